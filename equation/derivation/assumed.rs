//! What a chain takes its quantities to be.

use super::atoms::Atoms;
use super::chain::Chain;
use super::conditions::sides;
use super::hypotheses::Hypotheses;
use super::sample::draw;
use crate::expr::Expr;
use crate::symbol::Symbol;
use crate::value::Bindings;
use num_complex::Complex64;
use yardstick::random;

/// How many points are tried for one where a quantity that is called positive is so.
const POINTS: usize = 32;

/// The quantities that a chain speaks of, by what their domains say of them; others are any complex number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assumed {
    /// Positive, unless a premise says otherwise.
    pub positive: Vec<Symbol>,
    /// Real, of either sign.
    pub real: Vec<Symbol>,
}

impl Chain {
    /// What is assumed of the quantities in the lines, in the order of their names.
    pub fn assumed(&self) -> Assumed {
        let mut all: Vec<Symbol> = self
            .lines
            .iter()
            .flat_map(sides)
            .flat_map(Expr::symbols)
            .filter(|symbol| is_real(symbol))
            .cloned()
            .collect();
        all.sort_by(|a, b| a.name().cmp(b.name()));
        all.dedup_by(|a, b| a.name() == b.name());
        let atoms = Atoms::default();
        let hypotheses = Hypotheses::of(self, &atoms).ok();
        let may_be_positive = |symbol: &Symbol| {
            let value =
                hypotheses.as_ref().and_then(|found| found.resolve(&atoms, &symbol.into(), &symbol.into()).ok());
            value.and_then(|mut pairs| pairs.pop()).is_none_or(|(value, _)| is_somewhere_positive(&value))
        };
        let (positive, real): (Vec<_>, Vec<_>) = all.into_iter().partition(|symbol| symbol.domain().re.0 > 0.0);
        Assumed { positive: positive.into_iter().filter(may_be_positive).collect(), real }
    }
}

fn is_real(symbol: &Symbol) -> bool {
    symbol.domain().im == (0.0, 0.0)
}

fn is_somewhere_positive(expr: &Expr) -> bool {
    let symbols: Vec<Symbol> = expr.symbols().into_iter().cloned().collect();
    let mut stream = random::stream(1, "assumed");
    (0..POINTS).any(|_| {
        let mut bindings = Bindings::new();
        draw(&symbols, false, &mut stream).into_iter().for_each(|(symbol, value)| bindings.bind(symbol.name(), value));
        expr.evaluate(&bindings).is_ok_and(|value: Complex64| value.re > 0.0)
    })
}
