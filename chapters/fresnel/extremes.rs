//! The inputs that break formulas: the grid over which the chapter keeps its promise of accuracy.

use crate::vocabulary::{ALLOWED_ULPS, Extreme};
use light::Complex64;
use light::optics::{Direction, Incidence, fresnel, textbook};
use light::references::fresnel::{Exact, Input, NAMES};
use std::f64::consts::FRAC_PI_2;
use yardstick::precise;

/// A family of extreme inputs.
#[derive(Debug)]
pub struct Family {
    /// What they have in common.
    pub name: &'static str,
    /// The inputs.
    pub inputs: Vec<Input>,
}

/// Every family; more than ten thousand inputs together.
pub fn families() -> Vec<Family> {
    vec![
        Family { name: "ordinary glass, every angle", inputs: pairs(&ORDINARY, &everywhere()) },
        Family { name: "near normal incidence", inputs: pairs(&ORDINARY, &near_normal()) },
        Family { name: "grazing, down to π/2 − 1e−15", inputs: pairs(&ORDINARY, &grazing()) },
        Family {
            name: "near Brewster's angle",
            inputs: near(&ORDINARY, |n_i, n_t| Some(fresnel::brewster_angle(n_i, n_t))),
        },
        Family { name: "near the critical angle", inputs: near(&INWARD, fresnel::critical_angle) },
        Family { name: "nearly equal indices", inputs: pairs(&nearly_equal(), &everywhere()) },
        Family { name: "indices a million apart", inputs: pairs(&far_apart(), &everywhere()) },
        Family { name: "metals, k up to 1000", inputs: pairs(&metals(), &everywhere()) },
        Family { name: "a trace of absorption", inputs: traces() },
        Family { name: "the faintest contrasts at grazing", inputs: faint() },
    ]
}

/// The program's outputs at `input`, in the order of [`NAMES`].
pub fn ours(input: &Input) -> [f64; NAMES.len()] {
    let incidence = Incidence::from(input.direction);
    flat(fresnel::amplitudes(incidence, input.n_i, input.n_t), fresnel::powers(incidence, input.n_i, input.n_t))
}

/// What the lecture's formulas as written give at `input`.
fn as_written(input: &Input) -> [f64; NAMES.len()] {
    let theta = match input.direction {
        Direction::Angle(theta) => theta,
        Direction::Grazing(delta) => FRAC_PI_2 - delta,
        Direction::Cos(cos) => cos.acos(),
    };
    flat(textbook::amplitudes(theta, input.n_i, input.n_t), textbook::powers(theta, input.n_i, input.n_t))
}

fn flat(a: fresnel::Amplitudes, p: fresnel::Powers) -> [f64; NAMES.len()] {
    let parts = [a.r_s, a.t_s, a.r_p, a.t_p].map(|z| [z.re, z.im]);
    let [r_s, t_s, r_p, t_p] = parts;
    [r_s[0], r_s[1], t_s[0], t_s[1], r_p[0], r_p[1], t_p[0], t_p[1], p.r_s, p.t_s, p.r_p, p.t_p, p.r_n(), p.t_n()]
}

/// The outputs called `quantities`, each at every one of `inputs`, beside the lecture's formulas as written.
pub fn cases(quantities: &[&str], inputs: &[Input]) -> Vec<Extreme> {
    cases_against(quantities, inputs, as_written)
}

/// As [`cases`], beside the outputs of another `textbook` form.
pub fn cases_against(
    quantities: &[&str],
    inputs: &[Input],
    textbook: impl Fn(&Input) -> [f64; NAMES.len()],
) -> Vec<Extreme> {
    let of_input = |input: &Input| {
        let exact = Exact::new(input);
        let (ours, textbook, conditions) = (ours(input), textbook(input), exact.conditions());
        let wanted = (0..NAMES.len()).filter(|&at| quantities.contains(&NAMES[at]));
        let extreme = |at: usize| Extreme {
            input: describe(input),
            quantity: NAMES[at],
            reference: exact.outputs[at].clone(),
            textbook: textbook[at],
            ours: ours[at],
            condition: conditions[at],
            worst_of: 1,
        };
        wanted.map(extreme).collect::<Vec<_>>()
    };
    inputs.iter().flat_map(of_input).collect()
}

