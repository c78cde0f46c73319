//! The one judge: program, tests, exercises, book and bindings ask it, and it alone decides what holds.
//!
//! It measures with the clock that it is lent; without one it judges all the same.

use crate::parameter::Setting;
use crate::vocabulary::{
    Bench, Bound, Claim, Derivation, Extreme, Given, Heat, Item, Lane, Measured, Question, Race, SEED, Statement,
    Stress, fitted_order,
};
use equation::derivation::{Chain, Hop, Verdict};
use equation::units::Mismatch;
use equation::{Dimension, Equation};
use std::any::Any;
use std::hint::black_box;
use yardstick::precise;
use yardstick::random::stream;
use yardstick::statistics::{rms, sidak};

/// What tells the time.
pub trait Clock: Sync {
    /// Seconds since some moment; `None` if nothing is to be timed.
    fn seconds(&self) -> Option<f64>;
}

/// A clock that tells no time: everything runs once.
#[derive(Clone, Copy, Debug, Default)]
pub struct Untimed;

impl Clock for Untimed {
    fn seconds(&self) -> Option<f64> {
        None
    }
}

/// What became of an item, and how long it took.
#[derive(Debug)]
pub struct Timed<T> {
    /// What was found.
    pub found: T,
    /// Time [s]; NaN without a clock.
    pub seconds: f64,
}

/// Does `job` and times it.
pub fn timed<T>(clock: &dyn Clock, job: impl FnOnce() -> T) -> Timed<T> {
    let begun = clock.seconds();
    let found = job();
    let seconds = clock.seconds().zip(begun).map_or(f64::NAN, |(now, begun)| now - begun);
    Timed { found, seconds }
}

/// An equation and the dimension of its sides.
#[derive(Debug)]
pub struct Stated {
    /// The equation.
    pub equation: Equation,
    /// The SI dimension of both sides, or how they differ.
    pub dimension: Result<Dimension, Mismatch>,
    /// Whether they must differ, because it is shown as a mistake.
    pub is_struck_out: bool,
}

/// A derivation with all its lines, and what became of each hop.
#[derive(Debug)]
pub struct Derived {
    /// The chain, completed by the lines that its author left out.
    pub chain: Chain,
    /// What became of each hop.
    pub hops: Vec<Hop>,
    /// How the units of a line disagree.
    pub mismatch: Option<Mismatch>,
}

/// A measurement and the limit that it was held against.
#[derive(Debug)]
pub struct Checked {
    /// The worst case.
    pub measured: Measured,
    /// What the bound comes to: a p-value's limit is its share of the curriculum's significance.
    pub limit: f64,
    /// Whether the bound is kept.
    pub holds: bool,
    /// Whether the measurement looked at what is set: if not, it is the same at any setting.
    pub reads_setting: bool,
}

/// One amount of work and what it bought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Units of work.
    pub work: u64,
    /// RMS error of the runs.
    pub error: f64,
    /// Time [s] of the fastest run; NaN without a clock.
    pub seconds: f64,
}

/// A lane's points.
#[derive(Debug)]
pub struct Raced {
    /// By growing work.
    pub points: Vec<Point>,
    /// p of error ∝ work^(−p), fitted.
    pub order: Option<f64>,
    /// Whether the errors do what is expected of them.
    pub holds: bool,
}

/// States an equation.
pub fn statement(statement: &Statement) -> Stated {
    let equation = (statement.equation)();
    Stated { dimension: equation.dimension(), equation, is_struck_out: statement.is_struck_out }
}

impl Stated {
    /// Whether both sides have one dimension; of what is struck out, whether they have not.
    pub fn holds(&self) -> bool {
        self.dimension.is_ok() != self.is_struck_out
    }
}

/// At how many points the hops of a derivation are compared.
const POINTS: usize = 16;

/// Every hop of `chain`, judged at points that its derivation's `address` names.
pub fn hops(chain: &Chain, address: &str) -> Vec<Hop> {
    chain.verify(POINTS, precise::BITS, &mut stream(SEED, address))
}

/// Whether a hop holds. Numbers that agree are evidence, but no proof: a line that is only so much is not derived.
pub fn hop_holds(verdict: &Verdict) -> bool {
    *verdict == Verdict::Proved
}

