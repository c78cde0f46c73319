//! The command line: the only place that knows clap.

use crate::figures::Format;
use crate::film::Merge;
use crate::out;
use crate::prove::Question;
use crate::render::{Course, Goal, Job, MOST as MOST_SAMPLES, Shown};
use crate::stop::Stop;
use chapters::parameter::{Fault, excerpt, parse_quantity};
use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{ArgAction, Args, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum, ValueHint};
use clap_complete::Shell;
use light::scene::builtin::BUILTIN;
use light::tone::Curve;
use std::error::Error;
use std::path::PathBuf;
use std::time::Duration;
use views::block::Details;
use views::page::Page;
use views::report::Parts;
use views::tell::Teller;
use views::terminal;

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
    /// One JSON document instead of text.
    pub json: bool,
}

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
        Some(Command::Eval(eval)) => eval.into_request(),
        Some(Command::Prove(prove)) => Ok(Request::Prove(prove.into())),
        Some(Command::Render(render)) => render.into_request(),
        Some(Command::Film { command, .. }) => {
            command.map_or_else(|| Ok(help(vec!["film".to_owned()])), FilmCommand::into_request)
        }
        Some(Command::Completions { shell, .. }) => Ok(Request::Completions(completions(shell))),
    }
}

/// The command line. Of the lecture's own options the last one counts where it is given twice; other commands refuse that.
fn command() -> clap::Command {
    Cli::command().mut_args(|argument| match argument.get_action() {
        ArgAction::Set | ArgAction::SetTrue if !argument.is_positional() => {
            let own = argument.get_id().clone();
            argument.overrides_with(own)
        }
        _ => argument,
    })
}

/// Help on the program, on one of its commands, or on a part of the curriculum.
fn help(words: Vec<String>) -> Request {
    let mut command = command();
    // Only then its commands know whose they are.
    command.build();
    let asked = match &words[..] {
        [] => Some(&mut command),
        [word] => command.find_subcommand_mut(word),
        _ => None,
    };
    match asked {
        Some(command) => Request::Help { text: styled(&command.render_help()) },
        None => Request::About { words, commands: commands() },
    }
}

/// clap's text, in colour where that is wanted.
fn styled(text: &StyledStr) -> String {
    if out::is_coloured() { text.ansi().to_string() } else { text.to_string() }
}

/// clap's refusal in the manner of all others: one line, the place first.
fn refusal(error: &clap::Error) -> Stop {
    let all = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => vec![text.clone()],
        Some(ContextValue::Strings(texts)) => texts.clone(),
        _ => Vec::new(),
    };
    let first = |kind| all(kind).into_iter().next().unwrap_or_default();
    let (place, value) = (first(ContextKind::InvalidArg), first(ContextKind::InvalidValue));
    match error.kind() {
        // clap would advise to pass the option as a value, which none of ours can be.
        ErrorKind::UnknownArgument if place.starts_with('-') => {
            let meant = first(ContextKind::SuggestedArg);
            let meant = if meant.is_empty() { meant } else { format!(" (did you mean `{meant}`?)") };
            Stop::at(excerpt(&place), format!("unknown option{meant}; `--help` lists them"))
        }
        ErrorKind::UnknownArgument => Stop::at(excerpt(&place), "one word too many; `--help` tells what is taken"),
        ErrorKind::InvalidSubcommand => {
            let word = first(ContextKind::InvalidSubcommand);
            Stop::at(excerpt(&word), "unknown word; `--help` tells what may stand here")
        }
        ErrorKind::TooManyValues => Stop::at(excerpt(&value), "one word too many; `--help` tells what is taken"),
        ErrorKind::InvalidValue if value.is_empty() => Stop::at(argument(&place), "needs a value"),
        ErrorKind::InvalidValue => {
            let unknown = format!("`{}` is none of its words", excerpt(&value));
            Fault::unknown(argument(&place), value, unknown, all(ContextKind::ValidValue)).into()
        }
        ErrorKind::ValueValidation => {
            let why = error.source().map_or("not valid".to_owned(), ToString::to_string);
            let found = format!("`{}`", excerpt(&value));
            let found = if why.contains(&found) { String::new() } else { format!(", found {found}") };
            Stop::at(argument(&place), format!("{why}{found}"))
        }
        ErrorKind::ArgumentConflict if !place.is_empty() => {
            let other = argument(&first(ContextKind::PriorArg));
            match other == argument(&place) {
                true => Stop::at(other, "given twice; valid: once"),
                false => Stop::at(argument(&place), format!("cannot stand beside {other}")),
            }
        }
        ErrorKind::MissingRequiredArgument => Stop::at(argument(&place), "missing; `--help` tells what it may be"),
        _ => {
            let text = error.to_string();
            let line = text.lines().next().unwrap_or_default();
            Stop::Refused(line.strip_prefix("error: ").unwrap_or(line).to_owned())
        }
    }
}

