//! `lesson`: how it is shown.
fn main() {}
