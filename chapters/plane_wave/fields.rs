//! Fields in numbers: plane waves in any direction, the field of a dipole, and differences and integrals of fields
//! that know nothing of waves.

use glam::DVec3;
use light::Complex64;
use light::waves::{Medium, Wave};
use std::f64::consts::TAU;
use yardstick::quadrature::{gauss, gauss_legendre};
use yardstick::random::{Stream, uniform};

/// A field of arrows over place [m] and time [s].
pub type Field<'a> = &'a dyn Fn(DVec3, f64) -> DVec3;

/// A plane wave of a clear medium, polarised in one direction.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// Wave vector [rad/m].
    pub k: DVec3,
    /// Angular frequency [rad/s].
    pub omega: f64,
    /// Phase at the origin at time 0 [rad].
    pub phase: f64,
    /// Amplitude of E [V/m].
    pub e: DVec3,
    /// Amplitude of B [T].
    pub b: DVec3,
}

impl Plane {
    /// The wave of frequency `omega` in `medium` that runs along the unit vector `direction`, its field of amplitude 1
    /// along that part of `polarisation` that stands across.
    ///
    /// # Panics
    /// If `omega` is not positive.
    pub fn new(medium: &Medium, omega: f64, direction: DVec3, polarisation: DVec3, phase: f64) -> Self {
        let wave = Wave::new(medium, omega).expect("a positive frequency");
        let e = polarisation.reject_from(direction).normalize();
        let b = direction.cross(e) * (medium.mu() / wave.impedance.re);
        Self { k: direction * wave.k.re, omega, phase, e, b }
    }

    /// E [V/m] and B [T].
    pub fn at(&self, place: DVec3, time: f64) -> (DVec3, DVec3) {
        let cos = (self.k.dot(place) - self.omega * time + self.phase).cos();
        (self.e * cos, self.b * cos)
    }
}

/// A direction drawn evenly from the sphere.
pub fn direction(stream: &mut Stream) -> DVec3 {
    let (z, turn) = (uniform(stream, -1.0, 1.0), uniform(stream, 0.0, TAU));
    let (sin, cos) = turn.sin_cos();
    DVec3::new((1.0 - z * z).sqrt() * cos, (1.0 - z * z).sqrt() * sin, z)
}

/// Waves of one frequency from everywhere, at random.
pub fn crowd(stream: &mut Stream, medium: &Medium, omega: f64, count: usize) -> Vec<Plane> {
    let mut one = || {
        let (run, swing, phase) = (direction(stream), direction(stream), uniform(stream, 0.0, TAU));
        Plane::new(medium, omega, run, swing, phase)
    };
    (0..count).map(|_| one()).collect()
}

/// A point dipole p cos ωt along z at the origin (Jackson, *Classical Electrodynamics* (3rd ed.), eq. 9.18): anything
/// but a plane wave. Lengths are in units of 1/k, and p/(4πε) is 1.
#[derive(Clone, Copy, Debug)]
pub struct Dipole {
    /// Speed v = 1/√(εμ); the frequency is v too.
    pub speed: f64,
}

impl Dipole {
    /// E, anywhere but at the origin.
    pub fn e(&self, place: DVec3, time: f64) -> DVec3 {
        let (r, n) = (place.length(), place.normalize());
        let far = n.cross(DVec3::Z).cross(n) / r;
        let near = 3.0 * n * n.z - DVec3::Z;
        let wave = self.outgoing(r, time);
        far * wave.re + near * (wave * Complex64::new(r.powi(-3), -r.powi(-2))).re
    }

    /// B, anywhere but at the origin.
    pub fn b(&self, place: DVec3, time: f64) -> DVec3 {
        let (r, n) = (place.length(), place.normalize());
        // 1 − 1/(ikr) = 1 + i/(kr)
        n.cross(DVec3::Z) * ((self.outgoing(r, time) * Complex64::new(1.0, 1.0 / r)).re / (r * self.speed))
    }

    fn outgoing(&self, r: f64, time: f64) -> Complex64 {
        Complex64::cis(r - self.speed * time)
    }
}

/// ∇×F by central differences of width 2h.
pub fn curl(field: Field, place: DVec3, time: f64, h: f64) -> DVec3 {
    let slope = |axis: DVec3| (field(place + h * axis, time) - field(place - h * axis, time)) / (2.0 * h);
    let (x, y, z) = (slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z));
    DVec3::new(y.z - z.y, z.x - x.z, x.y - y.x)
}

/// ∇²F by central differences of step h.
pub fn laplacian(field: Field, place: DVec3, time: f64, h: f64) -> DVec3 {
    let around = DVec3::AXES.map(|axis| field(place + h * axis, time) + field(place - h * axis, time));
    (around[0] + around[1] + around[2] - 6.0 * field(place, time)) / (h * h)
}

/// ∂F/∂t by a central difference of width 2h.
pub fn rate(field: Field, place: DVec3, time: f64, h: f64) -> DVec3 {
    (field(place, time + h) - field(place, time - h)) / (2.0 * h)
}

/// ∂²F/∂t² by a central difference of step h.
pub fn acceleration(field: Field, place: DVec3, time: f64, h: f64) -> DVec3 {
    (field(place, time + h) - 2.0 * field(place, time) + field(place, time - h)) / (h * h)
}

/// A parallelogram: a corner and two sides [m]; it faces along their cross product.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// Where both sides start.
    pub corner: DVec3,
    /// The sides.
    pub sides: [DVec3; 2],
}

/// Points of Gauss's rule along each line.
const NODES: usize = 14;

impl Patch {
    /// ∮ F·dl round the edge.
    pub fn circulation(&self, field: Field, time: f64) -> f64 {
        let [a, b] = self.sides;
        let edges = [(self.corner, a), (self.corner + a, b), (self.corner + a + b, -a), (self.corner + b, -b)];
        let rule = gauss_legendre(NODES);
        let along = |(start, side): (DVec3, DVec3)| -> f64 {
            rule.iter().map(|(at, weight)| weight * field(start + *at * side, time).dot(side)).sum()
        };
        edges.into_iter().map(along).sum()
    }

    /// ∫ F·n dA over it.
    pub fn flux(&self, field: Field, time: f64) -> f64 {
        let [a, b] = self.sides;
        let (face, rule) = (a.cross(b), gauss_legendre(NODES));
        let row = |(up, weight): &(f64, f64)| -> f64 {
            let cells = rule.iter().map(|(at, w)| w * field(self.corner + *at * a + *up * b, time).dot(face));
            weight * cells.sum::<f64>()
        };
        rule.iter().map(row).sum()
    }
}

/// The outward flux of F through the faces of the cube of side `side` at `corner`: both faces across x, y and z.
pub fn outflows(field: Field, corner: DVec3, side: f64, time: f64) -> [f64; 3] {
    let [x, y, z] = DVec3::AXES.map(|axis| axis * side);
    let through = |a: DVec3, b: DVec3, across: DVec3| {
        let far = Patch { corner: corner + across, sides: [a, b] };
        far.flux(field, time) - Patch { corner, ..far }.flux(field, time)
    };
    [through(y, z, x), through(z, x, y), through(x, y, z)]
}

/// ∫ g dt from `from` to `to`.
pub fn over_time(from: f64, to: f64, g: impl Fn(f64) -> f64) -> f64 {
    gauss(NODES, from, to, g)
}
