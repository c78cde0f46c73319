//! Rules of the field: factors, fractions, squares, powers of e.

use super::number::{compare, is_unit, multiply};
use super::scene::Scene;
use super::term::{Form, Power, Term};
use crate::expr::Function;
use crate::rational::Rational;
use std::cmp::Ordering;

/// What a rule makes of a term.
#[derive(Clone, Debug)]
pub(super) struct Rewrite {
    pub to: Term,
    /// The factor that it is about: the k of "cancel k".
    pub about: Option<Term>,
    /// The factors on the way, not yet cancelled; may be empty.
    pub via: Vec<Power>,
}

impl Rewrite {
    fn about(factor: Term, to: Term) -> Self {
        Self { to, about: Some(factor), via: vec![] }
    }
}

impl From<Term> for Rewrite {
    fn from(to: Term) -> Self {
        Self { to, about: None, via: vec![] }
    }
}

/// What a rule found.
pub(super) type Found = Vec<Rewrite>;

/// Sums of more terms are not taken apart.
const WIDEST: usize = 24;
/// Higher powers of sums are not multiplied out.
const HIGHEST: i64 = 4;

/// The powers that all `terms` have in common, each with the exponent nearest to 0.
pub(super) fn common_factor(terms: &[&Term]) -> Vec<Power> {
    let Some((first, others)) = terms.split_first() else { return vec![] };
    let mut common = first.factors().1;
    for term in others {
        let (_, factors) = term.factors();
        common.retain_mut(|(base, e)| match factors.iter().find(|(known, _)| known == base) {
            Some((_, f)) if f.is_negative() == e.is_negative() => {
                if (compare(*f, *e) == Ordering::Less) != e.is_negative() {
                    *e = *f;
                }
                true
            }
            _ => false,
        });
    }
    common
}

fn positive(powers: Vec<Power>) -> Vec<Power> {
    powers.into_iter().filter(|(_, e)| !e.is_negative()).collect()
}

fn inverse(powers: &[Power]) -> Term {
    Term::product(powers.iter().map(|(base, e)| (base.clone(), e.negated())))
}

/// k·(every term of `sum` over k).
fn take_out(sum: &[&Term], factor: &[Power]) -> Term {
    let by = inverse(factor);
    let rest = Term::sum(sum.iter().map(|term| term.times(&by)));
    Term::product(factor.iter().cloned().chain([(rest, Rational::ONE)]))
}

/// ka + kb → k(a + b), for all terms or for those that share a factor.
pub(super) fn factor(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Sum(terms) = term.form() else { return };
    if terms.len() > WIDEST {
        return;
    }
    let all: Vec<&Term> = terms.iter().collect();
    let shared = positive(common_factor(&all));
    if !shared.is_empty() {
        found.push(Rewrite::about(Term::product(shared.clone()), take_out(&all, &shared)));
        return;
    }
    let mut seen: Vec<Vec<bool>> = Vec::new();
    for (base, _) in terms.iter().flat_map(|term| positive(term.factors().1)) {
        let has = |term: &Term| term.factors().1.iter().any(|(known, e)| *known == base && !e.is_negative());
        let members: Vec<bool> = terms.iter().map(has).collect();
        let group: Vec<&Term> =
            terms.iter().zip(&members).filter(|(_, member)| **member).map(|(term, _)| term).collect();
        if group.len() < 2 || seen.contains(&members) {
            continue;
        }
        let shared = positive(common_factor(&group));
        let rest = terms.iter().zip(&members).filter(|(_, member)| !**member).map(|(term, _)| term.clone());
        let to = Term::sum(rest.chain([take_out(&group, &shared)]));
        found.push(Rewrite::about(Term::product(shared), to));
        seen.push(members);
    }
}

