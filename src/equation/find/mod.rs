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
use super::rational::Rational;
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
/// In a derivation of more lines, moves of algebra in a row become one line.
const LONG: usize = 8;
/// The size of a factor that is still named.
const LONGEST: usize = 4;

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
    Ok(Found { steps: sum_up(single_steps(&scene, [start, goal], given, &from, way)) })
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
fn single_steps(scene: &Scene, ends: [&Expr; 2], given: &[Given], from: &Term, way: Vec<Edge>) -> Vec<Single> {
    let [start, goal] = ends;
    let after = |line: &Expr| {
        let models = std::iter::once(line).chain(given.iter().map(|given| &given.value)).chain([goal]);
        Writer::after(scene, models)
    };
    let mut lines = Vec::new();
    let mut before = start.clone();
    let simplified = after(start).expr(from);
    if leaves(&simplified) != leaves(start) && (!way.is_empty() || leaves(goal) != leaves(&simplified)) {
        lines.push(Single::simplify(simplified.clone()));
        before = simplified;
    }
    for edge in way {
        let line = single(&after(&before), &edge);
        before = line.step.expr.clone();
        lines.push(line);
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

fn single(writer: &Writer, edge: &Edge) -> Single {
    let Move { image, reason, about, via } = &edge.step;
    let expr = writer.expr(&edge.to);
    let about = about.as_ref().map(|about| face(writer, about));
    let mut name = reason.name(edge.reversed);
    if let Some(about) = about.as_ref().filter(|_| name != "expand") {
        name = format!("{name} {about}").into();
    }
    let mut by = vec![counted(&name, image.places)];
    if !image.cancelled.is_empty() {
        let verb = match edge.reversed {
            false => "cancel",
            true if name == "split the fraction" => "divide by",
            true => "extend by",
        };
        let all = Term::product(image.cancelled.iter().map(|factor| (factor.clone(), Rational::ONE)));
        by.push(format!("{verb} {}", face(writer, &all)).into());
    }
    let mut unfolded = vec![];
    if let Some(about) = about.filter(|_| !via.is_empty()) {
        let step = |expr, by: String| Step { expr, by: vec![by.into()], unfolded: vec![] };
        let on_the_way = writer.fraction(Rational::ONE, via);
        let names = if edge.reversed { [name.to_string(), "expand".into()] } else { [format!("factor {about}"), name.to_string()] };
        let [first, last] = names;
        unfolded = vec![step(on_the_way, first), step(expr.clone(), last)];
    }
    if edge.reversed {
        by.reverse();
    }
    Single { step: Step { expr, by, unfolded }, name, places: image.places, is_algebra: reason.is_algebra() }
}

/// A factor as it is named in a rule.
fn face(writer: &Writer, factor: &Term) -> String {
    if factor.size() > LONGEST { "the common factor".to_owned() } else { writer.factor(factor).to_string() }
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

/// Moves of one name in a row become one line, and where there are many lines, so do moves of algebra.
fn sum_up(lines: Vec<Single>) -> Vec<Step> {
    let is_long = lines.len() > LONG;
    let joins = |a: &Single, b: &Single| {
        let is_same = a.step.by.len() == 1 && b.step.by.len() == 1 && a.name == b.name && !a.is_algebra;
        is_same || (is_long && a.is_algebra && b.is_algebra)
    };
    lines.chunk_by(joins).map(merged).collect()
}

fn merged(run: &[Single]) -> Step {
    let last = &run[run.len() - 1];
    if run.len() == 1 {
        return last.step.clone();
    }
    let places = run.iter().map(|line| line.places).sum();
    let is_one_rule = run.iter().all(|line| line.name == last.name);
    let by = if is_one_rule { counted(&last.name, places) } else { "algebra".into() };
    let unfolded = run.iter().map(|line| line.step.clone()).collect();
    Step { expr: last.step.expr.clone(), by: vec![by], unfolded }
}
