//! What one and two films do to the reflection of a lens, over the visible spectrum.

use light::Complex64;
use light::Polarisation;
use light::media::named;
use light::optics::film::{Layer, Stack};
use light::optics::{Incidence, fresnel};

/// The wavelength [m] that the films are a quarter of.
const DESIGN: f64 = 550e-9;

fn main() {
    println!("wavelength    bare glass    MgF₂    MgF₂ on sapphire");
    for nanometres in (400..=700).step_by(25) {
        let wavelength = f64::from(nanometres) * 1e-9;
        let index = |name: &str, wavelength: f64| {
            let material = named(name).unwrap_or_else(|| panic!("no material {name}"));
            material.index(wavelength).unwrap_or_else(|out| panic!("{out}"))
        };
        let quarter =
            |name: &str| Layer { index: index(name, wavelength), thickness: DESIGN / 4.0 / index(name, DESIGN).re };
        let glass: Complex64 = index("bk7", wavelength);
        let bare = fresnel::powers(Incidence::NORMAL, 1.0, glass).r_n();
        let coated = |layers: &[Layer]| {
            let stack = Stack { n_i: 1.0, layers, substrate: glass };
            stack.response(wavelength, Incidence::NORMAL, Polarisation::S).reflectance
        };
        let (one, two) = (coated(&[quarter("mgf2")]), coated(&[quarter("mgf2"), quarter("sapphire")]));
        println!("{nanometres:>7} nm    {:>8.2} %    {:>5.2} %    {:>14.2} %", 100.0 * bare, 100.0 * one, 100.0 * two);
    }
}
