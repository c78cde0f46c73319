//! What a run is asked for.

use chapters::vocabulary::Part;

/// What a run does with the steps it is about; figures are drawn beside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Parts {
    /// Units, derivations and checks.
    pub checks: bool,
    /// Extreme cases.
    pub stress: bool,
    /// Error against run time.
    pub races: bool,
}

impl Parts {
    /// Whether `part` is run.
    pub fn has(self, part: Part) -> bool {
        match part {
            Part::Checks => self.checks,
            Part::Stress => self.stress,
            Part::Races => self.races,
            Part::Figures => false,
        }
    }

    /// One part alone; none if it is the figures.
    pub fn only(part: Part) -> Self {
        Self { checks: part == Part::Checks, stress: part == Part::Stress, races: part == Part::Races }
    }
}
