//! Tests on the displayed equations of the lecture, E1–E53: each can be written down, has the units it should have, and
//! a face that was looked at.

use super::dimension::Dimension as U;
use super::expr::*;
use super::parse::parse_equation;
use super::symbol::Symbol;
use super::{Equation, Expr};

const fn scalar(name: &'static str, unit: U) -> Symbol {
    Symbol::scalar(name, unit)
}

const fn vector(name: &'static str, unit: U) -> Symbol {
    Symbol::vector(name, unit)
}

const E: Symbol = vector("E", U::VOLT_PER_METRE);
const B: Symbol = vector("B", U::TESLA);
const D: Symbol = vector("D", U::COULOMB_PER_SQUARE_METRE);
const H: Symbol = vector("H", U::AMPERE_PER_METRE);
const J: Symbol = vector("J", U::AMPERE_PER_SQUARE_METRE);
const S: Symbol = vector("S", U::WATT_PER_SQUARE_METRE);
const N: Symbol = vector("n", U::ONE);
const EPSILON: Symbol = scalar("epsilon", U::FARAD_PER_METRE);
const MU: Symbol = scalar("mu", U::HENRY_PER_METRE);
const SIGMA: Symbol = scalar("sigma", U::SIEMENS_PER_METRE);
const RHO: Symbol = scalar("rho", U::COULOMB_PER_CUBIC_METRE);
const T: Symbol = scalar("t", U::SECOND);
const Z: Symbol = scalar("z", U::METRE);
const V: Symbol = scalar("v", U::METRE_PER_SECOND);
const LAMBDA: Symbol = scalar("lambda", U::METRE);
const OMEGA: Symbol = scalar("omega", U::HERTZ);
const K: Symbol = scalar("k", U::RADIAN_PER_METRE);
const A: Symbol = scalar("A", U::VOLT_PER_METRE);
const R: Symbol = scalar("r", U::METRE);
const THETA: Symbol = scalar("theta", U::ONE);
const PHI: Symbol = scalar("phi", U::ONE);
const SOLID: Symbol = scalar("Omega", U::ONE);
const FLUX: Symbol = scalar("Phi", U::WATT);
const INTENSITY: Symbol = scalar("I", U::WATT);
const RADIANCE: Symbol = scalar("L", U::WATT_PER_SQUARE_METRE);
const L_IN: Symbol = scalar("L_in", U::WATT_PER_SQUARE_METRE);
const L_R: Symbol = scalar("L_r", U::WATT_PER_SQUARE_METRE);
const AREA: Symbol = scalar("A", U::SQUARE_METRE);
const THETA_1: Symbol = scalar("theta_1", U::ONE).within(0.1, 1.4);
const THETA_2: Symbol = scalar("theta_2", U::ONE).within(0.1, 1.4);
const THETA_I: Symbol = scalar("theta_i", U::ONE);
const OMEGA_I: Symbol = scalar("omega_i", U::ONE);
const OMEGA_R: Symbol = scalar("omega_r", U::ONE);
const BRDF: Symbol = scalar("f_r", U::ONE);

fn field(name: &'static str) -> Symbol {
    scalar(name, U::VOLT_PER_METRE)
}

fn magnetic(name: &'static str) -> Symbol {
    scalar(name, U::AMPERE_PER_METRE)
}

fn wave(field: Symbol, unit: U) -> Equation {
    let twice_in_time = partial(partial(&field, T), T);
    assert_eq!(Expr::from(&field).dimension(), Ok(unit));
    Equation::new(laplacian(field) - EPSILON * MU * twice_in_time, 0)
}

