//! Records of irradiance, found by where they are, and what they say of places near by.

use super::hemisphere::Fallen;
use crate::bsdf::{Rgb, rgb};
use crate::number::{Frame, Vector};
use std::collections::HashMap;
use std::f64::consts::FRAC_PI_4;

/// How far [1] off a plane, in reaches, records count: those of the shelf above do not.
const FLAT: f64 = 0.1;

/// The light on a place.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// Where [units of the stage].
    pub place: Vector<f64>,
    /// The unit normal.
    pub normal: Vector<f64>,
    /// The most edges of a path that brings the light here.
    pub edges: u32,
    /// Irradiance [W m⁻²].
    pub irradiance: Rgb<f64>,
    /// Its gradient [W m⁻²] where the normal turns.
    pub turned: [Vector<f64>; 3],
    /// Its gradient [W m⁻² by units of the stage] where the place is shifted.
    pub shifted: [Vector<f64>; 3],
    /// How far what is around is [units of the stage].
    pub radius: f64,
}

impl Record {
    /// Of the light on a place along these axes, its radius within two bounds.
    ///
    /// The radius is the harmonic mean of all distances, but no more than that after which the gradient has doubled the light,
    /// which is a sign that something is near that the mean has overlooked; where it is held up from below, the gradient is
    /// held down instead (J. Křivánek and P. Gautron, *Practical global illumination with irradiance caching* (2009), §3.3).
    pub fn new(place: Vector<f64>, frame: &Frame<f64>, edges: u32, fallen: &Fallen, [least, most]: [f64; 2]) -> Self {
        let whole: f64 = fallen.irradiance.iter().sum();
        let slope = fallen.shifted.iter().fold(Vector::of([0.0; 3]), |sum, one| sum + *one);
        let slope = slope.dot(slope).sqrt();
        let doubled = if slope > 0.0 { whole / slope } else { f64::INFINITY };
        let radius = fallen.distance.min(doubled).min(most).max(least);
        let held = if slope * radius > whole { whole / (slope * radius) } else { 1.0 };
        Self {
            place,
            normal: frame.z,
            edges,
            irradiance: fallen.irradiance,
            turned: fallen.turned.map(|way| frame.outward(way)),
            shifted: fallen.shifted.map(|way| frame.outward(way.scaled(held))),
            radius,
        }
    }

    /// How much of its irradiance [1] a place near by may lack or have more: 4d/πR + √(2 − 2n·n′), the most where one half of
    /// a sphere of radius R is bright and the other dark (G. J. Ward, F. M. Rubinstein and R. D. Clear, *A ray tracing solution
    /// for diffuse interreflection*, SIGGRAPH '88, 85, eq. 5).
    pub fn doubt(&self, place: Vector<f64>, normal: Vector<f64>) -> f64 {
        let off = place - self.place;
        let turned = (2.0 - 2.0 * self.normal.dot(normal)).max(0.0).sqrt();
        off.dot(off).sqrt() / (FRAC_PI_4 * self.radius) + turned
    }

    /// The irradiance [W m⁻²] of a place near by, as its gradients have it.
    pub fn told(&self, place: Vector<f64>, normal: Vector<f64>) -> Rgb<f64> {
        let off = place - self.place;
        rgb(|c| self.irradiance[c] + self.shifted[c].dot(off) + self.turned[c].dot(normal))
    }
}

/// Records that count as far as their doubt is allowed.
pub struct Cache {
    allowed: f64,
    records: Vec<Record>,
    /// Of the width 2^level of a grid and a cell of it, the records that reach into it.
    cells: HashMap<(i32, [i64; 3]), Vec<usize>>,
    levels: Vec<i32>,
}

impl Cache {
    /// Of no records yet, allowed a doubt > 0 [1].
    pub fn new(allowed: f64) -> Self {
        Self { allowed, records: Vec::new(), cells: HashMap::new(), levels: Vec::new() }
    }

    /// The doubt [1] that is allowed.
    pub fn allowed(&self) -> f64 {
        self.allowed
    }

    /// Its records, in the order in which they came.
    pub fn records(&self) -> &[Record] {
        &self.records
    }

    /// How far [units of the stage] a record reaches.
    pub fn reach(&self, record: &Record) -> f64 {
        FRAC_PI_4 * self.allowed * record.radius
    }

    /// With one more.
    pub fn add(&mut self, record: Record) {
        let reach = self.reach(&record);
        // Cells as wide as its ball at least: it is in two of them along an axis at most.
        let level = (2.0 * reach).log2().ceil() as i32;
        if let Err(at) = self.levels.binary_search(&level) {
            self.levels.insert(at, level);
        }
        let [low, high] = [-reach, reach].map(|reach| cell(record.place + Vector::of([reach; 3]), level));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    self.cells.entry((level, [x, y, z])).or_default().push(self.records.len());
                }
            }
        }
        self.records.push(record);
    }

    /// Lets no radius be larger than that of a neighbour and the way to it: what one of them has seen is near the other too
    /// (Křivánek and Gautron, §3.3.2). The records from `first` on are new.
    pub fn adapt(&mut self, first: usize) {
        if first == self.records.len() {
            return;
        }
        let held = |record: &Record, others: &[Record]| {
            let near = others.iter().map(|other| {
                let off = other.place - record.place;
                other.radius + off.dot(off).sqrt()
            });
            near.fold(record.radius, f64::min)
        };
        let radii = super::mapped(&self.records[first..], |record| held(record, &self.records));
        self.records[first..].iter_mut().zip(radii).for_each(|(record, radius)| record.radius = radius);
        let (known, new) = self.records.split_at(first);
        let radii = super::mapped(known, |record| held(record, new));
        self.records.iter_mut().zip(radii).for_each(|(record, radius)| record.radius = radius);
    }

    // ANCHOR: interpolation
    /// The irradiance [W m⁻²] of a place by paths of at most so many edges: a mean of what the records near by say of it, weighed by
    /// how much of the doubt that is allowed they leave; None where there are none.
    pub fn irradiance(&self, place: Vector<f64>, normal: Vector<f64>, edges: u32) -> Option<Rgb<f64>> {
        let (mut sum, mut weights) = ([0.0; 3], 0.0);
        for level in &self.levels {
            for number in self.cells.get(&(*level, cell(place, *level))).into_iter().flatten() {
                let record = &self.records[*number];
                let weight = 1.0 - record.doubt(place, normal) / self.allowed;
                let rise = (place - record.place).dot(normal + record.normal).abs();
                if weight > 0.0 && record.edges == edges && rise <= 2.0 * FLAT * self.reach(record) {
                    let told = record.told(place, normal);
                    sum = rgb(|c| sum[c] + weight * told[c]);
                    weights += weight;
                }
            }
        }
        (weights > 0.0).then(|| sum.map(|sum| (sum / weights).max(0.0)))
    }
    // ANCHOR_END: interpolation
}

/// The cell of a place in a grid of width 2^level.
fn cell(place: Vector<f64>, level: i32) -> [i64; 3] {
    let width = f64::from(level).exp2();
    [place.x, place.y, place.z].map(|x| (x / width).floor() as i64)
}
