//! Listings in the course text: the very code that runs, cut from its file where the text has `<!-- listing: name -->`.

/// The files that are shown, each by the name of its anchors.
const SHOWN: &[(&str, &str)] = &[
    ("hemisphere", include_str!("../../src/transport/simple/hemisphere.rs")),
    ("surface", include_str!("../../src/transport/simple/surface.rs")),
    ("lamps", include_str!("../../src/transport/simple/lamps.rs")),
    ("both", include_str!("../../src/transport/simple/both.rs")),
    ("interpolation", include_str!("../../src/transport/irradiance_cache/record.rs")),
    ("photons", include_str!("../../src/transport/photons.rs")),
    ("polarised", include_str!("../../src/transport/simple/polarised.rs")),
    ("spectral", include_str!("../../src/transport/simple/spectral.rs")),
];

const MARK: &[u8] = b"<!-- listing: ";
const END: &[u8] = b" -->";
const FENCE: [&[u8]; 2] = [b"```rust\n", b"```"];

/// How long a text is with its listings in it [B].
pub(super) const fn length(text: &str) -> usize {
    with_listings::<0>(text).1
}

/// A text of `N` bytes with its listings in it.
pub(super) const fn filled<const N: usize>(text: &str) -> [u8; N] {
    with_listings::<N>(text).0
}

/// As much of the text as there is room for, and how long all of it is.
const fn with_listings<const N: usize>(text: &str) -> ([u8; N], usize) {
    let text = text.as_bytes();
    let (mut filled, mut length, mut at) = ([0; N], 0, 0);
    while let Some(mark) = find(text, MARK, at) {
        let name = mark + MARK.len();
        let end = find(text, END, name).expect("the end of a mark");
        length = appended(&mut filled, length, text, at, mark);
        length = appended(&mut filled, length, FENCE[0], 0, FENCE[0].len());
        let (code, from, to) = listing(text, name, end);
        length = outdented(&mut filled, length, code, from, to);
        length = appended(&mut filled, length, FENCE[1], 0, FENCE[1].len());
        at = end + END.len();
    }
    length = appended(&mut filled, length, text, at, text.len());
    (filled, length)
}

/// The file of the listing that the text names, and where the listing begins and ends in it.
const fn listing(text: &[u8], name: usize, end: usize) -> (&'static [u8], usize, usize) {
    let mut k = 0;
    while k < SHOWN.len() {
        let (known, source) = (SHOWN[k].0.as_bytes(), SHOWN[k].1.as_bytes());
        if known.len() == end - name && is_at(text, known, name) {
            let mark = find(source, b"// ANCHOR: ", 0).expect("an anchor");
            let from = find(source, b"\n", mark).expect("a line") + 1;
            // The end's line is indented as the code is.
            let mut to = find(source, b"// ANCHOR_END: ", from).expect("an anchor's end");
            while source[to - 1] != b'\n' {
                to -= 1;
            }
            return (source, from, to);
        }
        k += 1;
    }
    panic!("a listing that is not known")
}

/// Where `what` is, from a place on.
const fn find(text: &[u8], what: &[u8], from: usize) -> Option<usize> {
    let mut at = from;
    while at + what.len() <= text.len() {
        if text[at] == what[0] && is_at(text, what, at) {
            return Some(at);
        }
        at += 1;
    }
    None
}

const fn is_at(text: &[u8], what: &[u8], at: usize) -> bool {
    let mut k = 0;
    while k < what.len() {
        if text[at + k] != what[k] {
            return false;
        }
        k += 1;
    }
    true
}

/// Copies a part of `from` behind the first `length` bytes, as far as there is room; the length then.
const fn appended<const N: usize>(to: &mut [u8; N], length: usize, from: &[u8], start: usize, end: usize) -> usize {
    let mut k = start;
    while k < end && length + k - start < N {
        to[length + k - start] = from[k];
        k += 1;
    }
    length + end - start
}

/// Copies lines of code as [`appended`] does, without what the first of them is indented by.
const fn outdented<const N: usize>(to: &mut [u8; N], length: usize, from: &[u8], start: usize, end: usize) -> usize {
    let mut indent = 0;
    while from[start + indent] == b' ' {
        indent += 1;
    }
    let (mut length, mut line) = (length, start);
    while line < end {
        let next = find(from, b"\n", line).expect("a line's end") + 1;
        let mut code = line;
        while code - line < indent && from[code] == b' ' {
            code += 1;
        }
        length = appended(to, length, from, code, next);
        line = next;
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mark_becomes_the_code_between_the_anchors() {
        const TEXT: &str = "before\n\n<!-- listing: surface -->\n\nafter";
        const FILLED: [u8; length(TEXT)] = filled(TEXT);
        let filled = std::str::from_utf8(&FILLED).expect("text");
        assert!(
            filled.starts_with("before\n\n```rust\npub fn radiance(") && filled.ends_with("}\n```\n\nafter"),
            "{filled}"
        );
        assert!(!filled.contains("ANCHOR"));
    }

    #[test]
    fn every_listing_begins_and_ends_at_the_margin() {
        const TEXT: &str = "<!-- listing: interpolation -->\n\nafter";
        const FILLED: [u8; length(TEXT)] = filled(TEXT);
        let filled = std::str::from_utf8(&FILLED).expect("text");
        assert!(filled.starts_with("```rust\n///") && filled.ends_with("\n}\n```\n\nafter"), "{filled}");
        // So that what follows is text again.
        let prose = crate::path_tracing::CHAPTER.prose;
        let fences: Vec<&str> = prose.lines().filter(|line| line.contains("```")).collect();
        assert!(fences.len() >= 2 * SHOWN.len() && fences.iter().all(|line| line.starts_with("```")), "{fences:?}");
    }
}
