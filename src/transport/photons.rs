//! Photon mapping: light is sent out from the lamps and left where it falls; what a matt place sends to the camera is told by
//! how much lies about it (H. W. Jensen, *Global illumination using photon maps*, Rendering Techniques '96, 21).
//!
//! The first matt place of a path is lit by rays to lamps, by a map of what came by way of mirrors and glass, and by one ray
//! more, whose next matt place is told by a map of all light. A map is blurred by its radius, so that a picture by one map is
//! wrong, however many rays it takes. Here every sample has maps of its own, and their radius shrinks from one to the next, so
//! slowly that noise falls as well (C. Knaus and M. Zwicker, *Progressive photon mapping: a probabilistic approach*, ACM
//! Trans. Graph. 30 (2011) 25): the mean square of the error of N samples falls as N^−2/3.

use super::picture::DEEP;
use super::simple::lamps::from_lamps;
use super::simple::{Numbers, carried, gathered};
use super::{Stage, Vertex};
use crate::bsdf::{Rgb, rgb};
use crate::geometry::Ray;
use crate::number::{Frame, Vector};
use crate::sampling::{Choice, Points, Shares, Stream, warp};
use crate::threads::mapped;
use std::collections::HashMap;
use std::f64::consts::{FRAC_1_PI, PI};
use std::ops::Range;

/// Paths from lamps, for every pixel of a picture.
const PATHS_A_PIXEL: f64 = 0.25;
/// The least and the most of them.
const PATHS: [u32; 2] = [1 << 10, 1 << 18];
/// Vertices of them whose numbers are a net's.
const VERTICES: usize = 8;
/// Photons about a photon within the first radius.
const NEAR: usize = 24;
/// Photons that are asked for it.
const ASKED: usize = 64;
/// How much of the radius decays: r² falls as N^(α − 1), where noise and blur fall alike (Knaus and Zwicker, §4.3).
const ALPHA: f64 = 2.0 / 3.0;
/// How far [1] off a plane, in radii, photons count: those of the wall around a corner do not.
const FLAT: f64 = 0.1;
/// Vertices before a path from a lamp may be ended by chance.
const PATIENCE: u16 = 3;

/// Light on its way to a matt place, where it has arrived.
#[derive(Clone, Copy, Debug)]
pub struct Photon {
    /// Where [units of the stage].
    pub place: Vector<f64>,
    /// Where it came from.
    pub wi: Vector<f64>,
    /// Its part of the lamps' flux [W], lengths in units of the stage.
    pub flux: Rgb<f64>,
    /// Edges from the lamp on.
    pub edges: u16,
    /// Whether it has met something by the way, and nothing matt.
    pub is_caustic: bool,
}

/// Photons, found by where they are.
pub struct Map {
    photons: Vec<Photon>,
    cells: HashMap<[i64; 3], Range<usize>>,
    radius: f64,
}

impl Map {
    /// Of photons that count up to a radius > 0 [units of the stage].
    pub fn new(mut photons: Vec<Photon>, radius: f64) -> Self {
        let cell = |photon: &Photon| cell(photon.place, radius);
        // Stable: the order of sums is that of the paths.
        photons.sort_by_key(cell);
        let mut cells = HashMap::new();
        let mut start = 0;
        for some in photons.chunk_by(|a, b| cell(a) == cell(b)) {
            cells.insert(cell(&some[0]), start..start + some.len());
            start += some.len();
        }
        Self { photons, cells, radius }
    }

    /// Irradiance [W m⁻²] at a place of a surface from the side of a unit normal, by photons that have come at most so many edges:
    /// a mean over the disc about it, weighed by 1 − d²/r². Where the irradiance E curves, that is off by r²∇²E/12.
    pub fn irradiance(&self, place: Vector<f64>, normal: Vector<f64>, most: u32) -> Rgb<f64> {
        let reach2 = self.radius * self.radius;
        // The eight cells about it, each as wide as the disc.
        let low = cell(place - Vector::of([self.radius; 3]), self.radius);
        let mut sum = [0.0; 3];
        for corner in 0..8 {
            let key = std::array::from_fn(|axis| low[axis] + i64::from(corner >> axis & 1));
            let Some(range) = self.cells.get(&key) else { continue };
            for photon in &self.photons[range.clone()] {
                let off = photon.place - place;
                let weight = 1.0 - off.dot(off) / reach2;
                let is_here = off.dot(normal).abs() <= FLAT * self.radius && photon.wi.dot(normal) > 0.0;
                if weight > 0.0 && is_here && u32::from(photon.edges) <= most {
                    sum = rgb(|c| sum[c] + photon.flux[c] * weight);
                }
            }
        }
        sum.map(|sum| sum * 2.0 / (PI * reach2))
    }

