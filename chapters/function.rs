//! The checked functions that `lesson eval` offers to scripts.

use crate::setting::{Fault, excerpt, parse_quantity, range};

/// A function by name: the chapter's own physics behind a flat list of inputs and outputs.
#[derive(Debug)]
pub struct Function {
    /// Command-line word.
    pub name: &'static str,
    /// What it computes, with its conventions.
    pub says: &'static str,
    /// What it takes.
    pub inputs: &'static [Input],
    /// What it gives.
    pub outputs: &'static [Output],
    /// Computes the outputs, by name, in order.
    pub call: fn(&Arguments) -> Outcome,
}

/// The outputs by name, or why there are none.
pub type Outcome = Result<Vec<(&'static str, f64)>, Fault>;

/// One input of a function.
#[derive(Debug)]
pub struct Input {
    /// Field name.
    pub name: &'static str,
    /// What it is.
    pub says: &'static str,
    /// SI unit unless the name says otherwise; `rad` inputs also take the text `56.3deg`.
    pub unit: &'static str,
    /// Smallest and largest value of a number; `None` for structured fields, which their function checks.
    pub domain: Option<(f64, f64)>,
    /// Taken if the field is left out; `None` for fields that must be given or that have an alternative.
    pub default: Option<f64>,
}

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

/// A value as a script gives it.
#[derive(Clone, Debug, PartialEq)]
pub enum Argument {
    /// A number.
    Number(f64),
    /// A string.
    Text(String),
    /// A list.
    List(Vec<Argument>),
    /// Named fields.
    Record(Vec<(String, Argument)>),
    /// What no input can be: `true`, `false`, `null`.
    Other,
}

/// Named arguments, checked against the function's inputs as they are read.
#[derive(Debug)]
pub struct Arguments<'a> {
    inputs: &'a [Input],
    given: &'a [(String, Argument)],
}

impl<'a> Arguments<'a> {
    /// Takes the arguments given; a name that the function lacks, or one given twice, is a fault.
    pub fn new(function: &'a Function, given: &'a [(String, Argument)]) -> Result<Self, Fault> {
        for (at, (name, _)) in given.iter().enumerate() {
            if !function.inputs.iter().any(|input| input.name == name) {
                let known = function.inputs.iter().map(|input| input.name).collect();
                let message = format!("no such input of {}", function.name);
                return Err(Fault::unknown(excerpt(name), name, message, known));
            }
            if given[..at].iter().any(|(earlier, _)| earlier == name) {
                return Err(Fault::new(name, "given twice"));
            }
        }
        Ok(Self { inputs: function.inputs, given })
    }

    /// The argument `name` as it was given.
    pub fn get(&self, name: &str) -> Option<&'a Argument> {
        self.given.iter().find(|(given, _)| given == name).map(|(_, argument)| argument)
    }

    /// The number `name`, within its domain; its default if it was left out, `None` if it has none.
    pub fn optional(&self, name: &str) -> Result<Option<f64>, Fault> {
        let input = self.inputs.iter().find(|input| input.name == name).expect("a declared input");
        let Some(argument) = self.get(name) else { return Ok(input.default) };
        number(name, argument, input.unit, input.domain).map(Some)
    }

    /// The number `name`, which must be there.
    pub fn number(&self, name: &str) -> Result<f64, Fault> {
        self.optional(name)?.ok_or_else(|| Fault::new(name, "missing"))
    }
}

/// `argument` as a number in `unit` within `domain`.
pub fn number(place: &str, argument: &Argument, unit: &str, domain: Option<(f64, f64)>) -> Result<f64, Fault> {
    let given = match argument {
        Argument::Text(text) => excerpt(text),
        // The shorter of decimals and powers of ten, to the last digit.
        Argument::Number(value) => format!("{value:?}").trim_end_matches(".0").to_owned(),
        _ => String::new(),
    };
    let valid = domain.map_or(String::new(), |(min, max)| format!("; {}", range(min, max, unit, &given)));
    let value = match argument {
        Argument::Number(value) => *value,
        Argument::Text(text) => {
            parse_quantity(text, unit).map_err(|reason| Fault::new(place, format!("{reason}{valid}")))?
        }
        _ => return Err(Fault::new(place, format!("must be a number{valid}"))),
    };
    if !value.is_finite() || domain.is_some_and(|(min, max)| !(min..=max).contains(&value)) {
        return Err(Fault::new(place, format!("{given} is out of range{valid}")));
    }
    Ok(value)
}
