use super::*;
use crate::equation::derivation::{Chain, Verdict};
use crate::equation::dimension::Dimension;
use crate::equation::expr::{cos, exp, i, pi, ratio, sin, sqrt, tan};
use crate::equation::symbol::Symbol;
use crate::sampling;

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

fn cases() -> Vec<(Expr, Expr, Vec<Given>)> {
    let mut all: Vec<_> = fresnel().into_iter().map(|(a, b)| (a, b, snell())).collect();
    all.extend(others().into_iter().map(|(a, b)| (a, b, vec![])));
    all.push(airy());
    all.push((N_1 * sin(THETA_1), N_2 * sin(THETA_2), vec![given(N_2, N_1 * sin(THETA_1) / sin(THETA_2), "Snell")]));
    all
}

#[test]
fn print_all() {
    let begin = std::time::Instant::now();
    for (start, goal, given) in cases() {
        let begin = std::time::Instant::now();
        let found = find(&start, &goal, &given);
        println!("\n{start}   [{:?}]", begin.elapsed());
        match found {
            Ok(found) => {
                for step in found.steps {
                    println!("  = {}      [{}]", step.expr, step.by.join(", "));
                    for step in step.unfolded {
                        println!("        · {}      [{}]", step.expr, step.by.join(", "));
                    }
                }
            }
            Err(why) => println!("  ✗ {goal}: {why}"),
        }
    }
    println!("{:?}", begin.elapsed());
}
