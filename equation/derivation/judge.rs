//! What is known about the hops of a chain.

use super::sample::{self, Admission, Comparison};
use super::{Chain, Claim, Given, Hop, Role, Verdict};
use crate::Equation;
use crate::calculus::{Calculus, Unresolved};
use crate::expr::{Expr, Function, Node};
use crate::ring::{self, Solution, Unsolvable};
use crate::symbol::Symbol;
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use yardstick::random::Stream;

/// At how many points a decision by normal form is guarded: half of them off the real axis.
const GUARDS: usize = 4;

/// Judges every hop of `chain`.
pub(super) fn judge(chain: &Chain, points: usize, bits: usize, stream: &mut Stream) -> Vec<Hop> {
    let atoms = Atoms::default();
    let hypotheses = Hypotheses::of(chain, &atoms);
    let is_premise = |at: usize| chain.lines[at].role == Role::Premise;
    let claims: Vec<_> = chain.pairs().into_iter().filter(|(at, ..)| !is_premise(*at)).collect();
    let cases: Vec<Result<Vec<Comparison>, String>> = claims
        .iter()
        .map(|(at, left, right)| {
            let hypotheses = hypotheses.as_ref().map_err(Clone::clone)?;
            let pairs = hypotheses.resolve(&atoms, left, right).map_err(|why| why.to_string())?;
            let is_equation = matches!(chain.lines[*at].claim, Claim::Equation(_));
            let judged = |(left, right): (Expr, Expr)| {
                let equation = is_equation.then(|| Equation::new(&left, &right));
                match equation.and_then(|equation| hypotheses.imply(&equation)) {
                    Some(divisor) => Comparison::implied(left, right, atoms.named(&divisor), GUARDS),
                    None => compare(left, right, points),
                }
            };
            Ok(pairs.into_iter().map(judged).collect())
        })
        .collect();
    let mut comparisons: Vec<Comparison> = cases.iter().flatten().flatten().cloned().collect();
    let admission = hypotheses.as_ref().map_or_else(|_| Admission::default(), |found| found.admission(&atoms));
    let is_open = hypotheses.as_ref().is_ok_and(|hypotheses| !hypotheses.unsolved.is_empty());
    sample::run(&mut comparisons, &admission, &atoms, bits, stream);
    let mut found = comparisons.into_iter();
    let mut hops = Vec::new();
    for ((line, ..), case) in claims.iter().zip(cases) {
        let verdict = match case {
            Err(why) => Verdict::Unknown { why },
            Ok(pairs) => found
                .by_ref()
                .take(pairs.len())
                .map(|pair| pair.verdict(&atoms, is_open))
                .reduce(worse)
                .unwrap_or(Verdict::Proved),
        };
        hops.push(Hop { line: *line, by: chain.lines[*line].by.clone(), verdict });
    }
    hops
}

/// Two scalar sides, decided by normal form where that can be.
fn compare(left: Expr, right: Expr, points: usize) -> Comparison {
    let (normal, points) = match ring::equal(&left, &right) {
        Ok(true) => (Ok(()), GUARDS),
        Ok(false) => (Err("the normal forms differ".to_owned()), points),
        Err(why) => (Err(why.to_string()), points),
    };
    Comparison::new(left, right, normal, points)
}

/// The less favourable of two verdicts on parts of one hop.
fn worse(a: Verdict, b: Verdict) -> Verdict {
    let rank = |verdict: &Verdict| match verdict {
        Verdict::Refuted { .. } => (0, 0.0),
        Verdict::Unknown { .. } => (1, 0.0),
        Verdict::Agrees { digits, .. } => (2, *digits),
        Verdict::Proved => (3, 0.0),
    };
    if rank(&b) < rank(&a) { b } else { a }
}

/// What a chain's hops are judged under.
pub(super) struct Hypotheses<'a> {
    chain: &'a Chain,
    pub given: Vec<Given>,
    /// What was divided by where the premises were solved.
    pub divisors: Vec<Expr>,
    /// Positive symbols that premises were solved for: what they come out as must be positive.
    positive: Vec<Expr>,
    /// Premises that no symbol could be taken from.
    unsolved: Vec<Equation>,
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
    fn admission(&self, atoms: &Atoms) -> Admission {
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
    fn resolve(&self, atoms: &Atoms, left: &Expr, right: &Expr) -> Result<Vec<(Expr, Expr)>, Unresolved> {
        let equal = |a: &Expr, b: &Expr| ring::equal(&atoms.named(a), &atoms.named(b)) == Ok(true);
        let pairs = Calculus::new(&self.given, &self.chain.primitives, &equal).resolve(left, right)?;
        Ok(pairs.into_iter().map(|(left, right)| (atoms.named(&left), atoms.named(&right))).collect())
    }

    /// What must not vanish for one of the premises that could not be solved to lead to `equation`, if one does.
    fn imply(&self, equation: &Equation) -> Option<Expr> {
        self.unsolved.iter().find_map(|from| ring::follows(from, equation).ok()?)
    }
}

/// Functions at arguments, derivatives and differentials, each under the name of a number: at a point their values are independent.
#[derive(Default)]
pub(super) struct Atoms {
    known: RefCell<Vec<(Expr, Symbol)>>,
    /// Whether two of them may be one, although it could not be decided.
    is_doubtful: Cell<bool>,
}

impl Atoms {
    /// `expr` with a symbol for each of them, the same one where the arguments are equal.
    fn named(&self, expr: &Expr) -> Expr {
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
    fn meant(&self, expr: &Expr) -> Expr {
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
            if sample::differ(a, b) {
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

/// A symbol with any of the values that a derivative or a differential of `field` may have.
fn slope_of(field: &Symbol) -> Symbol {
    let is_real = field.domain().im == (0.0, 0.0);
    let slope = field.clone();
    if is_real { slope.real(-1.0, 1.0) } else { slope.complex((-1.0, 1.0), (-1.0, 1.0)) }
}
