//! The course as pages. The program `lesson` fills the pages of `book/pages`, mdBook sets them; a book is put in its place when
//! it is whole.

mod modules;
mod press;
mod serve;

use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

/// Builds the course's pages and shows them on this machine.
#[derive(Debug, Parser)]
#[command(name = "book")]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// A folder with the figures' modules; without it they are built, if this toolchain can.
    #[arg(long, value_name = "DIR", global = true)]
    modules: Option<PathBuf>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Build the pages.
    Build {
        /// Where to; a book that is there is replaced when the new one is whole.
        #[arg(long, value_name = "DIR", default_value = press::OUT)]
        out: PathBuf,
    },
    /// Build the pages, show them to browsers on this machine alone, and build them again when something changes.
    Serve {
        /// On which port; 0 takes any that is free.
        #[arg(long, default_value_t = 3000)]
        port: u16,
    },
}

/// What ends a command early: one message.
type Fault = String;

fn main() -> ExitCode {
    let Cli { command, modules } = Cli::parse();
    let modules = modules.as_deref();
    let done = match command {
        Command::Build { out } => {
            press::build(&out, modules).map(|()| println!("{}", out.join("index.html").display()))
        }
        Command::Serve { port } => serve::serve(port, modules),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("error: {fault}");
            ExitCode::from(2)
        }
    }
}
