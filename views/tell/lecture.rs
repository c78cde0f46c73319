//! A chapter and its steps as they are taught.

use super::{Teller, face_of, owned, section_at, tone};
use crate::block::{
    Assignment, Block, Figure, Fold, Formula, Heading, Picture, Quantity, Rank, Span, Term, Terms, Tone,
};
use crate::number::value;
use crate::report::{DerivationReport, ParameterReport, RaceReport, StatementReport, StepReport, Verdict};
use chapters::text::Phrase;
use chapters::vocabulary::{Item, Part};
use chapters::{Chapter, Step};

impl Teller<'_> {
    /// The heading of a chapter, and the prose before its first step.
    pub fn chapter(&self, chapter: &Chapter) -> Vec<Block> {
        let mut blocks = vec![self.title(chapter)];
        blocks.extend(self.intro(chapter));
        vec![section_at(chapter.id, blocks)]
    }

    /// The prose before a chapter's first step.
    pub fn intro(&self, chapter: &Chapter) -> Vec<Block> {
        let intro = chapter.prose.split("<!-- step:").next().unwrap_or_default();
        self.prose(chapter.id, intro, chapter.title)
    }

    /// The heading of a chapter.
    pub fn title(&self, chapter: &Chapter) -> Block {
        let title = self.phrase(chapter.id, "title", chapter.title);
        Block::Heading(Heading {
            rank: Rank::Chapter,
            text: vec![Span::new(Tone::Heading, title)],
            address: None,
            rows: Vec::new(),
        })
    }

    /// A step as a run of the lecture shows it: text, equations, derivations, numbers, verdicts, and where to look next. `folded`,
    /// its derivations and checks have one line each.
    pub fn lecture(&self, chapter: &Chapter, step: &Step, found: &StepReport, folded: bool) -> Vec<Block> {
        let mut blocks = self.taught(chapter, step, found, folded);
        let settable = self.settable(step, &found.address, !folded);
        blocks.push(Block::section([self.pointers(step, &found.address), settable].concat()));
        vec![section_at(&found.address, blocks)]
    }

    /// A step with all that was found of it, for a page that can fold; `picture` has the figures and races by address.
    pub fn whole(
        &self,
        chapter: &Chapter,
        step: &Step,
        found: &StepReport,
        picture: &dyn Fn(&str) -> Picture,
    ) -> Vec<Block> {
        let mut blocks = self.taught(chapter, step, found, false);
        blocks.extend(self.tried(step.exhibit.figures, found, picture));
        vec![section_at(&found.address, blocks)]
    }

    /// What was found of one item of a step, `found` having nothing else, for a page that can fold; the step's text is not
    /// repeated.
    pub fn item(&self, item: &Item, found: &StepReport, picture: &dyn Fn(&str) -> Picture) -> Vec<Block> {
        let mut blocks = self.formulas(found);
        blocks.extend(found.questions.iter().map(|question| self.question(question, false)));
        blocks.extend(self.derivations(&found.derivations, true));
        blocks.extend(found.checks.iter().map(|check| self.check(check)));
        let figures = if let Item::Figure(figure) = item { std::slice::from_ref(*figure) } else { &[] };
        blocks.extend(self.tried(figures, found, picture));
        // Checks tell for themselves at what they were done.
        let is_at_setting = matches!(item, Item::Question(_) | Item::Figure(_));
        self.setting(found).filter(|_| is_at_setting).into_iter().chain(blocks).collect()
    }

    /// What there is to see, what could break it, and what it costs.
    fn tried(
        &self,
        figures: &[chapters::vocabulary::Figure],
        found: &StepReport,
        picture: &dyn Fn(&str) -> Picture,
    ) -> Vec<Block> {
        let figure = |figure: &chapters::vocabulary::Figure| {
            self.shown(found, figure, picture(&format!("{}/{}", found.address, figure.id)))
        };
        let race = |race: &RaceReport| {
            let picture = picture(&race.address);
            let says = self.phrase(&race.address, "claim", race.claim);
            let figure = Figure { address: format!("{}/plot", race.address), says, picture };
            let drawn = figure.picture != Picture::Absent;
            [Some(self.race(race)), drawn.then_some(Block::Figure(figure))]
        };
        let parts = [
            figures.iter().map(figure).collect(),
            found.stress.iter().map(|stress| self.stress(stress)).collect(),
            found.races.iter().flat_map(race).flatten().collect(),
        ];
        parts.into_iter().filter(|part: &Vec<_>| !part.is_empty()).map(Block::section).collect()
    }

    /// The parameters in force, if there are any.
    pub fn setting(&self, found: &StepReport) -> Option<Block> {
        let assignment = |p: &ParameterReport| Assignment { name: p.name.to_owned(), text: p.text.clone() };
        (!found.setting.is_empty()).then(|| Block::Setting(found.setting.iter().map(assignment).collect()))
    }

    /// How to see what [`Self::lecture`] has folded.
    pub fn unfolding(&self) -> Vec<Block> {
        let how = "Derivations and checks are folded to a line each: --check shows what was found, --unfold all of it, \
                   and an address such as fresnel/brewster/square one alone.";
        vec![Block::section(vec![Block::text(0, Tone::Dim, self.say(how, &[]))])]
    }

    fn taught(&self, chapter: &Chapter, step: &Step, found: &StepReport, folded: bool) -> Vec<Block> {
        let mut blocks = self.head(found);
        blocks.extend(self.text(chapter, step, found));
        blocks.push(Block::section(self.formulas(found)));
        blocks.extend(found.questions.iter().map(|question| Block::section(vec![self.question(question, false)])));
        if folded {
            let line = |derivation: &DerivationReport| {
                let says = self.phrase(&derivation.address, "says", derivation.says);
                let told = Block::Group(self.derivations(std::slice::from_ref(derivation), true));
                fold(&derivation.address, derivation.verdict, says, told)
            };
            blocks.push(Block::Group(found.derivations.iter().map(line).collect()));
        } else {
            let derivations = self.derivations(&found.derivations, true).into_iter();
            blocks.extend(derivations.map(|block| Block::section(vec![block])));
        }
        let checks = found.checks.iter().map(|check| {
            let claim = self.phrase(&check.address, "claim", check.claim);
            if folded { fold(&check.address, check.verdict, claim, self.check(check)) } else { self.check(check) }
        });
        blocks.push(Block::section(vec![self.numbers(found)]));
        blocks.push(if folded { Block::Group(checks.collect()) } else { Block::section(checks.collect()) });
        blocks
    }

    pub(super) fn formula(&self, statement: &StatementReport) -> Block {
        Block::Formula(Formula {
            address: statement.address.clone(),
            face: face_of(statement),
            says: self.phrase(&statement.address, "says", statement.says),
            unit: self.dimension(statement).to_string(),
            verdict: statement.verdict,
            rows: owned(statement.rows),
        })
    }

    /// The setting and what the program computes at it.
    pub fn numbers(&self, found: &StepReport) -> Block {
        let mut blocks: Vec<Block> = self.setting(found).into_iter().collect();
        let quantities = found.readout.iter().map(|quantity| Quantity {
            key: quantity.key.to_owned(),
            symbol: Phrase::parse(quantity.symbol),
            value: Phrase::parse(&value(quantity.value.0, quantity.unit)),
            number: quantity.value,
            unit: quantity.unit.to_owned(),
            says: self.phrase(&format!("{}/{}", found.address, quantity.key), "says", quantity.says),
        });
        blocks.push(Block::Quantities(quantities.collect()));
        Block::Group(blocks)
    }

    /// What else can be asked of a step.
    fn pointers(&self, step: &Step, address: &str) -> Vec<Block> {
        let pointer = |item: Item| {
            let flag = item.part().filter(|part| *part != Part::Checks)?.flag();
            let says = self.phrase(&format!("{address}/{}", item.id()), item.field(), item.says());
            let name = Span::verbatim(Tone::Code, flag);
            Some(Term { name, says: vec![Span::new(Tone::Plain, says)], note: None })
        };
        let items: Vec<Term> = step.items().filter_map(pointer).collect();
        if items.is_empty() {
            return Vec::new();
        }
        let more = vec![
            Span::new(Tone::Plain, self.say("More:", &[]).then(Phrase::verbatim(" "))),
            Span::verbatim(Tone::Code, format!("lesson {}", address.replace('/', " "))),
            Span::new(Tone::Plain, Phrase::verbatim(" ").then(self.say("with", &[]))),
        ];
        vec![Block::Group(vec![Block::paragraph(2, 4, more), Block::Terms(Terms { width: Some(8), items })])]
    }
}

/// What was `told` of the item at an address, folded to a line: how it was judged, its id and what it says. What is
/// broken stays open.
fn fold(address: &str, verdict: Verdict, says: Phrase, told: Block) -> Block {
    let id = address.rsplit('/').next().unwrap_or(address);
    let sign = if verdict == Verdict::Passed { "✓ " } else { "✗ " };
    let summary = vec![
        Span::verbatim(tone(verdict), sign),
        Span::verbatim(Tone::Name, id),
        Span::plain("  "),
        Span::new(Tone::Plain, says),
    ];
    Block::Fold(Fold { summary, blocks: vec![told], open: verdict == Verdict::Failed })
}
