//! The text of a file: read, and held to what it says of itself before anything follows it.

use super::data::QUANTIZATION;
use super::materials::DISPERSION;
use gltf::Document;
use gltf::json::camera::Type;
use gltf::json::validation::{Checked, Error, Validate};

/// The extensions that a file may need: those that are read.
pub const KNOWN: [&str; 9] = [
    "KHR_lights_punctual",
    DISPERSION,
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_volume",
    QUANTIZATION,
    "KHR_texture_transform",
];

/// The document of a text. What it names is there.
pub fn document(text: &[u8]) -> Result<Document, String> {
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
    Ok(Document::from_json_without_validation(root))
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
    let needed = root.extensions_required.iter().enumerate().find(|(_, name)| !KNOWN.contains(&name.as_str()));
    if let Some((at, name)) = needed {
        let (name, known) = (chapters::parameter::excerpt(name), KNOWN.join(", "));
        return Err(format!("extensionsRequired[{at}]: {name} is needed, and cannot be read; valid: {known}"));
    }
    root.extensions_required.clear();
    Ok(())
}
