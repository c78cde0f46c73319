//! Tests on everything that an equation can be made of, each in a small example whose faces were looked at. The
//! lecture's own equations stand in its chapters and are held to [`super::sound`] there.

use super::dimension::Dimension as U;
use super::expr::*;
use super::sound;
use super::symbol::Symbol;
use super::{Equation, Expr};

const fn scalar(name: &'static str, unit: U) -> Symbol {
    Symbol::scalar(name, unit)
}

const fn one(name: &'static str) -> Symbol {
    scalar(name, U::ONE)
}

const fn velocity(name: &'static str) -> Symbol {
    Symbol::vector(name, U::METRE_PER_SECOND)
}

const F: Symbol = velocity("u");
const F_1: Symbol = velocity("u_1");
const F_2: Symbol = velocity("u_2");
const W: Symbol = Symbol::vector("w", U::ONE);
const N: Symbol = Symbol::vector("n", U::ONE);
const SOURCE: Symbol = Symbol::vector("s", U::HERTZ);
const A: Symbol = scalar("a", U::METRE_PER_SECOND.inverse());
const B: Symbol = scalar("b", U::METRE_PER_SECOND.inverse());
const C: Symbol = scalar("c", U::METRE_PER_SECOND);
const G: Symbol = scalar("g", U::HERTZ);
const K: Symbol = scalar("k", U::RADIAN_PER_METRE);
const T: Symbol = scalar("t", U::SECOND);
const PERIOD: Symbol = scalar("T", U::SECOND);
const X: Symbol = scalar("x", U::METRE);
const R: Symbol = scalar("r", U::METRE);
const AREA: Symbol = scalar("A", U::SQUARE_METRE);
const VOLUME: Symbol = scalar("V", U::CUBIC_METRE);
const RATE: Symbol = scalar("Q", U::CUBIC_METRE.per(U::SECOND));
const ALPHA: Symbol = one("alpha");
const BETA: Symbol = one("beta");
const THETA: Symbol = one("theta");
const PHI: Symbol = one("phi");
const SOLID: Symbol = one("Omega");
const THETA_1: Symbol = one("theta_1");
const THETA_2: Symbol = one("theta_2");

fn eq(lhs: impl Into<Expr>, rhs: impl Into<Expr>) -> Equation {
    Equation::new(lhs, rhs)
}

fn sum() -> Expr {
    THETA_1 + THETA_2
}

fn difference() -> Expr {
    THETA_1 - THETA_2
}

/// Equations with their face in Unicode and the unit of their sides.
fn looked_at() -> Vec<(Equation, &'static str, &'static str)> {
    let mut all = fields();
    all.extend(products_and_quotients());
    all.extend(integrals_and_differentials());
    all
}

/// ∇, ∂, vectors, functions at arguments.
fn fields() -> Vec<(Equation, &'static str, &'static str)> {
    let wave = laplacian(F) - A * B * partial(partial(F, T), T);
    let delay = || T / sqrt(A * B);
    vec![
        (eq(divergence(F), G), "∇·u = g", "1/s"),
        (eq(curl(F), -partial(W, T)), "∇×u = −∂w/∂t", "1/s"),
        (eq(curl(F), SOURCE + partial(W, T)), "∇×u = s + ∂w/∂t", "1/s"),
        (eq(curl(W), A * B * partial(F, T)), "∇×w = ab ∂u/∂t", "1/m"),
        (eq(curl(curl(F)), -partial(curl(W), T)), "∇×(∇×u) = −∂(∇×w)/∂t", "1/(m s)"),
        (eq(wave, 0), "∇²u − ab ∂²u/∂t² = 0", "1/(m s)"),
        (eq(partial(partial(W, T), X), gradient(G)), "∂²w/(∂x ∂t) = ∇g", "1/(m s)"),
        (eq(G, partial(partial(RATE, AREA * cos(THETA)), X)), "g = ∂²Q/(∂x ∂(A cos θ))", "1/s"),
        (eq(cross(N, F_1 - F_2), 0), "n×(u₁ − u₂) = 0", "m/s"),
        (eq(F, 1 / BETA * cross(F_1, W)), "u = (1/β) u₁×w", "m/s"),
        (eq(mean(F), ratio(1, 2) * re(cross(F_1, conj(W)))), "⟨u⟩ = ½ Re(u₁×w*)", "m/s"),
        (eq(ALPHA, abs(dot(N, F_1) / dot(N, F_2))), "α = |(n·u₁)/(n·u₂)|", "1"),
        (
            eq(F, velocity("f_1").at([X - delay()]) + velocity("f_2").at([X + delay()])),
            "u = f₁(x − t/√(ab)) + f₂(x + t/√(ab))",
            "m/s",
        ),
        (eq(BETA, one("delta").at([difference()]) / cos(PHI)), "β = δ(θ₁ − θ₂)/cos φ", "1"),
    ]
}

