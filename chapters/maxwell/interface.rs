//! E4: what the four laws demand where one medium ends and another begins.

use super::symbols::{B_1, B_2, D_1, D_2, E_1, E_2, H_1, H_2, NORMAL};
use crate::diagram::{Behind, Diagram, Part, Spot};
use crate::figure::{Axis, Chart, Dash, Hue, Plot};
use crate::fresnel::fields::{Wave, waves};
use crate::fresnel::{INTERFACE, interface, sample_inputs};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Question, Step, check, derivation, exhibit,
    figure, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{cross, dot, vector};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::Polarisation;
use light::fields::surface::{Side, free_charge};
use light::optics::Direction;
use light::optics::Incidence;
use light::optics::fresnel::amplitudes;
use light::optics::incidence::{normal_squared, outgoing_root};
use light::references::fresnel::Input;
use light::waves::constants::EPSILON_0;
use std::f64::consts::TAU;
use yardstick::precise::{self, Real};

pub(super) const EXHIBIT: Exhibit = exhibit(
    "interface",
    INTERFACE,
    &[
        figure(
            "box_and_loop",
            "The box and the loop that the four conditions come from, before they are made flat and narrow.",
            box_and_loop,
        ),
        figure(
            "through_the_interface",
            "p light across the interface: the tangential E runs on, the normal E jumps so \
         that the normal D runs on.",
            through,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Where two media meet",
    "Across a bare interface the normal parts of D and B go on, and so do the \
     tangential parts of E and H.",
)
.rows(&["E4"])
.statements(&[
    statement("b_normal", "as much magnetic flux leaves as arrives", || normal_meets(B_1, B_2)),
    statement("d_normal", "and as much electric flux, where no charge lies between", || normal_meets(D_1, D_2)),
    statement("e_tangential", "the electric fields along the interface agree", || tangential_meets(E_1, E_2)),
    statement("h_tangential", "and the magnetic ones, where no current runs between", || tangential_meets(H_1, H_2)),
])
.questions(&[ACROSS])
.derivations(&[
    derivation(
        "pill_box",
        "Gauss's theorem on a box of height h whose lids lie on either side: all but the \
         lids comes with an h",
        || pill_box(step_across_d(D_1 - D_2)),
    )
    .slip("both lids take n for their way out", || pill_box(step_across_d(D_1 + D_2))),
    derivation("flat_pill_box", "the same box made flat: no volume is left for charge, no wall for flux", || {
        flat_box().then(normal_meets(B_1, B_2), ["h → 0"]).then(normal_meets(D_1, D_2), ["h → 0"])
    })
    .slip("E for D", || flat_box().then(normal_meets(E_1, E_2), ["h → 0"])),
    derivation(
        "loop",
        "Stokes's theorem on a loop of height h whose long sides lie on either side, along \
         t = b×n",
        || around(turn_across(&B_WAY.into(), [E_1, E_2], SHORT_E, THROUGH_E)),
    )
    .slip("the sides exchanged", || around(turn_across(&B_WAY.into(), [E_2, E_1], SHORT_E, THROUGH_E))),
    derivation("narrow_loops", "two such loops, one along each direction of the interface, made narrow", || {
        let loops = narrow_loops().then(tangential_meets(E_1, E_2), ["h → 0"]);
        loops.then(tangential_meets(H_1, H_2), ["h → 0"])
    })
    .slip("the normal part is taken to be continuous too", || narrow_loops().then(Equation::new(E_1, E_2), ["h → 0"])),
])
.readout(readout)
.checks(&[&NORMAL_PARTS, &TANGENTIAL_PARTS])
.stress(&[stress(
    "free_charge",
    "the charge that conduction leaves on an interface keeps its digits from the best \
     insulators to the best conductors",
    |_| charges(),
)
.textbook(
    "the step of the normal D, ε₂E₂ − ε₁E₁, with E₂ from the continuity of the total \
     current",
)
.against("the same step in 256 bits")]);

const ACROSS: Question = question(
    "across",
    "p light falls slantwise on glass of n = 1.5. The part of E that stands square to the surface: how large is it \
     just inside the glass, over just outside?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let direction = Direction::Angle(50f64.to_radians());
            let [incident, reflected, transmitted] =
                solved(&Input { direction, n_i: 1.0, n_t: 1.5.into() }, Polarisation::P);
            (transmitted.e[2] / (incident.e[2] + reflected.e[2])).norm()
        },
        slips: &[
            Misled { value: |_| 1.0, reply: "So it is with the part along the surface. Across it, D runs on, not E." },
            Misled {
                value: |_| 1.5 * 1.5,
                reply: "The other way round: D = εE is the same on both sides, so E is smaller where ε is larger.",
            },
            Misled { value: |_| 1.0 / 1.5, reply: "n is the root of ε; and it is ε that ties D to E." },
        ],
    },
    "1/n² = 0.444: the normal D runs on, and ε is n². Charges bound in the glass come to its face, and there the \
     field jumps.",
);

