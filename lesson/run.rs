//! From the curriculum to a [`Report`]. The only place with a clock.

use crate::progress::Progress;
use crate::select::{Chosen, Selection};
use chapters::setting::{Kind, Setting, Value};
use chapters::vocabulary::{
    Bench, Bound, Check, Expects, Extreme, Heat, Lane, Race, SEED, Stress, digits, fitted_order, rms, sidak,
};
use rayon::prelude::*;
use std::hint::black_box;
use std::time::{Duration, Instant};
use views::report::derivation::{derive, state};
use views::report::*;
use yardstick::precise;

/// Runs `parts` of the `selection`: everything but the races in parallel, each race alone.
pub fn run(selection: &Selection, parts: Parts, progress: &Progress) -> Report {
    progress.expect(selection.steps.iter().map(|chosen| count(chosen, parts)).sum());
    let mut steps: Vec<StepReport> =
        selection.steps.par_iter().map(|chosen| judge_step(chosen, parts, progress)).collect();
    if parts.races {
        progress.reveal();
        for (chosen, step) in selection.steps.iter().zip(&mut steps) {
            step.races = run_races(chosen, progress);
        }
    }
    progress.end();
    report(selection, steps)
}

/// Groups steps by chapter and counts the verdicts.
fn report(selection: &Selection, steps: Vec<StepReport>) -> Report {
    let verdicts: Vec<Verdict> = steps.iter().flat_map(StepReport::verdicts).collect();
    let passed = verdicts.iter().filter(|verdict| **verdict == Verdict::Passed).count();
    let mut chapters: Vec<ChapterReport> = Vec::new();
    for (chosen, step) in selection.steps.iter().zip(steps) {
        if chapters.last().is_none_or(|chapter| chapter.id != chosen.chapter.id) {
            chapters.push(ChapterReport { id: chosen.chapter.id, title: chosen.chapter.title, steps: Vec::new() });
        }
        chapters.last_mut().expect("just pushed").steps.push(step);
    }
    let failed = verdicts.len() - passed;
    Report { schema: SCHEMA, version: env!("CARGO_PKG_VERSION"), machine: machine(), chapters, passed, failed }
}

fn count(chosen: &Chosen, parts: Parts) -> u64 {
    let step = chosen.step;
    let wanted = |ids: &mut dyn Iterator<Item = &'static str>| ids.filter(|id| chosen.wants(id)).count() as u64;
    let mut jobs = 0;
    if parts.checks {
        jobs += wanted(&mut step.derivations.iter().map(|item| item.id));
        jobs += wanted(&mut step.checks.iter().map(|item| item.id));
    }
    if parts.stress {
        jobs += wanted(&mut step.stress.iter().map(|item| item.id));
    }
    if parts.races {
        jobs += wanted(&mut step.races.iter().map(|item| item.id));
    }
    jobs
}

fn judge_step(chosen: &Chosen, parts: Parts, progress: &Progress) -> StepReport {
    let (step, setting, place) = (chosen.step, &chosen.setting, chosen.address());
    let at = |id: &str| format!("{place}/{id}");
    let statements = step.statements.iter().filter(|item| parts.checks && chosen.wants(item.id));
    let derivations = step.derivations.par_iter().filter(|item| parts.checks && chosen.wants(item.id));
    let checks = step.checks.par_iter().filter(|item| parts.checks && chosen.wants(item.id));
    let stress = step.stress.par_iter().filter(|item| parts.stress && chosen.wants(item.id));
    StepReport {
        title: step.title,
        says: step.says,
        rows: step.rows,
        setting: parameters(setting),
        readout: readout(chosen),
        statements: statements.map(|item| state(item, at(item.id))).collect(),
        derivations: derivations.map(|item| progress.during(at(item.id), |address| derive(item, address))).collect(),
        checks: checks.map(|item| progress.during(at(item.id), |address| check(item, setting, address))).collect(),
        stress: stress.map(|item| progress.during(at(item.id), |address| press(item, setting, address))).collect(),
        races: Vec::new(),
        figures: Vec::new(),
        address: place,
    }
}

fn parameters(setting: &Setting) -> Vec<ParameterReport> {
    let wavelength = setting.wavelength();
    let entries = setting.entries().map(|(parameter, text, value)| {
        let number = match value {
            Value::Number(number) => Some(Number(*number)),
            Value::Medium(_) | Value::Conductor(_) => None,
        };
        let index = match value {
            Value::Medium(medium) => medium.index(wavelength).ok(),
            Value::Number(_) | Value::Conductor(_) => None,
        };
        let unit = match parameter.kind {
            Kind::Number { unit, .. } => unit,
            Kind::Count { .. } => "1",
            Kind::Medium | Kind::ClearMedium => "1",
            // Three numbers, each with a unit of its own.
            Kind::Conductor => "",
        };
        ParameterReport {
            name: parameter.name,
            says: parameter.says,
            text: text.to_owned(),
            value: number,
            n: index.map(|index| Number(index.re)),
            k: index.map(|index| Number(index.im)),
            unit,
        }
    });
    entries.collect()
}

fn readout(chosen: &Chosen) -> Vec<QuantityReport> {
    let quantities = chosen.step.readout.map(|read| read(&chosen.setting)).unwrap_or_default();
    let report = quantities.into_iter().map(|quantity| QuantityReport {
        key: quantity.key,
        symbol: quantity.symbol,
        says: quantity.says,
        value: Number(quantity.value),
        unit: quantity.unit,
    });
    report.collect()
}

