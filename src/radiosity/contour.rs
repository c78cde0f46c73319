//! What two polygons exchange, by an integral around both: Stokes's theorem, used twice, makes of A F = ∫∫ cos θ cos θ′/(π r²) dA dA′
//! the sum 2π A F = ∮∮ ln r ds·ds′ (E. M. Sparrow, *A new and simpler formulation for radiative angle factors*, J. Heat Transfer 85
//! (1963) 81). No r stands in a denominator, so that polygons may touch, at an edge or a corner, at any slant.
//!
//! Of two straight edges one integral is done on paper. The other has a closed form too, of dilogarithms of complex numbers
//! (P. Schröder and P. Hanrahan, *On the form factor between two polygons*, SIGGRAPH '93, 163); here it is summed by Gauss's
//! rule, over pieces that grow away from the three places where it is singular: they are known, and the error is a rounding.

use super::exchange::at_least_none;
use crate::scene::Triple;
use crate::scene::triple::{cross, dot, largest, length, minus, plus, times};
use std::f64::consts::TAU;
use std::sync::LazyLock;
use yardstick::quadrature::gauss_legendre;

/// Roundings of the largest coordinate by which a corner in a plane may seem to be off it [1].
const SLACK: f64 = 32.0 * f64::EPSILON;

/// What two flat polygons exchange [m²], each convex, its corners counterclockwise about its normal, which is of length 1. Of
/// each only what is before the other's plane counts. Rounding leaves some 10⁻¹⁵ of the square of the longer edge.
pub fn exchange(one: (&[Triple], Triple), other: (&[Triple], Triple)) -> f64 {
    let reach = one.0.iter().chain(other.0).copied().map(largest).fold(0.0, f64::max);
    let slack = SLACK * reach;
    let (Some(here), Some(there)) = (before(one.0, other, slack), before(other.0, one, slack)) else { return 0.0 };
    let edges = |corners: &[Triple]| -> Vec<Edge> {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).filter_map(|(from, to)| Edge::new(*from, *to, slack)).collect()
    };
    let (here, there) = (edges(&here), edges(&there));
    // In a unit in which logarithms are small: its own logarithm goes around, and nothing of it is left.
    let unit = here.iter().chain(&there).map(|edge| edge.length).fold(0.0, f64::max);
    let terms = here.iter().flat_map(|a| there.iter().map(move |b| a.along(b, unit)));
    at_least_none(terms.sum::<f64>() / TAU)
}

/// What of a convex polygon is before a plane, given by another polygon's corner and normal, by more than rounding.
fn before(corners: &[Triple], (plane, normal): (&[Triple], Triple), slack: f64) -> Option<Vec<Triple>> {
    let height = |corner: &Triple| dot(normal, minus(*corner, plane[0]));
    let heights: Vec<f64> = corners.iter().map(height).collect();
    if heights.iter().all(|height| *height <= slack) {
        return None;
    }
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for at in 0..corners.len() {
        let next = (at + 1) % corners.len();
        let (here, there) = (heights[at], heights[next]);
        if here >= 0.0 {
            kept.push(corners[at]);
        }
        if (here >= 0.0) != (there >= 0.0) {
            kept.push(plus(corners[at], times(minus(corners[next], corners[at]), here / (here - there))));
        }
    }
    Some(kept)
}

/// From a corner along a direction of length 1, so far.
struct Edge {
    from: Triple,
    way: Triple,
    length: f64,
}

/// Sines of the angle of two edges [1] that are taken for parallel: ln r is off by the sine over r, which can be integrated.
const PARALLEL: f64 = 1e-9;

/// Cosines [1] of edges that are square to each other, and add nothing.
const SQUARE: f64 = 4.0 * f64::EPSILON;

impl Edge {
    /// None where the corners are one, but for rounding.
    fn new(from: Triple, to: Triple, slack: f64) -> Option<Self> {
        let whole = minus(to, from);
        let length = length(whole);
        (length > slack).then(|| Self { from, way: times(whole, 1.0 / length), length })
    }

    /// ∫∫ ln r ds·ds′ over this edge and another [m²], r in a unit [m].
    fn along(&self, other: &Self, unit: f64) -> f64 {
        let cos = dot(self.way, other.way);
        if cos.abs() <= SQUARE {
            return 0.0;
        }
        let turn = length(cross(self.way, other.way));
        let logarithms = if turn < PARALLEL {
            self.beside(other, cos.signum())
        } else if self.length <= other.length {
            self.across(other, cos, turn)
        } else {
            other.across(self, cos, turn)
        };
        cos * (logarithms - self.length * other.length * unit.ln())
    }

    /// ∫∫ ln r of parallel edges, by the second integral of ln √(x² + h²).
    fn beside(&self, other: &Self, sign: f64) -> f64 {
        let apart = minus(other.from, self.from);
        let along = dot(apart, self.way);
        let aside = length(minus(apart, times(self.way, along)));
        let ends = [along, along + sign * other.length];
        let twice = |x: f64| {
            let square = x * x + aside * aside;
            if square == 0.0 {
                return 0.0;
            }
            0.25 * (x * x - aside * aside) * square.ln() - 0.75 * x * x
                + x * aside * (x / aside.max(f64::MIN_POSITIVE)).atan()
        };
        let differences = |end: f64| twice(end) - twice(end - self.length);
        sign * (differences(ends[1]) - differences(ends[0]))
    }

