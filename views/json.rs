//! Reports and blocks as JSON.

use crate::block::{
    Answers, Block, Case, Choice, Face, Figure, Heading, Line, Picture, Quantity, Question, Rank, Span, Term, Tone,
};
use crate::report::{Number, Report};
use crate::words::Words;
use chapters::CURRICULUM;
use chapters::lecture::coverage;
use chapters::text::{Phrase, Piece, Shift};
use serde_json::{Value, json};

/// A report as one document.
pub fn report(report: &Report) -> String {
    serde_json::to_string_pretty(report).expect("plain data") + "\n"
}

/// The lecture's rows and what the curriculum has for each, as one document.
pub fn rows() -> String {
    let rows: Vec<_> = coverage(CURRICULUM)
        .iter()
        .map(|row| {
            json!({
                "id": row.row.id,
                "chapter": row.row.chapter,
                "steps": row.steps,
                "need": row.row.needs.chars().collect::<Vec<_>>(),
                "met": row.met,
                "missing": row.missing,
            })
        })
        .collect();
    format!("{:#}\n", json!({ "rows": rows }))
}

/// Blocks, each an object with its `kind`.
pub fn blocks(blocks: &[Block]) -> Value {
    blocks.iter().map(block).collect()
}

fn block(block: &Block) -> Value {
    match block {
        Block::Section(section) => {
            json!({ "kind": "section", "address": section.address, "blocks": blocks(&section.blocks) })
        }
        Block::Group(inner) => json!({ "kind": "group", "blocks": blocks(inner) }),
        Block::Heading(heading) => head(heading),
        Block::Paragraph(paragraph) => json!({ "kind": "paragraph", "spans": spans(&paragraph.spans) }),
        Block::List(list) => {
            json!({ "kind": "list", "items": list.items.iter().map(|item| blocks(item)).collect::<Vec<_>>() })
        }
        Block::Code(code) => json!({ "kind": "code", "text": code }),
        Block::Line(line) => json!({ "kind": "line", "text": line }),
        Block::Terms(terms) => json!({ "kind": "terms", "items": terms.items.iter().map(term).collect::<Vec<_>>() }),
        Block::Formula(formula) => json!({
            "kind": "formula", "address": formula.address, "face": face(&formula.face), "says": phrase(&formula.says),
            "unit": formula.unit, "verdict": formula.verdict, "rows": formula.rows,
        }),
        Block::Lines(told) => json!({ "kind": "lines", "lines": chain(&told.lines) }),
        Block::Table(table) => json!({
            "kind": "table", "caption": phrase(&table.caption),
            "columns": table.columns.iter().map(|column| phrase(&column.head)).collect::<Vec<_>>(),
            "rows": table.rows.iter().map(|row| spans(row)).collect::<Vec<_>>(),
        }),
        Block::Judged(judged) => json!({
            "kind": "judged", "address": judged.address, "verdict": judged.verdict, "claim": spans(&judged.claim),
            "rows": judged.rows, "details": blocks(&judged.details),
        }),
        Block::Cases(cases) => json!({
            "kind": "cases", "cases": cases.cases.iter().map(case).collect::<Vec<_>>(), "hidden": cases.hidden,
        }),
        Block::Fold(fold) => json!({
            "kind": "fold", "summary": spans(&fold.summary), "open": fold.open, "blocks": blocks(&fold.blocks),
        }),
        Block::Setting(setting) => {
            let set: Vec<_> = setting.iter().map(|set| json!({ "name": set.name, "text": set.text })).collect();
            json!({ "kind": "setting", "parameters": set })
        }
        Block::Quantities(quantities) => {
            json!({ "kind": "quantities", "quantities": quantities.iter().map(quantity).collect::<Vec<_>>() })
        }
        Block::Figure(figure) => picture("figure", figure),
        Block::Question(asked) => question(asked),
    }
}

fn head(heading: &Heading) -> Value {
    let level = match heading.rank {
        Rank::Chapter => 1,
        Rank::Step => 2,
        Rank::Entry | Rank::Part => 3,
    };
    json!({
        "kind": "heading", "level": level, "text": spans(&heading.text), "address": heading.address,
        "rows": heading.rows,
    })
}

fn term(term: &Term) -> Value {
    json!({ "name": span(&term.name), "says": spans(&term.says), "note": term.note.as_ref().map(span) })
}

fn face(face: &Face) -> Value {
    json!({ "unicode": face.unicode, "latex": face.latex, "mathml": face.mathml })
}

