/// E × B [V T/m], along which energy flows, of `e` [V/m] and `b` [T].
pub fn flow(e: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [e[1] * b[2] - e[2] * b[1], e[2] * b[0] - e[0] * b[2], e[0] * b[1] - e[1] * b[0]]
}
