//! Metal and polished glass under a film of one thickness: the colours of coated lenses, of oil on water, of tempered steel.
//!
//! A channel stands for a band of wavelengths, those that are nearest to its own ([`CHANNELS`]). What it reflects and lets
//! through is the mean of natural light over its band, by [`crate::optics::film`], tabulated over the cosine. A film of many
//! waves has no colours for that reason: the band holds many of its fringes. Indices do not disperse within a band.

use super::fresnel::{Reflecting, dielectric};
use super::losses::Neighbours;
use super::smooth::{CHARACTER, either, nothing};
use super::{Bsdf, Character, Rgb, Sample, rgb};
use crate::Polarisation;
use crate::media::CHANNELS;
use crate::number::{Mask, Number, Table, Vector};
use crate::optics::Incidence;
use crate::optics::film::{Layer, Powers, Stack};
use num_complex::Complex64;

/// A film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Film {
    /// n + iκ [1] over the index outside, in three channels; n > 0 and κ ≥ 0.
    pub index: [Complex64; 3],
    /// Thickness [m], times the index outside; 0 is none.
    pub thickness: f64,
}

/// Nodes along the cosine: the fringes that a band leaves to see are some tens of radians long at most.
const NODES: usize = 256;
/// Wavelengths of a band, at least, at most, and for each of its fringes.
const WAVELENGTHS: [f64; 2] = [48.0, 4096.0];
const PER_FRINGE: f64 = 16.0;

/// Stands for an index of 0 [1].
const LEAST: f64 = 1e-6;

/// The ends [m] of a channel's band: halfway to its neighbours, and as far beyond the last as before it.
pub fn band(channel: usize) -> [f64; 2] {
    let [red, green, blue] = CHANNELS;
    let (short, long) = ((blue + green) / 2.0, (green + red) / 2.0);
    [[long, 2.0 * red - long], [short, long], [2.0 * blue - short, short]][channel]
}

impl Film {
    /// Wavelengths [m] that stand for a channel's band.
    fn wavelengths(&self, channel: usize) -> Vec<f64> {
        let [short, long] = band(channel);
        let fringes = 2.0 * self.index[channel].re * self.thickness * (1.0 / short - 1.0 / long);
        let count = (PER_FRINGE * fringes).clamp(WAVELENGTHS[0], WAVELENGTHS[1]) as usize;
        (0..count).map(|k| short + (long - short) * (k as f64 + 0.5) / count as f64).collect()
    }
}

/// One side of a coated surface: what becomes of natural light, by channel, over the cosine.
#[derive(Clone, Debug)]
struct Side {
    /// Index [1] behind over that before, where there is a critical angle.
    critical: Option<f64>,
    reflected: [Table; 3],
    passed: [Table; 3],
}

impl Side {
    /// Before a half-space, one index a channel, seen from a clear medium.
    fn new(n_i: f64, film: &Film, behind: [Complex64; 3]) -> Self {
        let eta = behind[0].re / n_i;
        let critical = Some(eta).filter(|eta| *eta < 1.0 && behind.iter().all(|index| index.im == 0.0));
        let cosines: Vec<f64> = (0..if critical.is_some() { 2 * NODES } else { NODES })
            .map(|node| cosine(critical, node / NODES == 1, (node % NODES) as f64 / (NODES - 1) as f64))
            .collect();
        let tables = [0, 1, 2].map(|channel| {
            let layers = [Layer { index: film.index[channel], thickness: film.thickness }];
            let stack = Stack { n_i, layers: &layers, substrate: behind[channel] };
            let wavelengths = film.wavelengths(channel);
            cosines.iter().map(|cos| natural(&stack, Incidence::from_cos(*cos), &wavelengths)).collect::<Vec<_>>()
        });
        let of = |part: fn(&[f64; 2]) -> f64| [0, 1, 2].map(|c| Table::new(tables[c].iter().map(part).collect()));
        Self { critical, reflected: of(|powers| powers[0]), passed: of(|powers| powers[1]) }
    }

    /// R and T [1] at 0 ≤ `cos` ≤ 1.
    #[inline(always)]
    fn at<N: Number>(&self, cos: N) -> [Rgb<N>; 2] {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let (row, x) = match self.critical {
            None => (zero, cos.min(one)),
            Some(eta) => {
                // η² cos² θ_t, which is below 0 beyond the critical angle.
                let dark = (1.0 - eta) * (1.0 + eta);
                let through = cos.squared() - N::of(dark);
                let is_total = through.lt(zero);
                let beyond = (through * N::of(-1.0 / dark)).max(zero).sqrt();
                let before = (through * N::of(1.0 / (eta * eta))).max(zero).sqrt();
                let beyond = beyond / (beyond + cos * N::of(1.0 / dark.sqrt()));
                (N::of(NODES as f64).only(is_total), N::select(is_total, beyond, before).min(one))
            }
        };
        let near = Neighbours::of(x * N::of((NODES - 1) as f64), NODES);
        let share = |tables: &[Table; 3]| {
            rgb(
                #[inline(always)]
                |c| near.mean(&tables[c], row).max(zero).min(one),
            )
        };
        [share(&self.reflected), share(&self.passed)]
    }
}

