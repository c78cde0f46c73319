//! Pictures as files.

use super::exr;
use crate::stop::{Stop, plain};
use light::bsdf::Rgb;
use light::tone::{Curve, encoded};
use light::transport::Feature;
use light::transport::estimate::colour;
use light::transport::film::Halves;
use std::path::Path;

/// Radiance, row by row from the top.
pub struct Picture<'a> {
    pub width: u32,
    pub height: u32,
    /// The means of the halves of every pixel [W m⁻² sr⁻¹].
    pub halves: &'a [Halves],
    /// What the camera sees without any light, if a file asks for it and anyone knows.
    pub features: Option<&'a [Feature]>,
    /// What is told beside.
    pub about: &'a About,
}

/// Whence a picture is, as its file tells it; nothing of when, so that the same picture is the same file.
#[derive(Clone, Debug, Default)]
pub struct About {
    /// What its scene is called.
    pub scene: String,
    /// Samples a pixel.
    pub spp: u32,
    /// What else decides the samples, by name.
    pub manner: Vec<(String, String)>,
}

/// The program, as files name it.
pub const SOFTWARE: &str = concat!("lesson ", env!("CARGO_PKG_VERSION"));

impl About {
    /// In a line.
    pub fn told(&self) -> String {
        let manner: String = self.manner.iter().map(|(key, value)| format!(", {key} {value}")).collect();
        format!("{}, {} spp{manner}", self.scene, self.spp)
    }
}

/// How radiance is shown on a screen.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    pub curve: Curve,
    /// Stops: radiance is shown times 2 to that.
    pub exposure: f64,
}

impl Shown {
    /// What a screen is sent [1] for a radiance [W m⁻² sr⁻¹]: between 0 and 1, as sRGB codes it; black for what is no number.
    pub fn of(&self, radiance: Rgb<f64>) -> Rgb<f64> {
        let factor = self.exposure.exp2();
        let is_number = radiance.iter().all(|x| x.is_finite());
        if is_number { self.curve.apply(radiance.map(|x| x * factor)).map(encoded) } else { [0.0; 3] }
    }
}

/// A kind of file.
pub struct Kind {
    extension: &'static str,
    /// The most bytes a pixel that are held while one is made, beside the picture.
    pub bytes: u64,
    /// Whether it tells what the camera sees without any light.
    pub features: bool,
    pub encode: fn(&Picture, &Shown) -> Vec<u8>,
}

const KINDS: &[Kind] = &[
    Kind { extension: "png", bytes: 3 * 3, features: false, encode: png },
    Kind { extension: "exr", bytes: 2 * 13 * 4, features: true, encode: exr::encode },
    Kind { extension: "pfm", bytes: 3 * 4, features: false, encode: pfm },
];

/// The kind of a file by its name.
pub fn kind(path: &Path) -> Result<&'static Kind, Stop> {
    let extension = path.extension().map(|extension| plain(&extension.to_string_lossy())).unwrap_or_default();
    KINDS.iter().find(|kind| kind.extension == extension).ok_or_else(|| {
        let known: Vec<String> = KINDS.iter().map(|kind| format!(".{}", kind.extension)).collect();
        Stop::at(
            format!("--out {}", path.display()),
            format!("no kind of picture that is known; valid: {}", known.join(", ")),
        )
    })
}

/// 8-bit sRGB, dithered: between two steps a pixel takes one or the other as often as it lies near it, by a fixed pattern.
fn png(picture: &Picture, shown: &Shown) -> Vec<u8> {
    let mut pixels = Vec::with_capacity(3 * picture.halves.len());
    pixels.extend(picture.halves.iter().enumerate().flat_map(|(at, halves)| {
        let colour = shown.of(colour(halves));
        let place = [at as u32 % picture.width, at as u32 / picture.width];
        (0..3).map(move |c| (255.0 * colour[c] + threshold(place, c as u32)).min(255.0) as u8)
    }));
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let Shown { curve, exposure } = shown;
    let shown = format!("{}, tone {}, exposure {exposure}", picture.about.told(), format!("{curve:?}").to_lowercase());
    let told = encoder
        .add_text_chunk("Software".to_owned(), SOFTWARE.to_owned())
        .and_then(|()| encoder.add_itxt_chunk("Comment".to_owned(), shown));
    told.expect("no picture is written yet");
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&pixels));
    written.expect("a picture in memory can be encoded into memory");
    bytes
}

/// Where between 0 and 1 [1] a pixel's channel is rounded up: evenly spread among neighbours (the R₂ sequence of
/// M. Roberts, *The unreasonable effectiveness of quasirandom sequences* (2018)).
fn threshold([x, y]: [u32; 2], channel: u32) -> f64 {
    let at = f64::from(x) * 0.754_877_666_246_692_8 + f64::from(y) * 0.569_840_290_998_053_3;
    (at + f64::from(channel) / 3.0).fract()
}

