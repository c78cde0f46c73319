//! The walk over the tree: what goes in parentheses and what stands side by side, whatever the pen.

use super::name::{Name, ends_in_word};
use super::pen::{Gap, Level, Pen, Sign, Written};
use crate::expr::{Expr, Function, Nabla, Node, Range};
use crate::rational::Rational;
use crate::symbol::{Rank, Symbol};
use crate::{Equation, Relation};

pub(super) fn relate<P: Pen>(pen: P, equation: &Equation) -> P::Ink {
    let sign = match equation.relation {
        Relation::Equal => Sign::Equal,
        Relation::Approximate => Sign::Approximate,
        Relation::Proportional => Sign::Proportional,
    };
    pen.row(vec![write(pen, &equation.lhs).0, pen.infix(sign), write(pen, &equation.rhs).0])
}

pub(super) fn write<P: Pen>(pen: P, expr: &Expr) -> Written<P> {
    match expr.node() {
        Node::Number(value) => pen.number(*value),
        Node::Pi => (pen.name(&Name::parse("pi"), Rank::Scalar), Level::Atom),
        Node::ImaginaryUnit => (pen.word("i"), Level::Atom),
        Node::Symbol(symbol) => (name(pen, symbol), Level::Atom),
        Node::Apply(symbol, arguments) => {
            (pen.row(vec![name(pen, symbol), pen.fence('(', list(pen, arguments), ')')]), Level::Atom)
        }
        Node::Sum(terms) => (sum(pen, terms), Level::Sum),
        Node::Product(factors) => product(pen, factors, true),
        Node::Quotient(above, below) => quotient(pen, above, below),
        Node::Power(base, exponent) => power(pen, base, *exponent),
        Node::Negate(of) => (pen.row(vec![pen.prefix('−'), at_least(pen, of, Level::Slash)]), Level::Negative),
        Node::Function(function, of) => apply(pen, *function, of),
        Node::Vector(parts) => (pen.fence('(', list(pen, parts), ')'), Level::Atom),
        Node::Dot(a, b) => (infix(pen, a, Sign::Dot, b), Level::Open),
        Node::Cross(a, b) => (infix(pen, a, Sign::Cross, b), Level::Open),
        Node::Nabla(nabla, of) => (nabla_of(pen, *nabla, of), Level::Prefix),
        Node::Partial(of, by) => partial(pen, of, by),
        Node::Differential(of) => (differential(pen, of), Level::Prefix),
        Node::Mean(of) => (pen.fence('⟨', write(pen, of).0, '⟩'), Level::Atom),
        Node::Integral(of, by, range) => (integral(pen, of, by, range), Level::Open),
    }
}

fn name<P: Pen>(pen: P, symbol: &Symbol) -> P::Ink {
    pen.name(&Name::parse(symbol.name()), symbol.rank())
}

/// The face of `expr`, in parentheses if it is looser than `level`.
fn at_least<P: Pen>(pen: P, expr: &Expr, level: Level) -> P::Ink {
    let (face, own) = write(pen, expr);
    if own >= level { face } else { pen.fence('(', face, ')') }
}

fn list<P: Pen>(pen: P, items: &[Expr]) -> P::Ink {
    let mut parts = Vec::new();
    for item in items {
        if !parts.is_empty() {
            parts.push(pen.infix(Sign::Comma));
        }
        parts.push(write(pen, item).0);
    }
    pen.row(parts)
}

/// a·b or a×b. A product as an operand is fenced: (aE)×B is not a (E×B), though it has its value.
fn infix<P: Pen>(pen: P, a: &Expr, sign: Sign, b: &Expr) -> P::Ink {
    pen.row(vec![at_least(pen, a, Level::Prefix), pen.infix(sign), at_least(pen, b, Level::Prefix)])
}

fn sum<P: Pen>(pen: P, terms: &[Expr]) -> P::Ink {
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
    pen.row(parts)
}

/// `ends` tells whether what follows the product cannot be taken for a part of its last factor's argument.
fn product<P: Pen>(pen: P, factors: &[Expr], ends: bool) -> Written<P> {
    let mut parts = Vec::new();
    let mut level = Level::Product;
    let mut closed = false;
    let mut word = Word::default();
    for (at, factor) in factors.iter().enumerate() {
        let next = factors.get(at + 1);
        let (face, own) = write_before(pen, factor, next, ends);
        // A vector product, an integral or a derivative needs no parentheses where nothing follows it.
        let bare = match next {
            None => own >= Level::Product || own == Level::Open || is_derivative(factor),
            Some(_) => own >= Level::Product && (P::RAISES || !is_conjugate(factor)),
        };
        level = if bare && own < level { own } else { level };
        let face = if bare { face } else { pen.fence('(', face, ')') };
        if at > 0 && starts_with_digit(factor) {
            parts.push(pen.infix(Sign::Times));
        } else if at > 0 {
            let joins = stands_tight(&factors[at - 1], factor) && word.takes(factor);
            let tight = joins || (closed && pen.opens(&face));
            parts.push(pen.gap(match factor.node() {
                Node::Differential(_) => Gap::Differential,
                _ if tight => Gap::Tight,
                _ => Gap::Loose,
            }));
        }
        parts.push(face);
        word.push(factor);
        closed = !bare;
    }
    (pen.row(parts), level)
}

