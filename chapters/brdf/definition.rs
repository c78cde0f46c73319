//! E45–E47: how much of what comes from one direction goes to another.

use super::models::{ALBEDO, ALPHA, INDEX, METAL, MODEL, ROUGHNESS, SLOPES, THETA, chosen, made_from, model, way};
use super::symbols::{E, F_R, L_IN, L_R, OMEGA_I, OMEGA_O, RHO, THETA_I, THETA_O, W_I, W_O};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Step, check, choice, derivation, excess, exhibit, figure,
    question, statement, step,
};
use equation::derivation::Chain;
use equation::expr::{Range, cos, d, integral};
use equation::{Equation, Expr};
use light::bsdf::{self, Bsdf, Energy, zoo};
use light::number::Vector;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use yardstick::directions::{Domain, product};
use yardstick::order;
use yardstick::quadrature::gauss_legendre;
use yardstick::random::Stream;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "definition",
    &[MODEL, SLOPES, ALPHA, METAL, INDEX, ROUGHNESS, ALBEDO, THETA],
    &[
        figure("directions", "Light comes from ω_i and goes to ω_o; both point away from the surface.", directions),
        figure(
            "lobes",
            "How a surface spreads what comes in at four angles: f_r cos θ_o in the plane of incidence.",
            lobes,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "From one direction to another",
    "The BRDF is the radiance that leaves over the irradiance that caused it; it is the same both ways.",
)
.rows(&["E45", "E46", "E47"])
.about("of_irradiance")
.statements(&[
    statement("both_ways", "the same both ways, in 1/sr", || {
        Equation::new(F_R.at([W_I.into(), W_O.into()]), F_R.at([W_O.into(), W_I.into()]))
    })
    .rows(&["E45"]),
    statement("share", "what leaves in all is a share ρ ≤ 1 of what came", || {
        Equation::new(RHO, integral(F_R * cos(THETA_O), [OMEGA_O.into()], Range::Whole))
    })
    .rows(&["E45"]),
    statement("of_irradiance", "radiance over the irradiance that causes it", || Equation::new(F_R, d(L_R) / d(E)))
        .rows(&["E46"]),
    statement("of_radiance", "the same by the radiance that comes in", || {
        Equation::new(F_R, d(L_R) / (L_IN * cos(THETA_I) * d(OMEGA_I)))
    })
    .rows(&["E47"]),
])
.derivations(&[derivation("bundle", "one bundle of light adds L cos θ dω to the irradiance", || {
    bundle(d(L_R) / (L_IN * cos(THETA_I) * d(OMEGA_I)))
})
.rows(&["E47"])
.slip("cos θ forgotten", || bundle(d(L_R) / (L_IN * d(OMEGA_I))))])
.questions(&[question(
    "above_one",
    "A surface returns at most what it gets. Can its BRDF be larger than 1?",
    Answer::Choice {
        options: &[
            choice("no: then more would leave than came", "What may not exceed 1 is the BRDF's integral with its cosine."),
            choice("yes: without bound, if the directions are few enough", ""),
            choice("only for a source of light", "A mirror sends all of it into one direction: per steradian that is very much."),
        ],
        right: |_| {
            let narrow = bsdf::Setting { alpha: [0.01; 2], ..bsdf::Setting::default() };
            let along = way(0.5, 0.0);
            usize::from(model("rough-conductor", &narrow).eval(along, way(0.5, PI))[0] > 1.0)
        },
        slip: |_| 0,
    },
    "It is a share per steradian: a nearly smooth metal's is in the thousands, within a lobe of a thousandth of a steradian.",
)])
.readout(|setting| {
    let (surface, theta) = (chosen(setting), setting.number("theta").min(FRAC_PI_2 - 1e-6));
    let (wi, mirrored) = (way(theta, PI), way(theta, 0.0));
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("f_mirror", "f_r", "to the mirror's direction (green), deltas left out", surface.eval(wi, mirrored)[1], "1/sr"),
        quantity("f_back", "f_r", "straight back", surface.eval(wi, wi)[1], "1/sr"),
        quantity("f_up", "f_r", "along the normal", surface.eval(wi, way(0.0, 0.0))[1], "1/sr"),
    ]
})
.checks(&[&RECIPROCITY, &ENERGY, &BUNDLES]);

fn bundle(last: Expr) -> Chain {
    Chain::new(d(L_R) / d(E))
        .given(d(E), L_IN * cos(THETA_I) * d(OMEGA_I), "what one bundle adds to E")
        .then(last, ["what one bundle adds to E"])
}

/// A direction drawn evenly from the sphere.
fn any(dice: &mut Stream) -> Vector<f64> {
    let [x, y, z] = crate::plane_wave::fields::direction(dice).to_array();
    Vector::new(x, y, z)
}

