//! Caustics: light that comes from a lamp by way of mirrors or glass, followed from the lamp on.
//!
//! What a mirror, glass or polished metal shows of a lamp to a matt surface hardly any ray finds from the camera. From the lamp
//! it is easy: rays are sent into the cones under which it sees what casts its light. Those that have met it are followed, and
//! every matt place they meet is joined to the camera; the light falls on whichever pixel shows the place. The same paths are
//! still found from the camera. Each way counts by its share of the density with which all would have made the path (E. Veach,
//! *Robust Monte Carlo methods for light transport simulation* (1997), §10.2).
//!
//! The densities have the same factors wherever the path scatters without choice or by the cosine, but for the ends: from
//! the lamp M paths a sample with the density p_A of their place and p_ω of their direction, from the camera the density
//! p_c of rays through a pixel. With e = p_A p_ω/cos θ_L and c = p_c cos θ₁/r₁² they are as π M e to c. Where what is met first
//! from the lamp is rough, a direction is drawn there with a density p, from the lamp's side as from the camera's but for
//! shadowing (G₁ of the one for G₁ of the other), and rays are sent from there to the lamp, too, with a density p_L: the path is made by
//! chance, by a ray to the lamp and from the lamp as p c, p_L c and p π M e. Whatever lies between, the shares add up to 1, so
//! that nothing is counted twice.
//!
//! A wavelength changes none of this. Where glass disperses, either way draws it with the same density at a path's second
//! dispersing event, or the first that it passes; the shares ask for the ends alone, and add up to 1 for every wavelength.
//!
//! The light of a path is added to a pixel as a whole number of units: such sums know no order.

use super::film::{Splats, UNITS};
use super::lamp::{Arrival, Lamp};
use super::{Stage, Vertex};
use crate::bsdf::dispersive::Hue;
use crate::bsdf::{Rgb, grey, rgb};
use crate::geometry::{Bounds, Ray};
use crate::number::{Frame, MOST_LANES, Mask, Vector, Width, length_and_way, vectorised_lanes};
use crate::sampling::{Choice, Points, Row, Shares, Stream, warp};
use std::f64::consts::{FRAC_1_PI, PI};
use std::ops::Range;

/// Pixels for each of which a sample brings one path from a lamp: they are dear, and fewer do nearly as well.
const PIXELS_A_PATH: u32 = 8;

/// The most of them.
const MOST_PATHS: u32 = 1 << 22;

/// The most specular things that are aimed at one by one; more are aimed at all together.
const MOST_TARGETS: usize = 16;

/// How much [1] the balls about them are larger than they are, so that no rounding puts anything outside.
const MARGIN: f64 = 1.0 + 1e-3;

/// Vertices before a path from a lamp may be ended by chance.
const PATIENCE: f64 = 3.0;

/// Samples whose splats are held at once: some megabytes.
const TOGETHER: usize = 32;

/// Samples of a net for paths from lamps.
const SAMPLES: u32 = 1 << 11;

/// Rows of them.
const ROWS: usize = 8;

/// A ball about something specular.
#[derive(Clone, Copy, Debug)]
struct Target<N> {
    center: Vector<N>,
    radius: N,
}

/// Which paths from lamps a scene asks for.
#[derive(Clone, Debug)]
pub struct Caustics<N: Width> {
    shares: Shares,
    /// Of each lamp the density [m⁻²] of places on it.
    places: Vec<N>,
    targets: Vec<Target<N>>,
    /// M.
    paths: u32,
    /// π M.
    weight: N,
    /// The power of two that is a unit [W m⁻² sr⁻¹].
    exponent: i32,
}

impl<N: Width> Caustics<N> {
    /// For lamps that send out their light over an `extent` [m], and the boxes about what casts it on; None if either is missing.
    pub fn new(lamps: &[Lamp<N>], casters: &[Bounds], extent: f64, pixels: u32) -> Option<Self> {
        let flux = |lamp: &Lamp<N>| if lamp.area().is_some() { lamp.flux(extent) } else { 0.0 };
        let shares = Shares::new(lamps.iter().map(flux))?;
        let place = |(at, lamp): (usize, &Lamp<N>)| N::of(lamp.area().map_or(0.0, |area| shares.share(at) / area));
        let places = lamps.iter().enumerate().map(place).collect();
        let all = [casters.iter().fold(Bounds::NOTHING, |all, one| all.union(one))];
        let aimed_at = if casters.len() > MOST_TARGETS { &all } else { casters };
        let targets: Vec<Target<N>> = aimed_at.iter().map(Target::about).collect();
        if targets.is_empty() {
            return None;
        }
        // Whole vectors of them, and in every width as many.
        let lanes = MOST_LANES as u32;
        let paths = (pixels / PIXELS_A_PATH).min(MOST_PATHS).next_multiple_of(lanes).max(lanes);
        let brightest = lamps.iter().map(|lamp| lamp.brightest()).fold(0.0, f64::max);
        let exponent = brightest.log2().ceil() as i32 - UNITS;
        Some(Self { shares, places, targets, paths, weight: N::of(PI * f64::from(paths)), exponent })
    }

