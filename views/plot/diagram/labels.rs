//! Where the labels of a diagram stand: of many places tried around what each names, the first that hides nothing.

use super::Sight;
use super::shapes::{self, Shape, along, direction};
use crate::plot::canvas::{Frame, Place};
use crate::plot::palette::Colour;
use crate::plot::{TEXT, text};
use chapters::diagram::{Form, Part, Spot};
use std::f64::consts::TAU;

/// Free space around a label.
const GAP: f64 = 4.0;
/// What it costs to stand where something else is. Nothing is worth leaving the window or hiding another label;
/// wavefronts are many, and a label a little further off would be worse than one among them.
const OUTSIDE: f64 = 1e6;
const ON_LABEL: f64 = 1e4;
const ON_RAY: f64 = 200.0;
const ON_LINE: f64 = 50.0;
const ON_WAVEFRONT: f64 = 4.0;
/// What a pixel of distance costs, beyond the places right beside.
const AWAY: f64 = 0.1;
/// What the next best place right beside costs.
const NEXT: f64 = 1e-3;
/// Distances that are tried where there is no room right beside: first, last, step.
const SEARCH: (usize, usize, usize) = (16, 184, 8);
/// Directions tried at each.
const DIRECTIONS: usize = 24;
/// A label further from what it names than this has a line that leads there.
const NEAR: f64 = 22.0;

/// A label in its place.
#[derive(Clone, Debug)]
pub struct Placed<'a> {
    /// In the label markup.
    pub label: &'a str,
    /// Its colour.
    pub colour: Colour,
    /// What it covers.
    pub place: Frame,
    /// The line that leads to what it names, if it needs one.
    pub leader: Option<(Place, Place)>,
}

/// Places the labels of parts whose shapes are given. Those that have the least choice go first.
pub fn place<'a>(sight: &Sight, parts: &'a [Part], forms: &[Vec<Shape>]) -> Vec<Placed<'a>> {
    let obstacles: Vec<Obstacle> = parts.iter().zip(forms).flat_map(|(part, shapes)| obstacles(part, shapes)).collect();
    let is_seen = |part: &Part, shapes: &[Shape]| matches!(part.form, Form::Note { .. }) || !shapes.is_empty();
    let mut named: Vec<&Part> = parts
        .iter()
        .zip(forms)
        .filter(|(part, shapes)| !part.label.is_empty() && is_seen(part, shapes))
        .map(|(part, _)| part)
        .collect();
    named.sort_by_key(|part| turn(&part.form));
    let mut placed: Vec<Placed> = Vec::new();
    for part in named {
        if let Some(found) = best(sight, part, &obstacles, &placed) {
            placed.push(found);
        }
    }
    placed
}

/// Who goes first.
fn turn(form: &Form) -> u8 {
    match form {
        Form::Across { .. } | Form::Point { .. } => 0,
        Form::Arc { .. } => 1,
        Form::Vector { .. } => 2,
        Form::Ray { .. } | Form::Curve { .. } => 3,
        Form::Line { .. } | Form::Wavefronts { .. } | Form::Surface { .. } => 4,
        Form::Note { .. } => 5,
    }
}

/// A straight line that a label should not hide.
struct Obstacle {
    from: Place,
    to: Place,
    half: f64,
    cost: f64,
}

fn obstacles(part: &Part, shapes: &[Shape]) -> Vec<Obstacle> {
    let cost = match part.form {
        Form::Ray { .. } | Form::Vector { .. } | Form::Across { .. } | Form::Curve { .. } => ON_RAY,
        Form::Wavefronts { .. } => ON_WAVEFRONT,
        _ => ON_LINE,
    };
    let edges = shapes.iter().flat_map(Shape::edges);
    edges.map(|(from, to, half)| Obstacle { from, to, half, cost }).collect()
}

