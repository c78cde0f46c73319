//! `views`: how the lecture is told and drawn. It knows no command line, clock, file or thread.

#![allow(missing_docs)]

pub mod coverage;
pub mod judged;
pub mod page;
pub mod plot;
pub mod race_plot;
pub mod report;
pub mod request;
pub mod text;