/// The face of `factor` before another one: sin θ keeps its argument bare only where the next factor cannot be
/// mistaken for a part of it.
fn write_before<P: Pen>(pen: P, factor: &Expr, next: Option<&Expr>, ends: bool) -> Written<P> {
    let is_safe = |next: &Expr| trigonometric(next).is_some() || matches!(next.node(), Node::Differential(_));
    match trigonometric(factor) {
        Some((function, of, exponent)) if !next.map_or(ends, is_safe) => {
            trigonometric_face(pen, function, of, exponent, true)
        }
        _ => write(pen, factor),
    }
}

/// Whether a function is written sin x and squared as sin² x.
fn is_trigonometric(function: Function) -> bool {
    matches!(function, Function::Sin | Function::Cos | Function::Tan)
}

/// The parts of sin x and sinⁿ x, n ≥ 2.
fn trigonometric(expr: &Expr) -> Option<(Function, &Expr, Option<Rational>)> {
    match expr.node() {
        Node::Function(function, of) if is_trigonometric(*function) => Some((*function, of, None)),
        // A negative exponent would read as an inverse function.
        Node::Power(base, exponent) if exponent.as_integer().is_some_and(|n| n >= 2) => match base.node() {
            Node::Function(function, of) if is_trigonometric(*function) => Some((*function, of, Some(*exponent))),
            _ => None,
        },
        _ => None,
    }
}

fn trigonometric_face<P: Pen>(
    pen: P,
    function: Function,
    of: &Expr,
    exponent: Option<Rational>,
    fenced: bool,
) -> Written<P> {
    let word = pen.word(function.name());
    let word = match exponent {
        Some(exponent) => pen.raise(word, pen.exponent(exponent)),
        None => word,
    };
    let (argument, level) = write(pen, of);
    let is_simple = matches!(of.node(), Node::Symbol(_) | Node::Pi | Node::Number(_)) && level == Level::Atom;
    if is_simple && !fenced {
        (pen.row(vec![word, pen.apply(), argument]), Level::Prefix)
    } else {
        (pen.row(vec![word, pen.fence('(', argument, ')')]), Level::Prefix)
    }
}

fn is_derivative(expr: &Expr) -> bool {
    matches!(expr.node(), Node::Partial(..))
}

fn is_conjugate(expr: &Expr) -> bool {
    matches!(expr.node(), Node::Function(Function::Conj, _))
}

