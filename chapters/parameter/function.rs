//! The checked functions that `lesson eval` and the bindings offer.

use super::{Argument, Fault, Parameter, Setting};

/// A function by name: the chapter's own physics behind a flat list of inputs and outputs.
#[derive(Debug)]
pub struct Function {
    /// Command-line word.
    pub name: &'static str,
    /// What it computes, with its conventions.
    pub says: &'static str,
    /// What it takes.
    pub inputs: &'static [Parameter],
    /// What it gives.
    pub outputs: &'static [Output],
    /// Computes the outputs, by name, in order.
    pub compute: fn(&Setting) -> Outcome,
}

/// The outputs by name, or why there are none.
pub type Outcome = Result<Vec<(&'static str, f64)>, Fault>;

/// One output of a function.
#[derive(Debug)]
pub struct Output {
    /// Field name.
    pub name: &'static str,
    /// What it is.
    pub says: &'static str,
    /// Unit.
    pub unit: &'static str,
}

impl Output {
    /// An output `name` in `unit`.
    pub const fn new(name: &'static str, says: &'static str, unit: &'static str) -> Self {
        Self { name, says, unit }
    }
}

impl Function {
    /// The outputs for the arguments `given`.
    ///
    /// # Errors
    /// The first thing wrong with them: an unknown name, one given twice, one missing, a value outside its domain.
    pub fn call(&self, given: &[(String, Argument)]) -> Outcome {
        (self.compute)(&Setting::arguments(self, given)?)
    }

    /// The input that answers to `name`.
    pub fn input(&self, name: &str) -> Option<&'static Parameter> {
        self.inputs.iter().find(|input| input.form(name).is_some())
    }
}
