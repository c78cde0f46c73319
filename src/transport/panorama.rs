//! An image all around as a lamp: directions to where it is bright.
//!
//! A texel is drawn by its radiance, all channels together, times its solid angle; its row first, then its column in that row. Within
//! it all directions are alike, so that the density is the texel's radiance over the integral of all, exactly, and black texels are
//! never drawn (M. Pharr, W. Jakob and G. Humphreys, *Physically Based Rendering* (4th ed., 2023), §12.5).

use crate::bsdf::{Rgb, rgb};
use crate::number::{Mask, Width};
use crate::sampling::Shares;
use crate::scene::Sky;
use crate::scene::image::edge;
use std::f64::consts::TAU;

/// A sky that is not black, ready to be drawn from.
#[derive(Clone, Debug)]
pub struct Panorama {
    sky: Sky,
    rows: Shares,
    /// Of each row; None where that is black.
    columns: Vec<Option<Shares>>,
}

/// A direction, and what there is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Of length 1.
    pub direction: [f64; 3],
    /// Radiance [W m⁻² sr⁻¹] from there.
    pub radiance: Rgb<f64>,
    /// The density [sr⁻¹] of being drawn.
    pub pdf: f64,
}

impl Panorama {
    /// Of a sky; None if it is black.
    pub fn new(sky: &Sky) -> Option<Self> {
        if sky.scale == 0.0 {
            return None;
        }
        let [width, height] = sky.image.size();
        let each = TAU / f64::from(width);
        let row = |row: u32| {
            let texels = sky.image.texels()[row as usize * width as usize..].iter().take(width as usize);
            let shares = Shares::new(texels.map(|texel| sum(texel.map(f64::from)) * sky.scale));
            let weight = shares.as_ref().map_or(0.0, Shares::whole);
            (weight * each * (edge(row, height) - edge(row + 1, height)), shares)
        };
        let (weights, columns): (Vec<f64>, Vec<_>) = (0..height).map(row).unzip();
        Some(Self { sky: sky.clone(), rows: Shares::new(weights)?, columns })
    }

    /// ∫L dω [W m⁻²] over all directions, all channels together.
    pub fn whole(&self) -> f64 {
        self.rows.whole()
    }

    /// A direction drawn by two numbers 0 ≤ u < 1.
    // ANCHOR: panorama
    pub fn draw(&self, [u, v]: [f64; 2]) -> Look {
        let [width, height] = self.sky.image.size();
        let (row, down) = self.rows.pick(u);
        let columns = self.columns[row].as_ref().expect("a row that is drawn is not black");
        let (column, right) = columns.pick(v);
        let row = row as u32;
        let [above, below] = [edge(row, height), edge(row + 1, height)];
        let direction = self.sky.direction((column as f64 + right) / f64::from(width), above + (below - above) * down);
        let radiance = self.sky.radiance([column as u32, row]);
        Look { direction, radiance, pdf: sum(radiance) / self.whole() }
    }

    /// What a direction of any length but 0 looks at.
    pub fn look(&self, direction: [f64; 3]) -> Look {
        let radiance = self.sky.radiance(self.sky.texel(direction));
        Look { direction, radiance, pdf: sum(radiance) / self.whole() }
    }
    // ANCHOR_END: panorama

    /// Directions drawn lane by lane, radiance over density [W m⁻²], and density.
    #[inline(never)]
    pub(super) fn drawn<N: Width>(&self, [u, v]: [N; 2]) -> ([N; 3], Rgb<N>, N) {
        let rows = N::columns(|lane| {
            let Look { direction: [x, y, z], radiance, pdf } = self.draw([u.lane(lane), v.lane(lane)]);
            let [red, green, blue] = radiance.map(|radiance| radiance / pdf);
            [x, y, z, red, green, blue, pdf].map(|part| N::of(part).get(0))
        });
        let [x, y, z, red, green, blue, pdf] = rows;
        ([x, y, z], [red, green, blue], pdf)
    }

    /// Radiance [W m⁻² sr⁻¹] and density [sr⁻¹] in the directions of lanes; 0 where the mask is false.
    #[inline(never)]
    pub(super) fn looked<N: Width>(&self, [x, y, z]: [N; 3], active: N::Mask) -> (Rgb<N>, N) {
        let rows = N::columns(|lane| {
            if !active.lane(lane) {
                return [0.0; 4].map(|part| N::of(part).get(0));
            }
            let look = self.look([x, y, z].map(|part| part.lane(lane)));
            let [red, green, blue] = look.radiance;
            [red, green, blue, look.pdf].map(|part| N::of(part).get(0))
        });
        (rgb(|c| rows[c]), rows[3])
    }
}

