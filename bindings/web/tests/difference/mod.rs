//! Where two SVGs differ. Another machine's sines may differ in the last bit, so numbers may differ by what that does to
//! what is printed: places, which the sheet keeps to a 64th of a pixel, by one such step; a number that is read by one
//! unit of its last digit. A curve is compared as the line that it is, since points that fall together are left out of
//! it, and a last bit decides which. All else must be the same.

/// How far apart places may be [px]: neighbouring 64ths, printed to a hundredth.
const PLACE: f64 = 0.02;

/// A sentence for each element that differs, in the order of `ours`.
pub fn differences(ours: &str, theirs: &str) -> Vec<String> {
    // What stands between two elements goes with the one before it.
    let [ours, theirs] = [ours, theirs].map(|svg| svg.split('<').collect::<Vec<_>>());
    if ours.len() != theirs.len() {
        return vec![format!("{} elements instead of {}", theirs.len(), ours.len())];
    }
    let pairs = ours.iter().zip(&theirs).filter(|(one, other)| !agree(one, other));
    pairs.map(|(one, other)| format!("<{} instead of <{}", excerpt(other), excerpt(one))).collect()
}

fn excerpt(element: &str) -> String {
    element.chars().take(60).collect()
}

fn agree(one: &str, other: &str) -> bool {
    if one == other {
        return true;
    }
    let [(one, drawn), (other, drawn_there)] = [one, other].map(without_path);
    let same_line = match (drawn, drawn_there) {
        (Some(one), Some(other)) => one == other || lie_together(one, other),
        (one, other) => one == other,
    };
    let (mut one, mut other) = (Pieces::of(&one), Pieces::of(&other));
    same_line
        && loop {
            match (one.next(), other.next()) {
                (None, None) => break true,
                (Some(one), Some(other)) if same(one, other) => {}
                _ => break false,
            }
        }
}

/// The element without its path, and the path.
fn without_path(element: &str) -> (String, Option<&str>) {
    let Some((before, rest)) = element.split_once(" d=\"") else { return (element.into(), None) };
    let Some((path, after)) = rest.split_once('"') else { return (element.into(), None) };
    (format!("{before} d=\"{after}"), Some(path))
}

type Point = [f64; 2];

/// Whether two paths of straight lines run through the same places.
fn lie_together(one: &str, other: &str) -> bool {
    let (Some((one, one_closed)), Some((other, other_closed))) = (line(one), line(other)) else { return false };
    let all_near = |points: &[Point], line: &[Point]| points.iter().all(|point| distance(*point, line) <= slack(PLACE));
    let ends = [(one.first(), other.first()), (one.last(), other.last())];
    one_closed == other_closed
        && ends.iter().all(|(one, other)| distance(*one.expect("a line"), &[*other.expect("a line")]) <= slack(PLACE))
        && all_near(&one, &other)
        && all_near(&other, &one)
}

/// The corners of one line of straight pieces, and whether it is closed.
fn line(path: &str) -> Option<(Vec<Point>, bool)> {
    let path = path.strip_prefix('M')?;
    let (path, closed) = path.strip_suffix('Z').map_or((path, false), |open| (open, true));
    let corner = |text: &str| text.split_once(' ').and_then(|(x, y)| Some([x.parse().ok()?, y.parse().ok()?]));
    let corners: Option<Vec<Point>> = path.split('L').map(corner).collect();
    Some((corners?, closed))
}

/// How far a point is from a line.
fn distance([x, y]: Point, line: &[Point]) -> f64 {
    let to = |[a, b]: Point| (x - a).hypot(y - b);
    let pieces = line.windows(2).map(|ends| {
        let ([x0, y0], [dx, dy]) = (ends[0], [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]]);
        let along = ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy).max(f64::MIN_POSITIVE);
        let along = along.clamp(0.0, 1.0);
        to([x0 + along * dx, y0 + along * dy])
    });
    pieces.chain([to(line[0])]).min_by(f64::total_cmp).expect("a line has a point")
}

/// A little more, since hundredths are no binary fractions.
fn slack(apart: f64) -> f64 {
    apart * (1.0 + 1e-6) + 1e-12
}

