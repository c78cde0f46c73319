//! Text set to a width: wrapped by display columns, coloured by meaning or not at all.

use console::Term;
use pulldown_cmark::{Event, Parser, Tag, TagEnd};
use std::io::{IsTerminal, stdout};
use unicode_width::UnicodeWidthStr;

/// What a piece of text means; the only thing that decides its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    Plain,
    Heading,
    Emphasis,
    Strong,
    Code,
    Equation,
    /// Addresses, units, asides.
    Dim,
    Good,
    Bad,
}

impl Tone {
    /// The "select graphic rendition" parameters of ECMA-48.
    fn ansi(self) -> &'static str {
        match self {
            Self::Plain => "",
            Self::Heading => "1;4",
            Self::Emphasis => "3",
            Self::Strong => "1",
            Self::Code => "33",
            Self::Equation => "36",
            Self::Dim => "2",
            Self::Good => "32",
            Self::Bad => "1;31",
        }
    }
}

/// A piece of text and what it means.
pub type Span<'a> = (Tone, &'a str);

/// A page that is being set.
#[derive(Debug)]
pub struct Page {
    width: usize,
    colour: bool,
    text: String,
}

impl Page {
    /// A page for standard output: as wide as the terminal within reason, in colour where that is wanted.
    pub fn for_stdout() -> Self {
        let terminal = stdout().is_terminal();
        let columns = Term::stdout().size_checked().map_or(80, |(_, columns)| usize::from(columns));
        let declined = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
            || std::env::var_os("TERM").is_some_and(|value| value == "dumb");
        Self::new(if terminal { columns } else { 80 }, terminal && !declined)
    }

    /// A page of `width` columns (40 to 100 are used).
    pub fn new(width: usize, colour: bool) -> Self {
        Self { width: width.clamp(40, 100), colour, text: String::new() }
    }

    /// The page so far.
    pub fn into_text(self) -> String {
        self.text
    }

    /// An empty line, unless there is one already.
    pub fn gap(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with("\n\n") {
            self.text.push('\n');
        }
    }

    /// A paragraph: the first line starts at column `first`, the others at `rest`. Lines break at spaces; spans that
    /// touch stay together.
    pub fn wrap(&mut self, first: usize, rest: usize, spans: &[Span]) {
        let mut line = Line { page: self, column: first, tone: Tone::Plain };
        line.page.spaces(first);
        let mut empty = true;
        for word in words(spans) {
            let wide: usize = word.iter().map(|(_, text)| text.width()).sum();
            let blank = word.iter().all(|(_, text)| text.trim_start().is_empty());
            if !empty && !blank && line.column + wide > line.page.width {
                line.end();
                line.page.spaces(rest);
                line.column = rest;
                word.iter().for_each(|(tone, text)| line.put(*tone, text.trim_start()));
            } else {
                word.iter().for_each(|(tone, text)| line.put(*tone, text));
            }
            empty &= blank;
        }
        line.end();
    }

    /// A paragraph in one tone at column `indent`.
    pub fn line(&mut self, indent: usize, tone: Tone, text: &str) {
        self.wrap(indent, indent, &[(tone, text)]);
    }

    /// A line that is not wrapped, because a script may want it whole.
    pub fn verbatim(&mut self, text: &str) {
        self.text.push_str(text);
        self.text.push('\n');
    }

    /// Cells padded to `widths` (right-aligned where negative), at column `indent`; the last one is wrapped.
    pub fn row(&mut self, indent: usize, widths: &[i32], cells: &[Span]) {
        let mut column = indent;
        let mut padded = Vec::new();
        for (&(tone, cell), &width) in cells.iter().zip(widths) {
            let padding = " ".repeat((width.unsigned_abs() as usize).saturating_sub(cell.width()));
            let (before, after) = if width < 0 { (padding, String::new()) } else { (String::new(), padding) };
            padded.push((tone, before + cell + &after));
        }
        let mut spans: Vec<Span> = Vec::new();
        for (at, (tone, cell)) in padded.iter().enumerate() {
            if at > 0 {
                spans.push((Tone::Plain, "  "));
            }
            spans.push((*tone, cell));
            if at + 1 < padded.len() {
                column += cell.width() + 2;
            }
        }
        self.wrap(indent, column, &spans);
    }