    /// The power of two that is a unit [W m⁻² sr⁻¹] of the sums.
    pub fn exponent(&self) -> i32 {
        self.exponent
    }

    /// π M e: how densely a path that leaves a lamp at a place in a direction is sent from there, in units of c.
    #[inline(always)]
    fn density(&self, place: Vector<N>, by_place: N, direction: Vector<N>, cos: N) -> N {
        let mut density = N::of(0.0);
        for target in &self.targets {
            density = density + target.density(place, direction);
        }
        let each = N::of(1.0 / self.targets.len() as f64);
        self.weight * by_place * density * each / cos.max(N::of(f64::from(f32::MIN_POSITIVE)))
    }

    /// How densely paths from lamps make what a path from the camera is that has met a lamp by chance, against that path: π M e
    /// over the density c of its end at the camera ([`end`]).
    #[inline(always)]
    pub fn rival(&self, ray: &Ray<N>, vertex: &Vertex<'_, N>, end: N) -> N {
        let mut by_place = N::of(0.0);
        for (number, density) in self.places.iter().enumerate() {
            by_place = N::select((vertex.lamp - N::of(number as f64)).abs().lt(N::of(0.5)), *density, by_place);
        }
        self.density(vertex.surface.point, by_place, -ray.direction, vertex.cos) / end
    }

    /// The same of a path that has been joined, from a place, to the lamp of a number.
    #[inline(always)]
    pub fn rival_of_arrival(&self, from: Vector<N>, number: usize, arrival: &Arrival<N>, end: N) -> N {
        let place = from + arrival.wi.scaled(arrival.distance);
        self.density(place, self.places[number], -arrival.wi, arrival.cos) / end
    }
}

/// Numbers for paths from lamps.
pub fn points(choice: Choice, seed: u64) -> Points {
    Points::new(choice, SAMPLES, ROWS, seed ^ 0x6c61_6d70)
}

/// c = p_c cos θ₁/r₁²: the density, over a matt surface, of what rays through a pixel meet first.
#[inline(always)]
pub fn end<N: Width>(stage: &Stage<N>, from_camera: Vector<N>, distance: N, cos: N) -> N {
    // Never 0, so that quotients are numbers.
    let least = N::of(f64::from(f32::MIN_POSITIVE));
    (stage.lens().density(from_camera) * cos / distance.squared().max(least)).max(least)
}

impl<N: Width> Target<N> {
    fn about(bounds: &Bounds) -> Self {
        let middle = |axis: usize| 0.5 * (bounds.low[axis] + bounds.high[axis]);
        let half = |axis: usize| 0.5 * (bounds.high[axis] - bounds.low[axis]);
        let radius = (0..3).map(|axis| half(axis) * half(axis)).sum::<f64>().sqrt();
        Self::ball([middle(0), middle(1), middle(2)], radius)
    }

    fn ball(center: [f64; 3], radius: f64) -> Self {
        Self { center: Vector::of(center), radius: N::of(radius * MARGIN) }
    }

    /// Its axis and 1 − cos of its cone as a place sees it, and where that is outside.
    #[inline(always)]
    fn cone(&self, place: Vector<N>) -> (Vector<N>, N, N::Mask) {
        let way = self.center - place;
        let square = way.dot(way);
        let sin2 = self.radius.squared() / square.max(N::of(f64::from(f32::MIN_POSITIVE)));
        let is_outside = sin2.lt(N::of(1.0 - 1e-3));
        let axis = Vector::select(is_outside, way.normalised(), Vector::of([0.0, 0.0, 1.0]));
        (axis, warp::one_minus_cos(sin2.min(N::of(1.0))), is_outside)
    }

    /// The density [sr⁻¹] of directions that aim at it: within its cone, or if the place is inside, all alike.
    #[inline(always)]
    fn density(&self, place: Vector<N>, direction: Vector<N>) -> N {
        let (axis, one_minus_cos, is_outside) = self.cone(place);
        let off = direction - axis;
        let is_within = (off.dot(off) * N::of(0.5)).le(one_minus_cos);
        let within = warp::cone_density(one_minus_cos).only(is_within);
        N::select(is_outside, within, N::of(0.25 * FRAC_1_PI))
    }

