//! Parameters and the values in force.

use super::{
    Argument, Conductor, DEFAULT_WAVELENGTH, FREQUENCY, Fault, Form, Function, Kind, Parameter, Value, WAVELENGTH,
    excerpt,
};
use light::Complex64;
use light::media::Medium;
use light::waves::constants::C;
use std::borrow::Cow;
use std::f64::consts::TAU;

/// The frequency [Hz] where neither it nor a wavelength is a parameter.
const DEFAULT_FREQUENCY: f64 = 1e9;

/// The values in force for one step, one call of a function or one record.
#[derive(Clone, Debug)]
pub struct Setting {
    parameters: &'static [Parameter],
    /// One for each parameter.
    slots: Vec<Slot>,
}

/// What stands for a parameter.
#[derive(Clone, Debug)]
struct Slot {
    /// `None` if it was left out and has no default.
    value: Option<Value>,
    /// As it was given, where that was a text.
    text: Option<Cow<'static, str>>,
    /// The name under which it was given.
    given: Option<&'static str>,
}

impl Setting {
    /// The defaults of a step's `parameters`.
    ///
    /// # Panics
    /// If a default is missing or not valid; the tests build every step's setting.
    pub fn defaults(parameters: &'static [Parameter]) -> Self {
        let setting = Self::empty(parameters);
        setting.finish().unwrap_or_else(|fault| panic!("default {fault}"));
        setting
    }

    /// With every `(name, text)` applied; names that the step lacks are faults, and so is what stands for one parameter
    /// twice.
    ///
    /// # Errors
    /// The first thing wrong with them.
    pub fn with(mut self, changes: &[(String, String)]) -> Result<Self, Fault> {
        self.slots.iter_mut().for_each(|slot| slot.given = None);
        for (name, text) in choices_first(self.parameters, changes) {
            let at = self.place(name, "no such parameter here")?;
            let malformed = |why: String| self.parameters[at].malformed(name, &why);
            let argument = Argument::from_text(text).map_err(malformed)?;
            self.take(at, name, &argument)?;
            // A text in another form is told as the value that it gives.
            let is_own = self.parameters[at].form(name) == Some(Form::Same);
            let text = if is_own { text.clone() } else { self.written(at) };
            self.slots[at].text = Some(text.into());
        }
        self.finish()?;
        Ok(self)
    }

    /// The `given` arguments of a `function` beside the defaults of the others.
    ///
    /// # Errors
    /// The first thing wrong with them.
    pub fn arguments(function: &Function, given: &[(String, Argument)]) -> Result<Self, Fault> {
        let no_such = |mut fault: Fault| {
            if fault.unknown.is_some() && fault.message == NO_SUCH_INPUT {
                fault.message = format!("{NO_SUCH_INPUT} of {}", function.name);
            }
            fault
        };
        let setting = Self::filled(function.inputs, given, NO_SUCH_INPUT).map_err(no_such)?;
        setting.finish()?;
        Ok(setting)
    }

    /// The `fields` of a record. Whether its media are known at the wavelength is for who holds the record to ask.
    pub(super) fn record(parameters: &'static [Parameter], fields: &[(String, Argument)]) -> Result<Self, Fault> {
        let setting = Self::filled(parameters, fields, "no such field")?;
        setting.complete()?;
        Ok(setting)
    }

    fn filled(
        parameters: &'static [Parameter],
        given: &[(String, Argument)],
        unknown: &'static str,
    ) -> Result<Self, Fault> {
        let mut setting = Self::empty(parameters);
        for (name, argument) in choices_first(parameters, given) {
            let at = setting.place(name, unknown)?;
            setting.take(at, name, argument)?;
        }
        Ok(setting)
    }

    /// The defaults, where there are any.
    fn empty(parameters: &'static [Parameter]) -> Self {
        let slot = |parameter: &Parameter| {
            let default = |text| parameter.parse(text).unwrap_or_else(|fault| panic!("default {fault}"));
            Slot { value: parameter.default.map(default), text: parameter.default.map(Cow::Borrowed), given: None }
        };
        Self { parameters, slots: parameters.iter().map(slot).collect() }
    }

