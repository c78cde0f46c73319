//! What was found of a step: verdicts on equations, checks, extreme cases and races.

use super::{Teller, owned, section_at, tone};
use crate::block::{Block, Case, Cases, Column, Figure, Judged, Picture, Span, Table, Tone};
use crate::number::{full, hundredths, short};
use crate::report::{
    CaseReport, CheckReport, FigureReport, LaneReport, Parts, PointReport, RaceReport, Report, StatementReport,
    StepReport, StressReport, Verdict,
};
use chapters::text::Phrase;
use chapters::vocabulary::Expects;

/// How many cases of one stress are told; the JSON report has all.
const CASES_SHOWN: usize = 8;

impl Teller<'_> {
    /// A step as `--check`, `--stress` and `--race` show it: what was found, and nothing else. Derivations
    /// with their lines and questions with their answers if `whole`, because one was asked for by its address.
    pub fn findings(&self, found: &StepReport, parts: Parts, whole: bool) -> Vec<Block> {
        let questions = found.questions.iter().filter(|_| whole);
        let mut verdicts: Vec<Block> = questions.map(|question| self.question(question, true)).collect();
        if verdicts.is_empty() && found.verdicts().next().is_none() {
            return Vec::new();
        }
        if parts.checks {
            verdicts.extend(found.statements.iter().map(|statement| self.units(statement)));
            verdicts.extend(self.derivations(&found.derivations, whole));
            verdicts.extend(found.checks.iter().map(|check| self.check(check)));
        }
        let mut blocks = vec![self.heading(found)];
        // What is right depends on it.
        blocks.extend(self.setting(found).filter(|_| whole && !found.questions.is_empty()));
        blocks.push(Block::Group(verdicts));
        blocks.extend(found.stress.iter().map(|stress| self.stress(stress)));
        blocks.extend(found.races.iter().map(|race| self.race(race)));
        vec![section_at(&found.address, blocks)]
    }

    /// The figures that were written, with their paths.
    pub fn figures(&self, report: &Report) -> Option<Block> {
        let steps = report.chapters.iter().flat_map(|chapter| &chapter.steps);
        let figures: Vec<_> = steps.flat_map(|step| &step.figures).map(|figure| self.figure(figure)).collect();
        (!figures.is_empty()).then(|| Block::section(vec![Block::Group(figures)]))
    }

    fn units(&self, statement: &StatementReport) -> Block {
        let units = match (statement.is_struck_out, statement.verdict) {
            (false, Verdict::Passed) => {
                self.say("both sides in [{unit}]", &[("unit", Phrase::verbatim(&statement.dimension))])
            }
            _ => self.dimension(statement),
        };
        let units = Span::new(Tone::Plain, Phrase::verbatim("  ").then(units));
        Block::Judged(Judged {
            address: statement.address.clone(),
            verdict: Some(statement.verdict),
            claim: vec![Span::equation(&statement.unicode, &statement.mathml), units],
            rows: owned(statement.rows),
            details: Vec::new(),
        })
    }

    /// The unit of both sides, or how they differ; of what is struck out that it is, and rightly.
    pub(super) fn dimension(&self, statement: &StatementReport) -> Phrase {
        let dimension = Phrase::verbatim(&statement.dimension);
        match (statement.is_struck_out, statement.verdict) {
            (false, _) => dimension,
            (true, Verdict::Passed) => self.say("struck out: {mismatch}", &[("mismatch", dimension)]),
            (true, Verdict::Failed) => self.say("struck out, but both sides are in [{unit}]", &[("unit", dimension)]),
        }
    }

    pub(super) fn check(&self, check: &CheckReport) -> Block {
        let field = |field: &str, english: &str| self.phrase(&check.address, field, english);
        let unit = if check.unit == "1" { String::new() } else { format!(" {}", check.unit) };
        let value = Phrase::parse(&format!("{}{unit}", short(check.value.0)));
        let measured = Span::new(tone(check.verdict), self.say("measured {value}", &[("value", value)]));
        let bound = [("bound", Phrase::parse(&check.bound)), ("why", field("why", check.why))];
        let bound = Span::new(Tone::Plain, self.say("; {bound} ({why})", &bound));
        let parts = [
            ("route", field("route", check.route)),
            ("at", Phrase::parse(&check.at)),
            ("cases", Phrase::verbatim(check.cases.to_string())),
        ];
        let cases = match check.cases {
            1 => self.say("against {route}, at {at}", &parts),
            _ => self.say("against {route}; worst of {cases} cases at {at}", &parts),
        };
        let mut details = vec![Block::paragraph(4, 6, vec![measured, bound]), Block::text(4, Tone::Dim, cases)];
        if check.picture.is_some() {
            details.push(Block::text(4, Tone::Bad, self.say("--plot draws what to look at", &[])));
        }
        Block::Judged(Judged {
            address: check.address.clone(),
            verdict: Some(check.verdict),
            claim: vec![Span::new(Tone::Plain, field("claim", check.claim))],
            rows: owned(check.rows),
            details,
        })
    }

    pub(super) fn stress(&self, stress: &StressReport) -> Block {
        let field = |field: &str, english: &str| self.phrase(&stress.address, field, english);
        let fewest = |digits: fn(&CaseReport) -> f64| {
            let fewest = stress.cases.iter().map(digits).fold(f64::INFINITY, f64::min);
            Phrase::verbatim(format!("{fewest:.1}"))
        };
        let broken = stress.cases.iter().filter(|case| case.verdict == Verdict::Failed).count();
        let inputs: usize = stress.cases.iter().map(|case| case.worst_of).sum();
        let parts = [
            ("inputs", Phrase::verbatim(inputs.to_string())),
            ("broken", Phrase::verbatim(broken.to_string())),
            ("ours", fewest(|case| case.our_digits)),
            ("textbook", fewest(|case| case.textbook_digits)),
        ];
        let summary =
            self.say("{inputs} results, {broken} broken; fewest digits kept: ours {ours}, textbook {textbook}", &parts);
        let named = |template: &str, text: Phrase| {
            Block::paragraph(4, 6, vec![Span::new(Tone::Dim, self.say(template, &[("text", text)]))])
        };
        let shown = telling(&stress.cases);
        let hidden = stress.cases.len() - shown.len();
        Block::Judged(Judged {
            address: stress.address.clone(),
            verdict: Some(stress.verdict),
            claim: vec![Span::new(Tone::Plain, field("claim", stress.claim))],
            rows: owned(stress.rows),
            details: vec![
                Block::text(4, tone((broken == 0).into()), summary),
                named("textbook: {text}", field("textbook", stress.textbook)),
                named("reference: {text}", field("reference", stress.reference)),
                Block::Cases(Cases { cases: shown.into_iter().map(case).collect(), hidden }),
            ],
        })
    }

    pub(super) fn race(&self, race: &RaceReport) -> Block {
        let field = |field: &str, english: &str| self.phrase(&race.address, field, english);
        let parts = [("work", field("work", race.work)), ("error", field("reference", race.reference))];
        let how = Span::new(Tone::Dim, self.say("work: {work}; error: {error}", &parts));
        let mut details = vec![Block::paragraph(4, 6, vec![how])];
        details.extend(race.lanes.iter().map(|lane| self.lane(lane)));
        Block::Judged(Judged {
            address: race.address.clone(),
            verdict: None,
            claim: vec![Span::new(Tone::Strong, field("claim", race.claim))],
            rows: owned(race.rows),
            details,
        })
    }

    fn lane(&self, lane: &LaneReport) -> Block {
        let asserted = matches!(lane.asserted, Expects::Order { .. });
        let label = self.phrase(&lane.address, "label", lane.label);
        let mut claim = vec![Span::new(Tone::Strong, label.clone())];
        if let Some(order) = lane.order.filter(|_| asserted) {
            let order = Phrase::verbatim(hundredths(order));
            claim.push(Span::new(Tone::Plain, self.say(", fitted order {order}", &[("order", order)])));
        }
        let expects = Phrase::parse(&lane.expects);
        claim.push(Span::new(Tone::Plain, self.say("; asserted: {expects}", &[("expects", expects)])));
        let columns = [("work", -12), ("error", -12), ("seconds", -12), ("ns per work", -14)];
        let column = |(head, width): &(&str, i32)| Column { head: self.say(head, &[]), width: *width };
        let table = Table {
            caption: label,
            columns: columns.iter().map(column).collect(),
            rows: lane.points.iter().map(cells).collect(),
            headed: true,
            inset: 4,
        };
        Block::Judged(Judged {
            address: lane.address.clone(),
            verdict: Some(lane.verdict),
            claim,
            rows: Vec::new(),
            details: vec![Block::Table(table)],
        })
    }

    fn figure(&self, figure: &FigureReport) -> Block {
        Block::Figure(Figure {
            address: figure.address.clone(),
            says: self.phrase(&figure.address, "says", figure.says),
            picture: Picture::File(figure.path.display().to_string()),
        })
    }
}

