//! The words in which an exercise is written: all data.
//!
//! ```ignore
//! exercise("brewster", "the angle at which no p light comes back", files!("brewster"))
//!     .of("fresnel/brewster", &[claim("minimum", "…"), claim("square", "…")])
//!     .asks("brewster_angle", &[real("n_i", "1"), real("n_t", "1")], one("rad"), &Of::<fn(f64, f64) -> f64>::NEW)
//!     .slips(&[slip("degrees: angles are in radians here", |x| vec![(x[1] / x[0]).atan().to_degrees()])])
//! ```

use super::formula::Formula;

/// A formula that the learner writes and a chapter's own checks judge.
#[derive(Clone, Copy)]
pub struct Exercise {
    /// What it is called on the command line; also its folder.
    pub name: &'static str,
    /// What is asked, in half a sentence.
    pub says: &'static str,
    /// The step whose checks judge it, `chapter/step`.
    pub step: &'static str,
    /// Those checks.
    pub claims: &'static [Claimed],
    /// The extreme cases that it must stand too, by id.
    pub extremes: &'static [&'static str],
    /// The learner's function.
    pub function: &'static str,
    /// What it takes.
    pub takes: &'static [Taken],
    /// What it gives.
    pub gives: Given,
    /// The type of the checks' subjects.
    pub formula: &'static dyn Formula,
    /// Mistakes that are known beside those that the checks have planted.
    pub slips: &'static [Slip],
    /// Its folder.
    pub files: Files,
}

/// What is in an exercise's folder.
#[derive(Clone, Copy)]
pub struct Files {
    /// What is asked, with the function's signature.
    pub task: &'static str,
    /// The function with a hole.
    pub start: &'static str,
    /// The function.
    pub solution: &'static str,
    /// From the idea to the formula; an empty line between two.
    hints: &'static str,
}

impl Files {
    /// Of texts.
    pub const fn new([task, start, solution, hints]: [&'static str; 4]) -> Self {
        Self { task, start, solution, hints }
    }

    /// One after the other.
    pub fn hints(&self) -> Vec<&'static str> {
        self.hints.split("\n\n").map(str::trim).filter(|hint| !hint.is_empty()).collect()
    }
}

/// The files of the exercise of that name, as they are when the program is made.
macro_rules! files {
    ($name:literal) => {
        $crate::exercise::vocabulary::Files::new([
            include_str!(concat!("../../../exercises/", $name, "/task.md")),
            include_str!(concat!("../../../exercises/", $name, "/start.rs")),
            include_str!(concat!("../../../exercises/", $name, "/solution.rs")),
            include_str!(concat!("../../../exercises/", $name, "/hints.md")),
        ])
    };
}
pub(super) use files;

/// A check of the step that judges the learner's formula.
#[derive(Clone, Copy)]
pub struct Claimed {
    /// Its id.
    pub id: &'static str,
    /// Which idea is missing where the learner's numbers are those of its planted slip.
    pub idea: &'static str,
}

/// The check of that id, and which idea its planted slip lacks.
pub const fn claim(id: &'static str, idea: &'static str) -> Claimed {
    Claimed { id, idea }
}

/// An argument.
#[derive(Clone, Copy)]
pub struct Taken {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its type.
    pub kind: Kind,
}

/// The type of an argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// `f64`.
    Real,
    /// `u32`.
    Whole,
    /// `[f64; 3]`.
    Triple,
}

impl Kind {
    /// As Rust has it.
    pub fn rust(self) -> &'static str {
        match self {
            Self::Real => "f64",
            Self::Whole => "u32",
            Self::Triple => "[f64; 3]",
        }
    }

    /// How many numbers it is made of.
    pub fn numbers(self) -> usize {
        if self == Self::Triple { 3 } else { 1 }
    }
}

/// A number in that unit.
pub const fn real(name: &'static str, unit: &'static str) -> Taken {
    Taken { name, unit, kind: Kind::Real }
}

/// A whole number.
pub const fn whole(name: &'static str) -> Taken {
    Taken { name, unit: "1", kind: Kind::Whole }
}

/// A vector's three parts in that unit.
pub const fn triple(name: &'static str, unit: &'static str) -> Taken {
    Taken { name, unit, kind: Kind::Triple }
}

/// A result.
#[derive(Clone, Copy)]
pub struct Given {
    /// Its unit.
    pub unit: &'static str,
    /// Its type.
    pub kind: Kind,
}

/// One number in that unit.
pub const fn one(unit: &'static str) -> Given {
    Given { unit, kind: Kind::Real }
}

/// A vector in that unit.
pub const fn three(unit: &'static str) -> Given {
    Given { unit, kind: Kind::Triple }
}

/// A mistake that is known.
#[derive(Clone, Copy)]
pub struct Slip {
    /// What it is, and which idea is missing.
    pub says: &'static str,
    /// What it gives.
    pub formula: fn(&[f64]) -> Vec<f64>,
}

/// The mistake that gives what this formula does.
pub const fn slip(says: &'static str, formula: fn(&[f64]) -> Vec<f64>) -> Slip {
    Slip { says, formula }
}

/// An exercise that does not yet say who judges it.
#[derive(Clone, Copy)]
pub struct Named {
    name: &'static str,
    says: &'static str,
    files: Files,
}

/// The exercise of that name: what is asked, and its folder.
pub const fn exercise(name: &'static str, says: &'static str, files: Files) -> Named {
    Named { name, says, files }
}

/// An exercise that does not yet say what it asks for.
#[derive(Clone, Copy)]
pub struct Judged {
    named: Named,
    step: &'static str,
    claims: &'static [Claimed],
}

impl Named {
    /// Judged by checks of a step.
    pub const fn of(self, step: &'static str, claims: &'static [Claimed]) -> Judged {
        Judged { named: self, step, claims }
    }
}

impl Judged {
    /// The learner's function, and the type of the checks' subjects for which it stands.
    pub const fn asks(
        self,
        function: &'static str,
        takes: &'static [Taken],
        gives: Given,
        formula: &'static dyn Formula,
    ) -> Exercise {
        let Self { named: Named { name, says, files }, step, claims } = self;
        Exercise { name, says, step, claims, extremes: &[], function, takes, gives, formula, slips: &[], files }
    }
}

impl Exercise {
    /// With extreme cases of the step that it must stand too.
    pub const fn stands(self, extremes: &'static [&'static str]) -> Self {
        Self { extremes, ..self }
    }

    /// With mistakes that the checks have not planted.
    pub const fn slips(self, slips: &'static [Slip]) -> Self {
        Self { slips, ..self }
    }

    /// What the learner's function is to look like.
    pub fn signature(&self) -> String {
        let takes: Vec<String> = self.takes.iter().map(|one| format!("{}: {}", one.name, one.kind.rust())).collect();
        format!("pub fn {}({}) -> {}", self.function, takes.join(", "), self.gives.kind.rust())
    }

    /// The chapter that it is of.
    pub fn chapter(&self) -> &'static str {
        self.step.split('/').next().unwrap_or_default()
    }
}
