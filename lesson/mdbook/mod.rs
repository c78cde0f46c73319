//! `lesson mdbook`: parts of the lecture in any mdBook, put there by the preprocessor that mdBook runs.
//!
//! | what | where |
//! |---|---|
//! | mdBook's protocol | here |
//! | what a page asks for | [`directive`] |
//! | what is put there | [`told`] |
//! | the lecture's rows, the exercises | [`rows`], [`exercises`] |
//! | links from page to page | [`links`] |
//! | what was put there before | [`kept`] |
//!
//! mdBook asks `supports RENDERER` first. Then it writes `[context, book]` as JSON and reads the book, its chapters changed,
//! back (mdBook's guide, *Preprocessors*). Of the book only what is needed here is looked at, so that other versions' fields
//! go through as they are.

mod directive;
mod exercises;
mod kept;
mod links;
mod rows;
mod told;

use crate::out;
use crate::stop::Stop;
use chapters::CURRICULUM;
use chapters::parameter::{Fault, excerpt};
use links::Links;
use serde_json::{Map, Value, json};
use std::io::{IsTerminal, Read, stdin};
use std::process::ExitCode;
use told::{Below, Told};

/// The one renderer whose pages can show what is put into them.
const RENDERER: &str = "html";

/// The lists of a book's items: since mdBook 0.5, and before.
const ITEMS: [&str; 2] = ["items", "sections"];

/// The book's table of what concerns this program.
const TABLE: &str = "preprocessor.lesson";

/// What mdBook itself reads there.
const MDBOOKS: [&str; 6] = ["command", "before", "after", "renderer", "renderers", "optional"];

/// What a book may ask of us.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Whether races are run: error against run time, on the machine that builds the book.
    races: bool,
    /// Whether what was put into a book is kept for the next time that it is built.
    cache: bool,
    /// Whether there is no book when a verdict is against the lecture; otherwise the page shows it.
    strict: bool,
    /// The chapters whose modules the book brings, so that their figures can answer.
    live: Vec<String>,
}

/// Whether pages of a renderer can show what is put into them: exit code 0 or 1, as mdBook asks.
pub fn supports(renderer: &str) -> ExitCode {
    ExitCode::from(u8::from(renderer != RENDERER))
}

/// Reads a book from standard input and writes it to standard output, its pages filled.
pub fn serve() -> Result<(), Stop> {
    let place = "standard input";
    if stdin().is_terminal() {
        return Err(Stop::at(place, "mdBook runs this command and writes a book to it; see `lesson mdbook --help`"));
    }
    let mut input = String::new();
    stdin().read_to_string(&mut input).map_err(|error| Stop::at(place, error))?;
    out::print(filled(&input)?.as_bytes())
}

/// A book as it comes from mdBook, filled.
fn filled(input: &str) -> Result<String, Stop> {
    let place = "standard input";
    let foreign =
        |why: String| Stop::at(place, format!("{why}; valid: `[context, book]` as mdBook 0.4 and 0.5 write it"));
    let (context, mut book): (Value, Value) =
        serde_json::from_str(input).map_err(|error| foreign(format!("not what mdBook writes ({error})")))?;
    let version = context["mdbook_version"].as_str().map_or("of no version".to_owned(), excerpt);
    let list = ITEMS.into_iter().find(|list| book[*list].is_array());
    let list = list.ok_or_else(|| foreign(format!("mdBook {version}: a book without a list of items")))?;
    let source = context["config"]["book"]["src"].as_str().unwrap_or("src");
    let mut links = Links::default();
    claim(&mut book[list], &mut links);
    fill(&mut book[list], source, &Told::new(options(&context)?), &mut links)?;
    link(&mut book[list], source, &links)?;
    Ok(book.to_string())
}

/// The chapters among the items of a list: the rest are separators and titles.
fn chapters(items: &mut Value) -> impl Iterator<Item = &mut Map<String, Value>> {
    let items = items.as_array_mut().into_iter().flatten();
    items.filter_map(|item| item.get_mut("Chapter").and_then(Value::as_object_mut))
}

