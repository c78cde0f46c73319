//! Terms written out for a reader, in an order that follows the line before.

use super::number::is_unit;
use super::scene::Scene;
use super::term::{Form, Power, Term};
use crate::expr::{Expr, Function, Node, i, pi, sqrt};
use crate::rational::Rational;
use std::cmp::Reverse;

/// Writes terms as expressions.
pub(super) struct Writer<'a> {
    scene: &'a Scene,
    /// The sums of other lines, in their order.
    sums: Vec<Vec<Term>>,
}

impl<'a> Writer<'a> {
    /// A writer that keeps the order of the first of `models` where it can, else that of a later one.
    pub fn after<'b>(scene: &'a Scene, models: impl IntoIterator<Item = &'b Expr>) -> Self {
        let mut writer = Self { scene, sums: Vec::new() };
        models.into_iter().for_each(|model| writer.collect_sums(model));
        writer
    }

    fn collect_sums(&mut self, expr: &Expr) {
        if let Node::Sum(terms) = expr.node() {
            self.sums.extend(terms.iter().map(|term| self.scene.term(term)).collect::<Result<Vec<_>, _>>());
        }
        for child in expr.children() {
            self.collect_sums(child);
        }
    }

    /// `term` as a factor, whatever its sign.
    pub fn factor(&self, term: &Term) -> Expr {
        match term.form() {
            Form::Sum(terms) => self.row(&self.oriented(terms).1),
            _ => self.expr(term),
        }
    }

    pub fn expr(&self, term: &Term) -> Expr {
        match term.form() {
            Form::Undefined => Expr::from(1) / 0,
            Form::Product(c, factors) => self.fraction(*c, factors),
            Form::Symbol(index) => self.scene.symbol(*index).into(),
            Form::Pi => pi(),
            Form::ImaginaryUnit => i(),
            Form::Apply(index, parts) => {
                self.scene.symbol(*index).at(parts.iter().map(|part| self.expr(part)).collect::<Vec<_>>())
            }
            Form::Function(function, of) => {
                let (is_negative, face) = self.function(*function, of);
                if is_negative { -face } else { face }
            }
            Form::Sum(terms) => self.sum(term, terms),
        }
    }

    /// A function, of an argument of the other sign where that reads better, and whether that changes its own.
    fn function(&self, function: Function, of: &Term) -> (bool, Expr) {
        let is_odd = matches!(function, Function::Sin | Function::Tan);
        match of.form() {
            Form::Sum(terms) if is_odd || function == Function::Cos => {
                let (flipped, _) = self.oriented(terms);
                let of = if flipped { of.negated() } else { of.clone() };
                (flipped && is_odd, function.of(self.expr(&of)))
            }
            _ => (false, function.of(self.expr(of))),
        }
    }

    /// A sum that stands alone: over the denominator that all its coefficients have.
    fn sum(&self, whole: &Term, terms: &[Term]) -> Expr {
        let below = whole.content().denominator();
        if terms.iter().filter(|term| term.coefficient().as_integer().is_none()).count() > 1 {
            let whole: Vec<Term> = terms.iter().map(|term| term.scaled(Rational::integer(below))).collect();
            return self.row(&self.ordered(&whole)) / number(below);
        }
        self.row(&self.ordered(terms))
    }

    /// Terms one after the other.
    fn row(&self, terms: &[Term]) -> Expr {
        let faces = terms.iter().map(|term| self.expr(term));
        let sum = faces.reduce(|sum, face| match face.node() {
            Node::Negate(of) => sum - of,
            _ => sum + face,
        });
        sum.unwrap_or_else(|| 0.into())
    }

    /// The product of factors, which may occur above and below the line at once.
    pub fn fraction(&self, coefficient: Rational, factors: &[Power]) -> Expr {
        let (numbers, factors): (Vec<Power>, Vec<Power>) =
            factors.iter().cloned().partition(|(base, e)| base.as_number().is_some() && e.as_integer().is_some());
        let coefficient = Term::product(numbers).scaled(coefficient).as_number().unwrap_or(coefficient);
        let mut is_negative = coefficient.is_negative();
        let mut sides: [Vec<(&Term, Expr)>; 2] = [vec![], vec![]];
        let mut flippable: Option<(usize, usize, Expr)> = None;
        for (base, e) in self.in_order(&factors) {
            let below = usize::from(e.is_negative());
            let e = if e.is_negative() { e.negated() } else { *e };
            let is_odd = e.as_integer().is_some_and(|n| n % 2 == 1);
            let (flipped, face) = match base.form() {
                Form::Function(function, of) if e.as_integer().is_some() => self.function(*function, of),
                Form::Sum(terms) if e.as_integer().is_some() => {
                    let (flipped, ordered) = self.oriented(terms);
                    let is_mixed = ordered.iter().any(|term| term.coefficient().is_negative());
                    if is_odd && is_mixed && flippable.as_ref().is_none_or(|(side, ..)| *side > below) {
                        let other: Vec<Term> = ordered.iter().map(Term::negated).collect();
                        flippable = Some((below, sides[below].len(), raised(self.row(&positive_first(other)), e)));
                    }
                    (flipped, self.row(&ordered))
                }
                _ => (false, self.expr(base)),
            };
            is_negative ^= flipped && is_odd;
            sides[below].push((base, raised(face, e)));
        }
        if is_negative && let Some((side, at, other)) = flippable {
            is_negative = false;
            sides[side][at].1 = other;
        }
        let [above, below] = sides;
        let whole = self.assemble(coefficient, &above, below);
        if is_negative { -whole } else { whole }
    }

    /// |c| above/below
    fn assemble(&self, c: Rational, above: &[(&Term, Expr)], below: Vec<(&Term, Expr)>) -> Expr {
        let (p, q) = (c.numerator().abs(), c.denominator());
        let product = |first: Option<Expr>, rest: &[(&Term, Expr)]| {
            first.into_iter().chain(rest.iter().map(|(_, face)| face.clone())).reduce(|a, b| a * b)
        };
        // ½ sin 2x, but x/2 and (a + b)/2.
        let in_front = above.iter().any(|(base, _)| matches!(base.form(), Form::Function(..) | Form::Apply(..)))
            && above.iter().all(|(base, _)| !matches!(base.form(), Form::Sum(_)));
        if below.is_empty() && (q == 1 || in_front || above.is_empty()) {
            let number = Rational::new(p, q).filter(|c| !is_unit(*c) || above.is_empty()).map(Expr::number);
            return product(number, above).unwrap_or_else(|| 1.into());
        }
        let above = product((p != 1).then(|| number(p)), above).unwrap_or_else(|| 1.into());
        above / product((q != 1).then(|| number(q)), &below).unwrap_or_else(|| 1.into())
    }

    /// Factors in the order of a textbook: symbols, roots, functions, sums.
    fn in_order<'b>(&self, factors: &'b [Power]) -> Vec<&'b Power> {
        let mut ordered: Vec<&Power> = factors.iter().collect();
        ordered.sort_by_key(|(base, e)| match base.form() {
            _ if e.as_integer().is_none() => 3,
            Form::ImaginaryUnit => 0,
            Form::Pi => 1,
            Form::Symbol(_) => 2,
            Form::Apply(..) => 4,
            Form::Function(Function::Exp, _) => 5,
            Form::Function(..) => 6,
            _ => 7,
        });
        ordered
    }

    /// A sum inside a product, and whether its sign was changed to write it so.
    fn oriented(&self, terms: &[Term]) -> (bool, Vec<Term>) {
        let ordered = self.ordered(terms);
        let negative = terms.iter().filter(|term| term.coefficient().is_negative()).count();
        let first = self.arranged(terms)[0].coefficient().is_negative();
        if 2 * negative > terms.len() || (2 * negative == terms.len() && first) {
            let other: Vec<Term> = terms.iter().map(Term::negated).collect();
            return (true, self.ordered(&other));
        }
        (false, ordered)
    }

    fn ordered(&self, terms: &[Term]) -> Vec<Term> {
        positive_first(self.arranged(terms))
    }

    /// In the order of the most similar sum of another line, else by degree: rising where there are functions.
    fn arranged(&self, terms: &[Term]) -> Vec<Term> {
        let place = |term: &Term, model: &[Term]| {
            let alike = model.iter().enumerate().map(|(at, other)| (similarity(term, other), Reverse(at)));
            alike.max().map_or((0, 0), |(likeness, Reverse(at))| (likeness, at))
        };
        let total = |model: &&Vec<Term>| terms.iter().map(|term| place(term, model).0).sum::<usize>();
        let model = self.sums.iter().rev().max_by_key(total).filter(|model| total(model) > 0);
        let is_function = |(base, _): &Power| matches!(base.form(), Form::Function(..));
        // 1 − 2 cos x + cos² x, but x² − 2x + 1.
        let rises = terms.iter().any(|term| term.factors().1.iter().any(is_function));
        let mut ordered = terms.to_vec();
        ordered.sort_by_key(|term| {
            let at = model.map_or((0, 0), |model| place(term, model));
            let at = if at.0 == 0 { usize::MAX } else { at.1 };
            let degree = if rises { degree(term) } else { 0 };
            (model.is_some().then_some(at), degree)
        });
        ordered
    }
}

