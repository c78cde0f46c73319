//! glTF 2.0, `.gltf` and `.glb`: what of it a scene can show, and a list of what is left out.
//!
//! Text and names are the crate `gltf`'s to read; the numbers in its buffers are read here ([`data`]), for its own iterators
//! believe what an accessor says of itself.

mod data;
mod framing;
mod materials;
mod nodes;
mod primitives;
#[cfg(test)]
pub mod tests;
mod text;

use super::meshes::Files;
use data::{Data, pieces};
use gltf::Document;
use light::scene::{
    Camera, Environment, Filter, Geometry, Image, Light, Material, Mesh, Normals, Scene, Shape, Transform,
};
use materials::Made;
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use text::KNOWN;

/// Rows of a picture.
const HEIGHT: u32 = 256;

/// A file that is being read.
pub struct Reading<'f> {
    data: Data,
    /// Whether its materials are wanted too, and places on their images.
    is_scene: bool,
    folder: PathBuf,
    files: Files<'f>,
    images: HashMap<(usize, bool), Arc<Image>>,
    /// Texels of all images so far.
    texels: u64,
    left_out: BTreeSet<String>,
}

impl Reading<'_> {
    fn left_out(&mut self, what: &str) {
        // Some are names of the file's.
        self.left_out.insert(what.chars().take(80).collect());
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
    /// Where in the file it is, and which set of coordinates says where it lies on an image.
    place: String,
    set: u32,
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

/// The scene of a file that is called `name`, and what the reader should know.
pub fn scene(name: &str, path: &Path, bytes: &[u8], files: Files) -> Result<(Scene, Vec<String>), String> {
    let (document, mut reading, found) = open(path, bytes, files, true)?;
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
    for Part { mesh, material: number, place, set } in parts {
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
        let Made { name, emission, material } = &made[at].1;
        if material.pattern().is_some() && mesh.texture.is_empty() {
            return Err(format!("{place}: TEXCOORD_{set} places the image of its material, and it has none"));
        }
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
            framing::camera(&shapes)
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
    let (_, _, Found { parts, .. }) = open(path, bytes, files, false)?;
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

fn open<'f>(
    path: &Path,
    bytes: &[u8],
    files: Files<'f>,
    is_scene: bool,
) -> Result<(Document, Reading<'f>, Found), String> {
    let (text, own) = pieces(bytes)?;
    let document = text::document(text)?;
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    // Whoever reads files knows the scene's folder.
    let data = Data::open(&document, own, &folder, files)?;
    let (images, left_out) = (HashMap::new(), BTreeSet::new());
    let mut reading = Reading { data, is_scene, folder, files, images, texels: 0, left_out };
    for (what, count) in [("animations", document.animations().count()), ("skins", document.skins().count())] {
        if count > 0 {
            reading.left_out(what);
        }
    }
    document.extensions_used().filter(|name| !KNOWN.contains(name)).for_each(|name| reading.left_out(name));
    let scene = document.default_scene().or_else(|| document.scenes().next()).ok_or("has no scene")?;
    let found = nodes::found(&mut reading, &document, &scene)?;
    Ok((document, reading, found))
}
