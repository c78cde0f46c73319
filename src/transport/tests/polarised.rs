//! Light with its polarisation: against fields multiplied by hand, and where it must not matter.

use super::*;
use crate::media::named;
use crate::optics::Incidence;
use crate::optics::fresnel::{amplitudes, brewster_angle, powers};
use crate::scene::Metal;
use crate::scene::triple::{cross, minus, normalised, plus, times};
use crate::transport::simple::RARE;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, PI};

const GLASS: f64 = 1.5;

fn polarised() -> &'static Integrator {
    RARE.iter().find(|one| one.name == "polarised").expect("there")
}

/// The radiance that a needle sees, by run and channel.
fn seen(scene: &Scene, integrator: &Integrator, count: u64) -> [Moments; 3] {
    let mut found = [Moments::default(), Moments::default(), Moments::default()];
    for seed in 0..count {
        let picture = simple(scene, integrator, 64, seed);
        (0..3).for_each(|c| found[c].add(picture.iter().flatten().map(|half| f64::from(half[c])).sum::<f64>() / 2.0));
    }
    found
}

fn clear(index: f64) -> Material {
    Material::Dielectric { ior: index, outside: 1.0, absorption: [0.0; 3], coating: None }
}

/// A square about a place, that a unit vector is square to.
fn facing(center: [f64; 3], normal: [f64; 3], half: f64) -> Geometry {
    let aside = if normal[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let x = times(normalised(cross(aside, normal)), half);
    let y = cross(normal, x);
    let corner = |a: f64, b: f64| plus(center, plus(times(x, a), times(y, b)));
    quad([corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)])
}

/// A needle's ray along x from 2 m before the origin, up being y.
fn along_x(filter: Option<f64>) -> Camera {
    Camera { up: [0.0, 1.0, 0.0], polariser_deg: filter, ..looking([-2.0, 0.0, 0.0], [0.0; 3], 1e-6, 1) }
}

/// Two plates in the way, at so many radians to the ray each, the plane of incidence of the second one turned by an angle from that of the
/// first, which is the plane of x and y; and a lamp of radiance 1 behind.
fn two_plates(materials: [Material; 2], theta: f64, turned: f64, filter: Option<f64>) -> Scene {
    let bend = PI - 2.0 * theta;
    let there = [1.0, 0.0, 0.0];
    let next = [bend.cos(), bend.sin(), 0.0];
    // In the plane at an angle to that of the first, about where the ray goes.
    let (in_plane, out_of_it) = ([-bend.sin(), bend.cos(), 0.0], [0.0, 0.0, 1.0]);
    let side = plus(times(in_plane, turned.cos()), times(out_of_it, turned.sin()));
    let last = plus(times(next, bend.cos()), times(side, bend.sin()));
    let second = times(next, 2.0);
    let [one, other] = materials;
    let shapes = vec![
        shape(facing([0.0; 3], normalised(minus(next, there)), 0.1), "one"),
        shape(facing(second, normalised(minus(last, next)), 0.1), "other"),
        shining(shape(facing(plus(second, times(last, 2.0)), last, 0.2), "black"), [1.0; 3], true),
    ];
    let materials = vec![("one".into(), one), ("other".into(), other), diffuse("black", [0.0; 3])];
    scene(along_x(filter), 3, materials, shapes)
}

/// The same by fields: the mean over two fields at right angles, in turn by s and p of the second plate, of the first, and by the
/// filter's axis.
fn by_fields(indices: [Complex64; 2], theta: f64, turned: f64, filter: Option<f64>) -> f64 {
    let ratios = indices.map(|index| amplitudes(Incidence::from_angle(theta), 1.0, index));
    let mut sum = 0.0;
    for start in [[1.0, 0.0], [0.0, 1.0]] {
        let [s, y] = start.map(Complex64::from);
        let (s, y) = (ratios[1].r_s * s, ratios[1].r_p * y);
        // About where light goes, d = −next, with s₁ = z and y₁ = d × z: s₂ = s₁ cos − y₁ sin, and y₂ = y₁ cos + s₁ sin.
        let (sin, cos) = turned.sin_cos();
        let (s, y) = (s * cos + y * sin, y * cos - s * sin);
        let (s, y) = (ratios[0].r_s * s, ratios[0].r_p * y);
        sum += match filter {
            None => s.norm_sqr() + y.norm_sqr(),
            // Light goes along −x: s = z is the picture's right, and d × s = y its up.
            Some(angle) => (s * angle.cos() + y * angle.sin()).norm_sqr(),
        };
    }
    0.5 * sum
}

