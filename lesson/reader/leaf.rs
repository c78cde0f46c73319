//! A step as the reader holds it: what is known of it so far, and how it is set.

use super::work::{Job, Order, Outcome, Source, Task, Which};
use crate::run;
use chapters::figure::Plot;
use chapters::parameter::Setting;
use chapters::text::Phrase;
use chapters::vocabulary::{Given, Question};
use chapters::{Chapter, Step};
use std::sync::Arc;
use views::block::{Block, Cells, Details, Picture, Span, Tone};
use views::page::{Page, Row};
use views::race_plot;
use views::report::entry::{Entry, ask};
use views::report::{StepReport, Verdict};
use views::tell::{Evidence, Teller};
use views::terminal;

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

/// A picture that is drawn somewhere else.
#[derive(Default)]
struct Drawing {
    plot: Option<(u32, Arc<Plot>)>,
    cells: Option<(Order, Cells)>,
    asked: Option<Order>,
    /// Whether the last attempt failed.
    is_lost: bool,
}

/// How pages are set.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Columns of a page.
    pub width: usize,
    /// Rows of a page.
    pub height: usize,
    /// Whether there are colours.
    pub is_coloured: bool,
    /// The short way.
    pub short: bool,
    /// What is shown of derivations.
    pub details: Details,
}

/// What a part of a page is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    Head,
    Question(usize),
    Text,
    Formulas,
    Numbers,
    Figure(usize),
    Menu,
    Evidence(Evidence),
}

