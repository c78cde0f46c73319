//! A sheet as a PNG.

use super::outline::outline;
use super::palette::Paint;
use super::sheet::{Image, Item, Path, Sheet, Text};
use super::{DENSITY, encode};
use tiny_skia::{Color, FillRule, LineCap, LineJoin, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};

/// The sheet on white.
pub fn write(sheet: &Sheet) -> Vec<u8> {
    let (width, height) = (sheet.width.max(1) * DENSITY, sheet.height.max(1) * DENSITY);
    encode::png(width, height, &painted(sheet, f64::from(DENSITY), width, height))
}

/// The sheet on white, so many pixels to each of its own, sRGB by pixel.
pub(super) fn painted(sheet: &Sheet, density: f64, width: u32, height: u32) -> Vec<u8> {
    let mut pixmap = Pixmap::new(width, height).expect("a figure fits into memory");
    pixmap.fill(Color::WHITE);
    let scale = Transform::from_scale(density as f32, density as f32);
    for item in &sheet.items {
        match item {
            Item::Fill { path, paint } => fill(&mut pixmap, built(path), paint, scale),
            Item::Disc { centre: [x, y], radius, paint } => {
                fill(&mut pixmap, PathBuilder::from_circle(*x, *y, *radius), paint, scale);
            }
            Item::Stroke { path, paint, width, dashes } => stroke(&mut pixmap, path, paint, *width, dashes, scale),
            Item::Text(text) => set(&mut pixmap, text, scale),
            Item::Image(image) => paste(&mut pixmap, image, density),
        }
    }
    pixmap.data().chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

pub(super) fn built(path: &Path) -> Option<tiny_skia::Path> {
    let ([x, y], rest) = path.points.split_first()?;
    let mut built = PathBuilder::new();
    built.move_to(*x, *y);
    rest.iter().for_each(|[x, y]| built.line_to(*x, *y));
    if path.is_closed {
        built.close();
    }
    built.finish()
}

fn shaded(paint: &Paint) -> tiny_skia::Paint<'static> {
    let [red, green, blue] = paint.colour.rgb();
    let mut shaded = tiny_skia::Paint { anti_alias: true, ..tiny_skia::Paint::default() };
    shaded.set_color_rgba8(red, green, blue, (255.0 * paint.alpha).round() as u8);
    shaded
}

pub(super) fn fill(pixmap: &mut Pixmap, path: Option<tiny_skia::Path>, paint: &Paint, transform: Transform) {
    if let Some(path) = path {
        pixmap.fill_path(&path, &shaded(paint), FillRule::Winding, transform, None);
    }
}

pub(super) fn stroke(
    pixmap: &mut Pixmap,
    path: &Path,
    paint: &Paint,
    width: f32,
    dashes: &[f32],
    transform: Transform,
) {
    let Some(path) = built(path) else { return };
    let dash = StrokeDash::new(dashes.to_vec(), 0.0);
    let line_cap = if dash.is_some() { LineCap::Butt } else { LineCap::Round };
    let stroke = Stroke { width, dash, line_cap, line_join: LineJoin::Round, ..Stroke::default() };
    pixmap.stroke_path(&path, &shaded(paint), &stroke, transform, None);
}

fn set(pixmap: &mut Pixmap, text: &Text, scale: Transform) {
    let turn = if text.upwards { -90.0 } else { 0.0 };
    let transform = scale.pre_translate(text.start[0], text.start[1]).pre_rotate(turn);
    fill(pixmap, outline(&text.label, f64::from(text.size)), &text.paint, transform);
}

/// Copies the cells: a pixel takes the mean of those that it covers, or the nearest.
pub(super) fn paste(pixmap: &mut Pixmap, image: &Image, scale: f64) {
    let edge = |at: f64, limit: u32| (at * scale).round().clamp(0.0, f64::from(limit)) as usize;
    let (left, right) = (edge(image.place.left, pixmap.width()), edge(image.place.right, pixmap.width()));
    let (top, bottom) = (edge(image.place.top, pixmap.height()), edge(image.place.bottom, pixmap.height()));
    let stride = pixmap.width() as usize;
    let covered = |k: usize, pixels: usize, cells: usize| {
        let first = (k * cells / pixels).min(cells - 1);
        first..((k + 1) * cells / pixels).clamp(first + 1, cells)
    };
    let pixels = pixmap.pixels_mut();
    for y in top..bottom {
        let rows = covered(y - top, bottom - top, image.rows());
        for x in left..right {
            let columns = covered(x - left, right - left, image.columns);
            let mut sum = [0.0; 3];
            for cell in rows.clone().flat_map(|row| &image.cells[row * image.columns..][columns.clone()]) {
                // Light adds up, what is written down of it does not.
                sum.iter_mut().zip(cell).for_each(|(sum, part)| *sum += (f64::from(*part) / 255.0).powf(2.2));
            }
            let count = (rows.len() * columns.len()) as f64;
            let [red, green, blue] = sum.map(|sum| (255.0 * (sum / count).powf(1.0 / 2.2)).round() as u8);
            pixels[y * stride + x] = tiny_skia::ColorU8::from_rgba(red, green, blue, 255).premultiply();
        }
    }
}
