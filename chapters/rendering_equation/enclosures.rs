//! C19 where it can be solved with pen and paper: a sphere in pieces, a ball in a sphere, plates without end.

use super::symbols::{A_1, A_2, B_1, B_2, E_1, E_2, L_1, L_2, RATIO};
use crate::diagram::{Diagram, Part};
use crate::figure::{Axis, Chart, Dash, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::path_tracing::one_ray::judged;
use crate::path_tracing::scenes::runs;
use crate::path_tracing::ways::smallest;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Quantity, Step, check, choice, derivation, exhibit, figure,
    largest, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::{Equation, Expr};
use light::radiometry::form_factor::parallel_rectangles;
use light::radiosity::exact::{Wall, concentric, sphere};
use light::radiosity::{Light, Network, solve};
use light::scene::{Camera, Emission, Filter, Geometry, Material, Scene, Shape, Transform, Triple};
use light::transport::Manner;
use std::f64::consts::TAU;
use yardstick::{order, precise};

const BALL: Parameter =
    Parameter::new("r", "r/R", "radius of the ball over that of the sphere", Kind::number(0.01, 0.99, "1"))
        .default("0.5");
const INNER: Parameter =
    Parameter::new("a_1", "a_1", "what the ball absorbs", Kind::number(1e-6, 1.0, "1")).default("0.3");
const OUTER: Parameter =
    Parameter::new("a_2", "a_2", "what the sphere absorbs", Kind::number(1e-6, 1.0, "1")).default("0.1");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "enclosures",
    &[BALL, INNER, OUTER],
    &[
        figure(
            "ball",
            "A ball in a sphere: all that leaves the ball meets the sphere, but of what leaves the sphere only r²/R² meets the ball.",
            section,
        ),
        figure("sizes", "A glowing ball in a dark sphere: how bright both are, by the ball's size.", sizes),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Rooms for pen and paper",
    "Where every place of a surface sees the same, the integral is a sum of two terms and the equation can be solved.",
)
.rows(&["C19"])
.statements(&[
    statement("inner", "the ball sees the sphere alone; it absorbs a₁", || Equation::new(L_1, E_1 + (1 - A_1) * L_2)),
    statement("outer", "the sphere sees the ball by k = r²/R², and itself", || {
        Equation::new(L_2, E_2 + (1 - A_2) * (RATIO * L_1 + (1 - RATIO) * L_2))
    }),
])
.derivations(&[
    derivation("solved", "two equations for two radiances", || {
        solved((E_2 + (1 - A_2) * RATIO * E_1) / (A_2 + (1 - A_2) * RATIO * A_1))
    })
    .slip("the sphere does not see itself", || solved((E_2 + (1 - A_2) * E_1) / (A_2 + (1 - A_2) * A_1))),
    derivation(
        "christiansen",
        "what bodies absorb they send when they are hot: of the heat that goes from one to the other (Christiansen 1883)",
        || christiansen((B_1 - B_2) / (1 / A_1 + RATIO * (1 / A_2 - 1))),
    )
    .slip("plates' formula for a ball", || christiansen((B_1 - B_2) / (1 / A_1 + 1 / A_2 - 1))),
])
.questions(&[question(
    "small_ball",
    "A small ball, black or white, hangs in a large glowing sphere. On what does the ball's radiance depend?",
    Answer::Choice {
        options: &[
            choice("on its size: the larger, the more light it catches", "It does catch more, but over as much more of its area."),
            choice("on how white it is; its size hardly matters", ""),
            choice("on neither", "So it would be if it glowed as hot as the sphere: what it does not return it would send."),
        ],
        right: |_| {
            let shell = Wall { absorbed: 0.3, emitted: 0.3 };
            let of = |ratio: f64, absorbed: f64| concentric(ratio, Wall { absorbed, emitted: 0.0 }, shell)[0];
            match (of(1e-6, 0.3) / of(4e-6, 0.3) - 1.0, of(1e-6, 0.3) / of(1e-6, 0.6) - 1.0) {
                (by_size, _) if by_size.abs() > 1e-3 => 0,
                (_, by_white) if by_white.abs() > 1e-3 => 1,
                _ => 2,
            }
        },
        slip: |_| 0,
    },
    "The sphere's light is all but unchanged by it, and it sends back ρ of that.",
)])
.readout(|setting| {
    let (ratio, ball, shell) = given(setting);
    let [inner, outer] = concentric(ratio, ball, shell);
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        quantity("ball", "L_1/L_e", "the ball, which alone shines", inner),
        quantity("sphere", "L_2/L_e", "the sphere", outer),
        quantity("plates", "L_2/L_e", "of two plates without end", concentric(1.0, ball, shell)[1]),
    ]
})
.checks(&[&TRACED, &PLATES, &PIECES])
.stress(&[stress("mirrors", "balls and spheres that absorb next to nothing, and balls that are next to nothing", mirrors)
    .textbook("1 − ρ₂(1 − k) − kρ₁ρ₂ for what is absorbed, ρ = 1 − a in f64")
    .against("the same in arbitrary precision")]);