/// The cosine of a place 0 ≤ x ≤ 1 in a table: itself; or where there is a critical angle θ_c, by cos θ_t below it, and
/// beyond by a/(a + b) with b = cos θ/cos θ_c and a² + b² = 1, which is |cos θ_t| at the one end and the cosine at the other: so
/// all is smooth.
fn cosine(critical: Option<f64>, is_total: bool, x: f64) -> f64 {
    let Some(eta) = critical else { return x };
    let dark = (1.0 - eta) * (1.0 + eta);
    let square =
        if is_total { dark * (1.0 - x).powi(2) / (x * x + (1.0 - x).powi(2)) } else { dark + (eta * x).powi(2) };
    square.sqrt().min(1.0)
}

/// R and T [1] of natural light, the mean over wavelengths.
fn natural(stack: &Stack, incidence: Incidence, wavelengths: &[f64]) -> [f64; 2] {
    let nothing = Powers { reflectance: 0.0, transmittance: 0.0, absorptance: 0.0 };
    let mut powers = vec![nothing; wavelengths.len()];
    let mut sums = [0.0; 2];
    for polarisation in [Polarisation::S, Polarisation::P] {
        stack.waves(incidence, polarisation).powers(wavelengths, &mut powers);
        for one in &powers {
            sums = [sums[0] + one.reflectance, sums[1] + one.transmittance];
        }
    }
    sums.map(|sum| sum / (2 * wavelengths.len()) as f64)
}

/// Metal under a film.
#[derive(Clone, Debug)]
pub struct CoatedMetal(Side);

impl CoatedMetal {
    /// Of its indices [1] over that outside, in three channels.
    pub fn new(film: &Film, metal: [Complex64; 3]) -> Self {
        // ε = 0 is a limit that a stack does not take.
        Self(Side::new(1.0, film, metal.map(|index| if index == Complex64::ZERO { LEAST.into() } else { index })))
    }
}

impl<N: Number> Reflecting<N> for CoatedMetal {
    #[inline(always)]
    fn reflectance(&self, cos_i: N) -> Rgb<N> {
        let [reflected, _] = self.0.at(cos_i);
        reflected
    }
}

/// Polished glass under a film, seen from either side.
#[derive(Clone, Debug)]
pub struct CoatedDielectric {
    index: f64,
    outside: Side,
    inside: Side,
}

impl CoatedDielectric {
    /// Of its index [1] over that outside.
    pub fn new(film: &Film, index: f64) -> Self {
        let side = |before: f64, behind: f64| Side::new(before, film, [behind.into(); 3]);
        Self { index, outside: side(1.0, index), inside: side(index, 1.0) }
    }

    /// R and T [1] of what goes to `wo`.
    #[inline(always)]
    fn shares<N: Number>(&self, wo: Vector<N>) -> [Rgb<N>; 2] {
        let (is_inside, cos) = (wo.z.lt(N::of(0.0)), wo.z.abs());
        let [reflected, passed] = self.outside.at(cos);
        if !is_inside.any() {
            return [reflected, passed];
        }
        let [back, out] = self.inside.at(cos);
        [rgb(|c| N::select(is_inside, back[c], reflected[c])), rgb(|c| N::select(is_inside, out[c], passed[c]))]
    }
}

impl<N: Number> Bsdf<N> for CoatedDielectric {
    fn character(&self) -> Character {
        // The three channels share a choice, so that one of them may carry the weight of all.
        Character { transmits: true, largest_weight: 3.0, ..CHARACTER }
    }

    #[inline(always)]
    fn eval_pdf(&self, _: Vector<N>, _: Vector<N>) -> (Rgb<N>, N) {
        nothing()
    }

    #[inline(always)]
    fn sample(&self, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let one = N::of(1.0);
        let [reflected, passed] = self.shares(wo);
        // T is the same from both sides, which R is not where the film absorbs: light that runs the other way has the same choice.
        let through = (passed[0] + passed[1] + passed[2]) * N::of(1.0 / 3.0);
        let is_transmitted = u[2].ge(one - through);
        let eta = N::select(wo.z.lt(N::of(0.0)), N::of(1.0 / self.index), N::of(self.index));
        let odds = N::select(is_transmitted, through, one - through).max(N::of(f64::from(f32::MIN_POSITIVE)));
        let there = dielectric(wo.z.abs().min(one), eta);
        let shares = [rgb(|c| reflected[c] / odds), rgb(|c| passed[c] / odds)];
        either(wo, [eta, there.cos_t], is_transmitted, shares)
    }

    #[inline(always)]
    fn albedo(&self, wo: Vector<N>) -> Option<Rgb<N>> {
        let [reflected, passed] = self.shares(wo);
        Some(rgb(|c| reflected[c] + passed[c]))
    }
}
