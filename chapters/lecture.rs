//! The rows of the lecture: every equation (E…) and claim (C…) of the notes, with the evidence each must have.
//! The numbers are permanent names; gaps are the notes' own. What a row *has* is never typed: [`coverage`] computes it.

use crate::vocabulary::{Chapter, Step};

/// One row of the lecture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Permanent name.
    pub id: &'static str,
    /// Chapter that owes it.
    pub chapter: &'static str,
    /// What it states, in short.
    pub states: &'static str,
    /// The letters it must have, in the order `DUNXPR`: derived, units checked, numerically checked, extreme
    /// cases, plotted, raced.
    pub needs: &'static str,
}

/// A row and what the curriculum has for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coverage {
    /// The row.
    pub row: Row,
    /// Addresses (`chapter/step`) of the steps that teach it or hold evidence for it.
    pub steps: Vec<String>,
    /// Needed letters for which there is evidence.
    pub met: Vec<char>,
    /// Needed letters for which there is none.
    pub missing: Vec<char>,
}

/// Every chapter of the lecture, written or not, in teaching order.
pub fn chapter_names() -> Vec<&'static str> {
    let mut names: Vec<_> = LECTURE.iter().map(|row| row.chapter).collect();
    names.dedup();
    names
}

/// What `curriculum` has for every row of [`LECTURE`].
pub fn coverage(curriculum: &[&Chapter]) -> Vec<Coverage> {
    LECTURE.iter().map(|row| cover(row, curriculum)).collect()
}

fn cover(row: &Row, curriculum: &[&Chapter]) -> Coverage {
    let mut steps = Vec::new();
    let mut found = String::new();
    for chapter in curriculum {
        for step in chapter.steps {
            let letters = evidence(step, row.id);
            if step.rows.contains(&row.id) || !letters.is_empty() {
                steps.push(format!("{}/{}", chapter.id, step.id));
            }
            found.push_str(&letters);
        }
    }
    let (met, missing) = row.needs.chars().partition(|letter| found.contains(*letter));
    Coverage { row: *row, steps, met, missing }
}

/// The letters for which `step` holds evidence about the row `id`.
fn evidence(step: &Step, id: &str) -> String {
    step.items().filter(|item| step.rows_of(item).contains(&id)).filter_map(|item| item.letter()).collect()
}

const fn row(id: &'static str, chapter: &'static str, needs: &'static str, states: &'static str) -> Row {
    Row { id, chapter, states, needs }
}

