//! The module for the browser draws what the program draws. `LESSON_WASM` names a folder with a built module a chapter,
//! `fresnel.wasm` and so on (`.ci/wasm` builds them); without it there is nothing to run, and the tests say so.

mod difference;
mod module;

use chapters::parameter::Kind;
use chapters::{CURRICULUM, Chapter};
use difference::difference;
use module::Module;
use std::path::PathBuf;
use views::request;

/// The modules' folder, if it was given.
fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("LESSON_WASM").map(PathBuf::from);
    if folder.is_none() {
        println!("skipped: LESSON_WASM names no folder with built modules; .ci/wasm builds them and runs this");
    }
    folder
}

/// The bytes of the chapter's module.
fn built(folder: &std::path::Path, chapter: &Chapter) -> Vec<u8> {
    let path = folder.join(format!("{}.wasm", chapter.id));
    std::fs::read(&path).unwrap_or_else(|fault| panic!("{}: {fault}", path.display()))
}

/// Requests for every figure of the chapter: at its defaults, and with one parameter changed, if it has any.
fn requests(chapter: &'static Chapter) -> Vec<String> {
    let exhibits = chapter.figures.exhibits.iter();
    let figures = exhibits.flat_map(|exhibit| exhibit.figures.iter().map(move |figure| (exhibit, figure)));
    let both = figures.flat_map(|(exhibit, figure)| {
        let plain = format!("{}/{}/{}", chapter.id, exhibit.step, figure.id);
        let changed = exhibit.parameters.iter().find_map(|parameter| changed(parameter.name, parameter.kind));
        [changed.map(|change| format!("{plain}\n{change}")), Some(plain)].into_iter().flatten()
    });
    both.collect()
}

/// A line that sets a parameter to something that is not its default.
fn changed(name: &str, kind: Kind) -> Option<String> {
    let value = match kind {
        Kind::Number(range) if range.unit == "rad" => "33deg",
        Kind::Medium => "2.4",
        Kind::ClearMedium => "1.2",
        Kind::Conductor => "4/1/0.05",
        _ => return None,
    };
    Some(format!("{name}={value}"))
}

/// What a module of the chapter gets wrong, request by request.
fn disagreements(chapter: &'static Chapter, wasm: &[u8]) -> Result<Vec<String>, String> {
    let mut found = Vec::new();
    for request in requests(chapter) {
        let place = request.replace('\n', " ");
        let ours = request::answer(&request, &[chapter.figures]).map_err(|fault| fault.to_string())?;
        // Anew for each, as after a trap the instance is of no use.
        match Module::load(wasm)?.ask(&request) {
            Ok(theirs) => found.extend(difference(&ours, &theirs).map(|difference| format!("{place}: {difference}"))),
            Err(fault) => found.push(format!("{place}: {fault}")),
        }
    }
    Ok(found)
}

#[test]
fn every_figure_is_that_of_the_program() {
    let Some(folder) = folder() else { return };
    for chapter in CURRICULUM {
        let asked = requests(chapter).len();
        assert!(asked > 0, "{} has no figures", chapter.id);
        let start = std::time::Instant::now();
        let found = disagreements(chapter, &built(&folder, chapter)).unwrap();
        assert!(found.is_empty(), "{}", found.join("\n"));
        println!("{}: {asked} figures agree, {:.1?}", chapter.id, start.elapsed());
    }
}

#[test]
fn faults_come_through_in_words() {
    let Some(folder) = folder() else { return };
    for chapter in CURRICULUM {
        let mut module = Module::load(&built(&folder, chapter)).unwrap();
        let address = &request::addresses(&[chapter.figures])[0];
        for request in ["", "nowhere/at/all", chapter.id, &format!("{address}\nwrong"), &format!("{address}\nno=1")] {
            let ours = request::answer(request, &[chapter.figures]).unwrap_err().to_string();
            assert_eq!(module.ask(request), Err(ours));
        }
        assert_eq!(module.ask_bytes(b"\xff\xfe"), Err("request: not UTF-8".to_owned()));
        // And after all that it still draws.
        assert!(module.ask(address).unwrap().starts_with("<svg"));
    }
}

/// A module that is not what was built must be caught: by the runtime, or by the figures it draws.
#[test]
fn a_corrupted_module_is_caught() {
    let Some(folder) = folder() else { return };
    let chapter = CURRICULUM.iter().find(|chapter| chapter.id == "fresnel").unwrap();
    let wasm = built(&folder, chapter);
    assert!(Module::load(&wasm[..wasm.len() / 2]).is_err(), "half a module was taken");
    // The number of radians in a degree, wrong in its eleventh bit.
    let degree = (std::f64::consts::PI / 180.0).to_le_bytes();
    let places: Vec<usize> = (0..wasm.len() - 8).filter(|&at| wasm[at..at + 8] == degree).collect();
    assert!(!places.is_empty(), "the module holds no degree");
    let mut corrupted = wasm.clone();
    places.iter().for_each(|at| corrupted[at + 5] ^= 0x10);
    let found = disagreements(chapter, &corrupted).unwrap();
    assert!(!found.is_empty(), "a wrong degree went unnoticed");
    // The module of another chapter does not know this one's figures.
    let other = built(&folder, CURRICULUM.iter().find(|other| other.id == "maxwell").unwrap());
    assert_eq!(disagreements(chapter, &other).unwrap().len(), requests(chapter).len());
}
