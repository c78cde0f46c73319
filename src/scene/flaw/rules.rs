//! The rules.

use super::domain::{
    ABBE, ABSORPTION, ALPHA, APERTURE, COORDINATE, DIRECTION, Domain, FACTOR, FAR, FIELD_OF_VIEW, FILM, INTENSITY, IOR,
    IRRADIANCE, LENGTH, METAL, PLACE, RADIANCE, SCALE, SHARE, SQUARES, Shown, TURN,
};
use super::{Flaw, Part};
use crate::bsdf::dispersive::D_LINE;
use crate::colour::response::BAND;
use crate::media::named;
use crate::scene::material::{films, glasses, metals};
use crate::scene::triple::{cross, largest, length, minus, plus, widened};
use crate::scene::{
    Camera, Coating, Emission, Environment, Facets, Geometry, Glass, Image, Light, Material, Mesh, Metal, Normals,
    Pattern, Scene, Shape, Transform, Triple,
};

type Checked = Result<(), Flaw>;

/// Sizes below that vanish when they are squared in single numbers.
const LEAST_SCALE: f64 = 1e-12;

/// What a pixel takes in memory [byte]: in the film, and in the round being rendered, two sums of three single numbers.
const PIXEL: u64 = 2 * 2 * 3 * 4;
/// What a picture may take [byte].
const PICTURE: u64 = 4 << 30;

/// How far from a parallelogram [1] of its longest edge a quad may be: what single numbers in a file leave.
const ASKEW: f64 = 1e-6;
/// The least angle [rad] between the view and what is up.
const UPRIGHT: f64 = 1e-6;
/// How many roundings a difference of coordinates has to exceed.
const ROUNDINGS: f64 = 4.0;

pub(super) fn scene(scene: &Scene) -> Checked {
    if scene.max_depth == Some(0) {
        return Err(Flaw::of("max_depth", "0 is out of range; valid: at least 1, which shows emitters alone"));
    }
    camera(&scene.camera).map_err(|flaw| flaw.within("camera"))?;
    scene.environment.as_ref().map_or(Ok(()), environment).map_err(|flaw| flaw.within("environment"))?;
    for (at, (name, of)) in scene.materials.iter().enumerate() {
        let within = |flaw: Flaw| flaw.within(name.as_str()).within("materials");
        if scene.materials[..at].iter().any(|(earlier, _)| earlier == name) {
            return Err(within(Flaw::of_all("there are two of that name")));
        }
        material(of).map_err(within)?;
    }
    every("shapes", &scene.shapes, |of| shape(of, scene))?;
    every("lights", &scene.lights, light)
}

/// Holds each of a list to its rules.
fn every<T>(key: &str, list: &[T], rule: impl Fn(&T) -> Checked) -> Checked {
    let mut each = list.iter().enumerate();
    each.try_for_each(|(at, one)| rule(one).map_err(|flaw| flaw.within(at).within(key)))
}

fn environment(environment: &Environment) -> Checked {
    let sky = match environment {
        Environment::Constant(radiance) => return RADIANCE.holds_all("radiance", *radiance),
        Environment::Image(sky) => sky,
    };
    FACTOR.holds("scale", sky.scale)?;
    TURN.holds("rotate_deg", sky.rotate_deg)?;
    texels(&sky.image, sky.scale, &RADIANCE).map_err(|why| Flaw::of("image", why))
}

/// Holds an image's texels, times a factor, to a domain.
fn texels(image: &Image, factor: f64, domain: &Domain) -> Result<(), String> {
    let [width, height] = image.size();
    if image.texels().len() as u64 > Image::MOST {
        let most = Image::MOST;
        return Err(format!("has {width} × {height} texels; valid: width × height up to {most}"));
    }
    let wrong = |texel: &[f32; 3]| texel.iter().any(|part| domain.holds("", f64::from(*part) * factor).is_err());
    let Some(at) = image.texels().iter().position(wrong) else { return Ok(()) };
    let [red, green, blue] = image.texels()[at].map(|part| Shown(f64::from(part) * factor));
    let (column, row) = (at % width as usize, at / width as usize);
    Err(format!("its texel in column {column} of row {row}, from 0, is [{red}, {green}, {blue}]; valid: {domain}"))
}

