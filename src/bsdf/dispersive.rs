//! Polished glass whose index depends on the wavelength: what it does to a path that knows of no wavelength so far.
//!
//! A path carries three channels, and channel c means ∫r_c(λ) … dλ ([`crate::colour::response`]). Where all wavelengths go the
//! same way it needs to know no more. What passes a dispersing interface goes many ways at once, and one of them is drawn:
//! a wavelength with a density p, by which the channels weigh r_c(λ)/p(λ). This is hero wavelength sampling (A. Wilkie et al.,
//! *Hero wavelength spectral sampling*, CGF 33(4) (2014) 123) where it leaves the hero alone: at a delta no other wavelength
//! would have gone its way. From then on the path keeps it.
//!
//! What is reflected from outside goes one way, whatever the wavelength, only not as much of each: the channels keep their
//! means R̄_c = ∫r_c R dλ, and no wavelength is seen. That is exact once; of two such events the mean of the product counts, not
//! the product of means. So a wavelength is drawn at the first event all the same, and what it would have changed is *owed*:
//! r_c(λ)R(λ)/(p(λ)R̄_c), 1 on average, which the next dispersing event makes good. Which way a path goes is drawn by the
//! reflectance at one index, as long as no wavelength is reflected in total; elsewhere by that of the wavelength.

use super::fresnel::dielectric;
use super::guard::is_fit;
use super::losses::Neighbours;
use super::smooth::either;
use super::{Rgb, Sample, grey, rgb};
use crate::colour::response::{BAND, response};
use crate::number::{Mask, Table, Vector, Width, vectorised_lanes};

/// What a path knows of its wavelength.
#[derive(Clone, Copy, Debug)]
pub struct Hue<N: Width> {
    /// In vacuum [nm]; 0 as long as none is drawn.
    pub wavelength: N,
    /// What the next dispersing event has to make good [1].
    pub owed: Rgb<N>,
}

impl<N: Width> Hue<N> {
    /// Of a path that has met nothing that disperses.
    #[inline(always)]
    pub fn none() -> Self {
        Self { wavelength: N::of(0.0), owed: grey(N::of(1.0)) }
    }

    /// Of a path of one wavelength [m] from the start.
    pub fn of(wavelength: f64) -> Self {
        Self { wavelength: N::of(wavelength * NANOMETRES), ..Self::none() }
    }

    /// `yes` where the mask is true, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: N::Mask, yes: Self, no: Self) -> Self {
        Self {
            wavelength: N::select(mask, yes.wavelength, no.wavelength),
            owed: rgb(|c| N::select(mask, yes.owed[c], no.owed[c])),
        }
    }
}

/// In a metre.
const NANOMETRES: f64 = 1e9;
/// Nodes of an index over the wavelength, 2 nm apart, and of mean reflectances over the cosine.
const WAVELENGTHS: usize = 191;
const COSINES: usize = 64;
/// The least index [1], at any wavelength, of glass that reflects without a wavelength: about that of air, nothing is reflected
/// at one of them and something at others.
const LEAST: f64 = 1.05;
/// The sodium line's neighbour d [m], at which catalogues give n.
pub const D_LINE: f64 = 587.561_8e-9;

/// Polished glass that disperses.
#[derive(Clone, Debug)]
pub struct Dispersive {
    /// n [1] over that outside, over the wavelength.
    index: Table,
    /// That of the d line.
    middle: f64,
    /// R̄_c over the reflectance at the d line, from outside, over the cosine; None where that is no way to choose.
    means: Option<[Table; 3]>,
}

impl Dispersive {
    /// Of its index [1], over that outside, at a wavelength [m] in [`BAND`].
    pub fn new(index: impl Fn(f64) -> f64) -> Self {
        let step = (BAND[1] - BAND[0]) / (WAVELENGTHS - 1) as f64;
        let all: Vec<f64> = (0..WAVELENGTHS).map(|k| index(BAND[0] + step * k as f64)).collect();
        let middle = index(D_LINE);
        let is_denser = all.iter().all(|n| *n >= LEAST);
        let mean = |at: usize| {
            // R at grazing is 1 at any index.
            let cos = at as f64 / (COSINES - 1) as f64;
            let whole = dielectric(cos, middle).reflectance;
            response().mean(|wavelength| dielectric(cos, index(wavelength)).reflectance / whole)
        };
        let means = is_denser.then(|| {
            let rows: Vec<Rgb<f64>> = (0..COSINES).map(mean).collect();
            [0, 1, 2].map(|c| Table::new(rows.iter().map(|row| row[c]).collect()))
        });
        // A medium whose index leaps within the band is better asked wavelength by wavelength.
        let means = means.filter(|means| means.iter().all(|mean| mean.iter().all(|x| *x > 0.5 && *x < 2.0)));
        Self { index: Table::new(all.into()), middle, means }
    }

