//! What takes its time, away from the keys: figures, checks, races.

use super::event::Event;
use super::graphics::Ground;
use crate::run::Watch;
use chapters::figure::Plot;
use chapters::parameter::Setting;
use chapters::vocabulary::{Figure, Item};
use chapters::{Chapter, Step};
use rayon::prelude::*;
use std::collections::VecDeque;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, RwLock};
use std::thread;
use views::block::Picture;
use views::report::QuantityReport;
use views::report::entry::{Entry, judge, readout};
use views::tell::Evidence;

/// Threads that draw and judge: one may be busy with something long while another draws what is looked at.
const HANDS: usize = 2;

/// Which picture of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The figure of this place among the step's.
    Figure(usize),
    /// The plot of the race of this place.
    Race(usize),
}

/// What a picture shows, and how large: two that are equal look the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Order {
    /// The setting, by how often it was changed.
    pub edition: u32,
    /// Columns at most.
    pub columns: usize,
    /// Rows to a panel.
    pub rows: usize,
    /// What it is made of.
    pub ground: Ground,
}

/// Where a picture comes from.
#[derive(Clone, Debug)]
pub enum Source {
    /// It has yet to be computed.
    Figure(&'static Figure, Setting),
    /// It is there and needs another size.
    Plot(Arc<Plot>),
}

/// Something to be done for a step.
#[derive(Debug)]
pub struct Job {
    /// The step's place in the lecture.
    pub leaf: usize,
    /// What is to be done.
    pub task: Task,
}

/// What is to be done.
#[derive(Debug)]
pub enum Task {
    /// A picture is drawn.
    Draw { which: Which, source: Source, order: Order },
    /// The step's quantities are computed.
    Read { step: &'static Step, setting: Setting, edition: u32 },
    /// Evidence is judged.
    Judge { chapter: &'static Chapter, step: &'static Step, kind: Evidence, setting: Setting, edition: u32 },
}

/// Work that is done, for a step.
#[derive(Debug)]
pub struct Finished {
    /// The step's place in the lecture.
    pub leaf: usize,
    /// What came of it.
    pub result: Outcome,
}

/// What came of some work.
#[derive(Debug)]
pub enum Outcome {
    /// A picture, or nothing if drawing it failed.
    Drawn { which: Which, order: Order, drawn: Option<(Arc<Plot>, Picture)> },
    /// The step's quantities, or nothing if computing them failed.
    Read { edition: u32, readout: Option<Vec<QuantityReport>> },
    /// So many parts of a kind of evidence are done.
    Progress { kind: Evidence, edition: u32, done: usize, of: usize },
    /// Everything that was found of a kind of evidence, in order; nothing if judging it failed.
    Judged { kind: Evidence, edition: u32, found: Option<Vec<Entry>> },
}

/// Those who do the work.
pub struct Crew {
    shared: Arc<Shared>,
}

struct Shared {
    queue: Mutex<Queue>,
    comes: Condvar,
    /// Races are timed: whoever runs one is alone.
    quiet: RwLock<()>,
}

#[derive(Default)]
struct Queue {
    jobs: VecDeque<Job>,
    /// Whether somebody judges: another hand must stay free for what is looked at.
    is_judging: bool,
}

impl Crew {
    /// Hands that send what they have done. They work until the program ends.
    pub fn hired(events: &Sender<Event>) -> Self {
        let shared = Arc::new(Shared { queue: Mutex::default(), comes: Condvar::new(), quiet: RwLock::new(()) });
        for _ in 0..HANDS {
            let (shared, events) = (Arc::clone(&shared), events.clone());
            thread::spawn(move || {
                loop {
                    let job = shared.next();
                    let is_judging = job.judges();
                    job.run(&shared.quiet, &events);
                    if is_judging {
                        shared.lock().is_judging = false;
                        shared.comes.notify_one();
                    }
                }
            });
        }
        Self { shared }
    }

    /// Something more to do, in place of what waits to be judged at a setting that is no longer.
    pub fn give(&self, job: Job) {
        let mut queue = self.shared.lock();
        if let Task::Judge { kind, .. } = job.task {
            let is_older =
                |old: &Job| old.leaf == job.leaf && matches!(old.task, Task::Judge { kind: its, .. } if its == kind);
            queue.jobs.retain(|old| !is_older(old));
        }
        queue.jobs.push_back(job);
        drop(queue);
        self.shared.comes.notify_one();
    }

