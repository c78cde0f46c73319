//! The way from one term to another: best first, from both ends at once.

use super::rules::{Move, Moves};
use super::scene::Scene;
use super::term::{Form, Term, Values};
use std::cmp::Reverse;
use std::collections::hash_map::Entry;
use std::collections::{BinaryHeap, HashMap};

/// One line of the way.
#[derive(Clone, Debug)]
pub(super) struct Edge {
    /// The state that it leads to.
    pub to: Term,
    pub step: Move,
    /// Whether the rule was applied to that state, and led to the one before.
    pub reversed: bool,
}

/// States that are looked at before the search gives up.
const MOST_STATES: usize = 20_000;
/// The size of everything that rules come up with before the search gives up: a second's work.
const MOST_WORK: usize = 1_000_000;
/// How much larger than the larger end a state may be.
const GROWTH: usize = 40;
/// Expansions, as a multiple of those up to the first way found, during which a better one is looked for.
const PATIENCE: usize = 2;
/// Values are called equal up to this much of their size.
const TOLERANCE: f64 = 1e-7;

/// Whether two terms may be worth the same. `scale` is the size of numbers met on the way.
pub(super) fn agree(a: Values, b: Values, scale: f64) -> bool {
    a.iter().zip(&b).all(|(a, b)| (a - b).norm() <= TOLERANCE * (a.norm() + b.norm() + scale))
}

/// What rounding may leave of a value that vanishes, relative to the values of the parts it is made of.
pub(super) fn rounding(term: &Term) -> f64 {
    let parts: &[Term] = match term.form() {
        Form::Sum(parts) => parts,
        _ => &[],
    };
    1e-4 * parts.iter().flat_map(Term::values).map(|value| value.norm()).fold(0.0, f64::max)
}

/// The way from `start` to `goal`, or how many states were looked at in vain.
pub(super) fn search(scene: &Scene, start: &Term, goal: &Term) -> Result<Vec<Edge>, usize> {
    if start == goal {
        return Ok(vec![]);
    }
    let largest = start.size().max(goal.size()) + GROWTH;
    let scale = rounding(start).max(rounding(goal));
    let mut moves = Moves::new(scene);
    let mut sides = [Side::new(start, goal, false), Side::new(goal, start, true)];
    let mut best: Option<(u32, Term)> = None;
    let mut expanded = 0;
    let mut patience = usize::MAX;
    let mut work = 0;
    while expanded < patience && work < MOST_WORK && sides[0].states.len() + sides[1].states.len() < MOST_STATES {
        let Some(from) = sides[expanded % 2].next() else {
            if sides[(expanded + 1) % 2].queue.is_empty() {
                break;
            }
            expanded += 1;
            continue;
        };
        let (one, other) = sides.split_at_mut(1);
        let (side, other) = if expanded % 2 == 0 { (&mut one[0], &other[0]) } else { (&mut other[0], &one[0]) };
        expanded += 1;
        for step in moves.of(&side.states[from].term) {
            work += step.image.to.size();
            if step.image.to.size() > largest || !agree(step.image.to.values(), start.values(), scale) {
                continue;
            }
            let Some((to, cost)) = side.reach(from, &step) else { continue };
            if let Some(met) = other.known.get(&step.image.to) {
                let total = cost + other.states[*met].cost;
                if best.as_ref().is_none_or(|(least, _)| total < *least) {
                    best = Some((total, side.states[to].term.clone()));
                    patience = patience.min(PATIENCE * expanded + 12);
                }
            }
        }
    }
    let Some((_, meeting)) = best else { return Err(sides[0].states.len() + sides[1].states.len()) };
    Ok(shorten(&mut moves, start, way(&sides, &meeting)))
}

/// From the start to where the two sides met, and on to the goal.
fn way(sides: &[Side; 2], meeting: &Term) -> Vec<Edge> {
    let there = sides[0].back_from(meeting).into_iter().rev();
    let there = there.map(|(_, step)| Edge { to: step.image.to.clone(), step, reversed: false });
    let onwards = sides[1].back_from(meeting).into_iter().map(|(to, step)| Edge { to, step, reversed: true });
    there.chain(onwards).collect()
}

