//! How much the answer of a stack depends on each input, from the product of characteristic matrices in arbitrary
//! precision.

use super::{Scene, at, is_zero};
use crate::Polarisation;
use crate::optics::Direction;
use crate::optics::film::{Layer, Stack};
use num_complex::Complex64;
use yardstick::precise::{BITS, Complex, Real, from_real, real_at, to_f64};

/// Condition numbers [1]: Σ |∂ ln y/∂ ln x| over the inputs x — n, κ and thickness of each layer, n and κ of the
/// substrate, n_i, wavelength and angle — for y = R, T, A and ln T. Infinite where y = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// Of R.
    pub reflectance: f64,
    /// Of T.
    pub transmittance: f64,
    /// Of A.
    pub absorptance: f64,
    /// Of ln T.
    pub ln_transmittance: f64,
}

/// How the outputs of a stack depend on its inputs, from the product of characteristic matrices: the fields before
/// and behind a layer are kept, so that a change of that layer alone costs one matrix.
pub fn condition(stack: &Stack, wavelength: f64, direction: Direction, polarisation: Polarisation) -> Condition {
    let scene = Scene::new(stack, wavelength, direction, polarisation);
    let kinds: Vec<Matrices> = scene.kinds.iter().map(|layer| Matrices::new(&scene, layer)).collect();
    let y_s = scene.admittance(&scene.substrate, &scene.tangential);
    let y_i = from_real(scene.y_i.clone());
    let one = from_real(real_at(1.0, scene.bits));

    // Fields behind each layer, from the substrate up; then the row vectors (Y₀, ∓1) M₁ M₂ … before each layer.
    let mut fields = vec![(one.clone(), y_s.clone())];
    for &kind in scene.order.iter().rev() {
        let behind = fields.last().expect("the substrate's");
        fields.push(kinds[kind].matrix.times(behind));
    }
    let front = fields.pop().expect("the substrate's");
    let (reflected, incident) = (&y_i * &front.0 - &front.1, &y_i * &front.0 + &front.1);
    let waves =
        Waves { by_reflected: (!reflected.is_zero()).then(|| &one / &reflected), by_incident: &one / &incident };
    let mut rows = [(y_i.clone(), -one.clone()), (y_i.clone(), one.clone())];

    let mut sums = Sums::new(&scene, &reflected, &incident, &y_s);
    let (mut scale, mut tangential) = (sums.none(), sums.none());
    for &kind in &scene.order {
        let Matrices { matrix, by_n, by_k, by_thickness, by_tangential } = &kinds[kind];
        let behind = fields.pop().expect("one a layer");
        let gradient = |change: &Matrix| {
            let changed = change.times(&behind);
            waves.gradient([&rows[0], &rows[1]].map(|row| &row.0 * &changed.0 + &row.1 * &changed.1))
        };
        sums.add(&gradient(by_n));
        if let Some(by_k) = by_k {
            sums.add(&gradient(by_k));
        }
        let by_thickness = gradient(by_thickness);
        sums.add(&by_thickness);
        scale.accumulate(&by_thickness);
        tangential.accumulate(&gradient(by_tangential));
        rows = rows.map(|row| matrix.transposed_times(&row));
    }
    let substrate = scene.changes(&scene.substrate, |n, tangential| scene.admittance(n, tangential));
    let behind = |change: &Complex| {
        let mut gradient = waves.gradient([&rows[0], &rows[1]].map(|row| &row.1 * change));
        if !is_zero(&sums.y_s) {
            gradient.ln_transmittance += re(change) / &sums.y_s;
        }
        gradient
    };
    let (by_n, by_k) = (behind(&substrate.n), substrate.k.as_ref().map(&behind));
    tangential.accumulate(&behind(&substrate.tangential));
    sums.add(&by_n);
    if let Some(by_k) = by_k {
        sums.add(&by_k);
    }
    // The wavelength scales all thicknesses; n_i and the angle act through Y₀ and through (n_i sin θ)².
    sums.add(&scale);
    let change = &y_i * &front.0;
    let mut entrance = waves.gradient([change.clone(), change]);
    entrance.ln_transmittance += real_at(1.0, scene.bits);
    let by_n_i = if polarisation == Polarisation::S { 1.0 } else { -1.0 };
    let (by_sin2, by_cos) = sensitivities(direction);
    for (sin2, cos) in [(2.0, by_n_i), (by_sin2, by_cos)] {
        let mut total = sums.none();
        total.accumulate_times(&tangential, sin2);
        total.accumulate_times(&entrance, cos);
        sums.add(&total);
    }
    sums.condition()
}

