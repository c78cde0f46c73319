//! The reader without its terminal.

use super::shown::KEYS;
use super::*;
use crate::reader::graphics::Ground;
use crate::reader::work::{Finished, Order, Outcome, Source, Task};
use chapters::parameter::Setting;
use std::sync::Arc;
use views::report::entry::readout;

fn reader(at: &str, size: (usize, usize)) -> Reader {
    let leaves: Vec<Leaf> = chapters::steps()
        .map(|(chapter, step)| Leaf::new(chapter, step, Setting::defaults(step.parameters())))
        .collect();
    let at = leaves.iter().position(|leaf| leaf.address() == at).unwrap();
    let start = Start {
        at,
        resume: false,
        size,
        ground: Ground::Halves,
        short: false,
        details: Details::default(),
        memory: Memory::default(),
        note: None,
    };
    Reader::new(leaves, start)
}

fn press(reader: &mut Reader, keys: &str) {
    for key in keys.chars() {
        let key = match key {
            '\n' => Key::Enter,
            '\x1b' => Key::Escape,
            key => Key::Char(key),
        };
        reader.take(Event::Key(key));
    }
}

fn bar(reader: &Reader) -> String {
    reader.screen().last().unwrap().row.text()
}

fn text(reader: &Reader) -> String {
    reader.screen().iter().map(|line| line.row.text() + "\n").collect()
}

/// Draws and reads what is wanted, as the crew would.
fn draw(reader: &mut Reader) {
    for effect in reader.effects() {
        let Effect::Do(Job { leaf, task }) = effect else { continue };
        let result = match task {
            Task::Draw { which, source, order } => {
                let plot = match source {
                    Source::Figure(figure, setting) => Arc::new((figure.plot)(&setting)),
                    Source::Plot(plot) => plot,
                };
                let picture = order.ground.picture(&plot, order.columns, order.rows);
                Outcome::Drawn { which, order, drawn: Some((plot, picture)) }
            }
            Task::Read { step, setting, edition } => Outcome::Read { edition, readout: Some(readout(step, &setting)) },
            _ => continue,
        };
        reader.take(Event::Done(Finished { leaf, result }));
    }
}

#[test]
fn a_chapter_takes_few_presses() {
    let mut reader = reader("fresnel/snell", (80, 24));
    let mut presses = 0;
    loop {
        draw(&mut reader);
        if bar(&reader).contains("17/17") && reader.is_at_end() {
            break;
        }
        press(&mut reader, " ");
        presses += 1;
        // A question, and four screens of what answers it.
        assert!(presses <= 5 * 17, "still at {}", bar(&reader));
    }
    assert!(presses > 17, "a screen for every step, and more than that");
}

#[test]
fn back_leads_where_one_was_whatever_led_away() {
    let mut reader = reader("fresnel/snell", (80, 24));
    let mut places = vec![(reader.at, reader.top)];
    for keys in ["n", " ", " ", "gschlick\n", "N", "/grazing\n", "f"] {
        press(&mut reader, keys);
        places.push((reader.at, reader.top));
    }
    places.dedup();
    while let Some(place) = places.pop() {
        assert_eq!((reader.at, reader.top), place, "{places:?}");
        if !places.is_empty() {
            press(&mut reader, "b");
        }
    }
    assert_eq!((reader.leaves[reader.at].address().as_str(), reader.top), ("fresnel/snell", 0));
}

#[test]
fn every_screen_fits_its_terminal_and_keeps_its_place_when_that_changes() {
    let mut reader = reader("fresnel/snell", (80, 24));
    press(&mut reader, "n  ");
    let first = reader.sheet.rows[reader.top..].iter().find(|row| !row.is_empty()).unwrap().text();
    let word = first.split_whitespace().next().unwrap().to_owned();
    for size in [(40, 20), (200, 50), (61, 23), (100, 30), (80, 24)] {
        reader.take(Event::Resize(size.0, size.1));
        let screen = reader.screen();
        assert_eq!(screen.len(), size.1);
        for line in &screen {
            let wide: usize = line.margin + unicode_width::UnicodeWidthStr::width(line.row.text().as_str());
            assert!(wide <= size.0, "{size:?}: {:?}", line.row.text());
        }
    }
    assert!(text(&reader).contains(&word), "{word}: {}", text(&reader));
    reader.take(Event::Resize(30, 10));
    assert!(text(&reader).contains("30 × 10"), "{}", text(&reader));
}

