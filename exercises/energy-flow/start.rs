/// E × B [V T/m], along which energy flows, of `e` [V/m] and `b` [T].
pub fn flow(e: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    todo!()
}
