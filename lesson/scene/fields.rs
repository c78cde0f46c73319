//! Reading a tree by keys: what is there, what it must be, and what is refused.

use super::keys::{Key, Later, Object, Type};
use super::source::Snag;
use super::tree::{Entry, Node, Value};
use chapters::parameter::{Fault, excerpt};
use light::scene::{Part, Place, Triple};

/// A value that is being read.
#[derive(Clone, Debug)]
pub struct Item<'t> {
    node: &'t Node,
    place: Place,
}

/// A table that is being read.
#[derive(Clone, Debug)]
pub struct Fields<'t> {
    table: Item<'t>,
    entries: &'t [Entry],
    /// What it describes.
    what: String,
    /// Its keys in groups; none if they are anything.
    keys: &'static [&'static [Key]],
}

impl<'t> Item<'t> {
    /// The whole text.
    pub fn root(node: &'t Node) -> Self {
        Self { node, place: Place::default() }
    }

    /// That it is not what it should be.
    pub fn wrong(&self, message: impl Into<String>) -> Snag {
        let is_all = self.place.parts().is_empty();
        let place = if is_all { "the scene".to_owned() } else { self.place.to_string() };
        Snag { span: (!is_all).then(|| self.node.span.clone()), fault: Fault::new(place, message) }
    }

    /// That it is not `expected`.
    pub fn must_be(&self, expected: &str) -> Snag {
        self.wrong(format!("must be {expected}, found {}", self.node.kind()))
    }

    fn part(&self, part: impl Into<Part>, node: &'t Node) -> Self {
        Self { node, place: self.place.clone().then(part) }
    }

    /// As a number.
    pub fn number(&self) -> Result<f64, Snag> {
        match self.node.value {
            Value::Number(number) => Ok(number),
            _ => Err(self.must_be("a number")),
        }
    }

    /// As a number of things.
    pub fn count(&self) -> Result<u32, Snag> {
        let number = self.number()?;
        match number.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&number) {
            true => Ok(number as u32),
            false => Err(self.must_be(&format!("a whole number from 0 to {}", u32::MAX))),
        }
    }

    /// As a text.
    pub fn text(&self) -> Result<&'t str, Snag> {
        match &self.node.value {
            Value::Text(text) => Ok(text),
            _ => Err(self.must_be("a text")),
        }
    }

    /// As a text that a terminal shows as it is.
    pub fn plain_text(&self) -> Result<&'t str, Snag> {
        let text = self.text()?;
        if text.chars().any(char::is_control) {
            return Err(self.wrong("has control characters; valid: letters and signs that can be seen"));
        }
        Ok(text)
    }

    /// As true or false.
    pub fn flag(&self) -> Result<bool, Snag> {
        match self.node.value {
            Value::Flag(flag) => Ok(flag),
            _ => Err(self.must_be("true or false")),
        }
    }

    /// As a list.
    pub fn list(&self) -> Result<Vec<Item<'t>>, Snag> {
        match &self.node.value {
            Value::List(list) => Ok(list.iter().enumerate().map(|(at, node)| self.part(at, node)).collect()),
            _ => Err(self.must_be("a list")),
        }
    }

    /// As a list of three numbers.
    pub fn triple(&self) -> Result<Triple, Snag> {
        let three = match &self.node.value {
            Value::List(list) if list.len() == 3 => self.list()?,
            _ => return Err(self.must_be("a list of three numbers")),
        };
        let numbers = three.iter().map(Item::number).collect::<Result<Vec<_>, _>>()?;
        Ok([numbers[0], numbers[1], numbers[2]])
    }

    /// As one of `words`, each with what it stands for.
    pub fn word<T: Copy>(&self, what: &str, words: &[(&str, T)]) -> Result<T, Snag> {
        let text = self.text()?;
        let known = words.iter().find(|(word, _)| *word == text);
        known.map(|(_, meant)| *meant).ok_or_else(|| {
            let message = format!("`{}` is no {what}", excerpt(text));
            let names = words.iter().map(|(word, _)| *word);
            Snag::at(self.node, Fault::unknown(self.place.to_string(), text, message, names))
        })
    }

    /// Whether it is a table.
    pub fn is_table(&self) -> bool {
        matches!(self.node.value, Value::Table(_))
    }

    /// Whether there is nothing, on purpose.
    pub fn is_null(&self) -> bool {
        self.node.value == Value::Null
    }

    /// The inner value of a table under one of these keys, if it is such a table.
    pub fn under(&self, keys: &[Later]) -> Option<Snag> {
        let Value::Table(entries) = &self.node.value else { return None };
        entries.iter().find_map(|entry| later(&self.place, entry, keys))
    }

    /// As a table that describes `what`, with any keys.
    pub fn table(self, what: &str) -> Result<Fields<'t>, Snag> {
        match &self.node.value {
            Value::Table(entries) => Ok(Fields { entries, what: what.to_owned(), keys: &[], table: self }),
            _ => Err(self.must_be("a table")),
        }
    }

    /// As a table that describes an object, with its keys and no others.
    pub fn fields(self, object: &Object) -> Result<Fields<'t>, Snag> {
        self.table(object.what)?.only(object.keys, object.later)
    }

    /// As a table that describes `what`, of the type that its key `type` names: one of `types`, with its keys and no others.
    pub fn of_type<R: Copy>(self, what: &str, types: &'static [Type<R>]) -> Result<(Fields<'t>, R), Snag> {
        let fields = self.table(what)?;
        let item = fields.must("type")?;
        let known: Vec<(&str, &Type<R>)> = types.iter().map(|kind| (kind.name, kind)).collect();
        let kind = item.word(&format!("type of {}", what.trim_start_matches("a ")), &known)?;
        let fields = Fields { what: format!("type `{}`", kind.name), ..fields };
        Ok((fields.only(kind.keys, kind.later)?, kind.read))
    }
}

