//! The images that a scene names by file.

use super::meshes::Files;
use super::rgbe;
use crate::stop::plain;
use exr::image::{AnyChannel, AnyChannels, Encoding, FlatSamples, Layer};
use exr::meta::attribute::{EnvironmentMap, IntegerBounds};
use exr::prelude::{ReadChannels, ReadLayers, WritableImage};
use light::scene::Image;
use light::tone::decoded;
use std::collections::HashMap;
use std::io::Cursor;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// Reads images, each file once.
pub struct Images<'f> {
    files: Files<'f>,
    read: HashMap<(PathBuf, Use), Arc<Image>>,
}

/// What an image is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Use {
    /// Light of any size.
    Light,
    /// A share that is sent back.
    Colour,
}

impl<'f> Images<'f> {
    pub fn new(files: Files<'f>) -> Self {
        Self { files, read: HashMap::new() }
    }

    /// The image of a file.
    pub fn read(&mut self, file: &Path, whose: Use) -> Result<Arc<Image>, String> {
        let key: PathBuf = file.components().filter(|part| *part != Component::CurDir).collect();
        let key = (key, whose);
        if let Some(image) = self.read.get(&key) {
            return Ok(Arc::clone(image));
        }
        let extension = file.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let read = match (plain(extension).as_str(), whose) {
            ("exr", _) => open_exr,
            ("hdr", Use::Light) => rgbe::read,
            ("png", Use::Colour) => open_png,
            ("jpg" | "jpeg", Use::Colour) => open_jpeg,
            (_, Use::Light) => return Err("must be the name of an image's file; valid: .exr, .hdr".into()),
            (_, Use::Colour) => return Err("must be the name of an image's file; valid: .png, .jpg, .exr".into()),
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

/// Channels of an OpenEXR file: all of a piece's are made room for before any is read.
const MOST_CHANNELS: usize = 16;

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
        let channels = header.channels.list.len();
        if channels > MOST_CHANNELS {
            return Err(format!("has {channels} channels; valid: up to {MOST_CHANNELS}"));
        }
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
    Image::new([side(size.0), side(size.1)], image.layer_data.channel_data.pixels.1)
        .ok_or_else(|| "has no texels".into())
}

/// How a number of a file, as a share of the largest, is a share of light.
type ShareOf = fn(f64) -> f64;

/// Reads PNG, whose numbers are those of a screen (sRGB), as shares of light. How clear it is, is not asked.
pub fn open_png(bytes: &[u8]) -> Result<Image, String> {
    shares_of_png(bytes, decoded)
}

/// Reads JPEG, likewise. How it is to be turned (Exif) and profiles of colours are not asked for.
pub fn open_jpeg(bytes: &[u8]) -> Result<Image, String> {
    shares_of_jpeg(bytes, decoded)
}

/// The image of a file that tells by its own first bytes what it is: a colour's numbers are those of a screen, others are
/// shares themselves. None of a kind that is not read.
pub fn drawn(bytes: &[u8], is_colour: bool) -> Option<Result<Image, String>> {
    let share_of: ShareOf = if is_colour { decoded } else { |number| number };
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => Some(shares_of_png(bytes, share_of)),
        [0xFF, 0xD8, 0xFF, ..] => Some(shares_of_jpeg(bytes, share_of)),
        _ => None,
    }
}

/// The most texels that a byte of JPEG can tell of: a block of 8 × 8 takes at least a bit (ITU-T T.81, F.1.2.1 and G.1.2.1: its
/// first coefficient has a code of its own). Twice as many, lest a channel of half the size be held to it.
const TEXELS_OF_JPEG: u64 = 2 * 8 * 64;

fn shares_of_jpeg(bytes: &[u8], share_of: ShareOf) -> Result<Image, String> {
    let told = |error: zune_jpeg::errors::DecodeErrors| {
        let text = error.to_string();
        let first: String = text.lines().next().unwrap_or_default().chars().take(160).collect();
        format!("is no image that can be read: {first}")
    };
    let side = usize::from(u16::MAX);
    let options = DecoderOptions::new_safe()
        // What is cut off is no grey, and the largest size is ours to judge.
        .set_strict_mode(true)
        .set_max_width(side)
        .set_max_height(side)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder.decode_headers().map_err(told)?;
    let size = decoder.info().map(|info| [u32::from(info.width), u32::from(info.height)]).ok_or("has no size")?;
    sized(size)?;
    let texels = u64::from(size[0]) * u64::from(size[1]);
    if texels / TEXELS_OF_JPEG > bytes.len() as u64 {
        return Err(format!("promises {} × {} texels, and has {} bytes for them", size[0], size[1], bytes.len()));
    }
    // The decoder takes what is cut off within its last scan for nothing: after that scan's beginning there must be an end.
    let last = |marker: u8| bytes.windows(2).rposition(|two| two == [0xFF, marker]);
    if last(0xD9) < last(0xDA) {
        return Err("is no image that can be read: it ends within its last scan".into());
    }
    let numbers = decoder.decode().map_err(told)?;
    let shares: Vec<f32> = (0..=u8::MAX).map(|number| share_of(f64::from(number) / 255.0) as f32).collect();
    let (texels, _) = numbers.as_chunks::<3>();
    let texels = texels.iter().map(|texel| texel.map(|number| shares[usize::from(number)])).collect();
    Image::new(size, texels).ok_or_else(|| "has fewer texels than it says".into())
}

fn shares_of_png(bytes: &[u8], share_of: ShareOf) -> Result<Image, String> {
    let told = |error: png::DecodingError| {
        let text = error.to_string();
        let first: String = text.lines().next().unwrap_or_default().chars().take(160).collect();
        format!("is no image that can be read: {first}")
    };
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    // Palettes, and fewer bits than eight, as eight; sixteen stay sixteen.
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(told)?;
    let size = [reader.info().width, reader.info().height];
    sized(size)?;
    let needed = reader.output_buffer_size().ok_or("is too large")?;
    let mut numbers = vec![0; needed];
    let frame = reader.next_frame(&mut numbers).map_err(told)?;
    let channels = frame.color_type.samples();
    let of = |number: usize| -> f64 {
        match frame.bit_depth {
            png::BitDepth::Sixteen => {
                f64::from(u16::from_be_bytes([numbers[2 * number], numbers[2 * number + 1]])) / f64::from(u16::MAX)
            }
            _ => f64::from(numbers[number]) / f64::from(u8::MAX),
        }
    };
    let share = |number: usize| share_of(of(number)) as f32;
    let texel = |at: usize| match channels {
        // One channel, and perhaps how clear it is.
        1 | 2 => [share(channels * at); 3],
        _ => [0, 1, 2].map(|c| share(channels * at + c)),
    };
    let count = size[0] as usize * size[1] as usize;
    Image::new(size, (0..count).map(texel).collect()).ok_or_else(|| "has no texels".into())
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
        assert_eq!(
            images.read(Path::new("sky.jpg"), Use::Light).unwrap_err(),
            "must be the name of an image's file; valid: .exr, .hdr"
        );
        let one = images.read(Path::new("./sky.EXR"), Use::Light).unwrap();
        assert!(Arc::ptr_eq(&one, &images.read(Path::new("sky.EXR"), Use::Light).unwrap()));
    }