/// (ka + kb)/(kc + kd) → (a + b)/(c + d): factors that all terms of a sum share, where they leave the fraction.
pub(super) fn cancel(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Product(c, factors) = term.form() else { return };
    let mut shared: Vec<Power> = Vec::new();
    let mut parts: Vec<Power> = vec![(Term::number(*c), Rational::ONE)];
    for (base, e) in factors {
        let all: Vec<&Term> = base.terms().iter().collect();
        let common = if all.len() > 1 && e.as_integer().is_some() { positive(common_factor(&all)) } else { vec![] };
        if common.is_empty() {
            parts.push((base.clone(), *e));
            shared.push((base.clone(), *e));
            continue;
        }
        let by = inverse(&common);
        let taken: Vec<Power> = common.into_iter().filter_map(|(b, f)| Some((b, multiply(f, *e)?))).collect();
        parts.extend(taken.iter().cloned());
        parts.push((Term::sum(all.iter().map(|term| term.times(&by))), *e));
        shared.extend(taken);
    }
    let mut gone = Vec::new();
    for (at, (base, e)) in shared.iter().enumerate() {
        let opposite = shared[at + 1..].iter().find(|(other, f)| other == base && f.is_negative() != e.is_negative());
        if let Some((_, f)) = opposite {
            let least = if compare(absolute(*e), absolute(*f)) == Ordering::Less { *e } else { *f };
            gone.push((base.clone(), absolute(least)));
        }
    }
    if !gone.is_empty() {
        found.push(Rewrite { to: Term::product(parts.clone()), about: Some(Term::product(gone)), via: parts });
    }
}

fn absolute(value: Rational) -> Rational {
    if value.is_negative() { value.negated() } else { value }
}

/// N/D → Q where N = QD: division of polynomials without remainder.
pub(super) fn divide(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Product(c, factors) = term.form() else { return };
    let less_one = |e: Rational| Rational::integer(e.as_integer().unwrap_or(1) - 1);
    let sums = |sign: bool| {
        factors.iter().filter(move |(base, e)| {
            matches!(base.form(), Form::Sum(_)) && e.is_negative() == sign && e.as_integer().is_some()
        })
    };
    for (above, _) in sums(false) {
        for (below, _) in sums(true) {
            if let Some(quotient) = quotient(above, below) {
                let rest =
                    factors.iter().map(|(base, e)| (base.clone(), if base == above { less_one(*e) } else { *e }));
                let via = rest.chain([
                    (quotient, Rational::ONE),
                    (below.clone(), Rational::ONE),
                    (Term::number(*c), Rational::ONE),
                ]);
                let via: Vec<Power> = via.filter(|(_, e)| !e.is_zero()).collect();
                found.push(Rewrite { to: Term::product(via.clone()), about: Some(below.clone()), via });
            }
        }
    }
}

/// The polynomial quotient of two sums, if there is no remainder.
fn quotient(above: &Term, below: &Term) -> Option<Term> {
    let mut rest = above.clone();
    let mut result = Vec::new();
    let lead = &below.terms()[0];
    for _ in 0..2 * WIDEST {
        if rest.is_zero() {
            return Some(Term::sum(result));
        }
        let next = rest.terms()[0].over(lead);
        let is_whole = next.factors().1.iter().all(|(_, e)| !e.is_negative());
        if !is_whole || rest.terms().len() > WIDEST {
            return None;
        }
        rest = Term::sum(rest.terms().iter().cloned().chain(below.terms().iter().map(|t| t.times(&next).negated())));
        result.push(next);
    }
    None
}

/// c/(a + b) → c(a − b)/(a² − b²)
pub(super) fn conjugate(term: &Term, _: &Scene, found: &mut Found) {
    let (_, factors) = term.factors();
    for (base, e) in factors {
        if let [a, b] = base.terms()
            && e == Rational::integer(-1)
        {
            let (other, product) = (a.minus(b), a.squared().minus(&b.squared()));
            let to = term.times(&other).times(&base).over(&product);
            found.push(Rewrite::about(other, to));
        }
    }
}

/// a/b + c/d → (ad + cb)/(bd)
pub(super) fn common_denominator(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Sum(terms) = term.form() else { return };
    let mut below: Vec<Power> = Vec::new();
    for (base, e) in terms.iter().flat_map(|term| term.factors().1).filter(|(_, e)| e.is_negative()) {
        match below.iter_mut().find(|(known, _)| *known == base) {
            Some((_, least)) => *least = if compare(e, *least) == Ordering::Less { e } else { *least },
            None => below.push((base, e)),
        }
    }
    if !below.is_empty() && terms.len() <= WIDEST {
        let by = inverse(&below);
        let above = Term::sum(terms.iter().map(|term| term.times(&by)));
        found.push(above.over(&by).into());
    }
}

/// (a + b)/c → a/c + b/c
pub(super) fn split(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Product(_, factors) = term.form() else { return };
    if !factors.iter().any(|(_, e)| e.is_negative()) {
        return;
    }
    for (base, e) in factors {
        if is_unit(*e) && matches!(base.form(), Form::Sum(_)) && base.terms().len() <= WIDEST {
            let rest = term.over(base);
            found.push(Term::sum(base.terms().iter().map(|part| part.times(&rest))).into());
        }
    }
}

