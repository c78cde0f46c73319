//! What is put where a page asks for a part of the lecture: a number within a line, or blocks as HTML.

use super::Options;
use super::directive::{Directive, Kind, Piece, pieces};
use super::kept::Kept;
use super::links::link;
use super::{exercises, rows};
use crate::figures;
use crate::out;
use crate::progress::Progress;
use crate::run;
use crate::select::{Chosen, Selection, select};
use crate::stop::{Stop, plain};
use chapters::text::Phrase;
use chapters::{CURRICULUM, Chapter, Step};
use std::collections::HashSet;
use views::block::{Block, Details, Picture};
use views::html;
use views::number::value;
use views::report::entry::readout;
use views::report::{Parts, StepReport, Verdict};
use views::tell::Teller;

/// A page with what it asks for.
#[derive(Debug, Default)]
pub struct Filled {
    /// Its text.
    pub text: String,
    /// The addresses of what of the lecture is on it.
    pub ids: HashSet<String>,
    /// The pages that are to follow below it.
    pub below: Vec<Below>,
}

/// A page below another.
#[derive(Debug)]
pub struct Below {
    /// The name of its file, without an ending.
    pub name: &'static str,
    /// What it is called.
    pub title: String,
    /// Its text.
    pub text: String,
    /// The addresses of what of the lecture is on it.
    pub ids: HashSet<String>,
}

/// Tells parts of the lecture to pages.
pub struct Told {
    options: Options,
    kept: Option<Kept>,
    teller: Teller<'static>,
}

impl Told {
    /// As a book asks.
    pub fn new(options: Options) -> Self {
        let kept = if options.cache { Kept::open() } else { None };
        Self { options, kept, teller: Teller::english(Details::default()) }
    }

    /// The text of a page at a `place`, with the parts of the lecture that it asks for.
    pub fn page(&self, text: &str, place: &str) -> Result<Filled, Stop> {
        let pieces = pieces(text).map_err(|unread| Stop::at(format!("{place}:{}", unread.line), unread.why))?;
        let mut filled = Filled::default();
        for piece in pieces {
            match piece {
                Piece::Text(text) => filled.text.push_str(text),
                Piece::Lesson(directive) => {
                    let place = format!("{place}:{}", directive.line);
                    self.put(&directive, &place, &mut filled).map_err(|stop| stop.within(&place))?;
                }
            }
        }
        Ok(filled)
    }

    /// Puts what a directive asks for at the end of a page.
    fn put(&self, directive: &Directive, place: &str, filled: &mut Filled) -> Result<(), Stop> {
        let parts: Vec<String> = directive
            .address
            .iter()
            .flat_map(|word| word.split('/'))
            .filter(|part| !part.is_empty())
            .map(str::to_owned)
            .collect();
        let changes: Vec<_> =
            directive.changes.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        if directive.kind == Kind::Part
            && let Some(number) = number(&parts, &changes, place)?
        {
            filled.text.push_str(&number);
            return Ok(());
        }
        if !directive.is_alone {
            if directive.kind == Kind::Part {
                // A name that is known nowhere is what is wrong then.
                self.selected(&parts, &changes, place)?;
            }
            let what = if parts.is_empty() { "{{#lesson…}}".to_owned() } else { parts.join("/") };
            return Err(Stop::at(what, "only a number of a step stands within a line; this needs a line of its own"));
        }
        let html = match directive.kind {
            Kind::Coverage => rows::table(),
            Kind::Chapters => self.chapters(),
            Kind::Exercises => exercises::text(),
            Kind::Part => self.told(&self.selected(&parts, &changes, place)?, false, place)?,
            Kind::Steps => {
                let selection = self.selected(&parts, &changes, place)?;
                let Selection { steps } = &selection;
                let chapter = steps[0].chapter;
                if steps.len() != chapter.steps.len() {
                    return Err(Stop::at(parts.join("/"), "only a chapter has steps"));
                }
                filled.ids.insert(chapter.id.to_owned());
                for step in selection.steps {
                    filled.below.push(self.below(step, place)?);
                }
                self.contents(chapter)
            }
        };
        // What is HTML begins and ends at an empty line; within a list it is indented as the item is.
        let before = filled.text.trim_end_matches([' ', '\t']).len();
        let indent = filled.text.split_off(before);
        filled.text.push_str(if before == 0 || filled.text.ends_with("\n\n") { "" } else { "\n" });
        for line in once(&html, &mut filled.ids).lines() {
            filled.text.extend([&indent, line, "\n"]);
        }
        Ok(())
    }