#[test]
fn a_question_keeps_the_rest_back_until_it_is_answered_or_passed() {
    let mut one = reader("fresnel/brewster", (80, 24));
    let rows = one.sheet.rows.len();
    assert!(bar(&one).contains("answers"), "{}", bar(&one));
    press(&mut one, "9");
    assert!(bar(&one).contains("is no answer; valid: 1 to 5"), "{}", bar(&one));
    press(&mut one, "1");
    assert!(one.sheet.rows.len() > rows + 10 && text(&one).contains("Your answer: 1)"), "{}", text(&one));
    assert_eq!(one.memory.answers.len(), 1);
    let mut other = reader("fresnel/brewster", (80, 24));
    press(&mut other, " ");
    assert!(other.sheet.rows.len() > rows + 10 && other.memory.answers.is_empty());
    press(&mut other, "a");
    assert!(bar(&other).contains("answers"), "{}", bar(&other));
}

#[test]
fn a_setting_answers_at_once_and_asks_for_what_takes_longer() {
    let mut reader = reader("fresnel/brewster", (80, 24));
    press(&mut reader, " e");
    draw(&mut reader);
    press(&mut reader, "s");
    draw(&mut reader);
    let before = text(&reader);
    reader.take(Event::Key(Key::Right { shift: false }));
    assert_ne!(text(&reader), before);
    let tasks: Vec<_> = reader
        .effects()
        .into_iter()
        .filter_map(|effect| if let Effect::Do(job) = effect { Some(job.task) } else { None })
        .collect();
    assert!(
        tasks.iter().any(|task| matches!(task, Task::Judge { kind: Evidence::Checks, edition: 1, .. })),
        "{tasks:?}"
    );
    assert!(tasks.iter().any(|task| matches!(task, Task::Draw { order: Order { edition: 1, .. }, .. })), "{tasks:?}");
    // What comes late from the old setting is not taken for the new one's.
    let late = Outcome::Judged { kind: Evidence::Checks, edition: 0, found: Some(Vec::new()) };
    let at = reader.at;
    reader.take(Event::Done(Finished { leaf: at, result: late }));
    assert!(reader.leaves[at].is_busy());
}

#[test]
fn words_are_found_in_the_whole_chapter() {
    let mut reader = reader("fresnel/snell", (80, 24));
    press(&mut reader, "/brewster\n");
    assert!(bar(&reader).contains("“brewster”"), "{}", bar(&reader));
    let marked = |reader: &Reader| reader.screen().iter().any(|line| !line.marks.is_empty());
    let first = (reader.at, reader.top);
    for _ in 0..5 {
        assert!(marked(&reader), "{}", text(&reader));
        press(&mut reader, ".");
    }
    press(&mut reader, ",,,,,");
    assert_eq!(reader.at, first.0);
    press(&mut reader, "\x1b/xyzzy\n");
    assert!(bar(&reader).contains("does not stand"), "{}", bar(&reader));
}

#[test]
fn every_key_is_told_and_every_told_key_does_something() {
    let mut reader = reader("fresnel/natural", (80, 24));
    press(&mut reader, "?");
    for (keys, _) in KEYS {
        assert!(text(&reader).contains(keys), "{keys}");
    }
    press(&mut reader, " ");
    for (keys, _) in KEYS {
        for key in keys.split([' ', ',']).filter(|key| key.chars().count() == 1 && !"…↑↓".contains(key)) {
            press(&mut reader, key);
            assert!(!bar(&reader).contains("? shows the keys"), "{key}");
            press(&mut reader, "\x1b\x1b");
        }
    }
}

#[test]
fn what_broke_at_a_former_setting_is_not_forgotten() {
    let mut reader = reader("fresnel/brewster", (80, 24));
    press(&mut reader, " e");
    let (before, _) = reader.verdicts();
    let lost = Outcome::Judged { kind: Evidence::Checks, edition: 0, found: None };
    let at = reader.at;
    reader.take(Event::Done(Finished { leaf: at, result: lost }));
    assert_eq!(reader.verdicts(), (before + 1, 1));
    press(&mut reader, "s");
    reader.take(Event::Key(Key::Right { shift: false }));
    assert_eq!(reader.verdicts(), (before + 1, 1));
}
