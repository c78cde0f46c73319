use super::*;
use crate::dimension::Dimension;
use crate::expr::*;
use crate::rational::Rational;

fn scalar(name: &'static str) -> Symbol {
    lex::UNKNOWN.named(name)
}

/// What `text` reads as, shown by the face.
fn face(text: &str) -> String {
    parse(text, &[]).unwrap_or_else(|fault| panic!("{text}: {fault}")).to_string()
}

/// `text` is refused at `column` with a message that contains `words`.
fn refused(text: &str, column: usize, words: &str) {
    let fault = match parse(text, &[]) {
        Ok(expr) => panic!("{text} reads as {expr}"),
        Err(fault) => fault,
    };
    assert_eq!(fault.column, column, "{text}: {fault}");
    assert!(fault.message.contains(words), "{text}: {fault}");
}

#[test]
fn reads_what_people_type() {
    for (text, shown) in [
        ("sin(a)^2 - sin(b)^2", "sin² a − sin² b"),
        ("sin(a+b)*sin(a-b)", "sin(a + b) sin(a − b)"),
        ("n1*cos(t1)", "n₁ cos t₁"),
        ("theta_1' + theta1 - θ₂", "θ₁′ + θ₁ − θ₂"),
        ("E_in*E_{12}", "Eᵢₙ E₁₂"),
        ("L_θ", "L_θ"),
        ("-x^2", "−x²"),
        ("2^-1 + x^(-3/2) + x**2", "2⁻¹ + x^(−3/2) + x²"),
        ("x^½", "x^(1/2)"),
        ("a/b/c", "(a/b)/c"),
        ("a - b - c", "a − b − c"),
        ("a - (b - c)", "a − (b − c)"),
        ("a - -b", "a + b"),
        ("--a", "a"),
        ("a*-b", "a (−b)"),
        ("0.5 x + 1.2345", "½x + 1.2345"),
        ("[a + {b - c}]^2", "(a + b − c)²"),
        ("sin a cos b", "sin a cos b"),
        ("sin² a + cos^2(a)", "sin² a + cos² a"),
        ("sin 2x - cos kz", "sin(2x) − cos(kz)"),
        ("sin x + y", "sin x + y"),
        ("sin x/sin y", "sin x/sin y"),
        ("sqrt(mu/epsilon) - √2 x", "√(μ/ε) − √2 x"),
        ("asin(x) + arctan(y)", "arcsin(x) + arctan(y)"),
        ("e^x e^(-2 i x) + e^-1 + e", "exp(x) exp(−2ix) + exp(−1) + exp(1)"),
        ("|x - |y||^2", "|x − |y||²"),
        ("|x |y|| + |x||y|", "|x |y|| + |x| |y|"),
        ("x* + conj(y) - z*·w", "x* + y* − (z*) w"),
        ("(a+b)(a-b)", "(a + b)(a − b)"),
        ("2π r h + ½kz²", "2πrh + ½kz²"),
        ("10^6 x", "10⁶ x"),
        ("x^1000000000", "x¹⁰⁰⁰⁰⁰⁰⁰⁰⁰"),
        ("x^(10^9)", "x¹⁰⁰⁰⁰⁰⁰⁰⁰⁰"),
        ("3/2 + 2/5", "3/2 + 2/5"),
        ("8.8542 × 10⁻¹²", "8.8542 × 10⁻¹²"),
        ("µ ϕ", "μφ"),
        ("∂²x/∂t² + dx/dt", "∂²x/∂t² + dx/dt"),
    ] {
        assert_eq!(face(text), shown, "{text}");
    }
}

#[test]
fn refuses_what_could_mean_two_things() {
    refused("1/2x", 4, "(a/b) c or a/(b c)");
    refused("a/b (c + d)", 5, "write the brackets");
    refused("sina", 1, "Write sin(a)");
    refused("thetaa", 1, "`thetaa`");
    refused("xpi", 2, "several ways");
    refused("lamda", 1, "expected a name");
    refused("f(x)", 2, "write f*(…)");
    refused("sin a b", 7, "argument");
    refused("sin a*b", 6, "argument");
    refused("sin x/2", 6, "argument");
    refused("a/sin x*b", 8, "argument");
    refused("sin x(y)", 5, "in brackets");
    refused("sin^-1(x)", 1, "arcsin(x)");
    refused("sin2x", 4, "expected a bracket after sin");
    refused("x^2^3", 4, "(a^b)^c");
    refused("x* y", 2, "conj(a)");
    refused("e^2x", 4, "e^(2x)");
    refused("√x²", 3, "√(x²)");
    refused("√2x", 3, "√(x²)");
    refused("x 2", 3, "operator");
    refused("1½", 2, "operator");
    refused("2e5", 2, "× 10^n");
    refused("kz1", 3, "one letter");
    refused("xdx", 2, "differential");
    refused("∫ f dx g", 8, "integral");
    refused("∫ ∫ f dx dy", 3, "brackets");
}

