//! A tree from TOML.

use super::tree::{Entry, Malformed, Node, Value};
use toml::Spanned;
use toml::de::{DeFloat, DeInteger, DeTable, DeValue};

/// Reads a document.
pub fn parse(text: &str) -> Result<Node, Malformed> {
    match DeTable::parse(text) {
        Ok(table) => Ok(Node { span: 0..0, value: self::table(table.into_inner()) }),
        Err(error) => Err(Malformed { why: told(error.message()), span: error.span().unwrap_or_default() }),
    }
}

/// What people do, as the parser begins to say it, and as we say it.
const TOLD: &[(&[&str], &str)] = &[
    (&["duplicate key"], "duplicate key; valid: each once in its table"),
    (&["unclosed table"], "a table's name without an end; valid: [name]"),
    (&["unclosed array table"], "a table's name without an end; valid: [[name]]"),
    (&["unclosed array"], "a list without an end; valid: a comma, or ]"),
    (&["unclosed inline table"], "a table without an end; valid: a comma, or }"),
    (&["key with no value", "missing value", "missing assignment"], "a key without a value; valid: key = value, # why"),
    (&["extra `=`", "extra assignment"], "one = too many; valid: key = value"),
    (&["unexpected `=`"], "= in a list; valid: values with commas between them"),
    // It takes for an unquoted text whatever is no other value, and nothing too.
    (&["string values must be quoted"], "no value; valid: one number, list, true, false, or \"text\" in quotes; # why"),
    (&["invalid boolean"], "a word without quotes; valid: true, false, \"text\""),
    (&["unexpected key or value"], "more than a key and its value; valid: one key = value a line"),
    (&["missing comma"], "no comma between two values"),
    (&["extra comma"], "one comma too many"),
    (&["invalid basic string"], "a text without an end; valid: \"text\" on one line"),
    (&["invalid literal string"], "a text without an end; valid: 'text' on one line"),
    (&["missing escaped value"], "\\ before a sign that it does not go with; valid: \\\\ for \\"),
    (&["invalid unquoted key"], "a key of other signs than letters, digits, _ and -; valid: \"key\" in quotes"),
    (
        &["unquoted keys cannot be empty", "missing key", "invalid key-value pair"],
        "no key; valid: key = value, or [name]",
    ),
    (&["unexpected leading zero"], "a number that begins with 0; valid: without that"),
    (
        &["invalid mantissa", "invalid fraction", "invalid exponent", "invalid float", "invalid integer"],
        "no number; valid: such as 1, -2.5, 0.5, 1e-3",
    ),
    (&["`_` may only go between digits"], "_ that is not between two digits"),
    (&["cannot recurse further"], "tables or lists nested too deep"),
];

/// The parser's sentence as ours. What it says in lines of their own, and what it says of nothing, is no sentence.
fn told(message: &str) -> String {
    let known = TOLD.iter().find(|(theirs, _)| theirs.iter().any(|theirs| message.starts_with(theirs)));
    let plain = || message.lines().collect::<Vec<_>>().join("; ").replace(", expected nothing", "");
    known.map_or_else(plain, |(_, ours)| (*ours).to_owned())
}

fn node(value: Spanned<DeValue>) -> Node {
    let span = value.span();
    let value = match value.into_inner() {
        DeValue::String(text) => Value::Text(text.into_owned()),
        DeValue::Integer(number) => Value::Number(whole(&number)),
        DeValue::Float(number) => Value::Number(float(&number)),
        DeValue::Boolean(flag) => Value::Flag(flag),
        DeValue::Datetime(_) => Value::Date,
        DeValue::Array(list) => Value::List(list.into_iter().map(node).collect()),
        DeValue::Table(of) => table(of),
    };
    Node { span, value }
}

/// Entries in the order of the text, which the parser's are not.
fn table(table: DeTable) -> Value {
    let entry = |(key, value): (Spanned<_>, _)| {
        let span = key.span();
        let key: std::borrow::Cow<str> = key.into_inner();
        Entry { key: key.into_owned(), span, node: node(value) }
    };
    let mut entries: Vec<_> = table.into_iter().map(entry).collect();
    entries.sort_by_key(|entry| entry.span.start);
    Value::Table(entries)
}

