//! Blocks on a page of fixed pitch: a terminal, or a file of plain text.

use crate::block::{
    Answers, Block, Case, Cases, Face, Figure, Heading, Judged, Line, Lines, List, Paragraph, Picture, Quantity,
    Question, Rank, Span, Table, Terms, Tone,
};
use crate::page::{self, Page};
use crate::report::Verdict;
use crate::words::Words;
use chapters::text::Phrase;
use unicode_width::UnicodeWidthStr;

/// Sets `blocks` under what is on the page already.
pub fn set(page: &mut Page, words: Words, blocks: &[Block]) {
    blocks.iter().for_each(|block| show(page, words, block));
}

fn show(page: &mut Page, words: Words, block: &Block) {
    match block {
        Block::Section(section) => {
            page.gap();
            for block in &section.blocks {
                show(page, words, block);
                page.gap();
            }
        }
        Block::Group(blocks) => set(page, words, blocks),
        Block::Heading(heading) => head(page, heading),
        Block::Paragraph(Paragraph { spans, inset }) => wrap(page, inset.first, inset.rest, spans),
        Block::List(list) => points(page, words, list, 1),
        Block::Code(code) => code.lines().for_each(|line| page.row(4, &[0], &[(Tone::Code, line)])),
        Block::Line(line) => page.verbatim(line),
        Block::Terms(terms) => name(page, terms),
        Block::Formula(formula) => {
            equation(page, 4, &formula.face, "");
            let (tone, unit) = match formula.verdict {
                Verdict::Passed => (Tone::Dim, format!("[{}]", formula.unit)),
                Verdict::Failed => (Tone::Bad, formula.unit.clone()),
            };
            let says = Span::new(Tone::Plain, formula.says.clone());
            wrap(page, 6, 6, &[says, Span::plain(" "), Span::verbatim(tone, unit)]);
        }
        Block::Lines(lines) => argue(page, lines),
        Block::Table(table) => tabulate(page, table),
        Block::Judged(judged) => judge(page, words, judged),
        Block::Cases(cases) => press(page, words, cases),
        Block::Fold(fold) if fold.open => {
            set(page, words, &fold.blocks);
            page.gap();
        }
        Block::Fold(fold) => cut(page, 4, &fold.summary),
        Block::Setting(setting) => {
            let setting: Vec<_> = setting.iter().map(|set| format!("{}={}", set.name, set.text)).collect();
            let at = words.tell("At", &[]) + " ";
            page.wrap(2, 4, &[(Tone::Plain, &at), (Tone::Code, &setting.join(", ")), (Tone::Plain, ":")]);
        }
        Block::Quantities(quantities) => measure(page, quantities),
        Block::Figure(figure) => picture(page, figure),
        Block::Question(question) => ask(page, words, question),
    }
}

fn wrap(page: &mut Page, first: usize, rest: usize, spans: &[Span]) {
    let faces: Vec<_> = spans.iter().flat_map(Span::faces).collect();
    page.wrap(first, rest, &borrowed(&faces));
}

/// A line that is cut where the page ends.
fn cut(page: &mut Page, indent: usize, spans: &[Span]) {
    let faces: Vec<_> = spans.iter().flat_map(Span::faces).collect();
    page.cut(indent, &borrowed(&faces));
}

fn borrowed(faces: &[(Tone, String)]) -> Vec<page::Span<'_>> {
    faces.iter().map(|(tone, text)| (*tone, text.as_str())).collect()
}

/// A phrase in one tone.
fn line(page: &mut Page, indent: usize, tone: Tone, text: &Phrase) {
    page.line(indent, tone, &text.to_string());
}

fn head(page: &mut Page, heading: &Heading) {
    let hanging = if heading.rank == Rank::Entry { 4 } else { 0 };
    wrap(page, 0, hanging, &heading.text);
    if let Some(address) = &heading.address {
        page.wrap(0, 0, &[(Tone::Address, address), (Tone::Dim, "  "), (Tone::Dim, &heading.rows.join(" "))]);
    }
}

fn points(page: &mut Page, words: Words, list: &List, depth: usize) {
    let indent = 2 * depth;
    for item in &list.items {
        for (at, block) in item.iter().enumerate() {
            match block {
                Block::Paragraph(text) if at == 0 => {
                    let bullet = [Span::plain("• ")];
                    wrap(page, indent, indent + 2, &[&bullet, &text.spans[..]].concat());
                }
                Block::Paragraph(text) => wrap(page, indent + 2, indent + 2, &text.spans),
                Block::List(list) => points(page, words, list, depth + 1),
                other => show(page, words, other),
            }
            if list.spaced {
                page.gap();
            }
        }
    }
}

fn name(page: &mut Page, terms: &Terms) {
    for term in &terms.items {
        match terms.width {
            None => {
                let head = [term.name.clone(), Span::plain(": ")];
                wrap(page, 2, 6, &[&head[..], &term.says].concat());
            }
            Some(width) => {
                let name = format!("{:<width$} ", term.name.text.to_string());
                let name = [Span::verbatim(term.name.tone, name)];
                wrap(page, 4, 4 + width + 1, &[&name, &term.says[..]].concat());
            }
        }
        if let Some(note) = &term.note {
            line(page, 6, note.tone, &note.text);
        }
    }
}