fn camera(camera: &Camera) -> Checked {
    let Camera { origin, target, up, fov_y_deg, width, height, aperture, focus, polariser_deg } = camera;
    COORDINATE.holds_all("origin", *origin)?;
    COORDINATE.holds_all("target", *target)?;
    if origin == target {
        return Err(Flaw::of("target", "is where the camera stands; valid: any other place"));
    }
    direction("up", *up)?;
    let view = minus(*target, *origin);
    let [view, up] = [view, *up].map(|of| of.map(|x| x / largest(of)));
    if length(cross(view, up)) <= UPRIGHT * length(view) * length(up) {
        return Err(Flaw::of("up", "is along the view; valid: any other direction"));
    }
    FIELD_OF_VIEW.holds("fov_y_deg", *fov_y_deg)?;
    for (key, pixels) in [("width", width), ("height", height)] {
        if *pixels == 0 {
            return Err(Flaw::of(key, "0 is out of range; valid: at least 1"));
        }
    }
    let needed = u64::from(*width) * u64::from(*height);
    if needed > PICTURE / PIXEL {
        let pixels = PICTURE / PIXEL;
        let why = format!(
            "{width} × {height} pixels take {:.1} GiB of memory; valid: width × height up to {pixels}, which take {} GiB",
            needed as f64 * PIXEL as f64 / f64::from(1 << 30),
            PICTURE >> 30
        );
        return Err(Flaw::of(if width >= height { "width" } else { "height" }, why));
    }
    APERTURE.holds("aperture", *aperture)?;
    focus.map_or(Ok(()), |focus| LENGTH.holds("focus", focus))?;
    polariser_deg.map_or(Ok(()), |angle| TURN.holds("polariser_deg", angle))
}

/// A direction has a length that can be told from 0 and from infinity.
fn direction(part: impl Into<Part>, of: Triple) -> Checked {
    let part = part.into();
    DIRECTION.holds_all(part.clone(), of)?;
    match largest(of) >= 1.0 / FAR {
        true => Ok(()),
        false => Err(Flaw::of(part, format!("has no length; valid: a component of at least {}", Shown(1.0 / FAR)))),
    }
}

fn material(material: &Material) -> Checked {
    match material {
        Material::Diffuse { reflectance } | Material::Mirror { reflectance } => {
            SHARE.holds_all("reflectance", *reflectance)
        }
        Material::RoughDiffuse { reflectance, roughness } => {
            SHARE.holds_all("reflectance", *reflectance)?;
            SHARE.holds("roughness", *roughness)
        }
        Material::Conductor { metal: of, coating: film } => {
            metal(of)?;
            coating(film.as_ref())
        }
        Material::RoughConductor { metal: of, facets: rough, masking: _, energy: _, coating: film } => {
            metal(of)?;
            facets(*rough)?;
            coating(film.as_ref())
        }
        Material::Dielectric { ior, outside, absorption, coating: film } => {
            clear(*ior, *outside, *absorption)?;
            coating(film.as_ref())
        }
        Material::Dispersive { glass, outside, absorption } => {
            let key = match glass {
                Glass::Named(name) => {
                    let names = || glasses().map(|glass| glass.name.to_owned());
                    if !glasses().any(|known| named(name) == Some(known)) {
                        return Err(Flaw::unknown("glass", "no clear medium known at all that is seen", name, names()));
                    }
                    "glass"
                }
                Glass::Abbe { ior, abbe } => {
                    IOR.holds("ior", *ior)?;
                    ABBE.holds("abbe", *abbe)?;
                    "abbe"
                }
            };
            IOR.holds("outside", *outside)?;
            for wavelength in [BAND[0], D_LINE, BAND[1]] {
                IOR.holds(key, glass.index(wavelength)? / outside)
                    .map_err(|flaw| Flaw { why: format!("its index over the one outside, {}", flaw.why), ..flaw })?;
            }
            ABSORPTION.holds_all("absorption", *absorption)
        }
        Material::RoughDielectric { ior, outside, absorption, facets: rough, energy: _ } => {
            clear(*ior, *outside, *absorption)?;
            facets(*rough)
        }
        Material::Plastic { ior, reflectance, alpha } => {
            IOR.holds("ior", *ior)?;
            SHARE.holds_all("reflectance", *reflectance)?;
            alpha.map_or(Ok(()), |alpha| ALPHA.holds("alpha", alpha))
        }
        Material::Patterned { of, pattern: drawn } => {
            if !matches!(**of, Material::Diffuse { .. } | Material::RoughDiffuse { .. } | Material::Plastic { .. }) {
                return Err(Flaw::of(
                    "reflectance",
                    "a pattern is drawn on what is diffuse, rough and diffuse, or plastic",
                ));
            }
            pattern(drawn).map_err(|flaw| flaw.within("reflectance"))?;
            self::material(of)
        }
    }
}

