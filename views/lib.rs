//! `views`: how the lecture is told and drawn. It knows no command line, clock, file or thread.
//!
//! What was found is a [`report`]; a [`tell::Teller`] makes [`block`]s of it and of the chapters; [`terminal`],
//! [`html`] and [`json`] show them.

pub mod block;
pub mod html;
pub mod json;
pub mod number;
pub mod page;
pub mod plot;
pub mod race_plot;
pub mod report;
pub mod request;
pub mod tell;
pub mod terminal;
pub mod words;
pub mod xml;
