//! LaTeX for math mode; plain amsmath, which KaTeX and MathJax also read.

use super::name::{Name, greek};
use super::pen::{Gap, Level, Pen, Sign, Written};
use super::unicode::decimal;
use crate::rational::Rational;
use crate::symbol::Rank;

#[derive(Clone, Copy)]
pub(super) struct Latex;

fn letters(word: &str) -> String {
    match greek(word) {
        Some((_, command)) => command.to_owned(),
        None if word.chars().count() > 1 && word.chars().all(char::is_alphabetic) => format!(r"\mathrm{{{word}}}"),
        None => word.to_owned(),
    }
}

impl Pen for Latex {
    type Ink = String;
    const RAISES: bool = true;

    fn is_flat(self) -> bool {
        false
    }

    fn inner(self) -> Self {
        self
    }

    fn name(self, name: &Name, rank: Rank) -> String {
        let base = letters(name.base);
        let base = match rank {
            Rank::Scalar => base,
            Rank::Vector => format!(r"\boldsymbol{{{base}}}"),
        };
        let index = if name.index.is_empty() { String::new() } else { format!("_{{{}}}", letters(name.index)) };
        format!("{base}{index}{}", "'".repeat(name.primes))
    }

    fn number(self, value: Rational) -> Written<Self> {
        match decimal(value) {
            Some(digits) => (digits, Level::Atom),
            None => (format!(r"\tfrac{{{}}}{{{}}}", value.numerator(), value.denominator()), Level::Script),
        }
    }

    fn infix(self, sign: Sign) -> String {
        match sign {
            Sign::Plus => " + ",
            Sign::Minus => " - ",
            Sign::Times | Sign::Cross => r" \times ",
            Sign::Dot => r" \cdot ",
            Sign::Comma => ", ",
            Sign::Equal => " = ",
            Sign::Approximate => r" \approx ",
            Sign::Proportional => r" \propto ",
        }
        .to_owned()
    }

    fn prefix(self, mark: char) -> String {
        match mark {
            '∇' => r"\nabla ".to_owned(),
            '∂' => r"\partial ".to_owned(),
            'd' => r"\mathrm{d}".to_owned(),
            '−' => "-".to_owned(),
            other => other.to_string(),
        }
    }

    fn word(self, word: &str) -> String {
        match word {
            "i" => r"\mathrm{i}".to_owned(),
            "*" => word.to_owned(),
            "Re" | "Im" => format!(r"\operatorname{{{word}}}"),
            _ => format!(r"\{word}"),
        }
    }

    fn apply(self) -> String {
        " ".to_owned()
    }

    fn gap(self, gap: Gap) -> String {
        // TeX spaces factors by itself; only a differential needs help.
        if gap == Gap::Differential { r" \, " } else { " " }.to_owned()
    }

    fn fraction(self, above: String, below: String) -> String {
        format!(r"\frac{{{above}}}{{{below}}}")
    }

    fn root(self, (of, _): Written<Self>) -> Written<Self> {
        (format!(r"\sqrt{{{of}}}"), Level::Atom)
    }

    fn exponential(self, of: String) -> Written<Self> {
        (format!(r"\mathrm{{e}}^{{{of}}}"), Level::Script)
    }

    fn raise(self, base: String, exponent: String) -> String {
        // TeX merges a prime with an exponent only where nothing stands between; braces settle it.
        if base.ends_with('\'') {
            format!("{{{base}}}^{{{exponent}}}")
        } else {
            format!("{}^{{{exponent}}}", base.trim_end())
        }
    }

    fn exponent(self, value: Rational) -> String {
        value.to_string()
    }

    fn fence(self, open: char, inner: String, close: char) -> String {
        let command = |bracket| match bracket {
            '⟨' => r"\langle ",
            '⟩' => r" \rangle",
            '|' => "|",
            '(' => "(",
            _ => ")",
        };
        let is_tall = [r"\frac", r"\int", r"\oint", r"\sqrt"].iter().any(|tall| inner.contains(tall));
        match (open, is_tall) {
            (_, true) => format!(r"\left{} {inner} \right{}", command(open).trim(), command(close).trim()),
            ('|', false) => format!(r"\lvert {inner} \rvert"),
            (_, false) => format!("{}{inner}{}", command(open), command(close)),
        }
    }

    fn integral(self, sign: char, bounds: Option<(String, Option<String>)>) -> String {
        let sign = if sign == '∮' { r"\oint" } else { r"\int" };
        match bounds {
            None => sign.to_owned(),
            Some((lower, None)) => format!("{sign}_{{{lower}}}"),
            Some((lower, Some(upper))) => format!("{sign}_{{{lower}}}^{{{upper}}}"),
        }
    }

    fn row(self, parts: Vec<String>) -> String {
        // Marks bring the spaces that end a command; two in a row are no use.
        parts.concat().replace("  ", " ")
    }

    fn opens(self, face: &String) -> bool {
        face.starts_with('(')
    }
}