fn pattern(pattern: &Pattern) -> Checked {
    match pattern {
        Pattern::Image { file: _, image } => texels(image, 1.0, &SHARE).map_err(|why| Flaw::of("image", why)),
        Pattern::Checker { colours, scale } => {
            (0..2).try_for_each(|at| SHARE.holds_all(at, colours[at])).map_err(|flaw| flaw.within("checker"))?;
            SQUARES.holds("scale", *scale)
        }
    }
}

fn metal(metal: &Metal) -> Checked {
    match metal {
        Metal::Indices { eta, k } => {
            METAL.holds_all("eta", *eta)?;
            METAL.holds_all("k", *k)
        }
        Metal::Named(name) => match named(name).is_some_and(|known| metals().any(|metal| metal == known)) {
            true => Ok(()),
            false => {
                let names = metals().map(|metal| metal.name.to_owned());
                Err(Flaw::unknown("metal", "no metal whose colour is known", name, names))
            }
        },
    }
}

fn coating(coating: Option<&Coating>) -> Checked {
    let Some(Coating { medium, thickness_nm }) = coating else { return Ok(()) };
    let is_known = named(medium).is_some_and(|known| films().any(|film| film == known));
    let medium = match is_known {
        true => Ok(()),
        false => {
            let names = films().map(|film| film.name.to_owned());
            Err(Flaw::unknown("medium", "no medium whose index is known", medium, names))
        }
    };
    medium.and_then(|()| FILM.holds("thickness_nm", *thickness_nm)).map_err(|flaw| flaw.within("coating"))
}

fn facets(facets: Facets) -> Checked {
    match facets.alpha {
        [x, y] if x == y || x.is_nan() && y.is_nan() => ALPHA.holds("alpha", x),
        [x, y] => ALPHA.holds("alpha_x", x).and_then(|()| ALPHA.holds("alpha_y", y)),
    }
}

fn clear(ior: f64, outside: f64, absorption: Triple) -> Checked {
    IOR.holds("ior", ior)?;
    IOR.holds("outside", outside)?;
    IOR.holds("ior", ior / outside)
        .map_err(|flaw| Flaw { why: format!("over the one outside, {}", flaw.why), ..flaw })?;
    ABSORPTION.holds_all("absorption", absorption)
}

fn shape(shape: &Shape, scene: &Scene) -> Checked {
    let Shape { geometry: form, material, emission, transform: moved } = shape;
    geometry(form)?;
    transform(moved, form).map_err(|flaw| flaw.within("transform"))?;
    if scene.material(material).is_none() {
        let names = scene.materials.iter().map(|(name, _)| name.clone());
        return Err(Flaw::unknown("material", "no such material in the scene", material, names));
    }
    if let Geometry::Mesh { mesh, .. } = form
        && mesh.texture.is_empty()
        && scene.material(material).is_some_and(|material| material.pattern().is_some())
    {
        let why =
            format!("`{material}` has a pattern, and no corner of the mesh a place on it; valid: texture coordinates");
        return Err(Flaw::of("material", why));
    }
    match emission {
        Some(Emission { radiance, two_sided: _ }) => RADIANCE.holds_all("emission", *radiance),
        None => Ok(()),
    }
}

