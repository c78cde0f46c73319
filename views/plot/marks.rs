//! Curves and points on a pair of axes.

use super::canvas::{Canvas, Frame, Place};
use super::ink::Ink;
use super::palette::{self, Colour};
use super::ticks::Extent;
use chapters::figure::{Dash, Hue, Mark, Shape};
use std::collections::HashSet;

/// Width of a curve.
const CURVE: f64 = 2.4;
/// Width of the line that joins points.
const JOIN: f64 = 1.2;
/// Width of a reference line.
const AID: f64 = 1.2;
/// Radius of a point where there are few, and the least where there are many.
const POINT: (f64, f64) = (4.2, 1.7);
/// Half the width of the widest shape with its rim, in radii.
const WIDEST: f64 = 1.6;
/// How many points are few.
const FEW: f64 = 60.0;
/// Half the height of a bar in the key.
const SAMPLE: f64 = 5.0;
/// Width of the white casing of what is drawn over a map.
const CASING: f64 = 2.5;

/// The pair of axes in numbers.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// Horizontal.
    pub x: Extent,
    /// Vertical.
    pub y: Extent,
}

impl Plane {
    /// Fractions of the axes at a point; NaN where it cannot be shown.
    fn at(&self, [x, y]: [f64; 2]) -> Place {
        (self.x.fraction(x), self.y.fraction(y))
    }

    /// The line that a mark draws, if only as an empty one.
    fn stroke(&self, mark: &Mark) -> Stroke {
        let pieces = match mark {
            Mark::Line { points, .. } | Mark::Points { points, joined: true, .. } => self.pieces(points),
            Mark::Points { .. } | Mark::Bar { .. } | Mark::Broken { .. } | Mark::Vanished { .. } => Vec::new(),
            Mark::AtX { x, .. } => reference(self.x.fraction(*x), |along, across| (along, across)),
            Mark::AtY { y, .. } => reference(self.y.fraction(*y), |along, across| (across, along)),
        };
        Stroke { pieces, look: look(mark) }
    }

    /// The curve through points, broken where one cannot be shown, cut off at the frame.
    pub fn pieces(&self, points: &[[f64; 2]]) -> Vec<Vec<Place>> {
        let mut pieces: Vec<Vec<Place>> = Vec::new();
        for run in points.split(|point| !is_finite(self.at(*point))) {
            let run: Vec<Place> = run.iter().map(|point| self.at(*point)).collect();
            if let [lone] = run[..] {
                pieces.extend(is_inside(lone).then(|| vec![lone]));
            }
            let mut joins = false;
            for pair in run.windows(2) {
                let Some((from, to)) = cut(pair[0], pair[1]) else {
                    joins = false;
                    continue;
                };
                match pieces.last_mut().filter(|_| joins && from == pair[0]) {
                    Some(piece) => piece.push(to),
                    None => pieces.push(vec![from, to]),
                }
                joins = to == pair[1];
            }
        }
        pieces
    }

    /// The bar that ends at two corners, cut off at the frame; none if it has no end or none of its height.
    fn bar(&self, frame: &Frame, [low, high]: [[f64; 2]; 2]) -> Option<Frame> {
        let ((along, bottom), (_, top)) = (self.at(low), self.at(high));
        let [bottom, top] = [bottom, top].map(|height| height.clamp(0.0, 1.0));
        let ((left, below), (right, over)) = (frame.place(0.0, bottom), frame.place(along.clamp(0.0, 1.0), top));
        (is_finite((along, bottom)) && top > bottom).then_some(Frame { left, right, top: over, bottom: below })
    }

    /// The points within the frame.
    fn inside(&self, points: &[[f64; 2]]) -> Vec<Place> {
        points.iter().map(|point| self.at(*point)).filter(|place| is_inside(*place)).collect()
    }
}

/// A line in pieces, in fractions of the axes.
struct Stroke {
    pieces: Vec<Vec<Place>>,
    look: Look,
}

