//! A scene's shapes as primitives.

use super::Primitive;
use super::primitive::vector;
use crate::scene::{Geometry, Normals, Scene, Shape, Transform, Triple};

/// The primitives of a scene, shape after shape.
#[derive(Clone, Debug, Default)]
pub struct Flat {
    /// All of them.
    pub primitives: Vec<Primitive>,
    /// Whose they are.
    pub owners: Owners,
}

/// Which primitives belong to which shape.
#[derive(Clone, Debug, Default)]
pub struct Owners {
    /// Where each shape's begin.
    starts: Vec<u32>,
    /// The shape of every primitive, where that is no memory to speak of.
    shapes: Vec<u32>,
}

/// Primitives of which each has its shape written beside it; above, it is searched for.
const MOST_LISTED: usize = 1 << 12;

impl Owners {
    fn new(starts: Vec<u32>, primitives: usize) -> Self {
        let mut owners = Self { starts, shapes: Vec::new() };
        owners.shapes = (0..primitives.min(MOST_LISTED)).map(|at| owners.searched(at) as u32).collect();
        owners
    }

    /// The shape to which a primitive belongs.
    #[inline(always)]
    pub fn shape(&self, primitive: usize) -> usize {
        match self.shapes.get(primitive) {
            Some(shape) => *shape as usize,
            None => self.searched(primitive),
        }
    }

    #[inline(never)]
    fn searched(&self, primitive: usize) -> usize {
        self.starts.partition_point(|&start| start as usize <= primitive) - 1
    }
}

impl Flat {
    /// The primitives of a shape.
    pub fn of_shape(&self, shape: usize) -> &[Primitive] {
        let starts = &self.owners.starts;
        let start = |shape: usize| starts.get(shape).map_or(self.primitives.len(), |&start| start as usize);
        &self.primitives[start(shape)..start(shape + 1)]
    }

    /// The same, seen from `middle` [m], in a unit of which `scale` make a metre.
    pub fn seen_from(mut self, middle: Triple, scale: f64) -> Self {
        let place = |at: Triple| minus(at, middle).map(|part| part * scale);
        let sized = |way: Triple| way.map(|part| part * scale);
        for primitive in &mut self.primitives {
            match primitive {
                Primitive::Quad { corner, edges } => (*corner, *edges) = (place(*corner), edges.map(sized)),
                Primitive::Sphere { center, radius } | Primitive::Disc { center, radius, .. } => {
                    (*center, *radius) = (place(*center), *radius * scale);
                }
                Primitive::Triangle { corners, .. } => *corners = corners.map(place),
            }
        }
        self
    }
}

/// What a scene without a flaw is made of, [m]. What is outside stays outside where a scale mirrors.
pub fn flatten(scene: &Scene) -> Flat {
    let (mut primitives, mut starts) = (Vec::new(), Vec::new());
    for shape in &scene.shapes {
        starts.push(primitives.len() as u32);
        add(shape, &mut primitives);
    }
    let owners = Owners::new(starts, primitives.len());
    Flat { primitives, owners }
}

/// Those of one shape.
#[cfg(test)]
pub(super) fn primitives(shape: &Shape) -> Vec<Primitive> {
    let mut all = Vec::new();
    add(shape, &mut all);
    all
}

fn add(shape: &Shape, primitives: &mut Vec<Primitive>) {
    let map = Map::new(&shape.transform);
    match &shape.geometry {
        Geometry::Quad { vertices: [a, b, _, d] } => {
            let [u, v] = [b, d].map(|corner| map.turned(minus(*corner, *a)));
            let edges = if map.is_mirror { [v, u] } else { [u, v] };
            primitives.push(Primitive::Quad { corner: map.moved(*a), edges });
        }
        Geometry::Sphere { center, radius } => {
            primitives.push(Primitive::Sphere { center: map.moved(*center), radius: radius * map.scale[0].abs() });
        }
        Geometry::Disc { center, normal, radius } => primitives.push(Primitive::Disc {
            center: map.moved(*center),
            normal: map.upright(*normal),
            radius: radius * map.scale[0].abs(),
        }),
        Geometry::Box { min, max } => {
            let corner = |at: [bool; 3]| std::array::from_fn(|axis| if at[axis] { max[axis] } else { min[axis] });
            for axis in 0..3 {
                for is_high in [false, true] {
                    // The face's first corner and the two axes along it, so turned that the normal points out.
                    let start = corner(std::array::from_fn(|other| other == axis && is_high));
                    let along = |by: usize| {
                        let side = (axis + by) % 3;
                        let edge: Triple =
                            std::array::from_fn(|other| if other == side { max[side] - min[side] } else { 0.0 });
                        map.turned(edge)
                    };
                    let [one, other] = if is_high != map.is_mirror { [1, 2] } else { [2, 1] };
                    primitives.push(Primitive::Quad { corner: map.moved(start), edges: [along(one), along(other)] });
                }
            }
        }
        Geometry::Mesh { normals, mesh, .. } => {
            let position = |at: u32| map.moved(mesh.positions[at as usize].map(f64::from));
            let is_smooth = *normals == Normals::Smooth && mesh.normals.len() == mesh.positions.len();
            let normal = |at: u32| map.upright(mesh.normals[at as usize].map(f64::from)).map(|part| part as f32);
            primitives.extend(mesh.triangles.iter().map(|&[a, b, c]| {
                let corners = if map.is_mirror { [a, c, b] } else { [a, b, c] };
                let normals = is_smooth.then(|| corners.map(normal));
                Primitive::Triangle { corners: corners.map(position), normals }
            }));
        }
    }
}

fn minus(one: Triple, other: Triple) -> Triple {
    std::array::from_fn(|axis| one[axis] - other[axis])
}

/// A transform, ready to be used.
struct Map {
    scale: Triple,
    /// Rows of the rotation.
    rotation: [Triple; 3],
    translate: Triple,
    is_mirror: bool,
}

impl Map {
    fn new(transform: &Transform) -> Self {
        let [(sx, cx), (sy, cy), (sz, cz)] = transform.rotate_deg.map(turn);
        // About x first, then y, then z.
        let rotation = [
            [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
            [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
            [-sy, cy * sx, cy * cx],
        ];
        let is_mirror = transform.scale.iter().filter(|part| **part < 0.0).count() % 2 == 1;
        Self { scale: transform.scale, rotation, translate: transform.translate, is_mirror }
    }

    fn rotated(&self, v: Triple) -> Triple {
        self.rotation.map(|row| vector(row).dot(vector(v)))
    }

    /// Of a way.
    fn turned(&self, v: Triple) -> Triple {
        self.rotated(std::array::from_fn(|axis| v[axis] * self.scale[axis]))
    }

    /// Of a point.
    fn moved(&self, v: Triple) -> Triple {
        let turned = self.turned(v);
        std::array::from_fn(|axis| turned[axis] + self.translate[axis])
    }

    /// Of a normal, which stays square to the surface.
    fn upright(&self, v: Triple) -> Triple {
        self.rotated(std::array::from_fn(|axis| v[axis] / self.scale[axis]))
    }
}

/// Sine and cosine of an angle [deg], exact at quarter turns.
fn turn(degrees: f64) -> (f64, f64) {
    let quarters = (degrees / 90.0).round();
    let (sin, cos) = (degrees - 90.0 * quarters).to_radians().sin_cos();
    match quarters.rem_euclid(4.0) as u8 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}
