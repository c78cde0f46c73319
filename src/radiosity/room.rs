//! Diffuse faces, and how they are cut into patches.

use super::{Outline, Patch};
use crate::bsdf::Rgb;
use crate::geometry::{Primitive, flatten};
use crate::scene::triple::{length, times};
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

impl Face {
    /// Columns and rows of pieces no longer than `most` [m].
    fn counts(&self, most: f64) -> [usize; 2] {
        let counts = self.patch.edges.map(|edge| ((length(edge) / most).ceil() as usize).max(1));
        match self.patch.outline {
            Outline::Parallelogram => counts,
            Outline::Triangle => [counts[0].max(counts[1]); 2],
        }
    }
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
                Patch::parallelogram(edge(axis), [second, first])
            } else {
                Patch::parallelogram([0.0; 3], [first, second])
            };
            Face { patch, absorbed: [absorbed; 3], emitted: [emitted; 3] }
        };
        Self { faces: faces.into_iter().enumerate().map(face).collect(), is_closed: true }
    }

    /// Of a scene whose shapes are flat, diffuse and bright on one side at most: a face of every primitive, in order. What
    /// flies past all of them is lost, and so is what falls on their backs ([`Room::with_backs`]).
    ///
    /// # Errors
    /// If a shape is not so, or there is light without a surface.
    pub fn of(scene: &Scene) -> Result<Self, Flaw> {
        let flat = flatten(scene);
        let mut faces = Vec::new();
        for (at, primitive) in flat.primitives.iter().enumerate() {
            let owner = flat.owners.shape(at);
            let flaw = |part: &'static str, why: &str| Flaw::of(part, why).within(owner).within("shapes");
            let patch = match *primitive {
                Primitive::Quad { corner, edges } => Patch::parallelogram(corner, edges),
                Primitive::Triangle { corners, normals: None } => Patch::triangle(corners),
                Primitive::Triangle { .. } => {
                    return Err(flaw("normals", "are smooth, and a patch has one; valid: flat"));
                }
                Primitive::Sphere { .. } | Primitive::Disc { .. } => {
                    return Err(flaw("geometry", "is not made of flat patches; valid: a quad, a box or a mesh"));
                }
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
            faces.push(Face { patch, absorbed, emitted });
        }
        let why = "is light that comes from no surface: there is no patch that sends it";
        if scene.environment.as_ref().is_some_and(|sky| !sky.is_black()) {
            return Err(Flaw::of("environment", why));
        }
        if !scene.lights.is_empty() {
            return Err(Flaw::of("lights", why));
        }
        Ok(Self { faces, is_closed: false })
    }

    /// With the backs that light gets to, and the number of each face's back: they reflect as the fronts do, and send nothing
    /// out by themselves.
    ///
    /// Light is followed from lamps over a few places of either side of every face, each of which is dark or not: what is
    /// reached through gaps narrower than these are apart may be missed.
    pub fn with_backs(mut self) -> (Self, Vec<Option<usize>>) {
        let is_lit = super::sight::lit(&self);
        let fronts = self.faces.len();
        let mut backs = vec![None; fronts];
        for at in (0..fronts).filter(|at| is_lit[fronts + at]) {
            backs[at] = Some(self.faces.len());
            let face = self.faces[at];
            self.faces.push(Face { patch: face.patch.back(), emitted: [0.0; 3], ..face });
        }
        (self, backs)
    }

    /// [m²].
    pub fn area(&self) -> f64 {
        self.faces.iter().map(|face| face.patch.area()).sum()
    }

    /// Every face cut into `n` × `n`.
    pub fn cut(&self, n: usize) -> Patches {
        self.cut_by(|_| [n; 2])
    }

    /// Every face cut into pieces no longer than `most` [m].
    pub fn cut_to(&self, most: f64) -> Patches {
        self.cut_by(|face| face.counts(most))
    }

    /// The same, but into no more than so many pieces in all, if there are not as many faces.
    pub fn cut_within(&self, mut most: f64, pieces: usize) -> Patches {
        let count = |face: &Face, most| face.counts(most).map(|count| count as f64).iter().product::<f64>();
        let all = |most: f64| self.faces.iter().map(|face| count(face, most)).sum::<f64>();
        while all(most) > pieces.max(self.faces.len()) as f64 {
            most *= 1.1;
        }
        self.cut_to(most)
    }

    /// Every face, a parallelogram, cut into `n` × `n`, the finer the nearer to its edges: there the light of a wall bends as
    /// some power of the distance, which depends on how white both walls are and spoils every extrapolation. At shares
    /// t³(10 − 15t + 6t²) of an edge, t = k/n, errors are sums of powers of 1/n that begin with the second, fourth and fifth.
    pub fn cut_graded(&self, n: usize) -> Patches {
        let shares: Vec<f64> =
            (0..=n).map(|k| k as f64 / n as f64).map(|t| t * t * t * (10.0 + t * (6.0 * t - 15.0))).collect();
        let mut patches = self.cut(n);
        for (at, owner) in patches.owners.iter().enumerate() {
            let (face, number) = (&self.faces[*owner].patch, at - patches.starts[*owner]);
            let [i, j] = [number % n, number / n];
            let width = |k: usize| shares[k + 1] - shares[k];
            let edges = [times(face.edges[0], width(i)), times(face.edges[1], width(j))];
            patches.list[at] = Patch { corner: face.at([shares[i], shares[j]]), edges, ..*face };
        }
        Patches { shares: Some(shares), ..patches }
    }

    fn cut_by(&self, counts: impl Fn(&Face) -> [usize; 2]) -> Patches {
        let counts: Vec<_> = self.faces.iter().map(counts).collect();
        let (mut patches, mut owners, mut starts) = (Vec::new(), Vec::new(), Vec::new());
        for (at, (face, counts)) in self.faces.iter().zip(&counts).enumerate() {
            starts.push(patches.len());
            patches.extend((0..face.patch.count(*counts)).map(|number| face.patch.piece(*counts, number)));
            owners.resize(patches.len(), at);
        }
        Patches { room: self.clone(), list: patches, owners, counts, starts, shares: None }
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
    /// Where edges are cut [1], if they are not cut evenly.
    shares: Option<Vec<f64>>,
}

impl Patches {
    /// The pieces of a face.
    pub fn of_face(&self, face: usize) -> std::ops::Range<usize> {
        self.starts[face]..self.starts[face] + self.room.faces[face].patch.count(self.counts[face])
    }

    /// The mean [the unit of `values`] over a face of what each patch has.
    pub fn mean(&self, face: usize, values: &[f64]) -> f64 {
        let range = self.of_face(face);
        if self.is_even() {
            let count = range.len() as f64;
            return values[range].iter().sum::<f64>() / count;
        }
        let sum: f64 = range.map(|at| self.list[at].area() * values[at]).sum();
        sum / self.room.faces[face].patch.area()
    }

    /// Whether the pieces of a face are all alike.
    pub fn is_even(&self) -> bool {
        self.shares.is_none()
    }

    /// The piece of a face that has the place (u, v) of it, 0 … 1; of a triangle u + v ≤ 1.
    pub fn at(&self, face: usize, place: [f64; 2]) -> usize {
        let counts = self.counts[face];
        let place = match &self.shares {
            None => place,
            Some(shares) => [0, 1].map(|axis| {
                let at = shares[1..].partition_point(|share| *share <= place[axis]).min(counts[axis] - 1);
                (at as f64 + 0.5) / counts[axis] as f64
            }),
        };
        self.starts[face] + self.room.faces[face].patch.number(counts, place)
    }
}
