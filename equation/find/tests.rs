use super::rules::{Moves, Reason};
use super::show::Writer;
use super::term::Term;
use super::*;
use crate::derivation::{Chain, Verdict};
use crate::dimension::Dimension;
use crate::expr::{asin, cos, exp, gradient, i, partial, pi, ratio, sin, sqrt, tan};
use crate::symbol::Symbol;
use yardstick::random;

const THETA_1: Symbol = Symbol::scalar("theta_1", Dimension::ONE).within(0.1, 1.4);
const THETA_2: Symbol = Symbol::scalar("theta_2", Dimension::ONE).within(0.1, 1.4);
const N_1: Symbol = Symbol::scalar("n_1", Dimension::ONE);
const N_2: Symbol = Symbol::scalar("n_2", Dimension::ONE);
const K: Symbol = Symbol::scalar("k", Dimension::ONE).within(0.5, 2.0);
const A: Symbol = Symbol::scalar("a", Dimension::ONE);
const B: Symbol = Symbol::scalar("b", Dimension::ONE);
const X: Symbol = Symbol::scalar("x", Dimension::ONE).within(2.0, 3.0);
const R_1: Symbol = Symbol::scalar("r_1", Dimension::ONE);
const R_2: Symbol = Symbol::scalar("r_2", Dimension::ONE);
const T_1: Symbol = Symbol::scalar("t_1", Dimension::ONE);
const T_1B: Symbol = Symbol::scalar("t_1'", Dimension::ONE);
const P: Symbol = Symbol::scalar("p", Dimension::ONE);

fn given(what: impl Into<Expr>, value: impl Into<Expr>, by: &'static str) -> Given {
    Given { what: what.into(), value: value.into(), by }
}

fn snell() -> Vec<Given> {
    vec![given(N_1, K * sin(THETA_2), "Snell"), given(N_2, K * sin(THETA_1), "Snell")]
}

fn fresnel() -> Vec<(Expr, Expr)> {
    let (c_1, c_2) = (|| cos(THETA_1), || cos(THETA_2));
    vec![
        ((N_1 * c_1() - N_2 * c_2()) / (N_1 * c_1() + N_2 * c_2()), -sin(THETA_1 - THETA_2) / sin(THETA_1 + THETA_2)),
        (2 * N_1 * c_1() / (N_1 * c_1() + N_2 * c_2()), 2 * sin(THETA_2) * c_1() / sin(THETA_1 + THETA_2)),
        ((N_2 * c_1() - N_1 * c_2()) / (N_2 * c_1() + N_1 * c_2()), tan(THETA_1 - THETA_2) / tan(THETA_1 + THETA_2)),
        (
            2 * N_1 * c_1() / (N_2 * c_1() + N_1 * c_2()),
            2 * sin(THETA_2) * c_1() / (sin(THETA_1 + THETA_2) * cos(THETA_1 - THETA_2)),
        ),
    ]
}