    /// Markdown, simply: paragraphs, lists, emphasis, code, the text of links. Headings that repeat `title` are left out.
    pub fn markdown(&mut self, source: &str, title: &str) {
        let mut block: Vec<(Tone, String)> = Vec::new();
        let (mut tones, mut depth, mut bullet, mut verbatim) = (vec![Tone::Plain], 0_usize, false, false);
        for event in Parser::new(source) {
            match event {
                Event::Start(Tag::Emphasis) => tones.push(Tone::Emphasis),
                Event::Start(Tag::Strong) => tones.push(Tone::Strong),
                Event::Start(Tag::Heading { .. }) => tones.push(Tone::Strong),
                Event::Start(Tag::List(_)) => {
                    self.block(&mut block, depth, &mut bullet);
                    depth += 1;
                }
                Event::Start(Tag::Item) => bullet = true,
                Event::Start(Tag::CodeBlock(_)) => verbatim = true,
                Event::End(TagEnd::Emphasis | TagEnd::Strong) => drop(tones.pop()),
                Event::End(TagEnd::Heading(_)) => {
                    tones.pop();
                    if block.iter().map(|(_, text)| text.as_str()).collect::<String>() == title {
                        block.clear();
                    }
                    self.block(&mut block, depth, &mut bullet);
                    self.gap();
                }
                Event::End(TagEnd::Paragraph) => {
                    self.block(&mut block, depth, &mut bullet);
                    self.gap();
                }
                Event::End(TagEnd::Item) => self.block(&mut block, depth, &mut bullet),
                Event::End(TagEnd::List(_)) => {
                    depth -= 1;
                    self.gap();
                }
                Event::End(TagEnd::CodeBlock) => {
                    verbatim = false;
                    self.gap();
                }
                Event::Text(text) if verbatim => {
                    for line in text.lines() {
                        self.row(4, &[0], &[(Tone::Code, line)]);
                    }
                }
                Event::Text(text) => block.push((*tones.last().unwrap_or(&Tone::Plain), text.into_string())),
                Event::Code(text) => block.push((Tone::Code, text.into_string())),
                Event::SoftBreak | Event::HardBreak => block.push((Tone::Plain, " ".to_owned())),
                _ => {}
            }
        }
        self.gap();
    }

    /// Sets and empties the `block` of a list of `depth`, 0 for text outside lists.
    fn block(&mut self, block: &mut Vec<(Tone, String)>, depth: usize, bullet: &mut bool) {
        if block.is_empty() {
            return;
        }
        let indent = 2 * depth;
        if std::mem::take(bullet) {
            block.insert(0, (Tone::Plain, "• ".to_owned()));
        }
        let hanging = if block[0].1 == "• " { indent + 2 } else { indent };
        let spans: Vec<Span> = block.iter().map(|(tone, text)| (*tone, text.as_str())).collect();
        self.wrap(indent, hanging, &spans);
        block.clear();
    }

    fn spaces(&mut self, count: usize) {
        self.text.extend(std::iter::repeat_n(' ', count));
    }

    /// Changes the colour from one tone's to another's.
    fn paint(&mut self, from: Tone, to: Tone) {
        if !self.colour || from == to {
            return;
        }
        if from != Tone::Plain {
            self.text.push_str("\x1b[0m");
        }
        if to != Tone::Plain {
            self.text.push_str(&format!("\x1b[{}m", to.ansi()));
        }
    }
}

/// The words of `spans`, each with the space before it, in pieces of one tone.
fn words<'a>(spans: &[Span<'a>]) -> Vec<Vec<Span<'a>>> {
    let mut words: Vec<Vec<Span>> = Vec::new();
    for &(tone, text) in spans {
        let mut start = 0;
        while start < text.len() {
            let next = text[start..].char_indices().skip(1).find(|(_, letter)| *letter == ' ');
            let end = next.map_or(text.len(), |(at, _)| start + at);
            let piece = (tone, &text[start..end]);
            match words.last_mut() {
                Some(word) if !piece.1.starts_with(' ') => word.push(piece),
                _ => words.push(vec![piece]),
            }
            start = end;
        }
    }
    words
}

/// The line being filled.
struct Line<'a> {
    page: &'a mut Page,
    column: usize,
    tone: Tone,
}

impl Line<'_> {
    fn put(&mut self, tone: Tone, text: &str) {
        self.page.paint(self.tone, tone);
        self.tone = tone;
        self.page.text.push_str(text);
        self.column += text.width();
    }

    /// Ends the line: no spaces at its end, no colour beyond it.
    fn end(&mut self) {
        self.page.text.truncate(self.page.text.trim_end_matches(' ').len());
        self.page.paint(self.tone, Tone::Plain);
        self.tone = Tone::Plain;
        self.page.text.push('\n');
    }
}