/// The best place of a label; none if the part has no place at all.
fn best<'a>(sight: &Sight, part: &'a Part, obstacles: &[Obstacle], placed: &[Placed]) -> Option<Placed<'a>> {
    let size = (text::width(&part.label, TEXT), (text::CAPITAL + text::DESCENT) * TEXT);
    let (anchor, beside) = beside(sight, &part.form, (size.0 / 2.0, size.1 / 2.0))?;
    let beside = beside.into_iter().enumerate().map(|(k, centre)| (centre, NEXT * k as f64));
    let rings = (SEARCH.0..=SEARCH.1).step_by(SEARCH.2).flat_map(|radius| {
        (0..DIRECTIONS).map(move |k| {
            let (sin, cos) = (TAU * k as f64 / DIRECTIONS as f64).sin_cos();
            let (radius, reach) = (radius as f64, AWAY * radius as f64);
            ((anchor.0 + radius * cos, anchor.1 + radius * sin), 1.0 + reach)
        })
    });
    let mut best: Option<(f64, Frame)> = None;
    for (centre, cost) in beside.chain(rings) {
        let place = Frame::at((centre.0 - size.0 / 2.0, centre.1 - size.1 / 2.0), size.0, size.1);
        let cost = cost + cost_of(&place, sight, obstacles, placed);
        if cost.is_finite() && best.is_none_or(|(least, _)| cost < least) {
            best = Some((cost, place));
        }
        // What costs less than any place further off cannot be bettered.
        if best.is_some_and(|(least, _)| least < 1.0) {
            break;
        }
    }
    let (_, place) = best?;
    let leader = leader(&part.form, anchor, &place);
    Some(Placed { label: &part.label, colour: shapes::colour(part.hue), place, leader })
}

fn cost_of(place: &Frame, sight: &Sight, obstacles: &[Obstacle], placed: &[Placed]) -> f64 {
    let room = &sight.frame;
    let is_inside =
        room.left <= place.left && place.right <= room.right && room.top <= place.top && place.bottom <= room.bottom;
    let outside = if is_inside { 0.0 } else { OUTSIDE };
    let clear = place.grown(GAP / 2.0);
    let on_labels = placed.iter().filter(|other| clear.meets(&other.place)).count() as f64 * ON_LABEL;
    let hidden = obstacles.iter().filter(|obstacle| crosses(&place.grown(obstacle.half + 1.0), obstacle));
    outside + on_labels + hidden.map(|obstacle| obstacle.cost).sum::<f64>()
}

/// Whether a line runs through a rectangle.
fn crosses(frame: &Frame, Obstacle { from, to, .. }: &Obstacle) -> bool {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    let rooms = [
        (-dx, from.0 - frame.left),
        (dx, frame.right - from.0),
        (-dy, from.1 - frame.top),
        (dy, frame.bottom - from.1),
    ];
    for (slope, room) in rooms {
        if slope == 0.0 {
            if room < 0.0 {
                return false;
            }
        } else if slope < 0.0 {
            enter = enter.max(room / slope);
        } else {
            leave = leave.min(room / slope);
        }
    }
    enter <= leave
}

/// The line from a label to what it names, if that is not right beside.
fn leader(form: &Form, anchor: Place, place: &Frame) -> Option<(Place, Place)> {
    if !matches!(form, Form::Arc { .. } | Form::Point { .. } | Form::Across { .. } | Form::Vector { .. }) {
        return None;
    }
    let near = place.grown(1.0);
    let end = (anchor.0.clamp(near.left, near.right), anchor.1.clamp(near.top, near.bottom));
    ((end.0 - anchor.0).hypot(end.1 - anchor.1) > NEAR).then_some((anchor, end))
}

