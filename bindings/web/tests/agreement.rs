//! The module for the browser draws what the program draws. `LESSON_WASM` names a folder with a built module a chapter,
//! `fresnel.wasm` and so on (`.ci/wasm` builds them); without it there is nothing to run, and the tests say so.

mod difference;
mod module;

use chapters::vocabulary::{Exhibit, Gallery};
use chapters::{CURRICULUM, Chapter};
use difference::differences;
use module::{Module, Refusal};
use std::path::{Path, PathBuf};
use views::request::{self, answer};

/// Figures in which a last bit moves more than a last digit, how many of their elements it may move, and why.
const ROUNDING: &[(&str, usize, &str)] = &[
    (
        "maxwell/grid/blow_up",
        15,
        "beyond the Courant limit roundings grow; the key, of 12 elements, makes way for them",
    ),
    ("maxwell/conduction/stiffness", 3, "curves of errors end at some ε"),
    ("plane-wave/methods/after_a_while", 2, "curves of errors end at some ε"),
    ("poynting/theorem/books", 1, "a last bit decides on which side of an arrow its label stands"),
    ("fresnel/snell/refraction", 1, "a last bit decides whether a curve has a point at the critical angle"),
];

/// Chapters whose figures are too dear for an interpreter. Those of the first two are compared in a browser, with the book;
/// the others' modules would carry the renderer with all its lanes, four megabytes each, and are not built.
const ELSEWHERE: [&str; 4] = ["radiometry", "brdf", "rendering-equation", "path-tracing"];

/// What a parameter may be changed to: the first that it takes and that changes the figure.
const CHANGES: [&str; 6] = ["1.2", "33deg", "4/1/0.05", "0.5", "3", "2e9"];

/// The modules' folder, if it was given.
fn folder() -> Option<PathBuf> {
    let folder = std::env::var_os("LESSON_WASM").map(PathBuf::from);
    if folder.is_none() {
        println!("skipped: LESSON_WASM names no folder with built modules; .ci/wasm builds them and runs this");
    }
    folder
}

/// The chapter's module.
fn built(folder: &Path, chapter: &str) -> Vec<u8> {
    let path = folder.join(format!("{chapter}.wasm"));
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn galleries() -> Vec<Gallery> {
    CURRICULUM.iter().map(|chapter| chapter.figures).collect()
}

fn chapter(id: &str) -> &'static Chapter {
    CURRICULUM.iter().find(|chapter| chapter.id == id).expect("a chapter of the curriculum")
}

/// The figure's request with one parameter changed, if the figure depends on any.
fn changed(plain: &str, exhibit: &Exhibit, drawn: &str) -> Option<String> {
    let names = exhibit.parameters.iter().map(|parameter| parameter.name);
    let mut tries = names.flat_map(|name| CHANGES.map(|value| format!("{plain}\n{name}={value}")));
    tries.find(|request| answer(request, &galleries()).is_ok_and(|svg| svg != drawn))
}

/// What became of a chapter's figures.
#[derive(Default)]
struct Outcome {
    agree: usize,
    agree_changed: usize,
    dear: Vec<String>,
    wrong: Vec<String>,
}

impl Outcome {
    /// Asks the module for the figure; `false` if that is too dear.
    fn compare(&mut self, module: &Module, request: &str) -> bool {
        let place = request.replace('\n', " ");
        let ours = answer(request, &galleries()).expect("the program draws it");
        // Anew for each, as after a trap the instance is of no use.
        let theirs = match module.start().and_then(|mut running| running.ask(request)) {
            Ok(theirs) => theirs,
            Err(Refusal::TooDear) => {
                self.dear.push(place);
                return false;
            }
            Err(refusal) => {
                self.wrong.push(format!("{place}: {refusal:?}"));
                return true;
            }
        };
        let found = differences(&ours, &theirs);
        let rounded = ROUNDING.iter().find(|(address, ..)| request.lines().next() == Some(address));
        if found.len() <= rounded.map_or(0, |(_, elements, _)| *elements) {
            *if request.contains('\n') { &mut self.agree_changed } else { &mut self.agree } += 1;
        } else {
            self.wrong.push(format!("{place}: {} differ: {}", found.len(), found.join("; ")));
        }
        true
    }
}