#[test]
fn says_what_was_expected_and_where() {
    refused("", 1, "expected an expression, found the end");
    refused("  ", 3, "expected an expression");
    refused("(a + b", 7, "closing `)`, found the end");
    refused("(a + b]", 7, "closing `)`, found `]`");
    refused("a + b)", 6, "an operator or the end");
    refused("a + ", 5, "expected an expression");
    refused("a + * b", 5, "expected an expression, found `*`");
    refused("a = b", 3, "one expression");
    refused("|x", 3, "closing |");
    refused("x^y", 3, "rational number");
    refused("x^(y)", 3, "rational number");
    refused("x^(10^19)", 3, "rational number");
    refused("99999999999999999999", 1, "18 digits");
    refused("x^99999999999999999999", 3, "18 digits");
    refused("x⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹⁹", 2, "18 digits");
    refused("1.2.3", 4, "digits");
    refused("α + ☃", 5, "found `☃`");
    refused("x_", 3, "index");
    refused("ln x", 1, "not known");
    refused("cot(x)", 1, "1/tan(x)");
    refused("(a, b)", 1, "three components");
    refused("∂x", 3, "variable of the derivative");
    refused("∂²x/∂t", 1, "order");
    refused("∫_0^1 x", 8, "one variable");
    let fault = parse_equation("a = b = c", &[]).unwrap_err();
    assert_eq!(fault.column, 7);
    assert!(parse_equation("a", &[]).unwrap_err().message.contains("="));
}

#[test]
fn known_names_win() {
    let e = Symbol::vector("E", Dimension::VOLT_PER_METRE);
    let charge = Symbol::scalar("e", Dimension::COULOMB);
    let thickness = Symbol::scalar("d", Dimension::METRE);
    let known = [e.clone(), charge.clone(), thickness.clone(), scalar("f"), scalar("n_t").within(1.0, 2.0)];
    let read = |text| parse(text, &known).unwrap();
    assert_eq!(read("e E"), charge * &e);
    assert_eq!(read("dx"), thickness * scalar("x"));
    assert_eq!(read("f(x)"), scalar("f").at([scalar("x").into()]));
    assert_eq!(read("E·E"), dot(&e, &e));
    assert_eq!(read("2 E×E - x × E"), 2 * cross(&e, &e) - scalar("x") * &e);
    assert_eq!(read("nₜ"), Expr::from(&known[4]));
    assert_eq!(read("n_t").symbols()[0].domain(), known[4].domain());
    assert_eq!(read("(x, y, 0)"), vector(scalar("x"), scalar("y"), 0));
    assert!(parse("E E", &known).unwrap_err().message.contains("two vectors"));
    assert_eq!(parse("x", &known), Ok(scalar("x").into()));
}

#[test]
fn equations_keep_their_relation() {
    assert_eq!(parse_equation("x^2 = y", &[]), Ok(Equation::new(scalar("x").pow(2), scalar("y"))));
    assert_eq!(parse_equation("R ≈ 1/2", &[]), Ok(Equation::approximate(scalar("R"), Expr::from(1) / 2)));
    assert_eq!(parse_equation("S ∝ A²", &[]), Ok(Equation::proportional(scalar("S"), scalar("A").pow(2))));
}

#[test]
fn depth_and_length_are_bounded() {
    let nested = |open: &str, n: usize, close: &str| open.repeat(n) + "x" + &close.repeat(n);
    for (open, close) in
        [("(", ")"), ("sin(", ")"), ("√(", ")"), ("|", "|"), ("1/(", ")"), ("(1+", ")"), ("⟨", "⟩"), ("∇", "")]
    {
        let deep = parse(&nested(open, 100_000, close), &[]).unwrap_err();
        assert!(deep.message.contains("256 levels"), "{open}: {deep}");
        let fine = parse(&nested(open, 100, close), &[]).unwrap();
        assert_eq!(parse(&fine.to_string(), &[]), Ok(fine));
    }
    // Deep without a bracket: a tree that leans to the left.
    assert!(parse("x/".repeat(100_000).trim_end_matches('/'), &[]).unwrap_err().message.contains("256 levels"));
    let mut towers = "x".to_owned();
    for _ in 0..20 {
        towers = format!("({towers}){}", "/x".repeat(20));
    }
    assert!(parse(&towers, &[]).unwrap_err().message.contains("256 levels"));
    for long in ["x+", "x*", "2*", "-", "x ", "x1 sin(x)+", "é+", "(x)", "x^2-"] {
        let text = long.repeat(1_000_000 / long.len()) + "x";
        if let Ok(expr) = parse(&text, &[]) {
            assert!(!expr.to_string().is_empty());
        }
    }
    assert!(parse(&"x".repeat(1_000_000), &[]).is_err());
    assert!(parse(&"x".repeat(100_000), &[scalar("x")]).is_ok());
    assert!(parse(&"9".repeat(1_000_000), &[]).is_err());
}

#[test]
fn what_is_read_has_the_value_it_should() {
    let two_thirds = Rational::new(2, 3).unwrap();
    assert_eq!(parse("x^(2/3)", &[]), Ok(scalar("x").pow(two_thirds)));
    assert_eq!(parse("-a b/c", &[]), Ok(-(scalar("a") * scalar("b") / scalar("c"))));
    assert_eq!(parse("a b/c*d", &[]), Ok(scalar("a") * scalar("b") / scalar("c") * scalar("d")));
}
