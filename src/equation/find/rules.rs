//! The rules that a line may follow by, and everything that they make of a term.

use super::algebra::{self as field, Found};
use super::scene::{Scene, map};
use super::term::{Form, Power, Term};
use super::trigonometry as waves;
use crate::equation::dimension::Dimension;
use crate::equation::expr::{Expr, cos, exp, i, pi, ratio, sin, tan};
use crate::equation::rational::Rational;
use crate::equation::symbol::Symbol;
use std::borrow::Cow;
use std::collections::HashMap;
use std::rc::Rc;

/// A rule as it is displayed. It is read from left to right or from right to left.
pub struct Rule {
    /// The name by which a line follows from the left side of the example to its right side.
    pub name: &'static str,
    /// The name by which it follows the other way.
    pub reverse: &'static str,
    /// Two sides of one application, in generic symbols.
    pub example: fn() -> (Expr, Expr),
    /// Whether it is a move of any field, of which several in a row are one line of algebra.
    pub(super) is_algebra: bool,
    /// How much a line of it costs a reader; 10 for the plainest.
    pub(super) cost: u32,
    /// How many forms of the result are put in at all places at once.
    everywhere: usize,
    apply: fn(&Term, &Scene, &mut Found),
}

impl std::fmt::Debug for Rule {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

const A: Symbol = Symbol::scalar("a", Dimension::ONE);
const B: Symbol = Symbol::scalar("b", Dimension::ONE);
const C: Symbol = Symbol::scalar("c", Dimension::ONE);
const D: Symbol = Symbol::scalar("d", Dimension::ONE);
const X: Symbol = Symbol::scalar("x", Dimension::ONE);

const fn algebra(
    names: [&'static str; 2],
    cost: u32,
    apply: fn(&Term, &Scene, &mut Found),
    example: fn() -> (Expr, Expr),
) -> Rule {
    Rule { name: names[0], reverse: names[1], example, is_algebra: true, cost, everywhere: 0, apply }
}

const fn identity(
    name: &'static str,
    cost: u32,
    everywhere: usize,
    apply: fn(&Term, &Scene, &mut Found),
    example: fn() -> (Expr, Expr),
) -> Rule {
    Rule { name, reverse: name, example, is_algebra: false, cost, everywhere, apply }
}

/// Every rule but the hypotheses. An identity that is used in both directions stands here once for each.
pub static RULES: &[Rule] = &[
    algebra(["cancel", "extend"], 8, field::cancel, || ((A * B + A * C) / (A * D + A * X), (B + C) / (D + X))),
    algebra(["cancel", "extend"], 10, field::divide, || ((A.pow(2) - 3 * A + 2) / (A - 1), A - 2)),
    algebra(["factor", "expand"], 10, field::factor, || (A * B + A * C, A * (B + C))),
    algebra(["common denominator", "split the fraction"], 10, field::common_denominator, || {
        (A / B + C / D, (A * D + C * B) / (B * D))
    }),
    algebra(["split the fraction", "common denominator"], 12, field::split, || ((A + B) / C, A / C + B / C)),
    algebra(["expand", "factor"], 11, field::expand, || ((A + B) * (C + D), A * C + A * D + B * C + B * D)),
    algebra(["square of a sum"; 2], 10, field::expand_square, || ((A + B).pow(2), A.pow(2) + 2 * A * B + B.pow(2))),
    algebra(["square of a sum"; 2], 9, field::complete_square, || (A.pow(2) - 2 * A * B + B.pow(2), (A - B).pow(2))),
    algebra(["difference of squares"; 2], 10, field::split_squares, || (A.pow(2) - B.pow(2), (A + B) * (A - B))),
    algebra(["difference of squares"; 2], 9, field::join_squares, || ((A + B) * (A - B), A.pow(2) - B.pow(2))),
    identity("product of exponentials", 9, 1, field::join_exponentials, || (exp(A) * exp(B), exp(A + B))),
    identity("product of exponentials", 10, 1, field::split_exponential, || (exp(A + 2 * B), exp(A) * exp(B).pow(2))),
    identity("tangent", 9, 1, waves::tangent, || (tan(X), sin(X) / cos(X))),
    identity("tangent", 8, 1, waves::ratio_to_tangent, || (sin(X) / cos(X), tan(X))),
    identity("sine of a sum", 10, 1, waves::sine_of_sum, || (sin(A + B), sin(A) * cos(B) + cos(A) * sin(B))),
    identity("sine of a sum", 8, 1, waves::to_sine_of_sum, || (sin(A) * cos(B) - cos(A) * sin(B), sin(A - B))),
    identity("cosine of a sum", 10, 1, waves::cosine_of_sum, || (cos(A + B), cos(A) * cos(B) - sin(A) * sin(B))),
    identity("cosine of a sum", 8, 1, waves::to_cosine_of_sum, || (cos(A) * cos(B) + sin(A) * sin(B), cos(A - B))),
    identity("double angle", 10, 3, waves::double_angle, || (cos(2 * X), cos(X).pow(2) - sin(X).pow(2))),
    identity("double angle", 9, 1, waves::to_sine_of_double, || (sin(X) * cos(X), sin(2 * X) / 2)),
    identity("double angle", 9, 1, waves::to_cosine_of_double, || (1 - 2 * sin(X).pow(2), cos(2 * X))),
    identity("Pythagoras", 10, 1, waves::pythagoras, || (sin(X).pow(2), 1 - cos(X).pow(2))),
    identity("Pythagoras", 8, 1, waves::to_pythagoras, || (sin(X).pow(2) + cos(X).pow(2), 1.into())),
    identity("half angle", 11, 1, waves::half_angle, || (sin(X).pow(2), (1 - cos(2 * X)) / 2)),
    identity("product to sum", 12, 1, waves::product_to_sum, || (sin(A) * cos(B), (sin(A + B) + sin(A - B)) / 2)),
    identity("sum to product", 10, 1, waves::sum_to_product, || (sin(2 * A) - sin(2 * B), 2 * cos(A + B) * sin(A - B))),
    identity("special value", 8, 1, waves::special_value, || (sin(pi() / 6), ratio(1, 2))),
    identity("quarter turn", 9, 1, waves::quarter_turns, || (sin(pi() / 2 - X), cos(X))),
    identity("Euler", 12, 1, waves::euler, || (exp(i() * X), cos(X) + i() * sin(X))),
    identity("Euler", 10, 1, waves::to_euler, || (cos(X) - i() * sin(X), exp(-(i() * X)))),
    identity("Euler", 16, 1, waves::wave_to_exponentials, || (cos(X), (exp(i() * X) + exp(-(i() * X))) / 2)),
];

/// What leads from one state to the next.
#[derive(Clone, Debug)]
pub(super) struct Move {
    pub to: Term,
    pub reason: Reason,
    /// The factor that it is about.
    pub about: Option<Term>,
    /// At how many places at once.
    pub places: usize,
    /// The factors on the way, not yet cancelled; may be empty.
    pub via: Vec<Power>,
}

/// A rule, by its place in [`RULES`], or a hypothesis by its name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Reason {
    Rule(usize),
    Given(&'static str),
}

impl Reason {
    pub fn cost(self) -> u32 {
        match self {
            Self::Rule(rule) => RULES[rule].cost,
            Self::Given(_) => 8,
        }
    }

    pub fn is_algebra(self) -> bool {
        matches!(self, Self::Rule(rule) if RULES[rule].is_algebra)
    }

    /// Its name from where it was applied to what came out, or back.
    pub fn name(self, reversed: bool) -> Cow<'static, str> {
        match self {
            Self::Rule(rule) if reversed => RULES[rule].reverse,
            Self::Rule(rule) => RULES[rule].name,
            Self::Given(by) => by,
        }
        .into()
    }
}

/// Applies rules, and remembers what they made of every part of a term.
pub(super) struct Moves<'a> {
    pub scene: &'a Scene,
    at_one: HashMap<Term, Rc<Vec<Move>>>,
    at_all: HashMap<(Term, usize, usize), (Term, usize)>,
}

