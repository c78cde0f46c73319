//! The meshes that a scene names by file.

use super::{gltf, obj, ply};
use crate::stop::plain;
use light::scene::{Mesh, Normals};
use std::collections::HashMap;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// The largest file of a mesh [byte].
pub const LARGEST: u64 = 1 << 30;

/// Whence the bytes of a file come.
pub type Files<'f> = &'f dyn Fn(&Path) -> Result<Vec<u8>, String>;

/// Reads meshes, each file once.
pub struct Meshes<'f> {
    files: Files<'f>,
    read: HashMap<(PathBuf, bool), Arc<Mesh>>,
    smoothed: HashMap<(PathBuf, bool), Arc<Mesh>>,
    /// What the reader should know: what was left out of a file.
    pub notes: Vec<String>,
}

impl<'f> Meshes<'f> {
    pub fn new(files: Files<'f>) -> Self {
        Self { files, read: HashMap::new(), smoothed: HashMap::new(), notes: Vec::new() }
    }

    /// The mesh of a file. Smooth it has normals: the file's, or those of its triangles. Places on an image are kept only where
    /// they are wanted: corners that differ in nothing else are one without them.
    pub fn read(&mut self, file: &Path, normals: Normals, is_patterned: bool) -> Result<Arc<Mesh>, String> {
        // `./a.ply` is `a.ply`.
        let key: PathBuf = file.components().filter(|part| *part != Component::CurDir).collect();
        let key = (key, is_patterned);
        let mesh = match self.read.get(&key) {
            Some(mesh) => Arc::clone(mesh),
            None => {
                let mesh = Arc::new(self.open(file, is_patterned)?);
                self.read.insert(key.clone(), Arc::clone(&mesh));
                mesh
            }
        };
        if normals == Normals::Flat || !mesh.normals.is_empty() {
            return Ok(mesh);
        }
        let smoothed = self.smoothed.entry(key).or_insert_with(|| Arc::new(Mesh::clone(&mesh).smoothed()));
        Ok(Arc::clone(smoothed))
    }

    fn open(&mut self, file: &Path, is_patterned: bool) -> Result<Mesh, String> {
        let extension = file.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let files = self.files;
        let read: &dyn Fn(&[u8]) -> Result<Mesh, String> = match plain(extension).as_str() {
            "ply" => &|bytes| ply::read(bytes, is_patterned),
            "obj" => &|bytes| obj::read(bytes, is_patterned),
            "gltf" | "glb" => &|bytes| gltf::mesh(file, bytes, files, is_patterned),
            _ => return Err("must be the name of a mesh's file; valid: .ply, .obj, .gltf, .glb".into()),
        };
        let name = file.display();
        let bytes = files(file).map_err(|why| format!("{name} {why}"))?;
        let mut mesh = read(&bytes).map_err(|why| format!("{name}: {why}"))?;
        drop(bytes);
        let all = mesh.triangles.len();
        let flat = mesh.drop_flat();
        if flat == all {
            return Err(format!("{name}: none of its {all} triangles has an area"));
        }
        if flat > 0 {
            self.notes.push(format!("{name}: {flat} of {all} triangles have no area and are left out"));
        }
        Ok(mesh)
    }
}

/// Splits a face into triangles about its first corner.
pub fn split(corners: &[u32], triangles: &mut Vec<[u32; 3]>) {
    if let [first, rest @ ..] = corners {
        triangles.extend(rest.windows(2).map(|pair| [*first, pair[0], pair[1]]));
    }
}

/// A number as a coordinate.
pub fn coordinate(number: f32) -> Option<f32> {
    number.is_finite().then_some(number)
}