/// The name of an argument as one types it, of `--format <FORMAT>`, `<SHELL>` or `[NAME=VALUE]...`.
fn argument(face: &str) -> String {
    let name = face.split(' ').next().unwrap_or_default();
    match name.starts_with('-') {
        true => name.to_owned(),
        false => name.trim_matches(['<', '>', '[', ']', '.']).to_lowercase(),
    }
}

const EXAMPLES: &str = "\
Examples:
  lesson                                   the chapters, and what to type next
  lesson contents fresnel                  the steps of a chapter, one line each
  lesson fresnel                           walk through a chapter
  lesson fresnel brewster                  one step
  lesson fresnel brewster --help           what it has, and what can be set
  lesson fresnel/energy/r_plus_t           one check, by its address
  lesson fresnel --plot                    write every figure, check, race
  lesson fresnel --plot --set n_t=gold --set wavelength=550nm --out figures
  lesson fresnel --check --stress --race --json > report.json
  lesson all --check                       does it all still hold?
  lesson eval fresnel n_i=1 n_t=1.5 theta=56.3deg
  lesson eval fresnel --json-lines < inputs.jsonl > outputs.jsonl
  lesson fresnel r_s --units --unfold      every line, its unit and its steps
  lesson prove \"sin(a)^2 - sin(b)^2\" \"sin(a+b)*sin(a-b)\"
  lesson coverage                          which rows have what evidence

On a terminal the walk is read screen by screen: Enter (or n, space) for the
next, b for the one before, p to plot the step's figures, ? for the keys, q to
leave. Elsewhere a whole chapter shows its evidence in one line an item; --check
shows what was found, --unfold all of it.

Exit status: 0 if everything holds, 1 if a check broke, 2 if it could not run.

Signs:
";

