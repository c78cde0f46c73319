//! Colours.

use chapters::figure::{Dash, Hue, Ramp};

/// A colour by what it stands for. A page that shows a figure inline may give each role a colour of its own; see
/// [`Colour::role`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Text and axes.
    Ink,
    /// Edges of boxes.
    Edge,
    /// Grid lines behind the curves.
    Grid,
    /// Reference lines and their names.
    Aid,
    /// Background.
    Paper,
    /// Ground of the bands beside the frame.
    Band,
    /// Strokes over what a map has no value for.
    Hatch,
    /// Ground of what a map has no value for.
    Blank,
    /// s polarisation.
    S,
    /// p polarisation.
    P,
    /// Natural light, or the exact answer.
    Natural,
    /// What is transmitted.
    Transmitted,
    /// The program's own method.
    Ours,
    /// The textbook form.
    Textbook,
    /// A reference or an aid to the eye.
    Reference,
    /// The seventh of several equals, which is no other role.
    Seventh,
}

impl Colour {
    /// Every colour, each at its own number.
    pub const ALL: [Self; 16] = [
        Self::Ink,
        Self::Edge,
        Self::Grid,
        Self::Aid,
        Self::Paper,
        Self::Band,
        Self::Hatch,
        Self::Blank,
        Self::S,
        Self::P,
        Self::Natural,
        Self::Transmitted,
        Self::Ours,
        Self::Textbook,
        Self::Reference,
        Self::Seventh,
    ];

    /// Its name in a page's style, where `--lesson-` stands before it. None for the two that lie over and in a map,
    /// whose pixels do not follow the page.
    pub fn role(self) -> Option<&'static str> {
        match self {
            Self::Ink => Some("ink"),
            Self::Edge => Some("edge"),
            Self::Grid => Some("grid"),
            Self::Aid => Some("aid"),
            Self::Paper => Some("paper"),
            Self::Band => Some("band"),
            Self::Hatch | Self::Blank => None,
            Self::S => Some("s"),
            Self::P => Some("p"),
            Self::Natural => Some("natural"),
            Self::Transmitted => Some("transmitted"),
            Self::Ours => Some("ours"),
            Self::Textbook => Some("textbook"),
            Self::Reference => Some("reference"),
            Self::Seventh => Some("seventh"),
        }
    }

    /// How it looks on paper [8-bit sRGB]. The hues were found by search: any two differ by 0.13 or more in OKLab
    /// (B. Ottosson, 2020) to normal and to protan, deutan and tritan eyes (G. Machado et al., IEEE TVCG 15, 2009), and
    /// each has a contrast of 3 to white; the seventh equal, found the same way, differs from the others by 0.09.
    pub fn rgb(self) -> [u8; 3] {
        let [_, rgb @ ..] = u32::to_be_bytes(match self {
            Self::Ink => 0x222222,
            Self::Edge => 0xBEBEBE,
            Self::Grid => 0xE4E4E4,
            Self::Aid => 0x606060,
            Self::Paper => 0xFFFFFF,
            Self::Band => 0xF0F0F0,
            Self::Hatch => 0x5A5A5A,
            Self::Blank => 0xF0F0F0,
            Self::S => 0x3F4CCD,
            Self::P => 0xAD2312,
            Self::Natural => 0x1A1A1A,
            Self::Transmitted => 0x059AD8,
            Self::Ours => 0x68076F,
            Self::Textbook => 0xCC8400,
            Self::Reference => 0x808080,
            Self::Seventh => 0xFF3CC3,
        });
        rgb
    }

    /// How it looks on paper, as CSS writes it.
    pub fn hex(self) -> String {
        let [red, green, blue] = self.rgb();
        format!("#{red:02x}{green:02x}{blue:02x}")
    }
}

/// A colour, and how much it covers of what is under it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paint {
    /// The colour.
    pub colour: Colour,
    /// From 0, nothing, to 1, all.
    pub alpha: f64,
}

impl From<Colour> for Paint {
    fn from(colour: Colour) -> Self {
        Self { colour, alpha: 1.0 }
    }
}

/// How many equals have colours of their own.
const EQUALS: u8 = 8;

/// The colour of a hue.
pub fn colour(hue: Hue) -> Colour {
    match hue {
        Hue::S => Colour::S,
        Hue::P => Colour::P,
        Hue::Natural => Colour::Natural,
        Hue::Transmitted => Colour::Transmitted,
        Hue::Ours => Colour::Ours,
        Hue::Textbook => Colour::Textbook,
        Hue::Reference => Colour::Reference,
        Hue::Nth(k) => match k % EQUALS {
            0 => Colour::S,
            1 => Colour::Textbook,
            2 => Colour::Transmitted,
            3 => Colour::P,
            4 => Colour::Ours,
            5 => Colour::Natural,
            6 => Colour::Seventh,
            _ => Colour::Reference,
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
    let [[_, low @ ..], [_, high @ ..]] = [stops[below], stops[below + 1]].map(u32::to_be_bytes);
    let between = |k: usize| (f64::from(low[k]) + share * (f64::from(high[k]) - f64::from(low[k]))).round() as u8;
    Some([between(0), between(1), between(2)])
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

    fn linear(rgb: [u8; 3]) -> [f64; 3] {
        rgb.map(|code| {
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
                let seen = |hue: Hue| oklab(times(eye, linear(colour(hue).rgb())));
                for b in &hues[..k] {
                    let apart = distance(seen(*a), seen(*b));
                    assert!(apart > least, "{a:?} and {b:?} are {apart:.3} apart");
                }
            }
            // The contrast that WCAG 2.1 (criterion 1.4.11) asks of graphics.
            let luminance: f64 =
                linear(colour(*a).rgb()).iter().zip([0.2126, 0.7152, 0.0722]).map(|(c, w)| c * w).sum();
            assert!(1.05 / (luminance + 0.05) > 3.0, "{a:?} is pale");
        }
    }

    #[test]
    fn colours_are_known_by_number_and_name() {
        for (k, colour) in Colour::ALL.into_iter().enumerate() {
            assert_eq!(colour as usize, k);
            let namesakes = Colour::ALL.into_iter().filter(|other| other.role() == colour.role());
            assert!(colour.role().is_none() || namesakes.count() == 1, "{colour:?}");
        }
    }

    #[test]
    fn ramps_are_even_in_lightness() {
        let lightness = |kind: Ramp, t: f64| oklab(linear(ramp(kind, t).unwrap()))[0];
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
