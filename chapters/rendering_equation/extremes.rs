//! C19 and C20 where rooms are all but white.

use super::rooms::{cube, network};
use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Step, check, exhibit, figure, largest,
    question, step, stress,
};
use light::radiometry::form_factor::{parallel_rectangles, perpendicular_rectangles};
use light::radiosity::exact::Wall;
use light::radiosity::spectrum::{condition, modes};
use light::radiosity::{Light, Network, solve};
use yardstick::precise::{self, Real};

const WHITE: Parameter =
    Parameter::new("absorbed", "a", "share of the light that the walls absorb, 1 − ρ", Kind::number(1e-12, 0.99, "1"))
        .default("1e-4");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "extremes",
    &[WHITE],
    &[figure(
        "crawl",
        "What solvers still miss after as many rows: bounces and shots fade as the room does; conjugate gradients do not mind.",
        crawl,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "White rooms",
    "Where nearly nothing is absorbed, bounces go on for ever and 1 − ρ has no digits left: give what is absorbed, and subtract nothing.",
)
.rows(&["C19", "C20"])
.questions(&[question(
    "digits",
    "Walls return 1 − 10⁻⁹ of the light. f64 has 16 digits. How many are left, at best, of a radiance for which plain elimination solves the room's equations?",
    Answer::Number {
        unit: "1",
        tolerance: 0.15,
        right: |_| {
            let (_, network, light) = network(&cube(1e-9), 2);
            -f64::EPSILON.log10() - condition(&modes(&network, &light)).log10()
        },
        slips: &[
            Misled { value: |_| 16.0, reply: "The matrix is nearly singular: what was rounded off it is magnified by its condition number." },
            Misled { value: |_| 9.0, reply: "Nine are lost, not left." },
        ],
    },
    "The condition number is some 10⁹: sixteen less nine is seven. Elimination without differences keeps them all.",
)])
.readout(|setting| {
    let absorbed = setting.number("absorbed");
    let (_, network, light) = network(&cube(absorbed), 2);
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("condition", "κ", "condition number of the cube's equations", condition(&modes(&network, &light))),
        quantity("bright", "L/L_e", "mean radiance, the ceiling alone shining", mean(&solve::direct(&network, &light))),
        quantity("unsent", "u", "light that a hundred shots have not sent, over the lamp's", solve::shooting(&network, &light, 100).1),
    ]
})
.checks(&[&CRAWL, &CONJUGATE])
.stress(&[
    stress("white", "six walls that absorb down to 10⁻³⁰, solved at once", whites)
        .textbook("plain elimination of 1 − ρF, with ρ = 1 − a in f64")
        .against("elimination of the same six equations in 512 bits"),
    stress("sphere", "a sphere in four pieces that absorb down to 10⁻¹⁵, solved at once, against pen and paper", spheres)
        .textbook("plain elimination of 1 − ρF")
        .against("all that is sent over all that is absorbed, in 512 bits"),
    stress("slit", "two plates and the slits about them, a millionth of their side apart, solved at once", slits)
        .textbook("plain elimination, the slits' share as 1 − F")
        .against("the same two equations in 512 bits and more"),
]);

fn mean(radiances: &[f64]) -> f64 {
    radiances.iter().sum::<f64>() / radiances.len() as f64
}

/// What a share of light not yet sent after so many bounces is.
type Left = fn(f64, f64) -> f64;

const CRAWL: Check<Left> = check("round", "at an albedo of 0.9999 a round of shots, one for each patch, is worth two bounces: the fullest patch holds twice the mean")
    .against("ρ² a round for what is not sent yet, against shooting in a cube of 24 patches, from the 10th to the 100th round")
    .within(0.04, "1", "of its logarithm. Patches fill evenly from their last shot to their next, 0 to twice the mean; of 24 that is uneven by less than one in 24")
    .of(
        |_: &mut Bench, left: Left| {
            let absorbed = 1e-4;
            let (_, network, light) = network(&cube(absorbed), 2);
            let of = |rounds: u32| solve::shooting(&network, &light, 24 * rounds).1;
            let (early, late) = (of(10), of(100));
            Measured::new(((late / early).ln() / left(1.0 - absorbed, 90.0).ln() - 1.0).abs(), "24 patches", 1)
        },
        |rho, rounds| rho.powf(2.0 * rounds),
    )
    .slip("a round of shots taken for one bounce", |rho, rounds| rho.powf(rounds));

/// A way to solve a network in so many steps.
type Steps = fn(&Network, &Light, u32) -> Vec<f64>;

