//! Which patch sees how much of which.

use super::sight::Sight;
use super::{Patch, Patches, exchange};
use crate::scene::triple::{largest, minus};
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

/// What patches of two faces exchange, by the way from one to the other: the pieces of a face are all alike, and of n⁴ pairs at
/// most 2n³ differ.
struct Known {
    values: HashMap<[i64; 5], f64, BuildHasherDefault<Mixed>>,
    unit: f64,
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

impl Known {
    fn new(patches: &Patches) -> Self {
        let reach = patches.list.iter().map(|patch| largest(patch.corner) + patch.size()).fold(0.0, f64::max);
        Self { values: HashMap::default(), unit: ALIKE * reach }
    }

    fn exchange(&mut self, faces: [usize; 2], [one, other]: [&Patch; 2]) -> f64 {
        let [x, y, z] = minus(other.corner, one.corner).map(|way| (way / self.unit).round() as i64);
        let key = [faces[0] as i64, faces[1] as i64, x, y, z];
        *self.values.entry(key).or_insert_with(|| exchange::exchange(one, other))
    }
}

impl Network {
    /// From the areas [m²] of patches and what each two exchange [m²], row by row and the same both ways. Of a closed room
    /// nothing is lost; else what a patch sees of no other.
    pub fn new(areas: Vec<f64>, exchanged: &[f64], is_closed: bool) -> Self {
        let n = areas.len();
        let factors: Vec<f64> = exchanged.iter().enumerate().map(|(at, both)| both / areas[at / n]).collect();
        let lost = |row: &[f64]| if is_closed { 0.0 } else { (1.0 - row.iter().sum::<f64>()).max(0.0) };
        let lost = factors.chunks_exact(n).map(lost).collect();
        Self { areas, factors, lost }
    }

    /// Of the patches of a room. Where other faces may come between two patches, n⁴ rays are sent (n = 3), and of what the
    /// two would exchange that share counts which gets through.
    ///
    /// Patches that touch at a slant, as at the foot of a turned block, are summed by points and known badly: their rows may add
    /// up to more than 1, in the Cornell box to 1.05 of whole faces and 1.2 of quarters of their edges.
    pub fn of(patches: &Patches) -> Self {
        let n = patches.list.len();
        let areas: Vec<f64> = patches.list.iter().map(Patch::area).collect();
        let sight = Sight::new(&patches.room);
        let mut known = Known::new(patches);
        let mut exchanged = vec![0.0; n * n];
        for i in 0..n {
            for j in i + 1..n {
                let [one, other] = [i, j].map(|at| &patches.list[at]);
                let [from, to] = [i, j].map(|at| patches.owners[at]);
                let mut both = known.exchange([from, to], [one, other]);
                if both > 0.0 && sight.may_be_blocked(from, to) {
                    let between = sight.between([from, to], [one, other]);
                    if !between.is_empty() {
                        let [seen, all] =
                            exchange::by_middles(one, other, IN_PART, |a, b| Sight::is_free(&between, a, b));
                        both *= if all > 0.0 { seen / all } else { 0.0 };
                    }
                }
                exchanged[i * n + j] = both;
                exchanged[j * n + i] = both;
            }
        }
        Self::new(areas, &exchanged, patches.room.is_closed)
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
