//! glTF 2.0, `.gltf` and `.glb`: what of it a scene can show, and a list of what is left out.
//!
//! Text and names are the crate `gltf`'s to read; the numbers in its buffers are read here ([`data`]), for its own iterators
//! believe what an accessor says of itself.

mod data;
mod materials;
#[cfg(test)]
mod tests;

use super::meshes::Files;
use data::{Data, pieces};
use gltf::accessor::Dimensions;
use gltf::camera::Projection;
use gltf::json::camera::Type;
use gltf::json::validation::{Checked, Error, Validate};
use gltf::khr_lights_punctual::Kind;
use gltf::mesh::Mode;
use gltf::{Document, Semantic};
use light::scene::{
    Camera, Environment, Filter, Geometry, Image, Light, Material, Mesh, Normals, Scene, Shape, Transform, Triple,
};
use materials::Made;
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Luminous efficacy [lm W⁻¹] by which KHR_lights_punctual's candelas and luxes become watts.
const EFFICACY: f64 = 683.0;
/// The most corners, and corners of triangles, all nodes together: a mesh may be put in many places.
const MOST: usize = 1 << 26;
/// How deep nodes may lie in each other.
const DEEPEST: usize = 512;
/// Rows of a picture, and the angle [deg] of a camera that the file has not.
const HEIGHT: u32 = 256;
const FOV_Y_DEG: f64 = 40.0;

/// A file that is being read.
pub struct Reading<'f> {
    data: Data,
    folder: PathBuf,
    files: Files<'f>,
    images: HashMap<(usize, bool), Arc<Image>>,
    /// Texels of all images so far.
    texels: u64,
    left_out: BTreeSet<String>,
}

impl Reading<'_> {
    fn left_out(&mut self, what: &str) {
        self.left_out.insert(what.to_owned());
    }

    /// Refuses more images than fit: a file can name one many times.
    fn holds(&mut self, image: &Image) -> Result<(), String> {
        self.texels += image.texels().len() as u64;
        match self.texels <= 2 * Image::MOST {
            true => Ok(()),
            false => Err(format!("its images have more than {} texels, the most that are read", 2 * Image::MOST)),
        }
    }
}

/// A piece of a mesh where it is put, and the number of its material.
struct Part {
    mesh: Mesh,
    material: Option<usize>,
}

/// What there is, from all nodes of the scene.
#[derive(Default)]
struct Found {
    parts: Vec<Part>,
    lights: Vec<Light>,
    cameras: Vec<Camera>,
    corners: usize,
    flat: usize,
    /// Why it cannot be a scene, though its shapes can be read.
    unusable: Option<String>,
}

/// Rows of a matrix that takes points to points.
type Matrix = [[f64; 4]; 3];

/// The scene of a file that is called `name`, and what the reader should know.
pub fn scene(name: &str, path: &Path, bytes: &[u8], files: Files) -> Result<(Scene, Vec<String>), String> {
    let (document, mut reading, found) = open(path, bytes, files)?;
    let Found { parts, lights, mut cameras, flat, unusable, .. } = found;
    if let Some(why) = unusable {
        return Err(why);
    }
    let mut notes = Vec::new();
    if flat > 0 {
        notes.push(format!("{flat} triangles have no area and are left out"));
    }
    // In the order in which they are met.
    let mut made: Vec<(Option<usize>, Made)> = Vec::new();
    let mut shapes = Vec::new();
    for Part { mesh, material: number } in parts {
        let known = made.iter().position(|(known, _)| *known == number);
        let at = known.unwrap_or(made.len());
        if known.is_none() {
            let own = number.and_then(|number| document.materials().nth(number));
            let mut one = match own {
                Some(own) => materials::made(&mut reading, &own)?,
                // By the letter it is the roughest of metals, which looks much like this.
                None => Made {
                    name: "default".to_owned(),
                    material: Material::Diffuse { reflectance: [1.0; 3] },
                    emission: None,
                },
            };
            while made.iter().any(|(_, known)| known.name == one.name) {
                one.name += &format!("-{}", number.unwrap_or_default());
            }
            made.push((number, one));
        }
        let Made { name, emission, .. } = &made[at].1;
        let normals = if mesh.normals.is_empty() { Normals::Flat } else { Normals::Smooth };
        shapes.push(Shape {
            geometry: Geometry::Mesh { file: None, normals, mesh: Arc::new(mesh) },
            material: name.clone(),
            emission: *emission,
            transform: Transform::default(),
        });
    }
    let materials = made.into_iter().map(|(_, one)| (one.name, one.material)).collect();
    let camera = match cameras.len() {
        0 => {
            notes.push("the file has no camera; one is put before all that there is".to_owned());
            framing(&shapes)
        }
        count => {
            if count > 1 {
                notes.push(format!("the first of {count} cameras is taken"));
            }
            cameras.swap_remove(0)
        }
    };
    let mut environment = None;
    let is_dark = lights.is_empty() && shapes.iter().all(|shape| shape.emission.is_none());
    if is_dark {
        notes.push("nothing in the file shines; a sky of radiance 1 is put around it".to_owned());
        environment = Some(Environment::Constant([1.0; 3]));
    }
    if !reading.left_out.is_empty() {
        let left_out: Vec<String> = reading.left_out.into_iter().collect();
        notes.push(format!("left out: {}", left_out.join(", ")));
    }
    let notes = notes.into_iter().map(|note| format!("{}: {note}", path.display())).collect();
    let name = name.to_owned();
    Ok((
        Scene { name, max_depth: None, filter: Filter::default(), camera, environment, materials, shapes, lights },
        notes,
    ))
}

