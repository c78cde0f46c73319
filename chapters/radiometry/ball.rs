//! A ball of glass, of radius 1 about the origin, and rays through it along z: for the check of what it keeps of a bundle,
//! and for the drawings.

use crate::diagram::{Diagram, Part, Spot};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::Setting;
use glam::DVec3;
use light::optics::incidence::refracted;
use std::f64::consts::{PI, TAU};

/// A ray: a place [m] and a unit direction.
pub(super) type Ray = (DVec3, DVec3);

/// The ray where it comes to the plane `z`, in one medium.
pub(super) fn onward((place, way): Ray, z: f64) -> Ray {
    (place + (z - place.z) / way.z * way, way)
}

/// The ray behind the surface where it enters the ball of index `n`; `None` if it misses.
pub(super) fn entering(ray: Ray, n: f64) -> Option<Ray> {
    across(ray, -1.0, 1.0, n)
}

/// The ray behind the surface where it leaves the ball of index `n`.
pub(super) fn leaving(ray: Ray, n: f64) -> Option<Ray> {
    across(ray, 1.0, n, 1.0)
}

/// The ray behind the ball's surface, by Snell's law where it meets it for the first (`sign` −1) or the second time.
fn across((place, way): Ray, sign: f64, n_i: f64, n_t: f64) -> Option<Ray> {
    let (half, rest) = (place.dot(way), place.length_squared() - 1.0);
    let root = (half * half - rest).sqrt();
    let hit = place + (-half + sign * root) * way;
    let way = hit.is_finite().then(|| refracted(way.to_array(), hit.to_array(), n_i, n_t))??;
    Some((hit, DVec3::from_array(way)))
}

/// The ray through the ball, at the plane `z` behind it; `None` if it misses.
pub(super) fn through(ray: Ray, n: f64, z: f64) -> Option<Ray> {
    Some(onward(leaving(entering(ray, n)?, n)?, z))
}

/// From a place in the plane of the drawing, x up and z to the right, at an angle to the axis [rad].
fn from(x: f64, z: f64, angle: f64) -> Ray {
    (DVec3::new(x, 0.0, z), DVec3::new(angle.sin(), 0.0, angle.cos()))
}

/// Where rays meet again that leave one point of the axis at small angles to it.
#[derive(Clone, Copy, Debug)]
struct Image {
    /// Where on the axis.
    z: f64,
    /// Whether in the ball, where their refraction at its far side is still to come.
    in_glass: bool,
    /// Area [1] over that of the source.
    area: f64,
    /// Solid angle [1] of the bundle over that at the source.
    solid_angle: f64,
}

impl Image {
    /// Of the axis at `source` < −1, by tracing; `None` if the rays do not meet.
    fn of(source: f64, n: f64) -> Option<Self> {
        /// An angle and a size whose squares are lost in what is printed.
        const NEAR: f64 = 1e-4;
        let seen = |ray: Ray| {
            let inside = entering(ray, n)?;
            Some((inside, leaving(inside, n)?))
        };
        let (inside, behind) = seen(from(0.0, source, NEAR))?;
        let in_glass = behind.0.x <= 0.0;
        let (place, way) = if in_glass { inside } else { behind };
        let z = place.z - place.x / way.x * way.z;
        // All rays from a point beside the axis come to one point of that plane: this one starts along the axis.
        let (inside, behind) = seen(from(NEAR, source, 0.0))?;
        let size = onward(if in_glass { inside } else { behind }, z).0.x / NEAR;
        let (area, solid_angle) = (size * size, (way.x / NEAR.sin()).powi(2));
        (way.x < 0.0).then_some(Self { z, in_glass, area, solid_angle })
    }

    /// Radiance [1] over the source's: the same power from L dA dΩ and L′ dA′ dΩ′.
    fn radiance(&self) -> f64 {
        (self.area * self.solid_angle).recip()
    }
}

/// Where the source is, and half its width.
const SOURCE: f64 = -4.5;
const HALF: f64 = 0.28;
/// Half the opening of the bundle that is drawn [rad]: it fills a third of the ball, so that its rays still meet nearly
/// in a point.
const OPENING: f64 = 0.085;
/// The window.
const LOW: Spot = [-5.0, -1.45];
const HIGH: Spot = [4.2, 1.15];
/// Where the rays end: to the right, and from the axis.
const END: f64 = 4.0;
const ASIDE: f64 = 1.05;
/// An image farther off than this is none.
const FARTHEST: f64 = 1e3;
/// Where the notes begin.
const BEFORE: f64 = -4.9;
const WITHIN: f64 = -0.36;
const BEHIND: f64 = 0.85;
/// How far from the axis those about the ball stand, and the height of that below all.
const OUTSIDE: f64 = 0.92;
const INSIDE: f64 = 0.58;
const BELOW: f64 = -1.3;

/// Three digits.
fn short(value: f64) -> String {
    let places = (2.0 - value.abs().max(1e-99).log10().floor()).clamp(0.0, 9.0) as usize;
    let written = format!("{value:.places$}");
    if written.contains('.') { written.trim_end_matches('0').trim_end_matches('.').to_owned() } else { written }
}

