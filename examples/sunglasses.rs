//! How much of the glare off a wet road a polarising filter takes away, by the height of the sun.

use light::Complex64;
use light::media;
use light::optics::{Incidence, fresnel};

fn main() {
    let water = media::named("water").and_then(|water| water.index(550e-9).ok()).unwrap_or(Complex64::from(1.33));
    println!("sun above the horizon    glare    through the filter");
    for height in (5..=85).step_by(10).map(f64::from) {
        let incidence = Incidence::from_angle((90.0 - height).to_radians());
        let powers = fresnel::powers(incidence, 1.0, water);
        // An ideal filter lets the vertical (p) half through.
        println!("{height:>14}°    {:>12.2} %    {:>12.2} %", 100.0 * powers.r_n(), 50.0 * powers.r_p);
    }
    let brewster = fresnel::brewster_angle(1.0, water.re).to_degrees();
    println!("nothing is left at {:.1}°: Brewster's angle", 90.0 - brewster);
}
