//! Lamps as a point sees them: a direction towards one, drawn with a known density.
//!
//! | lamp | how a direction is drawn |
//! |---|---|
//! | flat ones, of one piece or many | a place by area, a piece by its share of it |
//! | a ball | within its cone, from inside by area |
//! | a point, the sun | without choice |
//! | an image all around | by its radiance ([`super::panorama`]) |

use super::panorama::Panorama;
use crate::bsdf::{Rgb, rgb};
use crate::number::{Frame, Mask, Vector, Width, length_and_way, vectorised_lanes};
use crate::sampling::{Shares, warp};
use crate::scene::triple::{cross, largest, length, times};
use std::f64::consts::PI;
use std::sync::Arc;

/// Light that would reach a point if nothing were in its way.
#[derive(Clone, Copy, Debug)]
pub struct Arrival<N> {
    /// Where it comes from.
    pub wi: Vector<N>,
    /// From how far [m]; what is nearer is in the way.
    pub distance: N,
    /// Radiance over density [W m⁻²]: times f cos θ_i the radiance that goes on.
    pub share: Rgb<N>,
    /// Density [sr⁻¹]; infinite where there was no choice.
    pub pdf: N,
    /// Cosine [1] to the lamp's normal there; 1 of what has no surface.
    pub cos: N,
}

/// A lamp.
#[derive(Clone, Debug)]
pub struct Lamp<N> {
    form: Form<N>,
    /// Radiance [W m⁻² sr⁻¹], or what the form says.
    light: Rgb<N>,
    /// Whether it shines to both sides.
    two_sided: bool,
    /// How far before its surface rays to it end, so that it does not stand in its own way: a few roundings of its
    /// coordinates.
    slack: N,
}

#[derive(Clone, Debug)]
enum Form<N> {
    Piece(Piece<N>),
    Pieces {
        all: Vec<Piece<N>>,
        shares: Shares,
        area: N,
    },
    Disc {
        frame: Frame<N>,
        center: Vector<N>,
        radius: N,
        area: N,
    },
    Ball {
        center: Vector<N>,
        radius: N,
    },
    /// Radiant intensity [W sr⁻¹] from a place.
    Point(Vector<N>),
    /// Irradiance [W m⁻²] from a direction.
    Sun(Vector<N>),
    /// From everywhere.
    Panorama(Arc<Panorama>),
}

/// A parallelogram, or the triangle that is its half.
#[derive(Clone, Copy, Debug)]
pub struct Piece<N> {
    corner: Vector<N>,
    edges: [Vector<N>; 2],
    normal: Vector<N>,
    area: N,
    is_triangle: bool,
}

impl<N: Width> Piece<N> {
    /// By a corner and the edges from it [m].
    pub fn new(corner: [f64; 3], edges: [[f64; 3]; 2], is_triangle: bool) -> Self {
        let [a, b] = edges;
        let cross = cross(a, b);
        let twice = length(cross);
        Self {
            corner: Vector::of(corner),
            edges: edges.map(Vector::of),
            normal: Vector::of(times(cross, 1.0 / twice)),
            area: N::of(if is_triangle { 0.5 * twice } else { twice }),
            is_triangle,
        }
    }

    /// Its largest coordinate, at most.
    fn reach(&self) -> f64 {
        [self.corner, self.edges[0], self.edges[1]].iter().map(|v| largest(v.lane(0))).sum()
    }

    #[inline(always)]
    fn place(&self, u: [N; 2]) -> Vector<N> {
        let [s, t] = if self.is_triangle { warp::triangle(u) } else { u };
        self.corner + self.edges[0].scaled(s) + self.edges[1].scaled(t)
    }
}

impl<N: Width> Lamp<N> {
    /// Flat pieces of one radiance [W m⁻² sr⁻¹]; None if they have no area.
    pub fn flat(pieces: Vec<Piece<N>>, radiance: [f64; 3], two_sided: bool) -> Option<Self> {
        let shares = Shares::new(pieces.iter().map(|piece| piece.area.lane(0)))?;
        let form = match pieces[..] {
            [piece] => Form::Piece(piece),
            _ => Form::Pieces { area: N::of(shares.whole()), all: pieces, shares },
        };
        let reach = match &form {
            Form::Piece(piece) => piece.reach(),
            Form::Pieces { all, .. } => all.iter().map(Piece::reach).fold(0.0, f64::max),
            _ => 0.0,
        };
        Some(Self { form, light: radiance.map(N::of), two_sided, slack: slack(reach) })
    }

