//! Rules and points held against closed forms, published rules, and the orders that theory gives them.

mod evenness;
mod exactness;
mod orders;

use super::{Direction, Domain};
use crate::random::{Stream, uniform};

/// A direction drawn evenly from the sphere.
fn axis(stream: &mut Stream) -> Direction {
    Domain::Sphere.at(std::array::from_fn(|_| uniform(stream, 0.0, 1.0)))
}

fn cosine(one: Direction, other: Direction) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}
