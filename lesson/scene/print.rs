//! A scene as a TOML file, its meshes as PLY files and its images as OpenEXR.

use super::read::{MASKING, OUTSIDE, SKY_SCALE, SQUARES};
use super::{images, ply};
use light::scene::{
    Camera, Coating, Emission, Energy, Environment, Facets, Filter, Geometry, Glass, Image, Light, Material, Mesh,
    Metal, Normals, Pattern, Scene, Shape, Sky, Transform, Triple,
};
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

/// A scene as text, and the files it names that there are not.
#[derive(Debug)]
pub struct Printed {
    pub text: String,
    pub files: Vec<(String, Part)>,
}

/// What is written beside a scene.
#[derive(Clone, Debug)]
pub enum Part {
    Mesh(Arc<Mesh>),
    Image(Arc<Image>),
}

impl Part {
    /// What is in its file.
    pub fn bytes(&self) -> Vec<u8> {
        match self {
            Self::Mesh(mesh) => ply::write(mesh),
            Self::Image(image) => images::write_exr(image),
        }
    }

    fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Mesh(one), Self::Mesh(other)) => Arc::ptr_eq(one, other),
            (Self::Image(one), Self::Image(other)) => Arc::ptr_eq(one, other),
            _ => false,
        }
    }
}

/// Prints a scene. Meshes and images that were read keep the names of their files unless all are to be `written`.
pub fn print(scene: &Scene, written: bool) -> Printed {
    let mut printer = Printer { text: String::new(), files: Vec::new(), stem: stem(&scene.name), written };
    printer.scene(scene);
    Printed { text: printer.text, files: printer.files }
}

/// A name that every file system takes.
pub fn stem(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || matches!(c, '_' | '-') { c } else { '-' };
    let plain: String = name.chars().take(64).map(plain).collect();
    if plain.is_empty() { "scene".into() } else { plain }
}

struct Printer {
    text: String,
    files: Vec<(String, Part)>,
    stem: String,
    written: bool,
}

impl Printer {
    /// A line of its own.
    fn line(&mut self, line: impl AsRef<str>) {
        self.text += line.as_ref();
        self.text.push('\n');
    }

    /// `key = value`, and perhaps a unit.
    fn put(&mut self, key: &str, value: impl AsRef<str>, unit: &str) {
        let unit = if unit.is_empty() { String::new() } else { format!(" # {unit}") };
        self.line(format!("{key} = {}{unit}", value.as_ref()));
    }

    fn scene(&mut self, scene: &Scene) {
        let Scene { name, max_depth, filter, camera, environment, materials, shapes, lights } = scene;
        self.line("# Metres, linear RGB, right-handed.");
        self.put("name", quoted(name), "");
        if let Some(depth) = max_depth {
            self.put("max_depth", depth.to_string(), "edges of a path from camera to light; left out: no limit");
        }
        if *filter != Filter::default() {
            self.put("filter", quoted(filter.name()), "");
        }
        self.camera(camera);
        if let Some(environment) = environment {
            self.line("\n[environment]");
            self.environment(environment);
        }
        for (name, material) in materials {
            self.line(format!("\n[materials.{}]", key(name)));
            self.material(material);
        }
        for shape in shapes {
            self.line("\n[[shapes]]");
            self.shape(shape);
        }
        for light in lights {
            self.line("\n[[lights]]");
            self.light(light);
        }
    }

    fn camera(&mut self, camera: &Camera) {
        let Camera { origin, target, up, fov_y_deg, width, height, aperture, focus, polariser_deg } = camera;
        self.line("\n[camera]");
        self.put("origin", triple(*origin), "");
        self.put("target", triple(*target), "");
        if *up != Camera::UP {
            self.put("up", triple(*up), "");
        }
        self.put("fov_y_deg", number(*fov_y_deg), "full angle from the picture's lower edge to its upper");
        self.put("width", width.to_string(), "pixels");
        self.put("height", height.to_string(), "");
        if *aperture != 0.0 {
            self.put("aperture", number(*aperture), "m, the lens's radius");
        }
        if let Some(focus) = focus {
            self.put("focus", number(*focus), "m to what is sharp");
        }
        if let Some(angle) = polariser_deg {
            self.put("polariser_deg", number(*angle), "axis of a filter, from the picture's right to its up");
        }
    }

    fn environment(&mut self, environment: &Environment) {
        match environment {
            Environment::Constant(radiance) => self.put("radiance", triple(*radiance), "W m⁻² sr⁻¹"),
            Environment::Image(Sky { file, image, scale, rotate_deg }) => {
                let [width, height] = image.size();
                let file = self.file(file.as_deref(), Part::Image(Arc::clone(image)));
                self.put("image", quoted(&file), &format!("{width} × {height} texels"));
                if *scale != SKY_SCALE {
                    self.put("scale", number(*scale), "");
                }
                if *rotate_deg != 0.0 {
                    self.put("rotate_deg", number(*rotate_deg), "about y");
                }
            }
        }
    }

