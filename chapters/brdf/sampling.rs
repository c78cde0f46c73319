//! C17: drawing directions as surfaces send them.

use super::models::{ALPHA, INDEX, METAL, MODEL, SLOPES, THETA, chosen, made_from, model, way};
use crate::diagram::{Diagram, Part};
use crate::figure::{Axis, Hue, Map, Plot, Ramp};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Heat, Measured, Misled, Quantity, Race, Step, check, excess, exhibit, figure, lane,
    question, race, step,
};
use light::bsdf::albedo::Rule;
use light::bsdf::audit::{drawn, lobe_density, spread_density};
use light::bsdf::fresnel::{Conductor, Reflecting};
use light::bsdf::microfacet::{Distribution, Ggx, Joint, Slopes};
use light::bsdf::rough_conductor::RoughConductor;
use light::bsdf::{self, Bsdf, Guarded, zoo};
use light::number::{F32x8, Number, Vector, vectorised};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use yardstick::directions::{Domain, Points};
use yardstick::random::{Stream, stream, uniform};
use yardstick::statistics::Moments;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "sampling",
    &[MODEL, SLOPES, ALPHA, METAL, INDEX, THETA],
    &[
        figure(
            "points",
            "Directions that the model draws, over the hemisphere from above, beside its density.",
            points,
        ),
        figure(
            "square",
            "The same by the numbers from which facets are drawn: even over the square, however narrow the lobe.",
            square,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Drawing directions",
    "Sample, density and value of every model are one: what is drawn follows the density, and no weight is large.",
)
.rows(&["C17"])
.questions(&[question(
    "uniform",
    "Light on metal of α = 0.1 is estimated from directions drawn evenly over the hemisphere. Most of its facets lie within 0.1 rad of the normal. Which share of the directions meets the lobe, about, seen from above?",
    Answer::Number {
        unit: "1",
        tolerance: 0.6,
        right: |_| 4.0 * 0.1 * 0.1 / 2.0,
        slips: &[
            Misled { value: |_| 0.1 * 0.1 / 2.0, reply: "So the facets lie; what they reflect turns twice as far." },
            Misled { value: |_| 0.1 / FRAC_PI_2, reply: "Two dimensions: the share is the square of an angle." },
            Misled { value: |_| 1.0, reply: "All would, if they were drawn as the lobe lies." },
        ],
    },
    "π·0.2² of 2π: two per cent. The others are traced for nothing.",
)])
.readout(|setting| {
    let surface = chosen(setting);
    let wo = way(setting.number("theta").min(FRAC_PI_2 - 1e-6), 0.0);
    let found = drawn(surface.as_ref(), wo, 20_000, "brdf/sampling/readout");
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("mean", "⟨w⟩", "mean weight: the share returned", found.energy.mean()),
        quantity("largest", "w_{max}", "the largest of 20 000", found.largest),
        quantity("scatter", "σ", "their scatter", found.energy.variance().sqrt()),
        quantity("through", "T", "share that came through", found.through),
    ]
})
.checks(&[&DENSITY, &SPREAD, &WEIGHTS])
.races(&[STRATEGIES, WIDTHS]);

/// Draws of one χ² test.
const DRAWS: u64 = 20_000;

/// How a model's directions are drawn.
type Wrong = fn(&dyn Bsdf<f64>, Vector<f64>) -> Vector<f64>;

/// A model that is seen from elsewhere than it thinks.
struct Askew {
    model: Box<dyn Bsdf<f64>>,
    view: Wrong,
}

impl Bsdf<f64> for Askew {
    fn character(&self) -> bsdf::Character {
        self.model.character()
    }
    fn eval_pdf(&self, wi: Vector<f64>, wo: Vector<f64>) -> ([f64; 3], f64) {
        self.model.eval_pdf(wi, wo)
    }
    fn sample(&self, wo: Vector<f64>, u: [f64; 3]) -> bsdf::Sample<f64> {
        let seen = (self.view)(self.model.as_ref(), wo);
        self.model.sample(seen, u)
    }
}

