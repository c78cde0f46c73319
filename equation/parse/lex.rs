//! From characters to tokens: numbers, names and signs.

use super::fault::{Fault, fault};
use crate::dimension::Dimension;
use crate::expr::Function;
use crate::face::{greek_name, is_greek, spells};
use crate::glyph::{plain, vulgar};
use crate::rational::Rational;
use crate::symbol::Symbol;
use std::collections::BTreeMap;

/// What a name stands for of which nothing is known: a positive number, of dimension one.
pub(super) const UNKNOWN: Symbol = Symbol::scalar("", Dimension::ONE).real(0.1, 4.0);

/// The least piece of meaning.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    Number(Rational),
    /// A quantity, and whether it was known beforehand.
    Name(Symbol, bool),
    Function(Function),
    Pi,
    ImaginaryUnit,
    /// e, the base of exponentials.
    Euler,
    /// The d before a variable.
    Differential,
    /// Raised characters, as plain ones.
    Raised(String),
    /// Lowered characters that are no index, as plain ones.
    Lowered(String),
    /// A bracket of any form, by the form that closes it.
    Open(char),
    Close(char),
    /// One of + − * · × / ^ | , = ≈ ∝ √ ∇ ∂ ∫ ∮ _
    Sign(char),
    End,
}

#[derive(Clone, Debug)]
pub(super) struct Token {
    pub kind: Kind,
    /// Its first character, counted from 0.
    pub at: usize,
    /// Whether space stands before it. The end counts as space.
    pub spaced: bool,
}

/// Words for functions, as they may be typed.
const FUNCTIONS: [(&str, Function); 15] = [
    ("sin", Function::Sin),
    ("cos", Function::Cos),
    ("tan", Function::Tan),
    ("asin", Function::Asin),
    ("acos", Function::Acos),
    ("atan", Function::Atan),
    ("arcsin", Function::Asin),
    ("arccos", Function::Acos),
    ("arctan", Function::Atan),
    ("exp", Function::Exp),
    ("sqrt", Function::Sqrt),
    ("conj", Function::Conj),
    ("abs", Function::Abs),
    ("Re", Function::Re),
    ("Im", Function::Im),
];

/// Functions that people expect and the language lacks, with a way to say them where there is one.
const LACKING: [(&str, &str); 14] = [
    ("re", ": write Re(z)"),
    ("im", ": write Im(z)"),
    ("cot", ": write 1/tan(x)"),
    ("sec", ": write 1/cos(x)"),
    ("csc", ": write 1/sin(x)"),
    ("sinh", ": write (exp(x) − exp(−x))/2"),
    ("cosh", ": write (exp(x) + exp(−x))/2"),
    ("tanh", ": write it with exp"),
    ("cis", ": write exp(i x)"),
    ("ln", ""),
    ("log", ""),
    ("arg", ""),
    ("max", ""),
    ("min", ""),
];

/// The longest word of unknown letters that is taken for their product.
const LONGEST_PRODUCT: usize = 3;

pub(super) fn function(word: &str) -> Option<Function> {
    FUNCTIONS.iter().find(|(name, _)| *name == word).map(|(_, function)| *function)
}

pub(super) struct Lexer<'a> {
    text: Vec<char>,
    known: &'a BTreeMap<&'a str, &'a Symbol>,
    /// The character to read next.
    at: usize,
    tokens: Vec<Token>,
}

/// What follows the letters of a name.
struct Suffix {
    index: String,
    primes: usize,
}

impl<'a> Lexer<'a> {
    /// The tokens of `text`, the last of which is [`Kind::End`].
    pub fn read(text: Vec<char>, known: &'a BTreeMap<&'a str, &'a Symbol>) -> Result<Vec<Token>, Fault> {
        let mut lexer = Self { text, known, at: 0, tokens: Vec::new() };
        loop {
            let before = lexer.at;
            lexer.run(|c| c.is_whitespace());
            let (at, spaced) = (lexer.at, lexer.at > before || lexer.at == 0);
            let first = lexer.tokens.len();
            let ended = lexer.token()?;
            if let Some(token) = lexer.tokens.get_mut(first) {
                token.spaced = spaced || ended;
            }
            debug_assert!(ended || lexer.at > at, "every token takes a character");
            if ended {
                return Ok(lexer.tokens);
            }
        }
    }

    fn peek(&self, ahead: usize) -> Option<char> {
        self.text.get(self.at + ahead).copied()
    }

    fn push(&mut self, at: usize, kind: Kind) {
        self.tokens.push(Token { kind, at, spaced: false });
    }

    /// Takes the characters that `fits`.
    fn run(&mut self, fits: impl Fn(char) -> bool) -> String {
        let start = self.at;
        while self.peek(0).is_some_and(&fits) {
            self.at += 1;
        }
        self.text[start..self.at].iter().collect()
    }