fn others() -> Vec<(Expr, Expr)> {
    let r = (N_1 * cos(THETA_1) - N_2 * cos(THETA_2)) / (N_1 * cos(THETA_1) + N_2 * cos(THETA_2));
    let t = 2 * N_1 * cos(THETA_1) / (N_1 * cos(THETA_1) + N_2 * cos(THETA_2));
    vec![
        (sin(A).pow(2) - sin(B).pow(2), sin(A + B) * sin(A - B)),
        (sin(3 * A), 3 * sin(A) - 4 * sin(A).pow(3)),
        (cos(3 * A), 4 * cos(A).pow(3) - 3 * cos(A)),
        ((A + B).pow(3), A.pow(3) + 3 * A.pow(2) * B + 3 * A * B.pow(2) + B.pow(3)),
        (tan(A + B), (tan(A) + tan(B)) / (1 - tan(A) * tan(B))),
        (1 + tan(A).pow(2), 1 / cos(A).pow(2)),
        (cos(2 * A), 1 - 2 * sin(A).pow(2)),
        (cos(2 * A), 2 * cos(A).pow(2) - 1),
        (cos(2 * A), cos(A).pow(2) - sin(A).pow(2)),
        ((1 - cos(2 * A)) / 2, sin(A).pow(2)),
        (cos(A).pow(4) - sin(A).pow(4), cos(2 * A)),
        (sin(A) + sin(B), 2 * sin((A + B) / 2) * cos((A - B) / 2)),
        (r.pow(2) + N_2 * cos(THETA_2) / (N_1 * cos(THETA_1)) * t.pow(2), 1.into()),
        (1 / (X - 1) - 1 / (X + 1), 2 / (X.pow(2) - 1)),
        ((X.pow(2) - 3 * X + 2) / (X - 1), X - 2),
        ((X - 1) * (X + 1) * (X.pow(2) + 1), X.pow(4) - 1),
        (sin(A) * cos(A) + sin(B) * cos(B), sin(A + B) * cos(A - B)),
        ((sin(A) + cos(A)).pow(2), 1 + sin(2 * A)),
        (exp(i() * A) * exp(i() * B), cos(A + B) + i() * sin(A + B)),
        ((exp(i() * A) + exp(-(i() * A))) / 2, cos(A)),
        (sin(pi() / 2 - A), cos(A)),
        (sin(A + pi() / 6), sqrt(3) * sin(A) / 2 + cos(A) / 2),
        (tan(A / 2), (1 - cos(A)) / sin(A)),
        (sin(2 * A) / (1 + cos(2 * A)), tan(A)),
        (cos(A).pow(2), ratio(1, 2) + cos(2 * A) / 2),
        (sin(A).pow(4), ratio(3, 8) - cos(2 * A) / 2 + cos(4 * A) / 8),
        (2 * sin(A) / sin(2 * A), 1 / cos(A)),
        (sin(A) / (1 + cos(A)), (1 - cos(A)) / sin(A)),
        (tan(A) + 1 / tan(A), 2 / sin(2 * A)),
        ((1 - tan(A).pow(2)) / (1 + tan(A).pow(2)), cos(2 * A)),
        (A.pow(2) - 2 * A * B + B.pow(2), (A - B).pow(2)),
        (((A + B).pow(2) - (A - B).pow(2)) / (A * B), 4.into()),
        (sqrt(X).pow(2) + A / (B / X), X + A * X / B),
    ]
}

fn airy() -> (Expr, Expr, Vec<Given>) {
    let start = R_1 + T_1 * T_1B * R_2 * P / (1 + R_1 * R_2 * P);
    (start, (R_1 + R_2 * P) / (1 + R_1 * R_2 * P), vec![given(T_1 * T_1B, 1 - R_1.pow(2), "Stokes")])
}

fn optics() -> Vec<(Expr, Expr, Vec<Given>)> {
    let (c_1, c_2) = (|| cos(THETA_1), || cos(THETA_2));
    let sum = || N_1 * c_1() + N_2 * c_2();
    let r = || (N_1 * c_1() - N_2 * c_2()) / sum();
    let brewster = || given(THETA_2, pi() / 2 - THETA_1, "Brewster");
    let both = || snell().into_iter().chain([brewster()]).collect::<Vec<_>>();
    vec![
        (1 + r(), 2 * N_1 * c_1() / sum(), vec![]),
        (r().pow(2) + 2 * N_1 * c_1() / sum() * (2 * N_2 * c_2() / sum()), 1.into(), vec![]),
        (1 - ((N_1 - N_2) / (N_1 + N_2)).pow(2), 4 * N_1 * N_2 / (N_1 + N_2).pow(2), vec![]),
        (N_2 * c_1() - N_1 * c_2(), 0.into(), both()),
        (N_2 / N_1, tan(THETA_1), both()),
        (cos(A - B) + cos(A + B), 2 * cos(A) * cos(B), vec![]),
        (exp(i() * A) - exp(-(i() * A)), 2 * i() * sin(A), vec![]),
        (exp(i() * A) * exp(-(i() * A)), 1.into(), vec![]),
        (1 + exp(i() * A), 2 * cos(A / 2) * exp(i() * A / 2), vec![]),
        ((1 + R_1) * (1 - R_1) / (1 + R_1).pow(2), (1 - R_1) / (1 + R_1), vec![]),
        (sin(THETA_1).pow(2) / (K.pow(2) - K.pow(2) * cos(THETA_1).pow(2)), 1 / K.pow(2), vec![]),
        (A.pow(2) * cos(B).pow(2) + A.pow(2) * sin(B).pow(2), A.pow(2), vec![]),
        (sqrt(N_1.pow(2) - N_1.pow(2) * sin(A).pow(2)).pow(2), N_1.pow(2) * cos(A).pow(2), vec![]),
        (sin(A - B) / (cos(A) * cos(B)), tan(A) - tan(B), vec![]),
        (
            cos(THETA_2).pow(2),
            1 - (N_1 * sin(THETA_1) / N_2).pow(2),
            vec![given(sin(THETA_2), N_1 * sin(THETA_1) / N_2, "Snell")],
        ),
        (1 / (1 - R_1) - 1, R_1 / (1 - R_1), vec![]),
        (sin(A + B) * sin(A - B) / sin(A + B).pow(2), sin(A - B) / sin(A + B), vec![]),
        (sin(A + B) * cos(B) - cos(A + B) * sin(B), sin(A), vec![]),
        ((tan(A) - tan(B)) / (tan(A) + tan(B)), sin(A - B) / sin(A + B), vec![]),
        (1 / (1 / A + 1 / B), A * B / (A + B), vec![]),
        (((X.pow(2) - 1) / (X.pow(2) + 1)).pow(2) / 2, ratio(1, 2) - 2 * X.pow(2) / (X.pow(2) + 1).pow(2), vec![]),
        ((1 - X.pow(4)) / (1 - X), 1 + X + X.pow(2) + X.pow(3), vec![]),
        ((A - i() * B) * (A + i() * B), A.pow(2) + B.pow(2), vec![]),
        ((sin(A) + sin(3 * A)) / (cos(A) + cos(3 * A)), tan(2 * A), vec![]),
        (cos(A).pow(2), (1 + cos(2 * A)) / 2, vec![]),
    ]
}

