//! Nodes: what they hold, where the matrices above them put it.

use super::primitives::{Places, triangles};
use super::{Found, HEIGHT, Part, Reading};
use gltf::camera::Projection;
use gltf::khr_lights_punctual::Kind;
use light::scene::{Camera, Light, Mesh, Triple};

/// Luminous efficacy [lm W⁻¹] by which KHR_lights_punctual's candelas and luxes become watts.
const EFFICACY: f64 = 683.0;
/// The most corners, and corners of triangles, all nodes together: a mesh may be put in many places.
pub const MOST: usize = 1 << 26;
/// How deep nodes may lie in each other.
const DEEPEST: usize = 512;

/// Rows of a matrix that takes points to points.
type Matrix = [[f64; 4]; 3];

/// All that the nodes of a scene hold.
pub fn found(reading: &mut Reading, document: &gltf::Document, scene: &gltf::Scene) -> Result<Found, String> {
    let mut found = Found::default();
    let mut seen = vec![false; document.nodes().count()];
    let one = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    // No call within a call: a file may be as deep as it is long.
    let mut left: Vec<(gltf::Node, Matrix, usize)> = scene.nodes().map(|node| (node, one, 0)).collect();
    left.reverse();
    while let Some((node, parent, depth)) = left.pop() {
        let place = format!("nodes[{}]", node.index());
        if std::mem::replace(&mut seen[node.index()], true) {
            return Err(format!("{place}: is met twice; valid: a tree, in which each node has one parent"));
        }
        if depth > DEEPEST {
            return Err(format!("{place}: lies deeper than {DEEPEST} nodes in each other"));
        }
        let matrix = product(&parent, &node.transform().matrix().map(|column| column.map(f64::from)));
        if !matrix.iter().flatten().all(|part| part.is_finite()) {
            return Err(format!("{place}: its matrix has what is no finite number"));
        }
        take(reading, &mut found, &node, &matrix).map_err(|why| format!("{place}: {why}"))?;
        let before = left.len();
        left.extend(node.children().map(|child| (child, matrix, depth + 1)));
        left[before..].reverse();
    }
    Ok(found)
}

/// What a node is.
fn take(reading: &mut Reading, found: &mut Found, node: &gltf::Node, matrix: &Matrix) -> Result<(), String> {
    let way = |[x, y, z]: Triple| -> Triple {
        std::array::from_fn(|row| matrix[row][0] * x + matrix[row][1] * y + matrix[row][2] * z)
    };
    let origin: Triple = std::array::from_fn(|row| matrix[row][3]);
    if let Some(camera) = node.camera() {
        match camera.projection() {
            Projection::Orthographic(_) => reading.left_out("orthographic cameras"),
            Projection::Perspective(of) => {
                let aspect = f64::from(of.aspect_ratio().unwrap_or(1.0));
                let ahead = way([0.0, 0.0, -1.0]);
                found.cameras.push(Camera {
                    origin,
                    target: std::array::from_fn(|axis| origin[axis] + ahead[axis]),
                    up: way(Camera::UP),
                    fov_y_deg: f64::from(of.yfov()).to_degrees(),
                    width: (f64::from(HEIGHT) * aspect).round().clamp(1.0, 16384.0) as u32,
                    height: HEIGHT,
                    aperture: 0.0,
                    focus: None,
                    polariser_deg: None,
                });
            }
        }
    }
    if let Some(light) = node.light() {
        let sent = light.color().map(|part| f64::from(part) * f64::from(light.intensity()) / EFFICACY);
        if light.range().is_some() {
            reading.left_out("ranges of lights");
        }
        found.lights.push(match light.kind() {
            Kind::Point => Light::Point { position: origin, intensity: sent },
            Kind::Directional => Light::Directional { direction: way([0.0, 0.0, -1.0]), irradiance: sent },
            Kind::Spot { .. } => {
                let why = "a spot light of KHR_lights_punctual cannot be used; valid: point, directional";
                found.unusable.get_or_insert(format!("nodes[{}]: {why}", node.index()));
                // Whoever takes the shape alone needs no light.
                Light::Point { position: origin, intensity: [0.0; 3] }
            }
        });
    }
    let Some(mesh) = node.mesh() else { return Ok(()) };
    for primitive in mesh.primitives() {
        let place = format!("meshes[{}].primitives[{}]", mesh.index(), primitive.index());
        let places = Places::of(&primitive, reading.is_scene);
        if let Some(mut mesh) = triangles(reading, &primitive, &places).map_err(|why| format!("{place}: {why}"))? {
            found.corners = found.corners.saturating_add(mesh.positions.len() + 3 * mesh.triangles.len());
            if found.corners > MOST {
                return Err(format!("{place}: makes more than {MOST} corners, the most that are read"));
            }
            put(&mut mesh, matrix).map_err(|why| format!("{place}: {why}"))?;
            let all = mesh.triangles.len();
            found.flat += mesh.drop_flat();
            if mesh.triangles.is_empty() {
                return Err(format!("{place}: none of its {all} triangles has an area"));
            }
            found.parts.push(Part { mesh, material: primitive.material().index(), place, set: places.set });
        }
    }
    Ok(())
}

/// Puts a mesh where a matrix takes it. Mirrored it keeps its sides.
fn put(mesh: &mut Mesh, matrix: &Matrix) -> Result<(), String> {
    let row = |row: usize| [matrix[row][0], matrix[row][1], matrix[row][2]];
    let cross =
        |a: Triple, b: Triple| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let dot = |a: Triple, b: Triple| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    // Normals go by the cofactors, the inverse transposed but for its size.
    let mut cofactors = [cross(row(1), row(2)), cross(row(2), row(0)), cross(row(0), row(1))];
    let determinant = dot(row(0), cofactors[0]);
    if !determinant.is_finite() {
        return Err("is scaled beyond all numbers".into());
    }
    if determinant < 0.0 {
        mesh.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        cofactors = cofactors.map(|row| row.map(|part| -part));
    }
    for position in &mut mesh.positions {
        let place = position.map(f64::from);
        *position = std::array::from_fn(|axis| (dot(row(axis), place) + matrix[axis][3]) as f32);
    }
    if !mesh.positions.iter().flatten().all(|part| part.is_finite()) {
        return Err("is put where single numbers end".into());
    }
    for normal in &mut mesh.normals {
        let own = normal.map(f64::from);
        let turned: Triple = std::array::from_fn(|axis| dot(cofactors[axis], own));
        let length = dot(turned, turned).sqrt();
        if !(length > 0.0 && length.is_finite()) {
            return Err("has a normal without a direction".into());
        }
        *normal = turned.map(|part| (part / length) as f32);
    }
    Ok(())
}

/// A matrix after another, which is given by columns.
fn product(one: &Matrix, columns: &[[f64; 4]; 4]) -> Matrix {
    std::array::from_fn(|row| std::array::from_fn(|column| (0..4).map(|k| one[row][k] * columns[column][k]).sum()))
}
