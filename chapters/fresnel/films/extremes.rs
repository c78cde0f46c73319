//! Films that break other forms: opaque, critical, many.

use super::checks::quarter_wave_mirror;
use super::{Films, film};
use crate::parameter::DEFAULT_WAVELENGTH;
use crate::vocabulary::Extreme;
use light::Polarisation;
use light::optics::film::textbook::{characteristic_matrix, recursion};
use light::optics::film::{Layer, Powers, Stack};
use light::optics::{Direction, Incidence};
use light::references::film::{condition, reference};
use std::f64::consts::{FRAC_PI_3, FRAC_PI_4};
use yardstick::precise::{self};

/// The powers that a textbook form gives.
type TextbookForm = fn(&Stack, f64, Incidence, Polarisation) -> Powers;

/// Which number of a stack is looked at.
#[derive(Clone, Copy, Debug)]
enum Output {
    Reflectance,
    Transmittance,
    LnTransmittance,
    Absorptance,
}

/// One number of a stack at 550 nm beside its reference and a textbook form.
fn extreme(
    input: &str,
    films: &Films,
    angle: Direction,
    polarisation: Polarisation,
    output: Output,
    form: TextbookForm,
) -> Extreme {
    let stack = films.stack();
    let exact = reference(&stack, DEFAULT_WAVELENGTH, angle, polarisation);
    let kappa = condition(&stack, DEFAULT_WAVELENGTH, angle, polarisation);
    let ours = stack.response(DEFAULT_WAVELENGTH, Incidence::from(angle), polarisation);
    let book = form(&stack, DEFAULT_WAVELENGTH, Incidence::from(angle), polarisation);
    let (quantity, reference, textbook, ours, condition) = match output {
        Output::Reflectance => ("R", exact.reflectance, book.reflectance, ours.reflectance, kappa.reflectance),
        Output::Transmittance => {
            ("T", exact.transmittance, book.transmittance, ours.transmittance, kappa.transmittance)
        }
        Output::Absorptance => ("A", exact.absorptance, book.absorptance, ours.absorptance, kappa.absorptance),
        Output::LnTransmittance => (
            "ln T",
            exact.ln_transmittance.unwrap_or(precise::real(0.0)),
            book.transmittance.ln(),
            ours.ln_transmittance,
            kappa.ln_transmittance,
        ),
    };
    Extreme {
        input: format!("{input}, {}", if polarisation == Polarisation::S { "s" } else { "p" }),
        quantity,
        reference,
        textbook,
        ours,
        condition,
        worst_of: 1,
    }
}

/// A film between `n_i` and a substrate.
pub(super) fn between(n_i: f64, layer: Layer, substrate: f64) -> Films {
    Films { n_i, layers: vec![layer], substrate: substrate.into() }
}

pub(super) fn opaque() -> Vec<Extreme> {
    let silver = |thickness| between(1.0, film(0.055, 3.32, thickness), 1.52);
    let dense = |thickness| between(1.0, film(3.0, 1e3, thickness), 1.52);
    let case = |name: &str, films: Films, theta, output| {
        extreme(name, &films, Direction::Angle(theta), Polarisation::P, output, characteristic_matrix)
    };
    vec![
        case("silver, 1 µm, θ = 45°", silver(1e-6), FRAC_PI_4, Output::Transmittance),
        case("silver, 8.9 µm, θ = 45°", silver(8.9e-6), FRAC_PI_4, Output::Transmittance),
        case("silver, 20 µm, θ = 45°", silver(20e-6), FRAC_PI_4, Output::LnTransmittance),
        case("silver, 1 mm, θ = 45°", silver(1e-3), FRAC_PI_4, Output::LnTransmittance),
        case("silver, 1 mm, θ = 45°", silver(1e-3), FRAC_PI_4, Output::Reflectance),
        case("n = 3 + 1000i, 100 nm, θ = 1.5", dense(1e-7), 1.5, Output::LnTransmittance),
        case("n = 3 + 1000i, 1 m, θ = 0", dense(1.0), 0.0, Output::LnTransmittance),
    ]
}

pub(super) fn critical() -> Vec<Extreme> {
    let gap = |thickness| between(1.5, film(1.0, 0.0, thickness), 1.5);
    let own = |thickness| between(1.0, film(1.0, 0.0, thickness), 1.5);
    let edge = (1.0f64 / 1.5).asin();
    let case = |name: &str, films: Films, angle, polarisation, output| {
        extreme(name, &films, angle, polarisation, output, recursion)
    };
    let mut cases = vec![
        case(
            "air gap of 100 µm, θ = 60°",
            gap(1e-4),
            Direction::Angle(FRAC_PI_3),
            Polarisation::S,
            Output::LnTransmittance,
        ),
        case("air gap of 1 pm, θ = 60°", gap(1e-12), Direction::Angle(FRAC_PI_3), Polarisation::P, Output::Reflectance),
        case(
            "film on glass, 1e−12 from grazing",
            own(1e-7),
            Direction::Grazing(1e-12),
            Polarisation::S,
            Output::Transmittance,
        ),
        case(
            "film on glass, 1e−18 from grazing",
            own(1e-7),
            Direction::Grazing(1e-18),
            Polarisation::P,
            Output::Transmittance,
        ),
    ];
    for (offset, name) in [(0.0, "at"), (1e-12, "1e−12 beyond"), (-1e-12, "1e−12 below")] {
        for (polarisation, thickness) in [(Polarisation::S, 1e-7), (Polarisation::P, 1e-7)] {
            let name = format!("air gap of 100 nm, {name} its critical angle");
            let angle = Direction::Angle(edge + offset);
            cases.push(case(&name, gap(thickness), angle, polarisation, Output::Reflectance));
        }
    }
    cases
}

/// Slices that a film is cut into. Each of them rounds, and the roundings must not add up.
const SLICES: usize = 1 << 12;

pub(super) fn many() -> Vec<Extreme> {
    let mut tinted = quarter_wave_mirror(1000, 3.5, 1.38);
    for layer in &mut tinted.layers {
        layer.index.im = 1e-6;
    }
    let gaps =
        (0..1000).map(|at| film(if at % 2 == 0 { 1.0 } else { 1.5 }, 0.0, if at % 2 == 0 { 1e-6 } else { 1e-7 }));
    let gaps = Films { n_i: 1.5, layers: gaps.collect(), substrate: 1.5.into() };
    let case = |name: &str, films: &Films, theta, output| {
        extreme(name, films, Direction::Angle(theta), Polarisation::S, output, characteristic_matrix)
    };
    let slices = vec![film(2.0, 0.1, 64e-9 / SLICES as f64); SLICES];
    let slices = Films { n_i: 1.0, layers: slices, substrate: 1.52.into() };
    let sliced = format!("one film of 64 nm, n = 2 + 0.1i, in {SLICES} slices");
    vec![
        case(&sliced, &slices, 0.8, Output::Absorptance),
        case(&sliced, &slices, 0.8, Output::Transmittance),
        case("1000 quarter waves of 3.5 and 1.38, κ = 1e−6", &tinted, 0.0, Output::Reflectance),
        case("500 air gaps of 1 µm between films of glass, θ = 60°", &gaps, FRAC_PI_3, Output::LnTransmittance),
    ]
}
