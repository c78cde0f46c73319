//! Whether numbers drawn by chance agree with what is claimed of them.
//!
//! A test answers with a p-value [1]: how often a true claim would look at least as bad as this one. It is NaN where
//! nothing was tested (one draw, one bin), so that it breaks every bound, and 0 where the claim is impossible.
//!
//! | question | asked by |
//! |---|---|
//! | do counts follow a density? | [`chi_square()`], whose bins can be drawn |
//! | is a mean what it should be? | [`t_test`], [`z_test`] on [`Moments`] |
//! | have two samples one mean? | [`welch`] |
//! | do numbers follow a distribution? | [`kolmogorov`] |
//! | how strict must one of many tests be? | [`sidak`]; [`family`] makes one p-value of many |
//! | how rare is a deviate? | [`normal_two_sided`], [`student_two_sided`], [`chi_square_tail`] |
//! | how large are errors that scatter? | [`rms`] |

mod chi_square;
mod family;
mod kolmogorov;
mod means;
mod moments;
#[cfg(test)]
mod references;
mod rms;
#[cfg(test)]
mod self_tests;
mod tails;

pub use chi_square::{Bin, ChiSquare, LEAST_EXPECTED, chi_square, chi_square_pooled};
pub use family::{family, sidak};
pub use kolmogorov::kolmogorov;
pub use means::{MeanTest, ROUNDING, t_test, welch, z_test};
pub use moments::Moments;
pub use rms::rms;
pub use tails::{chi_square_tail, normal_two_sided, student_two_sided, upper_gamma};