/// The sum of the whole exponents above the line.
fn degree(term: &Term) -> i64 {
    term.factors().1.iter().filter_map(|(_, e)| e.as_integer()).fold(0, |sum, n| sum.saturating_add(n.max(0)))
}

/// With the first term that is not subtracted in front.
fn positive_first(mut terms: Vec<Term>) -> Vec<Term> {
    if let Some(at) = terms.iter().position(|term| !term.coefficient().is_negative()) {
        terms[..=at].rotate_right(1);
    }
    terms
}

fn number(value: i64) -> Expr {
    Expr::number(Rational::integer(value))
}

fn raised(base: Expr, exponent: Rational) -> Expr {
    match (exponent.numerator(), exponent.denominator()) {
        (1, 1) => base,
        (1, 2) => sqrt(base),
        _ => base.pow(exponent),
    }
}

/// How much two terms have in common: factors, and symbols anywhere.
fn similarity(a: &Term, b: &Term) -> usize {
    if a.as_number().is_some() && b.as_number().is_some() {
        return 8;
    }
    let (factors, others) = (a.factors().1, b.factors().1);
    let shared = factors.iter().filter(|(base, _)| others.iter().any(|(other, _)| base == other)).count();
    let (mut mine, mut theirs) = (Vec::new(), Vec::new());
    collect_symbols(a, &mut mine);
    collect_symbols(b, &mut theirs);
    4 * shared + mine.iter().filter(|symbol| theirs.contains(symbol)).count()
}

fn collect_symbols(term: &Term, found: &mut Vec<usize>) {
    match term.form() {
        Form::Symbol(index) if !found.contains(index) => found.push(*index),
        Form::Sum(parts) | Form::Apply(_, parts) => parts.iter().for_each(|part| collect_symbols(part, found)),
        Form::Product(_, factors) => factors.iter().for_each(|(base, _)| collect_symbols(base, found)),
        Form::Function(_, of) => collect_symbols(of, found),
        _ => {}
    }
}
