//! Lines of Unicode for terminals, with fractions of two storeys.

use super::name::Name;
use super::pen::{Gap, Level, Pen, Sign, Written};
use super::unicode::{self, Unicode};
use crate::glyph::{subscript, superscript};
use crate::rational::Rational;
use crate::symbol::Rank;

/// A rectangle of text: rows of the same width, one of which is level with what stands beside it. Every character is
/// one column wide.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    rows: Vec<String>,
    width: usize,
    baseline: usize,
}

impl Block {
    /// From top to bottom, padded to one width.
    pub fn rows(&self) -> &[String] {
        &self.rows
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The row, counted from the top, that is level with what stands beside it.
    pub fn baseline(&self) -> usize {
        self.baseline
    }

    /// It and `right`, level with each other.
    pub fn beside(self, right: Self) -> Self {
        Self::join(&[self, right])
    }

    /// All of `parts` from left to right.
    fn join(parts: &[Self]) -> Self {
        let above = parts.iter().map(|part| part.baseline).max().unwrap_or(0);
        let below = parts.iter().map(|part| part.rows.len() - part.baseline - 1).max().unwrap_or(0);
        let mut rows = vec![String::new(); above + 1 + below];
        let mut width = 0;
        for part in parts {
            // A bar that touched a minus sign would swallow it.
            let touches = rows[above].ends_with(['−', BAR]) && part.rows[part.baseline].starts_with(BAR);
            let top = above - part.baseline;
            for (at, row) in rows.iter_mut().enumerate() {
                pad(row, usize::from(touches));
                match at.checked_sub(top).and_then(|at| part.rows.get(at)) {
                    Some(piece) => row.push_str(piece),
                    None => pad(row, part.width),
                }
            }
            width += usize::from(touches) + part.width;
        }
        Self { rows, width, baseline: above }
    }

    /// All of `parts` from top to bottom, centred; level with its surroundings is the part `at`.
    fn stack(parts: &[Self], at: usize) -> Self {
        let width = parts.iter().map(|part| part.width).max().unwrap_or(0);
        let rows = parts.iter().flat_map(|part| part.rows.iter().map(move |row| (part, row)));
        let rows = rows.map(|(part, row)| {
            let mut line = String::new();
            pad(&mut line, (width - part.width) / 2);
            line.push_str(row);
            pad(&mut line, (width - part.width).div_ceil(2));
            line
        });
        let before: usize = parts[..at].iter().map(|part| part.rows.len()).sum();
        Self { rows: rows.collect(), width, baseline: before + parts[at].baseline }
    }

    /// One column as tall as `self`, made of `top`, `middle` and `bottom`.
    fn column(&self, top: char, middle: char, bottom: char) -> Self {
        let last = self.rows.len() - 1;
        let mark = |at| match at {
            0 => top,
            _ if at == last => bottom,
            _ => middle,
        };
        Self { rows: (0..=last).map(|at| mark(at).to_string()).collect(), width: 1, baseline: self.baseline }
    }

    /// A bracket as tall as `self`.
    fn bracket(&self, bracket: char) -> Self {
        match bracket {
            _ if self.is_line() => bracket.to_string().into(),
            '(' => self.column('⎛', '⎜', '⎝'),
            ')' => self.column('⎞', '⎟', '⎠'),
            '⟨' => self.column('╱', '⟨', '╲'),
            '⟩' => self.column('╲', '⟩', '╱'),
            _ => self.column('│', '│', '│'),
        }
    }

    fn is_line(&self) -> bool {
        self.rows.len() == 1
    }

    fn into_line(mut self) -> String {
        self.rows.swap_remove(self.baseline)
    }
}

impl From<String> for Block {
    /// One row.
    fn from(row: String) -> Self {
        Self { width: row.chars().count(), rows: vec![row], baseline: 0 }
    }
}

impl std::fmt::Display for Block {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(&self.rows.join("\n"))
    }
}