fn normal_meets(near: Symbol, far: Symbol) -> Equation {
    Equation::new(dot(NORMAL, near - far), 0)
}

fn tangential_meets(near: Symbol, far: Symbol) -> Equation {
    Equation::new(cross(NORMAL, near - far), 0)
}

/// Area of a lid.
pub(super) const AREA: Symbol = Symbol::scalar("A", Dimension::SQUARE_METRE).real(0.5, 2.0);
/// Circumference of the box.
const GIRTH: Symbol = Symbol::scalar("p", Dimension::METRE).real(0.5, 2.0);
/// Height of box and loop.
pub(super) const HEIGHT: Symbol = Symbol::scalar("h", Dimension::METRE).real(0.1, 1.0);
/// Length of the loop.
const LENGTH: Symbol = Symbol::scalar("l", Dimension::METRE).real(0.5, 2.0);
/// Way of the normal of the loop, in the interface.
const B_WAY: Symbol = Symbol::vector("b", Dimension::ONE);
/// Mean of a field out of the box's wall.
pub(super) const WALL_D: Symbol = Symbol::scalar("D_w", Dimension::COULOMB_PER_SQUARE_METRE);
const WALL_B: Symbol = Symbol::scalar("B_w", Dimension::TESLA);
/// Mean of the charge in the box.
pub(super) const INSIDE: Symbol = Symbol::scalar("rho", Dimension::COULOMB_PER_CUBIC_METRE);
/// Means of a field along the two short sides of a loop, and of what flows through it.
const SHORT_E: Symbol = Symbol::scalar("E_s", Dimension::VOLT_PER_METRE);
const SHORT_H: Symbol = Symbol::scalar("H_s", Dimension::AMPERE_PER_METRE);
const THROUGH_E: Symbol = Symbol::scalar("w", Dimension::TESLA.per(Dimension::SECOND));
const THROUGH_H: Symbol = Symbol::scalar("j", Dimension::AMPERE_PER_SQUARE_METRE);

/// What flows out of the box: n points out of the far lid and into the near one.
pub(super) fn out_of_box(near: Symbol, far: Symbol, wall: Symbol) -> Expr {
    AREA * dot(NORMAL, far) - AREA * dot(NORMAL, near) + GIRTH * HEIGHT * wall
}

/// The same solved for the step of the normal part: everything else comes with an h.
fn step_across_b() -> Equation {
    Equation::new(dot(NORMAL, B_1 - B_2), HEIGHT * (GIRTH * WALL_B / AREA))
}

fn step_across_d(step: Expr) -> Equation {
    Equation::new(dot(NORMAL, step), HEIGHT * (GIRTH * WALL_D / AREA - INSIDE))
}

fn pill_box(last: Equation) -> Chain {
    Chain::assume(Equation::new(out_of_box(B_1, B_2, WALL_B), 0), "∇·B = 0, Gauss's theorem")
        .and(Equation::new(out_of_box(D_1, D_2, WALL_D), AREA * HEIGHT * INSIDE), "∇·D = ρ, Gauss's theorem")
        .solve_for([WALL_B, WALL_D])
        .then(step_across_b(), ["over A"])
        .then(last, ["over A"])
}

