//! What a page asks for: `{{#lesson fresnel/brewster n_t=gold}}`, `{{#lesson-steps fresnel}}`, `{{#lesson-coverage}}`.

use chapters::parameter::excerpt;
use std::ops::Range;

/// How it begins.
const OPENING: &str = "{{#lesson";
/// What may follow at once.
const KINDS: [(&str, Kind); 5] = [
    ("", Kind::Part),
    ("-chapters", Kind::Chapters),
    ("-steps", Kind::Steps),
    ("-coverage", Kind::Coverage),
    ("-exercises", Kind::Exercises),
];
/// How it ends.
const CLOSING: &str = "}}";

/// What stands in the text of a page.
#[derive(Debug, PartialEq, Eq)]
pub enum Piece<'a> {
    /// Text.
    Text(&'a str),
    /// A part of the lecture.
    Lesson(Directive<'a>),
}

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A chapter, a step, an item or a number, here.
    Part,
    /// The chapters, a list here.
    Chapters,
    /// The steps of a chapter: a list here, and a page for each below this one.
    Steps,
    /// The rows of the lecture, and where they are taught.
    Coverage,
    /// The exercises, what each asks and its hints.
    Exercises,
}

/// A part of the lecture that is to stand there.
#[derive(Debug, PartialEq, Eq)]
pub struct Directive<'a> {
    /// What is asked for.
    pub kind: Kind,
    /// The line that it is on, from 1.
    pub line: usize,
    /// Whether there is nothing else on that line.
    pub is_alone: bool,
    /// What it is called.
    pub address: Vec<&'a str>,
    /// What is set, `name=value`.
    pub changes: Vec<(&'a str, &'a str)>,
}

/// Why a text cannot be read.
#[derive(Debug, PartialEq, Eq)]
pub struct Unread {
    /// The line.
    pub line: usize,
    /// Why.
    pub why: String,
}

/// The pieces of a page in order. A backslash before it leaves what follows to be read, as mdBook has it of its own.
///
/// # Errors
/// Where one does not end on its line, or names nothing.
pub fn pieces(text: &str) -> Result<Vec<Piece<'_>>, Unread> {
    let mut pieces = Vec::new();
    let (mut written, mut from) = (0, 0);
    while let Some(found) = text[from..].find(OPENING).map(|found| from + found) {
        let inside = found + OPENING.len();
        from = inside;
        let line_end = text[inside..].find('\n').map_or(text.len(), |end| inside + end);
        let line = 1 + text[..found].matches('\n').count();
        let word = text[inside..line_end].split([' ', '\t', '\r', '}']).next().unwrap_or_default();
        if !(word.is_empty() || word.starts_with('-')) {
            continue;
        }
        if is_code(&text[..found]) {
            continue;
        }
        if text[..found].ends_with('\\') {
            pieces.push(Piece::Text(&text[written..found - 1]));
            written = found;
            continue;
        }
        let unread = |why: String| Unread { line, why };
        let kind = KINDS.iter().find(|(known, _)| *known == word).map(|(_, kind)| *kind).ok_or_else(|| {
            let valid = KINDS.map(|(known, _)| format!("{OPENING}{known}")).join(", ");
            unread(format!("{OPENING}{}: valid: {valid}", excerpt(word)))
        })?;
        let inside = inside + word.len();
        let end = text[inside..line_end].find(CLOSING);
        let end = end.ok_or_else(|| unread(format!("no {CLOSING} on the line of {OPENING}")))?;
        let (words, after) = (&text[inside..inside + end], inside + end + CLOSING.len());
        let (address, changes) = read(words);
        let (is_right, valid) = match kind {
            Kind::Part => (!address.is_empty(), "chapter/step/item name=value"),
            Kind::Steps => (address.len() == 1, "chapter name=value"),
            Kind::Chapters | Kind::Coverage | Kind::Exercises => (address.is_empty() && changes.is_empty(), ""),
        };
        if !is_right {
            let valid = format!("{OPENING}{word} {valid}").trim_end().to_owned();
            return Err(unread(format!("{OPENING}{word}{CLOSING}: valid: {valid}{CLOSING}")));
        }
        pieces.push(Piece::Text(&text[written..found]));
        let is_alone = is_blank_around(text, found..after, line_end);
        pieces.push(Piece::Lesson(Directive { kind, line, is_alone, address, changes }));
        (written, from) = (after, after);
    }
    pieces.push(Piece::Text(&text[written..]));
    Ok(pieces)
}

