//! From the words of a command line to the part of the curriculum that they name.

use crate::stop::{Stop, plain};
use chapters::lecture::chapter_names;
use chapters::parameter::{FREQUENCY, Fault, Parameter, Setting, WAVELENGTH, excerpt};
use chapters::vocabulary::Part;
use chapters::{CURRICULUM, Chapter, Step};
use views::block::Block;
use views::report::Parts;
use views::tell::Teller;

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

/// A change that a step cannot take.
#[derive(Debug)]
struct Left {
    /// As it was written.
    name: String,
    /// As the step calls it.
    own: &'static str,
    why: String,
    fault: Fault,
}

impl Chosen {
    fn whole(chapter: &'static Chapter, step: &'static Step) -> Self {
        Self { chapter, step, setting: Setting::defaults(step.parameters()), item: None, lane: None }
    }

    /// `chapter/step`.
    pub fn address(&self) -> String {
        format!("{}/{}", self.chapter.id, self.step.id)
    }

    /// The parameter that answers to `name`.
    fn parameter(&self, name: &str) -> Option<&'static Parameter> {
        self.step.parameters().iter().find(|parameter| parameter.form(name).is_some())
    }

    /// The setting with those of the `changes` that the step can take, and those that it has to leave.
    fn settle(&self, changes: &[(String, String)]) -> Result<(Setting, Vec<Left>), Fault> {
        let known = changes.iter().filter(|(name, _)| self.parameter(name).is_some());
        let mut kept: Vec<_> = known.cloned().collect();
        let mut left = Vec::new();
        loop {
            let fault = match self.setting.clone().with(&kept) {
                Ok(setting) => return Ok((setting, left)),
                Err(fault) => fault,
            };
            // What is wrong with a default, the wavelength or frequency that it now stands beside has made wrong.
            let at_fault = |(name, _): &&(String, String)| fault.is_of(name);
            let of_light = |(name, _): &&(String, String)| {
                self.parameter(name).is_some_and(|own| [WAVELENGTH.name, FREQUENCY.name].contains(&own.name))
            };
            let blamed = kept.iter().find(at_fault).or_else(|| kept.iter().find(of_light));
            let Some(name) = blamed.map(|(name, _)| name.clone()) else { return Err(fault) };
            let why = if fault.is_of(&name) { fault.message.clone() } else { format!("there, {fault}") };
            kept.retain(|(kept, _)| *kept != name);
            let own = self.parameter(&name).map_or("", |own| own.name);
            left.push(Left { name, own, why, fault });
        }
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

/// What `words` name: `all`, a chapter, a chapter and a step, or an address, whole or in parts. Somebody who wrote one of
/// the `commands` wrongly may be told of it.
pub fn select(words: &[String], commands: &[String]) -> Result<Selection, Stop> {
    if words.iter().any(|word| word.trim().is_empty()) {
        return Err(Stop::at("``", "an empty word names nothing; `lesson contents` lists chapters and steps"));
    }
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
    let chapter = find_chapter(first, commands)?;
    let Some((step, rest)) = rest.split_first() else {
        return Ok(Selection { steps: whole(chapter).collect() });
    };
    let mut chosen = Chosen::whole(chapter, find_step(chapter, step)?);
    if let Some((item, rest)) = rest.split_first() {
        let place = chosen.address();
        chosen.item = Some(find("item", item, &place, &chosen.step.items().map(|item| item.id()).collect::<Vec<_>>())?);
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

fn find_chapter(word: &str, commands: &[String]) -> Result<&'static Chapter, Stop> {
    let wanted = plain(word);
    if let Some(chapter) = CURRICULUM.iter().find(|chapter| plain(chapter.id) == wanted) {
        return Ok(chapter);
    }
    if commands.contains(&wanted) {
        return Err(Stop::at(&wanted, "a command, which stands first and has options of its own; `--help` lists them"));
    }
    let names = chapter_names().into_iter().map(str::to_owned).chain(commands.iter().cloned());
    Err(Stop::unknown(Fault::unknown(excerpt(word), word, "no such chapter", names), addresses()))
}

/// The addresses of all steps and of all that is in them, steps first.
fn addresses() -> Vec<String> {
    let steps = || CURRICULUM.iter().flat_map(|chapter| whole(chapter));
    let items = |chosen: Chosen| {
        let address = chosen.address();
        chosen.step.items().map(move |item| format!("{address}/{}", item.id())).collect::<Vec<_>>()
    };
    steps().map(|chosen| chosen.address()).chain(steps().flat_map(items)).collect()
}

/// The steps of the chapter called `name`, or of all chapters.
pub fn contents(name: Option<&str>, teller: &Teller) -> Result<Vec<Block>, Stop> {
    match name {
        None => Ok(CURRICULUM.iter().flat_map(|chapter| teller.contents(chapter)).collect()),
        Some(name) => Ok(teller.contents(find_chapter(name, &[])?)),
    }
}

/// What stands at `words`, and what can be set there.
pub fn about(words: &[String], commands: &[String], teller: &Teller) -> Result<Vec<Block>, Stop> {
    let selection = select(words, commands)?;
    Ok(match &selection.steps[..] {
        [Chosen { chapter, step, .. }] => teller.step_help(chapter, step),
        steps => {
            let mut chapters: Vec<&Chapter> = steps.iter().map(|chosen| chosen.chapter).collect();
            chapters.dedup_by_key(|chapter| chapter.id);
            teller.chapters_help(&chapters)
        }
    })
}

fn find_step(chapter: &'static Chapter, word: &str) -> Result<&'static Step, Stop> {
    let ids: Vec<_> = chapter.steps.iter().map(|step| step.id).collect();
    let id = find("step", word, chapter.id, &ids)?;
    Ok(chapter.steps.iter().find(|step| step.id == id).expect("an id of the list"))
}

fn find_lane(chosen: &Chosen, word: &str) -> Result<&'static str, Stop> {
    let place = format!("{}/{}", chosen.address(), chosen.item.unwrap_or_default());
    let Some(race) = chosen.step.races.iter().find(|race| Some(race.id) == chosen.item) else {
        let whole = format!("{place}/{}", excerpt(word));
        return Err(Stop::at(whole, "only a race has parts of its own: its contestants"));
    };
    find("contestant of this race", word, &place, &race.lanes.iter().map(|lane| lane.id).collect::<Vec<_>>())
}

fn find(what: &str, word: &str, place: &str, ids: &[&'static str]) -> Result<&'static str, Stop> {
    let wanted = plain(word);
    ids.iter().find(|id| plain(id) == wanted).copied().ok_or_else(|| {
        let place = format!("{place}/{}", excerpt(word));
        Stop::unknown(Fault::unknown(place, word, format!("no such {what}"), ids.to_vec()), addresses())
    })
}

impl Selection {
    /// Applies `--set`: each change goes to every selected step that has the name. Where it clashes with what the step
    /// itself demands, another domain, a clear medium or a default that has no index at the wavelength set, the step
    /// keeps its own value; the notes returned say so. A change that every step would have to leave is refused, and so is
    /// a second one of the same parameter.
    pub fn set(&mut self, changes: &[(String, String)]) -> Result<Vec<String>, Stop> {
        for (at, (name, _)) in changes.iter().enumerate() {
            self.require(name)?;
            if changes[..at].iter().any(|(earlier, _)| earlier == name) {
                return Err(Stop::at(name, "given twice"));
            }
        }
        let alone = self.steps.len() == 1;
        let mut all_left = Vec::new();
        for chosen in &mut self.steps {
            let placed = |fault| if alone { Stop::from(fault) } else { Stop::from(fault).within(chosen.address()) };
            let (setting, left) = chosen.settle(changes).map_err(placed)?;
            let address = chosen.address();
            all_left.extend(left.into_iter().map(|left| (address.clone(), left)));
            chosen.setting = setting;
        }
        for (name, _) in changes {
            let holders = self.steps.iter().filter(|chosen| chosen.parameter(name).is_some()).count();
            let mut leavers = all_left.iter().filter(|(_, left)| left.name == *name);
            if leavers.clone().count() == holders
                && let Some((address, left)) = leavers.next()
            {
                let stop = Stop::from(left.fault.clone());
                return Err(if alone { stop } else { stop.within(address) });
            }
        }
        let note = |(address, left): &(String, Left)| format!("{address} keeps its own {}: {}", left.own, left.why);
        Ok(all_left.iter().map(note).collect())
    }

    /// If nothing of the kind asked for is there, that and what is. Questions, which go with everything, are of no kind.
    pub fn lacks(&self, parts: Parts, plot: bool) -> Option<String> {
        let place = match &self.steps[..] {
            [chosen] => chosen.item.map_or(chosen.address(), |item| format!("{}/{item}", chosen.address())),
            steps => steps.first().map_or(String::new(), |chosen| chosen.chapter.id.to_owned()),
        };
        let holds = |part: Part| {
            let wanted =
                |chosen: &Chosen| chosen.step.items().any(|item| item.part() == Some(part) && chosen.wants(item.id()));
            self.steps.iter().any(wanted)
        };
        let asked = |part: Part| parts.has(part) || (plot && part == Part::Figures);
        let (there, lacking): (Vec<Part>, Vec<Part>) =
            Part::ALL.into_iter().filter(|part| asked(*part)).partition(|part| holds(*part));
        if lacking.is_empty() || !there.is_empty() {
            return None;
        }
        let lacks: Vec<_> = lacking.iter().map(|part| part.noun()).collect();
        let has: Vec<_> = Part::ALL.iter().filter(|part| holds(**part)).map(|part| part.flag()).collect();
        let has = if has.is_empty() { "nothing else".to_owned() } else { has.join(", ") };
        Some(format!("{place} has no {}; it has {has}", lacks.join(", no ")))
    }

    /// Refuses a parameter name that no selected step has.
    fn require(&self, name: &str) -> Result<(), Stop> {
        if self.parameters().any(|parameter| parameter.form(name).is_some()) {
            return Ok(());
        }
        let mut known = Vec::new();
        for name in self.parameters().flat_map(Parameter::names) {
            if !known.contains(&name) {
                known.push(name);
            }
        }
        let fault = Fault::unknown(excerpt(name), name, "no such parameter here", known);
        // What scripts call by another name where they call the functions.
        let functions = CURRICULUM.iter().flat_map(|chapter| chapter.functions);
        let namesakes = functions.filter_map(|function| function.input(name));
        match namesakes.map(|input| input.name).find(|meant| self.parameters().any(|own| own.name == *meant)) {
            Some(meant) => Err(Stop::meaning(&fault, Some(meant))),
            None => Err(fault.into()),
        }
    }

    fn parameters(&self) -> impl Iterator<Item = &'static Parameter> + '_ {
        self.steps.iter().flat_map(|chosen| chosen.step.parameters())
    }
}