/// Rows that belong together.
#[derive(Clone, Debug)]
pub struct Part {
    pub name: Name,
    /// Whether a page should not begin or end inside it, if it fits on one.
    pub is_whole: bool,
    pub rows: Vec<Row>,
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
        let verdicts = self.report.iter().flat_map(StepReport::verdicts);
        // What could not be judged is broken.
        let lost = self.folds.iter().filter(|fold| matches!(fold.state, State::Lost)).count();
        verdicts
            .fold((lost, lost), |(all, broken), verdict| (all + 1, broken + usize::from(verdict == Verdict::Failed)))
    }

    /// Takes another setting: its numbers are there at once, what is unfolded is judged again.
    pub fn set(&mut self, setting: Setting) -> Vec<Task> {
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
                if let Some((plot, cells)) = drawn {
                    drawing.plot = Some((order.edition, plot));
                    drawing.cells = Some((order, cells));
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
        let order = Order { edition: self.edition, columns: look.width, rows: picture_rows(look) };
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
        let draw = |(which, source)| Task::Draw { which, source, order, is_coloured: look.is_coloured };
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

    /// The page as it is now, part by part.
    pub fn parts(&mut self, look: &Look) -> Vec<Part> {
        self.report();
        let report = self.report.as_ref().expect("just made");
        let teller = Teller::english(look.details);
        let mut parts = Parts { width: look.width, parts: Vec::new() };
        let is_first = self.chapter.steps.first().is_some_and(|first| first.id == self.step.id);
        let chapter = if is_first && !look.short { teller.chapter(self.chapter) } else { Vec::new() };
        parts.add(Name::Head, false, &[chapter, vec![Block::section(teller.head(report))]].concat());
        let asks = self.asks();
        for (at, question) in self.step.questions.iter().enumerate() {
            let is_next = asks.is_some_and(|(open, _)| open == at);
            if self.answers[at].is_some() || is_next {
                parts.add(Name::Question(at), true, &self.question(&teller, report, at, question));
            }
            if is_next {
                return parts.parts;
            }
        }
        if look.short {
            parts.add(Name::Text, false, &Vec::from_iter(teller.beginning(self.chapter, self.step, report)));
            parts.add(Name::Formulas, true, &Vec::from_iter(teller.key(report)));
        } else {
            parts.add(Name::Text, false, &[Block::section(teller.text(self.chapter, self.step, report))]);
            parts.add(Name::Formulas, false, &teller.formulas(report));
        }
        for (at, question) in self.step.questions.iter().enumerate().filter(|(at, _)| self.answers[*at].is_none()) {
            parts.add(Name::Question(at), true, &self.question(&teller, report, at, question));
        }
        if !look.short {
            let mut numbers = vec![teller.numbers(report)];
            if self.read.1.is_some() && report.readout.is_empty() {
                numbers.push(Block::text(4, Tone::Dim, Phrase::verbatim("computing …")));
            }
            parts.add(Name::Numbers, false, &[Block::Group(numbers)]);
        }
        let shown = self.shown_figures();
        for (at, figure) in self.step.exhibit.figures.iter().enumerate().take(shown) {
            let picture = Picture::Cells(self.figures[at].shown(look, self.edition));
            parts.add(Name::Figure(at), true, &[teller.shown(report, figure, picture)]);
        }
        parts.add(Name::Menu, true, &[self.menu(report)]);
        for kind in Evidence::ALL.into_iter().filter(|kind| self.is_open(*kind)) {
            let blocks = self.evidence(&teller, report, kind, look);
            parts.add(Name::Evidence(kind), false, &blocks);
        }
        parts.parts
    }

    fn question(&self, teller: &Teller, report: &StepReport, at: usize, question: &Question) -> Vec<Block> {
        let address = format!("{}/{}", report.address, question.id);
        let asked = ask(question, &self.setting, address.clone());
        let mut blocks = Vec::new();
        if self.answers[at].is_none() && !self.skipped {
            blocks.extend(teller.setting(report));
        }
        blocks.push(teller.question(&views::report::QuestionReport { address: String::new(), ..asked }, false));
        let note = |tone, text: String| Block::text(4, tone, Phrase::verbatim(text));
        let options = question.options();
        match self.answers[at] {
            Some(given) => {
                let said = match given {
                    Given::Option(at) => format!("{})", at + 1),
                    Given::Number(number) => views::number::value(number, unit(question)),
                };
                blocks.push(note(Tone::Dim, format!("Your answer: {said}")));
                blocks.push(teller.reply(&address, question.reply(&self.setting, given)));
            }
            None if self.skipped => blocks.push(note(Tone::Dim, "a answers it".into())),
            None if options.is_empty() => {
                blocks.push(note(Tone::Dim, "Type a number, or press space to go on without.".into()))
            }
            None => blocks.push(note(Tone::Dim, format!("Press 1 to {}, or space to go on without.", options.len()))),
        }
        vec![Block::Group(blocks)]
    }

    /// What there is of evidence, in a line: the keys that unfold it, and what is known of it.
    fn menu(&self, report: &StepReport) -> Block {
        let mut spans = Vec::new();
        let item = |spans: &mut Vec<Span>, sign: Span, text: &str, key: char| {
            if !spans.is_empty() {
                spans.push(Span::verbatim(Tone::Dim, "  · "));
            }
            // One word, so that a key stays with what it opens.
            let text = Span::plain(format!("{text} ").replace(' ', "\u{a0}"));
            spans.extend([sign, text, Span::verbatim(Tone::Name, format!("[{key}]"))]);
        };
        match self.figures.len() - self.shown_figures() {
            0 => {}
            1 => item(&mut spans, Span::plain(""), "1 more figure", 'f'),
            more => item(&mut spans, Span::plain(""), &format!("{more} more figures"), 'f'),
        }
        for kind in Evidence::ALL {
            let (items, (one, several)) = (self.count(kind), kind.nouns());
            if items == 0 {
                continue;
            }
            let fold = self.folds[kind as usize];
            let (verdicts, cases) = found(report, kind);
            let broken = verdicts.iter().filter(|verdict| **verdict == Verdict::Failed).count();
            let count = match (kind, fold.state) {
                // How many cases a family has is known when they have run.
                (Evidence::Extremes, State::Found) => format!("{cases} {several}"),
                (Evidence::Extremes, _) => several.to_owned(),
                _ => format!("{items} {}", if items == 1 { one } else { several }),
            };
            let sign = match fold.state {
                State::Found if broken > 0 => Span::verbatim(Tone::Bad, "✗ "),
                State::Found => Span::verbatim(Tone::Good, "✓ "),
                _ => Span::plain(""),
            };
            let running = if let State::Running(..) = fold.state { " …" } else { "" };
            item(&mut spans, sign, &format!("{count}{running}"), key(kind));
        }
        if spans.is_empty() {
            spans.push(Span::verbatim(Tone::Dim, "This step tells and shows; its claims are checked in others."));
        }
        Block::paragraph(0, 2, spans)
    }

    fn evidence(&self, teller: &Teller, report: &StepReport, kind: Evidence, look: &Look) -> Vec<Block> {
        let heading = |text: &str| Block::text(0, Tone::Heading, Phrase::verbatim(text));
        let (_, several) = kind.nouns();
        let title = heading(&(several[..1].to_uppercase() + &several[1..]));
        match self.folds[kind as usize].state {
            State::Found => {
                let mut blocks = vec![title];
                let drawn = self.plots.iter().filter(|_| kind == Evidence::Races);
                let mut drawn = drawn.map(|drawing| drawing.shown(look, self.edition));
                for block in teller.evidence(report, kind) {
                    blocks.push(block);
                    if let Some(cells) = drawn.next() {
                        let picture = Picture::Cells(cells);
                        let says = Phrase::verbatim("Error against time:");
                        blocks.push(Block::Figure(views::block::Figure { address: String::new(), says, picture }));
                    }
                }
                blocks
            }
            State::Lost => vec![title, Block::text(2, Tone::Bad, Phrase::verbatim("could not be judged"))],
            State::Running(_, 0) => vec![title, Block::text(2, Tone::Dim, Phrase::verbatim("waits for its turn …"))],
            State::Running(done, of) => {
                let filled = BAR * done / of;
                let bar = format!("running {}{} {done} of {of}", "█".repeat(filled), "░".repeat(BAR - filled));
                vec![title, Block::text(2, Tone::Plain, Phrase::verbatim(bar))]
            }
            State::Unknown => Vec::new(),
        }
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

/// Columns of a bar that shows progress.
const BAR: usize = 20;

fn unit(question: &Question) -> &'static str {
    match question.answer {
        chapters::vocabulary::Answer::Number { unit, .. } => unit,
        _ => "",
    }
}

/// The verdicts of one kind of evidence, and how many cases are behind those on extremes.
fn found(report: &StepReport, kind: Evidence) -> (Vec<Verdict>, usize) {
    match kind {
        Evidence::Derivations => (report.derivations.iter().map(|found| found.verdict).collect(), 0),
        Evidence::Checks => (report.checks.iter().map(|found| found.verdict).collect(), 0),
        Evidence::Extremes => (
            report.stress.iter().map(|found| found.verdict).collect(),
            report.stress.iter().flat_map(|found| &found.cases).map(|case| case.worst_of.max(1)).sum(),
        ),
        Evidence::Races => (report.races.iter().flat_map(|race| &race.lanes).map(|found| found.verdict).collect(), 0),
    }
}

/// Rows of a picture: less than a screen, so that what it belongs to stands beside it, and no more than its width calls
/// for.
fn picture_rows(look: &Look) -> usize {
    (look.height * 5 / 8).min(look.width * 3 / 8).max(8)
}

impl Drawing {
    /// Whether it has to be drawn so; if it has, it is asked for.
    fn wants(&mut self, order: Order) -> bool {
        let is_there = self.cells.as_ref().is_some_and(|(made, _)| *made == order);
        let wants = !is_there && self.asked.is_none() && !self.is_lost;
        if wants {
            self.asked = Some(order);
        }
        wants
    }

    /// The picture, put back while a newer one is on its way.
    fn shown(&self, look: &Look, edition: u32) -> Cells {
        match &self.cells {
            Some((made, cells)) if made.edition == edition => cells.clone(),
            Some((_, cells)) => cells.dimmed(),
            None => {
                let note = if self.is_lost { "this figure could not be drawn" } else { "drawing …" };
                Cells::note(look.width.min(60), picture_rows(look), note)
            }
        }
    }
}

/// Parts that are being set.
struct Parts {
    width: usize,
    parts: Vec<Part>,
}

impl Parts {
    fn add(&mut self, name: Name, is_whole: bool, blocks: &[Block]) {
        let mut page = Page::new(self.width, true);
        for block in blocks {
            terminal::set(&mut page, Teller::english(Details::default()).words(), std::slice::from_ref(block));
            page.gap();
        }
        let rows = page.into_rows();
        if rows.iter().any(|row| !row.is_empty()) {
            self.parts.push(Part { name, is_whole, rows });
        }
    }
}
