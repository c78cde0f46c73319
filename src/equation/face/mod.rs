//! Faces: an expression as LaTeX, MathML or one line of Unicode.
//!
//! One walk over the tree decides what goes in parentheses and what stands side by side; a pen knows the
//! marks of its format. Unicode has a single line, so there fractions become slashes.

mod latex;
mod mathml;
mod name;
mod unicode;

use super::expr::{Expr, Function, Nabla, Node, Range};
use super::rational::Rational;
use super::symbol::{Rank, Symbol};
use super::{Equation, Relation};
use name::Name;
use std::fmt;

pub(super) use unicode::superscript;

impl Expr {
    /// As LaTeX, for math mode.
    pub fn latex(&self) -> String {
        write(&latex::Latex, self).0
    }

    /// As a MathML element.
    pub fn mathml(&self) -> String {
        mathml::element(&write(&mathml::MathMl, self).0, "inline")
    }
}

impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&write(&unicode::Unicode, self).0)
    }
}

impl Equation {
    /// As LaTeX, for math mode.
    pub fn latex(&self) -> String {
        relate(&latex::Latex, self)
    }

    /// As a MathML element in display style.
    pub fn mathml(&self) -> String {
        mathml::element(&relate(&mathml::MathMl, self), "block")
    }
}

impl fmt::Display for Equation {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&relate(&unicode::Unicode, self))
    }
}

impl Symbol {
    /// Its name as LaTeX, for math mode.
    pub fn latex(&self) -> String {
        latex::Latex.name(&Name::parse(self.name()), self.rank())
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&unicode::Unicode.name(&Name::parse(self.name()), self.rank()))
    }
}

impl Function {
    /// The word or sign it is known by.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sqrt => "√",
            Self::Exp => "exp",
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Asin => "arcsin",
            Self::Acos => "arccos",
            Self::Atan => "arctan",
            Self::Conj => "conj",
            Self::Abs => "abs",
            Self::Re => "Re",
            Self::Im => "Im",
        }
    }

    /// Whether it is written sin x and squared as sin² x.
    fn is_trigonometric(self) -> bool {
        matches!(self, Self::Sin | Self::Cos | Self::Tan)
    }
}

/// The marks of a format.
trait Pen {
    /// Whether everything stands on one line.
    const FLAT: bool;
    fn name(&self, name: &Name, rank: Rank) -> String;
    /// A number ≥ 0, and how tightly its face holds together.
    fn number(&self, value: Rational) -> Written;
    /// A sign between two parts, with the space that belongs around it.
    fn infix(&self, sign: Sign) -> String;
    /// A mark directly before what it acts on: −, ∇, ∂, d.
    fn prefix(&self, mark: char) -> String;
    fn word(&self, word: &str) -> String;
    /// What stands between a function's word and a bare argument.
    fn apply(&self) -> String;
    /// What stands between two neighbours.
    fn gap(&self, gap: Gap) -> String;
    fn fraction(&self, above: &str, below: &str) -> String;
    fn root(&self, of: Written) -> Written;
    fn exponential(&self, of: &str) -> Written;
    fn raise(&self, base: &str, exponent: &str) -> String;
    fn exponent(&self, value: Rational) -> String;
    fn fence(&self, open: char, inner: &str, close: char) -> String;
    fn integral(&self, sign: char, bounds: Option<(&str, Option<&str>)>) -> String;
    fn row(&self, parts: &[String]) -> String;
}

