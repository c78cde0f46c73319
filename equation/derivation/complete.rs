//! Goals reached: the lines that the author left to the program.

use super::atoms::Atoms;
use super::chain::{Chain, Claim, Line, Role};
use super::hypotheses::Hypotheses;
use crate::Equation;
use crate::expr::Expr;
use crate::find::{Step, find};
use crate::hypothesis::Given;

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
        Hypotheses::of(self, &Atoms::default()).map(|all| all.given).map_err(|refusal| refusal.why)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::derivation::Verdict;
    use crate::dimension::Dimension;
    use crate::expr::{cos, curl, sin, tan};
    use crate::find::RULES;
    use crate::symbol::Symbol;
    use crate::{Expr, ring};
    use yardstick::random;

    const A: Symbol = Symbol::scalar("a", Dimension::ONE);
    const B: Symbol = Symbol::scalar("b", Dimension::ONE);
    const X: Symbol = Symbol::scalar("x", Dimension::ONE);

    fn judge(chain: &Chain) -> Vec<Verdict> {
        chain.verify(6, 160, &mut random::stream(7, "complete")).into_iter().map(|hop| hop.verdict).collect()
    }

    /// What a found line is known by is true, symbol by symbol.
    #[test]
    fn every_rule_of_the_finder_is_proved() {
        for rule in RULES {
            for (left, right) in (rule.examples)() {
                assert_eq!(ring::equal(&left, &right), Ok(true), "{}: {left} = {right}", rule.name);
            }
        }
    }

    #[test]
    fn fills_in_the_lines_that_the_author_left_out() {
        let chain = Chain::assume(Equation::new(A * cos(X), B * sin(X)), "balance")
            .find(Equation::new(A / B, tan(X)))
            .because("the ratio")
            .complete();
        assert!(chain.lines.len() > 1 && judge(&chain).iter().all(|verdict| *verdict == Verdict::Proved), "{chain:?}");
        let last = chain.lines.last().unwrap();
        assert_eq!((last.role, last.says), (Role::Goal, "the ratio"));
        let known = |by: &str| {
            by.starts_with("balance")
                || RULES.iter().any(|rule| {
                    by.starts_with(rule.name) || by.starts_with(rule.reverse) || by == "simplify" || by == "rearrange"
                })
        };
        assert!(chain.lines.iter().flat_map(|line| &line.by).all(|by| known(by)), "{chain:?}");
    }

    /// What is beyond the search is still decided; what is false is still refuted.
    #[test]
    fn leaves_a_goal_without_a_way_to_the_decider() {
        let field = Symbol::vector("E", Dimension::VOLT_PER_METRE).field();
        let vectors = Chain::new(curl(2 * Expr::from(&field))).find(2 * curl(&field)).complete();
        assert_eq!((&vectors.lines[1].by[..], judge(&vectors)), (&["identity".into()][..], vec![Verdict::Proved]));
        let slip = Chain::new(sin(2 * X)).find(2 * sin(X)).complete();
        assert!(matches!(judge(&slip)[..], [Verdict::Refuted { .. }]));
    }
}
