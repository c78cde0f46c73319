//! E48: diffuse surfaces, smooth and rough.

use super::models::{ALBEDO, ROUGHNESS, made_from, model, way};
use super::symbols::{E, F_R, K, RHO, THETA_O};
use crate::figure::{Axis, Chart, Hue, Picture, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Step, check, derivation, exhibit, figure, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::{cos, integral_between, pi, sin};
use equation::{Equation, Expr};
use light::bsdf::{self, Bsdf};
use light::number::Vector;
use std::f64::consts::{FRAC_PI_2, PI};
use yardstick::directions::{Domain, integral, product};
use yardstick::quadrature::gauss_legendre;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "lambert",
    &[ALBEDO, ROUGHNESS],
    &[
        figure(
            "spheres",
            "Two balls under a lamp behind our shoulder: Lambert's darkens towards the rim, a rough one, as the moon, hardly.",
            spheres,
        ),
        figure(
            "gains",
            "What white rough diffuse surfaces return: the textbook's model loses energy, and gains some at grazing; the \
             other keeps all of it.",
            gains,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Diffuse surfaces",
    "A surface that looks the same from everywhere has f_r = ρ/π: π, not 2π, is what a hemisphere of it sends.",
)
.rows(&["E48"])
.statements(&[
    statement("constant", "the same for all directions", || Equation::new(F_R, K)),
    statement("albedo", "and energy conservation says which", || Equation::new(K, RHO / pi())),
])
.derivations(&[derivation("k", "all that leaves, summed over the hemisphere, is ρ of what arrived", || k(RHO / pi()))
    .slip("over 2π, the hemisphere's solid angle", || k(RHO / (2 * pi())))])
.questions(&[question(
    "white",
    "What is the BRDF of perfectly white paper?",
    Answer::Number {
        unit: "1/sr",
        tolerance: 0.01,
        right: |_| {
            let white = bsdf::Setting { albedo: [1.0; 3], ..bsdf::Setting::default() };
            model("lambert", &white).eval(way(0.3, 0.0), way(0.9, 1.0))[0]
        },
        slips: &[
            Misled { value: |_| 1.0, reply: "All of it returns, but spread over the hemisphere." },
            Misled {
                value: |_| 0.5 / PI,
                reply: "The hemisphere has 2π steradians, but weighed with cos θ they are π.",
            },
        ],
    },
    "1/π: multiplied by cos θ and summed over the hemisphere it gives 1.",
)])
.readout(|setting| {
    let of = made_from(setting);
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    let grazing = way(1.55, 0.0);
    vec![
        quantity("k", "k", "Lambert's f_r", model("lambert", &of).eval(way(0.3, 0.0), way(0.9, 1.0))[0], "1/sr"),
        quantity(
            "eon",
            "f_r",
            "of the rough one, straight back at θ = 60°",
            model("eon", &of).eval(way(1.047, 0.0), way(1.047, 0.0))[0],
            "1/sr",
        ),
        quantity(
            "gain",
            "E_{ON}",
            "what the textbook's rough model returns at θ = 89°, of white",
            {
                let white = bsdf::Setting { albedo: [1.0; 3], ..of };
                pieces(model("oren-nayar", &white).as_ref(), grazing)
            },
            "1",
        ),
    ]
})
.checks(&[&SHARE, &FURNACE, &TEXTBOOK]);

fn k(last: Expr) -> Chain {
    let leaves = integral_between(2 * pi() * K * E * cos(THETA_O) * sin(THETA_O), THETA_O, 0, pi() / 2);
    Chain::assume(Equation::new(leaves, RHO * E), "what leaves is ρ of what arrives")
        .primitive(pi() * K * E * sin(THETA_O).pow(2), THETA_O)
        .solve_for([K])
        .then(Equation::new(K, last), ["∂ sin² θ = 2 sin θ cos θ"])
}

const SHARE: Check<fn(f64) -> f64> =
    check("share", "with k = ρ/π a surface returns ρ of the light, whatever its directions")
        .against("ρ, against ∫ k cos θ dω by a product rule")
        .within(1e-13, "1", "18432 terms of a rule that is exact for it")
        .of(shares, |rho| {
            let of = bsdf::Setting { albedo: [rho; 3], ..bsdf::Setting::default() };
            model("lambert", &of).eval(way(0.3, 0.0), way(0.9, 1.0))[0]
        })
        .slip("ρ/2π", |rho| rho / (2.0 * PI));

fn shares(_: &mut Bench, k: fn(f64) -> f64) -> Measured {
    let rule = product(Domain::Hemisphere, 96);
    Measured::worst(
        [1.0, 0.5, 0.18, 1e-3].map(|rho: f64| (integral(&rule, |at| k(rho) * at[2]) / rho - 1.0, format!("ρ = {rho}"))),
    )
}

/// The rough diffuse model that returns everything: roughness [1] and direction to what is returned [1].
const FURNACE: Check<fn(f64, Vector<f64>) -> f64> = check(
    "furnace",
    "white bodies of any roughness return all light, as their authors designed them to",
)
.against("1, against ∫ f_r cos θ dω of energy-preserving Oren–Nayar, in azimuths and angles that bend where it bends")
.within(1e-9, "1", "64 points on each of the pieces between bends, on which the model is analytic but for a root")
.of(furnace, |roughness, wo| {
    let of = bsdf::Setting { roughness, albedo: [1.0; 3], ..bsdf::Setting::default() };
    pieces(model("eon", &of).as_ref(), wo)
})
.slip("the textbook's model", |roughness, wo| {
    let of = bsdf::Setting { roughness, albedo: [1.0; 3], ..bsdf::Setting::default() };
    pieces(model("oren-nayar", &of).as_ref(), wo)
});

fn furnace(_: &mut Bench, returned: fn(f64, Vector<f64>) -> f64) -> Measured {
    let roughness = [0.0, 0.1, 0.5, 1.0];
    let cases = roughness.into_iter().flat_map(|roughness| [0.0, 0.5, 1.2, 1.5, 1.57].map(|theta| (roughness, theta)));
    Measured::worst(cases.map(|(roughness, theta)| {
        (returned(roughness, way(theta, 0.0)) - 1.0, format!("r = {roughness}, θ = {theta}"))
    }))
}

/// ∫f_r cos θ_i dω_i [1] of a body that bends where θ_i = θ_o, and where ω_i·ω_o = cos θ_i cos θ_o: at φ = ±90° from the
/// view.
fn pieces(surface: &dyn Bsdf<f64>, wo: Vector<f64>) -> f64 {
    let rule = gauss_legendre(64);
    let at = wo.z.acos();
    let part = |[from, to]: [f64; 2], [begin, end]: [f64; 2]| -> f64 {
        let ring = |(u, weight): &(f64, f64)| {
            let theta = from + (to - from) * u;
            let along = |(v, share): &(f64, f64)| share * surface.eval(way(theta, begin + (end - begin) * v), wo)[0];
            weight * rule.iter().map(along).sum::<f64>() * theta.sin() * theta.cos()
        };
        (to - from) * (end - begin) * rule.iter().map(ring).sum::<f64>()
    };
    let turns = [[0.0, FRAC_PI_2], [FRAC_PI_2, PI]];
    let angles = [[0.0, at], [at, FRAC_PI_2]];
    2.0 * turns.into_iter().flat_map(|turn| angles.map(|angle| part(angle, turn))).sum::<f64>()
}

const TEXTBOOK: Check<fn(f64) -> f64> = check(
    "textbook",
    "the textbook's rough surface returns what its published A and B say: at small σ, seen at grazing, more than it got",
)
.against("1.005 at σ = 0.3 and cos θ = 0.01, from A(1 + …) integrated by hand over the azimuth: the published A and B")
.within(1e-4, "1", "the reference's closed form below, and 10⁻⁹ of quadrature")
.of(gained, |roughness| {
    let of = bsdf::Setting { roughness, albedo: [1.0; 3], ..bsdf::Setting::default() };
    pieces(model("oren-nayar", &of).as_ref(), way(GRAZING.acos(), 0.0))
})
.slip("the model that keeps its energy", |roughness| {
    let of = bsdf::Setting { roughness, albedo: [1.0; 3], ..bsdf::Setting::default() };
    pieces(model("eon", &of).as_ref(), way(GRAZING.acos(), 0.0))
});

/// cos θ_o of the view.
const GRAZING: f64 = 0.01;

/// The albedo by M. Oren and S. K. Nayar's qualitative model (SIGGRAPH '94, eq. 30): A + (B/π)∫∫ max(0, cos φ) sin α tan β
/// cos θ_i dω_i, where the azimuth gives 2 and the polar angle is one integral.
fn gained(_: &mut Bench, program: fn(f64) -> f64) -> Measured {
    let view = GRAZING.acos();
    Measured::worst([0.1, 0.191, 0.5, 1.0].map(|roughness| {
        let square = (roughness * FRAC_PI_2).powi(2);
        let (a, b) = (1.0 - 0.5 * square / (square + 0.33), 0.45 * square / (square + 0.09));
        let rule = gauss_legendre(64);
        let piece = |from: f64, to: f64| -> f64 {
            let term = |(u, weight): &(f64, f64)| {
                let theta = from + (to - from) * u;
                weight * theta.max(view).sin() * theta.min(view).tan() * theta.sin() * theta.cos()
            };
            (to - from) * rule.iter().map(term).sum::<f64>()
        };
        let exact = a + b / PI * 2.0 * (piece(0.0, view) + piece(view, FRAC_PI_2));
        (program(roughness) - exact, format!("σ = {:.3}, albedo {exact:.4}", roughness * FRAC_PI_2))
    }))
}

fn spheres(setting: &Setting) -> Plot {
    const SIDE: usize = 160;
    let of = made_from(setting);
    // A lamp a little above the eye's shoulder.
    let (lamp, eye) = (way(0.35, FRAC_PI_2), way(0.0, 0.0));
    let ball = |name: &str, title: &str| {
        let surface = model(name, &of);
        let pixel = |at: usize| {
            let place = |at: usize| (at as f64 + 0.5) / SIDE as f64 * 2.2 - 1.1;
            let (x, y) = (place(at % SIDE), -place(at / SIDE));
            let inside = 1.0 - x * x - y * y;
            if inside <= 0.0 {
                return [0.0; 3];
            }
            let [wi, wo] = [lamp, eye].map(|w| local([x, y, inside.sqrt()], w));
            // White paper facing the lamp is display white.
            surface.eval(wi, wo).map(|f| (PI * f * wi.z.max(0.0)) as f32)
        };
        Picture::new(title, SIDE, (0..SIDE * SIDE).map(pixel).collect())
    };
    let (plain, kept) = (ball("lambert", "Lambert"), ball("eon", "rough, its energy kept"));
    let printed = ball("oren-nayar", "rough, as textbooks have it");
    let errors = printed.errors(&kept, "the textbook's less the other");
    let panels = vec![plain.into(), kept.into(), printed.into(), errors.into()];
    Plot::grid(format!("Balls of albedo {}, roughness {}", of.albedo[0], of.roughness), 2, panels)
}

/// A direction as seen from a surface of a unit normal.
pub(super) fn local(normal: [f64; 3], w: Vector<f64>) -> Vector<f64> {
    let n = glam::DVec3::from_array(normal);
    let (east, north) = n.any_orthonormal_pair();
    let w = glam::DVec3::new(w.x, w.y, w.z);
    Vector::new(w.dot(east), w.dot(north), w.dot(n))
}

fn gains(setting: &Setting) -> Plot {
    let rough = made_from(setting).roughness;
    let curve = |name: &str, roughness: f64| -> Vec<[f64; 2]> {
        let of = bsdf::Setting { roughness, albedo: [1.0; 3], ..bsdf::Setting::default() };
        let surface = model(name, &of);
        (0..=44)
            .map(|at| 2.0 * f64::from(at) + 1.0)
            .map(|x| [x, pieces(surface.as_ref(), way(x.to_radians(), 0.0))])
            .collect()
    };
    let chart = Chart::new(
        "",
        Axis::linear("angle of the view θ_o", "°").range(0.0, 90.0).tick(15.0),
        Axis::linear("share returned E", "").range(0.5, 1.1),
    )
    .line(Hue::Ours, format!("energy-preserving, r = {rough}"), curve("eon", rough))
    .line(Hue::Nth(0), "Oren–Nayar, σ = 0.3", curve("oren-nayar", 0.3 / FRAC_PI_2))
    .line(Hue::Nth(1), format!("Oren–Nayar, r = {rough}"), curve("oren-nayar", rough))
    .at_y(1.0, "all of it");
    Plot::of("What a white rough body returns", chart)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_textbooks_rough_surface_gains_energy() {
        let of = bsdf::Setting { roughness: 0.3 / FRAC_PI_2, albedo: [1.0; 3], ..bsdf::Setting::default() };
        let found = pieces(model("oren-nayar", &of).as_ref(), way(GRAZING.acos(), 0.0));
        assert!(found > 1.004, "{found}");
    }
}
