//! Words in set text: where they are, across the ends of rows.

use std::ops::Range;
use views::page::Row;

/// A place where the words stand: ranges of letters, each in a row.
pub type Hit = Vec<(usize, Range<usize>)>;

/// Every place in `rows` where `words` stand, whatever their case; a row's end counts as a space.
pub fn hits<'a>(rows: impl Iterator<Item = &'a Row>, words: &str) -> Vec<Hit> {
    let wanted: Vec<char> = folded(words.split_whitespace().collect::<Vec<_>>().join(" ").chars());
    if wanted.is_empty() {
        return Vec::new();
    }
    // Letters with their places; runs of spaces and the ends of rows are one space, which stands nowhere.
    let mut letters: Vec<(char, Option<(usize, usize)>)> = vec![(' ', None)];
    for (row, text) in rows.enumerate() {
        let Row::Text(_) = text else { continue };
        for (at, letter) in text.text().chars().enumerate().map(|(at, letter)| (at, lower(letter))) {
            if !letter.is_whitespace() {
                letters.push((letter, Some((row, at))));
            } else if letters.last().is_some_and(|(last, _)| *last != ' ') {
                letters.push((' ', Some((row, at))));
            }
        }
        if letters.last().is_some_and(|(last, _)| *last != ' ') {
            letters.push((' ', None));
        }
    }
    let found = letters.windows(wanted.len()).filter(|window| window.iter().map(|(letter, _)| letter).eq(&wanted));
    found.map(|window| ranges(window.iter().filter_map(|(_, place)| *place))).collect()
}

fn folded(text: impl Iterator<Item = char>) -> Vec<char> {
    text.map(lower).collect()
}

/// One letter for one letter, so that places stay what they are.
fn lower(letter: char) -> char {
    let mut lower = letter.to_lowercase();
    lower.next().filter(|_| lower.next().is_none()).unwrap_or(letter)
}

fn ranges(places: impl Iterator<Item = (usize, usize)>) -> Hit {
    let mut hit: Hit = Vec::new();
    for (row, at) in places {
        match hit.last_mut() {
            Some((last, range)) if *last == row => range.end = at + 1,
            _ => hit.push((row, at..at + 1)),
        }
    }
    hit
}

#[cfg(test)]
mod tests {
    use super::*;
    use views::block::Tone;

    fn found(rows: &[&str], words: &str) -> Vec<Hit> {
        let rows: Vec<Row> = rows.iter().map(|text| Row::Text(vec![(Tone::Plain, (*text).to_owned())])).collect();
        hits(rows.iter(), words)
    }

    #[test]
    fn words_are_found_across_rows_and_in_any_case() {
        assert_eq!(found(&["The angle of", "  Brewster is"], "OF brewster"), [vec![(0, 10..12), (1, 2..10)]]);
        assert_eq!(found(&["θ_B and Θ_b"], "θ_b"), [vec![(0, 0..3)], vec![(0, 8..11)]]);
        assert_eq!(found(&["a  b", "", "c"], "b c"), [vec![(0, 3..4), (2, 0..1)]]);
        assert!(found(&["abc"], "  ").is_empty() && found(&["abc"], "bd").is_empty());
    }
}