    /// The index of the parameter that answers to `name`.
    fn place(&self, name: &str, unknown: &'static str) -> Result<usize, Fault> {
        let answers = || (0..self.slots.len()).filter(|at| self.parameters[*at].form(name).is_some());
        let own = || (0..self.slots.len()).filter(|at| self.applies(*at)).map(|at| &self.parameters[at]);
        answers().find(|at| self.applies(*at)).ok_or_else(|| {
            let Some((choice, words)) = answers().find_map(|at| self.parameters[at].only_with) else {
                return Fault::unknown(excerpt(name), name, unknown, own().flat_map(Parameter::names));
            };
            let Some(chosen) = self.get(choice).map(Value::argument) else {
                return self.missing(&self.parameters[self.at(choice)], std::iter::empty());
            };
            let takes: Vec<_> = own().filter(|other| other.only_with.is_some()).map(|other| other.name).collect();
            let takes = if takes.is_empty() { "nothing".to_owned() } else { takes.join(", ") };
            Fault::new(name, format!("goes with {choice}={}; {choice}={chosen} takes {takes}", words.join(" or ")))
        })
    }

    /// Whether a parameter belongs to the words in force.
    fn applies(&self, at: usize) -> bool {
        self.parameters[at].only_with.is_none_or(|(choice, words)| match self.get(choice) {
            Some(Value::Word(word)) => words.contains(word),
            _ => false,
        })
    }

    fn take(&mut self, at: usize, name: &str, argument: &Argument) -> Result<(), Fault> {
        let (parameter, slot) = (&self.parameters[at], &mut self.slots[at]);
        match slot.given {
            Some(earlier) if earlier == name => return Err(Fault::new(name, "given twice")),
            Some(earlier) => {
                return Err(Fault::new(name, format!("given beside {earlier}, which is the same; give one of them")));
            }
            None => slot.given = parameter.names().find(|own| *own == name),
        }
        let form = parameter.form(name).unwrap_or(Form::Same);
        slot.value = Some(parameter.read(form, argument).map_err(|fault| fault.within(name))?);
        slot.text = None;
        Ok(())
    }

    /// That nothing is missing, nothing contradicts, and every value can be used beside the others.
    fn finish(&self) -> Result<(), Fault> {
        self.complete()?;
        self.media(self.wavelength(), self.frequency())?;
        self.validate()
    }

