//! What becomes of a learner's function: the chapter's own checks tried on it, and what it has in common with mistakes that
//! are known.

use super::formula::{Answers, Call, during};
use super::process::{Fault, Heard};
use super::vocabulary::Exercise;
use chapters::judge::{Checked, survives};
use chapters::parameter::Setting;
use chapters::vocabulary::{Claim, Extreme, Stress};
use chapters::{CURRICULUM, Step};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;

/// What was found of a learner's function.
pub struct Verdict {
    /// By the step's checks, in the exercise's order; not those that came after it fell silent.
    pub checks: Vec<Found>,
    /// By its extreme cases.
    pub extremes: Vec<Pushed>,
    /// Where its numbers are farthest from the program's.
    pub worst: Option<Worst>,
    /// How many of its numbers were none, of how many.
    pub no_numbers: [usize; 2],
    /// The mistake that gives the same numbers, and which idea it lacks.
    pub slip: Option<String>,
    /// Why it stopped answering, and what it had been asked then.
    pub fault: Option<(Fault, Vec<f64>)>,
    /// What it printed.
    pub printed: Vec<u8>,
}

/// A check tried on it.
pub struct Found {
    pub address: String,
    pub claim: &'static dyn Claim,
    /// None where the check could not bear its numbers.
    pub checked: Option<Checked>,
}

impl Found {
    /// Whether the check holds of it.
    pub fn holds(&self) -> bool {
        self.checked.as_ref().is_some_and(|checked| checked.holds)
    }
}

/// Extreme cases that it was pushed to.
pub struct Pushed {
    pub address: String,
    pub stress: &'static Stress,
    pub cases: Vec<Extreme>,
}

impl Pushed {
    /// Whether it stands them.
    pub fn holds(&self) -> bool {
        survives(&self.cases)
    }
}

/// A call whose results are not the program's.
pub struct Worst {
    pub asked: Vec<f64>,
    pub yours: Vec<f64>,
    pub right: Vec<f64>,
}

impl Verdict {
    /// How many of the exercise's checks and families of extreme cases hold, and how many do not.
    pub fn counts(&self, exercise: &Exercise) -> [usize; 2] {
        let held = self.checks.iter().filter(|found| found.holds()).count()
            + self.extremes.iter().filter(|pushed| pushed.holds()).count();
        [held, exercise.claims.len() + exercise.extremes.len() - held]
    }

    /// Whether all that the exercise asks for holds.
    pub fn is_solved(&self, exercise: &Exercise) -> bool {
        self.fault.is_none() && self.counts(exercise)[1] == 0
    }
}

/// The step of an exercise.
pub fn step(exercise: &Exercise) -> &'static Step {
    let steps = CURRICULUM.iter().flat_map(|chapter| chapter.steps.iter().map(move |step| (chapter.id, step)));
    let found = steps.into_iter().find(|(chapter, step)| format!("{chapter}/{}", step.id) == exercise.step);
    found.expect("tests hold exercises to steps that there are").1
}

/// The checks of its step that judge an exercise.
pub fn claims(exercise: &Exercise) -> impl Iterator<Item = &'static dyn Claim> {
    let step = step(exercise);
    let find = |id: &str| step.checks.iter().find(|claim| claim.head().id == id).copied();
    exercise.claims.iter().map(move |claim| find(claim.id).expect("tests hold exercises to checks that there are"))
}

