//! Parts of the lecture, and what to do with them.

use super::values::assignment;
use super::{FOLDER, Lesson, Request, commands};
use crate::figures::Format;
use crate::stop::Stop;
use clap::{Args, ValueEnum, ValueHint};
use std::path::PathBuf;
use views::block::Details;
use views::report::Parts;

/// The Courant number of `--unstable`: its waves fill the range of a double within some thousand steps.
const BEYOND: &str = "1.02";

#[derive(Debug, Args)]
pub struct LessonArgs {
    /// A chapter, an address such as fresnel/energy/r_plus_t, or `all`; without one, a map of the chapters.
    pub chapter: Option<String>,
    /// A step of the chapter, and perhaps one item of the step.
    #[arg(num_args = 0..=3)]
    step: Vec<String>,
    /// Only the checks: units, derivations, and everything that a number could refute.
    #[arg(long)]
    check: bool,
    /// Only the extreme cases: reference, textbook form and ours, with the digits each keeps.
    #[arg(long)]
    stress: bool,
    /// Only the races: error against run time.
    #[arg(long)]
    race: bool,
    /// Write the figures and print their paths; alone it also runs the checks and the races, and draws those too.
    #[arg(long)]
    plot: bool,
    /// Folder for the figures.
    #[arg(long, value_name = "DIR", help = format!("Folder for the figures [default: {FOLDER}]"), value_hint = ValueHint::DirPath)]
    out: Option<PathBuf>,
    /// Format of the figures.
    #[arg(long, value_enum, help = "Format of the figures [default: png]")]
    format: Option<FormatArg>,
    /// Change a parameter of the selected steps: n_t=2.4, n_t=gold, theta=56.3deg, wavelength=550nm.
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    set: Vec<(String, String)>,
    /// Step a grid beyond its Courant limit and show what happens: --set unstable=1, and courant=1.02 if none is set.
    #[arg(long)]
    unstable: bool,
    /// Show the unit of every line of a derivation.
    #[arg(long)]
    units: bool,
    /// Show the single steps inside the lines of a derivation.
    #[arg(long)]
    unfold: bool,
    /// Everything at once, on a terminal too, and no questions that wait for an answer.
    #[arg(long)]
    plain: bool,
    /// The ten-minute way through a chapter: of each step its claim, how its text begins, its key equation and a figure.
    #[arg(long, conflicts_with_all = ["check", "stress", "race", "plot", "json", "units", "unfold"])]
    short: bool,
    /// The report as one JSON document on standard output.
    #[arg(long)]
    json: bool,
    /// This; after a chapter or a step, what it has and what can be set there.
    #[arg(short, long)]
    pub help: bool,
}

impl LessonArgs {
    pub fn words(&self) -> Vec<String> {
        self.chapter.iter().chain(&self.step).cloned().collect()
    }

    pub fn is_bare(&self) -> bool {
        let flags = self.check
            || self.stress
            || self.race
            || self.plot
            || self.units
            || self.unfold
            || self.plain
            || self.short
            || self.json
            || self.unstable;
        !flags && self.set.is_empty() && self.out.is_none() && self.format.is_none()
    }

    pub fn into_request(self) -> Result<Request, Stop> {
        for (flag, given) in [("--out", self.out.is_some()), ("--format", self.format.is_some())] {
            if given && !self.plot {
                return Err(Stop::at(flag, "needs --plot"));
            }
        }
        let is_set = |name: &str| self.set.iter().any(|(own, _)| own == name);
        let beyond = [("unstable", "1"), ("courant", BEYOND)].into_iter().filter(|(name, _)| !is_set(name));
        let beyond = beyond.map(|(name, value)| (name.to_owned(), value.to_owned()));
        let beyond: Vec<_> = beyond.filter(|_| self.unstable).collect();
        Ok(Request::Lesson(Lesson {
            words: self.words(),
            commands: commands(),
            parts: Parts { checks: self.check, stress: self.stress, races: self.race },
            plot: self.plot,
            out: self.out.unwrap_or_else(|| FOLDER.into()),
            format: format(self.format),
            changes: self.set.into_iter().chain(beyond).collect(),
            details: Details { units: self.units, unfold: self.unfold },
            plain: self.plain,
            short: self.short,
            json: self.json,
        }))
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum FormatArg {
    /// Pixels.
    Png,
    /// Vectors.
    Svg,
}

pub fn format(word: Option<FormatArg>) -> Format {
    match word {
        Some(FormatArg::Svg) => Format::Svg,
        Some(FormatArg::Png) | None => Format::Png,
    }
}