/// The relative changes of sin²θ and of cos θ for a relative change of the number that gives the direction.
fn sensitivities(direction: Direction) -> (f64, f64) {
    let cotangent = |x: f64| if x == 0.0 { 1.0 } else { x / x.tan() };
    match direction {
        Direction::Angle(theta) => (2.0 * cotangent(theta), -theta * theta.tan()),
        Direction::Grazing(delta) => (-2.0 * delta * delta.tan(), cotangent(delta)),
        Direction::Cos(cos) => (-2.0 * cos * cos / ((1.0 - cos) * (1.0 + cos)), 1.0),
    }
}

fn re(z: &Complex) -> Real {
    z.clone().into_parts().0
}

fn abs(x: Real) -> Real {
    if x < Real::ZERO { -x } else { x }
}

/// Relative steps of the condition's difference quotients, 2⁻¹⁰⁰.
const STEP: f64 = 1.0 / (1_u128 << 100) as f64;

impl Scene {
    fn matrix(&self, n: &Complex, thickness: &Real, tangential: &Real) -> Matrix {
        let q = self.normal_nudged(n, tangential);
        let y = &q / self.q_over_y(n);
        let step = (&q * from_real(&self.wave_number * thickness)).mul_i(false).exp();
        let back = at(Complex64::ONE, self.bits) / &step;
        let half = at(Complex64::from(0.5), self.bits);
        // −i sin δ = (e^(−iδ) − e^(iδ))/2
        let minus_i_sin = (&back - &step) * &half;
        Matrix { diagonal: (back + step) * half, upper: &minus_i_sin / &y, lower: minus_i_sin * y }
    }

    /// Derivatives of `f` by ln n, ln κ (if there is any κ) and ln (n_i sin θ)².
    fn changes<T>(&self, n: &Complex, f: impl Fn(&Complex, &Real) -> T) -> Changes<T>
    where
        T: Quotient,
    {
        let (re, im) = n.clone().into_parts();
        let grown = |x: &Real| x * (real_at(1.0, self.bits) + real_at(STEP, self.bits));
        let here = f(n, &self.tangential);
        let quotient = |there: T| there.quotient(&here, &at(Complex64::from(1.0 / STEP), self.bits));
        Changes {
            n: quotient(f(&Complex::from_parts(grown(&re), im.clone()), &self.tangential)),
            k: (!is_zero(&im)).then(|| quotient(f(&Complex::from_parts(re.clone(), grown(&im)), &self.tangential))),
            tangential: quotient(f(n, &grown(&self.tangential))),
            here,
        }
    }
}

struct Changes<T> {
    here: T,
    n: T,
    k: Option<T>,
    tangential: T,
}

/// What has difference quotients.
trait Quotient {
    /// (`self` − `here`)/step.
    fn quotient(&self, here: &Self, inverse_step: &Complex) -> Self;
}

impl Quotient for Complex {
    fn quotient(&self, here: &Self, inverse_step: &Complex) -> Self {
        (self - here) * inverse_step
    }
}

/// A characteristic matrix, or a change of one: both diagonal entries are the same.
struct Matrix {
    diagonal: Complex,
    upper: Complex,
    lower: Complex,
}

impl Quotient for Matrix {
    fn quotient(&self, here: &Self, inverse_step: &Complex) -> Self {
        Self {
            diagonal: self.diagonal.quotient(&here.diagonal, inverse_step),
            upper: self.upper.quotient(&here.upper, inverse_step),
            lower: self.lower.quotient(&here.lower, inverse_step),
        }
    }
}

impl Matrix {
    fn times(&self, (psi, phi): &(Complex, Complex)) -> (Complex, Complex) {
        (&self.diagonal * psi + &self.upper * phi, &self.lower * psi + &self.diagonal * phi)
    }

    fn transposed_times(&self, (psi, phi): &(Complex, Complex)) -> (Complex, Complex) {
        (&self.diagonal * psi + &self.lower * phi, &self.upper * psi + &self.diagonal * phi)
    }
}

/// A layer's matrix and its derivatives by the logarithms of what it depends on.
struct Matrices {
    matrix: Matrix,
    by_n: Matrix,
    by_k: Option<Matrix>,
    by_thickness: Matrix,
    by_tangential: Matrix,
}

