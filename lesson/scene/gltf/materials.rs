//! Materials of glTF as those of a scene.
//!
//! | glTF | here |
//! |---|---|
//! | metallic 0 | a diffuse body of the base colour under a coat: plastic of KHR_materials_ior, its reflection times that of KHR_materials_specular |
//! | metallic 1 | a conductor that reflects the base colour head-on |
//! | KHR_materials_transmission | glass of KHR_materials_ior, which absorbs as KHR_materials_volume says |
//! | roughness | α is its square |
//! | emissive factor × KHR_materials_emissive_strength | radiance [W m⁻² sr⁻¹] |

use super::Reading;
use super::data::fetched;
use crate::scene::images::drawn;
use gltf::image::Source;
use gltf::texture::{Info, WrappingMode};
use light::bsdf::microfacet::{Joint, LEAST_ALPHA, Slopes};
use light::scene::{Emission, Energy, Facets, Glass, Image, Material, Metal, Pattern, Triple};
use std::sync::Arc;

/// The index of what says none (KHR_materials_ior).
const IOR: f64 = 1.5;
/// The most that a metal reflects head-on [1]: κ is finite.
const MOST: f64 = 0.999;

/// A material and what it sends out.
#[derive(Clone)]
pub struct Made {
    pub name: String,
    pub material: Material,
    pub emission: Option<Emission>,
}

/// What is left of a material when it has no name of its own.
fn named(material: &gltf::Material) -> String {
    let number = material.index().map_or("default".to_owned(), |index| format!("material-{index}"));
    let own: String = material.name().unwrap_or_default().chars().filter(|c| !c.is_control()).take(64).collect();
    if own.is_empty() { number } else { own }
}

