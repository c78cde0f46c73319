/// Density [1/sr] of a facet's `normal` among those that are seen from `view`, for GGX of roughness `alpha` [1].
pub fn density(alpha: f64, view: [f64; 3], normal: [f64; 3]) -> f64 {
    let [x, y, z] = view;
    let a2 = alpha * alpha;
    let t = a2 * normal[2] * normal[2] + normal[0] * normal[0] + normal[1] * normal[1];
    let d = a2 / (std::f64::consts::PI * t * t);
    let hidden = 0.5 * ((1.0 + a2 * (x * x + y * y) / (z * z)).sqrt() - 1.0);
    let shown = (x * normal[0] + y * normal[1] + z * normal[2]).max(0.0);
    d * shown / (z * (1.0 + hidden))
}
