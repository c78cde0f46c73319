//! Expressions: immutable trees, cheap to clone, kept as they were written.
//!
//! Nothing is simplified on the way in, because a line of a derivation must show what its author wrote. Only what
//! cannot be seen on the page is settled: nested sums and products are flat, and a minus sign stands in front
//! (numbers are never negative; (−a)·b and (−a)/b become −(a·b) and −(a/b)).
//!
//! ```
//! use equation::dimension::Dimension;
//! use equation::expr::{cos, sin};
//! use equation::symbol::Symbol;
//!
//! const THETA_1: Symbol = Symbol::scalar("theta_1", Dimension::ONE).within(0.1, 1.4);
//! const THETA_2: Symbol = Symbol::scalar("theta_2", Dimension::ONE).within(0.1, 1.4);
//! let t_s = 2 * sin(THETA_2) * cos(THETA_1) / sin(THETA_1 + THETA_2);
//! assert_eq!(t_s.to_string(), "2 sin θ₂ cos θ₁/sin(θ₁ + θ₂)");
//! ```

mod notation;

use crate::rational::Rational;
use crate::symbol::Symbol;
use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

pub use notation::*;

/// An expression. Equality is of form, not of value.
#[derive(Clone)]
pub struct Expr(Arc<Hashed>);

/// A node with the hash of the whole tree below it, so that looking a tree up costs no walk.
struct Hashed {
    hash: u64,
    node: Node,
}

/// What an expression is made of. Built through the functions and operators of this module, which keep it flat
/// and its signs in front.
#[derive(Clone, Debug, PartialEq, Hash)]
#[non_exhaustive]
pub enum Node {
    /// An exact number ≥ 0.
    Number(Rational),
    /// π
    Pi,
    /// i, the root of −1.
    ImaginaryUnit,
    /// A named quantity.
    Symbol(Symbol),
    /// A named quantity at arguments: f₁(z − vt), f_r(x, ω_i, ω_o). It has the symbol's unit and rank.
    Apply(Symbol, Vec<Expr>),
    /// At least two terms.
    Sum(Vec<Expr>),
    /// At least two factors, at most one of them a vector.
    Product(Vec<Expr>),
    /// One over the other.
    Quotient(Expr, Expr),
    /// An integer or rational power.
    Power(Expr, Rational),
    /// −a
    Negate(Expr),
    /// A function of one argument.
    Function(Function, Expr),
    /// A vector by its Cartesian components.
    Vector([Expr; 3]),
    /// a·b of vectors.
    Dot(Expr, Expr),
    /// a×b of vectors.
    Cross(Expr, Expr),
    /// A vector derivative.
    Nabla(Nabla, Expr),
    /// ∂ⁿf/∂x∂y…; in the order of writing.
    Partial(Expr, Vec<Expr>),
    /// dx
    Differential(Expr),
    /// ⟨f⟩, an average over time.
    Mean(Expr),
    /// ∫ f dx dy …, with the variables in the order of writing.
    Integral(Expr, Vec<Expr>, Range),
}

/// Functions of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "each name is its own documentation")]
pub enum Function {
    Sqrt,
    Exp,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    /// Complex conjugate.
    Conj,
    /// Magnitude of a number or a vector.
    Abs,
    /// Real part.
    Re,
    /// Imaginary part.
    Im,
}

/// Vector derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Nabla {
    /// ∇f
    Gradient,
    /// ∇·a
    Divergence,
    /// ∇×a
    Curl,
    /// ∇²f, of a scalar or a vector.
    Laplacian,
}

/// What an integral runs over.
#[derive(Clone, Debug, PartialEq, Hash)]
pub enum Range {
    /// Everything that is meant: a bare ∫.
    Whole,
    /// A closed line or surface: ∮.
    Closed,
    /// A named region.
    Region(Symbol),
    /// From one value of the (single) variable to another.
    Between(Expr, Expr),
}

impl Expr {
    pub(crate) fn new(node: Node) -> Self {
        let mut hasher = DefaultHasher::new();
        node.hash(&mut hasher);
        Self(Arc::new(Hashed { hash: hasher.finish(), node }))
    }

    /// Its outermost part.
    pub fn node(&self) -> &Node {
        &self.0.node
    }

    /// The exact number `value`.
    pub fn number(value: Rational) -> Self {
        if value.is_negative() { Self::number(value.negated()).negated() } else { Self::new(Node::Number(value)) }
    }

    /// `function` of `of`.
    pub fn function(function: Function, of: Self) -> Self {
        Self::new(Node::Function(function, of))
    }

    /// Its power. `x.pow(2)`, `x.pow(rational)`.
    pub fn pow(&self, exponent: impl Into<Rational>) -> Self {
        Self::new(Node::Power(self.clone(), exponent.into()))
    }

    /// Whether it is the number 0 as written.
    pub fn is_zero(&self) -> bool {
        match self.node() {
            Node::Number(value) => value.is_zero(),
            Node::Negate(inner) => inner.is_zero(),
            _ => false,
        }
    }

    /// The expressions directly below.
    pub fn children(&self) -> Vec<&Expr> {
        match self.node() {
            Node::Number(_) | Node::Pi | Node::ImaginaryUnit | Node::Symbol(_) => vec![],
            Node::Apply(_, parts) | Node::Sum(parts) | Node::Product(parts) => parts.iter().collect(),
            Node::Vector(parts) => parts.iter().collect(),
            Node::Quotient(a, b) | Node::Dot(a, b) | Node::Cross(a, b) => vec![a, b],
            Node::Power(a, _) | Node::Negate(a) | Node::Function(_, a) | Node::Nabla(_, a) => vec![a],
            Node::Differential(a) | Node::Mean(a) => vec![a],
            Node::Partial(of, by) => std::iter::once(of).chain(by).collect(),
            Node::Integral(of, by, Range::Between(from, to)) => {
                std::iter::once(of).chain(by).chain([from, to]).collect()
            }
            Node::Integral(of, by, _) => std::iter::once(of).chain(by).collect(),
        }
    }

