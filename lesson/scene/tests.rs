//! What is written is read, whichever way.

use super::*;
use light::bsdf::microfacet::{Joint, Slopes};
use light::scene::*;
use proptest::prelude::*;
use std::cell::Cell;
use std::path::PathBuf;
use std::sync::Arc;

/// No files at all.
fn none(file: &Path) -> Result<Vec<u8>, String> {
    Err(format!("is not there: {}", file.display()))
}

pub(super) fn from_toml(text: &str, files: Files) -> Result<Scene, Stop> {
    read(&Source::new(Path::new("test.toml"), text.into())?, toml::parse, files).map(|(scene, _)| scene)
}

fn from_json(text: &str) -> Result<Scene, Stop> {
    read(&Source::new(Path::new("test.json"), text.into())?, json::parse, &none).map(|(scene, _)| scene)
}

/// A scene printed, with all its meshes, and read again.
fn again(scene: &Scene) -> Scene {
    let printed = print::print(scene, true);
    let files = |file: &Path| match printed.files.iter().find(|(name, _)| Path::new(name) == file) {
        Some((_, part)) => Ok(part.bytes()),
        None => none(file),
    };
    from_toml(&printed.text, &files).unwrap_or_else(|stop| panic!("{stop}\n{}", printed.text))
}

/// The same scene, its meshes and its sky from the files that they are printed to.
fn filed(mut scene: Scene) -> Scene {
    if let Some(Environment::Image(sky)) = &mut scene.environment {
        sky.file = Some(PathBuf::from(format!("{}.exr", print::stem(&scene.name))));
    }
    let mut known: Vec<Arc<Mesh>> = Vec::new();
    for shape in &mut scene.shapes {
        if let Geometry::Mesh { file, mesh, .. } = &mut shape.geometry {
            let at = known.iter().position(|known| Arc::ptr_eq(known, mesh)).unwrap_or(known.len());
            if at == known.len() {
                known.push(Arc::clone(mesh));
            }
            let number = if at == 0 { String::new() } else { format!("-{}", at + 1) };
            *file = Some(PathBuf::from(format!("{}{number}.ply", print::stem(&scene.name))));
        }
    }
    scene
}

#[test]
fn every_scene_of_the_lecture_survives_print_and_read() {
    for builtin in BUILTIN {
        let scene = filed((builtin.make)());
        assert!(again(&scene) == scene, "{}:\n{}", builtin.name, print::print(&scene, true).text);
    }
}