const DENSITY: Check<Wrong> = check("density", "directions of rough metal and glass follow their density, narrow or wide, to grazing")
    .against("the density over the facets' own square of numbers, summed in 16 × 16 cells, reflection and transmission apart (χ²)")
    .significant(1e-3)
    .of(
        |_: &mut Bench, view: Wrong| {
            let cases = [
                ("rough-conductor", Slopes::Ggx, 1e-3, 0.5),
                ("rough-conductor", Slopes::Beckmann, 0.5, 0.1),
                ("rough-dielectric", Slopes::Ggx, 0.3, 0.2),
            ];
            worst_p(cases.into_iter().map(|(name, slopes, alpha, cos)| {
                let of = bsdf::Setting { alpha: [alpha; 2], slopes, ..bsdf::Setting::default() };
                let askew = Askew { model: model(name, &of), view };
                let place = format!("{name}, {slopes:?}, α = {alpha}, cos θ = {cos}");
                (lobe_density(&askew, &of, way(f64::acos(cos), 0.6), DRAWS, &place), place)
            }))
        },
        |_, wo| wo,
    )
    .slip("facets drawn for a view along the normal, as if none hid another", |_, _| Vector::of([0.0, 0.0, 1.0]));

const SPREAD: Check<Wrong> = check("spread", "directions of diffuse bodies follow their density")
    .against("the density over cells even in cos² and azimuth (χ²)")
    .significant(1e-3)
    .of(
        |_: &mut Bench, view: Wrong| {
            let cases = zoo::<f64>().into_iter().filter(|entry| ["lambert", "oren-nayar", "eon"].contains(&entry.name));
            let cases = cases.flat_map(|entry| [0.7, 0.05].map(|cos| (entry, cos)));
            worst_p(cases.map(|(entry, cos)| {
                let model = Askew { model: entry.make(&bsdf::Setting::default()), view };
                let place = format!("{}, cos θ = {cos}", entry.name);
                (spread_density(&model, way(f64::acos(cos), 0.6), DRAWS, &place), place)
            }))
        },
        |_, wo| wo,
    )
    .slip("drawn below the surface for every view", |_, wo| -wo);

/// The smallest of independent p-values as one of a family (Šidák).
fn worst_p(cases: impl Iterator<Item = (f64, String)>) -> Measured {
    let found: Vec<(f64, String)> = cases.collect();
    let count = found.len();
    let worst = found.into_iter().min_by(|one, other| one.0.total_cmp(&other.0));
    let (p, at) = worst.unwrap_or((f64::NAN, "no case".into()));
    Measured::new(yardstick::statistics::family(p, count), at, count)
}

const WEIGHTS: Check<fn(f64) -> f64> = check("weights", "no weight exceeds what is proven of its model")
    .against("the model's own bound, against the largest of 4000 draws a view, from α = 10⁻⁴ to 1 and to grazing")
    .within(1e-9, "1", "the bound holds exactly; a few roundings")
    .of(
        |_: &mut Bench, factor: fn(f64) -> f64| {
            let views = [(1e-4, 0.9), (1e-4, 0.01), (0.1, 0.3), (1.0, 0.95), (1.0, 0.02)];
            let cases = zoo::<f64>().into_iter().flat_map(|entry| views.map(|(alpha, cos)| (entry, alpha, cos)));
            Measured::worst(cases.filter_map(|(entry, alpha, cos)| {
                let model = entry.make(&bsdf::Setting { alpha: [alpha; 2], ..bsdf::Setting::default() });
                let bound = model.character().largest_weight;
                let place = format!("{}, α = {alpha}, cos θ = {cos}", entry.name);
                let largest = drawn(model.as_ref(), way(f64::acos(cos), 0.6), 4000, &place).largest;
                bound.is_finite().then(|| (excess(largest * factor(cos) / bound - 1.0), place))
            }))
        },
        |_| 1.0,
    )
    .slip("the cosine of the view divided out once too often", |cos| 1.0 / cos);

