//! `lesson`: how it is shown. Everything here is a view of `chapters::CURRICULUM`.

mod cli;
mod eval;
mod figures;
mod out;
mod progress;
mod proof;
mod run;
mod select;
mod stop;
mod walk;

use cli::Request;
use std::io::{IsTerminal, stdout};
use std::process::ExitCode;
use stop::Stop;

fn main() -> ExitCode {
    match cli::parse().and_then(serve) {
        Ok(code) => code,
        Err(Stop::ClosedPipe) => ExitCode::SUCCESS,
        Err(Stop::Refused(message)) => {
            out::say(&format!("lesson: {message}"));
            ExitCode::from(2)
        }
    }
}

fn serve(request: Request) -> Result<ExitCode, Stop> {
    match request {
        Request::Contents => {
            let mut page = out::page();
            views::text::contents(&mut page);
            out::print(page.into_text().as_bytes())?;
        }
        Request::Lesson(lesson) => return walk::serve(&lesson),
        Request::Coverage { json: true } => out::print(views::coverage::json().as_bytes())?,
        Request::Coverage { json: false } => {
            let mut page = out::page();
            views::coverage::table(&mut page);
            out::print(page.into_text().as_bytes())?;
        }
        Request::Eval { function, arguments, json } => {
            out::print(&eval::once(&function, &arguments, json, stdout().is_terminal())?)?;
        }
        Request::EvalLines { function } => return eval::lines(&function),
        Request::Functions { json: true } => out::print(eval::list_json().as_bytes())?,
        Request::Functions { json: false } => {
            let mut page = out::page();
            eval::list(&mut page);
            out::print(page.into_text().as_bytes())?;
        }
        Request::Prove(question) => return proof::serve(&question),
        Request::Completions(script) => out::print(&script)?,
    }
    Ok(ExitCode::SUCCESS)
}