fn equation(page: &mut Page, indent: usize, face: &Face, beside: &str) {
    page.formula(indent, &face.layout, &face.unicode, beside);
}

/// The lines of a chain, each with its rules and what was found.
fn argue(page: &mut Page, lines: &Lines) {
    for line in &lines.lines {
        argue_line(page, 6, line, lines.details.units);
        for step in line.steps.iter().filter(|_| lines.details.unfold) {
            argue_line(page, 10, step, lines.details.units);
        }
    }
}

fn argue_line(page: &mut Page, indent: usize, told: &Line, units: bool) {
    let unit = if units { format!("[{}]", told.unit) } else { String::new() };
    equation(page, indent, &told.face, &unit);
    match &told.found {
        Some(found) => {
            let by = if told.by.is_empty() { Phrase::default() } else { told.by.clone().then(Phrase::verbatim(": ")) };
            let found = Span::new(tone(found.verdict), found.says.clone());
            wrap(page, indent + 4, indent + 6, &[Span::new(Tone::Plain, by), found]);
        }
        None if !told.by.is_empty() => line(page, indent + 4, Tone::Plain, &told.by),
        None => {}
    }
    if !told.says.is_empty() {
        line(page, indent + 4, Tone::Dim, &told.says);
    }
}

fn tabulate(page: &mut Page, table: &Table) {
    let widths: Vec<i32> = table.columns.iter().map(|column| column.width).collect();
    let cells = |row: &[Span]| row.iter().map(|cell| (cell.tone, cell.text.to_string())).collect::<Vec<_>>();
    if !table.headed {
        return table.rows.iter().for_each(|row| listed(page, table.inset, &widths, &cells(row)));
    }
    let heads: Vec<_> = table.columns.iter().map(|column| (Tone::Dim, column.head.to_string())).collect();
    page.row(table.inset, &widths, &borrowed(&heads));
    table.rows.iter().for_each(|row| page.row(table.inset, &widths, &borrowed(&cells(row))));
}

/// A row of a table without heads: its columns stay where they are on the narrowest page, for nothing else says which
/// is which.
fn listed(page: &mut Page, inset: usize, widths: &[i32], cells: &[(Tone, String)]) {
    let (mut spans, mut column) = (Vec::new(), inset);
    for ((tone, cell), width) in cells.iter().zip(widths) {
        let width = width.unsigned_abs() as i32;
        // A cell one letter too long may use the space behind it.
        spans.push((*tone, page::pad(cell, width + 1) + " "));
        column += if width == 0 { 0 } else { width as usize + 2 };
    }
    page.wrap(inset, column, &borrowed(&spans));
}

/// One line per verdict: its sign, what it is about, and its address.
fn judge(page: &mut Page, words: Words, judged: &Judged) {
    let sign = match judged.verdict {
        Some(Verdict::Passed) => vec![Span::verbatim(Tone::Good, "✓ ")],
        Some(Verdict::Failed) => vec![Span::verbatim(Tone::Bad, "✗ ")],
        None => Vec::new(),
    };
    wrap(page, 2, 4, &[&sign[..], &judged.claim].concat());
    page.line(4, Tone::Address, &judged.address);
    set(page, words, &judged.details);
}

fn press(page: &mut Page, words: Words, cases: &Cases) {
    cases.cases.iter().for_each(|case| press_one(page, words, case));
    if cases.hidden > 0 {
        let more = words.tell("… and {count} more (--json has them all)", &[("count", &cases.hidden.to_string())]);
        page.line(6, Tone::Dim, &more);
    }
}

fn press_one(page: &mut Page, words: Words, case: &Case) {
    let of = match case.worst_of {
        0 | 1 => String::new(),
        count => words.tell(" (worst of {count})", &[("count", &count.to_string())]),
    };
    let input = Span::new(Tone::Plain, case.input.clone());
    let quantity = Span::new(Tone::Equation, case.quantity.clone());
    let at = Span::plain(words.tell(" at ", &[]));
    wrap(page, 6, 8, &[quantity, at, input, Span::verbatim(Tone::Dim, of)]);
    let textbook = if case.textbook_digits < case.owed { Tone::Bad } else { Tone::Good };
    let mut row = |name: &str, value: &Phrase, tone: Tone, template: &str, digits: f64| {
        let (name, value) = (words.tell(name, &[]), value.to_string());
        let digits = words.tell(template, &[("digits", &format!("{digits:.1}"))]);
        page.row(8, &[9, 25, 0], &[(Tone::Dim, &name), (Tone::Plain, &value), (tone, &digits)]);
    };
    row("reference", &case.reference, Tone::Dim, "at least {digits} digits owed", case.owed);
    row("textbook", &case.textbook, textbook, "{digits} digits", case.textbook_digits);
    row("ours", &case.ours, tone(case.verdict), "{digits} digits", case.our_digits);
}

