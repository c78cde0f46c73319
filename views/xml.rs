//! Text inside markup.

/// Text that may stand in HTML and in XML 1.0, in attributes too: reserved characters as entities, forbidden ones left out.
pub fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            '\u{FFFE}' | '\u{FFFF}' => {}
            // Line ends and tabs would not survive in attributes as they are.
            '\t' | '\n' | '\r' => safe.push(' '),
            _ if character.is_control() => {}
            _ => safe.push(character),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_xml_forbids_is_left_out() {
        assert_eq!(escape("a<b & c>\u{1}\u{FFFE}"), "a&lt;b &amp; c&gt;");
    }
}
