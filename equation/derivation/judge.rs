//! What is known about the hops of a chain.

use super::atoms::Atoms;
use super::chain::{Chain, Claim, Role};
use super::hypotheses::{Hypotheses, Refusal};
use super::model;
use super::sample::{self, Admission, Comparison, Points};
use super::verdict::{Hop, Verdict};
use crate::Equation;
use crate::expr::Expr;
use crate::ring;
use yardstick::random::Stream;

/// At how many points a decision by normal form is guarded: half of them off the real axis.
const GUARDS: usize = 4;

/// Of a product that is zero one factor is; so many such cases are told apart.
const MOST_CASES: usize = 8;

impl Chain {
    /// Judges every hop: by its normal form, and in any case at points of the domain with `bits` of precision (at
    /// least 53). Where the normal form decides, a few points guard it; otherwise there are `points` of them. The same
    /// `stream` gives the same points.
    ///
    /// A premise that is a product holds where any of its factors is zero. What is claimed must hold in every case that
    /// the other premises admit, with every quantity positive that is called so, if there is such a case.
    pub fn verify(&self, points: usize, bits: usize, stream: &mut Stream) -> Vec<Hop> {
        let effort = Effort { points, bits };
        let mut cases = self.judged(&effort, MOST_CASES, stream);
        for standing in [Standing::Contradictory, Standing::NotPositive] {
            if cases.iter().any(|case| case.standing > standing) {
                cases.retain(|case| case.standing > standing);
            }
        }
        let worst = |all: Vec<Hop>, case: Vec<Hop>| {
            let both = all.into_iter().zip(case);
            both.map(|(a, b)| Hop { verdict: worse(a.verdict, b.verdict), ..b }).collect()
        };
        cases.into_iter().map(|case| case.hops).reduce(worst).unwrap_or_default()
    }

    /// Every case, at most `room` of them.
    fn judged(&self, effort: &Effort, room: usize, stream: &mut Stream) -> Vec<Case> {
        let atoms = Atoms::default();
        let hypotheses = Hypotheses::of(self, &atoms);
        match hypotheses.as_ref().ok().and_then(|found| found.cases(&atoms)).filter(|parts| parts.len() <= room) {
            Some(parts) => {
                let room = room / parts.len();
                parts.iter().flat_map(|part| part.judged(effort, room, stream)).collect()
            }
            None => vec![self.judge(&hypotheses, &atoms, effort, stream)],
        }
    }

    fn judge(
        &self,
        hypotheses: &Result<Hypotheses, Refusal>,
        atoms: &Atoms,
        effort: &Effort,
        stream: &mut Stream,
    ) -> Case {
        let is_premise = |at: usize| self.lines[at].role == Role::Premise;
        let claims: Vec<_> = self.pairs().into_iter().filter(|(at, ..)| !is_premise(*at)).collect();
        let asked: Vec<Result<Vec<Comparison>, String>> = claims
            .iter()
            .map(|(at, left, right)| {
                let hypotheses = hypotheses.as_ref().map_err(|refusal| refusal.why.clone())?;
                let pairs = hypotheses.resolve(atoms, left, right).map_err(|why| why.to_string())?;
                let is_equation = matches!(self.lines[*at].claim, Claim::Equation(_));
                let judged = |(left, right): (Expr, Expr)| {
                    let equation = is_equation.then(|| Equation::new(&left, &right));
                    match equation.and_then(|equation| hypotheses.imply(&equation)) {
                        Some(divisor) => Comparison::implied(left, right, atoms.named(&divisor), GUARDS),
                        None => compare(left, right, effort.points),
                    }
                };
                Ok(pairs.into_iter().map(judged).collect())
            })
            .collect();
        let mut comparisons: Vec<Comparison> = asked.iter().flatten().flatten().cloned().collect();
        let admission = hypotheses.as_ref().map_or_else(|_| Admission::default(), |found| found.admission(atoms));
        let found = sample::run(&mut comparisons, &admission, atoms, effort.bits, stream);
        let open: Vec<Equation> =
            hypotheses.iter().flat_map(|found| &found.unsolved).map(|(premise, _)| premise.clone()).collect();
        let models = (!open.is_empty()).then(|| {
            let symbols = sample::free_symbols(&comparisons, &admission, &open);
            model::find(&open, &admission, &symbols, stream)
        });
        let standing = match hypotheses {
            Err(refusal) if refusal.is_contradiction => Standing::Contradictory,
            Ok(_) if found == Points::Other && models.is_none() => Standing::NotPositive,
            _ => Standing::Open,
        };
        let mut found = comparisons.into_iter();
        let mut hops = Vec::new();
        for ((line, ..), pairs) in claims.iter().zip(asked) {
            let judged = |pair: Comparison| match &models {
                Some(models) => pair.verdict_at(models, atoms, effort.bits),
                None => pair.verdict(atoms),
            };
            let verdict = match pairs {
                Err(why) => Verdict::Unknown { why },
                Ok(pairs) => found.by_ref().take(pairs.len()).map(judged).reduce(worse).unwrap_or(Verdict::Proved),
            };
            hops.push(Hop { line: *line, by: self.lines[*line].by.clone(), verdict });
        }
        Case { hops, standing }
    }
}

/// How much is compared.
struct Effort {
    points: usize,
    bits: usize,
}

/// What became of the hops in one of the cases that a product leaves.
struct Case {
    hops: Vec<Hop>,
    standing: Standing,
}

/// How much a case counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Standing {
    /// The premises contradict one another.
    Contradictory,
    /// Something that is called positive is not.
    NotPositive,
    /// It may be.
    Open,
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
