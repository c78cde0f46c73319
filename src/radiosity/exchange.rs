//! What two patches exchange: A F = ∫∫ cos θ cos θ′/(π r²) dA dA′ [m²], the same both ways, if nothing is between them.

use super::{Outline, Patch, contour};
use crate::radiometry::polygon;
use crate::scene::Triple;
use crate::scene::triple::{dot, length, minus, normalised};
use std::f64::consts::{PI, TAU};

/// Patches so many of their sizes apart are summed by Gauss's rule, 4 points each way, whose error is about (1/2d)⁸ ~ 10⁻¹¹;
/// of the closed form's sixteen terms d⁴ ulp would be left, which is as much.
const FAR: f64 = 12.0;

/// By what route it was found what two patches exchange.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// One is behind the other.
    Behind,
    /// Sixteen terms, of rectangles along the same axes.
    Closed,
    /// Gauss's rule over both, which are far from each other.
    Points,
    /// Around both ([`contour`]).
    Contour,
}

/// What `one` and `other` exchange [m²]: by closed forms if they are rectangles, parallel to each other or at a right angle
/// with sides along each other's, and not far apart; by Gauss's rule if they are far; else around both, wherever they are.
pub fn exchange(one: &Patch, other: &Patch) -> f64 {
    by_route(one, other).0
}

/// The same, and how it was found.
pub fn by_route(one: &Patch, other: &Patch) -> (f64, Route) {
    let apart = length(minus(one.middle(), other.middle()));
    let is_far = apart > FAR * one.size().max(other.size());
    let whole = |seen: &Patch, from: &Patch| seen.corners().iter().all(|corner| from.before(*corner) >= 0.0);
    if is_far && whole(one, other) && whole(other, one) {
        return (by_points(one, other), Route::Points);
    }
    let is_hidden = |seen: &Patch, from: &Patch| seen.corners().iter().all(|corner| from.before(*corner) <= 0.0);
    if is_hidden(one, other) || is_hidden(other, one) {
        return (0.0, Route::Behind);
    }
    if [one, other].iter().all(|patch| patch.outline == Outline::Parallelogram) {
        let frame = [one.edges[0], one.edges[1], one.normal()].map(normalised);
        if let (Some(one), Some(other)) = (aligned(one, &frame), aligned(other, &frame)) {
            return (between_boxes(&one, &other), Route::Closed);
        }
    }
    (around(one, other), Route::Contour)
}

/// Around both, whatever they are and wherever.
pub fn around(one: &Patch, other: &Patch) -> f64 {
    let [here, there] = [one, other].map(Patch::corners);
    contour::exchange((&here, one.normal()), (&there, other.normal()))
}

/// A rectangle along the axes of a frame: intervals, of which that along the normal is a point.
struct Span {
    /// From where to where along each axis [m].
    along: [[f64; 2]; 3],
    /// The normal's axis.
    axis: usize,
    /// Whether the normal points along it, not against it.
    is_up: bool,
}

/// Roundings by which an edge may be off an axis, in its own length [1].
const SLACK: f64 = 16.0 * f64::EPSILON;

/// The patch as a span, if its edges are along the axes of the frame.
fn aligned(patch: &Patch, frame: &[Triple; 3]) -> Option<Span> {
    let seen = |v: Triple| -> Triple { frame.map(|axis| dot(axis, v)) };
    let axis_of = |edge: Triple| {
        let (parts, most) = (seen(edge), SLACK * length(edge));
        let mut along = (0..3).filter(|axis| parts[*axis].abs() > most);
        along.next().filter(|_| along.next().is_none())
    };
    let [first, second] = [axis_of(patch.edges[0])?, axis_of(patch.edges[1])?];
    if first == second {
        return None;
    }
    let (start, axis) = (seen(patch.corner), 3 - first - second);
    let mut along = start.map(|x| [x, x]);
    for (edge, at) in patch.edges.iter().zip([first, second]) {
        let end = start[at] + dot(frame[at], *edge);
        along[at] = [start[at].min(end), start[at].max(end)];
    }
    Some(Span { along, axis, is_up: dot(frame[axis], patch.normal()) > 0.0 })
}

