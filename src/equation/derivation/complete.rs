//! Goals reached: the lines that the author left to the program.

use super::judge::{Atoms, Hypotheses};
use super::{Chain, Claim, Given, Line, Role};
use crate::equation::Equation;
use crate::equation::expr::Expr;
use crate::equation::find::{Step, find};

impl Chain {
    /// The same chain with the lines that lead to its goals, as far as they are found. A goal without them stands as
    /// an identity: whether it holds is for [`Chain::verify`] to say, as of every other line.
    pub fn complete(&self) -> Self {
        if self.lines.iter().all(|line| line.role != Role::Goal) {
            return self.clone();
        }
        let hypotheses = Hypotheses::of(self, &Atoms::default()).map_or_else(|_| self.given.clone(), |all| all.given);
        let mut lines: Vec<Line> = Vec::new();
        for line in &self.lines {
            if line.role == Role::Goal {
                lines.extend(reach(line, lines.last(), &hypotheses));
            } else {
                lines.push(line.clone());
            }
        }
        Self { lines, ..self.clone() }
    }

    /// The hypotheses as substitutions: those given, and what the premises say of their symbols.
    ///
    /// # Errors
    /// Why the premises cannot be solved, or never hold.
    pub fn hypotheses(&self) -> Result<Vec<Given>, String> {
        Hypotheses::of(self, &Atoms::default()).map(|all| all.given)
    }
}

/// The lines that lead to `goal` from its own left side, or from the end of the line before it.
fn reach(goal: &Line, before: Option<&Line>, given: &[Given]) -> Vec<Line> {
    let (start, end) = match (&goal.claim, before.map(|line| &line.claim)) {
        (Claim::Equation(equation), _) => (&equation.lhs, &equation.rhs),
        (Claim::Expr(end), Some(Claim::Expr(start) | Claim::Equation(Equation { rhs: start, .. }))) => (start, end),
        (Claim::Expr(_), None) => return vec![goal.clone()],
    };
    let Ok(found) = find(start, end, given) else {
        return vec![Line { by: vec!["identity".into()], ..goal.clone() }];
    };
    let mut lines: Vec<Line> = found.steps.into_iter().map(found_line).collect();
    if let Some(last) = lines.last_mut() {
        last.role = Role::Goal;
        last.says = goal.says;
    }
    if let (Claim::Equation(_), Some(first)) = (&goal.claim, lines.first_mut())
        && let Claim::Expr(end) = &first.claim
    {
        first.claim = Equation::new(start, end).into();
    }
    lines
}

fn found_line(step: Step) -> Line {
    let unfolded = step.unfolded.into_iter().map(found_line).collect();
    Line { claim: Claim::Expr(Expr::clone(&step.expr)), by: step.by, says: "", role: Role::Found, unfolded }
}
