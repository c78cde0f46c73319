//! From the words of a command line to the part of the curriculum that they name.

use crate::stop::{Stop, did_you_mean, plain};
use chapters::lecture::LECTURE;
use chapters::setting::{DEFAULT_WAVELENGTH, Kind, Parameter, Setting, Value, WAVELENGTH, excerpt, parse_medium};
use chapters::{CURRICULUM, Chapter, Step};

/// The steps that a run is about, in teaching order.
#[derive(Debug)]
pub struct Selection {
    pub steps: Vec<Chosen>,
}

/// A step and the parameter values in force for it.
#[derive(Debug)]
pub struct Chosen {
    pub chapter: &'static Chapter,
    pub step: &'static Step,
    pub setting: Setting,
    /// The only item asked for, by id; all if `None`.
    pub item: Option<&'static str>,
    /// The only lane of that item asked for.
    pub lane: Option<&'static str>,
}

impl Chosen {
    fn whole(chapter: &'static Chapter, step: &'static Step) -> Self {
        Self { chapter, step, setting: Setting::defaults(step.parameters), item: None, lane: None }
    }

    /// `chapter/step`.
    pub fn address(&self) -> String {
        format!("{}/{}", self.chapter.id, self.step.id)
    }

    fn parameter(&self, name: &str) -> Option<&'static Parameter> {
        self.step.parameters.iter().find(|parameter| parameter.name == name)
    }

    fn must_be_clear(&self, name: &str) -> bool {
        self.parameter(name).is_some_and(|parameter| parameter.kind == Kind::ClearMedium)
    }

    /// Whether the item `id` was asked for.
    pub fn wants(&self, id: &str) -> bool {
        self.item.is_none_or(|item| item == id)
    }

    /// Whether the lane `id` was asked for.
    pub fn wants_lane(&self, id: &str) -> bool {
        self.lane.is_none_or(|lane| lane == id)
    }
}

/// What `words` name: `all`, a chapter, a chapter and a step, or an address, whole or in parts.
pub fn select(words: &[String]) -> Result<Selection, Stop> {
    let parts: Vec<&str> = words.iter().flat_map(|word| word.split('/')).filter(|part| !part.is_empty()).collect();
    let Some((first, rest)) = parts.split_first() else {
        return Err(Stop::at("chapter", "missing; `lesson` lists them"));
    };
    if plain(first) == "all" {
        return match rest {
            [] => Ok(Selection { steps: CURRICULUM.iter().flat_map(|chapter| whole(chapter)).collect() }),
            [extra, ..] => Err(Stop::at(excerpt(extra), "`all` takes no step")),
        };
    }
    let chapter = find_chapter(first)?;
    let Some((step, rest)) = rest.split_first() else {
        return Ok(Selection { steps: whole(chapter).collect() });
    };
    let mut chosen = Chosen::whole(chapter, find_step(chapter, step)?);
    if let Some((item, rest)) = rest.split_first() {
        let place = chosen.address();
        chosen.item = Some(find("item", item, &place, &items(chosen.step))?);
        if let Some((lane, rest)) = rest.split_first() {
            chosen.lane = Some(find_lane(&chosen, lane)?);
            if let Some(extra) = rest.first() {
                return Err(Stop::at(excerpt(extra), "an address has at most the parts chapter/step/race/lane"));
            }
        }
    }
    Ok(Selection { steps: vec![chosen] })
}

fn whole(chapter: &'static Chapter) -> impl Iterator<Item = Chosen> {
    chapter.steps.iter().map(move |step| Chosen::whole(chapter, step))
}

fn find_chapter(word: &str) -> Result<&'static Chapter, Stop> {
    let wanted = plain(word);
    if let Some(chapter) = CURRICULUM.iter().find(|chapter| plain(chapter.id) == wanted) {
        return Ok(chapter);
    }
    if LECTURE.iter().any(|row| row.chapter == wanted) {
        let written: Vec<_> = CURRICULUM.iter().map(|chapter| chapter.id).collect();
        return Err(Stop::at(&wanted, format!("this chapter is not written yet; there is: {}", written.join(", "))));
    }
    let names = chapter_names();
    let hint = did_you_mean(word, names.iter().copied().chain(COMMANDS));
    Err(Stop::at(excerpt(word), format!("no such chapter{hint}. There is: {}", names.join(", "))))
}

