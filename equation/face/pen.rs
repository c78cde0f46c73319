//! What a format must know to draw a face: its marks, and how tightly what it drew holds together.

use super::name::Name;
use crate::rational::Rational;
use crate::symbol::Rank;

/// The marks of a format.
pub(super) trait Pen: Copy {
    /// What it leaves: text, or a block of lines.
    type Ink;
    /// Whether exponents are smaller than what stands beside them; otherwise the star of E* H could be a product's.
    const RAISES: bool;
    /// Whether everything stands on one line.
    fn is_flat(self) -> bool;
    /// The pen for what is above or below a bar or in an exponent.
    fn inner(self) -> Self;
    fn name(self, name: &Name, rank: Rank) -> Self::Ink;
    /// A number ≥ 0, and how tightly its face holds together.
    fn number(self, value: Rational) -> Written<Self>;
    /// A sign between two parts, with the space that belongs around it.
    fn infix(self, sign: Sign) -> Self::Ink;
    /// A mark directly before what it acts on: −, ∇, ∂, d.
    fn prefix(self, mark: char) -> Self::Ink;
    fn word(self, word: &str) -> Self::Ink;
    /// What stands between a function's word and a bare argument.
    fn apply(self) -> Self::Ink;
    /// What stands between two neighbours.
    fn gap(self, gap: Gap) -> Self::Ink;
    fn fraction(self, above: Self::Ink, below: Self::Ink) -> Self::Ink;
    fn root(self, of: Written<Self>) -> Written<Self>;
    fn exponential(self, of: Self::Ink) -> Written<Self>;
    fn raise(self, base: Self::Ink, exponent: Self::Ink) -> Self::Ink;
    fn exponent(self, value: Rational) -> Self::Ink;
    fn fence(self, open: char, inner: Self::Ink, close: char) -> Self::Ink;
    fn integral(self, sign: char, bounds: Option<(Self::Ink, Option<Self::Ink>)>) -> Self::Ink;
    fn row(self, parts: Vec<Self::Ink>) -> Self::Ink;
    /// Whether a face begins with a parenthesis.
    fn opens(self, face: &Self::Ink) -> bool;
}

/// Signs between two parts.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Sign {
    Plus,
    Minus,
    Times,
    Dot,
    Cross,
    Comma,
    Equal,
    Approximate,
    Proportional,
}

/// The space between two neighbours of a product.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Gap {
    /// None: kz, 2π.
    Tight,
    /// Two things: n₁ sin θ₁.
    Loose,
    /// Before a differential.
    Differential,
}

/// How tightly a face holds together, from loose to tight.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) enum Level {
    Sum,
    Negative,
    /// A quotient on one line, or a derivative.
    Slash,
    /// a×b, a·b, ∫ f dx: may end a product bare.
    Open,
    Product,
    /// sin x, ∇f, dx, √x.
    Prefix,
    /// A fraction of two storeys, or something that already carries an exponent.
    Script,
    Atom,
}

pub(super) type Written<P> = (<P as Pen>::Ink, Level);