/// [`EXAMPLES`], and what the signs in a report mean.
fn after_help() -> String {
    let mut signs = Page::new(80, false);
    let teller = Teller::english(Details::default());
    terminal::set(&mut signs, teller.words(), &teller.legend());
    format!("{EXAMPLES}{}", signs.into_text().trim_end())
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

/// The option that shows a command's help.
#[derive(Debug, Args)]
struct HelpArg {
    /// This.
    #[arg(short, long, action = ArgAction::Help)]
    help: Option<bool>,
}

const EVAL_EXAMPLES: &str = "\
Examples:
  lesson eval --list
  lesson eval fresnel n_i=1 n_t=1.5 theta=56.3deg
  lesson eval fresnel n_i=1 n_t=gold wavelength=550nm theta=45deg --json
  lesson eval thin-film wavelength=550nm n_i=1 theta=0 pol=s \\
      'layers=[{\"n\":\"mgf2\",\"d\":\"99.6nm\"}]' 'substrate={\"n\":1.52}'
  echo '{\"n_i\":1,\"n_t\":1.5,\"theta\":0.98}' | lesson eval fresnel --json-lines

Every output is printed as `name value` with 17 significant digits, so that the
double survives. With --json-lines a bad line gives {\"error\": …} in its place,
and the exit status is 2 at the end.";

const PROVE_EXAMPLES: &str = "\
Examples:
  lesson prove \"sin(a)^2 - sin(b)^2\" \"sin(a+b)*sin(a-b)\"
  lesson prove \"n1*cos(t1)\" \"n2*cos(t2)\" --given \"n1*sin(t1)=n2*sin(t2)\"
  lesson prove \"x + y = 2\" \"y = 2 - x\"
  lesson prove \"sqrt(x^2)\" \"|x|\" --real x

Written as on paper: + - * / ^, brackets, 2x, sin 2x, sqrt(x), |x|, conj(z),
Re(z), e^(i x), pi, i; names theta_1, theta1, θ₁, E_1'. What could mean two
things is refused.

Every name stands for a positive number, unless --given says otherwise or --real
names it. Proved means for all of them, where what the answer names is not zero;
a refutation names a point. Of a --given product that is zero every factor may
be: what is proved holds in each case. Undecided are nested roots, and relations
between sines of different numbers.

Exit status: 0 if proved, 1 if refuted, 2 if undecided or unreadable.";

#[derive(Debug, Args)]
struct ProveArgs {
    /// An expression, or an equation.
    #[arg(allow_hyphen_values = true)]
    from: String,
    /// What it is equal to; or the equation that follows.
    #[arg(allow_hyphen_values = true)]
    to: String,
    /// An equation that holds besides.
    #[arg(long, value_name = "EQUATION", allow_hyphen_values = true)]
    given: Vec<String>,
    /// Names that stand for real numbers of either sign.
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    real: Vec<String>,
    /// The single steps inside the lines.
    #[arg(long)]
    unfold: bool,
    /// The answer as one JSON document.
    #[arg(long)]
    json: bool,
    // No -h: it would be taken out of -theta.
    /// This.
    #[arg(long, action = ArgAction::Help)]
    help: Option<bool>,
}

impl From<ProveArgs> for Question {
    fn from(args: ProveArgs) -> Self {
        let ProveArgs { from, to, given, real, unfold, json, help: _ } = args;
        Self { from, to, given, real, unfold, json }
    }
}

/// Where figures go if nothing else is said.
pub const FOLDER: &str = "lesson-out";

/// The Courant number of `--unstable`: its waves fill the range of a double within some thousand steps.
const BEYOND: &str = "1.02";

#[derive(Debug, Args)]
struct LessonArgs {
    /// A chapter, an address such as fresnel/energy/r_plus_t, or `all`; without one, a map of the chapters.
    chapter: Option<String>,
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
    /// The report as one JSON document on standard output.
    #[arg(long)]
    json: bool,
    /// This; after a chapter or a step, what it has and what can be set there.
    #[arg(short, long)]
    help: bool,
}

impl LessonArgs {
    fn words(&self) -> Vec<String> {
        self.chapter.iter().chain(&self.step).cloned().collect()
    }

    fn is_bare(&self) -> bool {
        let flags = self.check
            || self.stress
            || self.race
            || self.plot
            || self.units
            || self.unfold
            || self.plain
            || self.json
            || self.unstable;
        !flags && self.set.is_empty() && self.out.is_none() && self.format.is_none()
    }

    fn into_request(self) -> Result<Request, Stop> {
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
            json: self.json,
        }))
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum FormatArg {
    /// Pixels.
    Png,
    /// Vectors.
    Svg,
}

fn format(word: Option<FormatArg>) -> Format {
    match word {
        Some(FormatArg::Svg) => Format::Svg,
        Some(FormatArg::Png) | None => Format::Png,
    }
}

#[derive(Debug, Args)]
struct EvalArgs {
    /// The function; `--list` names them all.
    #[arg(required_unless_present = "list")]
    function: Option<String>,
    /// Its inputs: a number, a text with a unit such as 56.3deg, or JSON for structured fields.
    #[arg(value_name = "NAME=VALUE", value_parser = assignment, conflicts_with_all = ["json_lines", "list"])]
    arguments: Vec<(String, String)>,
    /// Read one JSON object a line from standard input and write one a line, in order.
    #[arg(long, conflicts_with = "list")]
    json_lines: bool,
    /// Document every function: inputs, units, domains, outputs.
    #[arg(long)]
    list: bool,
    /// The outputs, or with --list the documentation, as one JSON document.
    #[arg(long, conflicts_with = "json_lines")]
    json: bool,
    #[command(flatten)]
    help: HelpArg,
}

impl EvalArgs {
    fn into_request(self) -> Result<Request, Stop> {
        Ok(match self.function {
            _ if self.list => Request::Functions { json: self.json },
            Some(function) if self.json_lines => Request::EvalLines { function },
            Some(function) => Request::Eval { function, arguments: self.arguments, json: self.json },
            None => return Err(Stop::at("function", "missing; `lesson eval --list` names them")),
        })
    }
}

const RENDER_EXAMPLES: &str = "\
Examples:
  lesson render --list
  lesson render --keys                     what a scene file may say
  lesson render cornell                    64 samples a pixel, as a PNG
  lesson render cornell --time 20s --out cornell.png --out cornell.pfm
  lesson render cornell --error 0.02 --tone agx --exposure -1
  lesson render glass --explain --stats glass.json --error-map glass-error.png
  lesson render cornell --out all.exr      also variance, normals, albedo, depth
  lesson render cornell --time 20s --race --plot
  lesson render cornell --integrator hemisphere --spp 16
  lesson render cornell --print > my.toml  the scene as a file
  lesson render mesh --print --out scenes  with the mesh that it names
  lesson render my.toml --spp 256 --width 640 --out my.png
  lesson render cornell --spp 4096 --film c.film
  lesson render cornell --samples 64..128 --film b.film

Scenes are TOML or JSON: metres, linear RGB, radiance in W m⁻² sr⁻¹; --keys
tells what they may say. What is wrong with one is told with its line. Of --spp, --time
and --error the first that is reached ends the work. The relative error is the
root of the mean over pixels and channels of (x − truth)²/(truth² + 0.01), as the
picture's two independent halves tell it. Same scene and seed, same picture,
whatever the number of threads.

Ctrl-C or a request to terminate ends the work after some tenths of a second, and
what there is of the picture is written; the exit status is then 130 or 143. A
second one ends the program at once.

A --film is kept at least every ten seconds, unless one pair of samples of the
whole picture takes longer. Whatever ends the program, the same line goes on from
there, and the picture is the one of a run that nothing ended, bit for bit. So is
that of films of other --samples, put together by `lesson film merge`.";

const FILM_EXAMPLES: &str = "\
Examples:
  lesson render cornell --samples 0..64 --film a.film
  lesson render cornell --samples 64..128 --film b.film
  lesson film merge a.film b.film --out c.png --out c.film
  lesson film show c.film

Films are put together bit for bit, in whatever order: of one scene, size, seed
and integrator, and no sample in two of them.";

#[derive(Debug, Subcommand)]
enum FilmCommand {
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
    fn into_request(self) -> Result<Request, Stop> {
        Ok(match self {
            Self::Merge { films, out, shown, .. } => Request::Merge(Merge { films, out, shown: shown.into() }),
            Self::Show { film, .. } => Request::Show { film },
        })
    }
}

#[derive(Debug, Args)]
struct RenderArgs {
    /// A scene of the lecture, or a file that ends in .toml or .json.
    #[arg(value_hint = ValueHint::FilePath)]
    scene: Option<String>,
    /// The scenes of the lecture, one line each.
    #[arg(long, conflicts_with_all = ["scene", "print", "out"])]
    list: bool,
    /// The keys of scene files: what each is, in which unit and range, and what holds without it.
    #[arg(long, conflicts_with_all = ["scene", "list", "print", "out"])]
    keys: bool,
    /// Print the scene as a TOML file.
    #[arg(long, conflicts_with_all = ["tone", "exposure"])]
    print: bool,
    /// A file for the picture, .png, .exr or .pfm; may be repeated. With --print: a .toml for the scene, or a folder for it,
    /// and its meshes beside. With --race --plot: a .png or .svg for the figure, or a folder for it.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::AnyPath)]
    out: Vec<PathBuf>,
    /// Samples a pixel; an odd number is taken as the next even one.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, MOST_SAMPLES), allow_negative_numbers = true, conflicts_with = "print")]
    spp: Option<u32>,
    /// Numbers of the samples, such as 64..128: from the first up to but without the second, both even.
    #[arg(long, value_name = "A..B", value_parser = sample_numbers, allow_hyphen_values = true, conflicts_with_all = ["spp", "print"])]
    samples: Option<[u32; 2]>,
    /// A file for the error of every pixel in false colours, .png or .svg.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["print", "race"], value_hint = ValueHint::FilePath)]
    error_map: Option<PathBuf>,
    /// A file for what the picture took and what is known of it, .json.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["print", "race"], value_hint = ValueHint::FilePath)]
    stats: Option<PathBuf>,
    /// Say what the scene needs, what was left out, and what that saves: measured within some seconds.
    #[arg(long, conflicts_with = "print")]
    explain: bool,
    /// Instead of a picture, race every integrator that fits the scene: error against run time. It takes as long as all of
    /// them, and eight times as long as one for the picture that stands for the truth.
    #[arg(long, conflicts_with_all = ["print", "error", "integrator", "film", "samples"])]
    race: bool,
    /// With --race: draw it too.
    #[arg(long, conflicts_with = "print")]
    plot: bool,
    /// Format of the figure.
    #[arg(long, value_enum, help = "Format of the figure [default: png]")]
    format: Option<FormatArg>,
    /// A film, .film: gone on from if it is there, and kept while rendering.
    #[arg(long, value_name = "FILE", conflicts_with = "print", value_hint = ValueHint::FilePath)]
    film: Option<PathBuf>,
    /// How long to render: 20s, 500ms, 2min, 1h; a number alone is seconds. With --race: the processors' time that each
    /// integrator has [default: 2s].
    #[arg(long, value_parser = duration, allow_hyphen_values = true, conflicts_with = "print")]
    time: Option<Duration>,
    /// The relative error that is good enough, above 0 and below 1.
    #[arg(long, value_parser = share, allow_hyphen_values = true, conflicts_with = "print")]
    error: Option<f64>,
    /// Of all random numbers.
    #[arg(long, default_value_t = 1, value_parser = seed, allow_hyphen_values = true, conflicts_with = "print")]
    seed: u64,
    /// Threads; as many as there are cores if left out.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, 1024), allow_negative_numbers = true, conflicts_with = "print")]
    threads: Option<u32>,
    /// The integrator: fast, or one to read: hemisphere, surface, lamps, both.
    #[arg(long, value_name = "NAME", conflicts_with = "print")]
    integrator: Option<String>,
    /// The most edges of a path, instead of the scene's.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, DEEPEST), allow_negative_numbers = true, conflicts_with = "print")]
    depth: Option<u32>,
    /// The picture's width [pixels], instead of the scene's; without --height the picture keeps its shape.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, u32::MAX), allow_negative_numbers = true, conflicts_with = "print")]
    width: Option<u32>,
    /// The picture's height [pixels], instead of the scene's; without --width the picture keeps its shape.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, u32::MAX), allow_negative_numbers = true, conflicts_with = "print")]
    height: Option<u32>,
    #[command(flatten)]
    shown: ShownArgs,
    #[command(flatten)]
    help: HelpArg,
}

/// How radiance is shown.
#[derive(Debug, Args)]
struct ShownArgs {
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

/// The processors' time of every integrator of a race, if nothing is said.
const RACE: Duration = Duration::from_secs(2);

/// The deepest path that can be asked for.
const DEEPEST: u32 = 1_000_000;

/// A tone curve's word.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum ToneArg {
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

/// A whole number from the first to the last.
fn whole(text: &str, first: u32, last: u32) -> Result<u32, String> {
    let number = text.parse().ok().filter(|number| (first..=last).contains(number));
    number.ok_or_else(|| format!("must be a whole number from {first} to {last}"))
}

fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("must be a whole number from 0 to {}", u64::MAX))
}

