//! The keys of scene files, told: from the tables by which they are read.

use super::keys::{CAMERA, COATING, ENVIRONMENT, Key, Kind, Later, Need, Object, PATTERN, SCENE, TRANSFORM, Type};
use super::read::{LIGHTS, MATERIALS, SHAPES};
use chapters::text::Phrase;
use views::block::{Block, Heading, Rank, Span, Term, Terms, Tone};

/// A table of a scene file.
pub struct Told {
    /// How it begins in TOML.
    pub header: String,
    /// The word under `type`, if it has that key.
    pub kind: Option<&'static str>,
    pub keys: Vec<&'static Key>,
    pub later: &'static [Later],
}

/// Every table that a scene file may have, in the order in which one would write it.
pub fn tables() -> Vec<Told> {
    fn of(header: &str, object: &Object) -> Told {
        let keys = object.keys.iter().copied().flatten().collect();
        Told { header: header.to_owned(), kind: None, keys, later: object.later }
    }
    fn typed<R>(header: &str, types: &'static [Type<R>]) -> Vec<Told> {
        let told = |kind: &'static Type<R>| Told {
            header: header.to_owned(),
            kind: Some(kind.name),
            keys: kind.keys.iter().copied().flatten().collect(),
            later: kind.later,
        };
        types.iter().map(told).collect()
    }
    let mut all = vec![of("", &SCENE), of("[camera]", &CAMERA), of("[environment]", &ENVIRONMENT)];
    all.extend(typed("[materials.NAME]", MATERIALS));
    all.push(of("[materials.NAME.reflectance]", &PATTERN));
    all.push(of("[materials.NAME.coating]", &COATING));
    all.extend(typed("[[shapes]]", SHAPES));
    all.push(of("[shapes.transform]", &TRANSFORM));
    all.extend(typed("[[lights]]", LIGHTS));
    all
}

/// All of them, to be shown.
pub fn blocks() -> Vec<Block> {
    tables().iter().map(block).collect()
}

fn block(told: &Told) -> Block {
    let header = match (told.header.as_str(), told.kind) {
        ("", _) => "at the top".to_owned(),
        (header, None) => header.to_owned(),
        (header, Some(kind)) => format!("{header}  type = \"{kind}\""),
    };
    let heading = Heading {
        rank: Rank::Entry,
        text: vec![Span::verbatim(Tone::Heading, header)],
        address: None,
        rows: Vec::new(),
    };
    let term = |name: &str, says: String| Term {
        name: Span::verbatim(Tone::Code, name),
        says: vec![Span::new(Tone::Plain, Phrase::verbatim(says))],
        note: None,
    };
    let keys = told.keys.iter().filter(|key| told.kind.is_none() || key.name != "type");
    let keys = keys.map(|key| term(key.name, says(key)));
    let later = told.later.iter().map(|(key, what)| term(key, format!("not yet: {}", what.trim_end_matches(','))));
    let items = keys.chain(later).collect();
    Block::section(vec![Block::Group(vec![Block::Heading(heading), Block::Terms(Terms { width: Some(14), items })])])
}

/// What is known of a key, in a line.
fn says(key: &Key) -> String {
    let need = match key.need {
        Need::Must => "needed".to_owned(),
        Need::May(default) => format!("left out: {default}"),
        Need::Unless(other) => format!("needed without {other}"),
    };
    format!("{}; {}; {need}", key.says, kind(key.kind))
}

