//! Phrases and spans inside a line of HTML.

use crate::block::{Span, Tone};
use crate::xml::escape;
use chapters::text::{Phrase, Piece, Script, Shift};

/// A phrase inside a line.
pub fn phrase(phrase: &Phrase) -> String {
    phrase.0.iter().map(piece).collect()
}

fn piece(piece: &Piece) -> String {
    match piece {
        Piece::Plain(text) => escape(text),
        Piece::Symbol { base, scripts } => {
            let scripts: String = scripts.iter().map(script).collect();
            match base.chars().any(char::is_alphabetic) {
                true => format!("<var>{}</var>{scripts}", escape(base)),
                false => escape(base) + &scripts,
            }
        }
        Piece::Number { factor, power } => {
            let factor = if factor.is_empty() { String::new() } else { escape(factor) + "·" };
            format!("{factor}10<sup>{}</sup>", escape(power))
        }
        Piece::Emphasis(of) => element("em", &phrase(of)),
        Piece::Strong(of) => element("strong", &phrase(of)),
        Piece::Code(of) => element("code", &phrase(of)),
    }
}

fn script(script: &Script) -> String {
    let name = if script.shift == Shift::Lowered { "sub" } else { "sup" };
    // What is raised needs no brackets to hold it together.
    element(name, &phrase(&script.of))
}

fn element(name: &str, inner: &str) -> String {
    format!("<{name}>{inner}</{name}>")
}

/// Spans inside a line.
pub fn spans(spans: &[Span]) -> String {
    spans.iter().map(span).collect()
}

/// A span inside a line.
pub fn span(span: &Span) -> String {
    let text = match &span.mathml {
        Some(math) => math.replacen(r#"display="block""#, r#"display="inline""#, 1),
        None => phrase(&span.text),
    };
    if text.is_empty() {
        return text;
    }
    match span.tone {
        Tone::Plain | Tone::Heading => text,
        Tone::Emphasis => element("em", &text),
        Tone::Strong => element("strong", &text),
        Tone::Code | Tone::Name => element("code", &text),
        Tone::Address => format!(r#"<code class="address">{text}</code>"#),
        Tone::Equation if span.mathml.is_some() => text,
        Tone::Equation => format!(r#"<span class="math">{text}</span>"#),
        Tone::Dim => format!(r#"<span class="aside">{text}</span>"#),
        Tone::Good => format!(r#"<span class="good">{text}</span>"#),
        Tone::Bad => format!(r#"<span class="bad">{text}</span>"#),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn symbols_and_numbers_are_marked_up() {
        let html = |text: &str| phrase(&Phrase::parse(text));
        assert_eq!(html("R_s < 2e-7"), "<var>R</var><sub>s</sub> &lt; 2·10<sup>−7</sup>");
        assert_eq!(html("e^(iδ), 10^{−6}"), "<var>e</var><sup>iδ</sup>, 10<sup>−6</sup>");
    }

    proptest! {
        #[test]
        fn any_text_is_escaped(text in "\\PC{0,40}", markup in "[_^{}()<>&\"'a-zθ0-9e.−-]{0,40}", rough in ".{0,20}") {
            for text in [text, markup, rough] {
                let attribute = escape(&text);
                let parsed = Phrase::parse(&text);
                let document = format!(r#"<p id="{attribute}">{}</p>"#, phrase(&parsed));
                let document = roxmltree::Document::parse(&document).expect("well-formed");
                let root = document.root_element();
                let kept = |c: &char| !c.is_control() && !matches!(c, '\u{FFFE}' | '\u{FFFF}');
                let blank = |c| if "\t\n\r".contains(c) { ' ' } else { c };
                let clean = |text: &str| text.chars().map(blank).filter(kept).collect::<String>();
                prop_assert_eq!(root.attribute("id").map(str::to_owned), Some(clean(&text)));
                // What is shown is what was written, but for the markup.
                let texts = root.descendants().filter(|node| node.is_text());
                let shown: String = texts.filter_map(|node| node.text()).collect();
                let said: String = parsed.runs().iter().map(|run| clean(&run.text)).collect();
                prop_assert_eq!(shown, said);
            }
        }
    }
}