/// The part of an interval before a plane at `plane`, as distances from it; None if there is none.
fn before([from, to]: [f64; 2], plane: f64, is_up: bool) -> Option<[f64; 2]> {
    let [near, far] = if is_up { [from - plane, to - plane] } else { [plane - to, plane - from] };
    (far > 0.0).then(|| [near.max(0.0), far])
}

fn between_boxes(one: &Span, other: &Span) -> f64 {
    let plane = |span: &Span| span.along[span.axis][0];
    if one.axis == other.axis {
        let apart = if one.is_up { plane(other) - plane(one) } else { plane(one) - plane(other) };
        if apart <= 0.0 || one.is_up == other.is_up {
            return 0.0;
        }
        let [a, b] = [(one.axis + 1) % 3, (one.axis + 2) % 3];
        return parallel([one.along[a], one.along[b]], [other.along[a], other.along[b]], apart);
    }
    // What of each is before the other.
    let (Some(x), Some(z)) = (
        before(one.along[other.axis], plane(other), other.is_up),
        before(other.along[one.axis], plane(one), one.is_up),
    ) else {
        return 0.0;
    };
    let third = 3 - one.axis - other.axis;
    perpendicular(x, z, one.along[third], other.along[third])
}

/// Of rectangles in planes `apart` [m], by their intervals along both axes (J. R. Howell, *A Catalog of Radiation Heat Transfer
/// Configuration Factors*, C-13).
pub fn parallel(one: [[f64; 2]; 2], other: [[f64; 2]; 2], apart: f64) -> f64 {
    let [u, v] = [0, 1].map(|axis| differences(one[axis], other[axis]));
    let unit = u.iter().chain(&v).fold(apart, |most, (x, _)| most.max(x.abs()));
    let z = apart / unit;
    let term = |x: f64, y: f64| {
        let (s, t) = (x.hypot(z), y.hypot(z));
        y * s * (y / s).atan() + x * t * (x / t).atan() - 0.5 * z * z * (s * s + y * y).ln()
    };
    let sum: f64 = u.iter().flat_map(|(x, a)| v.iter().map(move |(y, b)| a * b * term(x / unit, y / unit))).sum();
    at_least_none(unit * unit / TAU * sum)
}

/// Of a rectangle over the intervals `x` and `y` and one over `z` and `eta` [m], in planes at a right angle that meet in the
/// line x = z = 0, along which run y and η (Howell C-15; E. U. Schmidt's kernel, integrated).
pub fn perpendicular(x: [f64; 2], z: [f64; 2], y: [f64; 2], eta: [f64; 2]) -> f64 {
    let along = differences(y, eta);
    let unit = along.iter().map(|(d, _)| d.abs()).chain([x[1], z[1]]).fold(0.0, f64::max);
    let term = |x: f64, z: f64, d: f64| {
        let (across, d2) = (x.hypot(z), d * d);
        let square = across * across;
        let turned = if across > 0.0 { d * across * (d / across).atan() } else { 0.0 };
        let whole = square + d2;
        turned - if whole > 0.0 { 0.25 * (square - d2) * whole.ln() } else { 0.0 }
    };
    let mut sum = 0.0;
    for (i, x) in x.into_iter().enumerate() {
        for (k, z) in z.into_iter().enumerate() {
            let sign = if i == k { 1.0 } else { -1.0 };
            sum += sign * along.iter().map(|(d, s)| s * term(x / unit, z / unit, d / unit)).sum::<f64>();
        }
    }
    at_least_none(unit * unit / TAU * sum)
}

/// The four differences of two intervals' ends, and the signs with which a double integral counts them.
fn differences(one: [f64; 2], other: [f64; 2]) -> [(f64, f64); 4] {
    [(one[1] - other[1], 1.0), (one[0] - other[0], 1.0), (one[1] - other[0], -1.0), (one[0] - other[1], -1.0)]
}