#[test]
fn two_mirrors_of_glass_are_malus_polariscope() {
    // At Brewster's angle the first returns s alone, and the second of that what is s to it: ½R_s² cos².
    let theta = brewster_angle(1.0, GLASS);
    let r_s = powers(Incidence::from_angle(theta), 1.0, GLASS.into()).r_s;
    for turned in [0.0, 0.4, FRAC_PI_2, 2.0, PI] {
        let scene = two_plates([clear(GLASS), clear(GLASS)], theta, turned, None);
        let exact = 0.5 * r_s * r_s * turned.cos().powi(2);
        assert!((by_fields([GLASS.into(); 2], theta, turned, None) - exact).abs() < 1e-15);
        let found = &seen(&scene, polarised(), 64)[1];
        let test = z_test(found.mean(), found.standard_error().max(1e-7), exact);
        assert!(
            test.p > SIGNIFICANCE / 10.0,
            "{turned}: {} ± {} against {exact}",
            found.mean(),
            found.standard_error()
        );
        // Channels of natural light would have had the square of the mean.
        let natural = &seen(&scene, &INTEGRATORS[3], 64)[1];
        let test = z_test(natural.mean(), natural.standard_error(), 0.25 * r_s * r_s);
        assert!(test.p > SIGNIFICANCE / 10.0, "{turned}: {}", natural.mean());
    }
}

#[test]
fn metals_turn_linear_light_elliptical_as_fields_say() {
    // Nothing is chosen by chance: f64 throughout, kept in f32.
    let metal = |name: &str| Material::Conductor { metal: Metal::Named(name.into()), coating: None };
    let indices = |name: &str| named(name).expect("a metal").colour().expect("known");
    let (gold, silver) = (indices("gold"), indices("silver"));
    for theta in [0.3, 1.0, 1.35] {
        for turned in [0.0, 0.7, 1.9] {
            for filter in [None, Some(0.0), Some(30.0), Some(90.0), Some(135.0)] {
                let scene = two_plates([metal("gold"), metal("silver")], theta, turned, filter);
                let found = seen(&scene, polarised(), 1);
                for c in 0..3 {
                    let exact = by_fields([gold[c], silver[c]], theta, turned, filter.map(f64::to_radians));
                    let off = found[c].mean() - exact;
                    assert!(off.abs() < 1e-6, "{theta} {turned} {filter:?}: {} against {exact}", found[c].mean());
                }
            }
        }
    }
}

#[test]
fn a_pile_of_plates_passes_products_not_means() {
    let theta = brewster_angle(1.0, GLASS);
    let plates = 4;
    let normal = [theta.cos(), theta.sin(), 0.0];
    let p = powers(Incidence::from_angle(theta), 1.0, GLASS.into());
    let power = 2 * plates;
    let exact = [
        (None, 0.5 * (p.t_s.powi(power) + p.t_p.powi(power))),
        (Some(0.0), 0.5 * p.t_s.powi(power)),
        (Some(90.0), 0.5 * p.t_p.powi(power)),
    ];
    for (filter, exact) in exact {
        let faces = (0..power).map(|k| {
            let out = if k % 2 == 0 { times(normal, -1.0) } else { normal };
            shape(facing([0.1 * f64::from(k), 0.0, 0.0], out, 1.0), "glass")
        });
        let lamp = shining(shape(facing([3.0, 0.0, 0.0], [-1.0, 0.0, 0.0], 1.0), "black"), [1.0; 3], false);
        let shapes = faces.chain([lamp]).collect();
        let materials = vec![("glass".into(), clear(GLASS)), diffuse("black", [0.0; 3])];
        // So many edges that nothing reflected within can come through.
        let scene = scene(along_x(filter), power as u32 + 1, materials, shapes);
        let found = &seen(&scene, polarised(), 64)[1];
        let test = z_test(found.mean(), found.standard_error().max(1e-7), exact);
        assert!(
            test.p > SIGNIFICANCE / 6.0,
            "{filter:?}: {} ± {} against {exact}",
            found.mean(),
            found.standard_error()
        );
        if filter.is_none() {
            let natural = &seen(&scene, &INTEGRATORS[3], 64)[1];
            let mean = (0.5 * (p.t_s + p.t_p)).powi(power);
            let test = z_test(natural.mean(), natural.standard_error(), mean);
            assert!(test.p > SIGNIFICANCE / 6.0, "{} against {mean}", natural.mean());
            assert!((mean - exact).abs() > 20.0 * natural.standard_error(), "{mean} {exact}");
        }
    }
}

#[test]
fn of_one_polished_surface_at_a_time_nothing_changes() {
    // Water over matt ground: between two meetings with it light is natural again. And mirrors, which are the same to s and p.
    let mut pool = (crate::scene::builtin::named("polariser").expect("there").make)();
    (pool.camera.width, pool.camera.height, pool.camera.polariser_deg) = (12, 12, None);
    let mut mirrors = room(12);
    mirrors.materials.push(("mirror".into(), Material::Mirror { reflectance: [0.9, 0.8, 0.7] }));
    mirrors.shapes[2].material = "mirror".into();
    mirrors.shapes[3].material = "mirror".into();
    for (name, scene) in [("pool", pool), ("mirrors", mirrors)] {
        let (one, other) = (simple(&scene, polarised(), 256, 1), simple(&scene, &INTEGRATORS[3], 256, 2));
        let p = normal_two_sided(apart(&one, &other));
        assert!(p > SIGNIFICANCE / 2.0, "{name}: p = {p:.1e}");
    }
}

