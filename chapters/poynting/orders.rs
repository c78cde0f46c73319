//! C4: how short, how fast, how often.

use crate::plane_wave::{GREEN, VACUUM, quantity, wave};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Question, Step, check, exhibit, question, step,
};
use light::waves::constants::C;
use light::waves::{Medium, Wave};
use std::f64::consts::TAU;

pub(super) const EXHIBIT: Exhibit = exhibit("orders", &[VACUUM, GREEN], &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "How short, how fast, how often",
    "Visible light is half a micrometre long and swings half a million times in a \
     billionth of a second.",
)
.rows(&["C4"])
.questions(&[SWINGS])
.readout(|setting| {
    let wave = wave(setting);
    vec![
        quantity("wavelength", "λ", "wavelength in the medium", wave.wavelength, "m"),
        quantity("frequency", "f", "frequency", wave.frequency(), "Hz"),
        quantity("omega", "ω", "angular frequency, 2πf", wave.omega, "rad/s"),
        quantity("period", "T", "period", 1.0 / wave.frequency(), "s"),
        quantity("per_exposure", "N", "periods in an exposure of 10 ms", 0.01 * wave.frequency(), "1"),
    ]
})
.checks(&[&LASER, &VISIBLE]);

const SWINGS: Question = question(
    "swings",
    "How many times does green light, of 550 nm, swing in a billionth of a second?",
    Answer::Number {
        unit: "1",
        tolerance: 0.1,
        right: |_| 1e-9 * green().frequency(),
        slips: &[
            Misled {
                value: |_| 1e6,
                reply: "From 1e15 Hz, as the notes have it: right as a power of ten, and twice too much as a \
                 number.",
            },
            Misled { value: |_| 1e-9 * green().omega, reply: "These are radians. A swing has 2π of them." },
        ],
    },
    "Half a million. No eye and no photodiode follows that: what they read is a mean over very many swings.",
);

fn green() -> Wave {
    Wave::new(&Medium::VACUUM, TAU * C / 550e-9).expect("a positive frequency")
}

const LASER: Check<f64> = check(
    "laser",
    "a laser whose frequency was counted has the wavelength that was measured by \
     fringes",
)
.against(
    "Evenson et al., Phys. Rev. Lett. 29 (1972) 1346: 88.376 181 627(50) THz and 3.392 \
     231 376(12) μm, methane",
)
.within(
    1.1e-8,
    "1",
    "three times their uncertainty, 3.5e−9, most of it that of the krypton metre of \
     the day",
)
.of(laser, TAU)
.slip("f taken for ω", 1.0);

fn laser(_: &mut Bench, radians: f64) -> Measured {
    let wave = Wave::new(&Medium::VACUUM, radians * 88.376_181_627e12).expect("a positive frequency");
    Measured::worst([(wave.wavelength / 3.392_231_376e-6 - 1.0, "methane".to_owned())])
}

/// The notes' powers of ten hold within a factor of ten, and for f, not ω: that is 3.4e15 rad/s.
const VISIBLE: Check<fn(&Wave) -> f64> = check(
    "visible",
    "from 780 nm to 380 nm light swings 3.8e14 to 7.9e14 times a second; λ, c and f \
     are within a factor of ten of 1e−7 m, 1e8 m/s, 1e15 Hz",
)
.against("division by hand: 2.998/0.380 = 7.889 and 2.998/0.780 = 3.844")
.within(1.5e-4, "1", "half a unit in the last of four digits")
.of(visible, |wave| wave.frequency())
.slip("ω for f", |wave| wave.omega);

fn visible(_: &mut Bench, frequency: fn(&Wave) -> f64) -> Measured {
    let ends = [(780e-9, 384.4e12), (380e-9, 788.9e12)];
    let ends = ends.map(|(wavelength, printed)| {
        let wave = Wave::new(&Medium::VACUUM, TAU * C / wavelength).expect("a positive frequency");
        (frequency(&wave) / printed - 1.0, format!("{wavelength:e} m"))
    });
    // Farther than a factor of ten counts as a whole miss.
    let green = Wave::new(&Medium::VACUUM, TAU * C / 550e-9).expect("a positive frequency");
    let orders = [("λ", green.wavelength, -7.0), ("c", green.v_phase, 8.0), ("f", frequency(&green), 15.0)];
    let orders = orders.map(|(name, value, power): (_, f64, f64)| {
        let miss = if (value.log10() - power).abs() < 1.0 { 0.0 } else { 1.0 };
        (miss, format!("{name} beside its power of ten"))
    });
    Measured::worst(ends.into_iter().chain(orders))
}
