//! What the lecture says in other languages: English stays in the chapters, and is the default.

use super::Phrase;
use std::borrow::Cow;

/// Looks up what is shown. An entry is named by the address of what says it (`fresnel/energy/r_plus_t`; `views` for
/// the words around it) and the field that it stands in (`claim`); the English text itself comes along, so that a
/// catalogue can tell what has become stale, and fall back on it.
pub trait Catalogue {
    /// The text to show, in the markup of chapters; Markdown where `english` is.
    fn text<'a>(&'a self, address: &str, field: &str, english: &'a str) -> Cow<'a, str>;

    /// The same, read.
    fn phrase(&self, address: &str, field: &str, english: &str) -> Phrase {
        Phrase::parse(&self.text(address, field, english))
    }
}

/// The lecture as it was written.
#[derive(Clone, Copy, Debug, Default)]
pub struct English;

impl Catalogue for English {
    fn text<'a>(&'a self, _: &str, _: &str, english: &'a str) -> Cow<'a, str> {
        Cow::Borrowed(english)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Other;

    impl Catalogue for Other {
        fn text<'a>(&'a self, address: &str, field: &str, english: &'a str) -> Cow<'a, str> {
            match (address, field) {
                ("fresnel", "title") => "界面 R_s".into(),
                _ => english.into(),
            }
        }
    }

    #[test]
    fn what_a_catalogue_lacks_stays_english() {
        assert_eq!(Other.phrase("fresnel", "title", "x").to_string(), "界面 Rₛ");
        assert_eq!(Other.phrase("fresnel", "says", "of R_s").to_string(), "of Rₛ");
        assert_eq!(English.phrase("fresnel", "title", "1e3").to_string(), "10³");
    }
}
