//! A frame with ticks, grid, axis labels, and the names of reference lines.

use super::canvas::{Across, Anchor, Canvas, Down, Frame, Place};
use super::label::Label;
use super::marks::{Beyond, Plane};
use super::palette::Colour;
use super::ticks::{Extent, Tick};
use super::{TEXT, text};
use chapters::figure::{Axis, Mark, Scale};
use std::borrow::Cow;

const TICK: f64 = 6.0;
const MINOR: f64 = 3.5;
/// Between a tick and its label, and a label and the next thing.
const GAP: f64 = 5.0;
/// Height of a line of text with its leading.
const LINE: f64 = 20.0;
/// Smallest margin, half of which keeps thick strokes off the edge.
const LEAST: f64 = 10.0;

/// Rows in which names may stand above the frame.
const ROWS: usize = 4;
/// Between the frame or another line and the lowest part of a name above it.
const NAME_GAP: f64 = 3.0;
/// Height of a band of what has no place on the vertical axis, and its distance from the frame.
const BAND: f64 = 18.0;
const BAND_GAP: f64 = 10.0;
/// Steps of the search for places for the names: ample for a handful, and an end for a hundred.
const PATIENCE: usize = 20_000;

/// Room that a panel keeps free of the frame for something else.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spare {
    /// To the right of the frame.
    pub right: f64,
    /// Under the label of the horizontal axis.
    pub below: f64,
}

/// A pair of axes laid out.
pub struct Axes<'a> {
    /// Where the curves go.
    pub frame: Frame,
    /// The axes in numbers.
    pub plane: Plane,
    /// The band above the frame for what has no finite value, where there is any.
    pub band: Option<Frame>,
    /// The band under the frame for what is exactly zero, where there is any.
    pub zeros: Option<Frame>,
    marks: &'a [Mark],
    room: Frame,
    is_bare: bool,
    x_label: Label,
    y_label: Label,
    /// Ticks of the horizontal axis.
    pub x_ticks: Vec<Tick>,
    y_ticks: Vec<Tick>,
    names: Vec<Name<'a>>,
}

/// The name of a vertical reference line, above the frame.
#[derive(Clone)]
struct Name<'a> {
    label: Cow<'a, str>,
    x: f64,
    /// Whether its line is beyond the axis: the label then has an arrow that way.
    is_beyond: bool,
    row: usize,
    place: Frame,
}

impl<'a> Axes<'a> {
    /// Lays axes out in `room`, keeping `spare` free.
    pub fn new(x: &'a Axis, y: &'a Axis, plane: Plane, marks: &'a [Mark], room: &Frame, spare: Spare) -> Self {
        let (x_label, y_label) = (Label::new(x, 0.9 * room.width()), Label::new(y, 0.9 * room.height()));
        let [has_band, has_zeros] =
            [Beyond::Broken, Beyond::Vanished].map(|beyond| beyond.points(marks).next().is_some());
        let under = if has_zeros { BAND_GAP + BAND } else { 0.0 };
        let beneath = under + TICK + GAP + LINE + x_label.thickness() + spare.below;
        let y_ticks = ticks(&plane.y, y, room.height() - beneath - LEAST, Direction::Up);
        let left = y_label.thickness() + beside(&y_ticks, has_band, has_zeros) + 2.0;
        let x_ticks = ticks(&plane.x, x, room.width() - left - spare.right - LEAST, Direction::Across);
        let overhang =
            x_ticks.iter().filter(|tick| tick.at > 0.9).map(|tick| tick_width(tick) / 2.0).fold(0.0, f64::max);
        let right = spare.right + LEAST.max(overhang + 2.0);
        let mut frame = Frame {
            left: (room.left + left).ceil(),
            top: room.top + LEAST,
            right: (room.right - right).floor(),
            bottom: (room.bottom - beneath).floor(),
        };
        frame.right = frame.right.max(frame.left + 1.0);
        let x_ticks = ticks(&plane.x, x, frame.width(), Direction::Across);
        let mut names = names(&plane, marks, &frame, room);
        let rows = names.iter().map(|name| name.row + 1).max().unwrap_or(0);
        let lines = (frame.top + rows as f64 * LINE).ceil();
        let band = has_band.then_some(Frame { top: lines, bottom: lines + BAND, ..frame });
        frame.top = band.map_or(lines, |band| band.bottom + BAND_GAP);
        frame.bottom = frame.bottom.max(frame.top + 1.0);
        let zeros = has_zeros.then_some(Frame {
            top: frame.bottom + BAND_GAP,
            bottom: frame.bottom + BAND_GAP + BAND,
            ..frame
        });
        for name in &mut names {
            let bottom = lines - NAME_GAP - text::DESCENT * TEXT - name.row as f64 * LINE;
            name.place = Frame { bottom, top: bottom - text::CAPITAL * TEXT, ..name.place };
        }
        let is_bare = x.is_bare() && y.is_bare();
        Self { frame, plane, band, zeros, marks, room: *room, is_bare, x_label, y_label, x_ticks, y_ticks, names }
    }

