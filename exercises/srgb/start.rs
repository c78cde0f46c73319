/// Share [1] of white's light that a channel of that code, 0 to 1, means.
pub fn light(code: f64) -> f64 {
    todo!()
}