    #[inline(always)]
    fn draw(&self, place: Vector<N>, u: [N; 2]) -> Vector<N> {
        let (axis, one_minus_cos, is_outside) = self.cone(place);
        let within = Frame::about(axis).outward(warp::cone(one_minus_cos, u).0);
        Vector::select(is_outside, within, warp::sphere(u))
    }
}

/// Paths from lamps that are under way.
struct Paths<N: Width> {
    ray: Ray<N>,
    /// What the lamp sends out [W m⁻² sr⁻¹], times what is left of it [1].
    light: Rgb<N>,
    /// The same without the lamp, by which chance decides.
    left: Rgb<N>,
    /// Which lamp they have left, and the cosine [1] to its normal.
    lamp: N,
    cos: N,
    /// π M e.
    density: N,
    /// How densely rays to the lamp would have been sent from what was met first, against those that are drawn there.
    by_ray: N,
    /// What they know of their wavelength, where glass disperses.
    hue: Hue<N>,
    alive: N::Mask,
}

/// The light that paths from lamps bring to the picture, of the samples of some pairs; None where none are sent.
pub fn splats<N: Width>(stage: &Stage<N>, points: &Points, pairs: Range<u32>) -> Option<Splats> {
    let caustics = stage.caustics()?;
    let [width, height] = stage.size();
    let stream = points.of_pixel([u32::MAX; 2]);
    let mut sums = Splats::none(width as usize * height as usize, caustics.exponent);
    // A task for every so many paths, and their splats added one after the other: whole numbers know no order.
    let tasks: Vec<u32> = pairs.flat_map(|pair| [2 * pair, 2 * pair + 1]).collect();
    for some in tasks.chunks(TOGETHER) {
        for found in crate::threads::mapped(some, |sample| of_sample(stage, caustics, &stream, *sample)) {
            found.into_iter().for_each(|(pixel, half, light)| sums.add(pixel, half, light));
        }
    }
    Some(sums)
}

/// Pixel, half, and light.
type Splat = (usize, usize, Rgb<f64>);

/// All of one sample of the picture.
fn of_sample<N: Width>(stage: &Stage<N>, caustics: &Caustics<N>, stream: &Stream<'_>, sample: u32) -> Vec<Splat> {
    let mut found = Vec::new();
    let (pair, half) = (sample / 2, sample % 2);
    for first in (0..caustics.paths).step_by(N::LANES) {
        // Paths of a half have the numbers of that half.
        let number = |lane: usize| {
            let path = pair.wrapping_mul(caustics.paths).wrapping_add(first + lane as u32);
            path.wrapping_mul(2) | half
        };
        let numbers: [u32; MOST_LANES] = std::array::from_fn(number);
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || caustics.follow(stage, stream, &numbers, |pixel, light| found.push((pixel, half as usize, light))),
        );
    }
    found
}

impl<N: Width> Caustics<N> {
    /// A path a lane, from a lamp until all have ended.
    #[inline(always)]
    fn follow(&self, stage: &Stage<N>, stream: &Stream<'_>, samples: &[u32], mut splat: impl FnMut(usize, Rgb<f64>)) {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let mut paths = self.begin(stage, stream.row(|lane| samples[lane], |_| 0));
        let mut edges = 0;
        while paths.alive.any() && stage.max_depth().is_none_or(|most| edges + 1 < most) {
            edges += 1;
            let hit = stage.closest(&paths.ray, paths.alive);
            paths.alive = paths.alive & hit.is_some();
            if !paths.alive.any() {
                break;
            }
            let vertex = stage.vertex(&paths.ray, &hit, paths.alive);
            if stage.absorbs() {
                paths.scale(vertex.clarity);
            }
            if edges > 1 {
                self.join(stage, &paths, &vertex, &mut splat);
            }
            let row: Row<N> = stream.at(|lane| samples[lane], |_| edges as usize);
            let mut drawn = vertex.met.sample(paths.alive, vertex.wo, row.surface);
            if stage.disperses() {
                let numbers = (row.surface, row.wavelength);
                drawn = vertex.met.dispersed(paths.alive, vertex.wo, numbers, &mut paths.hue, drawn);
            }
            if edges == 1 {
                let is_rough = paths.alive & vertex.met.is_rough_caster();
                paths.alive = paths.alive & (drawn.is_delta | is_rough);
                if is_rough.any() {
                    // Drawn from the camera's side, and by a ray from there.
                    let (_, by_chance) = vertex.met.eval_pdf(is_rough, vertex.wo, drawn.wi);
                    let by_ray = stage.density_from(vertex.start, paths.lamp, vertex.distance, paths.cos, is_rough);
                    let least = N::of(f64::from(f32::MIN_POSITIVE));
                    paths.by_ray = (by_ray / by_chance.max(least)).only(is_rough);
                }
            }
            let direction = vertex.frame.outward(drawn.wi);
            paths.scale(vertex.kept(&drawn, direction));
            paths.ray = stage.leave(&vertex, direction);
            let left = rgb(|c| paths.left[c].abs());
            let left = left[0].max(left[1]).max(left[2]);
            let chance = if f64::from(edges) < PATIENCE { one } else { left.min(one) };
            let goes_on = row.survival.lt(chance) & left.gt(zero);
            paths.scale(grey(one / N::select(goes_on, chance, one)));
            paths.alive = paths.alive & goes_on;
        }
    }