    /// Gives pairs of axes the same ticks where they show the same extents: as many as all have room for.
    pub fn agree(all: &mut [&mut Self]) {
        agree(all, |axes| (axes.plane.x, &mut axes.x_ticks));
        agree(all, |axes| (axes.plane.y, &mut axes.y_ticks));
    }

    /// Grid lines, for behind the curves.
    pub fn draw_grid(&self, canvas: &dyn Canvas) {
        let frame = &self.frame;
        for tick in self.x_ticks.iter().filter(|tick| tick.label.is_some()) {
            canvas.line(frame.place(tick.at, 0.0), frame.place(tick.at, 1.0), Colour::Grid, 1.0);
        }
        for tick in self.y_ticks.iter().filter(|tick| tick.label.is_some()) {
            canvas.line(frame.place(0.0, tick.at), frame.place(1.0, tick.at), Colour::Grid, 1.0);
        }
    }

    /// Frame, ticks, labels and names, for over the curves.
    pub fn draw(&self, canvas: &dyn Canvas) {
        let frame = &self.frame;
        if !self.is_bare {
            canvas.outline(frame, Colour::Ink, 1.0);
        }
        let foot = self.zeros.map_or(frame.bottom, |zeros| zeros.bottom);
        for tick in &self.x_ticks {
            let (x, y) = (frame.place(tick.at, 0.0).0, foot);
            canvas.line((x, y), (x, y + tick_length(tick)), Colour::Ink, 1.0);
            if let Some(label) = &tick.label {
                let anchor = Anchor(Across::Middle, Down::Bottom);
                canvas.text(label, (x, y + TICK + GAP + LINE - GAP), anchor, TEXT, Colour::Ink);
            }
        }
        for tick in &self.y_ticks {
            draw_y_tick(canvas, frame.place(0.0, tick.at), tick, -1.0);
        }
        let ((across, up), room) = (frame.place(0.5, 0.5), &self.room);
        self.x_label.draw_under(canvas, foot + TICK + GAP + LINE, across, (room.left, room.right));
        let beside = beside(&self.y_ticks, self.band.is_some(), self.zeros.is_some());
        let left = frame.left - beside - self.y_label.thickness();
        self.y_label.draw_upwards(canvas, left, up, (room.top, room.bottom));
        let top = self.band.map_or(frame.top, |band| band.top);
        for (band, beyond) in [(&self.band, Beyond::Broken), (&self.zeros, Beyond::Vanished)] {
            if let Some(band) = band {
                self.draw_band(canvas, band, beyond);
            }
        }
        for name in &self.names {
            // The line of a name in a higher row goes on through the lower ones, which keep clear of it.
            if name.row > 0 && !name.is_beyond {
                canvas.line((name.x, top), (name.x, top - name.row as f64 * LINE), Colour::Aid, 1.2);
            }
            let place = (name.place.left, name.place.bottom);
            canvas.text(&name.label, place, Anchor(Across::Left, Down::Bottom), TEXT, Colour::Aid);
        }
    }