/// A small source, a bundle of its rays through the ball, and its image: what becomes of dA, dΩ and L.
pub(super) fn image(setting: &Setting) -> Plot {
    let n = setting.number("n");
    let rim = (0..=120).map(|at| TAU * f64::from(at) / 120.0).map(|turn| [turn.cos(), turn.sin()]).collect();
    // Through the ball's middle no ray is bent, so that these two lead to the images of the source's ends.
    let straight = [-HALF, HALF].map(|x| from(x, SOURCE, (x / SOURCE).atan()));
    let bundle = (-2..=2).map(|step| from(0.0, SOURCE, f64::from(step) / 2.0 * OPENING));
    let found = Image::of(SOURCE, n).filter(|image| image.z < FARTHEST);
    let below = found.map_or("no image: the rays do not meet".to_owned(), |image| image.described(n));
    let diagram = Diagram::new("", LOW, HIGH)
        .with(Part::line([LOW[0], 0.0], [HIGH[0], 0.0]).hue(Hue::Reference).dash(Dash::Dashed))
        .with(Part::curve(rim).hue(Hue::Reference))
        .with_all(
            straight
                .into_iter()
                .flat_map(|ray| path(ray, n).into_iter().map(|[from, to]| Part::line(from, to).hue(Hue::Reference))),
        )
        .with_all(bundle.flat_map(|ray| {
            let heads: [&[f64]; 3] = [&[0.8], &[], &[0.92]];
            let pieces = path(ray, n).into_iter().zip(heads);
            pieces.map(|([from, to], heads)| Part::ray_with_heads(from, to, heads).hue(Hue::Ours))
        }))
        .with(Part::line([SOURCE, -HALF], [SOURCE, HALF]).hue(Hue::P).label("dA"))
        .with(Part::arc([SOURCE, 0.0], 1.7, -OPENING, OPENING).label("dΩ"))
        .with_all([BEFORE, BEHIND].map(|x| Part::note([x, OUTSIDE], "n = 1")))
        .with_all([BEFORE, BEHIND].map(|x| Part::note([x, -OUTSIDE], "L")))
        .with(Part::note([WITHIN, INSIDE], format!("n = {}", short(n))))
        .with(Part::note([WITHIN, -INSIDE], format!("{} L", short(n * n))))
        .with(Part::note([BEFORE, BELOW], below))
        .with_all(found.into_iter().flat_map(|image| image.drawn()));
    Plot::of("A small source and its image: dA and dΩ change, L/n^2 does not", diagram)
}

/// The path of a ray through the ball as far as the drawing goes: its three pieces; none if it misses.
fn path(ray: Ray, n: f64) -> Vec<[Spot; 2]> {
    let spot = |ray: Ray| [ray.0.z, ray.0.x];
    let pieces = || {
        let inside = entering(ray, n)?;
        let behind = leaving(inside, n)?;
        let (place, way) = behind;
        let aside = place.z + (ASIDE.copysign(way.x) - place.x) / way.x * way.z;
        let ends = [ray, inside, behind, onward(behind, END.min(aside))].map(spot);
        Some(ends.windows(2).map(|ends| [ends[0], ends[1]]).collect())
    };
    pieces().unwrap_or_default()
}

impl Image {
    /// The image and the bundle that makes it.
    fn drawn(&self) -> [Part; 2] {
        let half = HALF * self.area.sqrt();
        let opening = (OPENING.sin() * self.solid_angle.sqrt()).asin();
        // Behind the image if there is room, but in the medium in which it stands.
        let arc = match (self.in_glass, self.z + 1.0 < END) {
            (true, _) => Part::arc([self.z, 0.0], 0.6, PI - opening, PI + opening),
            (false, true) => Part::arc([self.z, 0.0], 0.9, -opening, opening),
            (false, false) => Part::arc([self.z, 0.0], 0.9, PI - opening, PI + opening),
        };
        [Part::line([self.z, -half], [self.z, half]).hue(Hue::P).label("dA′"), arc.label("dΩ′")]
    }

    /// What it has made of the source's area, solid angle and radiance.
    fn described(&self, n: f64) -> String {
        let [area, solid_angle, radiance] = [self.area, self.solid_angle, self.radiance()].map(short);
        let (place, index) = match self.in_glass {
            true => ("in the glass".to_owned(), n),
            false if self.z > END => (format!("at {} radii", short(self.z)), 1.0),
            false => ("in air".to_owned(), 1.0),
        };
        let square = short(index * index);
        format!("image {place}: dA′/dA = {area}, dΩ′/dΩ = {solid_angle}, so L′/L = {radiance}; n′² = {square}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a ball of radius 1 the focus is at n/2(n − 1) from its middle; in its glass, 1/s + n/s′ = n − 1 from its front
    /// (E. Hecht, *Optics*, §5.2 and §6.1).
    #[test]
    fn images_are_where_the_lens_equation_has_them() {
        for n in [1.2, 1.5, 2.0, 2.5] {
            let image = Image::of(SOURCE, n).expect("an image");
            let expected = 1.0 / (2.0 * (n - 1.0) / n + 1.0 / SOURCE);
            assert!(!image.in_glass && (image.z / expected - 1.0).abs() < 1e-6, "{n}: {image:?}, not {expected}");
            assert!((image.area.sqrt() / (expected / SOURCE).abs() - 1.0).abs() < 1e-6, "{n}: {image:?}");
        }
        for n in [2.7, 3.0, 4.0] {
            let image = Image::of(SOURCE, n).expect("an image");
            let expected = n / (n - 1.0 + 1.0 / (1.0 + SOURCE)) - 1.0;
            assert!(image.in_glass && (image.z - expected).abs() < 1e-6, "{n}: {image:?}, not {expected}");
        }
        assert!(Image::of(SOURCE, 1.0).is_none() && Image::of(SOURCE, 1.1).is_none());
    }

    /// What the figure says of L/n² is found by tracing alone.
    #[test]
    fn traced_images_keep_the_radiance_over_the_square_of_the_index() {
        for n in [1.2f64, 1.5, 2.5, 2.7, 4.0] {
            let image = Image::of(SOURCE, n).expect("an image");
            let kept = image.radiance() / if image.in_glass { n * n } else { 1.0 };
            assert!((kept - 1.0).abs() < 1e-6, "{n}: {image:?}");
        }
    }
}
