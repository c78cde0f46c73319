//! What cannot be carried out, and how large is too large.

use crate::expr::Expr;
use crate::symbol::Rank;
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

/// Adds the nodes of `expr` to `nodes`; an error above `largest`.
pub(super) fn measure(expr: &Expr, nodes: &mut usize, largest: usize, depth: usize) -> Result<(), Unresolved> {
    *nodes += 1;
    if *nodes > largest {
        return Err(Unresolved::TooLarge);
    }
    if depth > DEEPEST {
        return Err(Unresolved::TooDeep);
    }
    expr.children().into_iter().try_for_each(|child| measure(child, nodes, largest, depth + 1))
}

/// The face of `expr`, if it is short enough to be read.
pub(super) fn face(expr: &Expr) -> String {
    const READABLE: usize = 300;
    if measure(expr, &mut 0, READABLE, 0).is_ok() {
        expr.to_string()
    } else {
        format!("an expression of more than {READABLE} parts")
    }
}
