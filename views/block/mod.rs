//! What is told, as a list of blocks: all that a terminal, a web page or a notebook has to know how to show.
//!
//! Blocks say what something is. A page of fixed pitch needs a little more where a paragraph could stand in several
//! columns; that is an [`Inset`], which other media leave alone.

mod cells;
mod question;
mod span;

#[cfg(feature = "png")]
pub(crate) use cells::pale;
pub use cells::{Cell, Cells, Strips};
pub use question::{Answers, Choice, Question};
pub use span::{Span, Tone};

use crate::report::{Number, Verdict};
use chapters::text::Phrase;
use equation::face;

/// What is shown of equations and derivations besides themselves, where not everything can be folded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Details {
    /// The dimension of every line.
    pub units: bool,
    /// The single steps inside the lines.
    pub unfold: bool,
}

/// One thing that is told.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// What belongs together, apart from what is around it.
    Section(Section),
    /// Blocks without space between them.
    Group(Vec<Block>),
    /// What stands over others.
    Heading(Heading),
    /// Text.
    Paragraph(Paragraph),
    /// Points, each of one or more blocks.
    List(List),
    /// Text that is there to be typed or copied, line by line.
    Code(String),
    /// A line that a script may want whole.
    Line(String),
    /// Names and what they mean.
    Terms(Terms),
    /// An equation and what it says.
    Formula(Formula),
    /// Lines of a derivation.
    Lines(Lines),
    /// Rows and columns.
    Table(Table),
    /// Something that was judged.
    Judged(Judged),
    /// Extreme cases.
    Cases(Cases),
    /// What can be folded away.
    Fold(Fold),
    /// The parameters in force.
    Setting(Vec<Assignment>),
    /// Named numbers.
    Quantities(Vec<Quantity>),
    /// A plot.
    Figure(Figure),
    /// Something to think about first.
    Question(Question),
}

/// What belongs together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    /// What it is about, if it has an address.
    pub address: Option<String>,
    /// With space between them.
    pub blocks: Vec<Block>,
}

/// How much a heading stands over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rank {
    /// A chapter.
    Chapter,
    /// A step.
    Step,
    /// An entry of a list of contents.
    Entry,
    /// A part of the text.
    Part,
}

/// What stands over others.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// How much it stands over.
    pub rank: Rank,
    /// What it says.
    pub text: Vec<Span>,
    /// Where it stands in the lecture, if that is shown.
    pub address: Option<String>,
    /// Rows of the lecture that it is about.
    pub rows: Vec<String>,
}

/// Columns at which a paragraph starts on a page of fixed pitch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Inset {
    /// Its first line.
    pub first: usize,
    /// The others.
    pub rest: usize,
}

/// Text.
#[derive(Clone, Debug, PartialEq)]
pub struct Paragraph {
    /// What it says.
    pub spans: Vec<Span>,
    /// Where it starts.
    pub inset: Inset,
}

/// Points.
#[derive(Clone, Debug, PartialEq)]
pub struct List {
    /// One or more blocks each.
    pub items: Vec<Vec<Block>>,
    /// Whether there is space between them.
    pub spaced: bool,
}

/// Names and what they mean.
#[derive(Clone, Debug, PartialEq)]
pub struct Terms {
    /// Columns that the names share; without it, each is followed by a colon.
    pub width: Option<usize>,
    /// In order.
    pub items: Vec<Term>,
}

/// A name and what it means.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The name.
    pub name: Span,
    /// What it means.
    pub says: Vec<Span>,
    /// What else there is to it.
    pub note: Option<Span>,
}

/// The faces of an equation or of a part of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// One line.
    pub unicode: String,
    /// Several lines.
    pub layout: face::Block,
    /// An element of MathML.
    pub mathml: String,
    /// For LaTeX.
    pub latex: String,
}

/// An equation and what it says.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// Where it stands in the lecture.
    pub address: String,
    /// The equation.
    pub face: Face,
    /// What it says.
    pub says: Phrase,
    /// The dimension of both sides, or how they differ.
    pub unit: String,
    /// Whether they agree.
    pub verdict: Verdict,
    /// Rows of the lecture that it states.
    pub rows: Vec<String>,
}

/// Lines of a derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    /// From the first to the last.
    pub lines: Vec<Line>,
    /// What is shown of them where nothing folds.
    pub details: Details,
}

