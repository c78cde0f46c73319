use super::*;
use crate::scene::triple::{cross, dot, length, minus, normalised, plus, times, widened};
use crate::scene::{Environment, Mesh, Metal};

fn made(name: &str) -> Scene {
    (named(name).unwrap().make)()
}

#[test]
fn every_scene_is_called_what_the_list_says_and_has_no_flaw() {
    for builtin in BUILTIN {
        let scene = (builtin.make)();
        assert_eq!((scene.name.as_str(), scene.flaw()), (builtin.name, None));
        assert_eq!([scene.camera.width, scene.camera.height], [256; 2], "{}", builtin.name);
        assert!(scene.camera.origin.iter().all(|x| x.is_finite()));
        let used = |name: &str| scene.shapes.iter().any(|shape| shape.material == name);
        assert!(scene.materials.iter().all(|(name, _)| used(name)), "{} has a material that none is of", builtin.name);
    }
}

/// Corners, and their middle.
fn quads(scene: &Scene) -> Vec<([Triple; 4], Triple, &Shape)> {
    let quads = scene.shapes.iter().filter_map(|shape| match shape.geometry {
        Geometry::Quad { vertices } => Some((vertices, times(plus(vertices[0], vertices[2]), 0.5), shape)),
        _ => None,
    });
    quads.collect()
}

fn normal([a, b, _, d]: [Triple; 4]) -> Triple {
    normalised(cross(minus(b, a), minus(d, a)))
}

#[test]
fn the_box_is_closed_but_for_its_front_and_looks_inward() {
    let scene = made("cornell");
    let quads = quads(&scene);
    assert_eq!(quads.len(), 16);
    assert_eq!(scene.shapes.len(), 16);
    let middle = [2.78, 2.744, 2.796];
    for (vertices, center, shape) in &quads[..6] {
        assert!(dot(normal(*vertices), minus(middle, *center)) > 0.0, "{shape:?}");
    }
    // Blocks look outward: from the middle of the block that their top stands over.
    for block in [&quads[6..11], &quads[11..]] {
        let (top, above, _) = block[0];
        let inside = [above[0], above[1] / 2.0, above[2]];
        assert_eq!(normal(top), [0.0, 1.0, 0.0]);
        for (vertices, center, shape) in block {
            assert!(dot(normal(*vertices), minus(*center, inside)) > 0.0, "{shape:?}");
        }
        // Each corner of the top begins one side, and the floor ends it.
        for corner in top {
            let sides =
                block[1..].iter().filter(|(vertices, ..)| near(vertices[0], corner) && vertices[3][1].abs() < 1e-12);
            assert_eq!(sides.count(), 1, "{corner:?}");
        }
    }
    // Red is on the camera's left: its right is direction × up.
    let right = cross(minus(scene.camera.target, scene.camera.origin), scene.camera.up);
    let red = quads.iter().find(|(.., shape)| shape.material == "red").unwrap();
    assert!(dot(minus(red.1, scene.camera.origin), right) < 0.0);
}

fn near(a: Triple, b: Triple) -> bool {
    length(minus(a, b)) < 1e-12
}

#[test]
fn the_blocks_are_where_they_were_measured() {
    // Cornell Box Data: the fourth corners, [mm], of the short and the tall block.
    let measured = [([2.90, 1.65, 1.14], 0.03), ([4.72, 3.30, 4.06], 0.011)];
    let scene = made("cornell");
    let quads = quads(&scene);
    for (top, (corner, off)) in [quads[6], quads[11]].into_iter().zip(measured) {
        assert!(length(minus(top.0[3], corner)) < off, "{:?}", top.0);
    }
}

#[test]
fn far_and_tiny_are_the_box() {
    let (here, far, tiny) = (made("cornell"), made("far"), made("tiny"));
    for ((a, ..), ((b, ..), (c, ..))) in quads(&here).into_iter().zip(quads(&far).into_iter().zip(quads(&tiny))) {
        for at in 0..4 {
            let moved = minus(minus(b[at], far.camera.origin), minus(a[at], here.camera.origin));
            // Two roundings of coordinates of a million, half an ulp of which is 2^-34.
            assert!(length(moved) < 4.0 * 2f64.powi(-34), "{moved:?}");
            assert!(length(minus(times(c[at], 1e6), a[at])) < 1e-14, "{:?}", c[at]);
        }
    }
    assert_eq!((&far.materials, &tiny.materials), (&here.materials, &here.materials));
    assert!(far.shapes.iter().zip(&here.shapes).all(|(far, here)| far.emission == here.emission));
}

