//! Finds the lines of a derivation: the way from one expression to another in steps that a textbook would print.
//!
//! The states of the search are canonical forms, in which order, grouping, signs and the arithmetic of numbers do not
//! show, so that every move is a line with a name. The search starts from both ends, prefers short lines, and is
//! deterministic. It is not part of any proof: whoever shows a line has it decided first. All states are watched at
//! two points that satisfy the hypotheses, so that a false goal is refused at once.
//!
//! ```
//! use light::equation::dimension::Dimension;
//! use light::equation::expr::{cos, sin};
//! use light::equation::find::find;
//! use light::equation::symbol::Symbol;
//!
//! const X: Symbol = Symbol::scalar("x", Dimension::ONE);
//! let found = find(&(cos(X).pow(4) - sin(X).pow(4)), &cos(2 * X), &[]).unwrap();
//! let lines: Vec<_> = found.steps.iter().map(|step| step.expr.to_string()).collect();
//! assert_eq!(lines.last().unwrap(), "cos(2x)");
//! ```

mod algebra;
mod rules;
mod scene;
mod search;
mod show;
mod term;
#[cfg(test)]
mod tests;
mod trigonometry;

use super::derivation::Given;
use super::expr::{Expr, Node};
use rules::Move;
use scene::Scene;
use search::Edge;
use show::Writer;
use std::borrow::Cow;
use std::fmt;
use term::Term;

pub use rules::{RULES, Rule};

/// A way from one expression to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The lines after the start, of which the last is the goal.
    pub steps: Vec<Step>,
}

/// A line.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What it says.
    pub expr: Expr,
    /// The rules that lead to it from the line before, as displayed: "Snell ×4", "cancel k".
    pub by: Vec<Cow<'static, str>>,
    /// The single steps that it sums up, ending with itself; empty where it is one.
    pub unfolded: Vec<Step>,
}

/// Why there is no way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotFound {
    /// The two have different values at a point that satisfies the hypotheses.
    Differs,
    /// An expression has too many parts, too deep a nesting or numbers out of range.
    TooLarge,
    /// None was found among so many states.
    Exhausted {
        /// How many.
        states: usize,
    },
    /// A vector, a derivative or the like, or a hypothesis that cannot be satisfied; its face in Unicode.
    NotAlgebraic(String),
}

impl fmt::Display for NotFound {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Differs => f.write_str("the two sides differ"),
            Self::TooLarge => f.write_str("too large to search"),
            Self::Exhausted { states } => write!(f, "not found among {states} states"),
            Self::NotAlgebraic(what) => write!(f, "not a matter of algebra: {what}"),
        }
    }
}

impl std::error::Error for NotFound {}

/// Parts of an expression that a search starts from.
const MOST_PARTS: usize = 400;
/// Levels of such an expression.
const DEEPEST: usize = 60;
/// So many moves of algebra in a row become one line.
const SUMMED_UP: usize = 3;

/// The lines that lead from `start` to `goal`, which are scalar and equal under the hypotheses `given`.
pub fn find(start: &Expr, goal: &Expr, given: &[Given]) -> Result<Found, NotFound> {
    let hypotheses = given.iter().flat_map(|given| [&given.what, &given.value]);
    if ![start, goal].into_iter().chain(hypotheses).all(is_small) {
        return Err(NotFound::TooLarge);
    }
    let scene = Scene::new([start, goal], given)?;
    let (from, to) = (scene.term(start)?, scene.term(goal)?);
    if from.is_undefined() || to.is_undefined() {
        return Err(NotFound::TooLarge);
    }
    if !search::agree(from.values(), to.values(), search::rounding(&from).max(search::rounding(&to))) {
        return Err(NotFound::Differs);
    }
    let way = search::search(&scene, &from, &to).map_err(|states| NotFound::Exhausted { states })?;
    Ok(Found { steps: sum_up(single_steps(&scene, start, goal, &from, way)) })
}

/// Whether an expression can be walked without care. Looks at no more of it than that takes.
fn is_small(expr: &Expr) -> bool {
    let mut open = vec![(expr, 0)];
    let mut parts = 0;
    while let Some((expr, depth)) = open.pop() {
        parts += 1;
        if parts > MOST_PARTS || depth > DEEPEST {
            return false;
        }
        open.extend(expr.children().into_iter().map(|child| (child, depth + 1)));
    }
    true
}

