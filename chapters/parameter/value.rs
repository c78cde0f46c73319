//! What a parameter stands for, once it has been read.

use super::medium::write_medium;
use super::{Argument, Conductor, Setting};
use light::media::Medium;

/// A value in force.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number in SI, or a count.
    Number(f64),
    /// One of a choice's words.
    Word(&'static str),
    /// A medium by its index.
    Medium(Medium),
    /// A medium that may conduct.
    Conductor(Conductor),
    /// Three numbers in SI.
    Vector([f64; 3]),
    /// Values of one kind.
    List(Vec<Value>),
    /// Named values.
    Record(Setting),
}

impl Value {
    /// The value as it would be given: what is read back from it is the same value.
    pub fn argument(&self) -> Argument {
        match self {
            Self::Number(value) => (*value).into(),
            Self::Word(word) => (*word).into(),
            Self::Medium(medium) => write_medium(*medium),
            Self::Conductor(conductor) => conductor.to_string().into(),
            Self::Vector(numbers) => Argument::List(numbers.map(Argument::from).to_vec()),
            Self::List(items) => Argument::List(items.iter().map(Self::argument).collect()),
            Self::Record(fields) => {
                let given = fields.values().filter_map(|(parameter, value)| Some((parameter.name, value?.argument())));
                Argument::record(given)
            }
        }
    }
}