/// (a + b)(c + d) → ac + ad + bc + bd, above the line or below it.
pub(super) fn expand(term: &Term, _: &Scene, found: &mut Found) {
    let (_, factors) = term.factors();
    for below in [false, true] {
        let side: Vec<&Power> = factors.iter().filter(|(_, e)| e.is_negative() == below).collect();
        let is_open = |(base, e): &&&Power| {
            matches!(base.form(), Form::Sum(_)) && e.as_integer().is_some_and(|n| n.abs() <= HIGHEST)
        };
        let open: Vec<&&Power> = side.iter().filter(is_open).collect();
        if open.is_empty() || (side.len() == 1 && is_unit(absolute(side[0].1))) {
            continue;
        }
        let closed = side.iter().filter(|power| !is_open(power)).map(|(base, e)| (base.clone(), absolute(*e)));
        let mut expanded = vec![Term::product(closed)];
        for (base, e) in open {
            for _ in 0..e.as_integer().unwrap_or(0).abs() {
                let products = expanded.iter().flat_map(|part| base.terms().iter().map(|term| part.times(term)));
                expanded = Term::sum(products.collect::<Vec<_>>()).terms().to_vec();
                if expanded.len() > WIDEST {
                    return;
                }
            }
        }
        let sign = Rational::integer(if below { -1 } else { 1 });
        let rest = side.iter().map(|(base, e)| (base.clone(), e.negated()));
        let to = Term::product(rest.chain([(term.clone(), Rational::ONE), (Term::sum(expanded), sign)]));
        found.push(to.into());
    }
}

/// (a + b)² → a² + 2ab + b²
pub(super) fn expand_square(term: &Term, _: &Scene, found: &mut Found) {
    for (base, e) in term.factors().1 {
        let Form::Sum(parts) = base.form() else { continue };
        if absolute(e) != Rational::integer(2) || parts.len() > 3 {
            continue;
        }
        let cross = parts
            .iter()
            .enumerate()
            .flat_map(|(at, a)| parts[at + 1..].iter().map(move |b| a.times(b).scaled(Rational::integer(2))));
        let square = Term::sum(parts.iter().map(Term::squared).chain(cross));
        let half = if e.is_negative() { Rational::integer(-1) } else { Rational::ONE };
        found.push(Term::product([(term.over(&base.power(e)), Rational::ONE), (square, half)]).into());
    }
}

/// a² + 2ab + b² → (a + b)²
pub(super) fn complete_square(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Sum(terms) = term.form() else { return };
    if terms.len() != 3 {
        return;
    }
    for cross in 0..3 {
        let (a, b) = (&terms[(cross + 1) % 3], &terms[(cross + 2) % 3]);
        let (Some(a), Some(b)) = (root(a), root(b)) else { continue };
        let product = a.times(&b).scaled(Rational::integer(2));
        if product == terms[cross] {
            found.push(a.plus(&b).squared().into());
        } else if product.negated() == terms[cross] {
            found.push(a.minus(&b).squared().into());
        }
    }
}

/// The square root of a monomial that is a square as it stands.
pub(super) fn root(term: &Term) -> Option<Term> {
    let (c, factors) = term.factors();
    let whole = |n: i64| {
        let root = n.isqrt();
        (root * root == n).then_some(root)
    };
    if c.is_negative() {
        return None;
    }
    let c = Rational::new(whole(c.numerator())?, whole(c.denominator())?)?;
    let halves = factors.into_iter().map(|(base, e)| {
        let n = e.as_integer().filter(|n| n % 2 == 0)?;
        Some((base, Rational::integer(n / 2)))
    });
    Some(Term::product(halves.collect::<Option<Vec<_>>>()?.into_iter().chain([(Term::number(c), Rational::ONE)])))
}

/// a² − b² → (a + b)(a − b), with a common factor in front.
pub(super) fn split_squares(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Sum(terms) = term.form() else { return };
    let [first, second] = terms.as_slice() else { return };
    let common = Term::product(common_factor(&[first, second]));
    let content = Term::number(absolute(term.content()));
    let common = common.times(&content);
    let (a, b) = (first.over(&common), second.over(&common));
    let (a, b) = if b.coefficient().is_negative() { (a, b) } else { (b, a) };
    if let (Some(a), Some(b)) = (root(&a), root(&b.negated())) {
        found.push(common.times(&a.plus(&b)).times(&a.minus(&b)).into());
    }
}

