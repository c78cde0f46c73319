//! The fast integrator: as many paths at once as a number has lanes.
//!
//! A lane carries one path. Its path ended, it takes the next sample of its pixel or of the one after it at once, so that lanes
//! seldom idle; rare work is done only if a lane asks for it. At every vertex the path is joined to a lamp and goes on by its
//! surface, and both ways of meeting a lamp are weighed by their densities (E. Veach and L. J. Guibas, *Optimally combining
//! sampling techniques for Monte Carlo rendering*, SIGGRAPH '95, 419: the balance heuristic).

use super::caustics::{self, Caustics};
use super::film::{Halves, added, tree};
use super::{Stage, Vertex, pilot};
use crate::bsdf::dispersive::Hue;
use crate::bsdf::{Rgb, grey, rgb};
use crate::geometry::Ray;
use crate::number::{MOST_LANES, Mask, Vector, Width, vectorised_lanes};
use crate::sampling::{Row, Stream};
use std::cell::Cell;
use std::ops::Range;

/// Pairs of samples that lanes take from without a halt.
const BATCH: u32 = 256;

/// The most pixels that are worked on together.
const MOST_TOGETHER: u32 = 64;

/// The chance [1] that a path ends where nothing darkens it: in a closed white room it has to end some time.
const LEAST_LOSS: f64 = 1e-6;

/// What can be done otherwise, to see what it is good for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tactics {
    /// Vertices before a path may be ended by chance.
    pub patience: u32,
    /// The chance [1] to go on, over what a path carries.
    pub boost: f64,
    /// The most that chance [1], but where a surface keeps so much that the variance would be infinite.
    pub most: f64,
    /// How lamps are met.
    pub meeting: Meeting,
    /// Whether one lamp is chosen by chance before anything is known of it, instead of one candidate of each by what it
    /// would bring.
    pub blind_choice: bool,
    /// Whether paths from lamps are followed where they bring light that hardly anything else finds.
    pub caustics: bool,
    /// Samples in place of one, a power of two, in pixels that are worth it ([`super::looks`]).
    pub extra: u32,
    /// Whether two samples of each pixel tell first how many it is worth ([`super::pilot`]).
    pub pilot: bool,
    /// The most paths that are followed at a time, if the machine can do so many: the same picture, bit for bit.
    pub lanes: usize,
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
            patience: 5,
            boost: 4.0,
            most: 0.98,
            meeting: Meeting::Both,
            blind_choice: false,
            caustics: true,
            extra: 8,
            pilot: true,
            lanes: MOST_LANES,
        }
    }
}

impl Tactics {
    /// The most samples that are taken in place of one.
    pub fn most_samples(&self, is_looked_at: bool) -> u32 {
        let by_looks = if is_looked_at { self.extra.max(1) } else { 1 };
        if self.pilot { by_looks.max(pilot::MOST) } else { by_looks }
    }

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
    /// The end at the camera, as [`super::caustics`] weighs it; infinite where it is not matt.
    end: N,
    /// The same where the last surface casts light; infinite where no path from a lamp could have met a lamp from there.
    cast: N,
    /// What they know of their wavelength, where glass disperses.
    hue: Hue<N>,
    /// Which of the pixels each is of,
    owner: [usize; MOST_LANES],
    /// which of its samples,
    sample: [u32; MOST_LANES],
    /// and which of all that are under way.
    slot: [u32; MOST_LANES],
    alive: N::Mask,
}

/// The work of some pixels, together: where few samples are asked of each, the lanes of one that is done take the next one's.
pub struct Work<'a, N: Width> {
    /// The scene.
    pub stage: &'a Stage<N>,
    /// What is done otherwise.
    pub tactics: &'a Tactics,
    /// Column and row of each pixel.
    pub pixels: &'a [[u32; 2]],
    /// Of how many samples each one's samples are the mean.
    pub several: &'a [u32],
    /// Each one's numbers.
    pub streams: &'a [Stream<'a>],
    /// Where the edges of each one's paths are counted, if they are.
    pub edges: Option<&'a [Cell<u32>]>,
}

/// A branch of pairs of one pixel, small enough for lanes to take from it without a halt.
#[derive(Clone, Copy)]
struct Piece {
    /// Which pixel.
    owner: usize,
    /// The first pair.
    start: u32,
    /// Pairs.
    span: u32,
}