    /// What a directive names, with what it sets.
    fn selected(&self, parts: &[String], changes: &[(String, String)], place: &str) -> Result<Selection, Stop> {
        let mut selection = select(parts, &[])?;
        for note in selection.set(changes)? {
            out::say(&format!("note: {place}: {note}"));
        }
        Ok(selection)
    }

    /// The chapters, a line each.
    fn chapters(&self) -> String {
        let line = |chapter: &&Chapter| self.line(chapter.id, chapter.title, chapter.says);
        format!("<ol class=\"steps\">\n{}</ol>\n", CURRICULUM.iter().map(line).collect::<String>())
    }

    /// A line on what stands at an address, and the way there.
    fn line(&self, address: &str, title: &str, says: &str) -> String {
        let told = |field, english| html::inline(&self.teller.phrase(address, field, english));
        format!("<li>{}: {}</li>\n", link(address, &told("title", title)), told("says", says))
    }

    /// What a chapter is about, and a line on each of its steps.
    fn contents(&self, chapter: &'static Chapter) -> String {
        let line = |step: &Step| self.line(&format!("{}/{}", chapter.id, step.id), step.title, step.says);
        let steps: String = chapter.steps.iter().map(line).collect();
        let intro = html::fragment(self.teller.words(), &self.teller.intro(chapter));
        format!("{intro}<ol class=\"steps\">\n{steps}</ol>\n")
    }

    /// A page for a step.
    fn below(&self, step: Chosen, place: &str) -> Result<Below, Stop> {
        let (name, title) = (step.step.id, self.teller.phrase(&step.address(), "title", step.step.title).to_string());
        let html = self.told(&Selection { steps: vec![step] }, true, place)?;
        let mut ids = HashSet::new();
        let text = format!("# {}\n\n{}", markdown(&title), once(&html, &mut ids));
        Ok(Below { name, title, text, ids })
    }

    /// The selected steps or the item as HTML; `is_page`, the one step is a page of its own.
    fn told(&self, selection: &Selection, is_page: bool, place: &str) -> Result<String, Stop> {
        let key = format!("{is_page} {:?} {:?}", self.options, selection.steps.iter().map(key).collect::<Vec<_>>());
        if let Some(html) = self.kept.as_ref().and_then(|kept| kept.get(&key)) {
            return Ok(html);
        }
        let report = run::run(selection, self.parts(selection), &Progress::new());
        let steps = report.chapters.iter().flat_map(|chapter| &chapter.steps);
        let mut blocks = Vec::new();
        if let [first, _, ..] = &selection.steps[..] {
            blocks.extend(self.teller.chapter(first.chapter));
        }
        blocks.extend(selection.steps.iter().zip(steps.clone()).flat_map(|(chosen, found)| self.step(chosen, found)));
        if steps.clone().any(|step| !step.races.is_empty()) {
            blocks.extend(self.teller.machine(&report.machine));
        }
        let html = if is_page { html::page } else { html::fragment };
        let mut html = html(self.teller.words(), &blocks);
        let is_live = |(chosen, _): &(&Chosen, _)| self.options.live.iter().any(|live| live == chosen.chapter.id);
        let live = selection.steps.iter().zip(steps).filter(is_live);
        html.extend(live.filter_map(|(chosen, found)| setting(chosen, found)));
        match &fallen(report.chapters.iter().flat_map(|chapter| &chapter.steps))[..] {
            [] => self.kept.iter().for_each(|kept| kept.put(&key, &html)),
            fallen => against(fallen, self.options.strict, place)?,
        }
        Ok(html)
    }

