//! The text of a scene file, and how a place in it is shown.

use super::tree::Node;
use crate::stop::Stop;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use chapters::parameter::Fault;
use std::fs::{self, File};
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A text and whence it comes.
#[derive(Clone, Debug)]
pub struct Source {
    pub path: PathBuf,
    pub text: String,
}

/// What is wrong, and where in the text; None is all of it.
#[derive(Debug)]
pub struct Snag {
    pub span: Option<Range<usize>>,
    pub fault: Fault,
}

impl Snag {
    pub fn at(node: &Node, fault: Fault) -> Self {
        Self { span: Some(node.span.clone()), fault }
    }
}

/// The largest scene file [byte]: a shape takes a hundred.
pub const LARGEST: u64 = 8 << 20;

/// What some editors put before a text in UTF-8.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// How wide an excerpt may be [columns].
const WIDTH: usize = 100;

impl Source {
    /// Reads a scene file.
    pub fn open(path: &Path) -> Result<Self, Stop> {
        let bytes = bounded(path, LARGEST).map_err(|why| Stop::at(path.display(), why))?;
        Self::new(path, bytes)
    }

    /// From what a file holds.
    pub fn new(path: &Path, bytes: Vec<u8>) -> Result<Self, Stop> {
        let mut text = String::from_utf8(bytes).map_err(|error| {
            let at = error.utf8_error().valid_up_to();
            Stop::at(path.display(), format!("is no text: from byte {at} on it is not UTF-8"))
        })?;
        if let Some(at) = text.find('\0') {
            return Err(Stop::at(path.display(), format!("is no text: byte {at} is 0")));
        }
        if text.starts_with(BYTE_ORDER_MARK) {
            text.drain(..BYTE_ORDER_MARK.len_utf8());
        }
        match text.trim().is_empty() {
            true => Err(Stop::at(path.display(), "is empty")),
            false => Ok(Self { path: path.to_owned(), text }),
        }
    }

    /// The refusal of the file for a snag: file, line and column, what is wrong, and the line.
    pub fn refuse(&self, snag: Snag) -> Stop {
        let path = self.path.display();
        let fault = Fault { place: shortened(&snag.fault.place), ..snag.fault };
        let what = Stop::unknown(fault, std::iter::empty());
        let Some(span) = snag.span else { return what.within(path) };
        let span = self.first_line(span);
        let (before, column) = self.place(span.start);
        let shown = Snippet::source(&self.text).fold(true).annotation(AnnotationKind::Primary.span(span));
        let shown = Renderer::plain().term_width(WIDTH).render(&[Group::with_level(Level::ERROR).element(shown)]);
        match what.within(format!("{path}:{before}:{column}")) {
            Stop::Refused(message) => Stop::Refused(format!("{message}\n{shown}")),
            stop => stop,
        }
    }

    /// What of a span stands on its first line, within the text.
    fn first_line(&self, span: Range<usize>) -> Range<usize> {
        let whole = |at: usize| (0..=at.min(self.text.len())).rev().find(|at| self.text.is_char_boundary(*at));
        let start = whole(span.start).unwrap_or_default();
        let end = whole(span.end).unwrap_or_default().max(start);
        let line = self.text[start..end].find(['\n', '\r']).map_or(end, |length| start + length);
        start..line
    }

    /// Line and column of a byte, counted from 1; columns in characters.
    fn place(&self, at: usize) -> (usize, usize) {
        let before = &self.text[..at];
        let line = before.rfind('\n').map_or(0, |end| end + 1);
        (1 + before.matches('\n').count(), 1 + before[line..].chars().count())
    }
}

/// The longest place that is told as it is, and what is left of a longer one's beginning and end [characters]: names in a file
/// may be of any length.
const PLACE: usize = 160;
const ENDS: [usize; 2] = [80, 60];

fn shortened(place: &str) -> String {
    let count = place.chars().count();
    if count <= PLACE {
        return place.to_owned();
    }
    let [first, last] = ENDS;
    let beginning: String = place.chars().take(first).collect();
    let end: String = place.chars().skip(count - last).collect();
    format!("{beginning}…{end}")
}

/// What a file holds, if that is at most `largest` bytes.
pub fn bounded(path: &Path, largest: u64) -> Result<Vec<u8>, String> {
    let cannot = |error| format!("cannot be read: {error}");
    let kind = fs::metadata(path).map_err(cannot)?;
    // Pipes and devices might never end, or never begin.
    if !kind.is_file() {
        return Err(if kind.is_dir() { "is a folder" } else { "is no file" }.into());
    }
    let mut bytes = Vec::new();
    File::open(path).and_then(|file| file.take(largest + 1).read_to_end(&mut bytes)).map_err(cannot)?;
    match bytes.len() as u64 > largest {
        true => Err(format!("is larger than {} MiB, the most that is read", largest >> 20)),
        false => Ok(bytes),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str, span: Range<usize>) -> String {
        let source = Source::new(Path::new("s.toml"), text.into()).unwrap();
        source.refuse(Snag { span: Some(span), fault: Fault::new("camera", "is wrong") }).to_string()
    }

    #[test]
    fn a_place_is_shown_with_its_line() {
        let text = "a = 1\r\nlänge\t= -1 # why\r\n";
        let at = text.find("-1").unwrap();
        let expected = "s.toml:2:9: camera: is wrong\n  |\n2 | länge    = -1 # why\n  |            ^^";
        assert_eq!(shown(text, at..at + 2), expected);
        // Behind a byte order mark columns are those that an editor shows.
        assert!(shown("\u{feff}a = 1", 4..5).starts_with("s.toml:1:5: "));
    }

    #[test]
    fn no_place_is_too_far_and_no_line_too_long() {
        assert!(shown("a = [", 5..5).starts_with("s.toml:1:6: "));
        assert!(shown("a = [", 50..70).starts_with("s.toml:1:6: "));
        assert!(shown("ä", 1..2).starts_with("s.toml:1:1: "));
        // A table of many lines is shown by its first.
        assert_eq!(shown("{\n1\n}\n", 0..6).lines().count(), 4);
        let long = format!("a = [{}]", "1.0, ".repeat(100_000));
        assert!(shown(&long, 250_001..250_004).lines().all(|line| line.chars().count() <= WIDTH));
    }

    #[test]
    fn a_place_of_long_names_is_told_by_its_ends() {
        let source = Source::new(Path::new("s.toml"), b"a = 1".to_vec()).unwrap();
        let told = |place: &str| source.refuse(Snag { span: None, fault: Fault::new(place, "is wrong") }).to_string();
        let name = "ä".repeat(151);
        assert_eq!(told(&format!("materials{name}")), format!("s.toml: materials{name}: is wrong"));
        let long = told(&format!("materials.{}.alpha", "ä".repeat(3000)));
        assert!(long.starts_with("s.toml: materials.ää") && long.ends_with("ää.alpha: is wrong"), "{long}");
        assert_eq!(long.chars().count(), "s.toml: : is wrong".len() + 80 + 1 + 60);
    }

    #[test]
    fn what_is_no_text_is_refused() {
        let refused = |bytes: &[u8]| Source::new(Path::new("s.toml"), bytes.into()).unwrap_err().to_string();
        assert_eq!(refused(b"a = \xff"), "s.toml: is no text: from byte 4 on it is not UTF-8");
        assert_eq!(refused(b"a = \0"), "s.toml: is no text: byte 4 is 0");
        assert_eq!(refused(b"\xef\xbb\xbf \r\n\t"), "s.toml: is empty");
    }
}