    fn draw_band(&self, canvas: &dyn Canvas, band: &Frame, beyond: Beyond) {
        canvas.fill(band, Colour::Band, 1.0);
        canvas.outline(band, Colour::Ink, 1.0);
        let tick = Tick { at: 0.5, label: Some(beyond.name().into()) };
        draw_y_tick(canvas, band.place(0.0, tick.at), &tick, -1.0);
        beyond.draw(canvas, band, &self.plane, self.marks);
    }
}

/// Gives axes of one extent the ticks of the one that has fewest labels.
fn agree<'a>(all: &mut [&mut Axes<'a>], of: impl for<'b> Fn(&'b mut Axes<'a>) -> (Extent, &'b mut Vec<Tick>)) {
    let labels = |ticks: &[Tick]| ticks.iter().filter(|tick| tick.label.is_some()).count();
    for k in 1..all.len() {
        let (before, rest) = all.split_at_mut(k);
        let (extent, ticks) = of(&mut *rest[0]);
        for other in before {
            let (other_extent, others) = of(other);
            if extent == other_extent {
                if labels(ticks) < labels(others) { others.clone_from(ticks) } else { ticks.clone_from(others) }
            }
        }
    }
}

/// Width that the labels of the ticks and the names of the bands take beside the vertical axis.
fn beside(ticks: &[Tick], has_band: bool, has_zeros: bool) -> f64 {
    let bands =
        [(has_band, Beyond::Broken), (has_zeros, Beyond::Vanished)].into_iter().filter(|(is_there, _)| *is_there);
    let names = bands.map(|(_, beyond)| text::width(beyond.name(), TEXT) + TICK + GAP);
    names.fold(tick_room(ticks), f64::max)
}

fn tick_length(tick: &Tick) -> f64 {
    if tick.label.is_some() { TICK } else { MINOR }
}

fn tick_width(tick: &Tick) -> f64 {
    tick.label.as_ref().map_or(0.0, |label| text::width(label, TEXT))
}

/// Width that ticks and their labels take beside a vertical axis.
pub fn tick_room(ticks: &[Tick]) -> f64 {
    ticks.iter().map(tick_width).fold(0.0, f64::max) + TICK + GAP
}

/// A tick and its label to the left (−1) or right (+1) of a vertical axis.
pub fn draw_y_tick(canvas: &dyn Canvas, (x, y): Place, tick: &Tick, side: f64) {
    canvas.line((x, y), (x + side * tick_length(tick), y), Colour::Ink, 1.0);
    if let Some(label) = &tick.label {
        let align = if side < 0.0 { Across::Right } else { Across::Left };
        canvas.text(label, (x + side * (TICK + GAP), y), Anchor(align, Down::Middle), TEXT, Colour::Ink);
    }
}

/// Which way an axis runs.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From left to right.
    Across,
    /// From bottom to top.
    Up,
}

/// As many ticks as `length` has room for without their labels touching.
pub fn ticks(extent: &Extent, axis: &Axis, length: f64, direction: Direction) -> Vec<Tick> {
    if axis.is_bare() {
        return Vec::new();
    }
    let (pitch, gap) = match (direction, axis.scale) {
        (Direction::Across, _) => (66.0, 12.0),
        (Direction::Up, Scale::Linear) => (38.0, 5.0),
        (Direction::Up, Scale::Log) => (28.0, 5.0),
    };
    let size = |tick: &Tick| if direction == Direction::Across { tick_width(tick) } else { TEXT };
    let apart = |a: &Tick, b: &Tick| (b.at - a.at) * length >= (size(a) + size(b)) / 2.0 + gap;
    let most = ((length / pitch) as usize).clamp(2, 12);
    let tried = (2..=most).rev().map(|count| extent.ticks(count, axis.tick));
    let mut ticks = tried
        .into_iter()
        .find(|ticks| {
            let labelled: Vec<&Tick> = ticks.iter().filter(|tick| tick.label.is_some()).collect();
            labelled.windows(2).all(|pair| apart(pair[0], pair[1]))
        })
        .unwrap_or_else(|| extent.ticks(2, axis.tick));
    // A step that was asked for stays; labels that would touch the one before are left out.
    let mut last: Option<Tick> = None;
    for tick in ticks.iter_mut().filter(|tick| tick.label.is_some()) {
        if last.as_ref().is_none_or(|last| apart(last, tick)) {
            last = Some(tick.clone());
        } else {
            tick.label = None;
        }
    }
    let first = ticks.iter().position(|tick| tick.label.is_some());
    if let Some((start, first)) = extent.start_tick().zip(first)
        && apart(&start, &ticks[first])
    {
        ticks.retain(|tick| tick.label.is_some() || (tick.at - start.at).abs() > 1e-9);
        ticks.insert(ticks.partition_point(|tick| tick.at < start.at), start);
    }
    ticks
}