/// A time of at most a month.
fn duration(text: &str) -> Result<Duration, String> {
    const MONTH: f64 = 30.0 * 86_400.0;
    let seconds = parse_quantity(text, "s")?;
    match seconds > 0.0 && seconds <= MONTH {
        true => Ok(Duration::from_secs_f64(seconds)),
        false => Err(format!("out of range; valid: above 0, up to {MONTH} s")),
    }
}

/// A range of samples; they come in pairs, one of each half of the picture.
fn sample_numbers(text: &str) -> Result<[u32; 2], String> {
    let valid = format!("valid: A..B, both even, A below B, up to {MOST_SAMPLES}, such as 64..128");
    let (from, to) = text.split_once("..").ok_or_else(|| format!("is no range; {valid}"))?;
    let number = |text: &str| text.parse::<u32>().ok().filter(|number| *number <= MOST_SAMPLES);
    let (Some(from), Some(to)) = (number(from), number(to)) else { return Err(format!("is no range; {valid}")) };
    if from % 2 == 1 || to % 2 == 1 {
        return Err(format!("cuts a pair of samples, which are rendered together; {valid}"));
    }
    if from < to { Ok([from, to]) } else { Err(format!("has no sample; {valid}")) }
}

fn share(text: &str) -> Result<f64, String> {
    let share = parse_quantity(text, "1")?;
    if share > 0.0 && share < 1.0 { Ok(share) } else { Err("out of range; valid: above 0, below 1".to_owned()) }
}

