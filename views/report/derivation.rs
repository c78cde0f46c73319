//! A step's equations and derivations, judged.

use super::{DerivationReport, HopReport, LineReport, Number, StatementReport};
use chapters::judge::{Derived, Stated, hop_holds};
use chapters::vocabulary::{Derivation, Statement};
use equation::derivation::{Chain, Claim, Hop, Line, Role, Verdict};
use equation::face::Block;
use equation::hypothesis::Given;
use equation::units::Mismatch;
use equation::{Dimension, Equation, Expr};

/// The lecture rows that an item is evidence for.
pub type Rows = &'static [&'static str];

/// An equation with its faces and the dimension of its sides.
pub fn state(statement: &Statement, found: Stated, rows: Rows, address: String) -> StatementReport {
    let holds = found.holds();
    let Stated { equation, dimension, is_struck_out } = found;
    StatementReport {
        address,
        says: statement.says,
        rows,
        latex: equation.latex(),
        unicode: equation.to_string(),
        mathml: equation.mathml(),
        layout: equation.layout(),
        verdict: holds.into(),
        dimension: unit(dimension),
        is_struck_out,
    }
}

fn unit(found: Result<Dimension, Mismatch>) -> String {
    found.map_or_else(|mismatch| mismatch.to_string(), |dimension| dimension.to_string())
}

/// A chain of lines with the verdict on every hop.
pub fn derive(derivation: &Derivation, found: Derived, rows: Rows, address: String) -> DerivationReport {
    let holds = found.holds();
    let Derived { chain, hops, mismatch } = found;
    DerivationReport {
        address,
        says: derivation.says,
        rows,
        hypotheses: chain.given.iter().map(hypothesis).collect(),
        lines: lines(&chain, &hops),
        conditions: conditions(&chain),
        mismatch: mismatch.map(|mismatch| mismatch.to_string()),
        verdict: holds.into(),
    }
}

/// What must not be zero where `chain` holds.
pub fn conditions(chain: &Chain) -> Vec<String> {
    chain.conditions().iter().map(|divisor| format!("{divisor} ≠ 0")).collect()
}

/// A hypothesis as the substitution that it is.
pub fn hypothesis(given: &Given) -> LineReport {
    let equation = Equation::new(&given.what, &given.value);
    LineReport { by: vec![given.by.into()], ..of_equation(&equation) }
}

fn of_equation(equation: &Equation) -> LineReport {
    LineReport {
        latex: equation.latex(),
        unicode: equation.to_string(),
        mathml: equation.mathml(),
        layout: equation.layout(),
        dimension: unit(equation.dimension()),
        by: Vec::new(),
        says: "",
        hop: None,
        unfolded: Vec::new(),
    }
}

/// An expression that starts a chain.
fn of_start(expr: &Expr) -> LineReport {
    LineReport {
        latex: expr.latex(),
        unicode: expr.to_string(),
        mathml: expr.mathml(),
        layout: expr.layout(),
        dimension: unit(expr.dimension()),
        by: Vec::new(),
        says: "",
        hop: None,
        unfolded: Vec::new(),
    }
}

/// An expression that continues the line before it.
fn of_next(expr: &Expr) -> LineReport {
    let start = of_start(expr);
    LineReport {
        latex: format!("= {}", start.latex),
        unicode: format!("= {}", start.unicode),
        mathml: start.mathml.replacen('>', "><mo>=</mo>", 1),
        layout: Block::from("= ".to_owned()).beside(start.layout),
        ..start
    }
}

/// The lines of `chain` with what was found of each hop.
pub fn lines(chain: &Chain, hops: &[Hop]) -> Vec<LineReport> {
    let hop = |at: usize| hops.iter().find(|hop| hop.line == at).map(|hop| found(&hop.verdict));
    let is_bare = chain.given.is_empty() && chain.lines.iter().all(|line| line.role != Role::Premise);
    let unnamed = if is_bare { "worked out" } else { "put in and worked out" };
    chain.lines.iter().enumerate().map(|(at, line)| named(show(line, hop(at)), unnamed)).collect()
}

/// With a reason for a hop that its author gave none, which calculus and algebra alone lead over.
fn named(line: LineReport, unnamed: &'static str) -> LineReport {
    let by = if line.hop.is_some() && line.by.is_empty() { vec![unnamed.into()] } else { line.by };
    LineReport { by, ..line }
}

fn show(line: &Line, hop: Option<HopReport>) -> LineReport {
    let face = match &line.claim {
        Claim::Equation(equation) => of_equation(equation),
        // Only a start has no hop behind it.
        Claim::Expr(expr) if hop.is_none() => of_start(expr),
        Claim::Expr(expr) => of_next(expr),
    };
    let unfolded = line.unfolded.iter().map(step).collect();
    LineReport { by: line.by.clone(), says: line.says, hop, unfolded, ..face }
}

/// A single step inside a line.
fn step(line: &Line) -> LineReport {
    let face = match &line.claim {
        Claim::Equation(equation) => of_equation(equation),
        Claim::Expr(expr) => of_next(expr),
    };
    LineReport { by: line.by.clone(), says: line.says, ..face }
}

/// What was found of a hop, in words.
pub fn found(verdict: &Verdict) -> HopReport {
    let (found, digits) = match verdict {
        Verdict::Proved => ("proved".to_owned(), None),
        Verdict::Agrees { points, digits, .. } => {
            (format!("agrees to {digits:.0} digits at {points} points"), Some(*digits))
        }
        Verdict::Refuted { at, digits } => {
            let point: Vec<_> = at.iter().map(|(symbol, value)| format!("{symbol} = {value}")).collect();
            (format!("refuted: {:.0} digits agree at {}", digits.max(0.0), point.join(", ")), Some(*digits))
        }
        Verdict::Unknown { why } => (format!("undecided: {why}"), None),
    };
    HopReport { verdict: hop_holds(verdict).into(), found, digits: digits.map(Number) }
}
