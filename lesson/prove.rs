//! A step's equations and derivations, judged.

use crate::report::{DerivationReport, HopReport, LineReport, Number, StatementReport};
use chapters::vocabulary::{Derivation, Statement, verify};
use light::equation::Equation;
use light::equation::derivation::{Chain, Claim, Given, Hop, Line, Verdict};

/// An equation with its faces and the dimension of its sides.
pub fn state(statement: &Statement, address: String) -> StatementReport {
    let equation = (statement.equation)();
    let dimension = equation.dimension();
    StatementReport {
        address,
        says: statement.says,
        rows: statement.rows,
        latex: equation.latex(),
        unicode: equation.to_string(),
        verdict: dimension.is_ok().into(),
        dimension: dimension.map_or_else(|mismatch| mismatch.to_string(), |dimension| dimension.to_string()),
    }
}

/// A chain of lines with the verdict on every hop.
pub fn derive(derivation: &Derivation, address: String) -> DerivationReport {
    let chain = (derivation.chain)();
    let hops = verify(&chain, &address);
    let mismatch = chain.units().err().map(|mismatch| mismatch.to_string());
    let holds = mismatch.is_none() && !hops.is_empty() && hops.iter().all(|hop| hop.verdict.holds());
    DerivationReport {
        address,
        says: derivation.says,
        rows: derivation.rows,
        hypotheses: chain.given.iter().map(hypothesis).collect(),
        lines: lines(&chain, &hops),
        mismatch,
        verdict: holds.into(),
    }
}

fn hypothesis(given: &Given) -> LineReport {
    let equation = Equation::new(&given.what, &given.value);
    LineReport {
        latex: equation.latex(),
        unicode: equation.to_string(),
        by: vec![given.by.into()],
        says: "",
        hop: None,
    }
}

fn lines(chain: &Chain, hops: &[Hop]) -> Vec<LineReport> {
    let hop = |at: usize| hops.iter().find(|hop| hop.line == at).map(|hop| found(&hop.verdict));
    chain.lines.iter().enumerate().map(|(at, line)| show(line, hop(at))).collect()
}

fn show(line: &Line, hop: Option<HopReport>) -> LineReport {
    let (latex, unicode) = match &line.claim {
        Claim::Equation(equation) => (equation.latex(), equation.to_string()),
        // Only a start has no hop behind it.
        Claim::Expr(expr) if hop.is_none() => (expr.latex(), expr.to_string()),
        Claim::Expr(expr) => (format!("= {}", expr.latex()), format!("= {expr}")),
    };
    LineReport { latex, unicode, by: line.by.clone(), says: line.says, hop }
}

fn found(verdict: &Verdict) -> HopReport {
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
    HopReport { verdict: verdict.holds().into(), found, digits: digits.map(Number) }
}
