//! The report as text for a reader.

use crate::page::{Page, Span, Tone, typeset};
use crate::report::Parts;
use crate::report::*;
use chapters::lecture::LECTURE;
use chapters::vocabulary::{Expects, Item, Part};
use chapters::{CURRICULUM, Chapter, Step};
use unicode_width::UnicodeWidthStr;

/// What is shown of equations and derivations besides themselves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Details {
    /// The dimension of every line.
    pub units: bool,
    /// The single steps inside the lines.
    pub unfold: bool,
}

/// The contents: every chapter, its steps, and what each checks.
pub fn contents(page: &mut Page) {
    page.line(0, Tone::Plain, "A lecture on the physics of rendering that proves itself.");
    page.gap();
    for name in chapters::lecture::chapter_names() {
        match CURRICULUM.iter().find(|chapter| chapter.id == name) {
            Some(chapter) => written(page, chapter),
            None => coming(page, name),
        }
        page.gap();
    }
    page.line(0, Tone::Dim, "`lesson CHAPTER` walks through a chapter, `lesson CHAPTER STEP` shows one step; `lesson --help` tells the rest.");
}

fn written(page: &mut Page, chapter: &Chapter) {
    page.wrap(0, 4, &[(Tone::Heading, chapter.id), (Tone::Plain, "  "), (Tone::Strong, chapter.title)]);
    page.line(2, Tone::Plain, chapter.says);
    for step in chapter.steps {
        page.wrap(2, 6, &[(Tone::Name, step.id), (Tone::Plain, ": "), (Tone::Plain, step.says)]);
        page.line(6, Tone::Address, &inventory(step));
    }
}

/// What a step has, in one line: the checks by name, the rest by number.
fn inventory(step: &Step) -> String {
    let ids: Vec<_> = step.checks.iter().map(|check| check.head().id).collect();
    let mut parts = vec![step.rows.join(" ")];
    if !ids.is_empty() {
        parts.push(format!("checks {}", ids.join(", ")));
    }
    let mut counts: Vec<((&str, &str), usize)> = Vec::new();
    for item in step.items().filter(|item| !matches!(item, Item::Statement(_) | Item::Check(_))) {
        match counts.iter_mut().find(|(kind, _)| *kind == item.kind()) {
            Some((_, count)) => *count += 1,
            None => counts.push((item.kind(), 1)),
        }
    }
    parts.extend(counts.into_iter().map(|((one, many), count)| match count {
        1 => format!("1 {one}"),
        _ => format!("{count} {many}"),
    }));
    parts.retain(|part| !part.is_empty());
    parts.join(" · ")
}

fn coming(page: &mut Page, name: &str) {
    let rows: Vec<_> = LECTURE.iter().filter(|row| row.chapter == name).map(|row| row.id).collect();
    page.wrap(0, 4, &[(Tone::Strong, name), (Tone::Dim, "  to be written: "), (Tone::Dim, &rows.join(" "))]);
}

/// The signs used in verdicts.
pub fn legend(page: &mut Page) {
    page.section();
    for line in [
        "ε = 2⁻⁵² is the rounding unit of the machine's numbers. κ in ε(1+κ) is the condition number: how strongly the \
         exact answer reacts to its inputs.",
        "[…] is a unit, [1] a pure number. E36 or C10 is a row of the lecture (`lesson coverage`).",
    ] {
        page.wrap(0, 2, &[(Tone::Dim, line)]);
    }
    page.gap();
}

/// The heading of a chapter, and the prose before its first step.
pub fn chapter(page: &mut Page, chapter: &Chapter) {
    page.section();
    page.wrap(0, 0, &[(Tone::Heading, chapter.title)]);
    page.gap();
    page.markdown(chapter.prose.split("<!-- step:").next().unwrap_or_default(), chapter.title);
}

/// The part of `prose` that belongs to the step `id`: from its marker to the next.
pub fn section<'a>(prose: &'a str, id: &str) -> &'a str {
    let mut sections = prose.split("<!-- step:").skip(1).filter_map(|section| section.split_once("-->"));
    sections.find(|(marker, _)| marker.trim() == id).map_or("", |(_, text)| text.trim())
}

