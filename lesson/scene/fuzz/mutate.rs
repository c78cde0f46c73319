//! Changes that break readers: bits, bytes and pieces anywhere; numbers and words where a text has them; and lengths and
//! checksums mended afterwards, so that what is changed is looked at.

use std::ops::Range;
use yardstick::random::{Stream, uniform};

/// Numbers to draw from.
pub struct Chance(Stream);

impl Chance {
    pub fn new(stream: Stream) -> Self {
        Self(stream)
    }

    /// A whole number below `n`, which is not 0.
    pub fn below(&mut self, n: usize) -> usize {
        (uniform(&mut self.0, 0.0, n as f64) as usize).min(n - 1)
    }

    /// Once in so many times.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    fn of<'a, T: ?Sized>(&mut self, all: &'a [&'a T]) -> &'a T {
        all[self.below(all.len())]
    }

    fn byte(&mut self) -> u8 {
        self.below(256) as u8
    }

    /// A piece of so many bytes, mostly a short one.
    fn piece(&mut self, length: usize) -> Range<usize> {
        let start = self.below(length + 1);
        let most = if self.once_in(4) { length } else { 16 };
        let end = (start + self.below(most + 1)).min(length);
        start..end
    }
}

/// Where a format has text, and what it says of its own lengths and sums.
pub struct Shape {
    /// The part of a file that is text.
    text: fn(&[u8]) -> Range<usize>,
    /// Mends lengths and sums, of a text so long.
    mend: fn(&mut Vec<u8>, Option<usize>),
}

pub const TEXT: Shape = Shape { text: |bytes| 0..bytes.len(), mend: |_, _| {} };
pub const BYTES: Shape = Shape { text: |_| 0..0, mend: |_, _| {} };
pub const PLY: Shape = Shape { text: |bytes| 0..after(bytes, b"end_header\n"), mend: |_, _| {} };
pub const HDR: Shape = Shape { text: |bytes| 0..after(bytes, b"+X 8\n"), mend: |_, _| {} };
pub const GLB: Shape = Shape { text: piece_of_text, mend: |bytes, text| lengths(bytes, text) };
pub const PNG: Shape = Shape { text: |_| 0..0, mend: |bytes, _| chunks(bytes) };
pub const FILM: Shape = Shape { text: |_| 0..0, mend: |bytes, _| sealed(bytes) };

fn after(bytes: &[u8], word: &[u8]) -> usize {
    bytes.windows(word.len()).position(|some| some == word).map_or(bytes.len(), |at| at + word.len())
}

fn number(bytes: &[u8], at: usize) -> usize {
    bytes.get(at..at + 4).map_or(0, |four| u32::from_le_bytes([four[0], four[1], four[2], four[3]]) as usize)
}

/// Of a .glb: its first piece, after two headers.
fn piece_of_text(bytes: &[u8]) -> Range<usize> {
    let start = bytes.len().min(20);
    start..(start + number(bytes, 12)).min(bytes.len())
}

fn lengths(bytes: &mut [u8], text: Option<usize>) {
    if bytes.len() < 20 {
        return;
    }
    let text = text.unwrap_or(number(bytes, 12)).min(bytes.len() - 20);
    let whole = bytes.len();
    let mut put = |at: usize, value: usize| {
        if let Some(four) = bytes.get_mut(at..at + 4) {
            four.copy_from_slice(&(value as u32).to_le_bytes());
        }
    };
    put(8, whole);
    put(12, text);
    if let Some(data) = whole.checked_sub(20 + text + 8) {
        put(20 + text, data);
    }
}

/// The sums of a PNG's chunks, as far as its lengths make sense.
fn chunks(bytes: &mut [u8]) {
    let mut at = 8;
    while let Some(head) = bytes.get(at..at + 8) {
        let length = u32::from_be_bytes([head[0], head[1], head[2], head[3]]) as usize;
        let end = at + 8 + length;
        if bytes.len() < end + 4 {
            return;
        }
        let sum = crc32fast::hash(&bytes[at + 4..end]);
        bytes[end..end + 4].copy_from_slice(&sum.to_be_bytes());
        at = end + 4;
    }
}

