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
    assert!(run.out.contains("= sin(a + b) sin(a − b)") && run.out.ends_with("  Proved\n"), "{}", run.out);
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
