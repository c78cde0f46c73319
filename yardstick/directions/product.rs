//! Rules that are products of two.

use super::{Domain, Rule};
use crate::quadrature::gauss_legendre;
use std::f64::consts::PI;

/// `polar` ≥ 1 Gauss–Legendre nodes in cos θ, each with 2 `polar` even ones in φ, the first half a step from 0.
///
/// Over the sphere and the plain hemisphere exact for polynomials in x, y, z up to degree 2 `polar` − 1; under the
/// cosine one less, since the weights carry it. The hemisphere's nodes are its own: none is wasted below.
pub fn product(domain: Domain, polar: usize) -> Rule {
    let around = 2 * polar;
    let step = PI / polar as f64;
    let ring = |(node, weight): (f64, f64)| {
        // sin² θ = (1 − cos θ)(1 + cos θ) of both factors as they are, without cancellation.
        let (cos, sin, measure) = match domain {
            Domain::Sphere => (1.0 - 2.0 * node, 2.0 * (node * (1.0 - node)).sqrt(), 2.0),
            Domain::Hemisphere => (node, ((1.0 - node) * (1.0 + node)).sqrt(), 1.0),
            Domain::Cosine => (node, ((1.0 - node) * (1.0 + node)).sqrt(), node),
        };
        (0..around).map(move |at| {
            let (y, x) = (step * (at as f64 + 0.5)).sin_cos();
            ([sin * x, sin * y, cos], weight * measure * step)
        })
    };
    gauss_legendre(polar).into_iter().flat_map(ring).collect()
}