/// A line with what is needed to sum it up with its neighbours.
struct Single {
    step: Step,
    name: Cow<'static, str>,
    places: usize,
    is_algebra: bool,
}

impl Single {
    fn simplify(expr: Expr) -> Self {
        let step = Step { expr, by: vec!["simplify".into()], unfolded: vec![] };
        Self { step, name: "simplify".into(), places: 1, is_algebra: true }
    }
}

/// One line for every move, with the start and the goal as they were written.
fn single_steps(scene: &Scene, start: &Expr, goal: &Expr, from: &Term, way: Vec<Edge>) -> Vec<Single> {
    let mut lines = Vec::new();
    let mut before = start.clone();
    let simplified = Writer::after(scene, start).expr(from);
    if leaves(&simplified) != leaves(start) && (!way.is_empty() || leaves(goal) != leaves(&simplified)) {
        lines.push(Single::simplify(simplified.clone()));
        before = simplified;
    }
    let mut state = from.clone();
    for edge in way {
        let expr = Writer::after(scene, &before).expr(&edge.to);
        lines.push(single(scene, &before, &state, &edge, expr.clone()));
        before = expr;
        state = edge.to;
    }
    match lines.last_mut() {
        Some(last) if leaves(&last.step.expr) == leaves(goal) => {
            if let Some(end) = last.step.unfolded.last_mut() {
                end.expr = goal.clone();
            }
            last.step.expr = goal.clone();
        }
        _ => lines.push(Single::simplify(goal.clone())),
    }
    lines
}

fn single(scene: &Scene, before: &Expr, state: &Term, edge: &Edge, expr: Expr) -> Single {
    let Move { reason, about, places, via, .. } = &edge.step;
    let writer = Writer::after(scene, before);
    let mut name = reason.name(edge.reversed);
    if let Some(about) = about.as_ref().filter(|_| name != "expand") {
        name = format!("{name} {}", writer.expr(about)).into();
    }
    let by = vec![counted(&name, *places)];
    let mut unfolded = vec![];
    if let Some(about) = about.as_ref().filter(|_| !via.is_empty()) {
        let (first, last) = if edge.reversed { ("extend by", "expand") } else { ("factor", "cancel") };
        let on_the_way = writer.fraction(super::rational::Rational::ONE, via);
        let about = writer.expr(about);
        let last: Cow<'static, str> = if edge.reversed { last.into() } else { format!("{last} {about}").into() };
        unfolded.push(Step { expr: on_the_way, by: vec![format!("{first} {about}").into()], unfolded: vec![] });
        unfolded.push(Step { expr: expr.clone(), by: vec![last], unfolded: vec![] });
    }
    let _ = state;
    Single { step: Step { expr, by, unfolded }, name, places: *places, is_algebra: reason.is_algebra() }
}

fn counted(name: &Cow<'static, str>, places: usize) -> Cow<'static, str> {
    if places > 1 { format!("{name} ×{places}").into() } else { name.clone() }
}

/// Symbols in the order of their names, each as often as it is written: what simplifying changes.
fn leaves(expr: &Expr) -> Vec<&str> {
    let mut found: Vec<&str> = match expr.node() {
        Node::Symbol(symbol) => vec![symbol.name()],
        _ => expr.children().into_iter().flat_map(leaves).collect(),
    };
    found.sort_unstable();
    found
}

/// Moves of one name in a row become one line, and so do several of algebra.
fn sum_up(lines: Vec<Single>) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut rest = lines.as_slice();
    while let Some(first) = rest.first() {
        let algebra = rest.iter().take_while(|line| line.is_algebra).count();
        let alike = rest.iter().take_while(|line| line.name == first.name).count();
        let count = if algebra >= SUMMED_UP { algebra } else { alike };
        let (run, after) = rest.split_at(count);
        let expr = run[count - 1].step.expr.clone();
        steps.push(match count {
            1 => first.step.clone(),
            _ => {
                let places = run.iter().map(|line| line.places).sum();
                let by = if algebra >= SUMMED_UP { "algebra".into() } else { counted(&first.name, places) };
                Step { expr, by: vec![by], unfolded: run.iter().map(|line| line.step.clone()).collect() }
            }
        });
        rest = after;
    }
    steps
}
