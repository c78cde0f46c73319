//! One line of Unicode, for terminals.

use super::name::{Name, greek};
use super::{Gap, Level, Pen, Rank, Rational, Sign, Written};

#[derive(Clone, Copy)]
pub(super) struct Unicode;

/// `text` in raised characters, where every one of them exists.
pub(in super::super) fn superscript(text: &str) -> Option<String> {
    text.chars().map(|c| RAISED.iter().find(|(plain, _)| *plain == c).map(|(_, raised)| *raised)).collect()
}

/// `text` in lowered characters, where every one of them exists.
pub(super) fn subscript(text: &str) -> Option<String> {
    text.chars().map(|c| LOWERED.iter().find(|(plain, _)| *plain == c).map(|(_, lowered)| *lowered)).collect()
}

/// What the raised or lowered character stands for, and whether it is raised.
pub(in super::super) fn plain(small: char) -> Option<(char, bool)> {
    let find = |table: &[(char, char)]| table.iter().find(|(_, shifted)| *shifted == small).map(|(plain, _)| *plain);
    find(&RAISED).map(|c| (c, true)).or_else(|| find(&LOWERED).map(|c| (c, false)))
}

/// The fraction that a character such as ½ stands for.
pub(in super::super) fn vulgar(glyph: char) -> Option<Rational> {
    let (numerator, denominator, _) = VULGAR.iter().find(|(.., known)| *known == glyph)?;
    Rational::new(*numerator, *denominator)
}

/// A number in one piece: its digits, or its character.
pub(super) fn number(value: Rational) -> Option<String> {
    let vulgar = VULGAR.iter().find(|(n, d, _)| (*n, *d) == (value.numerator(), value.denominator()));
    vulgar.map(|(.., glyph)| glyph.to_string()).or_else(|| decimal(value))
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

const VULGAR: [(i64, i64, char); 12] = [
    (1, 2, '½'),
    (1, 3, '⅓'),
    (2, 3, '⅔'),
    (1, 4, '¼'),
    (3, 4, '¾'),
    (1, 5, '⅕'),
    (1, 6, '⅙'),
    (5, 6, '⅚'),
    (1, 8, '⅛'),
    (3, 8, '⅜'),
    (5, 8, '⅝'),
    (7, 8, '⅞'),
];

const RAISED: [(char, char); 20] = [
    ('0', '⁰'),
    ('1', '¹'),
    ('2', '²'),
    ('3', '³'),
    ('4', '⁴'),
    ('5', '⁵'),
    ('6', '⁶'),
    ('7', '⁷'),
    ('8', '⁸'),
    ('9', '⁹'),
    ('+', '⁺'),
    ('-', '⁻'),
    ('−', '⁻'),
    ('n', 'ⁿ'),
    ('i', 'ⁱ'),
    ('T', 'ᵀ'),
    ('N', 'ᴺ'),
    ('a', 'ᵃ'),
    ('b', 'ᵇ'),
    ('k', 'ᵏ'),
];

const LOWERED: [(char, char); 30] = [
    ('0', '₀'),
    ('1', '₁'),
    ('2', '₂'),
    ('3', '₃'),
    ('4', '₄'),
    ('5', '₅'),
    ('6', '₆'),
    ('7', '₇'),
    ('8', '₈'),
    ('9', '₉'),
    ('+', '₊'),
    ('-', '₋'),
    ('−', '₋'),
    ('a', 'ₐ'),
    ('e', 'ₑ'),
    ('h', 'ₕ'),
    ('i', 'ᵢ'),
    ('j', 'ⱼ'),
    ('k', 'ₖ'),
    ('l', 'ₗ'),
    ('m', 'ₘ'),
    ('n', 'ₙ'),
    ('o', 'ₒ'),
    ('p', 'ₚ'),
    ('r', 'ᵣ'),
    ('s', 'ₛ'),
    ('t', 'ₜ'),
    ('u', 'ᵤ'),
    ('v', 'ᵥ'),
    ('x', 'ₓ'),
];