const CONJUGATE: Check<Steps> =
    check("conjugate", "conjugate gradients need as many steps in a white room as in a grey one")
        .against("elimination without differences, against 16 steps at a = 0.5, 10⁻⁴ and 10⁻⁶ in a cube of 54 patches")
        .within(1e-8, "1", "one eigenvalue near 1 costs one step; the rounding of 1 − S is magnified by 10⁶")
        .of(
            |_: &mut Bench, steps: Steps| {
                Measured::worst([0.5, 1e-4, 1e-6].map(|absorbed| {
                    let (_, network, light) = network(&cube(absorbed), 3);
                    let exact = solve::direct(&network, &light);
                    let found = steps(&network, &light, 16);
                    let off = largest(found.iter().zip(&exact).map(|(one, other)| one / other - 1.0));
                    (off, format!("a = {absorbed:e}"))
                }))
            },
            solve::conjugate as Steps,
        )
        .slip("as many sweeps of Gauss and Seidel", solve::seidel);

/// Six walls and what they see of each other, of a cube.
fn six(white: f64) -> (Network, Light) {
    let p = parallel_rectangles(1.0, 1.0, 1.0).unwrap_or(f64::NAN);
    let q = (1.0 - p) / 4.0;
    let both = (0..36).map(|at| match (at / 6, at % 6) {
        (i, j) if i == j => 0.0,
        (i, j) if i / 2 == j / 2 => p,
        _ => q,
    });
    let network = Network::new(vec![1.0; 6], &both.collect::<Vec<_>>(), true);
    let absorbed = [1.0, 0.5, 0.25, 2.0, 1.5, 0.125].map(|a| 0.4 * white * a);
    (network, Light { absorbed: absorbed.into(), emitted: vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.25] })
}

/// The first radiance of a network in arbitrary precision: what patches do not see of each other is lost, or of a closed room
/// nothing is.
fn precisely(network: &Network, light: &Light) -> Real {
    const BITS: usize = 512;
    let n = network.len();
    let real = |x: f64| precise::real_at(x, BITS);
    let mut rows: Vec<Vec<Real>> = (0..n)
        .map(|i| {
            let rho = real(1.0) - real(light.absorbed[i]);
            // What is sent on, as the sums of the network's own numbers say.
            let all = network.row(i).iter().fold(real(0.0), |sum, factor| sum + real(*factor));
            let own = real(light.absorbed[i]) + &rho * (real(network.lost[i]) + all);
            let entry = |j: usize| if i == j { own.clone() } else { -(&rho * real(network.row(i)[j])) };
            (0..n).map(entry).chain([real(light.emitted[i])]).collect()
        })
        .collect();
    for k in (0..n).rev() {
        let (upper, pivot) = rows.split_at_mut(k);
        for row in upper {
            let share = &row[k] / &pivot[0][k];
            for at in (0..=k).chain([n]) {
                row[at] = &row[at] - &share * &pivot[0][at];
            }
        }
    }
    &rows[0][n] / &rows[0][0]
}

/// The condition number of a network's equations: as far as f64 tells, whose 1 − λ has no digit left where walls absorb
/// less than a rounding; by what is absorbed there, which each bounce takes of the pattern that is nearly even.
fn kappa(network: &Network, light: &Light) -> f64 {
    let modes = modes(network, light);
    let area: f64 = network.areas.iter().sum();
    let least = light.absorbed.iter().zip(&network.areas).map(|(absorbed, area)| absorbed * area).sum::<f64>() / area;
    match modes.last() {
        Some(last) if least < 1e-12 => (1.0 - last.value) / least,
        _ => condition(&modes),
    }
}

/// A ball's inside in four pieces, nearly white, on paper and as a network.
fn spheres(_: &Setting) -> Vec<Extreme> {
    let shares = [0.125, 0.25, 0.5, 0.125];
    [1e-3, 1e-9, 1e-15]
        .map(|white: f64| {
            let walls = [1.0, 2.0, 0.5, 3.0].map(|a: f64| Wall { absorbed: white * a, emitted: a * a });
            let light = Light { absorbed: walls.map(|w| w.absorbed).into(), emitted: walls.map(|w| w.emitted).into() };
            let network = Network::sphere(&shares);
            let real = |x: f64| precise::real_at(x, 512);
            let sum = |of: fn(&Wall) -> f64| {
                shares.iter().zip(&walls).fold(real(0.0), |sum, (share, wall)| sum + real(*share) * real(of(wall)))
            };
            // The last piece: what it sends, and what it returns of all that is sent over all that is absorbed.
            let arriving = sum(|wall| wall.emitted) / sum(|wall| wall.absorbed);
            let reference = real(walls[3].emitted) + (real(1.0) - real(walls[3].absorbed)) * arriving;
            Extreme {
                input: format!("a about {white:e}, κ = {:.1e}", kappa(&network, &light)),
                quantity: "L_4",
                reference,
                textbook: solve::plain(&network, &light)[3],
                ours: solve::direct(&network, &light)[3],
                condition: 4.0,
                worst_of: 1,
            }
        })
        .into()
}

