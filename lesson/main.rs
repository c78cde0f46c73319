//! `lesson`: how it is shown.
#[allow(dead_code)]
mod plot;

fn main() {}
