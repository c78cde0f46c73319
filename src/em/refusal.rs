//! What cannot be simulated, and why.

use crate::waves::plane::Plain;
use std::fmt;

/// Why a run was refused: where the trouble is, what was given, and what is allowed.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The grid, or what is recorded in it, would take more memory than allowed.
    TooLarge {
        /// What it would take at its peak [B]; `u64::MAX` for that or more.
        bytes: u64,
        /// What it may take [B].
        limit: u64,
    },
    /// The step is too long for the grid.
    Unstable {
        /// S = cΔt/Δ asked for [1].
        courant: f64,
        /// Largest stable S for these media [1].
        limit: f64,
    },
    /// A number is outside its range.
    OutOfRange {
        /// Which number.
        what: &'static str,
        /// Its value.
        given: f64,
        /// Its valid range.
        valid: &'static str,
    },
    /// A place does not lie on the grid.
    Outside {
        /// What was to be put there.
        what: &'static str,
        /// Where.
        at: usize,
        /// First and last valid place.
        valid: (usize, usize),
    },
    /// Cells that should be of one medium are not.
    Mixed {
        /// What was to be put there.
        what: &'static str,
        /// The node or row it was to enter at; the cells on both its sides, or in both rows, count.
        at: usize,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match *self {
            Self::TooLarge { bytes, limit } => {
                write!(f, "the grid and its records would take {bytes} bytes of memory, and the limit is {limit}")
            }
            Self::Unstable { courant, limit } => write!(
                f,
                "a Courant number of {} is unstable here: at most {}, unless instability is asked for",
                Plain(courant),
                Plain(limit)
            ),
            Self::OutOfRange { what, given, valid } => {
                write!(f, "{what} is {}; it must be {valid}", Plain(given))
            }
            Self::Outside { what, at, valid } => {
                write!(f, "{what} at {at} is outside the grid: {} to {}", valid.0, valid.1)
            }
            Self::Mixed { what, at } => write!(
                f,
                "{what} at {at} does not enter a uniform medium: all cells of {} and {at} must be of one",
                at.wrapping_sub(1)
            ),
        }
    }
}

impl std::error::Error for Refusal {}

/// `value` if `ok`, else the refusal that names it.
pub(super) fn demand(ok: bool, what: &'static str, given: f64, valid: &'static str) -> Result<(), Refusal> {
    if ok { Ok(()) } else { Err(Refusal::OutOfRange { what, given, valid }) }
}

/// Refuses `at` outside `first ..= last`.
pub(super) fn inside(what: &'static str, at: usize, first: usize, last: usize) -> Result<(), Refusal> {
    if (first..=last).contains(&at) { Ok(()) } else { Err(Refusal::Outside { what, at, valid: (first, last) }) }
}
