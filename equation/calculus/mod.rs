//! Derivatives, vector operators and integrals carried out: what is left of an equation are scalar equations in atoms
//! that algebra alone can decide.
//!
//! Vectors are taken in Cartesian components. Position is (x, y, z) and time t, symbols by these names; fields
//! ([`Symbol::field`]) depend on all four. The component of a vector symbol is a symbol with the axis in its index
//! (E₁ → E₁ₓ); those of the position vector r, in metres, are x, y and z.
//!
//! ```
//! use equation::calculus::derivative;
//! use equation::expr::sin;
//! use equation::{Dimension, Symbol};
//!
//! const K: Symbol = Symbol::scalar("k", Dimension::RADIAN_PER_METRE);
//! const Z: Symbol = Symbol::scalar("z", Dimension::METRE);
//! assert_eq!(derivative(&sin(K * Z), &Z).unwrap().to_string(), "cos(kz) k");
//! ```

mod resolver;
mod slope;
mod tidy;

#[cfg(test)]
mod tests;

use super::dimension::Dimension;
use super::expr::{Expr, Nabla, Node, partial};
use super::hypothesis::{Given, Primitive};
use super::symbol::{Rank, Symbol};
use resolver::{Resolver, Value};
use std::collections::HashMap;
use std::fmt;

/// The most nodes that an expression may have, before and after, and the most steps that one call takes.
pub const LARGEST: usize = 20_000;
/// The deepest that expressions, and rules applied within rules, may be nested.
pub const DEEPEST: usize = 256;

/// Why an expression cannot be carried out. Expressions are named by their face in Unicode.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unresolved {
    /// A derivative or an integral by something that is neither a free symbol nor an argument of what is derived.
    Variable(String),
    /// A vector where a number is needed, or the other way round.
    Rank {
        /// The offending part.
        face: String,
        /// What it should be.
        wanted: Rank,
    },
    /// A mean, a differential or an integral over a region that no hypothesis replaces, or something else that has
    /// no components or no derivative.
    Opaque(String),
    /// An integral of whose integrand no primitive is known.
    NoPrimitive(String),
    /// A primitive that may have singularities between the bounds.
    NotEntire {
        /// The primitive.
        face: String,
        /// The variable of integration.
        variable: String,
    },
    /// The derivative of a conjugate, a real or imaginary part or a magnitude by a variable that may be complex.
    NotReal {
        /// What is derived.
        face: String,
        /// The variable.
        variable: String,
    },
    /// A function whose derivative by an argument cannot be named, because that argument stands in another one too.
    Entangled(String),
    /// Hypotheses that lead back to what they replace.
    Circular(String),
    /// A name that stands for two quantities: of different unit or rank, or a field here and a constant there.
    Ambiguous(String),
    /// An exponent that does not fit.
    Exponent(String),
    /// More than [`LARGEST`] nodes or steps.
    TooLarge,
    /// Nested deeper than [`DEEPEST`].
    TooDeep,
}

impl fmt::Display for Unresolved {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Variable(face) => {
                write!(f, "{face} is neither a free symbol nor an argument, so nothing varies with it")
            }
            Self::Rank { face, wanted: Rank::Scalar } => write!(f, "{face} is a vector where a number is needed"),
            Self::Rank { face, wanted: Rank::Vector } => write!(f, "{face} is a number where a vector is needed"),
            Self::Opaque(face) => write!(f, "{face} cannot be carried out and no hypothesis replaces it"),
            Self::NoPrimitive(face) => write!(f, "no primitive is known for {face}"),
            Self::NotEntire { face, variable } => {
                write!(f, "the primitive {face} may be singular for some {variable} between the bounds")
            }
            Self::NotReal { face, variable } => {
                write!(f, "{face} has a derivative by {variable} only where that is real")
            }
            Self::Entangled(face) => write!(f, "an argument of {face} stands in another of its arguments too"),
            Self::Circular(face) => write!(f, "{face} is given by itself"),
            Self::Ambiguous(name) => write!(f, "{name} stands for two different quantities"),
            Self::Exponent(face) => write!(f, "the derivative of {face} has an exponent out of range"),
            Self::TooLarge => write!(f, "it grows beyond {LARGEST} parts"),
            Self::TooDeep => write!(f, "it is nested more than {DEEPEST} deep"),
        }
    }
}

