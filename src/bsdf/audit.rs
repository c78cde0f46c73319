//! What every surface has to hold, measured: samples against their density, energy, weights, both ways alike. For tests
//! and for those who show them.

use super::fresnel::dielectric;
use super::microfacet::{Beckmann, Distribution, Ggx, Slopes, visible_density};
use super::rough_dielectric::{Side, held_off_one, reflected, refracted};
use super::rules::golden;
use super::{Bsdf, Setting};
use crate::number::{Mask, Number, Vector};
use std::f64::consts::TAU;
use yardstick::random::{Stream, stream, uniform};
use yardstick::statistics::{LEAST_EXPECTED, Moments, chi_square};

/// The direction [1] at a cosine [1] to the normal and an azimuth [rad].
pub fn direction(cos: f64, phi: f64) -> Vector<f64> {
    let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
    Vector::new(sin * phi.cos(), sin * phi.sin(), cos)
}

/// One number in 0 ≤ u < 1.
pub fn throw(random: &mut Stream) -> f64 {
    uniform(random, 0.0, 1.0)
}

/// What many samples of one view carry.
#[derive(Clone, Debug, Default)]
pub struct Drawn {
    /// weight/compression [1] of the first channel.
    pub energy: Moments,
    /// The largest of them.
    pub largest: f64,
    /// The share [1] of those that came through.
    pub through: f64,
}

/// Draws for light that goes to `wo`; the address names the stream of random numbers.
pub fn drawn<N: Number>(model: &dyn Bsdf<N>, wo: Vector<f64>, draws: u64, address: &str) -> Drawn {
    let mut random = stream(31, address);
    let wo = Vector::<N>::of(wo.lane(0));
    let mut found = Drawn::default();
    for _ in 0..draws {
        let sample = model.sample(wo, [(); 3].map(|()| N::of(throw(&mut random)).min(N::of(1.0 - N::EPSILON))));
        let energy = (sample.weight[0] / sample.compression).lane(0);
        found.energy.add(energy);
        // NaN is the largest, and stays.
        let is_largest = !(found.largest.is_nan() || energy <= found.largest);
        found.largest = if is_largest { energy } else { found.largest };
        if sample.is_transmitted.lane(0) {
            found.through += energy / draws as f64;
        }
    }
    found
}

/// Bins along either side of a square.
const SIDE: usize = 16;
/// What the expected share of rejected samples is known to [1]; of what is within it the one that was found is taken.
const RULE: f64 = 1e-4;

/// p of the claim that the samples of a model of facets follow its density, for light that goes to `wo`. Directions are
/// binned by the facet that sends them, in the square of numbers from which visible facets are drawn, so that the narrowest
/// lobe fills the bins; reflection and transmission apart, what is rejected in a bin of its own. A direction counts as any
/// of those that are rounded to it: facets that belong to numbers of a width lie on a lattice, ε/(4α cos θ) of a lobe wide,
/// and bins would count its points. The limit in `f32` is α cos θ ≥ 1e−6: there the lattice is a thirtieth of the lobe, and
/// where it is a third, a density at rounded directions is no longer the lobe's.
pub fn lobe_density<N: Number>(
    model: &dyn Bsdf<N>,
    setting: &Setting,
    wo: Vector<f64>,
    draws: u64,
    address: &str,
) -> f64 {
    // As the model sees it.
    let wo = Vector::of(Vector::<N>::of(wo.lane(0)).lane(0));
    match setting.slopes {
        Slopes::Ggx => fits(model, &Facets::new(Ggx::new(setting.alpha), setting.index, wo), wo, draws, address),
        Slopes::Beckmann => {
            fits(model, &Facets::new(Beckmann::new(setting.alpha), setting.index, wo), wo, draws, address)
        }
    }
}

/// As [`lobe_density`], with bins that are even in solid angle: for what spreads over the hemisphere.
pub fn spread_density<N: Number>(model: &dyn Bsdf<N>, wo: Vector<f64>, draws: u64, address: &str) -> f64 {
    fits(model, &Sphere, wo, draws, address)
}

/// A square for each side of the surface whose points are directions.
trait Square {
    /// The point of a direction, seen from above.
    fn place(&self, wi: Vector<f64>) -> [f64; 2];
    /// The direction of a point on the given side, and |dω/du| [sr]; None where there is none.
    fn direction(&self, through: bool, u: [f64; 2]) -> Option<(Vector<f64>, f64)>;
}

struct Sphere;

impl Square for Sphere {
    fn place(&self, wi: Vector<f64>) -> [f64; 2] {
        [wi.z.abs(), wi.y.atan2(wi.x) / TAU]
    }

    fn direction(&self, through: bool, u: [f64; 2]) -> Option<(Vector<f64>, f64)> {
        Some((direction(u[0], TAU * u[1]).flipped(through), TAU))
    }
}

/// The facets that `wo` sees, from above.
struct Facets<D> {
    facets: D,
    wo: Vector<f64>,
    eta: f64,
}

impl<D: Distribution<f64>> Facets<D> {
    fn new(facets: D, index: f64, wo: Vector<f64>) -> Self {
        let side = Side::of(wo, held_off_one(index));
        Self { facets, wo: side.wo, eta: side.eta }
    }
}

impl<D: Distribution<f64>> Square for Facets<D> {
    fn place(&self, wi: Vector<f64>) -> [f64; 2] {
        let both = if wi.z < 0.0 { -(self.wo + wi.scaled(self.eta)) } else { self.wo + wi };
        let facet = both.normalised();
        self.facets.place(self.wo, facet.scaled(facet.z.signum()))
    }

