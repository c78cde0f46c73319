//! Vectors as three numbers.

/// Cartesian components.
pub type Vector = [f64; 3];

/// a·b.
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b.
pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a − b.
pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Vectors in a unit in which their largest component is about 1: a power of two, so that nothing is rounded.
pub fn in_unit(vectors: &[Vector]) -> Vec<Vector> {
    let largest =
        vectors.as_flattened().iter().fold(f64::MIN_POSITIVE, |largest, component| largest.max(component.abs()));
    let unit = f64::from_bits(largest.to_bits() >> 52 << 52);
    vectors.iter().map(|vector| vector.map(|component| component / unit)).collect()
}