/// Tries the function that `answers` know on all that the exercise asks for.
pub fn verdict(exercise: &Exercise, answers: Box<dyn Answers>, heard: &Mutex<Heard>) -> Verdict {
    let setting = Setting::defaults(step(exercise).parameters());
    let is_silent = || heard.lock().is_ok_and(|heard| heard.fault.is_some());
    let ((checks, extremes), answers, calls) = during(answers, || {
        let (mut checks, mut extremes) = (Vec::new(), Vec::new());
        for claim in claims(exercise) {
            if is_silent() {
                break;
            }
            let address = format!("{}/{}", exercise.step, claim.head().id);
            // Written for the program's own numbers, a check may refuse others in its own way.
            let tried = || exercise.formula.check(claim, &setting, &address);
            let checked = catch_unwind(AssertUnwindSafe(tried)).ok().flatten();
            checks.push(Found { address, claim, checked });
        }
        for stress in step(exercise).stress.iter().filter(|stress| exercise.extremes.contains(&stress.id)) {
            if is_silent() {
                break;
            }
            let address = format!("{}/{}", exercise.step, stress.id);
            let tried = || exercise.formula.stress(stress);
            let cases = catch_unwind(AssertUnwindSafe(tried)).ok().flatten().unwrap_or_default();
            extremes.push(Pushed { address, stress, cases });
        }
        (checks, extremes)
    });
    // Who answered ends here.
    drop(answers);
    let Heard { fault, printed } = heard.lock().map(|mut heard| std::mem::take(&mut *heard)).unwrap_or_default();
    let no_numbers = calls.iter().filter(|call| call.given.iter().any(|given| !given.is_finite())).count();
    let mut verdict =
        Verdict { checks, extremes, worst: None, no_numbers: [no_numbers, calls.len()], slip: None, fault, printed };
    if !verdict.is_solved(exercise) {
        verdict.worst = worst(exercise, &calls);
        verdict.slip = slip(exercise, &calls);
    }
    verdict
}

/// What the program's own formula gives.
fn right(exercise: &Exercise, asked: &[f64]) -> Option<Vec<f64>> {
    let claim = claims(exercise).next()?;
    exercise.formula.at(claim.subjects()[0], asked)
}

/// By how much results differ, over the larger part of what they should be; no number from a number is farthest.
fn distance(found: &[f64], right: &[f64]) -> f64 {
    let size = right.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let off = found.iter().zip(right).map(|(found, right)| match found.to_bits() == right.to_bits() {
        true => 0.0,
        false if found.is_nan() && right.is_nan() => 0.0,
        false => (found - right).abs(),
    });
    let off = off.map(|off| if off.is_nan() { f64::INFINITY } else { off }).fold(0.0, f64::max);
    if size > 0.0 && off > 0.0 { off / size } else { off }
}

fn worst(exercise: &Exercise, calls: &[Call]) -> Option<Worst> {
    let far = calls.iter().filter_map(|call| {
        let right = right(exercise, &call.asked)?;
        Some((distance(&call.given, &right), call, right))
    });
    let (off, call, right) = far.max_by(|one, other| one.0.total_cmp(&other.0))?;
    (off > 0.0).then(|| Worst { asked: call.asked.clone(), yours: call.given.clone(), right })
}

/// How near numbers are that come of one mistake: whatever way it is written.
const ALIKE: f64 = 1e-6;

/// The mistake whose numbers these are, all of them.
fn slip(exercise: &Exercise, calls: &[Call]) -> Option<String> {
    let is = |formula: &dyn Fn(&[f64]) -> Option<Vec<f64>>| {
        let alike = |call: &Call| formula(&call.asked).is_some_and(|slip| distance(&call.given, &slip) <= ALIKE);
        // Where it gives what is right, nothing can be told by it.
        let tells = |call: &Call| {
            let right = right(exercise, &call.asked);
            formula(&call.asked).zip(right).is_some_and(|(slip, right)| distance(&slip, &right) > ALIKE)
        };
        !calls.is_empty() && calls.iter().all(alike) && calls.iter().any(tells)
    };
    let planted = claims(exercise).zip(exercise.claims).find(|(claim, _)| {
        let of: &dyn Any = claim.subjects()[1];
        is(&|asked| exercise.formula.at(of, asked))
    });
    let planted = planted.map(|(claim, about)| format!("{}. {}", claim.head().slip, about.idea));
    planted.or_else(|| {
        let known = exercise.slips.iter().find(|known| is(&|asked| Some((known.formula)(asked))));
        known.map(|known| known.says.to_owned())
    })
}