    /// All of a step, or the one item of it that is chosen.
    fn step(&self, chosen: &Chosen, found: &StepReport) -> Vec<Block> {
        let drawn = figures::inline(chosen, found);
        let picture = |address: &str| drawn.get(address).map_or(Picture::Absent, |svg| Picture::Svg(svg.clone()));
        match chosen.item.and_then(|item| chosen.step.item(item)) {
            Some(item) => self.teller.item(&item, found, &picture),
            None => self.teller.whole(chosen.chapter, chosen.step, found, &picture),
        }
    }

    /// What is run: of an item what it is, of steps all.
    fn parts(&self, selection: &Selection) -> Parts {
        match &selection.steps[..] {
            [Chosen { step, item: Some(item), .. }] => {
                step.item(item).and_then(|item| item.part()).map_or(Parts::default(), Parts::only)
            }
            _ => Parts { checks: true, stress: true, races: self.options.races },
        }
    }
}

/// Where verdicts are against the lecture.
fn fallen<'a>(steps: impl Iterator<Item = &'a StepReport>) -> Vec<&'a str> {
    let items = steps.flat_map(|step| {
        let derivations = step.derivations.iter().map(|item| (item.verdict, &item.address));
        let checks = step.checks.iter().map(|item| (item.verdict, &item.address));
        let stress = step.stress.iter().map(|item| (item.verdict, &item.address));
        let lanes = step.races.iter().flat_map(|race| &race.lanes).map(|lane| (lane.verdict, &lane.address));
        let statements = step.statements.iter().map(|item| (item.verdict, &item.address));
        let questions = step.questions.iter().map(|item| (item.verdict, &item.address));
        statements.chain(questions).chain(derivations).chain(checks).chain(stress).chain(lanes)
    });
    items.filter(|(verdict, _)| *verdict == Verdict::Failed).map(|(_, address)| address.as_str()).collect()
}

/// What is done about those.
fn against(fallen: &[&str], strict: bool, place: &str) -> Result<(), Stop> {
    let says = "the verdict is against the lecture";
    if strict {
        return Err(Stop::at(fallen.join(", "), format!("{says}: no book, since book.toml has `strict = true`")));
    }
    out::say(&format!("note: {place}: {}: {says}; the page shows it", fallen.join(", ")));
    Ok(())
}

/// What a step was told at, for a page whose figures answer; None if it has none, or nothing can be set.
fn setting(chosen: &Chosen, found: &StepReport) -> Option<String> {
    let has_figures = chosen.step.exhibit.figures.iter().any(|figure| chosen.wants(figure.id));
    // A text that ends the element would end it.
    let setting = serde_json::to_string(&found.setting).ok()?.replace("</", "<\\/");
    (has_figures && !found.setting.is_empty()).then(|| {
        format!(
            "<script type=\"application/json\" class=\"lesson-setting\" data-step=\"{}\">{setting}</script>\n",
            found.address
        )
    })
}

/// What decides how a step is told.
fn key(chosen: &Chosen) -> String {
    let Chosen { item, lane, setting, .. } = chosen;
    format!("{} {item:?} {lane:?} {setting:?}", chosen.address())
}

/// A number that a step computes, by the name that it has there; None if that is no such name. An item of the name is
/// what is meant.
fn number(parts: &[String], changes: &[(String, String)], place: &str) -> Result<Option<String>, Stop> {
    let [_, _, name] = parts else { return Ok(None) };
    let mut selection = select(&parts[..2], &[])?;
    let step = selection.steps[0].step;
    let is_named = |key: &str| plain(key) == plain(name);
    if step.items().any(|item| is_named(item.id())) || !has(&selection.steps[0], &is_named) {
        return Ok(None);
    }
    for note in selection.set(changes)? {
        out::say(&format!("note: {place}: {note}"));
    }
    let quantities = readout(step, &selection.steps[0].setting);
    let quantity = quantities.iter().find(|quantity| is_named(quantity.key));
    Ok(quantity.map(|quantity| html::inline(&Phrase::parse(&value(quantity.value.0, quantity.unit)))))
}

fn has(chosen: &Chosen, is_named: &dyn Fn(&str) -> bool) -> bool {
    readout(chosen.step, &chosen.setting).iter().any(|quantity| is_named(quantity.key))
}