/// Follows a derivation.
pub fn derivation(derivation: &Derivation, address: &str) -> Derived {
    follow(&(derivation.chain)(), address)
}

/// Follows somebody's chain of lines: author's, finder's or learner's.
pub fn follow(chain: &Chain, address: &str) -> Derived {
    let chain = chain.complete();
    Derived { hops: hops(&chain, address), mismatch: chain.units().err(), chain }
}

impl Derived {
    /// Whether every hop is proved and every line has one unit. A chain of one line derives nothing.
    pub fn holds(&self) -> bool {
        self.mismatch.is_none() && !self.hops.is_empty() && self.hops.iter().all(|hop| hop_holds(&hop.verdict))
    }
}

impl Checked {
    /// Why `check` fell, if it did.
    pub fn fault(&self, check: &dyn Claim) -> Option<String> {
        let (head, measured) = (check.head(), &self.measured);
        (!self.holds).then(|| format!("{}: {measured} against {:?}", head.claim, head.bound))
    }
}

/// Tries a check on the program's own formula.
pub fn check(check: &dyn Claim, setting: &Setting, address: &str) -> Checked {
    let mut bench = Bench::new(setting, SEED, address);
    let measured = check.measure(&mut bench);
    checked(check, measured, &bench)
}

/// Tries a check on somebody's own formula, which must be of the type of the check's subject: `None` otherwise.
pub fn check_own(check: &dyn Claim, subject: &dyn Any, setting: &Setting, address: &str) -> Option<Checked> {
    let mut bench = Bench::new(setting, SEED, address);
    check.own(&mut bench, subject).map(|measured| checked(check, measured, &bench))
}

fn checked(check: &dyn Claim, measured: Measured, bench: &Bench) -> Checked {
    let tests = crate::statistical_checks();
    let bound = check.head().bound;
    let limit = match bound {
        Bound::AtMost { limit, .. } => limit,
        Bound::Order { order, .. } => order,
        Bound::PValue { significance } => sidak(significance, tests),
    };
    Checked { holds: bound.admits(measured.value, tests), limit, measured, reads_setting: bench.is_setting_read() }
}

/// Pushes to the extremes.
pub fn stress(stress: &Stress, setting: &Setting) -> Vec<Extreme> {
    (stress.cases)(setting)
}

/// Pushes somebody's own formula to the extremes: `None` if these take none, or none of its type.
pub fn stress_own(stress: &Stress, subject: &dyn Any) -> Option<Vec<Extreme>> {
    stress.own.and_then(|cases| cases(subject))
}

/// Whether extreme cases hold. A family without members has shown nothing.
pub fn survives(cases: &[Extreme]) -> bool {
    !cases.is_empty() && cases.iter().all(Extreme::holds)
}

/// What all heats of one race may take together [s], as long as each runs once.
const RACE_TIME: f64 = 1.5;
/// How long one heat is repeated [s], so that its fastest run is free of the machine's other business.
const HEAT_TIME: f64 = 0.02;

/// How long each heat of a race may be repeated [s].
pub fn patience(race: &Race) -> f64 {
    let heats: usize = race.lanes.iter().map(|lane| lane.works.len()).sum();
    (RACE_TIME / heats.max(1) as f64).min(HEAT_TIME)
}

/// Runs a lane over all its works, each heat as often as fits into `patience` [s] by the `clock`.
pub fn lane(lane: &Lane, setting: &Setting, address: &str, clock: &dyn Clock, patience: f64) -> Raced {
    let point = |&work: &u64| {
        let heats = lane.heats(setting, address, work).map(|mut heat| {
            let (seconds, result) = fastest(&mut heat, clock, patience / f64::from(lane.repeats.max(1)));
            (seconds, (heat.error)(&result))
        });
        let (seconds, errors): (Vec<f64>, Vec<f64>) = heats.unzip();
        let seconds = seconds.into_iter().fold(f64::NAN, f64::min);
        Point { work, error: rms(&errors), seconds }
    };
    let points: Vec<Point> = lane.works.iter().map(point).collect();
    let curve: Vec<(f64, f64)> = points.iter().map(|point| (point.work as f64, point.error)).collect();
    Raced { order: fitted_order(&curve), holds: lane.expects.admits(&curve), points }
}

/// The shortest time [s] that a clock is trusted to resolve to about a percent.
const RESOLVED: f64 = 5e-6;