fn flat_box() -> Chain {
    Chain::assume(step_across_b(), "the box, for B")
        .and(step_across_d(D_1 - D_2), "the box, for D")
        .given(NORMAL, vector(0, 0, 1), "n along z")
        .given(HEIGHT, 0, "h → 0")
}

/// Stokes's theorem on the loop: along t = b×n on the far side, back on the near one, and the short sides; `through` is
/// what flows through it, per area.
fn loop_of(way: &Expr, [near, far]: [Symbol; 2], short: Symbol, through: Symbol) -> Equation {
    let along = |field: Symbol| LENGTH * dot(cross(way, NORMAL), field);
    Equation::new(short * HEIGHT + along(far) - along(near), LENGTH * HEIGHT * through)
}

/// The same solved for the step of the tangential part along b: everything else comes with an h.
pub(super) fn turn_across(way: &Expr, [near, far]: [Symbol; 2], short: Symbol, through: Symbol) -> Equation {
    Equation::new(dot(way, cross(NORMAL, near - far)), HEIGHT * (short / LENGTH - through))
}

fn around(last: Equation) -> Chain {
    Chain::assume(loop_of(&B_WAY.into(), [E_1, E_2], SHORT_E, THROUGH_E), "∇×E = −∂B/∂t, Stokes's theorem")
        .then(last, ["(b×n)·a = b·(n×a)", "over l"])
}

/// Loops along x and y for E and for H, with h = 0.
fn narrow_loops() -> Chain {
    let ways = || [vector(1, 0, 0), vector(0, 1, 0)];
    let [x, y] = ways().map(|way| turn_across(&way, [E_1, E_2], SHORT_E, THROUGH_E));
    let [p, q] = ways().map(|way| turn_across(&way, [H_1, H_2], SHORT_H, THROUGH_H));
    Chain::assume(x, "the loop for E, b along x")
        .and(y, "b along y")
        .and(p, "the loop for H, b along x")
        .and(q, "b along y")
        .given(NORMAL, vector(0, 0, 1), "n along z")
        .given(HEIGHT, 0, "h → 0")
}

/// The three waves of an input.
fn solved(input: &Input, polarisation: Polarisation) -> [Wave; 3] {
    let incidence = Incidence::from(input.direction);
    waves(polarisation, incidence, input.n_i, input.n_t, &amplitudes(incidence, input.n_i, input.n_t))
}

/// (near, far) values of the tangential E_x, E_y, H_x, H_y and the normal D_z and B_z, E in units of the incident
/// amplitude, H times Z₀, D over ε₀; and how large each of the fields is.
fn sides(input: &Input, [incident, reflected, transmitted]: &[Wave; 3]) -> Sides {
    let near_eps = Complex64::from(input.n_i * input.n_i);
    let far_eps = input.n_t * input.n_t;
    let e = |axis: usize| (incident.e[axis] + reflected.e[axis], transmitted.e[axis]);
    let h = |axis: usize| (incident.h[axis] + reflected.h[axis], transmitted.h[axis]);
    let magnetic = 1.0 + input.n_i.max(input.n_t.norm());
    // The two waves on the near side may nearly cancel; what rounds is each of them.
    let meeting = incident.e[2].norm() + reflected.e[2].norm();
    let electric = 1.0 + near_eps.norm() * meeting + (far_eps * e(2).1).norm();
    let with = |(near, far): (Complex64, Complex64), scale: f64| (near, far, scale);
    [
        with(e(0), 1.0),
        with(e(1), 1.0),
        with(h(0), magnetic),
        with(h(1), magnetic),
        with((near_eps * e(2).0, far_eps * e(2).1), electric),
        with(h(2), magnetic),
    ]
}

const NAMES: [&str; 6] = ["E_x", "E_y", "H_x", "H_y", "D_z", "B_z"];

/// What stands on both sides of an interface; see [`sides`].
type Sides = [(Complex64, Complex64, f64); 6];

fn both_sides(input: &Input, polarisation: Polarisation) -> Sides {
    sides(input, &solved(input, polarisation))
}