/// The sum of a film.
fn sealed(bytes: &mut [u8]) {
    if let Some(end) = bytes.len().checked_sub(4) {
        let sum = crc32fast::hash(&bytes[..end]);
        bytes[end..].copy_from_slice(&sum.to_le_bytes());
    }
}

/// A file made of some.
pub fn changed(seeds: &[Vec<u8>], shape: &Shape, chance: &mut Chance) -> Vec<u8> {
    let mut bytes = seeds[chance.below(seeds.len())].clone();
    let text = (shape.text)(&bytes);
    let mut length = None;
    let changes = 1 + chance.below(3) * chance.below(4);
    if !text.is_empty() && !chance.once_in(4) {
        let mut own = bytes[text.clone()].to_vec();
        (0..changes).for_each(|_| reworded(&mut own, chance));
        length = Some(own.len());
        bytes.splice(text, own);
    } else {
        let other = &seeds[chance.below(seeds.len())];
        (0..changes).for_each(|_| broken(&mut bytes, other, chance));
    }
    if !chance.once_in(8) {
        (shape.mend)(&mut bytes, length);
    }
    bytes
}

/// Numbers at which counts, sizes and places go wrong.
const WHOLE: [i128; 21] = [
    0,
    1,
    -1,
    2,
    3,
    4,
    127,
    128,
    255,
    256,
    0x7FFF,
    0x8000,
    0xFFFF,
    0x10000,
    0x7FFF_FFFF,
    0x8000_0000,
    0xFFFF_FFFF,
    0x1_0000_0000,
    0x7FFF_FFFF_FFFF_FFFF,
    0x8000_0000_0000_0000,
    33_554_432,
];
const SINGLES: [f32; 8] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN_POSITIVE, -0.0, 1e-45, 1e30];

/// One change of bytes.
fn broken(bytes: &mut Vec<u8>, other: &[u8], chance: &mut Chance) {
    if bytes.is_empty() {
        return bytes.push(chance.byte());
    }
    let at = chance.below(bytes.len());
    match chance.below(12) {
        0 | 1 => bytes[at] ^= 1 << chance.below(8),
        2 => bytes[at] = chance.byte(),
        3 => bytes[at] = bytes[at].wrapping_add(if chance.once_in(2) { 1 } else { 255 }),
        4 | 5 => {
            // A number over what is there, either end first.
            let value = if chance.once_in(3) { bytes.len() as i128 } else { WHOLE[chance.below(WHOLE.len())] };
            let all = (value + chance.below(3) as i128 - 1).to_le_bytes();
            let mut own = all[..[1, 2, 4, 8][chance.below(4)]].to_vec();
            if chance.once_in(2) {
                own.reverse();
            }
            bytes.iter_mut().skip(at).zip(own).for_each(|(byte, own)| *byte = own);
        }
        6 => {
            let single = SINGLES[chance.below(SINGLES.len())].to_le_bytes();
            bytes.iter_mut().skip(at & !3).zip(single).for_each(|(byte, own)| *byte = own);
        }
        7 => {
            let piece: Vec<u8> = (0..=chance.below(8)).map(|_| chance.byte()).collect();
            bytes.splice(at..at, piece);
        }
        8 => drop(bytes.drain(chance.piece(bytes.len()))),
        9 => {
            let piece = bytes[chance.piece(bytes.len())].to_vec();
            bytes.splice(at..at, piece);
        }
        10 => bytes.truncate(at),
        _ => {
            let piece = other[chance.piece(other.len())].to_vec();
            let end = if chance.once_in(2) { at } else { (at + piece.len()).min(bytes.len()) };
            bytes.splice(at..end, piece);
        }
    }
}

