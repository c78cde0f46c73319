//! Rays among heights.

use super::{Facet, Relief};

/// A ray that has not met a facet after passing this many squares counts as trapped. Those from cos θ ≥ 10⁻⁵ need fewer
/// on a Gaussian relief; nearer to the horizon a ray may run past peaks for ever.
pub const MOST_STEPS: u32 = 1 << 16;

/// What became of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It rose above all heights.
    Left,
    /// It did not within the bounces it was given, or within [`MOST_STEPS`]: count it, for its light is missing.
    Trapped,
}

/// One ray's way through a relief.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// What became of it.
    pub fate: Fate,
    /// `wo`: where it went at last, away from the surface as all directions are.
    pub direction: [f64; 3],
    /// How many facets it met. None if it passed over all: only level rays do, and those from below.
    pub bounces: u32,
    /// The product of the reflectances [1] of the facets it met.
    pub power: f64,
    /// The normal of the first facet it met; straight up if none.
    pub first: [f64; 3],
}

impl Relief {
    /// Follows the light that comes from `wi`, a unit vector, along the ray through the point (u, v) of the plane at
    /// the [`Self::top`], in sides. Even points there are even in the light's own cross-section. Each facet met at the
    /// cosine c keeps `reflectance`(c) of the power; a ray that meets more than `most` facets is trapped.
    ///
    /// A ray with `wi` level or from below passes over everything.
    pub fn trace(&self, wi: [f64; 3], point: [f64; 2], reflectance: impl Fn(f64) -> f64, most: u32) -> Path {
        let away = wi.map(|part| 0.0 - part);
        let [x, y] = point.map(|part| part * self.side as f64);
        let cell = [x, y].map(|part| part.floor() as isize);
        let mut ray = Ray { cell, origin: [x, y, self.top()], direction: away };
        let mut path = Path { fate: Fate::Trapped, direction: away, bounces: 0, power: 1.0, first: [0.0, 0.0, 1.0] };
        loop {
            match self.next(&ray) {
                Met::Nothing => return Path { fate: Fate::Left, ..path },
                Met::TooLate => return path,
                Met::Facet(..) if path.bounces == most => return path,
                Met::Facet(facet, cell, place) => {
                    let (direction, cos) = facet.mirrored(ray.direction);
                    if path.bounces == 0 {
                        path.first = facet.normal();
                    }
                    path.bounces += 1;
                    path.power *= reflectance(cos);
                    path.direction = direction;
                    ray = Ray { origin: place, direction, cell };
                }
            }
        }
    }

    /// [`Self::trace`] for each of `points`, in their order, whatever the number of threads.
    pub fn trace_all(
        &self,
        wi: [f64; 3],
        points: &[[f64; 2]],
        reflectance: impl Fn(f64) -> f64 + Sync,
        most: u32,
    ) -> Vec<Path> {
        let path = |&point: &[f64; 2]| self.trace(wi, point, &reflectance, most);
        #[cfg(feature = "parallel")]
        {
            use rayon::prelude::*;
            points.par_iter().map(path).collect()
        }
        #[cfg(not(feature = "parallel"))]
        points.iter().map(path).collect()
    }

    /// The first facet that `ray` falls through.
    fn next(&self, ray: &Ray) -> Met {
        let rising = ray.direction[2] >= 0.0;
        let pace = ray.direction.map(f64::recip);
        let (mut t, mut cell, mut level) = (0.0_f64, ray.cell, 0);
        for _ in 0..MOST_STEPS {
            if rising && ray.height(t) >= self.top() {
                return Met::Nothing;
            }
            let low = cell.map(|part| part >> level << level);
            let [(to_x, next_x), (to_y, next_y)] =
                [0, 1].map(|axis| leaving(low[axis], level, ray.origin[axis], pace[axis]));
            let end = to_x.min(to_y).max(t);
            let lowest = ray.height(if rising { t } else { end });
            if lowest <= self.pyramid.highest(level, cell) {
                if level > 0 {
                    level -= 1;
                    continue;
                }
                if let Some((facet, at)) = self.within(ray, cell, t, end) {
                    return Met::Facet(facet, cell, ray.at(at));
                }
            }
            // The coordinate that is not crossed stays within the square whatever rounding says; `as` cuts towards zero.
            let beside = |axis: usize| {
                let inside = ray.origin[axis] + ray.direction[axis] * end - low[axis] as f64;
                low[axis] + (inside as isize).clamp(0, (1 << level) - 1)
            };
            let next = if to_x <= to_y { [next_x, beside(1)] } else { [beside(0), next_y] };
            // Into another square of twice the size: it may all be below.
            let up = level + 1;
            if up <= self.pyramid.summit() && (next[0] >> up, next[1] >> up) != (cell[0] >> up, cell[1] >> up) {
                level = up;
            }
            (cell, t) = (next, end);
        }
        Met::TooLate
    }

    /// The facet of `cell` that `ray` falls through between `t` and `end`, and where.
    fn within(&self, ray: &Ray, cell: [isize; 2], t: f64, end: f64) -> Option<(Facet, f64)> {
        let [x, y] = [0, 1].map(|axis| ray.origin[axis] - cell[axis] as f64);
        let [dx, dy, _] = ray.direction;
        let (offset, drift) = (x - y, dx - dy);
        let facets = self.facets(cell);
        // Which side of the diagonal comes first, and until when.
        let crossing = -offset / drift;
        let (first, change) = if crossing > t && crossing < end {
            (usize::from(drift > 0.0), crossing)
        } else if drift == 0.0 {
            (usize::from(offset < 0.0), end)
        } else {
            (usize::from(offset + drift * (0.5 * (t + end)) < 0.0), end)
        };
        let hit = |side: usize, from: f64, to: f64| {
            let facet = facets[side];
            let (start, gain) = (facet.above([x, y, ray.origin[2]]), facet.gain(ray.direction));
            // Only from above to below. A ray that rounding has put under a facet it rises from is let go; one that it
            // has put under a facet it falls towards meets it at once.
            (gain < 0.0 && start + gain * to < 0.0).then(|| (facet, (-start / gain).clamp(from, to)))
        };
        hit(first, t, change).or_else(|| if change < end { hit(1 - first, change, end) } else { None })
    }
}

/// A ray on its way between two facets.
#[derive(Clone, Copy, Debug)]
struct Ray {
    /// The cell it starts in.
    cell: [isize; 2],
    origin: [f64; 3],
    direction: [f64; 3],
}

impl Ray {
    fn height(&self, t: f64) -> f64 {
        self.origin[2] + self.direction[2] * t
    }

    fn at(&self, t: f64) -> [f64; 3] {
        std::array::from_fn(|axis| self.origin[axis] + self.direction[axis] * t)
    }
}

/// What a ray meets next.
enum Met {
    /// A facet of a cell, at a place.
    Facet(Facet, [isize; 2], [f64; 3]),
    /// It has left.
    Nothing,
    /// It has not yet met any.
    TooLate,
}

/// When a ray leaves the square of `level` from `low` on along one axis, and which cell it enters; `pace` is the time it
/// takes for a cell, infinite if it stays.
#[inline]
fn leaving(low: isize, level: usize, origin: f64, pace: f64) -> (f64, isize) {
    let next = if pace > 0.0 { low + (1 << level) } else { low - 1 };
    let border = if pace > 0.0 { next } else { low };
    (if pace.is_infinite() { f64::INFINITY } else { (border as f64 - origin) * pace }, next)
}
