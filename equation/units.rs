//! The SI dimension and the rank of an expression, inferred from its symbols.

use super::Equation;
use super::dimension::Dimension;
use super::expr::{Expr, Function, Nabla, Node, Range};
use super::rational::Rational;
use super::symbol::Rank;
use std::fmt;

/// Why the two sides, or two terms, of an equation cannot be compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mismatch {
    /// Two terms or sides of different dimension.
    Unlike {
        /// The offending term, in Unicode.
        term: String,
        /// Its dimension.
        unit: Dimension,
        /// What it is added to, or equated with.
        other: String,
        /// The dimension of that.
        other_unit: Dimension,
    },
    /// A dimension where a pure number must stand.
    NotPure {
        /// The offending term, in Unicode.
        term: String,
        /// Its dimension.
        unit: Dimension,
        /// Where it stands (`sin`).
        place: &'static str,
    },
    /// A vector where a number must stand, or the other way round.
    Rank {
        /// The offending term, in Unicode.
        term: String,
        /// What it is.
        rank: Rank,
        /// Where it stands.
        place: &'static str,
    },
    /// An exponent of a unit that no lecture needs.
    Overflow {
        /// The offending term, in Unicode.
        term: String,
    },
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Unlike { term, unit, other, other_unit } => {
                write!(f, "{term} is in {unit}, but {other} is in {other_unit}")
            }
            Self::NotPure { term, unit, place } => write!(f, "{term} is in {unit}, but {place} takes a pure number"),
            Self::Rank { term, rank: Rank::Vector, place } => {
                write!(f, "{term} is a vector, but {place} takes a number")
            }
            Self::Rank { term, rank: Rank::Scalar, place } => {
                write!(f, "{term} is a number, but {place} takes a vector")
            }
            Self::Overflow { term } => write!(f, "the unit of {term} has an exponent out of range"),
        }
    }
}

impl std::error::Error for Mismatch {}

/// Dimension and rank; `None` for a zero, which fits any.
type Kind = Option<(Dimension, Rank)>;

impl Expr {
    /// Its SI dimension; a bare zero counts as a pure number.
    pub fn dimension(&self) -> Result<Dimension, Mismatch> {
        Ok(infer(self)?.map_or(Dimension::ONE, |kind| kind.0))
    }
}

impl Equation {
    /// The SI dimension of both sides; that of the left where the relation is a proportionality.
    pub fn dimension(&self) -> Result<Dimension, Mismatch> {
        let (left, right) = (infer(&self.lhs)?, infer(&self.rhs)?);
        let kind = match self.relation {
            super::Relation::Proportional => left,
            _ => agree(&self.lhs, left, &self.rhs, right)?,
        };
        Ok(kind.map_or(Dimension::ONE, |kind| kind.0))
    }
}

/// The common kind of two terms. The second is named as the offender.
fn agree(first: &Expr, first_kind: Kind, term: &Expr, kind: Kind) -> Result<Kind, Mismatch> {
    let (Some((other_unit, other_rank)), Some((unit, rank))) = (first_kind, kind) else {
        return Ok(first_kind.or(kind));
    };
    if unit != other_unit {
        return Err(Mismatch::Unlike { term: term.to_string(), unit, other: first.to_string(), other_unit });
    }
    if rank != other_rank {
        let place = match rank {
            Rank::Vector => "a sum or equation of numbers",
            Rank::Scalar => "a sum or equation of vectors",
        };
        return Err(Mismatch::Rank { term: term.to_string(), rank, place });
    }
    Ok(kind)
}

