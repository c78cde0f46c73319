//! C20: rooms in patches, solved, and held against paths.

use super::cornell::{self, CORNELL};
use super::rooms::{UNEQUAL, cube, extrapolated, means, net, network, scene, seen, traced, unequal};
use super::solvers::{CUTS, LINKS, SOLVERS};
use super::symbols::{E_1, F_12, L_1, L_2, RHO};
use crate::figure::{Axis, Chart, Hue, Mark, Panel, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::path_tracing::one_ray::judged;
use crate::path_tracing::ways::smallest;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Step, check, choice, exhibit, figure, largest, question,
    statement, step,
};
use equation::Equation;
use light::radiosity::{Light, Network, Room, limit, solve};
use light::transport::Method;
use yardstick::order;

const CUT: Parameter = Parameter::new("n", "n", "patches along an edge", Kind::Count { min: 1, max: 12 }).default("8");
const WHITE: Parameter =
    Parameter::new("rho", "ρ", "share of the light that the cube's walls return", Kind::number(0.0, 0.999, "1"))
        .default("0.7");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "radiosity",
    &[CUT, WHITE],
    &[
        figure(
            "unfolded",
            "A cube unfolded, its ceiling shines: by the lamp alone, by one bounce more, and all of it.",
            unfolded,
        ),
        figure(
            "cornell",
            "The Cornell box by patches, by paths, and their difference: patches miss the edges of shadows and the shades within \
             themselves; their means are right.",
            cornell::pictures,
        ),
        figure(
            "order",
            "How the means of walls approach their limit as patches are made smaller, and with two cuts put together.",
            orders,
        ),
        figure("digits", "Error of the solvers after as many rows of the network were summed.", digits),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "A room in patches",
    "One radiance a patch and the integral becomes a sum: as many linear equations as patches, solved in several ways.",
)
.rows(&["C20"])
.statements(&[statement("patch", "what leaves patch 1, which sees patch 2 as F₁₂ (and so on, over all patches)", || {
    Equation::new(L_1, E_1 + RHO * F_12 * L_2)
})])
.questions(&[question(
    "half",
    "Patches are cut in half each way, so that there are four times as many. How does the error of a wall's mean change?",
    Answer::Choice {
        options: &[
            choice("it is halved", "So it is at a place of the wall, for a constant misses its slope. In the mean, slopes cancel."),
            choice("it becomes a quarter", ""),
            choice("it becomes a sixteenth", "That would be order four: bent patches, not constant ones."),
        ],
        right: |_| {
            let [a, b, c] = [2, 4, 8].map(|n| means(&unequal(), n)[2]);
            (limit::observed_order([a, b, c]).round().clamp(1.0, 3.0) as usize) - 1
        },
        slip: |_| 0,
    },
    "Order h², and the work of elimination grows as h⁻⁶: extrapolating is cheaper than cutting.",
)])
.readout(|setting| {
    let room = cube(1.0 - setting.number("rho"));
    let (patches, network, light) = network(&room, setting.number("n") as usize);
    let found = solve::conjugate(&network, &light, 24);
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("patches", "N", "patches", network.len() as f64),
        quantity("floor", "L/L_e", "mean of the floor, of the ceiling that shines", patches.mean(2, &found)),
        quantity("first", "L_1/L_e", "of that by one bounce", light.reflected(0) * network.factor(patches.of_face(2), patches.of_face(3))),
    ]
})
.checks(&[&EVEN, &ORDER, &TRACED, &THREE, &CORNELL])
.races(&[SOLVERS, CUTS, LINKS]);

/// A way to solve a network.
type Solver = fn(&Network, &Light) -> Vec<f64>;

const EVEN: Check<Solver> = check(
    "even",
    "in a room that shines and reflects alike everywhere every patch has L_e/(1 − ρ)",
)
.against("L_e/(1 − ρ), against conjugate gradients over 96 patches of boxes of three forms")
.within(
    1e-9,
    "1",
    "form factors' closure, 10⁻¹³, times the condition number 1/(1 − ρ) of up to a thousand, and the steps' rounding",
)
.of(
    |_: &mut Bench, solver: Solver| {
        let cases = [[1.0; 3], [2.0, 0.3, 1.0], [0.1, 0.1, 3.0]].into_iter().flat_map(|size| {
            [0.5, 0.05, 1e-3].map(|absorbed| {
                let (_, network, light) = network(&Room::cuboid(size, [(absorbed, 1.0); 6]), 4);
                let off = solver(&network, &light).into_iter().map(|x| (x * absorbed - 1.0).abs());
                (largest(off), format!("{size:?}, 1 − ρ = {absorbed}"))
            })
        });
        Measured::worst(cases)
    },
    |network, light| solve::conjugate(network, light, 24),
)
.slip("the first ten bounces alone", |network, light| solve::series(network, light, 11));

