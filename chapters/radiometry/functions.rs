//! What `lesson eval` offers from this chapter.

use crate::parameter::{Fault, Function, Kind, Output, Parameter, Range};
use light::radiometry::disc::Disc;
use light::radiometry::form_factor::{self, LENGTHS};
use light::radiometry::sphere::Sphere;
use light::radiometry::{Refusal, point, polygon, rectangle};
use std::f64::consts::PI;

/// The functions, each with its inputs' units and domains.
pub(super) const FUNCTIONS: &[Function] = &[IRRADIANCE, FORM_FACTOR];

/// A length that is not null [m].
const LENGTH: Kind = Kind::number(1e-150, 1e150, "m");

const fn length(
    name: &'static str,
    symbol: &'static str,
    says: &'static str,
    kinds: &'static [&'static str],
) -> Parameter {
    Parameter::new(name, symbol, says, LENGTH).only_with("kind", kinds)
}

const IRRADIANCE: Function = Function {
    name: "irradiance",
    says: "what arrives at the origin, on a receiver of normal +z unless said otherwise, from a lamp of one radiance that \
           shines to both sides, as far as it is above the receiver's horizon",
    inputs: &[
        Parameter::new("kind", "", "shape of the lamp", Kind::Choice(&["disk", "rect", "polygon", "sphere", "point"])),
        Parameter::new(
            "radiance",
            "L",
            "radiance of the lamp; of a point count Phi instead",
            Kind::number(0.0, 1e30, "W/(sr m²)"),
        )
        .default("1"),
        length("R", "R", "radius", &["disk", "sphere"]),
        length("h", "h", "height of the lamp's plane over the receiver", &["disk", "rect"]),
        Parameter::new("a", "a", "how far the disk's centre (a, 0, h) is aside", Kind::number(-1e150, 1e150, "m"))
            .default("0")
            .only_with("kind", &["disk"]),
        Parameter::new(
            "tau",
            "τ",
            "tilt of the receiver: its normal is (sin τ, 0, cos τ)",
            Kind::number(-PI, PI, "rad"),
        )
        .default("0")
        .only_with("kind", &["disk"]),
        length("a", "a", "side along x, from a corner over the receiver", &["rect"]),
        length("b", "b", "side along y, from the same corner", &["rect"]),
        Parameter::new("vertices", "", "the corners in order, in one plane", Kind::List { of: &CORNER, most: 100_000 })
            .only_with("kind", &["polygon"]),
        Parameter::new("normal", "n", "normal of the receiver, of any length", CORNER).only_with("kind", &["polygon"]),
        length("d", "d", "distance of the centre, or of the point", &["sphere", "point"]),
        Parameter::new(
            "omega",
            "ω",
            "angle between the receiver's normal and the way to the centre",
            Kind::number(0.0, PI, "rad"),
        )
        .only_with("kind", &["sphere"]),
        Parameter::new("Phi", "Φ", "flux of the point, alike to all sides", Kind::number(0.0, 1e30, "W"))
            .only_with("kind", &["point"]),
        Parameter::new(
            "theta",
            "θ",
            "angle between the receiver's normal and the way to the point",
            Kind::number(0.0, PI, "rad"),
        )
        .only_with("kind", &["point"]),
    ],
    outputs: &[
        Output::new("E", "irradiance", "W/m²"),
        Output::new("E_parallel", "of a rect, the same as E", "W/m²"),
        Output::new("E_perpendicular", "of a rect, on a receiver of normal +x", "W/m²"),
        Output::new("solid_angle", "of a rect, as seen from the receiver", "sr"),
    ],
    compute: |setting| {
        let (radiance, number) = (setting.number("radiance"), |name: &str| setting.number(name));
        let found = match setting.word("kind") {
            "disk" => {
                let disc = Disc { radius: number("R"), height: number("h"), offset: number("a"), tilt: number("tau") };
                radiance * disc.irradiance().map_err(fault)?
            }
            "rect" => {
                let of = rectangle::corner(number("a"), number("b"), number("h")).map_err(fault)?;
                return Ok(vec![
                    ("E", radiance * of.parallel),
                    ("E_parallel", radiance * of.parallel),
                    ("E_perpendicular", radiance * of.perpendicular),
                    ("solid_angle", of.solid_angle),
                ]);
            }
            "polygon" => {
                let corners: Vec<[f64; 3]> = setting.vectors("vertices").collect();
                radiance * polygon::irradiance(&corners, setting.vector("normal")).map_err(fault)?
            }
            "sphere" => {
                let sphere = Sphere { radius: number("R"), distance: number("d"), omega: number("omega") };
                radiance * sphere.irradiance().map_err(fault)?
            }
            _ => point(number("Phi"), number("d"), number("theta")).map_err(fault)?,
        };
        Ok(vec![("E", found)])
    },
};

/// A place or a way.
const CORNER: Kind = Kind::Vector(Range::new(-1e150, 1e150, "m"));

const FORM_FACTOR: Function = Function {
    name: "form-factor",
    says: "the share of what leaves one Lambertian surface that arrives at another",
    inputs: &[
        Parameter::new(
            "kind",
            "",
            "which two surfaces",
            Kind::Choice(&["parallel-rectangles", "perpendicular-rectangles", "coaxial-discs"]),
        ),
        side("a", "a", "one side of both", &["parallel-rectangles"]),
        side("b", "b", "the other side of both", &["parallel-rectangles"]),
        side("c", "c", "distance of their planes", &["parallel-rectangles"]),
        side("w", "w", "width of the rectangle from which it goes", &["perpendicular-rectangles"]),
        side("h", "h", "height of the one to which it goes", &["perpendicular-rectangles"]),
        side("l", "l", "their common edge", &["perpendicular-rectangles"]),
        side("r1", "r_1", "radius of the disc from which it goes", &["coaxial-discs"]),
        side("r2", "r_2", "radius of the one to which it goes", &["coaxial-discs"]),
        side("h", "h", "distance of their planes", &["coaxial-discs"]),
    ],
    outputs: &[Output::new("F", "form factor", "1")],
    compute: |setting| {
        let number = |name: &str| setting.number(name);
        let found = match setting.word("kind") {
            "parallel-rectangles" => form_factor::parallel_rectangles(number("a"), number("b"), number("c")),
            "perpendicular-rectangles" => form_factor::perpendicular_rectangles(number("w"), number("h"), number("l")),
            _ => form_factor::coaxial_discs(number("r1"), number("r2"), number("h")),
        };
        Ok(vec![("F", found.map_err(fault)?)])
    },
};

const fn side(
    name: &'static str,
    symbol: &'static str,
    says: &'static str,
    kinds: &'static [&'static str],
) -> Parameter {
    Parameter::new(name, symbol, says, Kind::number(LENGTHS.0, LENGTHS.1, "m")).only_with("kind", kinds)
}

fn fault(refusal: Refusal) -> Fault {
    Fault::new(refusal.place, refusal.why)
}