fn whites(_: &Setting) -> Vec<Extreme> {
    [1.0, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-30]
        .map(|white: f64| {
            let (network, light) = six(white);
            Extreme {
                input: format!("a about {white:e}, κ = {:.1e}", kappa(&network, &light)),
                quantity: "L_1",
                reference: precisely(&network, &light),
                textbook: solve::plain(&network, &light)[0],
                ours: solve::direct(&network, &light)[0],
                // Sums of positive terms, over what is absorbed and what is sent on.
                condition: 4.0,
                worst_of: 1,
            }
        })
        .into()
}

fn slits(_: &Setting) -> Vec<Extreme> {
    [1e-2, 1e-4, 1e-6, 1e-8]
        .into_iter()
        .flat_map(|gap: f64| [1e-3, 1e-9, 0.0].map(|absorbed| (gap, absorbed)))
        .map(|(gap, absorbed)| {
            let factor = parallel_rectangles(1.0, 1.0, gap).unwrap_or(f64::NAN);
            let leak = 4.0 * perpendicular_rectangles(1.0, gap, 1.0).unwrap_or(f64::NAN);
            let light = Light { absorbed: vec![absorbed; 2], emitted: vec![1.0, 0.0] };
            let open = Network::new(vec![1.0; 2], &[0.0, factor, factor, 0.0], false);
            let ours = open.clone().losing(vec![leak; 2]);
            // L_1 = 1/(1 − ρ²F²), with 1 − F known by itself.
            let bits = 1024;
            let [one, a] = [1.0, absorbed].map(|x| precise::real_at(x, bits));
            let exact = light::references::radiometry::parallel_rectangles(1.0, 1.0, gap).value;
            let on = (&one - &a) * exact;
            Extreme {
                input: format!("gap {gap:e}, a = {absorbed:e}"),
                quantity: "L_1",
                reference: &one / (&one - &on * &on),
                textbook: solve::plain(&open, &light)[0],
                ours: solve::direct(&ours, &light)[0],
                // As what is absorbed and what leaves through the slit.
                condition: 4.0,
                worst_of: 1,
            }
        })
        .collect()
}

fn crawl(setting: &Setting) -> Plot {
    let absorbed = setting.number("absorbed");
    let (_, network, light) = network(&cube(absorbed), 3);
    let exact = solve::direct(&network, &light);
    let rows = network.len() as f64;
    let off = |found: Vec<f64>| {
        let worst = largest(found.iter().zip(&exact).map(|(one, other)| one / other - 1.0));
        worst.max(1e-16)
    };
    let sweeps = [1, 2, 4, 8, 16, 64, 256, 1024, 4096, 16384, 65536];
    let marks =
        |label: &str, hue, shape, points| Mark::Points { label: label.into(), hue, shape, joined: true, points };
    let by = |of: &dyn Fn(u32) -> Vec<f64>, most: usize| -> Vec<[f64; 2]> {
        sweeps.iter().take(most).map(|k| [f64::from(*k) * rows, off(of(*k))]).collect()
    };
    let chart = Chart::new(
        "",
        Axis::log("rows summed", "").range(10.0, 1e7),
        Axis::log("largest relative error", "").range(1e-16, 3.0),
    )
    .with(marks("bounce by bounce", Hue::Nth(0), Shape::Disc, by(&|k| solve::series(&network, &light, k + 1), 11)))
    .with(marks("patch by patch", Hue::Nth(1), Shape::Square, by(&|k| solve::seidel(&network, &light, k), 11)))
    .with(marks(
        "shot by shot",
        Hue::Nth(2),
        Shape::Triangle,
        by(&|k| solve::shooting(&network, &light, k * network.len() as u32).0, 11),
    ))
    .with(marks(
        "conjugate gradients",
        Hue::Ours,
        Shape::Diamond,
        by(&|k| solve::conjugate(&network, &light, k), 5),
    ));
    Plot::of(format!("A cube of 54 patches that absorbs {absorbed:e}"), chart)
}
