//! E11: the speed of light, from two constants of electricity.

use crate::symbols::{C, EPSILON_0, MU_0};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Question, Step, check, exhibit, question, statement,
    step,
};
use equation::Equation;
use equation::expr::sqrt;
use light::waves::constants;
use light::waves::{Medium, Wave};
use std::f64::consts::PI;

pub(super) const EXHIBIT: Exhibit = exhibit("speed", &[], &[]);

pub(super) const STEP: Step =
    step(EXHIBIT, "The speed is that of light", "A capacitor and a coil tell how fast the wave runs, and it is light.")
        .rows(&["E11"])
        .statements(&[statement("speed_of_light", "the speed of the waves in the vacuum", || {
            Equation::new(C, 1 / sqrt(EPSILON_0 * MU_0))
        })])
        .questions(&[FOURFOLD])
        .readout(|_| {
            vec![
                Quantity {
                    key: "c",
                    symbol: "c",
                    says: "speed of light, exact by the definition of the metre",
                    value: constants::C,
                    unit: "m/s",
                },
                Quantity {
                    key: "epsilon_0",
                    symbol: "ε_0",
                    says: "permittivity of the vacuum",
                    value: constants::EPSILON_0,
                    unit: "F/m",
                },
                Quantity {
                    key: "mu_0",
                    symbol: "μ_0",
                    says: "permeability of the vacuum, measured",
                    value: constants::MU_0,
                    unit: "H/m",
                },
                Quantity {
                    key: "c_notes",
                    symbol: "1/√(ε₀μ₀), rounded",
                    says: "from the lecture's constants, 8.8542e−12 F/m and 4πe−7 H/m",
                    value: rounded_constants(),
                    unit: "m/s",
                },
            ]
        })
        .checks(&[&MEASURED, &ROUNDED]);

const FOURFOLD: Question = question(
    "fourfold",
    "In a medium with four times the permittivity of the vacuum, ε = 4ε₀ and μ = μ₀, how fast do waves run, over \
     their speed in the vacuum?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let medium = Medium::relative(4.0, 1.0, 0.0).expect("a clear medium");
            Wave::new(&medium, constants::C).expect("a positive frequency").v_phase / constants::C
        },
        slips: &[
            Misled { value: |_| 0.25, reply: "The root is forgotten, as in the line that the notes print." },
            Misled {
                value: |_| 2.0,
                reply: "A stiffer spring makes a wave faster; ε says how *easily* charges give \
             way.",
            },
            Misled { value: |_| 1.0, reply: "c is the speed in the vacuum; elsewhere ε and μ are other numbers." },
        ],
    },
    "One half: v is 1/√(εμ). In the vacuum the same line, with a capacitor and a coil in it, gives the speed of \
     light.",
);

/// 1/√(ε₀μ₀) [m/s] with the five digits of ε₀ that the notes print.
fn rounded_constants() -> f64 {
    1.0 / (8.8542e-12 * 4.0 * PI * 1e-7_f64).sqrt()
}

/// Rosa and Dorsey weighed charges on a condenser against currents in a coil and found 1/√(ε₀μ₀) without any light.
/// What they print goes with the root of their unit of resistance.
const MEASURED: Check<fn(f64, f64) -> f64> =
    check("weighed_and_timed", "charges on a condenser and currents in a coil give the speed that light is timed at")
        .against(
            "Rosa & Dorsey, Bull. Bur. Stand. 3 (1907) 433: 299 710(30) km/s, in ohms of 1.000495 Ω (NBS Circular 459)",
        )
        .within(1e-4, "1", "the uncertainty that they state, 30 km/s")
        .of(weighed, |epsilon_0, mu_0| 1.0 / (epsilon_0 * mu_0).sqrt())
        .slip("no root, as the notes print it", |epsilon_0, mu_0| 1.0 / (epsilon_0 * mu_0));

fn weighed(_: &mut Bench, speed: fn(f64, f64) -> f64) -> Measured {
    let found = speed(constants::EPSILON_0, constants::MU_0);
    let exact = ("exact", 299_792_458.0);
    let weighed = ("Rosa & Dorsey 1907", 2.9971e8 * 1.000_495_f64.sqrt());
    Measured::worst([exact, weighed].map(|(who, speed)| (found / speed - 1.0, who.to_owned())))
}

const ROUNDED: Check<f64> =
    check("notes_constants", "with the lecture's rounded constants the speed is 2.9979225176e8 m/s")
        .against("long-hand arithmetic: 4π · 8.8542 = 111.265158…, and its root")
        .within(2e-11, "1", "half a unit in the last of the eleven digits given")
        .of(against_notes, 2.997_922_517_6e8)
        .slip("2.99794e8, as the notes print it", 2.997_94e8);

fn against_notes(_: &mut Bench, printed: f64) -> Measured {
    Measured::worst([(rounded_constants() / printed - 1.0, "8.8542e-12 F/m".to_owned())])
}
