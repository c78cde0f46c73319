//! Pixels as a PNG: for the picture of a whole figure, and for the maps within an SVG.
//!
//! The crate `png` alone, which `image` would call in its turn, and which compiles wherever the lecture does.

use png::Compression;

/// A PNG of 8-bit sRGB pixels. Of the filters, none suits line art on white best.
pub fn png(width: u32, height: u32, rgb: &[u8]) -> Vec<u8> {
    compressed(width, height, rgb, Compression::High)
}

/// The same for once: made sooner, and larger.
#[cfg(feature = "png")]
pub fn quick_png(width: u32, height: u32, rgb: &[u8]) -> Vec<u8> {
    compressed(width, height, rgb, Compression::Fast)
}

fn compressed(width: u32, height: u32, rgb: &[u8], compression: Compression) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(compression);
    encoder.set_filter(png::Filter::NoFilter);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(rgb));
    written.expect("a picture in memory can be encoded into memory");
    bytes
}
