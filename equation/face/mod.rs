//! Faces: an expression as LaTeX, MathML, one line of Unicode, or Unicode with fractions of two storeys.
//!
//! One walk over the tree decides what goes in parentheses and what stands side by side; a pen knows the
//! marks of its format. On a single line fractions become slashes. Such a line says which expression it is: what
//! could be read in two ways is kept apart by parentheses, and [`super::parse`] reads it back.

mod block;
mod latex;
mod mathml;
mod name;
mod pen;
mod unicode;
mod walk;

use super::Equation;
use super::expr::{Expr, Function};
use super::symbol::Symbol;
use name::Name;
use pen::Pen;
use std::fmt;
use walk::{relate, write};

pub use block::Block;
pub(super) use name::{greek_name, is_greek, spells};

impl Expr {
    /// As LaTeX, for math mode.
    pub fn latex(&self) -> String {
        write(latex::Latex, self).0
    }

    /// As a MathML element.
    pub fn mathml(&self) -> String {
        mathml::element(&write(mathml::MathMl, self).0, "inline")
    }

    /// In Unicode for a terminal, with fractions of two storeys.
    pub fn layout(&self) -> Block {
        write(block::Stacked::new(), self).0
    }
}

impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&write(unicode::Unicode, self).0)
    }
}

impl Equation {
    /// As LaTeX, for math mode.
    pub fn latex(&self) -> String {
        relate(latex::Latex, self)
    }

    /// As a MathML element in display style.
    pub fn mathml(&self) -> String {
        mathml::element(&relate(mathml::MathMl, self), "block")
    }

    /// In Unicode for a terminal, with fractions of two storeys.
    pub fn layout(&self) -> Block {
        relate(block::Stacked::new(), self)
    }
}

impl fmt::Display for Equation {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&relate(unicode::Unicode, self))
    }
}

impl Symbol {
    /// Its name as LaTeX, for math mode.
    pub fn latex(&self) -> String {
        latex::Latex.name(&Name::parse(self.name()), self.rank())
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&unicode::Unicode.name(&Name::parse(self.name()), self.rank()))
    }
}

impl Function {
    /// The word or sign it is known by.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sqrt => "√",
            Self::Exp => "exp",
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Asin => "arcsin",
            Self::Acos => "arccos",
            Self::Atan => "arctan",
            Self::Conj => "conj",
            Self::Abs => "abs",
            Self::Re => "Re",
            Self::Im => "Im",
        }
    }
}
