//! C18: surfaces that let light through.

use super::definition::{angles, short};
use super::models::{ALPHA, INDEX, SLOPES, THETA, made_from, model, way};
use super::symbols::{N_I, N_O, THETA_I, THETA_O};
use crate::diagram::{Diagram, Part};
use crate::figure::{Axis, Chart, Dash, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Step, check, derivation, exhibit, figure,
    question, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{cos, sin};
use equation::{Dimension, Expr, Symbol};
use light::bsdf;
use light::bsdf::fresnel::dielectric;
use light::bsdf::microfacet::Joint;
use light::number::Vector;
use light::optics::fresnel::powers;
use light::optics::incidence::refracted;
use light::optics::{Direction, Incidence};
use light::references::fresnel::{Exact, Input, NAMES};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use yardstick::precise;
use yardstick::random::{stream, uniform};

pub(super) const EXHIBIT: Exhibit = exhibit(
    "glass",
    &[INDEX, SLOPES, ALPHA.default("0.6"), THETA],
    &[
        figure(
            "lobes",
            "Light on rough glass from outside and from inside: what comes back and what goes through.",
            lobes,
        ),
        figure(
            "shares",
            "What one event at a surface of glass sends on, by two kinds of masking, beside the walk.",
            shares,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Surfaces that let light through",
    "Of glass each facet reflects and refracts by Fresnel's odds; radiance inside is n² as much.",
)
.rows(&["C18"])
.derivations(&[
    derivation("snell_slope", "turn the facet: by how much the refracted ray follows, from Snell's law on both sides", || {
        snell(N_O * cos(THETA_O) / (N_I * cos(THETA_I)))
    })
    .slip("the quotient of the indices alone", || snell(N_O / N_I)),
    derivation("refraction_twin", "and so how much solid angle a refraction makes of a facet's", || {
        twin(spread() / (N_I.pow(2) * cos(THETA_I)))
    })
    .slip("n_o² for n_i²", || twin(spread() / (N_O.pow(2) * cos(THETA_I)))),
])
.questions(&[question(
    "underwater",
    "A white wall under water is seen from the air above, straight down. Its radiance in the water is 1; what is it in the \
     air, n = 1.33, reflection apart?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            // What comes from below, over Fresnel's share.
            let of = bsdf::Setting { index: 1.33, ..bsdf::Setting::default() };
            model("dielectric", &of).sample(way(1e-3, 0.0), [0.5, 0.5, 0.999_999]).weight[0]
        },
        slips: &[
            Misled { value: |_| 1.0, reply: "Radiance is constant along a ray only in one medium: here L/n² is." },
            Misled { value: |_| 1.33 * 1.33, reply: "The other way round: in the denser medium the same light is squeezed." },
        ],
    },
    "1/n²: the cone of light that leaves opens, and its radiance thins.",
)])
.readout(|setting| {
    let (of, theta) = (made_from(setting), setting.number("theta").min(FRAC_PI_2 - 1e-6));
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    let share = |name: &str, wo: Vector<f64>| super::sampling::energy(model(name, &of).as_ref(), wo, 10_000, "brdf/glass/readout").mean();
    vec![
        quantity("polished", "R", "reflected by polished glass", dielectric(theta.cos(), of.index).reflectance),
        quantity("outside", "E", "sent on by one event of rough glass, seen from outside", share("rough-dielectric", way(theta, 0.0))),
        quantity("inside", "E", "and from inside", share("rough-dielectric", -way(theta, 0.0))),
    ]
})
.checks(&[&SNELL, &BETA, &POLISHED])
.stress(&[stress("fresnel", "the surfaces' own Fresnel term, without a branch, keeps its digits near grazing, critical and equal indices", |_| interfaces(|cos, eta| dielectric(cos, eta).reflectance))
    .own(|subject| subject.downcast_ref::<fn(f64, f64) -> f64>().map(interfaces))
    .textbook("r_s and r_p by cosines, as every renderer has them")
    .against("256-bit arithmetic, and condition numbers")]);

/// By how much the refracted angle follows the incident one.
const TURN: Symbol = Symbol::scalar("tau", Dimension::ONE).real(0.5, 1.5);

fn snell(last: Expr) -> Chain {
    use equation::Equation;
    use equation::expr::partial;
    Chain::assume(
        Equation::new(N_I * cos(THETA_I) * TURN, partial(N_O * sin(THETA_O), THETA_O)),
        "n_i sin θ_i = n_o sin θ_o, differentiated by θ_o",
    )
    .because("τ is dθ_i/dθ_o")
    .solve_for([TURN])
    .then(Equation::new(TURN, last), ["chain rule"])
}

/// (n_o cos θ_o − n_i cos θ_i)².
fn spread() -> Expr {
    (N_O * cos(THETA_O) - N_I * cos(THETA_I)).pow(2)
}

fn twin(last: Expr) -> Chain {
    Chain::new(sin(THETA_O - THETA_I) * (1 - TURN) / sin(THETA_O))
        .because("about ω_o: the facet stands at θ_o, the refracted way at θ_o − θ_i; sin dΘ over sin dθ_o")
        .given(TURN, N_O * cos(THETA_O) / (N_I * cos(THETA_I)), "how the refracted ray follows")
        .given(N_I, N_O * sin(THETA_O) / sin(THETA_I), "Snell's law")
        .then(last, ["Snell's law", "sine of a difference"])
}

const SNELL: Check<fn(f64) -> f64> = check(
    "snell",
    "polished glass refracts as Snell's law has it, from outside and from inside, and reflects the rest",
)
.against("the refracted direction of chapter fresnel, and total reflection where there is none")
.within(64.0, "ulp · (1 + cond)", "near the critical angle cos θ_t moves as 1/cos θ_t; a dozen roundings")
.of(
    |bench: &mut Bench, index: fn(f64) -> f64| {
        let n = 1.5;
        let of = bsdf::Setting { index: index(n), ..bsdf::Setting::default() };
        let glass = model("dielectric", &of);
        let mut cases = Vec::new();
        for _ in 0..200 {
            let (theta, phi) = (uniform(&mut bench.stream, 0.0, 1.57), uniform(&mut bench.stream, 0.0, TAU));
            let side = if uniform(&mut bench.stream, 0.0, 1.0) < 0.5 { 1.0 } else { -1.0 };
            let wo = way(theta, phi).scaled(side);
            let (n_i, n_t) = if side > 0.0 { (1.0, n) } else { (n, 1.0) };
            let drawn = glass.sample(wo, [0.5, 0.5, 1.0 - 1e-16]);
            let place = format!("cos θ = {:.4}", wo.z);
            match refracted([-wo.x, -wo.y, -wo.z], [0.0, 0.0, 1.0], n_i, n_t) {
                Some([x, y, z]) => {
                    let off = (drawn.wi.x - x).abs().max((drawn.wi.y - y).abs()).max((drawn.wi.z - z).abs());
                    cases.push((off / (f64::EPSILON * (1.0 + 1.0 / z.abs())), place));
                }
                None => {
                    let mirrored = (drawn.wi.z - wo.z).abs().max((drawn.wi.x + wo.x).abs());
                    cases.push((mirrored / f64::EPSILON, place));
                }
            }
        }
        Measured::worst(cases)
    },
    |n| n,
)
.slip("the index the wrong way round", |n| 1.0 / n);

const BETA: Check<fn(Joint) -> Joint> = check(
    "beta",
    "of a walk on glass the first event sends on what Euler's Beta says of both maskings, and nothing else does",
)
.against("the share of walks that meet one facet, by how many standard errors of 20 000 it is off")
.within(4.5, "σ", "4.5 standard errors, of either side: once in 10⁵ by chance, for each of four views")
.of(
    |bench: &mut Bench, joint: fn(Joint) -> Joint| {
        use light::bsdf::microfacet::{Distribution, Ggx};
        use light::bsdf::walk::{Glass, Walk};
        let cases = [(0.5, 0.1), (1.0, 0.5), (1.0, -0.9), (0.5, -0.5)];
        Measured::worst(cases.map(|(alpha, cos)| {
            let (count, wo) = (20_000_u64, way(f64::acos(cos), 0.4));
            let walk = Walk::new(Ggx::new([alpha; 2]), Glass::new(1.5));
            let dice = &mut bench.stream;
            let mut throw = || [(); 3].map(|()| uniform(dice, 0.0, 1.0));
            let ones = (0..count).filter(|_| walk.bounces(wo, throw()) == 1.0).count() as f64 / count as f64;
            let of = bsdf::Setting { alpha: [alpha; 2], joint: joint(Joint::Correlated), ..bsdf::Setting::default() };
            let place = format!("α = {alpha}, cos θ = {cos}");
            let event = super::sampling::energy(model("rough-dielectric", &of).as_ref(), wo, count, &place);
            let sigma = (ones * (1.0 - ones) / count as f64).sqrt().hypot(event.standard_error());
            ((event.mean() - ones) / sigma, place)
        }))
    },
    |joint| joint,
)
.slip("masking of either side by itself", |_| Joint::Separable);

const POLISHED: Check<fn(f64, f64) -> f64> =
    check("polished", "the surfaces' own Fresnel term is that of chapter fresnel, from both sides")
        .against("R_n by complex amplitudes, at 400 random angles and indices")
        .within(64.0, "ulp · (1 + cond)", "two dozen roundings; near the critical angle R moves as 1/√ of the distance")
        .of(
            |bench: &mut Bench, program: fn(f64, f64) -> f64| {
                Measured::worst((0..400).map(|_| {
                    let (cos, eta) = (uniform(&mut bench.stream, 0.0, 1.0), uniform(&mut bench.stream, 0.3, 3.0));
                    let exact = powers(Incidence::from_cos(cos), 1.0, eta.into()).r_n();
                    let critical = (eta * eta - (1.0 - cos * cos)).abs();
                    let condition = 4.0 / critical.max(1e-24).sqrt() + 4.0 / (eta - 1.0).abs().max(1e-9);
                    (
                        (program(cos, eta) / exact - 1.0) / (f64::EPSILON * (1.0 + condition)),
                        format!("cos θ = {cos:.4}, η = {eta:.4}"),
                    )
                }))
            },
            |cos, eta| dielectric(cos, eta).reflectance,
        )
        .slip("η upside down", |cos, eta| dielectric(cos, 1.0 / eta).reflectance);

/// Reflectances at the extremes.
fn interfaces(program: impl Fn(f64, f64) -> f64) -> Vec<Extreme> {
    let indices = [1.5, 1.0 / 1.5, 1.0 + 1e-9, 1.0 - 1e-9, 4.0];
    let cosines = [1.0, 1.0 - 1e-12, 0.7, 0.3, 1e-3, 1e-7];
    let at = NAMES.iter().position(|name| *name == "R_n").expect("a name");
    let cases = indices.into_iter().flat_map(|eta| cosines.map(|cos| (eta, cos)));
    cases
        .map(|(eta, cos)| {
            let exact = Exact::new(&Input { direction: Direction::Cos(cos), n_i: 1.0, n_t: eta.into() });
            let condition = exact.conditions()[at];
            let sin2 = 1.0 - cos * cos;
            let cos_t = (1.0 - sin2 / (eta * eta)).sqrt();
            let share = |near: f64, far: f64| ((near - far) / (near + far)).powi(2);
            Extreme {
                input: format!("η = {eta:?}, cos θ = {cos:?}"),
                quantity: "R_n",
                textbook: 0.5 * (share(cos, eta * cos_t) + share(eta * cos, cos_t)),
                ours: program(cos, eta),
                condition,
                reference: exact.outputs.into_iter().nth(at).expect("as many as names"),
                worst_of: 1,
            }
        })
        .filter(|case| precise::to_f64(&case.reference).abs() > f64::MIN_POSITIVE)
        .collect()
}

fn lobes(setting: &Setting) -> Plot {
    let of = made_from(setting);
    let theta = setting.number("theta").min(1.5);
    let surface = model("rough-dielectric", &of);
    let panel = |title: &str, side: f64| {
        let wi = way(theta, PI).scaled(side);
        let wi = Vector::new(-theta.sin(), 0.0, wi.z);
        let outwards = if side > 0.0 { 1.0 / of.index } else { of.index };
        let bent = (theta.sin() * outwards).min(1.0).asin();
        let about = if side > 0.0 { [theta, PI - bent] } else { [PI - theta, bent] };
        let values: Vec<(f64, f64)> = angles(about)
            .into_iter()
            .map(|angle| {
                let wo = Vector::new(angle.sin(), 0.0, angle.cos());
                (angle, surface.eval(wi, wo)[0] * wo.z.abs())
            })
            .collect();
        let most = values.iter().map(|value| value.1).fold(f64::MIN_POSITIVE, f64::max);
        let points = values.iter().map(|(angle, f)| [f / most * angle.sin(), f / most * angle.cos()]).collect();
        let from = [1.1 * wi.x, 1.1 * wi.z];
        Diagram::new(format!("{title}: up to {} 1/sr", short(most)), [-1.3, -1.2], [1.3, 1.2])
            .with(Part::surface([-1.2, 0.0], [1.2, 0.0], crate::diagram::Behind::Tinted(1.0 - 1.0 / of.index.max(1.0))))
            .with(Part::line([0.0, -1.1], [0.0, 1.1]).dash(Dash::Dashed).hue(Hue::Reference))
            .with(Part::ray_with_heads(from, [0.0; 2], &[0.5]).hue(Hue::P))
            .with(Part::curve(points).hue(Hue::Ours))
            .into()
    };
    let panels = vec![panel("from outside", 1.0), panel("from inside", -1.0)];
    Plot::grid(format!("f_r cos θ_o of rough glass, n = {}, α = {}", of.index, of.alpha[0]), 2, panels)
}

fn shares(setting: &Setting) -> Plot {
    use light::bsdf::microfacet::{Distribution, Ggx};
    use light::bsdf::walk::{Glass, Walk};
    let of = made_from(setting);
    let angles = || (0..=16).map(|step| (5.0 * f64::from(step) + 2.5).min(87.0));
    let event = |joint: Joint| -> Vec<[f64; 2]> {
        let surface = model("rough-dielectric", &bsdf::Setting { joint, ..of });
        angles()
            .map(|x| {
                [
                    x,
                    super::sampling::energy(surface.as_ref(), way(x.to_radians(), 0.4), 3000, "brdf/glass/shares")
                        .mean(),
                ]
            })
            .collect()
    };
    let walk = Walk::new(Ggx::new(of.alpha), Glass::new(of.index));
    let mut dice = stream(0, "brdf/glass/shares");
    let walked: Vec<[f64; 2]> = angles()
        .map(|x| {
            let wo = way(x.to_radians(), 0.4);
            let mut throw = || [(); 3].map(|()| uniform(&mut dice, 0.0, 1.0));
            [x, (0..3000).filter(|_| walk.bounces(wo, throw()) == 1.0).count() as f64 / 3000.0]
        })
        .collect();
    let chart = Chart::new(
        "",
        Axis::linear("angle of the view θ_o", "°").range(0.0, 90.0).tick(15.0),
        Axis::linear("sent on by one event", ""),
    )
    .line(Hue::Ours, "Euler's Beta through the surface", event(Joint::Correlated))
    .line(Hue::Textbook, "either side by itself", event(Joint::Separable))
    .dashed(Hue::Reference, "the walk (GGX)", walked);
    Plot::of(format!("One event at rough glass, n = {}, α = {}", of.index, of.alpha[0]), chart)
}