fn check(check: &Check, setting: &Setting, address: String) -> CheckReport {
    let started = Instant::now();
    let measured = (check.measure)(&mut Bench::new(setting, SEED, &address));
    let seconds = started.elapsed().as_secs_f64();
    let tests = chapters::statistical_checks();
    let words = views::report::limit;
    let (bound, limit, unit, why) = match check.bound {
        Bound::AtMost { limit, unit, why } => (format!("at most {} {unit}", words(limit)), limit, unit, why),
        Bound::Order { order, tolerance, why } => (expected_order(order, tolerance), order, "1", why),
        Bound::PValue { significance } => {
            let limit = sidak(significance, tests);
            (format!("p at least {}", short(limit)), limit, "1", "Šidák's share of the curriculum's significance")
        }
    };
    CheckReport {
        address,
        claim: check.claim,
        rows: check.rows,
        route: check.route,
        value: Number(measured.value),
        bound: bound.trim_end_matches(" 1").to_owned(),
        why,
        limit: Number(limit),
        unit,
        verdict: check.bound.admits(measured.value, tests).into(),
        at: measured.at,
        cases: measured.cases,
        seconds,
    }
}

fn press(stress: &Stress, setting: &Setting, address: String) -> StressReport {
    let started = Instant::now();
    let cases: Vec<CaseReport> = (stress.cases)(setting).iter().map(case).collect();
    // A family without members has shown nothing.
    let holds = !cases.is_empty() && cases.iter().all(|case| case.verdict == Verdict::Passed);
    StressReport {
        address,
        claim: stress.claim,
        rows: stress.rows,
        textbook: stress.textbook,
        reference: stress.reference,
        cases,
        verdict: holds.into(),
        seconds: started.elapsed().as_secs_f64(),
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

fn run_races(chosen: &Chosen, progress: &Progress) -> Vec<RaceReport> {
    let races = chosen.step.races.iter().filter(|race| chosen.wants(race.id));
    races
        .map(|race| progress.during(format!("{}/{}", chosen.address(), race.id), |at| run_race(race, chosen, at)))
        .collect()
}

fn run_race(race: &Race, chosen: &Chosen, address: String) -> RaceReport {
    let heats: usize = race.lanes.iter().map(|lane| lane.works.len()).sum();
    let patience = RACE_TIME / heats.max(1) as u32;
    let lanes = race.lanes.iter().filter(|lane| chosen.wants_lane(lane.id));
    RaceReport {
        lanes: lanes.map(|lane| run_lane(lane, chosen, format!("{address}/{}", lane.id), patience)).collect(),
        address,
        claim: race.claim,
        rows: race.rows,
        work: race.work,
        error: race.error,
        reference: race.reference,
    }
}

fn run_lane(lane: &Lane, chosen: &Chosen, address: String, patience: Duration) -> LaneReport {
    let mut points = Vec::new();
    for &work in lane.works {
        let (mut errors, mut seconds) = (Vec::new(), f64::INFINITY);
        let share = patience.min(HEAT_TIME) / lane.repeats.max(1);
        for mut heat in lane.heats(&chosen.setting, &address, work) {
            let (fastest, result) = time(&mut heat, share);
            seconds = seconds.min(fastest);
            errors.push((heat.error)(&result));
        }
        points.push(PointReport {
            work,
            error: Number(rms(&errors)),
            seconds,
            ns_per_work: seconds * 1e9 / work as f64,
        });
    }
    let curve: Vec<(f64, f64)> = points.iter().map(|point| (point.work as f64, point.error.0)).collect();
    LaneReport {
        address,
        label: lane.label,
        repeats: lane.repeats,
        points,
        order: fitted_order(&curve),
        expects: expectation(lane.expects),
        verdict: lane.expects.admits(&curve).into(),
        asserted: lane.expects,
    }
}

fn expectation(expects: Expects) -> String {
    match expects {
        Expects::Order { order, tolerance } => expected_order(order, tolerance),
        Expects::Within { limit, why } => format!("error at most {}: {why}", views::report::limit(limit)),
        Expects::Converges { last, why } => {
            format!("error falls at every point, to at most {}: {why}", views::report::limit(last))
        }
        Expects::Breaks { limit, why } => format!("error above {}: {why}", views::report::limit(limit)),
    }
}

fn expected_order(order: f64, tolerance: f64) -> String {
    format!("order {} ± {}", significant(order, 3), significant(tolerance, 3))
}

/// What all heats of one race may take together, as long as each runs once.
const RACE_TIME: Duration = Duration::from_millis(1500);
/// How long one heat is repeated, so that its fastest run is free of the machine's other business.
const HEAT_TIME: Duration = Duration::from_millis(20);
/// The shortest time that the clock resolves to about a percent.
const CLOCK_TIME: Duration = Duration::from_micros(5);

/// The time [s] of the fastest of as many runs as fit into `patience` (at least one), and what the last one returned.
fn time(heat: &mut Heat, patience: Duration) -> (f64, Vec<f64>) {
    let begun = Instant::now();
    let mut result = black_box((heat.run)());
    let first = begun.elapsed();
    // Runs shorter than the clock resolves are timed by the batch.
    let batch = (CLOCK_TIME.as_secs_f64() / first.as_secs_f64().max(1e-9)).ceil().max(1.0) as u32;
    let mut fastest = first.as_secs_f64();
    while begun.elapsed() < patience {
        let started = Instant::now();
        for _ in 0..batch {
            result = black_box((heat.run)());
        }
        fastest = fastest.min(started.elapsed().as_secs_f64() / f64::from(batch));
    }
    (fastest, result)
}

/// Where this program runs.
pub fn machine() -> Machine {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model =
        info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':')).map(|(_, name)| name.trim());
    Machine {
        cpu: model.unwrap_or("unknown").to_owned(),
        cores: std::thread::available_parallelism().map_or(1, usize::from),
        os: std::env::consts::OS,
        arch: std::env::consts::ARCH,
        profile: if cfg!(debug_assertions) { "debug" } else { "release" },
    }
}
