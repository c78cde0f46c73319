//! `yardstick`: what we measure with. It knows no physics and no equations.
//!
//! | idea | where |
//! |---|---|
//! | arbitrary precision, relative errors | [`precise`] |
//! | random numbers by name and seed | [`random`] |
//! | the observed order of a method | [`order`] |
//! | integrals by rules | [`quadrature`] |
//! | directions over the sphere, by rules and by chance | [`directions`] |
//! | differential equations stepped from their start | [`initial_value`] |
//! | counts, means and what chance makes of them | [`statistics`] |

pub mod directions;
pub mod initial_value;
pub mod order;
#[cfg(feature = "precise")]
pub mod precise;
pub mod quadrature;
pub mod random;
pub mod statistics;