const RECIPROCITY: Check<fn(f64) -> f64> = check(
    "reciprocity",
    "every model is the same both ways, but for n² across a surface of glass",
)
.rows(&["E45"])
.against("f_r(ω_o → ω_i), with the radiance of the denser side over n²")
.within(
    1e-6,
    "1",
    "the half vector of a refraction cancels: 10⁻¹⁶ over the contrast of the directions, some 10⁻³ at worst, twice",
)
.of(both_ways, |index| index * index)
.slip("radiance taken to be the same on both sides of the glass", |_| 1.0);

fn both_ways(bench: &mut Bench, squared: fn(f64) -> f64) -> Measured {
    let mut cases = Vec::new();
    for entry in zoo::<f64>() {
        // Tables over two angles take longer to make than all the rest.
        let across = if entry.name.contains("compensated") || entry.name.contains("plastic") { 0.3 } else { 0.5 };
        let of = bsdf::Setting { alpha: [0.3, across], ..bsdf::Setting::default() };
        let surface = entry.make(&of);
        let character = surface.character();
        if character.is_delta || character.is_stochastic {
            continue;
        }
        for _ in 0..200 {
            let (wi, wo) = (any(&mut bench.stream), any(&mut bench.stream));
            let side = |w: Vector<f64>| if w.z < 0.0 { squared(of.index) } else { 1.0 };
            let (there, back) = (surface.eval(wi, wo)[0] / side(wo), surface.eval(wo, wi)[0] / side(wi));
            if there > 1e-12 && wi.z.abs().min(wo.z.abs()) > 1e-2 {
                cases.push((there / back - 1.0, format!("{}, cos θ {:.3} and {:.3}", entry.name, wi.z, wo.z)));
            }
        }
    }
    Measured::worst(cases)
}

const ENERGY: Check<fn(f64) -> f64> =
    check("energy", "no model that promises it returns more than it gets, seen from outside")
        .rows(&["E45"])
        .against("1, against the integral of f_r cos θ over the hemisphere (and below it) by a product rule")
        .within(1e-3, "1", "80 × 160 directions on lobes of α = 0.3, which end with a bend at the horizon")
        .of(returned, |cos| cos)
        .slip("cos θ forgotten", |_| 1.0);

/// By how much a model returns more than all.
fn returned(_: &mut Bench, weight: fn(f64) -> f64) -> Measured {
    let rule = product(Domain::Hemisphere, 80);
    let mut cases = Vec::new();
    for entry in zoo::<f64>() {
        let surface = entry.make(&bsdf::Setting::default());
        let character = surface.character();
        if character.is_delta || character.is_stochastic || character.energy == Energy::Gained {
            continue;
        }
        for theta in [0.0, 0.7, 1.3] {
            let wo = way(theta, 0.4);
            let sum: f64 =
                rule.iter().map(|(at, dω)| gathered(surface.as_ref(), Vector::of(*at), wo, weight) * dω).sum();
            cases.push((excess(sum - 1.0), format!("{}, θ = {theta}", entry.name)));
        }
    }
    Measured::worst(cases)
}

/// What comes from a direction and from its image below, radiance there times n².
fn gathered(surface: &dyn Bsdf<f64>, at: Vector<f64>, wo: Vector<f64>, weight: fn(f64) -> f64) -> f64 {
    let below = Vector::new(at.x, at.y, -at.z);
    let index = bsdf::Setting::default().index;
    weight(at.z) * (surface.eval(at, wo)[0] + surface.eval(below, wo)[0] * index * index)
}

const BUNDLES: Check<fn(f64, f64) -> f64> = check(
    "bundles",
    "the radiance that ever narrower bundles cause, over what they add to the irradiance, is the model's f_r",
)
.rows(&["E46", "E47"])
.against("f_r of rough gold in the middle of the bundle, against sums over the bundle by product rules")
.order(2.0, 0.05, "what is odd about the middle cancels over the bundle, and the square of its width is left")
.of(narrowing, |irradiance, _| irradiance)
.slip("over the radiance times the solid angle, cos θ forgotten", |_, radiance| radiance);

fn narrowing(_: &mut Bench, over: fn(f64, f64) -> f64) -> Measured {
    let of = bsdf::Setting { metal: super::models::metal("gold"), ..bsdf::Setting::default() };
    let surface = model("rough-conductor", &of);
    let (theta, phi, wo) = (0.8, 0.3, way(0.5, PI));
    let exact = surface.eval(way(theta, phi), wo)[0];
    let rule = gauss_legendre(8);
    let points: Vec<(f64, f64)> = (1..7)
        .map(|halving| {
            let half = 0.2 / f64::from(1 << halving);
            let (mut caused, mut irradiance, mut radiance) = (0.0, 0.0, 0.0);
            for (u, a) in &rule {
                for (v, b) in &rule {
                    let (t, p) = (theta + half * (2.0 * u - 1.0), phi + half * (2.0 * v - 1.0));
                    let patch = a * b * 4.0 * half * half * t.sin();
                    caused += surface.eval(way(t, p), wo)[0] * t.cos() * patch;
                    irradiance += t.cos() * patch;
                    radiance += patch;
                }
            }
            (half, (caused / over(irradiance, radiance) / exact - 1.0).abs())
        })
        .collect();
    Measured::new(order::slope(&points).unwrap_or(f64::NAN), "bundles from 0.1 to 0.003 rad", points.len())
}

