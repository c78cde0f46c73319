//! The images that a scene names by file.

use super::meshes::Files;
use super::rgbe;
use crate::stop::plain;
use exr::image::{AnyChannel, AnyChannels, Encoding, FlatSamples, Layer};
use exr::meta::attribute::{EnvironmentMap, IntegerBounds};
use exr::prelude::{ReadChannels, ReadLayers, WritableImage};
use light::scene::Image;
use std::collections::HashMap;
use std::io::Cursor;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// Reads images, each file once.
pub struct Images<'f> {
    files: Files<'f>,
    read: HashMap<PathBuf, Arc<Image>>,
}

impl<'f> Images<'f> {
    pub fn new(files: Files<'f>) -> Self {
        Self { files, read: HashMap::new() }
    }

    /// The image of a file of light.
    pub fn read(&mut self, file: &Path) -> Result<Arc<Image>, String> {
        let key: PathBuf = file.components().filter(|part| *part != Component::CurDir).collect();
        if let Some(image) = self.read.get(&key) {
            return Ok(Arc::clone(image));
        }
        let extension = file.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let read = match plain(extension).as_str() {
            "exr" => open_exr,
            "hdr" => rgbe::read,
            _ => return Err("must be the name of an image's file; valid: .exr, .hdr".into()),
        };
        let name = file.display();
        let bytes = (self.files)(file).map_err(|why| format!("{name} {why}"))?;
        let image = Arc::new(read(&bytes).map_err(|why| format!("{name}: {why}"))?);
        self.read.insert(key, Arc::clone(&image));
        Ok(image)
    }
}

/// Refuses a size that no image may have.
pub fn sized([width, height]: [u32; 2]) -> Result<(), String> {
    match u64::from(width) * u64::from(height) {
        0 => Err("has no texels".into()),
        1..=Image::MOST => Ok(()),
        _ => Err(format!("has {width} × {height} texels; valid: width × height up to {}", Image::MOST)),
    }
}

/// What a piece of an OpenEXR file takes at least [byte]: its place in the table, and what it says of itself.
const PIECE: usize = 16;

/// Reads OpenEXR: `R`, `G` and `B` of the first layer that has them, at their full size.
pub fn open_exr(bytes: &[u8]) -> Result<Image, String> {
    let told = |error: exr::error::Error| {
        let text = error.to_string();
        let first: String = text.lines().next().unwrap_or_default().chars().take(160).collect();
        format!("is no image that can be read: {first}")
    };
    let about = exr::meta::MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(told)?;
    let side = |size: usize| u32::try_from(size).unwrap_or(u32::MAX);
    for header in &about.headers {
        sized([side(header.layer_size.0), side(header.layer_size.1)])?;
        if header.chunk_count.saturating_mul(PIECE) > bytes.len() {
            return Err(format!("promises {} pieces, and has {} bytes for them", header.chunk_count, bytes.len()));
        }
        if header.shared_attributes.display_window.size != header.layer_size {
            let IntegerBounds { size, .. } = header.shared_attributes.display_window;
            let layer = header.layer_size;
            let of = format!("{} × {} of {} × {} texels", layer.0, layer.1, size.0, size.1);
            return Err(format!("holds a part of its picture alone, {of}; valid: all of it"));
        }
        if header.own_attributes.environment_map == Some(EnvironmentMap::Cube) {
            return Err("shows the six sides of a cube; valid: latitude and longitude".into());
        }
    }
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| (size.width(), vec![[0.0_f32; 3]; size.area()]),
            |(width, texels): &mut (usize, Vec<[f32; 3]>), place, (red, green, blue): (f32, f32, f32)| {
                texels[place.y() * *width + place.x()] = [red, green, blue];
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))
        .map_err(told)?;
    let size = image.layer_data.size;
    Image::new([side(size.0), side(size.1)], image.layer_data.channel_data.pixels.1).ok_or_else(|| "has no texels".into())
}

