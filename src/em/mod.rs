//! Maxwell's equations solved as fields: the Yee grid (finite differences in time domain).
//!
//! K. S. Yee, *IEEE Trans. Antennas Propag.* **14**, 302 (1966); A. Taflove & S. C. Hagness, *Computational
//! Electrodynamics* (3rd ed., 2005), cited as T&H. E and H sit half a cell and half a step apart, so that every
//! derivative of E1 is a centred difference,
//!
//! ε (E′ − E)/Δt = ∇×H − σE − J,  μ (H′ − H)/Δt = −∇×E,
//!
//! second-order accurate, and the two divergences of E1 are kept to rounding because the discrete divergence of a
//! discrete curl is zero term by term.
//!
//! | idea | where |
//! |---|---|
//! | E_x, H_y along z | [`line::Line`] |
//! | s (E_z, H_x, H_y) and p (H_z, E_x, E_y) in the plane | [`plane::Plane`] |
//! | ε, μ, σ and Drude metals; update coefficients that keep their digits | [`medium`] |
//! | walls: conductor, periodic and Bloch-periodic, CPML | [`absorber`] |
//! | pulses, point sources | [`pulse`] |
//! | Courant limit, growth beyond it, numerical dispersion | [`theory`] |
//! | charge and energy, balanced step by step | [`ledger`] |
//! | other ways to solve the wave equation | [`wave`] |
//! | what a scene left out | [`pruning`] |
//! | an incident plane wave, without echo | `incident` |
//! | inner loops, compiled for each processor | `kernel`, `span` |
//!
//! Inside, H is held as Z₀H [V/m], so that vacuum needs one number, the Courant number S = cΔt/Δ; every public
//! function speaks SI. Fields are real, or a pair of real grids where a Bloch phase makes them complex.

pub mod absorber;
mod aligned;
mod incident;
mod kernel;
pub mod ledger;
pub mod line;
pub mod medium;
pub mod plane;
pub mod pruning;
pub mod pulse;
mod refusal;
mod span;
mod stepping;
pub mod theory;
pub mod wave;

#[cfg(test)]
mod tests;

pub use absorber::{Cpml, Wall};
pub use line::Line;
pub use medium::{Conduction, Drude, Medium};
pub use plane::Plane;
pub use pulse::Pulse;
pub use refusal::Refusal;
pub use stepping::Stepping;

pub use crate::waves::constants::{C, EPSILON_0, MU_0, Z_0};