/// Lets the pages that the book has keep their paths.
fn claim(items: &mut Value, links: &mut Links) {
    for chapter in chapters(items) {
        chapter.get("path").and_then(Value::as_str).map(|path| links.claim(path));
        if let Some(below) = chapter.get_mut("sub_items") {
            claim(below, links);
        }
    }
}

/// Fills the chapters of a list of items, and those below them.
fn fill(items: &mut Value, source: &str, told: &Told, links: &mut Links) -> Result<(), Stop> {
    for chapter in chapters(items) {
        if let Some(below) = chapter.get_mut("sub_items") {
            fill(below, source, told, links)?;
        }
        let place = place(chapter, source);
        let Some(Value::String(content)) = chapter.get_mut("content") else { continue };
        let filled = told.page(content, &place)?;
        *content = filled.text;
        if let Some(path) = chapter.get("path").and_then(Value::as_str) {
            filled.ids.into_iter().for_each(|id| links.add(id, path));
        }
        for below in filled.below {
            let below = page(below, chapter, &place, links)?;
            match chapter.get_mut("sub_items") {
                Some(Value::Array(items)) => items.push(below),
                _ => return Err(Stop::at(place, "mdBook has no place for pages below this one")),
            }
        }
    }
    Ok(())
}

/// A page of ours below a chapter, as mdBook has it; no other page may have its path.
fn page(below: Below, chapter: &Map<String, Value>, place: &str, links: &mut Links) -> Result<Value, Stop> {
    let path = chapter.get("path").and_then(Value::as_str).and_then(|path| path.strip_suffix(".md"));
    let path = path.ok_or_else(|| Stop::at(place, "pages below it need a page in a file `….md`"))?;
    let path = format!("{path}/{}.md", below.name);
    if !links.claim(&path) {
        return Err(Stop::at(place, format!("{path} is a page of this book already; valid: a page of another name")));
    }
    below.ids.into_iter().for_each(|id| links.add(id, &path));
    let before = chapter.get("sub_items").and_then(Value::as_array).map_or(0, Vec::len);
    let number = chapter.get("number").and_then(Value::as_array).map(|number| {
        let own = [json!(before + 1)];
        number.iter().cloned().chain(own).collect::<Vec<_>>()
    });
    let parents = chapter.get("parent_names").and_then(Value::as_array).into_iter().flatten();
    let parents: Vec<&Value> = parents.chain(chapter.get("name")).collect();
    Ok(json!({"Chapter": {
        "name": below.title, "content": below.text, "number": number, "sub_items": [], "path": path,
        "source_path": null, "parent_names": parents,
    }}))
}

/// Leads the links of chapters to the pages that they mean.
fn link(items: &mut Value, source: &str, links: &Links) -> Result<(), Stop> {
    for chapter in chapters(items) {
        if let Some(below) = chapter.get_mut("sub_items") {
            link(below, source, links)?;
        }
        let path = chapter.get("path").and_then(Value::as_str).unwrap_or_default().to_owned();
        let place = place(chapter, source);
        if let Some(Value::String(content)) = chapter.get_mut("content") {
            *content = links.resolved(content, &path, &place)?;
        }
    }
    Ok(())
}

/// Where a chapter is written, or what it is called if it is in no file.
fn place(chapter: &Map<String, Value>, source: &str) -> String {
    let text = |key: &str| chapter.get(key).and_then(Value::as_str);
    let path = text("source_path").or(text("path"));
    path.map_or_else(|| excerpt(text("name").unwrap_or("a chapter")), |path| format!("{source}/{path}"))
}

/// What the book asks of us.
fn options(context: &Value) -> Result<Options, Stop> {
    let mut options = Options { races: true, cache: true, strict: false, live: Vec::new() };
    let Some(table) = context["config"]["preprocessor"]["lesson"].as_object() else { return Ok(options) };
    for (key, value) in table {
        let refused = |valid: &str| Stop::at(format!("book.toml: {TABLE}.{key}"), format!("valid: {valid}"));
        let flag = || value.as_bool().ok_or_else(|| refused("true or false"));
        match key.as_str() {
            "races" => options.races = flag()?,
            "cache" => options.cache = flag()?,
            "strict" => options.strict = flag()?,
            "live" => options.live = live(value).ok_or_else(|| refused("a list of chapters"))?,
            key if MDBOOKS.contains(&key) => {}
            key => {
                let place = format!("book.toml: {TABLE}.{}", excerpt(key));
                return Err(Fault::unknown(place, key, "no such key", ["races", "cache", "strict", "live"]).into());
            }
        }
    }
    Ok(options)
}