/// For every output the input of `family` at which the program uses up most of what it is allowed.
pub fn worst_cases(family: &Family) -> Vec<Extreme> {
    let mut worst: Vec<Option<(f64, Extreme)>> = vec![None; NAMES.len()];
    for input in &family.inputs {
        let (exact, ours) = (Exact::new(input), ours(input));
        let errors: Vec<f64> =
            ours.iter().zip(&exact.outputs).map(|(ours, exact)| precise::relative_error(*ours, exact)).collect();
        // Condition numbers cost four more solutions; where every error is within a quarter of what even cond = 0 allows
        // they cannot matter, and 0 is on the safe side.
        let calm = errors.iter().all(|error| *error <= 0.25 * ALLOWED_ULPS * f64::EPSILON);
        let conditions = if calm { [0.0; NAMES.len()] } else { exact.conditions() };
        for (at, slot) in worst.iter_mut().enumerate() {
            let used = errors[at] / (1.0 + conditions[at]);
            let used = if used.is_nan() { f64::INFINITY } else { used };
            if slot.as_ref().is_none_or(|(most, _)| used > *most) {
                let extreme = Extreme {
                    input: format!("{}: {}", family.name, describe(input)),
                    quantity: NAMES[at],
                    reference: exact.outputs[at].clone(),
                    textbook: as_written(input)[at],
                    ours: ours[at],
                    condition: conditions[at],
                    worst_of: family.inputs.len(),
                };
                *slot = Some((used, extreme));
            }
        }
    }
    worst.into_iter().flatten().map(|(_, extreme)| extreme).collect()
}

/// The input in words.
pub fn describe(input: &Input) -> String {
    let direction = match input.direction {
        Direction::Angle(theta) if theta > 1.5 => format!("θ = π/2 − {:.3e}", FRAC_PI_2 - theta),
        Direction::Angle(theta) if theta < 1e-3 => format!("θ = {theta:.3e}"),
        Direction::Angle(theta) => format!("θ = {theta:.17}"),
        Direction::Grazing(delta) => format!("δ = {delta:.3e} from the surface"),
        Direction::Cos(cos) => format!("cos θ = {cos:.17e}"),
    };
    let to = if input.n_t.im == 0.0 {
        number(input.n_t.re)
    } else {
        format!("{}+{}i", number(input.n_t.re), number(input.n_t.im))
    };
    format!("n {} → {to}, {direction}", number(input.n_i))
}

fn number(x: f64) -> String {
    if (1e-3..1e4).contains(&x) { format!("{x}") } else { format!("{x:e}") }
}

type Media = (f64, Complex64);

const fn clear(n_i: f64, n_t: f64) -> Media {
    (n_i, Complex64::new(n_t, 0.0))
}

const ORDINARY: [Media; 20] = [
    clear(1.0, 1.0003),
    clear(1.0, 1.31),
    clear(1.0, 1.33),
    clear(1.0, 1.46),
    clear(1.0, 1.5),
    clear(1.0, 2.0),
    clear(1.0, 3.0),
    clear(2.0, 1.5),
    clear(1.0, 1.7),
    clear(1.0, 2.4),
    clear(1.0, 3.8),
    clear(1.0, 4.1),
    clear(1.33, 1.5),
    clear(1.33, 1.0),
    clear(1.5, 1.0),
    clear(1.7, 1.0),
    clear(2.4, 1.0),
    clear(4.1, 1.0),
    clear(1.5, 1.33),
    clear(1.7, 1.69),
];

const INWARD: [Media; 12] = [
    clear(1.33, 1.0),
    clear(1.5, 1.0),
    clear(1.7, 1.0),
    clear(2.4, 1.0),
    clear(4.1, 1.0),
    clear(1.5, 1.33),
    clear(1.0, 0.999),
    clear(1e6, 1.0),
    clear(3.5, 1.0),
    clear(1.0, 0.13),
    clear(1.0, 0.02),
    clear(2.5740534900131133, 0.5428398373309594),
];

fn nearly_equal() -> Vec<Media> {
    let gaps = [1e-15, 1e-13, 1e-10, 1e-7, 1e-4];
    gaps.iter().flat_map(|gap| [clear(1.0, 1.0 + gap), clear(1.0, 1.0 - gap), clear(1.5, 1.5 * (1.0 + gap))]).collect()
}

fn far_apart() -> Vec<Media> {
    vec![clear(1.0, 1e6), clear(1.0, 1e3), clear(1.0, 1e-3), clear(1.0, 1e-6), clear(1e3, 1e-3), clear(1e-3, 1e3)]
}

