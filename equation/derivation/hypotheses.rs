//! The hypotheses of a chain, with what its premises are solved for.

use super::atoms::Atoms;
use super::chain::{Chain, Claim, Role};
use super::conditions::divisors;
use super::sample::Admission;
use crate::Equation;
use crate::calculus::{Calculus, Unresolved};
use crate::expr::{Expr, Function, Node};
use crate::hypothesis::Given;
use crate::ring::{self, Solution, Unsolvable};
use crate::symbol::Symbol;
use std::borrow::Cow;
use std::collections::VecDeque;

/// What a chain's hops are judged under.
pub(super) struct Hypotheses<'a> {
    chain: &'a Chain,
    pub given: Vec<Given>,
    /// What was divided by where the premises were solved, and what they divide by themselves.
    pub divisors: Vec<Expr>,
    /// Positive symbols that premises were solved for: what they come out as must be positive.
    positive: Vec<Expr>,
    /// Premises that no symbol could be taken from, each with its name.
    pub unsolved: Vec<(Equation, &'static str)>,
}

/// Why a chain has no hypotheses to be judged under.
#[derive(Clone, Debug)]
pub(super) struct Refusal {
    pub why: String,
    /// Whether the premises contradict one another.
    pub is_contradiction: bool,
}

/// Everything that a premise divides by.
fn divisors_of(premise: &Equation) -> Vec<Expr> {
    [&premise.lhs, &premise.rhs].into_iter().flat_map(divisors).collect()
}

impl<T: std::error::Error> From<T> for Refusal {
    fn from(why: T) -> Self {
        Self { why: why.to_string(), is_contradiction: false }
    }
}

/// A premise and its name.
type Premise<'a> = (&'a Equation, &'static str);

impl<'a> Hypotheses<'a> {
    fn new(chain: &'a Chain, given: &[Given]) -> Self {
        Self { chain, given: given.to_vec(), divisors: Vec::new(), positive: Vec::new(), unsolved: Vec::new() }
    }

    /// The hypotheses of `chain`, with what its premises are solved for.
    pub fn of(chain: &'a Chain, atoms: &Atoms) -> Result<Self, Refusal> {
        let mut all = Self::new(chain, &chain.given);
        if chain.unknowns.is_empty() {
            all = Self::oriented(chain, atoms)?;
        } else {
            let early = Self::new(chain, &chain.given[..chain.solved_under]);
            let solution = early.solve(atoms).or_else(|_| all.solve(atoms))?;
            all.take(solution, "linear solve", atoms);
            if let Some(divisor) = all.first_zero(&all.divisors, atoms)? {
                return Err(all.divided_by(divisor));
            }
        }
        all.settle(atoms)?;
        Ok(all)
    }

    /// Looks again at what the premises divide by and at what could not be solved, now that every hypothesis is known.
    fn settle(&mut self, atoms: &Atoms) -> Result<(), Refusal> {
        let written: Vec<Expr> = self.premises().flat_map(|(premise, _)| divisors_of(premise)).collect();
        if let Some(divisor) = self.first_zero(&written, atoms)? {
            return Err(self.divided_by(divisor));
        }
        self.divisors.extend(written);
        let mut unsolved = Vec::new();
        for (premise, by) in &self.unsolved {
            let (left, right) = (atoms.meant(&premise.lhs), atoms.meant(&premise.rhs));
            let pairs = self.resolve(atoms, &left, &right)?.into_iter();
            let open = pairs.filter(|(left, right)| ring::equal(left, right) != Ok(true));
            unsolved.extend(open.map(|(left, right)| (Equation::new(left, right), *by)));
        }
        self.unsolved = unsolved;
        Ok(())
    }

    fn divided_by(&self, divisor: Expr) -> Refusal {
        let why = format!("a premise is divided by {divisor}, which the premises make zero");
        Refusal { why, is_contradiction: false }
    }

