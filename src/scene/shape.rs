//! What there is to see.

use super::Triple;
use super::triple::{cross, dot, length, minus, plus, widened};
use std::path::PathBuf;
use std::sync::Arc;

/// A shape, what it is made of, and what it sends out.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Its form, before [`Shape::transform`].
    pub geometry: Geometry,
    /// The name of its material.
    pub material: String,
    /// What it sends out.
    pub emission: Option<Emission>,
    /// Where it is put.
    pub transform: Transform,
}

/// What a surface sends out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emission {
    /// [W m⁻² sr⁻¹].
    pub radiance: Triple,
    /// From both sides, not from that of the normal alone.
    pub two_sided: bool,
}

/// A form.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// A parallelogram; its normal is (v₁ − v₀) × (v₃ − v₀).
    Quad {
        /// Its corners [m] in order.
        vertices: [Triple; 4],
    },
    /// A ball, its normal outward.
    Sphere {
        /// [m].
        center: Triple,
        /// [m].
        radius: f64,
    },
    /// A flat disc.
    Disc {
        /// [m].
        center: Triple,
        /// Of any length but 0.
        normal: Triple,
        /// [m].
        radius: f64,
    },
    /// Six rectangles along the axes, their normals outward.
    Box {
        /// The least corner [m].
        min: Triple,
        /// The largest [m].
        max: Triple,
    },
    /// Triangles.
    Mesh {
        /// Where they were read from, as a scene file names it; None if they were made.
        file: Option<PathBuf>,
        /// Whether their normals are smoothed.
        normals: Normals,
        /// They.
        mesh: Arc<Mesh>,
    },
}

/// How the surface of a mesh looks between its corners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Normals {
    /// As flat as it is.
    #[default]
    Flat,
    /// By normals between those of the corners, which the mesh must have.
    Smooth,
}

impl Normals {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Flat, Self::Smooth];

    /// Its word in a scene file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Smooth => "smooth",
        }
    }
}

/// Triangles that share corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners [m].
    pub positions: Vec<[f32; 3]>,
    /// A direction a corner, of any length but 0, or none at all.
    pub normals: Vec<[f32; 3]>,
    /// A place on an image a corner, right and up [1] from its lower left corner, or none at all.
    pub texture: Vec<[f32; 2]>,
    /// Three corners each; the normal's side sees them counterclockwise.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// A prism over a flat convex section [m] of `N` ≥ 3 corners in order, as long as a vector [m] that does not lie in it;
    /// its faces look outward.
    pub fn prism<const N: usize>(section: [Triple; N], along: Triple) -> Self {
        let far = section.map(|corner| plus(corner, along));
        let positions = section.iter().chain(&far).map(|corner| corner.map(|x| x as f32)).collect();
        let normal = cross(minus(section[1], section[0]), minus(section[2], section[0]));
        let n = N as u32;
        let mut triangles: Vec<_> = (1..n - 1).flat_map(|k| [[0, k + 1, k], [n, n + k, n + k + 1]]).collect();
        for k in 0..n {
            let next = (k + 1) % n;
            triangles.extend([[k, next, next + n], [k, next + n, k + n]]);
        }
        if dot(normal, along) < 0.0 {
            triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        Self { positions, triangles, ..Self::default() }
    }

    /// (v₁ − v₀) × (v₂ − v₀) [m²] of a triangle, twice its area along its normal.
    ///
    /// # Panics
    /// If it has a corner that there is not.
    pub fn area(&self, triangle: [u32; 3]) -> Triple {
        let [a, b, c] = triangle.map(|corner| widened(self.positions[corner as usize]));
        cross(minus(b, a), minus(c, a))
    }

    /// Leaves out the triangles without area, which nothing can hit; how many those were.
    ///
    /// # Panics
    /// If a triangle has a corner that there is not.
    pub fn drop_flat(&mut self) -> usize {
        let before = self.triangles.len();
        let mut triangles = std::mem::take(&mut self.triangles);
        triangles.retain(|triangle| dot(self.area(*triangle), self.area(*triangle)) > 0.0);
        self.triangles = triangles;
        before - self.triangles.len()
    }

    /// The same with a normal a corner: the mean of those of its triangles, weighed by their areas. Where these cancel, or
    /// there are none, that of one of its triangles, or z.
    ///
    /// # Panics
    /// If a triangle has a corner that there is not.
    pub fn smoothed(self) -> Self {
        let mut sums = vec![[0.0; 3]; self.positions.len()];
        let mut ones = vec![[0.0, 0.0, 1.0]; self.positions.len()];
        for triangle in &self.triangles {
            let area = self.area(*triangle);
            for corner in triangle.map(|corner| corner as usize) {
                sums[corner] = plus(sums[corner], area);
                if length(area) > 0.0 {
                    ones[corner] = area;
                }
            }
        }
        let mean = |(sum, one): (Triple, Triple)| {
            // As single numbers they must not vanish either.
            let unit = |of: Triple| super::triple::normalised(of).map(|x| x as f32);
            if length(sum) > f64::EPSILON * length(one) { unit(sum) } else { unit(one) }
        };
        Self { normals: sums.into_iter().zip(ones).map(mean).collect(), ..self }
    }
}

/// Scaled first, then turned about x, y and z in that order, then moved. Mirrored, by an odd number of negative scales, a
/// surface keeps its sides: what was outside stays outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// By axis [1]; not 0. The same size along all three for spheres and discs.
    pub scale: Triple,
    /// [deg].
    pub rotate_deg: Triple,
    /// [m].
    pub translate: Triple,
}