fn kind(kind: Kind) -> String {
    match kind {
        Kind::Number(domain) => format!("number, {domain}"),
        Kind::Three(domain) => format!("three numbers, {domain}"),
        Kind::Size(domain) => format!("number or three, {domain}"),
        Kind::Corners(domain) => format!("four lists of three numbers, {domain}"),
        Kind::Pair(domain) => format!("two lists of three numbers, {domain}"),
        Kind::ThreeOr(domain, table) => format!("three numbers, {domain}, or table: {table}"),
        Kind::Count => "whole number, at least 1".to_owned(),
        Kind::Flag => "true or false".to_owned(),
        Kind::Text => "text".to_owned(),
        Kind::Word(words) => format!("one of {}", words().join(", ")),
        Kind::Table(what) => format!("table: {what}"),
        Kind::Tables(what) => format!("tables: {what}"),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::from_toml;
    use super::super::toml;
    use super::*;
    use crate::stop::Stop;
    use light::scene::Scene;
    use std::path::Path;

    /// A value that is valid under a key.
    fn sample(key: &Key) -> String {
        let value = match (key.name, key.kind) {
            ("target" | "min", _) => "[0, 0, 0]",
            ("material", _) => "\"m\"",
            ("file", _) => "\"x.obj\"",
            ("image", _) => "\"sky.hdr\"",
            (_, Kind::Number(_) | Kind::Count) => "1",
            (_, Kind::Three(_) | Kind::Size(_) | Kind::ThreeOr(..)) => "[1, 1, 1]",
            (_, Kind::Pair(_)) => "[[1, 1, 1], [0, 0, 0]]",
            (_, Kind::Corners(_)) => "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]",
            (_, Kind::Flag) => "true",
            (_, Kind::Text) => "\"a\"",
            (_, Kind::Word(words)) => return format!("{:?}", words()[0]),
            (_, Kind::Table(_) | Kind::Tables(_)) => panic!("{}", key.name),
        };
        value.to_owned()
    }

    /// Whether a table is whole only with this key, where keys that stand for each other are there by the first.
    fn is_needed(told: &Told, key: &Key) -> bool {
        let at = |name: &str| told.keys.iter().position(|key| key.name == name);
        match key.need {
            Need::Must => true,
            Need::May(_) => false,
            Need::Unless(other) => at(key.name) < at(other),
        }
    }

    /// A scene with a table that has what it needs, and this key besides.
    fn scene(told: &Told, besides: Option<(&str, &str)>) -> Result<Scene, Stop> {
        let mut lines = Vec::new();
        for key in &told.keys {
            let value = match besides {
                Some((name, value)) if name == key.name => value.to_owned(),
                _ if key.name == "type" => format!("{:?}", told.kind.expect("it has a type")),
                _ if !is_needed(told, key) || matches!(key.kind, Kind::Table(_)) => continue,
                _ => sample(key),
            };
            lines.push(format!("{} = {value}\n", key.name));
        }
        let own = lines.concat();
        let has_camera = told.header == "[camera]" || besides.is_some_and(|(name, _)| name == "camera");
        let has_materials = besides.is_some_and(|(name, _)| name == "materials");
        let camera = "[camera]\norigin = [0, 0, 9]\ntarget = [0, 0, 0]\nfov_y_deg = 1\nwidth = 1\nheight = 1\n";
        let before = match told.header.as_str() {
            "[materials.NAME.reflectance]" => "[materials.NAME]\ntype = \"diffuse\"\n",
            "[materials.NAME.coating]" => "[materials.NAME]\ntype = \"conductor\"\nmetal = \"gold\"\n",
            "[shapes.transform]" => "[[shapes]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n",
            _ => "",
        };
        let text = [
            if told.header.is_empty() { &own } else { "" },
            if has_camera { "" } else { camera },
            if has_materials { "" } else { "[materials.m]\ntype = \"mirror\"\nreflectance = [1, 1, 1]\n" },
            before,
            &if told.header.is_empty() { String::new() } else { format!("{}\n{own}", told.header) },
        ];
        let files = |file: &Path| match file.extension() {
            Some(extension) if extension == "hdr" => Ok(b"#?RADIANCE\n\n-Y 1 +X 1\n\x80\x80\x80\x81".to_vec()),
            _ => Ok(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec()),
        };
        from_toml(&text.concat(), &files)
    }

    /// Every key that can be tried alone, with the table that has it.
    fn each(mut attempt: impl FnMut(&Told, &Key, &str)) {
        for told in tables() {
            let whole = scene(&told, None);
            assert!(whole.is_ok(), "{} {:?}: {}", told.header, told.kind, whole.unwrap_err());
            for key in &told.keys {
                let is_alone = is_needed(&told, key) || matches!(key.need, Need::May(_));
                if is_alone && key.name != "type" {
                    attempt(&told, key, &format!("{} {:?} {}", told.header, told.kind, key.name));
                }
            }
        }
    }

    #[test]
    fn what_holds_without_a_key_is_what_is_told() {
        let mut count = 0;
        each(|told, key, place| {
            if let Need::May(default) = key.need
                && toml::parse(&format!("x = {default}")).is_ok()
            {
                let [with, without] = [Some((key.name, default)), None].map(|besides| scene(told, besides).ok());
                // What says nothing without its fellow is refused without it.
                assert!(key.name == "two_sided" || with == without, "{place} is not {default}");
                count += 1;
            }
        });
        assert!(count > 20, "{count}");
    }

    #[test]
    fn the_kind_that_is_told_is_the_one_that_is_read() {
        each(|told, key, place| {
            let (wrong, said) = match key.kind {
                Kind::Number(_) | Kind::Count => ("true", "must be a number, found true"),
                Kind::Three(_) | Kind::ThreeOr(..) => ("1", "must be a list of three numbers"),
                Kind::Pair(_) => ("[[1, 1, 1]]", "must be two colours, found 1"),
                Kind::Size(_) => ("true", "must be a number or a list of three"),
                Kind::Corners(_) => ("[[0, 0, 0]]", "must be four corners"),
                Kind::Flag => ("1", "must be true or false"),
                Kind::Text | Kind::Word(_) => ("1", "must be a text"),
                Kind::Table(_) => ("1", "must be a table"),
                Kind::Tables(_) => ("1", "must be a "),
            };
            let refusal = scene(told, Some((key.name, wrong))).map(drop).unwrap_err().to_string();
            assert!(refusal.contains(said), "{place}: {refusal}");
        });
    }

    #[test]
    fn the_range_that_is_told_is_the_one_that_holds() {
        each(|told, key, place| {
            let (far, said) = match key.kind {
                Kind::Number(domain) => ("1e300", format!("valid: {domain}")),
                Kind::Three(domain) | Kind::ThreeOr(domain, _) => ("[1, 1e300, 1]", format!("valid: {domain}")),
                Kind::Pair(domain) => ("[[1, 1, 1], [1, 1e300, 1]]", format!("valid: {domain}")),
                Kind::Size(domain) => ("1e300", format!("valid: {domain}")),
                Kind::Corners(domain) => {
                    ("[[1e300, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]", format!("valid: {domain}"))
                }
                Kind::Count => ("0", "0 is out of range; valid: at least 1".to_owned()),
                Kind::Word(words) => ("\"no such word\"", words()[0].to_owned()),
                Kind::Flag | Kind::Text | Kind::Table(_) | Kind::Tables(_) => return,
            };
            let refusal = scene(told, Some((key.name, far))).map(drop).unwrap_err().to_string();
            assert!(refusal.contains(&said), "{place}: {refusal}");
        });
    }
}