/// Every figure of the chapter, at its defaults and with a parameter changed.
fn compare(chapter: &Chapter, wasm: &[u8]) -> Outcome {
    let module = Module::new(wasm).expect("a valid module");
    let mut outcome = Outcome::default();
    let exhibits = chapter.figures.exhibits.iter();
    for (exhibit, figure) in exhibits.flat_map(|exhibit| exhibit.figures.iter().map(move |figure| (exhibit, figure))) {
        let plain = format!("{}/{}/{}", chapter.id, exhibit.step, figure.id);
        if outcome.compare(&module, &plain) {
            let drawn = answer(&plain, &galleries()).expect("the program draws it");
            changed(&plain, exhibit, &drawn).map(|request| outcome.compare(&module, &request));
        }
    }
    outcome
}

fn every_figure_agrees(chapter: &str) {
    let Some(folder) = folder() else { return };
    let Outcome { agree, agree_changed, dear, wrong } = compare(self::chapter(chapter), &built(&folder, chapter));
    println!("{chapter}: {agree} figures agree at their defaults, {agree_changed} with a parameter changed");
    dear.iter().for_each(|place| println!("{chapter}: left out, too dear for the interpreter: {place}"));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(agree > 0 && agree_changed > 0, "there was nothing to compare");
}

// A test a chapter, so that they run side by side.
#[test]
fn maxwell_agrees() {
    every_figure_agrees("maxwell");
}

#[test]
fn plane_wave_agrees() {
    every_figure_agrees("plane-wave");
}

#[test]
fn poynting_agrees() {
    every_figure_agrees("poynting");
}

#[test]
fn fresnel_agrees() {
    every_figure_agrees("fresnel");
}

#[test]
fn every_chapter_with_figures_has_its_test() {
    let with_figures =
        CURRICULUM.iter().filter(|chapter| chapter.steps.iter().any(|step| !step.exhibit.figures.is_empty()));
    let ids: Vec<_> = with_figures.map(|chapter| chapter.id).filter(|id| !ELSEWHERE.contains(id)).collect();
    assert_eq!(ids, ["maxwell", "plane-wave", "poynting", "fresnel"], "and its feature in the package's manifest");
}

#[test]
fn what_rounds_is_in_the_curriculum() {
    let all = request::addresses(&galleries());
    ROUNDING.iter().for_each(|(address, ..)| assert!(all.iter().any(|known| known == address), "{address}"));
}

#[test]
fn faults_come_through_in_words() {
    let Some(folder) = folder() else { return };
    let chapter = chapter("poynting");
    let mut module = Module::new(&built(&folder, chapter.id)).unwrap().start().unwrap();
    let address = &request::addresses(&[chapter.figures])[0];
    for request in ["", "nowhere/at/all", chapter.id, &format!("{address}\nwrong"), &format!("{address}\nno=1")] {
        let ours = answer(request, &[chapter.figures]).unwrap_err().to_string();
        assert_eq!(module.ask(request), Err(Refusal::Fault(ours)));
    }
    assert_eq!(module.ask(b"\xff\xfe"), Err(Refusal::Fault("request: not UTF-8".to_owned())));
    // And after all that it still draws.
    assert!(module.ask(address).unwrap().starts_with("<svg"));
}

/// A module that is not what was built is caught: when it is read, or by what it draws.
#[test]
fn a_corrupted_module_is_caught() {
    let Some(folder) = folder() else { return };
    let wasm = built(&folder, "fresnel");
    assert!(Module::new(&wasm[..wasm.len() / 2]).is_err(), "half a module was taken");
    // The number of radians in a degree, wrong by less than one per cent.
    let degree = (std::f64::consts::PI / 180.0).to_le_bytes();
    let places: Vec<usize> = (0..wasm.len() - 8).filter(|&at| wasm[at..at + 8] == degree).collect();
    assert!(!places.is_empty(), "the module holds no degree");
    let mut corrupted = wasm.clone();
    places.iter().for_each(|at| corrupted[at + 5] ^= 0x10);
    let mut outcome = Outcome::default();
    outcome.compare(&Module::new(&corrupted).unwrap(), "fresnel/natural/against_angle");
    assert_eq!((outcome.agree, outcome.wrong.len()), (0, 1), "a wrong degree went unnoticed");
}

/// A chapter's module holds no other chapter, and another figure is not taken for the one asked for.
#[test]
fn another_module_and_another_figure_are_caught() {
    let Some(folder) = folder() else { return };
    let module = Module::new(&built(&folder, "maxwell")).unwrap();
    let mut outcome = Outcome::default();
    outcome.compare(&module, "fresnel/natural/against_angle");
    assert_eq!((outcome.agree, outcome.wrong.len()), (0, 1));
    let sheet = answer("maxwell/surface_current/sheet", &galleries()).unwrap();
    let theirs = module.start().unwrap().ask("maxwell/media/walk_off").unwrap();
    assert!(!differences(&sheet, &theirs).is_empty());
}
