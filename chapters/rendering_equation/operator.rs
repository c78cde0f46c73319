//! C19 in many dimensions: what one bounce does to any light, and why it fades.

use super::rooms::{cube, net, network, unequal};
use super::symbols::{F_R, L, RHO, THETA};
use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Step, check, choice, derivation, excess, exhibit, figure,
    question, statement, step,
};
use equation::derivation::Chain;
use equation::expr::{cos, integral_between, pi, sin};
use equation::{Equation, Expr};
use light::radiometry::form_factor::parallel_rectangles;
use light::radiosity::spectrum::{condition, modes, radius};
use light::radiosity::{Room, solve};
use yardstick::random::uniform;

const RHO_SET: Parameter =
    Parameter::new("rho", "ρ", "share of the light that the walls return", Kind::number(0.05, 0.9999, "1"))
        .default("0.9");
const CUTS: Parameter =
    Parameter::new("n", "n", "patches along an edge of the cube", Kind::Count { min: 1, max: 5 }).default("4");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "operator",
    &[RHO_SET, CUTS],
    &[
        figure(
            "eigenvalues",
            "By how much a bounce changes each pattern of light in a cube: one fades as ρ, all others about twice as fast or faster. In \
             a room of unequal walls even the slowest is faster than the whitest wall.",
            eigenvalues,
        ),
        figure(
            "patterns",
            "The cube unfolded: the first patterns that a bounce only scales. Red is more, blue is less than none.",
            patterns,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What one bounce does",
    "A bounce makes no light brighter than ρ times the brightest; its eigenvalues say how fast each pattern fades.",
)
.rows(&["C19"])
.statements(&[statement("bounce", "a bounce of light that is the same everywhere", || {
    Equation::new(RHO * L, integral_between(ring(), THETA, 0, pi() / 2))
})])
.derivations(&[derivation(
    "bound",
    "where light is nowhere brighter than L, none is sent back that is brighter than ρL",
    || bound(RHO * L),
)
.slip("the bound without the cosine", || bound(2 * RHO * L))])
.questions(&[question(
    "fading",
    "In a room some walls return 90 %, some 30 %. The sum of bounces falls, in the end, each time by a factor that is …",
    Answer::Choice {
        options: &[
            choice("0.9, that of the whitest walls", "So it would be if light could stay among them."),
            choice("the mean over the walls, weighed by area", "Light that has survived lies on the white walls: they count more."),
            choice("between the mean and 0.9", ""),
        ],
        right: |_| {
            let (mean, found) = fading();
            if found > 0.9 - 1e-9 {
                0
            } else if (found / mean - 1.0).abs() < 1e-3 {
                1
            } else {
                2
            }
        },
        slip: |_| 1,
    },
    "It is the largest eigenvalue: the light that lasts is brighter on the white walls than on the dark.",
)])
.readout(|setting| {
    let (_, network, light) = network(&cube(1.0 - setting.number("rho")), setting.number("n") as usize);
    let modes = modes(&network, &light);
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("first", "λ_1", "the pattern that lasts", modes[0].value),
        quantity("second", "λ_2", "the next", modes[1].value),
        quantity("condition", "κ", "condition number of 1 − K", condition(&modes)),
    ]
})
.checks(&[&CUBE, &BOUND, &RATE]);

/// A ring of the hemisphere, of light L.
fn ring() -> Expr {
    RHO / pi() * L * cos(THETA) * 2 * pi() * sin(THETA)
}

fn bound(last: Expr) -> Chain {
    Chain::new(integral_between(L * cos(THETA) * F_R * 2 * pi() * sin(THETA), THETA, 0, pi() / 2))
        .because("rings of the hemisphere, nowhere brighter than L")
        .given(F_R, RHO / pi(), "Lambert's wall")
        .primitive(RHO * L * sin(THETA).pow(2), THETA)
        .then(last, ["Lambert's wall", "∂ sin² θ = 2 sin θ cos θ"])
}

/// The mean reflectance of a cube of three white and three dark walls, and the factor by which its light fades.
fn fading() -> (f64, f64) {
    let room = Room::cuboid([1.0; 3], std::array::from_fn(|at| (if at % 2 == 0 { 0.1 } else { 0.7 }, 1.0)));
    let (_, network, light) = network(&room, 2);
    (0.6, radius(&modes(&network, &light)))
}

/// The six eigenvalues of a cube of six patches, by what one of its walls sees of the opposite one.
type Six = fn(f64) -> [f64; 6];

const CUBE: Check<Six> = check(
    "cube",
    "a cube of six patches has the eigenvalues ρ, twice ρ(p − 2q) and three times −ρp, p of the opposite wall and q of each other",
)
.against("symmetry: all alike; pairs alike and summing to nothing; pairs opposed; p by Howell's catalogue, q = (1 − p)/4 by closure")
.within(64.0, "ulp", "fifteen rotations a sweep, a few sweeps, and sixteen terms a form factor")
.of(
    |_: &mut Bench, six: Six| {
        let p = parallel_rectangles(1.0, 1.0, 1.0).unwrap_or(f64::NAN);
        let cases = [0.3, 0.8, 1.0 - 1e-6].into_iter().flat_map(|rho| {
            let (_, network, light) = network(&cube(1.0 - rho), 1);
            let found = modes(&network, &light);
            let mut exact = six(p).map(|value| rho * value);
            exact.sort_by(|one, other| other.total_cmp(one));
            let off = move |(at, (found, exact)): (usize, (light::radiosity::spectrum::Mode, f64))| {
                ((found.value - exact) / f64::EPSILON, format!("λ_{} at ρ = {rho}", at + 1))
            };
            found.into_iter().zip(exact).enumerate().map(off).collect::<Vec<_>>()
        });
        Measured::worst(cases)
    },
    |p| {
        let q = (1.0 - p) / 4.0;
        [1.0, p - 2.0 * q, p - 2.0 * q, -p, -p, -p]
    },
)
.slip("light that swaps opposite walls taken to keep its sign", |p| {
    let q = (1.0 - p) / 4.0;
    [1.0, p - 2.0 * q, p - 2.0 * q, p, p, p]
});

