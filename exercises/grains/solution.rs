/// Relative permittivity [1] of a block of grains that point everywhere, from that along a grain's axes [1].
pub fn permittivity(eps_x: f64, eps_y: f64, eps_z: f64) -> f64 {
    let left = |eps: f64| [eps_x, eps_y, eps_z].map(|axis| (axis - eps) / (axis + 2.0 * eps)).iter().sum::<f64>();
    let (mut low, mut high) = (eps_x.min(eps_y).min(eps_z), eps_x.max(eps_y).max(eps_z));
    // The sum falls as ε rises: halve until the two ends are neighbours.
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        *(if left(middle) > 0.0 { &mut low } else { &mut high }) = middle;
    }
}