#[test]
fn patterns_survive_print_and_read() {
    let text = |reflectance: &str| {
        format!(
            "{CAMERA}[materials.p]\ntype = \"plastic\"\nior = 1.5\nreflectance = {reflectance}\n[[shapes]]\ntype = \"mesh\"\nfile = \"a.obj\"\nmaterial = \"p\"\n"
        )
    };
    let image = Image::new([2, 1], vec![[0.25, 0.5, 1.0], [0.0; 3]]).unwrap();
    let files = |file: &Path| match file.extension() {
        Some(extension) if extension == "exr" => Ok(images::write_exr(&image)),
        _ => Ok(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n".to_vec()),
    };
    for reflectance in ["{ checker = [[1, 0, 0.5], [0.25, 0.25, 0.25]], scale = 3 }", "{ image = \"wood.exr\" }"] {
        let scene = from_toml(&text(reflectance), &files).unwrap();
        let Geometry::Mesh { mesh, .. } = &scene.shapes[0].geometry else { panic!("no mesh") };
        assert_eq!(mesh.texture, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        assert!(print::print(&scene, false).text.contains(reflectance), "{}", print::print(&scene, false).text);
        // Written anew, with files of its own: the same but for their names.
        let mut written = again(&scene);
        let Geometry::Mesh { file, .. } = &mut written.shapes[0].geometry else { panic!("no mesh") };
        *file = Some("a.obj".into());
        if let Material::Patterned { pattern: Pattern::Image { file, .. }, .. } =
            &mut written.materials.last_mut().unwrap().1
        {
            *file = Some("wood.exr".into());
        }
        assert!(written == scene, "{reflectance}");
    }
    // A mesh without places on an image is refused by name.
    let plain = |_: &Path| Ok(TRIANGLE.as_bytes().to_vec());
    let refused = from_toml(&text("{ checker = [[1, 1, 1], [0, 0, 0]] }"), &plain).unwrap_err().to_string();
    assert!(refused.contains("shapes[0].material: `p` has a pattern, and no corner of the mesh"), "{refused}");
    // A colour is no more than all.
    let bright = Image::new([1, 1], vec![[1.5; 3]]).unwrap();
    let refused = from_toml(&text("{ image = \"b.exr\" }"), &|file| match file.extension() {
        Some(extension) if extension == "exr" => Ok(images::write_exr(&bright)),
        _ => files(file),
    });
    let refused = refused.unwrap_err().to_string();
    assert!(refused.contains("materials.p.reflectance.image: its texel in column 0 of row 0"), "{refused}");
}

/// The example of the contract, and a bit of everything else.
pub(super) const WHOLE: &str = r#"
name = "cornell"
max_depth = 16
filter = "tent"

[camera]
origin = [2.78, 2.73, -8.0]
target = [2.78, 2.73, 0.0]
up = [0, 1, 0]
fov_y_deg = 39.3
width = 256
height = 128
aperture = 0.1
focus = 7
polariser_deg = 90

[environment]
radiance = [0.4, 0.5, 0.6]

[materials.white]
type = "diffuse"
reflectance = [0.73, 0.73, 0.73]

[materials.clay]
type = "rough_diffuse"
reflectance = [0.5, 0.4, 0.3]
roughness = 0.8

[materials."a mirror"]
type = "mirror"
reflectance = [1, 1, 1]

[materials.gold]
type = "conductor"
metal = "gold"
coating = { medium = "mgf2", thickness_nm = 100 }

[materials.brushed]
type = "rough_conductor"
eta = [0.2, 0.4, 1.3]
k = [3, 2.5, 1.9]
alpha_x = 0.1
alpha_y = 0.3
distribution = "beckmann"
masking = "separable"
energy = "single"
coating = { medium = "tio2", thickness_nm = 60 }

[materials.glass]
type = "dielectric"
ior = 1.5
outside = 1.33
absorption = [0, 1, 2]

[materials.frosted]
type = "rough_dielectric"
ior = 1.5
alpha = 0.2
energy = "walk"

[materials.plastic]
type = "plastic"
ior = 1.5
reflectance = [0.1, 0.2, 0.3]
alpha = 0.1

[[shapes]]
type = "quad"
vertices = [[5.56, 0, 0], [0, 0, 0], [0, 0, 5.592], [5.56, 0, 5.592]]
material = "white"

[[shapes]]
type = "sphere"
center = [1, 1, 1]
radius = 1
material = "glass"
transform = { scale = 2.0, rotate_deg = [0, 90, 0], translate = [0, 0, 1] }

[[shapes]]
type = "disc"
center = [1, 5, 1]
normal = [0, -1, 0]
radius = 0.5
material = "a mirror"
emission = [17, 12, 4]
two_sided = true

[[shapes]]
type = "box"
min = [0, 0, 0]
max = [1, 2, 3]
material = "gold"
emission = [1, 0, 0]
transform = { scale = [1, 2, -3] }

[[lights]]
type = "point"
position = [0, 3, 0]
intensity = [1, 2, 3]

[[lights]]
type = "directional"
direction = [0, -2, 0]
irradiance = [0, 0, 1]
"#;

/// The same by hand.
fn whole() -> Scene {
    let of = |geometry, material: &str| Shape {
        geometry,
        material: material.into(),
        emission: None,
        transform: Transform::default(),
    };
    let named = |name: &str, material| (name.to_owned(), material);
    let emission = |radiance, two_sided| Some(Emission { radiance, two_sided });
    Scene {
        name: "cornell".into(),
        max_depth: Some(16),
        filter: Filter::Tent,
        camera: Camera {
            origin: [2.78, 2.73, -8.0],
            target: [2.78, 2.73, 0.0],
            up: [0.0, 1.0, 0.0],
            fov_y_deg: 39.3,
            width: 256,
            height: 128,
            aperture: 0.1,
            focus: Some(7.0),
            polariser_deg: Some(90.0),
        },
        environment: Some(Environment::Constant([0.4, 0.5, 0.6])),
        materials: vec![
            named("white", Material::Diffuse { reflectance: [0.73; 3] }),
            named("clay", Material::RoughDiffuse { reflectance: [0.5, 0.4, 0.3], roughness: 0.8 }),
            named("a mirror", Material::Mirror { reflectance: [1.0; 3] }),
            named(
                "gold",
                Material::Conductor {
                    metal: Metal::Named("gold".into()),
                    coating: Some(Coating { medium: "mgf2".into(), thickness_nm: 100.0 }),
                },
            ),
            named(
                "brushed",
                Material::RoughConductor {
                    metal: Metal::Indices { eta: [0.2, 0.4, 1.3], k: [3.0, 2.5, 1.9] },
                    facets: Facets { alpha: [0.1, 0.3], slopes: Slopes::Beckmann },
                    masking: Joint::Separable,
                    energy: Energy::Single,
                    coating: Some(Coating { medium: "tio2".into(), thickness_nm: 60.0 }),
                },
            ),
            named(
                "glass",
                Material::Dielectric { ior: 1.5, outside: 1.33, absorption: [0.0, 1.0, 2.0], coating: None },
            ),
            named(
                "frosted",
                Material::RoughDielectric {
                    ior: 1.5,
                    outside: 1.0,
                    absorption: [0.0; 3],
                    facets: Facets { alpha: [0.2; 2], slopes: Slopes::Ggx },
                    energy: Energy::Walk,
                },
            ),
            named("plastic", Material::Plastic { ior: 1.5, reflectance: [0.1, 0.2, 0.3], alpha: Some(0.1) }),
        ],
        shapes: vec![
            of(
                Geometry::Quad { vertices: [[5.56, 0.0, 0.0], [0.0; 3], [0.0, 0.0, 5.592], [5.56, 0.0, 5.592]] },
                "white",
            ),
            Shape {
                transform: Transform { scale: [2.0; 3], rotate_deg: [0.0, 90.0, 0.0], translate: [0.0, 0.0, 1.0] },
                ..of(Geometry::Sphere { center: [1.0; 3], radius: 1.0 }, "glass")
            },
            Shape {
                emission: emission([17.0, 12.0, 4.0], true),
                ..of(Geometry::Disc { center: [1.0, 5.0, 1.0], normal: [0.0, -1.0, 0.0], radius: 0.5 }, "a mirror")
            },
            Shape {
                emission: emission([1.0, 0.0, 0.0], false),
                transform: Transform { scale: [1.0, 2.0, -3.0], ..Transform::default() },
                ..of(Geometry::Box { min: [0.0; 3], max: [1.0, 2.0, 3.0] }, "gold")
            },
        ],
        lights: vec![
            Light::Point { position: [0.0, 3.0, 0.0], intensity: [1.0, 2.0, 3.0] },
            Light::Directional { direction: [0.0, -2.0, 0.0], irradiance: [0.0, 0.0, 1.0] },
        ],
    }
}

/// A tree as JSON, which no code of ours writes otherwise.
pub(super) fn as_json(node: &Node) -> String {
    use tree::Value;
    match &node.value {
        Value::Null | Value::Date => "null".into(),
        Value::Flag(flag) => flag.to_string(),
        Value::Number(number) => format!("{number:?}"),
        Value::Text(text) => serde_json::to_string(text).unwrap(),
        Value::List(list) => format!("[{}]", list.iter().map(as_json).collect::<Vec<_>>().join(",\n ")),
        Value::Table(entries) => {
            let entry = |entry: &tree::Entry| {
                format!("{}: {}", serde_json::to_string(&entry.key).unwrap(), as_json(&entry.node))
            };
            format!("{{{}}}", entries.iter().map(entry).collect::<Vec<_>>().join(",\n"))
        }
    }
}

#[test]
fn every_key_of_the_contract_is_read_from_either_format() {
    assert_eq!(from_toml(WHOLE, &none).unwrap(), whole());
    let json = as_json(&toml::parse(WHOLE).unwrap());
    assert_eq!(from_json(&json).unwrap(), whole());
    // Other ends of lines, and what some editors put before a text.
    assert_eq!(from_toml(&format!("\u{feff}{}", WHOLE.replace('\n', "\r\n")), &none).unwrap(), whole());
    assert_eq!(again(&whole()), whole());
}

#[test]
fn what_may_be_left_out_has_the_value_that_the_contract_says() {
    let least = "[camera]\norigin = [0, 0, -1]\ntarget = [0, 0, 0]\nfov_y_deg = 40\nwidth = 1\nheight = 2\n";
    let read = from_toml(least, &none).unwrap();
    let camera = Camera {
        origin: [0.0, 0.0, -1.0],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        fov_y_deg: 40.0,
        width: 1,
        height: 2,
        aperture: 0.0,
        focus: None,
        polariser_deg: None,
    };
    let expected = Scene {
        name: "test".into(),
        max_depth: None,
        filter: Filter::Box,
        camera,
        environment: None,
        materials: vec![],
        shapes: vec![],
        lights: vec![],
    };
    assert_eq!(read, expected);
    let json = r#"{"camera": {"origin": [0, 0, -1], "target": [0, 0, 0], "fov_y_deg": 40.0, "width": 1.0, "height": 2e0},
        "environment": null}"#;
    assert_eq!(from_json(json).unwrap(), expected);
    assert_eq!(again(&expected), expected);
}

const CAMERA: &str = "[camera]\norigin = [0, 0, -1]\ntarget = [0, 0, 0]\nfov_y_deg = 40\nwidth = 1\nheight = 2\n[materials.m]\ntype = \"diffuse\"\nreflectance = [0, 0, 0]\n";

fn ball(file: &str, normals: &str) -> String {
    format!("[[shapes]]\ntype = \"mesh\"\nfile = \"{file}\"\n{normals}material = \"m\"\n")
}

const SMOOTH: &str = "normals = \"smooth\"\n";
const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n";

#[test]
fn a_mesh_that_is_named_twice_is_read_once() {
    let count = Cell::new(0);
    let files = |file: &Path| {
        count.set(count.get() + 1);
        match file.file_name().and_then(|name| name.to_str()) {
            Some("a.obj") => Ok(TRIANGLE.as_bytes().to_vec()),
            _ => none(file),
        }
    };
    let text =
        [CAMERA, &ball("a.obj", ""), &ball("./a.obj", SMOOTH), &ball("a.obj", SMOOTH), &ball("a.obj", "")].concat();
    let source = Source::new(Path::new("test.toml"), text.into()).unwrap();
    let (scene, notes) = read(&source, toml::parse, &files).unwrap();
    assert_eq!(count.get(), 1);
    let meshes = scene.shapes.iter().map(|shape| match &shape.geometry {
        Geometry::Mesh { mesh, .. } => mesh,
        other => panic!("{other:?}"),
    });
    let meshes: Vec<_> = meshes.collect();
    assert!(Arc::ptr_eq(meshes[0], meshes[3]) && Arc::ptr_eq(meshes[1], meshes[2]));
    assert_eq!((meshes[0].normals.len(), &meshes[1].normals), (0, &vec![[0.0, 0.0, 1.0]; 3]));
    // What nothing can hit is left out, and that is said once.
    assert_eq!(meshes[0].triangles, [[0, 1, 2]]);
    assert_eq!(notes, ["a.obj: 1 of 2 triangles have no area and are left out"]);
}

#[test]
fn what_is_wrong_with_a_mesh_is_told_where_it_is_named() {
    let refused = |text: &str, file: &str| {
        let files = |_: &Path| Ok(text.as_bytes().to_vec());
        from_toml(&format!("{CAMERA}{}", ball(file, "")), &files).unwrap_err().to_string()
    };
    let place = "test.toml:12:8: shapes[0].file: ";
    assert!(refused("v 1 2", "x.obj").starts_with(&format!("{place}x.obj: line 1: needs three numbers")));
    assert!(refused("ply\n", "x.ply").starts_with(&format!("{place}x.ply: line 2: ")));
    assert!(refused("v 0 0 0\nf 1 1 1", "x.obj").contains("none of its 1 triangles has an area"));
    assert!(
        refused("v 0 0 0\nv 2e12 0 0\nv 0 1 0\nf 1 2 3", "x.obj")
            .starts_with("test.toml:12:8: shapes[0].mesh.positions[1][0]: ")
    );
    assert!(refused("", "x.glb").starts_with(&format!("{place}x.glb: cannot be read")));
    assert!(refused("", "x.stl").contains("valid: .ply, .obj, .gltf, .glb"));
    assert!(refused("", "x").contains("valid: .ply, .obj"));
    let missing = from_toml(&format!("{CAMERA}{}", ball("there.ply", "")), &none).unwrap_err().to_string();
    assert!(missing.starts_with(&format!("{place}there.ply is not there")));
}

#[test]
fn a_scene_keeps_the_files_that_it_names() {
    let files = |_: &Path| Ok(TRIANGLE.as_bytes().to_vec());
    let scene = from_toml(&format!("{CAMERA}{}", ball("sub/a.obj", "")), &files).unwrap();
    let kept = print::print(&scene, false);
    assert!(kept.files.is_empty() && kept.text.contains("file = \"sub/a.obj\""), "{}", kept.text);
    assert_eq!(from_toml(&kept.text, &files).unwrap(), scene);
    let written = print::print(&scene, true);
    assert!(written.text.contains("file = \"test.ply\""), "{}", written.text);
    assert_eq!(written.files.len(), 1);
}

#[test]
fn names_of_files_are_names_everywhere() {
    for (name, stem) in [("a b/../c", "a-b----c"), ("", "scene"), ("größe_1", "gr--e_1"), ("..", "--")] {
        assert_eq!(print::stem(name), stem);
    }
    assert_eq!(print::stem(&"x".repeat(1000)).len(), 64);
}

/// Numbers of any size up to `most`, whole ones among them.
fn size(most: f64) -> BoxedStrategy<f64> {
    prop_oneof![
        (0.0..1.0).prop_map(move |share: f64| most * share.powi(9)),
        (0..=10u8).prop_map(|whole| f64::from(whole) / 10.0 * 10.0).prop_map(move |whole| whole.min(most))
    ]
    .boxed()
}

fn triple_of(each: impl Strategy<Value = f64> + 'static) -> BoxedStrategy<[f64; 3]> {
    prop::array::uniform3(each).boxed()
}

fn signed(most: f64) -> BoxedStrategy<f64> {
    (size(most), any::<bool>()).prop_map(|(size, is_below)| if is_below { -size } else { size }).boxed()
}

fn material() -> BoxedStrategy<Material> {
    let share = || triple_of(size(1.0));
    let alpha = || 1e-4..=1.0;
    let index = || 0.5..4.0;
    let metal = || {
        let named = prop::sample::select(vec!["gold", "Ag", "COPPER"]).prop_map(|name| Metal::Named(name.into()));
        prop_oneof![named, (triple_of(size(5.0)), triple_of(size(5.0))).prop_map(|(eta, k)| Metal::Indices { eta, k })]
    };
    let coating = || {
        let film = (prop::sample::select(vec!["mgf2", "tio2"]), 1e-3..1e6);
        prop::option::of(film.prop_map(|(medium, thickness_nm)| Coating { medium: medium.into(), thickness_nm }))
    };
    let facets = || {
        let alpha = prop_oneof![alpha().prop_map(|both| [both; 2]), [alpha(), alpha()]];
        (alpha, prop::sample::select(&Slopes::ALL[..])).prop_map(|(alpha, slopes)| Facets { alpha, slopes })
    };
    let energy = || prop::sample::select(&Energy::ALL[..]);
    let masking = prop::sample::select(&Joint::ALL[..]);
    let outside = || prop_oneof![Just(1.0), index()];
    let absorption = || prop_oneof![Just([0.0; 3]), triple_of(size(1e6))];
    prop_oneof![
        share().prop_map(|reflectance| Material::Diffuse { reflectance }),
        (share(), size(1.0)).prop_map(|(reflectance, roughness)| Material::RoughDiffuse { reflectance, roughness }),
        share().prop_map(|reflectance| Material::Mirror { reflectance }),
        (metal(), coating()).prop_map(|(metal, coating)| Material::Conductor { metal, coating }),
        (metal(), facets(), masking, energy(), coating()).prop_map(|(metal, facets, masking, energy, coating)| {
            Material::RoughConductor { metal, facets, masking, energy, coating }
        }),
        (index(), outside(), absorption(), coating()).prop_map(|(ior, outside, absorption, coating)| {
            Material::Dielectric { ior, outside, absorption, coating }
        }),
        (prop::sample::select(vec!["bk7", "N-SF11", "water"]), outside(), absorption()).prop_map(
            |(glass, outside, absorption)| Material::Dispersive {
                glass: Glass::Named(glass.into()),
                outside,
                absorption
            }
        ),
        // Of any that its domain admits and whose index stays within the one of indices.
        (1.05..2.5, 3.0..1e6, absorption()).prop_map(|(ior, abbe, absorption)| Material::Dispersive {
            glass: Glass::Abbe { ior, abbe },
            outside: 1.0,
            absorption
        }),
        (index(), outside(), absorption(), facets(), energy()).prop_map(
            |(ior, outside, absorption, facets, energy)| {
                Material::RoughDielectric { ior, outside, absorption, facets, energy }
            }
        ),
        (index(), share(), prop::option::of(alpha())).prop_map(|(ior, reflectance, alpha)| Material::Plastic {
            ior,
            reflectance,
            alpha
        }),
    ]
    .boxed()
}

fn mesh() -> BoxedStrategy<Arc<Mesh>> {
    let corners = prop::collection::vec(prop::array::uniform3(-1e3f32..1e3), 4..12);
    (corners, any::<bool>())
        .prop_map(|(positions, is_smooth)| {
            let count = positions.len() as u32;
            let triangles = (2..count).map(|at| [0, at - 1, at]).collect();
            let mut mesh = Mesh { positions, triangles, ..Mesh::default() };
            mesh.drop_flat();
            Arc::new(if is_smooth { mesh.smoothed() } else { mesh })
        })
        .boxed()
}

fn geometry() -> BoxedStrategy<Geometry> {
    let point = || triple_of(signed(1e3));
    let length = || 1e-3..1e3;
    let quad = (point(), length(), length()).prop_map(|([x, y, z], a, b)| Geometry::Quad {
        vertices: [[x, y, z], [x + a, y, z], [x + a, y + b, z], [x, y + b, z]],
    });
    let cuboid = (point(), prop::array::uniform3(length()))
        .prop_map(|(min, edges)| Geometry::Box { min, max: [0, 1, 2].map(|axis| min[axis] + edges[axis]) });
    let mesh = mesh().prop_map(|mesh| Geometry::Mesh {
        file: None,
        normals: if mesh.normals.is_empty() { Normals::Flat } else { Normals::Smooth },
        mesh,
    });
    prop_oneof![
        quad,
        (point(), length()).prop_map(|(center, radius)| Geometry::Sphere { center, radius }),
        (point(), point(), length()).prop_map(|(center, normal, radius)| Geometry::Disc { center, normal, radius }),
        cuboid,
        mesh,
    ]
    .boxed()
}

fn transform() -> BoxedStrategy<Transform> {
    let scale = prop_oneof![Just([1.0; 3]), (0.1..10.0).prop_map(|all: f64| [all, all, -all])];
    let turn = prop_oneof![Just([0.0; 3]), triple_of(signed(360.0))];
    let moved = prop_oneof![Just([0.0; 3]), triple_of(signed(1e3))];
    (scale, turn, moved).prop_map(|(scale, rotate_deg, translate)| Transform { scale, rotate_deg, translate }).boxed()
}

fn light() -> BoxedStrategy<Light> {
    let point = || triple_of(signed(1e3));
    prop_oneof![
        (point(), triple_of(size(1e12))).prop_map(|(position, intensity)| Light::Point { position, intensity }),
        (point(), triple_of(size(1e12)))
            .prop_map(|(direction, irradiance)| Light::Directional { direction, irradiance }),
    ]
    .boxed()
}

fn environment() -> BoxedStrategy<Environment> {
    let image = (1..5u32, 1..5u32).prop_flat_map(|(width, height)| {
        let texels = prop::collection::vec(prop::array::uniform3(0f32..1e12), (width * height) as usize);
        texels.prop_map(move |texels| Arc::new(Image::new([width, height], texels).expect("as many")))
    });
    let scale = prop_oneof![Just(1.0), 0.0..1e3];
    let rotate_deg = prop_oneof![Just(0.0), signed(360.0)];
    let sky =
        (image, scale, rotate_deg).prop_map(|(image, scale, rotate_deg)| Sky { file: None, image, scale, rotate_deg });
    prop_oneof![triple_of(size(1e12)).prop_map(Environment::Constant), sky.prop_map(Environment::Image)].boxed()
}

fn camera() -> BoxedStrategy<Camera> {
    let point = || triple_of(signed(1e3));
    let pixels = || 1..4000u32;
    let up = prop_oneof![Just(Camera::UP), point()];
    let filter = (prop::option::of(1e-3..1e3), prop::option::of(-360.0..360.0));
    (point(), point(), up, 1.0..179.0, pixels(), pixels(), size(1.0), filter)
        .prop_map(|(origin, target, up, fov_y_deg, width, height, aperture, (focus, polariser_deg))| Camera {
            origin,
            target,
            up,
            fov_y_deg,
            width,
            height,
            aperture,
            focus,
            polariser_deg,
        })
        .boxed()
}

/// Any scene that has no flaw.
fn scenes() -> impl Strategy<Value = Scene> {
    let emission = prop::option::of(
        (triple_of(size(1e12)), any::<bool>()).prop_map(|(radiance, two_sided)| Emission { radiance, two_sided }),
    );
    let pick = any::<prop::sample::Index>();
    let shape = (geometry(), pick, emission, transform());
    (
        any::<String>(),
        prop::option::of(1..=u32::MAX),
        prop::sample::select(&Filter::ALL[..]),
        camera(),
        prop::option::of(environment()),
        prop::collection::btree_map(any::<String>(), material(), 1..6),
        prop::collection::vec(shape, 0..6),
        prop::collection::vec(light(), 0..3),
    )
        .prop_map(|(name, max_depth, filter, camera, environment, materials, shapes, lights)| {
            // Not in the order of their names.
            let materials: Vec<_> = materials.into_iter().rev().collect();
            let shape = |(geometry, pick, emission, transform): (_, prop::sample::Index, _, _)| Shape {
                geometry,
                material: pick.get(&materials).0.clone(),
                emission,
                transform,
            };
            let shapes = shapes.into_iter().map(shape).collect();
            filed(Scene { name, max_depth, filter, camera, environment, shapes, materials: materials.clone(), lights })
        })
        .prop_filter("some have a flaw", |scene| scene.flaw().is_none())
}

proptest! {
    #[test]
    fn any_scene_survives_print_and_read(scene in scenes()) {
        prop_assert_eq!(again(&scene), scene);
    }

    /// Whatever becomes of a file, it is a scene without a flaw or a refusal that names the file.
    #[test]
    fn nothing_in_a_file_breaks_the_reader(
        is_toml: bool,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>(), 0..12usize), 1..6),
    ) {
        let mut text: Vec<u8> = if is_toml { WHOLE.into() } else { as_json(&toml::parse(WHOLE).unwrap()).into() };
        // Pieces of the text put elsewhere in it: most of what is wrong then is wrong in a way that a person could make.
        for (from, to, length) in changes {
            let piece = text[from.index(text.len())..].iter().take(length).copied().collect::<Vec<_>>();
            let at = to.index(text.len());
            text.splice(at..(at + length / 2).min(text.len()), piece);
        }
        let path = Path::new(if is_toml { "test.toml" } else { "test.json" });
        let parse = if is_toml { toml::parse } else { json::parse };
        match Source::new(path, text).and_then(|source| read(&source, parse, &none)) {
            Ok((scene, _)) => prop_assert_eq!(scene.flaw(), None),
            Err(stop) => prop_assert!(stop.to_string().starts_with("test."), "{}", stop),
        }
    }
}
