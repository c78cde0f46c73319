//! A step as the reader holds it: what is known of it so far. [`page`] sets it, [`drawing`] keeps its pictures.

mod drawing;
mod page;

pub use page::{Name, Part};

use super::graphics::Ground;
use super::work::{Job, Order, Outcome, Source, Task, Which};
use crate::run;
use chapters::parameter::Setting;
use chapters::vocabulary::{Given, Question};
use chapters::{Chapter, Step};
use drawing::{Drawing, picture_rows};
use std::sync::Arc;
use views::block::Details;
use views::race_plot;
use views::report::entry::Entry;
use views::report::{StepReport, Verdict};
use views::tell::Evidence;

/// A step, and what is known of it.
pub struct Leaf {
    pub chapter: &'static Chapter,
    pub step: &'static Step,
    pub setting: Setting,
    /// How often the setting was changed.
    edition: u32,
    /// Its equations, once somebody has looked, its numbers, once they are there, and what was found.
    report: Option<StepReport>,
    /// The setting that its numbers belong to, by how often it was changed, and the one that they are asked for.
    read: (Option<u32>, Option<u32>),
    /// What was answered, question by question.
    pub answers: Vec<Option<Given>>,
    /// Whether the reader went on without answering.
    pub skipped: bool,
    folds: [Fold; 4],
    /// Verdicts on evidence at settings that are no longer: of how many things, and how many are broken.
    past: (usize, usize),
    /// Whether all figures are shown, not only the first.
    has_all_figures: bool,
    figures: Vec<Drawing>,
    plots: Vec<Drawing>,
}

/// A kind of evidence.
#[derive(Clone, Copy, Debug, Default)]
struct Fold {
    is_open: bool,
    state: State,
}

/// How far evidence is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum State {
    /// Nobody asked for it.
    #[default]
    Unknown,
    /// So many of its parts are done, of so many.
    Running(usize, usize),
    /// It is there.
    Found,
    /// Judging it failed.
    Lost,
}

/// How pages are set.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Columns of a page.
    pub width: usize,
    /// Rows of a page.
    pub height: usize,
    /// What pictures are made of.
    pub ground: Ground,
    /// The short way.
    pub short: bool,
    /// What is shown of derivations.
    pub details: Details,
}

impl Leaf {
    pub fn new(chapter: &'static Chapter, step: &'static Step, setting: Setting) -> Self {
        Self {
            chapter,
            step,
            setting,
            edition: 0,
            report: None,
            read: (None, None),
            answers: vec![None; step.questions.len()],
            skipped: false,
            folds: Default::default(),
            past: (0, 0),
            has_all_figures: false,
            figures: step.exhibit.figures.iter().map(|_| Drawing::default()).collect(),
            plots: step.races.iter().map(|_| Drawing::default()).collect(),
        }
    }

    /// `chapter/step`.
    pub fn address(&self) -> String {
        format!("{}/{}", self.chapter.id, self.step.id)
    }

    /// The question that waits for an answer before the rest is shown.
    pub fn asks(&self) -> Option<(usize, &'static Question)> {
        let open = self.answers.iter().position(Option::is_none).filter(|_| !self.skipped)?;
        Some((open, &self.step.questions[open]))
    }

    /// Whether a question was passed without an answer.
    pub fn has_passed(&self) -> bool {
        self.skipped && self.answers.iter().any(Option::is_none)
    }

    fn count(&self, kind: Evidence) -> usize {
        self.step.items().filter(|item| Evidence::of(item) == Some(kind)).count()
    }

    /// Unfolds evidence or folds it; what has to be judged for that, or that there is none.
    pub fn toggle(&mut self, kind: Evidence) -> Result<Option<Task>, String> {
        if self.count(kind) == 0 {
            return Err(format!("this step has no {}", kind.nouns().1));
        }
        let fold = &mut self.folds[kind as usize];
        fold.is_open = !fold.is_open;
        let needed = fold.is_open && matches!(fold.state, State::Unknown | State::Lost);
        Ok(needed.then(|| self.judge(kind)))
    }