    /// A path a lane, as it leaves its lamp.
    #[inline(always)]
    fn begin(&self, stage: &Stage<N>, [which, u, v, aim, a, b, side, _]: [N; 8]) -> Paths<N> {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let number = N::from_lanes(|lane| self.shares.pick(which.lane(lane)).0 as f64);
        let null = Vector::of([0.0; 3]);
        let (mut place, mut normal, mut start) = (null, Vector::of([0.0, 0.0, 1.0]), null);
        let (mut light, mut by_place) = (grey(zero), zero);
        for (at, lamp) in stage.lamps().iter().enumerate() {
            let its = (number - N::of(at as f64)).abs().lt(N::of(0.5));
            if its.any() {
                let [on, up, off] = lamp.place([u, v], side);
                (place, normal) = (Vector::select(its, on, place), Vector::select(its, up, normal));
                start = Vector::select(its, off, start);
                light = rgb(|c| N::select(its, lamp.radiance()[c], light[c]));
                by_place = N::select(its, self.places[at], by_place);
            }
        }
        let count = N::of(self.targets.len() as f64);
        let aim = aim * count;
        let mut direction = normal;
        for (at, target) in self.targets.iter().enumerate() {
            let its = aim.ge(N::of(at as f64)) & aim.lt(N::of(at as f64 + 1.0));
            if its.any() {
                direction = Vector::select(its, target.draw(place, [a, b]), direction);
            }
        }
        let cos = normal.dot(direction);
        let density = self.density(place, by_place, direction, cos);
        Paths {
            ray: Ray { origin: start, direction },
            light,
            left: grey(one),
            lamp: number,
            cos,
            density,
            by_ray: zero,
            hue: Hue::none(),
            alive: cos.gt(zero) & density.gt(zero),
        }
    }

    /// Joins matt places to the camera.
    #[inline(always)]
    fn join(
        &self,
        stage: &Stage<N>,
        paths: &Paths<N>,
        vertex: &Vertex<'_, N>,
        splat: &mut impl FnMut(usize, Rgb<f64>),
    ) {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let matt = paths.alive & vertex.met.is_lambert() & vertex.wo.z.gt(zero);
        if !matt.any() {
            return;
        }
        let (distance, to_camera) = length_and_way(stage.lens().origin() - vertex.surface.point);
        let [x, y] = stage.lens().place(-to_camera);
        let [width, height] = stage.size().map(|size| N::of(f64::from(size)));
        let is_seen = x.ge(zero) & x.lt(width) & y.ge(zero) & y.lt(height);
        let matt = matt & is_seen & vertex.frame.inward(to_camera).z.gt(zero) & distance.gt(zero);
        if !matt.any() {
            return;
        }
        let cos = vertex.surface.normal.dot(to_camera).abs();
        let end = end(stage, -to_camera, distance, cos);
        let arrival = Arrival { wi: to_camera, distance, share: grey(zero), pdf: zero, cos: one };
        let (ray, reach) = stage.towards(vertex, &arrival);
        let open = matt & !stage.is_blocked(&ray, reach, matt);
        // Light over e, times c ρ/π, times the share π M e/(π M e + c + …), over M.
        let least = N::of(f64::from(f32::MIN_POSITIVE));
        let turned = vertex.wo.z.abs() / vertex.cos.max(least);
        let factor = turned / (one + paths.density / end + paths.by_ray);
        let albedo = vertex.met.paint();
        let light = rgb(|c| paths.light[c] * paths.left[c] * albedo[c] * factor);
        for lane in open.lanes() {
            let pixel = y.place(lane) * stage.size()[0] as usize + x.place(lane);
            splat(pixel, rgb(|c| light[c].lane(lane)));
        }
    }
}

impl<N: Width> Paths<N> {
    #[inline(always)]
    fn scale(&mut self, factor: Rgb<N>) {
        self.left = rgb(|c| self.left[c] * factor[c]);
    }
}