/// How a line looks: colour, width, and the lengths of its dashes.
type Look = (Colour, f64, &'static [f32]);

fn look(mark: &Mark) -> Look {
    match mark {
        Mark::Line { hue, dash, .. } => (palette::colour(*hue), CURVE, palette::dashes(*dash)),
        Mark::Points { hue, .. } | Mark::Bar { hue, .. } | Mark::Broken { hue, .. } | Mark::Vanished { hue, .. } => {
            (palette::colour(*hue), JOIN, &[])
        }
        Mark::AtX { .. } | Mark::AtY { .. } => (Colour::Aid, AID, &[]),
    }
}

/// A line through the whole frame at a fraction of one axis, if that is within it.
fn reference(at: f64, place: fn(f64, f64) -> Place) -> Vec<Vec<Place>> {
    if (0.0..=1.0).contains(&at) { vec![vec![place(at, 0.0), place(at, 1.0)]] } else { Vec::new() }
}

fn is_finite((x, y): Place) -> bool {
    x.is_finite() && y.is_finite()
}

fn is_inside((x, y): Place) -> bool {
    let unit = 0.0..=1.0;
    unit.contains(&x) && unit.contains(&y)
}

/// The part of a line within the unit square (Y.-D. Liang and B. A. Barsky, "A New Concept and Method for Line
/// Clipping", ACM Trans. Graph. 3, 1984); ends that lie inside are kept to the bit.
fn cut(from: Place, to: Place) -> Option<(Place, Place)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    for (slope, room) in [(-dx, from.0), (dx, 1.0 - from.0), (-dy, from.1), (dy, 1.0 - from.1)] {
        if slope == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if slope < 0.0 {
            enter = enter.max(room / slope);
        } else {
            leave = leave.min(room / slope);
        }
    }
    if enter > leave {
        return None;
    }
    let at = |t: f64| ((from.0 + t * dx).clamp(0.0, 1.0), (from.1 + t * dy).clamp(0.0, 1.0));
    Some((if enter > 0.0 { at(enter) } else { from }, if leave < 1.0 { at(leave) } else { to }))
}

/// Draws the marks in order; `cased` puts white around lines, for dark ground.
pub fn draw(canvas: &dyn Canvas, frame: &Frame, plane: &Plane, marks: &[Mark], cased: bool) {
    for mark in marks {
        let Stroke { pieces, look: (colour, width, dashes) } = plane.stroke(mark);
        if cased {
            canvas.curves(frame, &pieces, Colour::Paper, width + CASING, &[]);
        }
        canvas.curves(frame, &pieces, colour, width, dashes);
        if let Mark::Points { shape, points, .. } = mark {
            for place in apart(frame, plane.inside(points)) {
                draw_point(canvas, place, radius(points.len()), *shape, colour);
            }
        }
        if let Mark::Bar { end, .. } = mark
            && let Some(bar) = plane.bar(frame, *end)
        {
            canvas.fill(&bar, colour, 1.0);
        }
    }
}

/// Places on the sheet, without those that would hide another to within half a pixel.
fn apart(frame: &Frame, fractions: Vec<Place>) -> Vec<Place> {
    let mut taken = HashSet::new();
    let places = fractions.into_iter().map(|(x, y)| frame.place(x, y));
    places.filter(|(x, y)| taken.insert(((2.0 * x).round() as i64, (2.0 * y).round() as i64))).collect()
}

/// Radius of each of so many points: crowds keep their density visible.
fn radius(count: usize) -> f64 {
    (POINT.0 * (FEW / count as f64).sqrt()).clamp(POINT.1, POINT.0)
}

/// A point, with a thin white rim unless it is one of a crowd, so that neighbours stay apart.
fn draw_point(canvas: &dyn Canvas, (x, y): Place, radius: f64, shape: Shape, colour: Colour) {
    let rim = if radius > 0.6 * POINT.0 { 0.2 * radius } else { 0.0 };
    let polygon = |grow: f64, colour: Colour| {
        let r = radius + grow;
        let corners: &[Place] = match shape {
            Shape::Square => &[(-0.88, -0.88), (0.88, -0.88), (0.88, 0.88), (-0.88, 0.88)],
            Shape::Triangle => &[(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)],
            _ => &[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
        };
        let corners: Vec<Place> = corners.iter().map(|(dx, dy)| (x + r * dx, y + r * dy)).collect();
        canvas.polygon(&corners, colour, 1.0);
    };
    match shape {
        Shape::Square | Shape::Triangle | Shape::Diamond => {
            polygon(rim, Colour::Paper);
            polygon(0.0, colour);
        }
        Shape::Disc | Shape::Ring => {
            if rim > 0.0 {
                canvas.disc((x, y), radius + rim, Colour::Paper);
            }
            canvas.disc((x, y), radius, colour);
            if shape == Shape::Ring {
                canvas.disc((x, y), 0.6 * radius, Colour::Paper);
            }
        }
        Shape::Cross => {
            for (width, colour) in [(0.8, Colour::Paper), (0.45, colour)] {
                let (r, width) = (0.9 * radius, width * radius);
                canvas.line((x - r, y - r), (x + r, y + r), colour, width);
                canvas.line((x - r, y + r), (x + r, y - r), colour, width);
            }
        }
    }
}

/// What has no place on the vertical axis, and its band beside the frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// Not finite: above the frame.
    Broken,
    /// Exactly zero: under the frame.
    Vanished,
}

