//! A scene's shapes as primitives.

use super::Primitive;
use crate::scene::triple::{minus, times};
use crate::scene::{Geometry, Normals, Scene, Shape, Triple};

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

    /// The first primitive of a shape.
    pub fn start(&self, shape: usize) -> usize {
        self.starts[shape] as usize
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
        let place = |at: Triple| times(minus(at, middle), scale);
        let sized = |way: Triple| times(way, scale);
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
    let map = shape.transform.map();
    match &shape.geometry {
        Geometry::Quad { vertices: [a, b, _, d] } => {
            let [u, v] = [b, d].map(|corner| map.way(minus(*corner, *a)));
            let edges = if map.is_mirror() { [v, u] } else { [u, v] };
            primitives.push(Primitive::Quad { corner: map.point(*a), edges });
        }
        Geometry::Sphere { center, radius } => {
            primitives.push(Primitive::Sphere { center: map.point(*center), radius: map.length(*radius) });
        }
        Geometry::Disc { center, normal, radius } => primitives.push(Primitive::Disc {
            center: map.point(*center),
            normal: map.normal(*normal),
            radius: map.length(*radius),
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
                        map.way(edge)
                    };
                    let [one, other] = if is_high != map.is_mirror() { [1, 2] } else { [2, 1] };
                    primitives.push(Primitive::Quad { corner: map.point(start), edges: [along(one), along(other)] });
                }
            }
        }
        Geometry::Mesh { normals, mesh, .. } => {
            let position = |at: u32| map.point(mesh.positions[at as usize].map(f64::from));
            let is_smooth = *normals == Normals::Smooth && mesh.normals.len() == mesh.positions.len();
            let normal = |at: u32| map.normal(mesh.normals[at as usize].map(f64::from)).map(|part| part as f32);
            primitives.extend(mesh.triangles.iter().map(|&[a, b, c]| {
                let corners = if map.is_mirror() { [a, c, b] } else { [a, b, c] };
                let normals = is_smooth.then(|| corners.map(normal));
                Primitive::Triangle { corners: corners.map(position), normals }
            }));
        }
    }
}
