use super::*;
use crate::optics::fresnel::{brewster_angle, natural_reflectance};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

fn near(a: Stokes, b: Stokes, within: f64) {
    let off = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= within, "{a:?} against {b:?}");
}

/// Of fields.
fn stokes(x: Complex64, y: Complex64) -> Stokes {
    let both = 2.0 * x.conj() * y;
    [x.norm_sqr() + y.norm_sqr(), x.norm_sqr() - y.norm_sqr(), both.re, both.im]
}

#[test]
fn matrices_do_to_stokes_vectors_what_ratios_do_to_fields() {
    let fields = [(0.3, 0.1), (-0.7, 0.4), (1.2, -0.2), (0.0, 0.9)].map(|(re, im)| Complex64::new(re, im));
    for a in fields {
        for b in fields {
            for x in fields {
                for y in fields {
                    near(Mueller::of_fields(a, b).apply(stokes(x, y)), stokes(a * x, b * y), 1e-14);
                }
            }
            let (sin, cos) = 0.7_f64.sin_cos();
            near(Mueller::turn(0.7).apply(stokes(a, b)), stokes(a * cos + b * sin, b * cos - a * sin), 1e-14);
            // What a polariser at 0.7 lets through is the field along its axis.
            let along = a * cos + b * sin;
            near(Mueller::polariser(0.7).apply(stokes(a, b)), stokes(along * cos, along * sin), 1e-14);
        }
    }
}

#[test]
fn the_hand_is_the_right_one() {
    // E_x = cos ωt, E_y = sin ωt turns from x to y; sin ωt is the real part of i e^(−iωt).
    assert_eq!(stokes(Complex64::ONE, Complex64::I)[3], 2.0);
    // A mirror makes left of right, and keeps what lies along or across the plane of incidence.
    let there = Mueller::reflection(Incidence::from_angle(0.0), 1.0, Complex64::new(0.0, 3.0));
    near(there.apply([1.0, 0.0, 0.0, 1.0]), [1.0, 0.0, 0.0, -1.0], 1e-14);
    near(Mueller::mirror(1.0).apply([1.0, 0.6, 0.0, 0.8]), [1.0, 0.6, 0.0, -0.8], 1e-14);
    // So does glass, of what it reflects; passing keeps the hand.
    let glass = Mueller::reflection(Incidence::from_angle(0.0), 1.0, 1.5.into());
    near(glass.apply([1.0, 0.0, 0.0, 1.0]), [0.04, 0.0, 0.0, -0.04], 1e-15);
    let through = Mueller::transmission(Incidence::from_angle(0.3), 1.0, 1.5);
    assert!(through.apply([1.0, 0.0, 0.0, 1.0])[3] > 0.9);
}

#[test]
fn two_polarisers_pass_what_malus_says() {
    for k in 0..=12 {
        let angle = PI * f64::from(k) / 12.0;
        let both = Mueller::polariser(angle).after(&Mueller::polariser(0.0));
        assert!((both.apply(natural(1.0))[0] - 0.5 * angle.cos().powi(2)).abs() < 1e-15, "{angle}");
    }
}

#[test]
fn a_rhomb_makes_linear_light_circular() {
    // Born & Wolf §1.5.4: two total reflections at 54°37′ in glass of 1.51, of light at 45° to the plane.
    let once = Mueller::reflection(Incidence::from_angle((54.0 + 37.0 / 60.0_f64).to_radians()), 1.51, Complex64::ONE);
    let light = once.after(&once).apply([1.0, 0.0, 1.0, 0.0]);
    assert!((light[3].abs() - 1.0).abs() < 1e-5, "{light:?}");
    assert!(light[2].abs() < 4e-3 && light[1].abs() < 1e-14, "{light:?}");
    // Once is half way there.
    let half = once.apply([1.0, 0.0, 1.0, 0.0]);
    assert!((half[2].abs() - 0.5_f64.sqrt()).abs() < 2e-3, "{half:?}");
}