/// What stands side by side, what takes a bracket, and what a line is drawn under.
fn products_and_quotients() -> Vec<(Equation, &'static str, &'static str)> {
    let phase = 2 * pi() / scalar("lambda", U::METRE) * (X - C * T);
    let ten = |n: i32| Expr::from(10).pow(n);
    vec![
        (eq(F, C * W), "u = cw", "m/s"),
        (eq(BETA, ALPHA / pi()), "β = α/π", "1"),
        (
            eq(1 / sqrt(ratio(88542, 10_000) * ten(-12) * (4 * pi() * ten(7))), ALPHA),
            "1/√(8.8542 × 10⁻¹² × 4π × 10⁷) = α",
            "1",
        ),
        (eq(F, velocity("f") * cos(phase)), "u = f cos((2π/λ)(x − ct))", "m/s"),
        (eq(F, velocity("f") * cos(K * X - G * T)), "u = f cos(kx − gt)", "m/s"),
        (eq(K.pow(2), G.pow(2) * A * (B + i() * A / BETA)), "k² = g²a (b + ia/β)", "1/m²"),
        (eq(abs(F) / abs(W), 1 / sqrt(A * B)), "|u|/|w| = 1/√(ab)", "m/s"),
        (eq(mean(abs(F)), ratio(1, 2) * C * BETA * ALPHA.pow(2)), "⟨|u|⟩ = ½cβα²", "m/s"),
        (Equation::proportional(mean(abs(F)), ALPHA.pow(2)), "⟨|u|⟩ ∝ α²", "m/s"),
        (Equation::approximate(ALPHA, BETA + (1 - BETA) * (1 + cos(THETA)).pow(3)), "α ≈ β + (1 − β)(1 + cos θ)³", "1"),
        (eq(THETA_1, one("theta_1'")), "θ₁ = θ₁′", "1"),
        // A sign that a program puts in.
        (eq(ALPHA - 1 * (BETA * PHI), ALPHA + -1 * (BETA * PHI)), "α − βφ = α − βφ", "1"),
        (eq(ALPHA - -1 * (BETA + PHI), 1 * ALPHA), "α + β + φ = α", "1"),
        (eq(sin(THETA_1) / A, sin(THETA_2) / B), "sin(θ₁)/a = sin(θ₂)/b", "m/s"),
        (
            eq((G.named("g_1") - G.named("g_1'")) * cos(THETA_1), G.named("g_2") * tan(THETA_2)),
            "(g₁ − g₁′) cos θ₁ = g₂ tan θ₂",
            "1/s",
        ),
        (eq(ALPHA, -cos(difference()) / sin(sum())), "α = −cos(θ₁ − θ₂)/sin(θ₁ + θ₂)", "1"),
        (
            eq(ALPHA, 2 * sin(THETA_1) * cos(THETA_2) / (tan(sum()) * cos(difference()))),
            "α = 2 sin θ₁ cos θ₂/(tan(θ₁ + θ₂) cos(θ₁ − θ₂))",
            "1",
        ),
        (eq(ALPHA, A * cos(THETA_1) / (B * cos(THETA_2)) * BETA.pow(2)), "α = (a cos θ₁/(b cos θ₂)) β²", "1"),
        (
            eq(ALPHA, ratio(1, 2) * (cos(difference()).pow(2) / sin(sum()).pow(2) + 1)),
            "α = ½(cos²(θ₁ − θ₂)/sin²(θ₁ + θ₂) + 1)",
            "1",
        ),
    ]
}

/// ∫, ∮, d.
fn integrals_and_differentials() -> Vec<(Equation, &'static str, &'static str)> {
    let radial = scalar("u_r", U::METRE_PER_SECOND);
    let incoming = scalar("g_in", U::HERTZ) * cos(THETA);
    vec![
        (eq(d(VOLUME), R.pow(2) * sin(THETA) * d(R) * d(PHI) * d(THETA)), "dV = r² sin θ dr dφ dθ", "m³"),
        (eq(C, d(X) / d(T)), "c = dx/dt", "m/s"),
        (eq(BETA, d(C) / (G * cos(THETA) * d(X))), "β = dc/(g cos θ dx)", "1"),
        (eq(mean(abs(F)), 1 / PERIOD * integral_between(abs(F), T, 0, PERIOD)), "⟨|u|⟩ = (1/T) ∫₀ᵀ |u| dt", "m/s"),
        (eq(RATE, integral(mean(abs(F)) * cos(ALPHA), [AREA.into()], Range::Whole)), "Q = ∫ ⟨|u|⟩ cos α dA", "m³/s"),
        (
            eq(RATE, integral(radial * R.pow(2) * sin(THETA), [PHI.into(), THETA.into()], Range::Closed)),
            "Q = ∮ uᵣ r² sin θ dφ dθ",
            "m³/s",
        ),
        (eq(C, integral(G * cos(THETA), [X.into()], Range::Region(SOLID))), "c = ∫_Ω g cos θ dx", "m/s"),
        (
            eq(
                C.at([PHI.into()]),
                C.named("c_1").at([PHI.into()])
                    + integral(incoming * BETA.at([THETA.into(), PHI.into()]), [X.into()], Range::Whole),
            ),
            "c(φ) = c₁(φ) + ∫ gᵢₙ cos(θ) β(θ, φ) dx",
            "m/s",
        ),
    ]
}