fn stops(text: &str) -> Result<f64, String> {
    let stops = parse_quantity(text, "1")?;
    if stops.abs() <= 30.0 { Ok(stops) } else { Err("out of range; valid: -30 to 30".to_owned()) }
}

impl RenderArgs {
    fn into_request(self) -> Result<Request, Stop> {
        let Some(scene) = self.scene else {
            return match (self.list, self.keys) {
                (true, _) => Ok(Request::Scenes),
                (_, true) => Ok(Request::Keys),
                _ => {
                    let names: Vec<&str> = BUILTIN.iter().map(|builtin| builtin.name).collect();
                    let valid = format!("valid: a file that ends in .toml or .json, or {}", names.join(", "));
                    Err(Stop::at("scene", format!("missing; {valid}; `lesson render --list` tells of those")))
                }
            };
        };
        if self.print {
            return match &self.out[..] {
                [] | [_] => Ok(Request::Print { scene, out: self.out.into_iter().next() }),
                _ => Err(Stop::at("--out", "with --print only one file or folder")),
            };
        }
        for (flag, given, other, is_there) in
            [("--plot", self.plot, "--race", self.race), ("--format", self.format.is_some(), "--plot", self.plot)]
        {
            if given && !is_there {
                return Err(Stop::at(flag, format!("needs {other}")));
            }
        }
        let race = self.race.then(|| {
            let plot = match &self.out[..] {
                [] => Some(FOLDER.into()),
                [folder] if self.plot => Some(folder.clone()),
                [_, ..] if self.plot => return Err(Stop::at("--out", "with --race only one file or folder")),
                [_, ..] => return Err(Stop::at("--out", "with --race needs --plot")),
            };
            Ok(Course {
                time: self.time.unwrap_or(RACE),
                spp: self.spp,
                seed: self.seed,
                plot: plot.filter(|_| self.plot).map(|path| (path, self.format.map(|word| format(Some(word))))),
            })
        });
        Ok(Request::Render(Box::new(Job {
            scene,
            race: race.transpose()?,
            error_map: self.error_map,
            stats: self.stats,
            explain: self.explain,
            goal: Goal { spp: self.spp, samples: self.samples, time: self.time, error: self.error, round: None },
            out: self.out,
            seed: self.seed,
            threads: self.threads.map(|threads| threads as usize),
            integrator: self.integrator,
            depth: self.depth,
            size: [self.width, self.height],
            shown: self.shown.into(),
            film: self.film,
        })))
    }
}

