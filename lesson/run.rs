//! From the curriculum to a [`Report`]: threads, progress, and the clock that is lent to the judge.

use crate::progress::Progress;
use crate::select::{Chosen, Selection};
use chapters::judge::Clock;
use chapters::parameter::Setting;
use chapters::vocabulary::{Item, Part};
use chapters::{Chapter, Step};
use rayon::prelude::*;
use std::time::Instant;
use views::report::entry::{Entry, judge, unjudged, unread};
use views::report::*;

/// Runs `parts` of the `selection`: everything but the races in parallel, each race alone.
pub fn run(selection: &Selection, parts: Parts, progress: &Progress) -> Report {
    let clock = Watch::started();
    let (alone, together): (Vec<_>, Vec<_>) = items(selection, parts).into_iter().partition(|job| job.is_timed());
    let is_job = |job: &&Job| !matches!(job.item, Item::Statement(_) | Item::Question(_));
    progress.expect(alone.iter().chain(&together).filter(is_job).count() as u64);
    let mut found: Vec<(usize, Entry)> = together.par_iter().map(|job| job.run(&clock, progress)).collect();
    if parts.races {
        progress.reveal();
        found.extend(alone.iter().map(|job| job.run(&clock, progress)));
    }
    progress.end();
    let mut steps: Vec<StepReport> =
        selection.steps.iter().map(|chosen| unjudged(chosen.step, chosen.address(), &chosen.setting)).collect();
    found.into_iter().for_each(|(step, entry)| steps[step].enter(entry));
    report(selection, steps)
}

/// An item to be judged.
struct Job<'a> {
    /// Place of its step in the selection.
    step: usize,
    chosen: &'a Chosen,
    item: Item,
}

/// What `parts` of the `selection` ask for, in order.
fn items(selection: &Selection, parts: Parts) -> Vec<Job<'_>> {
    let mut jobs = Vec::new();
    for (step, chosen) in selection.steps.iter().enumerate() {
        // A question goes with what it is about, or is asked for by itself.
        let goes = |item: &Item| item.part().map_or(parts.checks || chosen.item.is_some(), |part| parts.has(part));
        let asked = |item: &Item| goes(item) && chosen.wants(item.id());
        jobs.extend(chosen.step.items().filter(asked).map(|item| Job { step, chosen, item }));
    }
    jobs
}

impl Job<'_> {
    /// Whether its seconds are what it is run for: nothing else may run meanwhile.
    fn is_timed(&self) -> bool {
        self.item.part() == Some(Part::Races)
    }

    fn run(&self, clock: &Watch, progress: &Progress) -> (usize, Entry) {
        let Chosen { step, setting, .. } = self.chosen;
        let address = format!("{}/{}", self.chosen.address(), self.item.id());
        let rows = step.rows_of(&self.item);
        let lanes = |id: &str| self.chosen.wants_lane(id);
        let judged = |address| judge(self.item, rows, setting, address, clock, &lanes);
        let entry = match self.item {
            Item::Statement(_) | Item::Question(_) => judged(address),
            _ => progress.during(address, judged),
        };
        (self.step, entry)
    }
}

/// A step of which only its equations are there.
pub fn stated(chapter: &Chapter, step: &'static Step, setting: &Setting) -> StepReport {
    let address = format!("{}/{}", chapter.id, step.id);
    let mut report = unread(step, address.clone(), setting);
    for item in step.items().filter(|item| matches!(item, Item::Statement(_))) {
        let place = format!("{address}/{}", item.id());
        report.enter(judge(item, step.rows_of(&item), setting, place, &Watch::started(), &|_| true));
    }
    report
}

/// A clock that started with the run.
pub struct Watch(Instant);

impl Watch {
    /// From now on.
    pub fn started() -> Self {
        Self(Instant::now())
    }
}

impl Clock for Watch {
    fn seconds(&self) -> Option<f64> {
        Some(self.0.elapsed().as_secs_f64())
    }
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