fn directions(setting: &Setting) -> Plot {
    let theta = setting.number("theta");
    let ray = |angle: f64, length: f64| [length * angle.sin(), length * angle.cos()];
    let (from, to) = (ray(-theta, 1.25), ray(0.55, 1.25));
    let diagram = Diagram::new("", [-1.7, -0.35], [1.7, 1.5])
        .with(Part::surface([-1.6, 0.0], [1.6, 0.0], Behind::Hatched))
        .with(Part::line([0.0; 2], [0.0, 1.35]).dash(Dash::Dashed).hue(Hue::Reference).label("n"))
        .with(Part::ray_with_heads(from, [0.0; 2], &[0.5]).hue(Hue::P).label("L_{in}"))
        .with(Part::vector(ray(-theta, 0.0), ray(-theta, 0.55)).label("ω_i"))
        .with(Part::ray_with_heads([0.0; 2], to, &[0.75]).hue(Hue::Ours).label("L_r"))
        .with(Part::vector([0.0; 2], ray(0.55, 0.55)).label("ω_o"))
        .with(Part::arc([0.0; 2], 0.35, FRAC_PI_2, FRAC_PI_2 + theta).label("θ_i"))
        .with(Part::arc([0.0; 2], 0.45, FRAC_PI_2 - 0.55, FRAC_PI_2).label("θ_o"));
    Plot::of("The two directions of a BRDF", diagram)
}

/// f cos θ_o in the plane of incidence, polar; each over its own largest, which the key tells.
fn lobes(setting: &Setting) -> Plot {
    let surface = chosen(setting);
    let below = surface.character().transmits;
    let mut diagram = Diagram::new("", [-1.7, if below { -1.15 } else { -0.15 }], [1.7, 1.15]);
    let rim = |from: f64, to: f64| -> Vec<[f64; 2]> {
        (0..=90).map(|at| from + (to - from) * f64::from(at) / 90.0).map(|t| [t.sin(), t.cos()]).collect()
    };
    let rim = rim(-FRAC_PI_2, if below { FRAC_PI_2 * 3.0 } else { FRAC_PI_2 });
    diagram = diagram
        .with(Part::curve(rim).hue(Hue::Reference))
        .with(Part::line([-1.3, 0.0], [1.3, 0.0]).hue(Hue::Reference));
    for (at, degrees) in [0.0, 30.0, 60.0, 80.0].into_iter().enumerate() {
        let (theta, hue) = (f64::to_radians(degrees), Hue::Nth(at as u8));
        let wi = way(theta, PI);
        // Where a narrow lobe may be: the mirror's direction, and that of the refracted ray.
        let refracted = (theta.sin() / made_from(setting).index).min(1.0).asin();
        let values: Vec<(f64, f64)> = angles([theta, PI - refracted])
            .into_iter()
            .map(|angle| {
                let wo = Vector::new(angle.sin(), 0.0, angle.cos());
                (angle, surface.eval(wi, wo)[1] * wo.z.abs())
            })
            .collect();
        let most = values.iter().map(|value| value.1).fold(0.0, f64::max);
        if most == 0.0 {
            continue;
        }
        let points = values.iter().map(|(angle, f)| [f / most * angle.sin(), f / most * angle.cos()]).collect();
        let from = [-1.1 * theta.sin(), 1.1 * theta.cos()];
        diagram = diagram
            .with(Part::curve(points).hue(hue))
            .with(Part::ray(from, from.map(|part| part * 0.75)).hue(hue))
            .explain(hue, Dash::Solid, format!("θ_i = {degrees}°, up to {}", short(most)));
    }
    let model = setting.word("model");
    let title = match diagram.key.is_empty() {
        true => format!("{model} has no lobe, but a delta"),
        false => format!("f_r cos θ_o of {model} (1/sr, green), each over its largest"),
    };
    Plot::of(title, diagram)
}

/// Directions of a polar curve [rad], even, and crowded about two of them: a narrow lobe lies between even ones.
pub(super) fn angles(about: [f64; 2]) -> Vec<f64> {
    const STEPS: i32 = 1440;
    let even = (0..=STEPS).map(|step| TAU * f64::from(step) / f64::from(STEPS));
    let off = || (0..60).map(|k| 10f64.powf(-7.0 + f64::from(k) / 10.0));
    let near = about.into_iter().flat_map(|angle| {
        std::iter::once(angle)
            .chain(off().flat_map(move |off| [angle - off, angle + off]))
            .map(|angle| angle.rem_euclid(TAU))
    });
    let mut all: Vec<f64> = even.chain(near).collect();
    all.sort_by(f64::total_cmp);
    all
}

pub(super) fn short(x: f64) -> String {
    if (0.01..1000.0).contains(&x) { format!("{x:.2}") } else { format!("{x:.1e}") }
}
