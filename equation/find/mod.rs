//! Finds the lines of a derivation: the way from one expression to another in steps that a textbook would print.
//!
//! The states of the search are canonical forms, in which order, grouping, signs and the arithmetic of numbers do not
//! show, so that every move is a line with a name. The search starts from both ends, prefers short lines, and is
//! deterministic. It is not part of any proof: whoever shows a line has it decided first. All states are watched at
//! two points that satisfy the hypotheses, so that a false goal is refused at once.
//!
//! ```
//! use equation::dimension::Dimension;
//! use equation::expr::{cos, sin};
//! use equation::find::find;
//! use equation::symbol::Symbol;
//!
//! const X: Symbol = Symbol::scalar("x", Dimension::ONE);
//! let found = find(&(cos(X).pow(4) - sin(X).pow(4)), &cos(2 * X), &[]).unwrap();
//! let lines: Vec<_> = found.steps.iter().map(|step| step.expr.to_string()).collect();
//! assert_eq!(lines.last().unwrap(), "cos(2x)");
//! ```

mod algebra;
mod lines;
mod number;
mod rules;
mod scene;
mod search;
mod show;
mod term;
#[cfg(test)]
mod tests;
mod trigonometry;
mod way;

use super::expr::Expr;
use super::hypothesis::Given;
use scene::Scene;

pub use rules::{RULES, Rule};
pub use way::{Found, NotFound, Step};

/// Parts of an expression that a search starts from.
const MOST_PARTS: usize = 200;
/// Levels of such an expression.
const DEEPEST: usize = 60;

/// The lines that lead from `start` to `goal`, which are scalar and equal under the hypotheses `given`. Hypotheses about
/// vectors and derivatives are of no use to them and stay aside.
pub fn find(start: &Expr, goal: &Expr, given: &[Given]) -> Result<Found, NotFound> {
    let hypotheses = given.iter().flat_map(|given| [&given.what, &given.value]);
    if ![start, goal].into_iter().chain(hypotheses).all(is_small) {
        return Err(NotFound::TooLarge);
    }
    let given: Vec<Given> = given.iter().filter(|given| scene::is_scalar(&given.what)).cloned().collect();
    let scene = Scene::new([start, goal], &given)?;
    let (from, to) = (scene.term(start)?, scene.term(goal)?);
    if !search::agree(from.values(), to.values(), search::rounding(&from).max(search::rounding(&to))) {
        return Err(NotFound::Differs);
    }
    let way = search::search(&scene, &from, &to).map_err(|states| NotFound::Exhausted { states })?;
    Ok(Found { steps: lines::lay_out(&scene, [start, goal], &given, &from, way) })
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
