//! The one reader of the markup.

use super::face::small;
use super::{Held, Phrase, Piece, Script, Shift};

/// Characters of the longest number whose power of ten is raised; longer ones are there to be copied.
const SHORT: usize = 9;
/// Scripts within scripts beyond this depth stay as written.
const DEEPEST: usize = 3;

pub fn phrase(text: &str) -> Phrase {
    read(text, 0)
}

fn read(text: &str, depth: usize) -> Phrase {
    let (mut reader, mut rest) = (Reader::default(), text);
    while let Some(at) = rest.find(['_', '^', '-', 'e']) {
        reader.plain.push_str(&rest[..at]);
        let (mark, tail) = rest[at..].split_at(1);
        let next = match mark {
            "-" => reader.minus(tail),
            "e" => reader.power_of_ten(tail),
            "_" => reader.script(Shift::Lowered, tail, depth),
            _ => reader.script(Shift::Raised, tail, depth),
        };
        rest = next.unwrap_or_else(|| {
            reader.plain.push_str(mark);
            tail
        });
    }
    reader.plain.push_str(rest);
    reader.flush();
    Phrase(reader.pieces)
}

/// What has been read so far.
#[derive(Default)]
struct Reader {
    pieces: Vec<Piece>,
    /// Letters behind the last piece.
    plain: String,
}

impl Reader {
    fn flush(&mut self) {
        if !self.plain.is_empty() {
            self.pieces.push(Piece::Plain(std::mem::take(&mut self.plain)));
        }
    }

    /// Whether what was read ends in a symbol or a number.
    fn is_behind_piece(&self) -> bool {
        self.plain.is_empty() && !self.pieces.is_empty()
    }

    /// Reads a hyphen that is the sign of a number or of its exponent.
    fn minus<'a>(&mut self, tail: &'a str) -> Option<&'a str> {
        let before = self.plain.as_str();
        let exponent =
            before.strip_suffix('e').is_some_and(|number| number.ends_with(|c: char| c.is_ascii_digit() || c == '.'));
        let joins = before.ends_with(|c: char| c.is_alphanumeric() || "-_^/)]".contains(c)) || self.is_behind_piece();
        if !tail.starts_with(|c: char| c.is_ascii_digit()) || (joins && !exponent) {
            return None;
        }
        self.plain.push('−');
        Some(tail)
    }

    /// Reads the power of ten in `tail`, behind an `e`, together with the digits read last; gives what follows.
    fn power_of_ten<'a>(&mut self, tail: &'a str) -> Option<&'a str> {
        let digits = self.plain.len() - trailing(&self.plain, |c| c.is_ascii_digit() || c == '.');
        let (before, factor) = self.plain.split_at(digits);
        let (sign, digits) = match tail.strip_prefix(['-', '−']) {
            Some(digits) => ("−", digits),
            None => ("", tail.strip_prefix('+').unwrap_or(tail)),
        };
        let (power, next) = digits.split_at(digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len()));
        let is_number = factor.starts_with(|c: char| c.is_ascii_digit()) && !power.is_empty();
        let joined = |c: char| c.is_alphanumeric() || c == '_';
        let is_apart = !before.ends_with(joined) && (!before.is_empty() || self.pieces.is_empty());
        if !is_number || !is_apart || factor.len() > SHORT || next.starts_with(joined) {
            return None;
        }
        let factor = if factor == "1" { String::new() } else { factor.to_owned() };
        // What is taken from a number stands apart from it on both sides.
        let taken = before.strip_suffix('−').filter(|number| number.ends_with(' '));
        let taken = taken.is_some_and(|number| number.trim_end().ends_with(|c: char| c.is_ascii_digit()));
        self.plain.truncate(before.len());
        if taken {
            self.plain.push(' ');
        }
        self.flush();
        self.pieces.push(Piece::Number { factor, power: format!("{sign}{power}") });
        Some(next)
    }

    /// Reads what `tail` begins with as an index or a power of what was read last; gives what follows.
    fn script<'a>(&mut self, shift: Shift, tail: &'a str, depth: usize) -> Option<&'a str> {
        if depth == DEEPEST {
            return None;
        }
        let (body, held, next) = body(shift, tail)?;
        let length = self.base(shift, body, held, next)?;
        let script = Script { shift, of: read(body, depth + 1), held };
        if length == 0 {
            let Some(Piece::Symbol { scripts, .. }) = self.pieces.last_mut() else { return None };
            scripts.push(script);
            return Some(next);
        }
        let base = self.plain.split_off(self.plain.len() - length);
        self.flush();
        self.pieces.push(Piece::Symbol { base, scripts: vec![script] });
        Some(next)
    }

    /// How many bytes of the letters read last carry the script `body` before `next`; 0 if a symbol does, which was
    /// read before.
    fn base(&self, shift: Shift, body: &str, held: Held, next: &str) -> Option<usize> {
        let before = self.plain.as_str();
        if self.is_behind_piece() {
            let is_symbol = matches!(self.pieces.last(), Some(Piece::Symbol { .. }));
            return (is_symbol && (held != Held::Alone || ends(body, next))).then_some(0);
        }
        let last = before.chars().next_back()?;
        let length = match last {
            _ if last.is_ascii_digit() => trailing(before, |c| c.is_ascii_digit()),
            _ => last.len_utf8(),
        };
        let is_count = shift == Shift::Lowered && held == Held::Alone && body.bytes().all(|c| c.is_ascii_digit());
        let is_whole = !next.starts_with(|c: char| "_=".contains(c) || c.is_ascii_digit());
        if let Some(element) = element(before).filter(|_| is_count && is_whole) {
            return Some(element);
        }
        let carries = match shift {
            Shift::Raised => last.is_alphanumeric() || ")]|⟩′".contains(last),
            Shift::Lowered if held == Held::Braces => last.is_alphanumeric() || ")|⟩′".contains(last),
            Shift::Lowered => is_symbol(before),
        };
        (carries && (held != Held::Alone || ends(body, next))).then_some(length)
    }
}