/// A step as the walk shows it: text, equations, derivations, numbers, verdicts, and where to look next.
pub fn lecture(page: &mut Page, chapter: &Chapter, step: &Step, found: &StepReport, details: Details) {
    page.section();
    heading(page, found);
    page.line(0, Tone::Emphasis, found.says);
    page.gap();
    page.markdown(section(chapter.prose, step.id), step.title);
    page.section();
    for statement in &found.statements {
        show_statement(page, statement);
    }
    for derivation in &found.derivations {
        page.section();
        show_derivation(page, derivation, details);
    }
    page.section();
    numbers(page, found);
    page.section();
    for check in &found.checks {
        show_check(page, check);
        page.gap();
    }
    page.section();
    pointers(page, step, &found.address);
    page.gap();
}

/// A step as `--check`, `--stress`, `--race` and `--plot` show it: what was found, and nothing else. Derivations with
/// their lines if `whole`, because one was asked for by its address.
pub fn findings(page: &mut Page, found: &StepReport, parts: Parts, whole: Option<Details>) {
    let figures = !found.figures.is_empty();
    if found.verdicts().next().is_none() && !figures {
        return;
    }
    heading(page, found);
    if parts.checks {
        for statement in &found.statements {
            let units = match statement.verdict {
                Verdict::Passed => format!("  both sides in [{}]", statement.dimension),
                Verdict::Failed => format!("  {}", statement.dimension),
            };
            let spans = [(Tone::Equation, statement.unicode.as_str()), (Tone::Plain, &units)];
            verdict(page, statement.verdict, &statement.address, &spans);
        }
        for derivation in &found.derivations {
            match whole {
                Some(details) => show_derivation(page, derivation, details),
                None => show_derivation_verdict(page, derivation),
            }
        }
        for check in &found.checks {
            show_check(page, check);
        }
    }
    for stress in &found.stress {
        show_stress(page, stress);
    }
    for race in &found.races {
        show_race(page, race);
    }
    page.gap();
    for figure in &found.figures {
        page.line(2, Tone::Plain, figure.says);
        page.verbatim(&figure.path.display().to_string());
    }
    page.gap();
}

fn heading(page: &mut Page, found: &StepReport) {
    let rows = found.rows.join(" ");
    page.wrap(0, 0, &[(Tone::Heading, found.title)]);
    page.wrap(0, 0, &[(Tone::Address, &found.address), (Tone::Dim, "  "), (Tone::Dim, &rows)]);
    page.gap();
}

/// One line per verdict: its sign, what it is about, and its address.
fn verdict(page: &mut Page, verdict: Verdict, address: &str, spans: &[Span]) {
    let sign = match verdict {
        Verdict::Passed => (Tone::Good, "✓ "),
        Verdict::Failed => (Tone::Bad, "✗ "),
    };
    let mut all = vec![sign];
    all.extend_from_slice(spans);
    page.wrap(2, 4, &all);
    page.line(4, Tone::Address, address);
}

fn show_statement(page: &mut Page, statement: &StatementReport) {
    page.formula(4, &statement.layout, &statement.unicode, "");
    let unit = match statement.verdict {
        Verdict::Passed => (Tone::Dim, format!("[{}]", statement.dimension)),
        Verdict::Failed => (Tone::Bad, statement.dimension.clone()),
    };
    page.wrap(6, 6, &[(Tone::Plain, statement.says), (Tone::Plain, " "), (unit.0, &unit.1)]);
    page.gap();
}

fn show_derivation_verdict(page: &mut Page, derivation: &DerivationReport) {
    verdict(page, derivation.verdict, &derivation.address, &[(Tone::Plain, derivation.says)]);
    if let Some(mismatch) = &derivation.mismatch {
        page.line(6, Tone::Bad, mismatch);
    }
    let digits = derivation.lines.iter().filter_map(|line| Some(line.hop.as_ref()?.digits?.0)).min_by(f64::total_cmp);
    let hops = derivation.lines.iter().filter_map(|line| Some((line, line.hop.as_ref()?)));
    let fewest = digits.map_or(String::new(), |digits| format!(", {digits:.0} digits agree at the worst"));
    let count = match hops.clone().count() {
        1 => "1 hop".to_owned(),
        count => format!("{count} hops"),
    };
    page.line(4, Tone::Plain, &(count + &fewest));
    for (line, hop) in hops.filter(|(_, hop)| hop.verdict == Verdict::Failed) {
        page.wrap(6, 8, &[(Tone::Equation, &line.unicode), (Tone::Bad, "  "), (Tone::Bad, &hop.found)]);
    }
}