/// An image as OpenEXR, the very numbers.
pub fn write_exr(image: &Image) -> Vec<u8> {
    let size = exr::math::Vec2(image.size()[0] as usize, image.size()[1] as usize);
    let channel = |(at, name): (usize, &str)| {
        AnyChannel::new(name, FlatSamples::F32(image.texels().iter().map(|texel| texel[at]).collect()))
    };
    let channels = ["R", "G", "B"].into_iter().enumerate().map(channel).collect();
    let layer = Layer::new(size, Default::default(), Encoding::SMALL_LOSSLESS, AnyChannels::sort(channels));
    let mut bytes = Cursor::new(Vec::new());
    let whole = exr::image::Image::from_layer(layer);
    whole.write().non_parallel().to_buffered(&mut bytes).expect("an image in memory can be encoded into memory");
    bytes.into_inner()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn image(size: [u32; 2], texel: impl Fn(u32) -> [f32; 3]) -> Image {
        Image::new(size, (0..size[0] * size[1]).map(texel).collect()).expect("as many")
    }

    fn small() -> Image {
        image([3, 2], |k| [k as f32, 0.5, f32::MAX / (k + 1) as f32])
    }

    #[test]
    fn an_image_is_read_as_it_was_written() {
        for written in [small(), image([1, 1], |_| [f32::MIN_POSITIVE; 3]), image([70, 41], |k| [k as f32; 3])] {
            assert_eq!(open_exr(&write_exr(&written)).unwrap(), written);
        }
    }

    #[test]
    fn what_is_no_image_of_light_is_refused() {
        let bytes = write_exr(&small());
        for length in [0, 1, 4, 40, bytes.len() / 2, bytes.len() - 1] {
            let refused = open_exr(&bytes[..length]).unwrap_err();
            assert!(refused.contains("cannot be read") || refused.contains("no image"), "{length}: {refused}");
        }
        // A header that promises more than there can be.
        let far = image([1, 4096], |_| [0.0; 3]);
        let mut far = write_exr(&far);
        let at = far.windows(10).position(|some| some == b"dataWindow").expect("its name");
        let end = far[at..].windows(4).position(|some| some == 4095_u32.to_le_bytes()).expect("its last row") + at;
        far[end..end + 4].copy_from_slice(&33_000_000_u32.to_le_bytes());
        assert!(open_exr(&far).is_err());
        far[end..end + 4].copy_from_slice(&2_000_000_000_u32.to_le_bytes());
        assert!(open_exr(&far).is_err());
        let files = |_: &Path| Ok(bytes.clone());
        let mut images = Images::new(&files);
        assert_eq!(images.read(Path::new("sky.jpg")).unwrap_err(), "must be the name of an image's file; valid: .exr, .hdr");
        let one = images.read(Path::new("./sky.EXR")).unwrap();
        assert!(Arc::ptr_eq(&one, &images.read(Path::new("sky.EXR")).unwrap()));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        /// Whatever becomes of a file, it is an image or a refusal.
        #[test]
        fn nothing_in_a_file_breaks_the_readers(
            is_exr: bool,
            changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
            cut in prop::option::of(any::<prop::sample::Index>()),
        ) {
            let mut bytes = match is_exr {
                true => write_exr(&image([9, 33], |k| [k as f32, 0.5, 1.0 / (k + 1) as f32])),
                false => [
                    b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n".as_slice(),
                    &[2, 2, 0, 8, 136, 128, 8, 0, 1, 2, 3, 4, 5, 6, 7, 132, 1, 4, 2, 2, 2, 2, 136, 137],
                    &[7, 8, 9, 128, 1, 1, 1, 7],
                ].concat(),
            };
            for (at, byte) in changes {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            if let Some(cut) = cut {
                bytes.truncate(cut.index(bytes.len()));
            }
            let read = if is_exr { open_exr(&bytes) } else { rgbe::read(&bytes) };
            if let Err(why) = read {
                prop_assert!(!why.contains('\n'), "{}", why);
            }
        }
    }
}
