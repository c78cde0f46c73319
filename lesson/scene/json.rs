//! A tree from JSON.

use super::tree::{Entry, Malformed, Node, Value};
use jsonc_parser::ast::{self, ObjectProp};
use jsonc_parser::common::{Range, Ranged};
use jsonc_parser::errors::ParseErrorKind;
use jsonc_parser::{CollectOptions, ParseOptions, ParseStringErrorKind, parse_to_ast};

/// RFC 8259 and nothing else: what only some readers take is no contract.
const STRICT: ParseOptions = ParseOptions {
    allow_comments: false,
    allow_loose_object_property_names: false,
    allow_trailing_commas: false,
    allow_missing_commas: false,
    allow_single_quoted_strings: false,
    allow_hexadecimal_numbers: false,
    allow_unary_plus_numbers: false,
    allow_bare_decimal_point_numbers: false,
    allow_non_finite_numbers: false,
    allow_extended_string_escapes: false,
};

/// Reads a text. It may be nested 512 deep, which the parser sees to.
pub fn parse(text: &str) -> Result<Node, Malformed> {
    let parsed = parse_to_ast(text, &CollectOptions::default(), &STRICT)
        .map_err(|error| Malformed { why: told(error.kind()), span: span(error.range()) })?;
    match parsed.value {
        Some(value) => node(value),
        None => Err(Malformed { why: "there is no value".into(), span: 0..0 }),
    }
}

fn span(range: Range) -> std::ops::Range<usize> {
    range.start..range.end
}

/// The parser's sentence as ours.
fn told(kind: &ParseErrorKind) -> String {
    use ParseErrorKind::*;
    let ours = match kind {
        CommentsNotAllowed | UnterminatedCommentBlock => "a comment, which JSON has not; TOML has: # why",
        ExpectedColonAfterObjectKey => "a key without a colon; valid: \"key\": value",
        ExpectedObjectValue => "a key without a value; valid: \"key\": value",
        ExpectedStringObjectProperty => "a key without quotes; valid: \"key\": value",
        ExpectedComma => "no comma between two values",
        TrailingCommasNotAllowed => "a comma after the last value; valid: none",
        UnexpectedComma => "one comma too many",
        SingleQuotedStringsNotAllowed => "a text in single quotes; valid: \"text\"",
        MultipleRootJsonValues => "more than one value; valid: one table { … }",
        NonFiniteNumbersNotAllowed | UnexpectedWord | UnexpectedToken => {
            "a word without quotes; valid: true, false, null, \"text\""
        }
        HexadecimalNumbersNotAllowed
        | UnaryPlusNumbersNotAllowed
        | BareDecimalPointNumbersNotAllowed
        | ExpectedDigit
        | ExpectedDigitFollowingNegativeSign
        | ExpectedPlusMinusOrDigitInNumberLiteral => "no number; valid: such as 1, -2.5, 0.5, 1e-3",
        UnterminatedArray => "a list without an end; valid: a comma, or ]",
        UnterminatedObject => "a table without an end; valid: a comma, or }",
        UnexpectedCloseBrace => "} that closes nothing",
        UnexpectedCloseBracket => "] that closes nothing",
        NestingDepthExceeded => "tables or lists nested too deep",
        String(ParseStringErrorKind::UnterminatedStringLiteral) => "a text without an end; valid: \"text\" on one line",
        other => return first_small(&other.to_string()),
    };
    ours.to_owned()
}

/// The parser's sentence as the end of one of ours.
fn first_small(sentence: &str) -> String {
    let mut rest = sentence.chars();
    rest.next().map_or(String::new(), |first| first.to_lowercase().chain(rest).collect())
}

fn node(value: ast::Value) -> Result<Node, Malformed> {
    let span = span(value.range());
    let value = match value {
        ast::Value::NullKeyword(_) => Value::Null,
        ast::Value::BooleanLit(flag) => Value::Flag(flag.value),
        ast::Value::NumberLit(number) => Value::Number(number.value.parse().unwrap_or(f64::NAN)),
        ast::Value::StringLit(text) => Value::Text(text.value.into_owned()),
        ast::Value::Array(list) => Value::List(list.elements.into_iter().map(node).collect::<Result<_, _>>()?),
        ast::Value::Object(table) => Value::Table(entries(table.properties)?),
    };
    Ok(Node { span, value })
}

fn entries(properties: Vec<ObjectProp>) -> Result<Vec<Entry>, Malformed> {
    let mut seen = std::collections::HashSet::new();
    let entry = |property: ObjectProp| {
        let span = span(property.name.range());
        let key = property.name.into_string();
        match seen.insert(key.clone()) {
            true => Ok(Entry { key, span, node: node(property.value)? }),
            false => Err(Malformed { why: "duplicate key".into(), span }),
        }
    };
    properties.into_iter().map(entry).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_value_is_read_where_it_stands() {
        let text = r#"{"a": [1, -2.5e1, 1e999], "b\u0020": {"t": "xé"}, "n": null, "f": true}"#;
        let Value::Table(entries) = parse(text).unwrap().value else { panic!("no table") };
        let keys: Vec<_> = entries.iter().map(|entry| (entry.key.as_str(), &text[entry.node.span.clone()])).collect();
        assert_eq!(keys, [("a", "[1, -2.5e1, 1e999]"), ("b ", r#"{"t": "xé"}"#), ("n", "null"), ("f", "true")]);
        let Value::List(list) = &entries[0].node.value else { panic!("no list") };
        let numbers = list.iter().map(|node| match node.value {
            Value::Number(number) => number,
            _ => panic!("{node:?}"),
        });
        assert_eq!(numbers.collect::<Vec<_>>(), [1.0, -25.0, f64::INFINITY]);
    }

    #[test]
    fn what_is_no_json_is_refused_where_it_shows() {
        for (text, why, at) in [
            (r#"{"a": 1, "a": 2}"#, "duplicate key", 9..12),
            (r#"{"a": 1,}"#, "a comma after the last value; valid: none", 7..8),
            (r#"{"a": NaN}"#, "a word without quotes; valid: true, false, null, \"text\"", 6..9),
            ("// why", "a comment, which JSON has not; TOML has: # why", 0..6),
            ("{} {}", "more than one value; valid: one table { … }", 3..4),
            ("", "there is no value", 0..0),
            ("{'a': 1}", "a text in single quotes; valid: \"text\"", 1..2),
        ] {
            assert_eq!(parse(text), Err(Malformed { why: why.into(), span: at }), "{text}");
        }
        assert!(parse(&"[".repeat(1_000_000)).is_err());
        assert!(parse(&r#"{"a":"#.repeat(1_000_000)).is_err());
    }
}