/// Largest step, over the size of the waves and in ulp, of the chosen components across the setting's interface and
/// others.
fn steps(bench: &mut Bench, chosen: std::ops::Range<usize>, both_sides: fn(&Input, Polarisation) -> Sides) -> Measured {
    Measured::worst(sample_inputs(bench.setting()).iter().flat_map(|input| {
        [Polarisation::S, Polarisation::P].into_iter().flat_map({
            let chosen = chosen.clone();
            move |polarisation| {
                let sides = both_sides(input, polarisation);
                let place = format!("{polarisation:?}, {:?}, n {} → {}", input.direction, input.n_i, input.n_t);
                chosen.clone().map(move |at| {
                    let (near, far, scale) = sides[at];
                    ((near - far).norm() / scale / f64::EPSILON, format!("{} of {place}", NAMES[at]))
                })
            }
        })
    }))
}

const NORMAL_PARTS: Check<fn(&Input, Polarisation) -> Sides> = check(
    "normal_parts",
    "Fresnel's waves, made from the tangential conditions alone, carry D and B \
     straight through as well",
)
.against(
    "field vectors of the three waves of chapter fresnel, clear and absorbing, from \
     the normal to grazing and beyond total reflection",
)
.within(32.0, "ulp", "a dozen roundings in the amplitudes and in each product")
.of::<fn(&Input, Polarisation) -> Sides>(|bench, both_sides| steps(bench, 4..6, both_sides), both_sides)
.slip("E for D: the normal E is taken to be continuous", |input, polarisation| {
    sides(&Input { n_i: 1.0, n_t: 1.0.into(), ..*input }, &solved(input, polarisation))
});

const TANGENTIAL_PARTS: Check<fn(&Input, Polarisation) -> Sides> =
    check("tangential_parts", "and E and H along the interface, of course")
        .against("the same vectors, H = n k×E")
        .within(32.0, "ulp", "as for the normal parts")
        .of::<fn(&Input, Polarisation) -> Sides>(|bench, both_sides| steps(bench, 0..4, both_sides), both_sides)
        .slip("the reflected wave is forgotten", |input, polarisation| {
            let [incident, _, transmitted] = solved(input, polarisation);
            let nothing = Wave { e: [Complex64::ZERO; 3], h: [Complex64::ZERO; 3] };
            sides(input, &[incident, nothing, transmitted])
        });

fn readout(setting: &Setting) -> Vec<Quantity> {
    let input = interface(setting);
    let all = sides(&input, &solved(&input, Polarisation::P));
    let value = |key, symbol, says, value: f64| Quantity { key, symbol, says, value, unit: "1" };
    let normal = |at: usize, eps: Complex64, far: bool| {
        let (near, beyond, _) = all[at];
        (if far { beyond } else { near } / eps).norm()
    };
    vec![
        value("e_tangential", "|E_x|", "tangential E on both sides, p light of amplitude 1", all[0].0.norm()),
        value("d_normal", "|D_z|/ε_0", "normal D on both sides", all[4].0.norm()),
        value("e_normal_near", "|E_z|", "normal E on the near side", normal(4, (input.n_i * input.n_i).into(), false)),
        value("e_normal_far", "|E_z|", "normal E on the far side", normal(4, input.n_t * input.n_t, true)),
    ]
}

/// Pairs of media, and the frequency [Hz], from insulators to the best conductors.
const MEDIA: [(&str, [f64; 2], [f64; 2], f64); 9] = [
    ("air to distilled water, 1 MHz", [1.0, 0.0], [78.3, 5.5e-6], 1e6),
    ("air to sea water, 1 GHz", [1.0, 0.0], [72.5, 4.79], 1e9),
    ("air to fused silica, 545 THz", [1.0, 0.0], [2.13, 1e-18], 5.45e14),
    ("air to fused silica, 50 Hz", [1.0, 0.0], [3.8, 1e-18], 50.0),
    ("air to copper, 50 Hz", [1.0, 0.0], [1.0, 5.8e7], 50.0),
    ("air to copper, 1 mHz", [1.0, 0.0], [1.0, 5.8e7], 1e-3),
    ("two oils that relax nearly alike, 50 Hz", [2.0, 1e-12], [2.2, 1.1e-12 * (1.0 + 1e-9)], 50.0),
    ("copper to silver, 10 GHz", [1.0, 5.8e7], [1.0, 6.301e7], 1e10),
    ("damp to dry ground, 1 THz", [15.0, 1e-2], [4.0, 1e-4], 1e12),
];