impl Beyond {
    /// What the band is called.
    pub fn name(self) -> &'static str {
        match self {
            Self::Broken => "not finite",
            Self::Vanished => "exactly 0",
        }
    }

    /// The points of a mark that belong here: how they look, and their x.
    fn of(self, mark: &Mark) -> Option<(Hue, Shape, &[f64])> {
        match (self, mark) {
            (Self::Broken, Mark::Broken { hue, shape, at }) | (Self::Vanished, Mark::Vanished { hue, shape, at }) => {
                Some((*hue, *shape, at))
            }
            _ => None,
        }
    }

    /// The x of all points that belong here.
    pub fn points(self, marks: &[Mark]) -> impl Iterator<Item = f64> + '_ {
        marks.iter().filter_map(move |mark| self.of(mark)).flat_map(|(.., at)| at).copied()
    }

    /// Draws the points into their band; those at its ends are moved in until they are whole.
    pub fn draw(self, canvas: &dyn Canvas, band: &Frame, plane: &Plane, marks: &[Mark]) {
        for (hue, shape, at) in marks.iter().filter_map(|mark| self.of(mark)) {
            let radius = radius(at.len());
            let inset = WIDEST * radius / band.width().max(1.0);
            let along = at.iter().map(|x| plane.x.fraction(*x)).filter(|along| (0.0..=1.0).contains(along));
            let places = along.map(|along| (along.min(1.0 - inset).max(inset), 0.5)).collect();
            for place in apart(band, places) {
                draw_point(canvas, place, radius, shape, palette::colour(hue));
            }
        }
    }
}

/// How a mark looks in a key, to the right of a place.
pub fn draw_sample(canvas: &dyn Canvas, mark: &Mark, (x, y): Place, length: f64) {
    let (colour, width, dashes) = look(mark);
    if let Mark::Bar { .. } = mark {
        return canvas.fill(&Frame { left: x, right: x + length, top: y - SAMPLE, bottom: y + SAMPLE }, colour, 1.0);
    }
    if !matches!(mark, Mark::Points { joined: false, .. }) {
        canvas.curve(&[(x, y), (x + length, y)], colour, width, dashes);
    }
    if let Mark::Points { shape, .. } = mark {
        draw_point(canvas, (x + length / 2.0, y), POINT.0, *shape, colour);
    }
}

/// The entry of a mark in the key, if it has one.
pub fn entry(mark: &Mark) -> Option<&str> {
    match mark {
        Mark::Line { label, .. } | Mark::Points { label, .. } | Mark::Bar { label, .. } if !label.is_empty() => {
            Some(label)
        }
        _ => None,
    }
}

/// Inks all that the marks cover.
pub fn ink(ink: &mut Ink, frame: &Frame, plane: &Plane, marks: &[Mark]) {
    for mark in marks {
        let Stroke { pieces, look: (_, width, _) } = plane.stroke(mark);
        for piece in pieces {
            let places: Vec<Place> = piece.into_iter().map(|(x, y)| frame.place(x, y)).collect();
            ink.line(places[0], places[0], width);
            places.windows(2).for_each(|pair| ink.line(pair[0], pair[1], width));
        }
        if let Mark::Bar { end, .. } = mark
            && let Some(bar) = plane.bar(frame, *end)
        {
            ink.rectangle(&bar);
        }
        if let Mark::Points { points, .. } = mark {
            for place in apart(frame, plane.inside(points)) {
                ink.line(place, place, 2.5 * radius(points.len()));
            }
        }
    }
}

/// The coordinates that the axes should hold, drawable or not.
pub fn points(marks: &[Mark]) -> impl Iterator<Item = [f64; 2]> + '_ {
    marks
        .iter()
        .flat_map(|mark| match mark {
            Mark::Line { points, .. } | Mark::Points { points, .. } => points.as_slice(),
            Mark::Bar { end, .. } => end.as_slice(),
            Mark::Broken { .. } | Mark::Vanished { .. } | Mark::AtX { .. } | Mark::AtY { .. } => &[],
        })
        .copied()
}

/// A dashed line needs room in the key to show its pattern twice.
pub fn sample_width(marks: &[Mark]) -> f64 {
    let dashed = marks.iter().any(|mark| matches!(mark, Mark::Line { dash: Dash::Dashed, .. }));
    if dashed { 33.0 } else { 26.0 }
}