#[test]
fn every_construct_reads_as_it_should() {
    for (equation, face, _) in looked_at() {
        assert_eq!(equation.to_string(), face);
    }
}

#[test]
fn every_construct_is_sound() {
    for (equation, ..) in looked_at() {
        assert_eq!(sound::well_formed(&equation).and_then(|()| sound::read_back(&equation)), Ok(()));
    }
}

#[test]
fn every_construct_has_its_unit() {
    for (equation, face, unit) in looked_at() {
        let found = equation.dimension().unwrap_or_else(|mismatch| panic!("{face}: {mismatch}"));
        assert_eq!(found.to_string(), unit, "{face}");
    }
}

#[test]
fn latex_is_as_a_typesetter_would_write_it() {
    let share = A * cos(THETA_1) / (B * cos(THETA_2)) * BETA.pow(2);
    let squares = sin(difference()).pow(2) / sin(sum()).pow(2);
    for (expr, latex) in [
        (-sin(difference()) / sin(sum()), r"-\frac{\sin(\theta_{1} - \theta_{2})}{\sin(\theta_{1} + \theta_{2})}"),
        (2 * sin(THETA_2) * cos(THETA_1), r"2 \sin \theta_{2} \cos \theta_{1}"),
        (share, r"\frac{a \cos \theta_{1}}{b \cos \theta_{2}} \beta^{2}"),
        (
            abs(dot(N, F_1) / dot(N, F_2)),
            r"\left| \frac{\boldsymbol{n} \cdot \boldsymbol{u}_{1}}{\boldsymbol{n} \cdot \boldsymbol{u}_{2}} \right|",
        ),
        (
            ratio(1, 2) * (squares + 1),
            concat!(
                r"\tfrac{1}{2} \left( ",
                r"\frac{\sin^{2}(\theta_{1} - \theta_{2})}{\sin^{2}(\theta_{1} + \theta_{2})} + 1 \right)"
            ),
        ),
        (
            mean(re(cross(F_1, conj(W)))),
            r"\langle \operatorname{Re}(\boldsymbol{u}_{1} \times \boldsymbol{w}^{*}) \rangle",
        ),
        (partial(curl(W), T), r"\frac{\partial }{\partial t}(\nabla \times \boldsymbol{w})"),
        (one("n_in'").pow(2), r"{n_{\mathrm{in}}'}^{2}"),
        (exp(i() * K * X) / sqrt(A * B), r"\frac{\mathrm{e}^{\mathrm{i} k x}}{\sqrt{a b}}"),
        (integral_between(abs(F), T, 0, PERIOD), r"\int_{0}^{T} \lvert \boldsymbol{u} \rvert \, \mathrm{d}t"),
        (integral(G, [X.into()], Range::Region(SOLID)), r"\int_{\Omega} g \, \mathrm{d}x"),
    ] {
        assert_eq!(expr.latex(), latex, "{expr}");
    }
}

#[test]
fn mathml_names_every_part() {
    let ratio = eq(sin(THETA_1) / 2, one("n_in'"));
    assert_eq!(
        ratio.mathml(),
        concat!(
            r#"<math display="block"><mrow><mfrac><mrow><mi>sin</mi><mo>"#,
            "\u{2061}",
            r#"</mo><mspace width="0.1667em"/><msub><mi>θ</mi><mn>1</mn></msub></mrow><mn>2</mn></mfrac>"#,
            "<mo>=</mo><msubsup><mi>n</mi><mi>in</mi><mo>′</mo></msubsup></mrow></math>"
        )
    );
    assert_eq!(
        dot(F, Symbol::vector("omega", U::HERTZ)).mathml(),
        r#"<math display="inline"><mrow><mi>𝒖</mi><mo>·</mo><mi>𝝎</mi></mrow></math>"#
    );
}
