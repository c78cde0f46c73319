//! Glass that disperses: against Snell wavelength by wavelength, and one way of drawing wavelengths against another.

use super::*;
use crate::colour::response::{BAND, response};
use crate::media::named;
use crate::optics::Incidence;
use crate::optics::fresnel::powers;
use crate::scene::{Glass, Mesh, Normals};
use crate::transport::simple::RARE;
use std::sync::Arc;

fn glass(name: &str, absorption: [f64; 3]) -> Material {
    Material::Dispersive { glass: Glass::Named(name.into()), outside: 1.0, absorption }
}

fn index(name: &str, wavelength: f64) -> f64 {
    named(name).expect("a glass").index(wavelength).expect("known").re
}

/// The angle of a prism's edge.
const APEX: f64 = std::f64::consts::FRAC_PI_3;

/// A ray into a prism of equal sides, at the angle of least deviation of a wavelength [m], and behind it a lamp that begins where
/// that wavelength goes and reaches to where shorter ones do. That angle is 2 arcsin(n sin ½A) − A, by the symmetry of the way.
fn before_a_strip(name: &str, wavelength: f64) -> Scene {
    let deviation = 2.0 * (index(name, wavelength) * (APEX / 2.0).sin()).asin() - APEX;
    let half = 0.5 * deviation;
    // Along x within the glass, its edge up along y.
    let way = [half.cos(), half.sin()];
    let out = [half.cos(), -half.sin()];
    let side = |sign: f64| {
        // From the middle of the face, along it and along the edge.
        let [x, y] = [-sign * (APEX / 2.0).sin(), (APEX / 2.0).cos()];
        let corner = |along: f64, z: f64| [sign * 0.1 + along * x, along * y, z];
        let [low, high] = [-0.15, 0.15];
        let corners = [corner(low, -0.2), corner(high, -0.2), corner(high, 0.2), corner(low, 0.2)];
        // Outward of the glass.
        if sign < 0.0 { corners.map(|[x, y, z]| [x, y, -z]) } else { corners }
    };
    let far = 10.0;
    let edge = [0.1 + far * out[0], far * out[1]];
    // Shorter wavelengths are bent more: further from the edge of the prism, which is up.
    let [dx, dy] = [-4.0 * half.sin(), -4.0 * half.cos()];
    let strip = quad([
        [edge[0], edge[1], -2.0],
        [edge[0], edge[1], 2.0],
        [edge[0] + dx, edge[1] + dy, 2.0],
        [edge[0] + dx, edge[1] + dy, -2.0],
    ]);
    let camera =
        Camera { up: [0.0, 0.0, 1.0], ..looking([-0.1 - 0.5 * way[0], -0.5 * way[1], 0.0], [-0.1, 0.0, 0.0], 1e-5, 1) };
    let materials = vec![("glass".into(), glass(name, [0.0; 3])), diffuse("black", [0.0; 3])];
    let shapes = vec![
        shape(quad(side(-1.0)), "glass"),
        shape(quad(side(1.0)), "glass"),
        shining(shape(strip, "black"), [1.0; 3], true),
    ];
    scene(camera, 3, materials, shapes)
}

/// What the strip shows in each channel: ∫r_c T₁T₂ dλ over shorter wavelengths, by Snell and E42 at each.
fn on_the_strip(name: &str, last: f64) -> [f64; 3] {
    let angle = (index(name, last) * (APEX / 2.0).sin()).asin();
    let passed = |wavelength: f64| {
        let n = index(name, wavelength);
        let inside = (angle.sin() / n).asin();
        let there = powers(Incidence::from_angle(angle), 1.0, n.into());
        let back = powers(Incidence::from_angle(APEX - inside), n, 1.0.into());
        (1.0 - there.r_n()) * (1.0 - back.r_n())
    };
    const STEPS: usize = 20_000;
    let step = (last - BAND[0]) / STEPS as f64;
    (0..STEPS).fold([0.0; 3], |sum, k| {
        let wavelength = BAND[0] + step * (k as f64 + 0.5);
        let (seen, share) = (response().at(wavelength), passed(wavelength) * step);
        std::array::from_fn(|c| sum[c] + seen[c] * share)
    })
}

fn channel(picture: &[Halves], c: usize) -> f64 {
    picture.iter().flatten().map(|half| f64::from(half[c])).sum::<f64>() / (2 * picture.len()) as f64
}