/// Label markup (`R_s`, `10^{−6}`) with Unicode's own small letters where it has them all.
pub fn label(markup: &str) -> String {
    let (mut out, mut rest) = (String::new(), markup);
    while let Some(at) = rest.find(['_', '^']) {
        out.push_str(&rest[..at]);
        let (mark, tail) = rest[at..].split_at(1);
        let (body, next) = match tail.strip_prefix('{').and_then(|open| open.split_once('}')) {
            Some(split) => split,
            None => tail.split_at(tail.chars().next().map_or(0, char::len_utf8)),
        };
        let small: Option<String> = body.chars().map(|letter| shifted(letter, mark == "_")).collect();
        out.push_str(&small.unwrap_or_else(|| format!("{mark}{body}")));
        rest = next;
    }
    out + rest
}

/// The lowered or raised form of a letter, if Unicode has one.
fn shifted(letter: char, lowered: bool) -> Option<char> {
    const PLAIN: &str = "0123456789+−=()aehijklmnoprstuvx";
    const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ";
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ᵃᵉʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛˣ";
    let at = PLAIN.chars().position(|plain| plain == letter)?;
    if lowered { LOWERED } else { RAISED }.chars().nth(at)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(width: usize, spans: &[Span]) -> String {
        let mut page = Page::new(width, false);
        page.wrap(2, 4, spans);
        page.into_text()
    }

    #[test]
    fn lines_wrap_by_columns_not_bytes() {
        let text = set(40, &[(Tone::Plain, "θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁ θ₁")]);
        assert!(text.lines().all(|line| line.width() <= 40), "{text}");
        assert_eq!(text.lines().count(), 2);
        assert!(text.lines().nth(1).unwrap().starts_with("    θ"));
    }

    #[test]
    fn spans_that_touch_stay_together() {
        assert_eq!(set(40, &[(Tone::Plain, "see "), (Tone::Code, "x"), (Tone::Plain, ", then")]), "  see x, then\n");
    }

    #[test]
    fn a_word_in_several_tones_wraps_as_one() {
        let text = set(
            40,
            &[(Tone::Plain, "thirty-two columns are taken by this ("), (Tone::Code, "r_s"), (Tone::Plain, ").")],
        );
        assert_eq!(text, "  thirty-two columns are taken by this\n    (r_s).\n");
        let text =
            set(40, &[(Tone::Plain, "thirty-six columns are taken by this "), (Tone::Code, "r_s"), (Tone::Plain, ".")]);
        assert_eq!(text, "  thirty-six columns are taken by this\n    r_s.\n");
    }

    #[test]
    fn rows_align_and_wrap_their_last_cell() {
        let mut page = Page::new(40, false);
        let cells =
            [(Tone::Plain, "θ_B"), (Tone::Plain, "1.5"), (Tone::Plain, "the angle that is called after Brewster")];
        page.row(2, &[4, -5, 0], &cells);
        page.row(0, &[-6, 0], &[(Tone::Plain, "16"), (Tone::Plain, "x")]);
        page.row(0, &[-6, 0], &[(Tone::Plain, "123456"), (Tone::Plain, "x")]);
        assert_eq!(
            page.into_text(),
            "  θ_B     1.5  the angle that is called\n               after Brewster\n    16  x\n123456  x\n"
        );
    }

    #[test]
    fn markdown_becomes_paragraphs_and_lists() {
        let mut page = Page::new(60, false);
        page.markdown("## Title\n\nSome *soft* and\n`hard` text.\n\n- one\n- two\n  more\n\nend", "Title");
        assert_eq!(page.into_text(), "Some soft and hard text.\n\n  • one\n  • two more\n\nend\n\n");
    }

    #[test]
    fn colour_ends_where_its_meaning_does() {
        let mut page = Page::new(60, true);
        page.wrap(2, 2, &[(Tone::Good, "it holds"), (Tone::Plain, " so")]);
        assert_eq!(page.into_text(), "  \x1b[32mit holds\x1b[0m so\n");
    }

    #[test]
    fn labels_use_small_letters_where_there_are_all() {
        assert_eq!(label("R_s"), "Rₛ");
        assert_eq!(label("θ_B"), "θ_B");
        assert_eq!(label("10^{−6}"), "10⁻⁶");
        assert_eq!(label("n_t/n_i"), "nₜ/nᵢ");
    }
}