/// The script at the start of `tail`, what holds it together, and what follows.
fn body(shift: Shift, tail: &str) -> Option<(&str, Held, &str)> {
    let first = tail.chars().next()?;
    if first == '{' || (first == '(' && shift == Shift::Raised) {
        let (close, held) = if first == '{' { ('}', Held::Braces) } else { (')', Held::Brackets) };
        let end = closing(tail, first, close)?;
        return (end > 1).then_some((&tail[1..end], held, &tail[end + 1..]));
    }
    let sign = if shift == Shift::Raised && "−-".contains(first) { first.len_utf8() } else { 0 };
    let letter = tail[sign..].chars().next().filter(|letter| letter.is_alphanumeric())?;
    let (body, next) = tail.split_at(sign + letter.len_utf8());
    Some((body, Held::Alone, next))
}

/// Where the bracket that `text` begins with is closed.
fn closing(text: &str, open: char, close: char) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, letter) in text.char_indices() {
        if letter == open {
            depth += 1;
        } else if letter == close {
            depth -= 1;
            if depth == 0 {
                return Some(at);
            }
        }
    }
    None
}

/// Bytes at the end of `text` whose letters are of a `kind`.
fn trailing(text: &str, kind: fn(char) -> bool) -> usize {
    text.chars().rev().take_while(|letter| kind(*letter)).map(char::len_utf8).sum()
}

/// Whether `before` ends in one letter, a number or a bracket: what carries an index.
fn is_symbol(before: &str) -> bool {
    let mut letters = before.chars().rev();
    let last = letters.next();
    match last {
        Some(letter) if letter.is_alphabetic() => !letters.next().is_some_and(|c| c.is_alphabetic() || c == '_'),
        _ => last.is_some_and(|c| c.is_numeric() || ")′".contains(c)),
    }
}

/// Bytes of the chemical element that `before` ends in.
fn element(before: &str) -> Option<usize> {
    let mut letters = before.chars().rev();
    match (letters.next()?, letters.next(), letters.next()) {
        (last, _, _) if last.is_ascii_uppercase() => Some(1),
        (last, Some(first), before) if last.is_ascii_lowercase() && first.is_ascii_uppercase() => {
            before.is_none_or(|c| !c.is_ascii_lowercase()).then_some(2)
        }
        _ => None,
    }
}