/// What a label belongs to, and the middles of the places right beside it, the best first. `half` is half its width
/// and half its height.
fn beside(sight: &Sight, form: &Form, half: (f64, f64)) -> Option<(Place, Vec<Place>)> {
    let found = match form {
        Form::Line { from, to } | Form::Ray { from, to, .. } | Form::Surface { from, to, .. } => {
            beside_line(sight, *from, *to, 0.0, half)?
        }
        Form::Wavefronts { from, to, sides, .. } => {
            beside_line(sight, *from, *to, sides[0].max(sides[1]) * sight.scale, half)?
        }
        Form::Vector { from, to } => {
            let (way, _) = direction(*from, *to)?;
            let (tip, ahead) = (sight.place(*to), (way[0], -way[1]));
            let turns =
                [0.0, 40.0, -40.0, 75.0, -75.0, 110.0, -110.0].map(|turn: f64| turned(ahead, turn.to_radians()));
            (tip, turns.map(|ahead| off(tip, ahead, half, GAP)).to_vec())
        }
        Form::Arc { centre, radius, from, to } => beside_arc(sight, (*centre, *radius), (*from, *to), half),
        Form::Point { at } => around(sight.place(*at), half, GAP + 4.0),
        Form::Across { at, .. } => around(sight.place(*at), half, GAP + 8.0),
        Form::Curve { points } => {
            let seen = sight.lines(points).into_iter().max_by_key(Vec::len)?;
            let places = [0.9, 0.7, 0.5, 0.3, 0.1].map(|share| seen[(share * (seen.len() - 1) as f64) as usize]);
            (places[0], places.into_iter().flat_map(|place| around(place, half, GAP + 3.0).1).collect())
        }
        Form::Note { at } => {
            let (left, middle) = sight.place(*at);
            ((left + half.0, middle), vec![(left + half.0, middle)])
        }
    };
    (found.0.0.is_finite() && found.0.1.is_finite()).then_some(found)
}

/// Along a line on both sides of it, from its outer end inwards: in the middle of a diagram there is most to hide.
fn beside_line(sight: &Sight, from: Spot, to: Spot, aside: f64, half: (f64, f64)) -> Option<(Place, Vec<Place>)> {
    let (way, length) = direction(from, to)?;
    let middle = sight.frame.place(0.5, 0.5);
    let shares = (0..=24).map(|k| 0.02 + 0.04 * f64::from(k));
    let mut places: Vec<Place> = shares.map(|share| sight.place(along(from, way, share * length))).collect();
    places.retain(|place| sight.shows(*place));
    let out = |place: &Place| (place.0 - middle.0).hypot(place.1 - middle.1);
    places.sort_by(|a, b| out(b).total_cmp(&out(a)));
    let anchor = *places.first()?;
    // Above the line first.
    let over = if way[0] < 0.0 { (way[1], way[0]) } else { (-way[1], -way[0]) };
    let sides = [over, (-over.0, -over.1)];
    // Beside a head there is room a little further off.
    let gaps = [GAP + 1.0 + aside, GAP + 6.0 + aside];
    let around = |place| gaps.into_iter().flat_map(move |gap| sides.map(|side| off(place, side, half, gap)));
    Some((anchor, places.into_iter().flat_map(around).collect()))
}

/// Outside an arc from its middle to its ends, then inside, then further out.
fn beside_arc(
    sight: &Sight,
    (centre, radius): (Spot, f64),
    (from, to): (f64, f64),
    half: (f64, f64),
) -> (Place, Vec<Place>) {
    let at = |share: f64, way: f64| {
        let (sin, cos) = (from + share * (to - from)).sin_cos();
        (sight.place(along(centre, [cos, sin], way)), (cos, -sin))
    };
    let shares = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9];
    let outside = |more: f64| {
        shares.map(|share| {
            let (place, out) = at(share, radius);
            off(place, out, half, GAP + more)
        })
    };
    let inside = shares.map(|share| {
        let (place, out) = at(share, radius);
        off(place, (-out.0, -out.1), half, GAP)
    });
    let places = outside(0.0).into_iter().chain(inside).chain(outside(6.0)).chain(outside(12.0)).chain(outside(18.0));
    (at(0.5, radius).0, places.collect())
}

/// Around a place, the upper right first.
fn around(place: Place, half: (f64, f64), gap: f64) -> (Place, Vec<Place>) {
    let eighths = [1.0, 3.0, 0.0, 4.0, 2.0, 7.0, 5.0, 6.0].map(|k: f64| (k * TAU / 8.0).sin_cos());
    (place, eighths.map(|(sin, cos)| off(place, (cos, -sin), half, gap)).to_vec())
}

/// The middle of a label that stands off a place in a direction, just so far that its box is `gap` away.
fn off((x, y): Place, (dx, dy): (f64, f64), half: (f64, f64), gap: f64) -> Place {
    let reach = dx.abs() * half.0 + dy.abs() * half.1 + gap;
    (x + dx * reach, y + dy * reach)
}

fn turned((x, y): (f64, f64), by: f64) -> (f64, f64) {
    let (sin, cos) = by.sin_cos();
    (x * cos - y * sin, x * sin + y * cos)
}