pub fn made(reading: &mut Reading, material: &gltf::Material) -> Result<Made, String> {
    let (name, pbr) = (named(material), material.pbr_metallic_roughness());
    unread(reading, material);
    let [red, green, blue, _] = pbr.base_color_factor().map(f64::from);
    let factor = [red, green, blue].map(share);
    let drawn = match pbr.base_color_texture() {
        Some(info) => pattern(reading, &info, factor)?,
        None => None,
    };
    let colour = drawn.as_ref().map_or(factor, Pattern::mean);
    let mut of_image = [1.0; 2];
    if let Some(info) = pbr.metallic_roughness_texture() {
        reading.left_out("metallicRoughnessTexture (its mean is used all over)");
        if let Some((image, _)) = image(reading, &info.texture(), false)? {
            let sum = image
                .texels()
                .iter()
                .fold([0.0; 2], |[rough, metal], texel| [rough + f64::from(texel[1]), metal + f64::from(texel[2])]);
            of_image = sum.map(|sum| sum / image.texels().len() as f64);
        }
    }
    let roughness = share(f64::from(pbr.roughness_factor()) * of_image[0]);
    let metallic = share(f64::from(pbr.metallic_factor()) * of_image[1]);
    let transmission = material.transmission().map_or(0.0, |of| f64::from(of.transmission_factor()));
    let alpha = Some(roughness * roughness).filter(|alpha| *alpha >= LEAST_ALPHA);
    let facets = |alpha: f64| Facets { alpha: [alpha; 2], slopes: Slopes::Ggx };
    let ior = match material.ior() {
        // Stands for an index without end, of which the colour alone is left.
        Some(0.0) => {
            reading.left_out("KHR_materials_ior of 0 (1.5 is used)");
            IOR
        }
        Some(ior) => f64::from(ior),
        None => IOR,
    };
    if ![0.0, 1.0].contains(&metallic) {
        reading.left_out("metallic between 0 and 1 (the nearer of both is used)");
    }
    let made = if metallic >= 0.5 {
        if drawn.is_some() {
            reading.left_out("baseColorTexture of metal (its mean is used all over)");
        }
        let metal = metal(colour);
        match alpha {
            None => Material::Conductor { metal, coating: None },
            Some(alpha) => Material::RoughConductor {
                metal,
                facets: facets(alpha),
                masking: Joint::Correlated,
                energy: Energy::Compensated,
                coating: None,
            },
        }
    } else if transmission > 0.0 {
        if transmission < 1.0 {
            reading.left_out("transmission below 1 (taken for 1)");
        }
        if colour != [1.0; 3] {
            reading.left_out("base colour of what transmits light");
        }
        let absorption = absorption(reading, material);
        match (alpha, abbe(material)?) {
            (None, Some(abbe)) => Material::Dispersive { glass: Glass::Abbe { ior, abbe }, outside: 1.0, absorption },
            (None, None) => Material::Dielectric { ior, outside: 1.0, absorption, coating: None },
            (Some(alpha), abbe) => {
                if abbe.is_some() {
                    reading.left_out("dispersion of rough glass");
                }
                Material::RoughDielectric {
                    ior,
                    outside: 1.0,
                    absorption,
                    facets: facets(alpha),
                    energy: Energy::Compensated,
                }
            }
        }
    } else {
        let specular = material.specular().map_or(1.0, |of| share(f64::from(of.specular_factor())));
        // What is reflected head-on, by which an index gives as much.
        let reflected = specular * ((ior - 1.0) / (ior + 1.0)).powi(2);
        let root = reflected.sqrt();
        let plain = if reflected > 0.0 {
            Material::Plastic { ior: (1.0 + root) / (1.0 - root), reflectance: colour, alpha }
        } else {
            Material::Diffuse { reflectance: colour }
        };
        match drawn {
            Some(drawn) => plain.clone().patterned(drawn).unwrap_or(plain),
            None => plain,
        }
    };
    let strength = f64::from(material.emissive_strength().unwrap_or(1.0));
    let mut radiance = material.emissive_factor().map(|factor| f64::from(factor) * strength);
    if let Some(info) = material.emissive_texture().filter(|_| radiance != [0.0; 3]) {
        reading.left_out("emissiveTexture (its mean is used all over)");
        if let Some((image, _)) = image(reading, &info.texture(), true)? {
            let mean = Pattern::Image { file: None, image }.mean();
            radiance = [0, 1, 2].map(|channel| radiance[channel] * mean[channel]);
        }
    }
    let emission = (radiance != [0.0; 3]).then_some(Emission { radiance, two_sided: material.double_sided() });
    Ok(Made { name, material: made, emission })
}

/// Within 0 to 1; 0 of what is no number.
fn share(x: f64) -> f64 {
    if x.is_nan() { 0.0 } else { x.clamp(0.0, 1.0) }
}

/// What reflects a colour F₀ head-on: n = 1, κ² = 4F₀/(1 − F₀).
fn metal(colour: Triple) -> Metal {
    let k = |f_0: f64| 2.0 * (f_0.min(MOST) / (1.0 - f_0.min(MOST))).sqrt();
    Metal::Indices { eta: [1.0; 3], k: colour.map(k) }
}

/// −ln c/d [m⁻¹] of an attenuation colour c at a distance d.
fn absorption(reading: &mut Reading, material: &gltf::Material) -> Triple {
    let Some(volume) = material.volume() else {
        reading.left_out("thin walls (what transmits light is taken for a body)");
        return [0.0; 3];
    };
    // 1e−12 of the light is as good as none.
    let part = |c: f32| {
        let absorption = -f64::from(c).clamp(1e-12, 1.0).ln() / f64::from(volume.attenuation_distance());
        if absorption.is_finite() { absorption.max(0.0) } else { 0.0 }
    };
    volume.attenuation_color().map(part)
}

/// The extension by which glass disperses; its crate passes it on as it stands.
pub const DISPERSION: &str = "KHR_materials_dispersion";

/// The least that could be told from none [1]: at Abbe's number 10⁶ the index changes by some 1e−6 over all that is seen.
const LEAST_DISPERSION: f64 = 2e-5;