impl<N: Width> Work<'_, N> {
    /// As many pixels are worked on together if so many pairs of samples are asked of each.
    pub fn together(pairs: u32) -> usize {
        (BATCH / pairs.max(1)).clamp(1, MOST_TOGETHER) as usize
    }

    /// The sums over a branch of pairs of samples ([`super::film`]), pixel by pixel.
    #[inline(always)]
    pub fn branch(&self, range: Range<u32>) -> Vec<Halves> {
        // Whoever asks for so many samples that there are no numbers left for several in place of each gets single ones.
        let times =
            |owner: usize| if range.end <= u32::MAX / 4 / self.several[owner] { self.several[owner] } else { 1 };
        let mut pieces = Vec::new();
        for owner in 0..self.pixels.len() {
            let times = times(owner);
            let (start, end) = (range.start * times, range.end * times);
            let span = BATCH.min(end - start);
            pieces.extend((start..end).step_by(span.max(1) as usize).map(|start| Piece { owner, start, span }));
        }
        // A stack of what waits for its other half, as the tree has it, and what there is of the pixel so far.
        let mut waiting: Vec<(u32, Halves)> = Vec::new();
        let mut sums = vec![[[0.0; 3]; 2]; self.pixels.len()];
        let mut pairs = Vec::new();
        let mut owner = 0;
        while !pieces.is_empty() {
            let mut all = 0;
            let fit = |piece: &&Piece| {
                all += piece.span;
                all <= 2 * BATCH
            };
            let count = pieces.iter().take_while(fit).count().max(1);
            let rest = pieces.split_off(count);
            pairs.clear();
            pairs.resize(pieces.iter().map(|piece| piece.span as usize).sum(), [[0.0; 3]; 2]);
            self.trace(&pieces, &mut pairs);
            let mut left = &pairs[..];
            for piece in &pieces {
                if piece.owner != owner {
                    waiting.clear();
                    owner = piece.owner;
                }
                let (own, others) = left.split_at(piece.span as usize);
                left = others;
                let (mut size, mut found) = (piece.span, tree(own));
                while let Some((other, before)) = waiting.pop_if(|(other, _)| *other == size) {
                    (size, found) = (2 * other, added(before, found));
                }
                waiting.push((size, found));
                sums[owner] = found;
            }
            pieces = rest;
        }
        for (owner, sum) in sums.iter_mut().enumerate().filter(|(owner, _)| times(*owner) > 1) {
            *sum = sum.map(|half| rgb(|c| half[c] / times(owner) as f32));
        }
        sums
    }

    /// What each pair of samples of the pieces gathers, one piece after the other.
    #[inline(always)]
    fn trace(&self, pieces: &[Piece], pairs: &mut [Halves]) {
        // Numbers beyond the net are rare, and asking for them lane by lane is not free.
        let of_net = |piece: &Piece| self.streams[piece.owner].holds(2 * (piece.start + piece.span));
        let rows = if pieces.iter().all(of_net) { self.streams[0].rows() as f64 } else { 0.0 };
        let rows = N::of(rows);
        let mut source = Source { pieces, next: 0, before: 0 };
        let mut paths = Paths::<N>::none();
        loop {
            if !source.is_empty() && (!paths.alive).any() {
                let fresh = paths.take(&mut source);
                let u: [N; 8] = self.numbers(&paths, rows, N::of(0.0));
                let place = |axis: usize| {
                    N::from_lanes(
                        #[inline(always)]
                        |lane| f64::from(self.pixels[paths.owner[lane]][axis]),
                    )
                };
                let ray = self.stage.camera([place(0), place(1)], [u[0], u[1], u[2], u[3]]);
                paths.begin(fresh, ray);
                if self.stage.disperses() {
                    paths.hue = Hue::select(fresh, Hue::none(), paths.hue);
                }
            }
            if !paths.alive.any() {
                break;
            }
            let before = paths.alive;
            self.step(&mut paths, rows);
            let ended = before & !paths.alive;
            for lane in ended.lanes() {
                pairs[paths.slot[lane] as usize / 2][paths.slot[lane] as usize % 2] =
                    rgb(|c| paths.gathered[c].lane(lane) as f32);
                if let Some(edges) = self.edges {
                    let edges = &edges[paths.owner[lane]];
                    edges.set(edges.get() + paths.edges.lane(lane) as u32);
                }
            }
        }
    }

    /// The numbers of every lane's sample at a vertex.
    #[inline(always)]
    fn numbers(&self, paths: &Paths<N>, rows: N, vertex: N) -> [N; 8] {
        let is_of_net = !vertex.ge(rows).any();
        N::columns(
            #[inline(always)]
            |lane| {
                let (stream, sample) = (&self.streams[paths.owner[lane]], paths.sample[lane]);
                if is_of_net {
                    stream.single_of_net(sample, vertex.place(lane))
                } else {
                    stream.single(sample, vertex.place(lane))
                }
            },
        )
    }
}

/// Samples to be taken.
struct Source<'a> {
    pieces: &'a [Piece],
    /// The next sample of the first piece.
    next: u32,
    /// Samples of the pieces before it.
    before: u32,
}

impl Source<'_> {
    #[inline(always)]
    fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Whose the next one is, its number, and its place among all.
    #[inline(always)]
    fn take(&mut self) -> Option<(usize, u32, u32)> {
        let piece = self.pieces.first()?;
        let taken = (piece.owner, 2 * piece.start + self.next, self.before + self.next);
        self.next += 1;
        if self.next == 2 * piece.span {
            self.before += self.next;
            self.next = 0;
            self.pieces = &self.pieces[1..];
        }
        Some(taken)
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
            cast: N::of(f64::INFINITY),
            hue: Hue::none(),
            owner: [0; MOST_LANES],
            sample: [0; MOST_LANES],
            slot: [0; MOST_LANES],
            alive: N::Mask::of(false),
        }
    }

    /// Gives idle lanes the next samples; which have one.
    #[inline(always)]
    fn take(&mut self, source: &mut Source<'_>) -> N::Mask {
        let mut fresh = [0.0; MOST_LANES];
        for lane in (!self.alive).lanes() {
            let Some((owner, sample, slot)) = source.take() else { break };
            (self.owner[lane], self.sample[lane], self.slot[lane]) = (owner, sample, slot);
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
        self.cast = N::select(fresh, N::of(f64::INFINITY), self.cast);
        self.alive = self.alive | fresh;
    }

    /// Adds light that comes along what the paths carry.
    #[inline(always)]
    fn gather(&mut self, mask: N::Mask, light: Rgb<N>) {
        self.gathered = rgb(|c| self.gathered[c] + (self.throughput[c] * light[c]).only(mask));
    }
}

