//! Charts: curves and points on axes, with a key that hides none of them.

use super::axes::{Axes, Spare};
use super::canvas::{Across, Anchor, Canvas, Down, Frame, Place};
use super::ink::{Ink, Survey};
use super::key::{Key, Side};
use super::marks::{self, Beyond, Plane};
use super::palette::Colour;
use super::ticks::Extent;
use super::{TEXT, text};
use chapters::figure::{Axis, Chart, Mark};

/// Free space around a key or a name.
const CLEARANCE: f64 = 5.0;
/// Distance of a key from the frame.
const INSET: f64 = 8.0;
/// Share of the panel's width that the key may take beside the frame, and that names may.
const KEY_BESIDE: f64 = 0.28;
const NAMES_BESIDE: f64 = 0.36;

/// Draws a chart as arranged.
pub fn draw(canvas: &dyn Canvas, chart: &Chart, arrangement: &Arrangement) {
    let Arrangement { axes, names, key } = arrangement;
    axes.draw_grid(canvas);
    axes.draw(canvas);
    marks::draw(canvas, &axes.frame, &axes.plane, &chart.marks, false);
    for (label, place) in names {
        draw_name(canvas, label, *place, Colour::Aid);
    }
    if let Some((key, place)) = key {
        key.draw(canvas, *place);
    }
}

/// Where everything goes.
pub struct Arrangement<'a> {
    /// The frame with its ticks and labels.
    pub axes: Axes<'a>,
    /// Names of horizontal reference lines and the starts of their baselines.
    pub names: Vec<(&'a str, Place)>,
    /// The key and its top left corner.
    pub key: Option<(Key<'a>, Place)>,
}

/// What the frame makes room for.
struct Outside<'a> {
    /// Indices of the horizontal lines that are named beside the frame.
    names: Vec<usize>,
    key: Option<Key<'a>>,
}

/// Tries to fit names and key among the curves, and moves out of the frame what does not fit, one at a time, since
/// the frame shrinks with each.
pub fn arrange<'a>(chart: &'a Chart, room: &Frame) -> Arrangement<'a> {
    let plane = plane(&chart.x, &chart.y, &chart.marks);
    let mut outside = Outside { names: Vec::new(), key: None };
    loop {
        let axes = Axes::new(&chart.x, &chart.y, plane, &chart.marks, room, spare(chart, &outside));
        let mut ink = Ink::none(axes.frame);
        marks::ink(&mut ink, &axes.frame, &plane, &chart.marks);
        let names = match place_names(chart, &axes, &mut ink, &outside, room) {
            Ok(names) => names,
            Err(index) => {
                outside.names.push(index);
                continue;
            }
        };
        match place_key(chart, &axes, &ink, &outside, room) {
            Ok(key) => return Arrangement { axes, names, key },
            Err(key) => outside.key = Some(key),
        }
    }
}

/// The names of horizontal reference lines and where they start, inked; or the mark whose name must go outside.
fn place_names<'a>(
    chart: &'a Chart,
    axes: &Axes,
    ink: &mut Ink,
    outside: &Outside,
    room: &Frame,
) -> Result<Vec<(&'a str, Place)>, usize> {
    let frame = &axes.frame;
    let mut names = Vec::new();
    for (index, mark) in chart.marks.iter().enumerate() {
        let Some((y, label)) = at_y(&axes.plane, mark) else { continue };
        let (height, width) = (frame.place(0.0, y).1, text::width(label, TEXT));
        let place = if outside.names.contains(&index) {
            (frame.right + CLEARANCE, height + text::CAPITAL / 2.0 * TEXT)
        } else if let Some(place) = name_place(&ink.survey(), frame, height, width) {
            place
        } else if width < NAMES_BESIDE * room.width() {
            return Err(index);
        } else {
            (frame.right - width - CLEARANCE, height - CLEARANCE)
        };
        ink.rectangle(&name_box(place, width));
        names.push((label, place));
    }
    spread(&mut names, frame);
    Ok(names)
}

