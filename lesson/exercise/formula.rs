//! The learner's function as a formula of the type that a check tries.
//!
//! Checks take plain functions, which carry nothing with them: the function that stands for the learner's asks whoever
//! answers on this thread.

use chapters::judge::{self, Checked};
use chapters::parameter::Setting;
use chapters::vocabulary::{Claim, Extreme, Stress};
use glam::DVec3;
use light::fields::tensor::Tensor;
use num_complex::Complex64;
use std::any::Any;
use std::cell::RefCell;
use std::marker::PhantomData;

/// Who knows what the learner's function gives.
pub trait Answers {
    /// What it gives for these numbers. Who cannot say gives none, now and from then on.
    fn answer(&mut self, numbers: &[f64]) -> Option<Vec<f64>>;
}

/// What the function was asked, and what it gave.
#[derive(Clone, Debug)]
pub struct Call {
    pub asked: Vec<f64>,
    pub given: Vec<f64>,
}

/// How many calls are remembered.
const REMEMBERED: usize = 20_000;

/// Who answers on a thread, and what has been heard.
struct Asked {
    answers: Box<dyn Answers>,
    is_silent: bool,
    calls: Vec<Call>,
}

thread_local! {
    static ASKED: RefCell<Option<Asked>> = const { RefCell::new(None) };
}

/// Does `job` while the learner's function is what `answers` says: what comes of it, who answered, and what was heard.
pub fn during<T>(answers: Box<dyn Answers>, job: impl FnOnce() -> T) -> (T, Box<dyn Answers>, Vec<Call>) {
    ASKED.set(Some(Asked { answers, is_silent: false, calls: Vec::new() }));
    let result = job();
    let Asked { answers, calls, .. } = ASKED.take().expect("put there before the job");
    (result, answers, calls)
}

/// What the learner's function gives; nothing where nobody answers.
fn asked(numbers: &[f64]) -> Vec<f64> {
    ASKED.with_borrow_mut(|asked| {
        let Some(asked) = asked.as_mut().filter(|asked| !asked.is_silent) else { return Vec::new() };
        let Some(given) = asked.answers.answer(numbers) else {
            asked.is_silent = true;
            return Vec::new();
        };
        if asked.calls.len() < REMEMBERED {
            asked.calls.push(Call { asked: numbers.to_vec(), given: given.clone() });
        }
        given
    })
}

fn one(numbers: &[f64]) -> f64 {
    asked(numbers).first().copied().unwrap_or(f64::NAN)
}

fn three(numbers: &[f64]) -> [f64; 3] {
    asked(numbers).try_into().unwrap_or([f64::NAN; 3])
}

/// A type of formula that a check tries.
pub trait Subject: Copy + Sync + 'static {
    /// The learner's function.
    const LEARNERS: Self;

    /// What a formula of the type gives for the numbers that the learner's function would be asked.
    fn at(self, numbers: &[f64]) -> Vec<f64>;
}

impl Subject for fn(f64) -> f64 {
    const LEARNERS: Self = |a| one(&[a]);

    fn at(self, x: &[f64]) -> Vec<f64> {
        vec![self(x[0])]
    }
}

impl Subject for fn(f64, f64) -> f64 {
    const LEARNERS: Self = |a, b| one(&[a, b]);

    fn at(self, x: &[f64]) -> Vec<f64> {
        vec![self(x[0], x[1])]
    }
}

impl Subject for fn(f64, f64, f64) -> f64 {
    const LEARNERS: Self = |a, b, c| one(&[a, b, c]);

    fn at(self, x: &[f64]) -> Vec<f64> {
        vec![self(x[0], x[1], x[2])]
    }
}

impl Subject for fn(f64, u32) -> f64 {
    const LEARNERS: Self = |a, n| one(&[a, f64::from(n)]);

    fn at(self, x: &[f64]) -> Vec<f64> {
        vec![self(x[0], x[1] as u32)]
    }
}

/// A tensor on its axes, by these.
impl Subject for fn(&Tensor) -> f64 {
    const LEARNERS: Self = |tensor| one(&[0, 1, 2].map(|axis| tensor.0[axis][axis]));

    fn at(self, x: &[f64]) -> Vec<f64> {
        vec![self(&Tensor::diagonal([x[0], x[1], x[2]]))]
    }
}

/// Phasors by their parts.
impl Subject for fn(Complex64, Complex64) -> f64 {
    const LEARNERS: Self = |a, b| one(&[a.re, a.im, b.re, b.im]);

    fn at(self, x: &[f64]) -> Vec<f64> {
        vec![self(Complex64::new(x[0], x[1]), Complex64::new(x[2], x[3]))]
    }
}

impl Subject for fn(DVec3, DVec3) -> DVec3 {
    const LEARNERS: Self = |a, b| three(&[a.x, a.y, a.z, b.x, b.y, b.z]).into();

    fn at(self, x: &[f64]) -> Vec<f64> {
        self(DVec3::new(x[0], x[1], x[2]), DVec3::new(x[3], x[4], x[5])).to_array().into()
    }
}

impl Subject for fn(f64, [f64; 3], [f64; 3]) -> f64 {
    const LEARNERS: Self = |a, v, w| one(&[a, v[0], v[1], v[2], w[0], w[1], w[2]]);

    fn at(self, x: &[f64]) -> Vec<f64> {
        vec![self(x[0], [x[1], x[2], x[3]], [x[4], x[5], x[6]])]
    }
}

/// A type of formula, whichever it is.
pub trait Formula: Sync {
    /// Tries a check on the learner's function; `None` if its subject is of another type.
    fn check(&self, claim: &dyn Claim, setting: &Setting, address: &str) -> Option<Checked>;

    /// Pushes the learner's function to extremes that can take one of the type.
    fn stress(&self, stress: &Stress) -> Option<Vec<Extreme>>;

    /// What a formula of the type gives for the numbers that the learner's function would be asked.
    fn at(&self, subject: &dyn Any, numbers: &[f64]) -> Option<Vec<f64>>;
}

/// The formulas of type `F`.
pub struct Of<F>(PhantomData<fn() -> F>);

impl<F> Of<F> {
    /// The one there is.
    pub const NEW: Self = Self(PhantomData);
}

impl<F: Subject> Formula for Of<F> {
    fn check(&self, claim: &dyn Claim, setting: &Setting, address: &str) -> Option<Checked> {
        judge::check_own(claim, &F::LEARNERS, setting, address)
    }

    fn stress(&self, stress: &Stress) -> Option<Vec<Extreme>> {
        judge::stress_own(stress, &F::LEARNERS)
    }

    fn at(&self, subject: &dyn Any, numbers: &[f64]) -> Option<Vec<f64>> {
        subject.downcast_ref::<F>().map(|formula| formula.at(numbers))
    }
}