/// All triangles of a file as one mesh, and its places on an image if they are wanted.
pub fn mesh(path: &Path, bytes: &[u8], files: Files, is_patterned: bool) -> Result<Mesh, String> {
    let (_, _, Found { parts, .. }) = open(path, bytes, files)?;
    let has = |of: fn(&Mesh) -> bool| parts.iter().all(|part| of(&part.mesh));
    let has_normals = has(|mesh| !mesh.normals.is_empty());
    let has_texture = is_patterned && has(|mesh| !mesh.texture.is_empty());
    let mut all = Mesh::default();
    for Part { mesh, .. } in parts {
        let first = u32::try_from(all.positions.len()).map_err(|_| "has too many corners")?;
        all.positions.extend(mesh.positions);
        all.normals.extend(mesh.normals.into_iter().filter(|_| has_normals));
        all.texture.extend(mesh.texture.into_iter().filter(|_| has_texture));
        all.triangles.extend(mesh.triangles.into_iter().map(|triangle| triangle.map(|corner| corner + first)));
    }
    if all.triangles.is_empty() { Err("has no triangles".into()) } else { Ok(all) }
}

fn open<'f>(path: &Path, bytes: &[u8], files: Files<'f>) -> Result<(Document, Reading<'f>, Found), String> {
    let (text, own) = pieces(bytes)?;
    let mut root: gltf::json::Root = gltf::json::deserialize::from_slice(text).map_err(|error| {
        let told: String = error.to_string().chars().take(160).collect();
        format!("cannot be read: {told}")
    })?;
    prepare(&mut root)?;
    let mut wrong = Vec::new();
    root.validate(&root, gltf::json::Path::new, &mut |path, error| {
        if wrong.len() < 8 {
            wrong.push((path().to_string(), error));
        }
    });
    if let Some((place, error)) = wrong.into_iter().next() {
        let what = match error {
            Error::IndexOutOfBounds => "names what is not there",
            Error::Invalid => "is not valid",
            Error::Missing => "is missing",
            Error::Oversize => "is too large",
            Error::Unsupported => "is needed, and cannot be read",
        };
        return Err(format!("{place} {what}"));
    }
    let document = Document::from_json_without_validation(root);
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    // Whoever reads files knows the scene's folder.
    let data = Data::open(&document, own, &folder, files)?;
    let mut reading = Reading { data, folder, files, images: HashMap::new(), texels: 0, left_out: BTreeSet::new() };
    for (what, count) in [("animations", document.animations().count()), ("skins", document.skins().count())] {
        if count > 0 {
            reading.left_out(what);
        }
    }
    let scene = document.default_scene().or_else(|| document.scenes().next()).ok_or("has no scene")?;
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
        take(&mut reading, &mut found, &node, &matrix).map_err(|why| format!("{place}: {why}"))?;
        let before = left.len();
        left.extend(node.children().map(|child| (child, matrix, depth + 1)));
        left[before..].reverse();
    }
    drop(left);
    Ok((document, reading, found))
}

/// Says what the crate would fall over, and takes from what is needed what is read here without its word.
fn prepare(root: &mut gltf::json::Root) -> Result<(), String> {
    for (at, mesh) in root.meshes.iter().enumerate() {
        for (number, primitive) in mesh.primitives.iter().enumerate() {
            let there = root.accessors.len();
            if let Some(far) = primitive.attributes.values().map(|accessor| accessor.value()).find(|at| *at >= there) {
                let place = format!("meshes[{at}].primitives[{number}].attributes");
                return Err(format!("{place}: there is no accessor {far}; there are {there}, the first being 0"));
            }
        }
    }
    for (at, image) in root.images.iter_mut().enumerate() {
        match (&image.buffer_view, &image.uri) {
            (None, None) => return Err(format!("images[{at}]: has no data; valid: a uri or a bufferView")),
            // What it is its own bytes tell.
            (Some(_), _) => drop(image.mime_type.get_or_insert(gltf::json::image::MimeType(String::new()))),
            (None, Some(_)) => {}
        }
    }
    for (at, camera) in root.cameras.iter().enumerate() {
        let has_its_table = match camera.type_ {
            Checked::Valid(Type::Perspective) => camera.perspective.is_some(),
            Checked::Valid(Type::Orthographic) => camera.orthographic.is_some(),
            Checked::Invalid => true,
        };
        if !has_its_table {
            return Err(format!(
                "cameras[{at}]: has no table of its type; valid: perspective or orthographic, as `type` says"
            ));
        }
    }
    root.extensions_required.retain(|name| {
        !["KHR_materials_specular", "KHR_materials_volume", materials::DISPERSION].contains(&name.as_str())
    });
    Ok(())
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
        if let Some(mut mesh) = triangles(reading, &primitive).map_err(|why| format!("{place}: {why}"))? {
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
            found.parts.push(Part { mesh, material: primitive.material().index() });
        }
    }
    Ok(())
}

