//! Which patch sees how much of which.

use super::exchange::Route;
use super::sight::Sight;
use super::{Patch, Patches, exchange};
use crate::scene::Triple;
use crate::scene::triple::{dot, largest, minus};
use crate::threads::mapped;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};
use std::ops::Range;

/// Patches by what they see of each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Network {
    /// Area of each [m²].
    pub areas: Vec<f64>,
    /// F [1] row by row: of what leaves patch i the share that arrives at j.
    factors: Vec<f64>,
    /// Of what leaves a patch the share [1] that arrives nowhere.
    pub lost: Vec<f64>,
}

/// What each patch does with light, in one channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// 1 − ρ [1].
    pub absorbed: Vec<f64>,
    /// The radiance [W m⁻² sr⁻¹] that it sends out by itself.
    pub emitted: Vec<f64>,
}

impl Light {
    /// Of all patches of a room, in one of three channels.
    pub fn of(patches: &Patches, channel: usize) -> Self {
        let faces = || patches.owners.iter().map(|owner| &patches.room.faces[*owner]);
        Self {
            absorbed: faces().map(|face| face.absorbed[channel]).collect(),
            emitted: faces().map(|face| face.emitted[channel]).collect(),
        }
    }

    /// ρ of a patch [1].
    pub fn reflected(&self, patch: usize) -> f64 {
        1.0 - self.absorbed[patch]
    }
}

/// Pieces each way into which patches are cut that see each other in part.
const IN_PART: usize = 3;

/// How many pairs of patches were found by which route.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Routes {
    /// Of patches of one face, or behind each other: nothing to do.
    pub behind: usize,
    /// By closed forms.
    pub closed: usize,
    /// By Gauss's rule, far from each other.
    pub points: usize,
    /// Around both.
    pub contour: usize,
    /// Of all these, hidden from each other in part or wholly, as rays between them say.
    pub hidden: usize,
}

impl Routes {
    fn count(&mut self, route: Route, is_hidden: bool) {
        *match route {
            Route::Behind => &mut self.behind,
            Route::Closed => &mut self.closed,
            Route::Points => &mut self.points,
            Route::Contour => &mut self.contour,
        } += 1;
        self.hidden += usize::from(is_hidden);
    }

    fn plus(self, other: Self) -> Self {
        Self {
            behind: self.behind + other.behind,
            closed: self.closed + other.closed,
            points: self.points + other.points,
            contour: self.contour + other.contour,
            hidden: self.hidden + other.hidden,
        }
    }
}

/// What patches of two faces exchange, by the way from one to the other: the pieces of a face are all alike, and of n⁴ pairs at
/// most 2n³ differ.
struct Known {
    values: HashMap<[i64; 4], (f64, Route), BuildHasherDefault<Mixed>>,
    unit: f64,
    /// An edge of either face: a triangle's pieces may be turned round.
    edges: [Triple; 2],
}

/// A hash of a few whole numbers: each is added, multiplied and folded. Nobody hostile chooses them.
#[derive(Default)]
struct Mixed(u64);

impl Hasher for Mixed {
    fn write(&mut self, bytes: &[u8]) {
        for eight in bytes.chunks(8) {
            let number = eight.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte));
            // 2⁶⁴ over the golden ratio, odd.
            self.0 = (self.0.rotate_left(23) ^ number).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            self.0 ^= self.0 >> 32;
        }
    }

    fn finish(&self) -> u64 {
        self.0
    }
}

/// Ways that differ by less of the room [1] are one way: far less than a patch, far more than rounding.
const ALIKE: f64 = 1e-10;

/// Roundings of where a room lies by which ways that are alike may differ.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;

impl Known {
    fn new(patches: &Patches, faces: [usize; 2]) -> Self {
        let first = patches.list[0].corner;
        let reach = |from: Triple| {
            patches.list.iter().map(|patch| largest(minus(patch.corner, from)) + patch.size()).fold(0.0, f64::max)
        };
        // Of the room's own size, wherever it lies.
        let unit = (ALIKE * reach(first)).max(ROUNDINGS * reach([0.0; 3]));
        let edges = faces.map(|face| patches.room.faces[face].patch.edges[0]);
        Self { values: HashMap::default(), unit, edges }
    }

    fn exchange(&mut self, one: &Patch, other: &Patch) -> (f64, Route) {
        let [x, y, z] = minus(other.corner, one.corner).map(|way| (way / self.unit).round() as i64);
        let turned = |patch: &Patch, edge: Triple| i64::from(dot(patch.edges[0], edge) < 0.0);
        let key = [2 * turned(one, self.edges[0]) + turned(other, self.edges[1]), x, y, z];
        *self.values.entry(key).or_insert_with(|| exchange::by_route(one, other))
    }
}

/// What the patches of two faces exchange, row by row of the first.
fn between(patches: &Patches, sight: &Sight, faces: [usize; 2]) -> (Vec<f64>, Routes) {
    let (mut known, mut routes) = (Known::new(patches, faces), Routes::default());
    let others = sight.others(faces);
    let [here, there] = faces.map(|face| &patches.list[patches.of_face(face)]);
    let mut all = Vec::with_capacity(here.len() * there.len());
    for one in here {
        for other in there {
            let (mut both, route) =
                if patches.is_even() { known.exchange(one, other) } else { exchange::by_route(one, other) };
            let mut is_hidden = false;
            if both > 0.0 && !others.is_empty() {
                let screens = sight.between(&others, faces, [one, other]);
                if !screens.is_empty() {
                    let [seen, all] = exchange::by_middles(one, other, IN_PART, |a, b| Sight::is_free(&screens, a, b));
                    is_hidden = seen < all;
                    // Where no middle is before the other patch, rays say nothing.
                    if all > 0.0 {
                        both *= seen / all;
                    }
                }
            }
            routes.count(route, is_hidden);
            all.push(both);
        }
    }
    (all, routes)
}

