//! What algebra cannot look into, under names of its own.

use crate::expr::{Expr, Node};
use crate::ring;
use crate::symbol::Symbol;
use crate::value::Bindings;
use num_complex::Complex64;
use std::cell::{Cell, RefCell};

/// Functions at arguments, derivatives and differentials, each under the name of a number: at a point their values are independent.
#[derive(Default)]
pub(super) struct Atoms {
    known: RefCell<Vec<(Expr, Symbol)>>,
    /// Whether two of them may be one, although it could not be decided.
    is_doubtful: Cell<bool>,
}

impl Atoms {
    /// `expr` with a symbol for each of them, the same one where the arguments are equal.
    pub fn named(&self, expr: &Expr) -> Expr {
        match expr.node() {
            Node::Apply(function, _) => self.symbol(expr, function.clone()).into(),
            Node::Partial(of, _) => match of.node() {
                Node::Symbol(field) | Node::Apply(field, _) => self.symbol(expr, slope_of(field)).into(),
                _ => expr.clone(),
            },
            Node::Differential(of) => match of.node() {
                Node::Symbol(symbol) => self.symbol(expr, slope_of(symbol)).into(),
                _ => expr.clone(),
            },
            _ => expr.map(&mut |child| self.named(child)),
        }
    }

    /// The symbol for `atom`, which has the values of `like`.
    fn symbol(&self, atom: &Expr, like: Symbol) -> Symbol {
        let mut known = self.known.borrow_mut();
        for (other, symbol) in known.iter() {
            match likeness(other, atom) {
                Likeness::Same => return symbol.clone(),
                Likeness::Doubtful => self.is_doubtful.set(true),
                Likeness::Different => {}
            }
        }
        let symbol = like.named(format!("#{}", known.len()));
        known.push((atom.clone(), symbol.clone()));
        symbol
    }

    /// `expr` with what the symbols stand for.
    pub fn meant(&self, expr: &Expr) -> Expr {
        let known = self.known.borrow();
        known.iter().fold(expr.clone(), |expr, (atom, symbol)| expr.replace(&symbol.into(), atom))
    }

    /// How a symbol is called: by its own name, or by what it stands for.
    pub fn face(&self, symbol: &Symbol) -> String {
        let known = self.known.borrow();
        let atom = known.iter().find(|(_, own)| own.name() == symbol.name());
        atom.map_or_else(|| symbol.to_string(), |(atom, _)| atom.to_string())
    }

    pub fn is_doubtful(&self) -> bool {
        self.is_doubtful.get()
    }
}

enum Likeness {
    Same,
    Different,
    Doubtful,
}

/// Whether two atoms are one: the same function or derivative at equal arguments.
fn likeness(a: &Expr, b: &Expr) -> Likeness {
    let all = |a: &[Expr], b: &[Expr]| {
        if a.len() != b.len() {
            return Likeness::Different;
        }
        let mut all = Likeness::Same;
        for (a, b) in a.iter().zip(b) {
            if a == b || ring::equal(a, b) == Ok(true) {
                continue;
            }
            if differ(a, b) {
                return Likeness::Different;
            }
            all = Likeness::Doubtful;
        }
        all
    };
    match (a.node(), b.node()) {
        _ if a == b => Likeness::Same,
        (Node::Apply(f, a), Node::Apply(g, b)) if f.name() == g.name() => all(a, b),
        (Node::Partial(f, a), Node::Partial(g, b)) if a.len() == b.len() => match (likeness(f, g), all(a, b)) {
            (Likeness::Same, by) => by,
            (of, Likeness::Same) => of,
            (Likeness::Different, _) | (_, Likeness::Different) => Likeness::Different,
            _ => Likeness::Doubtful,
        },
        _ => Likeness::Different,
    }
}

/// Whether two expressions have different values at the middle of their symbols' domains.
fn differ(a: &Expr, b: &Expr) -> bool {
    let mut bindings = Bindings::new();
    for (at, symbol) in a.symbols().into_iter().chain(b.symbols()).enumerate() {
        // Not the very middle, where symbols of one domain would be equal.
        let place = 0.5 + 0.3 * (1.0 + at as f64).sin();
        let between = |(min, max): (f64, f64)| min + (max - min) * place;
        let domain = symbol.domain();
        if !bindings.has(symbol.name()) {
            bindings.bind(symbol.name(), Complex64::new(between(domain.re), between(domain.im)));
        }
    }
    match (a.evaluate(&bindings), b.evaluate(&bindings)) {
        (Ok(a), Ok(b)) => (a - b).norm() > 1e-6 * (a.norm() + b.norm()),
        _ => false,
    }
}

/// A symbol with any of the values that a derivative or a differential of `field` may have.
fn slope_of(field: &Symbol) -> Symbol {
    let is_real = field.domain().im == (0.0, 0.0);
    let slope = field.clone();
    if is_real { slope.real(-1.0, 1.0) } else { slope.complex((-1.0, 1.0), (-1.0, 1.0)) }
}
