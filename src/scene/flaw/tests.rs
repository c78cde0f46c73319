use super::Flaw;
use crate::scene::builtin;
use crate::scene::*;
use std::sync::Arc;

/// What spoils a scene.
type Slip = fn(&mut Scene);

/// A scene that has a bit of everything: each slip in it must be found where it is.
fn whole() -> Scene {
    let mut scene = (builtin::named("furnace").unwrap().make)();
    let film = || Some(Coating { medium: "mgf2".into(), thickness_nm: 99.6 });
    let gold = Material::Conductor { metal: Metal::Named("gold".into()), coating: film() };
    scene.materials.insert(0, ("gold".into(), gold));
    let mesh = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let of = |geometry| Shape {
        geometry,
        material: "gold".into(),
        emission: Some(Emission { radiance: [1.0; 3], two_sided: false }),
        transform: Transform { scale: [2.0, -2.0, 2.0], rotate_deg: [10.0, 20.0, 30.0], translate: [1.0, 2.0, 3.0] },
    };
    scene.shapes = vec![
        of(Geometry::Quad { vertices: [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]] }),
        of(Geometry::Sphere { center: [0.0; 3], radius: 1.0 }),
        of(Geometry::Disc { center: [0.0; 3], normal: [0.0, 0.0, 3.0], radius: 1.0 }),
        of(Geometry::Box { min: [0.0; 3], max: [1.0; 3] }),
        of(Geometry::Mesh { file: None, normals: Normals::Smooth, mesh: Arc::new(mesh) }),
    ];
    scene.lights = vec![
        Light::Point { position: [0.0; 3], intensity: [1.0; 3] },
        Light::Directional { direction: [0.0, -1.0, 0.0], irradiance: [1.0; 3] },
    ];
    scene
}

fn found(slip: Slip) -> Flaw {
    let mut scene = whole();
    slip(&mut scene);
    scene.flaw().expect("the slip was not found")
}

/// Sets a field of a geometry or a material: whatever the pattern binds.
macro_rules! put {
    ($scene:ident.$list:ident[$at:expr]: $pattern:pat => $change:expr) => {
        match put!(@ $scene $list $at) {
            $pattern => $change,
            _ => panic!("another kind stands there"),
        }
    };
    (@ $scene:ident shapes $at:expr) => { &mut $scene.shapes[$at].geometry };
    (@ $scene:ident lights $at:expr) => { &mut $scene.lights[$at] };
    (@ $scene:ident materials $name:expr) => {
        &mut $scene.materials.iter_mut().find(|(name, _)| name == $name).unwrap().1
    };
}

fn mesh(scene: &mut Scene, change: fn(&mut Mesh)) {
    put!(scene.shapes[4]: Geometry::Mesh { mesh, .. } => change(Arc::make_mut(mesh)));
}

#[test]
fn what_is_right_has_no_flaw() {
    assert_eq!(whole().flaw(), None);
}

