//! What `lesson eval` offers from this chapter.

use super::dispersion::glow;
use crate::parameter::{Alias, BY_FREQUENCY, Function, Kind, Output, Parameter};
use light::colour::response::{BAND, response};
use light::colour::{daylight, matching};

/// The functions, each with its inputs' units and domains.
pub(super) const FUNCTIONS: &[Function] = &[BLACKBODY, OBSERVER];

const fn one(name: &'static str, says: &'static str) -> Output {
    Output::new(name, says, "1")
}

const BLACKBODY: Function = Function {
    name: "blackbody",
    says: "the colour of a black body by Planck's law and the CIE's observer of 1931: chromaticity, linear sRGB at luminance 1 \
           (below 0 where the colour lies outside), and its luminance",
    inputs: &[Parameter::new("temperature", "T", "of the body", Kind::number(500.0, 1e6, "K"))],
    outputs: &[
        one("x", "chromaticity x"),
        one("y", "chromaticity y"),
        one("red", "linear sRGB at luminance 1, red"),
        one("green", "green"),
        one("blue", "blue"),
        Output::new("luminance", "luminance of its surface", "cd/m²"),
    ],
    compute: |setting| {
        let ([x, y], [red, green, blue], luminance) = glow(setting.number("temperature"));
        Ok(vec![("x", x), ("y", y), ("red", red), ("green", green), ("blue", blue), ("luminance", luminance)])
    },
};

const OBSERVER: Function = Function {
    name: "observer",
    says: "what eye and picture see of a wavelength: the colour matching functions of the CIE 1931 2° observer, the relative power of \
           D65, and the responses of a picture's channels, which integrate to 1",
    inputs: &[Parameter::new("wavelength", "λ", "in vacuum", Kind::number(BAND[0], BAND[1], "m"))
        .aliases(&[Alias::counted_in("lambda_nm", "nm"), BY_FREQUENCY])],
    outputs: &[
        one("x_bar", "x̄"),
        one("y_bar", "ȳ"),
        one("z_bar", "z̄"),
        one("d65", "relative power of daylight, 100 at 560 nm"),
        Output::new("red", "response of the red channel", "1/m"),
        Output::new("green", "of the green one", "1/m"),
        Output::new("blue", "of the blue one", "1/m"),
    ],
    compute: |setting| {
        let wavelength = setting.number("wavelength");
        let ([x, y, z], [red, green, blue]) = (matching(wavelength), response().at(wavelength));
        Ok(vec![
            ("x_bar", x),
            ("y_bar", y),
            ("z_bar", z),
            ("d65", daylight(wavelength)),
            ("red", red),
            ("green", green),
            ("blue", blue),
        ])
    },
};