/// Places the names of vertical reference lines above the frame, clear of each other and of each other's lines.
fn names<'a>(plane: &Plane, marks: &'a [Mark], frame: &Frame, room: &Frame) -> Vec<Name<'a>> {
    let mut lines: Vec<(f64, Cow<str>)> = marks.iter().filter_map(|mark| at_x(plane, mark)).collect();
    lines.retain(|(_, label)| !label.is_empty());
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    let candidates: Vec<Vec<Name>> = lines
        .into_iter()
        .map(|(fraction, label)| {
            let is_beyond = !(0.0..=1.0).contains(&fraction);
            let (x, width) = (frame.place(fraction.clamp(0.0, 1.0), 0.0).0, text::width(&label, TEXT));
            let places = (0..ROWS).flat_map(|row| [0.5, 0.0, 1.0].map(|share| (row, x - share * width)));
            let names = places.map(|(row, left)| {
                let left = left.min(room.right - width).max(room.left);
                Name {
                    label: label.clone(),
                    x,
                    is_beyond,
                    row,
                    place: Frame { left, right: left + width, top: 0.0, bottom: 0.0 },
                }
            });
            names.collect()
        })
        .collect();
    let mut chosen = Vec::new();
    if !choose(&candidates, &mut chosen, &mut { PATIENCE }) {
        // Rather on top of each other's lines than of each other.
        chosen = candidates.iter().enumerate().map(|(k, names)| names[3 * (k % ROWS)].clone()).collect();
    }
    chosen
}

/// Chooses one of each list such that all are apart, the earlier candidates first; gives up out of patience.
fn choose<'a>(candidates: &[Vec<Name<'a>>], chosen: &mut Vec<Name<'a>>, patience: &mut usize) -> bool {
    let Some(names) = candidates.get(chosen.len()) else { return true };
    for name in names {
        *patience = patience.saturating_sub(1);
        if *patience > 0 && chosen.iter().all(|other| apart(name, other)) {
            chosen.push(name.clone());
            if choose(candidates, chosen, patience) {
                return true;
            }
            chosen.pop();
        }
    }
    false
}

/// Whether neither name touches the other or the line that leads to it.
fn apart(a: &Name, b: &Name) -> bool {
    let crosses = |line: &Name, name: &Name| {
        !line.is_beyond && line.row > name.row && name.place.left - GAP < line.x && line.x < name.place.right + GAP
    };
    let touches = a.row == b.row && a.place.left < b.place.right + GAP && b.place.left < a.place.right + GAP;
    !touches && !crosses(a, b) && !crosses(b, a)
}

/// Fraction of the axis and name of a vertical reference line; one beyond the axis has an arrow that way.
fn at_x<'a>(plane: &Plane, mark: &'a Mark) -> Option<(f64, Cow<'a, str>)> {
    let Mark::AtX { x, label } = mark else { return None };
    let shown = plane.x.fraction(*x);
    // Zero and the infinities have no place on the axis, but a side of it.
    let fraction = if shown.is_nan() { 2.0 * plane.x.position(*x) - 0.5 } else { shown };
    let label = match fraction {
        _ if fraction.is_nan() => return None,
        _ if label.is_empty() => Cow::Borrowed(""),
        _ if fraction < 0.0 => format!("← {label}").into(),
        _ if fraction > 1.0 => format!("{label} →").into(),
        _ => Cow::Borrowed(label.as_str()),
    };
    Some((fraction, label))
}