/// The integrand: light from a sky that is brighter to one side, on rough metal.
fn arriving(surface: &dyn Bsdf<f64>, wi: Vector<f64>, wo: Vector<f64>) -> f64 {
    surface.eval(wi, wo)[0] * wi.z.max(0.0) * sky(wi)
}

fn sky(wi: Vector<f64>) -> f64 {
    1.0 + 0.5 * wi.x
}

/// α and view of the race.
const RACED: (f64, f64) = (0.3, 0.8);

fn raced() -> (Box<dyn Bsdf<f64>>, Vector<f64>) {
    let of = bsdf::Setting { alpha: [RACED.0; 2], ..bsdf::Setting::default() };
    (model("rough-conductor", &of), way(RACED.1, 0.0))
}

/// What arrives by the most even of plans, of 65 536 directions.
fn reference() -> f64 {
    let (surface, wo) = raced();
    let points = Points::Sobol.draw(1 << 16, &mut stream(9, "brdf/sampling/reference"));
    let one = |[u, v]: [f64; 2]| {
        let drawn = surface.sample(wo, [u, v, 0.5]);
        drawn.weight[0] * sky(drawn.wi)
    };
    points.iter().map(|at| one(*at)).sum::<f64>() / points.len() as f64
}

/// A direction from two numbers, and its share of the sum.
type Strategy = fn(&dyn Bsdf<f64>, Vector<f64>, [f64; 2]) -> f64;

fn estimated(bench: &mut Bench, work: u64, strategy: Strategy) -> Heat {
    let seed = uniform(&mut bench.stream, 0.0, 1.0).to_bits();
    let (surface, wo) = raced();
    let exact = reference();
    Heat {
        run: Box::new(move || {
            let mut dice: Stream = stream(seed, "brdf/sampling/strategies");
            let mut throw = || [(); 2].map(|()| uniform(&mut dice, 0.0, 1.0));
            vec![(0..work).map(|_| strategy(surface.as_ref(), wo, throw())).sum::<f64>() / work as f64]
        }),
        error: Box::new(move |found| (found[0] / exact - 1.0).abs()),
    }
}

const WORKS: &[u64] = &[64, 256, 1024, 4096];

const STRATEGIES: Race = race(
    "strategies",
    "at α = 0.3 directions drawn by visible facets scatter least; all are right on average, and all fall as 1/√N",
)
.work("directions")
.error(
    "relative error of the radiance",
    "rms over 32 seeds of the relative error, against 65 536 of Sobol's points by visible facets",
)
.lanes(&[
    lane("uniform", "evenly over the hemisphere", WORKS, |bench, work| {
        estimated(bench, work, |surface, wo, at| {
            let wi = Vector::of(Domain::Hemisphere.at(at));
            TAU * arriving(surface, wi, wo)
        })
    })
    .repeated(32)
    .order(0.5, 0.15),
    lane("cosine", "as the cosine has it", WORKS, |bench, work| {
        estimated(bench, work, |surface, wo, at| {
            let wi = Vector::of(Domain::Cosine.at(at));
            PI * arriving(surface, wi, wo) / wi.z
        })
    })
    .repeated(32)
    .order(0.5, 0.15),
    lane("normals", "by all facets", WORKS, |bench, work| {
        estimated(bench, work, |surface, wo, [u, v]| {
            // GGX: tan² θ = α² u/(1 − u), and the half vector's Jacobian.
            let slope = RACED.0 * (u / (1.0 - u)).sqrt();
            let (s, c) = (TAU * v).sin_cos();
            let m = Vector::new(slope * c, slope * s, 1.0).normalised();
            let facing = wo.dot(m);
            let wi = m.scaled(2.0 * facing) - wo;
            if facing <= 0.0 || wi.z <= 0.0 {
                return 0.0;
            }
            let q = slope * slope / (RACED.0 * RACED.0) + 1.0;
            let density = m.z.powi(-3) / (PI * RACED.0 * RACED.0 * q * q) / (4.0 * facing);
            arriving(surface, wi, wo) / density
        })
    })
    .repeated(32)
    .order(0.5, 0.15),
    lane("visible", "by visible facets", WORKS, |bench, work| {
        estimated(bench, work, |surface, wo, [u, v]| {
            let drawn = surface.sample(wo, [u, v, 0.5]);
            drawn.weight[0] * sky(drawn.wi)
        })
    })
    .repeated(32)
    .order(0.5, 0.15),
]);