#[test]
fn every_wavelength_goes_where_snell_says() {
    let ends = [420e-9, 520e-9, 600e-9, 700e-9];
    let spectral = &RARE[0];
    let least = sidak(SIGNIFICANCE, 2 * 2 * 3 * ends.len());
    for name in ["sf11", "bk7"] {
        for end in ends {
            let (scene, exact) = (before_a_strip(name, end), on_the_strip(name, end));
            let mut found = [[Moments::default(), Moments::default(), Moments::default()]; 2];
            for seed in 0..24 {
                let lanes = fast::<F32x8>(&scene, &Tactics::default(), 256, seed);
                let simple = simple(&scene, spectral, 256, 100 + seed);
                for (moments, picture) in found.iter_mut().zip([lanes, simple]) {
                    (0..3).for_each(|c| moments[c].add(channel(&picture, c)));
                }
            }
            for (how, moments) in ["lanes", "spectral"].iter().zip(&found) {
                for c in 0..3 {
                    let test = t_test(&moments[c], exact[c]);
                    let said = format!("{name} to {end:e}, {c}, {how}: {} against {}", moments[c].mean(), exact[c]);
                    assert!(test.p > least, "{said}, p = {:.1e}", test.p);
                    // Two nanometres beside it would be seen.
                    assert!(moments[c].standard_error() < 1e-2, "{said} ± {}", moments[c].standard_error());
                }
            }
        }
    }
}

/// The hall's bodies of glass that disperses, one of them absorbing, so that paths reflect and pass several times.
fn dispersing(pixels: u32) -> Scene {
    let mut hall = hall(pixels);
    for (name, material) in &mut hall.materials {
        match name.as_str() {
            "glass" => *material = glass("sf11", [0.0, 0.5, 1.0]),
            "mirror" => *material = glass("diamond", [0.0; 3]),
            _ => (),
        }
    }
    hall
}

/// By each channel, how far two pictures are apart in their own errors.
fn apart_by_channel(one: &[Halves], other: &[Halves]) -> [f64; 3] {
    std::array::from_fn(|c| {
        let (mut difference, mut variance) = (0.0, 0.0);
        for (a, b) in one.iter().zip(other) {
            let mean = |halves: &Halves| f64::from(halves[0][c] + halves[1][c]) / 2.0;
            let error = |halves: &Halves| f64::from(halves[0][c] - halves[1][c]).powi(2) / 4.0;
            difference += mean(a) - mean(b);
            variance += error(a) + error(b);
        }
        difference / variance.sqrt()
    })
}

#[test]
fn lazily_or_from_the_eye_on_it_is_the_same_picture() {
    let scene = dispersing(12);
    let spectral = &RARE[0];
    let lanes = |tactics, seed| filmed(&scene, &with(tactics, seed), &[0..512]).halves();
    let all = lanes(Tactics::default(), 1);
    let chance = lanes(Tactics { caustics: false, ..Tactics::default() }, 2);
    let plain = simple(&scene, spectral, 2048, 3);
    let least = sidak(SIGNIFICANCE, 9);
    for (how, [a, b]) in
        [("paths from lamps", [&all, &chance]), ("at the eye", [&all, &plain]), ("by chance", [&chance, &plain])]
    {
        for (c, off) in apart_by_channel(a, b).into_iter().enumerate() {
            assert!(normal_two_sided(off) > least, "{how}, {c}: {off:.1} standard errors apart");
        }
    }
}

#[test]
fn a_prism_casts_one_rainbow_from_either_end() {
    // Under a lamp in the ceiling; by chance alone it takes longer.
    let mut scene = room(12);
    scene.shapes.retain(|shape| !matches!(shape.geometry, Geometry::Box { .. }));
    let wedge = Mesh::prism([[0.3, 0.3, 0.2], [0.7, 0.3, 0.2], [0.5, 0.646, 0.2]], [0.0, 0.0, 0.6]);
    scene.materials.push(("prism".into(), glass("sf11", [0.0; 3])));
    scene.shapes.push(shape(Geometry::Mesh { file: None, normals: Normals::Flat, mesh: Arc::new(wedge) }, "prism"));
    let lanes = |caustics, seed, pairs: u32| {
        filmed(&scene, &with(Tactics { caustics, ..Tactics::default() }, seed), &[0..pairs]).halves()
    };
    let (both, chance) = (lanes(true, 1, 512), lanes(false, 2, 1024));
    let least = sidak(SIGNIFICANCE, 3);
    for (c, off) in apart_by_channel(&both, &chance).into_iter().enumerate() {
        assert!(normal_two_sided(off) > least, "{c}: {off:.1} standard errors apart");
    }
}

#[test]
fn a_body_that_disperses_cannot_be_seen_in_a_white_world() {
    for (outside, name) in [(1.0, "sf11"), (1.0, "diamond"), (1.5168, "bk7"), (2.0, "sf10")] {
        let body = Material::Dispersive { glass: Glass::Named(name.into()), outside, absorption: [0.0; 3] };
        let ball = shape(Geometry::Sphere { center: [0.0, 0.0, 3.0], radius: 1.0 }, "body");
        let camera = looking([0.0; 3], [0.0, 0.0, 1.0], 40.0, 8);
        let mut world = scene(camera, 256, vec![("body".into(), body)], vec![ball]);
        world.environment = Some(Environment::Constant([1.0; 3]));
        for c in 0..3 {
            let mut found = Moments::default();
            (0..16).for_each(|seed| found.add(channel(&fast::<F32x8>(&world, &Tactics::default(), 64, seed), c)));
            let test = t_test(&found, 1.0);
            assert!(
                test.p > SIGNIFICANCE / 12.0,
                "{name} in {outside}, {c}: {} ± {}",
                found.mean(),
                found.standard_error()
            );
            assert!(found.standard_error() < 2e-3, "{name} in {outside}, {c}: ± {}", found.standard_error());
        }
    }
}