fn geometry(geometry: &Geometry) -> Checked {
    match geometry {
        Geometry::Quad { vertices } => {
            (0..4).try_for_each(|at| COORDINATE.holds_all(at, vertices[at])).map_err(|flaw| flaw.within("vertices"))?;
            parallelogram(*vertices).map_err(|why| Flaw::of("vertices", why))
        }
        Geometry::Sphere { center, radius } => {
            COORDINATE.holds_all("center", *center)?;
            round(*center, *radius)
        }
        Geometry::Disc { center, normal, radius } => {
            COORDINATE.holds_all("center", *center)?;
            direction("normal", *normal)?;
            round(*center, *radius)
        }
        Geometry::Box { min, max } => {
            COORDINATE.holds_all("min", *min)?;
            COORDINATE.holds_all("max", *max)?;
            for axis in 0..3 {
                if max[axis] - min[axis] <= rounding(&[*min, *max]) {
                    let why = format!("{} is not above that of min, {}", Shown(max[axis]), Shown(min[axis]));
                    return Err(Flaw::of(axis, why).within("max"));
                }
            }
            Ok(())
        }
        Geometry::Mesh { file: _, normals, mesh: triangles } => {
            mesh(triangles, *normals).map_err(|flaw| flaw.within("mesh"))
        }
    }
}

/// By how much [m] a difference of coordinates may be off because they are rounded.
fn rounding(points: &[Triple]) -> f64 {
    ROUNDINGS * f64::EPSILON * points.iter().copied().map(largest).fold(0.0, f64::max)
}

/// Holds corners to the shape of a parallelogram with an area.
fn parallelogram(vertices: [Triple; 4]) -> Result<(), String> {
    let [a, b, c, d] = vertices;
    let (along, across) = (minus(b, a), minus(d, a));
    let longest = length(along).max(length(across));
    let rounding = rounding(&vertices);
    let gap = length(minus(plus(a, c), plus(b, d)));
    if gap > ASKEW * longest + rounding {
        let last = minus(plus(b, d), a).map(|x| Shown(x).to_string()).join(", ");
        return Err(format!("are no parallelogram; valid: [{last}] as the third"));
    }
    // The height over the longer side: what rounding leaves to chance turns the normal anywhere.
    let area = length(cross(along, across));
    let least = longest * (rounding + ROUNDINGS * f64::EPSILON * length(along).min(length(across)));
    match area > least {
        true => Ok(()),
        false => Err("have no area between them; valid: four corners of a parallelogram in order".into()),
    }
}

/// A radius is more than what the centre's rounding leaves to chance.
fn round(center: Triple, radius: f64) -> Checked {
    LENGTH.holds("radius", radius)?;
    let least = rounding(&[center]);
    match radius > least {
        true => Ok(()),
        false => {
            Err(Flaw::of("radius", format!("{} is lost so far out; valid: above {}", Shown(radius), Shown(least))))
        }
    }
}

fn mesh(mesh: &Mesh, normals: Normals) -> Checked {
    let Mesh { positions, normals: directions, texture, triangles } = mesh;
    every("positions", positions, |position| {
        (0..3).try_for_each(|axis| COORDINATE.holds(axis, f64::from(position[axis])))
    })?;
    if !directions.is_empty() && directions.len() != positions.len() {
        let why = format!("{} for {} corners; valid: one each, or none", directions.len(), positions.len());
        return Err(Flaw::of("normals", why));
    }
    if !texture.is_empty() && texture.len() != positions.len() {
        let why = format!("{} for {} corners; valid: one each, or none", texture.len(), positions.len());
        return Err(Flaw::of("texture", why));
    }
    every("texture", texture, |place| (0..2).try_for_each(|axis| PLACE.holds(axis, f64::from(place[axis]))))?;
    let is_smooth = normals == Normals::Smooth;
    if is_smooth && directions.is_empty() {
        return Err(Flaw::of("normals", "none, and yet smooth; valid: one a corner"));
    }
    every("triangles", triangles, |triangle| {
        let far = triangle.iter().find(|corner| **corner as usize >= positions.len());
        match far {
            None => Ok(()),
            Some(far) => Err(Flaw::of_all(format!("there is no corner {far}; there are {}", positions.len()))),
        }
    })?;
    if is_smooth {
        // What no triangle uses may be anything.
        for corner in triangles.iter().flatten().map(|corner| *corner as usize) {
            direction(corner, widened(directions[corner])).map_err(|flaw| flaw.within("normals"))?;
        }
    }
    match triangles.iter().any(|triangle| largest(mesh.area(*triangle)) > 0.0) {
        true => Ok(()),
        false => Err(Flaw::of("triangles", "none that has an area; valid: at least one")),
    }
}