impl<N: Width> Work<'_, N> {
    /// The paths from lamps that share their light with these.
    #[inline(always)]
    fn caustics(&self) -> Option<&Caustics<N>> {
        self.stage.caustics().filter(|_| self.tactics.follows())
    }

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
        if stage.has_panorama() {
            let missed = paths.alive & !met;
            if missed.any() {
                let (light, by_lamp) = stage.panorama_along(paths.ray.direction, missed);
                let share = match tactics.meeting {
                    Meeting::Both => one / (one + by_lamp / paths.pdf),
                    Meeting::Lamps => one.only(paths.pdf.ge(N::of(f64::INFINITY))),
                    Meeting::Chance => one,
                };
                paths.gather(missed, rgb(|c| light[c] * share));
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

        let caustics = self.caustics();
        let shining = met & vertex.lamp.ge(zero);
        if shining.any() {
            let by_lamp = stage.density_to(&paths.ray, &vertex, shining);
            let share = match tactics.meeting {
                Meeting::Both => {
                    let by_light = caustics.map_or(zero, |caustics| caustics.rival(&paths.ray, &vertex, paths.cast));
                    one / (one + by_lamp / paths.pdf + by_light)
                }
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

        let row: Row<N> = Row::of(self.numbers(paths, rows, paths.edges));
        // Where paths from lamps could be the same that rays to lamps make.
        let is_cast = paths.alive & vertex.met.is_rough_caster();
        if !stage.lamps().is_empty() && tactics.meeting != Meeting::Chance {
            paths.cast = N::select(is_cast, paths.end, N::of(f64::INFINITY));
            self.join(paths, &vertex, &row);
        }

        let mut drawn = vertex.met.sample(paths.alive, vertex.wo, row.surface);
        if stage.disperses() {
            let numbers = (row.surface, row.wavelength);
            drawn = vertex.met.dispersed(paths.alive, vertex.wo, numbers, &mut paths.hue, drawn);
        }
        paths.throughput = rgb(|c| paths.throughput[c] * drawn.weight[c]);
        paths.squeeze = paths.squeeze * drawn.compression;
        paths.pdf = N::select(drawn.is_delta, N::of(f64::INFINITY), drawn.pdf);
        paths.cast = N::select(is_cast | drawn.is_delta, paths.end, N::of(f64::INFINITY));
        let direction = vertex.frame.outward(drawn.wi);
        paths.ray = stage.leave(&vertex, direction);
        // Of one wavelength alone a channel may carry less than nothing.
        let is_number = (paths.throughput[0] + paths.throughput[1] + paths.throughput[2]).abs().ge(zero);
        let odd = paths.alive & !is_number;
        if odd.any() {
            // It would end without a word; the pixel has to tell.
            paths.gather(odd, grey(one));
        }
        // What is left of the light's energy, not of its radiance, decides.
        let size = rgb(|c| paths.throughput[c].abs());
        let left = size[0].max(size[1]).max(size[2]) / paths.squeeze;
        // Light gathered again and again on a way that ends too soon has no finite variance: a bounce that keeps w of it needs a
        // chance above w². Where there is no choice of where to go, nothing is gathered.
        let kept = drawn.weight[0].max(drawn.weight[1]).max(drawn.weight[2]);
        let enough = one - (one - kept * kept).max(N::of(2.0 * LEAST_LOSS)) * N::of(0.5);
        let most = N::select(drawn.is_delta, N::of(tactics.most), N::of(tactics.most).max(enough));
        let chance = (left * N::of(tactics.boost)).min(most);
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
        let cast = active & paths.cast.lt(N::of(f64::INFINITY));
        let caustics = self.caustics().filter(|_| cast.any());
        for (number, lamp) in self.stage.lamps().iter().enumerate() {
            let arrival = lamp.sample(vertex.start, row.lamp);
            let wi = vertex.frame.inward(arrival.wi);
            let (f, pdf) = vertex.met.eval_pdf(active, wi, vertex.wo);
            let share = match self.tactics.meeting {
                Meeting::Both => {
                    // No path leaves what has no surface.
                    let by_light = caustics
                        .filter(|_| lamp.area().is_some())
                        .map_or(zero, |caustics| caustics.rival_of_arrival(vertex.start, number, &arrival, paths.cast));
                    one / (one + pdf / arrival.pdf * (one + by_light))
                }
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
