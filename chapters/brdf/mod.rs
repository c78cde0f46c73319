//! draft
pub mod symbols;
#[cfg(test)]
mod chains;
