//! Primitives: their triangles, and where these lie on an image.

use super::Reading;
use super::nodes::MOST;
use gltf::Semantic;
use gltf::accessor::Dimensions;
use gltf::mesh::Mode;
use gltf::texture::TextureTransform;
use light::scene::Mesh;

/// How a primitive lies on the image of its material.
pub struct Places<'p> {
    /// The number of its set of coordinates.
    pub set: u32,
    /// How these are moved.
    transform: Option<TextureTransform<'p>>,
}

impl<'p> Places<'p> {
    /// As its base colour says; the first set as it is where nobody asks for its material.
    pub fn of(primitive: &gltf::Primitive<'p>, is_scene: bool) -> Self {
        let info = primitive.material().pbr_metallic_roughness().base_color_texture().filter(|_| is_scene);
        let Some(info) = info else { return Self { set: 0, transform: None } };
        let transform = info.texture_transform();
        let other = transform.as_ref().and_then(TextureTransform::tex_coord);
        Self { set: other.unwrap_or(info.tex_coord()), transform }
    }

    /// A place on the image from its lower left corner of one from its upper left corner: scaled, turned, moved, in that order
    /// (KHR_texture_transform, "Overview": translation · rotation · scale, whose rotation's columns are (cos, −sin) and (sin, cos)).
    fn moved(&self, [s, t]: [f32; 2]) -> [f32; 2] {
        let Some(of) = &self.transform else { return [s, 1.0 - t] };
        let [[right, down], [wide, high], [s, t]] = [of.offset(), of.scale(), [s, t]].map(|pair| pair.map(f64::from));
        let (sin, cos) = f64::from(of.rotation()).sin_cos();
        let (s, t) = (wide * s, high * t);
        [(cos * s + sin * t + right) as f32, (1.0 - (cos * t - sin * s + down)) as f32]
    }
}

/// The triangles of a primitive where it was made; None if it has none by its kind.
pub fn triangles(reading: &mut Reading, primitive: &gltf::Primitive, places: &Places) -> Result<Option<Mesh>, String> {
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
    let texture: Vec<[f32; 2]> = match primitive.get(&Semantic::TexCoords(places.set)) {
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
            crate::scene::meshes::split(&corners, &mut triangles);
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
    let texture: Vec<[f32; 2]> = texture.into_iter().map(|place| places.moved(place)).collect();
    if !texture.iter().flatten().all(|part| part.is_finite()) {
        return Err("lies on its image where single numbers end".into());
    }
    Ok(Some(Mesh { positions, normals, texture, triangles }))
}
