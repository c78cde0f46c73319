//! The second route of the chapter: the three waves at the interface as full vectors, E and H = k × E, from which
//! boundary conditions and energy flow are read off. It shares the normal wave number with the formulas under test,
//! and none of their algebra.

use light::Complex64;
use light::Polarisation;
use light::optics::Incidence;
use light::optics::fresnel::Amplitudes;
use light::optics::incidence::{normal_squared, outgoing_root};

/// A complex vector; z points along the normal into the second medium, the plane of incidence is y = 0.
pub type Vector = [Complex64; 3];

/// A wave's fields at the interface: E in units of the incident amplitude, H times the vacuum impedance.
#[derive(Clone, Copy, Debug)]
pub struct Wave {
    /// Electric field [1].
    pub e: Vector,
    /// Magnetic field times Z₀ [1].
    pub h: Vector,
}

impl Wave {
    /// The fields of both together.
    pub fn plus(&self, other: &Self) -> Self {
        let sum = |a: Vector, b: Vector| [0, 1, 2].map(|axis| a[axis] + b[axis]);
        Self { e: sum(self.e, other.e), h: sum(self.h, other.h) }
    }
}

/// Incident, reflected and transmitted wave for the amplitude ratios `a`.
pub fn waves(polarisation: Polarisation, incidence: Incidence, n_i: f64, n_t: Complex64, a: &Amplitudes) -> [Wave; 3] {
    let (sin, cos) = (Complex64::from(incidence.sin()), Complex64::from(incidence.cos()));
    let q_t = outgoing_root(normal_squared(incidence, n_i, n_t));
    let (sin_t, cos_t) = (n_i * sin / n_t, q_t / n_t);
    let n_i = Complex64::from(n_i);
    let one = Complex64::from(1.0);
    match polarisation {
        Polarisation::S => [
            wave([sin, cos], n_i, across(one)),
            wave([sin, -cos], n_i, across(a.r_s)),
            wave([sin_t, cos_t], n_t, across(a.t_s)),
        ],
        Polarisation::P => [
            wave([sin, cos], n_i, [cos, 0.0.into(), -sin]),
            wave([sin, -cos], n_i, [-cos * a.r_p, 0.0.into(), -sin * a.r_p]),
            wave([sin_t, cos_t], n_t, [cos_t * a.t_p, 0.0.into(), -sin_t * a.t_p]),
        ],
    }
}

/// The wave with unit wave vector (x, 0, z) in the medium `n` and the electric field `e`.
fn wave([x, z]: [Complex64; 2], n: Complex64, e: Vector) -> Wave {
    Wave { e, h: cross([n * x, 0.0.into(), n * z], e) }
}

fn across(y: Complex64) -> Vector {
    [0.0.into(), y, 0.0.into()]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Mean energy flow along the normal, Re(E × H*)_z [in units that cancel].
pub fn flow(wave: &Wave) -> f64 {
    cross(wave.e, wave.h.map(|h| h.conj()))[2].re
}

/// Largest step of the tangential E and H across the interface [1]: what E4 says is zero.
pub fn tangential_step([incident, reflected, transmitted]: &[Wave; 3]) -> f64 {
    let steps = [0, 1].into_iter().flat_map(|axis| {
        let e = incident.e[axis] + reflected.e[axis] - transmitted.e[axis];
        let h = incident.h[axis] + reflected.h[axis] - transmitted.h[axis];
        // H is as large as the index; its step counts relative to the fields that meet.
        let scale = 1.0 + incident.h[axis].norm() + transmitted.h[axis].norm();
        [e.norm(), h.norm() / scale]
    });
    // |NaN| sorts above all numbers; a NaN with its sign set, as 0/0 gives on some machines, would sort below them.
    steps.map(f64::abs).fold(0.0, |worst: f64, step| if step.total_cmp(&worst).is_gt() { step } else { worst })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_that_is_not_a_number_breaks_continuity() {
        let zero: Vector = [Complex64::ZERO; 3];
        for broken in [f64::NAN, -f64::NAN] {
            let waves = [Wave { e: zero, h: zero }; 2];
            let third = Wave { e: [broken.into(), Complex64::ZERO, Complex64::ZERO], h: zero };
            assert!(tangential_step(&[waves[0], waves[1], third]).is_nan());
        }
    }
}
