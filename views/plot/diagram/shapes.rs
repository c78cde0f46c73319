//! The parts of a diagram as strokes and fills on the sheet.

use super::Sight;
use crate::plot::canvas::{Canvas, Place};
use crate::plot::palette::{self, Colour};
use chapters::diagram::{Behind, Form, Part, Spot};
use chapters::figure::{Dash, Hue};

/// Width of a ray.
const RAY: f64 = 2.4;
/// Width of a vector, and of the signs for one across the plane.
const VECTOR: f64 = 2.0;
/// Width of a surface.
const SURFACE: f64 = 1.8;
/// Width of all else.
const THIN: f64 = 1.3;
/// Length of an arrow head and half its width.
const HEAD: (f64, f64) = (13.0, 5.0);
/// Share of its length at which a head is notched.
const NOTCH: f64 = 0.75;
/// Radius of ⊙ and ⊗, of the dot in the first, and of a point.
const RING: f64 = 7.0;
const DOT: f64 = 2.2;
const POINT: f64 = 3.8;
/// Length of the strokes behind a surface that lets no light through, and the distance between them.
const HATCH: (f64, f64) = (9.0, 9.0);
/// How much the densest medium covers of the paper.
const DENSEST: f64 = 0.34;
/// Wavefronts closer than this are a grey area, and are left out.
const CLOSEST: f64 = 3.0;
/// An angle smaller than this [rad] is none: half a degree.
const SMALLEST: f64 = 0.0087;
/// A corner of an arc or a ring every so many radians.
const CORNER: f64 = 0.05;

/// Something on the sheet.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A line.
    Stroke {
        /// Through these.
        places: Vec<Place>,
        /// Its colour.
        colour: Colour,
        /// Its width.
        width: f64,
        /// Lengths of strokes and gaps.
        dashes: &'static [f32],
    },
    /// An area.
    Fill {
        /// Its corners.
        corners: Vec<Place>,
        /// Its colour.
        colour: Colour,
        /// How much it covers.
        alpha: f64,
    },
    /// A filled disc.
    Disc {
        /// Its middle.
        centre: Place,
        /// Its radius.
        radius: f64,
        /// Its colour.
        colour: Colour,
    },
}

impl Shape {
    /// Draws it.
    pub fn draw(&self, canvas: &dyn Canvas) {
        match self {
            Self::Stroke { places, colour, width, dashes } => canvas.curve(places, *colour, *width, dashes),
            Self::Fill { corners, colour, alpha } => canvas.polygon(corners, *colour, *alpha),
            Self::Disc { centre, radius, colour } => canvas.disc(*centre, *radius, *colour),
        }
    }

    /// What labels must keep clear of: straight lines and half their width. The ground is not among it.
    pub fn edges(&self) -> Vec<(Place, Place, f64)> {
        match self {
            Self::Stroke { places, width, .. } => {
                places.windows(2).map(|pair| (pair[0], pair[1], width / 2.0)).collect()
            }
            Self::Fill { alpha, .. } if *alpha < 1.0 => Vec::new(),
            Self::Fill { corners, .. } => {
                let ends = corners.iter().skip(1).chain(corners.first());
                corners.iter().zip(ends).map(|(from, to)| (*from, *to, 0.5)).collect()
            }
            Self::Disc { centre, radius, .. } => vec![(*centre, *centre, *radius)],
        }
    }
}

/// The shapes of a part; none if nothing of it can be seen.
pub fn of(sight: &Sight, part: &Part) -> Vec<Shape> {
    let pen = Pen { sight, colour: colour(part.hue), dashes: palette::dashes(part.dash) };
    match &part.form {
        Form::Line { from, to } => pen.stroke(&[*from, *to], THIN),
        Form::Ray { from, to, heads } => pen.arrow(*from, *to, RAY, heads),
        Form::Vector { from, to } => pen.arrow(*from, *to, VECTOR, &[1.0]),
        Form::Wavefronts { from, to, first, spacing, sides } => pen.wavefronts(*from, *to, (*first, *spacing), *sides),
        Form::Surface { from, to, behind } => pen.surface(*from, *to, *behind),
        Form::Arc { centre, radius, from, to } => pen.arc(*centre, *radius, *from, *to),
        Form::Point { at } => pen.point(*at),
        Form::Across { at, is_out } => pen.across(*at, *is_out),
        Form::Curve { points } => pen.stroke(points, RAY),
        Form::Note { .. } => Vec::new(),
    }
}