/// Abbe's number of a material that transmits light, if it disperses more than could be told from none.
fn abbe(material: &gltf::Material) -> Result<Option<f64>, String> {
    let Some(table) = material.extension_value(DISPERSION) else { return Ok(None) };
    let dispersion = match table.get("dispersion") {
        None => 0.0,
        Some(number) => number.as_f64().filter(|number| *number >= 0.0).ok_or_else(|| {
            let place = material.index().unwrap_or_default();
            format!("materials[{place}].extensions.{DISPERSION}.dispersion: is {number}; valid: a number of 0 or more")
        })?,
    };
    Ok((dispersion >= LEAST_DISPERSION).then_some(20.0 / dispersion))
}

/// Tells what of a material is not read.
fn unread(reading: &mut Reading, material: &gltf::Material) {
    let keys = material.extensions().into_iter().flat_map(|extensions| extensions.keys());
    keys.filter(|key| *key != DISPERSION).for_each(|key| reading.left_out(key));
    if material.alpha_mode() != gltf::material::AlphaMode::Opaque {
        reading.left_out("alpha (all is opaque)");
    }
    for (what, is_there) in [
        ("normalTexture", material.normal_texture().is_some()),
        ("occlusionTexture", material.occlusion_texture().is_some()),
        ("transmissionTexture", material.transmission().is_some_and(|of| of.transmission_texture().is_some())),
        ("thicknessTexture", material.volume().is_some_and(|of| of.thickness_texture().is_some())),
        ("specularTexture", material.specular().is_some_and(|of| of.specular_texture().is_some())),
        (
            "specularColor",
            material
                .specular()
                .is_some_and(|of| of.specular_color_texture().is_some() || of.specular_color_factor() != [1.0; 3]),
        ),
    ] {
        if is_there {
            reading.left_out(what);
        }
    }
}

/// An image as a base colour, times a factor; None if it cannot be drawn, which is told.
fn pattern(reading: &mut Reading, info: &Info, factor: Triple) -> Result<Option<Pattern>, String> {
    let keys = info.extensions().into_iter().flat_map(|extensions| extensions.keys());
    keys.for_each(|key| reading.left_out(key));
    let sampler = info.texture().sampler();
    if [sampler.wrap_s(), sampler.wrap_t()] != [WrappingMode::Repeat; 2] {
        reading.left_out("textures that are not repeated (they are)");
    }
    let Some((image, _)) = image(reading, &info.texture(), true)? else { return Ok(None) };
    let image = match factor == [1.0; 3] {
        true => image,
        false => {
            let texel = |texel: &[f32; 3]| [0, 1, 2].map(|c| (f64::from(texel[c]) * factor[c]) as f32);
            let texels = image.texels().iter().map(texel).collect();
            let image = Arc::new(Image::new(image.size(), texels).ok_or("has no texels")?);
            reading.holds(&image)?;
            image
        }
    };
    Ok(Some(Pattern::Image { file: None, image }))
}

/// An image and its number, each read once; None of a kind that cannot be read, which is told.
fn image(
    reading: &mut Reading,
    texture: &gltf::Texture,
    is_colour: bool,
) -> Result<Option<(Arc<Image>, usize)>, String> {
    let source = texture.source();
    let key = (source.index(), is_colour);
    if let Some(known) = reading.images.get(&key) {
        return Ok(Some((Arc::clone(known), key.0)));
    }
    let place = format!("images[{}]", key.0);
    let bytes = match source.source() {
        Source::View { view, .. } => reading.data.view(&view)?.to_vec(),
        Source::Uri { uri, .. } => {
            fetched(uri, &reading.folder, reading.files).map_err(|why| format!("{place}: {why}"))?
        }
    };
    let Some(read) = drawn(&bytes, is_colour) else {
        reading.left_out("images that are no PNG and no JPEG (their factor is used all over)");
        return Ok(None);
    };
    let image = Arc::new(read.map_err(|why| format!("{place}: {why}"))?);
    reading.holds(&image)?;
    reading.images.insert(key, Arc::clone(&image));
    Ok(Some((image, key.0)))
}
