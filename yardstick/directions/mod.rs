//! Directions over the sphere and the hemisphere: rules that integrate, and points drawn by chance.
//!
//! | idea | where |
//! |---|---|
//! | the domains, and maps of equal area from the square to them | [`Domain`] |
//! | Gauss's nodes in cos θ times even ones in φ | [`product`] |
//! | points with the symmetry of the cube | [`lebedev`] |
//! | points of the square: by chance, stratified, Sobol's | [`Points`]; [`sampled`] makes a rule of them |

mod domain;
mod lebedev;
mod points;
mod product;
#[cfg(test)]
mod tests;

pub use domain::Domain;
pub use lebedev::{TOP_LEVEL, lebedev};
pub use points::{MOST_SOBOL, Points, net, shuffled};
pub use product::product;

/// A unit vector; z is the local normal of a hemisphere.
pub type Direction = [f64; 3];

/// Directions and their weights [sr]; the weights add up to the [`Domain::size`].
pub type Rule = Vec<(Direction, f64)>;

/// The rule that gives `points` of the unit square, carried to `domain`, equal weights.
pub fn sampled(domain: Domain, points: &[[f64; 2]]) -> Rule {
    let weight = domain.size() / points.len() as f64;
    points.iter().map(|&point| (domain.at(point), weight)).collect()
}

/// What `rule` makes of ∫ f dω, in the unit of f times sr.
pub fn integral(rule: &[(Direction, f64)], f: impl Fn(Direction) -> f64) -> f64 {
    rule.iter().map(|&(direction, weight)| weight * f(direction)).sum()
}