impl<'a> Moves<'a> {
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene, at_one: HashMap::new(), at_all: HashMap::new() }
    }

    /// Every term that one displayed line leads to.
    pub fn of(&mut self, term: &Term) -> Vec<Move> {
        let mut moves = self.hypotheses(term);
        for (rule, variant) in
            RULES.iter().enumerate().flat_map(|(at, rule)| (0..rule.everywhere).map(move |v| (at, v)))
        {
            let (to, places) = self.everywhere(term, rule, variant);
            if places > 1 {
                moves.push(Move { to, reason: Reason::Rule(rule), about: None, places, via: vec![] });
            }
        }
        moves.extend(self.once(term).iter().cloned());
        moves
    }

    /// The hypotheses of one name together, and each alone.
    fn hypotheses(&self, term: &Term) -> Vec<Move> {
        let givens = &self.scene.givens;
        let mut moves = Vec::new();
        for (at, given) in givens.iter().enumerate() {
            let (to, places) = given.apply(term);
            if places > 0 {
                moves.push(Move { to, reason: Reason::Given(given.by), about: None, places, via: vec![] });
            }
            if givens[..at].iter().any(|earlier| earlier.by == given.by) {
                continue;
            }
            let all = givens.iter().filter(|other| other.by == given.by);
            let (to, places) = all.fold((term.clone(), 0), |(term, places), given| {
                let (next, more) = given.apply(&term);
                (next, places + more)
            });
            if places > 0 {
                moves.insert(0, Move { to, reason: Reason::Given(given.by), about: None, places, via: vec![] });
            }
        }
        moves
    }

    /// Every rule at every single place.
    fn once(&mut self, term: &Term) -> Rc<Vec<Move>> {
        if let Some(known) = self.at_one.get(term) {
            return known.clone();
        }
        let mut moves = Vec::new();
        for (rule, Rule { apply, .. }) in RULES.iter().enumerate() {
            let mut found = Found::new();
            apply(term, self.scene, &mut found);
            let moved = found.into_iter().map(|rewrite| Move {
                to: rewrite.to,
                reason: Reason::Rule(rule),
                about: rewrite.about,
                places: 1,
                via: rewrite.via,
            });
            moves.extend(moved);
        }
        for (at, child) in children(term).into_iter().enumerate() {
            let inner = self.once(&child);
            moves.extend(inner.iter().map(|step| Move {
                to: with_child(term, at, &step.to),
                via: vec![],
                ..step.clone()
            }));
        }
        moves.retain(|step| !step.to.is_undefined() && step.to != *term);
        let moves = Rc::new(moves);
        self.at_one.insert(term.clone(), moves.clone());
        moves
    }

    /// One rule at every place, from the outside inwards, and at how many.
    fn everywhere(&mut self, term: &Term, rule: usize, variant: usize) -> (Term, usize) {
        if let Some(known) = self.at_all.get(&(term.clone(), rule, variant)) {
            return known.clone();
        }
        let mut found = Found::new();
        (RULES[rule].apply)(term, self.scene, &mut found);
        let last = found.len().saturating_sub(1);
        let result = match found.get(variant.min(last)) {
            Some(rewrite) => (rewrite.to.clone(), 1),
            None => {
                let mut places = 0;
                let image = map(term, &mut |child| {
                    let (image, count) = self.everywhere(child, rule, variant);
                    places += count;
                    image
                });
                (image, places)
            }
        };
        self.at_all.insert((term.clone(), rule, variant), result.clone());
        result
    }
}

fn children(term: &Term) -> Vec<Term> {
    match term.form() {
        Form::Sum(parts) => parts.clone(),
        Form::Product(_, factors) => factors.iter().map(|(base, _)| base.clone()).collect(),
        Form::Function(_, of) => vec![of.clone()],
        _ => vec![],
    }
}

fn with_child(term: &Term, at: usize, child: &Term) -> Term {
    let place = |i: usize, known: &Term| if i == at { child.clone() } else { known.clone() };
    match term.form() {
        Form::Sum(parts) => Term::sum(parts.iter().enumerate().map(|(i, part)| place(i, part))),
        Form::Product(c, factors) => {
            let powers = factors.iter().enumerate().map(|(i, (base, e))| (place(i, base), *e));
            Term::product(powers.chain::<[Power; 1]>([(Term::number(*c), Rational::ONE)]))
        }
        Form::Function(function, _) => Term::function(*function, child.clone()),
        _ => term.clone(),
    }
}
