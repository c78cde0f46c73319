//! What is rendered, as data: a camera, shapes, what they are made of, and lights.
//!
//! Metres, right-handed, linear RGB, radiance in [W m⁻² sr⁻¹]; angles in degrees, as scene files have them. A scene is
//! looked at once, by [`Scene::flaw`]; what makes pictures of it takes only scenes without one.
//!
//! | idea | where |
//! |---|---|
//! | what surfaces are made of | [`material`] |
//! | reflectances that change from place to place | [`Pattern`] |
//! | what there is to see | [`shape`] |
//! | images, and what is behind everything | [`image`] |
//! | what is wrong with a scene, and where | [`flaw`] |
//! | the scenes of the lecture | [`builtin`] |

pub mod builtin;
pub mod flaw;
pub mod image;
pub mod material;
mod pattern;
pub mod shape;
pub(crate) mod triple;

pub use flaw::{Flaw, Part, Place, Unknown};
pub use image::{Environment, Image, Sky};
pub use material::{Coating, Energy, Facets, Glass, Material, Metal};
pub use pattern::Pattern;
pub use shape::{Emission, Geometry, Map, Mesh, Normals, Shape, Transform};

/// A point [m], a direction, or a size along each axis.
pub type Triple = [f64; 3];

/// All of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// What it is called.
    pub name: String,
    /// The most edges of a path, from camera to light: 1 shows emitters alone, 2 direct light. None is no limit.
    pub max_depth: Option<u32>,
    /// How the samples of a pixel are weighed.
    pub filter: Filter,
    /// Who looks.
    pub camera: Camera,
    /// What is behind all shapes; None is black.
    pub environment: Option<Environment>,
    /// What shapes are made of, by name; names differ.
    pub materials: Vec<(String, Material)>,
    /// What there is to see.
    pub shapes: Vec<Shape>,
    /// Lights without a surface.
    pub lights: Vec<Light>,
}

/// How samples of a pixel, and of those about it, are weighed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filter {
    /// The plain mean of the pixel's own.
    #[default]
    Box,
    /// Falling evenly to 0 one pixel from the centre.
    Tent,
    /// A Gaussian of standard deviation ½ pixel, cut two pixels from the centre.
    Gaussian,
}

impl Filter {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Box, Self::Tent, Self::Gaussian];

    /// Its word in a scene file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Box => "box",
            Self::Tent => "tent",
            Self::Gaussian => "gaussian",
        }
    }
}

/// A thin lens, or a pinhole where its aperture is 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Where it stands [m].
    pub origin: Triple,
    /// What it looks at [m].
    pub target: Triple,
    /// What is up in the picture: any direction but the one of view. The picture's right is view × up.
    pub up: Triple,
    /// The full angle [deg] that the picture spans vertically, 0 … 180 excluded.
    pub fov_y_deg: f64,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// The lens's radius [m].
    pub aperture: f64,
    /// Distance [m] of the sharp plane; None is that of the target.
    pub focus: Option<f64>,
    /// The angle [deg] of an ideal polariser before it, from the picture's right to its up: what swings along that passes. None is no
    /// filter.
    pub polariser_deg: Option<f64>,
}

/// A light without a surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Light {
    /// From a point to all sides.
    Point {
        /// Where [m].
        position: Triple,
        /// Radiant intensity [W sr⁻¹].
        intensity: Triple,
    },
    /// From infinitely far.
    Directional {
        /// Where it goes to; of any length but 0.
        direction: Triple,
        /// Irradiance [W m⁻²] on a plane square to it.
        irradiance: Triple,
    },
}

impl Camera {
    /// [`Camera::up`] unless it is said otherwise.
    pub const UP: Triple = [0.0, 1.0, 0.0];
}

impl Scene {
    /// The material called `name`.
    pub fn material(&self, name: &str) -> Option<&Material> {
        self.materials.iter().find(|(known, _)| known == name).map(|(_, material)| material)
    }
}