    fn png(size: [u32; 2], colour: png::ColorType, depth: png::BitDepth, numbers: &[u8]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, size[0], size[1]);
        encoder.set_color(colour);
        encoder.set_depth(depth);
        encoder.write_header().unwrap().write_image_data(numbers).unwrap();
        bytes
    }

    #[test]
    fn what_a_screen_shows_is_read_as_shares_of_light() {
        use png::{BitDepth, ColorType};
        // 188 of 255 is half the light to 1/255, from outside: IEC 61966-2-1's curve at 0.7354.
        let image = open_png(&png([2, 1], ColorType::Rgb, BitDepth::Eight, &[0, 188, 255, 255, 0, 188])).unwrap();
        let [first, last] = [image.at([0, 0]), image.at([1, 0])];
        assert_eq!([first[0], first[2], last[0], last[1]], [0.0, 1.0, 1.0, 0.0]);
        assert!((first[1] - 0.5).abs() < 5e-3 && first[1] == last[2], "{first:?}");
        // The upper row first, grey, clear, and of sixteen bits.
        let grey = open_png(&png([1, 2], ColorType::Grayscale, BitDepth::Eight, &[255, 0])).unwrap();
        assert_eq!([grey.at([0, 0]), grey.at([0, 1])], [[1.0; 3], [0.0; 3]]);
        let clear = open_png(&png([1, 1], ColorType::GrayscaleAlpha, BitDepth::Eight, &[255, 3])).unwrap();
        assert_eq!(clear.at([0, 0]), [1.0; 3]);
        let fine = [255, 255, 0, 0, 188, 188];
        let fine = open_png(&png([1, 1], ColorType::Rgb, BitDepth::Sixteen, &fine)).unwrap();
        assert_eq!(fine.at([0, 0]), [1.0, 0.0, first[1]]);
        let bits = open_png(&png([8, 1], ColorType::Grayscale, BitDepth::One, &[0b1010_0000])).unwrap();
        assert_eq!([0, 1, 2, 3].map(|column| bits.at([column, 0])[0]), [1.0, 0.0, 1.0, 0.0]);
        let whole = png([2, 1], ColorType::Rgb, BitDepth::Eight, &[0; 6]);
        for length in [0, 8, 20, whole.len() / 2] {
            assert!(open_png(&whole[..length]).is_err(), "{length}");
        }
    }

    /// By libjpeg-turbo 3.1.2 through Pillow 13: what it reads of its own files is what is held against here, an encoder and a
    /// decoder of other hands. Two may differ by a step or two where they round (ITU-T T.83, accuracy of a decoder).
    const FLAT: &[u8] = include_bytes!("jpeg/flat.jpg");
    const PROGRESSIVE: &[u8] = include_bytes!("jpeg/progressive.jpg");
    const INKS: &[u8] = include_bytes!("jpeg/inks.jpg");

    #[test]
    fn photographs_are_read_as_another_decoder_reads_them() {
        let near = |image: &Image, place: [u32; 2], expected: [u8; 3], steps: f64| {
            let found = image.at(place);
            for (found, expected) in found.into_iter().zip(expected) {
                let [low, high] =
                    [-steps, steps].map(|step| decoded(((f64::from(expected) + step) / 255.0).clamp(0.0, 1.0)));
                assert!((low - 1e-6..=high + 1e-6).contains(&found), "{place:?}: {found}, and not {expected} of 255");
            }
        };
        let flat = open_jpeg(FLAT).unwrap();
        assert_eq!(flat.size(), [16, 8]);
        for row in 0..8 {
            (0..8).for_each(|column| near(&flat, [column, row], [200, 100, 50], 1.0));
            (8..16).for_each(|column| near(&flat, [column, row], [0, 187, 254], 1.0));
        }
        // Grey, in several passes, and no whole number of blocks: its first column from the top.
        let grey = open_jpeg(PROGRESSIVE).unwrap();
        assert_eq!(grey.size(), [9, 17]);
        let column = [0, 15, 31, 45, 60, 75, 90, 105, 120, 135, 151, 165, 180, 195, 210, 225, 240];
        column.into_iter().enumerate().for_each(|(row, grey_of)| near(&grey, [0, row as u32], [grey_of; 3], 2.0));
        near(&grey, [8, 16], [248; 3], 2.0);
        // Numbers that are no colour are shares themselves.
        let numbers = drawn(FLAT, false).expect("a kind that is known").unwrap();
        assert!((numbers.at([0, 0])[0] - 200.0 / 255.0).abs() < 1.01 / 255.0);
        near(&open_jpeg(INKS).unwrap(), [3, 3], [240, 54, 221], 3.0);
    }

    #[test]
    fn photographs_that_are_cut_off_or_promise_too_much_are_refused() {
        for whole in [FLAT, PROGRESSIVE] {
            // Without its last two bytes, which say that it ends, nothing of it is missing.
            for length in 0..whole.len() - 2 {
                let refused = open_jpeg(&whole[..length]).expect_err(&length.to_string());
                assert!(refused.starts_with("is no image that can be read: ") || refused == "has no size", "{refused}");
            }
        }
        let frame = FLAT.windows(2).position(|two| two == [0xFF, 0xC0]).expect("a frame");
        let sized = |size: [u8; 4]| {
            let mut bytes = FLAT.to_vec();
            bytes[frame + 5..frame + 9].copy_from_slice(&size);
            open_jpeg(&bytes).unwrap_err()
        };
        assert!(sized([255; 4]).contains("has 65535 × 65535 texels; valid: width × height up to"));
        assert_eq!(sized([16, 0, 16, 0]), "promises 4096 × 4096 texels, and has 293 bytes for them");
        assert!(sized([0; 4]).contains("zero"), "{}", sized([0; 4]));
        let files = |_: &Path| Ok(FLAT.to_vec());
        let mut images = Images::new(&files);
        for name in ["a.jpg", "a.JPEG"] {
            assert_eq!(images.read(Path::new(name), Use::Colour).unwrap().size(), [16, 8]);
        }
        let light = images.read(Path::new("a.jpg"), Use::Light).unwrap_err();
        assert_eq!(light, "must be the name of an image's file; valid: .exr, .hdr");
        assert!(drawn(b"GIF89a", true).is_none());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        /// Whatever becomes of a file, it is an image or a refusal.
        #[test]
        fn nothing_in_a_file_breaks_the_readers(
            kind in 0..3usize,
            changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
            cut in prop::option::of(any::<prop::sample::Index>()),
        ) {
            let mut bytes = match kind {
                0 => write_exr(&image([9, 33], |k| [k as f32, 0.5, 1.0 / (k + 1) as f32])),
                1 => png([3, 2], png::ColorType::Rgb, png::BitDepth::Eight, &[77; 18]),
                _ => [
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
            let read = [open_exr, open_png, rgbe::read][kind];
            if let Err(why) = read(&bytes) {
                prop_assert!(!why.contains('\n'), "{}", why);
            }
        }
    }
}