    /// n [1] over that outside at a wavelength [nm] in the band.
    #[inline(always)]
    pub fn index<N: Width>(&self, wavelength: N) -> N {
        let per_node = (WAVELENGTHS - 1) as f64 / ((BAND[1] - BAND[0]) * NANOMETRES);
        let place = (wavelength - N::of(BAND[0] * NANOMETRES)) * N::of(per_node);
        Neighbours::of(place.clamp(0.0, (WAVELENGTHS - 1) as f64), WAVELENGTHS).mean(&self.index, N::of(0.0))
    }

    /// That of the d line.
    pub fn middle(&self) -> f64 {
        self.middle
    }

    /// A direction for light that goes to `wo` to come from, by three numbers 0 ≤ u < 1 and one for the wavelength, which is drawn
    /// where there is none; and what the path knows after that.
    #[inline(never)]
    pub fn sample<N: Width>(
        &self,
        active: N::Mask,
        wo: Vector<N>,
        u: [N; 3],
        number: N,
        hue: Hue<N>,
    ) -> (Sample<N>, Hue<N>) {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.drawn(active, wo, u, number, hue),
        )
    }

    #[inline(always)]
    fn drawn<N: Width>(
        &self,
        active: N::Mask,
        wo: Vector<N>,
        u: [N; 3],
        number: N,
        hue: Hue<N>,
    ) -> (Sample<N>, Hue<N>) {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let fresh = active & hue.wavelength.le(zero);
        let [drawn, red, green, blue] = if fresh.any() { wavelengths(fresh, number) } else { [zero; 4] };
        let wavelength = N::select(fresh, drawn, hue.wavelength);
        let colour = [red, green, blue];

        let is_inside = wo.z.lt(zero);
        let cos = wo.z.abs().min(one);
        let index = self.index(wavelength);
        let eta = N::select(is_inside, one / index, index);
        let there = dielectric(cos, eta);
        // The chance to be reflected, and what either way weighs, but for the wavelength.
        let (mut chance, mut reflected, mut passed) = (there.reflectance, one, one);
        let mut mean = grey(one);
        let mut is_lazy = N::Mask::of(false);
        if let Some(means) = &self.means {
            is_lazy = fresh & !is_inside;
            if is_lazy.any() {
                let middle = dielectric(cos, N::of(self.middle)).reflectance;
                let least = N::of(f64::from(f32::MIN_POSITIVE));
                chance = N::select(is_lazy, middle, chance);
                reflected = N::select(is_lazy, there.reflectance / middle.max(least), one);
                passed = N::select(is_lazy, (one - there.reflectance) / (one - middle).max(least), one);
                let near = Neighbours::of(cos * N::of((COSINES - 1) as f64), COSINES);
                mean = rgb(
                    #[inline(always)]
                    |c| N::select(is_lazy, near.mean(&means[c], zero), one),
                );
            }
        }
        let is_transmitted = u[2].ge(chance);
        let made_good = rgb(
            #[inline(always)]
            |c| N::select(fresh, colour[c], hue.owed[c]),
        );
        let of_mean = is_lazy & !is_transmitted;
        let shares = [
            rgb(
                #[inline(always)]
                |c| N::select(is_lazy, mean[c], made_good[c]),
            ),
            rgb(
                #[inline(always)]
                |c| made_good[c] * passed,
            ),
        ];
        let owed = rgb(
            #[inline(always)]
            |c| N::select(of_mean, colour[c] * reflected / mean[c], one),
        );
        let sample = either(wo, [eta, there.cos_t], is_transmitted, shares);
        // What grazes too closely is lost, as behind every model's gate.
        (sample.only(is_fit(wo) & is_fit(sample.wi)), Hue { wavelength, owed })
    }
}