    /// A reflectance, from place to place if there is a pattern.
    fn reflectance(&mut self, reflectance: Triple, pattern: Option<&Pattern>) {
        let text = match pattern {
            None => triple(reflectance),
            Some(Pattern::Checker { colours, scale }) => {
                let scale = if *scale == SQUARES { String::new() } else { format!(", scale = {}", number(*scale)) };
                format!("{{ checker = [{}]{scale} }}", colours.map(triple).join(", "))
            }
            Some(Pattern::Image { file, image }) => {
                let file = self.file(file.as_deref(), Part::Image(Arc::clone(image)));
                format!("{{ image = {} }}", quoted(&file))
            }
        };
        self.put("reflectance", text, "");
    }

    fn material(&mut self, material: &Material) {
        let pattern = material.pattern();
        match material.base() {
            // Its base has none.
            Material::Patterned { .. } => {}
            Material::Diffuse { reflectance } => {
                self.put("type", quoted("diffuse"), "");
                self.reflectance(*reflectance, pattern);
            }
            Material::RoughDiffuse { reflectance, roughness } => {
                self.put("type", quoted("rough_diffuse"), "");
                self.reflectance(*reflectance, pattern);
                self.put("roughness", number(*roughness), "");
            }
            Material::Mirror { reflectance } => {
                self.put("type", quoted("mirror"), "");
                self.put("reflectance", triple(*reflectance), "");
            }
            Material::Conductor { metal, coating } => {
                self.put("type", quoted("conductor"), "");
                self.metal(metal);
                self.coating(coating.as_ref());
            }
            Material::RoughConductor { metal, facets, masking, energy, coating } => {
                self.put("type", quoted("rough_conductor"), "");
                self.metal(metal);
                self.facets(*facets);
                if *masking != MASKING {
                    self.put("masking", quoted(masking.name()), "");
                }
                self.energy(*energy);
                self.coating(coating.as_ref());
            }
            Material::Dielectric { ior, outside, absorption, coating } => {
                self.put("type", quoted("dielectric"), "");
                self.clear(*ior, *outside, *absorption);
                self.coating(coating.as_ref());
            }
            Material::Dispersive { glass, outside, absorption } => {
                self.put("type", quoted("dielectric"), "");
                match glass {
                    Glass::Named(name) => self.put("glass", quoted(name), ""),
                    Glass::Abbe { ior, abbe } => {
                        self.put("ior", number(*ior), "");
                        self.put("abbe", number(*abbe), "");
                    }
                }
                self.surrounded(*outside, *absorption);
            }
            Material::RoughDielectric { ior, outside, absorption, facets, energy } => {
                self.put("type", quoted("rough_dielectric"), "");
                self.clear(*ior, *outside, *absorption);
                self.facets(*facets);
                self.energy(*energy);
            }
            Material::Plastic { ior, reflectance, alpha } => {
                self.put("type", quoted("plastic"), "");
                self.put("ior", number(*ior), "");
                self.reflectance(*reflectance, pattern);
                if let Some(alpha) = alpha {
                    self.put("alpha", number(*alpha), "");
                }
            }
        }
    }

    fn metal(&mut self, metal: &Metal) {
        match metal {
            Metal::Named(name) => self.put("metal", quoted(name), ""),
            Metal::Indices { eta, k } => {
                self.put("eta", triple(*eta), "");
                self.put("k", triple(*k), "");
            }
        }
    }

    fn coating(&mut self, coating: Option<&Coating>) {
        if let Some(Coating { medium, thickness_nm }) = coating {
            let fields = format!("{{ medium = {}, thickness_nm = {} }}", quoted(medium), number(*thickness_nm));
            self.put("coating", fields, "");
        }
    }

    fn facets(&mut self, facets: Facets) {
        let Facets { alpha: [x, y], slopes } = facets;
        if x == y {
            self.put("alpha", number(x), "");
        } else {
            self.put("alpha_x", number(x), "");
            self.put("alpha_y", number(y), "");
        }
        self.put("distribution", quoted(slopes.name()), "");
    }

    fn energy(&mut self, energy: Energy) {
        if energy != Energy::default() {
            self.put("energy", quoted(energy.name()), "");
        }
    }

    fn clear(&mut self, ior: f64, outside: f64, absorption: Triple) {
        self.put("ior", number(ior), "");
        self.surrounded(outside, absorption);
    }