#[test]
fn every_slip_is_found_where_it_is_with_what_would_be_valid() {
    const NAN: f64 = f64::NAN;
    let slips: &[(Slip, &str, &str)] = &[
        (|s| s.max_depth = Some(0), "max_depth", "valid: at least 1"),
        (|s| s.camera.origin[1] = NAN, "camera.origin[1]", "NaN is out of range; valid: -1e12 to 1e12 m"),
        (|s| s.camera.target = [2e12; 3], "camera.target[0]", "2e12 is out of range"),
        (|s| s.camera.target = s.camera.origin, "camera.target", "valid: any other place"),
        (|s| s.camera.up = [0.0; 3], "camera.up", "has no length"),
        (|s| s.camera.up = [0.0, 0.0, -7.0], "camera.up", "is along the view"),
        (|s| s.camera.up = [1e-7, 0.0, 1.0], "camera.up", "is along the view"),
        (|s| s.camera.fov_y_deg = 0.0, "camera.fov_y_deg", "valid: above 0, below 180 deg"),
        (|s| s.camera.fov_y_deg = 180.0, "camera.fov_y_deg", "valid: above 0, below 180 deg"),
        (|s| s.camera.width = 0, "camera.width", "valid: at least 1"),
        (|s| s.camera.height = 0, "camera.height", "valid: at least 1"),
        (|s| s.camera.height = u32::MAX, "camera.height", "256 × 4294967295 pixels take 49152.0 GiB of memory"),
        (|s| s.camera.aperture = -1.0, "camera.aperture", "valid: 0 to 1e12 m"),
        (|s| s.camera.focus = Some(0.0), "camera.focus", "valid: above 0"),
        (
            |s| s.environment = Some(Environment::Constant([1.0, 1.0, -1.0])),
            "environment.radiance[2]",
            "valid: 0 to 1e15 W m⁻² sr⁻¹",
        ),
        (|s| s.materials.push(s.materials[0].clone()), "materials.gold", "two of that name"),
        (
            |s| put!(s.materials["diffuse"]: Material::Diffuse { reflectance } => reflectance[1] = 1.5),
            "materials.diffuse.reflectance[1]",
            "1.5 is out of range; valid: 0 to 1",
        ),
        (
            |s| put!(s.materials["rough_diffuse"]: Material::RoughDiffuse { roughness, .. } => *roughness = -0.1),
            "materials.rough_diffuse.roughness",
            "valid: 0 to 1",
        ),
        (
            |s| put!(s.materials["mirror"]: Material::Mirror { reflectance } => reflectance[0] = NAN),
            "materials.mirror.reflectance[0]",
            "NaN",
        ),
        (
            |s| put!(s.materials["gold"]: Material::Conductor { metal, .. } => *metal = Metal::Named("water".into())),
            "materials.gold.metal",
            "no metal",
        ),
        (
            |s| put!(s.materials["gold"]: Material::Conductor { coating, .. } => coating.as_mut().unwrap().medium.push('x')),
            "materials.gold.coating.medium",
            "no medium",
        ),
        (
            |s| put!(s.materials["gold"]: Material::Conductor { coating, .. } => coating.as_mut().unwrap().thickness_nm = 0.0),
            "materials.gold.coating.thickness_nm",
            "valid: above 0, up to 1e6 nm",
        ),
        (
            |s| put!(s.materials["conductor"]: Material::Conductor { metal: Metal::Indices { k, .. }, .. } => k[2] = -1.0),
            "materials.conductor.k[2]",
            "valid: 0 to 1000",
        ),
        (
            |s| put!(s.materials["rough_conductor"]: Material::RoughConductor { facets, .. } => facets.alpha = [0.0; 2]),
            "materials.rough_conductor.alpha",
            "valid: 0.0001 to 1",
        ),
        (
            |s| put!(s.materials["rough_dielectric"]: Material::RoughDielectric { facets, .. } => facets.alpha[1] = 1.5),
            "materials.rough_dielectric.alpha_y",
            "valid: 0.0001 to 1",
        ),
        (
            |s| put!(s.materials["dielectric"]: Material::Dielectric { ior, .. } => *ior = 0.05),
            "materials.dielectric.ior",
            "valid: 0.1 to 10",
        ),
        (
            |s| put!(s.materials["dielectric"]: Material::Dielectric { ior, outside, .. } => (*ior, *outside) = (0.2, 9.0)),
            "materials.dielectric.ior",
            "over the one outside",
        ),
        (
            |s| put!(s.materials["dielectric"]: Material::Dielectric { absorption, .. } => absorption[0] = -1.0),
            "materials.dielectric.absorption[0]",
            "valid: 0 to 1e12 m⁻¹",
        ),
        (
            |s| put!(s.materials["rough_plastic"]: Material::Plastic { alpha, .. } => *alpha = Some(0.0)),
            "materials.rough_plastic.alpha",
            "valid: 0.0001 to 1",
        ),
        (
            |s| put!(s.shapes[0]: Geometry::Quad { vertices } => vertices[2][2] = f64::INFINITY),
            "shapes[0].vertices[2][2]",
            "inf is out of range",
        ),
        (
            |s| put!(s.shapes[0]: Geometry::Quad { vertices } => vertices[2] = [1.0, 1.0, 0.01]),
            "shapes[0].vertices",
            "no parallelogram; valid: [1, 1, 0] as the third",
        ),
        (
            |s| put!(s.shapes[0]: Geometry::Quad { vertices } => vertices[2..].copy_from_slice(&[[2.0, 0.0, 0.0], [1.0, 0.0, 0.0]])),
            "shapes[0].vertices",
            "no area",
        ),
        (
            |s| put!(s.shapes[0]: Geometry::Quad { vertices } => *vertices = [[1.0; 3]; 4]),
            "shapes[0].vertices",
            "no area",
        ),
        (
            |s| put!(s.shapes[1]: Geometry::Sphere { radius, .. } => *radius = -1.0),
            "shapes[1].radius",
            "-1 is out of range; valid: above 0, up to 1e12 m",
        ),
        (
            |s| put!(s.shapes[1]: Geometry::Sphere { center, radius } => (center[0], *radius) = (1e6, 1e-10)),
            "shapes[1].radius",
            "1e-10 is lost so far out",
        ),
        (
            |s| put!(s.shapes[2]: Geometry::Disc { normal, .. } => *normal = [0.0; 3]),
            "shapes[2].normal",
            "has no length",
        ),
        (|s| put!(s.shapes[2]: Geometry::Disc { radius, .. } => *radius = NAN), "shapes[2].radius", "NaN"),
        (
            |s| put!(s.shapes[3]: Geometry::Box { max, .. } => max[1] = 0.0),
            "shapes[3].max[1]",
            "0 is not above that of min, 0",
        ),
        (|s| mesh(s, |m| m.positions[1][2] = f32::NAN), "shapes[4].mesh.positions[1][2]", "NaN"),
        (|s| mesh(s, |m| m.normals.truncate(2)), "shapes[4].mesh.normals", "2 for 3 corners"),
        (|s| mesh(s, |m| m.normals.clear()), "shapes[4].mesh.normals", "yet smooth"),
        (|s| mesh(s, |m| m.normals[1] = [0.0; 3]), "shapes[4].mesh.normals[1]", "has no length"),
        (
            |s| mesh(s, |m| m.triangles.push([0, 1, 3])),
            "shapes[4].mesh.triangles[1]",
            "there is no corner 3; there are 3",
        ),
        (|s| mesh(s, |m| m.triangles.clear()), "shapes[4].mesh.triangles", "none that has an area"),
        (|s| mesh(s, |m| m.positions[1] = [0.0, 2.0, 0.0]), "shapes[4].mesh.triangles", "none that has an area"),
        (|s| s.shapes[0].material = "gild".into(), "shapes[0].material", "no such material in the scene"),
        (
            |s| s.shapes[0].emission.as_mut().unwrap().radiance[0] = -1.0,
            "shapes[0].emission[0]",
            "valid: 0 to 1e15 W m⁻² sr⁻¹",
        ),
        (|s| s.shapes[0].transform.scale[1] = 0.0, "shapes[0].transform.scale[1]", "leaves nothing"),
        (|s| s.shapes[1].transform.scale[1] = 3.0, "shapes[1].transform.scale", "ellipsoid"),
        (|s| s.shapes[2].transform.scale[1] = 3.0, "shapes[2].transform.scale", "ellipse"),
        (|s| s.shapes[3].transform.rotate_deg[1] = NAN, "shapes[3].transform.rotate_deg[1]", "NaN"),
        (|s| s.shapes[3].transform.translate[1] = 1e13, "shapes[3].transform.translate[1]", "valid: -1e12 to 1e12 m"),
        // Each number is within its range, their product is not.
        (
            |s| {
                put!(s.shapes[3]: Geometry::Box { max, .. } => max[0] = 1e9);
                s.shapes[3].transform.scale[0] = 1e9;
            },
            "shapes[3].transform",
            "takes the shape to",
        ),
        (
            |s| s.shapes[0].transform = Transform { scale: [1e-9; 3], translate: [1e9; 3], ..Transform::default() },
            "shapes[0].transform",
            "no area",
        ),
        (
            |s| s.shapes[1].transform = Transform { scale: [1e-9; 3], translate: [1e9; 3], ..Transform::default() },
            "shapes[1].transform",
            "lost so far out",
        ),
        (|s| put!(s.lights[0]: Light::Point { position, .. } => position[0] = NAN), "lights[0].position[0]", "NaN"),
        (
            |s| put!(s.lights[0]: Light::Point { intensity, .. } => intensity[0] = -1.0),
            "lights[0].intensity[0]",
            "W sr⁻¹",
        ),
        (
            |s| put!(s.lights[1]: Light::Directional { direction, .. } => *direction = [0.0; 3]),
            "lights[1].direction",
            "has no length",
        ),
        (
            |s| put!(s.lights[1]: Light::Directional { irradiance, .. } => irradiance[0] = 1e16),
            "lights[1].irradiance[0]",
            "1e16 is out of range; valid: 0 to 1e15 W m⁻²",
        ),
    ];
    for (slip, place, why) in slips {
        let flaw = found(*slip);
        assert_eq!(flaw.place.to_string(), *place, "{flaw}");
        assert!(flaw.why.contains(why), "should say `{why}`: {flaw}");
    }
}

