//! What a search knows from the outset: symbols with their values at two points, hypotheses, and the angles in sight.

use super::term::{Fold, Form, Power, Term, Values};
use super::way::NotFound;
use crate::expr::{Expr, Function, Node};
use crate::hypothesis::Given;
use crate::rational::Rational;
use crate::symbol::{Rank, Symbol};
use crate::value::{Bindings, Evaluation, Unevaluable};
use num_complex::Complex64;
use std::collections::HashSet;
use std::hash::Hasher;

/// Symbols in the order of reading, what they are worth, and what is given about them.
pub(super) struct Scene {
    symbols: Vec<Symbol>,
    values: Vec<Values>,
    /// Hypotheses in canonical form.
    pub givens: Vec<Substitution>,
    /// What the start, the goal and the hypotheses take sines, cosines and tangents of.
    angles: HashSet<Term>,
    /// Whether there is an exponential in sight.
    pub is_exponential: bool,
}

/// A hypothesis in canonical form.
pub(super) struct Substitution {
    pub what: Term,
    pub value: Term,
    pub by: &'static str,
}

impl Scene {
    /// The symbols of `exprs` and `given`, at points where all `exprs` have a value.
    pub fn new(exprs: [&Expr; 2], given: &[Given]) -> Result<Self, NotFound> {
        let mut symbols: Vec<Symbol> = Vec::new();
        let parts = given.iter().flat_map(|given| [&given.what, &given.value]);
        for symbol in exprs.into_iter().chain(parts).flat_map(|expr| expr.symbols()) {
            if symbols.iter().all(|known| known.name() != symbol.name()) {
                symbols.push(symbol.clone());
            }
        }
        let mut scene = Self { values: vec![], symbols, givens: vec![], angles: HashSet::new(), is_exponential: false };
        for attempt in 0..ATTEMPTS {
            scene.values = scene.draw(attempt, given)?;
            let terms = [scene.term(exprs[0])?, scene.term(exprs[1])?];
            if terms.iter().flat_map(Term::values).all(Complex64::is_finite) {
                scene.take_in(&terms, given)?;
                return Ok(scene);
            }
        }
        Err(NotFound::NotAlgebraic("a division by zero, or numbers out of range".to_owned()))
    }

    fn take_in(&mut self, terms: &[Term], given: &[Given]) -> Result<(), NotFound> {
        for given in given {
            let (what, value) = (self.term(&given.what)?, self.term(&given.value)?);
            self.givens.push(Substitution { what, value, by: given.by });
        }
        let mut angles = HashSet::new();
        for term in terms.iter().chain(self.givens.iter().map(|given| &given.value)) {
            collect_angles(term, &mut angles);
        }
        self.angles = angles;
        self.is_exponential = terms.iter().any(has_exponential);
        Ok(())
    }

    pub fn symbol(&self, index: usize) -> &Symbol {
        &self.symbols[index]
    }

    /// Whether a rule may bring in `angle`: whole multiples only, unless it is in sight already.
    pub fn welcomes(&self, angle: &Term) -> bool {
        let is_whole = |term: &Term| term.coefficient().as_integer().is_some();
        angle.terms().iter().all(is_whole) || self.angles.contains(angle) || self.angles.contains(&angle.negated())
    }

    /// The canonical form of `expr`, which is small enough to walk.
    pub fn term(&self, expr: &Expr) -> Result<Term, NotFound> {
        let all = |parts: &[Expr]| parts.iter().map(|part| self.term(part)).collect::<Result<Vec<_>, _>>();
        Ok(match expr.node() {
            Node::Number(value) => Term::number(*value),
            Node::Pi => Term::pi(),
            Node::ImaginaryUnit => Term::imaginary_unit(),
            Node::Symbol(symbol) if symbol.rank() == Rank::Scalar => {
                let index = self.index(symbol);
                Term::symbol(index, self.values[index])
            }
            Node::Apply(symbol, arguments) if symbol.rank() == Rank::Scalar => {
                let index = self.index(symbol);
                Term::apply(index, self.values[index], all(arguments)?)
            }
            Node::Sum(terms) => Term::sum(all(terms)?),
            Node::Product(factors) => Term::product(all(factors)?.into_iter().map(|factor| (factor, Rational::ONE))),
            Node::Quotient(above, below) => self.term(above)?.over(&self.term(below)?),
            Node::Power(base, exponent) => self.term(base)?.power(*exponent),
            Node::Negate(of) => self.term(of)?.negated(),
            Node::Function(function, of) => Term::function(*function, self.term(of)?),
            _ => return Err(NotFound::NotAlgebraic(expr.to_string())),
        })
    }