#[test]
fn a_pile_of_plates_polarises() {
    // At Brewster's angle p passes whole, s by 4n²/(1 + n²)² at each face.
    let n = 1.5_f64;
    let there = brewster_angle(1.0, n);
    let back = FRAC_PI_2 - there;
    let plate = Mueller::transmission(Incidence::from_angle(back), n, 1.0).after(&Mueller::transmission(
        Incidence::from_angle(there),
        1.0,
        n,
    ));
    let s = (4.0 * n * n / (1.0 + n * n).powi(2)).powi(2);
    let mut light = natural(1.0);
    for plates in 1..=20 {
        light = plate.apply(light);
        let left = s.powi(plates);
        let exact = (1.0 - left) / (1.0 + left);
        assert!((degree(light) - exact).abs() < 1e-13, "{plates}: {} {exact}", degree(light));
        assert!(light[1] < 0.0, "what is left is p");
    }
}

fn index() -> impl Strategy<Value = Complex64> {
    (0.05..4.0, prop_oneof![Just(0.0), 1e-6..8.0]).prop_map(|(n, k)| Complex64::new(n, k))
}

proptest! {
    #[test]
    fn natural_light_is_reflected_by_the_mean(theta in 0.0..1.57, n_i in 1.0..2.0, n_t in index()) {
        let incidence = Incidence::from_angle(theta);
        let p = powers(incidence, n_i, n_t);
        let light = Mueller::reflection(incidence, n_i, n_t).apply(natural(1.0));
        prop_assert!((light[0] - p.r_n()).abs() < 1e-13);
        prop_assert!((light[1] - 0.5 * (p.r_s - p.r_p)).abs() < 1e-13);
        if n_t.im == 0.0 {
            let passed = Mueller::transmission(incidence, n_i, n_t.re).apply(natural(1.0));
            prop_assert!((light[0] + passed[0] - 1.0).abs() < 1e-13);
            let mut by_other = [0.0];
            natural_reflectance(&[incidence.cos()], n_i, n_t.re, &mut by_other);
            prop_assert!((light[0] - by_other[0]).abs() < 1e-12);
            if n_t.re > n_i * 1.01 {
                let own = reflected_degree(theta.sin().powi(2), n_t.re / n_i);
                prop_assert!((degree(light) - own).abs() < 1e-9, "{} {own}", degree(light));
            }
        }
    }

    #[test]
    fn all_of_them_are_possible(theta in 0.0..1.57, n_i in 1.0..2.0, n_t in index(), turns in -4.0..4.0, angle in -4.0..4.0) {
        let incidence = Incidence::from_angle(theta);
        let there = Mueller::reflection(incidence, n_i, n_t);
        let passed = if n_t.im == 0.0 { Mueller::transmission(incidence, n_i, n_t.re) } else { Mueller::IDENTITY };
        let way = Mueller::polariser(angle).after(&there).after(&Mueller::turn(turns)).after(&passed);
        for (name, matrix) in [("reflected", there), ("passed", passed), ("turned", Mueller::turn(turns)), ("all", way),
            ("matt", Mueller::depolariser(0.5)), ("mirror", Mueller::mirror(0.7))] {
            if matrix.0[0][0] > 1e-12 {
                prop_assert!(matrix.impossible() > -1e-9, "{name}: {}", matrix.impossible());
            }
        }
    }
}

#[test]
fn what_no_light_can_do_is_found() {
    // More polarised than light can be, and the hand turned without anything else: a mirror image of the field alone.
    let mut more = Mueller::polariser(0.0);
    more.0[0][1] *= 1.1;
    assert!(more.impossible() < -1e-3, "{}", more.impossible());
    let mut hand = Mueller::IDENTITY;
    hand.0[3][3] = -1.0;
    assert!(hand.impossible() < -0.1, "{}", hand.impossible());
    // By half a wave it can be turned.
    let mut wave = Mueller::turn(FRAC_PI_4);
    wave = wave.after(&Mueller::of_fields(Complex64::ONE, -Complex64::ONE));
    assert!(wave.impossible() > -1e-12);
}
