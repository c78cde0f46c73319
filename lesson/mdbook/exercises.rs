//! The exercises as Markdown: what each asks, the step that it belongs to, and its hints, folded one by one.

use super::links::link;
use crate::exercise::shelf;
use crate::exercise::vocabulary::Exercise;
use chapters::CURRICULUM;
use std::fmt::Write;

/// All of them, by the chapters' order.
pub fn text() -> String {
    let mut text = String::new();
    for chapter in CURRICULUM {
        // Writing to a string does not fail.
        let _ = writeln!(text, "## {}\n", chapter.title);
        let own = shelf::all().filter(|exercise| exercise.chapter() == chapter.id);
        own.for_each(|exercise| text.push_str(&told(exercise)));
    }
    text
}

fn told(exercise: &Exercise) -> String {
    let Exercise { name, step, files, .. } = exercise;
    let (title, task) = files.task.split_once('\n').unwrap_or((files.task, ""));
    let title = title.trim_start_matches('#').trim();
    let mut text =
        format!("### {title} {{#exercise-{name}}}\n\n{}\n\nThe step: {}.\n\n", task.trim(), link(step, step));
    for (at, hint) in files.hints().iter().enumerate() {
        let _ = write!(text, "<details>\n<summary>hint {}</summary>\n\n{hint}\n\n</details>\n\n", at + 1);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_exercise_is_there_without_its_solution() {
        let text = text();
        for exercise in shelf::all() {
            assert!(text.contains(&format!("{{#exercise-{}}}", exercise.name)), "{}", exercise.name);
            assert!(!text.contains(exercise.files.solution), "{}", exercise.name);
        }
        assert_eq!(text.matches("\n### ").count(), shelf::all().count(), "tasks have one heading each");
    }
}
