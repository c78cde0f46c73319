/// Radiance of a closed room over that which its walls send, L/L_e [1], where they absorb that share.
pub fn brightness(absorbed: f64) -> f64 {
    todo!()
}