#[test]
fn the_lamps_of_veach_send_out_the_same_power() {
    let power = |shape: &Shape| match (&shape.geometry, shape.emission) {
        (Geometry::Sphere { radius, .. }, Some(emission)) => Some(radius * radius * emission.radiance[0]),
        _ => None,
    };
    let powers: Vec<f64> = made("veach").shapes.iter().filter_map(power).collect();
    assert_eq!(powers.len(), 4);
    assert!(powers.iter().all(|power| (power / powers[0] - 1.0).abs() < 1e-12), "{powers:?}");
}

#[test]
fn the_furnace_has_every_kind_of_material_and_none_absorbs() {
    let scene = made("furnace");
    let mut kinds = std::collections::HashSet::new();
    for (name, material) in &scene.materials {
        kinds.insert(std::mem::discriminant(material));
        let absorbs = match material.base() {
            Material::Diffuse { reflectance }
            | Material::RoughDiffuse { reflectance, .. }
            | Material::Mirror { reflectance }
            | Material::Plastic { reflectance, .. } => *reflectance != [1.0; 3],
            // |(n − 1)/(n + 1)| with n = iκ.
            Material::Conductor { metal, .. } | Material::RoughConductor { metal, .. } => {
                !matches!(metal, Metal::Indices { eta: [0.0, 0.0, 0.0], .. })
            }
            Material::Dielectric { absorption, .. }
            | Material::Dispersive { absorption, .. }
            | Material::RoughDielectric { absorption, .. } => *absorption != [0.0; 3],
            Material::Patterned { .. } => panic!("{name} has two patterns"),
        };
        assert!(!absorbs, "{name}");
    }
    // One more kind has to be put there: eight as of now. Glass that disperses is not, since wavelengths bring noise: that it
    // keeps all there is, is tested where paths are.
    assert_eq!(kinds.len(), 8);
    assert_eq!((scene.environment, scene.max_depth), (Some(Environment::Constant([1.0; 3])), None));
    let balls = scene.shapes.iter().map(|shape| match shape.geometry {
        Geometry::Sphere { center, radius } => (center, radius),
        _ => panic!("{shape:?}"),
    });
    let balls: Vec<_> = balls.collect();
    for (at, (a, r)) in balls.iter().enumerate() {
        assert!(balls[..at].iter().all(|(b, s)| length(minus(*a, *b)) > r + s), "{a:?}");
    }
}

#[test]
fn the_mesh_is_a_closed_surface_that_looks_outward() {
    let scene = made("mesh");
    let Geometry::Mesh { mesh, .. } = &scene.shapes[0].geometry else { panic!("no mesh first") };
    assert_eq!(mesh.triangles.len(), 200_000);
    // Each edge belongs to two triangles, which go along it in opposite directions.
    let mut edges = std::collections::HashSet::new();
    let mut volume = 0.0;
    for triangle in &mesh.triangles {
        let [a, b, c] = *triangle;
        for edge in [[a, b], [b, c], [c, a]] {
            assert!(edges.insert(edge), "{edge:?} twice");
        }
        volume += dot(widened(mesh.positions[a as usize]), mesh.area(*triangle)) / 6.0;
    }
    assert!(edges.iter().all(|[a, b]| edges.contains(&[*b, *a])));
    // Euler: a sphere, of which no corner is left out.
    assert_eq!(mesh.positions.len() + mesh.triangles.len(), edges.len() / 2 + 2);
    // About that of a ball; negative if it looked inward.
    assert!((volume / (4.0 / 3.0 * std::f64::consts::PI * 1.2f64.powi(3)) - 1.0).abs() < 0.1, "{volume}");
    // It stands on the floor, and touches no more.
    let lowest = mesh.positions.iter().map(|position| position[1]).fold(f32::INFINITY, f32::min);
    assert!((0.0..0.3).contains(&lowest), "{lowest}");
    for (normal, position) in mesh.normals.iter().zip(&mesh.positions) {
        let out = minus(widened(*position), [0.0, 1.2, 0.0]);
        assert!(dot(widened(*normal), out) > 0.0, "{position:?}");
    }
    assert_eq!(Mesh::clone(mesh).drop_flat(), 0);
    let again = made("mesh");
    let Geometry::Mesh { mesh: again, .. } = &again.shapes[0].geometry else { panic!("no mesh first") };
    assert!(std::sync::Arc::ptr_eq(mesh, again), "made twice");
}

#[test]
fn lamps_send_their_light_where_something_is() {
    // Quads that send out light look down, though one at a slant; balls to all sides.
    for builtin in BUILTIN {
        let scene = (builtin.make)();
        let downward = quads(&scene).into_iter().filter(|(.., shape)| shape.emission.is_some());
        downward.for_each(|(vertices, ..)| assert!(normal(vertices)[1] < -0.6, "{}", builtin.name));
        let is_lit = scene.environment.is_some()
            || scene.shapes.iter().any(|shape| shape.emission.is_some())
            || !scene.lights.is_empty();
        assert!(is_lit, "{}", builtin.name);
    }
}
