//! The preprocessor that mdBook runs.

use super::Request;
use super::help::HelpArg;
use clap::{Args, Subcommand};

pub const MDBOOK_EXAMPLES: &str = "\
In book.toml:
  [preprocessor.lesson]
  command = \"lesson mdbook\"
  before = [\"links\"]
  races = true        # error against run time, measured where the book is built
  cache = true        # what was computed is kept for the next build
  strict = false      # true: no book when a verdict is against the lecture
  live = []           # chapters whose modules the book brings: figures answer

In a page, on a line of its own, a chapter, a step or an item of one; within a
line a number that a step computes; behind it what is set:
  {{#lesson fresnel/brewster}}
  {{#lesson fresnel/brewster/square}}
  {{#lesson fresnel/metals/colour n_t=gold}}
  the angle is {{#lesson fresnel/brewster/theta_b n_t=1.5}}

The chapters as a list, the steps of one with a page for each below the page
that asks for them, the lecture's rows and where each is taught, the exercises:
  {{#lesson-chapters}}
  {{#lesson-steps fresnel}}
  {{#lesson-coverage}}
  {{#lesson-exercises}}
`[text](lesson:fresnel/brewster)` leads to the page that shows it.

`lesson contents` lists the steps, `lesson fresnel brewster --help` what one has.
A backslash before {{#lesson …}} leaves it as it stands.";

#[derive(Debug, Args)]
pub struct MdbookArgs {
    #[command(subcommand)]
    asked: Option<Asked>,
    #[command(flatten)]
    help: HelpArg,
}

#[derive(Debug, Subcommand)]
enum Asked {
    /// Tell mdBook by the exit status whether pages of a renderer can show the lecture.
    Supports {
        /// The renderer's name.
        renderer: String,
        #[command(flatten)]
        help: HelpArg,
    },
}

impl From<MdbookArgs> for Request {
    fn from(args: MdbookArgs) -> Self {
        match args.asked {
            Some(Asked::Supports { renderer, .. }) => Self::Supports { renderer },
            None => Self::Mdbook,
        }
    }
}
