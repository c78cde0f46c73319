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

/// The seventh of several equals, which is no role: found by the same search, it differs from the others by 0.09.
const PINK: RGBColor = rgb(0xFF3CC3);

/// How many equals have colours of their own.
const EQUALS: u8 = 8;

/// The colour of a role. Found by search: any two differ by 0.13 or more in OKLab (B. Ottosson, 2020) to normal and to
/// protan, deutan and tritan eyes (G. Machado et al., IEEE TVCG 15, 2009), and each has a contrast of 3 to white.
pub fn colour(hue: Hue) -> RGBColor {
    match hue {
        Hue::S => rgb(0x3F4CCD),
        Hue::P => rgb(0xAD2312),
        Hue::Natural => rgb(0x1A1A1A),
        Hue::Transmitted => rgb(0x059AD8),
        Hue::Ours => rgb(0x68076F),
        Hue::Textbook => rgb(0xCC8400),
        Hue::Reference => rgb(0x808080),
        Hue::Nth(k) => match k % EQUALS {
            0 => colour(Hue::S),
            1 => colour(Hue::Textbook),
            2 => colour(Hue::Transmitted),
            3 => colour(Hue::P),
            4 => colour(Hue::Ours),
            5 => colour(Hue::Natural),
            6 => PINK,
            _ => colour(Hue::Reference),
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

#[cfg(test)]
mod tests {
    use super::*;

    type Rows = [[f64; 3]; 3];

    /// What is left of linear sRGB to normal, protan, deutan and tritan eyes (Machado et al. 2009, severity 1).
    const EYES: [Rows; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    ];

    fn times(rows: &Rows, v: [f64; 3]) -> [f64; 3] {
        rows.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    fn linear(RGBColor(red, green, blue): RGBColor) -> [f64; 3] {
        [red, green, blue].map(|code| {
            let display = f64::from(code) / 255.0;
            if display <= 0.04045 { display / 12.92 } else { ((display + 0.055) / 1.055).powf(2.4) }
        })
    }

    /// OKLab of linear sRGB (Ottosson 2020).
    fn oklab(rgb: [f64; 3]) -> [f64; 3] {
        let cones = times(
            &[
                [0.4122214708, 0.5363325363, 0.0514459929],
                [0.2119034982, 0.6806995451, 0.1073969566],
                [0.0883024619, 0.2817188376, 0.6299787005],
            ],
            rgb.map(|component| component.clamp(0.0, 1.0)),
        );
        times(
            &[
                [0.2104542553, 0.7936177850, -0.0040720468],
                [1.9779984951, -2.4285922050, 0.4505937099],
                [0.0259040371, 0.7827717662, -0.8086757660],
            ],
            cones.map(f64::cbrt),
        )
    }

    fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
        a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn hues_differ_to_every_eye_and_from_white() {
        let roles = [Hue::S, Hue::P, Hue::Natural, Hue::Transmitted, Hue::Ours, Hue::Textbook, Hue::Reference];
        are_apart(&roles, 0.13);
        let equals: Vec<Hue> = (0..EQUALS).map(Hue::Nth).collect();
        are_apart(&equals, 0.09);
    }

    fn are_apart(hues: &[Hue], least: f64) {
        for (k, a) in hues.iter().enumerate() {
            for eye in &EYES {
                let seen = |hue: Hue| oklab(times(eye, linear(colour(hue))));
                for b in &hues[..k] {
                    let apart = distance(seen(*a), seen(*b));
                    assert!(apart > least, "{a:?} and {b:?} are {apart:.3} apart");
                }
            }
            // The contrast that WCAG 2.1 (criterion 1.4.11) asks of graphics.
            let luminance: f64 = linear(colour(*a)).iter().zip([0.2126, 0.7152, 0.0722]).map(|(c, w)| c * w).sum();
            assert!(1.05 / (luminance + 0.05) > 3.0, "{a:?} is pale");
        }
    }

    #[test]
    fn ramps_are_even_in_lightness() {
        let lightness = |kind: Ramp, t: f64| {
            let [red, green, blue] = ramp(kind, t).unwrap();
            oklab(linear(RGBColor(red, green, blue)))[0]
        };
        let whole = lightness(Ramp::Sequential, 1.0) - lightness(Ramp::Sequential, 0.0);
        for k in 0..16 {
            let t = f64::from(k) / 16.0;
            let step = lightness(Ramp::Sequential, t + 1.0 / 16.0) - lightness(Ramp::Sequential, t);
            assert!((step * 16.0 / whole - 1.0).abs() < 0.45, "step {k}: {:.2} of the mean", step * 16.0 / whole);
            let arm = t / 2.0;
            assert!(lightness(Ramp::Diverging, arm + 1.0 / 32.0) > lightness(Ramp::Diverging, arm));
            let mirrored = lightness(Ramp::Diverging, arm) - lightness(Ramp::Diverging, 1.0 - arm);
            assert!(mirrored.abs() < 0.08, "the arms differ by {mirrored:.3} at {arm}");
        }
        assert_eq!(ramp(Ramp::Diverging, 0.5), Some([255; 3]));
        assert_eq!(ramp(Ramp::Sequential, f64::NAN), None);
        assert_eq!(ramp(Ramp::Sequential, 7.0), Some([0xfd, 0xe7, 0x25]));
    }

    /// By IEC 61966-2-1, code 128 displays ((128/255 + 0.055)/1.055)^2.4 = 0.21586.
    #[test]
    fn display_codes_follow_the_standard() {
        assert_eq!([0.0, 1.0, 2.0, -1.0, f32::NAN].map(encoded), [0, 255, 255, 0, 0]);
        assert_eq!(encoded(0.215_86), 128);
        assert_eq!(encoded(0.002), 7);
    }
}