/// Leaves out what a single line leads past.
fn shorten(moves: &mut Moves, start: &Term, way: Vec<Edge>) -> Vec<Edge> {
    let mut short: Vec<Edge> = Vec::new();
    let mut at = 0;
    while at < way.len() {
        let here = short.last().map_or(start, |edge| &edge.to).clone();
        let options = moves.of(&here);
        let jump = (at + 1..way.len()).rev().find_map(|later| {
            let step = options.iter().find(|step| step.image.to == way[later].to)?;
            let skipped: u32 = way[at..=later].iter().map(|edge| edge.step.cost(edge.reversed)).sum();
            (step.cost(false) < skipped).then(|| (later, step.clone()))
        });
        let (last, edge) = match jump {
            Some((later, step)) => (later, Edge { to: step.image.to.clone(), step, reversed: false }),
            None => (at, way[at].clone()),
        };
        short.push(edge);
        at = last + 1;
    }
    short
}

/// A state, and the move that led there from its parent.
struct State {
    term: Term,
    parent: Option<(usize, Move)>,
    cost: u32,
}

/// One of the two searches.
struct Side {
    states: Vec<State>,
    known: HashMap<Term, usize>,
    queue: BinaryHeap<Reverse<(u32, usize)>>,
    /// Whether it starts from the goal.
    is_backward: bool,
    /// The atoms of the other end, sorted.
    aim: Vec<u64>,
    /// The size of the larger end.
    size: usize,
}

impl Side {
    fn new(from: &Term, to: &Term, is_backward: bool) -> Self {
        let mut side = Self {
            states: vec![State { term: from.clone(), parent: None, cost: 0 }],
            known: HashMap::from([(from.clone(), 0)]),
            queue: BinaryHeap::new(),
            is_backward,
            aim: atoms(to),
            size: from.size().max(to.size()),
        };
        side.queue.push(Reverse((0, 0)));
        side
    }

    fn next(&mut self) -> Option<usize> {
        self.queue.pop().map(|Reverse((_, state))| state)
    }

    /// Notes the state that `step` leads to, unless it was reached as cheaply before.
    fn reach(&mut self, from: usize, step: &Move) -> Option<(usize, u32)> {
        let growth = step.image.to.size().saturating_sub(self.size) as u32;
        let cost = self.states[from].cost + step.cost(self.is_backward) + growth / 4;
        let parent = Some((from, step.clone()));
        let at = match self.known.entry(step.image.to.clone()) {
            Entry::Occupied(known) if self.states[*known.get()].cost <= cost => return None,
            Entry::Occupied(known) => {
                let at = *known.get();
                self.states[at].parent = parent;
                self.states[at].cost = cost;
                return Some((at, cost));
            }
            Entry::Vacant(free) => *free.insert(self.states.len()),
        };
        self.states.push(State { term: step.image.to.clone(), parent, cost });
        let distance = strangers(&atoms(&step.image.to), &self.aim) as u32;
        self.queue.push(Reverse((cost + step.image.to.size() as u32 + 3 * distance, at)));
        Some((at, cost))
    }

    /// The moves that led to `term`, the last one first, each with the state it was applied to.
    fn back_from(&self, term: &Term) -> Vec<(Term, Move)> {
        let mut moves = Vec::new();
        let mut at = self.known[term];
        while let Some((parent, step)) = &self.states[at].parent {
            moves.push((self.states[*parent].term.clone(), step.clone()));
            at = *parent;
        }
        moves
    }
}

/// What a term is made of, functions and symbols outside them, sorted and each once.
fn atoms(term: &Term) -> Vec<u64> {
    fn collect(term: &Term, found: &mut Vec<u64>) {
        match term.form() {
            Form::Sum(parts) => parts.iter().for_each(|part| collect(part, found)),
            Form::Product(_, factors) => factors.iter().for_each(|(base, _)| collect(base, found)),
            _ => found.push(term.fingerprint()),
        }
    }
    let mut found = Vec::new();
    collect(term, &mut found);
    found.sort_unstable();
    found.dedup();
    found
}

/// How many atoms only one of two terms has.
fn strangers(a: &[u64], b: &[u64]) -> usize {
    let missing = |a: &[u64], b: &[u64]| a.iter().filter(|atom| b.binary_search(atom).is_err()).count();
    missing(a, b) + missing(b, a)
}
