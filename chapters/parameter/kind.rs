//! What a parameter may be: the only list of kinds.

use super::argument::Argument;
use super::medium::{CONDUCTIVITY, CONDUCTOR_DOMAIN, INDEX_MAX, INDEX_MIN, RELATIVE, Taken, read_conductor};
use super::quantity::{Range, Scale, number, suffixes};
use super::{Fault, Parameter, Setting, Value, excerpt};
use light::media;

/// What a parameter may be.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A finite number with a unit.
    Number(Range),
    /// A whole number within `min ..= max` [1].
    Count {
        /// Smallest value.
        min: u64,
        /// Largest value; a double holds it if it is at most 2⁵³.
        max: u64,
    },
    /// One of these words.
    Choice(&'static [&'static str]),
    /// A refractive index: a number, `n+ki`, or a material by name, evaluated at the setting's wavelength.
    Medium,
    /// The same, of which a number may be the real part alone: the imaginary one is another parameter, and its owner sees
    /// to it that both are not zero.
    MediumInParts,
    /// A medium that does not absorb.
    ClearMedium,
    /// A medium that may conduct, at any frequency: `ε_r/μ_r/σ` with σ in S/m (`80/1/4`), or one by name.
    Conductor,
    /// Three numbers, each within the range.
    Vector(Range),
    /// Any number of one kind.
    List {
        /// Each of them.
        of: &'static Kind,
        /// How many at most.
        most: usize,
    },
    /// Named fields.
    Record(&'static [Parameter]),
}

impl Kind {
    /// A number within `min ..= max` in `unit` (SI).
    pub const fn number(min: f64, max: f64, unit: &'static str) -> Self {
        Self::Number(Range::new(min, max, unit))
    }