    /// A disc about a centre [m], of a unit normal and a radius [m].
    pub fn disc(center: [f64; 3], normal: [f64; 3], radius: f64, radiance: [f64; 3], two_sided: bool) -> Self {
        let form = Form::Disc {
            frame: Frame::about(Vector::of(normal)),
            center: Vector::of(center),
            radius: N::of(radius),
            area: N::of(PI * radius * radius),
        };
        Self { form, light: radiance.map(N::of), two_sided, slack: slack(largest(center) + radius) }
    }

    /// A ball about a centre [m], of a radius [m].
    pub fn ball(center: [f64; 3], radius: f64, radiance: [f64; 3], two_sided: bool) -> Self {
        let form = Form::Ball { center: Vector::of(center), radius: N::of(radius) };
        Self { form, light: radiance.map(N::of), two_sided, slack: slack(largest(center) + radius) }
    }

    /// A point [m] of an intensity [W sr⁻¹].
    pub fn point(position: [f64; 3], intensity: [f64; 3]) -> Self {
        Self {
            form: Form::Point(Vector::of(position)),
            light: intensity.map(N::of),
            two_sided: true,
            slack: N::of(0.0),
        }
    }

    /// Light that goes along a unit vector, of an irradiance [W m⁻²].
    pub fn sun(direction: [f64; 3], irradiance: [f64; 3]) -> Self {
        let form = Form::Sun(-Vector::of(direction));
        Self { form, light: irradiance.map(N::of), two_sided: true, slack: N::of(0.0) }
    }

    /// An image all around.
    pub fn panorama(panorama: Arc<Panorama>) -> Self {
        // What it sends depends on whence: there is no one radiance.
        Self { form: Form::Panorama(panorama), light: [0.0; 3].map(N::of), two_sided: true, slack: N::of(0.0) }
    }