    pub fn is_open(&self, kind: Evidence) -> bool {
        self.folds[kind as usize].is_open
    }

    fn judge(&mut self, kind: Evidence) -> Task {
        self.folds[kind as usize].state = State::Running(0, 0);
        let (chapter, step, setting, edition) = (self.chapter, self.step, self.setting.clone(), self.edition);
        Task::Judge { chapter, step, kind, setting, edition }
    }

    /// Whether something of it is being judged.
    pub fn is_busy(&self) -> bool {
        let drawn = self.figures.iter().chain(&self.plots);
        self.folds.iter().any(|fold| matches!(fold.state, State::Running(..)))
            || self.read.1.is_some()
            || drawn.into_iter().any(|drawing| drawing.asked.is_some())
    }

    /// How many verdicts there are, and how many of them are that something is broken.
    pub fn verdicts(&self) -> (usize, usize) {
        let stated = self.report.iter().flat_map(|report| &report.statements).map(|statement| statement.verdict);
        counted(self.judged(), stated)
    }

    /// Of the evidence alone, at all settings so far: equations hold at every one, and are counted once.
    fn judged(&self) -> (usize, usize) {
        // What could not be judged is broken.
        let lost = self.folds.iter().filter(|fold| fold.state == State::Lost).map(|_| Verdict::Failed);
        let found = self
            .report
            .iter()
            .flat_map(|report| Evidence::ALL.into_iter().flat_map(|kind| page::found(report, kind).0));
        counted(self.past, found.chain(lost))
    }

    /// Takes another setting: its numbers are there at once, what is unfolded is judged again.
    pub fn set(&mut self, setting: Setting) -> Vec<Task> {
        self.past = self.judged();
        self.setting = setting;
        self.edition += 1;
        // The old numbers stay until the new ones are there.
        let readout = self.report.take().map(|report| report.readout);
        self.report().readout = readout.unwrap_or_default();
        self.figures.iter_mut().for_each(|drawing| drawing.is_lost = false);
        // The plot of a race is of the setting that it was run at.
        self.plots.iter_mut().for_each(|drawing| *drawing = Drawing::default());
        let again = |kind: &Evidence| {
            self.folds[*kind as usize].state = State::Unknown;
            // A race is run for its seconds; whoever wants them at this setting asks again.
            self.folds[*kind as usize].is_open &= *kind != Evidence::Races;
            self.folds[*kind as usize].is_open
        };
        let open: Vec<Evidence> = Evidence::ALL.into_iter().filter(again).collect();
        open.into_iter().map(|kind| self.judge(kind)).collect()
    }

    /// What came of some work.
    pub fn take(&mut self, outcome: Outcome) {
        match outcome {
            Outcome::Progress { kind, edition, done, of } if edition == self.edition => {
                // Hands in parallel may tell of it in any order.
                let before = if let State::Running(before, _) = self.folds[kind as usize].state { before } else { 0 };
                self.folds[kind as usize].state = State::Running(done.max(before), of);
            }
            Outcome::Judged { kind, edition, found } if edition == self.edition => {
                self.folds[kind as usize].state = if found.is_some() { State::Found } else { State::Lost };
                found.into_iter().flatten().for_each(|entry| self.enter(entry));
            }
            // Of a setting that is no longer: what is there is as good, and what is wanted is asked for again.
            Outcome::Read { edition, .. } if edition != self.edition => self.read.1 = None,
            Outcome::Drawn { which: Which::Race(_), order, .. } if order.edition != self.edition => {}
            Outcome::Read { edition, readout } => {
                self.read = (Some(edition), None);
                self.report().readout = readout.unwrap_or_default();
            }
            Outcome::Drawn { which, order, drawn } => {
                let drawing = match which {
                    Which::Figure(at) => &mut self.figures[at],
                    Which::Race(at) => &mut self.plots[at],
                };
                drawing.asked = None;
                drawing.is_lost = drawn.is_none() && order.edition == self.edition;
                if let Some((plot, picture)) = drawn {
                    drawing.plot = Some((order.edition, plot));
                    drawing.picture = Some((order, picture));
                }
            }
            Outcome::Progress { .. } | Outcome::Judged { .. } => {}
        }
    }

