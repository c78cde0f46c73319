/// GGX's D [1/sr] of facets at that cosine, for roughness `alpha` [1].
pub fn density(alpha: f64, cos: f64) -> f64 {
    let a2 = alpha * alpha;
    // α² cos² θ + sin² θ.
    let t = a2 * cos * cos + (1.0 - cos) * (1.0 + cos);
    a2 / (std::f64::consts::PI * t * t)
}