    /// A direction from a point [m] to the lamp, drawn by two numbers 0 ≤ u < 1.
    #[inline(never)]
    pub fn sample(&self, from: Vector<N>, u: [N; 2]) -> Arrival<N> {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.drawn(from, u),
        )
    }

    #[inline(always)]
    fn drawn(&self, from: Vector<N>, u: [N; 2]) -> Arrival<N> {
        match &self.form {
            Form::Piece(piece) => self.by_area(from, piece.place(u), piece.normal, piece.area),
            Form::Pieces { all, shares, area } => {
                let [place, normal] = picked(all, shares, u);
                self.by_area(from, place, normal, *area)
            }
            Form::Disc { frame, center, radius, area } => {
                let [x, y] = warp::disc(u);
                let place = *center + frame.x.scaled(x * *radius) + frame.y.scaled(y * *radius);
                self.by_area(from, place, frame.z, *area)
            }
            Form::Ball { center, radius } => self.ball_from(from, *center, *radius, u),
            Form::Point(place) => {
                let (distance, wi) = length_and_way(*place - from);
                let falloff = N::of(1.0) / distance.squared();
                let share = self.light.map(|light| light * falloff);
                Arrival { wi, distance, share, pdf: N::of(f64::INFINITY), cos: N::of(1.0) }
            }
            Form::Sun(wi) => {
                let (distance, pdf) = (N::of(1e30), N::of(f64::INFINITY));
                Arrival { wi: *wi, distance, share: self.light, pdf, cos: N::of(1.0) }
            }
            Form::Panorama(panorama) => {
                let ([x, y, z], share, pdf) = panorama.drawn(u);
                let (wi, distance) = (Vector::new(x, y, z), N::of(1e30));
                Arrival { wi, distance, share, pdf: pdf.max(least()), cos: N::of(1.0) }
            }
        }
    }

    /// The density [sr⁻¹] with which [`Lamp::sample`] draws a direction from a point [m] that meets the lamp `distance` [m]
    /// away at the cosine `cos` [1] to its normal.
    #[inline(never)]
    pub fn pdf(&self, from: Vector<N>, distance: N, cos: N) -> N {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.density(from, distance, cos),
        )
    }

    #[inline(always)]
    fn density(&self, from: Vector<N>, distance: N, cos: N) -> N {
        let by_area = |area: N| distance.squared() / (area * cos.abs()).max(least());
        match &self.form {
            Form::Piece(piece) => by_area(piece.area),
            Form::Pieces { area, .. } | Form::Disc { area, .. } => by_area(*area),
            Form::Ball { center, radius } => {
                let seen = Cone::of(from, *center, *radius);
                N::select(seen.is_outside, warp::cone_density(seen.one_minus_cos), by_area(ball_area(*radius)))
            }
            // No surface of theirs is ever met.
            Form::Point(_) | Form::Sun(_) | Form::Panorama(_) => N::of(0.0),
        }
    }

    /// Flux [W], all channels together, of a scene that reaches `extent` [m] from its middle.
    pub fn flux(&self, extent: f64) -> f64 {
        if let Form::Panorama(panorama) = &self.form {
            return PI * extent * extent * panorama.whole();
        }
        let light: f64 = self.light.iter().map(|light| light.lane(0)).sum();
        let sides = if self.two_sided { 2.0 } else { 1.0 };
        light
            * match &self.form {
                Form::Piece(piece) => PI * piece.area.lane(0) * sides,
                Form::Pieces { area, .. } | Form::Disc { area, .. } => PI * area.lane(0) * sides,
                Form::Ball { radius, .. } => PI * ball_area(*radius).lane(0) * sides,
                Form::Point(_) => 4.0 * PI,
                Form::Sun(_) | Form::Panorama(_) => PI * extent * extent,
            }
    }

    /// Radiance [W m⁻² sr⁻¹] of what has an area.
    pub fn radiance(&self) -> Rgb<N> {
        self.light
    }

    /// The largest part of it.
    pub fn brightest(&self) -> f64 {
        self.light.iter().map(|light| light.lane(0)).fold(0.0, f64::max)
    }

    /// What it has of area [m²] from where it shines, both sides if it does so on both; None for lights without a surface.
    pub fn area(&self) -> Option<f64> {
        let sides = if self.two_sided { 2.0 } else { 1.0 };
        let one = match &self.form {
            Form::Piece(piece) => piece.area,
            Form::Pieces { area, .. } | Form::Disc { area, .. } => *area,
            Form::Ball { radius, .. } => ball_area(*radius),
            Form::Point(_) | Form::Sun(_) | Form::Panorama(_) => return None,
        };
        Some(one.lane(0) * sides)
    }

    /// A place on it, all alike, the normal on a side that shines, and where rays start from there; of what has an area.
    #[inline(always)]
    pub fn place(&self, u: [N; 2], side: N) -> [Vector<N>; 3] {
        let (place, normal) = match &self.form {
            Form::Piece(piece) => (piece.place(u), piece.normal),
            Form::Pieces { all, shares, .. } => {
                let [place, normal] = picked(all, shares, u);
                (place, normal)
            }
            Form::Disc { frame, center, radius, .. } => {
                let [x, y] = warp::disc(u);
                (*center + frame.x.scaled(x * *radius) + frame.y.scaled(y * *radius), frame.z)
            }
            Form::Ball { center, radius } => {
                let normal = warp::sphere(u);
                (*center + normal.scaled(*radius), normal)
            }
            Form::Point(place) => (*place, Vector::of([0.0, 0.0, 1.0])),
            Form::Sun(way) => (*way, -*way),
            Form::Panorama(_) => (Vector::of([0.0; 3]), Vector::of([0.0, 0.0, 1.0])),
        };
        let is_back = side.lt(N::of(if self.two_sided { 0.5 } else { 0.0 }));
        let normal = Vector::select(is_back, -normal, normal);
        [place, normal, place + normal.scaled(self.slack)]
    }

    /// What a place on it sends to a point.
    #[inline(always)]
    fn by_area(&self, from: Vector<N>, place: Vector<N>, normal: Vector<N>, area: N) -> Arrival<N> {
        let is_behind = (from - place).dot(normal).lt(N::of(0.0));
        let place = place + normal.scaled(N::select(is_behind, -self.slack, self.slack));
        let (distance, wi) = length_and_way(place - from);
        let facing = -wi.dot(normal);
        let cos = if self.two_sided { facing.abs() } else { facing.max(N::of(0.0)) };
        // Never 0, so that quotients of densities are numbers.
        let pdf = (distance.squared() / (area * cos).max(least())).max(least());
        let inverse = area * cos / distance.squared().max(least());
        Arrival { wi, distance, share: rgb(|c| self.light[c] * inverse), pdf, cos }
    }

    #[inline(always)]
    fn ball_from(&self, from: Vector<N>, center: Vector<N>, radius: N, u: [N; 2]) -> Arrival<N> {
        let Cone { is_outside, distance, axis, one_minus_cos } = Cone::of(from, center, radius);
        let (way, off) = warp::cone(one_minus_cos, u);
        let wi = Frame::about(axis).outward(way);
        // The nearer end of the chord: how far the centre's foot on the ray, less half the chord. Where it is short, nobody
        // knows its length to better than the root of a rounding, and the ball must not stand in its own way: rays end
        // at one that is larger by as much.
        let beside2 = distance.squared() * off * (N::of(2.0) - off);
        let doubt = N::of(16.0 * N::EPSILON) * distance.squared();
        let half = ((radius.squared() - beside2).max(N::of(0.0)) + doubt).sqrt();
        let solid = N::of(2.0 * PI) * one_minus_cos;
        let outside = Arrival {
            wi,
            distance: (distance * (N::of(1.0) - off) - half).max(N::of(0.0)),
            share: rgb(|c| self.light[c] * solid),
            pdf: warp::cone_density(one_minus_cos),
            cos: (half / radius).min(N::of(1.0)),
        };
        if !self.two_sided || !(!is_outside).any() {
            return Arrival { share: rgb(|c| outside.share[c].only(is_outside)), ..outside };
        }
        let normal = warp::sphere(u);
        let inside = self.by_area(from, center + normal.scaled(radius), normal, ball_area(radius));
        Arrival {
            wi: Vector::select(is_outside, outside.wi, inside.wi),
            distance: N::select(is_outside, outside.distance, inside.distance),
            share: rgb(|c| N::select(is_outside, outside.share[c], inside.share[c])),
            pdf: N::select(is_outside, outside.pdf, inside.pdf),
            cos: N::select(is_outside, outside.cos, inside.cos),
        }
    }
}