    fn enter(&mut self, entry: Entry) {
        if let Entry::Race(race) = &entry {
            let at = self.step.races.iter().position(|own| race.address.ends_with(&format!("/{}", own.id)));
            if let Some(drawing) = at.map(|at| &mut self.plots[at]) {
                *drawing = Drawing {
                    plot: Some((self.edition, Arc::new(race_plot::plot(race)))),
                    asked: drawing.asked,
                    ..Drawing::default()
                };
            }
        }
        self.report().enter(entry);
    }

    /// Its equations and numbers, and what was found.
    fn report(&mut self) -> &mut StepReport {
        self.report.get_or_insert_with(|| run::stated(self.chapter, self.step, &self.setting))
    }

    /// The pictures on its page that are not there yet, or not as they should be.
    pub fn wanted(&mut self, place: usize, look: &Look) -> Vec<Job> {
        if self.asks().is_some() {
            return Vec::new();
        }
        let order = Order { edition: self.edition, columns: look.width, rows: picture_rows(look), ground: look.ground };
        let shown = self.shown_figures();
        let figures = self.step.exhibit.figures.iter().zip(&mut self.figures).take(shown).enumerate();
        let of_figures = figures.filter_map(|(at, (figure, drawing))| {
            let source = match &drawing.plot {
                Some((edition, plot)) if *edition == order.edition => Source::Plot(Arc::clone(plot)),
                _ => Source::Figure(figure, self.setting.clone()),
            };
            drawing.wants(order).then_some((Which::Figure(at), source))
        });
        let is_open = self.folds[Evidence::Races as usize].is_open;
        let of_races = self.plots.iter_mut().enumerate().filter_map(|(at, drawing)| {
            let (_, plot) = drawing.plot.as_ref().filter(|_| is_open)?;
            let source = Source::Plot(Arc::clone(plot));
            drawing.wants(order).then_some((Which::Race(at), source))
        });
        let draw = |(which, source)| Task::Draw { which, source, order };
        let mut tasks: Vec<Task> = of_figures.chain(of_races).map(draw).collect();
        if !look.short && self.step.readout.is_some() && self.read.0 != Some(self.edition) && self.read.1.is_none() {
            self.read.1 = Some(self.edition);
            tasks.insert(0, Task::Read { step: self.step, setting: self.setting.clone(), edition: self.edition });
        }
        tasks.into_iter().map(|task| Job { leaf: place, task }).collect()
    }

    /// How many of its figures are on the page.
    fn shown_figures(&self) -> usize {
        if self.has_all_figures { self.figures.len() } else { self.figures.len().min(1) }
    }

    /// Shows all its figures; whether some were folded away.
    pub fn unfold_figures(&mut self) -> bool {
        let folded = self.shown_figures() < self.figures.len();
        self.has_all_figures = true;
        folded
    }

    /// Nobody draws for this step any more.
    pub fn forget(&mut self) {
        self.read.1 = None;
        self.figures.iter_mut().chain(&mut self.plots).for_each(|drawing| drawing.asked = None);
    }
}

/// The key that unfolds evidence.
pub fn key(kind: Evidence) -> char {
    match kind {
        Evidence::Derivations => 'd',
        Evidence::Checks => 'e',
        Evidence::Extremes => 'x',
        Evidence::Races => 'r',
    }
}

/// Verdicts more: of how many things, and how many are broken.
fn counted(before: (usize, usize), verdicts: impl Iterator<Item = Verdict>) -> (usize, usize) {
    verdicts.fold(before, |(all, broken), verdict| (all + 1, broken + usize::from(verdict == Verdict::Failed)))
}