/// A piece of an element.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Piece<'a> {
    /// A number of the drawing.
    Place(&'a str),
    /// A number that is read.
    Label(&'a str),
    /// Anything else.
    Text(&'a str),
}

fn same(one: Piece, other: Piece) -> bool {
    let within = |one: &str, other: &str, apart: f64| match (one.parse::<f64>(), other.parse::<f64>()) {
        (Ok(one), Ok(other)) => (one - other).abs() <= slack(apart),
        _ => false,
    };
    match (one, other) {
        _ if one == other => true,
        (Piece::Place(one), Piece::Place(other)) => within(one, other, PLACE),
        (Piece::Label(one), Piece::Label(other)) => within(one, other, last_digit(one).min(last_digit(other))),
        _ => false,
    }
}

/// One unit of the last digit of a number; 0 for a whole one, which counts something or was chosen.
fn last_digit(number: &str) -> f64 {
    let (digits, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let Some((_, decimals)) = digits.split_once('.') else { return 0.0 };
    10f64.powi(exponent.parse::<i32>().unwrap_or(0) - decimals.len() as i32)
}

/// The pieces of an element in order.
struct Pieces<'a> {
    rest: &'a str,
    in_tag: bool,
}

impl<'a> Pieces<'a> {
    fn of(element: &'a str) -> Self {
        Self { rest: element, in_tag: true }
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
        if let Some(length) = number(self.rest) {
            let number = self.take(length);
            return Some(if self.in_tag { Piece::Place(number) } else { Piece::Label(number) });
        }
        // A colour and an embedded picture are one piece each, so that their digits are not taken for numbers.
        let first = self.rest.chars().next()?;
        let length = if first == '#' {
            let digits = self.rest[1..].find(|digit: char| !digit.is_ascii_hexdigit());
            digits.map_or(self.rest.len(), |digits| 1 + digits)
        } else if self.in_tag && self.rest.starts_with("data:") {
            self.rest.find('"').unwrap_or(self.rest.len())
        } else {
            first.len_utf8()
        };
        self.in_tag &= first != '>';
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
    use super::differences;

    const SVG: &str = "<svg viewBox=\"0 0 640 400\"><title>R at 56.31°</title>\n\
        <path d=\"M1.5 -2L30.25 4L50 40\" fill=\"var(--lesson-s,#1f77b4)\"/>\n\
        <image href=\"data:image/png;base64,iVBO12\"/><text x=\"7\">n 1 → 1.5, θ_1</text></svg>";

    fn with(from: &str, to: &str) -> Vec<String> {
        assert!(SVG.contains(from));
        differences(SVG, &SVG.replacen(from, to, 1))
    }

    #[test]
    fn what_is_the_same_does_not_differ() {
        assert_eq!(differences(SVG, SVG), [""; 0]);
    }

    #[test]
    fn the_last_bit_of_another_machine_is_let_pass() {
        for (from, to) in [("30.25", "30.27"), ("-2", "-1.98"), ("56.31", "56.32"), ("x=\"7\"", "x=\"7.02\"")] {
            assert_eq!(with(from, to), [""; 0], "{from} → {to}");
        }
        assert_eq!(with("L30.25 4", "L30.25 4L30.27 4.01"), [""; 0], "a point that fell together with another");
    }

    #[test]
    fn everything_else_is_seen() {
        for (from, to) in [
            ("30.25", "30.29"),
            ("-2", "2"),
            ("L30.25 4", ""),
            ("L50 40", ""),
            ("L50 40", "Z"),
            ("L50 40", "L50 40L60 40"),
            ("L50 40", "M50 40"),
            ("40\"", "nan\""),
            ("x=\"7\"", "x=\"7.03\""),
            ("56.31", "56.33"),
            ("1 → ", "2 → "),
            ("θ_1", "θ_2"),
            ("#1f77b4", "#1f77b5"),
            ("lesson-s", "lesson-p"),
            ("iVBO12", "iVBO13"),
            ("</svg>", ""),
        ] {
            assert_eq!(with(from, to).len(), 1, "{from} → {to}");
        }
        assert!(!differences(SVG, "").is_empty() && !differences("", SVG).is_empty());
    }

    #[test]
    fn a_difference_is_told() {
        assert_eq!(with("1.5,", "1.7,"), ["<text x=\"7\">n 1 → 1.7, θ_1 instead of <text x=\"7\">n 1 → 1.5, θ_1"]);
    }
}
