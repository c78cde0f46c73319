//! What chance is made of: points for paths, and how they become directions and places.
//!
//! | idea | where |
//! |---|---|
//! | numbers for every sample, vertex and use | [`Points`] |
//! | a choice among things of different weight | [`Shares`] |
//! | directions about an axis | [`warp`] |
//! | shares of several ways to find one thing | [`balance`] |

mod points;
mod shares;
pub mod warp;
mod weights;

pub use points::{Choice, Points, ROW, Row, Stream};
pub use shares::Shares;
pub use weights::balance;