/// A bound of eigenvalues, by the walls' reflectances.
type Limit = fn(&[f64]) -> f64;

const BOUND: Check<Limit> = check("whitest", "whatever the room, no pattern outlasts the whitest wall")
    .against("the largest reflectance, against all eigenvalues of 40 rooms of random walls")
    .within(1e-12, "1", "what form factors miss of 1 by the roundings of their terms")
    .of(
        |bench: &mut Bench, limit: Limit| {
            let dice = &mut bench.stream;
            Measured::worst((0..40).map(|_| {
                let size = [(); 3].map(|()| uniform(dice, 0.2, 3.0));
                let walls = [(); 6].map(|()| (uniform(dice, 0.01, 0.99), 1.0));
                let (_, network, light) = network(&Room::cuboid(size, walls), 2);
                let rho = walls.map(|(absorbed, _)| 1.0 - absorbed);
                let over = radius(&modes(&network, &light)) - limit(&rho);
                (excess(over), format!("{size:.2?}, ρ = {rho:.2?}"))
            }))
        },
        |rho| rho.iter().copied().fold(0.0, f64::max),
    )
    .slip("the walls' mean", |rho| rho.iter().sum::<f64>() / rho.len() as f64);

const RATE: Check<fn(f64, f64) -> f64> = check("rate", "in a room of unequal walls the series falls by the largest eigenvalue a term")
    .against("the eigenvalue by Jacobi's rotations, against two neighbouring partial sums' distances from the solution by elimination")
    .within(
    1e-4,
    "1",
    "the next pattern is at most 0.6 as long-lived, by its eigenvalue: 0.6^20 ~ 4·10⁻⁵ of it is left beside the first",
)
.of(
        |_: &mut Bench, factor: fn(f64, f64) -> f64| {
            let (_, network, light) = network(&unequal(), 3);
            let all = solve::direct(&network, &light);
            let off = |terms: u32| -> f64 {
                solve::series(&network, &light, terms).iter().zip(&all).map(|(some, all)| all - some).sum()
            };
            let mean = (0..network.len()).map(|at| network.areas[at] * light.reflected(at)).sum::<f64>()
                / network.areas.iter().sum::<f64>();
            let expected = factor(radius(&modes(&network, &light)), mean);
            Measured::new((off(21) / off(20) / expected - 1.0).abs(), "20 terms, 54 patches", 1)
        },
        |eigenvalue, _| eigenvalue,
    )
    .slip("the mean reflectance for the eigenvalue", |_, mean| mean);

fn eigenvalues(setting: &Setting) -> Plot {
    let (rho, n) = (setting.number("rho"), setting.number("n") as usize);
    let points = |room: &Room| -> Vec<[f64; 2]> {
        let (_, network, light) = network(room, n);
        modes(&network, &light).iter().zip(1..).map(|(mode, at)| [f64::from(at), mode.value]).collect()
    };
    let marks = |label: String, hue, shape, points| Mark::Points { label, hue, shape, joined: false, points };
    let chart = Chart::new(
        "",
        Axis::log("number of the pattern", "").range(0.8, 200.0),
        Axis::linear("eigenvalue λ", "").range(-0.4, 1.05),
    )
    .with(marks(format!("cube, ρ = {rho}"), Hue::Ours, Shape::Disc, points(&cube(1.0 - rho))))
    .with(marks("room of unequal walls".into(), Hue::Nth(1), Shape::Ring, points(&unequal())))
    .at_y(rho, "ρ")
    .at_y(0.8, "whitest wall");
    Plot::of(format!("Eigenvalues of one bounce, {n} × {n} patches a wall"), chart)
}

fn patterns(setting: &Setting) -> Plot {
    let (rho, n) = (setting.number("rho"), setting.number("n").max(2.0) as usize);
    let (patches, network, light) = network(&cube(1.0 - rho), n);
    let found = modes(&network, &light);
    let panels = found.iter().take(6).zip(1..).map(|(mode, at)| {
        let most = mode.radiances.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let shade = |value: f64| {
            // Sum positive: the sign of an eigenvector is anybody's choice.
            let x = (value / most).clamp(-1.0, 1.0);
            let fade = 1.0 - x.abs();
            if x >= 0.0 { [1.0, fade, fade] } else { [fade, fade, 1.0] }
        };
        let turn = if mode.radiances.iter().sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        net(&patches, 72, format!("λ_{at} = {:.3}", mode.value), |patch| shade(turn * mode.radiances[patch])).into()
    });
    Plot::grid("Patterns that a bounce only scales", 3, panels.collect())
}
