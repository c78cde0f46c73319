//! Colours.

use chapters::figure::{Dash, Hue, Ramp};
use plotters::style::RGBColor;

/// Text and axes.
pub const INK: RGBColor = RGBColor(34, 34, 34);
/// Edges of boxes.
pub const EDGE: RGBColor = RGBColor(190, 190, 190);
/// Grid lines behind the curves.
pub const GRID: RGBColor = RGBColor(228, 228, 228);
/// Reference lines and their names.
pub const AID: RGBColor = RGBColor(96, 96, 96);
/// Background.
pub const PAPER: RGBColor = RGBColor(255, 255, 255);
/// Strokes and ground of what a map has no value for.
pub const BROKEN: (RGBColor, RGBColor) = (RGBColor(90, 90, 90), RGBColor(240, 240, 240));

const fn rgb(code: u32) -> RGBColor {
    RGBColor((code >> 16) as u8, (code >> 8) as u8, code as u8)
}

/// The colour of a role. Chosen by search so that any two differ by at least 0.12 in OKLab (B. Ottosson, 2020) to
/// normal and to protan, deutan and tritan eyes (G. Machado et al., IEEE TVCG 15, 2009), and each from white.
pub fn colour(hue: Hue) -> RGBColor {
    match hue {
        Hue::S => rgb(0x2952CC),
        Hue::P => rgb(0xBA3D00),
        Hue::Natural => rgb(0x1A1A1A),
        Hue::Transmitted => rgb(0x6DA167),
        Hue::Ours => rgb(0x81007C),
        Hue::Textbook => rgb(0xE86F04),
        Hue::Reference => rgb(0x808080),
        Hue::Nth(k) => match k % 7 {
            0 => colour(Hue::S),
            1 => colour(Hue::Textbook),
            2 => colour(Hue::Ours),
            3 => colour(Hue::Transmitted),
            4 => colour(Hue::P),
            5 => rgb(0x04B7EF),
            _ => colour(Hue::Natural),
        },
    }
}

/// Lengths of strokes and gaps of a line; empty if unbroken.
pub fn dashes(dash: Dash) -> &'static [f32] {
    match dash {
        Dash::Solid => &[],
        Dash::Dashed => &[8.0, 4.5],
        Dash::Dotted => &[2.2, 3.2],
    }
}

/// viridis of S. van der Walt and N. Smith (matplotlib, CC0) at 17 even places of its 256.
const SEQUENTIAL: [u32; 17] = [
    0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d, 0x2c728e, 0x26828e, 0x21918c, 0x1f9f88, 0x27ad81,
    0x3dbc74, 0x5cc863, 0x81d34d, 0xaadc32, 0xd5e21a, 0xfde725,
];

/// RdBu of C. Brewer (ColorBrewer 2.0, 11 classes) from blue to red, its middle made white.
const DIVERGING: [u32; 11] =
    [0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xd1e5f0, 0xffffff, 0xfddbc7, 0xf4a582, 0xd6604d, 0xb2182b, 0x67001f];

/// The colour at a fraction of a ramp, ends held beyond it; none for NaN.
pub fn ramp(ramp: Ramp, fraction: f64) -> Option<[u8; 3]> {
    let stops: &[u32] = match ramp {
        Ramp::Sequential => &SEQUENTIAL,
        Ramp::Diverging => &DIVERGING,
    };
    if fraction.is_nan() {
        return None;
    }
    let along = fraction.clamp(0.0, 1.0) * (stops.len() - 1) as f64;
    let below = (along as usize).min(stops.len() - 2);
    let share = along - below as f64;
    let (RGBColor(r0, g0, b0), RGBColor(r1, g1, b1)) = (rgb(stops[below]), rgb(stops[below + 1]));
    let between = |a: u8, b: u8| (f64::from(a) + share * (f64::from(b) - f64::from(a))).round() as u8;
    Some([between(r0, r1), between(g0, g1), between(b0, b1)])
}

/// A linear component as 8-bit sRGB (IEC 61966-2-1); what is not a number is black.
pub fn encoded(linear: f32) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let display = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (255.0 * display).round() as u8
}