/// A list of chapters.
fn live(value: &Value) -> Option<Vec<String>> {
    let is_known = |name: &&str| CURRICULUM.iter().any(|chapter| chapter.id == *name);
    let name = |value: &Value| value.as_str().filter(is_known).map(str::to_owned);
    value.as_array()?.iter().map(name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// A book of one page and one below it.
    fn book(list: &str, pages: [&str; 2], table: Value) -> String {
        let chapter = |name: &str, content: &str, below: Value| {
            json!({"Chapter": {
                "name": name, "content": content, "number": [1], "sub_items": below, "path": format!("{name}.md"),
                "source_path": format!("{name}.md"), "parent_names": [],
            }})
        };
        let below = chapter("below", pages[1], json!([]));
        let context = json!({
            "root": "/book", "renderer": "html", "mdbook_version": "0.5.4",
            "config": {"book": {"src": "text"}, "preprocessor": {"lesson": table}},
        });
        let book =
            json!({list: [{"PartTitle": "One"}, chapter("page", pages[0], json!([below])), "Separator"], "else": 1});
        json!([context, book]).to_string()
    }

    fn table() -> Value {
        json!({"command": "lesson mdbook", "before": ["links"], "races": false, "cache": false})
    }

    fn fault(pages: [&str; 2], table: Value) -> String {
        filled(&book("items", pages, table)).expect_err("a fault").to_string()
    }

    #[test]
    fn pages_and_those_below_are_filled_and_the_rest_goes_through() {
        for list in ITEMS {
            let pages = [
                "before\n\n{{#lesson fresnel/snell/snell}}\n\nafter",
                "at {{#lesson fresnel/brewster/theta_b n_t=1.5}}.",
            ];
            let filled: Value = serde_json::from_str(&filled(&book(list, pages, table())).unwrap()).unwrap();
            let chapter = &filled[list][1]["Chapter"];
            let content = chapter["content"].as_str().unwrap();
            assert!(content.starts_with("before\n\n<"), "{content}");
            assert!(content.ends_with(">\n\n\nafter"), "{content}");
            assert!(content.contains("id=\"fresnel/snell/snell\"") && content.contains("<math"), "{content}");
            assert_eq!(chapter["sub_items"][0]["Chapter"]["content"], "at 56.3099°.");
            let rest = [&filled[list][0]["PartTitle"], &filled[list][2], &filled["else"], &chapter["number"][0]];
            assert_eq!(rest, [&json!("One"), &json!("Separator"), &json!(1), &json!(1)]);
        }
    }

    #[test]
    fn every_step_has_a_page_below_its_chapter_s_and_links_lead_there() {
        let pages = ["{{#lesson-steps poynting}}", "# B\n\n[the balance](lesson:poynting/theorem)"];
        let filled: Value = serde_json::from_str(&filled(&book("items", pages, table())).unwrap()).unwrap();
        let chapter = &filled["items"][1]["Chapter"];
        let (written, steps) = chapter["sub_items"].as_array().unwrap().split_first().unwrap();
        assert_eq!(written["Chapter"]["content"], "# B\n\n[the balance](page/theorem.md#poynting/theorem)");
        let poynting = chapters::CURRICULUM.iter().find(|chapter| chapter.id == "poynting").unwrap();
        assert_eq!(steps.len(), poynting.steps.len());
        for (at, (page, step)) in steps.iter().zip(poynting.steps).enumerate() {
            let page = &page["Chapter"];
            assert_eq!(page["path"], format!("page/{}.md", step.id));
            assert_eq!(page["number"], json!([1, at + 2]));
            assert_eq!(page["parent_names"], json!(["page"]));
            let text = page["content"].as_str().unwrap();
            assert!(text.starts_with("# ") && !text.contains("<h1"), "one heading, the page's: {}", step.id);
            assert!(text.contains(&format!(" id=\"poynting/{}\"", step.id)));
            let link = format!("href=\"page/{0}.md#poynting/{0}\"", step.id);
            assert!(chapter["content"].as_str().unwrap().contains(&link), "{link}");
        }
    }

    #[test]
    fn no_page_of_an_author_s_is_written_over() {
        let twice = fault(["{{#lesson-steps poynting}}\n\n{{#lesson-steps poynting}}", ""], table());
        assert_eq!(twice, "text/page.md: page/flow.md is a page of this book already; valid: a page of another name");
    }

    #[test]
    fn rows_lead_to_their_steps_or_nowhere() {
        let rows = |page: &str| {
            let filled = filled(&book("items", [page, "{{#lesson-coverage}}"], table())).unwrap();
            let filled: Value = serde_json::from_str(&filled).unwrap();
            filled["items"][1]["Chapter"]["sub_items"][0]["Chapter"]["content"].as_str().unwrap().to_owned()
        };
        let (alone, beside) = (rows(""), rows("{{#lesson poynting/theorem}}"));
        assert!(alone.contains("<a>poynting/theorem</a>") && !alone.contains("href"), "{alone}");
        assert!(beside.contains("<a href=\"page.md#poynting/theorem\">poynting/theorem</a>"), "{beside}");
    }

    #[test]
    fn what_cannot_be_filled_is_refused_with_its_place() {
        let lost = fault(["", "one\n\n{{#lesson fresnel/brewstr}}"], table());
        assert!(lost.starts_with("text/below.md:3: fresnel/brewstr: no such step (did you mean `"), "{lost}");
        let wrong = fault(["{{#lesson fresnel/brewster theta=95deg}}", ""], table());
        assert!(wrong.starts_with("text/page.md:1: theta: "), "{wrong}");
        let key = fault(["", ""], json!({"race": true}));
        assert!(key.starts_with("book.toml: preprocessor.lesson.race: no such key (did you mean `races`?)"), "{key}");
        let kind = fault(["", ""], json!({"races": "yes"}));
        assert_eq!(kind, "book.toml: preprocessor.lesson.races: valid: true or false");
        for live in [json!("fresnel"), json!(["fresnell"]), json!([1])] {
            let refused = fault(["", ""], json!({"live": live}));
            assert_eq!(refused, "book.toml: preprocessor.lesson.live: valid: a list of chapters");
        }
    }

    #[test]
    fn figures_answer_where_the_book_brings_their_modules() {
        let pages = ["{{#lesson fresnel/brewster/zero_of_r_p}}", "{{#lesson poynting/mean}}"];
        let table = json!({"races": false, "cache": false, "live": ["fresnel"]});
        let filled: Value = serde_json::from_str(&filled(&book("items", pages, table)).unwrap()).unwrap();
        let chapter = &filled["items"][1]["Chapter"];
        let text = chapter["content"].as_str().unwrap();
        let setting = text.split_once("class=\"lesson-setting\" data-step=\"fresnel/brewster\">").expect(text).1;
        let setting: Value = serde_json::from_str(setting.split("</script>").next().unwrap()).unwrap();
        assert_eq!(setting[1]["name"], "n_t");
        assert!(!chapter["sub_items"][0]["Chapter"]["content"].as_str().unwrap().contains("<script"));
    }

    #[test]
    fn only_books_are_taken() {
        for bad in
            ["", "{}", "[1,2,3]", "[{},{}]", "[{\"mdbook_version\":\"9.0.0\"},{\"chapters\":[]}]", "null", "[{}, 7]"]
        {
            let refused = filled(bad).expect_err(bad).to_string();
            assert!(refused.starts_with("standard input: "), "{refused}");
        }
        let later = filled("[{\"mdbook_version\":\"9.0.0\"},{\"chapters\":[]}]").expect_err("a fault").to_string();
        assert!(later.contains("mdBook 9.0.0"), "{later}");
    }

    #[test]
    fn only_pages_of_html_show_it() {
        assert_eq!(supports("html"), ExitCode::SUCCESS);
        assert_eq!(supports("latex"), ExitCode::from(1));
    }
}