/// The triangles of a primitive where it was made; None if it has none by its kind.
fn triangles(reading: &mut Reading, primitive: &gltf::Primitive) -> Result<Option<Mesh>, String> {
    if matches!(primitive.mode(), Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip) {
        reading.left_out("points and lines");
        return Ok(None);
    }
    if primitive.morph_targets().next().is_some() {
        reading.left_out("morph targets");
    }
    if primitive.get(&Semantic::Colors(0)).is_some() {
        reading.left_out("colours of corners (COLOR_0)");
    }
    let count = primitive.indices().map_or(0, |indices| indices.count());
    if count > MOST {
        return Err(format!("has {count} indices; valid: up to {MOST}"));
    }
    let data = &reading.data;
    let positions: Vec<[f32; 3]> = match primitive.get(&Semantic::Positions) {
        Some(accessor) => data.numbers(&accessor, Dimensions::Vec3)?,
        None => return Err("has no POSITION".into()),
    };
    let each = |count: usize, what: &str| match count == positions.len() {
        true => Ok(()),
        false => Err(format!("{count} {what} for {} corners; valid: one each", positions.len())),
    };
    let normals: Vec<[f32; 3]> = match primitive.get(&Semantic::Normals) {
        Some(accessor) => data.numbers(&accessor, Dimensions::Vec3)?,
        None => Vec::new(),
    };
    if !normals.is_empty() {
        each(normals.len(), "normals")?;
    }
    let texture: Vec<[f32; 2]> = match primitive.get(&Semantic::TexCoords(0)) {
        Some(accessor) => data.numbers(&accessor, Dimensions::Vec2)?,
        None => Vec::new(),
    };
    if !texture.is_empty() {
        each(texture.len(), "texture coordinates")?;
    }
    let corners = match primitive.indices() {
        Some(accessor) => data.indices(&accessor)?,
        None => (0..u32::try_from(positions.len()).map_err(|_| "has too many corners")?).collect(),
    };
    if let Some(far) = corners.iter().find(|corner| **corner as usize >= positions.len()) {
        return Err(format!("there is no corner {far}; there are {}, the first being 0", positions.len()));
    }
    let triangles: Vec<[u32; 3]> = match primitive.mode() {
        Mode::TriangleStrip => {
            // Every second one runs the other way round.
            let turned = |(at, three): (usize, &[u32])| {
                if at % 2 == 0 { [three[0], three[1], three[2]] } else { [three[1], three[0], three[2]] }
            };
            corners.windows(3).enumerate().map(turned).collect()
        }
        Mode::TriangleFan => {
            let mut triangles = Vec::new();
            super::meshes::split(&corners, &mut triangles);
            triangles
        }
        _ => {
            if corners.len() % 3 != 0 {
                return Err(format!("{} corners of triangles; valid: three each", corners.len()));
            }
            corners.chunks_exact(3).map(|three| [three[0], three[1], three[2]]).collect()
        }
    };
    if triangles.is_empty() {
        return Err("has no triangles".into());
    }
    // From the upper left corner there, from the lower left one here.
    let texture = texture.into_iter().map(|[s, t]| [s, 1.0 - t]).collect();
    Ok(Some(Mesh { positions, normals, texture, triangles }))
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

/// A camera before all shapes, a little from above.
fn framing(shapes: &[Shape]) -> Camera {
    let corners = shapes.iter().flat_map(|shape| match &shape.geometry {
        Geometry::Mesh { mesh, .. } => &mesh.positions[..],
        _ => &[],
    });
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for corner in corners {
        for axis in 0..3 {
            low[axis] = low[axis].min(f64::from(corner[axis]));
            high[axis] = high[axis].max(f64::from(corner[axis]));
        }
    }
    if low[0] > high[0] {
        (low, high) = ([-1.0; 3], [1.0; 3]);
    }
    let middle: Triple = std::array::from_fn(|axis| 0.5 * (low[axis] + high[axis]));
    let radius = 0.5 * (0..3).map(|axis| (high[axis] - low[axis]).powi(2)).sum::<f64>().sqrt();
    // The ball about it touches the picture's edges.
    let distance = radius.max(1e-6) / (FOV_Y_DEG.to_radians() / 2.0).sin();
    let way = [0.4, 0.3, 1.0];
    let length = way.iter().map(|part: &f64| part * part).sum::<f64>().sqrt();
    Camera {
        origin: std::array::from_fn(|axis| middle[axis] + distance * way[axis] / length),
        target: middle,
        up: Camera::UP,
        fov_y_deg: FOV_Y_DEG,
        width: HEIGHT,
        height: HEIGHT,
        aperture: 0.0,
        focus: None,
        polariser_deg: None,
    }
}
