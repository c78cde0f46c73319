//! How exercises and what became of them are told: to people and to scripts.

use super::shelf;
use super::verdict::{Found, Pushed, Verdict};
use super::vocabulary::{Exercise, Kind};
use crate::reader::bookmark::Memory;
use chapters::vocabulary::Bound;
use serde_json::{Value, json};
use views::block::Tone;
use views::number::{Number, limit, seventeen_digits, short};
use views::page::Page;

/// What says how the documents are laid out.
const SCHEMA: &str = "lesson/exercise/1";

/// All exercises, chapter by chapter.
pub fn list(memory: &Memory) -> String {
    let widest = shelf::all().map(|one| one.name.len()).max().unwrap_or(0);
    let (mut text, mut chapter) = (String::new(), "");
    let mut solved = 0;
    for exercise in shelf::all() {
        if exercise.chapter() != chapter {
            chapter = exercise.chapter();
            text += &format!("{}{chapter}\n", if text.is_empty() { "" } else { "\n" });
        }
        let is_solved = memory.exercises.get(exercise.name).is_some_and(|work| work.solved);
        solved += usize::from(is_solved);
        let mark = if is_solved { '✓' } else { '·' };
        text += &format!("  {mark} {:<widest$}  {}\n", exercise.name, exercise.says);
        text += &format!("    {:<widest$}  {}\n", "", exercise.step);
    }
    text + &format!("\n{solved} of {} solved; `lesson exercise start NAME` lays one out\n", shelf::all().count())
}

/// The same as one document.
pub fn list_json(memory: &Memory) -> String {
    let one = |exercise: &Exercise| {
        let work = memory.exercises.get(exercise.name).copied().unwrap_or_default();
        json!({
            "name": exercise.name,
            "says": exercise.says,
            "step": exercise.step,
            "checks": exercise.claims.iter().map(|claim| format!("{}/{}", exercise.step, claim.id)).collect::<Vec<_>>(),
            "stress": exercise.extremes.iter().map(|id| format!("{}/{id}", exercise.step)).collect::<Vec<_>>(),
            "signature": exercise.signature(),
            "takes": exercise.takes.iter().map(|one| json!({ "name": one.name, "unit": one.unit })).collect::<Vec<_>>(),
            "unit": exercise.gives.unit,
            "hints": exercise.files.hints().len(),
            "hints_seen": work.hints,
            "solved": work.solved,
        })
    };
    document(&json!({ "schema": SCHEMA, "exercises": shelf::all().map(one).collect::<Vec<_>>() }))
}

fn document(value: &Value) -> String {
    serde_json::to_string_pretty(value).expect("plain data") + "\n"
}

/// A call of the learner's function.
fn call(exercise: &Exercise, numbers: &[f64]) -> String {
    let mut at = 0;
    let argument = |taken: &super::vocabulary::Taken| {
        let of = numbers.get(at..at + taken.kind.numbers()).unwrap_or_default();
        at += taken.kind.numbers();
        let value =
            if taken.kind == Kind::Whole { of.first().map_or(String::new(), f64::to_string) } else { plain(of) };
        format!("{} = {value}{}", taken.name, unit(taken.unit))
    };
    let arguments: Vec<String> = exercise.takes.iter().map(argument).collect();
    format!("{}({})", exercise.function, arguments.join(", "))
}

fn unit(unit: &str) -> String {
    if unit == "1" { String::new() } else { format!(" {unit}") }
}

/// Numbers so that whoever types them gets the same.
fn plain(numbers: &[f64]) -> String {
    match numbers {
        [one] => format!("{one:?}"),
        several => format!("{several:?}"),
    }
}

/// What was allowed, and why.
fn allowed(found: &Found, limit_found: f64) -> String {
    match found.claim.head().bound {
        Bound::AtMost { limit: most, unit, why } => format!("at most {}{}: {why}", short(most), self::unit(unit)),
        Bound::Order { order, tolerance, why } => format!("order {order} ± {tolerance}: {why}"),
        Bound::PValue { .. } => format!("a p-value of at least {}", short(limit_found)),
    }
}

fn check(found: &Found) -> String {
    let head = found.claim.head();
    let mark = if found.holds() { '✓' } else { '✗' };
    let mut text = format!("  {mark} {}  {}\n    against {}\n", found.address, head.claim, head.route);
    text += &match &found.checked {
        None => "    its measurement cannot bear these numbers\n".to_owned(),
        Some(checked) => {
            let (measured, unit) = (
                &checked.measured,
                match head.bound {
                    Bound::AtMost { unit, .. } => self::unit(unit),
                    _ => String::new(),
                },
            );
            let value = format!("{}{unit} at {}", short(measured.value), measured.at);
            format!(
                "    found {value} (the worst of {})\n    allowed {}\n",
                measured.cases,
                allowed(found, checked.limit)
            )
        }
    };
    text
}

fn extremes(pushed: &Pushed) -> String {
    let mark = if pushed.holds() { '✓' } else { '✗' };
    let kept = pushed.cases.iter().filter(|case| case.holds()).count();
    let mut text = format!("  {mark} {}  {}\n", pushed.address, pushed.stress.claim);
    text += &format!("    {kept} of {} extreme cases keep the digits that they can\n", pushed.cases.len());
    let fallen = pushed.cases.iter().filter(|case| !case.holds());
    let worst = fallen.min_by(|one, other| one.digits(one.ours).total_cmp(&other.digits(other.ours)));
    if let Some(case) = worst {
        text += &format!(
            "    the worst: {} at {}: yours {:?} keeps {:.1} digits; right {}, error allowed {}\n",
            case.quantity,
            case.input,
            case.ours,
            case.digits(case.ours),
            seventeen_digits(&case.reference),
            limit(case.allowed()),
        );
    }
    text
}