    /// The first of `divisors` that is zero under the hypotheses.
    fn first_zero(&self, divisors: &[Expr], atoms: &Atoms) -> Result<Option<Expr>, Refusal> {
        for divisor in divisors {
            let pairs = self.resolve(atoms, divisor, divisor)?;
            if pairs.iter().any(|(value, _)| ring::equal(value, &Expr::from(0)) == Ok(true)) {
                return Ok(Some(divisor.clone()));
            }
        }
        Ok(None)
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

    fn premises(&self) -> impl Iterator<Item = Premise<'a>> + use<'a> {
        let premises = self.chain.lines.iter().filter(|line| line.role == Role::Premise);
        premises.filter_map(|line| match (&line.claim, line.by.first()) {
            (Claim::Equation(premise), Some(Cow::Borrowed(by))) => Some((premise, *by)),
            (Claim::Equation(premise), _) => Some((premise, "premise")),
            (Claim::Expr(_), _) => None,
        })
    }

    /// Every premise as a hypothesis about one of its symbols, where that can be. One that was divided by what the others
    /// make zero says nothing before they do: it waits until they have spoken. So does one that was divided by anything,
    /// where another contradicts what came of it.
    fn oriented(chain: &'a Chain, atoms: &Atoms) -> Result<Self, Refusal> {
        let mut order: Vec<Premise> = Self::new(chain, &[]).premises().collect();
        let mut last = None;
        for _ in 0..=2 * order.len() {
            let mut all = Self::new(chain, &chain.given);
            match all.orient(&order, atoms)? {
                None => return Ok(all),
                Some((at, refusal)) => {
                    let late = order.remove(at);
                    order.push(late);
                    last = Some(refusal);
                }
            }
        }
        last.map_or_else(|| Ok(Self::new(chain, &chain.given)), Err)
    }

    /// Takes the premises one after the other, and what no symbol could be taken from once more when all have spoken; the
    /// place of the first that must not come so early, and why, if there is one.
    fn orient(&mut self, order: &[Premise], atoms: &Atoms) -> Result<Option<(usize, Refusal)>, Refusal> {
        let mut owners = Vec::new();
        let mut queue: VecDeque<_> = (0..order.len()).map(|at| (at, false)).collect();
        while let Some((at, is_late)) = queue.pop_front() {
            let (premise, by) = order[at];
            let mut waits = false;
            for (left, right) in self.resolve(atoms, &premise.lhs, &premise.rhs)? {
                let premise = Equation::new(left, right);
                match ring::orient(&premise) {
                    Ok(solution) => {
                        let positive = solution.values.iter().filter(|(symbol, _)| symbol.domain().re.0 > 0.0);
                        self.positive.extend(positive.map(|(symbol, _)| Expr::from(symbol)));
                        owners.extend(solution.divisors.iter().map(|_| at));
                        self.take(solution, by, atoms);
                    }
                    Err(Unsolvable::NoSymbol(_)) if is_late => self.unsolved.push((premise, by)),
                    Err(Unsolvable::NoSymbol(_)) => waits = true,
                    Err(why @ Unsolvable::Contradiction(_)) => {
                        let refusal = Refusal { why: why.to_string(), is_contradiction: owners.is_empty() };
                        return Ok(Some((owners.last().copied().unwrap_or(at), refusal)));
                    }
                    Err(why) => {
                        let zero = self.first_zero(&divisors_of(order[at].0), atoms);
                        return Err(zero.ok().flatten().map_or(why.into(), |divisor| self.divided_by(divisor)));
                    }
                }
            }
            if waits {
                queue.push_back((at, true));
            }
        }
        let found = self.first_zero(&self.divisors, atoms)?;
        let owner = |divisor: &Expr| self.divisors.iter().position(|own| own == divisor).map(|at| owners[at]);
        Ok(found.and_then(|divisor| Some((owner(&divisor)?, self.divided_by(divisor)))))
    }

    /// What a point must satisfy to count, in numbers and free symbols.
    pub fn admission(&self, atoms: &Atoms) -> Admission {
        let value = |expr: &Expr| self.resolve(atoms, expr, expr).ok()?.pop().map(|(value, _)| value);
        let positive = self.positive.iter().filter_map(&value);
        let (roots, positive) = positive.partition(|value| matches!(value.node(), Node::Function(Function::Sqrt, _)));
        Admission { roots, positive, divisors: self.divisors.iter().filter_map(value).collect() }
    }

    /// The unknowns as the premises together determine them.
    fn solve(&self, atoms: &Atoms) -> Result<Solution, Refusal> {
        let mut system = Vec::new();
        for (premise, _) in self.premises() {
            system.extend(self.resolve(atoms, &premise.lhs, &premise.rhs)?);
        }
        Ok(ring::solve(&system, &self.chain.unknowns)?)
    }

    /// The scalar equations that `left` = `right` stands for, in numbers and symbols alone.
    pub fn resolve(&self, atoms: &Atoms, left: &Expr, right: &Expr) -> Result<Vec<(Expr, Expr)>, Unresolved> {
        let equal = |a: &Expr, b: &Expr| ring::equal(&atoms.named(a), &atoms.named(b)) == Ok(true);
        let pairs = Calculus::new(&self.given, &self.chain.primitives, &equal).resolve(left, right)?;
        Ok(pairs.into_iter().map(|(left, right)| (atoms.named(&left), atoms.named(&right))).collect())
    }

    /// The chain once for every factor of a premise that is a product and could not be solved; `None` where there is no
    /// such premise, or one of its factors is known to be zero.
    pub fn cases(&self, atoms: &Atoms) -> Option<Vec<Chain>> {
        let is_given = |factor: &Expr| {
            self.unsolved.iter().any(|(premise, _)| premise.lhs == *factor && premise.rhs == Expr::from(0))
        };
        self.unsolved.iter().find_map(|(premise, by)| {
            let factors = ring::factors(premise).ok().filter(|factors| factors.len() > 1)?;
            let with = |factor: &Expr| self.chain.clone().and(Equation::new(atoms.meant(factor), 0), by);
            (!factors.iter().any(is_given)).then(|| factors.iter().map(with).collect())
        })
    }

    /// What must not vanish for one of the premises that could not be solved to lead to `equation`, if one does.
    pub fn imply(&self, equation: &Equation) -> Option<Expr> {
        self.unsolved.iter().find_map(|(from, _)| ring::follows(from, equation).ok()?)
    }
}
