//! `lesson prove`: does one expression equal another, does one equation follow from another?

use crate::out;
use crate::stop::Stop;
use chapters::judge::{hop_holds, hops};
use equation::derivation::{Chain, Claim, Hop, Verdict};
use equation::expr::Node;
use equation::parse::{Fault, parse, parse_equation};
use equation::value::Bindings;
use equation::{Equation, Expr, Relation, Symbol};
use num_complex::Complex64;
use std::process::ExitCode;
use views::block::Details;
use views::report::derivation::{conditions, hypothesis, lines};
use views::report::proof::{ProofReport, Sides, Witness, assumed};
use views::tell::Teller;

/// What is asked.
#[derive(Debug)]
pub struct Question {
    pub from: String,
    pub to: String,
    pub given: Vec<String>,
    pub real: Vec<String>,
    pub unfold: bool,
    pub json: bool,
}

/// Answers on standard output.
pub fn serve(question: &Question) -> Result<ExitCode, Stop> {
    let (chain, goal) = read(question)?;
    let answer = answer(&chain, &goal);
    if question.json {
        let document = serde_json::to_string_pretty(&answer).expect("plain data");
        out::print(format!("{document}\n").as_bytes())?;
    } else {
        let teller = Teller::english(Details { units: false, unfold: question.unfold });
        out::show(&teller.proof(&answer))?;
    }
    Ok(ExitCode::from(match answer.verdict {
        "proved" => 0,
        "refuted" => 1,
        _ => 2,
    }))
}

/// The premises, and what is to be shown of them.
fn read(question: &Question) -> Result<(Chain, Equation), Stop> {
    let real = question.real.iter().map(|text| real(text)).collect::<Result<Vec<_>, _>>()?;
    let (expression, equation) = (|text: &str| expression(text, &real), |text: &str| equation(text, &real));
    let mut chain = Chain::default();
    for text in &question.given {
        chain = chain.and(equation(text)?, "given");
    }
    let is_equation = |text: &str| text.contains(['=', '≈', '∝']);
    match (is_equation(&question.from), is_equation(&question.to)) {
        (false, false) => Ok((chain, Equation::new(expression(&question.from)?, expression(&question.to)?))),
        (true, true) => Ok((chain.and(equation(&question.from)?, "assumed"), equation(&question.to)?)),
        _ => Err(Stop::Refused("expected two expressions or two equations, found one of each".to_owned())),
    }
}

/// Where a name that is declared real is looked at.
const REAL: f64 = 4.0;
/// Where names are looked at that no difference was found between nearer to zero.
const FAR: f64 = 60.0;

/// A name that stands for a real number of either sign.
fn real(name: &str) -> Result<Symbol, Stop> {
    match expression(name, &[])?.node() {
        Node::Symbol(symbol) => Ok(symbol.clone().real(-REAL, REAL)),
        _ => Err(Stop::at("--real", format!("expected a name such as x or theta_1, found {name}"))),
    }
}

fn expression(text: &str, known: &[Symbol]) -> Result<Expr, Stop> {
    parse(text, known).map_err(|fault| point_at(text, &fault))
}

fn equation(text: &str, known: &[Symbol]) -> Result<Equation, Stop> {
    let equation = parse_equation(text, known).map_err(|fault| point_at(text, &fault))?;
    match equation.relation {
        Relation::Equal => Ok(equation),
        _ => Err(Stop::at(equation, "only equations with = can be proved or given")),
    }
}

/// How many characters of a text are shown around a fault, on each side.
const AROUND: usize = 30;

/// The fault with the place in `text` that it is about, a caret below.
fn point_at(text: &str, fault: &Fault) -> Stop {
    let start = fault.column.saturating_sub(AROUND + 1);
    let excerpt: String =
        text.chars().skip(start).take(2 * AROUND).map(|c| if c.is_control() { ' ' } else { c }).collect();
    let before = if start > 0 { "…" } else { "" };
    let after = if text.chars().nth(start + 2 * AROUND).is_some() { "…" } else { "" };
    let indent = " ".repeat(before.chars().count() + fault.column - 1 - start);
    Stop::Refused(format!("{fault}\n  {before}{excerpt}{after}\n  {indent}^"))
}

