//! The rules that a line may follow by, and everything that they make of a term.

use super::algebra::{self as field, Found, Rewrite};
use super::scene::{Image, Scene, map};
use super::term::{Form, Power, Term};
use super::trigonometry as waves;
use crate::dimension::Dimension;
use crate::expr::{Expr, cos, exp, i, pi, ratio, sin, sqrt, tan};
use crate::symbol::Symbol;
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

/// A rule as it is displayed. It is read from left to right or from right to left.
pub struct Rule {
    /// The name by which the right side of an example follows from the left.
    pub name: &'static str,
    /// The name by which it follows the other way.
    pub reverse: &'static str,
    /// The two sides of each form it has, in generic symbols.
    pub examples: fn() -> Vec<(Expr, Expr)>,
    /// Whether it is a move of any field, of which several in a row are one line of algebra.
    pub(super) is_algebra: bool,
    /// How much a line of it costs a reader, read either way; about 10.
    pub(super) costs: [u32; 2],
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

type Apply = fn(&Term, &Scene, &mut Found);
type Examples = fn() -> Vec<(Expr, Expr)>;

const fn algebra(
    names: [&'static str; 2],
    costs: [u32; 2],
    everywhere: usize,
    apply: Apply,
    examples: Examples,
) -> Rule {
    Rule { name: names[0], reverse: names[1], examples, is_algebra: true, costs, everywhere, apply }
}

const fn identity(name: &'static str, costs: [u32; 2], everywhere: usize, apply: Apply, examples: Examples) -> Rule {
    Rule { name, reverse: name, examples, is_algebra: false, costs, everywhere, apply }
}

/// Every rule but the hypotheses. An identity that is used in both directions stands here once for each.
pub static RULES: &[Rule] = &[
    algebra(["cancel", "extend by"], [8, 14], 0, field::cancel, || {
        vec![((A * B + A * C) / (A * D + A * X), (B + C) / (D + X))]
    }),
    algebra(["cancel", "extend by"], [20, 24], 0, field::divide, || vec![((A.pow(2) - 3 * A + 2) / (A - 1), A - 2)]),
    algebra(["extend by", "cancel"], [14, 10], 0, field::conjugate, || {
        vec![(C / (A + B), C * (A - B) / (A.pow(2) - B.pow(2)))]
    }),
    algebra(["factor", "expand"], [10, 10], 0, field::factor, || {
        vec![(A * B + A * C, A * (B + C)), (A * B + A * C + D, A * (B + C) + D)]
    }),
    algebra(["common denominator", "split the fraction"], [10, 12], 1, field::common_denominator, || {
        vec![(A / B + C / D, (A * D + C * B) / (B * D))]
    }),
    algebra(["split the fraction", "common denominator"], [12, 12], 1, field::split, || {
        vec![((A + B) / C, A / C + B / C)]
    }),
    algebra(["expand", "factor"], [11, 11], 1, field::expand, || {
        vec![
            ((A + B) * (C + D), A * C + A * D + B * C + B * D),
            (1 / (A * (B + C)), 1 / (A * B + A * C)),
            ((A + B).pow(3), A.pow(3) + 3 * A.pow(2) * B + 3 * A * B.pow(2) + B.pow(3)),
        ]
    }),
    algebra(["square of a sum"; 2], [10, 10], 1, field::expand_square, || {
        vec![((A + B).pow(2), A.pow(2) + 2 * A * B + B.pow(2))]
    }),
    algebra(["square of a sum"; 2], [9, 9], 0, field::complete_square, || {
        vec![(A.pow(2) - 2 * A * B + B.pow(2), (A - B).pow(2))]
    }),
    algebra(["difference of squares"; 2], [10, 10], 0, field::split_squares, || {
        vec![(A.pow(2) - B.pow(2), (A + B) * (A - B))]
    }),
    algebra(["difference of squares"; 2], [9, 9], 0, field::join_squares, || {
        vec![((A + B) * (A - B), A.pow(2) - B.pow(2))]
    }),
    identity("product of exponentials", [9, 10], 1, field::join_exponentials, || {
        vec![(exp(i() * A) * exp(i() * B), exp(i() * (A + B)))]
    }),
    identity("product of exponentials", [10, 9], 1, field::split_exponential, || {
        vec![(exp(A + 2 * B), exp(A) * exp(B).pow(2))]
    }),
    identity("tangent", [9, 8], 1, waves::tangent, || vec![(tan(X), sin(X) / cos(X))]),
    identity("tangent", [8, 9], 1, waves::to_tangent, || {
        vec![(sin(X) / cos(X), tan(X)), (cos(X) / sin(X), 1 / tan(X))]
    }),
    identity("angle sum", [10, 9], 1, waves::angle_sum, || {
        vec![
            (sin(A + B), sin(A) * cos(B) + cos(A) * sin(B)),
            (cos(A + B), cos(A) * cos(B) - sin(A) * sin(B)),
            (sin(3 * A), sin(2 * A) * cos(A) + cos(2 * A) * sin(A)),
        ]
    }),
    identity("angle sum", [8, 10], 1, waves::to_angle_sum, || {
        vec![(sin(A) * cos(B) - cos(A) * sin(B), sin(A - B)), (cos(A) * cos(B) + sin(A) * sin(B), cos(A - B))]
    }),
    identity("double angle", [10, 10], 3, waves::double_angle, || {
        vec![
            (sin(2 * X), 2 * sin(X) * cos(X)),
            (cos(2 * X), cos(X).pow(2) - sin(X).pow(2)),
            (cos(2 * X), 1 - 2 * sin(X).pow(2)),
            (cos(2 * X), 2 * cos(X).pow(2) - 1),
        ]
    }),
    identity("double angle", [9, 11], 1, waves::to_sine_of_double, || vec![(sin(X) * cos(X), sin(2 * X) / 2)]),
    identity("double angle", [9, 11], 1, waves::to_cosine_of_double, || {
        vec![
            (cos(X).pow(2) - sin(X).pow(2), cos(2 * X)),
            (1 - 2 * sin(X).pow(2), cos(2 * X)),
            (2 * cos(X).pow(2) - 1, cos(2 * X)),
        ]
    }),
    identity("half angle", [9, 13], 1, waves::from_half_angle, || {
        vec![(1 - cos(2 * X), 2 * sin(X).pow(2)), (1 + cos(2 * X), 2 * cos(X).pow(2))]
    }),
    identity("half angle", [13, 11], 1, waves::half_angle, || {
        vec![(sin(X).pow(2), (1 - cos(2 * X)) / 2), (cos(X).pow(2), (1 + cos(2 * X)) / 2)]
    }),
    identity("Pythagoras", [10, 9], 1, waves::pythagoras, || {
        vec![(sin(X).pow(2), 1 - cos(X).pow(2)), (cos(X).pow(2), 1 - sin(X).pow(2))]
    }),
    identity("Pythagoras", [8, 14], 1, waves::to_pythagoras, || {
        vec![
            (sin(X).pow(2) + cos(X).pow(2), 1.into()),
            (1 - sin(X).pow(2), cos(X).pow(2)),
            (1 - cos(X).pow(2), sin(X).pow(2)),
        ]
    }),
    identity("product to sum", [12, 30], 1, waves::product_to_sum, || {
        vec![
            (sin(A) * cos(B), (sin(A + B) + sin(A - B)) / 2),
            (cos(A) * cos(B), (cos(A - B) + cos(A + B)) / 2),
            (sin(A) * sin(B), (cos(A - B) - cos(A + B)) / 2),
        ]
    }),
    identity("sum to product", [10, 14], 1, waves::sum_to_product, || {
        vec![
            (sin(2 * A) + sin(2 * B), 2 * sin(A + B) * cos(A - B)),
            (sin(2 * A) - sin(2 * B), 2 * cos(A + B) * sin(A - B)),
            (cos(2 * A) + cos(2 * B), 2 * cos(A + B) * cos(A - B)),
            (cos(2 * A) - cos(2 * B), -(2 * sin(A + B) * sin(A - B))),
        ]
    }),
    identity("special value", [8, 10], 1, waves::special_value, || {
        vec![(sin(pi() / 6), ratio(1, 2)), (cos(3 * pi() / 4), -sqrt(2) / 2), (sin(4 * pi() / 3), -sqrt(3) / 2)]
    }),
    identity("quarter turn", [9, 11], 1, waves::quarter_turns, || {
        vec![(sin(pi() / 2 - X), cos(X)), (cos(X + pi()), -cos(X)), (sin(X - pi() / 2), -cos(X))]
    }),
    identity("Euler", [12, 12], 1, waves::euler, || vec![(exp(i() * X), cos(X) + i() * sin(X))]),
    identity("Euler", [10, 12], 1, waves::to_euler, || vec![(cos(X) - i() * sin(X), exp(-(i() * X)))]),
    identity("Euler", [16, 14], 1, waves::wave_to_exponentials, || {
        vec![(cos(X), (exp(i() * X) + exp(-(i() * X))) / 2), (sin(X), (exp(i() * X) - exp(-(i() * X))) / (2 * i()))]
    }),
];

/// What leads from one state to the next.
#[derive(Clone, Debug)]
pub(super) struct Move {
    pub image: Image,
    pub reason: Reason,
    /// The factor that it is about.
    pub about: Option<Term>,
    /// The factors on the way, not yet cancelled; may be empty.
    pub via: Vec<Power>,
}

impl Move {
    fn new(image: Image, reason: Reason) -> Self {
        Self { image, reason, about: None, via: vec![] }
    }

    /// How much a line of it costs a reader: more where it is done at many places, or where factors cancel by the
    /// way.
    pub fn cost(&self, reversed: bool) -> u32 {
        let by_the_way = match self.image.cancelled.len() as u32 {
            0 => 0,
            factors if self.reason.is_algebra() => 5 + factors,
            factors if reversed => 12 + factors,
            factors => 9 + factors,
        };
        match self.reason {
            Reason::Rule(rule) => {
                RULES[rule].costs[usize::from(reversed)] + 2 * (self.image.places as u32 - 1) + by_the_way
            }
            Reason::Given(_) => 8 + by_the_way,
        }
    }
}

/// A rule, by its place in [`RULES`], or a hypothesis by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Reason {
    Rule(usize),
    Given(&'static str),
}

impl Reason {
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
    scene: &'a Scene,
    known: HashMap<Term, Rc<Vec<Move>>>,
}

impl<'a> Moves<'a> {
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene, known: HashMap::new() }
    }

