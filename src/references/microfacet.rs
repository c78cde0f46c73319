//! Slopes of rough surfaces in arbitrary precision, by the plainest formulas, with the condition numbers of what they give.

pub use crate::bsdf::microfacet::Slopes;
use yardstick::precise::{self, Real};

/// The names of what is given.
pub const NAMES: [&str; 3] = ["D", "lambda", "G1"];

/// D [sr⁻¹] of the facet with the normal w, Λ and G₁ [1] of the direction w, exact for every purpose of `f64`; and their
/// condition numbers Σ|∂ ln y/∂ ln x| over α and the three components of w, which is taken as it is, of length 1 or not.
/// A Beckmann Λ below the range of `f64` is given as 0.
pub fn microfacet(slopes: Slopes, alpha: f64, w: [f64; 3]) -> ([Real; 3], [f64; 3]) {
    let inputs = [alpha, w[0], w[1], w[2]].map(|x| precise::real_at(x, BITS));
    let here = outputs(slopes, &inputs);
    let mut conditions = [0.0; 3];
    for moved in 0..4 {
        let mut inputs = inputs.clone();
        inputs[moved] = &inputs[moved] + &inputs[moved] * &precise::real_at(STEP, BITS);
        for ((sum, there), here) in conditions.iter_mut().zip(outputs(slopes, &inputs)).zip(&here) {
            if !is_zero(here) {
                *sum += precise::to_f64(&((there - here) / here)).abs() / STEP;
            }
        }
    }
    (here, conditions)
}

/// Wide enough for erfc where it nearly cancels.
const BITS: usize = 2048;
/// Relative step of the difference quotients.
const STEP: f64 = 1e-30;

fn is_zero(x: &Real) -> bool {
    x.repr().significand().is_zero()
}

fn outputs(slopes: Slopes, [alpha, x, y, z]: &[Real; 4]) -> [Real; 3] {
    let number = |x: f64| precise::real_at(x, BITS);
    let (one, pi) = (number(1.0), precise::pi(BITS));
    let (sin2, cos2, alpha2) = (x * x + y * y, z * z, alpha * alpha);
    let tan2 = &sin2 / &cos2;
    // As the vector has them: cos⁴ is |w|⁴ times that of the angle, D that of a normal of any length.
    let base = &pi * &alpha2 * &cos2 * &cos2;
    let density = match slopes {
        Slopes::Ggx => {
            let sum = &one + &tan2 / &alpha2;
            &one / (base * &sum * &sum)
        }
        Slopes::Beckmann => (-(&tan2 / &alpha2)).exp() / base,
    };
    let lambda = if is_zero(&sin2) {
        number(0.0)
    } else {
        match slopes {
            Slopes::Ggx => ((&one + &alpha2 * &tan2).sqrt() - &one) / number(2.0),
            Slopes::Beckmann => {
                let a = &one / (alpha * tan2.sqrt());
                if precise::to_f64(&a) > 27.5 {
                    return [density, number(0.0), one];
                }
                ((-(&a * &a)).exp() / (&a * pi.sqrt()) - erfc(&a)) / number(2.0)
            }
        }
    };
    let masking = &one / (&one + &lambda);
    [density, lambda, masking]
}

/// erfc x for 0 ≤ x < 28, by Taylor's series of erf (DLMF 7.6.2), all of whose terms are positive.
fn erfc(x: &Real) -> Real {
    let number = |x: f64| precise::real_at(x, BITS);
    let square = number(2.0) * x * x;
    let (mut term, mut sum, mut odd) = (x.clone(), x.clone(), 3.0);
    while precise::to_f64(&(&term / &sum)) > 1e-307 || odd < precise::to_f64(&square) {
        term = term * &square / number(odd);
        sum += &term;
        odd += 2.0;
    }
    number(1.0) - number(2.0) / precise::pi(BITS).sqrt() * (-(x * x)).exp() * sum
}
