use crate::media::named;
use crate::optics::schlick::normal_reflectance;
use crate::waves::constants::C;
use std::f64::consts::TAU;

#[test]
fn skin_depths_are_the_published_ones() {
    // Copper at 50 Hz and 1 GHz (Pozar, Microwave Engineering, example 1.2, scaled to 58 MS/m), sea water at 10 kHz.
    for (name, frequency, depth) in [("copper", 50.0, 9.35e-3), ("copper", 1e9, 2.09e-6), ("sea-water", 1e4, 2.30)] {
        let found = named(name).unwrap().wave(frequency).unwrap().skin_depth;
        assert!((found / depth - 1.0).abs() < 3e-3, "{name} {frequency}: {found}");
    }
}

#[test]
fn light_takes_over_where_circuits_end() {
    let frequency = C / 550e-9;
    for name in ["copper", "silver", "gold", "aluminium", "silicon", "water", "glass", "fused-silica", "air"] {
        let substance = named(name).unwrap();
        let index = substance.index(550e-9).unwrap();
        let found = substance.wave(frequency).unwrap().index();
        assert!((found / index - 1.0).norm() < 1e-14, "{name} {found} {index}");
    }
    // A metal's reflectance follows from its impedance as from its index: (Z − Z₀)/(Z + Z₀).
    let silver = named("silver").unwrap().wave(frequency).unwrap();
    let z = silver.impedance / crate::waves::constants::Z_0;
    let reflected = ((z - 1.0) / (z + 1.0)).norm_sqr();
    assert!((reflected / normal_reflectance(1.0, silver.index()) - 1.0).abs() < 1e-12);
}

#[test]
fn frequencies_in_between_are_refused_by_name() {
    let copper = named("copper").unwrap();
    for frequency in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e13, 1e17] {
        let message = copper.wave(frequency).unwrap_err().to_string();
        assert!(message.starts_with("copper at") && message.contains("5e11 Hz, its refractive index"), "{message}");
    }
    for frequency in [0.0, -1.0, f64::NAN, f64::INFINITY, f64::MAX] {
        assert!(named("vacuum").unwrap().wave(frequency).is_err());
    }
    assert!(named("vacuum").unwrap().wave(1e300).is_ok());
}

#[test]
fn a_constant_tangent_makes_the_loss_a_share_of_a_cycle() {
    let glass = named("glass").unwrap();
    for frequency in [1e5, 1e6, 1e7] {
        let tangent = glass.medium(frequency).unwrap().loss_tangent(TAU * frequency);
        assert!((tangent / 0.0037 - 1.0).abs() < 1e-14);
    }
}

#[test]
fn what_is_not_known_is_told_with_what_is() {
    let message = |name, frequency| named(name).unwrap().wave(frequency).unwrap_err().to_string();
    assert_eq!(
        message("diamond", 1e9),
        "diamond at 1e9 Hz: its ε, μ, σ are not known here, its refractive index from 3.945e14 Hz to 1.327e15 Hz"
    );
    assert!(message("iron", 1e9).ends_with("hold from 0e0 Hz to 1e3 Hz"));
    // Light is enough where light is asked for.
    let diamond = named("diamond").unwrap();
    assert!((diamond.wave(C / 550e-9).unwrap().index() / diamond.index(550e-9).unwrap() - 1.0).norm() < 1e-14);
}
