//! Yardsticks for chapters and tests alike: references in arbitrary precision, condition numbers,
//! observed orders, quadrature, initial values, statistics.

pub mod film;
pub mod fresnel;
pub mod initial_value;
pub mod order;
pub mod quadrature;
pub mod waves;