/// The time [s] of the fastest of as many runs as fit into `patience` [s] (at least one), and what the last one returned.
fn fastest(heat: &mut Heat, clock: &dyn Clock, patience: f64) -> (f64, Vec<f64>) {
    let begun = clock.seconds();
    let mut result = black_box((heat.run)());
    let since = |earlier: Option<f64>| clock.seconds().zip(earlier).map_or(f64::NAN, |(now, earlier)| now - earlier);
    let first = since(begun);
    // Runs shorter than the clock resolves are timed by the batch.
    let batch = (RESOLVED / first.max(1e-9)).ceil().max(1.0) as u32;
    let mut fastest = first;
    while since(begun) < patience {
        let started = clock.seconds();
        for _ in 0..batch {
            result = black_box((heat.run)());
        }
        fastest = fastest.min(since(started) / f64::from(batch));
    }
    (fastest, result)
}

/// Whether the right answer of a question is one that can be given, and is taken.
pub fn question(question: &Question, setting: &Setting) -> bool {
    let right = question.right(setting);
    let can_be_given = match right {
        Given::Option(at) => at < question.options().len(),
        Given::Number(x) => x.is_finite(),
    };
    can_be_given && question.reply(setting, right).right
}

/// What became of any item that is judged, and why it fell if it did. Every lane of a race runs; a figure is judged by
/// whoever looks at it.
pub fn holds(item: Item, setting: &Setting, address: &str) -> Result<(), String> {
    match item {
        Item::Statement(item) => match statement(item) {
            found if found.holds() => Ok(()),
            Stated { dimension: Err(mismatch), .. } => Err(mismatch.to_string()),
            Stated { dimension: Ok(unit), .. } => Err(format!("struck out, but both sides are in {unit}")),
        },
        Item::Question(item) => match question(item, setting) {
            true => Ok(()),
            false => Err(format!("its right answer is none: {:?}", item.right(setting))),
        },
        Item::Derivation(item) => {
            let found = derivation(item, address);
            match found.hops.iter().find(|hop| !hop_holds(&hop.verdict)) {
                _ if found.holds() => Ok(()),
                Some(hop) => Err(format!("line {} by {:?}: {:?}", hop.line, hop.by, hop.verdict)),
                None => Err(found.mismatch.map_or("one line derives nothing".into(), |mismatch| mismatch.to_string())),
            }
        }
        Item::Check(item) => {
            let found = check(item, setting, address);
            found.fault(item).map_or(Ok(()), Err)
        }
        Item::Stress(item) => fallen(&stress(item, setting)),
        Item::Race(item) => {
            item.lanes.iter().try_for_each(|one| keeps(item, one, setting, &format!("{address}/{}", one.id)))
        }
        Item::Figure(_) => Ok(()),
    }
}

/// Whether a lane's errors do what is expected of them, untimed.
pub fn keeps(race: &Race, one: &Lane, setting: &Setting, address: &str) -> Result<(), String> {
    let found = lane(one, setting, address, &Untimed, 0.0);
    let points = || found.points.iter().map(|point| (point.work, point.error)).collect::<Vec<_>>();
    found.holds.then_some(()).ok_or_else(|| format!("{}: {:?} against {:?}", race.claim, points(), one.expects))
}

/// The extreme cases that fell.
fn fallen(cases: &[Extreme]) -> Result<(), String> {
    if survives(cases) {
        return Ok(());
    }
    let fallen = cases.iter().filter(|case| !case.holds()).map(|case| {
        let (digits, allowed) = (case.digits(case.ours), case.allowed());
        let Extreme { quantity, input, ours, .. } = case;
        format!("{quantity} at {input}: {ours:e} keeps {digits:.1} digits, error allowed {allowed:.1e}")
    });
    let fallen: Vec<String> = fallen.collect();
    let shown = &fallen[..fallen.len().min(5)];
    Err(format!("{} of {} cases: {}", fallen.len(), cases.len(), shown.join("\n")))
}