/// Whether what follows a text is code in Markdown: within a fence, or behind an odd number of backticks on its line.
pub fn is_code(text: &str) -> bool {
    let (before, line) = text.rsplit_once('\n').unwrap_or(("", text));
    let fences = before.lines().filter(|line| line.trim_start().starts_with("```")).count();
    fences % 2 == 1 || line.matches('`').count() % 2 == 1
}

/// The words of an address, and what is set.
fn read(words: &str) -> (Vec<&str>, Vec<(&str, &str)>) {
    let (mut address, mut changes) = (Vec::new(), Vec::new());
    for word in words.split_whitespace() {
        match word.split_once('=') {
            Some(change) => changes.push(change),
            None => address.push(word),
        }
    }
    (address, changes)
}

/// Whether there is nothing else on the line of a range.
fn is_blank_around(text: &str, range: Range<usize>, line_end: usize) -> bool {
    let line_start = text[..range.start].rfind('\n').map_or(0, |end| end + 1);
    text[line_start..range.start].trim().is_empty() && text[range.end..line_end].trim().is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn asked<'a>(line: usize, is_alone: bool, address: &[&'a str], changes: &[(&'a str, &'a str)]) -> Directive<'a> {
        Directive { kind: Kind::Part, line, is_alone, address: address.to_vec(), changes: changes.to_vec() }
    }

    #[test]
    fn addresses_and_settings_are_read() {
        assert_eq!(
            pieces("a\n\n  {{#lesson fresnel/snell n_t=gold theta=5deg}} \nR is {{#lesson fresnel brewster theta_b}}.")
                .unwrap(),
            [
                Piece::Text("a\n\n  "),
                Piece::Lesson(asked(3, true, &["fresnel/snell"], &[("n_t", "gold"), ("theta", "5deg")])),
                Piece::Text(" \nR is "),
                Piece::Lesson(asked(4, false, &["fresnel", "brewster", "theta_b"], &[])),
                Piece::Text("."),
            ]
        );
        let of = |kind, address: &[&'static str]| Piece::Lesson(Directive { kind, ..asked(1, true, address, &[]) });
        assert_eq!(pieces("{{#lesson-steps fresnel}}").unwrap()[1], of(Kind::Steps, &["fresnel"]));
        assert_eq!(pieces("{{#lesson-coverage}}").unwrap()[1], of(Kind::Coverage, &[]));
    }

    #[test]
    fn others_and_those_behind_a_backslash_are_left() {
        assert_eq!(pieces("{{#lessons x}} {{#include x}}").unwrap(), [Piece::Text("{{#lessons x}} {{#include x}}")]);
        assert_eq!(pieces("so: \\{{#lesson x}}").unwrap(), [Piece::Text("so: "), Piece::Text("{{#lesson x}}")]);
    }

    #[test]
    fn code_is_left() {
        for code in ["as `{{#lesson x}}` says", "```text\n{{#lesson x}}\n```\n", "  ```\r\n{{#lesson x}}\r\n"] {
            assert_eq!(pieces(code).unwrap(), [Piece::Text(code)]);
        }
        assert_eq!(pieces("```\ncode\n```\n`a` {{#lesson x}}").unwrap().len(), 3);
    }

    #[test]
    fn what_does_not_end_or_names_nothing_is_refused_with_its_line() {
        assert_eq!(pieces("\n{{#lesson fresnel\n}}").unwrap_err().line, 2);
        assert_eq!(pieces("{{#lesson n_t=1.5}}").unwrap_err().line, 1);
        assert_eq!(pieces("a\r\nb\r\n{{#lesson}}").unwrap_err().line, 3);
        for (bad, valid) in [
            ("{{#lesson-stps fresnel}}", "{{#lesson, {{#lesson-chapters, {{#lesson-steps, "),
            ("{{#lesson-steps}}", "{{#lesson-steps chapter name=value}}"),
            ("{{#lesson-steps a b}}", "{{#lesson-steps chapter name=value}}"),
            ("{{#lesson-coverage a}}", "{{#lesson-coverage}}"),
        ] {
            let why = pieces(bad).unwrap_err().why;
            assert!(why.contains("valid: ") && why.contains(valid), "{why}");
        }
    }

    proptest! {
        #[test]
        fn of_any_text_nothing_is_lost(text in "([a-z{}#\\\\ \n=é]|\\{\\{#lesson |\\}\\}){0,60}") {
            let Ok(pieces) = pieces(&text) else { return Ok(()) };
            let kept: usize = pieces.iter().map(|piece| if let Piece::Text(text) = piece { text.len() } else { 0 }).sum();
            prop_assert!(kept <= text.len());
            if !text.contains(OPENING) {
                prop_assert_eq!(kept, text.len());
            }
        }
    }
}
