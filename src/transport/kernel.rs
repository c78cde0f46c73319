//! The fast integrator: as many paths of one pixel at once as a number has lanes.
//!
//! A lane carries one path. Its path ended, it takes the pixel's next sample at once, so that lanes seldom idle; rare work is
//! done only if a lane asks for it. At every vertex the path is joined to a lamp and goes on by its surface, and both ways of
//! meeting a lamp are weighed by their densities (E. Veach and L. J. Guibas, *Optimally combining sampling techniques for
//! Monte Carlo rendering*, SIGGRAPH '95, 419: the balance heuristic).

use super::film::{Halves, added, tree};
use super::{Stage, Vertex, caustics};
use crate::bsdf::{Rgb, grey, rgb};
use crate::geometry::Ray;
use crate::number::{MOST_LANES, Mask, Vector, Width, vectorised_lanes};
use crate::sampling::{Row, Stream};
use std::ops::Range;

/// Pairs of samples that lanes take from without a halt.
const BATCH: u32 = 256;

/// What can be done otherwise, to see what it is good for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tactics {
    /// Vertices before a path may be ended by chance.
    pub patience: u32,
    /// The chance [1] to go on, over what a path carries.
    pub boost: f64,
    /// The most that chance [1].
    pub most: f64,
    /// How lamps are met.
    pub meeting: Meeting,
    /// Whether one lamp is chosen by chance before anything is known of it, instead of one candidate of each by what it
    /// would bring.
    pub blind_choice: bool,
    /// Whether paths from lamps are followed where they bring light that hardly anything else finds.
    pub caustics: bool,
    /// Samples in place of one, a power of two, where a pixel's centre shows something specular.
    pub extra: u32,
    /// Whether one path is followed at a time, as if there were no lanes.
    pub one_lane: bool,
}

/// How paths meet lamps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Meeting {
    /// By rays to them and by chance, weighed.
    #[default]
    Both,
    /// By rays to them alone, but where nothing else is possible.
    Lamps,
    /// By chance alone.
    Chance,
}

impl Default for Tactics {
    fn default() -> Self {
        Self {
            patience: 6,
            boost: 2.0,
            most: 0.98,
            meeting: Meeting::Both,
            blind_choice: false,
            caustics: true,
            extra: 8,
            one_lane: false,
        }
    }
}

impl Tactics {
    /// Whether paths from lamps are followed, if the scene asks for them: they share their light with paths that meet lamps by
    /// chance.
    pub fn follows(&self) -> bool {
        self.caustics && self.meeting == Meeting::Both
    }
}

/// The paths that are under way.
struct Paths<N: Width> {
    ray: Ray<N>,
    /// What they carry [1].
    throughput: Rgb<N>,
    /// What they have gathered [W m⁻² sr⁻¹].
    gathered: Rgb<N>,
    /// Density [sr⁻¹] of the last direction; infinite where there was no choice.
    pdf: N,
    /// Edges so far.
    edges: N,
    /// n² of where they are, over that of the camera [1].
    squeeze: N,
    /// The end at the camera, as [`super::caustics`] weighs it; infinite where no path from a lamp could be the same.
    end: N,
    /// Whose sample it is.
    sample: [u32; MOST_LANES],
    alive: N::Mask,
}

/// A pixel's work.
pub struct Work<'a, N: Width> {
    /// The scene.
    pub stage: &'a Stage<N>,
    /// What is done otherwise.
    pub tactics: &'a Tactics,
    /// The pixel's numbers.
    pub stream: Stream<'a>,
    /// Column and row.
    pub pixel: [u32; 2],
}