impl std::error::Error for Unresolved {}

/// The derivative of `expr` by the symbol `by`, with no more simplification than that terms 0 and factors 1 are left
/// out.
///
/// A field depends on x, y, z and t; its derivatives by them are the atoms ∂F/∂x…, variables in alphabetical order. A
/// function at arguments is derived by the chain rule, with the atoms ∂f(u, v)/∂u. Any symbol but `by` is a constant.
/// A vector is taken to components first. Conjugate, real and imaginary part and magnitude have a derivative by real
/// variables alone (|f|′ = Re(f* f′)/|f|).
pub fn derivative(expr: &Expr, by: &Symbol) -> Result<Expr, Unresolved> {
    let calculus = Calculus::new(&[], &[], &|_, _| false);
    let mut resolver = Resolver::new(&calculus, &[expr])?;
    let value = resolver.value(expr)?;
    let by = resolver.variable(&by.into())?;
    let slopes = resolver.slope_of(value, &by)?;
    resolver.check(&slopes)?;
    Ok(match slopes {
        Value::Scalar(slope) => slope,
        Value::Vector(parts) => Expr::new(Node::Vector(parts)),
    })
}

/// Hypotheses and primitives, ready to be applied to any number of equations.
///
/// - A symbol is replaced by what it is given as before any derivative is taken; so is any other form, where it stands
///   as it is written and before components are taken.
/// - The derivative of a field that is given (∂F/∂t := f) replaces every derivative that contains it by the remaining
///   derivatives of f, again and again. With Faraday's and Ampère's laws this leaves spatial derivatives only.
/// - A given divergence ∇·F := f does the same for ∂F_z/∂z := f − ∂Fₓ/∂x − ∂F_y/∂y.
pub struct Calculus<'a> {
    symbols: HashMap<&'a str, &'a Expr>,
    forms: HashMap<&'a Expr, &'a Expr>,
    rules: Vec<Rule>,
    primitives: &'a [Primitive],
    /// Everything that a symbol could be declared in.
    sources: Vec<&'a Expr>,
    /// Whether two scalar expressions are equal: the decider.
    equal: &'a dyn Fn(&Expr, &Expr) -> bool,
}

/// A derivative of a scalar field, or of a component of a vector field, that is given.
struct Rule {
    field: String,
    /// The names of the variables.
    by: Vec<String>,
    value: Expr,
    /// Which component of `value`, if it is a vector.
    axis: Option<usize>,
}

impl<'a> Calculus<'a> {
    /// With these hypotheses and primitives, and `equal` to tell whether an integrand is a primitive's derivative.
    /// Where a thing is given twice, the later hypothesis counts.
    pub fn new(given: &'a [Given], primitives: &'a [Primitive], equal: &'a dyn Fn(&Expr, &Expr) -> bool) -> Self {
        let by_symbol = given.iter().filter_map(|given| match given.what.node() {
            Node::Symbol(symbol) => Some((symbol.name(), &given.value)),
            _ => None,
        });
        let sources = given.iter().flat_map(|given| [&given.what, &given.value]);
        let mut calculus = Self {
            symbols: by_symbol.collect(),
            forms: HashMap::new(),
            rules: Vec::new(),
            primitives,
            sources: sources.chain(primitives.iter().map(|primitive| &primitive.of)).collect(),
            equal,
        };
        for given in given {
            let rules = calculus.rules_of(given);
            if rules.is_empty() && !matches!(given.what.node(), Node::Symbol(_)) {
                calculus.forms.insert(&given.what, &given.value);
            }
            // The later first, so that it is found first.
            calculus.rules.splice(0..0, rules);
        }
        calculus
    }

