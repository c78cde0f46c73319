//! Whether numbers drawn by chance agree with what is claimed of them.
//!
//! A test answers with a p-value [1]: how often a true claim would look at least as bad as this one. It is NaN where
//! nothing was tested (one draw, one bin), so that it breaks every bound, and 0 where the claim is impossible.
//!
//! | question | asked by |
//! |---|---|
//! | how strict must one of many tests be? | [`sidak`]; [`family`] makes one p-value of many |
//! | how large are errors that scatter? | [`rms`] |

mod family;
mod rms;

pub use family::{family, sidak};
pub use rms::rms;