/// Numbers as texts, at which readers go wrong.
const NUMBERS: [&str; 34] = [
    "0",
    "-0",
    "-1",
    "1",
    "2",
    "3",
    "0.5",
    "-0.5",
    "255",
    "65535",
    "65536",
    "2147483647",
    "2147483648",
    "-2147483648",
    "-2147483649",
    "4294967295",
    "4294967296",
    "9007199254740993",
    "9223372036854775807",
    "-9223372036854775808",
    "9223372036854775808",
    "18446744073709551615",
    "18446744073709551616",
    "1e308",
    "-1e308",
    "1e309",
    "3.5e38",
    "1e39",
    "1e-46",
    "1e-320",
    "1e12",
    "nan",
    "inf",
    "-inf",
];
const WORDS: [&str; 18] = [
    "null",
    "true",
    "false",
    "\"\"",
    "[]",
    "{}",
    "[[]]",
    "[0,0,0]",
    "\"\\u0000\"",
    "'",
    "\"",
    "\\",
    "#",
    "\u{feff}",
    "\u{202e}",
    "\u{1b}[2J",
    "\r",
    "é",
];
const SIGNS: [&str; 12] = ["[", "]", "{", "}", ",", ":", "=", ".", "-", "/", "\n", " "];

/// Words, numbers, texts in quotes, and single signs of a text.
fn tokens(text: &[u8]) -> Vec<Range<usize>> {
    let mut all = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let start = at;
        let run = |of: fn(u8) -> bool| text[start..].iter().take_while(|byte| of(**byte)).count();
        at += match text[at] {
            b'"' => {
                let end = text[at + 1..].iter().position(|byte| *byte == b'"' || *byte == b'\n');
                end.map_or(text.len() - at, |end| end + 2)
            }
            b'0'..=b'9' | b'-' | b'+' => run(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte)),
            byte if byte.is_ascii_alphabetic() => run(|byte| byte.is_ascii_alphanumeric() || byte == b'_'),
            _ => 1,
        };
        all.push(start..at);
    }
    all
}

fn is_number(token: &[u8]) -> bool {
    matches!(token, [b'0'..=b'9', ..] | [b'-' | b'+', b'0'..=b'9', ..])
}

/// One change of a text.
fn reworded(text: &mut Vec<u8>, chance: &mut Chance) {
    let all = tokens(text);
    if all.is_empty() {
        return text.extend(chance.of(&WORDS).bytes());
    }
    let one = all[chance.below(all.len())].clone();
    let like = |range: &&Range<usize>| is_number(&text[(*range).clone()]);
    let numbers: Vec<&Range<usize>> = all.iter().filter(like).collect();
    match chance.below(14) {
        0..=4 if !numbers.is_empty() => {
            let number = numbers[chance.below(numbers.len())].clone();
            let near = std::str::from_utf8(&text[number.clone()]).ok().and_then(|text| text.parse::<i64>().ok());
            let own = match near.filter(|_| chance.once_in(3)) {
                Some(near) => near.wrapping_add(chance.below(5) as i64 - 2).to_string(),
                None => chance.of(&NUMBERS).to_owned(),
            };
            text.splice(number, own.into_bytes());
        }
        5 => drop(text.splice(one, chance.of(&WORDS).bytes())),
        6 | 7 => {
            // What stands elsewhere in the text, here.
            let other = text[all[chance.below(all.len())].clone()].to_vec();
            text.splice(one, other);
        }
        8 => drop(text.drain(one)),
        9 => {
            let piece = text[one.start..all[chance.below(all.len())].end.max(one.end)].to_vec();
            text.splice(one.start..one.start, piece);
        }
        10 => {
            let end = all[(chance.below(all.len())).min(all.len() - 1)].end.max(one.end);
            text.drain(one.start..end.min(one.start + 400));
        }
        11 => {
            let times = if chance.once_in(4) { 3000 } else { 1 };
            let sign = chance.of(&SIGNS).repeat(times);
            text.splice(one.start..one.start, sign.into_bytes());
        }
        12 => {
            // A line again, or none.
            let before = text[..one.start].iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
            let after = text[one.start..].iter().position(|byte| *byte == b'\n');
            let after = after.map_or(text.len(), |at| one.start + at + 1);
            let line = text[before..after.max(before)].to_vec();
            match chance.once_in(2) {
                true => drop(text.splice(before..before, line)),
                false => drop(text.drain(before..after.max(before))),
            }
        }
        _ => broken(text, b"\xff\0\x80\xc3\xed\xa0\x80", chance),
    }
}