/// What a wall's mean is by n × n patches a wall; or by what it is to be multiplied.
type Mean = fn(usize) -> f64;

const ORDER: Check<Mean> = check("mean", "the mean of a wall by constant patches is of order h²")
    .against("cuts finer towards the edges, 4 of them extrapolated; 3 to 8 patches an edge")
    .order(
        2.0,
        0.2,
        "the error of a Galerkin mean is the square of that of the light, which is of order h; the next term is about h³, and an eighth of it at these",
    )
    .of(
        |_: &mut Bench, mean: Mean| {
            let known = extrapolated(&unequal(), 10)[2];
            let points: Vec<(f64, f64)> =
                [3, 4, 6, 8].map(|n| (1.0 / n as f64, (mean(n) / known - 1.0).abs())).into();
            Measured::new(order::slope(&points).unwrap_or(f64::NAN), "h from 1/3 to 1/8 of an edge", points.len())
        },
        |n| means(&unequal(), n)[2],
    )
    .slip("the patch in the middle for the mean", |n| {
        let (patches, network, light) = network(&unequal(), n);
        solve::conjugate(&network, &light, 24)[patches.at(2, [0.4, 0.6])]
    });

const TRACED: Check<Solver> = check("traced", "walls of an unequal box are as bright by patches as by paths")
    .against(
        "the means of all six walls, extrapolated from three cuts, against 32 independent pictures of each (t-tests)",
    )
    .significant(1e-3)
    .of(
        |_: &mut Bench, solver: Solver| {
            let room = unequal();
            let (known, scene) = (patched(&room, solver), scene(&room));
            let tests = room.faces.iter().zip(known).enumerate().map(|(at, (face, known))| {
                let of = judged(&traced(&scene, &face.patch, 0.1, 32, 32), known);
                Measured { at: format!("wall {at}: {}", of.at), ..of }
            });
            smallest(tests.collect())
        },
        |network, light| solve::conjugate(network, light, 24),
    )
    .slip("the first five bounces taken for all", |network, light| solve::series(network, light, 6));

const THREE: Check<Solver> = check(
    "three",
    "six walls of unequal albedo and light are as bright by patches as by records of a few places, and so as by paths",
)
.against(
    "the means of all walls, extrapolated, against 16 independent pictures of each by irradiance caching, of 512 samples a pixel (t-tests): \
     their noise is some per cent, and what is interpolated is off by less",
)
.significant(1e-3)
.of(
    |_: &mut Bench, solver: Solver| {
        let room = unequal();
        let (known, scene) = (patched(&room, solver), scene(&room));
        let tests = room.faces.iter().zip(known).enumerate().map(|(at, (face, known))| {
            let of = judged(&seen(&scene, &face.patch, 0.1, (Method::Cached, 16, 256)), known);
            Measured { at: format!("wall {at}: {}", of.at), ..of }
        });
        smallest(tests.collect())
    },
    |network, light| solve::conjugate(network, light, 24),
)
.slip("light that was reflected once taken for all", |network, light| solve::series(network, light, 2));

/// The means of all faces by a solver, of three graded cuts put together.
fn patched(room: &Room, solver: Solver) -> Vec<f64> {
    let cuts = [4, 6, 8].map(|n| {
        let patches = room.cut_graded(n);
        let found = solver(&Network::of(&patches), &Light::of(&patches, 1));
        let means: Vec<f64> = (0..room.faces.len()).map(|face| patches.mean(face, &found)).collect();
        (1.0 / n as f64, means)
    });
    let of = |face: usize| limit::without(&cuts.each_ref().map(|(h, means)| (*h, means[face])), &[2.0, 4.0]);
    (0..room.faces.len()).map(of).collect()
}

fn unfolded(setting: &Setting) -> Plot {
    let room = cube(1.0 - setting.number("rho"));
    let (patches, network, light) = network(&room, setting.number("n") as usize);
    let all = solve::conjugate(&network, &light, 24);
    let panel = |title: &str, found: Vec<f64>| {
        let most =
            all.iter().zip(&light.emitted).filter(|(_, lamp)| **lamp == 0.0).map(|(x, _)| *x).fold(0.0, f64::max);
        Panel::from(net(&patches, 72, title.into(), move |at| [found[at] / most.max(1e-9); 3]))
    };
    let panels = vec![
        panel("once reflected", solve::series(&network, &light, 2)),
        panel("at most twice", solve::series(&network, &light, 3)),
        panel("all of it", all.clone()),
    ];
    Plot::grid(format!("A cube under a bright ceiling, ρ = {}", setting.number("rho")), 3, panels)
}