    fn direction(&self, through: bool, u: [f64; 2]) -> Option<(Vector<f64>, f64)> {
        let (wo, eta) = (self.wo, self.eta);
        let facet = self.facets.visible(wo, u);
        let cos = wo.dot(facet).clamp(0.0, 1.0);
        let there = dielectric(cos, eta);
        // ∂ω_i/∂ω_m.
        let (wi, spread) = if through {
            let squeezed = ((1.0 - eta * eta) / (cos + eta * there.cos_t)).powi(2);
            (refracted(wo, facet, cos, eta, there), squeezed / (eta * eta * there.cos_t))
        } else {
            (reflected(wo, facet, cos), 4.0 * cos)
        };
        let is_sent = cos > 0.0 && (!through || there.cos_t > 0.0) && (wi.z < 0.0) == through;
        is_sent.then(|| (wi, spread / visible_density(&self.facets, wo, facet)))
    }
}

fn fits<N: Number>(model: &dyn Bsdf<N>, square: &impl Square, wo: Vector<f64>, draws: u64, address: &str) -> f64 {
    let rounded = Vector::<N>::of(wo.lane(0));
    let is_inside = wo.z < 0.0;
    let rejected = if model.character().transmits { 2 } else { 1 } * SIDE * SIDE;
    let mut counts = vec![0_u64; rejected + 1];
    let (mut random, mut within) = (stream(32, address), stream(34, address));
    for _ in 0..draws {
        let sample = model.sample(rounded, [(); 3].map(|()| N::of(throw(&mut random)).min(N::of(1.0 - N::EPSILON))));
        let any = sample.wi.lane(0).map(|x| x + spacing::<N>(x) * (throw(&mut within) - 0.5));
        let wi = Vector::of(any).flipped(is_inside);
        let at = square.place(wi).map(|u| ((u.rem_euclid(1.0) * SIDE as f64) as usize).min(SIDE - 1));
        let bin = (usize::from(wi.z < 0.0) * SIDE + at[0]) * SIDE + at[1];
        counts[if sample.pdf.lane(0) > 0.0 { bin } else { rejected }] += 1;
    }
    let density = |through: bool, u: [f64; 2]| match square.direction(through, u) {
        None => 0.0,
        Some((wi, area)) => model.pdf(Vector::of(wi.flipped(is_inside).lane(0)), rounded).lane(0) * area,
    };
    let mut expected: Vec<f64> = (0..rejected).map(|bin| mean(|u| density(bin / (SIDE * SIDE) == 1, u), bin)).collect();
    // Slivers of bins go with what is rejected: the rule may take them for empty, and then one count would be impossible.
    for bin in 0..rejected {
        if expected[bin] * (draws as f64) < LEAST_EXPECTED {
            counts[rejected] += std::mem::take(&mut counts[bin]);
            expected[bin] = 0.0;
        }
    }
    let left = 1.0 - expected.iter().sum::<f64>();
    let found = counts[rejected] as f64 / draws as f64;
    expected.push(found.max(left - RULE).min(left + RULE).max(0.0));
    chi_square(&counts, &expected.iter().map(|share| share * draws as f64).collect::<Vec<_>>()).p
}

/// The distance of a width's numbers near `x`.
fn spacing<N: Number>(x: f64) -> f64 {
    x.abs().log2().floor().exp2() * N::EPSILON
}

/// The integral over one bin of the square: a few points where the bin's rim shows it even, many where it has an edge.
fn mean(f: impl Fn([f64; 2]) -> f64, bin: usize) -> f64 {
    let corner = [bin / SIDE % SIDE, bin % SIDE];
    let at = |x: f64, y: f64| f([x, y].map(|u| u.clamp(1e-12, 1.0 - 1e-12)));
    let place = |part: f64, axis: usize| (corner[axis] as f64 + part) / SIDE as f64;
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for k in 0..=RIM {
        let part = f64::from(k) / f64::from(RIM);
        for (x, y) in [(part, 0.0), (part, 1.0), (0.0, part), (1.0, part), (part, 0.5), (part, part)] {
            let here = at(place(x, 0), place(y, 1));
            (least, most) = (least.min(here), most.max(here));
        }
    }
    // A golden lattice: an edge that runs along a grid's rows would miss or take whole rows. It converges as the square of
    // their number where nothing jumps. 48² of them leave 0.1 % of a bin that a straight edge cuts anywhere (the root mean
    // square over such edges; 1 % at worst), where two hundred counts scatter by 7 %; of fifty such bins an eighth of RULE.
    let points = if most <= 1.02 * least {
        16
    } else if most <= 4.0 * least {
        24 * 24
    } else {
        48 * 48
    };
    let mut sum = 0.0;
    for k in 0..points {
        let [x, y] = golden(k, points);
        sum += at(place(x, 0), place(y, 1));
    }
    sum / (points * SIDE * SIDE) as f64
}

/// Intervals along a bin's rim.
const RIM: i32 = 16;

/// The largest |f(wi → wo)/n_o² ÷ f(wo → wi)/n_i² − 1| [1] over pairs that `model` itself draws, and where.
pub fn reciprocity(model: &dyn Bsdf<f64>, wo: Vector<f64>, draws: u64, address: &str) -> (f64, Vector<f64>) {
    let mut random = stream(33, address);
    let mut worst = (0.0, wo);
    for _ in 0..draws {
        let sample = model.sample(wo, [(); 3].map(|()| throw(&mut random)));
        if sample.pdf > 0.0 {
            let (there, back) = (model.eval(sample.wi, wo)[0], model.eval(wo, sample.wi)[0] * sample.compression);
            let off = (back / there - 1.0).abs();
            if (off > worst.0 || off.is_nan()) && (there, back) != (0.0, 0.0) {
                worst = (off, sample.wi);
            }
        }
    }
    worst
}