fn pair() -> Chain {
    Chain::assume(Equation::new(L_1, E_1 + (1 - A_1) * L_2), "the ball")
        .and(Equation::new(L_2, E_2 + (1 - A_2) * (RATIO * L_1 + (1 - RATIO) * L_2)), "the sphere")
        .solve_for([L_1, L_2])
}

fn solved(last: Expr) -> Chain {
    pair().then(Equation::new(L_2, last), ["linear solve"])
}

fn christiansen(last: Expr) -> Chain {
    pair()
        .given(E_1, A_1 * B_1, "Kirchhoff: absorbed as sent")
        .given(E_2, A_2 * B_2, "Kirchhoff: absorbed as sent")
        .then(Equation::new(L_1 - L_2, last), ["linear solve", "Kirchhoff: absorbed as sent"])
        .because("from each place of the ball L₁ leaves and L₂ arrives; π times the difference is the heat")
}

fn given(setting: &Setting) -> (f64, Wall, Wall) {
    let ball = Wall { absorbed: setting.number("a_1"), emitted: 1.0 };
    (setting.number("r").powi(2), ball, Wall { absorbed: setting.number("a_2"), emitted: 0.0 })
}

/// The radiances of ball and sphere, by the square of their radii's ratio.
type Pair = fn(f64, Wall, Wall) -> [f64; 2];

const TRACED: Check<Pair> = check("traced", "ball and sphere are as bright in the renderer as on paper")
    .against("the closed form, against 48 independent pictures of a place of either, for three pairs (t-tests)")
    .significant(1e-3)
    .of(
        |_: &mut Bench, pair: Pair| {
            let wall = |absorbed, emitted| Wall { absorbed, emitted };
            let cases = [
                (0.5, wall(0.3, 1.0), wall(0.2, 0.0)),
                (0.8, wall(0.6, 0.0), wall(0.5, 1.0)),
                (0.2, wall(0.1, 1.0), wall(0.1, 0.05)),
            ];
            let tests = cases.into_iter().flat_map(|(radius, ball, shell)| {
                let exact = pair(radius * radius, ball, shell);
                [radius, 1.0].into_iter().zip(exact).map(move |(seen, exact)| {
                    let of = judged(&runs(48, &around(radius, ball, shell, seen), Manner::default(), 32), exact);
                    Measured { at: format!("r/R = {radius}, at {seen} R: {}", of.at), ..of }
                })
            });
            smallest(tests.collect())
        },
        concentric as Pair,
    )
    .slip("as if both were plates", |_, ball, shell| concentric(1.0, ball, shell));

