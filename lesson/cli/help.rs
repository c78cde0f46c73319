//! How to use the program.

use super::lesson::LessonArgs;
use super::{Cli, Request, command, commands};
use crate::out;
use clap::builder::StyledStr;
use clap::{ArgAction, Args, CommandFactory};
use clap_complete::Shell;
use views::block::Details;
use views::page::Page;
use views::tell::Teller;
use views::terminal;

const EXAMPLES: &str = "\
Examples:
  lesson                                   the chapters, and what to type next
  lesson contents fresnel                  the steps of a chapter, one line each
  lesson fresnel                           read a chapter, where you left it
  lesson fresnel --short                   the ten-minute way through it
  lesson progress                          how much of each chapter you have read
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
  lesson exercise start snell              a formula to write; `check` judges it

On a terminal a chapter opens in a reader, full screen: space goes on, b back,
g to another step, / searches, s turns the parameters, d e x r unfold the
evidence, ? shows all keys, q leaves. It remembers your place. Elsewhere, or
with --plain, everything comes at once, the evidence of a whole chapter in a
line an item; --check shows what was found, --unfold all of it.

Exit status: 0 if everything holds, 1 if a check broke, 2 if it could not run.

Signs:
";

/// [`EXAMPLES`], and what the signs in a report mean.
pub fn after_help() -> String {
    let mut signs = Page::new(80, false);
    let teller = Teller::english(Details::default());
    terminal::set(&mut signs, teller.words(), &teller.legend());
    format!("{EXAMPLES}{}", signs.into_text().trim_end())
}

/// The option that shows a command's help.
#[derive(Debug, Args)]
pub struct HelpArg {
    /// This.
    #[arg(short, long, action = ArgAction::Help)]
    help: Option<bool>,
}

/// Help on the program, on one of its commands, or on a part of the curriculum.
pub fn help(words: Vec<String>) -> Request {
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
pub fn styled(text: &StyledStr) -> String {
    if out::is_coloured() { text.ansi().to_string() } else { text.to_string() }
}

/// The script for `shell`. It knows chapters, their steps, and functions by name, as if they were commands.
pub fn completions(shell: Shell) -> Vec<u8> {
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
