//! A step set as a page, part by part.

use super::{Leaf, Look, State, key};
use chapters::text::Phrase;
use chapters::vocabulary::{Given, Question};
use views::block::{Block, Details, Span, Tone};
use views::page::{Page, Row};
use views::report::entry::ask;
use views::report::{StepReport, Verdict};
use views::tell::{Evidence, Teller};
use views::terminal;

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

/// Columns of a bar that shows progress.
const BAR: usize = 20;

impl Leaf {
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
            parts.add(Name::Formulas, true, &Vec::from_iter(teller.key(self.step, report)));
        } else {
            parts.add(Name::Text, false, &[Block::section(teller.text(self.chapter, self.step, report))]);
            parts.add(Name::Formulas, false, &teller.formulas(report));
        }
        for (at, question) in self.step.questions.iter().enumerate().filter(|(at, _)| self.answers[*at].is_none()) {
            parts.add(Name::Question(at), true, &self.question(&teller, report, at, question));
        }
        if !look.short {
            let mut numbers = vec![teller.numbers(report)];
            if self.read.1.is_some() {
                let note =
                    if report.readout.is_empty() { "computing …" } else { "computing; these are from before …" };
                numbers.push(Block::text(4, Tone::Dim, Phrase::verbatim(note)));
            }
            parts.add(Name::Numbers, false, &[Block::Group(numbers)]);
        }
        let shown = self.shown_figures();
        for (at, figure) in self.step.exhibit.figures.iter().enumerate().take(shown) {
            let picture = self.figures[at].shown(look, self.edition);
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
                    if let Some(picture) = drawn.next() {
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

fn unit(question: &Question) -> &'static str {
    match question.answer {
        chapters::vocabulary::Answer::Number { unit, .. } => unit,
        _ => "",
    }
}

/// The verdicts of one kind of evidence, and how many cases are behind those on extremes.
pub(super) fn found(report: &StepReport, kind: Evidence) -> (Vec<Verdict>, usize) {
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