/// A ball in a sphere of radius 1 m, a place of which is looked at: of the ball where `seen` is its radius.
fn around(radius: f64, ball: Wall, shell: Wall, seen: f64) -> Scene {
    let diffuse = |wall: Wall| Material::Diffuse { reflectance: [1.0 - wall.absorbed; 3] };
    let shape = |radius: f64, wall: Wall, name: &str| Shape {
        geometry: Geometry::Sphere { center: [0.0; 3], radius },
        material: name.into(),
        emission: (wall.emitted > 0.0).then_some(Emission { radiance: [wall.emitted; 3], two_sided: true }),
        transform: Transform::default(),
    };
    // Slantwise, from between the two.
    let (origin, target): (Triple, Triple) =
        ([0.0, 0.0, 0.5 * (1.0 + radius)], [0.3 * seen, 0.0, seen * 0.91_f64.sqrt()]);
    Scene {
        name: "ball".into(),
        max_depth: None,
        filter: Filter::Box,
        camera: Camera {
            origin,
            target,
            up: Camera::UP,
            fov_y_deg: 1e-3,
            width: 1,
            height: 1,
            aperture: 0.0,
            focus: None,
            polariser_deg: None,
        },
        environment: None,
        materials: vec![("ball".into(), diffuse(ball)), ("shell".into(), diffuse(shell))],
        shapes: vec![shape(radius, ball, "ball"), shape(1.0, shell, "shell")],
        lights: Vec::new(),
    }
}

const PLATES: Check<Pair> = check("plates", "square plates, ever nearer, become plates without end")
    .against("the closed form, against two patches with Howell's form factor, at gaps from 1/100 to 1/6400 of a side")
    .order(1.0, 0.1, "what is lost at the rim is as the gap, up to its logarithm")
    .of(
        |_: &mut Bench, pair: Pair| {
            let walls = [Wall { absorbed: 0.1, emitted: 1.0 }, Wall { absorbed: 0.4, emitted: 0.2 }];
            let exact = pair(1.0, walls[0], walls[1]);
            let light = Light { absorbed: walls.map(|w| w.absorbed).into(), emitted: walls.map(|w| w.emitted).into() };
            let points: Vec<(f64, f64)> = (0..7)
                .map(|halving| {
                    let gap = 0.01 / f64::from(1 << halving);
                    let factor = parallel_rectangles(1.0, 1.0, gap).unwrap_or(f64::NAN);
                    let network = Network::new(vec![1.0; 2], &[0.0, factor, factor, 0.0], false);
                    (gap, (solve::direct(&network, &light)[1] / exact[1] - 1.0).abs())
                })
                .collect();
            Measured::new(order::slope(&points).unwrap_or(f64::NAN), "seven gaps", points.len())
        },
        concentric as Pair,
    )
    .slip("the light of the first bounce alone", |_, ball, shell| {
        [ball.emitted, shell.emitted + (1.0 - shell.absorbed) * ball.emitted]
    });

/// What pieces of a sphere see of each other.
type Pieces = fn(&[f64]) -> Network;

const PIECES: Check<Pieces> =
    check("pieces", "a sphere cut into seven unequal pieces, solved as a network, is as bright as on paper")
        .against("Σ sL_e/Σ sa, against elimination over what pieces see of each other")
        .within(32.0, "ulp", "sums and quotients of positive numbers, seven deep")
        .of(
            |_: &mut Bench, pieces: Pieces| {
                let shares = [0.05, 0.1, 0.3, 0.02, 0.13, 0.2, 0.2];
                Measured::worst([1.0, 1e-3, 1e-9].map(|white| {
                    let wall = |at: usize| Wall { absorbed: white * (0.2 + 0.1 * at as f64), emitted: (at % 3) as f64 };
                    let known: Vec<_> = shares.iter().enumerate().map(|(at, share)| (*share, wall(at))).collect();
                    let light = Light {
                        absorbed: known.iter().map(|(_, wall)| wall.absorbed).collect(),
                        emitted: known.iter().map(|(_, wall)| wall.emitted).collect(),
                    };
                    let found = solve::direct(&pieces(&shares), &light);
                    let off = found.iter().zip(sphere(&known)).map(|(one, other)| (one / other - 1.0).abs());
                    (largest(off) / f64::EPSILON, format!("a up to {white:e}"))
                }))
            },
            Network::sphere as Pieces,
        )
        .slip("pieces taken as if all were of one size", |shares| {
            Network::sphere(&vec![1.0 / shares.len() as f64; shares.len()])
        });