/// The words that may stand where a chapter's name may stand.
fn commands() -> Vec<String> {
    Cli::command().get_subcommands().map(|command| command.get_name().to_owned()).chain(["all".to_owned()]).collect()
}

/// Reads `NAME=VALUE`.
fn assignment(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    if name.is_empty() || value.is_empty() {
        return Err("expected NAME=VALUE with both sides filled".to_owned());
    }
    Ok((name.to_owned(), value.to_owned()))
}

/// The script for `shell`. It knows chapters, their steps, and functions by name, as if they were commands.
fn completions(shell: Shell) -> Vec<u8> {
    let options = || {
        let command = LessonArgs::augment_args(clap::Command::new(""));
        command.get_arguments().filter(|argument| !argument.is_positional()).cloned().collect::<Vec<_>>()
    };
    let word = |name, about| clap::Command::new(name).about(about).disable_help_flag(true).args(options());
    let chapters = chapters::CURRICULUM.iter().map(|chapter| {
        word(chapter.id, chapter.title).subcommands(chapter.steps.iter().map(|step| word(step.id, step.title)))
    });
    let functions = chapters::CURRICULUM.iter().flat_map(|chapter| chapter.functions);
    let functions = functions.map(|function| clap::Command::new(function.name).disable_help_flag(true));
    let mut command = Cli::command()
        .subcommands(chapters.chain([word("all", "Every chapter in order")]))
        .mut_subcommand("eval", |eval| eval.subcommands(functions).disable_help_subcommand(true));
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, "lesson", &mut script);
    script
}

#[cfg(test)]
mod tests {
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