    /// Pictures of other steps than this one need not be drawn.
    pub fn turn_to(&self, leaf: usize) {
        self.shared.lock().jobs.retain(|job| job.leaf == leaf || matches!(job.task, Task::Judge { .. }));
    }
}

impl Shared {
    fn lock(&self) -> MutexGuard<'_, Queue> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits for a job: numbers and pictures first, they are looked at; of what is judged one thing at a time.
    fn next(&self) -> Job {
        let mut queue = self.lock();
        loop {
            let looked_at = queue.jobs.iter().position(|job| !job.judges());
            let first = looked_at.or((!queue.is_judging).then_some(0));
            if let Some(job) = first.and_then(|first| queue.jobs.remove(first)) {
                queue.is_judging |= job.judges();
                return job;
            }
            queue = self.comes.wait(queue).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl Job {
    fn judges(&self) -> bool {
        matches!(self.task, Task::Judge { .. })
    }

    /// Does it. What fails in a chapter must not end the reader.
    fn run(self, quiet: &RwLock<()>, events: &Sender<Event>) {
        let leaf = self.leaf;
        // When nobody listens any more the program ends.
        let tell = |result| drop(events.send(Event::Done(Finished { leaf, result })));
        match self.task {
            Task::Draw { which, source, order } => {
                let _shared = quiet.read();
                let drawn = catch_unwind(AssertUnwindSafe(|| {
                    let plot = match source {
                        Source::Figure(figure, setting) => Arc::new((figure.plot)(&setting)),
                        Source::Plot(plot) => plot,
                    };
                    let picture = order.ground.picture(&plot, order.columns, order.rows);
                    (plot, picture)
                }));
                tell(Outcome::Drawn { which, order, drawn: drawn.ok() });
            }
            Task::Read { step, setting, edition } => {
                let _shared = quiet.read();
                let readout = catch_unwind(AssertUnwindSafe(|| readout(step, &setting)));
                tell(Outcome::Read { edition, readout: readout.ok() });
            }
            Task::Judge { chapter, step, kind, setting, edition } => {
                let told = |done, of| tell(Outcome::Progress { kind, edition, done, of });
                let found = catch_unwind(AssertUnwindSafe(|| {
                    if kind == Evidence::Races {
                        let _alone = quiet.write();
                        race(chapter, step, &setting, &told)
                    } else {
                        let _shared = quiet.read();
                        verdicts(chapter, step, kind, &setting, &told)
                    }
                }));
                tell(Outcome::Judged { kind, edition, found: found.ok() });
            }
        }
    }
}

fn items(step: &'static Step, kind: Evidence) -> Vec<Item> {
    step.items().filter(|item| Evidence::of(item) == Some(kind)).collect()
}

fn address(chapter: &Chapter, step: &Step, item: &Item) -> String {
    format!("{}/{}/{}", chapter.id, step.id, item.id())
}

fn verdicts(
    chapter: &'static Chapter,
    step: &'static Step,
    kind: Evidence,
    setting: &Setting,
    told: &(dyn Fn(usize, usize) + Sync),
) -> Vec<Entry> {
    let (items, done) = (items(step, kind), AtomicUsize::new(0));
    told(0, items.len());
    let judged = |item: &Item| {
        let place = address(chapter, step, item);
        let entry = judge(*item, step.rows_of(item), setting, place, &Watch::started(), &|_| true);
        told(done.fetch_add(1, Ordering::Relaxed) + 1, items.len());
        entry
    };
    items.par_iter().map(judged).collect()
}

/// Races one after the other; a lane that begins ends the one before.
fn race(chapter: &'static Chapter, step: &'static Step, setting: &Setting, told: &dyn Fn(usize, usize)) -> Vec<Entry> {
    let lanes = step.races.iter().map(|race| race.lanes.len()).sum();
    let begun = AtomicUsize::new(0);
    let run = |item: &Item| {
        let place = address(chapter, step, item);
        judge(*item, step.rows_of(item), setting, place, &Watch::started(), &|_| {
            told(begun.fetch_add(1, Ordering::Relaxed), lanes);
            true
        })
    };
    items(step, Evidence::Races).iter().map(run).collect()
}
