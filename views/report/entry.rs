//! What the judge found, as a report.

use super::derivation::{Rows, derive, state};
use super::*;
use chapters::judge::{self, Checked, Clock, Raced, Timed, timed};
use chapters::parameter::{Setting, Value};
use chapters::vocabulary::{
    Answer, Bound, Claim, Expects, Extreme, Given, Item, Lane, Question, Race, Step, Stress, digits,
};
use yardstick::precise;

/// The report of one item.
#[derive(Debug)]
pub enum Entry {
    /// An equation.
    Statement(StatementReport),
    /// A question.
    Question(QuestionReport),
    /// A derivation.
    Derivation(DerivationReport),
    /// A check.
    Check(CheckReport),
    /// Extreme cases.
    Stress(StressReport),
    /// A race.
    Race(RaceReport),
    /// A figure, which is drawn, not judged.
    Figure,
}

/// A step of which nothing is judged yet: its setting and its readout.
pub fn unjudged(step: &Step, address: String, setting: &Setting) -> StepReport {
    StepReport { readout: readout(step, setting), ..unread(step, address, setting) }
}

/// A step of which not even its readout is there, which may take a while.
pub fn unread(step: &Step, address: String, setting: &Setting) -> StepReport {
    StepReport {
        address,
        title: step.title,
        says: step.says,
        rows: step.rows,
        setting: parameters(setting),
        readout: Vec::new(),
        statements: Vec::new(),
        questions: Vec::new(),
        derivations: Vec::new(),
        checks: Vec::new(),
        stress: Vec::new(),
        races: Vec::new(),
        figures: Vec::new(),
    }
}

impl StepReport {
    /// Takes in what was found of an item.
    pub fn enter(&mut self, entry: Entry) {
        match entry {
            Entry::Statement(found) => self.statements.push(found),
            Entry::Question(found) => self.questions.push(found),
            Entry::Derivation(found) => self.derivations.push(found),
            Entry::Check(found) => self.checks.push(found),
            Entry::Stress(found) => self.stress.push(found),
            Entry::Race(found) => self.races.push(found),
            Entry::Figure => {}
        }
    }
}

/// Has `item` judged at the `setting`. Of a race only the lanes that are `wanted` run.
pub fn judge(
    item: Item,
    rows: Rows,
    setting: &Setting,
    address: String,
    clock: &dyn Clock,
    wanted: &dyn Fn(&str) -> bool,
) -> Entry {
    match item {
        Item::Statement(item) => Entry::Statement(state(item, judge::statement(item), rows, address)),
        Item::Question(item) => Entry::Question(ask(item, setting, address)),
        Item::Derivation(item) => {
            let found = judge::derivation(item, &address);
            Entry::Derivation(derive(item, found, rows, address))
        }
        Item::Check(item) => {
            let found = timed(clock, || judge::check(item, setting, &address));
            Entry::Check(check(item, found, rows, address))
        }
        Item::Stress(item) => {
            let found = timed(clock, || judge::stress(item, setting));
            Entry::Stress(press(item, found, rows, address))
        }
        Item::Race(item) => Entry::Race(race(item, setting, rows, address, clock, wanted)),
        Item::Figure(_) => Entry::Figure,
    }
}

fn parameters(setting: &Setting) -> Vec<ParameterReport> {
    let wavelength = setting.wavelength();
    let entries = setting.entries().map(|(parameter, text, value)| {
        let index = match value {
            Value::Medium(medium) => medium.index(wavelength).ok(),
            _ => None,
        };
        ParameterReport {
            name: parameter.name,
            symbol: parameter.symbol,
            says: parameter.says,
            text: text.into_owned(),
            value: if let Value::Number(number) = value { Some(Number(*number)) } else { None },
            n: index.map(|index| Number(index.re)),
            k: index.map(|index| Number(index.im)),
            unit: parameter.kind.unit(),
            default: parameter.default,
            domain: parameter.kind.describe(),
        }
    });
    entries.collect()
}

/// The step's quantities at a setting.
pub fn readout(step: &Step, setting: &Setting) -> Vec<QuantityReport> {
    let quantities = step.readout.map(|read| read(setting)).unwrap_or_default();
    let report = quantities.into_iter().map(|quantity| QuantityReport {
        key: quantity.key,
        symbol: quantity.symbol,
        says: quantity.says,
        value: Number(quantity.value),
        unit: quantity.unit,
    });
    report.collect()
}

