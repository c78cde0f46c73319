/// Density [1/sr] of a facet's `normal` among those that are seen from `view`, for GGX of roughness `alpha` [1].
pub fn density(alpha: f64, view: [f64; 3], normal: [f64; 3]) -> f64 {
    todo!()
}