/// The colour of a part and of its label: black is that of text.
pub fn colour(hue: Hue) -> Colour {
    if hue == Hue::Natural { Colour::Ink } else { palette::colour(hue) }
}

/// From a spot some way along a direction.
pub fn along([x, y]: Spot, [dx, dy]: Spot, way: f64) -> Spot {
    [x + way * dx, y + way * dy]
}

/// The unit direction from one spot to another and their distance; none if they are one.
pub fn direction([x, y]: Spot, [x_to, y_to]: Spot) -> Option<(Spot, f64)> {
    let length = (x_to - x).hypot(y_to - y);
    (length > 0.0 && length.is_finite()).then(|| ([(x_to - x) / length, (y_to - y) / length], length))
}

/// A quarter turn to the left.
pub fn left([x, y]: Spot) -> Spot {
    [-y, x]
}

struct Pen<'a> {
    sight: &'a Sight,
    colour: Colour,
    dashes: &'static [f32],
}

impl Pen<'_> {
    fn line(&self, places: Vec<Place>, width: f64) -> Shape {
        Shape::Stroke { places, colour: self.colour, width, dashes: self.dashes }
    }

    fn stroke(&self, spots: &[Spot], width: f64) -> Vec<Shape> {
        self.sight.lines(spots).into_iter().map(|places| self.line(places, width)).collect()
    }

    fn arrow(&self, from: Spot, to: Spot, width: f64, heads: &[f64]) -> Vec<Shape> {
        let Some((way, length)) = direction(from, to) else { return Vec::new() };
        // The line ends within the head at its end, which would otherwise be blunt; a short arrow has a short head.
        let longest = 0.6 * length * self.sight.scale;
        let (head, half) = (HEAD.0.min(longest), HEAD.1.min(longest * HEAD.1 / HEAD.0));
        let is_pointed = heads.contains(&1.0);
        let end = if is_pointed { along(to, way, -NOTCH * head / self.sight.scale) } else { to };
        let mut shapes = self.stroke(&[from, end], width);
        for share in heads {
            let (tip_x, tip_y) = self.sight.place(along(from, way, share * length));
            if self.sight.shows((tip_x, tip_y)) {
                let corner = |back: f64, aside: f64| {
                    (tip_x - back * way[0] - aside * way[1], tip_y + back * way[1] - aside * way[0])
                };
                let corners = vec![(tip_x, tip_y), corner(head, half), corner(NOTCH * head, 0.0), corner(head, -half)];
                shapes.push(Shape::Fill { corners, colour: self.colour, alpha: 1.0 });
            }
        }
        shapes
    }

    fn wavefronts(
        &self,
        from: Spot,
        to: Spot,
        (first, spacing): (f64, f64),
        [to_left, to_right]: [f64; 2],
    ) -> Vec<Shape> {
        let Some((way, length)) = direction(from, to) else { return Vec::new() };
        if !(spacing * self.sight.scale >= CLOSEST && first.is_finite()) {
            return Vec::new();
        }
        let count = ((length - first) / spacing + 1e-9).floor();
        let middles =
            (0..=count as usize).filter(|_| count >= 0.0).map(|k| along(from, way, first + k as f64 * spacing));
        let ends = middles.map(|middle| [to_left, -to_right].map(|aside| along(middle, left(way), aside)));
        ends.flat_map(|ends| self.stroke(&ends, THIN)).collect()
    }

    fn surface(&self, from: Spot, to: Spot, behind: Behind) -> Vec<Shape> {
        let Some((way, length)) = direction(from, to) else { return Vec::new() };
        let mut shapes = match behind {
            Behind::Nothing => Vec::new(),
            Behind::Tinted(depth) => self.half_plane(from, way, depth),
            Behind::Hatched => {
                let [stroke, pitch] = [HATCH.0, HATCH.1].map(|pixels| pixels / self.sight.scale);
                let count = (length / pitch).min(1e4) as usize;
                let starts = (0..count).map(|k| along(from, way, (k as f64 + 0.8) * pitch));
                let hatch = Pen { colour: Colour::Aid, dashes: &[], ..*self };
                let ends =
                    starts.map(|start| [start, along(along(start, way, -0.7 * stroke), left(way), -0.7 * stroke)]);
                ends.flat_map(|ends| hatch.stroke(&ends, 1.0)).collect()
            }
        };
        shapes.extend(self.stroke(&[from, to], SURFACE));
        shapes
    }

    /// The part of the window to the right of a line (I. E. Sutherland and G. W. Hodgman, CACM 17, 1974).
    fn half_plane(&self, from: Spot, way: Spot, depth: f64) -> Vec<Shape> {
        let frame = &self.sight.frame;
        let (x, y) = self.sight.place(from);
        // Distance to the right of the line on the sheet, where y runs down.
        let right = |(at_x, at_y): Place| (at_x - x) * way[1] + (at_y - y) * way[0];
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| frame.place(x, y));
        let mut kept = Vec::new();
        for (k, &corner) in corners.iter().enumerate() {
            let next = corners[(k + 1) % corners.len()];
            let (here, there) = (right(corner), right(next));
            if here >= 0.0 {
                kept.push(corner);
            }
            if (here < 0.0) != (there < 0.0) {
                let share = here / (here - there);
                kept.push((corner.0 + share * (next.0 - corner.0), corner.1 + share * (next.1 - corner.1)));
            }
        }
        let alpha = DENSEST * depth.clamp(0.0, 1.0);
        let is_there = kept.len() > 2 && alpha > 0.0;
        let ground = Shape::Fill { corners: kept, colour: Colour::Transmitted, alpha };
        is_there.then_some(ground).into_iter().collect()
    }

    fn arc(&self, centre: Spot, radius: f64, from: f64, to: f64) -> Vec<Shape> {
        let sweep = to - from;
        if !(sweep.abs() >= SMALLEST && sweep.abs() < 100.0) {
            return Vec::new();
        }
        let count = (sweep.abs() / CORNER).ceil().max(1.0) as usize;
        let angles = (0..=count).map(|k| from + sweep * k as f64 / count as f64);
        let spots: Vec<Spot> = angles.map(|angle| along(centre, [angle.cos(), angle.sin()], radius)).collect();
        self.stroke(&spots, THIN)
    }

    fn point(&self, at: Spot) -> Vec<Shape> {
        let centre = self.sight.place(at);
        let seen = self.sight.shows(centre).then_some(Shape::Disc { centre, radius: POINT, colour: self.colour });
        seen.into_iter().collect()
    }

    /// The tip of an arrow seen from the front, or its feathers from behind.
    fn across(&self, at: Spot, is_out: bool) -> Vec<Shape> {
        let centre = self.sight.place(at);
        if !self.sight.shows(centre) {
            return Vec::new();
        }
        let around = |angle: f64| (centre.0 + RING * angle.cos(), centre.1 + RING * angle.sin());
        let count = (std::f64::consts::TAU / (3.0 * CORNER)).ceil();
        let ring = (0..=count as usize).map(|k| around(std::f64::consts::TAU * k as f64 / count)).collect();
        let pen = Pen { dashes: palette::dashes(Dash::Solid), ..*self };
        let mut shapes =
            vec![Shape::Disc { centre, radius: RING, colour: Colour::Paper }, pen.line(ring, 0.8 * VECTOR)];
        if is_out {
            shapes.push(Shape::Disc { centre, radius: DOT, colour: self.colour });
        } else {
            let eighth = std::f64::consts::FRAC_PI_4;
            let stroke = |k: f64| pen.line(vec![around(k * eighth), around((k + 4.0) * eighth)], 0.8 * VECTOR);
            shapes.extend([stroke(1.0), stroke(3.0)]);
        }
        shapes
    }
}
