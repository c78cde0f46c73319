//! Faces of a phrase: a line of Unicode for terminals, runs of two heights for plots.

use super::{Held, Phrase, Piece, Script};
use std::fmt;

/// Where an index or a power stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shift {
    /// Below the line.
    Lowered,
    /// Above it.
    Raised,
}

/// A stretch of text on one baseline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// What is written.
    pub text: String,
    /// How its baseline was reached from that of the phrase, step by step; each step is set smaller.
    pub shifts: Vec<Shift>,
}

impl Phrase {
    /// The phrase as runs, left to right.
    pub fn runs(&self) -> Vec<Run> {
        let mut runs = Vec::new();
        self.run(&mut Vec::new(), &mut runs);
        runs
    }

    fn run(&self, shifts: &mut Vec<Shift>, runs: &mut Vec<Run>) {
        for piece in &self.0 {
            match piece {
                Piece::Plain(text) => append(runs, shifts, text),
                Piece::Symbol { base, scripts } => {
                    append(runs, shifts, base);
                    for script in scripts {
                        shifts.push(script.shift);
                        script.of.run(shifts, runs);
                        shifts.pop();
                    }
                }
                Piece::Number { factor, power } => {
                    append(runs, shifts, &ten(factor));
                    shifts.push(Shift::Raised);
                    append(runs, shifts, power);
                    shifts.pop();
                }
                Piece::Emphasis(of) | Piece::Strong(of) | Piece::Code(of) => of.run(shifts, runs),
            }
        }
    }
}

fn append(runs: &mut Vec<Run>, shifts: &[Shift], text: &str) {
    match runs.last_mut() {
        Some(last) if last.shifts == shifts => last.text.push_str(text),
        _ => runs.push(Run { text: text.to_owned(), shifts: shifts.to_vec() }),
    }
}

/// What stands before a power of ten.
fn ten(factor: &str) -> String {
    if factor.is_empty() { "10".to_owned() } else { format!("{factor}·10") }
}

/// One line of Unicode: scripts in its own small letters where it has them all, otherwise as they were written.
impl fmt::Display for Phrase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|piece| piece.fmt(f))
    }
}

impl fmt::Display for Piece {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Plain(text) => f.write_str(text),
            Self::Symbol { base, scripts } => {
                f.write_str(base)?;
                scripts.iter().try_for_each(|script| script.fmt(f))
            }
            Self::Number { factor, power } => {
                f.write_str(&ten(factor))?;
                f.write_str(&shifted(power, Shift::Raised).unwrap_or_else(|| format!("^{power}")))
            }
            Self::Emphasis(of) | Self::Strong(of) | Self::Code(of) => of.fmt(f),
        }
    }
}

impl fmt::Display for Script {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = self.of.to_string();
        let mark = if self.shift == Shift::Lowered { '_' } else { '^' };
        match (self.held, shifted(&of, self.shift)) {
            (Held::Alone | Held::Braces, Some(small)) => f.write_str(&small),
            (Held::Alone, None) => write!(f, "{mark}{of}"),
            (Held::Braces, None) => write!(f, "{mark}{{{of}}}"),
            (Held::Brackets, _) => write!(f, "{mark}({of})"),
        }
    }
}

/// `text` in small letters, if Unicode has them all.
fn shifted(text: &str, shift: Shift) -> Option<String> {
    let small = |letter| small(letter).map(|[lowered, raised]| if shift == Shift::Lowered { lowered } else { raised });
    text.chars().map(small).collect()
}

/// The lowered and the raised form of a letter, if Unicode has them.
pub fn small(letter: char) -> Option<[char; 2]> {
    const PLAIN: &str = "0123456789+−=()aehijklmnoprstuvx";
    const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ";
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ᵃᵉʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛˣ";
    let at = PLAIN.chars().position(|plain| plain == letter)?;
    Some([LOWERED.chars().nth(at)?, RAISED.chars().nth(at)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_say_how_they_were_reached() {
        let runs = Phrase::parse("x_{b^2} + 1e-6").runs();
        let found: Vec<_> = runs.iter().map(|run| (run.text.as_str(), run.shifts.as_slice())).collect();
        use Shift::{Lowered, Raised};
        assert_eq!(
            found,
            [("x", &[][..]), ("b", &[Lowered]), ("2", &[Lowered, Raised]), (" + 10", &[]), ("−6", &[Raised])]
        );
    }
}