    /// Its name in reports.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Number(_) => "number",
            Self::Count { .. } => "count",
            Self::Choice(_) => "choice",
            Self::Medium | Self::MediumInParts => "medium",
            Self::ClearMedium => "clear_medium",
            Self::Conductor => "conducting_medium",
            Self::Vector(_) => "vector",
            Self::List { .. } => "list",
            Self::Record(_) => "record",
        }
    }

    /// The unit of its numbers; empty where several have one each, or none has.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Number(range) | Self::Vector(range) => range.unit,
            Self::Count { .. } | Self::Medium | Self::MediumInParts | Self::ClearMedium => "1",
            Self::Choice(_) | Self::Conductor | Self::List { .. } | Self::Record(_) => "",
        }
    }

    /// The media that can be given by name; none of a kind that is no medium.
    pub fn names(&self) -> Vec<&'static str> {
        match self {
            Self::Medium | Self::MediumInParts => Taken::All.names().collect(),
            Self::ClearMedium => Taken::Clear.names().collect(),
            Self::Conductor => media::electric().map(|known| known.name).collect(),
            _ => Vec::new(),
        }
    }

    /// The value that `argument` stands for. The fault's place is inside the value: `[1].n`, or empty for the whole.
    ///
    /// # Errors
    /// What is wrong with it and what would be valid.
    pub fn read(&self, argument: &Argument) -> Result<Value, Fault> {
        let fault = |message: String| Fault::new("", message);
        match self {
            Self::Number(range) => range.read(argument, "", "").map(Value::Number).map_err(fault),
            Self::Count { min, max } => read_count(argument, *min, *max).map(Value::Number).ok_or_else(|| {
                fault(format!("`{}` is not a whole number in range; {}", argument.excerpt(), self.words()))
            }),
            Self::Choice(words) => read_word(argument, words).map(Value::Word),
            Self::Medium => Taken::All.read(argument).map(Value::Medium),
            Self::MediumInParts => Taken::Parts.read(argument).map(Value::Medium),
            Self::ClearMedium => Taken::Clear.read(argument).map(Value::Medium),
            Self::Conductor => read_conductor(argument).map(Value::Conductor),
            Self::Vector(range) => match argument {
                Argument::List(items) if items.len() == 3 => {
                    let mut numbers = [0.0; 3];
                    for (at, item) in items.iter().enumerate() {
                        let fault = |message| Fault::new(format!("[{at}]"), message);
                        numbers[at] = range.read(item, "", "").map_err(fault)?;
                    }
                    Ok(Value::Vector(numbers))
                }
                _ => Err(fault(format!("must be a list of three numbers; {}", self.words()))),
            },
            Self::List { of, most } => match argument {
                Argument::List(items) if items.len() <= *most => {
                    let read = |(at, item): (usize, &Argument)| {
                        of.read(item).map_err(|fault| fault.within(&format!("[{at}]")))
                    };
                    items.iter().enumerate().map(read).collect::<Result<_, _>>().map(Value::List)
                }
                Argument::List(items) => Err(fault(format!("{} of them; {}", items.len(), self.words()))),
                _ => Err(fault(format!("must be a list; {}", self.words()))),
            },
            Self::Record(parameters) => match (argument, alone(parameters)) {
                (Argument::Record(fields), _) => Setting::record(parameters, fields).map(Value::Record),
                (Argument::Number(_) | Argument::Text(_), Some(field)) => {
                    let fields = [(field.name.to_owned(), argument.clone())];
                    let at_whole = |fault: Fault| {
                        if fault.place == field.name { Fault { place: String::new(), ..fault } } else { fault }
                    };
                    Setting::record(parameters, &fields).map(Value::Record).map_err(at_whole)
                }
                _ => Err(fault(format!("must have fields; {}", self.words()))),
            },
        }
    }

    /// The valid values in words.
    pub fn words(&self) -> String {
        match self {
            Self::Number(range) => range.words("", ""),
            Self::Count { min, max } => {
                let end = |end: u64| if end < 1_000_000 { end.to_string() } else { number(end as f64) };
                format!("valid: {} to {}", end(*min), end(*max))
            }
            Self::Choice(words) => format!("valid: {}", words.join(", ")),
            Self::Medium | Self::MediumInParts => Taken::All.words().into(),
            Self::ClearMedium => Taken::Clear.words().into(),
            Self::Conductor => CONDUCTOR_DOMAIN.into(),
            Self::Vector(range) => format!("{}, three times", range.words("", "")),
            Self::List { of, most } => {
                let each = of.words();
                format!("valid: up to {most} of {}", each.strip_prefix("valid: ").unwrap_or(&each))
            }
            Self::Record(parameters) => {
                let field = |parameter: &Parameter| {
                    let names = parameter.names().collect::<Vec<_>>().join(" or ");
                    parameter.default.map_or(names.clone(), |default| format!("{names} = {default}"))
                };
                let alone = alone(parameters).map_or(String::new(), |field| format!(", or {} alone", field.name));
                format!("valid: {{{}}}{alone}", parameters.iter().map(field).collect::<Vec<_>>().join(", "))
            }
        }
    }

    /// The same for programs: `kind`, and what belongs to it (`min` and `max` in SI, `words`, `names`, `of`, `fields`).
    pub fn describe(&self) -> Argument {
        let mut fields = vec![("kind", Argument::from(self.name()))];
        let ends = |range: &Range| {
            let end = |end: f64| if range.is_bounded() { Argument::Number(end) } else { Argument::Other };
            let scale = match range.scale() {
                Scale::Linear => "linear",
                Scale::Logarithmic => "logarithmic",
            };
            let suffixes = Argument::words(suffixes(range.unit).iter().map(|(suffix, _)| *suffix));
            [
                ("unit", range.unit.into()),
                ("min", end(range.min)),
                ("max", end(range.max)),
                ("scale", scale.into()),
                ("suffixes", suffixes),
            ]
        };
        let names = || ("names", Argument::words(self.names()));
        let pair = |(min, max): (f64, f64)| Argument::List(vec![min.into(), max.into()]);
        match self {
            Self::Number(range) | Self::Vector(range) => fields.extend(ends(range)),
            Self::Count { min, max } => fields.extend([("min", (*min as f64).into()), ("max", (*max as f64).into())]),
            Self::Choice(words) => fields.push(("words", Argument::words(words.iter().copied()))),
            Self::Medium | Self::MediumInParts => {
                fields.extend([("n", pair((INDEX_MIN, INDEX_MAX))), ("k", pair((0.0, INDEX_MAX))), names()])
            }
            Self::ClearMedium => fields.extend([("n", pair((INDEX_MIN, INDEX_MAX))), names()]),
            Self::Conductor => fields.extend([
                ("eps_r", pair(RELATIVE)),
                ("mu_r", pair(RELATIVE)),
                ("sigma", pair(CONDUCTIVITY)),
                names(),
            ]),
            Self::List { of, most } => fields.extend([("most", (*most as f64).into()), ("of", of.describe())]),
            Self::Record(parameters) => {
                fields.push(("fields", Argument::List(parameters.iter().map(Parameter::describe).collect())));
            }
        }
        let words = self.words();
        fields.push(("valid", words.strip_prefix("valid: ").unwrap_or(&words).into()));
        Argument::record(fields)
    }

    /// Values at the ends of what is taken, for tests of what is made of them. Media have no ends that a figure could
    /// be drawn at; they have a thin one and a thick one.
    pub fn ends(&self) -> Vec<Argument> {
        match self {
            Self::Number(range) => vec![range.min.into(), range.max.into()],
            Self::Count { min, max } => vec![(*min as f64).into(), (*max as f64).into()],
            Self::Choice(words) => words.iter().map(|word| (*word).into()).collect(),
            Self::Medium | Self::MediumInParts => vec![1.0.into(), "4+9i".into()],
            Self::ClearMedium => vec![1.0.into(), 4.0.into()],
            Self::Conductor => vec!["vacuum".into(), "1e-9/1e-9/0".into(), "1e9/1e9/1e30".into()],
            Self::Vector(range) => [range.min, range.max].map(|end| Argument::List(vec![end.into(); 3])).to_vec(),
            Self::List { of, .. } => vec![Argument::List(vec![]), Argument::List(of.ends())],
            Self::Record(parameters) => {
                let needed = || parameters.iter().filter(|parameter| parameter.is_required());
                let all = |end: fn(Vec<Argument>) -> Option<Argument>| {
                    Argument::record(needed().filter_map(|field| Some((field.name, end(field.kind.ends())?))))
                };
                vec![all(|ends| ends.into_iter().next()), all(|mut ends| ends.pop())]
            }
        }
    }
}

/// The field that may stand for a whole record: the only one that has to be given.
fn alone(parameters: &'static [Parameter]) -> Option<&'static Parameter> {
    let mut needed = parameters.iter().filter(|field| field.is_required());
    needed.next().filter(|_| needed.next().is_none())
}

/// A whole number, however it is written: 100, 100.0 and 1e2 are one.
fn read_count(argument: &Argument, min: u64, max: u64) -> Option<f64> {
    let value = match argument {
        Argument::Number(value) => *value,
        Argument::Text(text) => text.trim().parse().ok()?,
        _ => return None,
    };
    // −0 is no count.
    (value.fract() == 0.0 && (min as f64..=max as f64).contains(&value)).then_some(value.abs())
}

fn read_word(argument: &Argument, words: &'static [&'static str]) -> Result<&'static str, Fault> {
    let Argument::Text(text) = argument else {
        return Err(Fault::new("", format!("must be a text; valid: {}", words.join(", "))));
    };
    let unknown =
        || Fault::unknown("", text, format!("`{}` is none of its words", excerpt(text)), words.iter().copied());
    words.iter().find(|word| *word == text).copied().ok_or_else(unknown)
}