/// Whether an item's planted mistake is caught; `None` if nothing is planted in an item of its kind.
pub fn can_fail(item: Item, setting: &Setting, address: &str) -> Option<Result<(), String>> {
    match item {
        Item::Derivation(item) => Some(is_refused(item, address)),
        Item::Check(item) => Some(is_caught(item, setting, address)),
        Item::Stress(item) => {
            let bites = stress(item, setting).iter().any(Extreme::textbook_breaks);
            Some(bites.then_some(()).ok_or_else(|| "the textbook form survives every case: this shows nothing".into()))
        }
        Item::Question(item) => Some(is_wrong(item, setting)),
        Item::Statement(_) | Item::Race(_) | Item::Figure(_) => None,
    }
}

fn is_refused(derivation: &Derivation, address: &str) -> Result<(), String> {
    let hops = hops(&(derivation.spoiled)(), address);
    let (refuted, others): (Vec<_>, Vec<_>) =
        hops.iter().partition(|hop| matches!(&hop.verdict, Verdict::Refuted { at, .. } if !at.is_empty()));
    // What is not the slip must stand, or it would be refused for another reason.
    let caught = !refuted.is_empty() && others.iter().all(|hop| hop_holds(&hop.verdict));
    caught.then_some(()).ok_or_else(|| format!("the planted mistake passed ({}): {hops:?}", derivation.slip))
}

fn is_caught(check: &dyn Claim, setting: &Setting, address: &str) -> Result<(), String> {
    let mut bench = Bench::new(setting, SEED, address);
    let measured = check.spoiled(&mut bench);
    let Checked { holds, measured, .. } = checked(check, measured, &bench);
    let head = check.head();
    match holds {
        true => Err(format!("the planted mistake passed ({}): {measured} against {:?}", head.slip, head.bound)),
        // A mistake that computes nothing would break the bound for the wrong reason.
        false if measured.cases == 0 => Err("the planted mistake measured nothing".into()),
        false => Ok(()),
    }
}

fn is_wrong(question: &Question, setting: &Setting) -> Result<(), String> {
    let Some(slip) = question.slip(setting) else { return Err("no mistake is planted".into()) };
    match question.reply(setting, slip) {
        reply if reply.right => Err(format!("the planted mistake passed: {slip:?}")),
        reply if reply.says.is_empty() => Err(format!("nothing is said to the planted mistake: {slip:?}")),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vocabulary::{Check, check as claim};

    type Formula = fn(f64) -> f64;

    const SQUARE: Check<Formula> = claim("square", "the square of 3 is 9")
        .against("counting")
        .within(0.0, "1", "whole numbers")
        .of(of_three, |x| x * x)
        .slip("doubled", |x| 2.0 * x);

    fn of_three(_: &mut Bench, formula: Formula) -> Measured {
        Measured::worst([(formula(3.0) - 9.0, "3".to_owned())])
    }

    #[test]
    fn truth_slip_and_a_learners_formula_are_judged_alike() {
        let setting = Setting::defaults(&[]);
        assert!(check(&SQUARE, &setting, "a/b/square").holds);
        assert_eq!(can_fail(Item::Check(&SQUARE), &setting, "a/b/square"), Some(Ok(())));
        let own = |formula: &dyn Any| check_own(&SQUARE, formula, &setting, "a/b/square").map(|found| found.holds);
        let (right, wrong): (Formula, Formula) = (|x| x.powi(2), |x| x.powi(3));
        assert_eq!([own(&right), own(&wrong)], [Some(true), Some(false)]);
        // Of another type: not judged at all, rather than wrongly.
        assert_eq!(own(&3.0_f64), None);
    }

    #[test]
    fn it_is_known_which_checks_look_at_what_is_set() {
        const SET: Check<Formula> = claim("set", "nothing is set")
            .against("counting")
            .within(0.0, "1", "whole numbers")
            .of(of_all_set, |x| x)
            .slip("one more", |x| x + 1.0);
        fn of_all_set(bench: &mut Bench, formula: Formula) -> Measured {
            let count = bench.setting().entries().count();
            Measured::worst([(formula(count as f64), "all".to_owned())])
        }
        let setting = Setting::defaults(&[]);
        assert!(check(&SET, &setting, "a/b/set").reads_setting);
        assert!(!check(&SQUARE, &setting, "a/b/square").reads_setting);
        // Of the curriculum some do, and most do not.
        let step = crate::fresnel::CHAPTER.steps.iter().find(|step| step.id == "brewster").expect("there");
        let setting = Setting::defaults(step.parameters());
        assert!(step.checks.iter().any(|one| check(*one, &setting, "fresnel/brewster").reads_setting));
    }
}
