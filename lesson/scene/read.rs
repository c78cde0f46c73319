//! From a tree to a scene: one reader for every format.

use super::fields::{Fields, Item};
use super::images::{Images, Use};
use super::keys::{
    CAMERA, CLEAR, COATED, COATING, ENERGY, ENVIRONMENT, FACETS, GLASS, GLASSES, IOR, Kind, MASKING as MASKED, METAL,
    PATTERN, PATTERNED, PATTERNS, REFLECTANCE, ROUGH_GLASSES, SCENE, SHAPE, TRANSFORM, TYPE, Type, may, must,
};
use super::meshes::Meshes;
use super::source::Snag;
use super::tree::Node;
use chapters::parameter::Fault;
use light::bsdf::microfacet::{Joint, Slopes};
use light::scene::flaw::domain;
use light::scene::{
    Camera, Coating, Emission, Energy, Environment, Facets, Filter, Flaw, Geometry, Glass, Light, Material, Metal,
    Normals, Pattern, Scene, Shape, Sky, Transform, Triple,
};
use std::path::PathBuf;

/// How slopes are distributed unless it is said.
pub const SLOPES: Slopes = Slopes::Ggx;
/// How masking goes together unless it is said.
pub const MASKING: Joint = Joint::Correlated;
/// The index outside unless it is said: empty space.
pub const OUTSIDE: f64 = 1.0;
/// How bright an image is unless it is said: as it says itself.
pub const SKY_SCALE: f64 = 1.0;

/// Reads a scene called `name` unless it says otherwise. It has no flaw.
pub fn scene(root: &Node, name: &str, meshes: &mut Meshes, images: &mut Images) -> Result<Scene, Snag> {
    let fields = Item::root(root).fields(&SCENE)?;
    let list = |key: &str| fields.get(key).map_or(Ok(Vec::new()), |item| item.list());
    let materials = fields.get("materials").map_or(Ok(Vec::new()), |item| self::materials(item, images))?;
    let scene = Scene {
        name: fields.may("name", Item::plain_text)?.unwrap_or(name).to_owned(),
        max_depth: fields.may("max_depth", Item::count)?,
        filter: fields
            .may("filter", |item| item.word("pixel filter", &words(Filter::ALL, Filter::name)))?
            .unwrap_or_default(),
        camera: camera(fields.must("camera")?)?,
        environment: fields
            .get("environment")
            .filter(|item| !item.is_null())
            .map(|item| environment(item, images))
            .transpose()?,
        shapes: list("shapes")?.into_iter().map(|item| shape(item, &materials, meshes)).collect::<Result<_, _>>()?,
        materials,
        lights: list("lights")?.into_iter().map(light).collect::<Result<_, _>>()?,
    };
    match scene.flaw() {
        None => Ok(scene),
        Some(flaw) => Err(flawed(root, flaw)),
    }
}

/// Where a flaw of the scene stands in its text.
fn flawed(root: &Node, flaw: Flaw) -> Snag {
    let (span, place) = (root.find(&flaw.place), flaw.place.to_string());
    let fault = match flaw.unknown {
        Some(unknown) => Fault::unknown(place, unknown.word, flaw.why, unknown.names),
        None => Fault::new(place, flaw.why),
    };
    Snag { span: (span != root.span).then_some(span), fault }
}

/// Each of `all` by its name.
fn words<T: Copy, const N: usize>(all: [T; N], name: fn(T) -> &'static str) -> [(&'static str, T); N] {
    all.map(|each| (name(each), each))
}

fn camera(item: Item) -> Result<Camera, Snag> {
    let fields = item.fields(&CAMERA)?;
    Ok(Camera {
        origin: fields.triple("origin")?,
        target: fields.triple("target")?,
        up: fields.may("up", Item::triple)?.unwrap_or(Camera::UP),
        fov_y_deg: fields.number("fov_y_deg")?,
        width: fields.must("width")?.count()?,
        height: fields.must("height")?.count()?,
        aperture: fields.may("aperture", Item::number)?.unwrap_or_default(),
        focus: fields.may("focus", Item::number)?,
        polariser_deg: fields.may("polariser_deg", Item::number)?,
    })
}