/// Signs between two parts.
#[derive(Clone, Copy, PartialEq)]
enum Sign {
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
enum Gap {
    /// None: kz, 2π.
    Tight,
    /// Two things: n₁ sin θ₁.
    Loose,
    /// Before a differential.
    Differential,
}

/// How tightly a face holds together, from loose to tight.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
enum Level {
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

type Written = (String, Level);

fn relate<P: Pen>(pen: &P, equation: &Equation) -> String {
    let sign = match equation.relation {
        Relation::Equal => Sign::Equal,
        Relation::Approximate => Sign::Approximate,
        Relation::Proportional => Sign::Proportional,
    };
    pen.row(&[write(pen, &equation.lhs).0, pen.infix(sign), write(pen, &equation.rhs).0])
}

fn write<P: Pen>(pen: &P, expr: &Expr) -> Written {
    match expr.node() {
        Node::Number(value) => pen.number(*value),
        Node::Pi => (pen.name(&Name::parse("pi"), Rank::Scalar), Level::Atom),
        Node::ImaginaryUnit => (pen.word("i"), Level::Atom),
        Node::Symbol(symbol) => (pen.name(&Name::parse(symbol.name()), symbol.rank()), Level::Atom),
        Node::Apply(symbol, arguments) => {
            let name = pen.name(&Name::parse(symbol.name()), symbol.rank());
            (pen.row(&[name, pen.fence('(', &list(pen, arguments), ')')]), Level::Atom)
        }
        Node::Sum(terms) => (sum(pen, terms), Level::Sum),
        Node::Product(factors) => product(pen, factors),
        Node::Quotient(above, below) => quotient(pen, above, below),
        Node::Power(base, exponent) => power(pen, base, *exponent),
        Node::Negate(of) => (pen.row(&[pen.prefix('−'), at_least(pen, of, Level::Slash)]), Level::Negative),
        Node::Function(function, of) => apply(pen, *function, of, false),
        Node::Vector(parts) => (pen.fence('(', &list(pen, parts), ')'), Level::Atom),
        Node::Dot(a, b) => (infix(pen, a, Sign::Dot, b), Level::Open),
        Node::Cross(a, b) => (infix(pen, a, Sign::Cross, b), Level::Open),
        Node::Nabla(nabla, of) => (nabla_of(pen, *nabla, of), Level::Prefix),
        Node::Partial(of, by) => partial(pen, of, by),
        Node::Differential(of) => (pen.row(&[pen.prefix('d'), at_least(pen, of, Level::Script)]), Level::Prefix),
        Node::Mean(of) => (pen.fence('⟨', &write(pen, of).0, '⟩'), Level::Atom),
        Node::Integral(of, by, range) => (integral(pen, of, by, range), Level::Open),
    }
}

/// The face of `expr`, in parentheses if it is looser than `level`.
fn at_least<P: Pen>(pen: &P, expr: &Expr, level: Level) -> String {
    let (face, own) = write(pen, expr);
    if own >= level { face } else { pen.fence('(', &face, ')') }
}

fn list<P: Pen>(pen: &P, items: &[Expr]) -> String {
    let mut parts = Vec::new();
    for item in items {
        if !parts.is_empty() {
            parts.push(pen.infix(Sign::Comma));
        }
        parts.push(write(pen, item).0);
    }
    pen.row(&parts)
}

fn infix<P: Pen>(pen: &P, a: &Expr, sign: Sign, b: &Expr) -> String {
    pen.row(&[at_least(pen, a, Level::Product), pen.infix(sign), at_least(pen, b, Level::Product)])
}

fn sum<P: Pen>(pen: &P, terms: &[Expr]) -> String {
    let mut parts = Vec::new();
    for (at, term) in terms.iter().enumerate() {
        match term.node() {
            Node::Negate(of) if at > 0 => {
                parts.extend([pen.infix(Sign::Minus), at_least(pen, of, Level::Slash)]);
            }
            _ if at > 0 => parts.extend([pen.infix(Sign::Plus), at_least(pen, term, Level::Slash)]),
            _ => parts.push(at_least(pen, term, Level::Negative)),
        }
    }
    pen.row(&parts)
}

fn product<P: Pen>(pen: &P, factors: &[Expr]) -> Written {
    let mut parts = Vec::new();
    let mut level = Level::Product;
    let mut closed = false;
    for (at, factor) in factors.iter().enumerate() {
        let next = factors.get(at + 1);
        let (face, own) = write_before(pen, factor, next);
        // A vector product, an integral or a derivative needs no parentheses where nothing follows it.
        let bare = own >= Level::Product || (next.is_none() && (own == Level::Open || is_derivative(factor)));
        level = if bare && own < level { own } else { level };
        let face = if bare { face } else { pen.fence('(', &face, ')') };
        if at > 0 && starts_with_digit(factor) {
            parts.push(pen.infix(Sign::Times));
        } else if at > 0 {
            let tight = stands_tight(&factors[at - 1], factor) || (closed && face.starts_with('('));
            parts.push(pen.gap(match factor.node() {
                Node::Differential(_) => Gap::Differential,
                _ if tight => Gap::Tight,
                _ => Gap::Loose,
            }));
        }
        parts.push(face);
        closed = !bare;
    }
    (pen.row(&parts), level)
}

/// The face of `factor` before another one: sin θ keeps its argument bare only where the next factor cannot be
/// mistaken for a part of it.
fn write_before<P: Pen>(pen: &P, factor: &Expr, next: Option<&Expr>) -> Written {
    let safe = next.is_none_or(|next| trigonometric(next).is_some() || matches!(next.node(), Node::Differential(_)));
    match trigonometric(factor) {
        Some((function, of, exponent)) if !safe => trigonometric_face(pen, function, of, exponent, true),
        _ => write(pen, factor),
    }
}

/// The parts of sin x and sinⁿ x, n ≥ 2.
fn trigonometric(expr: &Expr) -> Option<(Function, &Expr, Option<Rational>)> {
    match expr.node() {
        Node::Function(function, of) if function.is_trigonometric() => Some((*function, of, None)),
        // A negative exponent would read as an inverse function.
        Node::Power(base, exponent) if exponent.as_integer().is_some_and(|n| n >= 2) => match base.node() {
            Node::Function(function, of) if function.is_trigonometric() => Some((*function, of, Some(*exponent))),
            _ => None,
        },
        _ => None,
    }
}

fn trigonometric_face<P: Pen>(
    pen: &P,
    function: Function,
    of: &Expr,
    exponent: Option<Rational>,
    fenced: bool,
) -> Written {
    let word = pen.word(function.name());
    let word = exponent.map_or(word.clone(), |exponent| pen.raise(&word, &pen.exponent(exponent)));
    let (argument, level) = write(pen, of);
    let is_simple = matches!(of.node(), Node::Symbol(_) | Node::Pi | Node::Number(_)) && level == Level::Atom;
    if is_simple && !fenced {
        (pen.row(&[word, pen.apply(), argument]), Level::Prefix)
    } else {
        (pen.row(&[word, pen.fence('(', &argument, ')')]), Level::Prefix)
    }
}

fn is_derivative(expr: &Expr) -> bool {
    matches!(expr.node(), Node::Partial(..))
}

fn starts_with_digit(expr: &Expr) -> bool {
    match expr.node() {
        Node::Number(_) => true,
        Node::Power(base, _) => matches!(base.node(), Node::Number(_)),
        _ => false,
    }
}

/// Whether two neighbours stand together without a space: kz, 2π, 4πr², 2(a + b).
fn stands_tight(left: &Expr, right: &Expr) -> bool {
    let is_number = matches!(left.node(), Node::Number(_) | Node::ImaginaryUnit);
    match right.node() {
        Node::Sum(_) => is_number,
        _ => is_letter(right) && (is_number || is_letter(left)),
    }
}

/// A single letter, perhaps with an exponent.
fn is_letter(expr: &Expr) -> bool {
    match expr.node() {
        Node::Pi | Node::ImaginaryUnit => true,
        Node::Symbol(symbol) => Name::parse(symbol.name()).is_letter(),
        Node::Power(base, _) => !matches!(base.node(), Node::Power(..)) && is_letter(base),
        _ => false,
    }
}

fn quotient<P: Pen>(pen: &P, above: &Expr, below: &Expr) -> Written {
    if !P::FLAT {
        return (pen.fraction(&write(pen, above).0, &write(pen, below).0), Level::Script);
    }
    let numerator = match trigonometric(above) {
        // sin(θ)/v, since sin θ/v could be the sine of a quotient; sin θ₁/sin θ₂ could not.
        Some((function, of, exponent)) if trigonometric(below).is_none() => {
            trigonometric_face(pen, function, of, exponent, true).0
        }
        _ => at_least(pen, above, Level::Product),
    };
    (pen.fraction(&numerator, &at_least(pen, below, Level::Prefix)), Level::Slash)
}

fn power<P: Pen>(pen: &P, base: &Expr, exponent: Rational) -> Written {
    if exponent.as_integer().is_some_and(|n| n >= 2)
        && let Node::Function(function, of) = base.node()
        && function.is_trigonometric()
    {
        return trigonometric_face(pen, *function, of, Some(exponent), false);
    }
    (pen.raise(&at_least(pen, base, Level::Atom), &pen.exponent(exponent)), Level::Script)
}

fn apply<P: Pen>(pen: &P, function: Function, of: &Expr, fenced: bool) -> Written {
    match function {
        Function::Sqrt => pen.root(write(pen, of)),
        Function::Exp => pen.exponential(&write(pen, of).0),
        Function::Abs => (pen.fence('|', &write(pen, of).0, '|'), Level::Atom),
        Function::Conj => (pen.raise(&at_least(pen, of, Level::Atom), &pen.word("*")), Level::Script),
        Function::Sin | Function::Cos | Function::Tan => trigonometric_face(pen, function, of, None, fenced),
        Function::Asin | Function::Acos | Function::Atan | Function::Re | Function::Im => {
            let argument = pen.fence('(', &write(pen, of).0, ')');
            (pen.row(&[pen.word(function.name()), argument]), Level::Prefix)
        }
    }
}

fn nabla_of<P: Pen>(pen: &P, nabla: Nabla, of: &Expr) -> String {
    let operand = at_least(pen, of, Level::Script);
    let del = pen.prefix('∇');
    match nabla {
        Nabla::Gradient => pen.row(&[del, operand]),
        Nabla::Divergence => pen.row(&[del, pen.infix(Sign::Dot), operand]),
        Nabla::Curl => pen.row(&[del, pen.infix(Sign::Cross), operand]),
        Nabla::Laplacian => pen.row(&[pen.raise(&del, &pen.exponent(Rational::integer(2))), operand]),
    }
}

fn partial<P: Pen>(pen: &P, of: &Expr, by: &[Expr]) -> Written {
    let raised = |mark: String, n: usize| match n {
        1 => mark,
        _ => pen.raise(&mark, &pen.exponent(Rational::integer(n as i64))),
    };
    let mut below = Vec::new();
    for run in by.chunk_by(|a, b| a == b) {
        if !below.is_empty() {
            below.push(pen.gap(Gap::Differential));
        }
        let variable = at_least(pen, &run[0], Level::Atom);
        below.extend([pen.prefix('∂'), raised(variable, run.len())]);
    }
    let several = by.chunk_by(|a, b| a == b).count() > 1;
    let below = pen.row(&below);
    let below = if P::FLAT && several { pen.fence('(', &below, ')') } else { below };
    let above = raised(pen.prefix('∂'), by.len());
    let (operand, level) = write(pen, of);
    if P::FLAT || level >= Level::Script {
        let operand = if level >= Level::Script { operand } else { pen.fence('(', &operand, ')') };
        return (pen.fraction(&pen.row(&[above, operand]), &below), if P::FLAT { Level::Slash } else { Level::Script });
    }
    let operand = pen.fence('(', &operand, ')');
    (pen.row(&[pen.fraction(&above, &below), operand]), Level::Product)
}

fn integral<P: Pen>(pen: &P, of: &Expr, by: &[Expr], range: &Range) -> String {
    let sign = match range {
        Range::Whole => pen.integral('∫', None),
        Range::Closed => pen.integral('∮', None),
        Range::Region(region) => pen.integral('∫', Some((&pen.name(&Name::parse(region.name()), region.rank()), None))),
        Range::Between(from, to) => pen.integral('∫', Some((&write(pen, from).0, Some(&write(pen, to).0)))),
    };
    let mut parts = vec![sign, pen.gap(Gap::Loose), at_least(pen, of, Level::Slash)];
    for variable in by {
        parts.extend([pen.gap(Gap::Differential), pen.prefix('d'), at_least(pen, variable, Level::Script)]);
    }
    pen.row(&parts)
}
