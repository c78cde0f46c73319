//! What can be set: one schema for `--set`, `eval`, scene files, JSON, sliders and bindings.
//!
//! A [`Parameter`] has a name, a [`Kind`] and perhaps a default. Whatever form it is given in becomes an [`Argument`]
//! first, is read by its kind into a [`Value`], and stands in a [`Setting`] beside the others. Descriptions go the other
//! way: words for people ([`Parameter::domain`]), an [`Argument`] for programs ([`Parameter::describe`]).

mod argument;
mod draw;
mod fault;
mod function;
mod kind;
mod medium;
mod nudge;
mod quantity;
mod setting;
mod shared;
#[cfg(test)]
mod tests;
mod value;

pub use argument::{Argument, reason};
pub use fault::{Fault, Unknown, excerpt};
pub use function::{Function, Outcome, Output};
pub use kind::Kind;
pub use medium::{CONDUCTIVITY, Conductor, INDEX_MAX, INDEX_MIN, RELATIVE, parse_conductor, parse_medium};
pub use nudge::Nudge;
pub use quantity::{Range, Scale, number, parse_quantity, write_quantity};
pub use setting::Setting;
pub use shared::{BY_FREQUENCY, BY_WAVELENGTH, DEFAULT_WAVELENGTH, FREQUENCY, MEDIUM, THETA, WAVELENGTH};
pub use value::Value;

/// Something that can be set.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// The word before `=`. One quantity has one name everywhere.
    pub name: &'static str,
    /// Other ways to give it: older names, and the same quantity in another form.
    pub aliases: &'static [Alias],
    /// Symbol, in the label markup of [`crate::figure`].
    pub symbol: &'static str,
    /// What it is.
    pub says: &'static str,
    /// What it may be.
    pub kind: Kind,
    /// Its value if nothing is set, written as on the command line; `None` if it must be given or has an alternative.
    pub default: Option<&'static str>,
    /// Parameters that this one is given instead of; of none of them if it may simply be left out.
    pub instead_of: Option<&'static [&'static str]>,
    /// The choice that it belongs to, and with which of its words: of several parameters of one name the one that belongs
    /// to the word in force is meant.
    pub only_with: Option<OnlyWith>,
    /// What only the owner of the parameter knows: whether its value goes together with the others.
    pub validate: Option<Validate>,
}