fn metals() -> Vec<Media> {
    let parts = [
        (0.05, 3.3),
        (0.2, 3.4),
        (1.0, 6.6),
        (3.2, 3.3),
        (3.0, 3.0),
        (4.0, 0.03),
        (1e-3, 1e3),
        (50.0, 1e3),
        (1e3, 1e3),
        (1.5, 1e-3),
        (0.4, 2.5),
        (2.9, 4.2),
        (20.0, 0.5),
        (0.01, 100.0),
        (1.0, 1.0),
    ];
    parts.iter().flat_map(|&(n, k)| [1.0, 1.5].map(|n_i| (n_i, Complex64::new(n, k)))).collect()
}

/// A clear medium that absorbs ever so little, at ordinary angles and about its critical and Brewster angles.
fn traces() -> Vec<Input> {
    let mut inputs = Vec::new();
    for k in [1e-300, 1e-100, 1e-30, 1e-20, 1e-16, 1e-12, 1e-8, 1e-5, 1e-2] {
        for (n_i, n) in
            [(1.0, 1.5), (1.5, 1.0), (1.0, 1.0 + 1e-10), (1.0, 1.0), (2.4, 2.0), (1.0, 1e-3), (1.0, 0.13), (3.5, 1.0)]
        {
            let media = [(n_i, Complex64::new(n, k))];
            let ordinary = [0.0, 1e-12, 0.3, 0.7, 1.2, 1.5, FRAC_PI_2 - 1e-6, FRAC_PI_2 - 1e-12];
            inputs.extend(pairs(&media, &ordinary.map(Direction::Angle)));
            inputs.extend(near(&media, fresnel::critical_angle));
            inputs.extend(near(&media, |n_i, n_t| Some(fresnel::brewster_angle(n_i, n_t))));
        }
    }
    inputs
}

/// Where both normal wave numbers are so small that their squares underflow.
fn faint() -> Vec<Input> {
    let indices = [(1.0, 0.0), (1.0, 1e-290), (1.0, 3e-192), (1.0, 1e-160), (1.0, 1e-100), (1.0 + 1e-15, 0.0)];
    let cosines = [1e-300, 1e-200, 1e-160, 1e-120, 1e-60].map(Direction::Cos);
    let media = indices.map(|(n, k)| (1.0, Complex64::new(n, k)));
    pairs(&media, &[&cosines[..], &[1e-160, 1e-20].map(Direction::Grazing)].concat())
}

fn everywhere() -> Vec<Direction> {
    let even = (0..=90).map(|degrees| Direction::Angle(f64::from(degrees).to_radians().min(FRAC_PI_2 - 1e-9)));
    even.chain(near_normal().into_iter().step_by(3)).chain(grazing().into_iter().step_by(3)).collect()
}

fn near_normal() -> Vec<Direction> {
    let angles = [0.0, 1e-300, 1e-160, 1e-80, 1e-12, 3e-9, 1e-8, 1e-6, 1e-4, 1e-3, 1e-2];
    angles
        .into_iter()
        .map(Direction::Angle)
        .chain([1.0, 1.0 - 1e-16, 1.0 - 1e-12, 1.0 - 1e-6].map(Direction::Cos))
        .collect()
}

fn grazing() -> Vec<Direction> {
    let deltas = [1e-15, 1e-13, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2];
    let angles = deltas.map(|delta| Direction::Angle(FRAC_PI_2 - delta));
    let exact = [1e-100, 1e-30, 1e-18, 1e-9, 1e-4].map(Direction::Grazing);
    angles.into_iter().chain(exact).chain([1e-60, 1e-20, 1e-5].map(Direction::Cos)).collect()
}

/// Inputs at and about a special angle, from a few units in the last place to a ten-thousandth.
fn near(media: &[Media], special: impl Fn(f64, f64) -> Option<f64>) -> Vec<Input> {
    let mut inputs = Vec::new();
    for &(n_i, n_t) in media {
        let Some(angle) = special(n_i, n_t.re) else { continue };
        let offsets = [0.0, 1e-16, 1e-15, 1e-14, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4, 1e-3, 1e-2];
        for direction in offsets.iter().flat_map(|offset| [angle - offset, angle + offset]) {
            if (0.0..=FRAC_PI_2).contains(&direction) {
                inputs.push(Input { direction: Direction::Angle(direction), n_i, n_t });
            }
        }
    }
    inputs
}

fn pairs(media: &[Media], directions: &[Direction]) -> Vec<Input> {
    let each = |&(n_i, n_t): &Media| directions.iter().map(move |&direction| Input { direction, n_i, n_t });
    media.iter().flat_map(each).collect()
}
