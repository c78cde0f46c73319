//! Films of samples, and how what they hold is shown.

use super::Request;
use super::help::HelpArg;
use super::values::stops;
use crate::film::Merge;
use crate::render::Shown;
use crate::stop::Stop;
use clap::{Args, Subcommand, ValueEnum, ValueHint};
use light::tone::Curve;
use std::path::PathBuf;

pub const FILM_EXAMPLES: &str = "\
Examples:
  lesson render cornell --samples 0..64 --film a.film
  lesson render cornell --samples 64..128 --film b.film
  lesson film merge a.film b.film --out c.png --out c.film
  lesson film show c.film

Films are put together bit for bit, in whatever order: of one scene, size, seed
and integrator, and no sample in two of them.";

#[derive(Debug, Subcommand)]
pub enum FilmCommand {
    /// Put films together: into pictures, into one film.
    Merge {
        /// The films.
        #[arg(required = true, value_hint = ValueHint::FilePath)]
        films: Vec<PathBuf>,
        /// A file for what comes of it, .png, .exr, .pfm or .film; may be repeated.
        #[arg(long, value_name = "FILE", required = true, value_hint = ValueHint::AnyPath)]
        out: Vec<PathBuf>,
        #[command(flatten)]
        shown: ShownArgs,
        #[command(flatten)]
        help: HelpArg,
    },
    /// Print what is in a film: scene, samples, how they were made, how wrong the picture is.
    Show {
        /// The film.
        #[arg(value_hint = ValueHint::FilePath)]
        film: PathBuf,
        #[command(flatten)]
        help: HelpArg,
    },
}

impl FilmCommand {
    pub fn into_request(self) -> Result<Request, Stop> {
        Ok(match self {
            Self::Merge { films, out, shown, .. } => Request::Merge(Merge { films, out, shown: shown.into() }),
            Self::Show { film, .. } => Request::Show { film },
        })
    }
}

/// How radiance is shown.
#[derive(Debug, Args)]
pub struct ShownArgs {
    /// How radiance is brought into a screen's range.
    #[arg(long, value_enum, help = "How radiance is brought into a screen's range [default: none]")]
    tone: Option<ToneArg>,
    /// Stops by which the PNG is brighter, -30 to 30.
    #[arg(long, value_name = "STOPS", value_parser = stops, allow_negative_numbers = true, default_value_t = 0.0)]
    exposure: f64,
}

impl From<ShownArgs> for Shown {
    fn from(args: ShownArgs) -> Self {
        Self { curve: args.tone.map_or(Curve::None, Curve::from), exposure: args.exposure }
    }
}

/// A tone curve's word.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum ToneArg {
    /// Cut at white.
    None,
    /// By luminance, white at 4.
    Reinhard,
    /// Like a film's.
    Aces,
    /// Bright colours fade to white.
    Agx,
}

impl From<ToneArg> for Curve {
    fn from(word: ToneArg) -> Self {
        match word {
            ToneArg::None => Self::None,
            ToneArg::Reinhard => Self::Reinhard,
            ToneArg::Aces => Self::Aces,
            ToneArg::Agx => Self::Agx,
        }
    }
}
