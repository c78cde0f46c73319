//! The hypotheses of a chain, with what its premises are solved for.

use super::atoms::Atoms;
use super::chain::{Chain, Claim, Role};
use super::sample::Admission;
use crate::Equation;
use crate::calculus::{Calculus, Unresolved};
use crate::expr::{Expr, Function, Node};
use crate::hypothesis::Given;
use crate::ring::{self, Solution, Unsolvable};
use crate::symbol::Symbol;
use std::borrow::Cow;

/// What a chain's hops are judged under.
pub(super) struct Hypotheses<'a> {
    chain: &'a Chain,
    pub given: Vec<Given>,
    /// What was divided by where the premises were solved.
    pub divisors: Vec<Expr>,
    /// Positive symbols that premises were solved for: what they come out as must be positive.
    positive: Vec<Expr>,
    /// Premises that no symbol could be taken from.
    pub unsolved: Vec<Equation>,
}

impl<'a> Hypotheses<'a> {
    fn new(chain: &'a Chain, given: &[Given]) -> Self {
        Self { chain, given: given.to_vec(), divisors: Vec::new(), positive: Vec::new(), unsolved: Vec::new() }
    }

    /// The hypotheses of `chain`, with what its premises are solved for.
    pub fn of(chain: &'a Chain, atoms: &Atoms) -> Result<Self, String> {
        let mut all = Self::new(chain, &chain.given);
        if chain.unknowns.is_empty() {
            all.orient(atoms)?;
        } else {
            let early = Self::new(chain, &chain.given[..chain.solved_under]);
            let solution = early.solve(atoms).or_else(|_| all.solve(atoms))?;
            all.take(solution, "linear solve", atoms);
        }
        all.settle(atoms)?;
        Ok(all)
    }

    /// Looks again at what was divided by and at what could not be solved, now that every hypothesis is known.
    fn settle(&mut self, atoms: &Atoms) -> Result<(), String> {
        for divisor in &self.divisors {
            let pairs = self.resolve(atoms, divisor, divisor).map_err(|why| why.to_string())?;
            if pairs.iter().any(|(value, _)| ring::equal(value, &Expr::from(0)) == Ok(true)) {
                return Err(format!("a premise was divided by {divisor}, which the premises make zero"));
            }
        }
        let mut unsolved = Vec::new();
        for premise in &self.unsolved {
            let (left, right) = (atoms.meant(&premise.lhs), atoms.meant(&premise.rhs));
            let pairs = self.resolve(atoms, &left, &right).map_err(|why| why.to_string())?;
            unsolved.extend(pairs.into_iter().filter(|(left, right)| ring::equal(left, right) != Ok(true)));
        }
        self.unsolved = unsolved.into_iter().map(|(left, right)| Equation::new(left, right)).collect();
        Ok(())
    }

    /// Adds what was found for symbols, known as `by`.
    fn take(&mut self, solution: Solution, by: &'static str, atoms: &Atoms) {
        let given = |(symbol, value): &(Symbol, Expr)| Given {
            what: atoms.meant(&symbol.into()),
            value: atoms.meant(value),
            by,
        };
        self.given.extend(solution.values.iter().map(given));
        self.divisors.extend(solution.divisors.iter().map(|divisor| atoms.meant(divisor)));
    }

    fn premises(&self) -> impl Iterator<Item = (&'a Equation, &'static str)> + use<'a> {
        let premises = self.chain.lines.iter().filter(|line| line.role == Role::Premise);
        premises.filter_map(|line| match (&line.claim, line.by.first()) {
            (Claim::Equation(premise), Some(Cow::Borrowed(by))) => Some((premise, *by)),
            (Claim::Equation(premise), _) => Some((premise, "premise")),
            (Claim::Expr(_), _) => None,
        })
    }

    /// Every premise as a hypothesis about one of its symbols, where that can be.
    fn orient(&mut self, atoms: &Atoms) -> Result<(), String> {
        for (premise, by) in self.premises() {
            for (left, right) in self.resolve(atoms, &premise.lhs, &premise.rhs).map_err(|why| why.to_string())? {
                let premise = Equation::new(left, right);
                match ring::orient(&premise) {
                    Ok(solution) => {
                        let positive = solution.values.iter().filter(|(symbol, _)| symbol.domain().re.0 > 0.0);
                        self.positive.extend(positive.map(|(symbol, _)| Expr::from(symbol)));
                        self.take(solution, by, atoms);
                    }
                    Err(Unsolvable::NoSymbol(_)) => self.unsolved.push(premise),
                    Err(why) => return Err(why.to_string()),
                }
            }
        }
        Ok(())
    }

    /// What a point must satisfy to count, in numbers and free symbols.
    pub fn admission(&self, atoms: &Atoms) -> Admission {
        let value = |expr: &Expr| self.resolve(atoms, expr, expr).ok()?.pop().map(|(value, _)| value);
        let positive = self.positive.iter().filter_map(&value);
        let (roots, positive) = positive.partition(|value| matches!(value.node(), Node::Function(Function::Sqrt, _)));
        Admission { roots, positive, divisors: self.divisors.iter().filter_map(value).collect() }
    }

    /// The unknowns as the premises together determine them.
    fn solve(&self, atoms: &Atoms) -> Result<Solution, String> {
        let mut system = Vec::new();
        for (premise, _) in self.premises() {
            system.extend(self.resolve(atoms, &premise.lhs, &premise.rhs).map_err(|why| why.to_string())?);
        }
        ring::solve(&system, &self.chain.unknowns).map_err(|why| why.to_string())
    }

    /// The scalar equations that `left` = `right` stands for, in numbers and symbols alone.
    pub fn resolve(&self, atoms: &Atoms, left: &Expr, right: &Expr) -> Result<Vec<(Expr, Expr)>, Unresolved> {
        let equal = |a: &Expr, b: &Expr| ring::equal(&atoms.named(a), &atoms.named(b)) == Ok(true);
        let pairs = Calculus::new(&self.given, &self.chain.primitives, &equal).resolve(left, right)?;
        Ok(pairs.into_iter().map(|(left, right)| (atoms.named(&left), atoms.named(&right))).collect())
    }

    /// What must not vanish for one of the premises that could not be solved to lead to `equation`, if one does.
    pub fn imply(&self, equation: &Equation) -> Option<Expr> {
        self.unsolved.iter().find_map(|from| ring::follows(from, equation).ok()?)
    }
}