#[test]
fn a_name_that_is_not_known_comes_with_those_that_are() {
    let names = |slip: Slip| found(slip).unknown.unwrap();
    let material = names(|s| s.shapes[0].material = "gild".into());
    assert_eq!((material.word.as_str(), material.names[0].as_str()), ("gild", "gold"));
    let metal = names(
        |s| put!(s.materials["gold"]: Material::Conductor { metal, .. } => *metal = Metal::Named("glass".into())),
    );
    assert!(["gold", "silver", "copper", "aluminium"].iter().all(|known| metal.names.iter().any(|name| name == known)));
    assert!(
        !["glass", "water", "silicon"].iter().any(|clear| metal.names.iter().any(|name| name == clear)),
        "{metal:?}"
    );
    let flaw = found(|s| s.shapes[0].material = "gild".into());
    assert!(
        flaw.to_string().starts_with("shapes[0].material: no such material in the scene, found `gild`. Known: gold, ")
    );
}

/// A quad of this height [m] over a side of one metre, so far out [m].
fn strip(height: f64, out: f64) -> Option<Flaw> {
    let mut scene = whole();
    let vertices = [[out, 0.0, 0.0], [out + 1.0, 0.0, 0.0], [out + 1.0, height, 0.0], [out, height, 0.0]];
    scene.shapes = vec![Shape {
        geometry: Geometry::Quad { vertices },
        transform: Transform::default(),
        ..scene.shapes[0].clone()
    }];
    scene.flaw()
}

