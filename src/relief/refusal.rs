//! What no relief can be made of.

use super::Relief;
use crate::waves::plane::Invalid;

/// `side` if a relief may have it.
pub fn side(side: usize) -> Result<usize, Invalid> {
    let (least, most) = Relief::SIDES;
    unless(
        !side.is_power_of_two() || !(least..=most).contains(&side),
        "side",
        side as f64,
        "a power of two from 2 to 8192",
    )?;
    Ok(side)
}

/// An error if `wrong`.
pub fn unless(wrong: bool, place: &'static str, value: f64, valid: &'static str) -> Result<(), Invalid> {
    if wrong { Err(Invalid { place, value, valid }) } else { Ok(()) }
}