impl Default for Transform {
    /// Leaves everything where it is.
    fn default() -> Self {
        Self { scale: [1.0; 3], rotate_deg: [0.0; 3], translate: [0.0; 3] }
    }
}

impl Transform {
    /// Ready to be used for many points.
    pub fn map(&self) -> Map {
        let [(sx, cx), (sy, cy), (sz, cz)] = self.rotate_deg.map(sin_cos_deg);
        // About x first, then y, then z.
        let rotation = [
            [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
            [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
            [-sy, cy * sx, cy * cx],
        ];
        let is_mirror = self.scale.iter().filter(|part| **part < 0.0).count() % 2 == 1;
        Map { scale: self.scale, rotation, translate: self.translate, is_mirror }
    }
}

/// Where a [`Transform`] takes points, ways and normals. Quarter turns are exact.
#[derive(Clone, Copy, Debug)]
pub struct Map {
    scale: Triple,
    /// Row by row.
    rotation: [Triple; 3],
    translate: Triple,
    is_mirror: bool,
}

impl Map {
    /// Whether it turns right into left.
    pub fn is_mirror(&self) -> bool {
        self.is_mirror
    }

    /// Where a point goes [m].
    pub fn point(&self, point: Triple) -> Triple {
        plus(self.way(point), self.translate)
    }

    /// Where a way goes [m]: scaled and turned, not moved.
    pub fn way(&self, way: Triple) -> Triple {
        self.turned(std::array::from_fn(|axis| way[axis] * self.scale[axis]))
    }

    /// Where a normal goes, which stays square to the surface: of another length.
    pub fn normal(&self, normal: Triple) -> Triple {
        self.turned(std::array::from_fn(|axis| normal[axis] / self.scale[axis]))
    }

    /// What a length becomes [m] where the scale is the same along all axes.
    pub fn length(&self, length: f64) -> f64 {
        length * self.scale[0].abs()
    }

    fn turned(&self, way: Triple) -> Triple {
        self.rotation.map(|row| dot(row, way))
    }
}

/// Sine and cosine of an angle [deg], exact at quarter turns.
fn sin_cos_deg(angle: f64) -> (f64, f64) {
    let quarters = (angle / 90.0).round();
    let (sin, cos) = (angle - 90.0 * quarters).to_radians().sin_cos();
    match quarters.rem_euclid(4.0) as u8 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_is_scaled_then_turned_about_x_y_and_z_then_moved() {
        let quarter = Transform { scale: [2.0, 3.0, 5.0], rotate_deg: [90.0, 0.0, 0.0], translate: [0.0, 0.0, 1.0] };
        // About x, y goes to z and z to −y.
        assert_eq!(quarter.map().point([1.0, 1.0, 1.0]), [2.0, -5.0, 4.0]);
        let two = Transform { rotate_deg: [90.0, 0.0, 90.0], ..Transform::default() };
        // x, y, z → x, −z, y → z, x, y: the second turn is about the axis that stands still.
        assert_eq!(two.map().point([1.0, 2.0, 3.0]), [3.0, 1.0, 2.0]);
        let all = Transform { rotate_deg: [90.0, -90.0, 450.0], ..Transform::default() };
        // x, −z, y → (about y by −90: z to −x, x to z) → −y, −z, x → z, −y, x.
        assert_eq!(all.map().point([1.0, 2.0, 3.0]), [3.0, -2.0, 1.0]);
    }

    #[test]
    fn turning_keeps_lengths_and_angles() {
        let any = Transform { rotate_deg: [12.0, 345.0, -678.9], ..Transform::default() };
        let rows = any.map().rotation;
        for a in 0..3 {
            for b in 0..3 {
                let expected = f64::from(u8::from(a == b));
                // A dozen roundings of numbers up to 1.
                assert!((dot(rows[a], rows[b]) - expected).abs() < 16.0 * f64::EPSILON, "{rows:?}");
            }
        }
        // No mirror.
        assert!(dot(cross(rows[0], rows[1]), rows[2]) > 0.0);
    }

    /// A square of two triangles, one more without area, and a corner that none has.
    fn square() -> Mesh {
        Mesh {
            positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [9.0, 9.0, 9.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3], [0, 2, 2], [1, 1, 1]],
            ..Mesh::default()
        }
    }

    #[test]
    fn triangles_without_area_are_left_out_and_counted() {
        let mut mesh = square();
        mesh.triangles.push([0, 1, 2]);
        assert_eq!((mesh.drop_flat(), mesh.triangles.len()), (2, 3));
        assert_eq!(mesh.drop_flat(), 0);
        // Thin is not flat, whatever its size.
        mesh.positions = vec![[0.0, 0.0, 0.0], [1e-20, 0.0, 0.0], [0.0, 1e-30, 0.0]];
        mesh.triangles = vec![[0, 1, 2]];
        assert_eq!(mesh.drop_flat(), 0);
    }

    #[test]
    fn smoothed_normals_are_those_of_the_triangles_about_a_corner() {
        let flat = square().smoothed();
        assert!(flat.normals.iter().all(|normal| *normal == [0.0, 0.0, 1.0]), "{:?}", flat.normals);
        // Both sides of one sheet: nothing is left of the mean.
        let mut both = square();
        both.triangles = vec![[0, 1, 2], [0, 2, 1]];
        assert!(both.smoothed().normals.iter().all(|normal| normal[2].abs() == 1.0));
        // A roof whose halves are of the same area: up at the ridge.
        let roof = Mesh {
            positions: vec![[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]],
            triangles: vec![[0, 2, 1], [0, 1, 3]],
            ..Mesh::default()
        };
        assert_eq!(roof.smoothed().normals[0], [0.0, 0.0, 1.0]);
    }
}