fn cases() -> Vec<(Expr, Expr, Vec<Given>)> {
    let mut all: Vec<_> = fresnel().into_iter().map(|(a, b)| (a, b, snell())).collect();
    all.extend(others().into_iter().map(|(a, b)| (a, b, vec![])));
    all.extend(optics());
    all.push(airy());
    all.push((N_1 * sin(THETA_1), N_2 * sin(THETA_2), vec![given(N_2, N_1 * sin(THETA_1) / sin(THETA_2), "Snell")]));
    all
}

/// The same hypotheses with a symbol on each left side, as numerical verification wants them.
fn solved(given: &[Given]) -> Vec<Given> {
    let solve = |hypothesis: &Given| match hypothesis.what.to_string().as_str() {
        "t₁ t₁′" => super::tests::given(T_1B, &hypothesis.value / T_1, hypothesis.by),
        "sin θ₂" => super::tests::given(THETA_2, asin(&hypothesis.value), hypothesis.by),
        _ => hypothesis.clone(),
    };
    given.iter().map(solve).collect()
}

fn lines(start: &Expr, goal: &Expr, given: &[Given]) -> Vec<String> {
    let found = find(start, goal, given).unwrap_or_else(|why| panic!("{start} = {goal}: {why}"));
    found.steps.iter().map(|step| format!("{} [{}]", step.expr, step.by.join(", "))).collect()
}

#[test]
fn every_derivation_is_found_in_a_dozen_lines() {
    for (start, goal, given) in cases() {
        let lines = lines(&start, &goal, &given);
        assert!(lines.len() <= 6, "{start}: {lines:#?}");
        assert!(lines.last().unwrap().starts_with(&goal.to_string()), "{lines:#?}");
    }
}

#[test]
fn every_line_agrees_with_the_one_before() {
    for (start, goal, given) in cases() {
        let mut chain = Chain { given: solved(&given), ..Chain::new(start.clone()) };
        for step in find(&start, &goal, &given).unwrap().steps {
            for single in step.unfolded {
                chain = chain.then(single.expr, []);
            }
            chain = chain.then(step.expr, []);
        }
        for hop in chain.verify(4, 160, &mut random::stream(11, "equation/find")) {
            assert!(hop.verdict == Verdict::Proved, "{:?} {:?}", chain.lines[hop.line], hop);
        }
    }
}