    fn index(&self, symbol: &Symbol) -> usize {
        self.symbols.iter().position(|known| known.name() == symbol.name()).expect("every symbol was collected")
    }

    /// Values for every symbol, those of the hypotheses computed from the others.
    fn draw(&self, attempt: u64, given: &[Given]) -> Result<Vec<Values>, NotFound> {
        let mut values = vec![[Complex64::ZERO; 2]; self.symbols.len()];
        for at in 0..2 {
            let mut bindings = Bindings::new();
            for symbol in &self.symbols {
                bindings.bind(symbol.name(), point(symbol, 2 * attempt + at as u64));
            }
            for given in given {
                if let Node::Symbol(symbol) = given.what.node() {
                    bindings.define(symbol, given.value.clone());
                }
            }
            let mut solved: Vec<&Symbol> = Vec::new();
            for given in given.iter().filter(|given| !matches!(given.what.node(), Node::Symbol(_))) {
                solved.push(self.solve(given, &mut bindings, &solved)?);
            }
            let mut evaluation = Evaluation::new(&bindings);
            for (value, symbol) in values.iter_mut().zip(&self.symbols) {
                value[at] = evaluation.value(&symbol.into()).map_err(not_algebraic)?;
            }
        }
        Ok(values)
    }

    /// Moves one symbol of a hypothesis about a compound form, such as t₁t₁′ := 1 − r₁², by the secant method to where
    /// the hypothesis holds.
    fn solve<'a>(
        &self,
        given: &'a Given,
        bindings: &mut Bindings<Complex64>,
        solved: &[&Symbol],
    ) -> Result<&'a Symbol, NotFound> {
        let gap =
            |bindings: &Bindings<Complex64>| (&given.what - &given.value).evaluate(bindings).map_err(not_algebraic);
        let unsolvable = || NotFound::NotAlgebraic(format!("{} := {}", given.what, given.value));
        let start = gap(bindings)?;
        let free =
            given.what.symbols().into_iter().rev().filter(|symbol| solved.iter().all(|s| s.name() != symbol.name()));
        for symbol in free {
            let mut last = (point(symbol, 0) + 0.125, Complex64::ZERO);
            bindings.bind(symbol.name(), last.0);
            last.1 = gap(bindings)?;
            if last.1 == start {
                continue;
            }
            let mut next = point(symbol, 0);
            for _ in 0..SECANT_STEPS {
                bindings.bind(symbol.name(), next);
                let here = gap(bindings)?;
                if here.norm() < 1e-14 || here == last.1 {
                    break;
                }
                let step = here * (next - last.0) / (here - last.1);
                last = (next, here);
                next -= step;
            }
            return if gap(bindings)?.norm() < 1e-9 { Ok(symbol) } else { Err(unsolvable()) };
        }
        Err(unsolvable())
    }
}

/// Whether an expression, small enough to walk, is a number by itself, without derivatives and the like.
pub(super) fn is_scalar(expr: &Expr) -> bool {
    let itself = match expr.node() {
        Node::Symbol(symbol) | Node::Apply(symbol, _) => symbol.rank() == Rank::Scalar,
        Node::Number(_) | Node::Pi | Node::ImaginaryUnit | Node::Sum(_) | Node::Product(_) => true,
        Node::Quotient(..) | Node::Power(..) | Node::Negate(_) | Node::Function(..) => true,
        _ => false,
    };
    itself && expr.children().into_iter().all(is_scalar)
}

/// How many pairs of points are tried for one where everything is finite.
const ATTEMPTS: u64 = 4;
const SECANT_STEPS: usize = 40;

fn not_algebraic(why: Unevaluable) -> NotFound {
    NotFound::NotAlgebraic(why.to_string())
}

/// A fixed point of the symbol's domain, off the real axis wherever it may be.
fn point(symbol: &Symbol, number: u64) -> Complex64 {
    let mut hasher = Fold(number);
    hasher.write(symbol.name().as_bytes());
    let mut within = |(min, max): (f64, f64)| {
        hasher.write_u64(1);
        min + (max - min) * (0.1 + 0.8 * (hasher.finish() >> 11) as f64 / (1_u64 << 53) as f64)
    };
    let domain = symbol.domain();
    Complex64::new(within(domain.re), within(domain.im))
}

