//! What is known about the hops of a chain.

use super::atoms::Atoms;
use super::chain::{Chain, Claim, Role};
use super::hypotheses::Hypotheses;
use super::sample::{self, Admission, Comparison};
use super::verdict::{Hop, Verdict};
use crate::Equation;
use crate::expr::Expr;
use crate::ring;
use yardstick::random::Stream;

/// At how many points a decision by normal form is guarded: half of them off the real axis.
const GUARDS: usize = 4;

impl Chain {
    /// Judges every hop: by its normal form, and in any case at points of the domain with `bits` of precision (at
    /// least 53). Where the normal form decides, a few points guard it; otherwise there are `points` of them. The same
    /// `stream` gives the same points.
    pub fn verify(&self, points: usize, bits: usize, stream: &mut Stream) -> Vec<Hop> {
        let atoms = Atoms::default();
        let hypotheses = Hypotheses::of(self, &atoms);
        let is_premise = |at: usize| self.lines[at].role == Role::Premise;
        let claims: Vec<_> = self.pairs().into_iter().filter(|(at, ..)| !is_premise(*at)).collect();
        let cases: Vec<Result<Vec<Comparison>, String>> = claims
            .iter()
            .map(|(at, left, right)| {
                let hypotheses = hypotheses.as_ref().map_err(Clone::clone)?;
                let pairs = hypotheses.resolve(&atoms, left, right).map_err(|why| why.to_string())?;
                let is_equation = matches!(self.lines[*at].claim, Claim::Equation(_));
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
            hops.push(Hop { line: *line, by: self.lines[*line].by.clone(), verdict });
        }
        hops
    }
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