#[test]
fn a_filter_takes_the_glare_off_the_pool() {
    // About the middle of the picture: what is reflected of the sky is R_s/2 without a filter and next to nothing with it; what comes
    // from below stays, but for the filter's half.
    let mut pool = (crate::scene::builtin::named("polariser").expect("there").make)();
    (pool.camera.width, pool.camera.height, pool.camera.fov_y_deg) = (8, 8, 2.0);
    pool.shapes.retain(|shape| shape.material == "water" || shape.material == "basin");
    pool.materials.iter_mut().filter(|(name, _)| name == "basin").for_each(|(_, material)| {
        *material = Material::Diffuse { reflectance: [0.0; 3] };
    });
    let glare = |filter| {
        let mut pool = pool.clone();
        pool.camera.polariser_deg = filter;
        green(&simple(&pool, polarised(), 64, 1)).mean()
    };
    let n = match &pool.materials[0].1 {
        Material::Dielectric { ior, .. } => *ior,
        other => panic!("{other:?}"),
    };
    let r_s = powers(Incidence::from_angle(brewster_angle(1.0, n)), 1.0, n.into()).r_s;
    let Some(Environment::Constant([_, sky, _])) = pool.environment else { panic!("{:?}", pool.environment) };
    let [none, across, upright] = [None, Some(0.0), Some(90.0)].map(glare);
    // Within a degree of Brewster's angle R_s changes by a few hundredths of itself; noise is that of 4096 × 2 choices.
    assert!((none / (0.5 * sky * r_s) - 1.0).abs() < 0.12, "{none}");
    assert!((across / (0.5 * sky * r_s) - 1.0).abs() < 0.12, "{across}");
    assert!(upright < 2e-3 * none, "{upright}");
}

#[test]
fn behind_a_rhomb_no_filter_tells_linear_light() {
    let scene = |aside: f64, filter| {
        let mut scene = (crate::scene::builtin::named("rhomb").expect("there").make)();
        for place in [&mut scene.camera.origin, &mut scene.camera.target] {
            place[0] += aside;
        }
        (scene.camera.width, scene.camera.height, scene.camera.fov_y_deg) = (1, 1, 1e-6);
        scene.camera.polariser_deg = filter;
        scene
    };
    let dark = powers(Incidence::from_angle(brewster_angle(1.0, 1.5)), 1.0, 1.5.into()).r_s;
    let (glass, lamp) = (crate::scene::builtin::rhomb::INDEX, 10.0);
    // Beside it nothing is chosen by chance: what the mirror returns of s, by the square of the filter's cosine to it.
    for (filter, share) in [(None, 1.0), (Some(45.0), 0.0), (Some(0.0), 0.5), (Some(90.0), 0.5), (Some(135.0), 1.0)] {
        let found = seen(&scene(-0.03, filter), polarised(), 1)[1].mean();
        assert!((found - 0.5 * lamp * dark * share).abs() < 1e-6, "{filter:?}: {found}");
    }
    // Through it, half at any angle; what goes to and fro inside is circular as well. The same choices at every angle.
    let through = [None, Some(0.0), Some(30.0), Some(45.0), Some(90.0), Some(135.0)].map(|filter| {
        seen(&scene(0.0, filter), polarised(), 64).map(|channel| (channel.mean(), channel.standard_error()))
    });
    let (whole, error) = through[0][1];
    for half in &through[1..] {
        // Corners of meshes are single numbers.
        assert!((2.0 * half[1].0 / whole - 1.0).abs() < 1e-5, "{half:?} of {whole}");
    }
    let face = ((glass - 1.0) / (glass + 1.0)).powi(2);
    let exact = 0.5 * lamp * dark * (1.0 - face) / (1.0 + face);
    assert!(z_test(whole, error, exact).p > SIGNIFICANCE, "{whole} ± {error} against {exact}");
}

#[test]
fn a_scene_behind_a_filter_goes_to_who_looks_at_it() {
    let pool = (crate::scene::builtin::named("polariser").expect("there").make)();
    let needs = crate::transport::Needs::of(&pool);
    let fit: Vec<&str> = Method::all().filter(|one| one.fits(&needs)).map(|one| one.name()).collect();
    assert_eq!((fit, Method::usual(&needs).name()), (vec!["polarised"], "polarised"));
    let needs = crate::transport::Needs::of(&room(4));
    assert!(Method::all().filter(|one| one.fits(&needs)).any(|one| one.name() == "polarised"));
    let prism = (crate::scene::builtin::named("prism").expect("there").make)();
    let needs = crate::transport::Needs::of(&prism);
    let fit: Vec<&str> = Method::all().filter(|one| one.fits(&needs)).map(|one| one.name()).collect();
    assert_eq!(fit, ["fast", "spectral"]);
}
