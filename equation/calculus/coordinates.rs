//! What fields depend on, and the components of a vector along it.

use crate::dimension::Dimension;
use crate::expr::{Expr, Node};
use crate::symbol::{Rank, Symbol};

const AXES: [&str; 3] = ["x", "y", "z"];

/// The coordinate along an axis where the author names none.
pub(super) fn coordinate(axis: usize) -> Symbol {
    Symbol::scalar(AXES[axis], Dimension::METRE).real(0.25, 1.25)
}

pub(super) fn coordinate_name(expr: &Expr) -> Option<String> {
    match expr.node() {
        Node::Symbol(symbol) if is_coordinate(symbol) => Some(symbol.name().to_owned()),
        _ => None,
    }
}

/// Whether fields depend on it.
pub(super) fn is_coordinate(symbol: &Symbol) -> bool {
    symbol.rank() == Rank::Scalar && (symbol.name() == "t" || AXES.contains(&symbol.name()))
}

/// E → Eₓ, E₁ → E₁ₓ, E₁′ → E₁ₓ′; r → x.
pub(super) fn component(vector: &Symbol, axis: usize) -> Symbol {
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

/// Whether it may have another value for another `variable`.
pub(super) fn varies(expr: &Expr, variable: &Symbol) -> bool {
    match expr.node() {
        Node::Symbol(symbol) => symbol.name() == variable.name() || (symbol.is_field() && is_coordinate(variable)),
        _ => expr.children().into_iter().any(|child| varies(child, variable)),
    }
}
