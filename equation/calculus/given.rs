//! What is given, made ready: symbols and forms to put in, rules for derivatives, primitives.

use super::coordinates::{component, coordinate, coordinate_name};
use crate::expr::{Expr, Nabla, Node, partial};
use crate::hypothesis::{Given, Primitive};
use crate::symbol::{Rank, Symbol};
use std::collections::HashMap;

/// Hypotheses and primitives, ready to be applied to any number of equations.
///
/// - A symbol is replaced by what it is given as before any derivative is taken; so is any other form, where it stands
///   as it is written and before components are taken.
/// - The derivative of a field that is given (∂F/∂t := f) replaces every derivative that contains it by the remaining
///   derivatives of f, again and again. With Faraday's and Ampère's laws this leaves spatial derivatives only.
/// - A given divergence ∇·F := f does the same for ∂F_z/∂z := f − ∂Fₓ/∂x − ∂F_y/∂y.
pub struct Calculus<'a> {
    pub(super) symbols: HashMap<&'a str, &'a Expr>,
    pub(super) forms: HashMap<&'a Expr, &'a Expr>,
    pub(super) rules: Vec<Rule>,
    pub(super) primitives: &'a [Primitive],
    /// Everything that a symbol could be declared in.
    pub(super) sources: Vec<&'a Expr>,
    /// Whether two scalar expressions are equal: the decider.
    pub(super) equal: &'a dyn Fn(&Expr, &Expr) -> bool,
}

/// A derivative of a scalar field, or of a component of a vector field, that is given.
pub(super) struct Rule {
    pub field: String,
    /// The names of the variables.
    pub by: Vec<String>,
    pub value: Expr,
    /// Which component of `value`, if it is a vector.
    pub axis: Option<usize>,
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
