//! Diffuse faces, and how they are cut into patches.

use super::Patch;
use crate::bsdf::Rgb;
use crate::geometry::{Primitive, flatten};
use crate::scene::{Flaw, Material, Scene, Shape, Triple};

/// A flat face that is the same all over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Where it is.
    pub patch: Patch,
    /// 1 − ρ [1] of each channel.
    pub absorbed: Rgb<f64>,
    /// The radiance [W m⁻² sr⁻¹] that it sends out by itself.
    pub emitted: Rgb<f64>,
}

/// Faces that see each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Room {
    /// All of them; their backs are black.
    pub faces: Vec<Face>,
    /// Whether every way from a face ends on one: what is not seen of others is then an error, else it is the dark.
    pub is_closed: bool,
}

impl Room {
    /// The inside of a box from the origin to `size` [m], what of the light each face absorbs [1] and what it sends out: those
    /// at x = 0 and x = `size[0]`, then y, then z.
    pub fn cuboid(size: Triple, faces: [(f64, f64); 6]) -> Self {
        let edge = |axis: usize| -> Triple { std::array::from_fn(|at| if at == axis { size[axis] } else { 0.0 }) };
        let face = |(at, (absorbed, emitted)): (usize, (f64, f64))| {
            let (axis, is_high) = (at / 2, at % 2 == 1);
            let [first, second] = [edge((axis + 1) % 3), edge((axis + 2) % 3)];
            // Inward.
            let patch = if is_high {
                Patch { corner: edge(axis), edges: [second, first] }
            } else {
                Patch { corner: [0.0; 3], edges: [first, second] }
            };
            Face { patch, absorbed: [absorbed; 3], emitted: [emitted; 3] }
        };
        Self { faces: faces.into_iter().enumerate().map(face).collect(), is_closed: true }
    }

    /// Of a scene whose shapes are flat, diffuse and bright on one side at most; what flies past all of them is lost.
    ///
    /// # Errors
    /// If a shape is not so, or there is light without a surface.
    pub fn of(scene: &Scene) -> Result<Self, Flaw> {
        let flat = flatten(scene);
        let mut faces = Vec::new();
        for (at, primitive) in flat.primitives.iter().enumerate() {
            let owner = flat.owners.shape(at);
            let flaw = |part: &'static str, why: &str| Flaw::of(part, why).within(owner).within("shapes");
            let Primitive::Quad { corner, edges } = *primitive else {
                return Err(flaw("geometry", "is not made of parallelograms; valid: a quad or a box"));
            };
            let Shape { material, emission, .. } = &scene.shapes[owner];
            let Some(Material::Diffuse { reflectance }) = scene.material(material) else {
                return Err(flaw("material", "is not diffuse, and has no one radiance"));
            };
            if emission.is_some_and(|emission| emission.two_sided) {
                return Err(flaw("emission", "is two-sided; valid: on the side of the normal"));
            }
            let emitted = emission.map_or([0.0; 3], |emission| emission.radiance);
            let absorbed = reflectance.map(|share| 1.0 - share);
            faces.push(Face { patch: Patch { corner, edges }, absorbed, emitted });
        }
        if scene.environment.is_some() || !scene.lights.is_empty() {
            return Err(Flaw::of("lights", "light that comes from no surface: there is no patch that sends it"));
        }
        Ok(Self { faces, is_closed: false })
    }

    /// Every face cut into `n` × `n`.
    pub fn cut(&self, n: usize) -> Patches {
        self.cut_by(|_| [n; 2])
    }

    /// Every face cut into pieces no longer than `most` [m].
    pub fn cut_to(&self, most: f64) -> Patches {
        let count = |edge: Triple| ((crate::scene::triple::length(edge) / most).ceil() as usize).max(1);
        self.cut_by(|face| face.patch.edges.map(count))
    }

    fn cut_by(&self, counts: impl Fn(&Face) -> [usize; 2]) -> Patches {
        let counts: Vec<_> = self.faces.iter().map(counts).collect();
        let (mut patches, mut owners, mut starts) = (Vec::new(), Vec::new(), Vec::new());
        for (at, (face, counts)) in self.faces.iter().zip(&counts).enumerate() {
            starts.push(patches.len());
            for j in 0..counts[1] {
                patches.extend((0..counts[0]).map(|i| face.patch.piece(*counts, [i, j])));
            }
            owners.resize(patches.len(), at);
        }
        Patches { room: self.clone(), list: patches, owners, counts, starts }
    }
}

/// A room in pieces: of each face row after row.
#[derive(Clone, Debug, PartialEq)]
pub struct Patches {
    /// What was cut.
    pub room: Room,
    /// All pieces.
    pub list: Vec<Patch>,
    /// The face of each.
    pub owners: Vec<usize>,
    /// Columns and rows of every face.
    pub counts: Vec<[usize; 2]>,
    /// Where every face's pieces begin.
    starts: Vec<usize>,
}

impl Patches {
    /// The pieces of a face.
    pub fn of_face(&self, face: usize) -> std::ops::Range<usize> {
        let [columns, rows] = self.counts[face];
        self.starts[face]..self.starts[face] + columns * rows
    }

    /// The mean [the unit of `values`] over a face of what each patch has.
    pub fn mean(&self, face: usize, values: &[f64]) -> f64 {
        let range = self.of_face(face);
        let count = range.len() as f64;
        values[range].iter().sum::<f64>() / count
    }

    /// The piece of a face that has the place (u, v) of it, 0 … 1.
    pub fn at(&self, face: usize, place: [f64; 2]) -> usize {
        let counts = self.counts[face];
        let [i, j] = [0, 1].map(|axis| ((place[axis] * counts[axis] as f64) as usize).min(counts[axis] - 1));
        self.starts[face] + j * counts[0] + i
    }
}
