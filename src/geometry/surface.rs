//! What a surface is like where it is met, and how to leave it again.

use super::bvh::Bvh;
use super::planar::{disc_axes, largest, unit};
use super::primitive::{triple, vector};
use super::{Hit, Primitive, Ray, Sphere};
use crate::number::{Number, Vector, Width};

/// A point of a surface.
#[derive(Clone, Copy, Debug)]
pub struct Surface<N> {
    /// On the primitive [m], to a few roundings of its place and size; o + t d has those of the ray's way besides.
    pub point: Vector<N>,
    /// Of the primitive itself, as it is turned; of length 1.
    pub normal: Vector<N>,
    /// That of a smooth mesh, to 2e−6; [`Self::normal`] elsewhere. Of length 1.
    pub shading: Vector<N>,
    /// [`Hit::u`] and [`Hit::v`].
    pub uv: [N; 2],
    /// How far [m] beside the point the surface may be met.
    pub slack: N,
}

/// Roundings by which a surface may be met beside its point, in coordinates and sizes.
const SLACK: f64 = 4.0;

impl<N: Number> Surface<N> {
    /// Where a ray in `direction` starts so that it does not meet the surface it leaves: off the point, on that side of
    /// the surface to which it goes, as far as rounding asks. Between two surfaces a segment runs from what leaves the one
    /// to what leaves the other, its direction the whole way, and ends at t = 1.
    #[inline(always)]
    pub fn leave(&self, direction: Vector<N>) -> Vector<N> {
        let side = N::select(self.normal.dot(direction).lt(N::of(0.0)), -self.slack, self.slack);
        self.point + self.normal.scaled(side)
    }
}

/// |x| + |y| + |z|.
#[inline(always)]
fn size<N: Number>(v: Vector<N>) -> N {
    v.x.abs() + v.y.abs() + v.z.abs()
}

/// What surfaces are made from, by primitive.
#[derive(Clone, Debug)]
pub(super) struct Rows<N: Width> {
    /// Its row; or, with [`IN_PACKS`], the slot among the hierarchy's triangles.
    places: Vec<u32>,
    /// An origin and the radius if it is round, one axis and the power, another axis and whether it is a triangle, and
    /// the normal.
    rows: Vec<[N::Scalar; 16]>,
    /// The normals at a triangle's corners, packed; all 0 if flat. None at all if all are flat.
    smooth: Vec<[u32; 4]>,
    /// Whether there are spheres.
    has_round: bool,
    /// Whether there are triangles.
    has_triangles: bool,
}

/// Marks a place among the triangles of the hierarchy, which are kept there alone.
const IN_PACKS: u32 = 1 << 31;

impl<N: Width> Rows<N> {
    pub fn new(primitives: &[Primitive], many: Option<&Bvh<N::Pack>>) -> Self {
        let mut places = vec![0; primitives.len().max(1)];
        for (place, slot) in many.into_iter().flat_map(Bvh::slots) {
            places[place] = IN_PACKS | slot as u32;
        }
        let mut rows = Vec::new();
        for (place, primitive) in places.iter_mut().zip(primitives) {
            if *place == 0 {
                *place = rows.len() as u32;
                rows.push(row::<N>(primitive));
            }
        }
        if primitives.is_empty() {
            rows.push([N::Scalar::of(0.0); 16]);
        }
        let is_smooth = |one: &Primitive| matches!(one, Primitive::Triangle { normals: Some(_), .. });
        let smooth =
            if primitives.iter().any(is_smooth) { primitives.iter().map(packed_normals).collect() } else { Vec::new() };
        let has_round = primitives.iter().any(|one| matches!(one, Primitive::Sphere { .. }));
        let has_triangles = primitives.iter().any(|one| matches!(one, Primitive::Triangle { .. }));
        Self { places, rows, smooth, has_round, has_triangles }
    }