#[test]
fn fresnel_reads_like_a_textbook() {
    let [r_s, t_s, r_p, t_p]: [_; 4] = fresnel().try_into().unwrap();
    let lines = |(start, goal): (Expr, Expr)| lines(&start, &goal, &snell());
    assert_eq!(
        lines(r_s),
        [
            "(k sin θ₂ cos θ₁ − k sin θ₁ cos θ₂)/(k sin θ₂ cos θ₁ + k sin θ₁ cos θ₂) [Snell ×4]",
            "(sin θ₂ cos θ₁ − sin θ₁ cos θ₂)/(sin θ₂ cos θ₁ + sin θ₁ cos θ₂) [cancel k]",
            "−sin(θ₁ − θ₂)/sin(θ₁ + θ₂) [angle sum ×2]",
        ]
    );
    assert_eq!(
        lines(t_s),
        [
            "2k sin θ₂ cos θ₁/(k sin θ₂ cos θ₁ + k sin θ₁ cos θ₂) [Snell ×3]",
            "2 sin θ₂ cos θ₁/(sin θ₂ cos θ₁ + sin θ₁ cos θ₂) [cancel k]",
            "2 sin θ₂ cos θ₁/sin(θ₁ + θ₂) [angle sum]",
        ]
    );
    assert_eq!(
        lines(r_p),
        [
            "(k sin θ₁ cos θ₁ − k sin θ₂ cos θ₂)/(k sin θ₁ cos θ₁ + k sin θ₂ cos θ₂) [Snell ×4]",
            "(sin θ₁ cos θ₁ − sin θ₂ cos θ₂)/(sin θ₁ cos θ₁ + sin θ₂ cos θ₂) [cancel k]",
            "(sin(2 θ₁) − sin(2 θ₂))/(sin(2 θ₁) + sin(2 θ₂)) [double angle ×4]",
            "sin(θ₁ − θ₂) cos(θ₁ + θ₂)/(sin(θ₁ + θ₂) cos(θ₁ − θ₂)) [sum to product ×2]",
            "tan(θ₁ − θ₂)/tan(θ₁ + θ₂) [tangent ×2]",
        ]
    );
    assert_eq!(
        lines(t_p),
        [
            "2k sin θ₂ cos θ₁/(k sin θ₁ cos θ₁ + k sin θ₂ cos θ₂) [Snell ×3]",
            "2 sin θ₂ cos θ₁/(sin θ₁ cos θ₁ + sin θ₂ cos θ₂) [cancel k]",
            "4 sin θ₂ cos θ₁/(sin(2 θ₁) + sin(2 θ₂)) [double angle ×2]",
            "2 sin θ₂ cos θ₁/(sin(θ₁ + θ₂) cos(θ₁ − θ₂)) [sum to product]",
        ]
    );
    let squares = super::tests::lines(&(sin(A).pow(2) - sin(B).pow(2)), &(sin(A + B) * sin(A - B)), &[]);
    assert_eq!(squares, ["(cos(2b) − cos(2a))/2 [half angle ×2]", "sin(a + b) sin(a − b) [sum to product]"]);
}

#[test]
fn a_cancelled_factor_unfolds_into_taking_it_out_first() {
    let (start, goal) = fresnel().remove(0);
    let found = find(&start, &goal, &snell()).unwrap();
    let unfolded: Vec<_> =
        found.steps[1].unfolded.iter().map(|step| (step.expr.to_string(), step.by[0].as_ref())).collect();
    let [(factored, "factor k"), (_, "cancel k")] = unfolded.as_slice() else { panic!("{unfolded:?}") };
    assert_eq!(factored, "k (sin θ₂ cos θ₁ − sin θ₁ cos θ₂)/(k (sin θ₂ cos θ₁ + sin θ₁ cos θ₂))");
}

#[test]
fn a_false_goal_is_refused_at_once() {
    for (start, goal, given) in cases() {
        for wrong in [&goal + ratio(1, 1000), ratio(999, 1000) * &goal + A * ratio(1, 1000)] {
            assert_eq!(find(&start, &wrong, &given), Err(NotFound::Differs), "{start} = {wrong}");
        }
    }
    let (r_p, t_p) = (fresnel().remove(2), fresnel().remove(3));
    assert_eq!(find(&r_p.0, &-r_p.1, &snell()), Err(NotFound::Differs));
    assert_eq!(find(&t_p.0, &t_p.1, &[]), Err(NotFound::Differs));
}

/// The states of a search without an aim, one move after the other.
fn wander(scene: &Scene, from: Term, steps: usize, mut visit: impl FnMut(&Term, &rules::Move)) {
    let mut moves = Moves::new(scene);
    let mut states = vec![from];
    for at in 0..steps {
        let Some(state) = states.get(at).cloned() else { break };
        for step in moves.of(&state) {
            visit(&state, &step);
            if !states.contains(&step.image.to) {
                states.push(step.image.to);
            }
        }
    }
}

