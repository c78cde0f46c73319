//! The formulas of this crate again in arbitrary precision, by routes of their own where there are any, with the condition
//! numbers of their outputs: what `f64` results are held against.

pub mod film;
pub mod fresnel;
pub mod microfacet;
pub mod radiometry;
pub mod waves;