/// What became of a learner's function.
pub fn verdict(exercise: &Exercise, verdict: &Verdict) -> String {
    let is_solved = verdict.is_solved(exercise);
    let mut text = format!("{}: {}\n", exercise.name, if is_solved { "solved" } else { "not solved" });
    if let Some((fault, asked)) = &verdict.fault {
        text += &format!("  {}\n  asked for {}\n", fault.says(), call(exercise, asked));
    }
    // What was measured of a function that fell silent says nothing of it.
    let is_told = |found: &&Found| verdict.fault.is_none() || found.holds();
    text += &verdict.checks.iter().filter(is_told).map(check).collect::<String>();
    if verdict.fault.is_none() {
        text += &verdict.extremes.iter().map(extremes).collect::<String>();
    }
    if let Some(worst) = verdict.worst.as_ref().filter(|_| verdict.fault.is_none()) {
        let unit = unit(exercise.gives.unit);
        text += &format!("\nFarthest off:\n  {}\n", call(exercise, &worst.asked));
        text += &format!("    yours  {}{unit}\n    right  {}{unit}\n", plain(&worst.yours), plain(&worst.right));
    }
    let [none, all] = verdict.no_numbers;
    if none > 0 && !is_solved {
        text += &format!("\n{none} of its {all} results are no numbers (NaN or infinite).\n");
    }
    if let Some(slip) = &verdict.slip {
        text += &format!("\nThese are the numbers of a known slip:\n  {slip}\n");
    } else if !is_solved && verdict.fault.is_none() {
        text += &format!("\nNo known slip gives these numbers. `lesson exercise hint {}` helps on.\n", exercise.name);
    }
    if !verdict.printed.is_empty() {
        let printed = String::from_utf8_lossy(&verdict.printed);
        let printed = printed.lines().take(12).map(|line| format!("  {}\n", clean(line)));
        text += &format!("\nIt printed:\n{}", printed.collect::<String>());
    }
    let [passed, failed] = verdict.counts(exercise);
    text + &format!("\n{passed} passed, {failed} failed\n")
}

/// Text on a page: as wide as that is, lines that go on drawn in, marks in their colours.
pub fn set(text: &str, mut page: Page) -> String {
    for line in text.lines() {
        let words = line.trim_start();
        let indent = line.len() - words.len();
        let mark = words.chars().next().filter(|mark| ['✓', '✗'].contains(mark)).map_or(0, char::len_utf8);
        let tone = if words.starts_with('✓') { Tone::Good } else { Tone::Bad };
        match words {
            "" => page.gap(),
            _ => page.wrap(indent, indent + 2, &[(tone, &words[..mark]), (Tone::Plain, &words[mark..])]),
        }
    }
    page.into_text()
}

/// Without what would move a terminal's cursor.
fn clean(line: &str) -> String {
    line.chars().take(120).map(|c| if c.is_control() { '·' } else { c }).collect()
}

/// The same as one document.
pub fn verdict_json(exercise: &Exercise, verdict: &Verdict) -> String {
    let word = |holds: bool| if holds { "passed" } else { "failed" };
    let numbers = |all: &[f64]| json!(all.iter().map(|x| Number(*x)).collect::<Vec<_>>());
    let check = |found: &Found| {
        let head = found.claim.head();
        let unit = match head.bound {
            Bound::AtMost { unit, .. } => unit,
            _ => "1",
        };
        let checked = found.checked.as_ref();
        json!({
            "address": found.address,
            "claim": head.claim,
            "route": head.route,
            "verdict": word(found.holds()),
            "value": checked.map(|checked| Number(checked.measured.value)),
            "at": checked.map(|checked| &checked.measured.at),
            "cases": checked.map(|checked| checked.measured.cases),
            "limit": checked.map(|checked| Number(checked.limit)),
            "unit": unit,
            "allowed": checked.map(|checked| allowed(found, checked.limit)),
        })
    };
    let stress = |pushed: &Pushed| {
        let case = |case: &chapters::vocabulary::Extreme| {
            json!({
                "input": case.input,
                "quantity": case.quantity,
                "yours": Number(case.ours),
                "right": seventeen_digits(&case.reference),
                "digits": case.digits(case.ours),
                "verdict": word(case.holds()),
            })
        };
        json!({
            "address": pushed.address,
            "claim": pushed.stress.claim,
            "verdict": word(pushed.holds()),
            "cases": pushed.cases.iter().map(case).collect::<Vec<_>>(),
        })
    };
    let worst = verdict.worst.as_ref().filter(|_| verdict.fault.is_none()).map(|worst| {
        json!({
            "call": call(exercise, &worst.asked),
            "asked": numbers(&worst.asked),
            "yours": numbers(&worst.yours),
            "right": numbers(&worst.right),
        })
    });
    let fault = verdict.fault.as_ref().map(|(fault, asked)| {
        json!({ "kind": fault.word(), "says": fault.says(), "call": call(exercise, asked), "asked": numbers(asked) })
    });
    let [passed, failed] = verdict.counts(exercise);
    document(&json!({
        "schema": SCHEMA,
        "name": exercise.name,
        "step": exercise.step,
        "solved": verdict.is_solved(exercise),
        "checks": verdict.checks.iter().map(check).collect::<Vec<_>>(),
        "stress": verdict.extremes.iter().map(stress).collect::<Vec<_>>(),
        "worst": worst,
        "no_numbers": verdict.no_numbers[0],
        "calls": verdict.no_numbers[1],
        "slip": verdict.slip,
        "fault": fault,
        "printed": String::from_utf8_lossy(&verdict.printed),
        "passed": passed,
        "failed": failed,
    }))
}