/// Decides the goal first; only what holds is worth a search for lines.
fn answer(premises: &Chain, goal: &Equation) -> ProofReport {
    let mut whole = premises.clone().find(goal.clone());
    let mut decisions = hops(&whole, "prove");
    if let Some(Verdict::Agrees { .. }) = decisions.last().map(|hop| &hop.verdict) {
        let far = further_out(&whole);
        let found = hops(&far, "prove");
        if let Some(Verdict::Refuted { .. }) = found.last().map(|hop| &hop.verdict) {
            (whole, decisions) = (far, found);
        }
    }
    let decided = decisions.last().map_or(Verdict::Proved, |hop| hop.verdict.clone());
    let is_proof = |hops: &[Hop]| !hops.is_empty() && hops.iter().all(|hop| hop_holds(&hop.verdict));
    let complete = decided.agrees().then(|| whole.complete());
    let judged = complete.map(|chain| (hops(&chain, "prove"), chain)).filter(|(hops, _)| is_proof(hops));
    // Without lines the goal stands as the normal form decided it.
    let (hops, found) = judged.unwrap_or((decisions, whole));
    let proved = is_proof(&hops);
    let (verdict, why) = match &decided {
        _ if proved => ("proved", None),
        Verdict::Refuted { .. } => ("refuted", None),
        Verdict::Unknown { why } => ("unknown", Some(why.clone())),
        Verdict::Proved | Verdict::Agrees { .. } => {
            ("unknown", Some("the sides agree wherever they were compared, but no proof was found".to_owned()))
        }
    };
    let mut lines = lines(&found, &hops);
    if !proved {
        // What became of the goal is said once, below.
        lines.iter_mut().for_each(|line| line.hop = None);
    }
    let hypotheses = found.hypotheses().unwrap_or_default();
    let witness = match &decided {
        Verdict::Refuted { at, .. } => Some(Witness { at: at.clone(), values: values(goal, at, &found) }),
        _ => None,
    };
    ProofReport {
        verdict,
        claim: goal.to_string(),
        lines,
        hypotheses: hypotheses.iter().map(hypothesis).collect(),
        assumed: assumed(&found),
        conditions: if proved { conditions(&found) } else { Vec::new() },
        why,
        witness,
    }
}

/// The same chain with its names over larger numbers.
fn further_out(chain: &Chain) -> Chain {
    fn wider(expr: &Expr) -> Expr {
        match expr.node() {
            Node::Symbol(symbol) if symbol.domain().re.0 > 0.0 => Expr::from(symbol.clone().real(1.0 / FAR, FAR)),
            Node::Symbol(symbol) => Expr::from(symbol.clone().real(-FAR, FAR)),
            _ => expr.map(&mut wider),
        }
    }
    let mut far = chain.clone();
    for line in &mut far.lines {
        line.claim = match &line.claim {
            Claim::Expr(expr) => wider(expr).into(),
            Claim::Equation(equation) => Equation::new(wider(&equation.lhs), wider(&equation.rhs)).into(),
        };
    }
    far
}

/// Both sides of `goal` at a point, under the hypotheses of `chain`; none if they need more than the point says.
fn values(goal: &Equation, at: &[(String, String)], chain: &Chain) -> Option<Sides> {
    let mut bindings = Bindings::new();
    let claims = chain.lines.iter().flat_map(|line| match &line.claim {
        Claim::Expr(expr) => vec![expr],
        Claim::Equation(equation) => vec![&equation.lhs, &equation.rhs],
    });
    let symbols: Vec<_> = claims.flat_map(Expr::symbols).collect();
    for (face, value) in at {
        let symbol = symbols.iter().find(|symbol| symbol.to_string() == *face)?;
        bindings.bind(symbol.name(), complex(value)?);
    }
    for given in chain.hypotheses().ok()? {
        if let Node::Symbol(symbol) = given.what.node() {
            bindings.define(symbol, given.value);
        }
    }
    let value = |side: &Expr| side.evaluate(&bindings).map(shown).ok();
    Some(Sides { left: value(&goal.lhs)?, right: value(&goal.rhs)? })
}

/// Reads `0.25`, `0.25 + 0.5i` or `0.25 − 0.5i`.
fn complex(text: &str) -> Option<Complex64> {
    let Some(parts) = text.strip_suffix('i') else { return Some(text.parse::<f64>().ok()?.into()) };
    match (parts.split_once(" + "), parts.split_once(" − ")) {
        (Some((re, im)), _) => Some(Complex64::new(re.parse().ok()?, im.parse().ok()?)),
        (_, Some((re, im))) => Some(Complex64::new(re.parse().ok()?, -im.parse::<f64>().ok()?)),
        _ => None,
    }
}

fn shown(value: Complex64) -> String {
    let sign = if value.im < 0.0 { '−' } else { '+' };
    let real = value.re.to_string().replace('-', "−");
    if value.im == 0.0 { real } else { format!("{real} {sign} {}i", value.im.abs()) }
}
