/// By how much the logarithm of the shortest wave grows in a step [1], at the Courant number `courant` > 1.
pub fn growth_per_step(courant: f64) -> f64 {
    todo!()
}
