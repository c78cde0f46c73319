//! How a run is stepped, and what every grid demands before it is built.

use super::absorber::Wall;
use super::medium::{Conduction, HUGE, Medium};
use super::refusal::{Refusal, demand};
use super::theory;

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
    pub(super) fn admit_records(
        &self,
        peak: u64,
        steps: u64,
        records: impl Iterator<Item = (usize, u64)>,
    ) -> Result<(), Refusal> {
        // A record that grows may have room for twice what it holds.
        let room = |(length, each): (usize, u64)| steps.saturating_add(length as u64).saturating_mul(2 * each);
        self.admit(records.map(room).fold(peak, u64::saturating_add))
    }

    /// Refuses what takes more memory [B] than allowed.
    pub(super) fn admit(&self, bytes: u64) -> Result<(), Refusal> {
        let limit = self.memory_limit;
        if bytes > limit { Err(Refusal::TooLarge { bytes, limit }) } else { Ok(()) }
    }
}

/// Number of bytes of an `f64`.
pub(super) const WORD: u64 = 8;

/// Σ of products, as much as there is where it exceeds the range: sizes that are still to be refused.
pub(super) fn total<const N: usize>(products: [[u64; 3]; N]) -> u64 {
    let product = |factors: [u64; 3]| factors.into_iter().fold(1, u64::saturating_mul);
    products.into_iter().map(product).fold(0, u64::saturating_add)
}

/// What a grid takes whatever its size [B].
pub(super) const FIXED: u64 = 1 << 10;

/// What every grid demands of its spacing and its stepping.
pub(super) fn check_grid(spacing: f64, stepping: &Stepping) -> Result<(), Refusal> {
    demand((1.0 / HUGE..=HUGE).contains(&spacing), "spacing", spacing, "1e−30 m to 1e30 m")?;
    let courant = stepping.courant;
    demand(courant > 0.0 && courant <= HUGE, "Courant number", courant, "above 0 and at most 1e30")
}

/// Refuses absorbers that leave no cell of an axis between them.
pub(super) fn check_room(walls: [Wall; 2], cells: usize) -> Result<(), Refusal> {
    let thick = walls[0].thickness().saturating_add(walls[1].thickness());
    demand(thick < cells, "thickness of both absorbers", thick as f64, "less than the number of cells")
}

/// Refuses a Courant number beyond what the fastest of `media` allows.
pub(super) fn check_courant<'a>(
    stepping: &Stepping,
    media: impl Iterator<Item = &'a Medium>,
    dimensions: u32,
) -> Result<(), Refusal> {
    // E and H average their own cells: the smallest ε and the smallest μ may meet.
    let least = media.fold((f64::MAX, f64::MAX), |(eps, mu), m| (eps.min(m.eps_r), mu.min(m.mu_r)));
    let limit = (least.0 * least.1).sqrt() * theory::courant_limit(dimensions);
    let courant = stepping.courant;
    if courant <= limit || stepping.unstable { Ok(()) } else { Err(Refusal::Unstable { courant, limit }) }
}