fn measure(page: &mut Page, quantities: &[Quantity]) {
    let faces: Vec<_> = quantities.iter().map(|q| (q.symbol.to_string(), q.value.to_string())).collect();
    let widest =
        |of: fn(&(String, String)) -> &str| faces.iter().map(|face| of(face).width()).max().unwrap_or(0) as i32;
    let widths = [widest(|(symbol, _)| symbol), widest(|(_, value)| value), 0];
    for ((symbol, value), quantity) in faces.iter().zip(quantities) {
        let says = quantity.says.to_string();
        page.row(4, &widths, &[(Tone::Equation, symbol), (Tone::Strong, value), (Tone::Plain, &says)]);
    }
}

fn picture(page: &mut Page, figure: &Figure) {
    line(page, 2, Tone::Plain, &figure.says);
    match &figure.picture {
        Picture::File(path) => page.verbatim(path),
        Picture::Cells(cells) => page.picture(0, cells),
        Picture::Strips(strips) => page.strips(strips),
        Picture::Svg(_) | Picture::Absent => page.line(4, Tone::Address, &figure.address),
    }
}

fn ask(page: &mut Page, words: Words, question: &Question) {
    let prompt = [Span::verbatim(Tone::Strong, "? ")];
    wrap(page, 2, 4, &[&prompt, &question.prompt[..]].concat());
    match &question.answers {
        Answers::Choices(choices) => {
            for (at, choice) in choices.iter().enumerate() {
                let number = Span::verbatim(Tone::Strong, format!("{}) ", at + 1));
                wrap(page, 4, 7, &[number, Span::new(Tone::Plain, choice.says.clone())]);
                if question.open {
                    let tone = if choice.right { Tone::Good } else { Tone::Bad };
                    let word = words.tell(if choice.right { "right" } else { "wrong" }, &[]) + ": ";
                    let response = Span::new(Tone::Plain, choice.response.clone());
                    wrap(page, 7, 9, &[Span::verbatim(tone, word), response]);
                }
            }
        }
        Answers::Number { response, .. } if question.open => {
            let answer = Span::new(Tone::Good, question.answers.told(words));
            wrap(page, 4, 6, &[answer, Span::plain(": "), Span::new(Tone::Plain, response.clone())]);
        }
        Answers::Number { unit, .. } => page.line(4, Tone::Dim, &words.tell("a number [{unit}]", &[("unit", unit)])),
    }
    if question.open {
        page.line(4, Tone::Address, &question.address);
    } else if !question.address.is_empty() {
        let answer = words.tell("the answer: {command}", &[("command", &format!("lesson {}", question.address))]);
        page.line(4, Tone::Address, &answer);
    }
}

fn tone(verdict: Verdict) -> Tone {
    if verdict == Verdict::Passed { Tone::Good } else { Tone::Bad }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::Choice;

    fn shown(block: Block) -> String {
        let mut page = Page::new(60, false);
        set(&mut page, Words::ENGLISH, &[block]);
        page.into_text()
    }

    fn question(open: bool) -> Block {
        let choice = |says: &str, right, response: &str| Choice {
            says: Phrase::parse(says),
            right,
            response: Phrase::parse(response),
        };
        Block::Question(Question {
            address: "c/s/q".to_owned(),
            prompt: vec![Span::plain("Which fades?")],
            answers: Answers::Choices(vec![choice("R_s", false, "It grows."), choice("R_p", true, "At θ_B.")]),
            open,
        })
    }

    #[test]
    fn questions_keep_their_answers_until_they_are_opened() {
        assert_eq!(shown(question(false)), "  ? Which fades?\n    1) Rₛ\n    2) Rₚ\n    the answer: lesson c/s/q\n");
        assert_eq!(
            shown(question(true)),
            "  ? Which fades?\n    1) Rₛ\n       wrong: It grows.\n    2) Rₚ\n       right: At θ_B.\n    c/s/q\n"
        );
    }

    #[test]
    fn numbers_say_what_is_asked_for() {
        let number = |open| {
            Block::Question(Question {
                address: "c/s/q".to_owned(),
                prompt: vec![Span::plain("How much?")],
                answers: Answers::Number {
                    value: 0.04,
                    unit: "1".to_owned(),
                    tolerance: 0.01,
                    response: Phrase::parse("by R_0"),
                },
                open,
            })
        };
        assert_eq!(shown(number(false)), "  ? How much?\n    a number [1]\n    the answer: lesson c/s/q\n");
        assert_eq!(shown(number(true)), "  ? How much?\n    0.04 within 1 %: by R₀\n    c/s/q\n");
    }

    #[test]
    fn what_is_folded_shows_its_summary_alone() {
        let fold = |open| {
            let blocks = vec![Block::text(4, Tone::Plain, Phrase::verbatim("inside"))];
            Block::Fold(crate::block::Fold { summary: vec![Span::plain("2 hops")], blocks, open })
        };
        assert_eq!(shown(fold(false)), "    2 hops\n");
        assert_eq!(shown(fold(true)), "    inside\n\n");
    }
}