impl<N: Width> Work<'_, N> {
    /// The sum over a branch of pairs of samples ([`super::film`]).
    #[inline(always)]
    pub fn branch(&self, range: Range<u32>) -> Halves {
        // What is specular shows the picture's darkest corners and its lamps side by side: there a sample is the mean of
        // several, of numbers of their own. Whoever asks for so many samples that there are no numbers left gets single ones.
        let extra = self.tactics.extra.max(1);
        if extra == 1 || range.end > u32::MAX / 4 / extra || !self.stage.may_be_specular() || !self.is_specular() {
            return self.sum(range);
        }
        let sum = self.sum(range.start * extra..range.end * extra);
        sum.map(|half| rgb(|c| half[c] / extra as f32))
    }

    /// Whether the pixel's centre shows something specular.
    #[inline(never)]
    fn is_specular(&self) -> bool {
        let [half, zero] = [0.5, 0.0].map(N::of);
        let ray = self.stage.camera(self.pixel, [half, half, zero, zero]);
        let all = N::Mask::of(true);
        let hit = self.stage.closest(&ray, all);
        hit.is_some().lane(0) && self.stage.vertex(&ray, &hit, all).met.is_specular(0)
    }

    #[inline(always)]
    fn sum(&self, range: Range<u32>) -> Halves {
        // A stack of what waits for its other half, as the tree has it.
        let mut sum: Option<Halves> = None;
        let mut waiting: Vec<(u32, Halves)> = Vec::new();
        let mut start = range.start;
        while start < range.end {
            let span = BATCH.min(range.end - range.start);
            let mut pairs = vec![[[0.0; 3]; 2]; span as usize];
            self.trace(start, &mut pairs);
            let (mut size, mut found) = (span, tree(&pairs));
            while let Some((other, before)) = waiting.pop_if(|(other, _)| *other == size) {
                (size, found) = (2 * other, added(before, found));
            }
            waiting.push((size, found));
            sum = Some(found);
            start += span;
        }
        sum.unwrap_or_default()
    }

    /// What each pair of samples from `start` on gathers.
    #[inline(always)]
    fn trace(&self, start: u32, pairs: &mut [Halves]) {
        let (mut next, end) = (2 * start, 2 * (start + pairs.len() as u32));
        // Numbers beyond the net are rare, and asking for them lane by lane is not free.
        let rows = N::of(if self.stream.holds(end) { self.stream.rows() as f64 } else { 0.0 });
        let mut paths = Paths::<N>::none();
        loop {
            if next < end && (!paths.alive).any() {
                let fresh = paths.take(&mut next, end);
                let u: [N; 8] = if rows.gt(N::of(0.0)).any() {
                    self.stream.of_net(
                        #[inline(always)]
                        |lane| paths.sample[lane],
                        |_| 0,
                    )
                } else {
                    self.stream.row(|lane| paths.sample[lane], |_| 0)
                };
                let ray = self.stage.camera(self.pixel, [u[0], u[1], u[2], u[3]]);
                paths.begin(fresh, ray);
            }
            if !paths.alive.any() {
                break;
            }
            let before = paths.alive;
            self.step(&mut paths, rows);
            let ended = before & !paths.alive;
            for lane in ended.lanes() {
                let at = paths.sample[lane] - 2 * start;
                pairs[at as usize / 2][at as usize % 2] = rgb(|c| paths.gathered[c].lane(lane) as f32);
            }
        }
    }
}

impl<N: Width> Paths<N> {
    fn none() -> Self {
        let zero = N::of(0.0);
        let null = Vector::of([0.0; 3]);
        Self {
            ray: Ray { origin: null, direction: Vector::of([0.0, 0.0, 1.0]) },
            throughput: grey(zero),
            gathered: grey(zero),
            pdf: zero,
            edges: zero,
            squeeze: N::of(1.0),
            end: N::of(f64::INFINITY),
            sample: [0; MOST_LANES],
            alive: N::Mask::of(false),
        }
    }

    /// Gives idle lanes the next samples; which have one.
    #[inline(always)]
    fn take(&mut self, next: &mut u32, end: u32) -> N::Mask {
        let mut fresh = [0.0; MOST_LANES];
        for lane in (!self.alive).lanes() {
            if *next >= end {
                break;
            }
            self.sample[lane] = *next;
            *next += 1;
            fresh[lane] = 1.0;
        }
        N::from_lanes(
            #[inline(always)]
            |lane| fresh[lane],
        )
        .gt(N::of(0.5))
    }