/// A whole number; beyond 128 bits it is as good as infinite.
fn whole(number: &DeInteger) -> f64 {
    let text = number.as_str();
    match i128::from_str_radix(text, number.radix()) {
        Ok(number) => number as f64,
        Err(_) if text.starts_with('-') => f64::NEG_INFINITY,
        Err(_) => f64::INFINITY,
    }
}

fn float(number: &DeFloat) -> f64 {
    // The parser has taken out what `f64` cannot read.
    number.as_str().parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shows a tree without its places.
    pub fn shown(node: &Node) -> String {
        match &node.value {
            Value::List(list) => format!("[{}]", list.iter().map(shown).collect::<Vec<_>>().join(", ")),
            Value::Table(entries) => {
                let entry = |entry: &Entry| format!("{}: {}", entry.key, shown(&entry.node));
                format!("{{{}}}", entries.iter().map(entry).collect::<Vec<_>>().join(", "))
            }
            Value::Text(text) => format!("{text:?}"),
            Value::Number(number) => number.to_string(),
            other => format!("{other:?}"),
        }
    }

    #[test]
    fn every_kind_of_value_is_read_in_the_order_of_the_text() {
        let text = "z = [1, -0, 0xff, 1_000]\na = +1.5e3\n[m.\"b c\"]\nt = 'x'\n[m.a]\nd = 2020-01-01\nf = true\n[[s]]\n[[s]]\nn = nan\n";
        let tree = parse(text).unwrap();
        let expected =
            "{z: [1, 0, 255, 1000], a: 1500, m: {b c: {t: \"x\"}, a: {d: Date, f: Flag(true)}}, s: [{}, {n: NaN}]}";
        assert_eq!(shown(&tree), expected);
    }

    #[test]
    fn numbers_too_large_are_infinite() {
        let text = format!("a = 1e999\nb = -{}\nc = 170141183460469231731687303715884105728", "9".repeat(100));
        assert_eq!(shown(&parse(&text).unwrap()), "{a: inf, b: -inf, c: inf}");
    }

    #[test]
    fn what_is_no_toml_is_refused_where_it_shows() {
        let refused = |text: &str| parse(text).unwrap_err().span;
        assert_eq!(refused("a = 1\na = 2"), 6..7);
        assert_eq!(refused("[a]\n[a]"), 5..6);
        assert_eq!(refused("a = 1.\n"), 6..6);
        // As deep as no scene is; the parser's own stack is safe.
        assert!(parse(&format!("a = {}", "[".repeat(100_000))).is_err());
    }

    #[test]
    fn what_people_do_is_said_in_words_of_ours() {
        for (text, said) in [
            ("a = [1, 2", "a list without an end"),
            ("a = [1, 2\nb = 3", "no comma between"),
            ("a = [1,,2]", "one comma too many"),
            ("[a\nb = 1", "a table's name without an end; valid: [name]"),
            ("[[a]\n", "a table's name without an end; valid: [[name]]"),
            ("a = {b = 1", "a table without an end"),
            ("a", "a key without a value"),
            ("a : 1", "a key without a value"),
            ("// why", "valid: key = value, # why"),
            ("a =", "no value; valid: "),
            ("a = red", "\"text\" in quotes"),
            ("a = 1 m", "valid: one number"),
            ("a = True", "valid: true, false"),
            ("a == 1", "one = too many"),
            ("a = [b = 1]", "= in a list"),
            ("a = 1,", "valid: one key = value a line"),
            ("a = 'x", "a text without an end"),
            ("a = \"x", "a text without an end"),
            ("a = \"C:\\q\"", "valid: \\\\ for \\"),
            ("é = 1", "valid: \"key\" in quotes"),
            ("{\"a\": 1}", "no key"),
            ("a = 01", "begins with 0"),
            ("a = .5", "no number; valid: "),
            ("a = 1e", "no number; valid: "),
        ] {
            let why = parse(text).unwrap_err().why;
            assert!(why.contains(said) && !why.contains("expected"), "{text}: {why}");
        }
        // What is not in the table is told as the parser has it.
        assert_eq!(told("flux of a new kind, expected nothing"), "flux of a new kind");
    }
}
