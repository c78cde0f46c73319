//! What no relief can be made of.

use super::Relief;
use crate::waves::plane::Invalid;

/// `side` if a relief may have it.
pub fn side(side: usize) -> Result<usize, Invalid> {
    let (least, most) = Relief::SIDES;
    let holds = side.is_power_of_two() && (least..=most).contains(&side);
    only_if(holds, "side", side as f64, "a power of two from 2 to 8192").map(|_| side)
}

/// `value` if what makes it valid `holds`.
pub fn only_if(holds: bool, place: &'static str, value: f64, valid: &'static str) -> Result<f64, Invalid> {
    if holds { Ok(value) } else { Err(Invalid { place, value, valid }) }
}