fn find_step(chapter: &'static Chapter, word: &str) -> Result<&'static Step, Stop> {
    let ids: Vec<_> = chapter.steps.iter().map(|step| step.id).collect();
    let id = find("step", word, chapter.id, &ids)?;
    Ok(chapter.steps.iter().find(|step| step.id == id).expect("an id of the list"))
}

fn find_lane(chosen: &Chosen, word: &str) -> Result<&'static str, Stop> {
    let race = chosen.step.races.iter().find(|race| Some(race.id) == chosen.item);
    let lanes: Vec<_> = race.iter().flat_map(|race| race.lanes).map(|lane| lane.id).collect();
    find("lane", word, &format!("{}/{}", chosen.address(), chosen.item.unwrap_or_default()), &lanes)
}

fn find(what: &str, word: &str, place: &str, ids: &[&'static str]) -> Result<&'static str, Stop> {
    let wanted = plain(word);
    ids.iter().find(|id| plain(id) == wanted).copied().ok_or_else(|| {
        let hint = did_you_mean(word, ids.iter().copied());
        let list = if ids.is_empty() { "none".to_owned() } else { ids.join(", ") };
        Stop::at(format!("{place}/{}", excerpt(word)), format!("no such {what}{hint}. There is: {list}"))
    })
}

/// The ids of everything in a step that has an address.
pub fn items(step: &Step) -> Vec<&'static str> {
    let statements = step.statements.iter().map(|item| item.id);
    let derivations = step.derivations.iter().map(|item| item.id);
    let checks = step.checks.iter().map(|item| item.id);
    let stress = step.stress.iter().map(|item| item.id);
    let races = step.races.iter().map(|item| item.id);
    let figures = step.figures.iter().map(|item| item.id);
    statements.chain(derivations).chain(checks).chain(stress).chain(races).chain(figures).collect()
}

/// Every chapter of the lecture, written or not, in teaching order.
pub fn chapter_names() -> Vec<&'static str> {
    let mut names: Vec<_> = LECTURE.iter().map(|row| row.chapter).collect();
    names.dedup();
    names
}

impl Selection {
    /// Applies `--set`: each change goes to every selected step that has the name. Where a step needs a clear medium
    /// and another takes the absorbing one that was set, the first keeps its own; the notes returned say so.
    pub fn set(&mut self, changes: &[(String, String)]) -> Result<Vec<String>, Stop> {
        for (name, _) in changes {
            self.require(name)?;
        }
        let open: Vec<_> = self.parameters().filter(|p| p.kind == Kind::Medium).map(|p| p.name).collect();
        let alone = self.steps.len() == 1;
        let mut notes = Vec::new();
        for chosen in &mut self.steps {
            let known = changes.iter().filter(|(name, _)| chosen.parameter(name).is_some());
            let (kept, left): (Vec<_>, Vec<_>) = known.cloned().partition(|change| {
                let elsewhere = open.contains(&change.0.as_str());
                !(elsewhere && chosen.must_be_clear(&change.0) && absorbs(&change.1, wavelength(changes)))
            });
            chosen.setting = chosen.setting.clone().with(&kept).map_err(|fault| match alone {
                true => Stop::from(fault),
                false => Stop::at(chosen.address(), fault),
            })?;
            let note = |(name, text)| {
                format!("{} keeps its own {name}: it needs a clear medium, not {text}", chosen.address())
            };
            notes.extend(left.into_iter().map(note));
        }
        Ok(notes)
    }

    /// Refuses a parameter name that no selected step has.
    fn require(&self, name: &str) -> Result<(), Stop> {
        if self.parameters().any(|parameter| parameter.name == name) {
            return Ok(());
        }
        let mut known = Vec::new();
        for parameter in self.parameters() {
            if !known.contains(&parameter.name) {
                known.push(parameter.name);
            }
        }
        let hint = did_you_mean(name, known.iter().copied());
        let list = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
        Err(Stop::at(excerpt(name), format!("no such parameter here{hint}. There is: {list}")))
    }

    fn parameters(&self) -> impl Iterator<Item = &'static Parameter> + '_ {
        self.steps.iter().flat_map(|chosen| chosen.step.parameters)
    }
}

/// The wavelength [m] that `changes` set, or the default.
fn wavelength(changes: &[(String, String)]) -> f64 {
    let text = changes.iter().rev().find(|(name, _)| name == WAVELENGTH.name).map(|(_, text)| text.as_str());
    match WAVELENGTH.parse(text.unwrap_or(WAVELENGTH.default)) {
        Ok(Value::Number(metres)) => metres,
        _ => DEFAULT_WAVELENGTH,
    }
}

/// Whether `text` names a medium that absorbs at `wavelength` [m].
fn absorbs(text: &str, wavelength: f64) -> bool {
    parse_medium(text).is_ok_and(|medium| medium.index(wavelength).is_ok_and(|index| index.im > 0.0))
}

/// Words that stand where a chapter's name may stand.
const COMMANDS: [&str; 4] = ["all", "coverage", "eval", "completions"];
