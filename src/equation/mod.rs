//! Equations as objects. (being written)
pub mod derivation;

/// lhs = rhs
#[derive(Clone, Debug)]
pub struct Equation {}

impl Equation {
    /// The SI dimension of both sides.
    pub fn dimension(&self) -> Result<(), ()> {
        Ok(())
    }
}