/// Every displayed equation of the lecture with its face in Unicode and the unit of its sides.
fn displayed() -> Vec<(&'static str, Equation, &'static str, &'static str)> {
    let eq = |lhs: Expr, rhs: Expr| Equation::new(lhs, rhs);
    let phase = 2 * pi() / LAMBDA * (Z - V * T);
    let jump = |a: Symbol, b: Symbol| a - b;
    let at_1 = |name| vector(name, E.dimension());
    let sum = || sin(THETA_1 + THETA_2);
    let difference = || sin(THETA_1 - THETA_2);
    let tangents = || tan(THETA_1 - THETA_2) / tan(THETA_1 + THETA_2);
    let one = |name| scalar(name, U::ONE);
    let s = |name| dot(N, vector(name, U::WATT_PER_SQUARE_METRE));
    let c_0 = || EPSILON * MU;
    let incoming = || L_IN * cos(THETA_I);
    vec![
        ("E1", eq(divergence(D), RHO.into()), "∇·D = ρ", "C/m³"),
        ("E1", eq(divergence(B), 0.into()), "∇·B = 0", "T/m"),
        ("E1", eq(curl(E), -partial(B, T)), "∇×E = −∂B/∂t", "V/m²"),
        ("E1", eq(curl(H), J + partial(D, T)), "∇×H = J + ∂D/∂t", "A/m²"),
        ("E2", eq(divergence(J), -partial(RHO, T)), "∇·J = −∂ρ/∂t", "A/m³"),
        ("E3", eq(D.into(), EPSILON * E), "D = εE", "C/m²"),
        ("E3", eq(J.into(), SIGMA * E), "J = σE", "A/m²"),
        ("E4", eq(cross(N, jump(at_1("E_1"), at_1("E_2"))), 0.into()), "n×(E₁ − E₂) = 0", "V/m"),
        ("E5", eq(curl(B), c_0() * partial(E, T)), "∇×B = εμ ∂E/∂t", "T/m"),
        ("E6", eq(curl(curl(E)), -partial(curl(B), T)), "∇×(∇×E) = −∂(∇×B)/∂t", "V/m³"),
        ("E6", eq(-partial(curl(B), T), -c_0() * partial(partial(E, T), T)), "−∂(∇×B)/∂t = −εμ ∂²E/∂t²", "V/m³"),
        ("E7", wave(E, U::VOLT_PER_METRE), "∇²E − εμ ∂²E/∂t² = 0", "V/m³"),
        ("E8", wave(B, U::TESLA), "∇²B − εμ ∂²B/∂t² = 0", "T/m²"),
        (
            "E9",
            eq(partial(partial(E, Z), Z) - c_0() * partial(partial(E, T), T), 0.into()),
            "∂²E/∂z² − εμ ∂²E/∂t² = 0",
            "V/m³",
        ),
        (
            "E10",
            eq(E.into(), at_1("f_1").at([Z - T / sqrt(c_0())]) + at_1("f_2").at([Z + T / sqrt(c_0())])),
            "E = f₁(z − t/√(εμ)) + f₂(z + t/√(εμ))",
            "V/m",
        ),
        (
            "E11",
            eq(
                1 / sqrt(ratio(88542, 10_000) * Expr::from(10).pow(-12) * (4 * pi() * Expr::from(10).pow(-7))),
                scalar("c", U::ONE).into(),
            ),
            "1/√(8.8542 × 10⁻¹² × 4π × 10⁻⁷) = c",
            "1",
        ),
        ("E12", eq(E.into(), at_1("f_E").at([Z - V * T])), "E = f_E(z − vt)", "V/m"),
        ("E14", eq(E.into(), at_1("A") * cos(phase)), "E = A cos((2π/λ)(z − vt))", "V/m"),
        ("E16", eq(abs(E) / abs(B), 1 / sqrt(MU * EPSILON)), "|E|/|B| = 1/√(με)", "m/s"),
        ("E17", eq(abs(E) / abs(H), sqrt(MU / EPSILON)), "|E|/|H| = √(μ/ε)", "Ω"),
        ("E18", eq(K.pow(2), OMEGA.pow(2) * MU * (EPSILON + i() * SIGMA / OMEGA)), "k² = ω²μ (ε + iσ/ω)", "1/m²"),
        ("E19", eq(K.into(), OMEGA / V), "k = ω/v", "1/m"),
        ("E19", eq(E.into(), at_1("A") * cos(K * Z - OMEGA * T)), "E = A cos(kz − ωt)", "V/m"),
        ("E20", eq(S.into(), 1 / MU * cross(E, B)), "S = (1/μ) E×B", "W/m²"),
        (
            "E23",
            eq(mean(abs(S)), 1 / scalar("T", U::SECOND) * integral_between(abs(S), T, 0, scalar("T", U::SECOND))),
            "⟨|S|⟩ = (1/T) ∫₀ᵀ |S| dt",
            "W/m²",
        ),
        ("E23", eq(mean(abs(S)), ratio(1, 2) * V * EPSILON * A.pow(2)), "⟨|S|⟩ = ½vεA²", "W/m²"),
        ("E24", Equation::proportional(mean(abs(S)), A.pow(2)), "⟨|S|⟩ ∝ A²", "W/m²"),
        ("E24", eq(mean(S), ratio(1, 2) * re(cross(E, conj(H)))), "⟨S⟩ = ½ Re(E×H*)", "W/m²"),
        (
            "E26",
            eq(FLUX.into(), integral(mean(abs(S)) * cos(one("alpha")), [AREA.into()], Range::Whole)),
            "Φ = ∫ ⟨|S|⟩ cos α dA",
            "W",
        ),
        (
            "E27",
            eq(
                FLUX.into(),
                integral(
                    scalar("S_r", U::WATT_PER_SQUARE_METRE) * R.pow(2) * sin(THETA),
                    [PHI.into(), THETA.into()],
                    Range::Closed,
                ),
            ),
            "Φ = ∮ Sᵣ r² sin θ dφ dθ",
            "W",
        ),
        ("E28", eq(d(SOLID), sin(THETA) * d(PHI) * d(THETA)), "dΩ = sin θ dφ dθ", "1"),
        ("E29", eq(INTENSITY.into(), scalar("S_r", U::WATT_PER_SQUARE_METRE) * R.pow(2)), "I = Sᵣ r²", "W"),
        ("E30", eq(FLUX.into(), integral(INTENSITY, [SOLID.into()], Range::Closed)), "Φ = ∮ I dΩ", "W"),
        ("E30", eq(INTENSITY.into(), partial(FLUX, SOLID)), "I = ∂Φ/∂Ω", "W"),
        (
            "E31",
            eq(RADIANCE.into(), partial(partial(FLUX, AREA * cos(THETA)), SOLID)),
            "L = ∂²Φ/(∂Ω ∂(A cos θ))",
            "W/m²",
        ),
        (
            "E32",
            eq(
                scalar("E", U::WATT_PER_SQUARE_METRE).into(),
                integral(RADIANCE * cos(THETA), [OMEGA_I.into()], Range::Region(SOLID)),
            ),
            "E = ∫_Ω L cos θ dωᵢ",
            "W/m²",
        ),
        ("E33", eq(THETA_1.into(), one("theta_1'").into()), "θ₁ = θ₁′", "1"),
        ("E33", eq(sin(THETA_1) / V.named("v_1"), sin(THETA_2) / V.named("v_2")), "sin(θ₁)/v₁ = sin(θ₂)/v₂", "s/m"),
        ("E33", eq(one("n_1") * sin(THETA_1), one("n_2") * sin(THETA_2)), "n₁ sin θ₁ = n₂ sin θ₂", "1"),
        ("E35", eq(field("E_1") + field("E_1'"), field("E_2").into()), "E₁ + E₁′ = E₂", "V/m"),
        (
            "E35",
            eq((magnetic("H_1") - magnetic("H_1'")) * cos(THETA_1), magnetic("H_2") * cos(THETA_2)),
            "(H₁ − H₁′) cos θ₁ = H₂ cos θ₂",
            "A/m",
        ),
        ("E36", eq(one("r_s").into(), -difference() / sum()), "rₛ = −sin(θ₁ − θ₂)/sin(θ₁ + θ₂)", "1"),
        (
            "E37",
            eq(one("t_s").into(), 2 * sin(THETA_2) * cos(THETA_1) / sum()),
            "tₛ = 2 sin θ₂ cos θ₁/sin(θ₁ + θ₂)",
            "1",
        ),
        ("E39", eq(one("r_p").into(), tangents()), "rₚ = tan(θ₁ − θ₂)/tan(θ₁ + θ₂)", "1"),
        (
            "E40",
            eq(one("t_p").into(), 2 * sin(THETA_2) * cos(THETA_1) / (sum() * cos(THETA_1 - THETA_2))),
            "tₚ = 2 sin θ₂ cos θ₁/(sin(θ₁ + θ₂) cos(θ₁ − θ₂))",
            "1",
        ),
        ("E41", eq(one("R").into(), abs(s("S_r") / s("S_i"))), "R = |(n·Sᵣ)/(n·Sᵢ)|", "1"),
        (
            "E41",
            eq(one("T").into(), one("n_2") * cos(THETA_2) / (one("n_1") * cos(THETA_1)) * one("t").pow(2)),
            "T = (n₂ cos θ₂/(n₁ cos θ₁)) t²",
            "1",
        ),
        (
            "E42",
            eq(
                one("R_n").into(),
                ratio(1, 2)
                    * (difference().pow(2) / sum().pow(2)
                        + tan(THETA_1 - THETA_2).pow(2) / tan(THETA_1 + THETA_2).pow(2)),
            ),
            "Rₙ = ½(sin²(θ₁ − θ₂)/sin²(θ₁ + θ₂) + tan²(θ₁ − θ₂)/tan²(θ₁ + θ₂))",
            "1",
        ),
        ("E43", eq(one("R_n") + one("T_n"), 1.into()), "Rₙ + Tₙ = 1", "1"),
        (
            "E44",
            Equation::approximate(one("R"), one("R_0") + (1 - one("R_0")) * (1 - cos(THETA)).pow(5)),
            "R ≈ R₀ + (1 − R₀)(1 − cos θ)⁵",
            "1",
        ),
        ("E46", eq(BRDF.into(), d(L_R) / d(scalar("E", U::WATT_PER_SQUARE_METRE))), "fᵣ = dLᵣ/dE", "1"),
        ("E47", eq(BRDF.into(), d(L_R) / (L_IN * cos(THETA_I) * d(OMEGA_I))), "fᵣ = dLᵣ/(Lᵢₙ cos θᵢ dωᵢ)", "1"),
        ("E48", eq(BRDF.into(), one("rho") / pi()), "fᵣ = ρ/π", "1"),
        ("E50", eq(BRDF.into(), one("delta").at([OMEGA_I - OMEGA_R]) / cos(THETA_I)), "fᵣ = δ(ωᵢ − ωᵣ)/cos θᵢ", "1"),
        (
            "E52",
            eq(
                scalar("L_o", U::WATT_PER_SQUARE_METRE).at([OMEGA_R.into()]),
                scalar("L_e", U::WATT_PER_SQUARE_METRE).at([OMEGA_R.into()])
                    + integral(incoming() * BRDF.at([OMEGA_I.into(), OMEGA_R.into()]), [OMEGA_I.into()], Range::Whole),
            ),
            "Lₒ(ωᵣ) = Lₑ(ωᵣ) + ∫ Lᵢₙ cos(θᵢ) fᵣ(ωᵢ, ωᵣ) dωᵢ",
            "W/m²",
        ),
    ]
}