fn chain(lines: &[Line]) -> Value {
    let told = |line: &Line| {
        let found = line.found.as_ref().map(|found| json!({ "verdict": found.verdict, "says": phrase(&found.says) }));
        json!({
            "face": face(&line.face), "unit": line.unit, "by": phrase(&line.by), "found": found,
            "says": phrase(&line.says), "steps": chain(&line.steps),
        })
    };
    lines.iter().map(told).collect()
}

fn case(case: &Case) -> Value {
    json!({
        "quantity": phrase(&case.quantity), "input": phrase(&case.input), "worst_of": case.worst_of,
        "reference": phrase(&case.reference), "owed_digits": case.owed,
        "textbook": phrase(&case.textbook), "textbook_digits": case.textbook_digits,
        "ours": phrase(&case.ours), "our_digits": case.our_digits, "verdict": case.verdict,
    })
}

fn quantity(quantity: &Quantity) -> Value {
    json!({
        "key": quantity.key, "symbol": phrase(&quantity.symbol), "text": phrase(&quantity.value),
        "value": quantity.number, "unit": quantity.unit, "says": phrase(&quantity.says),
    })
}

fn picture(kind: &str, figure: &Figure) -> Value {
    let (path, svg) = match &figure.picture {
        Picture::File(path) => (Some(path), None),
        Picture::Svg(svg) => (None, Some(svg)),
        Picture::Cells(_) | Picture::Strips(_) | Picture::Absent => (None, None),
    };
    json!({ "kind": kind, "address": figure.address, "says": phrase(&figure.says), "path": path, "svg": svg })
}

/// A question with its answer folded: whoever shows it decides when.
fn question(question: &Question) -> Value {
    let choices: Option<Vec<_>> = match &question.answers {
        Answers::Choices(choices) => Some(choices.iter().map(|choice| phrase(&choice.says)).collect()),
        Answers::Number { .. } => None,
    };
    let answer = match &question.answers {
        Answers::Choices(choices) => {
            let response = |choice: &Choice| json!({ "right": choice.right, "response": phrase(&choice.response) });
            json!({ "choices": choices.iter().map(response).collect::<Vec<_>>() })
        }
        Answers::Number { value, unit, tolerance, response } => json!({
            "value": Number(*value), "unit": unit, "tolerance": tolerance, "response": phrase(response),
        }),
    };
    json!({
        "kind": "question", "address": question.address, "prompt": spans(&question.prompt), "choices": choices,
        "fold": { "told": phrase(&question.answers.told(Words::ENGLISH)), "answer": answer },
    })
}

fn spans(spans: &[Span]) -> Value {
    spans.iter().map(span).collect()
}

fn span(span: &Span) -> Value {
    match &span.mathml {
        Some(mathml) => json!({ "tone": tone(span.tone), "text": phrase(&span.text), "mathml": mathml }),
        None => json!({ "tone": tone(span.tone), "text": phrase(&span.text) }),
    }
}

fn tone(tone: Tone) -> &'static str {
    match tone {
        Tone::Plain => "plain",
        Tone::Heading => "heading",
        Tone::Emphasis => "emphasis",
        Tone::Strong => "strong",
        Tone::Code => "code",
        Tone::Name => "name",
        Tone::Address => "address",
        Tone::Equation => "equation",
        Tone::Dim => "aside",
        Tone::Good => "good",
        Tone::Bad => "bad",
    }
}

/// A phrase: a string if nothing in it is marked, otherwise a list of strings and of objects that say what they are.
fn phrase(phrase: &Phrase) -> Value {
    match &phrase.0[..] {
        [] => json!(""),
        [Piece::Plain(text)] => json!(text),
        pieces => pieces.iter().map(piece).collect(),
    }
}

fn piece(piece: &Piece) -> Value {
    match piece {
        Piece::Plain(text) => json!(text),
        Piece::Symbol { base, scripts } => {
            let script = |script: &chapters::text::Script| {
                let of = phrase(&script.of);
                if script.shift == Shift::Lowered { json!({ "lowered": of }) } else { json!({ "raised": of }) }
            };
            json!({ "symbol": base, "scripts": scripts.iter().map(script).collect::<Vec<_>>() })
        }
        Piece::Number { factor, power } => json!({ "factor": factor, "power_of_ten": power }),
        Piece::Emphasis(of) => json!({ "emphasis": phrase(of) }),
        Piece::Strong(of) => json!({ "strong": phrase(of) }),
        Piece::Code(of) => json!({ "code": phrase(of) }),
    }
}
