/// Radiance [1] that paths of at most `edges` edges find in a closed room, over L_e, where walls absorb that share.
pub fn brightness(absorbed: f64, edges: u32) -> f64 {
    -(f64::from(edges) * (-absorbed).ln_1p()).exp_m1() / absorbed
}