impl Matrices {
    fn new(scene: &Scene, layer: &Layer) -> Self {
        let n = at(layer.index, scene.bits);
        let thickness = real_at(layer.thickness, scene.bits);
        let changes = scene.changes(&n, |n, tangential| scene.matrix(n, &thickness, tangential));
        let grown = &thickness * (real_at(1.0, scene.bits) + real_at(STEP, scene.bits));
        let by_thickness = scene
            .matrix(&n, &grown, &scene.tangential)
            .quotient(&changes.here, &at(Complex64::from(1.0 / STEP), scene.bits));
        Self { matrix: changes.here, by_n: changes.n, by_k: changes.k, by_thickness, by_tangential: changes.tangential }
    }
}

/// 1/(Y₀ψ − φ) at the entrance, `None` if nothing is reflected, and 1/(Y₀ψ + φ).
struct Waves {
    by_reflected: Option<Complex>,
    by_incident: Complex,
}

/// Changes of ln R and of ln T.
struct Gradient {
    ln_reflectance: Real,
    ln_transmittance: Real,
}

impl Waves {
    /// From the changes of the reflected and the incident wave. R = |reflected/incident|², T ∝ 1/|incident|².
    fn gradient(&self, [reflected, incident]: [Complex; 2]) -> Gradient {
        let relative = |change: &Complex, inverse: &Complex| real_at(2.0, BITS) * re(&(change * inverse));
        let by_incident = relative(&incident, &self.by_incident);
        let by_reflected = self.by_reflected.as_ref().map(|inverse| relative(&reflected, inverse));
        let ln_reflectance = by_reflected.unwrap_or_else(|| real_at(0.0, BITS)) - &by_incident;
        Gradient { ln_reflectance, ln_transmittance: -by_incident }
    }
}

impl Gradient {
    fn accumulate(&mut self, other: &Self) {
        self.accumulate_times(other, 1.0);
    }

    fn accumulate_times(&mut self, other: &Self, factor: f64) {
        let factor = real_at(factor, BITS);
        self.ln_reflectance += &other.ln_reflectance * &factor;
        self.ln_transmittance += &other.ln_transmittance * &factor;
    }
}

/// Sums of the sizes of changes.
struct Sums {
    reflectance: Real,
    transmittance: Real,
    /// Re Y of the substrate.
    y_s: Real,
    ln_reflectance: Real,
    ln_transmittance: Real,
    absorptance: Real,
}

impl Sums {
    fn new(scene: &Scene, reflected: &Complex, incident: &Complex, y_s: &Complex) -> Self {
        let y_s = re(y_s);
        let zero = real_at(0.0, BITS);
        let incident = incident.norm();
        Self {
            reflectance: reflected.norm() / &incident,
            transmittance: real_at(4.0, BITS) * &scene.y_i * &y_s / incident,
            y_s,
            ln_reflectance: zero.clone(),
            ln_transmittance: zero.clone(),
            absorptance: zero,
        }
    }

    fn none(&self) -> Gradient {
        Gradient { ln_reflectance: real_at(0.0, BITS), ln_transmittance: real_at(0.0, BITS) }
    }

    fn add(&mut self, change: &Gradient) {
        self.ln_reflectance += abs(change.ln_reflectance.clone());
        self.ln_transmittance += abs(change.ln_transmittance.clone());
        self.absorptance +=
            abs(&self.reflectance * &change.ln_reflectance + &self.transmittance * &change.ln_transmittance);
    }

    fn condition(self) -> Condition {
        let absorptance = real_at(1.0, BITS) - &self.reflectance - &self.transmittance;
        let over = |sum: Real, value: &Real| if is_zero(value) { f64::INFINITY } else { to_f64(&(sum / value)).abs() };
        let transparent = is_zero(&self.transmittance);
        Condition {
            reflectance: if is_zero(&self.reflectance) { f64::INFINITY } else { to_f64(&self.ln_reflectance) },
            transmittance: if transparent { f64::INFINITY } else { to_f64(&self.ln_transmittance) },
            absorptance: over(self.absorptance, &absorptance),
            ln_transmittance: if transparent {
                f64::INFINITY
            } else {
                over(self.ln_transmittance, &self.transmittance.ln())
            },
        }
    }
}
