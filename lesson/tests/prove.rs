//! `lesson prove`: proved, refuted with a point, or unknown with the reason; and whatever cannot be read is told where.

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{Run, lesson_fed};
use serde_json::Value;

fn prove(arguments: &[&str]) -> Run {
    lesson_fed(&[&["prove"], arguments].concat(), b"")
}

fn json(arguments: &[&str]) -> (i32, Value) {
    let run = prove(&[arguments, &["--json"]].concat());
    let answer = serde_json::from_str(&run.out).unwrap_or_else(|error| panic!("{error}: {run:?}"));
    (run.code, answer)
}

#[test]
fn an_identity_is_proved_with_its_steps() {
    let run = prove(&["sin(a)^2 - sin(b)^2", "sin(a+b)*sin(a-b)"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{run:?}");
    assert!(
        run.out.contains("= sin(a + b) sin(a − b)") && run.out.ends_with("  Proved for positive a, b\n"),
        "{}",
        run.out
    );
    let (code, answer) = json(&["sin(a)^2 - sin(b)^2", "sin(a+b)*sin(a-b)"]);
    assert_eq!((code, &answer["verdict"]), (0, &"proved".into()));
    assert!(answer["lines"].as_array().unwrap().iter().all(|line| line["hop"]["verdict"] == "passed"), "{answer}");
}

#[test]
fn a_wrong_claim_is_refuted_at_a_point_where_anyone_can_check_it() {
    let run = prove(&["n1*cos(t1)", "n2*cos(t2)", "--given", "n1*sin(t1)=n2*sin(t2)"]);
    assert_eq!((run.code, run.err.as_str()), (1, ""), "{run:?}");
    assert!(run.out.contains("Refuted at") && run.out.contains("n₂ ="), "{}", run.out);
    let (code, answer) = json(&["x^2", "x^3"]);
    let number = |value: &Value| value.as_str().unwrap().parse::<f64>().unwrap();
    let (point, witness) = (number(&answer["witness"]["at"][0][1]), &answer["witness"]);
    assert_eq!(code, 1);
    assert!((number(&witness["left"]) - point.powi(2)).abs() < 1e-15);
    assert!((number(&witness["right"]) - point.powi(3)).abs() < 1e-15);
}

#[test]
fn hypotheses_are_used_and_equations_lead_to_equations() {
    assert_eq!(prove(&["a^2 - b^2", "0", "--given", "a=b"]).code, 0);
    assert_eq!(prove(&["a", "c", "--given", "a = b", "--given", "b = c"]).code, 0);
    assert_eq!(prove(&["a", "b", "--given", "a = b", "--given", "b = a"]).code, 0);
    assert_eq!(prove(&["x + y = 2", "y = 2 - x"]).code, 0);
    assert_eq!(prove(&["x + y = 2", "y = 2 + x"]).code, 1);
    let never = prove(&["a", "b", "--given", "1 = 2"]);
    assert!(never.code == 2 && never.out.contains("never holds"), "{never:?}");
}

/// The exit status under these premises, in whatever order.
fn under(claim: [&str; 2], premises: &[&str], more: &[&str]) -> i32 {
    let asked = |premises: &mut dyn Iterator<Item = &&str>| {
        let given = premises.flat_map(|premise| ["--given", premise]);
        prove(&claim.into_iter().chain(given).chain(more.iter().copied()).collect::<Vec<_>>()).code
    };
    let code = asked(&mut premises.iter());
    assert_eq!(code, asked(&mut premises.iter().rev()), "{claim:?} from {premises:?}");
    code
}

#[test]
fn nothing_is_proved_through_a_divisor_that_is_zero() {
    let cases: [([&str; 2], &[&str]); 11] = [
        (["x", "y"], &["a*(x-y)=0", "a=0"]),
        (["x", "1"], &["x*y=y", "y=0"]),
        (["x", "1"], &["x*y=y", "y+z=z"]),
        (["x", "1"], &["x*y=y", "y=z-z"]),
        (["x", "y"], &["x*a=y*a", "a^2=0"]),
        (["x", "y"], &["x*a=y*a", "sqrt(a)=0"]),
        (["x", "z"], &["x/y=z/y", "y=0"]),
        (["x", "y"], &["x*a=y*a", "exp(a)=1"]),
        (["x", "y"], &["x=1", "x=2"]),
        (["x", "y"], &["x*a=y*a", "a*b=b", "a=c", "c+b=b"]),
        (["b", "1"], &["a*b=b", "a=2"]),
    ];
    for (claim, premises) in cases {
        assert_ne!(under(claim, premises, &[]), 0, "{claim:?} from {premises:?}");
    }
    assert_eq!(under(["x", "y"], &["a*(x-y)=0", "a=b"], &[]), 0);
    let run = prove(&["x", "x", "--given", "sqrt(a)=-1"]);
    assert!(run.code == 2 && run.out.contains("contradict"), "{run:?}");
}

#[test]
fn every_factor_of_a_premise_is_a_case() {
    let product = "(x-1)*(y-2)=0";
    assert_eq!(under(["x", "1"], &[product], &[]), 1);
    assert_eq!(under(["y", "2"], &[product], &[]), 1);
    assert_eq!(under(["x*y+2", "2x+y"], &[product], &[]), 0);
    assert_eq!(under(["y", "2"], &[product, "x=3"], &[]), 0);
    assert_eq!(under(["y", "z"], &["sin(x)*y=sin(x)*z"], &[]), 1);
    assert_eq!(under(["y", "z"], &["sin(x)*y=sin(x)*z", "x=1"], &[]), 0);
    // A name is positive where it can be.
    assert_eq!(under(["y", "2"], &["(x+1)*(y-2)=0"], &[]), 0);
    assert_eq!(under(["y", "2"], &["(x+1)*(y-2)=0"], &["--real", "x"]), 1);
    assert_eq!(under(["a", "0"], &["a*b=0"], &["--real", "a,b"]), 1);
}

#[test]
fn what_was_assumed_stands_with_the_answer() {
    let told = |arguments: &[&str], end: &str| {
        let run = prove(arguments);
        assert!(run.code == 0 && run.out.ends_with(&format!("  Proved {end}\n")), "{run:?}");
    };
    told(&["sqrt(x^2)", "x"], "for positive x");
    told(&["sin(x)/cos(x)", "tan(x)"], "for positive x where cos x ≠ 0");
    told(&["sqrt(theta_1^2)", "|theta1|", "--real", "theta1"], "for real θ₁");
    told(&["a*|x|", "|a*x|", "--real", "x"], "for positive a and real x");
    told(&["x", "-a", "--given", "x+a=0"], "for positive a");
    let (_, answer) = json(&["a*|x|", "|a*x|", "--real", "x"]);
    assert_eq!((&answer["assumed"]["positive"][0], &answer["assumed"]["real"][0]), (&"a".into(), &"x".into()));
    assert_eq!(prove(&["sqrt(x^2)", "x", "--real", "x"]).code, 1);
    let unreadable = prove(&["x", "x", "--real", "x+1"]);
    assert!(unreadable.code == 2 && unreadable.err.contains("--real"), "{unreadable:?}");
}

#[test]
fn moduli_and_large_multiples() {
    for (left, right) in [
        ("|a|*|b|", "|a*b|"),
        ("sqrt((x+y)^2)", "x+y"),
        ("sqrt(e^(2x))", "e^x"),
        ("sin(100000*x)", "sin(100000*x)"),
        ("sin(100000*x)", "sin(50000*(x+x))"),
    ] {
        assert_eq!(prove(&[left, right]).code, 0, "{left} = {right}");
    }
    assert_eq!(prove(&["|a|*|b|", "|a*b|", "--real", "a", "--real", "b"]).code, 0);
    assert_eq!(prove(&["sqrt((x-y)^2)", "x-y"]).code, 1);
    assert_eq!(prove(&["sin(100000*x)", "sin(100001*x)"]).code, 1);
    // True up to 2π and false from there on.
    let (code, answer) = json(&["|1-exp(i*x)|", "2*sin(x/2)"]);
    let x: f64 = answer["witness"]["at"][0][1].as_str().unwrap().parse().unwrap();
    assert!(code == 1 && (x / 2.0).sin() < 0.0, "{answer}");
}

#[test]
fn a_minus_sign_is_no_option() {
    for (from, to) in [("-a", "0-a"), ("-h*x", "-x*h"), ("-theta", "0 - theta"), ("--a", "a"), ("-2", "-4/2")] {
        let run = prove(&[from, to]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{from}: {run:?}");
    }
    assert_eq!(prove(&["-a^2", "-b^2", "--given", "-a = -b"]).code, 0);
    assert!(prove(&["--help"]).out.contains("Exit status"));
}

#[test]
fn what_is_undecided_says_why() {
    let run = prove(&["∂x/∂t", "x"]);
    assert!(run.code == 2 || run.code == 1, "{run:?}");
    let unknown = prove(&["1/(x - x)", "x"]);
    assert!(unknown.code == 2 && unknown.out.contains("Unknown: "), "{unknown:?}");
}

#[test]
fn unreadable_input_is_shown_with_a_caret() {
    let run = prove(&["1/2x", "x"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    let lines: Vec<_> = run.err.lines().collect();
    assert!(lines[0].starts_with("error: column 4: "), "{run:?}");
    assert_eq!(lines[1..], ["  1/2x", "     ^"]);
    let both = prove(&["a = b", "c"]);
    assert!(both.code == 2 && both.err.contains("one of each"), "{both:?}");
}

/// Whatever is typed, there is an answer soon.
#[test]
fn bad_input_is_answered_soon() {
    let open = "(".repeat(100_000);
    let balanced = format!("{}x{}", "(".repeat(50_000), ")".repeat(50_000));
    let products = format!("{}x", "x*".repeat(50_000));
    let sum = format!("{}x", "x1+".repeat(30_000));
    let cosines = format!("{}x{}", "cos(".repeat(200), ")".repeat(200));
    let power = format!("({})^40", (1..40).map(|n| format!("x{n}")).collect::<Vec<_>>().join("+"));
    let cases = [
        ("(a + b", Some("column 7")),
        ("", Some("column 1")),
        ("sina", Some("column 1")),
        (&open, Some("column 257")),
        (&balanced, Some("column 257")),
        ("x^(10^9)", None),
        ("(1+x)^(10^9)", None),
        ("(1+x)^(-1000000000)", None),
        ("sin(10^9*x)", None),
        ("x^(1/1000000007)", None),
        ("x^(-9000000000000000000/8999999999999999999)", None),
        ("10^(10^9)", None),
        (&products, None),
        (&sum, None),
        (&cosines, None),
        (&power, None),
        ("e^(e^(e^(e^(e^x))))", None),
    ];
    for (text, place) in cases {
        let run = prove(&[text, "x"]);
        let name: String = text.chars().take(20).collect();
        assert!((0..=2).contains(&run.code) && !run.err.contains("panicked"), "{name}: {}", run.err);
        match place {
            Some(place) => assert!(run.code == 2 && run.err.contains(place), "{name}: {}", run.err),
            None => assert!(run.err.is_empty() && run.code > 0, "{name}: {} {}", run.code, run.err),
        }
    }
}
