//! C20, first half: how much one patch sees of another.

use super::edge::EDGE;
use super::rooms::{cube, net, network};
use super::slanted::{HINGE, SLANTED};
use super::symbols::{DISTANCE, F_12, F_21, S_1, S_2, THETA, THETA_2};
use crate::diagram::{Diagram, Part};
use crate::figure::{Axis, Chart, Dash, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Step, check, derivation, exhibit, figure,
    largest, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{Range, cos, integral, pi};
use equation::{Equation, Expr};
use light::radiometry::disc::Disc;
use light::radiometry::{form_factor, textbook};
use light::radiosity::exchange::exchange;
use light::radiosity::{Face, Network, Patch, Room};
use light::references::radiometry as precisely;
use light::scene::Triple;
use std::f64::consts::{FRAC_PI_2, PI};
use yardstick::precise;
use yardstick::quadrature::gauss_legendre;
use yardstick::random::uniform;

const APART: Parameter =
    Parameter::new("c", "c/a", "distance of two squares over their side", Kind::number(1e-3, 100.0, "1")).default("1");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "form_factors",
    &[APART],
    &[
        figure(
            "two_patches",
            "What two patches exchange: seen at a slant from either side, and thinner by 1/r².",
            two_patches,
        ),
        figure(
            "distance",
            "What a square sees of its like: across a gap, and at its side, hinged and folded.",
            distance,
        ),
        figure(
            "seen",
            "The cube unfolded: what one patch in the floor's corner sees of all others, on a scale of powers of ten.",
            seen,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Who sees whom",
    "A form factor is the share of what leaves one patch that arrives at another: geometry alone, and the same both ways but for areas.",
)
.rows(&["C20"])
.statements(&[
    statement("factor", "the share of what leaves patch 1 that arrives at 2", || {
        let both = cos(THETA) * cos(THETA_2) / (pi() * DISTANCE.pow(2));
        Equation::new(F_12, 1 / S_1 * integral(both, [S_1.into(), S_2.into()], Range::Whole))
    }),
    statement("both_ways", "what two patches exchange is the same both ways", || {
        Equation::new(S_1 * F_12, S_2 * F_21)
    }),
])
.derivations(&[derivation("back", "the share that goes back, from that which came: large patches see little of small ones", || {
    back(S_1 * F_12 / S_2)
})
.slip("the areas exchanged", || back(S_2 * F_12 / S_1))])
.questions(&[question(
    "wall",
    "Of what leaves one wall of a cubic room, how much arrives at the opposite wall?",
    Answer::Number {
        unit: "1",
        tolerance: 0.03,
        right: |_| form_factor::parallel_rectangles(1.0, 1.0, 1.0).unwrap_or(f64::NAN),
        slips: &[
            Misled { value: |_| 1.0 / PI, reply: "That is a wall so small or so far that its angles do not matter, at a distance of one side." },
            Misled { value: |_| 0.5, reply: "The walls beside it catch four fifths together." },
            Misled { value: |_| 1.0 / 6.0, reply: "It sees five walls, not six." },
        ],
    },
    "A fifth, nearly: the other four walls get a hair more each.",
)])
.readout(|setting| {
    let c = setting.number("c");
    let quantity = |key, symbol, says, value: Result<f64, _>| Quantity { key, symbol, says, value: value.unwrap_or(f64::NAN), unit: "1" };
    vec![
        quantity("facing", "F_∥", "between squares that face each other", form_factor::parallel_rectangles(1.0, 1.0, c)),
        quantity("hinged", "F_⊥", "between a square and a strip c high at its edge", form_factor::perpendicular_rectangles(1.0, c, 1.0)),
    ]
})
.checks(&[&SUMS, &DISCS, &CLOSURE, &RECIPROCITY, &HINGE, &SLANTED, &HIDDEN])
.stress(&[stress("slit", "plates so near that next to nothing leaves the slit between them", slits)
    .textbook("1 − F with Howell's C-11 as printed")
    .against("1 − F in 512 bits and more")])
.races(&[EDGE]);

fn back(last: Expr) -> Chain {
    Chain::assume(Equation::new(S_1 * F_12, S_2 * F_21), "the same both ways")
        .solve_for([F_21])
        .then(Equation::new(F_21, last), ["linear solve"])
}

/// What two patches exchange [m²].
type Exchange = fn(&Patch, &Patch) -> f64;

fn patch(corner: Triple, edges: [Triple; 2]) -> Patch {
    Patch::parallelogram(corner, edges)
}

/// Pairs that are apart, wholly before each other.
fn pairs() -> Vec<(Patch, Patch)> {
    let floor = patch([0.0; 3], [[1.0, 0.0, 0.0], [0.0, 0.7, 0.0]]);
    let above = |x: f64, y: f64, z: f64| patch([x, y, z], [[0.0, 0.9, 0.0], [1.2, 0.0, 0.0]]);
    let upright = |x: f64, y: f64, z: f64| patch([x, y, z], [[0.0, 1.1, 0.0], [0.0, 0.0, 0.5]]);
    vec![
        (floor, above(0.4, -2.0, 1.5)),
        (floor, above(-0.1, 0.0, 0.8)),
        (floor, upright(-0.5, 0.2, 0.6)),
        (floor, upright(-1.0, -2.0, 0.3)),
        (floor, above(9.0, 7.0, 17.0)),
        (above(0.0, 0.0, 2.0), upright(-1.0, 0.4, 1.0)),
    ]
}

const SUMS: Check<Exchange> = check("sums", "the closed forms for rectangles in any position are the sums over pairs of points")
    .against("∫∫ cos θ cos θ′/(π r²) dA dA′ by a product of four rules of Gauss, 20 points each, for six pairs")
    .within(1e-9, "1", "the nearest pair is apart by four fifths of a side: (0.8 + √1.64)⁻⁴⁰ ~ 10⁻¹³ a rule; sixteen terms that cancel to 10⁻⁶ leave 10⁻¹⁰")
    .of(
        |_: &mut Bench, exchange: Exchange| {
            Measured::worst(pairs().into_iter().enumerate().map(|(at, (one, other))| {
                (exchange(&one, &other) / by_gauss(&one, &other, 20) - 1.0, format!("pair {}", at + 1))
            }))
        },
        exchange as Exchange,
    )
    .slip("one of the two cosines forgotten, as for a lamp that is a point", |one, other| {
        let way: Triple = [0, 1, 2].map(|axis| other.at([0.5; 2])[axis] - one.at([0.5; 2])[axis]);
        let dot = |a: Triple, b: Triple| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        exchange(one, other) * dot(way, way).sqrt() / -dot(other.normal(), way)
    });

const DISCS: Check<fn(f64, f64, f64) -> f64> =
    check("discs", "of what leaves a disc, another on its axis gets what its middle and its rim get on average")
        .against("E/(πL) of the other disc at a point aside (chapter radiometry), averaged over the first by Gauss's rule")
        .within(
            1e-12,
            "1",
            "the printed form cancels to a two-thousandth where the first disc is smallest; 80 points leave 2.5⁻¹⁶⁰ of the mean",
        )
        .of(over_the_first, |r_1, r_2, h| form_factor::coaxial_discs(r_1, r_2, h).unwrap_or(f64::NAN))
        .slip("the way back for the way there", |r_1, r_2, h| {
            form_factor::coaxial_discs(r_2, r_1, h).unwrap_or(f64::NAN)
        });

/// The radii of first and second disc and their distance [m] to the share [1].
fn over_the_first(_: &mut Bench, factor: fn(f64, f64, f64) -> f64) -> Measured {
    let rule = gauss_legendre(80);
    Measured::worst([(1.0, 2.0, 1.5), (0.5, 0.2, 1.0), (1.0, 1.0, 0.4), (0.1, 3.0, 2.0)].map(|(r_1, r_2, h)| {
        let ring = |(u, weight): &(f64, f64)| {
            let disc = Disc { radius: r_2, height: h, offset: u * r_1, tilt: 0.0 };
            weight * 2.0 * u * disc.irradiance().unwrap_or(f64::NAN) / PI
        };
        let mean: f64 = rule.iter().map(ring).sum();
        (factor(r_1, r_2, h) / mean - 1.0, format!("r₁ = {r_1}, r₂ = {r_2}, h = {h}"))
    }))
}

/// By Gauss's rule in all four shares.
fn by_gauss(one: &Patch, other: &Patch, n: usize) -> f64 {
    let rule = gauss_legendre(n);
    let dot = |a: Triple, b: Triple| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let points = |patch: &Patch| -> Vec<(Triple, f64)> {
        rule.iter()
            .flat_map(|(u, a)| rule.iter().map(move |(v, b)| ([*u, *v], a * b)))
            .map(|(at, w)| (patch.at(at), w))
            .collect()
    };
    let (here, there, n, m) = (points(one), points(other), one.normal(), other.normal());
    let mut sum = 0.0;
    for (from, a) in &here {
        for (to, b) in &there {
            let way: Triple = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
            sum += a * b * dot(n, way) * -dot(m, way) / dot(way, way).powi(2);
        }
    }
    one.area() * other.area() / PI * sum
}

const CLOSURE: Check<Exchange> = check("closure", "what a patch of a closed room sees of all others is all that there is")
    .against("Σ F = 1, for every one of 600 patches of a cube and of a flat box")
    .within(
        1e-11,
        "1",
        "sixteen terms of the box's own size, in ulp, over the area of a patch of a hundredth: 10⁴ ulp; what 600 of them add up to at worst",
    )
    .of(
        |_: &mut Bench, exchange: Exchange| {
            Measured::worst([[1.0; 3], [2.0, 0.2, 1.0]].map(|size| {
                let patches = Room::cuboid(size, [(0.5, 1.0); 6]).cut(10).list;
                // By symmetry an octant of each wall would do; a row of each is looked at.
                let off = patches.iter().step_by(7).map(|one| {
                    let sum: f64 = patches.iter().map(|other| exchange(one, other)).sum();
                    (sum / one.area() - 1.0).abs()
                });
                (largest(off), format!("{size:?}"))
            }))
        },
        |one, other| if one == other { 0.0 } else { exchange(one, other) },
    )
    .slip("patches that touch at an edge left out, since r is 0 there", |one, other| {
        let touches = one.corners().iter().filter(|corner| other.corners().contains(corner)).count() == 2;
        if touches || one == other { 0.0 } else { exchange(one, other) }
    });

const RECIPROCITY: Check<Exchange> = check("reciprocity", "what two patches exchange is the same both ways, whatever lies behind the other's horizon")
    .against("the exchange reckoned from the other side, for 300 pairs of rectangles at random places of a room, parallel and upright")
    .within(1e-9, "1", "of the larger patch's area: sixteen terms of the room's size in ulp over its hundredth; or a rule of eight digits far away")
    .of(
        |bench: &mut Bench, exchange: Exchange| {
            let dice = &mut bench.stream;
            let mut any = || {
                let axis = (uniform(dice, 0.0, 3.0) as usize).min(2);
                let corner = [(); 3].map(|()| uniform(dice, 0.0, 2.0));
                let edge = |axis: usize, length: f64| -> Triple { std::array::from_fn(|at| if at == axis { length } else { 0.0 }) };
                let [a, b] = [(); 2].map(|()| uniform(dice, 0.1, 1.0));
                let edges = [edge((axis + 1) % 3, a), edge((axis + 2) % 3, b)];
                patch(corner, if uniform(dice, 0.0, 1.0) < 0.5 { edges } else { [edges[1], edges[0]] })
            };
            Measured::worst((0..300).map(|_| {
                let (one, other) = (any(), any());
                let scale = one.area().max(other.area());
                ((exchange(&one, &other) - exchange(&other, &one)) / scale, format!("{one:.2?}, {other:.2?}"))
            }))
        },
        exchange as Exchange,
    )
    .slip("form factors taken to be the same both ways", |one, other| exchange(one, other) / one.area());

/// What the network of a room is.
type Made = fn(&Room) -> Network;

const HIDDEN: Check<Made> = check("hidden", "a block floats in a room: what it hides of the walls is seen on the block, and sums stay 1")
    .against("Σ F = 1 for all 108 patches of room and block, what is hidden by rays between 3 × 3 points of either patch")
    .within(0.03, "1", "along the block's outline a third of a patch's points is uncertain, at random; it crosses some fifth of the 60 patches that one sees")
    .of(
        |_: &mut Bench, made: Made| {
            let network = made(&with_block());
            let sums = (0..network.len()).map(|at| network.row(at).iter().sum::<f64>());
            Measured::worst(sums.enumerate().map(|(at, sum)| (sum - 1.0, format!("patch {at}"))))
        },
        |room| Network::of(&room.cut(3)),
    )
    .slip("nothing taken to be in the way", |room| {
        let patches = room.cut(3).list;
        let n = patches.len();
        let both = (0..n * n).map(|at| if at / n == at % n { 0.0 } else { exchange(&patches[at / n], &patches[at % n]) });
        Network::new(patches.iter().map(Patch::area).collect(), &both.collect::<Vec<_>>(), true)
    });

/// A cube with a block in it, all walls alike.
fn with_block() -> Room {
    let room = Room::cuboid([1.0; 3], [(0.5, 1.0); 6]);
    // The block's faces are those of a smaller room, seen from outside.
    let out = |face: &Face| {
        let Patch { corner, edges, .. } = face.patch;
        let place = [0, 1, 2].map(|axis| [0.3, 0.2, 0.45][axis] + corner[axis]);
        Face { patch: patch(place, [edges[1], edges[0]]), ..*face }
    };
    let block = Room::cuboid([0.35, 0.5, 0.3], [(0.5, 0.0); 6]);
    Room { faces: room.faces.iter().copied().chain(block.faces.iter().map(out)).collect(), is_closed: true }
}

fn slits(_: &Setting) -> Vec<Extreme> {
    [1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12]
        .map(|gap: f64| {
            let exact = precisely::parallel_rectangles(1.0, 1.0, gap).value;
            let reference = precise::real_at(1.0, exact.precision()) - exact;
            // What does not arrive at the other plate leaves through four slits.
            let ours = 4.0 * form_factor::perpendicular_rectangles(1.0, gap, 1.0).unwrap_or(f64::NAN);
            Extreme {
                input: format!("gap over side {gap:e}"),
                quantity: "1 − F",
                reference,
                textbook: 1.0 - textbook::parallel_rectangles(1.0, 1.0, gap),
                ours,
                // It is about as the gap over each side.
                condition: 2.0,
                worst_of: 1,
            }
        })
        .into()
}

fn two_patches(_: &Setting) -> Plot {
    let (a, b) = ([-1.2, 0.0], [1.3, 1.9]);
    let (tilt, turn) = (0.15_f64, 2.5_f64);
    let edge = |at: [f64; 2], angle: f64, half: f64| {
        let [c, s] = [angle.cos() * half, angle.sin() * half];
        ([at[0] - c, at[1] - s], [at[0] + c, at[1] + s])
    };
    let normal = |at: [f64; 2], angle: f64| [at[0] - 0.9 * angle.sin(), at[1] + 0.9 * angle.cos()];
    let ((a0, a1), (b0, b1)) = (edge(a, tilt, 0.7), edge(b, turn, 0.5));
    let way = (b[1] - a[1]).atan2(b[0] - a[0]);
    let diagram = Diagram::new("", [-2.6, -0.5], [2.6, 2.7])
        .with(Part::line(a0, a1).hue(Hue::P))
        .with(Part::line(b0, b1).hue(Hue::Ours))
        .with(Part::line(a, b))
        .with(Part::vector(a, normal(a, tilt)).label("n"))
        .with(Part::vector(b, normal(b, turn)).label("n′"))
        .with(Part::arc(a, 0.5, tilt + FRAC_PI_2, way).label("θ"))
        .with(Part::arc(b, 0.45, turn + FRAC_PI_2, way + PI).label("θ′"))
        .with(Part::point(a))
        .with(Part::point(b))
        .with(Part::note([0.25, 0.85], "r"))
        .explain(Hue::P, Dash::Solid, "patch 1, of area S_1")
        .explain(Hue::Ours, Dash::Solid, "patch 2, of area S_2");
    Plot::of("Two patches", diagram)
}

fn distance(setting: &Setting) -> Plot {
    let c = setting.number("c");
    let at = |k: i32| 10f64.powf(f64::from(k) / 20.0);
    let curve = |of: fn(f64) -> f64| -> Vec<[f64; 2]> { (-60..=40).map(at).map(|c| [c, of(c)]).collect() };
    let facing = |c: f64| form_factor::parallel_rectangles(1.0, 1.0, c).unwrap_or(f64::NAN);
    let chart = Chart::new(
        "",
        Axis::log("gap, or height of the strip, c over the side", "").range(1e-3, 100.0),
        Axis::log("form factor F", "").range(1e-5, 2.0),
    )
    .line(Hue::Ours, "across a gap", curve(facing))
    .line(
        Hue::Nth(1),
        "to a strip at its edge",
        curve(|c| form_factor::perpendicular_rectangles(1.0, c, 1.0).unwrap_or(f64::NAN)),
    )
    .line(
        Hue::Nth(2),
        "past the other plate, 1 − F",
        curve(|c| 4.0 * form_factor::perpendicular_rectangles(1.0, c, 1.0).unwrap_or(f64::NAN)),
    )
    .dashed(Hue::Reference, "far away, a²/(π c²)", curve(|c| 1.0 / (PI * c * c)))
    .at_x(c, "c");
    Plot::of("What a square sees", chart)
}

fn seen(_: &Setting) -> Plot {
    let n = 12;
    let (patches, network, _) = network(&cube(0.5), n);
    // Near a corner of the floor.
    let from = patches.at(2, [0.2, 0.2]);
    let row = network.row(from);
    let most = row.iter().copied().fold(0.0, f64::max);
    let shade = |at: usize| {
        if at == from {
            return [1.0, 0.15, 0.1];
        }
        // Four decades from black to white.
        let level = if row[at] > 0.0 { (1.0 + (row[at] / most).log10() / 3.0).clamp(0.0, 1.0) } else { 0.0 };
        [level * level, level * level, 0.08 + 0.92 * level * level]
    };
    Plot::of("What the red patch sees, over three powers of ten", net(&patches, 96, String::new(), shade))
}