/// What patches that see more than all there is see of it [1], 1 of all others: of a pair that is hidden in part the share is
/// known by a few rays only, and light that grows at every bounce has no end.
fn fullness(areas: &[f64], exchanged: &[f64]) -> Vec<f64> {
    let rows = exchanged.chunks_exact(areas.len()).zip(areas);
    rows.map(|(row, area)| (row.iter().sum::<f64>() / area).max(1.0)).collect()
}

/// Pairs of faces that are looked at before what was found is put in its place.
const TOGETHER: usize = 64;

impl Network {
    /// From the areas [m²] of patches and what each two exchange [m²], row by row and the same both ways. Of a closed room
    /// nothing is lost; else what a patch sees of no other.
    pub fn new(areas: Vec<f64>, exchanged: &[f64], is_closed: bool) -> Self {
        let n = areas.len();
        let factors: Vec<f64> = exchanged
            .iter()
            .enumerate()
            .map(|(at, both)| if *both > 0.0 { both / areas[at / n] } else { 0.0 })
            .collect();
        let lost = |row: &[f64]| if is_closed { 0.0 } else { (1.0 - row.iter().sum::<f64>()).max(0.0) };
        let lost = factors.chunks_exact(n).map(lost).collect();
        Self { areas, factors, lost }
    }

    /// Of the patches of a room. Where other faces may come between two patches, n⁴ rays are sent (n = 3), and of what the
    /// two would exchange that share counts which gets through: of a pair that is hidden in part it is known to about 1/n² of
    /// the whole.
    pub fn of(patches: &Patches) -> Self {
        Self::counted(patches).0
    }

    /// The same, and by which routes.
    pub fn counted(patches: &Patches) -> (Self, Routes) {
        let (n, faces) = (patches.list.len(), patches.room.faces.len());
        let areas: Vec<f64> = patches.list.iter().map(Patch::area).collect();
        let sight = Sight::new(&patches.room);
        let pairs: Vec<[usize; 2]> = (0..faces).flat_map(|i| (i + 1..faces).map(move |j| [i, j])).collect();
        let mut exchanged = vec![0.0; n * n];
        let mut routes = Routes::default();
        // Some faces after some, lest all there is be held twice.
        for some in pairs.chunks(TOGETHER) {
            for (faces, (all, more)) in some.iter().zip(mapped(some, |faces| between(patches, &sight, *faces))) {
                routes = routes.plus(more);
                let [here, there] = faces.map(|face| patches.of_face(face));
                for (i, row) in here.zip(all.chunks_exact(there.len())) {
                    for (j, both) in there.clone().zip(row) {
                        exchanged[i * n + j] = *both;
                        exchanged[j * n + i] = *both;
                    }
                }
            }
        }
        let full = fullness(&areas, &exchanged);
        for (at, both) in exchanged.iter_mut().enumerate() {
            *both /= full[at / n].max(full[at % n]);
        }
        (Self::new(areas, &exchanged, patches.room.is_closed), routes)
    }

    /// The inside of a sphere whose pieces have such shares [1] of it: each sees of every piece, itself included, as much as
    /// that is of the whole. (Of a chord's two angles to the normals both cosines are r/2R.)
    pub fn sphere(shares: &[f64]) -> Self {
        let exchanged: Vec<f64> = shares.iter().flat_map(|a| shares.iter().map(move |b| a * b)).collect();
        Self::new(shares.to_vec(), &exchanged, true)
    }

    /// With what of each patch is lost [1] as it is known by itself, not as what is missing of 1.
    pub fn losing(self, lost: Vec<f64>) -> Self {
        Self { lost, ..self }
    }

    /// How many patches there are.
    pub fn len(&self) -> usize {
        self.areas.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.areas.is_empty()
    }

    /// F of a patch to each [1].
    pub fn row(&self, patch: usize) -> &[f64] {
        let n = self.len();
        &self.factors[patch * n..(patch + 1) * n]
    }

    /// F [1] from all patches of one range to all of another: Σ A F over Σ A.
    pub fn factor(&self, from: Range<usize>, to: Range<usize>) -> f64 {
        let area: f64 = self.areas[from.clone()].iter().sum();
        from.map(|at| self.areas[at] * self.row(at)[to.clone()].iter().sum::<f64>()).sum::<f64>() / area
    }

    /// What arrives at a patch [W m⁻² sr⁻¹], as a mean over the hemisphere: Σ F L.
    pub fn arriving(&self, patch: usize, radiances: &[f64]) -> f64 {
        let row = self.row(patch);
        let (rows, rest) = row.as_chunks::<8>();
        let (lights, last) = radiances[..row.len()].as_chunks::<8>();
        // Eight sums side by side, which no addition waits for.
        let mut sums = [0.0; 8];
        for (factors, lights) in rows.iter().zip(lights) {
            for (sum, (factor, light)) in sums.iter_mut().zip(factors.iter().zip(lights)) {
                *sum += factor * light;
            }
        }
        let rest = rest.iter().zip(last).map(|(factor, light)| factor * light).sum::<f64>();
        sums.iter().sum::<f64>() + rest
    }
}
