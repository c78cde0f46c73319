//! The closed forms against arbitrary precision, and what must hold among them.

mod precision;
mod refusals;
mod relations;