#[test]
fn every_equation_reads_as_it_should() {
    for (id, equation, face, _) in displayed() {
        assert_eq!(equation.to_string(), face, "{id}");
        assert!(face.chars().count() <= 78, "{id} does not fit a terminal");
    }
}

#[test]
fn every_equation_is_read_back_from_its_face() {
    for (id, equation, face, _) in displayed() {
        let mut known: Vec<Symbol> =
            equation.lhs.symbols().into_iter().chain(equation.rhs.symbols()).cloned().collect();
        known.push(SOLID);
        assert_eq!(parse_equation(face, &known).as_ref(), Ok(&equation), "{id}: {face}");
    }
}

#[test]
fn every_equation_has_its_unit() {
    for (id, equation, face, unit) in displayed() {
        let found = equation.dimension().unwrap_or_else(|mismatch| panic!("{id}: {face}: {mismatch}"));
        assert_eq!(found.to_string(), unit, "{id}: {face}");
    }
}

#[test]
fn the_coefficients_of_fresnel_are_typeset() {
    let latex = |wanted: &str| -> Vec<String> {
        displayed().iter().filter(|(id, ..)| *id == wanted).map(|(_, equation, ..)| equation.latex()).collect()
    };
    assert_eq!(latex("E36"), [r"r_{s} = -\frac{\sin(\theta_{1} - \theta_{2})}{\sin(\theta_{1} + \theta_{2})}"]);
    assert_eq!(
        latex("E40"),
        [concat!(
            r"t_{p} = \frac{2 \sin \theta_{2} \cos \theta_{1}}",
            r"{\sin(\theta_{1} + \theta_{2}) \cos(\theta_{1} - \theta_{2})}"
        )]
    );
    assert_eq!(
        latex("E41"),
        [
            r"R = \left| \frac{\boldsymbol{n} \cdot \boldsymbol{S}_{r}}{\boldsymbol{n} \cdot \boldsymbol{S}_{i}} \right|",
            r"T = \frac{n_{2} \cos \theta_{2}}{n_{1} \cos \theta_{1}} t^{2}",
        ]
    );
    assert_eq!(
        latex("E42"),
        [concat!(
            r"R_{n} = \tfrac{1}{2} \left( ",
            r"\frac{\sin^{2}(\theta_{1} - \theta_{2})}{\sin^{2}(\theta_{1} + \theta_{2})} + ",
            r"\frac{\tan^{2}(\theta_{1} - \theta_{2})}{\tan^{2}(\theta_{1} + \theta_{2})} \right)"
        )]
    );
    let snell = Equation::new(sin(THETA_1) / 2, scalar("n_in'", U::ONE));
    assert_eq!(
        snell.mathml(),
        concat!(
            r#"<math display="block"><mrow><mfrac><mrow><mi>sin</mi><mo>"#,
            "\u{2061}",
            r#"</mo><mspace width="0.1667em"/><msub><mi>θ</mi><mn>1</mn></msub></mrow><mn>2</mn></mfrac>"#,
            "<mo>=</mo><msubsup><mi>n</mi><mi>in</mi><mo>′</mo></msubsup></mrow></math>"
        )
    );
}