/// The key and its place, if there is anything to explain; or the key that must go outside.
fn place_key<'a>(
    chart: &'a Chart,
    axes: &Axes,
    ink: &Ink,
    outside: &Outside<'a>,
    room: &Frame,
) -> Result<Option<(Key<'a>, Place)>, Key<'a>> {
    let key = Key::new(&chart.marks);
    if key.is_empty() {
        return Ok(None);
    }
    if let Some(key) = &outside.key {
        let place = outside_place(key, &axes.frame, room, names_width(chart, &outside.names));
        return Ok(Some((key.clone(), place)));
    }
    key_place(&key, ink, &axes.frame).map(Some).ok_or_else(|| key.outside(room, KEY_BESIDE))
}

/// The axes in numbers: as given, or else as the marks need them.
pub fn plane(x: &Axis, y: &Axis, marks: &[Mark]) -> Plane {
    let dots =
        marks.iter().any(|mark| matches!(mark, Mark::Points { .. } | Mark::Broken { .. } | Mark::Vanished { .. }));
    let xs = marks::points(marks).filter(|[_, y]| y.is_finite()).map(|[x, _]| x);
    let beyond = [Beyond::Broken, Beyond::Vanished].into_iter().flat_map(|beyond| beyond.points(marks));
    let at_x = marks.iter().filter_map(|mark| if let Mark::AtX { x, .. } = mark { Some(*x) } else { None });
    let x = Extent::new(x, xs.chain(beyond).chain(at_x), if dots { 0.04 } else { 0.0 });
    let shown = |[along, _]: &[f64; 2]| (0.0..=1.0).contains(&x.fraction(*along));
    let at_y = marks.iter().filter_map(|mark| if let Mark::AtY { y, .. } = mark { Some(*y) } else { None });
    let ys = marks::points(marks).filter(shown).map(|[_, y]| y).chain(at_y);
    Plane { x, y: Extent::new(y, ys, 0.05) }
}

/// Fraction of the axis and name of a horizontal reference line within the frame.
pub fn at_y<'a>(plane: &Plane, mark: &'a Mark) -> Option<(f64, &'a str)> {
    let Mark::AtY { y, label } = mark else { return None };
    let fraction = plane.y.fraction(*y);
    ((0.0..=1.0).contains(&fraction) && !label.is_empty()).then_some((fraction, label.as_str()))
}

/// What a name covers that starts at a place.
pub fn name_box((left, bottom): Place, width: f64) -> Frame {
    Frame { left, right: left + width, top: bottom - text::CAPITAL * TEXT, bottom: bottom + text::DESCENT * TEXT }
}

/// Baselines of a name just over and just under a line at a height.
pub fn beside_line(height: f64) -> [f64; 2] {
    [height - CLEARANCE - text::DESCENT * TEXT, height + CLEARANCE + text::CAPITAL * TEXT]
}

/// Writes a name on a white plate, which keeps it readable over grid lines and maps.
pub fn draw_name(canvas: &dyn Canvas, label: &str, place: Place, colour: Colour) {
    canvas.fill(&name_box(place, text::width(label, TEXT)).grown(2.0), Colour::Paper, 0.85);
    canvas.text(label, place, Anchor(Across::Left, Down::Bottom), TEXT, colour);
}

/// A place for a name just over or under its line, as far to the right as can be; none if all are taken.
fn name_place(survey: &Survey, frame: &Frame, height: f64, width: f64) -> Option<Place> {
    let [over, under] = beside_line(height);
    let steps = ((frame.width() - width - 2.0 * CLEARANCE) / 6.0).max(-1.0) as i64;
    let along = (0..=steps).map(|k| frame.right - CLEARANCE - width - 6.0 * k as f64);
    let places = along.flat_map(|left| [(left, over), (left, under)]);
    places.into_iter().find(|place| {
        let name = name_box(*place, width);
        name.top > frame.top && name.bottom < frame.bottom && survey.is_clear(&name.grown(1.5))
    })
}

/// Moves names beside the frame apart, downwards, and back up if they pass its bottom.
fn spread(names: &mut [(&str, Place)], frame: &Frame) {
    let mut beside: Vec<&mut Place> =
        names.iter_mut().map(|name| &mut name.1).filter(|at| at.0 > frame.right).collect();
    beside.sort_by(|a, b| a.1.total_cmp(&b.1));
    for k in 1..beside.len() {
        beside[k].1 = beside[k].1.max(beside[k - 1].1 + 1.15 * TEXT);
    }
    let beyond = beside.last().map_or(0.0, |last| (last.1 - frame.bottom).max(0.0));
    beside.into_iter().for_each(|place| place.1 -= beyond);
}

/// Width that the names beside the frame take.
fn names_width(chart: &Chart, outside: &[usize]) -> f64 {
    let wide = |&index: &usize| match &chart.marks[index] {
        Mark::AtY { label, .. } => text::width(label, TEXT) + 2.0 * CLEARANCE,
        _ => 0.0,
    };
    outside.iter().map(wide).fold(0.0, f64::max)
}

fn spare(chart: &Chart, outside: &Outside) -> Spare {
    let names = names_width(chart, &outside.names);
    match &outside.key {
        Some(key) if key.side == Side::Beside => Spare { right: names + key.size().0, below: 0.0 },
        Some(key) => Spare { right: names, below: key.size().1 },
        None => Spare { right: names, below: 0.0 },
    }
}

/// The key among the curves, in the fewest columns that find a clear place.
fn key_place<'a>(key: &Key<'a>, ink: &Ink, frame: &Frame) -> Option<(Key<'a>, Place)> {
    let survey = ink.survey();
    key.layouts(frame.width()).find_map(|key| {
        let (width, height) = key.size();
        let place = survey.clear_place(width, height, INSET, CLEARANCE)?;
        Some((key, place))
    })
}

/// The top left corner of a key that stands outside the frame.
pub fn outside_place(key: &Key, frame: &Frame, room: &Frame, names: f64) -> Place {
    let (width, height) = key.size();
    if key.side == Side::Beside {
        return (frame.right + names + CLEARANCE, frame.top);
    }
    let left = (frame.left + frame.right - width) / 2.0;
    (left.min(room.right - width).max(room.left), room.bottom - height)
}