    /// Its photons.
    pub fn photons(&self) -> &[Photon] {
        &self.photons
    }
}

/// The cell of a place in a grid as wide as a disc of that radius.
fn cell(place: Vector<f64>, radius: f64) -> [i64; 3] {
    [place.x, place.y, place.z].map(|x| (0.5 * x / radius).floor() as i64)
}

/// What maps of a scene are made by.
pub struct Photons {
    /// Of the lamps that have a surface to send light from; None if none has.
    shares: Option<Shares>,
    paths: u32,
    /// Of the first maps: of what came by way of mirrors and glass, and of all.
    radii: [f64; 2],
    points: Points,
}

/// The maps of one sample.
pub struct Maps {
    caustics: Map,
    all: Map,
}

impl Photons {
    /// For the pictures of a stage.
    pub fn new(stage: &Stage<f64>, choice: Choice, seed: u64) -> Self {
        let flux = stage.lamps().iter().map(|lamp| if lamp.area().is_some() { lamp.flux(1.0) } else { 0.0 });
        let shares = Shares::new(flux);
        let [width, height] = stage.size().map(f64::from);
        let paths = ((width * height * PATHS_A_PIXEL) as u32).clamp(PATHS[0], PATHS[1]);
        let points = Points::new(choice, paths, VERTICES, seed ^ 0x70_686f_746f_6e73);
        let mut photons = Self { shares, paths, radii: [1.0; 2], points };
        // By numbers that no map has.
        let first = photons.sent(stage, u32::MAX / 2);
        let caustics: Vec<Photon> = first.iter().filter(|photon| photon.is_caustic).copied().collect();
        photons.radii = [near(&caustics), near(&first)];
        photons
    }

    /// The paths of a map.
    pub fn paths(&self) -> u32 {
        self.paths
    }

    /// The radii [units of the stage] of the maps of a sample: of what came by way of mirrors and glass, and of all.
    pub fn radii(&self, sample: u32) -> [f64; 2] {
        self.radii.map(|radius| radius * (f64::from(sample) + 1.0).powf(0.5 * (ALPHA - 1.0)))
    }

    /// The maps of a sample.
    pub fn maps(&self, stage: &Stage<f64>, sample: u32) -> Maps {
        let all = self.sent(stage, sample);
        let caustics = all.iter().filter(|photon| photon.is_caustic).copied().collect();
        let [narrow, wide] = self.radii(sample);
        Maps { caustics: Map::new(caustics, narrow), all: Map::new(all, wide) }
    }

    /// The photons of a sample, in the order of their paths.
    pub fn sent(&self, stage: &Stage<f64>, sample: u32) -> Vec<Photon> {
        let stream = self.points.of_pixel([u32::MAX, sample / 2]);
        let paths: Vec<u32> = (0..self.paths).collect();
        // The two halves of a picture have numbers that know nothing of each other.
        let of =
            |shares: &Shares| mapped(&paths, |path| self.path(stage, shares, &stream, 2 * path + sample % 2)).concat();
        self.shares.as_ref().map(of).unwrap_or_default()
    }