/// Wavelengths [nm] and what the channels weigh at them, by a number 0 ≤ u < 1; 0 where the mask is false.
#[inline(never)]
fn wavelengths<N: Width>(fresh: N::Mask, number: N) -> [N; 4] {
    N::columns(|lane| {
        if !fresh.lane(lane) {
            return [N::Scalar::default(); 4];
        }
        let drawn = response().draw(number.lane(lane));
        let [red, green, blue] = drawn.weight;
        [drawn.wavelength * NANOMETRES, red, green, blue].map(|x| N::of(x).get(0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::media::named;
    use crate::number::{F32x8, Number};
    use crate::optics::Incidence;
    use crate::optics::fresnel::powers;

    fn glass(name: &str) -> (Dispersive, impl Fn(f64) -> f64 + use<>) {
        let medium = named(name).expect("a glass");
        let index = |wavelength: f64| medium.index(wavelength).expect("known in the band").re;
        (Dispersive::new(index), index)
    }

    #[test]
    fn the_index_is_that_of_the_medium() {
        for name in ["bk7", "sf11", "diamond", "water", "fused-silica", "sapphire"] {
            let (table, index) = glass(name);
            for nm in [380.0, 381.3, 404.7, 486.1, 587.6, 656.3, 759.9, 760.0] {
                let off = table.index(nm) - index(nm * 1e-9);
                assert!(off.abs() < 1e-7, "{name} at {nm} nm: {off:.1e} off");
            }
        }
    }

    fn way(cos: f64) -> Vector<f64> {
        Vector::new((1.0 - cos * cos).sqrt(), 0.0, cos)
    }

    /// What is reflected and what passes on average, by channel, over numbers for choice and wavelength.
    fn means(table: &Dispersive, wo: Vector<f64>) -> [[f64; 3]; 2] {
        let side = 512;
        let mut sums = [[0.0; 3]; 2];
        for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
            let [u, v] = [i, j].map(|k| (f64::from(k) + 0.5) / f64::from(side));
            let (sample, _) = table.sample(true, wo, [0.5, 0.5, u], v, Hue::none());
            let sum = &mut sums[usize::from(sample.is_transmitted)];
            *sum = rgb(|c| sum[c] + sample.weight[c] / sample.compression / f64::from(side * side));
        }
        sums
    }

    /// The same of what has been reflected once and goes on.
    fn means_of_two(table: &Dispersive, first: Vector<f64>, second: Vector<f64>) -> [[f64; 3]; 2] {
        const COUNTS: [u32; 3] = [512, 1024, 256];
        let all = f64::from(COUNTS[0]) * f64::from(COUNTS[1]) * f64::from(COUNTS[2]);
        let mut sums = [[0.0; 3]; 2];
        for wavelength in 0..COUNTS[0] {
            // Choices are even, and moved from one wavelength to the next.
            let moved = (0.618_033_988_75 * f64::from(wavelength)).fract();
            let choice = |k: u32, count: u32| (f64::from(k) + moved) / f64::from(count);
            let number = (f64::from(wavelength) + 0.5) / f64::from(COUNTS[0]);
            for one in 0..COUNTS[1] {
                let u = [0.5, 0.5, choice(one, COUNTS[1])];
                let (sample, hue) = table.sample(true, first, u, number, Hue::none());
                if sample.is_transmitted {
                    continue;
                }
                for other in 0..COUNTS[2] {
                    let u = [0.5, 0.5, choice(other, COUNTS[2])];
                    let (next, _) = table.sample(true, second, u, 0.5, hue);
                    let sum = &mut sums[usize::from(next.is_transmitted)];
                    *sum = rgb(|c| sum[c] + sample.weight[c] * next.weight[c] / next.compression / all);
                }
            }
        }
        sums
    }

    #[test]
    fn each_channel_gets_its_share_on_average() {
        // Against E36–E43 wavelength by wavelength: outside, inside, beyond the critical angle of some wavelengths and not of others.
        for (name, cos) in [("sf11", 1.0), ("sf11", 0.3), ("diamond", 0.05), ("diamond", -0.95), ("sf11", -0.8273)] {
            let (table, index) = glass(name);
            let found = means(&table, way(cos));
            let share = |wavelength: f64| {
                let n = index(wavelength);
                let (n_i, n_t) = if cos > 0.0 { (1.0, n) } else { (n, 1.0) };
                powers(Incidence::from_cos(cos.abs()), n_i, n_t.into()).r_n()
            };
            let exact = response().mean(share);
            for c in 0..3 {
                let off = [found[0][c] - exact[c], found[1][c] - (1.0 - exact[c])];
                assert!(off.iter().all(|off| off.abs() < 4e-3), "{name} {cos} {c}: {off:?}");
            }
        }
        // At the last cosine red passes and blue does not.
        let (_, index) = glass("sf11");
        let critical = |nm: f64| (1.0 - index(nm * 1e-9).powi(-2)).sqrt();
        assert!(critical(656.3) < 0.8273 && critical(486.1) > 0.8273, "{} {}", critical(656.3), critical(486.1));
    }

    #[test]
    fn of_two_events_the_mean_of_the_product_counts() {
        // Reflected twice, or reflected and then let through, by a medium whose index varies enough for the product of means to be
        // another number.
        let index = |wavelength: f64| 1.1 + 1.2 * ((wavelength - 380e-9) / 380e-9);
        let table = Dispersive::new(index);
        assert!(table.means.is_none(), "an index that leaps is asked wavelength by wavelength");
        let index = |wavelength: f64| 1.6 + 0.12 * (wavelength * 4e7).sin();
        let table = Dispersive::new(index);
        assert!(table.means.is_some());
        let found = means_of_two(&table, way(0.8), way(0.9));
        let r = |cos: f64, l: f64| powers(Incidence::from_cos(cos), 1.0, index(l).into()).r_n();
        let both = response().mean(|l| r(0.8, l) * r(0.9, l));
        let through = response().mean(|l| r(0.8, l) * (1.0 - r(0.9, l)));
        let apart: Vec<f64> =
            (0..3).map(|c| response().mean(|l| r(0.8, l))[c] * response().mean(|l| r(0.9, l))[c] - both[c]).collect();
        for c in 0..3 {
            assert!((found[0][c] - both[c]).abs() < 3e-5, "{c}: {} {}", found[0][c], both[c]);
            assert!((found[1][c] - through[c]).abs() < 3e-4, "{c}: {} {}", found[1][c], through[c]);
        }
        assert!(apart.iter().any(|off| off.abs() > 1e-4), "{apart:?}");
    }

    #[test]
    fn what_knows_its_wavelength_goes_by_snell_and_keeps_it() {
        let (table, index) = glass("sf11");
        for nm in [400.0, 550.0, 700.0] {
            let wo = way(0.6);
            let known = Hue::of(nm * 1e-9);
            let (sample, hue) = table.sample(true, wo, [0.5, 0.5, 0.99], 0.3, known);
            assert!(sample.is_transmitted && hue.wavelength == known.wavelength && hue.owed == [1.0; 3]);
            assert!((sample.wi.x * index(nm * 1e-9) + wo.x).abs() < 1e-7, "{nm}");
            let n2 = index(nm * 1e-9).powi(2);
            assert!(sample.weight.iter().all(|w| (w * n2 - 1.0).abs() < 1e-6), "{:?}", sample.weight);
        }
    }

    #[test]
    fn lanes_are_alike() {
        let (table, _) = glass("bk7");
        let u = |k: usize, lane: usize| ((k * 8 + lane) as f32 * 0.377).fract();
        let wo = |lane: usize| if lane.is_multiple_of(2) { way(0.5) } else { way(-0.9) };
        let each = |k: usize| F32x8::each(|lane| u(k, lane));
        let part = |of: fn(Vector<f64>) -> f64| F32x8::each(|lane| of(wo(lane)) as f32);
        let all = Vector::new(part(|w| w.x), part(|w| w.y), part(|w| w.z));
        let active = each(9).ge(F32x8::of(0.0));
        let (wide, hue) = table.sample(active, all, [each(0), each(1), each(2)], each(3), Hue::none());
        for lane in 0..8 {
            let own = Vector::new(wo(lane).x as f32, 0.0, wo(lane).z as f32);
            let (one, its) =
                table.sample(true, own, [u(0, lane), u(1, lane), u(2, lane)], u(3, lane), Hue::<f32>::none());
            assert_eq!(f64::from(its.wavelength), hue.wavelength.lane(lane));
            for c in 0..3 {
                assert_eq!(f64::from(one.weight[c]), wide.weight[c].lane(lane), "{lane} {c}");
                assert_eq!(f64::from(its.owed[c]), hue.owed[c].lane(lane), "{lane} {c}");
            }
            assert_eq!(one.wi.x as f64, wide.wi.x.lane(lane));
        }
    }
}