const WIDTHS: Race = race(
    "widths",
    "one formula in three widths finds the same; eight numbers at a time cost about as much as one",
)
.work("samples, each with its weight, density and value")
.error(
    "relative error of the share returned",
    "relative error of the mean weight of rough gold (green) by Sobol's points, against 64 × 64 nodes over the slopes",
)
.lanes(&[
    lane("f64", "f64", DRAWN, in_width::<f64>).within(WIDE.0, WIDE.1),
    lane("f32", "f32", DRAWN, in_width::<f32>).within(WIDE.0, WIDE.1),
    lane("lanes", "eight f32", DRAWN, in_width::<F32x8>).within(WIDE.0, WIDE.1),
]);

const DRAWN: &[u64] = &[4096, 16384, 65536];
/// Their common bound.
const WIDE: (f64, &str) =
    (3e-3, "no worse than chance: weights that scatter by 0.2, 0.2/√4096; rounding of f32 sums adds 10⁻⁴ at most");

/// Rough gold sampled in one width of number.
fn in_width<N: Number>(bench: &mut Bench, work: u64) -> Heat {
    let indices = super::models::metal("gold");
    let gold = Conductor { n: indices.map(|index| N::of(index.re)), k: indices.map(|index| N::of(index.im)) };
    let facets = Ggx::<N>::new([N::of(RACED.0); 2]);
    let surface = Guarded(RoughConductor { facets, joint: Joint::Correlated, metal: gold });
    let points = Points::Sobol.draw(work as usize, &mut bench.stream);
    let lanes = |axis: usize| -> Vec<N> {
        // In f32 the last of them would round to 1.
        let at = |k: usize| points[k][axis].min(1.0 - 1e-7);
        (0..points.len() / N::LANES).map(|k| N::from_lanes(|lane| at(k * N::LANES + lane))).collect()
    };
    let (along, around, wo) = (lanes(0), lanes(1), Vector::<N>::of(way(RACED.1, 0.0).lane(0)));
    let exact = {
        let gold = Conductor { n: indices.map(|index| index.re), k: indices.map(|index| index.im) };
        Rule::new(&Ggx::<f64>::new([RACED.0; 2]), 64, 64).albedo(RACED.1.cos(), |cos| gold.reflectance(cos)[1])
    };
    Heat {
        run: Box::new(move || {
            let sum = |values: N| (0..N::LANES).map(|lane| values.lane(lane)).sum::<f64>();
            let (weights, values) = vectorised(
                #[inline(always)]
                || {
                    let mut sums = (N::of(0.0), N::of(0.0));
                    for (u, v) in along.iter().zip(&around) {
                        let drawn = surface.sample(wo, [*u, *v, N::of(0.5)]);
                        let value = drawn.weight[1] * drawn.pdf / drawn.wi.z.abs();
                        sums = (sums.0 + drawn.weight[1], sums.1 + value + drawn.pdf);
                    }
                    sums
                },
            );
            vec![sum(weights) / work as f64, sum(values)]
        }),
        error: Box::new(move |found| (found[0] / exact - 1.0).abs()),
    }
}

/// A surface, the view, and where the light that it draws comes from.
struct Directions {
    surface: Box<dyn Bsdf<f64>>,
    wo: Vector<f64>,
    found: Vec<Vector<f64>>,
}

/// Directions of the setting's model, and the view.
fn directions(setting: &Setting, count: usize) -> Directions {
    let (surface, wo) = (chosen(setting), way(setting.number("theta").min(1.55), PI));
    let mut dice = stream(0, "brdf/sampling/points");
    let mut throw = || [(); 3].map(|()| uniform(&mut dice, 0.0, 1.0));
    let found =
        (0..count).map(|_| surface.sample(wo, throw())).filter(|drawn| drawn.weight[0] > 0.0).map(|drawn| drawn.wi);
    let found = found.collect();
    Directions { surface, wo, found }
}

