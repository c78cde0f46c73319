//! The keys of a scene file: what the reader takes, and what is told of it. One table for both.

use light::bsdf::microfacet::{Joint, Slopes};
use light::scene::flaw::domain::{self, Domain};
use light::scene::material::{films, glasses, metals};
use light::scene::{Energy, Filter};

/// A key of a table.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    pub name: &'static str,
    pub kind: Kind,
    pub need: Need,
    /// What it is, in a few words.
    pub says: &'static str,
}

/// What stands under a key.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    Number(Domain),
    /// A list of three, each within the domain.
    Three(Domain),
    /// One number, or a list of three.
    Size(Domain),
    /// A list of four lists of three.
    Corners(Domain),
    /// A list of two lists of three.
    Pair(Domain),
    /// A list of three, or a table.
    ThreeOr(Domain, &'static str),
    /// A whole number from 1.
    Count,
    Flag,
    /// Any text.
    Text,
    /// One of some words.
    Word(fn() -> Vec<&'static str>),
    /// A table, or null.
    Table(&'static str),
    /// A list of tables, or a table of them by name.
    Tables(&'static str),
}

/// Whether a key has to be there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Need {
    Must,
    /// What holds without it: a value as it would be written, or what that is in words.
    May(&'static str),
    /// Unless this one is there.
    Unless(&'static str),
}

/// Something of the contract that this version does not have: its key, and what that is.
pub type Later = (&'static str, &'static str);

/// What a table may hold.
#[derive(Clone, Copy, Debug)]
pub struct Object {
    /// What it describes: `a camera`.
    pub what: &'static str,
    /// The keys, in groups that several objects share.
    pub keys: &'static [&'static [Key]],
    pub later: &'static [Later],
}

/// A kind of object by the word under its key `type`, and what reads it.
#[derive(Clone, Copy, Debug)]
pub struct Type<R: 'static> {
    pub name: &'static str,
    pub keys: &'static [&'static [Key]],
    pub later: &'static [Later],
    pub read: R,
}

const fn key(name: &'static str, kind: Kind, need: Need, says: &'static str) -> Key {
    Key { name, kind, need, says }
}

pub const fn must(name: &'static str, kind: Kind, says: &'static str) -> Key {
    key(name, kind, Need::Must, says)
}

pub const fn may(name: &'static str, kind: Kind, default: &'static str, says: &'static str) -> Key {
    key(name, kind, Need::May(default), says)
}

pub const SCENE: Object = Object {
    what: "a scene",
    keys: &[&[
        may("name", Kind::Text, "the file's", "what the scene is called"),
        may(
            "max_depth",
            Kind::Count,
            "no limit",
            "the most edges of a path from camera to light: 1 shows emitters alone, 2 direct light",
        ),
        may(
            "filter",
            Kind::Word(|| Filter::ALL.map(Filter::name).into()),
            "\"box\"",
            "how a pixel's samples are weighed",
        ),
        must("camera", Kind::Table("a camera"), "who looks"),
        may("environment", Kind::Table("an environment"), "black", "what is behind everything"),
        may("materials", Kind::Tables("materials by name"), "none", "what shapes are made of"),
        may("shapes", Kind::Tables("shapes"), "none", "what there is to see"),
        may("lights", Kind::Tables("lights"), "none", "lights without a surface"),
    ]],
    later: &[],
};

pub const CAMERA: Object = Object {
    what: "a camera",
    keys: &[&[
        must("origin", Kind::Three(domain::COORDINATE), "where it stands"),
        must("target", Kind::Three(domain::COORDINATE), "what is in the middle of the picture"),
        may("up", Kind::Three(domain::DIRECTION), "[0, 1, 0]", "what is up in the picture"),
        must("fov_y_deg", Kind::Number(domain::FIELD_OF_VIEW), "the full angle from the lower edge to the upper"),
        must("width", Kind::Count, "pixels"),
        must("height", Kind::Count, "pixels"),
        may("aperture", Kind::Number(domain::APERTURE), "0", "the lens's radius; 0 is a pinhole"),
        may("focus", Kind::Number(domain::LENGTH), "the distance of the target", "the distance of what is sharp"),
        may(
            "polariser_deg",
            Kind::Number(domain::TURN),
            "none",
            "an ideal polariser before it, its axis from the picture's right towards its up",
        ),
    ]],
    later: &[],
};

pub const ENVIRONMENT: Object = Object {
    what: "an environment",
    keys: &[&[
        key(
            "image",
            Kind::Text,
            Need::Unless("radiance"),
            "a .exr or .hdr, from the scene's folder: radiance by latitude and longitude, +y on top, +z in the middle, +x left of it",
        ),
        key("radiance", Kind::Three(domain::RADIANCE), Need::Unless("image"), "from everywhere alike"),
        may("scale", Kind::Number(domain::FACTOR), "1", "times the image's radiance; only with image"),
        may("rotate_deg", Kind::Number(domain::TURN), "0", "turned about y, from z towards x; only with image"),
    ]],
    later: &[],
};

pub const COATING: Object = Object {
    what: "a coating",
    keys: &[&[
        must("medium", Kind::Word(|| films().map(|known| known.name).collect()), "what the film is made of"),
        must("thickness_nm", Kind::Number(domain::FILM), "how thick it is"),
    ]],
    later: &[],
};

pub const TRANSFORM: Object = Object {
    what: "a transform",
    keys: &[&[
        may("scale", Kind::Size(domain::SCALE), "1", "first: larger, along each axis"),
        may("rotate_deg", Kind::Three(domain::TURN), "[0, 0, 0]", "then: turned about x, y and z, in that order"),
        may("translate", Kind::Three(domain::COORDINATE), "[0, 0, 0]", "last: moved"),
    ]],
    later: &[],
};

/// What kind a table with a key `type` is of.
pub const TYPE: Key = must("type", Kind::Text, "of which kind it is");
pub const REFLECTANCE: Key = must("reflectance", Kind::Three(domain::SHARE), "how much goes back, by channel");
/// The same where it may change from place to place.
pub const PATTERNED: Key = must(
    "reflectance",
    Kind::ThreeOr(domain::SHARE, "a pattern"),
    "how much goes back, by channel, from place to place",
);

pub const PATTERN: Object = Object {
    what: "a pattern",
    keys: &[&[
        key(
            "checker",
            Kind::Pair(domain::SHARE),
            Need::Unless("image"),
            "how much two kinds of squares send back, the first in the lower left corner",
        ),
        key(
            "image",
            Kind::Text,
            Need::Unless("checker"),
            "a .png or .jpg (sRGB) or .exr (linear), from the scene's folder; its lower left corner lies at a quad's first, the right one at the second",
        ),
        may("scale", Kind::Number(domain::SQUARES), "8", "squares along each side of the shape; only with checker"),
    ]],
    later: &[],
};
pub const IOR: Key = must("ior", Kind::Number(domain::IOR), "the index inside");
pub const COATED: Key = may("coating", Kind::Table("a coating"), "none", "a film upon it");
pub const ENERGY: Key = may(
    "energy",
    Kind::Word(|| Energy::ALL.map(Energy::name).into()),
    "\"compensated\"",
    "what becomes of light that meets several facets",
);

/// Of what a conductor is made.
pub const METAL: &[Key] = &[
    key("metal", Kind::Word(|| metals().map(|known| known.name).collect()), Need::Unless("eta"), "which"),
    key("eta", Kind::Three(domain::METAL), Need::Unless("metal"), "n by channel"),
    key("k", Kind::Three(domain::METAL), Need::Unless("metal"), "κ by channel"),
];

/// How the facets of a rough surface lie.
pub const FACETS: &[Key] = &[
    key("alpha", Kind::Number(domain::ALPHA), Need::Unless("alpha_x"), "roughness"),
    key("alpha_x", Kind::Number(domain::ALPHA), Need::Unless("alpha"), "roughness along the surface's first axis"),
    key("alpha_y", Kind::Number(domain::ALPHA), Need::Unless("alpha"), "roughness along its second axis"),
    may("distribution", Kind::Word(|| Slopes::ALL.map(Slopes::name).into()), "\"ggx\"", "how slopes are distributed"),
];

/// What is clear.
pub const CLEAR: &[Key] = &[
    IOR,
    may("outside", Kind::Number(domain::IOR), "1", "the index outside"),
    may("absorption", Kind::Three(domain::ABSORPTION), "[0, 0, 0]", "radiance falls by e^(−aℓ) on a way ℓ inside"),
];

/// What polished glass is, by its index or its name.
pub const GLASS: &[Key] = &[
    key("ior", Kind::Number(domain::IOR), Need::Unless("glass"), "the index inside"),
    may(
        "abbe",
        Kind::Number(domain::ABBE),
        "one index for all",
        "Abbe's number: how little it depends on the wavelength",
    ),
    key(
        "glass",
        Kind::Word(|| glasses().map(|known| known.name).collect()),
        Need::Unless("ior"),
        "which: its index depends on the wavelength",
    ),
    CLEAR[1],
    CLEAR[2],
];

/// What glass cannot be yet.
pub const GLASSES: &[Later] = &[("glass", "a glass by name, whose index depends on the wavelength,")];
/// What rough glass cannot be yet: the light that coated facets lose on both sides would want tables of its own, by channel and film.
pub const ROUGH_GLASSES: &[Later] = &[GLASSES[0], ("coating", "a film on rough glass")];

/// How masking from two sides goes together.
pub const MASKING: Key = may(
    "masking",
    Kind::Word(|| Joint::ALL.map(Joint::name).into()),
    "\"correlated\"",
    "how two sides' masking goes together",
);

/// What every shape has beside its own keys.
pub const SHAPE: &[Key] = &[
    must("material", Kind::Text, "the name of its material"),
    may("emission", Kind::Three(domain::RADIANCE), "none", "radiance on its normal's side, outward of a sphere"),
    may("two_sided", Kind::Flag, "false", "whether it sends that out on both sides; only with emission"),
    may("transform", Kind::Table("a transform"), "none", "scaled, turned, moved"),
];

/// What the reflectance of a mirror cannot be yet.
pub const PATTERNS: &[Later] =
    &[("image", "an image as a mirror's reflectance"), ("checker", "a checkerboard as a mirror's reflectance")];
