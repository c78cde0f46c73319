//! A value as somebody gives it: on the command line, in JSON, in a scene file, from Python.

use super::excerpt;
use serde::de::{self, Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::fmt;

/// A value before anybody has asked what it should be. Every format is read into it (it is `Deserialize`), and every
/// value and description is written through it (it is `Serialize`).
#[derive(Clone, Debug, PartialEq)]
pub enum Argument {
    /// A number.
    Number(f64),
    /// A string.
    Text(String),
    /// A list.
    List(Vec<Argument>),
    /// Named fields. Two of one name are for the reader to refuse, who stops at the first name that is not known: to
    /// compare all names here would take a hostile megabyte the square of its length.
    Record(Vec<(String, Argument)>),
    /// What no parameter can be: `true`, `false`, `null`.
    Other,
}

impl Argument {
    /// From a command line: JSON where it looks structured, otherwise text.
    ///
    /// # Errors
    /// What is wrong with the JSON, and in which column.
    pub fn from_text(text: &str) -> Result<Self, String> {
        match text.trim_start().starts_with(['[', '{', '"']) {
            true => Self::from_json(text),
            false => Ok(Self::Text(text.to_owned())),
        }
    }

    /// From JSON. Lists nested deeper than any parameter are refused by the reader.
    ///
    /// # Errors
    /// What is wrong with it, and in which column.
    pub fn from_json(text: &str) -> Result<Self, String> {
        serde_json::from_str(text).map_err(|error| reason(&error))
    }

    /// A list of texts.
    pub fn words<'a>(words: impl IntoIterator<Item = &'a str>) -> Self {
        Self::List(words.into_iter().map(Self::from).collect())
    }

    /// Named fields.
    pub fn record<'a>(fields: impl IntoIterator<Item = (&'a str, Self)>) -> Self {
        Self::Record(fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
    }

    /// What it is, for a message: numbers and texts as they were given, at most 40 characters.
    pub(super) fn excerpt(&self) -> String {
        match self {
            Self::Number(value) => shortest(*value),
            Self::Text(text) => excerpt(text),
            _ => String::new(),
        }
    }
}

impl From<f64> for Argument {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<&str> for Argument {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Argument {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

/// As it would stand on a command line.
impl fmt::Display for Argument {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => f.write_str(&shortest(*value)),
            Self::Text(text) => f.write_str(text),
            _ => f.write_str(&serde_json::to_string(self).map_err(|_| fmt::Error)?),
        }
    }
}

/// The shorter of decimals and powers of ten, to the last digit.
pub(super) fn shortest(value: f64) -> String {
    format!("{value:?}").trim_end_matches(".0").to_owned()
}

/// serde_json's message, with the place in the text if it is at one.
pub fn reason(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let message = text.split(" at line ").next().unwrap_or(&text);
    match (error.line(), error.column()) {
        (_, 0) => message.to_owned(),
        (0 | 1, column) => format!("{message} (column {column})"),
        (line, column) => format!("{message} (line {line}, column {column})"),
    }
}

impl Serialize for Argument {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(value) if value.is_nan() => serializer.serialize_str("nan"),
            Self::Number(value) if value.is_infinite() => {
                serializer.serialize_str(if *value > 0.0 { "inf" } else { "-inf" })
            }
            Self::Number(value) => serializer.serialize_f64(*value),
            Self::Text(text) => serializer.serialize_str(text),
            Self::List(items) => serializer.collect_seq(items),
            Self::Record(fields) => {
                let mut map = serializer.serialize_map(Some(fields.len()))?;
                fields.iter().try_for_each(|(name, value)| map.serialize_entry(name, value))?;
                map.end()
            }
            Self::Other => serializer.serialize_unit(),
        }
    }
}

impl<'de> Deserialize<'de> for Argument {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Reader)
    }
}

struct Reader;

impl<'de> Visitor<'de> for Reader {
    type Value = Argument;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a number, a text, a list or an object")
    }

    fn visit_bool<E: de::Error>(self, _: bool) -> Result<Argument, E> {
        Ok(Argument::Other)
    }

    fn visit_unit<E: de::Error>(self) -> Result<Argument, E> {
        Ok(Argument::Other)
    }

    fn visit_none<E: de::Error>(self) -> Result<Argument, E> {
        Ok(Argument::Other)
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Argument, E> {
        Ok(Argument::Number(value))
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Argument, E> {
        Ok(Argument::Number(value as f64))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Argument, E> {
        Ok(Argument::Number(value as f64))
    }

    fn visit_str<E: de::Error>(self, value: &str) -> Result<Argument, E> {
        Ok(Argument::Text(value.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Argument, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element()? {
            list.push(item);
        }
        Ok(Argument::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Argument, A::Error> {
        let mut fields: Vec<(String, Argument)> = Vec::new();
        while let Some(name) = entries.next_key::<String>()? {
            fields.push((name, entries.next_value()?));
        }
        Ok(Argument::Record(fields))
    }
}
