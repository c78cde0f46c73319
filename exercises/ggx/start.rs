/// GGX's D [1/sr] of facets at that cosine, for roughness `alpha` [1].
pub fn density(alpha: f64, cos: f64) -> f64 {
    todo!()
}
