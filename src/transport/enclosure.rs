//! A closed room whose diffuse walls all shine with one radiance L_e and absorb one share `a` of what they get: the scene whose
//! light is known. What arrives anywhere is what leaves anywhere, L = L_e + (1 − a)L, whatever the room's form.

/// L/L_e [1] of paths of at most so many edges, the camera's being the first: Σ(1 − a)^k over 0 ≤ k < `edges`, for
/// 0 ≤ `absorbed` ≤ 1; `edges` where nothing is absorbed.
pub fn radiance(absorbed: f64, edges: u32) -> f64 {
    if absorbed == 0.0 { f64::from(edges) } else { -(f64::from(edges) * (-absorbed).ln_1p()).exp_m1() / absorbed }
}

/// The share [1] of all light that such paths miss, (1 − a)^d.
pub fn missing(absorbed: f64, edges: u32) -> f64 {
    if edges == 0 { 1.0 } else { (f64::from(edges) * (-absorbed).ln_1p()).exp() }
}

/// The relative standard deviation [1] of what a path finds that no depth ends, but chance: after every edge with the
/// probability `ended`, whoever goes on counting for the others. With q = 1 − `ended` and ρ = 1 − a it is
/// ρ √((1 − q)/(q − ρ²)), for 0 < `absorbed` ≤ 1 and 0 ≤ `ended` < 1; None where it is infinite, q ≤ ρ².
pub fn scatter(absorbed: f64, ended: f64) -> Option<f64> {
    let reflected = 1.0 - absorbed;
    // q − ρ² without the difference of numbers near 1.
    let room = absorbed.mul_add(2.0 - absorbed, -ended);
    (room > 0.0).then(|| reflected * (ended / room).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_room_is_as_bright_as_its_series() {
        for (absorbed, edges) in [(0.5, 1), (0.25, 7), (1e-3, 100), (1.0, 3), (0.0, 4)] {
            let series: f64 = (0..edges).map(|k| f64::powi(1.0 - absorbed, k as i32)).sum();
            // A rounding a term.
            let allowed = f64::from(edges) * f64::EPSILON;
            assert!((radiance(absorbed, edges) / series - 1.0).abs() <= allowed, "{absorbed}, {edges}");
            let rest = 1.0 - absorbed * series;
            assert!((missing(absorbed, edges) - rest).abs() <= allowed, "{absorbed}, {edges}");
        }
    }

    #[test]
    fn chance_scatters_as_its_own_sum_says() {
        // ⟨X²⟩ = Σ qᵏ(1 − q) (Σ_{j ≤ k} (ρ/q)ʲ)², term by term.
        for (rho, q) in [(0.5, 0.5), (0.8, 0.9), (0.3, 0.99), (0.9, 0.85)] {
            let (mut sum, mut found, mut weight, mut alive) = (0.0, 0.0, 1.0, 1.0);
            for _ in 0..4000 {
                found += weight;
                sum += alive * (1.0 - q) * found * found;
                weight *= rho / q;
                alive *= q;
            }
            let exact = (sum * (1.0 - rho) * (1.0 - rho) - 1.0_f64).sqrt();
            let ours = scatter(1.0 - rho, 1.0 - q).expect("finite");
            assert!((ours / exact - 1.0).abs() < 1e-9, "ρ = {rho}, q = {q}: {ours} against {exact}");
        }
        assert_eq!((scatter(0.1, 0.2), scatter(0.5, 0.0)), (None, Some(0.0)));
    }
}