fn mirrors(_: &Setting) -> Vec<Extreme> {
    let cases = [
        (0.25, 0.3, 0.3),
        (0.25, 1e-6, 1e-6),
        (0.25, 1e-12, 1e-12),
        (1.0, 1e-15, 1e-15),
        (1e-12, 0.5, 1e-14),
        (0.81, 1e-30, 1e-25),
        (1e-20, 1e-3, 1e-18),
    ];
    cases
        .map(|(ratio, inner, outer): (f64, f64, f64)| {
            let [k, a_1, a_2, one] = [ratio, inner, outer, 1.0].map(|x| precise::real_at(x, 1024));
            let rho = &one - &a_2;
            let reference = &rho * &k / (&a_2 + &rho * &k * &a_1);
            let [rho_1, rho_2] = [1.0 - inner, 1.0 - outer];
            let [ball, shell] = [Wall { absorbed: inner, emitted: 1.0 }, Wall { absorbed: outer, emitted: 0.0 }];
            Extreme {
                input: format!("k = {ratio}, a_1 = {inner:e}, a_2 = {outer:e}"),
                quantity: "L_2",
                reference,
                textbook: rho_2 * ratio / (1.0 - rho_2 * (1.0 - ratio) - ratio * rho_1 * rho_2),
                ours: concentric(ratio, ball, shell)[1],
                // A quotient of sums of positive terms in three inputs.
                condition: 3.0,
                worst_of: 1,
            }
        })
        .into()
}

fn section(setting: &Setting) -> Plot {
    let radius = setting.number("r");
    let circle = |r: f64| (0..=96).map(|k| TAU * f64::from(k) / 96.0).map(|t| [r * t.cos(), r * t.sin()]).collect();
    // From a place of the sphere to the left: what passes the ball and what does not.
    let from = [-1.0, 0.0];
    let rim = radius.asin();
    let reach = |angle: f64| -> ([f64; 2], bool) {
        let is_met = angle.abs() < rim;
        let chord = 2.0 * angle.cos();
        let near = angle.cos() - (radius * radius - angle.sin().powi(2)).max(0.0).sqrt();
        let length = if is_met { near } else { chord };
        ([from[0] + length * angle.cos(), length * angle.sin()], is_met)
    };
    let rays = (-6..=6).map(|k| {
        let (end, is_met) = reach(f64::from(k) * 0.22);
        Part::line(from, end).hue(if is_met { Hue::P } else { Hue::Reference })
    });
    let top = [0.0, radius];
    let away = (-2..=2).map(|k| {
        let angle = f64::from(k) * 0.45;
        let (s, c) = angle.sin_cos();
        let length = -radius * c + (1.0 - (radius * s).powi(2)).sqrt();
        Part::line(top, [length * s, radius + length * c]).hue(Hue::Ours)
    });
    let diagram = Diagram::new("", [-1.5, -1.15], [1.5, 1.15])
        .with(Part::curve(circle(1.0)))
        .with(Part::curve(circle(radius)))
        .with_all(rays)
        .with_all(away)
        .with(Part::line([0.0; 2], [radius * 0.6, -radius * 0.8]).dash(Dash::Dashed).label("r"))
        .with(Part::point(from))
        .explain(Hue::P, Dash::Solid, "from the sphere to the ball")
        .explain(Hue::Reference, Dash::Solid, "from the sphere to itself")
        .explain(Hue::Ours, Dash::Solid, "from the ball: to the sphere alone");
    Plot::of(format!("A ball of {radius} of the sphere's radius"), diagram)
}

fn sizes(setting: &Setting) -> Plot {
    let (_, ball, shell) = given(setting);
    let curve = |which: usize, shell: Wall| -> Vec<[f64; 2]> {
        (1..=100).map(|k| f64::from(k) / 100.0).map(|r| [r, concentric(r * r, ball, shell)[which]]).collect()
    };
    let black = Wall { absorbed: 1.0, emitted: 0.0 };
    let chart =
        Chart::new("", Axis::linear("radius of the ball r/R", "").range(0.0, 1.0), Axis::log("radiance L/L_e", ""))
            .line(Hue::P, "the ball", curve(0, shell))
            .line(Hue::Ours, "the sphere", curve(1, shell))
            .dashed(Hue::Reference, "the ball, the sphere black", curve(0, black))
            .at_x(setting.number("r"), "r/R");
    Plot::of(
        format!("A glowing ball that absorbs {} in a sphere that absorbs {}", ball.absorbed, shell.absorbed),
        chart,
    )
}