/// A derivation line by line.
pub fn show_derivation(page: &mut Page, derivation: &DerivationReport, details: Details) {
    verdict(page, derivation.verdict, &derivation.address, &[(Tone::Strong, derivation.says)]);
    if let Some(mismatch) = &derivation.mismatch {
        page.line(6, Tone::Bad, mismatch);
    }
    show_lines(page, &derivation.lines, details);
    conditions(page, &derivation.conditions);
    // The hypotheses as substitutions: they place the sample points, the lines above are the argument.
    let given = |line: &LineReport| match line.by.join(", ") {
        by if by == line.unicode => by,
        by => format!("{} ({by})", line.unicode),
    };
    let points: Vec<String> = derivation.hypotheses.iter().map(given).collect();
    if !points.is_empty() {
        page.line(6, Tone::Dim, &format!("under {}", points.join(", ")));
    }
    page.gap();
}

/// What must not be zero.
fn conditions(page: &mut Page, conditions: &[String]) {
    if !conditions.is_empty() {
        page.line(6, Tone::Dim, &format!("where {}", conditions.join(", ")));
    }
}

/// The lines of a chain, each with its rules and what was found.
pub fn show_lines(page: &mut Page, lines: &[LineReport], details: Details) {
    for line in lines {
        show_line(page, 6, line, details);
        for step in line.unfolded.iter().filter(|_| details.unfold) {
            show_line(page, 10, step, details);
        }
    }
}

fn show_line(page: &mut Page, indent: usize, line: &LineReport, details: Details) {
    let unit = if details.units { format!("[{}]", line.dimension) } else { String::new() };
    page.formula(indent, &line.layout, &line.unicode, &unit);
    let rules = line.by.join(", ");
    match &line.hop {
        Some(hop) => {
            let tone = if hop.verdict == Verdict::Passed { Tone::Good } else { Tone::Bad };
            let by = if rules.is_empty() { String::new() } else { format!("{rules}: ") };
            page.wrap(indent + 4, indent + 6, &[(Tone::Plain, &by), (tone, &hop.found)]);
        }
        None if !rules.is_empty() => page.line(indent + 4, Tone::Plain, &rules),
        None => {}
    }
    if !line.says.is_empty() {
        page.line(indent + 4, Tone::Dim, line.says);
    }
}

/// The setting and what the program computes at it.
fn numbers(page: &mut Page, found: &StepReport) {
    if !found.setting.is_empty() {
        let setting: Vec<String> = found.setting.iter().map(|p| format!("{}={}", p.name, p.text)).collect();
        page.wrap(2, 4, &[(Tone::Plain, "At "), (Tone::Code, &setting.join(", ")), (Tone::Plain, ":")]);
    }
    let symbols: Vec<String> = found.readout.iter().map(|quantity| typeset(quantity.symbol)).collect();
    let values: Vec<String> = found.readout.iter().map(|quantity| value(quantity.value.0, quantity.unit)).collect();
    let widths = [widest(&symbols), widest(&values), 0];
    for ((quantity, symbol), value) in found.readout.iter().zip(&symbols).zip(&values) {
        let cells = [(Tone::Equation, symbol.as_str()), (Tone::Strong, value), (Tone::Plain, quantity.says)];
        page.row(4, &widths, &cells);
    }
    page.gap();
}

fn widest(texts: &[String]) -> i32 {
    texts.iter().map(|text| text.width()).max().unwrap_or(0) as i32
}

/// What lengths are told in [m].
const LENGTHS: [(f64, &str); 5] = [(1e-9, "nm"), (1e-6, "µm"), (1e-3, "mm"), (1.0, "m"), (1e3, "km")];

/// A length [m] in the unit that leaves one to three digits before the point, as far as there is one.
fn length(metres: f64) -> String {
    let reached = LENGTHS.iter().rev().find(|(size, _)| metres.abs() >= *size);
    let (size, unit) = if metres == 0.0 { (1.0, "m") } else { *reached.unwrap_or(&LENGTHS[0]) };
    format!("{} {unit}", short(metres / size))
}

/// A value with its unit as people read it: angles in degrees, lengths in the prefix of their size.
fn value(value: f64, unit: &str) -> String {
    let sign = if value < 0.0 { "−" } else { "" };
    match unit {
        _ if value.is_nan() => "none".to_owned(),
        _ if value.is_infinite() => format!("{sign}∞"),
        "rad" => format!("{}°", short(value.to_degrees())),
        "m" => length(value),
        "1" | "" => short(value),
        _ => format!("{} {unit}", short(value)),
    }
}