    /// Reads one token, or the few that a word consists of; whether that was the end.
    fn token(&mut self) -> Result<bool, Fault> {
        let at = self.at;
        let Some(c) = self.peek(0) else {
            self.push(at, Kind::End);
            return Ok(true);
        };
        if c.is_ascii_digit() || c == '.' {
            let number = self.number()?;
            self.push(at, Kind::Number(number));
        } else if let Some((_, raised)) = plain(c) {
            let of_kind = |c| plain(c).filter(|(_, kind)| *kind == raised);
            let text = self.run(|c| of_kind(c).is_some()).chars().filter_map(of_kind).map(|(plain, _)| plain).collect();
            self.push(at, if raised { Kind::Raised(text) } else { Kind::Lowered(text) });
        } else if is_letter(c) {
            self.word()?;
        } else {
            self.at += 1;
            let kind = match c {
                '(' => Kind::Open(')'),
                '[' => Kind::Open(']'),
                '{' => Kind::Open('}'),
                '⟨' => Kind::Open('⟩'),
                ')' | ']' | '}' | '⟩' => Kind::Close(c),
                '*' if self.peek(0) == Some('*') => {
                    self.at += 1;
                    Kind::Sign('^')
                }
                '-' | '−' => Kind::Sign('−'),
                '⋅' => Kind::Sign('·'),
                '∗' => Kind::Sign('*'),
                '+' | '*' | '·' | '×' | '/' | '^' | '|' | ',' | '=' | '≈' | '∝' | '√' | '∇' | '∂' | '∫' | '∮' | '_' => {
                    Kind::Sign(c)
                }
                _ => match vulgar(c) {
                    Some(value) => Kind::Number(value),
                    None => return Err(fault(at, format!("expected a number, a name or a sign, found `{c}`"))),
                },
            };
            self.push(at, kind);
        }
        Ok(false)
    }

    fn number(&mut self) -> Result<Rational, Fault> {
        let at = self.at;
        let whole = self.run(|c| c.is_ascii_digit());
        let decimals = if self.peek(0) == Some('.') {
            self.at += 1;
            self.run(|c| c.is_ascii_digit())
        } else {
            String::new()
        };
        let written: String = self.text[at..self.at].iter().collect();
        if self.peek(0) == Some('.') || written.ends_with('.') {
            return Err(fault(self.at, "expected digits, as in 0.25"));
        }
        let power = match (self.peek(0), self.peek(1), self.peek(2)) {
            (Some('e' | 'E'), Some(c), _) if c.is_ascii_digit() => true,
            (Some('e' | 'E'), Some('+' | '-' | '−'), Some(c)) => c.is_ascii_digit(),
            _ => false,
        };
        if power {
            return Err(fault(self.at, format!("a power of ten is written {written} × 10^n")));
        }
        let value = || {
            let digits: i64 = format!("{whole}{decimals}").parse().ok()?;
            Rational::new(digits, 10_i64.checked_pow(decimals.len().try_into().ok()?)?)
        };
        value().ok_or_else(|| fault(at, "expected a number of at most 18 digits"))
    }

    /// A word: a name, a function, a constant, a differential, or the product of its letters.
    fn word(&mut self) -> Result<(), Fault> {
        let at = self.at;
        let word: String = self.run(is_letter).chars().map(same_letter).collect();
        let index_at = self.at;
        let suffix = self.suffix()?;
        let is_bare = suffix.index.is_empty() && suffix.primes == 0;
        if let Some(name) = self.name(&word, &suffix) {
            self.push(at, name);
        } else if let Some(name) = self.variable(&word, &suffix) {
            self.push(at, Kind::Differential);
            self.push(at + 1, name);
        } else if let Some((_, instead)) = LACKING.iter().find(|(name, _)| *name == word) {
            return Err(fault(at, format!("the function {word} is not known here{instead}")));
        } else if is_bare {
            self.letters(at, &word)?;
        } else if function(&word).is_some() {
            return Err(fault(index_at, format!("expected a bracket after {word}, as in {word}(2 x)")));
        } else {
            let message =
                format!("expected an index after one letter only: write a sign between those of `{}`", short(&word));
            return Err(fault(index_at, message));
        }
        Ok(())
    }

    /// The token for one name.
    fn name(&self, word: &str, suffix: &Suffix) -> Option<Kind> {
        let mut letters = word.chars();
        let only = letters.next().filter(|_| letters.next().is_none());
        let base = only.and_then(greek_name).unwrap_or(word);
        let mut name = base.to_owned();
        if !suffix.index.is_empty() {
            name.push('_');
            name.push_str(&suffix.index);
        }
        name.extend(std::iter::repeat_n('\'', suffix.primes));
        if let Some(symbol) = self.known.get(name.as_str()) {
            return Some(Kind::Name((*symbol).clone(), true));
        }
        let opens = matches!(self.peek(0), Some('(' | '[' | '{' | '⟨'));
        match name.as_str() {
            "pi" => Some(Kind::Pi),
            "i" => Some(Kind::ImaginaryUnit),
            "e" => Some(Kind::Euler),
            "d" if opens => Some(Kind::Differential),
            _ if only.is_some() || is_greek(base) => Some(Kind::Name(UNKNOWN.named(name), false)),
            _ => function(&name).map(Kind::Function),
        }
    }