/// Nodes and weights of Gauss's rule of four points on 0 … 1.
const NODES: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// By Gauss's rule over both, each wholly before the other.
fn by_points(one: &Patch, other: &Patch) -> f64 {
    let [n, m] = [one.normal(), other.normal()];
    let places = |patch: &Patch| -> [(Triple, f64); 16] {
        std::array::from_fn(|at| {
            let ((u, a), (v, b)) = (NODES[at / 4], NODES[at % 4]);
            match patch.outline {
                Outline::Parallelogram => (patch.at([u, v]), a * b),
                // The square drawn together at one of its sides.
                Outline::Triangle => (patch.at([u, v * (1.0 - u)]), a * b * 2.0 * (1.0 - u)),
            }
        })
    };
    let (here, there) = (places(one), places(other));
    let mut sum = 0.0;
    for (from, a) in &here {
        for (to, b) in &there {
            let way = minus(*to, *from);
            let square = dot(way, way);
            sum += a * b * dot(n, way) * -dot(m, way) / (square * square);
        }
    }
    at_least_none(one.area() * other.area() / PI * sum)
}

/// Of any two patches: what arrives at a point of `one` from `other` by Lambert's sum over its rim, and that by the middles of
/// `n` × `n` pieces of `one`. The error falls as 1/n², of patches that share an edge at a right angle too, and at a slant slower.
pub fn by_rim(one: &Patch, other: &Patch, n: usize) -> f64 {
    let (normal, corners) = (one.normal(), other.corners());
    // A triangle's last corner is there twice, and an edge of no length has no direction.
    let corners = if other.outline == Outline::Triangle { &corners[..3] } else { &corners };
    // From behind nothing is seen.
    if corners.iter().all(|corner| one.before(*corner) <= 0.0) {
        return 0.0;
    }
    // Nothing to cut at the horizon, or something.
    let is_whole = corners.iter().all(|corner| one.before(*corner) >= 0.0);
    let places = (0..n * n).map(|k| one.piece([n; 2], k).middle());
    let seen = places.filter(|place| other.before(*place) > 0.0).map(|place| {
        let from_here: Vec<Triple> = corners.iter().map(|corner| minus(*corner, place)).collect();
        if is_whole {
            polygon::edges(&from_here).into_iter().map(|edge| dot(edge, normal)).sum::<f64>().abs()
        } else {
            polygon::irradiance(&from_here, normal).unwrap_or(f64::NAN)
        }
    });
    one.area() / PI * seen.sum::<f64>() / (n * n) as f64
}

/// Of any two patches by n⁴ pairs of points, the middles of n × n pieces of each: of those that see each other, and of all
/// [m²]. What is behind counts nothing. Near each other they are far from the truth, but their quotient is not.
pub fn by_middles(one: &Patch, other: &Patch, n: usize, sees: impl Fn(Triple, Triple) -> bool) -> [f64; 2] {
    let places = |patch: &Patch| -> Vec<Triple> { (0..n * n).map(|k| patch.piece([n; 2], k).middle()).collect() };
    let (here, there) = (places(one), places(other));
    let ([a, b], share) = ([one.normal(), other.normal()], one.area() * other.area() / (PI * (n as f64).powi(4)));
    let [mut seen, mut all] = [0.0; 2];
    for from in &here {
        for to in &there {
            let way = minus(*to, *from);
            let (cos, other, square) = (dot(a, way), -dot(b, way), dot(way, way));
            if cos > 0.0 && other > 0.0 {
                let adds = share * cos * other / (square * square);
                all += adds;
                seen += if sees(*from, *to) { adds } else { 0.0 };
            }
        }
    }
    [seen, all]
}

/// 0 of what rounding has made less; what is no number stays none, which `max` would hide.
pub(super) fn at_least_none(exchanged: f64) -> f64 {
    if exchanged < 0.0 { 0.0 } else { exchanged }
}