/// Text as Markdown, letter by letter.
fn markdown(text: &str) -> String {
    let escaped = text.chars().flat_map(|c| c.is_ascii_punctuation().then_some('\\').into_iter().chain([c]));
    escaped.collect()
}

/// HTML of ours without the ids that a page has already; those that are new are among them afterwards.
fn once(html: &str, ids: &mut HashSet<String>) -> String {
    const ID: &str = " id=\"";
    let mut parts = html.split(ID);
    let mut kept = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (id, rest) = part.split_once('"').unwrap_or((part, ""));
        if ids.insert(id.to_owned()) {
            kept.push_str(ID);
            kept.push_str(id);
            kept.push('"');
        }
        kept.push_str(rest);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told() -> Told {
        Told::new(Options { races: false, cache: false, strict: true, live: Vec::new() })
    }

    fn page(text: &str) -> String {
        told().page(text, "a.md").unwrap().text
    }

    #[test]
    fn a_page_has_each_id_once_and_no_empty_line_within_a_part() {
        let page = page("{{#lesson fresnel/brewster}}\n\n{{#lesson fresnel/brewster/square}}\n");
        assert_eq!(page.matches(" id=\"fresnel/brewster/square\"").count(), 1);
        let parts: Vec<&str> = page.trim_end().split("\n\n").collect();
        assert_eq!(parts.len(), 2, "two blocks of HTML and nothing that ends them");
        assert!(parts.iter().all(|part| part.trim_start().starts_with('<')));
    }

    #[test]
    fn every_kind_of_item_can_be_asked_for() {
        for (address, sign) in [
            ("fresnel/snell/snell", "class=\"formula\""),
            ("fresnel/snell/phase_matching", "class=\"derivation\""),
            ("fresnel/brewster/square", "✓ passed"),
            ("fresnel/brewster/zero_of_r_p", "<svg"),
        ] {
            let page = page(&format!("{{{{#lesson {address}}}}}"));
            assert!(page.contains(sign), "{address}: {page}");
        }
    }

    #[test]
    fn a_strict_book_has_no_verdict_against_the_lecture() {
        assert!(against(&["a/b/c"], false, "a.md:1").is_ok());
        let refused = against(&["a/b/c", "a/b/d"], true, "a.md:1").expect_err("strict").to_string();
        assert!(refused.starts_with("a/b/c, a/b/d: the verdict is against the lecture"), "{refused}");
        let selection = select(&["fresnel/brewster".to_owned()], &[]).unwrap();
        let parts = Parts { checks: true, ..Parts::default() };
        let mut report = run::run(&selection, parts, &Progress::new());
        let step = &mut report.chapters[0].steps[0];
        assert!(fallen(std::iter::once(&*step)).is_empty());
        step.checks[1].verdict = Verdict::Failed;
        assert_eq!(fallen(std::iter::once(&*step)), [step.checks[1].address.as_str()]);
    }

    #[test]
    fn settings_count() {
        let of = |n_t: &str| page(&format!("{{{{#lesson fresnel/brewster/theta_b n_t={n_t}}}}}"));
        assert_eq!(of("1.5"), "56.3099°");
        assert_ne!(of("1.5"), of("2.4"));
    }

    #[test]
    fn what_is_more_than_a_number_needs_its_line() {
        let refused = told().page("see {{#lesson fresnel/brewster}}", "a.md").expect_err("refused").to_string();
        assert!(refused.starts_with("a.md:1: fresnel/brewster: "), "{refused}");
        let typed = told().page("at {{#lesson fresnel/brewster/theta_c}}", "a.md").expect_err("refused").to_string();
        assert!(typed.contains("no such item"), "{typed}");
    }

    #[test]
    fn within_a_list_it_stays_within_the_item() {
        let page = page("- item\n\n  {{#lesson fresnel/snell/snell}}\n\n  more\n");
        let inside = page.strip_prefix("- item\n\n").and_then(|rest| rest.strip_suffix("\n\n  more\n")).expect(&page);
        assert!(inside.lines().all(|line| line.starts_with("  ")), "{inside}");
    }
}