fn environment(item: Item, images: &mut Images) -> Result<Environment, Snag> {
    let fields = item.fields(&ENVIRONMENT)?;
    let scale = fields.may("scale", Item::number)?;
    let rotate_deg = fields.may("rotate_deg", Item::number)?;
    let Some(item) = fields.get("image") else {
        let radiance = fields.triple("radiance")?;
        ["scale", "rotate_deg"].iter().try_for_each(|key| fields.idle(key, "says nothing without image"))?;
        return Ok(Environment::Constant(radiance));
    };
    fields.idle("radiance", "given beside image, which has its own")?;
    let file = PathBuf::from(item.text()?);
    let image = images.read(&file, Use::Light).map_err(|why| item.wrong(why))?;
    Ok(Environment::Image(Sky {
        file: Some(file),
        image,
        scale: scale.unwrap_or(SKY_SCALE),
        rotate_deg: rotate_deg.unwrap_or_default(),
    }))
}

fn materials(item: Item, images: &mut Images) -> Result<Vec<(String, Material)>, Snag> {
    let table = item.table("the materials")?;
    table.items().map(|(name, item)| Ok((name.to_owned(), material(item, images)?))).collect()
}

/// Reads the fields of a kind of material or shape.
pub type Read<T> = fn(&Fields) -> Result<T, Snag>;

pub const MATERIALS: &[Type<Read<Material>>] = &[
    Type {
        name: "diffuse",
        keys: &[&[TYPE, PATTERNED]],
        later: &[],
        read: |fields| Ok(Material::Diffuse { reflectance: any_reflectance(fields)? }),
    },
    Type {
        name: "rough_diffuse",
        keys: &[&[TYPE, PATTERNED, must("roughness", Kind::Number(domain::SHARE), "0 is Lambert's")]],
        later: &[],
        read: |fields| {
            Ok(Material::RoughDiffuse { reflectance: any_reflectance(fields)?, roughness: fields.number("roughness")? })
        },
    },
    Type {
        name: "mirror",
        keys: &[&[TYPE, REFLECTANCE]],
        later: &[],
        read: |fields| Ok(Material::Mirror { reflectance: reflectance(fields)? }),
    },
    Type {
        name: "conductor",
        keys: &[&[TYPE], METAL, &[COATED]],
        later: &[],
        read: |fields| Ok(Material::Conductor { metal: metal(fields)?, coating: fields.may("coating", coating)? }),
    },
    Type {
        name: "rough_conductor",
        keys: &[&[TYPE], METAL, FACETS, &[MASKED, ENERGY, COATED]],
        later: &[],
        read: |fields| {
            let masking =
                fields.may("masking", |item| item.word("kind of masking", &words(Joint::ALL, Joint::name)))?;
            Ok(Material::RoughConductor {
                metal: metal(fields)?,
                facets: facets(fields)?,
                masking: masking.unwrap_or(MASKING),
                energy: energy(fields)?,
                coating: fields.may("coating", coating)?,
            })
        },
    },
    Type {
        name: "dielectric",
        keys: &[&[TYPE], GLASS, &[COATED]],
        later: &[],
        read: |fields| {
            if let Some(glass) = fields.may("glass", Item::text)? {
                fields.idle("ior", "given beside glass, which has its own")?;
                fields.idle("abbe", "given beside glass, which has its own")?;
                return dispersive(fields, Glass::Named(glass.to_owned()));
            }
            if let Some(abbe) = fields.may("abbe", Item::number)? {
                return dispersive(fields, Glass::Abbe { ior: fields.number("ior")?, abbe });
            }
            let (ior, outside, absorption) = clear(fields)?;
            Ok(Material::Dielectric { ior, outside, absorption, coating: fields.may("coating", coating)? })
        },
    },
    Type {
        name: "rough_dielectric",
        keys: &[&[TYPE], CLEAR, FACETS, &[ENERGY]],
        later: ROUGH_GLASSES,
        read: |fields| {
            let (ior, outside, absorption) = clear(fields)?;
            Ok(Material::RoughDielectric { ior, outside, absorption, facets: facets(fields)?, energy: energy(fields)? })
        },
    },
    Type {
        name: "plastic",
        keys: &[&[
            TYPE,
            IOR,
            PATTERNED,
            may("alpha", Kind::Number(domain::ALPHA), "polished", "roughness of the coat"),
        ]],
        later: GLASSES,
        read: |fields| {
            Ok(Material::Plastic {
                ior: fields.number("ior")?,
                reflectance: any_reflectance(fields)?,
                alpha: fields.may("alpha", Item::number)?,
            })
        },
    },
];

