//! The list itself: what a chapter must have before anyone looks at it.

use chapters::lecture::{LECTURE, chapter_names};
use chapters::parameter::Setting;
use chapters::vocabulary::{Exhibit, Given, Item};
use chapters::{CURRICULUM, Step, steps};
use equation::derivation::{Chain, Claim};
use equation::{Equation, sound};
use std::collections::HashSet;

/// Every item's id and the rows it is evidence for.
fn items(step: &'static Step) -> impl Iterator<Item = (&'static str, &'static [&'static str])> {
    step.items().map(|item| (item.id(), step.rows_of(&item)))
}

/// The names that occur more than once.
fn repeated<'a>(names: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = HashSet::new();
    names.into_iter().filter(|name| !seen.insert(*name)).collect()
}

#[test]
fn addresses_are_unique() {
    let mut twice: Vec<String> = Vec::new();
    let mut note = |place: &str, names: Vec<&str>| twice.extend(names.iter().map(|name| format!("{place}/{name}")));
    note("", repeated(CURRICULUM.iter().map(|chapter| chapter.id)));
    for chapter in CURRICULUM {
        note(chapter.id, repeated(chapter.steps.iter().map(|step| step.id)));
    }
    for (chapter, step) in steps() {
        let place = format!("{}/{}", chapter.id, step.id);
        note(&place, repeated(items(step).map(|(id, _)| id)));
        note(&place, repeated(step.parameters().iter().map(|parameter| parameter.name)));
        for race in step.races {
            note(&format!("{place}/{}", race.id), repeated(race.lanes.iter().map(|lane| lane.id)));
        }
    }
    let functions = CURRICULUM.iter().flat_map(|chapter| chapter.functions);
    note("eval", repeated(functions.map(|function| function.name)));
    assert!(twice.is_empty(), "given to two: {}", twice.join(", "));
}

#[test]
fn a_key_equation_is_one_of_its_step() {
    for (chapter, step) in steps() {
        let Some(key) = step.key else { continue };
        let at = step.statements.iter().position(|statement| statement.id == key);
        assert!(
            at.is_some_and(|at| at > 0),
            "{}/{}: {key} is none of its equations, or the first",
            chapter.id,
            step.id
        );
    }
}

#[test]
fn words_are_words_of_an_address() {
    for (chapter, step) in steps() {
        let lanes = step.races.iter().flat_map(|race| race.lanes).map(|lane| lane.id);
        for id in items(step).map(|(id, _)| id).chain(lanes).chain([step.id]) {
            let plain =
                id.chars().all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_');
            assert!(plain && !id.is_empty(), "{}/{}: `{id}`", chapter.id, step.id);
        }
    }
}

#[test]
fn chapters_are_those_of_the_lecture_and_build_on_it() {
    assert_eq!(CURRICULUM.iter().map(|chapter| chapter.id).collect::<Vec<_>>(), chapter_names());
    let known: HashSet<_> = LECTURE.iter().map(|row| row.chapter).collect();
    for chapter in CURRICULUM {
        assert!(known.contains(chapter.id), "{}", chapter.id);
        assert!(chapter.builds_on.iter().all(|earlier| known.contains(earlier)), "{}", chapter.id);
    }
}

#[test]
fn the_lecture_has_all_its_rows_once() {
    assert_eq!(LECTURE.len(), 76);
    assert!(repeated(LECTURE.iter().map(|row| row.id)).is_empty());
}

#[test]
fn every_row_named_exists() {
    let known: HashSet<_> = LECTURE.iter().map(|row| row.id).collect();
    for (chapter, step) in steps() {
        let named = items(step).flat_map(|(id, rows)| rows.iter().map(move |row| (id, row)));
        for (id, row) in named.chain(step.rows.iter().map(|row| ("", row))) {
            assert!(known.contains(row), "{}/{}/{id} names {row}", chapter.id, step.id);
        }
    }
}

#[test]
fn prose_has_one_section_for_each_step_in_order() {
    for chapter in CURRICULUM {
        let markers =
            chapter.prose.split("<!-- step:").skip(1).map(|rest| rest.split("-->").next().unwrap_or("").trim());
        let steps: Vec<_> = chapter.steps.iter().map(|step| step.id).collect();
        assert_eq!(markers.collect::<Vec<_>>(), steps, "{}", chapter.id);
    }
}

#[test]
fn defaults_are_valid_and_readouts_answer() {
    for (chapter, step) in steps() {
        let setting = Setting::defaults(step.parameters());
        for quantity in step.readout.map(|read| read(&setting)).unwrap_or_default() {
            assert!(quantity.value.is_finite(), "{}/{}: {quantity:?}", chapter.id, step.id);
        }
    }
}

#[test]
fn figures_and_readouts_answer_at_the_ends_of_every_parameter() {
    // Steps are dealt out in turn: dear ones stand together.
    let hands = std::thread::available_parallelism().map_or(1, usize::from);
    let all: Vec<_> = steps().collect();
    std::thread::scope(|scope| {
        for hand in 0..hands {
            let mine = all.iter().skip(hand).step_by(hands);
            scope.spawn(move || mine.for_each(|(chapter, step)| answers_at_the_ends(chapter.id, step)));
        }
    });
}

