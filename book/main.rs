//! The course as pages. The program `lesson` fills the pages of `book/pages`, mdBook sets them; a book is put in its place when
//! it is whole.

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
    let done = match Cli::parse().command {
        Command::Build { out } => press::build(&out).map(|()| println!("{}", out.join("index.html").display())),
        Command::Serve { port } => serve::serve(port),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("error: {fault}");
            ExitCode::from(2)
        }
    }
}