    /// What they occupy in memory [B].
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.places) + size_of_val(&*self.rows) + size_of_val(&*self.smooth)
    }

    #[inline(always)]
    pub fn surface(&self, many: Option<&Bvh<N::Pack>>, ray: &Ray<N>, hit: &Hit<N>) -> Surface<N> {
        let columns = N::columns(
            #[inline(always)]
            |lane| self.row(many, hit.primitive.place(lane)),
        );
        let [ox, oy, oz, radius, ux, uy, uz, power, vx, vy, vz, is_triangle, nx, ny, nz, _] = columns;
        let (origin, along, aside) = (Vector::new(ox, oy, oz), Vector::new(ux, uy, uz), Vector::new(vx, vy, vz));
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let mut point = origin + (along.scaled(hit.u) + aside.scaled(hit.v));
        let mut normal = Vector::new(nx, ny, nz);
        let mut extent = size(along) + size(aside);
        if self.has_round {
            // On a sphere the point of the ray, moved along the normal until its power is 0.
            let sphere = Sphere { anchor: origin, arm: along, power, radius };
            let (near, from_center, beyond) = sphere.power_of(ray.at(hit.t));
            let distance = from_center.dot(from_center).sqrt();
            let outward = from_center.scaled(one / distance);
            let moved = near - outward.scaled(beyond / (distance + radius));
            let is_round = radius.gt(zero);
            point = Vector::select(is_round, origin + moved, point);
            normal = Vector::select(is_round, outward, normal);
            extent = N::select(is_round, size(moved), extent);
        }
        if self.has_triangles {
            normal = Vector::select(is_triangle.gt(zero), across(along, aside), normal);
        }
        let slack = N::of(SLACK * N::EPSILON) * (size(point) + extent);
        let shading = if self.smooth.is_empty() { normal } else { self.shading(hit, normal) };
        Surface { point, normal, shading, uv: [hit.u, hit.v], slack }
    }

    /// The row of a primitive.
    #[inline(always)]
    fn row(&self, many: Option<&Bvh<N::Pack>>, primitive: usize) -> [N::Scalar; 16] {
        let at = primitive.min(self.places.len() - 1);
        let place = self.places[at];
        match many {
            Some(many) if place & IN_PACKS != 0 => triangle_row::<N>(many.corners((place & !IN_PACKS) as usize)),
            _ => self.rows[place as usize],
        }
    }

    /// The normal between those of the corners.
    #[inline(always)]
    fn shading(&self, hit: &Hit<N>, normal: Vector<N>) -> Vector<N> {
        let corners = N::columns(
            #[inline(always)]
            |lane| {
                let at = hit.primitive.place(lane).min(self.smooth.len() - 1);
                unpacked::<N::Scalar>(self.smooth[at])
            },
        );
        let [ax, ay, bx, by, cx, cy, is_smooth, _] = corners;
        let [a, b, c] = [from_square([ax, ay]), from_square([bx, by]), from_square([cx, cy])];
        let sum = a.scaled(N::of(1.0) - hit.u - hit.v) + b.scaled(hit.u) + c.scaled(hit.v);
        let square = sum.dot(sum);
        let is_smooth = is_smooth.gt(N::of(0.0)) & square.gt(N::of(0.0));
        Vector::select(is_smooth, sum.scaled(N::of(1.0) / square.sqrt()), normal)
    }
}

/// The direction of u × v, whatever their size; that of z if they have no area.
#[inline(always)]
fn across<N: Number>(u: Vector<N>, v: Vector<N>) -> Vector<N> {
    let normal = u.scaled(N::of(1.0) / largest(u)).cross(v.scaled(N::of(1.0) / largest(v)));
    let square = normal.dot(normal);
    let unit = normal.scaled(N::of(1.0) / square.sqrt());
    Vector::select(square.gt(N::of(0.0)), unit, Vector::of([0.0, 0.0, 1.0]))
}

