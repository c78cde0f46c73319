//! The way that was found as lines for a reader: what leads to each, what it sums up.

use super::rules::Move;
use super::scene::Scene;
use super::search::Edge;
use super::show::Writer;
use super::term::Term;
use super::way::Step;
use crate::expr::{Expr, Node};
use crate::hypothesis::Given;
use crate::rational::Rational;
use std::borrow::Cow;

/// In a derivation of more lines, moves of algebra in a row become one line.
const LONG: usize = 8;
/// The size of a factor that is still named.
const LONGEST: usize = 4;

/// A line with what is needed to sum it up with its neighbours.
struct Single {
    step: Step,
    name: Cow<'static, str>,
    places: usize,
    is_algebra: bool,
}

impl Single {
    /// What takes no rule: numbers, signs, like terms, powers and fractions of fractions; or the mere order.
    fn plain(before: &Expr, expr: &Expr) -> Self {
        let name: Cow<str> = if leaves(before) == leaves(expr) { "rearrange" } else { "simplify" }.into();
        let step = Step { expr: expr.clone(), by: vec![name.clone()], unfolded: vec![] };
        Self { step, name, places: 1, is_algebra: true }
    }
}

/// The lines of a way, with the start and the goal as they were written.
pub(super) fn lay_out(scene: &Scene, ends: [&Expr; 2], given: &[Given], from: &Term, way: Vec<Edge>) -> Vec<Step> {
    sum_up(&single_steps(scene, ends, given, from, way))
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
    if !way.is_empty() && leaves(&simplified) != leaves(start) {
        lines.push(Single::plain(start, &simplified));
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
        _ if before == *goal => {}
        _ => lines.push(Single::plain(&before, goal)),
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
        let names = if edge.reversed {
            [name.to_string(), "expand".into()]
        } else {
            [format!("factor {about}"), name.to_string()]
        };
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

fn counted(name: &str, places: usize) -> Cow<'static, str> {
    if places > 1 { format!("{name} ×{places}").into() } else { name.to_owned().into() }
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
fn sum_up(lines: &[Single]) -> Vec<Step> {
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
