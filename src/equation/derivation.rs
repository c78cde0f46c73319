//! Derivations: lines that follow from one another, each hop judged by the program.
//!
//! A hop is judged at random points of the stated domain, on the real axis and off it, in arbitrary precision.
//! With every value goes a bound of its rounding error, so that a difference is called real, or not, by what the
//! arithmetic at that point can tell, cancellation included.

use super::Equation;
use super::expr::Expr;
use super::symbol::{Domain, Symbol};
use super::tracked::Tracked;
use super::units::Mismatch;
use super::value::{Bindings, Evaluation, Unevaluable};
use crate::precise::{self, Complex};
use crate::sampling::Stream;
use num_complex::Complex64;
use rand::RngExt;

/// Hypotheses and lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The hypotheses as substitutions, each naming the rule it comes from. They are triangular: none leads back
    /// to its own symbol. Snell's law, for one, is n₁ := k sin θ₂, n₂ := k sin θ₁.
    pub given: Vec<Given>,
    /// In order. A line that is an expression equals the end of the line before it; a line that is an equation
    /// holds by itself under the hypotheses.
    pub lines: Vec<Line>,
}

/// A hypothesis: a symbol and what stands for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// What is replaced.
    pub symbol: Symbol,
    /// By what.
    pub value: Expr,
    /// The rule or law that says so.
    pub by: &'static str,
}

/// One line of a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it states.
    pub claim: Claim,
    /// The rules that lead to it, by name; none for a start.
    pub by: Vec<&'static str>,
    /// Why, in words; may be empty.
    pub says: &'static str,
}

/// What a line states.
#[derive(Clone, Debug, PartialEq)]
pub enum Claim {
    /// The next form of the same quantity.
    Expr(Expr),
    /// An equation.
    Equation(Equation),
}

impl From<Expr> for Claim {
    fn from(expr: Expr) -> Self {
        Self::Expr(expr)
    }
}

impl From<Equation> for Claim {
    fn from(equation: Equation) -> Self {
        Self::Equation(equation)
    }
}

/// A judged step of a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Hop {
    /// The line it leads to: an index into [`Chain::lines`].
    pub line: usize,
    /// The rules that justify it.
    pub by: Vec<&'static str>,
    /// What the program found.
    pub verdict: Verdict,
}

/// What is known about a hop.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Decided symbolically.
    Proved,
    /// Both sides agree wherever they were compared.
    Agrees {
        /// Points compared, half of them off the real axis wherever a symbol may leave it.
        points: usize,
        /// Points left out because a side has no finite value there.
        skipped: usize,
        /// Decimal digits that agree at the worst point, relative to the size of the terms.
        digits: f64,
    },
    /// The sides differ.
    Refuted {
        /// A point where they do: symbol (in Unicode) and value.
        at: Vec<(String, String)>,
        /// Decimal digits that agree there, relative to the size of the terms; negative where nothing does.
        digits: f64,
    },
    /// Nothing could be decided.
    Unknown {
        /// What stood in the way.
        why: String,
    },
}

impl Verdict {
    /// Whether the hop may be shown as holding.
    pub fn holds(&self) -> bool {
        matches!(self, Self::Proved | Self::Agrees { .. })
    }
}

impl Chain {
    /// A chain that starts from an expression or an equation.
    pub fn new(start: impl Into<Claim>) -> Self {
        Self { given: Vec::new(), lines: vec![Line { claim: start.into(), by: Vec::new(), says: "" }] }
    }

    /// With the hypothesis `symbol` := `value`, known as `by`.
    pub fn given(mut self, symbol: Symbol, value: impl Into<Expr>, by: &'static str) -> Self {
        self.given.push(Given { symbol, value: value.into(), by });
        self
    }

