//! How much of the light from everywhere rough metal returns at the first bounce: ∫f cos θ_i dω_i by quadrature over the
//! slopes, in coordinates that end where facets begin to reflect downwards.
//!
//! Facets of slope R at the azimuth φ from the view reflect upwards as long as R < e^w with sinh w = tan θ cos φ. Hence
//! w = W sin(πv/2), W = arsinh tan θ, for the azimuth: even and smooth at both ends, so that midpoints converge
//! exponentially; and R = α tan ψ for the radius.

use super::microfacet::{Beckmann, Distribution, Ggx, Slopes};
use super::rules::{Node, fejer, tanh_sinh};
use crate::number::Vector;
use std::f64::consts::FRAC_PI_2;

/// E [1], the share of light that white facets of roughness `alpha` (1e−4 … 1) return to 0 < `cos` ≤ 1 at one bounce, with
/// height-correlated masking; to 1e−8, from 4096 nodes.
pub fn albedo(slopes: Slopes, alpha: f64, cos: f64) -> f64 {
    match slopes {
        Slopes::Ggx => Rule::new(&Ggx::new([alpha; 2]), 64, 64).albedo(cos, |_| 1.0),
        Slopes::Beckmann => Rule::new(&Beckmann::new([alpha; 2]), 64, 64).albedo(cos, |_| 1.0),
    }
}

/// A rule for the facets of one surface that is equally rough along x and y.
pub struct Rule<D> {
    facets: D,
    alpha: f64,
    azimuths: usize,
    radii: Vec<Node>,
}

impl<D: Distribution<f64>> Rule<D> {
    /// Of so many azimuths and slopes.
    pub fn new(facets: &D, azimuths: usize, slopes: usize) -> Self {
        let radii = if D::HAS_TAIL { tanh_sinh(slopes) } else { fejer(slopes) };
        Self { facets: *facets, alpha: facets.alpha()[0], azimuths, radii }
    }

    /// E [1] where facets return the share `reflectance` [1] at a cosine [1] to their normal.
    pub fn albedo(&self, cos: f64, reflectance: impl Fn(f64) -> f64) -> f64 {
        let sin = ((1.0 - cos) * (1.0 + cos)).max(0.0).sqrt();
        let reach = (sin / cos).asinh();
        let azimuth = |k: usize| {
            let s = (FRAC_PI_2 * ((2 * k + 1) as f64 / self.azimuths as f64 - 1.0)).sin();
            let w = reach * s;
            // dφ/dv: the roots of sinh(W − w) sinh(W + w) and of dw/dv at the ends are the same.
            let crowding = w.cosh() / (sinhc(reach - w) * sinhc(reach + w)).sqrt();
            crowding * self.along(w, [sin, cos], &reflectance)
        };
        (0..self.azimuths).map(azimuth).sum::<f64>() * 2.0 * FRAC_PI_2 * 2.0 / self.azimuths as f64
    }

    /// The integral over R at one azimuth.
    fn along(&self, w: f64, [sin, cos]: [f64; 2], reflectance: &impl Fn(f64) -> f64) -> f64 {
        let hidden_o = self.facets.hidden(Vector::new(sin, 0.0, cos));
        let (steepest, lean) = (w.exp(), w.sinh());
        let end = (steepest / self.alpha).atan();
        let radius = |node: &Node| {
            let psi = end * node.at;
            let stretch = 1.0 / psi.cos();
            let r = self.alpha * psi.tan();
            let z = 1.0 / (1.0 + r * r).sqrt();
            // cos θ_i = cos θ (e^w − R)(R + e^−w)/(1 + R²), its difference by a sine.
            let below = self.alpha * (end * node.left).sin() * stretch / end.cos();
            let cos_i = (cos * below * (r + 1.0 / steepest) * z * z).min(1.0);
            let wi = Vector::new(((1.0 - cos_i) * (1.0 + cos_i)).sqrt(), 0.0, cos_i);
            let facing = cos * (1.0 + r * lean);
            let seen = facing * cos_i / (cos_i * cos + (cos * self.facets.hidden(wi) + cos_i * hidden_o));
            // D m_z⁴ R dR is the share of the slopes.
            let slopes =
                self.facets.density(Vector::new(r * z, 0.0, z)) * z.powi(4) * r * self.alpha * stretch * stretch;
            node.weight * slopes * seen * reflectance((facing * z).min(1.0))
        };
        end * self.radii.iter().map(radius).sum::<f64>()
    }
}

/// sinh x/x.
fn sinhc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sinh() / x }
}
