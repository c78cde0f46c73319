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
//! | TM (E_z, H_x, H_y) and TE (H_z, E_x, E_y) in the plane | [`plane::Plane`] |
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

pub use crate::waves::constants::{C, EPSILON_0, MU_0, Z_0};

/// How a run is stepped, whatever its shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stepping {
    /// S = cΔt/Δ [1], with c of vacuum; at most √(ε_r μ_r)/√dimensions of the fastest medium.
    pub courant: f64,
    /// Whether a Courant number above the limit is taken all the same.
    pub unstable: bool,
    /// How conduction is stepped.
    pub conduction: Conduction,
    /// Whether what a cell does not need is left out of its update; the fields are the same bit by bit.
    pub pruned: bool,
    /// The most memory a grid may take while it is built and after [B], its incident wave and all that probes record
    /// included, which a run checks before its first step. A clone, such as an audited step makes, counts anew.
    pub memory_limit: u64,
}

impl Stepping {
    /// The usual choices at this Courant number [1]: exponential conduction, pruned, at most 2 GiB.
    pub const fn at(courant: f64) -> Self {
        Self { courant, unstable: false, conduction: Conduction::Exponential, pruned: true, memory_limit: 2 << 30 }
    }

    /// Refuses a run of `steps` after which a grid of `peak` bytes and its records, of so many entries and bytes each,
    /// would exceed the limit.
    fn admit_records(&self, peak: u64, steps: u64, records: impl Iterator<Item = (usize, u64)>) -> Result<(), Refusal> {
        // A record that grows may have room for twice what it holds.
        let room = |(length, each): (usize, u64)| steps.saturating_add(length as u64).saturating_mul(2 * each);
        self.admit(records.map(room).fold(peak, u64::saturating_add))
    }

    /// Refuses what takes more memory [B] than allowed.
    fn admit(&self, bytes: u64) -> Result<(), Refusal> {
        let limit = self.memory_limit;
        if bytes > limit { Err(Refusal::TooLarge { bytes, limit }) } else { Ok(()) }
    }
}

/// Number of bytes of an `f64`.
const WORD: u64 = 8;

/// Σ of products, as much as there is where it exceeds the range: sizes that are still to be refused.
fn total<const N: usize>(products: [[u64; 3]; N]) -> u64 {
    let product = |factors: [u64; 3]| factors.into_iter().fold(1, u64::saturating_mul);
    products.into_iter().map(product).fold(0, u64::saturating_add)
}