    /// What one path leaves.
    fn path(&self, stage: &Stage<f64>, shares: &Shares, stream: &Stream<'_>, number: u32) -> Vec<Photon> {
        let mut left = Vec::new();
        let [which, u, v, a, b, side, ..] = stream.row::<f64>(|_| number, |_| 0);
        let (at, _) = shares.pick(which);
        let lamp = &stage.lamps()[at];
        let Some(area) = lamp.area() else { return left };
        let [_, normal, start] = lamp.place([u, v], side);
        let (way, _) = warp::cosine_hemisphere([a, b]);
        let mut ray = Ray { origin: start, direction: Frame::about(normal).outward(way) };
        // πLA of a lamp, by its share of all paths.
        let sent = PI * area / (shares.share(at) * f64::from(self.paths));
        let (mut carries, mut is_direct, mut is_diffuse) = ([1.0; 3], true, false);
        let most = stage.max_depth().unwrap_or(DEEP).saturating_sub(1).min(u32::from(u16::MAX)) as u16;
        for edges in 1..=most {
            let Some(vertex) = stage.meet(&ray) else { break };
            carries = carried(carries, vertex.clarity);
            if is_matt(&vertex) {
                let flux = rgb(|c| lamp.radiance()[c] * sent * carries[c]);
                let is_caustic = !is_direct && !is_diffuse;
                left.push(Photon { place: vertex.surface.point, wi: -ray.direction, flux, edges, is_caustic });
            }
            is_diffuse |= is_matt(&vertex);
            is_direct = false;
            let row = stream.at(|_| number, |_| usize::from(edges));
            let drawn = vertex.scatter(row.surface);
            let direction = vertex.frame.outward(drawn.wi);
            carries = carried(carries, vertex.kept(&drawn, direction));
            ray = stage.leave(&vertex, direction);
            let largest = carries.into_iter().fold(0.0, f64::max);
            let chance = if edges < PATIENCE { 1.0 } else { largest.min(1.0) };
            if !(largest > 0.0 && row.survival < chance) {
                break;
            }
            carries = carries.map(|carries| carries / chance);
        }
        left
    }

    /// The radiance [W m⁻² sr⁻¹] that comes along a ray, by the maps of its sample.
    // ANCHOR: photons
    pub fn radiance(
        stage: &Stage<f64>,
        maps: &Maps,
        mut ray: Ray<f64>,
        numbers: &mut Numbers<'_>,
        depth: u32,
    ) -> Rgb<f64> {
        let (mut light, mut carries) = ([0.0; 3], [1.0; 3]);
        let mut is_second = false;
        for edge in 1..=depth {
            let Some(vertex) = stage.meet(&ray) else { break };
            carries = carried(carries, vertex.clarity);
            if !is_second {
                light = gathered(light, carries, vertex.emitted());
            }
            if edge == depth {
                break;
            }
            let row = numbers.of_next_vertex();
            if is_matt(&vertex) {
                let albedo = vertex.met.paint();
                let (place, normal) = (vertex.surface.point, vertex.frame.z);
                let of_map = |map: &Map| {
                    let fallen = map.irradiance(place, normal, depth - edge);
                    rgb(|c| albedo[c] * FRAC_1_PI * fallen[c])
                };
                if is_second {
                    // Where one ray more has led: all light that fell there.
                    return gathered(light, carries, of_map(&maps.all));
                }
                light = gathered(light, carries, from_lamps(stage, &vertex, row.lamp, |_, _| 1.0));
                light = gathered(light, carries, of_map(&maps.caustics));
                is_second = true;
            }
            let drawn = vertex.scatter(row.surface);
            carries = carried(carries, drawn.weight);
            ray = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
        }
        light
    }
    // ANCHOR_END: photons
}

/// Whether light is left there: Lambert's surfaces, on the side that is met.
fn is_matt(vertex: &Vertex<'_, f64>) -> bool {
    vertex.met.is_lambert() && vertex.wo.z > 0.0
}

/// The median distance of some photons to the [`NEAR`]th about them, or where there are hardly any, to the last; 1 of none.
fn near(photons: &[Photon]) -> f64 {
    let step = photons.len().div_ceil(ASKED).max(1);
    let distance = |one: &Photon| {
        let mut all: Vec<f64> = photons.iter().map(|other| other.place - one.place).map(|off| off.dot(off)).collect();
        let at = NEAR.min(all.len() - 1);
        all.select_nth_unstable_by(at, f64::total_cmp).1.sqrt()
    };
    let mut all: Vec<f64> = photons.iter().step_by(step).map(distance).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().filter(|radius| *radius > 0.0).unwrap_or(1.0)
}
