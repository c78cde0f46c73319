//! Derivations: lines that follow from one another, each hop judged by the program.
//!
//! A hop is decided by normal form ([`super::ring`]), under the hypotheses and with the premises solved. A decision is
//! guarded at a few random points of the stated domain, on the real axis and off it, in arbitrary precision; what no
//! normal form decides is compared at more of them, and a point where the sides differ refutes it. With every value
//! goes a bound of its rounding error, so that a difference is called real, or not, by what the arithmetic at that
//! point can tell, cancellation included.

mod assumed;
mod atoms;
mod chain;
mod complete;
mod conditions;
mod hypotheses;
mod judge;
mod model;
#[cfg(test)]
mod properties;
mod sample;
#[cfg(test)]
mod tests;
mod verdict;

pub use assumed::Assumed;
pub use chain::{Chain, Claim, Line, Role};
pub use verdict::{Hop, Verdict};
