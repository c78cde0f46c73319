//! Where two SVGs differ. Another machine's sines may differ in the last bit, so numbers may differ by what that does to
//! what is printed: a coordinate, which the sheet keeps to a 64th of a pixel, by one such step; a number in a label by
//! one unit of its last digit. All else must be the same.

/// How far apart coordinates may be [px]: neighbouring 64ths, printed to a hundredth.
const COORDINATE: f64 = 0.02;

/// A piece of an SVG.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Piece<'a> {
    /// A number of the drawing.
    Coordinate(&'a str),
    /// A number that is read.
    Label(&'a str),
    /// Anything else.
    Text(&'a str),
}

/// The first difference in words, if there is any.
pub fn difference(ours: &str, theirs: &str) -> Option<String> {
    let (mut ours, mut theirs) = (Pieces::of(ours), Pieces::of(theirs));
    loop {
        match (ours.next(), theirs.next()) {
            (None, None) => return None,
            (Some(one), Some(other)) if agree(one, other) => {}
            (one, other) => return Some(format!("{} instead of {}", shown(other), shown(one))),
        }
    }
}

fn shown(piece: Option<Piece>) -> String {
    match piece {
        None => "the end".into(),
        Some(Piece::Coordinate(text) | Piece::Label(text) | Piece::Text(text)) => {
            let short: String = text.chars().take(60).collect();
            format!("`{short}`")
        }
    }
}

fn agree(one: Piece, other: Piece) -> bool {
    let within = |one: &str, other: &str, apart: f64| match (one.parse::<f64>(), other.parse::<f64>()) {
        // A little more, since hundredths are no binary fractions.
        (Ok(one), Ok(other)) => (one - other).abs() <= apart * (1.0 + 1e-9) + 1e-12,
        _ => false,
    };
    match (one, other) {
        (Piece::Coordinate(one), Piece::Coordinate(other)) => one == other || within(one, other, COORDINATE),
        (Piece::Label(one), Piece::Label(other)) => {
            one == other || within(one, other, last_digit(one).min(last_digit(other)))
        }
        (one, other) => one == other,
    }
}

/// One unit of the last digit of a number; 0 for a whole one, which counts something or was chosen.
fn last_digit(number: &str) -> f64 {
    let (digits, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let Some((_, decimals)) = digits.split_once('.') else { return 0.0 };
    10f64.powi(exponent.parse::<i32>().unwrap_or(0) - decimals.len() as i32)
}

/// The pieces of an SVG in order.
struct Pieces<'a> {
    rest: &'a str,
    in_tag: bool,
}

impl<'a> Pieces<'a> {
    fn of(svg: &'a str) -> Self {
        Self { rest: svg, in_tag: false }
    }

    fn take(&mut self, bytes: usize) -> &'a str {
        let (piece, rest) = self.rest.split_at(bytes);
        self.rest = rest;
        piece
    }
}

impl<'a> Iterator for Pieces<'a> {
    type Item = Piece<'a>;

    fn next(&mut self) -> Option<Piece<'a>> {
        if self.rest.is_empty() {
            return None;
        }
        if let Some(length) = number(self.rest) {
            let number = self.take(length);
            return Some(if self.in_tag { Piece::Coordinate(number) } else { Piece::Label(number) });
        }
        // A colour and an embedded picture are one piece each, so that their digits are not taken for numbers.
        let first = self.rest.chars().next().expect("it is not empty");
        let length = if first == '#' {
            let digits = self.rest[1..].find(|digit: char| !digit.is_ascii_hexdigit());
            digits.map_or(self.rest.len(), |digits| 1 + digits)
        } else if self.in_tag && self.rest.starts_with("data:") {
            self.rest.find('"').unwrap_or(self.rest.len())
        } else {
            first.len_utf8()
        };
        match first {
            '<' => self.in_tag = true,
            '>' => self.in_tag = false,
            _ => {}
        }
        Some(Piece::Text(self.take(length)))
    }
}

/// Length of the decimal number that `text` begins with.
fn number(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from.min(bytes.len())..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let sign = usize::from(bytes.first() == Some(&b'-'));
    let whole = digits(sign);
    if whole == 0 {
        return None;
    }
    let mut end = sign + whole;
    if bytes.get(end) == Some(&b'.') && digits(end + 1) > 0 {
        end += 1 + digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'-' | b'+')));
        let exponent = digits(end + 1 + sign);
        end += if exponent > 0 { 1 + sign + exponent } else { 0 };
    }
    Some(end)
}

#[cfg(test)]
mod tests {
    use super::difference;

    const SVG: &str = "<svg viewBox=\"0 0 640 400\"><title>R at 56.31°</title>\n\
        <path d=\"M1.5 -2L30.25 4Z\" fill=\"var(--lesson-s,#1f77b4)\"/>\n\
        <image href=\"data:image/png;base64,iVBO12\"/><text x=\"7\">n 1 → 1.5, θ_1</text></svg>";

    fn with(from: &str, to: &str) -> Option<String> {
        assert!(SVG.contains(from));
        difference(SVG, &SVG.replacen(from, to, 1))
    }

    #[test]
    fn what_is_the_same_does_not_differ() {
        assert_eq!(difference(SVG, SVG), None);
    }

    #[test]
    fn the_last_bit_of_another_machine_is_let_pass() {
        assert_eq!(with("30.25", "30.27"), None);
        assert_eq!(with("-2", "-1.98"), None);
        assert_eq!(with("56.31", "56.32"), None);
    }

    #[test]
    fn everything_else_is_seen() {
        for (from, to) in [
            ("30.25", "30.28"),
            ("-2", "2"),
            ("L30.25 4", ""),
            ("4Z", "4L5 6Z"),
            ("56.31", "56.33"),
            ("56.31", "56.3"),
            ("1 → ", "2 → "),
            ("θ_1", "θ_2"),
            ("#1f77b4", "#1f77b5"),
            ("lesson-s", "lesson-p"),
            ("iVBO12", "iVBO13"),
            ("</svg>", ""),
        ] {
            assert!(with(from, to).is_some(), "{from} → {to}");
        }
        assert!(difference(SVG, "").is_some() && difference("", SVG).is_some());
    }

    #[test]
    fn a_difference_is_told() {
        assert_eq!(with("30.25", "30.5").as_deref(), Some("`30.5` instead of `30.25`"));
    }
}
