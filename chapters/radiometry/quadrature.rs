//! E32 where there is no closed form: sums over the sky, and what each way to draw directions costs.

use crate::diagram::{Diagram, Part};
use crate::figure::{Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Heat, Judge, Lane, Measured, Quantity, Race, Step, check, choice, exhibit, figure,
    lane, question, race, step,
};
use light::radiometry::rectangle::corner;
use std::f64::consts::{PI, TAU};
use yardstick::directions::{Direction, Domain, Points, Rule, integral, product, sampled};
use yardstick::quadrature::gauss_legendre;
use yardstick::random::{Stream, stream};
use yardstick::statistics::{Moments, t_test};

/// How many points are shown.
const SHOWN: Parameter =
    Parameter::new("points", "N", "how many points are drawn", Kind::Count { min: 1, max: 4096 }).default("256");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "quadrature",
    &[SHOWN],
    &[figure(
        "points",
        "The same number of directions over a hemisphere from above, as the cosine draws them: by chance, one in each cell, \
         and Sobol's scrambled points.",
        points,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Sums over the sky",
    "Points that avoid each other, drawn where the sum has its weight, buy digits for less.",
)
.rows(&["E32"])
.questions(&[question(
    "hundredfold",
    "A sum over directions drawn by chance is wrong by a per cent. How many times more directions for a tenth of that?",
    Answer::Choice {
        options: &[
            choice("ten times", "So it would be if the error fell as 1/N; by chance it falls as 1/√N."),
            choice("a hundred times", ""),
            choice("a thousand times", "That would be an error that falls as the cube root of N."),
        ],
        right: |_| {
            let [few, many] = [1 << 8, 1 << 12].map(|n| scatter(Points::Random, n));
            let order = (few / many).log(16.0);
            (1.0 / order).round().clamp(1.0, 3.0) as usize - 1
        },
        slip: |_| 0,
    },
    "The error falls as 1/√N, whatever the function.",
)])
.readout(|setting| {
    let n = setting.number("points") as usize;
    let quantity = |key, symbol, says, points| Quantity { key, symbol, says, value: scatter(points, n), unit: "1" };
    vec![
        quantity("random", "σ_1", "scatter of the smooth sky's sum over it, by chance", Points::Random),
        quantity("stratified", "σ_2", "one in each cell", Points::Stratified),
        quantity("sobol", "σ_3", "Sobol's, scrambled", Points::Sobol),
    ]
})
.checks(&[&UNBIASED, &EXACT])
.races(&[
    SUMS.named("smooth", "a smooth sky: points that avoid each other gain an order, and scrambled ones more").lanes(&[
        chance(|bench, work| heat(bench, Points::Random, work, SMOOTH)),
        stratified(|bench, work| heat(bench, Points::Stratified, work, SMOOTH)).order(1.0, 0.15),
        sobol(|bench, work| heat(bench, Points::Sobol, work, SMOOTH)).order(1.4, 0.2),
    ]),
    SUMS.named("kink", "a sky with a bend in it").lanes(&[
        chance(|bench, work| heat(bench, Points::Random, work, KINK)),
        stratified(|bench, work| heat(bench, Points::Stratified, work, KINK)).order(1.0, 0.15),
        sobol(|bench, work| heat(bench, Points::Sobol, work, KINK)).order(1.25, 0.2),
    ]),
    SUMS.named("step", "a sky with an edge: what planning gains is a quarter of an order").lanes(&[
        chance(|bench, work| heat(bench, Points::Random, work, EDGE)),
        stratified(|bench, work| heat(bench, Points::Stratified, work, EDGE)).order(0.75, 0.1),
        sobol(|bench, work| heat(bench, Points::Sobol, work, EDGE)).order(0.75, 0.12),
    ]),
    SUMS.named("near", "a glare low in the sky").lanes(&[
        chance(|bench, work| heat(bench, Points::Random, work, GLARE)),
        stratified(|bench, work| heat(bench, Points::Stratified, work, GLARE)).order(0.85, 0.2),
        sobol(|bench, work| heat(bench, Points::Sobol, work, GLARE)).order(1.1, 0.25),
    ]),
    LAMP,
]);

/// A sky by its direction, and what arrives from it.
#[derive(Clone, Copy)]
struct Sky {
    of: fn(Direction) -> f64,
    exact: fn() -> f64,
}

/// e^x; over the disc under the hemisphere 2π I₁(1).
const SMOOTH: Sky = Sky { of: |way| way[0].exp(), exact: || TAU * 0.565_159_103_992_485 };
/// |x|
const KINK: Sky = Sky { of: |way| way[0].abs(), exact: || 4.0 / 3.0 };
/// 1 where x > 0.3
const EDGE: Sky = Sky { of: |way| f64::from(u8::from(way[0] > 0.3)), exact: || 0.3_f64.acos() - 0.3 * 0.91_f64.sqrt() };
/// 1/(1.01 − x)
const GLARE: Sky = Sky { of: |way| 1.0 / (1.01 - way[0]), exact: || TAU * (1.01 - 0.0201_f64.sqrt()) };

/// Runs that make one error.
const RUNS: u32 = 32;
const WORKS: &[u64] = &[64, 256, 1024, 4096, 16384];

/// A sum over the sky, whatever the sky.
const SUMS: Race = race("", "").work("directions, drawn as the cosine has it").error(
    "relative error of E",
    "rms over 32 seeds of the relative error, against the integral over the disc under the sky",
);

const fn chance(prepare: fn(&mut Bench, u64) -> Heat) -> Lane {
    lane("monte_carlo", "by chance", WORKS, prepare).repeated(RUNS).order(0.5, 0.1)
}

const fn stratified(prepare: fn(&mut Bench, u64) -> Heat) -> crate::vocabulary::Entrant {
    lane("stratified", "one in each cell", WORKS, prepare).repeated(RUNS)
}

const fn sobol(prepare: fn(&mut Bench, u64) -> Heat) -> crate::vocabulary::Entrant {
    lane("sobol", "Sobol, scrambled", WORKS, prepare).repeated(RUNS)
}

fn heat(bench: &mut Bench, points: Points, work: u64, sky: Sky) -> Heat {
    let rule = sampled(Domain::Cosine, &points.draw(work as usize, &mut bench.stream));
    summed(rule, sky.of, (sky.exact)())
}

fn summed(rule: Rule, of: impl Fn(Direction) -> f64 + Copy + 'static, exact: f64) -> Heat {
    Heat {
        run: Box::new(move || vec![integral(&rule, of)]),
        error: Box::new(move |found| (found[0] / exact - 1.0).abs()),
    }
}

/// The scatter of the smooth sky's sum over 32 seeds, over the sum [1].
fn scatter(points: Points, n: usize) -> f64 {
    let found: Moments = (0..u64::from(RUNS))
        .map(|seed| {
            let rule = sampled(Domain::Cosine, &points.draw(n, &mut stream(seed, "radiometry/quadrature/scatter")));
            integral(&rule, SMOOTH.of) / (SMOOTH.exact)()
        })
        .collect();
    found.variance().sqrt()
}

const UNBIASED: Check<fn(Direction) -> f64> = check(
    "unbiased",
    "directions drawn evenly over the hemisphere, each with its cosine, have the mean that those drawn by it have",
)
.against("2π I₁(1), the closed form of a sky e^x")
.significant(1e-3)
.of(evenly, |way| TAU * way[2])
.slip("the weight π of directions that the cosine draws", |_| PI);

fn evenly(bench: &mut Bench, weight: fn(Direction) -> f64) -> Measured {
    let points = Points::Random.draw(100_000, &mut bench.stream);
    let found: Moments = points
        .into_iter()
        .map(|point| Domain::Hemisphere.at(point))
        .map(|way| weight(way) * (SMOOTH.of)(way))
        .collect();
    let test = t_test(&found, (SMOOTH.exact)());
    let at = format!("mean {:.5} ± {:.5}", found.mean(), found.standard_error());
    Measured::new(test.p, at, points_of(&found))
}

fn points_of(moments: &Moments) -> usize {
    moments.count() as usize
}

const EXACT: Check<fn(Direction) -> f64> =
    check("products", "Gauss's rule over the hemisphere finds what arrives from any smooth sky")
        .against("2π I₁(1), the closed form of a sky e^x")
        .within(1e-13, "1", "exact to degree 22; of e^x 1/23! is beyond it; 288 terms")
        .of(by_product, |way| way[2])
        .slip("cos θ forgotten", |_| 1.0);

fn by_product(_: &mut Bench, weight: fn(Direction) -> f64) -> Measured {
    let found = integral(&product(Domain::Hemisphere, 12), |way| weight(way) * (SMOOTH.of)(way));
    Measured::new((found / (SMOOTH.exact)() - 1.0).abs(), "288 directions", 1)
}

/// The lamp of the last race: half as wide as it is far, its corner over the receiver.
const LAMP_SIDES: [f64; 3] = [0.5, 0.5, 1.0];

const LAMP: Race =
    race("lamp", "a small lamp: draw from it, not from the sky; and where there is a closed form, use that")
        .work("directions, points of the lamp, or evaluations")
        .error(
            "relative error of E",
            "rms over 32 seeds of the relative error, against Gauss's rule of 40 × 40 over the lamp",
        )
        .lanes(&[
            lane("sky", "the sky, evenly", WORKS, |bench, work| of_sky(bench, Domain::Hemisphere, work))
                .repeated(RUNS)
                .order(0.5, 0.12),
            lane("cosine", "the sky, as the cosine has it", WORKS, |bench, work| of_sky(bench, Domain::Cosine, work))
                .repeated(RUNS)
                .order(0.5, 0.12),
            lane("lamp", "the lamp, by chance", &[16, 64, 256, 1024, 4096], |bench, work| {
                of_lamp(bench, Points::Random, work)
            })
            .repeated(RUNS)
            .order(0.5, 0.1),
            lane("cells", "the lamp, one in each cell", &[16, 64, 256, 1024, 4096], |bench, work| {
                of_lamp(bench, Points::Stratified, work)
            })
            .repeated(RUNS)
            .order(1.0, 0.15),
            lane("sobol", "the lamp, Sobol's points", &[16, 64, 256, 1024, 4096], |bench, work| {
                of_lamp(bench, Points::Sobol, work)
            })
            .repeated(RUNS)
            .order(1.5, 0.2),
            lane("gauss", "the lamp, Gauss's rule", &[4, 9, 16, 36, 64], |_, work| {
                let nodes = gauss_legendre((work as f64).sqrt().round() as usize);
                let grid: Vec<([f64; 2], f64)> =
                    nodes.iter().flat_map(|(u, a)| nodes.iter().map(move |(v, b)| ([*u, *v], a * b))).collect();
                Heat {
                    run: Box::new(move || vec![grid.iter().map(|(at, weight)| weight * sent(*at)).sum()]),
                    error: wrong(),
                }
            })
            .converges(1e-9, "the pole is 4 half-sides from the middle: (4 + √17)⁻¹⁶ of 8 points a side is 10⁻¹⁵"),
            lane("closed", "the closed form", &[1], |_, _| Heat {
                run: Box::new(|| {
                    let [a, b, h] = std::hint::black_box(LAMP_SIDES);
                    vec![corner(a, b, h).map_or(f64::NAN, |of| of.parallel)]
                }),
                error: wrong(),
            })
            .within(1e-14, "a dozen roundings, and those of the reference"),
        ]);

/// What a point of the lamp sends, times the lamp's area.
fn sent([u, v]: [f64; 2]) -> f64 {
    let [a, b, h] = LAMP_SIDES;
    let square = (u * a).powi(2) + (v * b).powi(2) + h * h;
    a * b * (h / square).powi(2)
}

/// The relative error, against a rule that has converged.
fn wrong() -> Judge {
    let nodes = gauss_legendre(40);
    let exact: f64 = nodes.iter().map(|(u, a)| a * nodes.iter().map(|(v, b)| b * sent([*u, *v])).sum::<f64>()).sum();
    Box::new(move |found| (found[0] / exact - 1.0).abs())
}

fn of_lamp(bench: &mut Bench, points: Points, work: u64) -> Heat {
    let points = points.draw(work as usize, &mut bench.stream);
    Heat {
        run: Box::new(move || vec![points.iter().map(|at| sent(*at)).sum::<f64>() / points.len() as f64]),
        error: wrong(),
    }
}

fn of_sky(bench: &mut Bench, domain: Domain, work: u64) -> Heat {
    let rule = sampled(domain, &Points::Random.draw(work as usize, &mut bench.stream));
    let [a, b, h] = LAMP_SIDES;
    let hit = move |way: Direction| {
        let (x, y) = (way[0] / way[2] * h, way[1] / way[2] * h);
        let is_hit = (0.0..a).contains(&x) && (0.0..b).contains(&y);
        let weight = if domain == Domain::Cosine { 1.0 } else { way[2] };
        if is_hit { weight } else { 0.0 }
    };
    Heat { run: Box::new(move || vec![integral(&rule, hit)]), error: wrong() }
}

fn points(setting: &Setting) -> Plot {
    let n = setting.number("points") as usize;
    let kinds = [
        (Points::Random, "by chance"),
        (Points::Stratified, "one in each cell"),
        (Points::Sobol, "Sobol's, scrambled"),
    ];
    let panel = |(kind, name): (Points, &str)| {
        let mut dice: Stream = stream(0, "radiometry/quadrature/points");
        let seen = kind.draw(n, &mut dice).into_iter().map(|at| Domain::Cosine.at(at));
        let rim = (0..=120).map(|at| TAU * f64::from(at) / 120.0).map(|t| [t.cos(), t.sin()]).collect();
        Diagram::new(name, [-1.05; 2], [1.05; 2])
            .with(Part::curve(rim).hue(Hue::Reference))
            .with_all(seen.map(|way| Part::point([way[0], way[1]]).hue(Hue::Ours)))
            .into()
    };
    Plot::grid(format!("{n} directions over a hemisphere, from above"), 3, kinds.map(panel).into())
}