#[test]
fn no_rule_changes_a_value() {
    let mut applied = vec![0; RULES.len()];
    for (start, goal, given) in cases() {
        let scene = Scene::new([&start, &goal], &given).unwrap();
        for end in [&start, &goal] {
            let from = scene.term(end).unwrap();
            let scale = search::rounding(&from);
            wander(&scene, from, 25, |state, step| {
                let (before, after) = (state.values(), step.image.to.values());
                assert!(search::agree(before, after, scale), "{step:?}: {before:?} {after:?}");
                if let Reason::Rule(rule) = step.reason {
                    applied[rule] += 1;
                }
            });
        }
    }
    let idle: Vec<_> = applied.iter().zip(RULES).filter(|(count, _)| **count < 3).collect();
    assert!(idle.is_empty(), "{idle:?}");
}

#[test]
fn what_is_written_out_is_what_was_meant() {
    for (start, goal, given) in cases() {
        let scene = Scene::new([&start, &goal], &given).unwrap();
        let writer = Writer::after(&scene, [&start, &goal]);
        wander(&scene, scene.term(&start).unwrap(), 15, |_, step| {
            let written = writer.expr(&step.image.to);
            assert_eq!(scene.term(&written).unwrap(), step.image.to, "{written}");
        });
    }
}

#[test]
fn every_named_rule_does_what_it_says() {
    for (at, rule) in RULES.iter().enumerate() {
        for (left, right) in (rule.examples)() {
            let scene = Scene::new([&left, &right], &[]).unwrap();
            let goal = scene.term(&right).unwrap();
            let moves = Moves::new(&scene).of(&scene.term(&left).unwrap());
            let is_it = |step: &rules::Move| step.reason == Reason::Rule(at) && step.image.to == goal;
            assert!(moves.iter().any(is_it), "{}: {left} = {right}", rule.name);
            let hops = Chain::new(left).then(right, [rule.name]).verify(6, 160, &mut random::stream(3, rule.name));
            assert!(hops[0].verdict.agrees(), "{hops:?}");
        }
    }
}

#[test]
fn what_takes_no_rule_is_one_line_or_none() {
    let (start, goal) = (A / (B / X) + A * X / B, 2 * A * X / B);
    assert_eq!(lines(&start, &start, &[]), [""; 0]);
    assert_eq!(lines(&start, &goal, &[]), ["2ax/b [simplify]"]);
    assert_eq!(lines(&(A + B), &(B + A), &[]), ["b + a [rearrange]"]);
}

#[test]
fn the_same_question_has_the_same_answer() {
    for (start, goal, given) in cases() {
        assert_eq!(find(&start, &goal, &given), find(&start, &goal, &given));
    }
}

#[test]
fn says_what_it_cannot_search() {
    let chain = |join: fn(Expr, i32) -> Expr| (0..5000).fold(Expr::from(A), join);
    for huge in [chain(|e, n| e + n), chain(|e, _| sin(e)), chain(|e, _| 1 / (e + 1)), chain(|e, _| e.pow(2))] {
        assert_eq!(find(&huge, &huge, &[]), Err(NotFound::TooLarge));
        assert_eq!(find(&A.into(), &A.into(), &[given(B, huge, "much")]), Err(NotFound::TooLarge));
    }
    let not_algebraic = |start: &Expr, given: &[Given]| {
        let answer = find(start, start, given);
        assert!(matches!(answer, Err(NotFound::NotAlgebraic(_))), "{answer:?}");
    };
    not_algebraic(&gradient(A), &[]);
    not_algebraic(&(1 / (Expr::from(A) - A)), &[]);
    not_algebraic(&Expr::from(2).pow(1_000_000_000), &[]);
    not_algebraic(&A.into(), &[given(A, A + 1, "nonsense")]);
    assert_eq!(lines(&(A + A), &(2 * A), &[given(partial(A, X), B, "of no use")]), ["2a [simplify]"]);
    not_algebraic(&(A * B), &[given(A * B, A * B + 1, "nonsense")]);
}

#[test]
fn gives_up_within_bounds() {
    let wide = (1..20).map(|n| A.pow(n) * sin(n * A) * cos(B)).reduce(|a, b| a + b).unwrap();
    let (root, sum) = (sqrt(3 + 2 * sqrt(2)), 1 + sqrt(2));
    let answer = find(&(&wide * root), &(wide * sum), &[]);
    assert!(matches!(answer, Err(NotFound::Exhausted { states }) if states > 100), "{answer:?}");
}
