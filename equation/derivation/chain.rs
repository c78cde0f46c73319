//! What an author writes: hypotheses and lines.

use crate::Equation;
use crate::expr::Expr;
use crate::hypothesis::{Given, Primitive};
use crate::symbol::Symbol;
use crate::units::Mismatch;
use std::borrow::Cow;

/// Hypotheses and lines.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chain {
    /// The hypotheses as substitutions, each naming the rule it comes from. They are triangular: none leads back
    /// to its own left side. Snell's law, for one, is n₁ := k sin θ₂, n₂ := k sin θ₁.
    pub given: Vec<Given>,
    /// What the premises among the lines are solved for; they are linear in these.
    pub unknowns: Vec<Symbol>,
    /// So many of the hypotheses the premises are solved under; where they do not suffice, under all.
    pub solved_under: usize,
    /// The antiderivatives that integrals are taken with.
    pub primitives: Vec<Primitive>,
    /// In order. A line that is an expression equals the end of the line before it; a line that is an equation
    /// holds by itself under the hypotheses and the premises.
    pub lines: Vec<Line>,
}

/// One line of a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it states.
    pub claim: Claim,
    /// The rules that lead to it, by name; none for a start.
    pub by: Vec<Cow<'static, str>>,
    /// Why, in words; may be empty.
    pub says: &'static str,
    /// How it comes to stand there.
    pub role: Role,
    /// The single steps that it sums up, where the program found it; may be empty.
    pub unfolded: Vec<Line>,
}

/// How a line comes to stand where it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Assumed: an equation that the rest follows from.
    Premise,
    /// Stated by the author.
    Stated,
    /// Stated by the author, who leaves it to the program to find the way there.
    Goal,
    /// Found by the program.
    Found,
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

impl Line {
    fn new(claim: impl Into<Claim>, by: &[&'static str], role: Role) -> Self {
        let by = by.iter().map(|&rule| rule.into()).collect();
        Self { claim: claim.into(), by, says: "", role, unfolded: Vec::new() }
    }
}

impl Chain {
    /// A chain that starts from an expression or an equation.
    pub fn new(start: impl Into<Claim>) -> Self {
        Self { lines: vec![Line::new(start, &[], Role::Stated)], ..Self::default() }
    }

    /// A chain that starts from what is assumed: the equation known as `by`.
    pub fn assume(equation: Equation, by: &'static str) -> Self {
        Self::default().and(equation, by)
    }

    /// With one more equation that is assumed, known as `by`.
    pub fn and(mut self, equation: Equation, by: &'static str) -> Self {
        self.lines.push(Line::new(equation, &[by], Role::Premise));
        self
    }

    /// With the premises solved for `unknowns`, in which they are linear: as many as there are premises. They are
    /// solved under the hypotheses given so far; those that follow are for the solution.
    pub fn solve_for<const N: usize>(mut self, unknowns: [Symbol; N]) -> Self {
        self.solved_under = self.given.len();
        self.unknowns.extend(unknowns);
        self
    }

    /// With the hypothesis `what` := `value`, known as `by`.
    pub fn given(mut self, what: impl Into<Expr>, value: impl Into<Expr>, by: &'static str) -> Self {
        self.given.push(Given { what: what.into(), value: value.into(), by });
        self
    }

    /// With the antiderivative `of` in `variable`.
    pub fn primitive(mut self, of: impl Into<Expr>, variable: Symbol) -> Self {
        self.primitives.push(Primitive { of: of.into(), variable });
        self
    }

    /// With one more line, which follows `by` these rules.
    pub fn then<const N: usize>(mut self, claim: impl Into<Claim>, by: [&'static str; N]) -> Self {
        self.lines.push(Line::new(claim, &by, Role::Stated));
        self
    }

    /// With one more line, to which the program finds the way.
    pub fn find(mut self, goal: impl Into<Claim>) -> Self {
        self.lines.push(Line::new(goal, &[], Role::Goal));
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
            Equation::new(&given.what, &given.value).dimension()?;
        }
        for (_, left, right) in self.pairs() {
            Equation::new(left, right).dimension()?;
        }
        Ok(())
    }

    /// What each line claims to be equal: its index and two expressions. A first expression claims nothing.
    pub(super) fn pairs(&self) -> Vec<(usize, &Expr, &Expr)> {
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
}