    /// The scalar equations that `left` = `right` stands for, one or three, with every hypothesis applied and every
    /// vector operation, derivative and integral carried out.
    ///
    /// What is left are algebra and functions of these atoms: symbols; functions at arguments; ∂F/∂x… of a field or
    /// a component of one, variables in alphabetical order; ∂f(u, v)/∂u… of a function by its own arguments, in their
    /// order; differentials of symbols, other than in the quotient dq/dt, which is the derivative. The magnitude
    /// |v| of a vector becomes √(v·v) where v is real for real symbols, and √(v·v*) elsewhere.
    ///
    /// An integral between bounds is taken with a primitive F whose derivative is equal to the integrand; F must be
    /// entire in the variable: made of sums, products, powers, sin, cos and exp, and divided by nothing that varies.
    pub fn resolve(&self, left: &Expr, right: &Expr) -> Result<Vec<(Expr, Expr)>, Unresolved> {
        let mut resolver = Resolver::new(self, &[left, right])?;
        let (a, b) = (resolver.value(left)?, resolver.value(right)?);
        resolver.check(&a)?;
        resolver.check(&b)?;
        match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => Ok(vec![(a, b)]),
            (a, b) => Ok(a.into_vector(left)?.into_iter().zip(b.into_vector(right)?).collect()),
        }
    }

    /// The rules that a hypothesis on a derivative stands for; none if it is not on a derivative of a free field.
    fn rules_of(&self, given: &Given) -> Vec<Rule> {
        let field = |expr: &Expr| match expr.node() {
            Node::Symbol(symbol) if symbol.is_field() && !self.symbols.contains_key(symbol.name()) => {
                Some(symbol.clone())
            }
            _ => None,
        };
        match given.what.node() {
            Node::Partial(of, by) => {
                let coordinates: Option<Vec<String>> = by.iter().map(coordinate_name).collect();
                let (Some(symbol), Some(by)) = (field(of), coordinates) else { return vec![] };
                let rule = |symbol: &Symbol, axis| Rule {
                    field: symbol.name().to_owned(),
                    by: by.clone(),
                    value: given.value.clone(),
                    axis,
                };
                match symbol.rank() {
                    Rank::Scalar => vec![rule(&symbol, None)],
                    Rank::Vector => (0..3).map(|axis| rule(&component(&symbol, axis), Some(axis))).collect(),
                }
            }
            Node::Nabla(Nabla::Divergence, of) => {
                let Some(symbol) = field(of).filter(|symbol| symbol.rank() == Rank::Vector) else { return vec![] };
                let slope = |axis| partial(component(&symbol, axis), coordinate(axis));
                vec![Rule {
                    field: component(&symbol, 2).name().to_owned(),
                    by: vec!["z".to_owned()],
                    value: &given.value - slope(0) - slope(1),
                    axis: None,
                }]
            }
            _ => vec![],
        }
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The coordinate along an axis where the author names none.
fn coordinate(axis: usize) -> Symbol {
    Symbol::scalar(AXES[axis], Dimension::METRE).real(0.25, 1.25)
}

fn coordinate_name(expr: &Expr) -> Option<String> {
    match expr.node() {
        Node::Symbol(symbol) if is_coordinate(symbol) => Some(symbol.name().to_owned()),
        _ => None,
    }
}

/// Whether fields depend on it.
fn is_coordinate(symbol: &Symbol) -> bool {
    symbol.rank() == Rank::Scalar && (symbol.name() == "t" || AXES.contains(&symbol.name()))
}

/// E → Eₓ, E₁ → E₁ₓ, E₁′ → E₁ₓ′; r → x.
fn component(vector: &Symbol, axis: usize) -> Symbol {
    if vector.name() == "r" && vector.dimension() == Dimension::METRE {
        return coordinate(axis);
    }
    let name = vector.name();
    let bare = name.trim_end_matches('\'');
    let underscore = if bare.contains('_') { "" } else { "_" };
    let name = format!("{bare}{underscore}{}{}", AXES[axis], &name[bare.len()..]);
    let domain = vector.domain();
    let scalar = Symbol::scalar("", vector.dimension()).complex(domain.re, domain.im).named(name);
    if vector.is_field() { scalar.field() } else { scalar }
}

/// The face of `expr`, if it is short enough to be read.
fn face(expr: &Expr) -> String {
    const READABLE: usize = 300;
    if resolver::measure(expr, &mut 0, READABLE, 0).is_ok() {
        expr.to_string()
    } else {
        format!("an expression of more than {READABLE} parts")
    }
}