fn material(item: Item, images: &mut Images) -> Result<Material, Snag> {
    let (fields, read) = item.of_type("a material", MATERIALS)?;
    let made = read(&fields)?;
    // Not every type has that key.
    let reflectance = fields.items().find(|(key, _)| *key == "reflectance").map(|(_, item)| item);
    match reflectance.filter(Item::is_table) {
        // What has no pattern has been refused by who read it.
        Some(item) => Ok(made.clone().patterned(pattern(item, images)?).unwrap_or(made)),
        None => Ok(made),
    }
}

/// The reflectance of what has the same all over.
fn reflectance(fields: &Fields) -> Result<Triple, Snag> {
    let item = fields.must("reflectance")?;
    match item.under(PATTERNS) {
        Some(later) => Err(later),
        None => item.triple(),
    }
}

/// The reflectance of what may have a pattern, which is read besides.
fn any_reflectance(fields: &Fields) -> Result<Triple, Snag> {
    let item = fields.must("reflectance")?;
    if item.is_table() { Ok([0.0; 3]) } else { item.triple() }
}

/// How many squares a checkerboard has along a side unless it is said.
pub const SQUARES: f64 = 8.0;

fn pattern(item: Item, images: &mut Images) -> Result<Pattern, Snag> {
    let fields = item.fields(&PATTERN)?;
    let scale = fields.may("scale", Item::number)?;
    let Some(item) = fields.get("image") else {
        let item = fields.must("checker")?;
        let colours = item.list()?.iter().map(Item::triple).collect::<Result<Vec<_>, _>>()?;
        let two = <[Triple; 2]>::try_from(colours);
        let colours = two.map_err(|found| item.wrong(format!("must be two colours, found {}", found.len())))?;
        return Ok(Pattern::Checker { colours, scale: scale.unwrap_or(SQUARES) });
    };
    fields.idle("checker", "given beside image, which is another pattern")?;
    fields.idle("scale", "says nothing without checker")?;
    let file = PathBuf::from(item.text()?);
    let image = images.read(&file, Use::Colour).map_err(|why| item.wrong(why))?;
    Ok(Pattern::Image { file: Some(file), image })
}

fn metal(fields: &Fields) -> Result<Metal, Snag> {
    match fields.may("metal", Item::text)? {
        Some(name) => {
            ["eta", "k"].iter().try_for_each(|key| fields.idle(key, "given beside metal, which has its own"))?;
            Ok(Metal::Named(name.to_owned()))
        }
        None if fields.get("eta").is_none() && fields.get("k").is_none() => Err(fields.missing("metal")),
        None => Ok(Metal::Indices { eta: fields.triple("eta")?, k: fields.triple("k")? }),
    }
}