    /// The variable of a differential dx, unless d is a quantity.
    fn variable(&self, word: &str, suffix: &Suffix) -> Option<Kind> {
        let rest = word.strip_prefix('d').filter(|_| !self.known.contains_key("d"))?;
        self.name(rest, suffix).filter(|kind| matches!(kind, Kind::Name(..)))
    }

    /// The letters of a word as a product.
    fn letters(&mut self, at: usize, word: &str) -> Result<(), Fault> {
        let bare = Suffix { index: String::new(), primes: 0 };
        let letters: Vec<_> = word.chars().map(|letter| self.name(&letter.to_string(), &bare)).collect();
        let is_plain = |c: char| c.is_ascii_alphabetic();
        let unknown = |kind: &Option<Kind>| matches!(kind, Some(Kind::Name(_, false) | Kind::Euler) | None);
        if word.chars().all(is_plain) && letters.len() > LONGEST_PRODUCT && letters.iter().any(unknown) {
            let message = format!("expected a name: `{}` is none. {}", short(word), split_hint(word));
            return Err(fault(at, message));
        }
        for ((place, (start, first)), letter) in word.char_indices().enumerate().zip(letters) {
            let rest: String = word[start..].chars().take(LONGEST_WORD).collect();
            if spells(&rest) || self.spells_known(&rest) {
                let message = format!("`{}` could be read in several ways. {}", short(word), split_hint(word));
                return Err(fault(at + place, message));
            }
            if first == 'd' && rest.len() > 1 && !self.known.contains_key("d") {
                let message = format!("`{}` could hold a differential: write d* or a space before the d", short(word));
                return Err(fault(at + place, message));
            }
            self.push(at + place, letter.expect("one letter is a name"));
        }
        Ok(())
    }

    /// Whether `rest` starts with a known name of several letters.
    fn spells_known(&self, rest: &str) -> bool {
        self.known.keys().any(|name| name.len() > 1 && name.chars().all(char::is_alphabetic) && rest.starts_with(*name))
    }

    /// The index and the primes of a name.
    fn suffix(&mut self) -> Result<Suffix, Fault> {
        let lowered = |c| plain(c).filter(|(_, raised)| !raised).map(|(plain, _)| plain);
        let index = match self.peek(0) {
            Some('_') => {
                self.at += 1;
                self.index()?
            }
            Some(c) if c.is_ascii_digit() => self.run(|c| c.is_ascii_digit()),
            Some(_) => self.run(|c| lowered(c).is_some()).chars().filter_map(lowered).collect(),
            None => String::new(),
        };
        let marks = self.run(|c| matches!(c, '\'' | '′' | '’' | '″'));
        Ok(Suffix { index, primes: marks.chars().map(|mark| if mark == '″' { 2 } else { 1 }).sum() })
    }

    /// What stands after the _ of a name: 1, in, x2, θ, {12}.
    fn index(&mut self) -> Result<String, Fault> {
        let at = self.at;
        let braced = self.peek(0) == Some('{');
        self.at += usize::from(braced);
        let letters: String = self.run(is_letter).chars().map(same_letter).collect();
        let digits = self.run(|c| c.is_ascii_digit());
        if braced && self.peek(0) != Some('}') {
            return Err(fault(self.at, "expected letters or digits and a } after _{"));
        }
        self.at += usize::from(braced);
        if letters.is_empty() && digits.is_empty() {
            return Err(fault(at, "expected an index of letters or digits after _"));
        }
        let mut all = letters.chars();
        let only = all.next().filter(|_| all.next().is_none() && digits.is_empty());
        if letters.len() > 2 && FUNCTIONS.iter().any(|(name, _)| name.len() > 2 && letters.contains(name)) {
            return Err(fault(
                at,
                format!("`{}` as an index hides a function: write a space before it", short(&letters)),
            ));
        }
        Ok(only.and_then(greek_name).map_or(letters + &digits, str::to_owned))
    }
}

/// How far into a word a hidden name is looked for.
const LONGEST_WORD: usize = 12;

fn is_letter(c: char) -> bool {
    c.is_alphabetic() && plain(c).is_none()
}

/// The letter that is meant by others of its looks.
fn same_letter(c: char) -> char {
    match c {
        'µ' => 'μ',
        'Ω' => 'Ω',
        'ϕ' => 'φ',
        'ϑ' => 'θ',
        'ϵ' => 'ε',
        'ϱ' => 'ρ',
        _ => c,
    }
}

fn short(word: &str) -> String {
    match word.char_indices().nth(20) {
        Some((end, _)) => format!("{}…", &word[..end]),
        None => word.to_owned(),
    }
}

/// How the word may be meant: a function's argument, a name and a letter, or letters.
fn split_hint(word: &str) -> String {
    let parts = FUNCTIONS.iter().filter_map(|(name, _)| Some((name, word.strip_prefix(name)?)));
    match parts.filter(|(_, rest)| !rest.is_empty()).max_by_key(|(name, _)| name.len()) {
        Some((name, rest)) => format!("Write {name}({})", short(rest)),
        None => format!("Write a * between what is multiplied, or a letter with an index: {}_1", first(word)),
    }
}

fn first(word: &str) -> char {
    word.chars().next().unwrap_or('x')
}