    /// That every parameter has a value or something that stands instead of it, and not both.
    fn complete(&self) -> Result<(), Fault> {
        for (at, (parameter, slot)) in self.parameters.iter().zip(&self.slots).enumerate() {
            if !self.applies(at) {
                continue;
            }
            let rivals = || {
                let is_rival = |rival: &&Parameter| {
                    rival.instead_of.is_some_and(|others| {
                        others.contains(&parameter.name)
                            || parameter.instead_of.is_some_and(|own| own.iter().any(|name| others.contains(name)))
                    }) && rival.name != parameter.name
                };
                self.parameters.iter().filter(is_rival)
            };
            let rival = rivals().find_map(|rival| self.slot(rival.name).given);
            match (slot.given, rival) {
                (Some(given), Some(rival)) => {
                    let is_first = parameter.instead_of.is_none();
                    let (first, second) = if is_first { (given, rival) } else { (rival, given) };
                    return Err(Fault::new(second, format!("given beside {first}; give one of them")));
                }
                (None, None) if slot.value.is_none() && parameter.instead_of.is_none() => {
                    return Err(self.missing(parameter, rivals()));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn missing<'a>(&self, parameter: &Parameter, rivals: impl Iterator<Item = &'a Parameter>) -> Fault {
        let rivals: Vec<_> = rivals.map(|rival| rival.name).collect();
        let also: Vec<_> = parameter.aliases.iter().map(|alias| alias.name).collect();
        let also = if also.is_empty() { String::new() } else { format!(" (or {})", also.join(", ")) };
        let give = match &rivals[..] {
            [] => String::new(),
            [rest @ .., last] => {
                let first: Vec<_> = std::iter::once(parameter.name).chain(rest.iter().copied()).collect();
                format!("; give {} or {last}", first.join(", "))
            }
        };
        Fault::new(parameter.name, format!("missing{also}{give}; {}", parameter.domain()))
    }

    /// Every medium must have an index at the wavelength or be known at the frequency, and be clear where it has to be.
    fn media(&self, wavelength: f64, frequency: f64) -> Result<(), Fault> {
        for (at, (parameter, slot)) in self.parameters.iter().zip(&self.slots).enumerate() {
            let Some(value) = &slot.value else { continue };
            let text = || slot.text.as_deref().map_or_else(|| self.written(at), str::to_owned);
            check_media(&parameter.kind, value, &text, wavelength, frequency)
                .map_err(|fault| fault.within(slot.given.unwrap_or(parameter.name)))?;
        }
        Ok(())
    }

    /// What only the owners of the parameters know.
    fn validate(&self) -> Result<(), Fault> {
        self.parameters.iter().filter_map(|parameter| parameter.validate).try_for_each(|validate| validate(self))
    }

    /// The vacuum wavelength [m]: a parameter, or of the frequency that is one, or the default.
    pub fn wavelength(&self) -> f64 {
        let own = self.own_number(WAVELENGTH.name);
        own.or_else(|| self.own_frequency().map(|hertz| C / hertz)).unwrap_or(DEFAULT_WAVELENGTH)
    }

    /// The frequency [Hz]: a parameter, or of the wavelength that is one, or a gigahertz.
    pub fn frequency(&self) -> f64 {
        let of_wavelength = || self.own_number(WAVELENGTH.name).map(|metres| C / metres);
        self.own_frequency().or_else(of_wavelength).unwrap_or(DEFAULT_FREQUENCY)
    }

    fn own_frequency(&self) -> Option<f64> {
        let of_angular = || self.own_number("omega").map(|omega| omega / TAU);
        self.own_number(FREQUENCY.name).or_else(of_angular)
    }

    fn own_number(&self, name: &str) -> Option<f64> {
        let at = self.parameters.iter().position(|parameter| parameter.name == name)?;
        match self.slots[at].value {
            Some(Value::Number(value)) => Some(value),
            _ => None,
        }
    }

    /// The number named `name`, in SI.
    ///
    /// # Panics
    /// If it is not declared, not a number, or left out: a mistake in the chapter, not in its use.
    pub fn number(&self, name: &str) -> f64 {
        match self.get(name) {
            Some(Value::Number(value)) => *value,
            _ => panic!("no number `{name}` is declared"),
        }
    }

    /// The number named `name`, in SI, unless it was left out for another.
    ///
    /// # Panics
    /// If it is not declared as a number.
    pub fn optional(&self, name: &str) -> Option<f64> {
        self.get(name).map(|_| self.number(name))
    }

    /// The word chosen for `name`.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn word(&self, name: &str) -> &'static str {
        match self.get(name) {
            Some(Value::Word(word)) => word,
            _ => panic!("no choice `{name}` is declared"),
        }
    }

    /// The medium named `name`.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn medium(&self, name: &str) -> Medium {
        match self.get(name) {
            Some(Value::Medium(medium)) => *medium,
            _ => panic!("no medium `{name}` is declared"),
        }
    }

    /// The complex index [1] of the medium named `name` at the setting's wavelength.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn index(&self, name: &str) -> Complex64 {
        self.medium(name).index(self.wavelength()).expect("validated when it was set")
    }

