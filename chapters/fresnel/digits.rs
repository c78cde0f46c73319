//! C10: where the formulas as written lose their digits, and the form that does not.

use super::extremes::{families, ours, worst_cases};
use super::{N_I, N_T, interface};
use crate::figure::{Axis, Map, Panel, Plot, Ramp};
use crate::parameter::{Setting, THETA, WAVELENGTH};
use crate::vocabulary::{
    ALLOWED_ULPS, Answer, Bench, Exhibit, Expects, Heat, Lane, Quantity, Question, Race, Step, choice, digits, exhibit,
    figure, lane, question, race, step, stress,
};
use light::Complex64;
use light::optics::fresnel::{natural_reflectance, natural_reflectance_absorbing, powers};
use light::optics::textbook::{self, natural_reflectance_by_cosines};
use light::optics::{Direction, Incidence};
use light::references::fresnel::{Exact, Input, NAMES};
use yardstick::precise;
use yardstick::random::uniform;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "digits",
    &[N_I, N_T.default("1.000001"), THETA, WAVELENGTH],
    &[figure(
        "digits_lost",
        "Digits of R_n kept by the formula as written, by the cosines most renderers use, \
         and by the program; and how many the condition number asks for.",
        digits_lost,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Digits lost, digits kept",
    "As written the formulas are 0/0 at normal incidence and cancel between similar \
     media; one identity cures both.",
)
.rows(&["C10"])
.questions(&[OF_SIXTEEN])
.readout(readout)
.stress(&[stress(
    "promise",
    "over more than ten thousand inputs chosen to break it, every output stays within \
     16 ulp · (1 + cond)",
    |_| families().iter().flat_map(worst_cases).collect(),
)
.rows(&["C10", "C13", "C14"])
.textbook("E36–E42 as written")
.against("256-bit arithmetic; cond from difference quotients with a relative step of 1e−30")])
.races(&[FORMS, FORMS_ABSORBING]);

const OF_SIXTEEN: Question = question(
    "of_sixteen",
    "Two media differ in index by one part in a million. R_n at 45°, by the formula as written, in sixteen digits: \
     how many of them are right?",
    Answer::Choice {
        options: &[
            choice(
                "all but the last",
                "Each operation is right to the last digit. But θ₁ − θ₂ is a difference of two angles that agree in \
                 six digits, and these are gone.",
            ),
            choice("some nine or ten", ""),
            choice("hardly any", "So it is where they differ by a part in 10¹⁵, or close to normal incidence."),
        ],
        right: |_| {
            let (theta, n) = (45f64.to_radians(), 1.000_001);
            let exact = Exact::new(&Input { direction: Direction::Angle(theta), n_i: 1.0, n_t: n.into() });
            let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
            match digits(precise::relative_error(by_angles(theta, n), &exact.outputs[at])) {
                kept if kept > 14.0 => 0,
                kept if kept > 6.0 => 1,
                _ => 2,
            }
        },
        slip: |_| 0,
    },
    "Six of the sixteen cancel in θ₁ − θ₂, and nothing brings them back. Formed from n₁ − n₂, which is exact, the \
     same number keeps them all.",
);

fn readout(setting: &Setting) -> Vec<Quantity> {
    let input = interface(setting);
    let exact = Exact::new(&input);
    let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
    let condition = exact.conditions()[at];
    let written = textbook::powers(setting.number("theta"), input.n_i, input.n_t).r_n();
    let kept = |value: f64| digits(precise::relative_error(value, &exact.outputs[at]));
    let all = [
        ("digits_written", "as written", "decimal digits of R_n that E42 keeps here", kept(written)),
        ("digits_kept", "the program", "decimal digits of R_n that the program keeps here", kept(ours(&input)[at])),
        ("condition", "cond", "condition number of R_n: what the inputs' own rounding is multiplied by", condition),
    ];
    all.map(|(key, symbol, says, value)| Quantity { key, symbol, says, value, unit: "1" }).into()
}

/// How many evaluations make a heat, and how many of them are held against arbitrary precision.
const BATCH: u64 = 4096;
const JUDGED: usize = 48;

const FORMS: Race = race(
    "forms",
    "in a batch the form that keeps its digits costs no more than the plain cosines: \
     R_n between clear media",
)
.rows(&["C10", "E42"])
.work("evaluations of R_n")
.error(
    "worst relative error of R_n",
    "worst relative error against 256-bit arithmetic over angles down to 1e−9 and \
     contrasts down to 1e−9",
)
.lanes(&[
    entrant("written", "angles, as written", BREAKS, |bench, work| {
        clear(bench, work, singly(|cos, n_t| by_angles(cos.acos(), n_t.re)))
    }),
    entrant("cosines", "cosines", BREAKS, |bench, work| {
        clear(bench, work, singly(|cos, n_t| natural_reflectance_by_cosines(cos, 1.0, n_t.re)))
    }),
    entrant("single", "the program, one by one", KEEPS, |bench, work| clear(bench, work, singly(one_by_one))),
    entrant("batch", "the program, in a batch", KEEPS, |bench, work| {
        clear(bench, work, |cosines, n_t, out| natural_reflectance(cosines, 1.0, n_t.re, out))
    }),
]);

const FORMS_ABSORBING: Race =
    race("forms_absorbing", "into metals the form that keeps its digits is the faster one, even one by one")
        .work("evaluations of R_n")
        .error(
            "worst relative error of R_n",
            "worst relative error against 256-bit arithmetic over gold, a trace of absorption \
             and k = 100",
        )
        .lanes(&[
            entrant("written", "complex angles", BREAKS, |bench, work| {
                absorbing(bench, work, singly(|cos, n_t| textbook::powers(cos.acos(), 1.0, n_t).r_n()))
            }),
            entrant("single", "the program, one by one", KEEPS, |bench, work| {
                absorbing(bench, work, singly(one_by_one))
            }),
            entrant("batch", "the program, in a batch", KEEPS, |bench, work| {
                absorbing(bench, work, |cosines, n_t, out| natural_reflectance_absorbing(cosines, 1.0, n_t, out))
            }),
        ]);

const fn entrant(
    id: &'static str,
    label: &'static str,
    expects: Expects,
    prepare: fn(&mut Bench, u64) -> Heat,
) -> Lane {
    lane(id, label, &[BATCH], prepare).expects(expects)
}

const BREAKS: Expects =
    Expects::Breaks { limit: 1e-10, why: "differences of nearly equal numbers, and 0/0 at normal incidence" };
const KEEPS: Expects =
    Expects::Within { limit: 64.0 * f64::EPSILON, why: "a dozen roundings, times a few where p nearly vanishes" };

/// E42 with real angles, the fastest way to write it down.
fn by_angles(theta: f64, n_t: f64) -> f64 {
    let theta_t = (theta.sin() / n_t).asin();
    let (difference, sum) = (theta - theta_t, theta + theta_t);
    let (s, p) = (difference.sin() / sum.sin(), difference.tan() / sum.tan());
    0.5 * (s * s + p * p)
}

/// R_n from cos θ₁ and n₂, out of the vacuum.
type Form = fn(f64, Complex64) -> f64;

fn one_by_one(cos: f64, n_t: Complex64) -> f64 {
    powers(Incidence::from_cos(cos), 1.0, n_t).r_n()
}

/// `form` at one cosine after another.
fn singly(form: impl Fn(f64, Complex64) -> f64) -> impl FnMut(&[f64], Complex64, &mut [f64]) {
    move |cosines, n_t, out| {
        for (out, cos) in out.iter_mut().zip(cosines) {
            *out = form(*cos, n_t);
        }
    }
}

fn clear(bench: &mut Bench, work: u64, fill: impl FnMut(&[f64], Complex64, &mut [f64]) + 'static) -> Heat {
    heat(bench, work, &[1.5, 2.4, 1.0 + 1e-9, 4.0].map(|n| (n, 0.0)), fill)
}

fn absorbing(bench: &mut Bench, work: u64, fill: impl FnMut(&[f64], Complex64, &mut [f64]) + 'static) -> Heat {
    heat(bench, work, &[(0.42, 2.47), (1.0 + 1e-9, 1e-12), (2.0, 100.0), (1.5, 1e-6)], fill)
}

/// A batch of evenly and of logarithmically spread angles for each medium in turn; the error is the worst over a
/// sample of them.
fn heat(
    bench: &mut Bench,
    work: u64,
    media: &[(f64, f64)],
    mut fill: impl FnMut(&[f64], Complex64, &mut [f64]) + 'static,
) -> Heat {
    let media: Vec<Complex64> = media.iter().map(|&(n, k)| Complex64::new(n, k)).collect();
    let share = work as usize / media.len();
    let mut cosines: Vec<f64> = (0..share)
        .map(|at| match at % 2 {
            0 => uniform(&mut bench.stream, 0.01, 1.0),
            _ => 10f64.powf(uniform(&mut bench.stream, -9.0, 0.0)).cos(),
        })
        .collect();
    cosines[0] = 1.0;
    let judged: Vec<usize> = (0..JUDGED / media.len()).map(|at| at * share * media.len() / JUDGED).collect();
    let (inputs, indices) = (cosines.clone(), media.clone());
    let mut out = vec![0.0; share * media.len()];
    Heat {
        run: Box::new(move || {
            for (n_t, part) in media.iter().zip(out.chunks_exact_mut(share)) {
                fill(&cosines, *n_t, part);
            }
            out.clone()
        }),
        error: Box::new(move |results| {
            let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
            let errors = indices
                .iter()
                .enumerate()
                .flat_map(|(medium, n_t)| judged.iter().map(move |case| (medium, n_t, *case)));
            let worst = errors.map(|(medium, n_t, case)| {
                let exact = Exact::new(&Input { direction: Direction::Cos(inputs[case]), n_i: 1.0, n_t: *n_t });
                precise::relative_error(results[medium * share + case], &exact.outputs[at])
            });
            worst
                .map(f64::abs)
                .fold(0.0, |worst: f64, error| if error.total_cmp(&worst).is_gt() { error } else { worst })
        }),
    }
}

/// Cells of the maps; the fourth, whose cells cost five solutions each, has half as many along either side.
const COLUMNS: usize = 72;
const ROWS: usize = 54;

fn digits_lost(_: &Setting) -> Plot {
    let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
    let forms: [(&str, Form); 3] = [
        ("as written", |cos, n_t| by_angles(cos.acos(), n_t.re)),
        ("by the cosines", |cos, n_t| natural_reflectance_by_cosines(cos, 1.0, n_t.re)),
        ("the program", one_by_one),
    ];
    let fine = cells(COLUMNS, ROWS);
    let panels = forms.map(|(title, form)| {
        let kept = |(cos, n_t, exact): &(f64, f64, Exact)| {
            let value = form(*cos, (*n_t).into());
            if value.is_finite() { digits(precise::relative_error(value, &exact.outputs[at])) } else { f64::NAN }
        };
        map(title, "decimal digits kept", COLUMNS, fine.iter().map(kept).collect())
    });
    let owed = |(.., exact): &(f64, f64, Exact)| digits(ALLOWED_ULPS * f64::EPSILON * (1.0 + exact.conditions()[at]));
    let coarse = cells(COLUMNS / 2, ROWS / 2);
    let owed =
        map("what 16 ulp · (1 + cond) asks for", "decimal digits owed", COLUMNS / 2, coarse.iter().map(owed).collect());
    Plot::grid("Digits of R_n kept, of the sixteen there are", 2, panels.into_iter().chain([owed]).collect())
}

/// cos θ₁, n₂/n₁ and the exact solution in every cell, row by row from the bottom.
fn cells(columns: usize, rows: usize) -> Vec<(f64, f64, Exact)> {
    let all = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let cell = |(column, row)| {
        let middle = |at: usize, of: usize| (at as f64 + 0.5) / of as f64;
        let (angle, contrast) =
            (10f64.powf(10.0 * middle(column, columns) - 10.0), 10f64.powf(12.0 * middle(row, rows) - 12.0));
        let (cos, n_t) = (angle.cos(), 1.0 + contrast);
        (cos, n_t, Exact::new(&Input { direction: Direction::Cos(cos), n_i: 1.0, n_t: n_t.into() }))
    };
    all.map(cell).collect()
}

fn map(title: &str, colour: &str, columns: usize, values: Vec<f64>) -> Panel {
    Panel::Map(Map {
        title: title.into(),
        x: Axis::log("angle of incidence θ_1", "rad").range(1e-10, 1.0),
        y: Axis::log("contrast n_2/n_1 − 1", "").range(1e-12, 1.0),
        colour: Axis::linear(colour, "").range(0.0, 16.0).tick(4.0),
        ramp: Ramp::Sequential,
        columns,
        values,
        marks: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fresnel::extremes::describe;
    use crate::vocabulary::Extreme;

    #[test]
    fn the_grid_is_as_large_as_it_claims() {
        let inputs: Vec<Input> = families().into_iter().flat_map(|family| family.inputs).collect();
        assert!(inputs.len() >= 10_000, "{}", inputs.len());
        let nan: Vec<_> = inputs.iter().filter(|input| ours(input).iter().any(|x| x.is_nan())).map(describe).collect();
        assert!(nan.is_empty(), "{nan:?}");
    }

    #[test]
    fn the_promise_is_kept() {
        let broken: Vec<Extreme> = families().iter().flat_map(worst_cases).filter(|case| !case.holds()).collect();
        assert!(broken.is_empty(), "{broken:?}");
    }

    #[test]
    fn the_batch_keeps_the_promise_too() {
        let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
        let broken: Vec<_> = families()
            .into_iter()
            .flat_map(|family| family.inputs)
            .filter_map(|input| {
                // The batch takes cosines: the same direction, rounded to one.
                let cos = Incidence::from(input.direction).cos();
                let input = Input { direction: Direction::Cos(cos), ..input };
                let mut out = [f64::NAN];
                match input.n_t.im == 0.0 {
                    true => natural_reflectance(&[cos], input.n_i, input.n_t.re, &mut out),
                    false => natural_reflectance_absorbing(&[cos], input.n_i, input.n_t, &mut out),
                }
                let exact = Exact::new(&input);
                let error = precise::relative_error(out[0], &exact.outputs[at]) / (16.0 * f64::EPSILON);
                (error.is_nan() || error > 1.0 && error > 1.0 + exact.conditions()[at])
                    .then(|| format!("{}: {error} {} {}", describe(&input), out[0], exact.conditions()[at]))
            })
            .collect();
        assert!(broken.is_empty(), "{} {:#?}", broken.len(), &broken[..broken.len().min(12)]);
    }
}