fn points(setting: &Setting) -> Plot {
    let Directions { surface, wo, found } = directions(setting, 1500);
    let rim = || {
        Part::curve((0..=120).map(|at| TAU * f64::from(at) / 120.0).map(|t| [t.cos(), t.sin()]).collect())
            .hue(Hue::Reference)
    };
    let seen = found.iter().filter(|wi| wi.z > 0.0).map(|wi| Part::point([wi.x, wi.y]).hue(Hue::Ours));
    let drawn = Diagram::new("drawn", [-1.1; 2], [1.1; 2])
        .with(rim())
        .with_all(seen)
        .with(Part::point([wo.x, wo.y]).hue(Hue::P).label("ω_o"));
    const CELLS: usize = 120;
    let place = |at: usize| (at as f64 + 0.5) / CELLS as f64 * 2.0 - 1.0;
    let density = |at: usize| {
        let (x, y) = (place(at % CELLS), place(at / CELLS));
        let z2 = 1.0 - x * x - y * y;
        // Over the disc: dω = dA/cos θ.
        if z2 <= 2.5e-3 { 0.0 } else { surface.pdf(Vector::new(x, y, z2.sqrt()), wo) / z2.sqrt() }
    };
    let values: Vec<f64> = (0..CELLS * CELLS).map(density).collect();
    let mut sorted = values.clone();
    sorted.sort_by(f64::total_cmp);
    // The brightest thousandth may be white.
    let most = sorted[CELLS * CELLS - CELLS * CELLS / 1000 - 1].max(1e-6);
    let map = Map {
        title: "density over the disc".into(),
        x: Axis::linear("ω_i along x", "").range(-1.0, 1.0).tick(0.5),
        y: Axis::linear("ω_i along y", "").range(-1.0, 1.0).tick(0.5),
        colour: Axis::linear("p/cos θ_i, the brightest thousandth cut", "1/sr").range(0.0, most),
        ramp: Ramp::Sequential,
        columns: CELLS,
        values: values.into_iter().map(|value| value.min(most)).collect(),
        marks: Vec::new(),
    };
    Plot::grid(format!("Directions of {}, seen from above", setting.word("model")), 2, vec![drawn.into(), map.into()])
}

/// How even the draws are in the facets' own numbers.
fn square(setting: &Setting) -> Plot {
    use light::bsdf::microfacet::Beckmann;
    let of = made_from(setting);
    let wo = way(setting.number("theta").min(1.55), 0.3);
    fn placed<D: Distribution<f64>>(alpha: [f64; 2], wo: Vector<f64>) -> Vec<[f64; 2]> {
        let (facets, mut dice) = (D::new(alpha), stream(0, "brdf/sampling/square"));
        let mut throw = || [(); 2].map(|()| uniform(&mut dice, 0.0, 1.0));
        (0..1500)
            .map(|_| facets.visible(wo, throw()))
            .map(|m| facets.place(wo, m))
            .map(|[u, v]| [u, v.rem_euclid(1.0)])
            .collect()
    }
    let places = match of.slopes {
        Slopes::Ggx => placed::<Ggx<f64>>(of.alpha, wo),
        Slopes::Beckmann => placed::<Beckmann<f64>>(of.alpha, wo),
    };
    let frame = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]].to_vec();
    let diagram = Diagram::new("", [-0.1; 2], [1.1; 2])
        .with(Part::curve(frame).hue(Hue::Reference))
        .with_all(places.into_iter().map(|at| Part::point(at).hue(Hue::Ours)));
    Plot::of(
        format!(
            "Facets seen at {:.0}°, α = {}, in the numbers (u_1, u_2)",
            setting.number("theta").to_degrees(),
            of.alpha[0]
        ),
        diagram,
    )
}

/// The mean of what is drawn and its scatter, for other steps.
pub(super) fn energy(surface: &dyn Bsdf<f64>, wo: Vector<f64>, draws: u64, address: &str) -> Moments {
    drawn(surface, wo, draws, address).energy
}
