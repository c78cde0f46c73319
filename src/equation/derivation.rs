//! Derivations. (being written)
/// A chain of lines.
#[derive(Clone, Debug)]
pub struct Chain {}