    /// Everything that one displayed line leads to.
    pub fn of(&mut self, term: &Term) -> Vec<Move> {
        let single = self.once(term);
        let mut moves = self.hypotheses(term);
        for (at, rule) in RULES.iter().enumerate() {
            let reason = Reason::Rule(at);
            if rule.everywhere > 0 && single.iter().filter(|step| step.reason == reason).nth(1).is_some() {
                let all = (0..rule.everywhere).map(|variant| self.everywhere(term, rule, variant));
                moves.extend(all.filter(|image| image.places > 1).map(|image| Move::new(image, reason)));
            }
        }
        moves.extend(single.iter().cloned());
        moves
    }

    /// The hypotheses of one name together, and each alone.
    fn hypotheses(&self, term: &Term) -> Vec<Move> {
        let givens = &self.scene.givens;
        let mut moves = Vec::new();
        for (at, given) in givens.iter().enumerate() {
            if givens[..at].iter().all(|earlier| earlier.by != given.by) {
                let all = givens.iter().filter(|other| other.by == given.by);
                let together = all.fold(Image::new(term.clone(), 0), |mut sum, given| {
                    let next = given.apply(&sum.to);
                    sum.cancelled.extend(next.cancelled);
                    Image { to: next.to, places: sum.places + next.places, ..sum }
                });
                moves.push(Move::new(together, Reason::Given(given.by)));
            }
            moves.push(Move::new(given.apply(term), Reason::Given(given.by)));
        }
        moves.retain(|step| step.image.places > 0);
        moves
    }

