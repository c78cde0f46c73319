//! Presentation MathML (MathML Core), which browsers draw by themselves. Every face is one element.

use super::name::{Name, greek};
use super::pen::{Gap, Level, Pen, Sign, Written};
use super::unicode::decimal;
use crate::rational::Rational;
use crate::symbol::Rank;

#[derive(Clone, Copy)]
pub(super) struct MathMl;

pub(super) fn element(inner: &str, display: &str) -> String {
    format!(r#"<math display="{display}">{inner}</math>"#)
}

fn letters(word: &str, rank: Rank) -> String {
    let text = greek(word).map_or(escape(word), |(letter, _)| letter.to_string());
    match rank {
        _ if text.chars().all(|c| c.is_ascii_digit()) => format!("<mn>{text}</mn>"),
        Rank::Vector => format!("<mi>{}</mi>", text.chars().map(bold).collect::<String>()),
        Rank::Scalar => format!("<mi>{text}</mi>"),
    }
}

/// The bold italic letter of the mathematical alphabets (Unicode, U+1D400…), where there is one: MathML Core has
/// no attribute for it.
fn bold(letter: char) -> char {
    let offset = |first: char, start: u32| char::from_u32(start + letter as u32 - first as u32).unwrap_or(letter);
    match letter {
        'A'..='Z' => offset('A', 0x1D468),
        'a'..='z' => offset('a', 0x1D482),
        'Α'..='Ω' => offset('Α', 0x1D71C),
        'α'..='ω' => offset('α', 0x1D736),
        _ => letter,
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

impl Pen for MathMl {
    type Ink = String;
    const RAISES: bool = true;

    fn is_flat(self) -> bool {
        false
    }

    fn inner(self) -> Self {
        self
    }

    fn name(self, name: &Name, rank: Rank) -> String {
        let base = letters(name.base, rank);
        let primes = format!("<mo>{}</mo>", "′".repeat(name.primes));
        let index = letters(name.index, Rank::Scalar);
        match (name.index.is_empty(), name.primes) {
            (true, 0) => base,
            (false, 0) => format!("<msub>{base}{index}</msub>"),
            (true, _) => format!("<msup>{base}{primes}</msup>"),
            (false, _) => format!("<msubsup>{base}{index}{primes}</msubsup>"),
        }
    }

    fn number(self, value: Rational) -> Written<Self> {
        match decimal(value) {
            Some(digits) => (format!("<mn>{digits}</mn>"), Level::Atom),
            None => {
                let (above, below) = (value.numerator(), value.denominator());
                (format!("<mfrac><mn>{above}</mn><mn>{below}</mn></mfrac>"), Level::Script)
            }
        }
    }

    fn infix(self, sign: Sign) -> String {
        let sign = match sign {
            Sign::Plus => "+",
            Sign::Minus => "−",
            Sign::Times | Sign::Cross => "×",
            Sign::Dot => "·",
            Sign::Comma => ",",
            Sign::Equal => "=",
            Sign::Approximate => "≈",
            Sign::Proportional => "∝",
        };
        format!("<mo>{sign}</mo>")
    }

    fn prefix(self, mark: char) -> String {
        match mark {
            'd' => r#"<mi mathvariant="normal">d</mi>"#.to_owned(),
            '∂' | '∇' => format!(r#"<mi mathvariant="normal">{mark}</mi>"#),
            _ => format!(r#"<mo form="prefix">{mark}</mo>"#),
        }
    }

    fn word(self, word: &str) -> String {
        match word {
            "*" => "<mo>*</mo>".to_owned(),
            "i" => r#"<mi mathvariant="normal">i</mi>"#.to_owned(),
            _ => format!("<mi>{word}</mi>"),
        }
    }

    fn apply(self) -> String {
        "<mo>\u{2061}</mo><mspace width=\"0.1667em\"/>".to_owned()
    }

    fn gap(self, gap: Gap) -> String {
        if gap == Gap::Tight { "<mo>\u{2062}</mo>" } else { "<mo>\u{2062}</mo><mspace width=\"0.1667em\"/>" }.to_owned()
    }

    fn fraction(self, above: String, below: String) -> String {
        format!("<mfrac>{above}{below}</mfrac>")
    }

    fn root(self, (of, _): Written<Self>) -> Written<Self> {
        (format!("<msqrt>{of}</msqrt>"), Level::Atom)
    }

    fn exponential(self, of: String) -> Written<Self> {
        (format!(r#"<msup><mi mathvariant="normal">e</mi>{of}</msup>"#), Level::Script)
    }

    fn raise(self, base: String, exponent: String) -> String {
        format!("<msup>{base}{exponent}</msup>")
    }

    fn exponent(self, value: Rational) -> String {
        format!("<mn>{}</mn>", value.to_string().replace('-', "−"))
    }

    fn fence(self, open: char, inner: String, close: char) -> String {
        format!(
            r#"<mrow><mo form="prefix" stretchy="true">{open}</mo>{inner}<mo form="postfix" stretchy="true">{close}</mo></mrow>"#
        )
    }

    fn integral(self, sign: char, bounds: Option<(String, Option<String>)>) -> String {
        let sign = format!("<mo>{sign}</mo>");
        match bounds {
            None => sign,
            Some((lower, None)) => format!("<msub>{sign}{lower}</msub>"),
            Some((lower, Some(upper))) => {
                format!("<msubsup>{sign}{lower}{upper}</msubsup>")
            }
        }
    }

    fn row(self, parts: Vec<String>) -> String {
        let inner = parts.concat();
        if parts.len() == 1 { inner } else { format!("<mrow>{inner}</mrow>") }
    }

    fn opens(self, face: &String) -> bool {
        face.starts_with('(')
    }
}