    /// ∫∫ ln r of edges that are not, by points of this one.
    fn across(&self, other: &Self, cos: f64, turn: f64) -> f64 {
        let apart = minus(self.from, other.from);
        // Where along this edge r² of a place of the other's line can vanish, and how far that is beside the real numbers: for
        // either end, and for the foot of the lines' common perpendicular.
        let end = |at: f64| {
            let way = minus(plus(other.from, times(other.way, at)), self.from);
            let foot = dot(way, self.way);
            [foot, length(minus(way, times(self.way, foot)))]
        };
        let normal = times(cross(self.way, other.way), 1.0 / turn);
        let square = turn * turn;
        let foot = (cos * dot(apart, other.way) - dot(apart, self.way)) / square;
        let singular = [end(0.0), end(other.length), [foot, dot(apart, normal).abs() / turn]];
        // ∫ ln r over the other edge, from one place of this.
        let inner = |s: f64| {
            let way = plus(apart, times(self.way, s));
            let along = dot(way, other.way);
            let aside = length(minus(way, times(other.way, along)));
            let once = |x: f64| {
                let square = x * x + aside * aside;
                let log = if square > 0.0 { 0.5 * x * square.ln() } else { 0.0 };
                log - x + if aside > 0.0 { aside * (x / aside).atan() } else { 0.0 }
            };
            once(other.length - along) - once(-along)
        };
        let mut cuts: Vec<f64> =
            singular.iter().map(|[at, _]| *at).filter(|at| *at > 0.0 && *at < self.length).collect();
        cuts.extend([0.0, self.length]);
        cuts.sort_by(f64::total_cmp);
        cuts.windows(2).map(|ends| summed(&inner, &singular, [ends[0], ends[1]], DEEPEST)).sum()
    }
}

/// Halvings after which a piece beside a singular place is so short [1] that what it misses is no digit: s² ln s.
const DEEPEST: u32 = 28;

/// Gauss's rules for pieces that are their own length away from what is singular, and four of them.
static RULES: LazyLock<[Vec<(f64, f64)>; 2]> = LazyLock::new(|| [gauss_legendre(12), gauss_legendre(6)]);

/// An integral over a piece, cut in half until it is far enough from all singular places. The error of n points falls as ρ^−2n
/// with ρ the sum of the axes of the ellipse about the piece, its half for unit, that meets the first such place (L. N. Trefethen,
/// *Is Gauss quadrature better than Clenshaw–Curtis?*, SIAM Rev. 50 (2008) 67, theorem 4.5): at a distance of one length from
/// the middle ρ ≥ 3.7, at four 15.9, and either rule is left with some 10⁻¹⁴ of the piece.
fn summed(inner: &impl Fn(f64) -> f64, singular: &[[f64; 2]; 3], [from, to]: [f64; 2], deep: u32) -> f64 {
    let (middle, size) = (0.5 * (from + to), to - from);
    let near = singular.iter().map(|[at, aside]| (at - middle).hypot(*aside)).fold(f64::INFINITY, f64::min);
    if near < size && deep > 0 {
        let half = |ends| summed(inner, singular, ends, deep - 1);
        return half([from, middle]) + half([middle, to]);
    }
    let rule = &RULES[usize::from(near >= 4.0 * size)];
    size * rule.iter().map(|(at, weight)| weight * inner(from + at * size)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::triple::normalised;

    fn exchanged(one: &[Triple], other: &[Triple]) -> f64 {
        let normal = |all: &[Triple]| normalised(cross(minus(all[1], all[0]), minus(all[2], all[0])));
        exchange((one, normal(one)), (other, normal(other)))
    }

    /// Faces of regular bodies about the origin, turned inward.
    fn inward(faces: &[[Triple; 3]]) -> Vec<[Triple; 3]> {
        let turned =
            |[a, b, c]: [Triple; 3]| if dot(cross(minus(b, a), minus(c, a)), a) > 0.0 { [a, c, b] } else { [a, b, c] };
        faces.iter().map(|face| turned(*face)).collect()
    }

    #[test]
    fn a_face_of_a_tetrahedron_sees_a_third_of_each_other() {
        let [a, b, c, d] = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        let faces = inward(&[[a, b, c], [a, b, d], [a, c, d], [b, c, d]]);
        let area = 2.0 * 3.0_f64.sqrt();
        for (at, one) in faces.iter().enumerate() {
            for other in &faces[..at] {
                let found = exchanged(one, other) / area;
                // Nine terms of order 1, a few roundings each, and two rules of error 10⁻¹⁴.
                assert!((found - 1.0 / 3.0).abs() < 1e-13, "{found}");
            }
        }
    }

    #[test]
    fn a_face_of_an_octahedron_sees_all_of_it() {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let face = |signs: usize| -> [Triple; 3] {
            std::array::from_fn(|axis| times(axes[axis], if signs >> axis & 1 == 0 { 1.0 } else { -1.0 }))
        };
        let faces = inward(&(0..8).map(face).collect::<Vec<_>>());
        let sum: f64 = faces[1..].iter().map(|other| exchanged(&faces[0], other)).sum();
        let sum = sum / (0.75_f64.sqrt() * 2.0 / 2.0);
        assert!((sum - 1.0).abs() < 1e-13, "{}", sum - 1.0);
    }
}
