//! `lesson`: how it is shown. Everything here is a view of `chapters::CURRICULUM`.

mod cli;
mod eval;
mod exercise;
mod figures;
mod film;
mod interrupt;
mod mdbook;
mod memory;
mod out;
mod progress;
mod prove;
mod reader;
mod render;
mod run;
mod scene;
mod select;
mod stop;
mod walk;

use cli::Request;
use std::io::{IsTerminal, stdout};
use std::path::Path;
use std::process::ExitCode;
use stop::Stop;
use views::block::Details;
use views::tell::Teller;

fn main() -> ExitCode {
    match cli::parse().and_then(serve) {
        Ok(code) => code,
        Err(Stop::ClosedPipe) => ExitCode::SUCCESS,
        Err(Stop::Interrupted(code)) => ExitCode::from(code),
        Err(Stop::Refused(message)) => {
            out::say(&format!("error: {message}"));
            ExitCode::from(2)
        }
    }
}

fn serve(request: Request) -> Result<ExitCode, Stop> {
    let teller = Teller::english(Details::default());
    match request {
        Request::Map => out::show(&teller.map())?,
        Request::Contents { chapter } => out::show(&select::contents(chapter.as_deref(), &teller)?)?,
        Request::Help { text } => out::print(text.as_bytes())?,
        Request::About { words, commands } => out::show(&select::about(&words, &commands, &teller)?)?,
        Request::Lesson(lesson) => return walk::serve(&lesson),
        Request::Coverage { json: true } => out::print(views::json::rows().as_bytes())?,
        Request::Coverage { json: false } => out::show(&teller.coverage())?,
        Request::Eval { function, arguments, json } => {
            out::print(&eval::once(&function, &arguments, json, stdout().is_terminal())?)?;
        }
        Request::EvalLines { function } => return eval::lines(&function),
        Request::Functions { json: true } => out::print(eval::list_json().as_bytes())?,
        Request::Functions { json: false } => out::show(&teller.functions(eval::functions()))?,
        Request::Progress => reader::bookmark::progress()?,
        Request::Prove(question) => return prove::serve(&question),
        Request::Scenes => out::show(&scene::list())?,
        Request::Keys => out::show(&scene::keys())?,
        Request::Print { scene, out } => scene::serve_print(&scene, out.as_deref())?,
        Request::Render(job) => return render::serve(&job, Path::new(cli::FOLDER)),
        Request::Merge(job) => return film::merge(&job),
        Request::Show { film } => film::show(&film)?,
        Request::Mdbook => mdbook::serve()?,
        Request::Supports { renderer } => return Ok(mdbook::supports(&renderer)),
        Request::Exercise(ask) => return exercise::serve(&ask),
        Request::Completions(script) => out::print(&script)?,
    }
    Ok(ExitCode::SUCCESS)
}