    /// The medium named `name`, which may conduct.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn conductor(&self, name: &str) -> Conductor {
        match self.get(name) {
            Some(Value::Conductor(conductor)) => *conductor,
            _ => panic!("no conductor `{name}` is declared"),
        }
    }

    /// The three numbers named `name`, in SI.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn vector(&self, name: &str) -> [f64; 3] {
        match self.get(name) {
            Some(Value::Vector(numbers)) => *numbers,
            _ => panic!("no vector `{name}` is declared"),
        }
    }

    /// The list named `name`.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn list(&self, name: &str) -> &[Value] {
        match self.get(name) {
            Some(Value::List(items)) => items,
            _ => panic!("no list `{name}` is declared"),
        }
    }

    /// The vectors of the list named `name`.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn vectors(&self, name: &str) -> impl Iterator<Item = [f64; 3]> {
        self.list(name).iter().map(move |item| match item {
            Value::Vector(numbers) => *numbers,
            _ => panic!("`{name}` is not declared as a list of vectors"),
        })
    }

    /// The records of the list named `name`.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn records(&self, name: &str) -> impl Iterator<Item = &Setting> {
        self.list(name).iter().map(move |item| match item {
            Value::Record(fields) => fields,
            _ => panic!("`{name}` is not declared as a list of records"),
        })
    }

    /// The fields of the record named `name`.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn fields(&self, name: &str) -> &Setting {
        match self.get(name) {
            Some(Value::Record(fields)) => fields,
            _ => panic!("no record `{name}` is declared"),
        }
    }

    /// The text in force of the parameter `name`; empty if it was left out.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn text(&self, name: &str) -> Cow<'_, str> {
        self.text_at(self.at(name))
    }

    /// The name under which `name` was given, so that a fault stands where somebody wrote something; `None` if it was
    /// not.
    ///
    /// # Panics
    /// As [`Setting::number`].
    pub fn given(&self, name: &str) -> Option<&'static str> {
        self.slot(name).given
    }

    /// Parameters that have a value, with it and its text, in their order.
    pub fn entries(&self) -> impl Iterator<Item = (&'static Parameter, Cow<'_, str>, &Value)> {
        let entry = |(at, parameter)| Some((parameter, self.text_at(at), self.slots[at].value.as_ref()?));
        self.parameters.iter().enumerate().filter(|(at, _)| self.applies(*at)).filter_map(entry)
    }

    /// Every parameter that belongs to the words in force with its value, if it has one.
    pub fn values(&self) -> impl Iterator<Item = (&'static Parameter, Option<&Value>)> {
        let own = (0..self.slots.len()).filter(|at| self.applies(*at));
        own.map(|at| (&self.parameters[at], self.slots[at].value.as_ref()))
    }

    fn text_at(&self, at: usize) -> Cow<'_, str> {
        match &self.slots[at].text {
            Some(text) => Cow::Borrowed(text),
            None => Cow::Owned(self.written(at)),
        }
    }

    fn written(&self, at: usize) -> String {
        self.slots[at].value.as_ref().map_or(String::new(), |value| self.parameters[at].write(value))
    }

    fn get(&self, name: &str) -> Option<&Value> {
        self.slot(name).value.as_ref()
    }

    fn slot(&self, name: &str) -> &Slot {
        &self.slots[self.at(name)]
    }

    fn at(&self, name: &str) -> usize {
        let called = || (0..self.slots.len()).filter(|at| self.parameters[*at].name == name);
        called()
            .find(|at| self.applies(*at))
            .or_else(|| called().next())
            .unwrap_or_else(|| panic!("no parameter `{name}` is declared"))
    }
}

/// What is given, that which others belong to first.
fn choices_first<'a, T>(parameters: &[Parameter], given: &'a [(String, T)]) -> impl Iterator<Item = &'a (String, T)> {
    let is_choice =
        |name: &str| parameters.iter().filter_map(|other| other.only_with).any(|(choice, _)| choice == name);
    let (choices, rest): (Vec<_>, Vec<_>) = given.iter().partition(|(name, _)| is_choice(name));
    choices.into_iter().chain(rest)
}

impl PartialEq for Setting {
    fn eq(&self, other: &Self) -> bool {
        let values = |setting: &Self| -> Vec<_> {
            setting.values().map(|(parameter, value)| (parameter.name, value.cloned())).collect()
        };
        values(self) == values(other)
    }
}

const NO_SUCH_INPUT: &str = "no such input";

/// That the media in `value` are known and, where they have to be, clear.
fn check_media(
    kind: &Kind,
    value: &Value,
    text: &dyn Fn() -> String,
    wavelength: f64,
    frequency: f64,
) -> Result<(), Fault> {
    match (kind, value) {
        (_, Value::Conductor(conductor)) => {
            conductor.wave(frequency).map(drop).map_err(|unknown| Fault::new("", unknown))
        }
        (_, Value::Medium(medium)) => {
            let index = medium.index(wavelength).map_err(|out| Fault::new("", out.to_string()))?;
            match kind {
                Kind::ClearMedium if index.im != 0.0 => Err(Fault::new(
                    "",
                    format!("{} absorbs (k = {:.3}); this side needs a medium with k = 0", text(), index.im),
                )),
                _ => Ok(()),
            }
        }
        (Kind::List { of, .. }, Value::List(items)) => items.iter().enumerate().try_for_each(|(at, item)| {
            let text = || item.argument().to_string();
            check_media(of, item, &text, wavelength, frequency).map_err(|fault| fault.within(&format!("[{at}]")))
        }),
        (_, Value::Record(fields)) => {
            fields.media(wavelength, frequency)?;
            fields.validate()
        }
        _ => Ok(()),
    }
}
