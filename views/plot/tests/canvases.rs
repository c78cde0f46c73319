//! The canvas with `plotters` and the one without put the same on the sheet.

use super::super::canvas::{Plain, WithPlotters};
use super::super::sheet::{Image, Item, Path, Sheet, Text};
use super::gallery;
use chapters::figure::Plot;
use chapters::setting::Setting;

/// How far apart two coordinates may be [px]: a step of the sheet, of which there are 64 to a pixel, and an f32.
const NEAR: f32 = 0.02;

/// Every figure of the gallery and of the chapters, with its name.
fn figures() -> impl Iterator<Item = (String, Plot)> {
    let steps =
        chapters::CURRICULUM.iter().flat_map(|chapter| chapter.steps.iter().map(move |step| (chapter.id, step)));
    let listed = steps.flat_map(|(chapter, step)| {
        let figures = step.figures.iter().map(move |figure| (chapter, step, figure));
        figures.map(|(chapter, step, figure)| {
            let plot = (figure.plot)(&Setting::defaults(step.parameters));
            (format!("{chapter}/{}/{}", step.id, figure.id), plot)
        })
    });
    gallery::all().into_iter().map(|(name, plot)| (name.to_owned(), plot)).chain(listed)
}

/// Why two sheets differ, if they do.
fn difference(one: &Sheet, other: &Sheet) -> Option<String> {
    if (one.width, one.height, one.items.len()) != (other.width, other.height, other.items.len()) {
        return Some(format!("{} items of {} against {}", one.width, one.items.len(), other.items.len()));
    }
    let pair = one.items.iter().zip(&other.items).enumerate().find(|(_, (one, other))| !is_same(one, other));
    pair.map(|(k, (one, other))| format!("item {k}: {one:?} against {other:?}"))
}

fn is_same(one: &Item, other: &Item) -> bool {
    match (one, other) {
        (Item::Fill { path: a, paint: p }, Item::Fill { path: b, paint: q }) => p == q && is_same_path(a, b),
        (Item::Disc { centre: a, radius: r, paint: p }, Item::Disc { centre: b, radius: s, paint: q }) => {
            p == q && is_near(*a, *b) && (r - s).abs() < NEAR
        }
        (
            Item::Stroke { path: a, paint: p, width: v, dashes: d },
            Item::Stroke { path: b, paint: q, width: w, dashes: e },
        ) => p == q && v == w && d == e && is_same_path(a, b),
        (Item::Text(a), Item::Text(b)) => is_same_text(a, b),
        (Item::Image(a), Item::Image(b)) => is_same_image(a, b),
        _ => false,
    }
}

fn is_near(a: [f32; 2], b: [f32; 2]) -> bool {
    (a[0] - b[0]).abs() < NEAR && (a[1] - b[1]).abs() < NEAR
}

fn is_same_path(a: &Path, b: &Path) -> bool {
    let is_as_long = a.points.len() == b.points.len() && a.is_closed == b.is_closed;
    is_as_long && a.points.iter().zip(&b.points).all(|(a, b)| is_near(*a, *b))
}

fn is_same_text(a: &Text, b: &Text) -> bool {
    let is_alike = a.label == b.label && a.paint == b.paint && a.upwards == b.upwards;
    is_alike && (a.size - b.size).abs() < 1e-3 && is_near(a.start, b.start)
}

fn is_same_image(a: &Image, b: &Image) -> bool {
    a.place == b.place && a.columns == b.columns && a.cells == b.cells
}

#[test]
fn both_canvases_draw_every_figure_alike() {
    let mut drawn = 0;
    for (name, plot) in figures() {
        let (with, without) = (super::super::draw::<WithPlotters>(&plot), super::super::draw::<Plain>(&plot));
        assert!(!with.items.is_empty(), "{name} is empty");
        if let Some(difference) = difference(&with, &without) {
            panic!("{name}: {difference}");
        }
        drawn += 1;
    }
    assert!(drawn > 50, "only {drawn} figures");
}

/// A test that finds all alike shows little unless it also finds a slip.
#[test]
fn a_step_too_far_is_seen() {
    let (_, plot) = gallery::all().remove(0);
    let with = super::super::draw::<WithPlotters>(&plot);
    let moved = |by: f32| {
        let mut sheet = super::super::draw::<Plain>(&plot);
        let stroke = sheet.items.iter_mut().rev().find_map(|item| match item {
            Item::Stroke { path, .. } => Some(path),
            _ => None,
        });
        stroke.expect("a stroke").points[0][0] += by;
        difference(&with, &sheet)
    };
    assert_eq!(moved(0.001), None);
    assert!(moved(0.04).is_some());
}