fn orders(_: &Setting) -> Plot {
    let room = unequal();
    let cuts = [1, 2, 3, 4, 6, 8, 12];
    let found: Vec<Vec<f64>> = cuts.iter().map(|n| means(&room, *n)).collect();
    let place = |n: usize| cuts.iter().position(|cut| *cut == n);
    let names = ["a wall across x", "the floor", "a wall across z"];
    let chart = Chart::new(
        "",
        Axis::log("patches along an edge n", "").range(0.9, 14.0),
        Axis::log("relative error of the mean", "").range(1e-6, 0.1),
    );
    let chart = [0, 2, 4].into_iter().zip(names).zip(0..).fold(chart, |chart, ((face, name), hue)| {
        let known = limit::richardson([found[4][face], found[6][face]], 2.0);
        let off = |value: f64| (value / known - 1.0).abs();
        let single = cuts.iter().zip(&found).take(6).map(|(n, means)| [*n as f64, off(means[face])]).collect();
        let double = cuts.iter().filter_map(|n| {
            let half = place(n / 2).filter(|_| n % 2 == 0 && *n < 12)?;
            let value = limit::richardson([found[half][face], found[place(*n)?][face]], 2.0);
            Some([*n as f64, off(value)])
        });
        let marks =
            |label: String, shape, points| Mark::Points { label, hue: Hue::Nth(hue), shape, joined: true, points };
        chart.with(marks(name.into(), Shape::Disc, single)).with(marks(
            format!("{name}, with n/2"),
            Shape::Ring,
            double.collect(),
        ))
    });
    let [x, y, z] = UNEQUAL;
    let slope = [1.0, 12.0].map(|n: f64| [n, 0.02 / (n * n)]);
    Plot::of(format!("Walls of a room of {x} m × {y} m × {z} m"), chart.dashed(Hue::Reference, "n^{−2}", slope.into()))
}

fn digits(setting: &Setting) -> Plot {
    let room = cube(1.0 - setting.number("rho"));
    let (_, network, light) = network(&room, 4);
    let exact = solve::direct(&network, &light);
    let most = exact.iter().copied().fold(0.0, f64::max);
    let off = |found: Vec<f64>| {
        found.iter().zip(&exact).map(|(one, other)| (one - other).abs() / most).fold(0.0, f64::max).max(1e-17)
    };
    let rows = network.len() as f64;
    let sweeps = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];
    let by =
        |of: &dyn Fn(u32) -> Vec<f64>| -> Vec<[f64; 2]> { sweeps.map(|k| [f64::from(k) * rows, off(of(k))]).into() };
    let shots = [1, 4, 16, 48, 96, 192, 384, 768, 1536, 3072, 6144];
    let marks =
        |label: &str, hue, shape, points| Mark::Points { label: label.into(), hue, shape, joined: true, points };
    let chart = Chart::new(
        "",
        Axis::log("rows summed", "").range(1.0, 1e4),
        Axis::log("largest error over the brightest patch", "").range(1e-16, 2.0),
    )
    .with(marks("bounce by bounce", Hue::Nth(0), Shape::Disc, by(&|k| solve::series(&network, &light, k + 1))))
    .with(marks("patch by patch", Hue::Nth(1), Shape::Square, by(&|k| solve::seidel(&network, &light, k))))
    .with(marks(
        "shot by shot",
        Hue::Nth(2),
        Shape::Triangle,
        shots.map(|k| [f64::from(k), off(solve::shooting(&network, &light, k).0)]).into(),
    ))
    .with(marks("conjugate gradients", Hue::Ours, Shape::Diamond, by(&|k| solve::conjugate(&network, &light, k))));
    Plot::of(format!("A cube of 96 patches, ρ = {}", setting.number("rho")), chart)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Picture;

    #[test]
    fn a_shade_is_a_picture() {
        let Panel::Picture(Picture { width, pixels, .. }) = &unfolded(&Setting::defaults(EXHIBIT.parameters)).panels[0]
        else {
            panic!("a picture");
        };
        assert_eq!(pixels.len(), width * width / 4 * 3);
    }
}