fn row<N: Width>(primitive: &Primitive) -> [N::Scalar; 16] {
    let (origin, [u, v], normal, radius, power) = match *primitive {
        Primitive::Quad { corner, edges } => {
            let [u, v] = edges.map(|edge| vector(edge).scaled(0.5));
            (vector(corner) + u + v, [u, v], across(u, v), 0.0, 0.0)
        }
        Primitive::Disc { center, normal, radius } => {
            (vector(center), disc_axes(normal, radius), unit(vector(normal)).0, 0.0, 0.0)
        }
        Primitive::Sphere { center, radius } => {
            let sphere = Sphere::<N::Scalar>::new(center, radius);
            let [anchor, arm] = [sphere.anchor, sphere.arm].map(|v| vector(v.lane(0)));
            (anchor, [arm, Vector::of([0.0; 3])], arm, radius, sphere.power.lane(0))
        }
        Primitive::Triangle { corners, .. } => {
            return triangle_row::<N>(corners.map(|corner| corner.map(N::Scalar::of)));
        }
    };
    let [o, u, v, n] = [origin, u, v, normal].map(triple);
    let row = [o[0], o[1], o[2], radius, u[0], u[1], u[2], power, v[0], v[1], v[2], 0.0, n[0], n[1], n[2], 0.0];
    row.map(N::Scalar::of)
}

/// From corners as they are kept, so that it is the same wherever that is.
#[inline(always)]
fn triangle_row<N: Width>([a, b, c]: [[N::Scalar; 3]; 3]) -> [N::Scalar; 16] {
    let (zero, one) = (N::Scalar::of(0.0), N::Scalar::of(1.0));
    let (u, v) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    [a[0], a[1], a[2], zero, u[0], u[1], u[2], zero, v[0], v[1], v[2], one, zero, zero, zero, zero]
}

/// Steps from 0 to 1 of a packed coordinate.
const STEPS: f64 = ((1 << 20) - 1) as f64;

/// Three normals, each as a point of a square in 2 × 21 bits (Z. Cigolle et al., "A survey of efficient representations
/// for independent unit vectors", *JCGT* 3(2) (2014) 1: octahedral).
fn packed_normals(primitive: &Primitive) -> [u32; 4] {
    let &Primitive::Triangle { normals: Some(normals), .. } = primitive else {
        return [0; 4];
    };
    let mut bits = 1_u128 << 127;
    for (at, normal) in normals.into_iter().enumerate() {
        let [x, y, z] = triple(unit(vector(normal.map(f64::from))).0);
        let sum = x.abs() + y.abs() + z.abs();
        let (x, y) = (x / sum, y / sum);
        let folded = |part: f64, other: f64| (1.0 - other.abs()).copysign(part);
        let [x, y] = if z < 0.0 { [folded(x, y), folded(y, x)] } else { [x, y] };
        for (part, by) in [(x, 0), (y, 21)] {
            // Counted from the middle up, 0 … 2²¹ − 2; not a number is 0.
            bits |= u128::from(((part + 1.0) * STEPS).round() as u32) << (42 * at + by);
        }
    }
    [0, 32, 64, 96].map(|by| (bits >> by) as u32)
}

/// The six coordinates, −1 … 1, and whether there are any.
#[inline(always)]
fn unpacked<S: Number>([a, b, c, d]: [u32; 4]) -> [S; 8] {
    let (low, high) = (u64::from(a) | u64::from(b) << 32, u64::from(c) | u64::from(d) << 32);
    [
        coordinate(low),
        coordinate(low >> 21),
        coordinate(low >> 42),
        coordinate(low >> 63 | high << 1),
        coordinate(high >> 20),
        coordinate(high >> 41),
        S::of(f64::from((high >> 63) as u32)),
        S::of(0.0),
    ]
}

/// Of the lowest 21 bits.
#[inline(always)]
fn coordinate<S: Number>(bits: u64) -> S {
    S::of(f64::from((bits & 0x1f_ffff) as u32)) * S::of(1.0 / STEPS) - S::of(1.0)
}

/// Back from the square to the sphere.
#[inline(always)]
fn from_square<N: Number>([x, y]: [N; 2]) -> Vector<N> {
    let zero = N::of(0.0);
    let z = N::of(1.0) - x.abs() - y.abs();
    let fold = (-z).max(zero);
    let x = N::select(x.lt(zero), x + fold, x - fold);
    let y = N::select(y.lt(zero), y + fold, y - fold);
    Vector::new(x, y, z).normalised()
}
