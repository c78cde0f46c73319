//! Small characters: raised and lowered ones, and fractions that are one character. Units, faces and the reader
//! share them.

use super::rational::Rational;

/// `text` in raised characters, where every one of them exists.
pub(super) fn superscript(text: &str) -> Option<String> {
    text.chars().map(|c| RAISED.iter().find(|(plain, _)| *plain == c).map(|(_, raised)| *raised)).collect()
}

/// `text` in lowered characters, where every one of them exists.
pub(super) fn subscript(text: &str) -> Option<String> {
    text.chars().map(|c| LOWERED.iter().find(|(plain, _)| *plain == c).map(|(_, lowered)| *lowered)).collect()
}

/// What the raised or lowered character stands for, and whether it is raised.
pub(super) fn plain(small: char) -> Option<(char, bool)> {
    let find = |table: &[(char, char)]| table.iter().find(|(_, shifted)| *shifted == small).map(|(plain, _)| *plain);
    find(&RAISED).map(|c| (c, true)).or_else(|| find(&LOWERED).map(|c| (c, false)))
}

/// The fraction that a character such as ½ stands for.
pub(super) fn vulgar(glyph: char) -> Option<Rational> {
    let (numerator, denominator, _) = VULGAR.iter().find(|(.., known)| *known == glyph)?;
    Rational::new(*numerator, *denominator)
}

/// The character that stands for a fraction.
pub(super) fn fraction(value: Rational) -> Option<char> {
    let known = VULGAR.iter().find(|(n, d, _)| (*n, *d) == (value.numerator(), value.denominator()));
    known.map(|(.., glyph)| *glyph)
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