fn charges() -> Vec<Extreme> {
    MEDIA
        .iter()
        .flat_map(|&(name, near, far, frequency)| {
            let omega = TAU * frequency;
            let side = |[eps_r, sigma]: [f64; 2]| Side { epsilon: eps_r * EPSILON_0, sigma };
            let (near, far) = (side(near), side(far));
            let ours = free_charge(near, far, omega);
            let book = step_of_d(near, far, omega);
            let (exact, condition) = exact_charge([near.epsilon, near.sigma, far.epsilon, far.sigma, omega]);
            let [re, im] = exact;
            let extreme = |quantity, reference, textbook, ours, condition| Extreme {
                input: name.to_owned(),
                quantity,
                reference,
                textbook,
                ours,
                condition,
                worst_of: 1,
            };
            [
                extreme("Re ρ_s/E_1", re, book.re, ours.re, condition[0]),
                extreme("Im ρ_s/E_1", im, book.im, ours.im, condition[1]),
            ]
        })
        .collect()
}

/// The textbook's way: the field beyond, then the difference.
fn step_of_d(near: Side, far: Side, omega: f64) -> Complex64 {
    let total = |side: Side| Complex64::new(side.sigma, -omega * side.epsilon);
    let e_far = total(near) / total(far);
    far.epsilon * e_far - near.epsilon
}

/// Real and imaginary part of ρ_s/E₁, and the condition numbers with respect to ε₁, σ₁, ε₂, σ₂ and ω.
fn exact_charge(inputs: [f64; 5]) -> ([Real; 2], [f64; 2]) {
    const STEP: f64 = 1e-30;
    // The textbook's way, in digits enough for its difference.
    let value = |[eps_1, sigma_1, eps_2, sigma_2, omega]: &[Real; 5]| {
        let total = |eps: &Real, sigma: &Real| {
            precise::from_real(sigma.clone()) - precise::complex(Complex64::I) * precise::from_real(omega * eps)
        };
        let e_far = total(eps_1, sigma_1) / total(eps_2, sigma_2);
        let step = precise::from_real(eps_2.clone()) * e_far - precise::from_real(eps_1.clone());
        <[Real; 2]>::from(step.into_parts())
    };
    let exact = inputs.map(precise::real);
    let here = value(&exact);
    let mut condition = [0.0; 2];
    for at in 0..5 {
        let mut moved = exact.clone();
        moved[at] = &moved[at] + &moved[at] * precise::real(STEP);
        for ((sum, there), here) in condition.iter_mut().zip(value(&moved)).zip(&here) {
            *sum += precise::to_f64(&((there - here) / here)).abs() / STEP;
        }
    }
    (here, condition)
}

