//! The command line: the only place that knows clap.
//!
//! | what | where |
//! |---|---|
//! | parts of the lecture | [`lesson`] |
//! | functions called, expressions proved | [`call`] |
//! | pictures, films of samples | [`render`], [`film`] |
//! | the lecture in books | [`mdbook`] |
//! | exercises | [`exercise`] |
//! | values of options | [`values`] |
//! | how to use it, what was wrong | [`help`], [`refusal`] |

mod call;
mod exercise;
mod film;
mod help;
mod lesson;
mod mdbook;
mod refusal;
mod render;
mod values;

use crate::exercise::Ask;
use crate::figures::Format;
use crate::film::Merge;
use crate::prove::Question;
use crate::render::Job;
use crate::stop::Stop;
use call::{EVAL_EXAMPLES, EvalArgs, PROVE_EXAMPLES, ProveArgs};
use clap::{ArgAction, CommandFactory, FromArgMatches, Parser, Subcommand};
use clap_complete::Shell;
pub use exercise::EXERCISES;
use exercise::{EXERCISE_EXAMPLES, ExerciseCommand};
use film::{FILM_EXAMPLES, FilmCommand};
use help::{HelpArg, after_help, completions, help, styled};
use lesson::LessonArgs;
use mdbook::{MDBOOK_EXAMPLES, MdbookArgs};
use refusal::refusal;
use render::{RENDER_EXAMPLES, RenderArgs};
use std::path::PathBuf;
use views::block::Details;
use views::report::Parts;

/// What was asked for.
#[derive(Debug)]
pub enum Request {
    /// The chapters, and what to type next.
    Map,
    /// The steps of a chapter, or of all.
    Contents { chapter: Option<String> },
    /// How to use the program, or its version: to be printed as it is.
    Help { text: String },
    /// What a part of the curriculum has, and what can be set there.
    About { words: Vec<String>, commands: Vec<String> },
    /// A chapter, a step, an item, or everything.
    Lesson(Lesson),
    /// The lecture's rows.
    Coverage { json: bool },
    /// One call of a checked function.
    Eval { function: String, arguments: Vec<(String, String)>, json: bool },
    /// A stream of calls.
    EvalLines { function: String },
    /// What can be called.
    Functions { json: bool },
    /// How much of each chapter was read.
    Progress,
    /// Whether one expression or equation leads to another.
    Prove(Question),
    /// The lecture's scenes.
    Scenes,
    /// The keys of scene files.
    Keys,
    /// A scene as a file.
    Print { scene: String, out: Option<PathBuf> },
    /// A picture of a scene.
    Render(Box<Job>),
    /// Films put together.
    Merge(Merge),
    /// What is in a film.
    Show { film: PathBuf },
    /// An mdBook, from standard input to standard output.
    Mdbook,
    /// Whether a renderer of mdBook can show it.
    Supports { renderer: String },
    /// Exercises: which there are, one laid out, judged, helped with.
    Exercise(Ask),
    /// A script for the shell.
    Completions(Vec<u8>),
}

/// What to do with which part of the curriculum.
#[derive(Debug)]
pub struct Lesson {
    /// Chapter, step, or address.
    pub words: Vec<String>,
    /// What else may stand in the first one's place.
    pub commands: Vec<String>,
    /// Parts asked for by flags.
    pub parts: Parts,
    /// Whether figures are written.
    pub plot: bool,
    /// Where to.
    pub out: PathBuf,
    /// As what.
    pub format: Format,
    /// `--set`, in order.
    pub changes: Vec<(String, String)>,
    /// What is shown of derivations.
    pub details: Details,
    /// Everything at once, on a terminal too.
    pub plain: bool,
    /// The short way.
    pub short: bool,
    /// One JSON document instead of text.
    pub json: bool,
}

impl Lesson {
    /// Whether the whole lecture was asked for.
    pub fn is_all(&self) -> bool {
        matches!(&self.words[..], [word] if word.eq_ignore_ascii_case("all"))
    }
}

/// Where figures go if nothing else is said.
pub const FOLDER: &str = "lesson-out";

/// Reads the command line.
pub fn parse() -> Result<Request, Stop> {
    let cli = match command().try_get_matches().and_then(|found| Cli::from_arg_matches(&found)) {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => return Err(refusal(&error)),
        Err(help) => return Ok(Request::Help { text: styled(&help.render()) }),
    };
    match cli.command {
        None if cli.lesson.help => Ok(help(cli.lesson.words())),
        Some(Command::Help { words, .. }) => Ok(help(words)),
        None if cli.lesson.chapter.is_none() => match cli.lesson.is_bare() {
            true => Ok(Request::Map),
            false => Err(Stop::at("chapter", "missing: these options need one, or `all`")),
        },
        None => cli.lesson.into_request(),
        Some(Command::Contents { chapter, .. }) => Ok(Request::Contents { chapter }),
        Some(Command::Coverage { json, .. }) => Ok(Request::Coverage { json }),
        Some(Command::Progress { .. }) => Ok(Request::Progress),
        Some(Command::Eval(eval)) => eval.into_request(),
        Some(Command::Prove(prove)) => Ok(Request::Prove(prove.into())),
        Some(Command::Render(render)) => render.into_request(),
        Some(Command::Film { command, .. }) => {
            command.map_or_else(|| Ok(help(vec!["film".to_owned()])), FilmCommand::into_request)
        }
        Some(Command::Mdbook(mdbook)) => Ok(mdbook.into()),
        Some(Command::Exercise { command, .. }) => {
            Ok(command.map_or_else(|| help(vec!["exercise".to_owned()]), ExerciseCommand::into_request))
        }
        Some(Command::Completions { shell, .. }) => Ok(Request::Completions(completions(shell))),
    }
}