fn transform(transform: &Transform, form: &Geometry) -> Checked {
    let Transform { scale, rotate_deg, translate } = transform;
    SCALE.holds_all("scale", *scale)?;
    if let Some(axis) = (0..3).find(|axis| scale[*axis].abs() < LEAST_SCALE) {
        let why = format!("{} leaves nothing; valid: at least {} in size", Shown(scale[axis]), Shown(LEAST_SCALE));
        return Err(Flaw::of(axis, why).within("scale"));
    }
    let [x, y, z] = scale.map(f64::abs);
    let round = match form {
        Geometry::Sphere { .. } => Some("a sphere would be an ellipsoid"),
        Geometry::Disc { .. } => Some("a disc would be an ellipse"),
        _ => None,
    };
    if let Some(why) = round.filter(|_| x != y || y != z) {
        return Err(Flaw::of("scale", format!("is not the same along all axes, and {why}; valid: one size for all")));
    }
    TURN.holds_all("rotate_deg", *rotate_deg)?;
    COORDINATE.holds_all("translate", *translate)?;
    if *transform == Transform::default() {
        return Ok(());
    }
    moved(transform, form)
}

/// What holds of a form holds where it is put.
fn moved(transform: &Transform, form: &Geometry) -> Checked {
    let map = transform.map();
    let place = |point: Triple| map.point(point);
    let within = |points: &[Triple], reach: f64| {
        let far = points.iter().map(|point| largest(*point) + reach).fold(0.0, f64::max);
        match far <= FAR {
            true => Ok(()),
            false => Err(format!("takes the shape to {} m; valid: up to {} m", Shown(far), Shown(FAR))),
        }
    };
    let lost = |size: f64, points: &[Triple]| match size > rounding(points) {
        true => Ok(()),
        false => Err(format!("leaves {} m of the shape, which are lost so far out", Shown(size))),
    };
    let checked = match form {
        Geometry::Quad { vertices } => {
            let vertices = vertices.map(place);
            within(&vertices, 0.0)
                .and_then(|()| parallelogram(vertices).map_err(|why| format!("takes it to corners that {why}")))
        }
        Geometry::Sphere { center, radius } | Geometry::Disc { center, normal: _, radius } => {
            let (center, radius) = (place(*center), map.length(*radius));
            within(&[center], radius).and_then(|()| lost(radius, &[center]))
        }
        Geometry::Box { min, max } => {
            let corners = [0, 1, 2, 3, 4, 5, 6, 7]
                .map(|corner| place([0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { min[axis] } else { max[axis] })));
            let edges = [0, 1, 2].map(|axis| (max[axis] - min[axis]) * transform.scale[axis].abs());
            within(&corners, 0.0).and_then(|()| lost(edges.into_iter().fold(FAR, f64::min), &corners))
        }
        Geometry::Mesh { mesh, .. } => {
            let far = mesh.positions.iter().map(|position| place(widened(*position)));
            let far = far.max_by(|a, b| largest(*a).total_cmp(&largest(*b)));
            far.map_or(Ok(()), |far| within(&[far], 0.0))
        }
    };
    checked.map_err(Flaw::of_all)
}

fn light(light: &Light) -> Checked {
    match light {
        Light::Point { position, intensity } => {
            COORDINATE.holds_all("position", *position)?;
            INTENSITY.holds_all("intensity", *intensity)
        }
        Light::Directional { direction: of, irradiance } => {
            direction("direction", *of)?;
            IRRADIANCE.holds_all("irradiance", *irradiance)
        }
    }
}