/// What a question asks, what may be answered, and what is said to each answer.
pub fn ask(question: &Question, setting: &Setting, address: String) -> QuestionReport {
    let right = question.right(setting);
    let options = question.options().into_iter().enumerate().map(|(at, says)| {
        let reply = question.reply(setting, Given::Option(at));
        OptionReport { says, right: reply.right, reply: reply.says }
    });
    let (number, unit, tolerance) = match (question.answer, right) {
        (Answer::Number { unit, tolerance, .. }, Given::Number(number)) => {
            (Some(Number(number)), unit, Some(tolerance))
        }
        _ => (None, "", None),
    };
    QuestionReport {
        address,
        asks: question.asks,
        options: options.collect(),
        number,
        unit,
        tolerance,
        because: question.because,
        verdict: judge::question(question, setting).into(),
    }
}

fn check(check: &dyn Claim, found: Timed<Checked>, rows: Rows, address: String) -> CheckReport {
    let Timed { found: Checked { measured, limit, holds, .. }, seconds } = found;
    let head = check.head();
    let words = super::limit;
    let (bound, unit, why) = match head.bound {
        Bound::AtMost { unit, why, .. } => (format!("at most {} {unit}", words(limit)), unit, why),
        Bound::Order { order, tolerance, why } => (expected_order(order, tolerance), "1", why),
        Bound::PValue { .. } => {
            (format!("p at least {}", short(limit)), "1", "Šidák's share of the curriculum's significance")
        }
    };
    CheckReport {
        address,
        claim: head.claim,
        rows,
        route: head.route,
        value: Number(measured.value),
        bound: bound.trim_end_matches(" 1").to_owned(),
        why,
        limit: Number(limit),
        unit,
        verdict: holds.into(),
        at: measured.at,
        cases: measured.cases,
        picture: measured.picture.filter(|_| !holds),
        seconds,
    }
}

fn press(stress: &Stress, found: Timed<Vec<Extreme>>, rows: Rows, address: String) -> StressReport {
    StressReport {
        address,
        claim: stress.claim,
        rows,
        textbook: stress.textbook,
        reference: stress.reference,
        verdict: judge::survives(&found.found).into(),
        cases: found.found.iter().map(case).collect(),
        seconds: found.seconds,
    }
}

fn case(extreme: &Extreme) -> CaseReport {
    CaseReport {
        input: extreme.input.clone(),
        quantity: extreme.quantity,
        reference: seventeen_digits(&extreme.reference),
        textbook: Number(extreme.textbook),
        ours: Number(extreme.ours),
        textbook_digits: extreme.digits(extreme.textbook),
        our_digits: extreme.digits(extreme.ours),
        allowed_digits: digits(extreme.allowed()),
        condition: Number(extreme.condition),
        worst_of: extreme.worst_of,
        vanishes: extreme.reference == precise::real(0.0),
        verdict: extreme.holds().into(),
    }
}

fn race(
    race: &Race,
    setting: &Setting,
    rows: Rows,
    address: String,
    clock: &dyn Clock,
    wanted: &dyn Fn(&str) -> bool,
) -> RaceReport {
    let patience = judge::patience(race);
    let lanes = race.lanes.iter().filter(|lane| wanted(lane.id)).map(|lane| {
        let address = format!("{address}/{}", lane.id);
        let found = judge::lane(lane, setting, &address, clock, patience);
        run(lane, found, address)
    });
    RaceReport {
        lanes: lanes.collect(),
        address,
        claim: race.claim,
        rows,
        work: race.work,
        error: race.error,
        reference: race.reference,
    }
}

fn run(lane: &Lane, found: Raced, address: String) -> LaneReport {
    let points = found.points.iter().map(|point| PointReport {
        work: point.work,
        error: Number(point.error),
        seconds: point.seconds,
        ns_per_work: point.seconds * 1e9 / point.work as f64,
    });
    LaneReport {
        address,
        label: lane.label,
        repeats: lane.repeats,
        points: points.collect(),
        order: found.order,
        expects: expectation(lane.expects),
        verdict: found.holds.into(),
        asserted: lane.expects,
    }
}

fn expectation(expects: Expects) -> String {
    match expects {
        Expects::Order { order, tolerance } => expected_order(order, tolerance),
        Expects::Within { limit: most, why } => format!("error at most {}: {why}", limit(most)),
        Expects::Converges { last, why } => format!("error falls at every point, to at most {}: {why}", limit(last)),
        Expects::Breaks { limit: most, why } => format!("error above {}: {why}", limit(most)),
    }
}

fn expected_order(order: f64, tolerance: f64) -> String {
    format!("order {} ± {}", significant(order, 3), significant(tolerance, 3))
}
