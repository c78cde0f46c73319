//! What lamps send, in arbitrary precision and by other routes than [`radiometry`](crate::radiometry): contour integrals,
//! and what textbooks print, in numbers wide enough not to mind what cancels; with condition numbers.

mod contours;
mod shares;

use contours::Source;
use yardstick::precise::{self, Real, real_at};

/// An output, exact for every purpose of `f64`.
#[derive(Clone, Debug)]
pub struct Exact {
    /// Its value.
    pub value: Real,
    /// Its condition number [1]: Σ |x ∂y/∂x|/|y| over the inputs x; 0 where nothing moves y, ∞ where y = 0 could move.
    pub condition: f64,
}

impl Exact {
    /// `f` of inputs that are exact.
    fn new(inputs: &[f64], f: impl Fn(&[Real]) -> Real) -> Self {
        let bits = bits(inputs);
        let inputs: Vec<Real> = inputs.iter().map(|&input| real_at(input, bits)).collect();
        let step = real_at(STEP, bits);
        let value = f(&inputs);
        let mut condition = 0.0;
        for at in (0..inputs.len()).filter(|&at| !is_zero(&inputs[at])) {
            let mut moved = inputs.clone();
            moved[at] = &moved[at] + &moved[at] * &step;
            let change = f(&moved) - &value;
            if !is_zero(&change) {
                condition +=
                    if is_zero(&value) { f64::INFINITY } else { precise::to_f64(&(change / &value)).abs() / STEP };
            }
        }
        Self { value, condition }
    }

    /// The error of `ours` in ulp · (1 + condition) [1].
    pub fn error_of(&self, ours: f64) -> f64 {
        precise::relative_error(ours, &self.value) / (f64::EPSILON * (1.0 + self.condition))
    }
}

/// Relative step of the difference quotients: far below `f64`, far above the rounding.
const STEP: f64 = 1e-40;

/// Enough for sums whose terms cancel to the fourth power of what the inputs' sizes differ by, and 256 more.
fn bits(inputs: &[f64]) -> usize {
    let sizes = inputs.iter().map(|input| input.abs()).filter(|&size| size > 0.0);
    let (least, most) = sizes.fold((1.0_f64, 1.0_f64), |(least, most), size| (least.min(size), most.max(size)));
    2 * precise::BITS + 4 * (most / least).log2().min(2000.0) as usize
}

fn is_zero(x: &Real) -> bool {
    x.repr().significand().is_zero()
}

/// E/L [sr] of the lamp [`Disc`](crate::radiometry::disc::Disc), by the contour integral along the arc above the horizon and
/// the chord that closes it.
pub fn disc(radius: f64, height: f64, offset: f64, tilt: f64) -> Exact {
    Exact::new(&[radius, height, offset, tilt], contours::disc)
}

/// E/L [sr] of the lamp [`Sphere`](crate::radiometry::sphere::Sphere), by its closed form (J. M. Snyder, *Area Light Sources
/// for Real-Time Graphics*, MSR-TR-96-11, 1996).
pub fn sphere(radius: f64, distance: f64, omega: f64) -> Exact {
    Exact::new(&[radius, distance, omega], contours::sphere)
}

/// E/L [sr] of a plane polygon above the horizon, by Lambert's sum as it stands.
pub fn polygon(corners: &[[f64; 3]], normal: [f64; 3]) -> Exact {
    let inputs: Vec<f64> = normal.iter().chain(corners.as_flattened()).copied().collect();
    Exact::new(&inputs, contours::polygon)
}

/// [`Corner`](crate::radiometry::rectangle::Corner): its two irradiances and its solid angle, as textbooks print them.
pub fn corner(a: f64, b: f64, h: f64) -> [Exact; 3] {
    [contours::corner_parallel as Source, contours::corner_perpendicular, contours::corner_solid_angle]
        .map(|source| Exact::new(&[a, b, h], source))
}

/// The solid angle [sr] of a triangle, without its sign, by its spherical excess.
pub fn triangle(corners: [[f64; 3]; 3]) -> Exact {
    Exact::new(corners.as_flattened(), contours::triangle)
}

/// The solid angle [sr] of a cone.
pub fn cone(alpha: f64) -> Exact {
    Exact::new(&[alpha], contours::cone)
}

/// The solid angle [sr] of a disc from its axis.
pub fn solid_angle_of_disc(radius: f64, distance: f64) -> Exact {
    Exact::new(&[radius, distance], contours::solid_angle_of_disc)
}

/// E [W m⁻²] of a point.
pub fn point(flux: f64, distance: f64, theta: f64) -> Exact {
    Exact::new(&[flux, distance, theta], contours::point)
}

/// The form factor [1] of equal rectangles that face each other (Howell C-11).
pub fn parallel_rectangles(a: f64, b: f64, c: f64) -> Exact {
    Exact::new(&[a, b, c], shares::parallel_rectangles)
}

/// The form factor [1] of rectangles at a right angle (Howell C-14).
pub fn perpendicular_rectangles(w: f64, h: f64, l: f64) -> Exact {
    Exact::new(&[w, h, l], shares::perpendicular_rectangles)
}

/// The form factor [1] of coaxial discs (Howell C-41).
pub fn coaxial_discs(r1: f64, r2: f64, h: f64) -> Exact {
    Exact::new(&[r1, r2, h], shares::coaxial_discs)
}
