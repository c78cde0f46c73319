//! One line of Unicode, for terminals.

use super::name::{Name, greek};
use super::pen::{Gap, Level, Pen, Sign, Written};
use crate::glyph::{self, subscript, superscript};
use crate::rational::Rational;
use crate::symbol::Rank;

#[derive(Clone, Copy)]
pub(super) struct Unicode;

/// A number in one piece: its digits, or its character.
pub(super) fn number(value: Rational) -> Option<String> {
    glyph::fraction(value).map(String::from).or_else(|| decimal(value))
}

impl Pen for Unicode {
    type Ink = String;
    const RAISES: bool = false;

    fn is_flat(self) -> bool {
        true
    }

    fn inner(self) -> Self {
        self
    }

    fn name(self, name: &Name, _rank: Rank) -> String {
        let letter = |word: &str| greek(word).map_or(word.to_owned(), |(letter, _)| letter.to_string());
        let index = match name.index {
            "" => String::new(),
            index => match greek(index) {
                Some((letter, _)) => format!("_{letter}"),
                None => subscript(index).unwrap_or_else(|| format!("_{index}")),
            },
        };
        format!("{}{index}{}", letter(name.base), "′".repeat(name.primes))
    }

    fn number(self, value: Rational) -> Written<Self> {
        match number(value) {
            Some(face) => (face, Level::Atom),
            None => (value.to_string(), Level::Slash),
        }
    }

    fn infix(self, sign: Sign) -> String {
        match sign {
            Sign::Plus => " + ",
            Sign::Minus => " − ",
            Sign::Times => " × ",
            Sign::Dot => "·",
            Sign::Cross => "×",
            Sign::Comma => ", ",
            Sign::Equal => " = ",
            Sign::Approximate => " ≈ ",
            Sign::Proportional => " ∝ ",
        }
        .to_owned()
    }

    fn prefix(self, mark: char) -> String {
        mark.to_string()
    }

    fn word(self, word: &str) -> String {
        word.to_owned()
    }

    fn apply(self) -> String {
        " ".to_owned()
    }

    fn gap(self, gap: Gap) -> String {
        if gap == Gap::Tight { String::new() } else { " ".to_owned() }
    }

    fn fraction(self, above: String, below: String) -> String {
        format!("{above}/{below}")
    }

    fn root(self, (of, level): Written<Self>) -> Written<Self> {
        if level == Level::Atom && !of.contains(['(', '|', '⟨']) {
            (format!("√{of}"), Level::Prefix)
        } else {
            (format!("√({of})"), Level::Prefix)
        }
    }

    fn exponential(self, of: String) -> Written<Self> {
        (format!("exp({of})"), Level::Atom)
    }

    fn raise(self, base: String, exponent: String) -> String {
        match superscript(&exponent) {
            Some(raised) => format!("{base}{raised}"),
            None if exponent == "*" => format!("{base}*"),
            None => format!("{base}^({exponent})"),
        }
    }

    fn exponent(self, value: Rational) -> String {
        value.to_string().replace('-', "−")
    }

    fn fence(self, open: char, inner: String, close: char) -> String {
        format!("{open}{inner}{close}")
    }

    fn integral(self, sign: char, bounds: Option<(String, Option<String>)>) -> String {
        let script = |mark, text: String, small: Option<String>| match small {
            Some(small) => small,
            None if text.chars().count() == 1 => format!("{mark}{text}"),
            None => format!("{mark}({text})"),
        };
        let Some((lower, upper)) = bounds else { return sign.to_string() };
        let small = subscript(&lower);
        let lower = script('_', lower, small);
        let upper = upper.map_or(String::new(), |upper| {
            let small = superscript(&upper);
            script('^', upper, small)
        });
        format!("{sign}{lower}{upper}")
    }

    fn row(self, parts: Vec<String>) -> String {
        parts.concat()
    }

    fn opens(self, face: &String) -> bool {
        face.starts_with('(')
    }
}

/// The digits of an integer or of a finite decimal (8.8542). Small fractions stay fractions: 3/2, 2/5.
pub(super) fn decimal(value: Rational) -> Option<String> {
    if let Some(n) = value.as_integer() {
        return Some(n.to_string());
    }
    if value.denominator() <= 10 {
        return None;
    }
    let places = (1..=18).find(|places| 10_i64.pow(*places) % value.denominator() == 0)?;
    let power = 10_i128.pow(places);
    let scaled = i128::from(value.numerator()) * (power / i128::from(value.denominator()));
    Some(format!("{}.{:0width$}", scaled / power, scaled % power, width = places as usize))
}