#[test]
fn thin_is_not_flat_until_rounding_decides_the_normal() {
    // At the origin coordinates of 1 are known to 2^-53, and so is where the strip's far end lies.
    assert_eq!(strip(1e-14, 0.0), None);
    assert!(strip(1e-16, 0.0).is_some());
    // A million metres out they are known to 2^-34 = 6e-11.
    assert_eq!(strip(1e-8, 1e6), None);
    assert!(strip(1e-10, 1e6).is_some());
}

#[test]
fn single_numbers_in_a_file_make_a_parallelogram() {
    let mut scene = whole();
    let single = |x: f64| f64::from(x as f32);
    let turned = |x: f64, y: f64| [single(100.0 + 0.6 * x - 0.8 * y), single(0.8 * x + 0.6 * y), single(x / 3.0)];
    let vertices = [turned(0.0, 0.0), turned(7.0, 0.0), turned(7.0, 7.0), turned(0.0, 7.0)];
    put!(scene.shapes[0]: Geometry::Quad { vertices: of } => *of = vertices);
    assert_eq!(scene.flaw(), None);
}

#[test]
fn the_largest_picture_is_as_large_as_it_is_said() {
    let takes = |width, height| {
        let mut scene = whole();
        (scene.camera.width, scene.camera.height) = (width, height);
        scene.flaw().is_none()
    };
    // 4 GiB at 48 bytes a pixel.
    let most = 89_478_485;
    assert!(takes(most, 1) && takes(1, most));
    assert!(!takes(most + 1, 1) && !takes(u32::MAX, u32::MAX));
    // 8K, and twice that.
    assert!(takes(7680, 4320) && !takes(15360, 8640));
}
