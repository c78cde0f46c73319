//! A sheet as a PNG.

use super::sheet::{Image, Item, Sheet, Text};
use super::text;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use plotters_backend::BackendColor;
use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};

/// Pixels of the picture to a pixel of the sheet: sharp on dense screens and on a projector.
pub const DENSITY: u32 = 2;

/// The sheet on white.
pub fn write(sheet: &Sheet) -> Vec<u8> {
    let (width, height) = (sheet.width.max(1) * DENSITY, sheet.height.max(1) * DENSITY);
    let mut pixmap = Pixmap::new(width, height).expect("a figure fits into memory");
    pixmap.fill(Color::WHITE);
    let scale = Transform::from_scale(DENSITY as f32, DENSITY as f32);
    for item in &sheet.items {
        match item {
            Item::Fill { path, colour } => fill(&mut pixmap, path, *colour, scale),
            Item::Disc { centre: [x, y], radius, colour } => {
                if let Some(path) = PathBuilder::from_circle(*x, *y, *radius) {
                    fill(&mut pixmap, &path, *colour, scale);
                }
            }
            Item::Stroke { path, colour, width, dashes } => {
                stroke(&mut pixmap, path, *colour, *width, dashes, scale);
            }
            Item::Text(text) => set(&mut pixmap, text, scale),
            Item::Image(image) => paste(&mut pixmap, image),
        }
    }
    let opaque: Vec<u8> = pixmap.data().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    encode(width, height, &opaque)
}

/// A PNG of 8-bit sRGB pixels. Of the filters, none suits line art on white best.
pub fn encode(width: u32, height: u32, rgb: &[u8]) -> Vec<u8> {
    let mut png = Vec::new();
    PngEncoder::new_with_quality(&mut png, CompressionType::Best, FilterType::NoFilter)
        .write_image(rgb, width, height, ExtendedColorType::Rgb8)
        .expect("a picture in memory can be encoded into memory");
    png
}

fn paint(colour: BackendColor) -> Paint<'static> {
    let (red, green, blue) = colour.rgb;
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(red, green, blue, (255.0 * colour.alpha).round() as u8);
    paint
}

fn fill(pixmap: &mut Pixmap, path: &Path, colour: BackendColor, transform: Transform) {
    pixmap.fill_path(path, &paint(colour), FillRule::Winding, transform, None);
}

fn stroke(pixmap: &mut Pixmap, path: &Path, colour: BackendColor, width: f32, dashes: &[f32], transform: Transform) {
    let dash = StrokeDash::new(dashes.to_vec(), 0.0);
    let line_cap = if dash.is_some() { LineCap::Butt } else { LineCap::Round };
    let stroke = Stroke { width, dash, line_cap, line_join: LineJoin::Round, ..Stroke::default() };
    pixmap.stroke_path(path, &paint(colour), &stroke, transform, None);
}

fn set(pixmap: &mut Pixmap, text: &Text, scale: Transform) {
    let Some(outline) = text::outline(&text.label, f64::from(text.size)) else { return };
    let turn = if text.upwards { -90.0 } else { 0.0 };
    let transform = scale.pre_translate(text.start[0], text.start[1]).pre_rotate(turn);
    fill(pixmap, &outline, text.colour, transform);
}

/// Copies the cells without smoothing: a pixel takes the colour of the cell that its centre lies in.
fn paste(pixmap: &mut Pixmap, image: &Image) {
    let density = DENSITY as f32;
    let edge = |at: f32, limit: u32| (at * density).round().clamp(0.0, limit as f32) as usize;
    let (left, right) = (edge(image.place.left(), pixmap.width()), edge(image.place.right(), pixmap.width()));
    let (top, bottom) = (edge(image.place.top(), pixmap.height()), edge(image.place.bottom(), pixmap.height()));
    let stride = pixmap.width() as usize;
    let cell = |k: usize, pixels: usize, cells: usize| ((2 * k + 1) * cells / (2 * pixels)).min(cells - 1);
    let pixels = pixmap.pixels_mut();
    for y in top..bottom {
        let row = cell(y - top, bottom - top, image.rows()) * image.columns;
        for x in left..right {
            let [red, green, blue] = image.cells[row + cell(x - left, right - left, image.columns)];
            pixels[y * stride + x] = tiny_skia::ColorU8::from_rgba(red, green, blue, 255).premultiply();
        }
    }
}