fn show_check(page: &mut Page, check: &CheckReport) {
    verdict(page, check.verdict, &check.address, &[(Tone::Plain, check.claim)]);
    let unit = if check.unit == "1" { "" } else { check.unit };
    let measured = format!("measured {} {unit}", short(check.value.0));
    let bound = format!("; {} ({})", check.bound, check.why);
    let tone = if check.verdict == Verdict::Passed { Tone::Good } else { Tone::Bad };
    page.wrap(4, 6, &[(tone, measured.trim_end()), (Tone::Plain, &bound)]);
    let cases = match check.cases {
        1 => format!("against {}, at {}", check.route, check.at),
        cases => format!("against {}; worst of {cases} cases at {}", check.route, check.at),
    };
    page.line(4, Tone::Dim, &cases);
}

/// How many cases of one stress are printed; the JSON report has all.
const CASES_SHOWN: usize = 8;

fn show_stress(page: &mut Page, stress: &StressReport) {
    page.gap();
    verdict(page, stress.verdict, &stress.address, &[(Tone::Plain, stress.claim)]);
    let kept = |digits: fn(&CaseReport) -> f64| stress.cases.iter().map(digits).fold(f64::INFINITY, f64::min);
    let broken = stress.cases.iter().filter(|case| case.verdict == Verdict::Failed).count();
    let inputs: usize = stress.cases.iter().map(|case| case.worst_of).sum();
    let summary = format!(
        "{inputs} results, {broken} broken; fewest digits kept: ours {:.1}, textbook {:.1}",
        kept(|case| case.our_digits),
        kept(|case| case.textbook_digits),
    );
    page.line(4, if broken == 0 { Tone::Good } else { Tone::Bad }, &summary);
    page.wrap(4, 6, &[(Tone::Dim, "textbook: "), (Tone::Dim, stress.textbook)]);
    page.wrap(4, 6, &[(Tone::Dim, "reference: "), (Tone::Dim, stress.reference)]);
    let shown = telling(&stress.cases);
    shown.iter().for_each(|case| show_case(page, case));
    let hidden = stress.cases.len() - shown.len();
    if hidden > 0 {
        page.line(6, Tone::Dim, &format!("… and {hidden} more (--json has them all)"));
    }
}

/// The cases worth printing: the broken ones, then those that cost the textbook form most. Where the exact answer is
/// zero there are no digits to compare.
fn telling(cases: &[CaseReport]) -> Vec<&CaseReport> {
    let rank = |case: &CaseReport| (case.verdict == Verdict::Passed, case.textbook_digits);
    let mut telling: Vec<_> = cases.iter().filter(|case| case.verdict == Verdict::Failed || !case.vanishes).collect();
    telling.sort_by(|a, b| rank(a).0.cmp(&rank(b).0).then(rank(a).1.total_cmp(&rank(b).1)));
    telling.truncate(CASES_SHOWN);
    telling
}

/// A quantity's key as a symbol: `r_s_re` is Re r_s.
fn symbol(key: &str) -> String {
    match (key.strip_suffix("_re"), key.strip_suffix("_im")) {
        (Some(of), _) => format!("Re {of}"),
        (_, Some(of)) => format!("Im {of}"),
        _ => key.to_owned(),
    }
}

fn show_case(page: &mut Page, case: &CaseReport) {
    let symbol = symbol(case.quantity);
    let of = if case.worst_of > 1 { format!(" (worst of {})", case.worst_of) } else { String::new() };
    page.wrap(6, 8, &[(Tone::Equation, &symbol), (Tone::Plain, " at "), (Tone::Plain, &case.input), (Tone::Dim, &of)]);
    let (good, bad) = (Tone::Good, Tone::Bad);
    let tone = if case.verdict == Verdict::Passed { good } else { bad };
    let textbook_tone = if case.textbook_digits < case.allowed_digits { bad } else { good };
    let widths = [9, 25, 0];
    let allowed = format!("at least {:.1} digits owed", case.allowed_digits);
    let kept = |digits: f64| format!("{digits:.1} digits");
    page.row(8, &widths, &[(Tone::Dim, "reference"), (Tone::Plain, &case.reference), (Tone::Dim, &allowed)]);
    page.row(
        8,
        &widths,
        &[(Tone::Dim, "textbook"), (Tone::Plain, &full(case.textbook)), (textbook_tone, &kept(case.textbook_digits))],
    );
    page.row(8, &widths, &[(Tone::Dim, "ours"), (Tone::Plain, &full(case.ours)), (tone, &kept(case.our_digits))]);
}