#[test]
fn eight_wavelengths_are_eight_single_ones() {
    let scene = dispersing(8);
    let lanes = fast::<F32x8>(&scene, &Tactics::default(), 16, 5);
    assert_eq!(lanes, fast::<f32>(&scene, &Tactics::default(), 16, 5));
}

#[test]
fn a_camera_within_glass_sees_by_the_same_rules() {
    // All paths begin inside, where light may be reflected in total at some wavelengths and not at others.
    let mut scene = dispersing(8);
    scene.camera = looking([0.3, 0.3, 0.4], [0.7, 0.2, 0.6], 120.0, 8);
    let spectral = &RARE[0];
    let lanes = filmed(&scene, &with(Tactics::default(), 1), &[0..512]).halves();
    let plain = simple(&scene, spectral, 1024, 3);
    let least = sidak(SIGNIFICANCE, 3);
    for (c, off) in apart_by_channel(&lanes, &plain).into_iter().enumerate() {
        assert!(normal_two_sided(off) > least, "{c}: {off:.1} standard errors apart");
    }
}

#[test]
fn a_rainbow_lies_where_snell_puts_it() {
    // The lecture's scene with nothing lit but the screen, seen square on: places on it are even in the picture.
    let mut scene = (crate::scene::builtin::named("prism").expect("there").make)();
    scene.environment = None;
    for (name, material) in &mut scene.materials {
        if matches!(name.as_str(), "table" | "tunnel") {
            *material = Material::Diffuse { reflectance: [0.0; 3] };
        }
    }
    // A strip as high as the lamp is: what goes through the prism at a slant is bent more, so that lines are curved.
    let (pixels, high, half) = (128, 8, 0.16);
    let angle = 2.0 * (half * f64::from(high) / f64::from(pixels) / 0.5).atan().to_degrees();
    let middle = [0.27, 0.02];
    scene.camera = Camera {
        up: Camera::UP,
        width: pixels,
        height: high,
        ..looking([middle[0], middle[1], -0.1], [middle[0], middle[1], -0.6], angle, pixels)
    };
    let place = |wavelength| crate::scene::builtin::prism::on_screen(wavelength).expect("it gets through");
    let n = |wavelength| index("sf11", wavelength);
    let theta = (n(crate::bsdf::dispersive::D_LINE) * (APEX / 2.0).sin()).asin();
    let passed = |wavelength: f64| {
        let inside = (theta.sin() / n(wavelength)).asin();
        let there = powers(Incidence::from_angle(theta), 1.0, n(wavelength).into());
        let back = powers(Incidence::from_angle(APEX - inside), n(wavelength), 1.0.into());
        (1.0 - there.r_n()) * (1.0 - back.r_n())
    };
    let (first, zeroth) = (response().mean(|l| passed(l) * place(l)), response().mean(passed));
    let mut found = [Moments::default(), Moments::default(), Moments::default()];
    for seed in 0..16 {
        let picture = filmed(&scene, &with(Tactics::default(), seed), &[0..512]).halves();
        for (c, moments) in found.iter_mut().enumerate() {
            let (mut sum, mut along) = (0.0, 0.0);
            for (at, halves) in picture.iter().enumerate() {
                let light = f64::from(halves[0][c] + halves[1][c]);
                let x = (at as u32 % pixels) as f64 + 0.5;
                sum += light;
                along += light * (middle[0] + half * (2.0 * x / f64::from(pixels) - 1.0));
            }
            moments.add(along / sum);
        }
    }
    for (c, moments) in found.iter().enumerate() {
        let exact = first[c] / zeroth[c];
        let off = moments.mean() - exact;
        // Besides noise, the lamp and the slit are not points, and their images are not quite even about the middle: by about their
        // width, squared, over what lies between.
        let slack = 0.01 * 0.01 / 0.6;
        assert!(
            off.abs() < 4.0 * moments.standard_error() + slack,
            "{c}: {} ± {} against {exact}",
            moments.mean(),
            moments.standard_error()
        );
        assert!(moments.standard_error() < 1e-3, "{c}: {}", moments.standard_error());
    }
    // Red is bent less than blue, by centimetres.
    assert!(found[0].mean() - found[2].mean() > 0.02);
}