/// A choice, by its name, and some of its words.
pub type OnlyWith = (&'static str, &'static [&'static str]);

/// Whether a value goes together with the others of its setting.
pub type Validate = fn(&Setting) -> Result<(), Fault>;

/// Another way to give a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alias {
    /// The word before `=`.
    pub name: &'static str,
    /// What stands behind it.
    pub form: Form,
}

/// How what is given stands to the value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// It is the value.
    Same,
    /// It is a number that counts in this unit if it carries no other: `nm`.
    In(&'static str),
    /// The value is the constant [SI] over it, and it has a unit of its own: a wavelength by its frequency.
    Over(f64, &'static str),
}

impl Alias {
    /// An older name of the same.
    pub const fn same(name: &'static str) -> Self {
        Self { name, form: Form::Same }
    }

    /// A name under which plain numbers count in `unit`.
    pub const fn counted_in(name: &'static str, unit: &'static str) -> Self {
        Self { name, form: Form::In(unit) }
    }

    /// A quantity in `unit` that `constant` [SI] over the value gives.
    pub const fn over(name: &'static str, constant: f64, unit: &'static str) -> Self {
        Self { name, form: Form::Over(constant, unit) }
    }
}

impl Parameter {
    /// One without a default, which has to be given.
    pub const fn new(name: &'static str, symbol: &'static str, says: &'static str, kind: Kind) -> Self {
        Self {
            name,
            aliases: &[],
            symbol,
            says,
            kind,
            default: None,
            instead_of: None,
            only_with: None,
            validate: None,
        }
    }

    /// With a default, written as on the command line.
    pub const fn default(self, default: &'static str) -> Self {
        Self { default: Some(default), ..self }
    }

    /// Without a default.
    pub const fn required(self) -> Self {
        Self { default: None, ..self }
    }

    /// With these aliases instead of those it had.
    pub const fn aliases(self, aliases: &'static [Alias]) -> Self {
        Self { aliases, ..self }
    }

    /// Given instead of `others`, and left out otherwise.
    pub const fn instead_of(self, others: &'static [&'static str]) -> Self {
        Self { instead_of: Some(others), ..self }
    }

    /// Belonging to these `words` of the choice called `choice`.
    pub const fn only_with(self, choice: &'static str, words: &'static [&'static str]) -> Self {
        Self { only_with: Some((choice, words)), ..self }
    }

    /// With something that only its owner knows.
    pub const fn validate(self, validate: Validate) -> Self {
        Self { validate: Some(validate), ..self }
    }

    /// Whether nothing stands in for it if it is left out.
    pub fn is_required(&self) -> bool {
        self.default.is_none() && self.instead_of.is_none()
    }

    /// Its name and its aliases.
    pub fn names(&self) -> impl Iterator<Item = &'static str> + use<> {
        std::iter::once(self.name).chain(self.aliases.iter().map(|alias| alias.name))
    }

    /// The form in which `name` gives it, if that is one of its names.
    pub fn form(&self, name: &str) -> Option<Form> {
        if self.name == name {
            return Some(Form::Same);
        }
        self.aliases.iter().find(|alias| alias.name == name).map(|alias| alias.form)
    }

    /// The value that `text` stands for.
    ///
    /// # Errors
    /// What is wrong with it and what would be valid.
    pub fn parse(&self, text: &str) -> Result<Value, Fault> {
        self.parse_as(self.name, text)
    }

    /// The value that `text` stands for under one of its names.
    ///
    /// # Errors
    /// As [`Self::parse`], and if it is none of its names.
    pub fn parse_as(&self, name: &str, text: &str) -> Result<Value, Fault> {
        let form = self.form(name).ok_or_else(|| Fault::unknown(name, name, "not one of its names", self.names()))?;
        let argument = Argument::from_text(text).map_err(|why| self.malformed(name, &why))?;
        self.read(form, &argument).map_err(|fault| fault.within(name))
    }

    /// That what was given under `name` cannot be read at all.
    pub fn malformed(&self, name: &str, why: &str) -> Fault {
        Fault::new(excerpt(name), format!("{why}; {}", self.domain_of(self.form(name).unwrap_or(Form::Same), "")))
    }

    /// The value that `argument` stands for in a `form`. The fault's place is inside the value.
    ///
    /// # Errors
    /// What is wrong with it and what would be valid.
    pub fn read(&self, form: Form, argument: &Argument) -> Result<Value, Fault> {
        let Kind::Number(range) = self.kind else { return self.kind.read(argument) };
        let like = self.default.unwrap_or("");
        let value = match form {
            Form::Same => range.read(argument, "", like),
            Form::In(unit) => range.read(argument, unit, ""),
            // An end goes there and back by two divisions, which may leave it a rounding outside.
            Form::Over(constant, unit) => over(range, constant, unit)
                .read(argument, "", "")
                .map(|given| (constant / given).clamp(range.min, range.max)),
        };
        value.map(Value::Number).map_err(|message| Fault::new("", message))
    }

    /// The text that reads back to `value`.
    pub fn write(&self, value: &Value) -> String {
        match (self.kind, value) {
            (Kind::Number(range), Value::Number(value)) => write_quantity(*value, range.unit),
            _ => value.argument().to_string(),
        }
    }

    /// The valid values in words, in the unit of the default.
    pub fn domain(&self) -> String {
        self.domain_of(Form::Same, self.default.unwrap_or(""))
    }

    /// The valid values in words for a `form`, in the unit that `like` carries.
    pub fn domain_of(&self, form: Form, like: &str) -> String {
        match (self.kind, form) {
            (Kind::Number(range), Form::Same) => range.words(like, ""),
            (Kind::Number(range), Form::In(unit)) => range.words(like, unit),
            (Kind::Number(range), Form::Over(constant, unit)) => over(range, constant, unit).words(like, ""),
            (kind, _) => kind.words(),
        }
    }

    /// The parameter for programs: `name`, `aliases`, `symbol`, `says`, `default` (as text, or null) and `takes`, the
    /// description of its kind; `only_with` where it belongs to some words of a choice.
    pub fn describe(&self) -> Argument {
        let choice = |(choice, words): OnlyWith| {
            ("only_with", Argument::record([(choice, Argument::words(words.iter().copied()))]))
        };
        let fields = [
            ("name", self.name.into()),
            ("aliases", Argument::words(self.aliases.iter().map(|alias| alias.name))),
            ("symbol", self.symbol.into()),
            ("says", self.says.into()),
            ("default", self.default.map_or(Argument::Other, Argument::from)),
            ("takes", self.kind.describe()),
        ];
        Argument::record(fields.into_iter().chain(self.only_with.map(choice)))
    }
}

/// The range of `constant` over a quantity in `range`.
fn over(range: Range, constant: f64, unit: &'static str) -> Range {
    Range::new(constant / range.max, constant / range.min, unit)
}