/// (a + b)(a − b) → a² − b²
pub(super) fn join_squares(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Product(_, factors) = term.form() else { return };
    for (at, (first, e)) in factors.iter().enumerate() {
        for (second, f) in &factors[at + 1..] {
            let ([a, b], [c, d]) = (first.terms(), second.terms()) else { continue };
            if e != f || absolute(*e) != Rational::ONE {
                continue;
            }
            // The first coefficient of a factor is positive.
            if a == c && *b == d.negated() {
                let difference = a.squared().minus(&b.squared());
                let joined = first.times(second);
                found.push(term.times(&Term::product([(difference, *e), (joined, e.negated())])).into());
            }
        }
    }
}

/// e^a e^b → e^(a + b)
pub(super) fn join_exponentials(term: &Term, _: &Scene, found: &mut Found) {
    let mut exponent = Vec::new();
    let mut rest = Vec::new();
    let mut count = 0;
    let (c, factors) = term.factors();
    for (base, e) in factors {
        match base.form() {
            Form::Function(Function::Exp, of) if e.as_integer().is_some() => {
                count += if is_unit(e) { 1 } else { 2 };
                exponent.push(of.scaled(e));
            }
            _ => rest.push((base, e)),
        }
    }
    if count > 1 {
        let exponent = Term::sum(exponent);
        let all: Vec<&Term> = exponent.terms().iter().collect();
        let joined = Term::function(Function::Exp, take_out(&all, &positive(common_factor(&all))));
        found.push(
            Term::product(rest.into_iter().chain([(joined, Rational::ONE), (Term::number(c), Rational::ONE)])).into(),
        );
    }
}

/// e^(a + b) → e^a e^b, and e^(na) → (e^a)ⁿ
pub(super) fn split_exponential(term: &Term, scene: &Scene, found: &mut Found) {
    let Form::Function(Function::Exp, of) = term.form() else { return };
    let part = |part: &Term| {
        let times = part.coefficient().as_integer().filter(|n| n.abs() > 1 || *n == -1);
        let times = times.filter(|_| part.as_number().is_none()).map_or(Rational::ONE, Rational::integer);
        let inverse = Rational::new(times.denominator(), times.numerator())?;
        Some((Term::function(Function::Exp, part.scaled(inverse)), times))
    };
    let mut expanded = Found::new();
    expand(of, scene, &mut expanded);
    let of = expanded.first().map_or(of, |rewrite| &rewrite.to);
    let Some(parts) = of.terms().iter().map(part).collect::<Option<Vec<_>>>() else { return };
    let split = Term::product(parts);
    if split != *term {
        found.push(split.into());
    }
}

/// Two terms of a sum without what they have in common, and how to put another term in their place.
pub(super) struct Pair<'a> {
    pub a: Term,
    pub b: Term,
    common: Term,
    terms: &'a [Term],
    at: [usize; 2],
}

impl Pair<'_> {
    /// The sum with `joined` instead of the two.
    pub fn replace(&self, joined: &Term) -> Rewrite {
        let others = self.terms.iter().enumerate().filter(|(at, _)| !self.at.contains(at));
        let joined = self.common.times(joined);
        Term::sum(others.map(|(_, term)| term.clone()).chain([joined])).into()
    }
}

/// Every two terms of a sum, in both orders.
pub(super) fn pairs(term: &Term) -> Vec<Pair<'_>> {
    let Form::Sum(terms) = term.form() else { return vec![] };
    let mut found = Vec::new();
    if terms.len() > WIDEST {
        return found;
    }
    for (i, first) in terms.iter().enumerate() {
        for (j, second) in terms.iter().enumerate().skip(i + 1) {
            let common = Term::product(common_factor(&[first, second]));
            let (a, b) = (first.over(&common), second.over(&common));
            found.push(Pair { a: b.clone(), b: a.clone(), common: common.clone(), terms, at: [j, i] });
            found.push(Pair { a, b, common, terms, at: [i, j] });
        }
    }
    found
}

/// Whether two numbers are equal up to a sign.
pub(super) fn same_size(a: Rational, b: Rational) -> bool {
    absolute(a) == absolute(b)
}
