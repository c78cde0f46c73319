//! OpenEXR: all that is known of a picture, in one file.
//!
//! | channels | what |
//! |---|---|
//! | `R` `G` `B` | radiance [W m⁻² sr⁻¹], linear, of Rec. 709's primaries |
//! | `variance.R` … | the variance [W² m⁻⁴ sr⁻²] of its mean, by the picture's two halves: one degree of freedom |
//! | `normal.X` … | the normal that shades, a mean of unit vectors; 0 where nothing is |
//! | `albedo.R` … | the share [1] of light from all around that comes this way; 0 where nothing is |
//! | `depth.Z` | distance from the camera along the ray [m], not along its axis, the mean of the rays that meet something; +∞ where none does |
//!
//! The last three are left out where only the film is known and not the scene.

use super::pictures::{Picture, SOFTWARE, Shown};
use ::exr::prelude::*;
use light::transport::estimate::{colour, variance};
use std::io::Cursor;

/// Where red, green, blue and white are (ITU-R BT.709) [CIE 1931 x, y].
const REC709: attribute::Chromaticities = attribute::Chromaticities {
    red: Vec2(0.64, 0.33),
    green: Vec2(0.30, 0.60),
    blue: Vec2(0.15, 0.06),
    white: Vec2(0.3127, 0.3290),
};

/// The file's bytes.
pub fn encode(picture: &Picture, _: &Shown) -> Vec<u8> {
    let size = Vec2(picture.width as usize, picture.height as usize);
    let channel = |name: &str, of: &dyn Fn(usize) -> f32| {
        let samples = (0..picture.halves.len()).map(of).collect();
        AnyChannel::new(name, FlatSamples::F32(samples))
    };
    let mut channels = Vec::new();
    for (c, letter) in ["R", "G", "B"].into_iter().enumerate() {
        channels.push(channel(letter, &|at| colour(&picture.halves[at])[c] as f32));
        channels.push(channel(&format!("variance.{letter}"), &|at| variance(&picture.halves[at])[c] as f32));
    }
    if let Some(features) = picture.features {
        for c in 0..3 {
            channels.push(channel(&format!("normal.{}", ["X", "Y", "Z"][c]), &|at| features[at].normal[c]));
            channels.push(channel(&format!("albedo.{}", ["R", "G", "B"][c]), &|at| features[at].albedo[c]));
        }
        channels.push(channel("depth.Z", &|at| features[at].distance));
    }
    let layer = Layer::new(
        size,
        LayerAttributes {
            software_name: Some(SOFTWARE.into()),
            comments: Some(picture.about.told().as_str().into()),
            ..LayerAttributes::default()
        },
        Encoding { compression: Compression::ZIP16, blocks: Blocks::ScanLines, line_order: LineOrder::Increasing },
        AnyChannels::sort(channels.into_iter().collect()),
    );
    let mut attributes = ImageAttributes::new(IntegerBounds::from_dimensions(size));
    attributes.chromaticities = Some(REC709);
    let image = Image::empty(attributes).with_layer(layer);
    let mut bytes = Cursor::new(Vec::new());
    image.write().non_parallel().to_buffered(&mut bytes).expect("a picture in memory can be encoded into memory");
    bytes.into_inner()
}

#[cfg(test)]
mod tests {
    use super::super::pictures::About;
    use super::*;
    use light::tone::Curve;
    use light::transport::Feature;
    use std::collections::BTreeMap;

    /// Every channel of a file, by its name.
    fn channels(bytes: &[u8]) -> (Vec2<usize>, BTreeMap<String, Vec<f32>>) {
        let image = read()
            .no_deep_data()
            .largest_resolution_level()
            .all_channels()
            .first_valid_layer()
            .all_attributes()
            .from_buffered(Cursor::new(bytes))
            .expect("an EXR");
        assert_eq!(image.attributes.chromaticities, Some(REC709));
        let of = |channel: AnyChannel<FlatSamples>| match channel.sample_data {
            FlatSamples::F32(samples) => (channel.name.to_string(), samples),
            other => panic!("{} is not of 32-bit floats: {other:?}", channel.name),
        };
        (image.layer_data.size, image.layer_data.channel_data.list.into_iter().map(of).collect())
    }

    #[test]
    fn every_channel_comes_back_where_it_was_bit_for_bit() {
        // Two columns, three rows: neither can be taken for the other.
        let halves: Vec<_> = (0..6u8).map(f32::from).map(|k| [[k, 1.0, f32::MAX], [k + 2.0, 1.0, f32::MAX]]).collect();
        let feature = |k: f32| Feature { distance: k + 0.5, normal: [k, 0.0, -1.0], albedo: [0.25, k / 8.0, 1.0] };
        let features: Vec<_> = (0..6u8).map(f32::from).map(feature).collect();
        let about = About { scene: "a".to_owned(), spp: 8, manner: vec![("seed".to_owned(), "3".to_owned())] };
        let picture = Picture { width: 2, height: 3, halves: &halves, features: Some(&features), about: &about };
        // Tone and exposure are for screens.
        let shown = Shown { curve: Curve::Agx, exposure: 3.0 };
        let bytes = encode(&picture, &shown);
        let told = b"a, 8 spp, seed 3";
        assert!(bytes.windows(told.len()).any(|some| some == told) && bytes == encode(&picture, &shown));
        let (size, found) = channels(&bytes);
        assert_eq!(size, Vec2(2, 3));
        let of = |f: &dyn Fn(f32) -> f32| (0..6u8).map(f32::from).map(f).collect::<Vec<_>>();
        let expected: BTreeMap<String, Vec<f32>> = [
            ("R", of(&|k| k + 1.0)),
            ("G", of(&|_| 1.0)),
            ("B", of(&|_| f32::MAX)),
            // (2/2)² of the mean of two that are 2 apart.
            ("variance.R", of(&|_| 1.0)),
            ("variance.G", of(&|_| 0.0)),
            ("variance.B", of(&|_| 0.0)),
            ("normal.X", of(&|k| k)),
            ("normal.Y", of(&|_| 0.0)),
            ("normal.Z", of(&|_| -1.0)),
            ("albedo.R", of(&|_| 0.25)),
            ("albedo.G", of(&|k| k / 8.0)),
            ("albedo.B", of(&|_| 1.0)),
            ("depth.Z", of(&|k| k + 0.5)),
        ]
        .map(|(name, samples)| (name.to_owned(), samples))
        .into();
        assert_eq!(found, expected);
    }

    #[test]
    fn what_is_no_number_stays_none() {
        let halves = [[[f32::NAN, 1.0, f32::INFINITY], [1.0; 3]]];
        let about = About::default();
        let picture = Picture { width: 1, height: 1, halves: &halves, features: None, about: &about };
        let (_, found) = channels(&encode(&picture, &Shown { curve: Curve::None, exposure: 0.0 }));
        assert!(found["R"][0].is_nan() && found["G"][0] == 1.0 && found["B"][0] == f32::INFINITY);
        // Nor is anything made up of what is not known.
        let names: Vec<_> = found.keys().map(String::as_str).collect();
        assert_eq!(names, ["B", "G", "R", "variance.B", "variance.G", "variance.R"]);
    }
}