/// The command line. Of the lecture's own options the last one counts where it is given twice; other commands refuse that.
fn command() -> clap::Command {
    /// Each command tells the version of the one program that there is.
    fn named(command: clap::Command) -> clap::Command {
        command.display_name("lesson").mut_subcommands(named)
    }
    named(Cli::command()).mut_args(|argument| match argument.get_action() {
        ArgAction::Set | ArgAction::SetTrue if !argument.is_positional() => {
            let own = argument.get_id().clone();
            argument.overrides_with(own)
        }
        _ => argument,
    })
}

/// A lecture on the physics of rendering that proves itself.
#[derive(Debug, Parser)]
#[command(name = "lesson", version, after_help = after_help(), disable_help_flag = true, disable_help_subcommand = true, args_conflicts_with_subcommands = true, propagate_version = true, max_term_width = 80)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    lesson: LessonArgs,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// The steps of a chapter, or of every chapter, one line each.
    Contents {
        /// The chapter.
        chapter: Option<String>,
        #[command(flatten)]
        help: HelpArg,
    },
    /// The lecture's rows: chapter, steps, and which evidence each has or still lacks.
    Coverage {
        /// As one JSON document.
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        help: HelpArg,
    },
    /// How many steps of each chapter you have seen in the reader, where you were, and which exercises are solved.
    Progress {
        #[command(flatten)]
        help: HelpArg,
    },
    /// Call a checked function, once or for every line of JSON on standard input.
    #[command(after_help = EVAL_EXAMPLES)]
    Eval(EvalArgs),
    /// Prove that two expressions are equal, or that one equation follows from another; or find where it fails.
    #[command(after_help = PROVE_EXAMPLES)]
    Prove(ProveArgs),
    /// Make a picture of a scene: one of the lecture's, or a file's.
    #[command(after_help = RENDER_EXAMPLES)]
    Render(RenderArgs),
    /// Put films of `lesson render --film` together, or see what is in one.
    #[command(after_help = FILM_EXAMPLES, disable_help_subcommand = true)]
    Film {
        #[command(subcommand)]
        command: Option<FilmCommand>,
        #[command(flatten)]
        help: HelpArg,
    },
    /// Put parts of the lecture into an mdBook: the preprocessor that mdBook runs.
    #[command(after_help = MDBOOK_EXAMPLES, disable_help_subcommand = true)]
    Mdbook(MdbookArgs),
    /// Formulas for you to write, judged by the chapters' own checks.
    #[command(after_help = EXERCISE_EXAMPLES, disable_help_subcommand = true)]
    Exercise {
        #[command(subcommand)]
        command: Option<ExerciseCommand>,
        #[command(flatten)]
        help: HelpArg,
    },
    /// Print a completion script for a shell.
    ///
    /// For bash: lesson completions bash > ~/.local/share/bash-completion/completions/lesson
    Completions {
        /// The shell.
        shell: Shell,
        #[command(flatten)]
        help: HelpArg,
    },
    /// Help on the program, a command, a chapter or a step.
    Help {
        /// What it is about.
        words: Vec<String>,
        #[command(flatten)]
        help: HelpArg,
    },
}

/// The words that may stand where a chapter's name may stand.
fn commands() -> Vec<String> {
    Cli::command().get_subcommands().map(|command| command.get_name().to_owned()).chain(["all".to_owned()]).collect()
}

#[cfg(test)]
mod tests {
    use super::values::assignment;
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn every_command_and_every_argument_says_what_it_is_for() {
        let mut command = Cli::command();
        command.build();
        for command in std::iter::once(&command).chain(command.get_subcommands()) {
            assert!(command.get_about().is_some(), "{}", command.get_name());
            for argument in command.get_arguments() {
                assert!(argument.get_help().is_some(), "{} {}", command.get_name(), argument.get_id());
            }
        }
    }

    #[test]
    fn assignments_need_both_sides() {
        assert_eq!(assignment("layers=[{\"n\":1}]=x"), Ok(("layers".into(), "[{\"n\":1}]=x".into())));
        for bad in ["theta", "=1", "theta="] {
            assert!(assignment(bad).is_err(), "{bad}");
        }
    }
}