fn collect_angles(term: &Term, found: &mut HashSet<Term>) {
    match term.form() {
        Form::Function(Function::Sin | Function::Cos | Function::Tan, of) => {
            found.insert(of.clone());
            collect_angles(of, found);
        }
        Form::Function(_, of) => collect_angles(of, found),
        Form::Sum(parts) | Form::Apply(_, parts) => parts.iter().for_each(|part| collect_angles(part, found)),
        Form::Product(_, factors) => factors.iter().for_each(|(base, _)| collect_angles(base, found)),
        _ => {}
    }
}

/// What replacing parts of a term makes of it.
#[derive(Clone, Debug)]
pub(super) struct Image {
    pub to: Term,
    /// At how many places something was replaced.
    pub places: usize,
    /// Factors above and below the line that met in consequence, and are gone.
    pub cancelled: Vec<Term>,
}

impl Image {
    pub fn new(to: Term, places: usize) -> Self {
        Self { to, places, cancelled: vec![] }
    }
}

fn has_exponential(term: &Term) -> bool {
    match term.form() {
        Form::Function(function, of) => *function == Function::Exp || has_exponential(of),
        Form::Sum(parts) => parts.iter().any(has_exponential),
        Form::Product(_, factors) => factors.iter().any(|(base, _)| has_exponential(base)),
        _ => false,
    }
}

impl Substitution {
    /// `term` with this hypothesis put in wherever it applies.
    pub fn apply(&self, term: &Term) -> Image {
        if *term == self.what {
            return Image::new(self.value.clone(), 1);
        }
        let mut image = map(term, &mut |child| self.apply(child));
        if let Some(times) = self.times_in(&image.to) {
            image.to = image.to.times(&Term::over(&self.value, &self.what).power(times));
            image.places += 1;
        }
        image
    }

    /// How many times a product of several powers is contained in `term`.
    fn times_in(&self, term: &Term) -> Option<Rational> {
        let Form::Product(_, wanted) = self.what.form() else { return None };
        let Form::Product(_, factors) = term.form() else { return None };
        let times = wanted.iter().map(|(base, e)| {
            let (_, has) = factors.iter().find(|(known, _)| known == base)?;
            let times = has.as_integer()?.checked_div(e.as_integer()?)?;
            (times != 0).then_some(times)
        });
        let times = times.collect::<Option<Vec<_>>>()?;
        let same_sign = times.iter().all(|n| n.signum() == times[0].signum());
        same_sign.then(|| Rational::integer(times.into_iter().min_by_key(|n| n.abs()).unwrap_or(1)))
    }
}

/// The same outermost part over other terms.
pub(super) fn map(term: &Term, image: &mut impl FnMut(&Term) -> Image) -> Image {
    let mut whole = Image::new(term.clone(), 0);
    let mut part = |child: &Term| {
        let image = image(child);
        whole.places += image.places;
        whole.cancelled.extend(image.cancelled);
        image.to
    };
    let to = match term.form() {
        Form::Sum(parts) => {
            let images: Vec<Term> = parts.iter().map(part).collect();
            (images != *parts).then(|| Term::sum(images))
        }
        Form::Product(c, factors) => {
            let images: Vec<Power> = factors.iter().map(|(base, e)| (part(base), *e)).collect();
            (images != *factors).then(|| {
                whole.cancelled.extend(opposed(&images));
                Term::product(images.into_iter().chain([(Term::number(*c), Rational::ONE)]))
            })
        }
        Form::Function(function, of) => {
            let inner = part(of);
            (inner != *of).then(|| Term::function(*function, inner))
        }
        _ => None,
    };
    whole.to = to.unwrap_or(whole.to);
    whole
}

/// The bases that occur both above and below the line in a product of products.
fn opposed(images: &[Power]) -> Vec<Term> {
    let inner = images.iter().flat_map(|(image, e)| {
        image.factors().1.into_iter().map(|(base, f)| (base, f.is_negative() != e.is_negative()))
    });
    let all: Vec<(Term, bool)> = inner.collect();
    let is_met = |(base, below): &&(Term, bool)| !below && all.contains(&(base.clone(), true));
    let mut met: Vec<Term> = all.iter().filter(is_met).map(|(base, _)| base.clone()).collect();
    met.dedup();
    met
}