/// A line of a derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it states.
    pub face: Face,
    /// Its dimension, or how its sides differ.
    pub unit: String,
    /// The rules that justify it.
    pub by: Phrase,
    /// What was found of the hop to it.
    pub found: Option<Found>,
    /// What is said to it.
    pub says: Phrase,
    /// The single steps that it sums up.
    pub steps: Vec<Line>,
}

/// What was found of a hop.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Whether it holds.
    pub verdict: Verdict,
    /// How that is known.
    pub says: Phrase,
}

/// Rows and columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// What it shows.
    pub caption: Phrase,
    /// From left to right.
    pub columns: Vec<Column>,
    /// A cell for every column.
    pub rows: Vec<Vec<Span>>,
    /// Whether the columns need their heads to be understood.
    pub headed: bool,
    /// Column at which it starts on a page of fixed pitch.
    pub inset: usize,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// What stands over it.
    pub head: Phrase,
    /// Columns of fixed pitch that it takes at least; right-aligned where negative.
    pub width: i32,
}

/// Something that was judged, or whose parts were.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// Where it stands in the lecture.
    pub address: String,
    /// What became of it; none if only its parts were judged.
    pub verdict: Option<Verdict>,
    /// What it claims.
    pub claim: Vec<Span>,
    /// Rows of the lecture that it is evidence for.
    pub rows: Vec<String>,
    /// How that is known.
    pub details: Vec<Block>,
}

/// Extreme cases.
#[derive(Clone, Debug, PartialEq)]
pub struct Cases {
    /// The telling ones.
    pub cases: Vec<Case>,
    /// How many there are besides.
    pub hidden: usize,
}

/// An extreme case, and what became of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// What is computed.
    pub quantity: Phrase,
    /// The input.
    pub input: Phrase,
    /// How many inputs this one is the worst of.
    pub worst_of: usize,
    /// The exact value.
    pub reference: Phrase,
    /// Digits that are owed.
    pub owed: f64,
    /// What the textbook form gives.
    pub textbook: Phrase,
    /// Digits that it keeps.
    pub textbook_digits: f64,
    /// What the program gives.
    pub ours: Phrase,
    /// Digits that it keeps.
    pub our_digits: f64,
    /// Whether they are those owed.
    pub verdict: Verdict,
}

/// What can be folded away.
#[derive(Clone, Debug, PartialEq)]
pub struct Fold {
    /// What is shown of it folded.
    pub summary: Vec<Span>,
    /// What is folded.
    pub blocks: Vec<Block>,
    /// Whether it is shown at once.
    pub open: bool,
}

/// A parameter and its value, as one types them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assignment {
    /// The word before `=`.
    pub name: String,
    /// What stands behind it.
    pub text: String,
}

/// A named number.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Stable name.
    pub key: String,
    /// Its symbol.
    pub symbol: Phrase,
    /// Its value with the unit, as people read it.
    pub value: Phrase,
    /// The same as a number.
    pub number: Number,
    /// The unit of the number.
    pub unit: String,
    /// What it is.
    pub says: Phrase,
}

/// A plot or a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Where it stands in the lecture.
    pub address: String,
    /// What is to be seen.
    pub says: Phrase,
    /// The picture itself.
    pub picture: Picture,
}

/// Where a picture is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Picture {
    /// In a file.
    File(String),
    /// Here, as an element of SVG.
    Svg(String),
    /// Here, in the cells of a terminal.
    Cells(Cells),
    /// Here, in the pixels of a terminal.
    Strips(Strips),
    /// Nowhere yet.
    Absent,
}

impl Picture {
    /// The same, put back while something newer is on its way, if it is here in a terminal.
    pub fn dimmed(&self) -> Self {
        match self {
            Self::Cells(cells) => Self::Cells(cells.dimmed()),
            Self::Strips(strips) => Self::Strips(strips.dimmed()),
            other => other.clone(),
        }
    }
}

impl Block {
    /// A paragraph at the columns `first` and `rest`.
    pub fn paragraph(first: usize, rest: usize, spans: Vec<Span>) -> Self {
        Self::Paragraph(Paragraph { spans, inset: Inset { first, rest } })
    }

    /// A paragraph in one tone at the column `indent`.
    pub fn text(indent: usize, tone: Tone, text: Phrase) -> Self {
        Self::paragraph(indent, indent, vec![Span::new(tone, text)])
    }

    /// What belongs together, without an address.
    pub fn section(blocks: Vec<Block>) -> Self {
        Self::Section(Section { address: None, blocks })
    }
}