/// Places on pieces drawn by area, and the normals there.
#[inline(never)]
fn picked<N: Width>(all: &[Piece<N>], shares: &Shares, u: [N; 2]) -> [Vector<N>; 2] {
    let rows = N::columns(|lane| {
        let (at, rest) = shares.pick(u[0].lane(lane));
        let piece = &all[at];
        let place = piece.place([N::of(rest), N::of(u[1].lane(lane))]);
        let row = |v: Vector<N>| [v.x.get(0), v.y.get(0), v.z.get(0)];
        let ([x, y, z], [a, b, c]) = (row(place), row(piece.normal));
        [x, y, z, a, b, c]
    });
    let [x, y, z, a, b, c] = rows;
    [Vector::new(x, y, z), Vector::new(a, b, c)]
}

/// A ball as a point sees it.
struct Cone<N: Width> {
    is_outside: N::Mask,
    distance: N,
    axis: Vector<N>,
    one_minus_cos: N,
}

impl<N: Width> Cone<N> {
    #[inline(always)]
    fn of(from: Vector<N>, center: Vector<N>, radius: N) -> Self {
        let (distance, axis) = length_and_way(center - from);
        let sin2 = radius.squared() / distance.squared().max(least());
        // A place on the ball itself is not outside, whichever way it is rounded.
        let is_outside = sin2.lt(N::of(1.0 - 64.0 * N::EPSILON));
        let axis = Vector::select(is_outside, axis, Vector::of([0.0, 0.0, 1.0]));
        Self { is_outside, distance, axis, one_minus_cos: warp::one_minus_cos(sin2.min(N::of(1.0))) }
    }
}

#[inline(always)]
fn ball_area<N: Width>(radius: N) -> N {
    N::of(4.0 * PI) * radius.squared()
}

/// Of what reaches so far.
fn slack<N: Width>(reach: f64) -> N {
    N::of(8.0 * N::EPSILON * reach)
}

/// What keeps quotients of nothing finite.
#[inline(always)]
fn least<N: Width>() -> N {
    N::of(f64::from(f32::MIN_POSITIVE))
}