fn facets(fields: &Fields) -> Result<Facets, Snag> {
    let alpha = match fields.may("alpha", Item::number)? {
        Some(alpha) => {
            ["alpha_x", "alpha_y"].iter().try_for_each(|key| fields.idle(key, "given beside alpha, which is both"))?;
            [alpha; 2]
        }
        None if fields.get("alpha_x").is_some() || fields.get("alpha_y").is_some() => {
            [fields.number("alpha_x")?, fields.number("alpha_y")?]
        }
        None => [fields.number("alpha")?; 2],
    };
    let slopes = fields.may("distribution", |item| item.word("distribution", &words(Slopes::ALL, Slopes::name)))?;
    Ok(Facets { alpha, slopes: slopes.unwrap_or(SLOPES) })
}

fn energy(fields: &Fields) -> Result<Energy, Snag> {
    let energy = fields.may("energy", |item| item.word("way to treat energy", &words(Energy::ALL, Energy::name)))?;
    Ok(energy.unwrap_or_default())
}

/// Index, index outside, and absorption.
fn clear(fields: &Fields) -> Result<(f64, f64, Triple), Snag> {
    let (outside, absorption) = surrounded(fields)?;
    Ok((fields.number("ior")?, outside, absorption))
}

/// Index outside, and absorption.
fn dispersive(fields: &Fields, glass: Glass) -> Result<Material, Snag> {
    fields.idle("coating", "a film on glass that disperses cannot be used so far; valid: on glass of one ior")?;
    let (outside, absorption) = surrounded(fields)?;
    Ok(Material::Dispersive { glass, outside, absorption })
}

fn surrounded(fields: &Fields) -> Result<(f64, Triple), Snag> {
    let outside = fields.may("outside", Item::number)?.unwrap_or(OUTSIDE);
    Ok((outside, fields.may("absorption", Item::triple)?.unwrap_or_default()))
}

fn coating(item: &Item) -> Result<Coating, Snag> {
    let fields = item.clone().fields(&COATING)?;
    Ok(Coating { medium: fields.must("medium")?.text()?.to_owned(), thickness_nm: fields.number("thickness_nm")? })
}

/// Reads the fields of a kind of shape, which may need places on an image.
pub type ReadShape = fn(&Fields, &mut Meshes, bool) -> Result<Geometry, Snag>;

pub const SHAPES: &[Type<ReadShape>] = &[
    Type {
        name: "quad",
        keys: &[
            &[
                TYPE,
                must(
                    "vertices",
                    Kind::Corners(domain::COORDINATE),
                    "corners of a parallelogram in order; its normal is (v1 − v0) × (v3 − v0)",
                ),
            ],
            SHAPE,
        ],
        later: &[],
        read: |fields, _, _| {
            let item = fields.must("vertices")?;
            let vertices = item.list()?.iter().map(Item::triple).collect::<Result<Vec<_>, _>>()?;
            let four = <[Triple; 4]>::try_from(vertices);
            let vertices = four.map_err(|found| item.wrong(format!("must be four corners, found {}", found.len())))?;
            Ok(Geometry::Quad { vertices })
        },
    },
    Type {
        name: "sphere",
        keys: &[
            &[
                TYPE,
                must("center", Kind::Three(domain::COORDINATE), "its middle"),
                must("radius", Kind::Number(domain::LENGTH), "its radius"),
            ],
            SHAPE,
        ],
        later: &[],
        read: |fields, _, _| {
            Ok(Geometry::Sphere { center: fields.triple("center")?, radius: fields.number("radius")? })
        },
    },
    Type {
        name: "disc",
        keys: &[
            &[
                TYPE,
                must("center", Kind::Three(domain::COORDINATE), "its middle"),
                must("normal", Kind::Three(domain::DIRECTION), "whither it faces"),
                must("radius", Kind::Number(domain::LENGTH), "its radius"),
            ],
            SHAPE,
        ],
        later: &[],
        read: |fields, _, _| {
            let (center, normal) = (fields.triple("center")?, fields.triple("normal")?);
            Ok(Geometry::Disc { center, normal, radius: fields.number("radius")? })
        },
    },
    Type {
        name: "box",
        keys: &[
            &[
                TYPE,
                must("min", Kind::Three(domain::COORDINATE), "the corner of the least coordinates"),
                must("max", Kind::Three(domain::COORDINATE), "the corner of the largest"),
            ],
            SHAPE,
        ],
        later: &[],
        read: |fields, _, _| Ok(Geometry::Box { min: fields.triple("min")?, max: fields.triple("max")? }),
    },
    Type {
        name: "mesh",
        keys: &[
            &[
                TYPE,
                must("file", Kind::Text, "a .ply, .obj, .gltf or .glb, from the scene's folder"),
                may(
                    "normals",
                    Kind::Word(|| Normals::ALL.map(Normals::name).into()),
                    "\"flat\"",
                    "whether triangles are flat or look smooth",
                ),
            ],
            SHAPE,
        ],
        later: &[],
        read: |fields, meshes, is_patterned| {
            let item = fields.must("file")?;
            let file = PathBuf::from(item.text()?);
            let normals =
                fields.may("normals", |item| item.word("kind of normals", &words(Normals::ALL, Normals::name)))?;
            let normals = normals.unwrap_or_default();
            let mesh = meshes.read(&file, normals, is_patterned).map_err(|why| item.wrong(why))?;
            Ok(Geometry::Mesh { file: Some(file), normals, mesh })
        },
    },
];

