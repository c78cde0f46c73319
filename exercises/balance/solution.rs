/// Weight [1] of the way that draws a direction with the density `p`, beside one that draws it with `q` [1/sr].
pub fn share(p: f64, q: f64) -> f64 {
    p / (p + q)
}