fn cells(point: &PointReport) -> Vec<Span> {
    let cells = [
        point.work.to_string(),
        point.error.non_finite().map_or_else(|| format!("{:.2e}", point.error.0), str::to_owned),
        format!("{:.2e}", point.seconds),
        short_time(point.ns_per_work),
    ];
    cells.iter().map(|cell| Span::new(Tone::Plain, Phrase::parse(cell))).collect()
}

fn short_time(ns: f64) -> String {
    if ns < 1e5 { format!("{ns:.2}") } else { format!("{ns:.2e}") }
}

/// The cases worth telling: the broken ones, then those that cost the textbook form most. Where the exact answer is
/// zero there are no digits to compare.
fn telling(cases: &[CaseReport]) -> Vec<&CaseReport> {
    let rank = |case: &CaseReport| (case.verdict == Verdict::Passed, case.textbook_digits);
    let mut telling: Vec<_> = cases.iter().filter(|case| case.verdict == Verdict::Failed || !case.vanishes).collect();
    telling.sort_by(|a, b| rank(a).0.cmp(&rank(b).0).then(rank(a).1.total_cmp(&rank(b).1)));
    telling.truncate(CASES_SHOWN);
    telling
}

fn case(case: &CaseReport) -> Case {
    Case {
        quantity: Phrase::parse(&symbol(case.quantity)),
        input: Phrase::parse(&case.input),
        worst_of: case.worst_of,
        reference: Phrase::parse(&case.reference),
        owed: case.allowed_digits,
        textbook: Phrase::parse(&full(case.textbook)),
        textbook_digits: case.textbook_digits,
        ours: Phrase::parse(&full(case.ours)),
        our_digits: case.our_digits,
        verdict: case.verdict,
    }
}

/// A quantity's key as a symbol: `r_s_re` is Re r_s.
fn symbol(key: &str) -> String {
    match (key.strip_suffix("_re"), key.strip_suffix("_im")) {
        (Some(of), _) => format!("Re {of}"),
        (_, Some(of)) => format!("Im {of}"),
        _ => key.to_owned(),
    }
}