/// That an entry is one of those that are not there yet.
fn later(place: &Place, entry: &Entry, keys: &[Later]) -> Option<Snag> {
    let (key, what) = keys.iter().find(|(key, _)| *key == entry.key)?;
    let message = format!("not yet: {what} cannot be used so far");
    Some(Snag { span: Some(entry.span.clone()), fault: Fault::new(place.clone().then(*key).to_string(), message) })
}

impl<'t> Fields<'t> {
    /// The same if it has none but these `keys`; else that one is unknown, or one of `not_yet`.
    fn only(self, keys: &'static [&'static [Key]], not_yet: &[Later]) -> Result<Self, Snag> {
        let place = &self.table.place;
        let known = |entry: &&Entry| keys.iter().copied().flatten().any(|key| key.name == entry.key);
        let Some(entry) = self.entries.iter().find(|entry| !known(entry)) else { return Ok(Self { keys, ..self }) };
        Err(later(place, entry, not_yet).unwrap_or_else(|| {
            let message = format!("no such key in {}", self.what);
            let place = place.clone().then(entry.key.as_str()).to_string();
            let fault =
                Fault::unknown(place, entry.key.as_str(), message, keys.iter().copied().flatten().map(|key| key.name));
            Snag { span: Some(entry.span.clone()), fault }
        }))
    }

    /// The value under `key`, if there is one.
    pub fn get(&self, key: &str) -> Option<Item<'t>> {
        debug_assert!(self.keys.is_empty() || self.key(key).is_some(), "{key} is no key of {}", self.what);
        self.entries.iter().find(|entry| entry.key == key).map(|entry| self.table.part(key, &entry.node))
    }

    /// All of them, in order.
    pub fn items(&self) -> impl Iterator<Item = (&'t str, Item<'t>)> + '_ {
        self.entries.iter().map(|entry| (entry.key.as_str(), self.table.part(entry.key.as_str(), &entry.node)))
    }

    /// What `read` makes of the value under `key`, if there is one.
    pub fn may<T>(&self, key: &str, read: impl FnOnce(&Item<'t>) -> Result<T, Snag>) -> Result<Option<T>, Snag> {
        self.get(key).map(|item| read(&item)).transpose()
    }

    /// The value under `key`, which must be there.
    pub fn must(&self, key: &str) -> Result<Item<'t>, Snag> {
        self.get(key).ok_or_else(|| self.missing(key))
    }

    /// That there is no value under `key`.
    pub fn missing(&self, key: &str) -> Snag {
        let mut missing = self.table.wrong(format!("missing, and {} needs it", self.what));
        missing.fault.place = self.table.place.clone().then(key).to_string();
        missing
    }

    /// What is known of a key.
    fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().copied().flatten().find(|key| key.name == name)
    }

    /// Three numbers under `key`.
    pub fn triple(&self, key: &str) -> Result<Triple, Snag> {
        self.must(key)?.triple()
    }

    /// A number under `key`.
    pub fn number(&self, key: &str) -> Result<f64, Snag> {
        self.must(key)?.number()
    }

    /// That a key stands where it has nothing to say.
    pub fn idle(&self, key: &str, why: &str) -> Result<(), Snag> {
        match self.get(key) {
            Some(item) => Err(item.wrong(why)),
            None => Ok(()),
        }
    }
}