    /// Begins the paths of some lanes.
    #[inline(always)]
    fn begin(&mut self, fresh: N::Mask, ray: Ray<N>) {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        self.ray = Ray::select(fresh, ray, self.ray);
        self.throughput = rgb(|c| N::select(fresh, one, self.throughput[c]));
        self.gathered = rgb(|c| N::select(fresh, zero, self.gathered[c]));
        self.pdf = N::select(fresh, N::of(f64::INFINITY), self.pdf);
        self.edges = N::select(fresh, zero, self.edges);
        self.squeeze = N::select(fresh, one, self.squeeze);
        self.end = N::select(fresh, N::of(f64::INFINITY), self.end);
        self.alive = self.alive | fresh;
    }

    /// Adds light that comes along what the paths carry.
    #[inline(always)]
    fn gather(&mut self, mask: N::Mask, light: Rgb<N>) {
        self.gathered = rgb(|c| self.gathered[c] + (self.throughput[c] * light[c]).only(mask));
    }
}

impl<N: Width> Work<'_, N> {
    /// One edge of every path.
    #[inline(always)]
    fn step(&self, paths: &mut Paths<N>, rows: N) {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let (stage, tactics) = (self.stage, self.tactics);
        let hit = stage.closest(&paths.ray, paths.alive);
        let met = paths.alive & hit.t.lt(N::of(f64::INFINITY));
        if let Some(environment) = stage.environment() {
            let missed = paths.alive & !met;
            if missed.any() {
                paths.gather(missed, environment);
            }
        }
        paths.alive = met;
        // Idle lanes stand still: what they ask for stays within what there is.
        paths.edges = paths.edges + one.only(met);
        if !met.any() {
            return;
        }
        let vertex = stage.vertex(&paths.ray, &hit, met);
        if stage.absorbs() {
            paths.throughput = rgb(|c| paths.throughput[c] * vertex.clarity[c]);
        }

        let caustics = stage.caustics().filter(|_| tactics.follows());
        let shining = met & vertex.lamp.ge(zero);
        if shining.any() {
            let by_lamp = stage.density_to(&paths.ray, &vertex, shining);
            let share = match tactics.meeting {
                Meeting::Both if caustics.is_some() => {
                    let is_free = paths.pdf.ge(N::of(f64::INFINITY));
                    let by_light = caustics.map_or(one, |caustics| caustics.share(&paths.ray, &vertex, paths.end));
                    N::select(is_free, by_light, one / (one + by_lamp / paths.pdf))
                }
                Meeting::Both => one / (one + by_lamp / paths.pdf),
                Meeting::Lamps => one.only(paths.pdf.ge(N::of(f64::INFINITY))),
                Meeting::Chance => one,
            };
            paths.gather(shining, rgb(|c| vertex.emitted[c] * share));
        }
        if caustics.is_some() {
            let first = met & paths.edges.lt(N::of(1.5)) & vertex.met.is_lambert();
            if first.any() {
                paths.end =
                    N::select(first, caustics::end(stage, paths.ray.direction, vertex.distance, vertex.cos), paths.end);
            }
        }
        if let Some(most) = stage.max_depth() {
            paths.alive = paths.alive & paths.edges.lt(N::of(f64::from(most)));
            if !paths.alive.any() {
                return;
            }
        }

        let row = if paths.edges.ge(rows).any() {
            self.stream.at(|lane| paths.sample[lane], |lane| paths.edges.place(lane))
        } else {
            Row::of(self.stream.of_net(
                #[inline(always)]
                |lane| paths.sample[lane],
                #[inline(always)]
                |lane| paths.edges.place(lane),
            ))
        };
        if !stage.lamps().is_empty() && tactics.meeting != Meeting::Chance {
            self.join(paths, &vertex, &row);
        }

        let drawn = vertex.met.sample(paths.alive, vertex.wo, row.surface);
        paths.throughput = rgb(|c| paths.throughput[c] * drawn.weight[c]);
        paths.squeeze = paths.squeeze * drawn.compression;
        paths.pdf = N::select(drawn.is_delta, N::of(f64::INFINITY), drawn.pdf);
        let direction = vertex.frame.outward(drawn.wi);
        paths.ray = stage.leave(&vertex, direction);
        let is_number = (paths.throughput[0] + paths.throughput[1] + paths.throughput[2]).ge(zero);
        let odd = paths.alive & !is_number;
        if odd.any() {
            // It would end without a word; the pixel has to tell.
            paths.gather(odd, grey(one));
        }
        // What is left of the light's energy, not of its radiance, decides.
        let left = paths.throughput[0].max(paths.throughput[1]).max(paths.throughput[2]) / paths.squeeze;
        let chance = (left * N::of(tactics.boost)).min(N::of(tactics.most));
        let is_young = paths.edges.lt(N::of(f64::from(tactics.patience)));
        let chance = N::select(is_young, one, chance);
        let goes_on = row.survival.lt(chance) & left.gt(zero);
        let inverse = one / N::select(goes_on, chance, one);
        paths.throughput = rgb(|c| paths.throughput[c] * inverse);
        paths.alive = paths.alive & goes_on;
    }

    /// Joins every path to a lamp: one candidate a lamp, one of them kept by what it would bring, one ray to it.
    #[inline(never)]
    fn join(&self, paths: &mut Paths<N>, vertex: &Vertex<'_, N>, row: &Row<N>) {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.joined(paths, vertex, row),
        );
    }

    #[inline(always)]
    fn joined(&self, paths: &mut Paths<N>, vertex: &Vertex<'_, N>, row: &Row<N>) {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let active = paths.alive;
        let mut kept: Option<(Ray<N>, N, Rgb<N>, N)> = None;
        let (mut sum, mut u) = (zero, row.which);
        let count = N::of(self.stage.lamps().len() as f64);
        let blind = self.tactics.blind_choice.then(|| row.which * count);
        for (number, lamp) in self.stage.lamps().iter().enumerate() {
            let arrival = lamp.sample(vertex.start, row.lamp);
            let wi = vertex.frame.inward(arrival.wi);
            let (f, pdf) = vertex.met.eval_pdf(active, wi, vertex.wo);
            let share = match self.tactics.meeting {
                Meeting::Both => one / (one + pdf / arrival.pdf),
                _ => one,
            };
            let factor = wi.z.abs() * share;
            let mut light = rgb(|c| f[c] * arrival.share[c] * factor);
            if let Some(at) = blind {
                // Whoever is chosen stands for all; the others bring nothing.
                let its = at.ge(N::of(number as f64)) & at.lt(N::of(number as f64 + 1.0));
                light = rgb(|c| (light[c] * count).only(its));
            }
            let size = light[0] + light[1] + light[2];
            let (ray, reach) = self.stage.towards(vertex, &arrival);
            kept = Some(match kept {
                None => (ray, reach, light, size),
                Some((other, far, others, before)) => {
                    // Kept by its part of all so far; the number that decided is stretched to be even again.
                    let all = sum + size;
                    let part = size / N::select(all.gt(zero), all, one);
                    let takes = u.lt(part);
                    let rest = N::select(takes, part, one - part);
                    u = (N::select(takes, u, u - part) / N::select(rest.gt(zero), rest, one)).clamp(0.0, 1.0);
                    (
                        Ray::select(takes, ray, other),
                        N::select(takes, reach, far),
                        rgb(|c| N::select(takes, light[c], others[c])),
                        N::select(takes, size, before),
                    )
                }
            });
            sum = sum + size;
        }
        let Some((ray, reach, light, size)) = kept else { return };
        // What is not a number is worth it too: it has to be seen.
        let worth = active & (size.gt(zero) | !sum.ge(zero));
        if !worth.any() {
            return;
        }
        let open = worth & !self.stage.is_blocked(&ray, reach, worth);
        let scale = sum / N::select(worth, size, one);
        paths.gather(open, rgb(|c| light[c] * scale));
    }
}