fn infer(expr: &Expr) -> Result<Kind, Mismatch> {
    let scalar = |dimension| Ok(Some((dimension, Rank::Scalar)));
    match expr.node() {
        Node::Number(value) if value.is_zero() => Ok(None),
        Node::Number(_) | Node::Pi | Node::ImaginaryUnit => scalar(Dimension::ONE),
        Node::Symbol(symbol) => Ok(Some((symbol.dimension(), symbol.rank()))),
        Node::Apply(symbol, arguments) => {
            arguments.iter().try_for_each(|argument| infer(argument).map(drop))?;
            Ok(Some((symbol.dimension(), symbol.rank())))
        }
        Node::Sum(terms) => {
            let (mut first, mut kind) = (&terms[0], None);
            for term in terms {
                let found = infer(term)?;
                if kind.is_none() {
                    first = term;
                }
                kind = agree(first, kind, term, found)?;
            }
            Ok(kind)
        }
        Node::Product(factors) => product(expr, factors),
        Node::Quotient(above, below) => {
            let (above, below) = (infer(above)?, scalar_only(below, "a denominator")?);
            let Some((dimension, rank)) = above else { return Ok(None) };
            Ok(Some((times(expr, dimension, below.inverse())?, rank)))
        }
        Node::Power(of, exponent) => scalar(power(expr, scalar_only(of, "a power")?, *exponent)?),
        Node::Negate(of) | Node::Mean(of) | Node::Differential(of) => infer(of),
        Node::Function(function, of) => infer_function(expr, *function, of),
        Node::Vector(parts) => {
            let (mut first, mut kind) = (&parts[0], None);
            for part in parts {
                let found = infer(part)?;
                if let Some((_, rank @ Rank::Vector)) = found {
                    return Err(Mismatch::Rank { term: part.to_string(), rank, place: "a component" });
                }
                if kind.is_none() {
                    first = part;
                }
                kind = agree(first, kind, part, found)?;
            }
            Ok(kind.map(|(dimension, _)| (dimension, Rank::Vector)))
        }
        Node::Dot(a, b) => scalar(times(expr, vector_only(a, "a dot product")?, vector_only(b, "a dot product")?)?),
        Node::Cross(a, b) => {
            let dimension = times(expr, vector_only(a, "a cross product")?, vector_only(b, "a cross product")?)?;
            Ok(Some((dimension, Rank::Vector)))
        }
        Node::Nabla(nabla, of) => infer_nabla(expr, *nabla, of),
        Node::Partial(of, by) => {
            let mut kind = infer(of)?;
            for variable in by {
                kind = scale(expr, kind, scalar_only(variable, "a derivative's variable")?.inverse())?;
            }
            Ok(kind)
        }
        Node::Integral(of, by, range) => {
            let mut kind = infer(of)?;
            for variable in by {
                kind = scale(expr, kind, scalar_only(variable, "an integral's variable")?)?;
            }
            if let (Range::Between(from, to), Some(variable)) = (range, by.first()) {
                let variable_kind = infer(variable)?;
                agree(variable, variable_kind, from, infer(from)?)?;
                agree(variable, variable_kind, to, infer(to)?)?;
            }
            Ok(kind)
        }
    }
}

fn product(expr: &Expr, factors: &[Expr]) -> Result<Kind, Mismatch> {
    let mut kind = Some((Dimension::ONE, Rank::Scalar));
    for factor in factors {
        let (Some((dimension, rank)), Some((unit, factor_rank))) = (kind, infer(factor)?) else {
            kind = None;
            continue;
        };
        if rank == Rank::Vector && factor_rank == Rank::Vector {
            return Err(Mismatch::Rank { term: factor.to_string(), rank: factor_rank, place: "a plain product" });
        }
        let rank = if rank == Rank::Vector { rank } else { factor_rank };
        kind = Some((times(expr, dimension, unit)?, rank));
    }
    Ok(kind)
}

fn infer_function(expr: &Expr, function: Function, of: &Expr) -> Result<Kind, Mismatch> {
    let kind = infer(of)?;
    match (function, kind) {
        (Function::Conj | Function::Re | Function::Im, _) => Ok(kind),
        (Function::Abs, _) => Ok(kind.map(|(dimension, _)| (dimension, Rank::Scalar))),
        (Function::Sqrt, None) => Ok(None),
        (Function::Sqrt, Some(_)) => {
            let half = const { Rational::new(1, 2).expect("a fraction") };
            Ok(Some((power(expr, of_rank(of, kind, Rank::Scalar, "a root")?, half)?, Rank::Scalar)))
        }
        _ => match of_rank(of, kind, Rank::Scalar, function.name())? {
            Dimension::ONE => Ok(Some((Dimension::ONE, Rank::Scalar))),
            unit => Err(Mismatch::NotPure { term: of.to_string(), unit, place: function.name() }),
        },
    }
}

fn infer_nabla(expr: &Expr, nabla: Nabla, of: &Expr) -> Result<Kind, Mismatch> {
    let per_metre = Dimension::RADIAN_PER_METRE;
    let (dimension, rank) = match nabla {
        Nabla::Gradient => (times(expr, scalar_only(of, "a gradient")?, per_metre)?, Rank::Vector),
        Nabla::Divergence => (times(expr, vector_only(of, "a divergence")?, per_metre)?, Rank::Scalar),
        Nabla::Curl => (times(expr, vector_only(of, "a curl")?, per_metre)?, Rank::Vector),
        Nabla::Laplacian => return scale(expr, infer(of)?, Dimension::SQUARE_METRE.inverse()),
    };
    Ok(Some((dimension, rank)))
}

fn scalar_only(expr: &Expr, place: &'static str) -> Result<Dimension, Mismatch> {
    ranked(expr, Rank::Scalar, place)
}

fn vector_only(expr: &Expr, place: &'static str) -> Result<Dimension, Mismatch> {
    ranked(expr, Rank::Vector, place)
}

fn ranked(expr: &Expr, wanted: Rank, place: &'static str) -> Result<Dimension, Mismatch> {
    of_rank(expr, infer(expr)?, wanted, place)
}