fn pad(row: &mut String, columns: usize) {
    row.extend(std::iter::repeat_n(' ', columns));
}

/// What fraction bars are made of.
const BAR: char = '─';

/// Draws fractions with a bar; on one line only inside one, or in an exponent.
#[derive(Clone, Copy)]
pub(super) struct Stacked {
    inside: bool,
}

impl Stacked {
    pub fn new() -> Self {
        Self { inside: false }
    }
}

fn bar(width: usize) -> Block {
    String::from_iter(std::iter::repeat_n(BAR, width)).into()
}

impl Pen for Stacked {
    type Ink = Block;
    const RAISES: bool = false;

    fn is_flat(self) -> bool {
        self.inside
    }

    fn inner(self) -> Self {
        Self { inside: true }
    }

    fn name(self, name: &Name, rank: Rank) -> Block {
        Unicode.name(name, rank).into()
    }

    fn number(self, value: Rational) -> Written<Self> {
        match unicode::number(value) {
            None if !self.inside => {
                let part = |n: i64| Block::from(n.to_string());
                (self.fraction(part(value.numerator()), part(value.denominator())), Level::Script)
            }
            _ => {
                let (face, level) = Unicode.number(value);
                (face.into(), level)
            }
        }
    }

    fn infix(self, sign: Sign) -> Block {
        Unicode.infix(sign).into()
    }

    fn prefix(self, mark: char) -> Block {
        Unicode.prefix(mark).into()
    }

    fn word(self, word: &str) -> Block {
        Unicode.word(word).into()
    }

    fn apply(self) -> Block {
        Unicode.apply().into()
    }

    fn gap(self, gap: Gap) -> Block {
        Unicode.gap(gap).into()
    }

    fn fraction(self, above: Block, below: Block) -> Block {
        if self.inside {
            return Unicode.fraction(above.into_line(), below.into_line()).into();
        }
        let bar = bar(above.width.max(below.width));
        Block::stack(&[above, bar, below], 1)
    }

    fn root(self, (of, level): Written<Self>) -> Written<Self> {
        if of.is_line() {
            let (face, level) = Unicode.root((of.into_line(), level));
            return (face.into(), level);
        }
        let vinculum = Block::from("┌".to_owned()).beside(bar(of.width + 1));
        let last = of.rows.len() - 1;
        let tick = |at| if at == last { "╲" } else { " " }.to_owned();
        let tick = Block { rows: (0..=last).map(tick).collect(), width: 1, baseline: of.baseline };
        let gap = of.column(' ', ' ', ' ');
        let body = Block::join(&[of.column('│', '│', '│'), gap, of]);
        (tick.beside(Block::stack(&[vinculum, body], 1)), Level::Prefix)
    }

    fn exponential(self, of: Block) -> Written<Self> {
        (self.word("exp").beside(self.fence('(', of, ')')), Level::Atom)
    }

    fn raise(self, base: Block, exponent: Block) -> Block {
        if base.is_line() {
            return Unicode.raise(base.into_line(), exponent.into_line()).into();
        }
        let exponent = exponent.into_line();
        // Small characters stand beside the top row, others above it.
        let (face, lift) = match superscript(&exponent) {
            Some(small) => (small, 0),
            None if exponent == "*" => (exponent, 0),
            None => (exponent, 1),
        };
        let mut raised = Block::from(face);
        raised.baseline = base.baseline + lift;
        raised.rows.resize(raised.baseline + 1, " ".repeat(raised.width));
        base.beside(raised)
    }

    fn exponent(self, value: Rational) -> Block {
        Unicode.exponent(value).into()
    }

    fn fence(self, open: char, inner: Block, close: char) -> Block {
        Block::join(&[inner.bracket(open), inner.clone(), inner.bracket(close)])
    }

