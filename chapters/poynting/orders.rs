//! C4: how short, how fast, how often.

use crate::setting::{FREQUENCY, MEDIUM, Parameter};
use crate::vocabulary::{Bound, Check, Measured, Step};
use light::waves::constants::C;
use light::waves::{Medium, Wave};
use std::f64::consts::TAU;

pub(super) const STEP: Step = Step {
    id: "orders",
    title: "How short, how fast, how often",
    says: "Visible light is half a micrometre long and swings half a million times in a billionth of a second.",
    rows: &["C4"],
    parameters: &[Parameter { default: "vacuum", ..MEDIUM }, Parameter { default: "545THz", ..FREQUENCY }],
    statements: &[],
    derivations: &[],
    readout: Some(|setting| {
        let wave = crate::plane_wave::wave(setting);
        vec![
            super::quantity("wavelength", "λ", "wavelength in the medium", wave.wavelength, "m"),
            super::quantity("frequency", "f", "frequency", wave.frequency(), "Hz"),
            super::quantity("omega", "ω", "angular frequency, 2πf", wave.omega, "rad/s"),
            super::quantity("period", "T", "period", 1.0 / wave.frequency(), "s"),
            super::quantity("per_exposure", "N", "periods in an exposure of 10 ms", 0.01 * wave.frequency(), "1"),
        ]
    }),
    checks: &[LASERS, VISIBLE],
    stress: &[],
    races: &[],
    figures: &[],
};

const LASERS: Check = Check {
    id: "lasers",
    claim: "the frequencies of standard lasers have the wavelengths that the metre was realised with",
    rows: &["C4"],
    route: "BIPM, Mise en pratique for the definition of the metre: both were measured, the one by counting, the other by fringes",
    bound: Bound::AtMost { limit: 5e-11, unit: "1", why: "wavelengths printed to eleven digits, frequencies to more" },
    measure: |_| lasers(TAU),
    spoiled: |_| lasers(1.0),
    slip: "f taken for ω",
};

fn lasers(radians: f64) -> Measured {
    // Iodine-stabilised helium–neon at 633 nm and frequency-doubled Nd:YAG at 532 nm.
    let lines = [("He–Ne", 473.612_353_604e12, 632.991_212_58e-9), ("Nd:YAG", 563.260_223_513e12, 532.245_036_104e-9)];
    Measured::worst(lines.map(|(name, frequency, wavelength)| {
        let wave = Wave::new(&Medium::VACUUM, radians * frequency).expect("a positive frequency");
        (wave.wavelength / wavelength - 1.0, name.to_owned())
    }))
}

/// The notes' powers of ten hold as the nearest ones, and for f alone: ω is 3.4e15 rad/s.
const VISIBLE: Check = Check {
    id: "visible",
    claim: "from 780 nm to 380 nm light swings 3.8e14 to 7.9e14 times a second; λ, c and f are 1e−7 m, 1e8 m/s, 1e15 Hz to the nearest power of ten or the one below",
    rows: &["C4"],
    route: "ISO 20473: visible radiation is 380 nm to 780 nm, 789 THz to 384 THz",
    bound: Bound::AtMost { limit: 1.5e-3, unit: "1", why: "the standard prints three digits" },
    measure: |_| visible(|wave| wave.frequency()),
    spoiled: |_| visible(|wave| wave.omega),
    slip: "ω for f",
};

fn visible(frequency: fn(&Wave) -> f64) -> Measured {
    let ends = [(780e-9, 384e12), (380e-9, 789e12)];
    let ends = ends.map(|(wavelength, printed)| {
        let wave = Wave::new(&Medium::VACUUM, TAU * C / wavelength).expect("a positive frequency");
        (frequency(&wave) / printed - 1.0, format!("{wavelength:e} m"))
    });
    // A power of ten is the notes' if it is no farther than one from log₁₀; beyond that the case counts as a whole miss.
    let green = Wave::new(&Medium::VACUUM, TAU * C / 550e-9).expect("a positive frequency");
    let orders = [("λ", green.wavelength, -7.0), ("c", green.v_phase, 8.0), ("f", frequency(&green), 15.0)];
    let orders = orders.map(|(name, value, power): (_, f64, f64)| {
        let miss = if (value.log10() - power).abs() < 1.0 { 0.0 } else { 1.0 };
        (miss, format!("{name} to the nearest power of ten"))
    });
    Measured::worst(ends.into_iter().chain(orders))
}