fn starts_with_digit(expr: &Expr) -> bool {
    match expr.node() {
        Node::Number(_) => true,
        Node::Power(base, _) | Node::Function(Function::Conj, base) => matches!(base.node(), Node::Number(_)),
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

fn quotient<P: Pen>(pen: P, above: &Expr, below: &Expr) -> Written<P> {
    if !pen.is_flat() {
        let pen_inside = pen.inner();
        return (pen.fraction(write(pen_inside, above).0, write(pen_inside, below).0), Level::Script);
    }
    // sin(θ)/v, since sin θ/v could be the sine of a quotient; sin θ₁/sin θ₂ could not.
    let ends = trigonometric(below).is_some();
    let (denominator, level) = write(pen, below);
    let is_fenced = level < Level::Prefix;
    let denominator = if is_fenced { pen.fence('(', denominator, ')') } else { denominator };
    let numerator = match (above.node(), trigonometric(above)) {
        (Node::Product(factors), _) => {
            let (face, level) = product(pen, factors, ends || is_fenced);
            if level >= Level::Product { face } else { pen.fence('(', face, ')') }
        }
        (_, Some((function, of, exponent))) if !ends => trigonometric_face(pen, function, of, exponent, true).0,
        _ => at_least(pen, above, Level::Product),
    };
    (pen.fraction(numerator, denominator), Level::Slash)
}

fn power<P: Pen>(pen: P, base: &Expr, exponent: Rational) -> Written<P> {
    if exponent.as_integer().is_some_and(|n| n >= 2)
        && let Node::Function(function, of) = base.node()
        && is_trigonometric(*function)
    {
        return trigonometric_face(pen, *function, of, Some(exponent), false);
    }
    (pen.raise(at_least(pen, base, Level::Atom), pen.exponent(exponent)), Level::Script)
}

fn apply<P: Pen>(pen: P, function: Function, of: &Expr) -> Written<P> {
    match function {
        Function::Sqrt => pen.root(write(pen, of)),
        Function::Exp => pen.exponential(write(pen.inner(), of).0),
        Function::Abs => (pen.fence('|', write(pen, of).0, '|'), Level::Atom),
        Function::Conj => (pen.raise(at_least(pen, of, Level::Atom), pen.word("*")), Level::Script),
        Function::Sin | Function::Cos | Function::Tan => trigonometric_face(pen, function, of, None, false),
        Function::Asin | Function::Acos | Function::Atan | Function::Re | Function::Im => {
            let argument = pen.fence('(', write(pen, of).0, ')');
            (pen.row(vec![pen.word(function.name()), argument]), Level::Prefix)
        }
    }
}

fn nabla_of<P: Pen>(pen: P, nabla: Nabla, of: &Expr) -> P::Ink {
    let operand = at_least(pen, of, Level::Script);
    let del = pen.prefix('∇');
    match nabla {
        Nabla::Gradient => pen.row(vec![del, operand]),
        Nabla::Divergence => pen.row(vec![del, pen.infix(Sign::Dot), operand]),
        Nabla::Curl => pen.row(vec![del, pen.infix(Sign::Cross), operand]),
        Nabla::Laplacian => pen.row(vec![pen.raise(del, pen.exponent(Rational::integer(2))), operand]),
    }
}

fn partial<P: Pen>(pen: P, of: &Expr, by: &[Expr]) -> Written<P> {
    let inside = pen.inner();
    let raised = |mark: P::Ink, n: usize| match n {
        1 => mark,
        _ => pen.raise(mark, pen.exponent(Rational::integer(n as i64))),
    };
    let mut below = Vec::new();
    for run in by.chunk_by(|a, b| a == b) {
        if !below.is_empty() {
            below.push(pen.gap(Gap::Differential));
        }
        let variable = at_least(inside, &run[0], Level::Atom);
        below.extend([pen.prefix('∂'), raised(variable, run.len())]);
    }
    let several = by.chunk_by(|a, b| a == b).count() > 1;
    let below = pen.row(below);
    let below = if pen.is_flat() && several { pen.fence('(', below, ')') } else { below };
    let above = raised(pen.prefix('∂'), by.len());
    let (operand, level) = write(inside, of);
    let bare = level >= Level::Script;
    let operand = if bare { operand } else { pen.fence('(', operand, ')') };
    if pen.is_flat() || bare {
        let level = if pen.is_flat() { Level::Slash } else { Level::Script };
        return (pen.fraction(pen.row(vec![above, operand]), below), level);
    }
    (pen.row(vec![pen.fraction(above, below), operand]), Level::Product)
}

/// dx; d(2) and d(a + b), which would otherwise be read as something else.
fn differential<P: Pen>(pen: P, of: &Expr) -> P::Ink {
    let (face, level) = write(pen, of);
    let base = match of.node() {
        Node::Power(base, _) | Node::Function(Function::Conj, base) => base,
        _ => of,
    };
    let starts_with_name = matches!(base.node(), Node::Symbol(_) | Node::Apply(..) | Node::Mean(_));
    let bare = level >= Level::Script && starts_with_name;
    pen.row(vec![pen.prefix('d'), if bare { face } else { pen.fence('(', face, ')') }])
}

fn integral<P: Pen>(pen: P, of: &Expr, by: &[Expr], range: &Range) -> P::Ink {
    let sign = match range {
        Range::Whole => pen.integral('∫', None),
        Range::Closed => pen.integral('∮', None),
        Range::Region(region) => pen.integral('∫', Some((name(pen, region), None))),
        Range::Between(from, to) => {
            let inside = pen.inner();
            pen.integral('∫', Some((write(inside, from).0, Some(write(inside, to).0))))
        }
    };
    let integrand =
        if takes_differentials(of) { pen.fence('(', write(pen, of).0, ')') } else { at_least(pen, of, Level::Slash) };
    let mut parts = vec![sign, pen.gap(Gap::Loose), integrand];
    for variable in by {
        parts.extend([pen.gap(Gap::Differential), differential(pen, variable)]);
    }
    pen.row(parts)
}

/// Whether the differentials after an integrand could be taken for its own.
fn takes_differentials(integrand: &Expr) -> bool {
    match integrand.node() {
        Node::Product(factors) => factors.last().is_some_and(takes_differentials),
        Node::Differential(_) | Node::Integral(..) => true,
        _ => false,
    }
}

/// The letters of a product that stand together. They must not spell a name: x i, not xi.
#[derive(Default)]
struct Word(String);

impl Word {
    /// Whether `factor` can join it; otherwise a new one begins.
    fn takes(&mut self, factor: &Expr) -> bool {
        self.0.extend(Self::letter(factor));
        let is_word = ends_in_word(&self.0);
        self.0.pop();
        if is_word {
            self.0.clear();
        }
        !is_word
    }

    fn push(&mut self, factor: &Expr) {
        match Self::letter(factor) {
            Some(letter) => self.0.push(letter),
            None => self.0.clear(),
        }
        // An exponent ends it.
        if matches!(factor.node(), Node::Power(..)) {
            self.0.clear();
        }
    }

    /// The letter that `factor` starts with, if it is one; any other mark for what is not in the Latin alphabet.
    fn letter(factor: &Expr) -> Option<char> {
        match factor.node() {
            Node::ImaginaryUnit => Some('i'),
            Node::Power(base, _) => Self::letter(base),
            Node::Symbol(symbol) if symbol.name().len() == 1 => symbol.name().chars().next(),
            Node::Symbol(_) | Node::Pi => Some('π'),
            _ => None,
        }
    }
}