    fn integral(self, sign: char, bounds: Option<(Block, Option<Block>)>) -> Block {
        let small = |lower: &Block, upper: Option<&Block>| {
            let lowered = subscript(&lower.rows[0]).is_some();
            lowered && upper.is_none_or(|upper| superscript(&upper.rows[0]).is_some())
        };
        match bounds {
            Some((lower, upper)) if !self.inside && !small(&lower, upper.as_ref()) => {
                let parts: Vec<_> = upper.into_iter().chain([sign.to_string().into(), lower]).collect();
                let at = parts.len() - 2;
                Block::stack(&parts, at)
            }
            bounds => {
                let line = |(lower, upper): (Block, Option<Block>)| (lower.into_line(), upper.map(Block::into_line));
                Unicode.integral(sign, bounds.map(line)).into()
            }
        }
    }

    fn row(self, parts: Vec<Block>) -> Block {
        Block::join(&parts)
    }

    fn opens(self, face: &Block) -> bool {
        face.rows[0].starts_with(['(', '⎛'])
    }
}

#[cfg(test)]
mod tests {
    use crate::Symbol;
    use crate::dimension::Dimension;
    use crate::parse::{parse, parse_equation};

    /// The layout of `text`, but for the space at the ends of rows.
    fn draws(text: &str, rows: &[&str]) {
        let known = [Symbol::vector("E", Dimension::ONE), Symbol::scalar("f", Dimension::ONE)];
        let block = match parse(text, &known) {
            Ok(expr) => expr.layout(),
            Err(_) => parse_equation(text, &known).unwrap().layout(),
        };
        let drawn: Vec<_> = block.rows().iter().map(|row| row.trim_end()).collect();
        assert_eq!(drawn, rows, "\n{block}");
    }

    #[test]
    fn fractions_have_two_storeys_and_what_surrounds_them_fits() {
        draws(
            "r_p = tan(theta_1 - theta_2)/tan(theta_1 + theta_2)",
            &["     tan(θ₁ − θ₂)", "rₚ = ────────────", "     tan(θ₁ + θ₂)"],
        );
        draws("-sin(θ₁ − θ₂)/sin(θ₁ + θ₂)", &["  sin(θ₁ − θ₂)", "− ────────────", "  sin(θ₁ + θ₂)"]);
        draws("T = (n₂ cos θ₂/(n₁ cos θ₁)) t²", &["    n₂ cos θ₂", "T = ───────── t²", "    n₁ cos θ₁"]);
        draws(
            "½(sin²(θ₁ − θ₂)/sin²(θ₁ + θ₂) + 1)",
            &[" ⎛sin²(θ₁ − θ₂)    ⎞", "½⎜───────────── + 1⎟", " ⎝sin²(θ₁ + θ₂)    ⎠"],
        );
        draws("√(μ/ε) + 1", &[" ┌──", " │ μ", " │ ─ + 1", "╲│ ε"]);
        draws("∂²E/∂t² − (a/b)^(3/2)", &["         3/2", "∂²E   ⎛a⎞", "─── − ⎜─⎟", "∂t²   ⎝b⎠"]);
        draws(
            "exp(i (k z - t/2)) (1 + x/y)^2",
            &["                 ⎛    x⎞²", "exp(i(kz − t/2)) ⎜1 + ─⎟", "                 ⎝    y⎠"],
        );
        draws("(1/T) ∫_0^T |E| dt", &["1", "─ ∫₀ᵀ |E| dt", "T"]);
        draws("∫_0^(π/2) cos θ dθ", &["π/2", " ∫  cos θ dθ", " 0"]);
        draws("(a/b)/(1 + c/d)", &["  a/b", "───────", "1 + c/d"]);
        draws("|f(x/y)|", &["│ ⎛x⎞│", "│f⎜─⎟│", "│ ⎝y⎠│"]);
        draws("x + (3/2) y", &["    3", "x + ─ y", "    2"]);
        draws("∂(∇×E)/∂t", &["∂", "──(∇×E)", "∂t"]);
        draws("2πr (1 − cos θ₁)²", &["2πr (1 − cos θ₁)²"]);
    }
}