/// The dimension of `expr`, which is of this kind, where only `wanted` may stand.
fn of_rank(expr: &Expr, kind: Kind, wanted: Rank, place: &'static str) -> Result<Dimension, Mismatch> {
    match kind {
        None => Ok(Dimension::ONE),
        Some((dimension, rank)) if rank == wanted => Ok(dimension),
        Some((_, rank)) => Err(Mismatch::Rank { term: expr.to_string(), rank, place }),
    }
}

fn scale(expr: &Expr, kind: Kind, by: Dimension) -> Result<Kind, Mismatch> {
    kind.map(|(dimension, rank)| Ok((times(expr, dimension, by)?, rank))).transpose()
}

fn times(expr: &Expr, a: Dimension, b: Dimension) -> Result<Dimension, Mismatch> {
    a.checked_times(b).ok_or_else(|| Mismatch::Overflow { term: expr.to_string() })
}

fn power(expr: &Expr, a: Dimension, exponent: Rational) -> Result<Dimension, Mismatch> {
    a.checked_power(exponent).ok_or_else(|| Mismatch::Overflow { term: expr.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{cross, curl, d, dot, integral, partial, sin, sqrt, vector};
    use crate::symbol::Symbol;

    const T: Symbol = Symbol::scalar("t", Dimension::SECOND);
    const V: Symbol = Symbol::scalar("v", Dimension::METRE_PER_SECOND);
    const R: Symbol = Symbol::scalar("r", Dimension::METRE);
    const FLUX: Symbol = Symbol::scalar("Phi", Dimension::WATT);
    const ENERGY: Symbol = Symbol::scalar("Q", Dimension::JOULE);
    const AREA: Symbol = Symbol::scalar("A", Dimension::SQUARE_METRE);
    const S: Symbol = Symbol::vector("S", Dimension::WATT_PER_SQUARE_METRE);
    const N: Symbol = Symbol::vector("n", Dimension::ONE);
    const E: Symbol = Symbol::vector("E", Dimension::VOLT_PER_METRE);
    const B: Symbol = Symbol::vector("B", Dimension::TESLA);

    fn complaint<T: fmt::Debug>(result: Result<T, Mismatch>) -> String {
        result.unwrap_err().to_string()
    }

    /// Row C6 of the lecture: an energy that is already a power.
    #[test]
    fn refuses_the_flux_of_the_encyclopaedia() {
        let through = integral(dot(S, N), [AREA.into()], Range::Region(Symbol::scalar("Sigma", Dimension::ONE)));
        let formula = Equation::new(FLUX, d(&through) / d(T));
        assert_eq!(complaint(formula.dimension()), "d(∫_Σ S·n dA)/dt is in W/s, but Φ is in W");
        let energy = Equation::new(ENERGY, through);
        assert_eq!(complaint(energy.dimension()), "∫_Σ S·n dA is in W, but Q is in J");
        assert_eq!(Equation::new(FLUX, d(ENERGY) / d(T)).dimension(), Ok(Dimension::WATT));
    }

    #[test]
    fn names_the_offending_term() {
        assert_eq!(complaint((V * T + R + T).dimension()), "t is in s, but vt is in m");
        assert_eq!(complaint((2 * sin(V * T)).dimension()), "vt is in m, but sin takes a pure number");
        assert_eq!(
            complaint(Equation::new(curl(E), partial(E, T)).dimension()),
            "∂E/∂t is in V/(m s), but ∇×E is in V/m²"
        );
        assert_eq!(complaint((E * B).dimension()), "B is a vector, but a plain product takes a number");
        assert_eq!(complaint((1 / E).dimension()), "E is a vector, but a denominator takes a number");
        assert_eq!(complaint(cross(N, R).dimension()), "r is a number, but a cross product takes a vector");
        assert_eq!(
            complaint(Equation::new(E, Expr::from(Symbol::scalar("E", Dimension::VOLT_PER_METRE))).dimension()),
            "E is a number, but a sum or equation of vectors takes a vector"
        );
        assert_eq!(complaint(vector(0, N, 0).dimension()), "n is a vector, but a component takes a number");
        assert_eq!(vector(0, V * T, R).dimension(), Ok(Dimension::METRE));
    }

    #[test]
    fn zero_fits_any_unit_and_rank() {
        assert_eq!(Equation::new(V * T - R, 0).dimension(), Ok(Dimension::METRE));
        assert_eq!(Equation::new(0, E).dimension(), Ok(Dimension::VOLT_PER_METRE));
        assert_eq!(Equation::new(0 * E, R).dimension(), Ok(Dimension::METRE));
        assert_eq!((0 + R - 0).dimension(), Ok(Dimension::METRE));
    }

    #[test]
    fn takes_roots_and_refuses_absurd_powers() {
        assert_eq!(sqrt(R * R).dimension(), Ok(Dimension::METRE));
        let absurd = R.pow(Rational::new(1, 30_000).unwrap()).pow(Rational::new(1, 30_000).unwrap());
        assert!(matches!(absurd.dimension(), Err(Mismatch::Overflow { .. })));
    }
}
