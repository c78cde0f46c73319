/// Share [1] of white's light that a channel of that code, 0 to 1, means.
pub fn light(code: f64) -> f64 {
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}
