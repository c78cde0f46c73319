//! Pictures of a step, apart from its evidence: whoever only draws (a browser) need not load what proves.

use crate::figure::Plot;
use crate::parameter::{Parameter, Setting};

/// A picture of a step at a setting.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Last part of the address, and the file name.
    pub id: &'static str,
    /// What is to be seen.
    pub says: &'static str,
    /// Lecture rows it is evidence for (letter P); those of its step if empty.
    pub rows: &'static [&'static str],
    /// Makes the figure; data, drawn elsewhere.
    pub plot: fn(&Setting) -> Plot,
}

/// The figure `id`, in which is to be seen what it `says`.
pub const fn figure(id: &'static str, says: &'static str, plot: fn(&Setting) -> Plot) -> Figure {
    Figure { id, says, rows: &[], plot }
}

impl Figure {
    /// With lecture rows of its own.
    pub const fn rows(self, rows: &'static [&'static str]) -> Self {
        Self { rows, ..self }
    }
}

/// What a step shows: its figures and what they can be set to.
#[derive(Clone, Copy, Debug)]
pub struct Exhibit {
    /// The step's id, second part of its figures' addresses.
    pub step: &'static str,
    /// What `--set` may change.
    pub parameters: &'static [Parameter],
    /// What it looks like.
    pub figures: &'static [Figure],
}

/// What the step `step` shows.
pub const fn exhibit(step: &'static str, parameters: &'static [Parameter], figures: &'static [Figure]) -> Exhibit {
    Exhibit { step, parameters, figures }
}

/// A chapter's figures, by the steps that show them.
#[derive(Clone, Copy, Debug)]
pub struct Gallery {
    /// The chapter's id, first part of their addresses.
    pub chapter: &'static str,
    /// In teaching order; a step may show nothing.
    pub exhibits: &'static [Exhibit],
}

/// What the steps of `chapter` show.
pub const fn gallery(chapter: &'static str, exhibits: &'static [Exhibit]) -> Gallery {
    Gallery { chapter, exhibits }
}