    /// Every symbol in it, each name once, in the order of reading.
    pub fn symbols(&self) -> Vec<&Symbol> {
        let mut found = Vec::new();
        self.collect_symbols(&mut found);
        found
    }

    /// The same outermost part over other expressions: every child replaced by its `image`.
    pub fn map(&self, image: &mut impl FnMut(&Expr) -> Expr) -> Self {
        let mut each = |parts: &[Expr]| parts.iter().map(&mut *image).collect::<Vec<_>>();
        match self.node() {
            Node::Number(_) | Node::Pi | Node::ImaginaryUnit | Node::Symbol(_) => self.clone(),
            Node::Apply(symbol, arguments) => Self::new(Node::Apply(symbol.clone(), each(arguments))),
            Node::Sum(terms) => Self::sum_of(each(terms)),
            Node::Product(factors) => Self::product_of(each(factors)),
            Node::Vector(parts) => Self::new(Node::Vector(parts.each_ref().map(image))),
            Node::Quotient(a, b) => image(a).quotient(image(b)),
            Node::Power(base, exponent) => image(base).pow(*exponent),
            Node::Negate(of) => image(of).negated(),
            Node::Function(function, of) => Self::new(Node::Function(*function, image(of))),
            Node::Dot(a, b) => Self::new(Node::Dot(image(a), image(b))),
            Node::Cross(a, b) => Self::new(Node::Cross(image(a), image(b))),
            Node::Nabla(nabla, of) => Self::new(Node::Nabla(*nabla, image(of))),
            Node::Partial(of, by) => {
                let of = image(of);
                Self::new(Node::Partial(of, by.iter().map(image).collect()))
            }
            Node::Differential(of) => Self::new(Node::Differential(image(of))),
            Node::Mean(of) => Self::new(Node::Mean(image(of))),
            Node::Integral(of, by, range) => {
                let (of, by) = (image(of), by.iter().map(&mut *image).collect());
                let range = match range {
                    Range::Between(from, to) => Range::Between(image(from), image(to)),
                    other => other.clone(),
                };
                Self::new(Node::Integral(of, by, range))
            }
        }
    }

    /// The same with every part that has the form of `what` replaced by `by`, from the outside inwards; what comes in
    /// is not searched again.
    pub fn replace(&self, what: &Expr, by: &Expr) -> Self {
        if self == what { by.clone() } else { self.map(&mut |child| child.replace(what, by)) }
    }

    fn collect_symbols<'a>(&'a self, found: &mut Vec<&'a Symbol>) {
        if let Node::Symbol(symbol) | Node::Apply(symbol, _) = self.node()
            && found.iter().all(|known| known.name() != symbol.name())
        {
            found.push(symbol);
        }
        for child in self.children() {
            child.collect_symbols(found);
        }
    }

    /// The sum of `terms`, at least one.
    pub(crate) fn sum_of(mut terms: Vec<Self>) -> Self {
        match terms.len() {
            1 => terms.remove(0),
            _ => Self::new(Node::Sum(terms.into_iter().flat_map(Self::into_terms).collect())),
        }
    }

    /// The product of `factors`, at least one.
    pub(crate) fn product_of(mut factors: Vec<Self>) -> Self {
        if let Node::Negate(inner) = factors[0].node() {
            factors[0] = inner.clone();
            return Self::product_of(factors).negated();
        }
        match factors.len() {
            1 => factors.remove(0),
            _ => Self::new(Node::Product(factors.into_iter().flat_map(Self::into_factors).collect())),
        }
    }

    fn sum(self, other: Self) -> Self {
        Self::sum_of(vec![self, other])
    }

    fn into_terms(self) -> Vec<Self> {
        match self.node() {
            Node::Sum(terms) => terms.clone(),
            _ => vec![self],
        }
    }

    fn product(self, other: Self) -> Self {
        Self::product_of(vec![self, other])
    }

    fn into_factors(self) -> Vec<Self> {
        match self.node() {
            Node::Product(factors) => factors.clone(),
            _ => vec![self],
        }
    }

    fn quotient(self, other: Self) -> Self {
        match self.node() {
            Node::Negate(inner) => inner.clone().quotient(other).negated(),
            _ => Self::new(Node::Quotient(self, other)),
        }
    }

    fn negated(self) -> Self {
        match self.node() {
            Node::Negate(inner) => inner.clone(),
            _ => Self::new(Node::Negate(self)),
        }
    }
}

impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || (self.0.hash == other.0.hash && self.0.node == other.0.node)
    }
}

impl Eq for Expr {}

impl Hash for Expr {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.hash.hash(state);
    }
}

impl std::fmt::Debug for Expr {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        self.0.node.fmt(f)
    }
}

impl From<&Expr> for Expr {
    fn from(expr: &Expr) -> Self {
        expr.clone()
    }
}

impl From<Symbol> for Expr {
    fn from(symbol: Symbol) -> Self {
        Self::new(Node::Symbol(symbol))
    }
}

impl From<&Symbol> for Expr {
    fn from(symbol: &Symbol) -> Self {
        symbol.clone().into()
    }
}

impl From<Rational> for Expr {
    fn from(value: Rational) -> Self {
        Self::number(value)
    }
}

impl From<i32> for Expr {
    fn from(value: i32) -> Self {
        Self::number(value.into())
    }
}