fn sum([red, green, blue]: Rgb<f64>) -> f64 {
    red + green + blue
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Image;
    use std::f64::consts::PI;
    use std::sync::Arc;
    use yardstick::random::{stream, uniform};
    use yardstick::statistics::{chi_square, sidak};

    /// The chance that any one of these tests fails though nothing is wrong.
    const SIGNIFICANCE: f64 = 1e-4;

    fn sky([width, height]: [u32; 2], rotate_deg: f64, texel: impl Fn([u32; 2]) -> [f32; 3]) -> Sky {
        let texels = (0..height).flat_map(|row| (0..width).map(move |column| [column, row])).map(texel).collect();
        let image = Arc::new(Image::new([width, height], texels).expect("as many"));
        Sky { file: None, image, scale: 0.5, rotate_deg }
    }

    /// Of all brightnesses: black rows and texels, a sun, and everything between.
    fn uneven(size: [u32; 2], rotate_deg: f64) -> Sky {
        sky(size, rotate_deg, |[column, row]| match (column * 7 + row * 13) % 11 {
            _ if row == 1 => [0.0; 3],
            0 | 4 => [0.0; 3],
            5 if row == 2 => [90.0, 80.0, 70.0],
            k => [k as f32, 0.0, 0.25 * k as f32],
        })
    }

    /// Middles of cells, each texel being `parts`² of them, and their solid angles [sr]: told by their latitude and longitude
    /// alone.
    fn cells([width, height]: [u32; 2], parts: u32, rotate_deg: f64) -> Vec<([f64; 3], f64)> {
        let [across, down] = [width * parts, height * parts];
        let cell = |k: u32| {
            let theta = PI * (f64::from(k / across) + 0.5) / f64::from(down);
            let longitude = PI - TAU * (f64::from(k % across) + 0.5) / f64::from(across) + rotate_deg.to_radians();
            let half = 0.5 * PI / f64::from(down);
            let solid = TAU / f64::from(across) * 2.0 * theta.sin() * half.sin();
            ([theta.sin() * longitude.sin(), theta.cos(), theta.sin() * longitude.cos()], solid)
        };
        (0..across * down).map(cell).collect()
    }

    /// Which of these cells a direction lies in.
    fn cell([width, height]: [u32; 2], parts: u32, rotate_deg: f64, [x, y, z]: [f64; 3]) -> usize {
        let [across, down] = [width * parts, height * parts];
        let turned = (0.5 - (x.atan2(z) - rotate_deg.to_radians()) / TAU).rem_euclid(1.0);
        let column = ((turned * f64::from(across)) as u32).min(across - 1);
        let row = ((y.clamp(-1.0, 1.0).acos() / PI * f64::from(down)) as u32).min(down - 1);
        (row * across + column) as usize
    }

    /// The chance of counts as bad as those of draws, if their density is that.
    fn fits(panorama: &Panorama, size: [u32; 2], rotate_deg: f64, density: impl Fn([f64; 3]) -> f64) -> f64 {
        let mut numbers = stream(7, "panorama");
        let draws = 60_000;
        let cells = cells(size, 2, rotate_deg);
        let mut counts = vec![0; cells.len()];
        for _ in 0..draws {
            let u = [uniform(&mut numbers, 0.0, 1.0), uniform(&mut numbers, 0.0, 1.0)];
            counts[cell(size, 2, rotate_deg, panorama.draw(u).direction)] += 1;
        }
        let expected: Vec<f64> = cells.iter().map(|(way, solid)| density(*way) * solid * f64::from(draws)).collect();
        chi_square(&counts, &expected).p
    }

    #[test]
    fn directions_are_drawn_by_their_density_which_integrates_to_one() {
        let skies = [([9, 6], 0.0), ([16, 5], 123.0), ([5, 17], -40.0), ([4, 3], 90.0)];
        for (size, rotate_deg) in skies {
            let sky = uneven(size, rotate_deg);
            let panorama = Panorama::new(&sky).expect("some light");
            let pdf = |direction| panorama.look(direction).pdf;
            let all: f64 = cells(size, 1, rotate_deg).iter().map(|(direction, solid)| pdf(*direction) * solid).sum();
            // A few roundings a texel.
            assert!((all - 1.0).abs() < 1e-12, "{size:?}: {all}");
            let p = fits(&panorama, size, rotate_deg, pdf);
            assert!(p > sidak(SIGNIFICANCE, skies.len()), "{size:?}: p = {p:.1e}");
            // The slip: texels by their radiance alone, as if those at the poles were as large as the others.
            let all: f64 = sky.image.texels().iter().map(|texel| sum(texel.map(f64::from)) * sky.scale).sum();
            let texel = 2.0 * PI * PI / (f64::from(size[0]) * f64::from(size[1]));
            let flat = |direction: [f64; 3]| {
                let sin = (1.0 - direction[1] * direction[1]).sqrt();
                sum(sky.radiance(sky.texel(direction))) / all / (texel * sin)
            };
            let p = fits(&panorama, size, rotate_deg, flat);
            assert!(p < 1e-9, "{size:?}: the slip passed, p = {p:.1e}");
        }
    }

    #[test]
    fn what_is_drawn_is_what_is_seen_there() {
        let sky = uneven([33, 20], 71.0);
        let panorama = Panorama::new(&sky).expect("some light");
        let mut others = 0;
        for k in 0..4096u32 {
            let u = [f64::from(k) / 4096.0, f64::from(k * 1255 % 4096) / 4096.0];
            let drawn = panorama.draw(u);
            assert!(drawn.pdf > 0.0 && drawn.radiance != [0.0; 3]);
            assert!((drawn.direction.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-14);
            let seen = panorama.look(drawn.direction);
            others += u32::from((seen.radiance, seen.pdf) != (drawn.radiance, drawn.pdf));
        }
        // At an edge between two texels rounding may choose either: of so many draws some lie on one, by their numbers.
        assert!(others < 41, "{others} of 4096");
    }

    #[test]
    fn lanes_draw_and_see_what_one_does() {
        use crate::number::{F32x8, Number};
        let panorama = Panorama::new(&uneven([33, 20], 71.0)).expect("some light");
        let mut dim = 0;
        for k in 0..64 {
            let u = F32x8::from_lanes(|lane| f64::from(8 * k + lane as u32) / 512.0);
            let v = F32x8::from_lanes(|lane| f64::from((8 * k + lane as u32) * 157 % 512) / 512.0);
            let (way, share, pdf) = panorama.drawn([u, v]);
            let (radiance, by_look) = panorama.looked(way, F32x8::of(1.0).gt(F32x8::of(0.0)));
            for lane in 0..8 {
                let one = panorama.draw([u.lane(lane), v.lane(lane)]);
                let part = |of: f64| f64::from(of as f32);
                assert_eq!(way.map(|x| x.lane(lane)), one.direction.map(part));
                assert_eq!(share.map(|x| x.lane(lane)), one.radiance.map(|radiance| part(radiance / one.pdf)));
                assert_eq!(pdf.lane(lane), part(one.pdf));
                let seen = panorama.look(way.map(|x| x.lane(lane)));
                assert_eq!(radiance.map(|x| x.lane(lane)), seen.radiance.map(part));
                assert_eq!(by_look.lane(lane), part(seen.pdf));
                dim += u32::from(one.pdf < 0.05);
            }
        }
        assert!(dim > 10, "{dim} draws of where there is little light");
        let (dark, none) = panorama.looked([F32x8::of(1.0); 3], F32x8::of(0.0).gt(F32x8::of(0.0)));
        assert!((0..8).all(|lane| none.lane(lane) == 0.0 && dark.iter().all(|x| x.lane(lane) == 0.0)));
    }

    #[test]
    fn one_texel_is_drawn_all_around_alike() {
        let panorama = Panorama::new(&sky([1, 1], 10.0, |_| [1.0, 2.0, 3.0])).expect("some light");
        let look = panorama.draw([0.25, 0.75]);
        assert_eq!(look.radiance, [0.5, 1.0, 1.5]);
        assert!((look.pdf - 0.25 / PI).abs() < 1e-15 && (look.direction[1] - 0.5).abs() < 1e-15, "{look:?}");
    }

    #[test]
    fn nothing_is_drawn_from_black() {
        assert!(Panorama::new(&sky([3, 2], 0.0, |_| [0.0; 3])).is_none());
        assert!(Panorama::new(&Sky { scale: 0.0, ..uneven([8, 4], 0.0) }).is_none());
        // The faintest and the brightest that a scene may have, side by side.
        let far = Sky { scale: 1.0, ..sky([2, 1], 0.0, |[column, _]| [if column == 0 { 1e15 } else { 1e-38 }; 3]) };
        let panorama = Panorama::new(&far).expect("some light");
        for u in [0.0, 0.5, 1.0_f32.next_down()] {
            let (way, share, pdf) = panorama.drawn::<f32>([0.3, u]);
            assert!(way.iter().chain(&share).all(|x| x.is_finite()) && pdf > 0.0, "{u}: {share:?}, {pdf}");
        }
    }
}