/// Linear radiance in 32-bit floats, little-endian, row by row from the bottom (P. Debevec's portable float map).
fn pfm(picture: &Picture, _: &Shown) -> Vec<u8> {
    let mut bytes = format!("PF\n{} {}\n-1.0\n", picture.width, picture.height).into_bytes();
    bytes.reserve_exact(12 * picture.halves.len());
    for row in picture.halves.chunks(picture.width as usize).rev() {
        for halves in row {
            let radiance: Rgb<f64> = colour(halves);
            radiance.iter().for_each(|x| bytes.extend((*x as f32).to_le_bytes()));
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of which nothing else is told.
    fn of(width: u32, height: u32, halves: &[Halves]) -> Picture<'_> {
        static NOTHING: About = About { scene: String::new(), spp: 0, manner: Vec::new() };
        Picture { width, height, halves, features: None, about: &NOTHING }
    }

    const PLAIN: Shown = Shown { curve: Curve::None, exposure: 0.0 };

    fn decoded(bytes: &[u8]) -> Vec<u8> {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        reader.next_frame(&mut pixels).expect("a frame");
        pixels
    }

    #[test]
    fn a_screen_shows_on_average_what_lies_between_its_steps() {
        // A quarter of the way from 100 to 101.
        let linear = light::tone::decoded(100.25 / 255.0) as f32;
        let halves = vec![[[linear; 3]; 2]; 64 * 64];
        let shown = decoded(&png(&of(64, 64, &halves), &PLAIN));
        assert!(shown.iter().all(|step| (100..=101).contains(step)));
        let above = shown.iter().filter(|step| **step == 101).count() as f64 / shown.len() as f64;
        // 64² thresholds of a sequence of low discrepancy, three times.
        assert!((above - 0.25).abs() < 0.01, "{above}");
    }

    #[test]
    fn black_and_white_are_exact_and_what_is_no_number_is_black() {
        let grey = |x: f32| [[x; 3]; 2];
        let halves = [grey(0.0), grey(1.0), grey(7.0), grey(f32::NAN), grey(-1.0), grey(f32::INFINITY)];
        let shown = decoded(&png(&of(6, 1, &halves), &PLAIN));
        let expected: Vec<u8> = [0, 255, 255, 0, 0, 0].iter().flat_map(|step| [*step; 3]).collect();
        assert_eq!(shown, expected);
        // A stop is a factor of two.
        let [half, whole] = [grey(0.25), grey(0.5)];
        let brighter = Shown { exposure: 1.0, ..PLAIN };
        let one = |halves: [Halves; 1], shown| decoded(&png(&of(1, 1, &halves), shown));
        assert_eq!(one([half], &brighter), one([whole], &PLAIN));
    }

    #[test]
    fn a_png_tells_whence_it_is() {
        let about = About { scene: "Küche".to_owned(), spp: 8, manner: vec![("seed".to_owned(), "3".to_owned())] };
        let picture = Picture { about: &about, ..of(1, 1, &[[[1.0; 3]; 2]]) };
        let bytes = png(&picture, &Shown { curve: Curve::Agx, exposure: -0.5 });
        assert_eq!(bytes, png(&picture, &Shown { curve: Curve::Agx, exposure: -0.5 }));
        let reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().expect("a PNG");
        let info = reader.info();
        let software = &info.uncompressed_latin1_text[0];
        assert_eq!((software.keyword.as_str(), software.text.as_str()), ("Software", SOFTWARE));
        let comment = info.utf8_text[0].get_text().expect("a text");
        assert_eq!(comment, "Küche, 8 spp, seed 3, tone agx, exposure -0.5");
    }

    #[test]
    fn floats_are_kept_from_the_bottom_row_on() {
        let halves = [[[1.0, 2.0, 3.0], [3.0, 2.0, 1.0]], [[-0.5, 0.0, f32::MAX], [-0.5, 0.0, f32::MAX]]];
        let bytes = pfm(&of(1, 2, &halves), &PLAIN);
        let numbers = bytes.strip_prefix(b"PF\n1 2\n-1.0\n").expect("the head");
        let numbers: Vec<f32> =
            numbers.chunks(4).map(|four| f32::from_le_bytes(four.try_into().expect("four"))).collect();
        assert_eq!(numbers, [-0.5, 0.0, f32::MAX, 2.0, 2.0, 2.0]);
    }

    #[test]
    fn a_kind_is_known_by_its_name_or_refused_with_those_there_are() {
        assert!(["a.PNG", "b.pfm", "c.exr"].iter().all(|name| kind(Path::new(name)).is_ok()));
        for other in ["a", "a.jpg", ".png", "a.png/"] {
            let refused = kind(Path::new(other)).map(|kind| kind.extension);
            assert!(
                other == "a.png/" || refused.is_err_and(|stop| stop.to_string().contains(".png, .exr, .pfm")),
                "{other}"
            );
        }
    }
}