fn answers_at_the_ends(chapter: &str, step: &'static Step) {
    for parameter in step.parameters() {
        for end in parameter.kind.ends() {
            // Some ends are refused beside the defaults of the others, with a message.
            let changes = [(parameter.name.to_owned(), end.to_string())];
            let Ok(setting) = Setting::defaults(step.parameters()).with(&changes) else { continue };
            step.readout.map(|readout| readout(&setting));
            for question in step.questions {
                let place = format!("{chapter}/{}/{} at {end}", step.id, question.id);
                assert!(chapters::judge::question(question, &setting), "{place}");
                let mistake = chapters::judge::can_fail(Item::Question(question), &setting, &place);
                assert_eq!(mistake, Some(Ok(())), "{place}");
            }
            for figure in step.exhibit.figures {
                let plot = (figure.plot)(&setting);
                assert!(!plot.panels.is_empty(), "{chapter}/{}/{} at {end}", step.id, figure.id);
            }
        }
    }
}

#[test]
fn units_of_both_sides_agree() {
    for (chapter, step) in steps() {
        for statement in step.statements {
            let found = chapters::judge::statement(statement);
            assert!(found.holds(), "{}/{}/{}: {:?}", chapter.id, step.id, statement.id, found.dimension);
        }
    }
}

/// Every equation on the page, with its place: statements, and hypotheses and lines of derivations.
fn equations() -> Vec<(String, Equation)> {
    let mut all = Vec::new();
    for (chapter, step) in steps() {
        let place = |id: &str| format!("{}/{}/{id}", chapter.id, step.id);
        all.extend(step.statements.iter().map(|item| (place(item.id), (item.equation)())));
        for item in step.derivations {
            all.extend(written(&(item.chain)()).into_iter().map(|equation| (place(item.id), equation)));
        }
    }
    all
}

/// What a chain shows, each as an equation; a bare expression follows "=" there.
fn written(chain: &Chain) -> Vec<Equation> {
    let given = chain.given.iter().map(|given| Equation::new(&given.what, &given.value));
    let lines = chain.lines.iter().map(|line| match &line.claim {
        Claim::Equation(equation) => equation.clone(),
        Claim::Expr(expr) => Equation::new(0, expr),
    });
    given.chain(lines).collect()
}

#[test]
fn faces_are_well_formed_and_read_back() {
    let faults: Vec<String> = equations()
        .into_iter()
        .filter_map(|(place, equation)| {
            let sound = sound::well_formed(&equation).and_then(|()| sound::read_back(&equation));
            sound.err().map(|why| format!("{place}: {why}"))
        })
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn races_have_rivals_and_growing_work() {
    for (chapter, step) in steps() {
        for race in step.races {
            let place = format!("{}/{}/{}", chapter.id, step.id, race.id);
            assert!(race.lanes.len() >= 2, "{place}");
            for lane in race.lanes {
                assert!(!lane.works.is_empty() && lane.works[0] > 0, "{place}/{}", lane.id);
                assert!(lane.works.is_sorted_by(|a, b| a < b), "{place}/{}", lane.id);
                assert!(lane.repeats >= 1, "{place}/{}", lane.id);
            }
        }
    }
}

/// What an item says of itself.
fn words(item: &Item) -> Vec<&'static str> {
    match item {
        Item::Statement(item) => vec![item.says],
        Item::Question(item) => vec![item.asks, item.because],
        Item::Derivation(item) => vec![item.says, item.slip],
        Item::Check(item) => {
            let head = item.head();
            vec![head.claim, head.route, head.slip]
        }
        Item::Stress(item) => vec![item.claim, item.textbook, item.reference],
        Item::Race(item) => vec![item.claim, item.work, item.error, item.reference],
        Item::Figure(item) => vec![item.says],
    }
}

#[test]
fn every_item_says_what_it_is_and_where_its_bound_and_its_slip_come_from() {
    for (chapter, step) in steps() {
        for item in step.items() {
            assert!(words(&item).iter().all(|text| !text.is_empty()), "{}/{}/{}", chapter.id, step.id, item.id());
        }
    }
}

#[test]
fn every_figure_is_reached_without_its_step() {
    for chapter in CURRICULUM {
        let shown = |exhibits: &mut dyn Iterator<Item = Exhibit>| -> Vec<String> {
            let addresses = exhibits.flat_map(|exhibit| {
                exhibit.figures.iter().map(move |figure| format!("{}/{}", exhibit.step, figure.id))
            });
            addresses.collect()
        };
        let apart = shown(&mut chapter.figures.exhibits.iter().copied());
        assert_eq!(chapter.figures.chapter, chapter.id);
        assert_eq!(apart, shown(&mut chapter.steps.iter().map(|step| step.exhibit)), "{}", chapter.id);
    }
}

#[test]
fn every_step_asks_before_it_shows() {
    let asks_nothing = |(chapter, step): (&chapters::Chapter, &'static Step)| {
        step.questions.is_empty().then(|| format!("{}/{}", chapter.id, step.id))
    };
    let silent: Vec<String> = steps().filter_map(asks_nothing).collect();
    assert!(silent.is_empty(), "no question in {}", silent.join(", "));
}

#[test]
fn every_wrong_choice_is_told_what_leads_there() {
    for (chapter, step) in steps() {
        let setting = Setting::defaults(step.parameters());
        for question in step.questions {
            let place = format!("{}/{}/{}", chapter.id, step.id, question.id);
            let replies: Vec<_> =
                (0..question.options().len()).map(|at| question.reply(&setting, Given::Option(at))).collect();
            assert!(replies.iter().all(|reply| !reply.says.is_empty()), "{place}");
            let rights = replies.iter().filter(|reply| reply.right).count();
            assert_eq!(rights, usize::from(!replies.is_empty()), "{place}");
        }
    }
}