    /// With one more line, which follows `by` these rules.
    pub fn then<const N: usize>(mut self, claim: impl Into<Claim>, by: [&'static str; N]) -> Self {
        self.lines.push(Line { claim: claim.into(), by: by.into(), says: "" });
        self
    }

    /// With the reason, in words, for the last line.
    pub fn because(mut self, says: &'static str) -> Self {
        if let Some(line) = self.lines.last_mut() {
            line.says = says;
        }
        self
    }

    /// Whether every line has sides of the same SI dimension, and every hypothesis and expression the dimension
    /// of what it stands for.
    pub fn units(&self) -> Result<(), Mismatch> {
        for given in &self.given {
            Equation::new(&given.symbol, &given.value).dimension()?;
        }
        for (_, left, right) in self.pairs() {
            Equation::new(left, right).dimension()?;
        }
        Ok(())
    }

    /// What each hop claims to be equal: the line's index and two expressions.
    fn pairs(&self) -> Vec<(usize, &Expr, &Expr)> {
        let mut pairs = Vec::new();
        let mut end: Option<&Expr> = None;
        for (at, line) in self.lines.iter().enumerate() {
            match &line.claim {
                Claim::Equation(equation) => {
                    pairs.push((at, &equation.lhs, &equation.rhs));
                    end = Some(&equation.rhs);
                }
                Claim::Expr(expr) => {
                    pairs.extend(end.map(|end| (at, end, expr)));
                    end = Some(expr);
                }
            }
        }
        pairs
    }

    /// Judges every hop at `points` points of the domain with `bits` of precision (at least 53). The same `stream`
    /// gives the same points.
    pub fn verify(&self, points: usize, bits: usize, stream: &mut Stream) -> Vec<Hop> {
        let pairs = self.pairs();
        let symbols = self.free_symbols();
        let mut hops: Vec<Tally> = pairs.iter().map(|_| Tally::default()).collect();
        for attempt in 0..points * ATTEMPTS {
            if hops.iter().all(|hop| hop.is_done(points)) {
                break;
            }
            let sample = draw(&symbols, attempt % 2 == 1, stream);
            let bindings = self.bind(&sample, bits);
            let mut evaluation = Evaluation::new(&bindings);
            for (hop, (_, left, right)) in hops.iter_mut().zip(&pairs) {
                if !hop.is_done(points) {
                    hop.look(&mut evaluation, left, right, &sample, bits);
                }
            }
        }
        let judged = hops.into_iter().zip(&pairs);
        judged
            .map(|(hop, (line, ..))| Hop { line: *line, by: self.lines[*line].by.clone(), verdict: hop.verdict() })
            .collect()
    }

    /// The symbols that no hypothesis replaces, each once.
    fn free_symbols(&self) -> Vec<&Symbol> {
        let mut found: Vec<&Symbol> = Vec::new();
        let lines = self.lines.iter().flat_map(|line| match &line.claim {
            Claim::Expr(expr) => vec![expr],
            Claim::Equation(equation) => vec![&equation.lhs, &equation.rhs],
        });
        for expr in lines.chain(self.given.iter().map(|given| &given.value)) {
            for symbol in expr.symbols() {
                let is_given = self.given.iter().any(|given| given.symbol.name() == symbol.name());
                if !is_given && found.iter().all(|known| known.name() != symbol.name()) {
                    found.push(symbol);
                }
            }
        }
        found
    }

    fn bind(&self, sample: &[(&Symbol, Complex64)], bits: usize) -> Bindings<Tracked> {
        let mut bindings = Bindings::with_bits(bits);
        for (symbol, value) in sample {
            let part = |x| precise::real_at(x, bits);
            bindings.bind(symbol.name(), Tracked::exact(Complex::from_parts(part(value.re), part(value.im)), bits));
        }
        for given in &self.given {
            bindings.define(&given.symbol, given.value.clone());
        }
        bindings
    }
}

/// How many points are tried for each one that is wanted.
const ATTEMPTS: usize = 4;

/// How far apart, in units of the two error bounds, values may lie that are still called equal: room for the few
/// units in the last place that the functions themselves may be off.
const ALLOWANCE: f64 = 16.0;

fn draw<'a>(symbols: &[&'a Symbol], off_axis: bool, stream: &mut Stream) -> Vec<(&'a Symbol, Complex64)> {
    symbols.iter().map(|symbol| (*symbol, draw_one(symbol.domain(), off_axis, stream))).collect()
}

/// A point of the domain. On the real axis where the domain touches it, unless `off_axis`.
fn draw_one(domain: Domain, off_axis: bool, stream: &mut Stream) -> Complex64 {
    let mut within = |(min, max): (f64, f64)| min + (max - min) * stream.random::<f64>();
    let (re, im) = (within(domain.re), within(domain.im));
    let touches_axis = domain.im.0 <= 0.0 && domain.im.1 >= 0.0;
    Complex64::new(re, if touches_axis && !off_axis { 0.0 } else { im })
}

/// What was seen of a hop so far.
#[derive(Default)]
struct Tally {
    compared: usize,
    skipped: usize,
    digits: Option<f64>,
    last_singularity: String,
    settled: Option<Verdict>,
}

impl Tally {
    fn is_done(&self, points: usize) -> bool {
        self.settled.is_some() || self.compared >= points
    }

    fn look(
        &mut self,
        evaluation: &mut Evaluation<Tracked>,
        left: &Expr,
        right: &Expr,
        sample: &[(&Symbol, Complex64)],
        bits: usize,
    ) {
        let values = evaluation.value(left).and_then(|l| Ok((l, evaluation.value(right)?)));
        let (left, right) = match values {
            Ok(values) => values,
            Err(Unevaluable::Singular(face)) => {
                self.skipped += 1;
                self.last_singularity = face;
                return;
            }
            Err(other) => {
                self.settled = Some(Verdict::Unknown { why: other.to_string() });
                return;
            }
        };
        let Some(difference) = left.difference(&right) else {
            self.skipped += 1;
            return;
        };
        self.compared += 1;
        let all = bits as f64 * std::f64::consts::LOG10_2;
        let digits = (-difference.log10()).min(all);
        if difference <= ALLOWANCE * (-(bits as f64)).exp2() {
            self.digits = Some(self.digits.map_or(digits, |worst| worst.min(digits)));
        } else {
            let at = sample.iter().map(|(symbol, value)| (symbol.to_string(), text(*value))).collect();
            self.settled = Some(Verdict::Refuted { at, digits });
        }
    }

    fn verdict(self) -> Verdict {
        match (self.settled, self.digits) {
            (Some(verdict), _) => verdict,
            (None, Some(digits)) => Verdict::Agrees { points: self.compared, skipped: self.skipped, digits },
            (None, None) if self.skipped == 0 => Verdict::Unknown { why: "no point was asked for".to_owned() },
            (None, None) => Verdict::Unknown {
                why: format!("{} has no finite value at any of {} points", self.last_singularity, self.skipped),
            },
        }
    }
}

fn text(value: Complex64) -> String {
    match value.im {
        0.0 => value.re.to_string(),
        im if im < 0.0 => format!("{} − {}i", value.re, -im),
        im => format!("{} + {im}i", value.re),
    }
}
