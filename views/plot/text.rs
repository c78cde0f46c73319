//! Text: the measure of a label in the embedded font.

use chapters::text::{self, Phrase, Shift};
use std::sync::LazyLock;
use ttf_parser::{Face, GlyphId};

/// Families an SVG reader should try, the embedded one first; the others are as wide or are fitted to its widths.
pub const FAMILIES: &str = "'DejaVu Sans Condensed','DejaVu Sans',Verdana,'Noto Sans',sans-serif";

/// Height of a capital above the baseline [em].
pub const CAPITAL: f64 = 0.729;
/// Depth of a descender below the baseline [em].
pub const DESCENT: f64 = 0.236;

/// Size of a raised or lowered run against the text around it [1].
const SMALLER: f64 = 0.72;
/// How far a raised run stands above the baseline around it [em].
const RAISE: f64 = 0.36;
/// How far a lowered run hangs below the baseline around it [em].
const LOWER: f64 = 0.17;

/// The embedded font.
pub(super) static FACE: LazyLock<Face<'static>> = LazyLock::new(|| {
    let font = include_bytes!("../fonts/DejaVuSansCondensed-subset.ttf");
    Face::parse(font, 0).expect("the embedded font is sound")
});

/// A stretch of a label that is set at one size on one baseline. Lengths in em of the label.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// What is written.
    pub text: String,
    /// Where it starts.
    pub x: f64,
    /// Height of its baseline above that of the label.
    pub rise: f64,
    /// Its size.
    pub size: f64,
}

/// The runs of a label in the markup of chapters (`R_s`, `10^{−6}`).
pub fn runs(label: &str) -> Vec<Run> {
    let mut x = 0.0;
    let set = |run: text::Run| {
        let (rise, size) = run.shifts.iter().fold((0.0, 1.0), |(rise, size), shift| match shift {
            Shift::Lowered => (rise - LOWER * size, size * SMALLER),
            Shift::Raised => (rise + RAISE * size, size * SMALLER),
        });
        let run = Run { text: run.text, x, rise, size };
        x += run.size * advance(&run.text);
        run
    };
    Phrase::parse(label).runs().into_iter().map(set).collect()
}

/// Width of plain text [em].
pub(super) fn advance(text: &str) -> f64 {
    let units: f64 = text.chars().map(|c| f64::from(FACE.glyph_hor_advance(glyph(c)).unwrap_or(0))).sum();
    units / units_per_em()
}

/// Units of the font to an em.
pub(super) fn units_per_em() -> f64 {
    f64::from(FACE.units_per_em())
}

/// The glyph of a character; the font's empty box if it has none.
pub(super) fn glyph(character: char) -> GlyphId {
    FACE.glyph_index(character).unwrap_or_default()
}

/// Width of a label, in the unit of `size`.
pub fn width(label: &str, size: f64) -> f64 {
    runs(label).last().map_or(0.0, |run| size * (run.x + run.size * advance(&run.text)))
}

/// The label broken at spaces into as few lines as there must be, no wider than `limit` where words allow, and about as long
/// as each other.
pub fn wrap(label: &str, size: f64, limit: f64) -> Vec<String> {
    let lines = filled(label, size, limit);
    let (mut low, mut high) = (limit / lines.len().max(1) as f64, limit);
    // To a pixel.
    while lines.len() > 1 && high - low > 1.0 {
        let middle = 0.5 * (low + high);
        let is_enough = filled(label, size, middle).len() == lines.len();
        if is_enough { high = middle } else { low = middle }
    }
    filled(label, size, high)
}

/// The label in lines as full as can be.
fn filled(label: &str, size: f64, limit: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words(label) {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= limit => {
                line.push(' ');
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

/// The words of a label; a per cent sign is one with its number.
fn words(label: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for word in label.split_whitespace() {
        match words.last_mut() {
            Some(number) if word.starts_with('%') => {
                number.push(' ');
                number.push_str(word);
            }
            _ => words.push(word.to_owned()),
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn texts(label: &str) -> Vec<String> {
        runs(label).into_iter().map(|run| run.text).collect()
    }

    #[test]
    fn markup_lowers_and_raises() {
        let found = runs("R_s + 10^{−6}x");
        assert_eq!(texts("R_s + 10^{−6}x"), ["R", "s", " + 10", "−6", "x"]);
        assert!(found[1].rise < 0.0 && found[3].rise > 0.3);
        assert!(found[3].size < 1.0 && found[4].size == 1.0 && found[4].rise == 0.0);
        assert_eq!(texts("a_{b^2}"), ["a", "b", "2"]);
        assert_eq!(texts("n_t/n_i"), ["n", "t", "/n", "i"]);
    }

    #[test]
    fn stray_marks_stay_as_written() {
        assert_eq!(texts("a_"), ["a_"]);
        assert_eq!(texts("{x}"), ["{x}"]);
        assert_eq!(texts("x^{2"), ["x^{2"]);
        assert!(runs("").is_empty());
    }

    #[test]
    fn font_has_every_sign_of_the_lecture() {
        let signs =
            "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩϑϕϵ√∞±×·≤≥≪≫′″°½→←↔⇒−⁻⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉∂∇⟨⟩≈≠≡∝∫∮∑∏∈ℏ∠⊥∥…–—’“”µÅ⋅éöü";
        for sign in signs.chars().chain(' '..='~') {
            assert!(FACE.glyph_index(sign).is_some(), "the font lacks {sign}");
        }
    }

    #[test]
    fn widths_add_up() {
        assert_eq!(width("", 10.0), 0.0);
        let whole = width("θ_B = 56°", 15.0);
        let parts = width("θ", 15.0) + SMALLER * width("B", 15.0) + width(" = 56°", 15.0);
        assert!((whole - parts).abs() < 1e-9);
    }

    #[test]
    fn wrapping_keeps_every_word() {
        let label = "Glass in air: what is reflected, and what goes on";
        let lines = wrap(label, 15.0, 150.0);
        assert!(lines.len() > 1 && lines.iter().all(|line| width(line, 15.0) <= 150.0));
        assert_eq!(lines.join(" "), label);
        assert_eq!(wrap("immeasurable", 15.0, 1.0), ["immeasurable"]);
        // No word is left over for a line of its own, and no sign without its number.
        let whole = width("one two six ten", 15.0);
        assert_eq!(wrap("one two six ten", 15.0, whole - 1.0), ["one two", "six ten"]);
        assert_eq!(wrap("error 8.97 %", 15.0, width("error 8.97 %", 15.0) - 1.0), ["error", "8.97 %"]);
    }

    proptest! {
        #[test]
        fn any_label_can_be_set(label in "[_^{}a-zθ⁻\\PC]{0,40}") {
            prop_assert!(width(&label, 15.0).is_finite());
        }
    }
}