/// 17 significant digits, or the name of what is not finite.
pub fn full(x: Number) -> String {
    x.non_finite().map_or_else(|| format!("{:.16e}", x.0), str::to_owned)
}

fn show_race(page: &mut Page, race: &RaceReport) {
    page.gap();
    page.wrap(2, 4, &[(Tone::Strong, race.claim)]);
    page.line(4, Tone::Address, &race.address);
    page.wrap(
        4,
        6,
        &[(Tone::Dim, "work: "), (Tone::Dim, race.work), (Tone::Dim, "; error: "), (Tone::Dim, race.reference)],
    );
    for lane in &race.lanes {
        let asserted = matches!(lane.asserted, Expects::Order { .. });
        let fitted =
            lane.order.filter(|_| asserted).map_or(String::new(), |order| format!(", fitted order {order:.2}"));
        verdict(
            page,
            lane.verdict,
            &lane.address,
            &[
                (Tone::Strong, lane.label),
                (Tone::Plain, &fitted),
                (Tone::Plain, "; asserted: "),
                (Tone::Plain, &lane.expects),
            ],
        );
        let widths = [-12, -12, -12, -14];
        page.row(
            4,
            &widths,
            &[(Tone::Dim, "work"), (Tone::Dim, "error"), (Tone::Dim, "seconds"), (Tone::Dim, "ns per work")],
        );
        for point in &lane.points {
            let cells = [
                point.work.to_string(),
                point.error.non_finite().map_or_else(|| format!("{:.2e}", point.error.0), str::to_owned),
                format!("{:.2e}", point.seconds),
                short_time(point.ns_per_work),
            ];
            let spans: Vec<Span> = cells.iter().map(|cell| (Tone::Plain, cell.as_str())).collect();
            page.row(4, &widths, &spans);
        }
    }
}

fn short_time(ns: f64) -> String {
    if ns < 1e5 { format!("{ns:.2}") } else { format!("{ns:.2e}") }
}

/// What else can be asked of a step.
fn pointers(page: &mut Page, step: &Step, address: &str) {
    let command = address.replace('/', " ");
    let mut rows: Vec<(&str, String)> = Vec::new();
    rows.extend(step.items().filter_map(|item| match item.part()? {
        Part::Checks => None,
        part => Some((part.flag(), item.says().to_owned())),
    }));
    if rows.is_empty() {
        return;
    }
    page.gap();
    page.wrap(2, 4, &[(Tone::Plain, "More: "), (Tone::Code, &format!("lesson {command}")), (Tone::Plain, " with")]);
    for (flag, text) in &rows {
        page.wrap(4, 13, &[(Tone::Code, &format!("{flag:<8}")), (Tone::Plain, " "), (Tone::Plain, text)]);
    }
}

/// The machine that the seconds belong to.
pub fn machine(page: &mut Page, machine: &Machine) {
    let text = format!(
        "{} ({} cores), {} {}, {} build",
        machine.cpu, machine.cores, machine.os, machine.arch, machine.profile
    );
    page.line(0, Tone::Dim, &text);
}

/// The last line of every run.
pub fn tally(passed: usize, failed: usize) -> String {
    format!("{passed} passed, {failed} failed")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_carry_the_unit_of_their_size() {
        let lengths = [550.078e3, 550e-9, 2.06e-6, 0.0, -1.5e-3, 1e-12, 5.0, 1e-29];
        let told = ["550.078 km", "550 nm", "2.06 µm", "0 m", "-1.5 mm", "0.001 nm", "5 m", "1e-20 nm"];
        assert_eq!(lengths.map(|x| value(x, "m")), told);
        assert_eq!(value(0.001_327_209_4, "W/m²"), "0.00132721 W/m²");
        assert_eq!(value(std::f64::consts::FRAC_PI_2, "rad"), "90°");
    }

    #[test]
    fn sections_run_from_marker_to_marker() {
        let prose = "intro\n<!-- step: a -->\nfirst\n<!-- step: b -->\nsecond\n";
        assert_eq!((section(prose, "a"), section(prose, "b"), section(prose, "c")), ("first", "second", ""));
    }
}