    fn surrounded(&mut self, outside: f64, absorption: Triple) {
        if outside != OUTSIDE {
            self.put("outside", number(outside), "");
        }
        if absorption != [0.0; 3] {
            self.put("absorption", triple(absorption), "m⁻¹");
        }
    }

    fn shape(&mut self, shape: &Shape) {
        let Shape { geometry, material, emission, transform } = shape;
        match geometry {
            Geometry::Quad { vertices } => {
                self.put("type", quoted("quad"), "");
                self.put("vertices", format!("[{}]", vertices.map(triple).join(", ")), "");
            }
            Geometry::Sphere { center, radius } => {
                self.put("type", quoted("sphere"), "");
                self.put("center", triple(*center), "");
                self.put("radius", number(*radius), "");
            }
            Geometry::Disc { center, normal, radius } => {
                self.put("type", quoted("disc"), "");
                self.put("center", triple(*center), "");
                self.put("normal", triple(*normal), "");
                self.put("radius", number(*radius), "");
            }
            Geometry::Box { min, max } => {
                self.put("type", quoted("box"), "");
                self.put("min", triple(*min), "");
                self.put("max", triple(*max), "");
            }
            Geometry::Mesh { file, normals, mesh } => {
                self.put("type", quoted("mesh"), "");
                let file = self.file(file.as_deref(), Part::Mesh(Arc::clone(mesh)));
                self.put("file", quoted(&file), &format!("{} triangles", mesh.triangles.len()));
                if *normals != Normals::default() {
                    self.put("normals", quoted(normals.name()), "");
                }
            }
        }
        self.put("material", quoted(material), "");
        if let Some(Emission { radiance, two_sided }) = emission {
            self.put("emission", triple(*radiance), "W m⁻² sr⁻¹");
            if *two_sided {
                self.put("two_sided", "true", "");
            }
        }
        self.transform(transform);
    }

    /// The name of the file that a part has, or will have.
    fn file(&mut self, named: Option<&Path>, part: Part) -> String {
        if let Some(named) = named.filter(|_| !self.written).and_then(Path::to_str) {
            return named.to_owned();
        }
        if let Some((name, _)) = self.files.iter().find(|(_, known)| known.is(&part)) {
            return name.clone();
        }
        let kind = match part {
            Part::Mesh(_) => "ply",
            Part::Image(_) => "exr",
        };
        let others = self.files.iter().filter(|(name, _)| name.ends_with(kind)).count();
        let name = match others {
            0 => format!("{}.{kind}", self.stem),
            others => format!("{}-{}.{kind}", self.stem, others + 1),
        };
        self.files.push((name.clone(), part));
        name
    }

    fn transform(&mut self, transform: &Transform) {
        let Transform { scale, rotate_deg, translate } = *transform;
        let own = Transform::default();
        let mut fields = Vec::new();
        if scale != own.scale {
            let [x, y, z] = scale;
            fields.push(format!("scale = {}", if x == y && y == z { number(x) } else { triple(scale) }));
        }
        if rotate_deg != own.rotate_deg {
            fields.push(format!("rotate_deg = {}", triple(rotate_deg)));
        }
        if translate != own.translate {
            fields.push(format!("translate = {}", triple(translate)));
        }
        if !fields.is_empty() {
            self.put("transform", format!("{{ {} }}", fields.join(", ")), "in that order");
        }
    }

    fn light(&mut self, light: &Light) {
        match light {
            Light::Point { position, intensity } => {
                self.put("type", quoted("point"), "");
                self.put("position", triple(*position), "");
                self.put("intensity", triple(*intensity), "W sr⁻¹");
            }
            Light::Directional { direction, irradiance } => {
                self.put("type", quoted("directional"), "");
                self.put("direction", triple(*direction), "of travel");
                self.put("irradiance", triple(*irradiance), "W m⁻² on a plane square to it");
            }
        }
    }
}

/// The shortest text that is read as the same number.
fn number(number: f64) -> String {
    let text = format!("{number:?}");
    // TOML's whole numbers know no −0.
    match text.strip_suffix(".0") {
        Some(whole) if number != 0.0 || number.is_sign_positive() => whole.to_owned(),
        _ => text,
    }
}

fn triple(of: Triple) -> String {
    format!("[{}]", of.map(number).join(", "))
}

/// A name as a key.
fn key(name: &str) -> String {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
    if !name.is_empty() && name.chars().all(is_bare) { name.to_owned() } else { quoted(name) }
}

/// A text as TOML's basic string.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            '\n' => quoted += "\\n",
            '\t' => quoted += "\\t",
            c if c.is_control() => write!(quoted, "\\u{:04x}", u32::from(c)).expect("a string takes all"),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
