//! A wave in perspective: E upright, B across, the propagation to the right and back.

use crate::figure::{Axis, Chart, Dash, Hue, Mark};
use light::Complex64;
use light::waves::Wave;
use std::f64::consts::TAU;

/// How many wavelengths are shown of a wave that does not decay.
pub const LONGEST: f64 = 1.75;

/// How many wavelengths show what the wave does: not quite two, or five skin depths if that is less.
pub fn span(wave: &Wave) -> f64 {
    (5.0 * wave.k.re / (wave.k.im * TAU)).min(LONGEST)
}

/// Where x (E), y (B) and z (the propagation) go on paper: E up, B towards the reader and to the left, z to the right
/// and a little up. Amplitudes and the whole way are 1.
const PAPER: [[f64; 2]; 3] = [[0.0, 0.72], [-0.34, -0.42], [2.2, 0.5]];

/// E (blue) and B (red), each over its amplitude at z = 0, as far as [`span`] says, `turn` = ωt [rad] after the start.
pub fn travelling(title: String, wave: &Wave, turn: f64) -> Chart {
    // By wavelengths, so that no scale can overflow: decay per wavelength and the lag are all that shapes the picture.
    let (decay, lag, far) = (wave.k.im / wave.k.re, wave.phase_lag, span(wave));
    let amplitude = |z: f64| (Complex64::new(-decay, 1.0) * (TAU * z)).exp();
    let e = move |z: f64| (amplitude(z) * Complex64::cis(-turn)).re;
    // H = E/Z lags by the angle of k.
    let h = move |z: f64| (amplitude(z) * Complex64::cis(lag - turn)).re;
    let steps = 400;
    let curve = |point: &dyn Fn(f64) -> [f64; 2]| -> Vec<[f64; 2]> {
        (0..=steps).map(|at| point(far * f64::from(at) / f64::from(steps))).collect()
    };
    let electric = |z: f64| paper(e(z), 0.0, z / far);
    let magnetic = |z: f64| paper(0.0, h(z), z / far);
    let thin = |hue, points| Mark::Line { label: String::new(), hue, dash: Dash::Dotted, points };
    Chart::new(title, Axis::bare(-0.5, 2.65), Axis::bare(-0.8, 1.35))
        .line(Hue::Reference, "", vec![paper(0.0, 0.0, -0.06), paper(0.0, 0.0, END)])
        .line(Hue::Reference, "", head())
        .with(thin(Hue::P, stems(far, &magnetic)))
        .line(Hue::P, "", curve(&magnetic))
        .with(thin(Hue::S, stems(far, &electric)))
        .line(Hue::S, "", curve(&electric))
}

/// Where E = `x` and B = `y`, over their amplitudes, stand at the share `z` of the way.
fn paper(x: f64, y: f64, z: f64) -> [f64; 2] {
    [0, 1].map(|axis| PAPER[0][axis] * x + PAPER[1][axis] * y + PAPER[2][axis] * z)
}

/// Arrows from the axis to a curve that is `far` wavelengths long, as one broken line.
fn stems(far: f64, tip: &dyn Fn(f64) -> [f64; 2]) -> Vec<[f64; 2]> {
    let count = 21;
    let stem = |at: u32| {
        let share = f64::from(at) / f64::from(count);
        [paper(0.0, 0.0, share), tip(share * far), [f64::NAN, f64::NAN]]
    };
    (0..=count).flat_map(stem).collect()
}

/// Share of the way at which the axis ends.
const END: f64 = 1.08;

/// The head of the axis.
fn head() -> Vec<[f64; 2]> {
    let ([x, y], [tip_x, tip_y]) = (paper(0.0, 0.0, END - 0.03), paper(0.0, 0.0, END));
    let (along, up) = (tip_x - x, tip_y - y);
    vec![[x - 0.4 * up, y + 0.7 * along], [tip_x, tip_y], [x + 0.6 * up, y - 0.6 * along]]
}