fn shape(item: Item, materials: &[(String, Material)], meshes: &mut Meshes) -> Result<Shape, Snag> {
    let (fields, read) = item.of_type("a shape", SHAPES)?;
    let name = fields.must("material")?.text()?;
    let is_patterned = materials.iter().any(|(known, material)| known == name && material.pattern().is_some());
    let geometry = read(&fields, meshes, is_patterned)?;
    let two_sided = fields.may("two_sided", Item::flag)?;
    let emission = fields.may("emission", Item::triple)?;
    if emission.is_none() {
        fields.idle("two_sided", "says nothing without emission")?;
    }
    Ok(Shape {
        geometry,
        material: name.to_owned(),
        emission: emission.map(|radiance| Emission { radiance, two_sided: two_sided.unwrap_or_default() }),
        transform: fields.may("transform", transform)?.unwrap_or_default(),
    })
}

fn transform(item: &Item) -> Result<Transform, Snag> {
    let fields = item.clone().fields(&TRANSFORM)?;
    let own = Transform::default();
    let scale = |item: &Item| match (item.number(), item.list()) {
        (Ok(scale), _) => Ok([scale; 3]),
        (_, Ok(_)) => item.triple(),
        _ => Err(item.must_be("a number or a list of three")),
    };
    Ok(Transform {
        scale: fields.may("scale", scale)?.unwrap_or(own.scale),
        rotate_deg: fields.may("rotate_deg", Item::triple)?.unwrap_or(own.rotate_deg),
        translate: fields.may("translate", Item::triple)?.unwrap_or(own.translate),
    })
}

pub const LIGHTS: &[Type<Read<Light>>] = &[
    Type {
        name: "point",
        keys: &[&[
            TYPE,
            must("position", Kind::Three(domain::COORDINATE), "where it is"),
            must("intensity", Kind::Three(domain::INTENSITY), "alike in all directions"),
        ]],
        later: &[],
        read: |fields| {
            Ok(Light::Point { position: fields.triple("position")?, intensity: fields.triple("intensity")? })
        },
    },
    Type {
        name: "directional",
        keys: &[&[
            TYPE,
            must("direction", Kind::Three(domain::DIRECTION), "whither its light travels"),
            must("irradiance", Kind::Three(domain::IRRADIANCE), "on a plane square to it"),
        ]],
        later: &[],
        read: |fields| {
            Ok(Light::Directional { direction: fields.triple("direction")?, irradiance: fields.triple("irradiance")? })
        },
    },
];

fn light(item: Item) -> Result<Light, Snag> {
    let (fields, read) = item.of_type("a light", LIGHTS)?;
    read(&fields)
}
