//! The place in a text up to which it was read: what comes next, how deep it lies, and what is said of it if it is wrong.

use super::fault::{DEEPEST, Fault, fault};
use super::lex::{Kind, Lexer, Token};
use super::part::Part;
use crate::symbol::Symbol;
use std::collections::BTreeMap;

pub(super) struct Parser<'a> {
    pub tokens: Vec<Token>,
    pub known: &'a [Symbol],
    /// The token to read next.
    pub at: usize,
    pub depth: usize,
    /// What closes the innermost bracket.
    pub closer: char,
    /// Whether the differentials that follow end the integrand being read.
    pub in_integrand: bool,
}

pub(super) type Read = Result<Part, Fault>;

impl<'a> Parser<'a> {
    pub fn new(text: &str, known: &'a [Symbol]) -> Result<Self, Fault> {
        let names: BTreeMap<&str, &Symbol> = known.iter().map(|symbol| (symbol.name(), symbol)).collect();
        let tokens = Lexer::read(text.chars().collect(), &names)?;
        Ok(Self { tokens, known, at: 0, depth: 0, closer: ' ', in_integrand: false })
    }

    pub fn token(&self, ahead: usize) -> &Token {
        &self.tokens[(self.at + ahead).min(self.tokens.len() - 1)]
    }

    pub fn kind(&self) -> &Kind {
        &self.token(0).kind
    }

    pub fn is_sign(&self, sign: char) -> bool {
        *self.kind() == Kind::Sign(sign)
    }

    /// Takes `sign` if it is next.
    pub fn takes(&mut self, sign: char) -> bool {
        let is_next = self.is_sign(sign);
        self.at += usize::from(is_next);
        is_next
    }

    pub fn fault(&self, message: impl Into<String>) -> Fault {
        fault(self.token(0).at, message)
    }

    pub fn expected(&self, what: &str) -> Fault {
        let found = match self.kind() {
            Kind::Number(_) => "a number".to_owned(),
            Kind::Name(symbol, _) => format!("the name {symbol}"),
            Kind::Function(function) => format!("the function {}", function.name()),
            Kind::Pi => "π".to_owned(),
            Kind::ImaginaryUnit => "i".to_owned(),
            Kind::Euler => "e".to_owned(),
            Kind::Differential => "a differential".to_owned(),
            Kind::Raised(_) => "an exponent".to_owned(),
            Kind::Lowered(_) => "an index".to_owned(),
            Kind::Open(closer) => format!("`{}`", opener(*closer)),
            Kind::Close(sign) | Kind::Sign(sign) => format!("`{sign}`"),
            Kind::End => "the end".to_owned(),
        };
        self.fault(format!("expected {what}, found {found}"))
    }

    /// Reads with `read` one level further down.
    pub fn deeper<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T, Fault>) -> Result<T, Fault> {
        if self.depth == DEEPEST {
            return Err(self.too_deep(self.token(0).at));
        }
        self.depth += 1;
        let part = read(self);
        self.depth -= 1;
        part
    }

    pub fn too_deep(&self, at: usize) -> Fault {
        fault(at, format!("expected no more than {DEEPEST} levels within one another"))
    }

    pub fn checked(&self, part: Part, at: usize) -> Read {
        if part.height > DEEPEST { Err(self.too_deep(at)) } else { Ok(part) }
    }

    /// The plus and minus signs that come next, together: whether they make a minus.
    pub fn minus(&mut self) -> bool {
        let mut is_negative = false;
        loop {
            match self.kind() {
                Kind::Sign('−') => is_negative = !is_negative,
                Kind::Sign('+') => {}
                _ => return is_negative,
            }
            self.at += 1;
        }
    }

    /// Reads with `read` inside a bracket that `closer` closes.
    pub fn within<T>(&mut self, closer: char, read: fn(&mut Self) -> Result<T, Fault>) -> Result<T, Fault> {
        let outer = (std::mem::replace(&mut self.closer, closer), std::mem::replace(&mut self.in_integrand, false));
        let part = read(self);
        (self.closer, self.in_integrand) = outer;
        part
    }

    pub fn close(&mut self, closer: char) -> Result<(), Fault> {
        if *self.kind() != Kind::Close(closer) {
            return Err(self.expected(&format!("an operator or a closing `{closer}`")));
        }
        self.at += 1;
        Ok(())
    }
}

fn opener(closer: char) -> char {
    match closer {
        ')' => '(',
        ']' => '[',
        '}' => '{',
        _ => '⟨',
    }
}
