//! What rays meet: against exact arithmetic, against counting, and each structure against the other.

mod areas;
mod build;
mod exact;
mod flat;
mod hostile;
mod structures;
mod surfaces;
mod walls;
mod watertight;

use super::primitive::{triple, vector};
use super::*;
use crate::number::F32x8;
use crate::scene::Triple;
use yardstick::random::{Stream, stream, uniform};

/// Numbers even in 0 … 1 and what is drawn with them.
struct Even(Stream);

impl Even {
    fn new(address: &str) -> Self {
        Self(stream(1, address))
    }

    fn number(&mut self) -> f64 {
        uniform(&mut self.0, 0.0, 1.0)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        uniform(&mut self.0, low, high)
    }

    /// Of size 10^low … 10^high, either sign.
    fn power(&mut self, low: f64, high: f64) -> f64 {
        let size = 10_f64.powf(self.between(low, high));
        if self.number() < 0.5 { -size } else { size }
    }

    /// In the cube −1 … 1.
    fn point(&mut self) -> Triple {
        [0; 3].map(|_| self.between(-1.0, 1.0))
    }

    /// Even on the sphere.
    fn direction(&mut self) -> Triple {
        let (z, phi) = (self.between(-1.0, 1.0), self.between(0.0, std::f64::consts::TAU));
        let r = (1.0 - z * z).sqrt();
        [r * phi.cos(), r * phi.sin(), z]
    }
}

/// As a width rounds it.
fn rounded<N: Width>(v: Triple) -> Triple {
    v.map(|part| N::of(part).lane(0))
}

fn ray<N: Width>(origin: Triple, direction: Triple) -> Ray<N> {
    Ray { origin: Vector::of(origin), direction: Vector::of(direction) }
}

/// A ray a lane.
fn rays(of: impl Fn(usize) -> (Triple, Triple)) -> Ray<F32x8> {
    let all: [(Triple, Triple); 8] = std::array::from_fn(of);
    let part = |pick: fn(&(Triple, Triple)) -> Triple| {
        let [x, y, z] = [0, 1, 2].map(|axis| F32x8::from_lanes(|lane| pick(&all[lane])[axis]));
        Vector::new(x, y, z)
    };
    Ray { origin: part(|(origin, _)| *origin), direction: part(|(_, direction)| *direction) }
}

/// Every lane.
fn active<N: Width>() -> N::Mask {
    N::of(0.0).le(N::of(0.0))
}

fn length(v: Vector<f64>) -> f64 {
    v.dot(v).sqrt()
}

fn plus(one: Triple, other: Triple, by: f64) -> Triple {
    triple(vector(one) + vector(other).scaled(by))
}

fn flat(corners: [Triple; 3]) -> Primitive {
    Primitive::Triangle { corners, normals: None }
}

fn quad(corner: Triple, edges: [Triple; 2]) -> Primitive {
    Primitive::Quad { corner, edges }
}

/// Six rectangles, their normals outward.
fn cube(low: Triple, high: Triple) -> Vec<Primitive> {
    let shape = crate::scene::Shape {
        geometry: crate::scene::Geometry::Box { min: low, max: high },
        material: String::new(),
        emission: None,
        transform: crate::scene::Transform::default(),
    };
    flatten::primitives(&shape)
}

/// Each triangle of a regular icosahedron divided `times` into four, its corners moved to where `at` says.
fn ball(times: u32, at: impl Fn(Triple) -> Triple) -> Vec<[Triple; 3]> {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let corners: Vec<Triple> = [-1.0, 1.0]
        .into_iter()
        .flat_map(|one| [-golden, golden].map(|other| [[0.0, one, other], [one, other, 0.0], [other, 0.0, one]]))
        .flatten()
        .collect();
    let distance = |i: usize, j: usize| length(vector(corners[i]) - vector(corners[j]));
    let mut faces = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if [distance(i, j), distance(j, k), distance(k, i)].iter().all(|edge| *edge < 2.1) {
                    let [a, b, c] = [i, j, k].map(|at| vector(corners[at]));
                    let outward = (b - a).cross(c - a).dot(a) > 0.0;
                    faces.push(if outward { [a, b, c] } else { [a, c, b] }.map(|corner| triple(corner.normalised())));
                }
            }
        }
    }
    for _ in 0..times {
        let middle = |a: Triple, b: Triple| triple((vector(a) + vector(b)).normalised());
        let divided = |[a, b, c]: [Triple; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(divided).collect();
    }
    faces.into_iter().map(|face| face.map(&at)).collect()
}

/// Something of everything, within −1 … 1.
fn soup(count: usize, even: &mut Even) -> Vec<Primitive> {
    let mut all: Vec<Primitive> = Vec::new();
    for at in 0..count {
        let (size, corner) = (even.power(-3.0, -0.2).abs(), even.point());
        let mut edge = || even.point().map(|part| size * part);
        let primitive = match at % 8 {
            0 => quad(corner, [edge(), edge()]),
            1 => Primitive::Sphere { center: corner, radius: 0.5 * size },
            2 => Primitive::Disc { center: corner, normal: edge(), radius: size },
            // Skew.
            3 => {
                let along = edge();
                quad(corner, [along, plus(along, edge(), 0.05)])
            }
            // A needle.
            4 => {
                let along = edge();
                flat([corner, plus(corner, along, 1.0), plus(plus(corner, along, 0.3), edge(), 1e-4)])
            }
            // One that is there already.
            5 if at > 10 => all[at / 2],
            _ => flat([corner, plus(corner, edge(), 1.0), plus(corner, edge(), 1.0)]),
        };
        all.push(primitive);
    }
    all
}