    /// Every rule at every single place.
    fn once(&mut self, term: &Term) -> Rc<Vec<Move>> {
        if let Some(known) = self.known.get(term) {
            return known.clone();
        }
        let mut moves = Vec::new();
        for (rule, Rule { apply, .. }) in RULES.iter().enumerate() {
            let mut found = Found::new();
            apply(term, self.scene, &mut found);
            moves.extend(found.into_iter().map(|Rewrite { to, about, via }| Move {
                image: Image::new(to, 1),
                reason: Reason::Rule(rule),
                about,
                via,
            }));
        }
        for (at, part) in parts(term).iter().enumerate() {
            let inner = self.once(part);
            moves.extend(inner.iter().map(|step| Move {
                image: with_part(term, at, step),
                via: vec![],
                ..step.clone()
            }));
        }
        let mut seen = HashSet::new();
        moves.retain(|step| {
            let to = &step.image.to;
            !to.is_undefined() && to != term && seen.insert((to.clone(), step.reason))
        });
        let moves = Rc::new(moves);
        self.known.insert(term.clone(), moves.clone());
        moves
    }

    /// One rule at every place, from the outside inwards.
    fn everywhere(&self, term: &Term, rule: &Rule, variant: usize) -> Image {
        let mut found = Found::new();
        (rule.apply)(term, self.scene, &mut found);
        let last = found.len().saturating_sub(1);
        match found.get(variant.min(last)) {
            Some(rewrite) => Image::new(rewrite.to.clone(), 1),
            None => map(term, &mut |child| self.everywhere(child, rule, variant)),
        }
    }
}

fn parts(term: &Term) -> Vec<Term> {
    match term.form() {
        Form::Sum(parts) => parts.clone(),
        Form::Product(_, factors) => factors.iter().map(|(base, _)| base.clone()).collect(),
        Form::Function(_, of) => vec![of.clone()],
        _ => vec![],
    }
}

/// `term` with one of its parts moved.
fn with_part(term: &Term, at: usize, step: &Move) -> Image {
    let mut count = 0;
    map(term, &mut |part| {
        count += 1;
        if count - 1 == at { step.image.clone() } else { Image::new(part.clone(), 0) }
    })
}