/// Whether a script of a single letter may end before `next`: a further letter of its alphabet would make it a name.
fn ends(body: &str, next: &str) -> bool {
    match next.chars().next() {
        Some('_' | '=') => false,
        Some(letter) if letter.is_alphanumeric() => body.is_ascii() && !letter.is_ascii() && small(letter).is_none(),
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(text: &str) -> String {
        phrase(text).to_string()
    }

    /// Base and scripts of the symbols in `text`.
    fn symbols(text: &str) -> Vec<(String, Vec<String>)> {
        let symbol = |piece: &Piece| match piece {
            Piece::Symbol { base, scripts } => {
                Some((base.clone(), scripts.iter().map(|script| script.of.to_string()).collect()))
            }
            _ => None,
        };
        phrase(text).0.iter().filter_map(symbol).collect()
    }

    #[test]
    fn labels_use_small_letters_where_there_are_all() {
        assert_eq!(set("R_s"), "Rₛ");
        assert_eq!(set("θ_B"), "θ_B");
        assert_eq!(set("10^{−6}"), "10⁻⁶");
        assert_eq!(set("n_t/n_i"), "nₜ/nᵢ");
        assert_eq!(set("e^(−iωt)"), "e^(−iωt)");
        assert_eq!(set("(R_s−R_p)/(R_s+R_p) of Im r_s"), "(Rₛ−Rₚ)/(Rₛ+Rₚ) of Im rₛ");
        assert_eq!(set("r_s^2 and |r|^2"), "rₛ² and |r|²");
    }

    #[test]
    fn names_and_assignments_are_left_as_typed() {
        for name in ["total_reflection", "r_plus_t", "n_t=gold", "theta_1", "d_nm", "exp_m1", "-1 nm to p-polarised"] {
            assert_eq!(set(name), name.replace("-1", "−1"), "{name}");
            assert_eq!(symbols(name), [], "{name}");
        }
        for stray in ["a_", "{x}", "x^{2", "x^{}", "^2", "_", "a__b", "x_{"] {
            assert_eq!(phrase(stray), Phrase::verbatim(stray));
        }
    }

    #[test]
    fn symbols_carry_what_hangs_on_them() {
        let found = |text: &str, expected: &[(&str, &[&str])]| {
            let expected: Vec<_> = expected
                .iter()
                .map(|(base, scripts)| (base.to_string(), scripts.iter().map(|script| script.to_string()).collect()))
                .collect();
            assert_eq!(symbols(text), expected, "{text}");
        };
        found("R_s + 10^{−6}x", &[("R", &["s"]), ("10", &["−6"])]);
        found("a_{b^2}", &[("a", &["b²"])]);
        found("ω_cτ = 1, Z_0G", &[("ω", &["c"]), ("Z", &["0"])]);
        found("2 TiO_2, Al_2O_3", &[("O", &["2"]), ("Al", &["2"]), ("O", &["3"])]);
        found("E_x^2 e^{−z/δ}", &[("E", &["x", "2"]), ("e", &["−z/δ"])]);
        found("N^−½, cos^2 θ_1'", &[("N", &["−½"]), ("s", &["2"]), ("θ", &["1"])]);
        found("10^{-6}, e^(i(kz − ωt))", &[("10", &["−6"]), ("e", &["i(kz − ωt)"])]);
    }

    #[test]
    fn numbers_carry_minus_signs_and_words_hyphens() {
        assert_eq!(set("-1.5e-10, s-polarised, n-1, x = -2"), "−1.5·10⁻¹⁰, s-polarised, n-1, x = −2");
    }

    #[test]
    fn powers_of_ten_are_raised() {
        for (typed, shown) in [
            ("1e12 or 2.5e-7", "10¹² or 2.5·10⁻⁷"),
            ("n = 1 -1e-6", "n = 1 − 10⁻⁶"),
            ("at -3e+20,", "at −3·10²⁰,"),
            ("1.2345678901234567e-45", "1.2345678901234567e−45"),
            ("x1e5, 1e5m, the 2e, 0x1e", "x1e5, 1e5m, the 2e, 0x1e"),
        ] {
            assert_eq!(set(typed), shown);
        }
        assert_eq!(phrase("1e-6").0, [Piece::Number { factor: "".into(), power: "−6".into() }]);
    }

    #[test]
    fn scripts_end_at_a_depth() {
        let deep = "a_{".repeat(1000) + "b" + &"}".repeat(1000);
        assert_eq!(set(&deep), deep);
    }
}