/// Every row, in the lecture's order.
pub const LECTURE: &[Row] = &[
    row("E1", "maxwell", "UN", "∇·D = ρ; ∇·B = 0; ∇×E = −∂B/∂t; ∇×H = J + ∂D/∂t"),
    row("E2", "maxwell", "DUN", "continuity ∇·J = −∂ρ/∂t (follows from E1: divergence of the last, with the first)"),
    row("E3", "maxwell", "UN", "D = εE, B = μH, J = σE; isotropic here (scalars); the notes mention 3×3 tensors"),
    row("E4", "maxwell", "DUNX", "at an interface: n·(B₁−B₂)=0, n·(D₁−D₂)=0, n×(E₁−E₂)=0, n×(H₁−H₂)=0"),
    row("C1", "maxwell", "N", "E4 as written holds only without surface charge and surface current"),
    row("C2", "maxwell", "NXPR", "all of rendering is these equations in free space"),
    row("E5", "plane-wave", "DUN", "source-free, uniform, lossless, isotropic form of E1"),
    row("E6", "plane-wave", "DUN", "∇×(∇×E) = −∂(∇×B)/∂t = −εμ ∂²E/∂t²"),
    row("E7", "plane-wave", "DUN", "(∇² − εμ ∂²/∂t²) E = 0"),
    row("E8", "plane-wave", "DUN", "the same for B"),
    row("E9", "plane-wave", "DUN", "one-dimensional reduction (∂²/∂z² − εμ ∂²/∂t²) E = 0"),
    row(
        "E10",
        "plane-wave",
        "DUNPR",
        "d'Alembert: E = f₁(z − t/√(εμ)) + f₂(z + t/√(εμ)) for any twice differentiable f₁, f₂",
    ),
    row("E11", "plane-wave", "UN", "1/√(εμ) in vacuum = c. The notes print it without the root"),
    row("E12", "plane-wave", "DN", "one-way solution E = f_E(z − vt), B = f_B(z − vt)"),
    row("E13", "plane-wave", "NPR", "a finite-energy wave is a sum of harmonics, so one frequency suffices"),
    row("E14", "plane-wave", "DUNP", "E = A cos[(2π/λ)(z − vt)], B = A′ cos[(2π/λ)(z − vt)]"),
    row("E15", "plane-wave", "DN", "transverse; E·B = 0; in phase"),
    row("E16", "plane-wave", "DUN", "|E|/|B| = 1/√(με) = v"),
    row("E17", "plane-wave", "DUN", "|E|/|H| = √(μ/ε) = Z_c, in Ω (vacuum: 376.73…)"),
    row("E18", "plane-wave", "DUNXPR", "in a lossy medium: complex wave number and complex impedance, H lags E"),
    row("E19", "plane-wave", "DUN", "k = ω/v in rad/m, along the propagation; E = A cos(kz − ωt)"),
    row("E20", "poynting", "UN", "S = (1/μ) E×B, instantaneous energy flux density, W/m²"),
    row(
        "C3",
        "poynting",
        "DNX",
        "S points along the propagation; Poynting's theorem (energy balance, also with losses) closes",
    ),
    row("C4", "poynting", "N", "orders of magnitude: λ ~ 1e−7 m, c ~ 1e8 m/s"),
    row("E23", "poynting", "DUNXPR", "⟨|S|⟩ = (1/T)∫₀ᵀ|S|dt = ½ v ε A²"),
    row(
        "E24",
        "poynting",
        "DN",
        "⟨|S|⟩ ∝ A²; the phasor form ½ Re(E×H*) agrees, and stays right where E and H are out of phase",
    ),
    row("C5", "poynting", "NPR", "a detector averages over many, not a whole number of, periods"),
    row(
        "C6",
        "radiometry",
        "U",
        "the struck-out encyclopaedia formula (Φ = dQ/dt with Q = ∫S·n dA) fails the dimension check",
    ),
    row("E26", "radiometry", "UN", "Φ = ∫⟨|S|⟩ cos α dA, in W"),
    row("E27", "radiometry", "DUNR", "Φ over a detection sphere = ∮ S_r r² sin θ dφ dθ"),
    row("E28", "radiometry", "DUN", "dΩ = sin θ dφ dθ; the whole sphere is 4π sr"),
    row("E29", "radiometry", "UN", "radiant intensity I = S_r r², W/sr"),
    row("E30", "radiometry", "DUN", "Φ = ∮ I dΩ, I = ∂Φ/∂Ω"),
    row("E31", "radiometry", "UN", "radiance L = ∂I/∂(A cos θ) = ∂²Φ/(∂Ω ∂(A cos θ)), W/(sr·m²)"),
    row(
        "E32",
        "radiometry",
        "DUNXPR",
        "irradiance E = ∫ L cos θ dω; closed forms for sphere, disc, rectangle and polygon",
    ),
    row("C7", "radiometry", "NX", "the flux does not depend on the radius or shape of the detecting surface"),
    row("C8", "radiometry", "DNP", "radiance is what a pixel sees: it is constant along a ray in free space"),
    row(
        "C9",
        "radiometry",
        "N",
        "the notes say that each element of a source radiates along its own normal (far field)",
    ),
    row("E33", "fresnel", "DUNX", "θ₁ = θ₁′; sin θ₁/v₁ = sin θ₂/v₂; n₁ sin θ₁ = n₂ sin θ₂"),
    row("E35", "fresnel", "DUN", "s: E₁+E₁′ = E₂; (H₁ − H₁′) cos θ₁ = H₂ cos θ₂"),
    row("E36", "fresnel", "DNXP", "r_s = −sin(θ₁−θ₂)/sin(θ₁+θ₂)"),
    row("E37", "fresnel", "DNXP", "t_s = 2 sin θ₂ cos θ₁/sin(θ₁+θ₂)"),
    row("E38", "fresnel", "DUN", "p: (E₁ − E₁′) cos θ₁ = E₂ cos θ₂; H₁ + H₁′ = H₂"),
    row("E39", "fresnel", "DNXP", "r_p = tan(θ₁−θ₂)/tan(θ₁+θ₂)"),
    row("E40", "fresnel", "DNXP", "t_p = 2 sin θ₂ cos θ₁/(sin(θ₁+θ₂) cos(θ₁−θ₂))"),
    row("E41", "fresnel", "DUNX", "R = n·S_r/n·S_i, T = n·S_t/n·S_i; so T = (n₂cosθ₂/n₁cosθ₁) t² and not t²"),
    row("E42", "fresnel", "DNXPR", "natural light: R_n = ½[sin²(θ₁−θ₂)/sin²(θ₁+θ₂) + tan²(θ₁−θ₂)/tan²(θ₁+θ₂)]"),
    row("E43", "fresnel", "DNX", "R_n + T_n = 1 (lossless)"),
    row("C10", "fresnel", "XPR", "E36–E42 as written are 0/0 at normal incidence and lose digits near it"),
    row("C11", "fresnel", "NP", "“reflectance rises with the angle” is not true for every interface"),
    row("C12", "fresnel", "NP", "Fresnel effect: R → 1 at grazing, shown on a rendered object too"),
    row(
        "C13",
        "fresnel",
        "DNXP",
        "total internal reflection (n₁ > n₂): complex r, |r| = 1, phase shift, evanescent wave",
    ),
    row("C14", "fresnel", "NXP", "absorbing media and metals: complex index, same code path"),
    row("E44", "fresnel", "NXPR", "Schlick: R ≈ R₀ + (1−R₀)(1−cos θ)⁵"),
    row("C15", "fresnel", "DNXPR", "beyond the notes: a stack of films (the same boundary conditions, repeated)"),
    row("E45", "brdf", "UN", "f_r(x, ω_i, ω_o), 1/sr; reciprocity, energy conservation"),
    row("C16", "brdf", "NPR", "roughness is microfacets that each obey the mirror law"),
    row("E46", "brdf", "UN", "f_r = dL_r/dE"),
    row("E47", "brdf", "DUN", "f_r = dL_r/(L_in cos θ dω)"),
    row("E48", "brdf", "DUNP", "Lambert: f_r = k, and energy conservation makes k = ρ/π"),
    row("E49", "brdf", "N", "mirror: L_r(ω_r) = L_in(mirror direction): the delta integrates to one"),
    row("E50", "brdf", "DUN", "f_mirror = δ(ω_i − ω_r)/cos θ_i"),
    row("C17", "brdf", "NXPR", "BRDF sampling: for every model"),
    row("C18", "brdf", "NX", "transmission needs the BSDF, which the notes only name: smooth and rough dielectric"),
    row("E51", "rendering-equation", "DUNR", "L_r(ω_r) = ∫ L_in cos θ_i f_r dω_i"),
    row("E52", "rendering-equation", "UN", "L_o = L_e + ∫ L_in cos θ_i f_r dω_i"),
    row("C19", "rendering-equation", "DNXPR", "it is recursive: its Neumann series converges as albedo^k"),
    row(
        "C20",
        "rendering-equation",
        "NXPR",
        "radiosity (finite elements): form factors, solved progressively and by a direct method",
    ),
    row(
        "E53",
        "path-tracing",
        "DN",
        "the camera ray's first hit needs E51 with unknown L_in: one new ray, recursively",
    ),
    row("C21", "path-tracing", "NPR", "the notes sample the uniform hemisphere: right, with its weight"),
    row("C22", "path-tracing", "NPR", "a depth limit ends the recursion and loses energy: measure the bias by depth"),
    row(
        "C23",
        "path-tracing",
        "NPR",
        "one ray per path, many paths per pixel: error falls as N^−½; quasi-random points do better",
    ),
    row("C24", "path-tracing", "NP", "global illumination, tone mapping: a picture, PNG for eyes and EXR for numbers"),
    row("C25", "path-tracing", "NPR", "irradiance caching: the same picture, error against run time"),
    row("C26", "path-tracing", "NPR", "photon mapping: the same picture, caustics, error against run time"),
    row("C27", "path-tracing", "NXP", "light through glass with wavelength-dependent index"),
];