/// p light along the normal through the interface at one moment.
fn through(setting: &Setting) -> Plot {
    let input = interface(setting);
    let incidence = Incidence::from(input.direction);
    let [incident, reflected, transmitted] = solved(&input, Polarisation::P);
    let q = [input.n_i.into(), input.n_t].map(|n| outgoing_root(normal_squared(incidence, input.n_i, n)));
    let wave = |at: Complex64, z: f64| (Complex64::i() * TAU * at * z).exp();
    let field = |axis: usize, z: f64| {
        if z < 0.0 {
            incident.e[axis] * wave(q[0], z) + reflected.e[axis] * wave(-q[0], z)
        } else {
            transmitted.e[axis] * wave(q[1], z)
        }
    };
    let eps = |z: f64| if z < 0.0 { (input.n_i * input.n_i).into() } else { input.n_t * input.n_t };
    // Both sides of the interface itself are drawn, so that a jump is upright.
    let places = (-200..=200).filter(|&at| at != 0).map(|at| f64::from(at) / 200.0);
    let places: Vec<f64> = places.flat_map(|z| if z == 0.005 { vec![-1e-9, 1e-9, z] } else { vec![z] }).collect();
    let curve = |of: &dyn Fn(f64) -> f64| places.iter().map(|&z| [z, of(z)]).collect::<Vec<_>>();
    let chart = |title: &str, y: &str| {
        Chart::new(title, Axis::linear("distance from the interface z/λ", "").range(-1.0, 1.0), Axis::linear(y, ""))
            .at_x(0.0, "")
    };
    let heading = crate::fresnel::media(input.n_i, input.n_t);
    Plot::grid(
        format!("Across the interface, {heading}"),
        2,
        vec![
            chart("along the interface", "field over the incident amplitude")
                .line(Hue::Nth(0), "E_x", curve(&|z| field(0, z).re))
                .into(),
            chart("across it", "field over the incident amplitude")
                .line(Hue::Nth(1), "E_z", curve(&|z| field(2, z).re))
                .dashed(Hue::Nth(2), "D_z/ε_0", curve(&|z| (eps(z) * field(2, z)).re))
                .into(),
        ],
    )
}

/// ε of the medium behind over that before: glass in air.
const DENSER: f64 = 2.25;

/// A box and a loop about an interface; the second medium lies below, and n points into it.
fn box_and_loop(_: &Setting) -> Plot {
    // Of D the normal part goes on, and of E the one along the interface; the other one of each follows from D = εE.
    let [along, down] = [0.25, -0.43];
    let arrow = |from: Spot, way: Spot| Part::vector(from, [from[0] + way[0], from[1] + way[1]]).hue(Hue::S);
    let pill_box = around_interface("Gauss's theorem: normal parts")
        .with(Part::vector([0.0, BOX[1]], [0.0, BOX[1] + 0.35]).hue(Hue::Reference).label("−n"))
        .with(Part::vector([0.0, -BOX[1]], [0.0, -BOX[1] - 0.35]).hue(Hue::Reference).label("n"))
        .with(arrow([-0.8, 0.85], [along, down]).label("D_1"))
        .with(arrow([-0.95, -0.42], [DENSER * along, down]).label("D_2"))
        .with(Part::note([0.25, -0.12], "A"));
    let [half, high] = BOX;
    let side = |from: Spot, to: Spot| Part::vector(from, to).hue(Hue::Natural);
    let narrow_loop = around_interface("Stokes's theorem: tangential parts")
        .with(side([0.25, high], [-0.25, high]))
        .with(side([-0.25, -high], [0.25, -high]))
        .with(side([-half, 0.1], [-half, -0.12]))
        .with(side([half, -0.1], [half, 0.12]))
        .with(Part::across([0.0, 0.0], true).label("b"))
        .with(arrow([-0.4, 0.85], [2.4 * along, down]).label("E_1"))
        .with(arrow([-0.3, -0.5], [2.4 * along, down / DENSER]).label("E_2"))
        .with(Part::vector([-1.0, 0.0], [-1.0, -0.4]).hue(Hue::Reference).label("n"));
    Plot::grid("Two ways to look across an interface", 2, vec![pill_box.into(), narrow_loop.into()])
}

/// Half the width and half the height of the box and of the loop.
pub(super) const BOX: Spot = [0.75, 0.28];

/// The interface and what is drawn about it, from the side.
pub(super) fn around_interface(title: &str) -> Diagram {
    let [half, high] = BOX;
    let rim = vec![[-half, -high], [half, -high], [half, high], [-half, high], [-half, -high]];
    Diagram::new(title, [-1.35, -1.2], [1.35, 1.2])
        .with(Part::surface([-1.35, 0.0], [1.35, 0.0], Behind::Tinted(0.35)))
        .with(Part::curve(rim).dash(Dash::Dashed))
        .with(Part::line([half + 0.15, -high], [half + 0.15, high]).hue(Hue::Reference).label("h"))
        .with(Part::note([-1.28, 1.05], "medium 1"))
        .with(Part::note([-1.28, -1.05], "medium 2"))
}
