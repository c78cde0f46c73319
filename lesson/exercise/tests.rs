//! The exercises held to what they promise: the truth passes, every hole and every known slip falls, and is told why.

use super::compile::{Program, Source, program};
use super::formula::Answers;
use super::process::{Fault, Process};
use super::shelf;
use super::told;
use super::verdict::{Verdict, claims, step, verdict};
use super::vocabulary::Exercise;
use crate::interrupt::Interrupt;
use crate::reader::bookmark::Memory;
use std::any::Any;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// A formula in the learner's place, without a process.
struct Local<F>(F);

impl<F: FnMut(&[f64]) -> Vec<f64>> Answers for Local<F> {
    fn answer(&mut self, numbers: &[f64]) -> Option<Vec<f64>> {
        Some((self.0)(numbers))
    }
}

fn local(exercise: &Exercise, formula: impl FnMut(&[f64]) -> Vec<f64> + 'static) -> Verdict {
    verdict(exercise, Box::new(Local(formula)), &Mutex::default())
}

/// One of a check's own subjects in the learner's place.
fn subject(exercise: &'static Exercise, subject: &'static dyn Any) -> Verdict {
    local(exercise, move |asked| exercise.formula.at(subject, asked).expect("of the exercise's type"))
}

#[test]
fn the_shelf_is_whole() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../exercises");
    let folders: BTreeSet<String> =
        folder.read_dir().unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    let names: BTreeSet<String> = shelf::all().map(|exercise| exercise.name.to_owned()).collect();
    assert_eq!(folders, names);
    assert_eq!(names.len(), shelf::all().count());
    for chapter in chapters::CURRICULUM {
        assert!(shelf::all().filter(|exercise| exercise.chapter() == chapter.id).count() >= 2, "{}", chapter.id);
    }
    let order: Vec<&str> = shelf::all().map(|exercise| exercise.chapter()).collect();
    let at = |chapter: &str| chapters::CURRICULUM.iter().position(|one| one.id == chapter);
    assert!(order.is_sorted_by_key(|chapter| at(chapter)), "{order:?}");
}

#[test]
fn every_folder_fits_what_judges_it() {
    for exercise in shelf::all() {
        let (name, signature) = (exercise.name, exercise.signature());
        for text in [exercise.files.task, exercise.files.start, exercise.files.solution] {
            assert!(text.contains(&signature), "{name}: {signature}");
        }
        assert!(exercise.files.start.contains("todo!()") && !exercise.files.solution.contains("todo!"), "{name}");
        assert!(exercise.files.hints().len() >= 2, "{name}");
        for claim in claims(exercise) {
            assert!(exercise.files.task.contains(&format!("{}/{}", exercise.step, claim.head().id)), "{name}");
        }
        for stress in exercise.extremes {
            let found = step(exercise).stress.iter().find(|one| one.id == *stress).expect("an id of the step");
            assert!(found.own.is_some(), "{name}: {stress} takes no formula");
            assert!(exercise.files.task.contains(&format!("{}/{stress}", exercise.step)), "{name}");
        }
        for taken in exercise.takes {
            assert!(
                exercise.files.task.contains(&format!("| `{}` | {} |", taken.name, taken.unit)),
                "{name}: {}",
                taken.name
            );
        }
        assert!(exercise.files.task.contains(&format!("| result | {} |", exercise.gives.unit)), "{name}");
        let command = format!("lesson {}", exercise.step.replace('/', " "));
        assert!(exercise.files.task.contains(&command), "{name}: {command}");
    }
    let list = told::list(&Memory::default());
    assert!(list.lines().all(|line| line.chars().count() <= 80), "{list}");
}

#[test]
fn the_programs_own_formulas_solve_every_exercise() {
    for exercise in shelf::all() {
        let claim = claims(exercise).next().expect("some check");
        let found = subject(exercise, claim.subjects()[0]);
        assert!(found.is_solved(exercise), "{}", told::verdict(exercise, &found));
        assert!(found.worst.is_none() && found.slip.is_none());
    }
}

#[test]
fn every_known_slip_falls_and_is_told() {
    for exercise in shelf::all() {
        let planted = claims(exercise).zip(exercise.claims).map(|(claim, about)| {
            let says = format!("{}. {}", claim.head().slip, about.idea);
            (says, subject(exercise, claim.subjects()[1]))
        });
        let known = exercise.slips.iter().map(|slip| (slip.says.to_owned(), local(exercise, slip.formula)));
        for (says, found) in planted.chain(known) {
            let told = told::verdict(exercise, &found);
            assert!(!found.is_solved(exercise), "{}, {says}: {told}", exercise.name);
            assert_eq!(found.slip.as_deref(), Some(says.as_str()), "{told}");
            assert!(told.contains("yours") && told.contains("right") && told.contains(&says), "{told}");
        }
    }
}

#[test]
fn no_number_whatsoever_is_more_than_wrong() {
    for exercise in shelf::all() {
        let results = exercise.gives.kind.numbers();
        for mad in [f64::NAN, f64::INFINITY, -1.0, 1e308] {
            let found = local(exercise, move |_| vec![mad; results]);
            let told = told::verdict(exercise, &found);
            assert!(
                !found.is_solved(exercise) && found.checks.iter().all(|one| one.checked.is_some()),
                "{mad}: {told}"
            );
            assert!(serde_json::from_str::<serde_json::Value>(&told::verdict_json(exercise, &found)).is_ok());
        }
    }
}

/// All files of one kind as one program.
fn all_of(text: fn(&'static Exercise) -> &'static str) -> (Arc<Program>, Arc<Interrupt>) {
    let interrupt = Interrupt::noted();
    let source = |exercise: &'static Exercise| Source { exercise, text: text(exercise), called: exercise.name.into() };
    let sources: Vec<Source> = shelf::all().map(source).collect();
    let program = program(&sources, &interrupt).unwrap_or_else(|stop| panic!("{stop}"));
    (Arc::new(program), Arc::new(interrupt))
}

fn run(exercise: &'static Exercise, (program, interrupt): &(Arc<Program>, Arc<Interrupt>)) -> Verdict {
    let results = exercise.gives.kind.numbers();
    let (program, interrupt) = (Arc::clone(program), Arc::clone(interrupt));
    let process = Process::start(program, exercise.name, results, Duration::from_secs(60), interrupt).unwrap();
    let heard = process.heard();
    verdict(exercise, Box::new(process), &heard)
}

#[test]
fn every_solution_passes() {
    let solutions = all_of(|exercise| exercise.files.solution);
    for exercise in shelf::all() {
        let found = run(exercise, &solutions);
        assert!(found.is_solved(exercise), "{}", told::verdict(exercise, &found));
    }
}

#[test]
fn every_start_fails_at_its_hole() {
    let starts = all_of(|exercise| exercise.files.start);
    for exercise in shelf::all() {
        let found = run(exercise, &starts);
        assert!(!found.is_solved(exercise));
        assert_eq!(found.fault.as_ref().map(|(fault, _)| fault), Some(&Fault::Hole), "{}", exercise.name);
        assert!(told::verdict(exercise, &found).contains("the hole is still there"));
    }
}
