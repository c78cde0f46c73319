use super::*;
use crate::block::{Assignment, Details, Span, Tone};
use crate::plot;
use crate::report::entry::judge;
use crate::report::{
    CaseReport, CheckReport, LaneReport, Number, PointReport, QuantityReport, RaceReport, StepReport, StressReport,
};
use crate::tell::Teller;
use chapters::judge::Untimed;
use chapters::parameter::Setting;
use chapters::text::English;
use chapters::vocabulary::Item;
use chapters::{CURRICULUM, Chapter, Step};
use roxmltree::{Document, ParsingOptions};

/// A step as if it had been run; of checks, extreme cases and races only their words are true.
fn report(chapter: &Chapter, step: &Step) -> StepReport {
    let at = |id: &str| format!("{}/{}/{id}", chapter.id, step.id);
    let (verdict, value) = (Verdict::Failed, Number(-2.5e-7));
    let checks = step.checks.iter().map(|check| check.head()).map(|check| CheckReport {
        address: at(check.id),
        claim: check.claim,
        rows: check.rows,
        route: check.route,
        value,
        bound: "at most 8 ulp".into(),
        why: "rounding",
        limit: value,
        unit: "1",
        verdict,
        at: "θ_1 < 1e-8 & more".into(),
        cases: 7,
        seconds: 0.0,
        picture: None,
    });
    let case = || CaseReport {
        input: "n 1 → 1e9".into(),
        quantity: "r_s_re",
        reference: "1.2345678901234567e-400".into(),
        textbook: Number(f64::NAN),
        ours: value,
        textbook_digits: 0.0,
        our_digits: 15.0,
        allowed_digits: 14.5,
        condition: value,
        worst_of: 3,
        vanishes: false,
        verdict,
    };
    let stress = step.stress.iter().map(|stress| StressReport {
        address: at(stress.id),
        claim: stress.claim,
        rows: stress.rows,
        textbook: stress.textbook,
        reference: stress.reference,
        cases: (0..10).map(|_| case()).collect(),
        verdict,
        seconds: 0.0,
    });
    let races = step.races.iter().map(|race| RaceReport {
        address: at(race.id),
        claim: race.claim,
        rows: race.rows,
        work: race.work,
        error: race.error,
        reference: race.reference,
        lanes: race
            .lanes
            .iter()
            .map(|lane| LaneReport {
                address: at(&format!("{}/{}", race.id, lane.id)),
                label: lane.label,
                repeats: lane.repeats,
                points: vec![PointReport { work: 10, error: value, seconds: 1e-6, ns_per_work: 100.0 }],
                order: Some(2.0),
                expects: "order 2 ± 0.1".into(),
                verdict,
                asserted: lane.expects,
            })
            .collect(),
    });
    let setting = Setting::defaults(step.parameters());
    let mut report = StepReport {
        address: format!("{}/{}", chapter.id, step.id),
        title: step.title,
        says: step.says,
        rows: step.rows,
        setting: Vec::new(),
        readout: vec![QuantityReport { key: "r_s", symbol: "r_s", says: "field ratio", value, unit: "1" }],
        statements: Vec::new(),
        questions: Vec::new(),
        derivations: Vec::new(),
        checks: checks.collect(),
        stress: stress.collect(),
        races: races.collect(),
        figures: Vec::new(),
    };
    for item in step.items().filter(|item| matches!(item, Item::Statement(_) | Item::Question(_) | Item::Derivation(_)))
    {
        report.enter(judge(item, step.rows_of(&item), &setting, at(item.id()), &Untimed, &|_| true));
    }
    report
}

/// A chapter as a page, and the reports that it was made of.
fn page(chapter: &Chapter) -> (String, Vec<StepReport>) {
    let teller = Teller::new(&English, Details::default());
    let reports: Vec<_> = chapter.steps.iter().map(|step| report(chapter, step)).collect();
    let mut blocks = teller.legend();
    blocks.extend(teller.chapter(chapter));
    for (step, report) in chapter.steps.iter().zip(&reports) {
        blocks.extend(teller.whole(chapter, step, report, &|_| Picture::Absent));
    }
    (document(&Phrase::parse(chapter.title), "en", teller.words(), &blocks), reports)
}

fn parsed(html: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(html, options).unwrap_or_else(|error| panic!("{error}"))
}

fn ids(document: &Document) -> Vec<String> {
    document.descendants().filter_map(|node| node.attribute("id")).map(str::to_owned).collect()
}

fn text(document: &Document) -> String {
    document.descendants().filter(|node| node.is_text()).filter_map(|node| node.text()).collect()
}

/// What a phrase says, without its markup.
fn said(phrase: &str) -> String {
    Phrase::parse(phrase).runs().into_iter().map(|run| run.text).collect()
}

#[test]
fn chapters_are_well_formed_whole_and_from_here() {
    for chapter in CURRICULUM {
        let (html, reports) = page(chapter);
        let document = parsed(&html);
        let ids = ids(&document);
        let mut unique = ids.clone();
        unique.sort();
        unique.dedup();
        assert_eq!(unique.len(), ids.len(), "ids are unique");
        let text = text(&document);
        let mut due = vec![chapter.id.to_owned()];
        let mut claims: Vec<&str> = vec![chapter.title];
        for (step, report) in chapter.steps.iter().zip(&reports) {
            due.push(report.address.clone());
            due.extend(report.statements.iter().map(|item| item.address.clone()));
            due.extend(report.derivations.iter().map(|item| item.address.clone()));
            due.extend(report.checks.iter().map(|item| item.address.clone()));
            due.extend(report.stress.iter().map(|item| item.address.clone()));
            due.extend(report.races.iter().map(|item| item.address.clone()));
            due.extend(report.races.iter().flat_map(|race| &race.lanes).map(|lane| lane.address.clone()));
            due.extend(step.exhibit.figures.iter().map(|figure| format!("{}/{}", report.address, figure.id)));
            claims.extend([step.title, step.says]);
            claims.extend(step.statements.iter().map(|item| item.says));
            claims.extend(step.derivations.iter().map(|item| item.says));
            claims.extend(step.checks.iter().flat_map(|item| [item.head().claim, item.head().route]));
            claims.extend(step.questions.iter().flat_map(|item| [item.asks]));
            due.extend(report.questions.iter().map(|item| item.address.clone()));
            claims.extend(step.stress.iter().flat_map(|item| [item.claim, item.textbook, item.reference]));
            claims.extend(step.races.iter().flat_map(|item| [item.claim, item.reference]));
            claims.extend(step.exhibit.figures.iter().map(|item| item.says));
        }
        for address in due {
            assert!(ids.contains(&address), "{address}");
        }
        for claim in claims {
            assert!(text.contains(&said(claim)), "{claim}");
        }
        for forbidden in ["<script", "http:", "https:", "src=", "url(", "@import"] {
            assert!(!html.contains(forbidden), "{forbidden}");
        }
        let named = |name: &'static str| document.descendants().filter(move |node| node.has_tag_name(name));
        assert!(named("table").all(|table| table.children().any(|child| child.has_tag_name("caption"))));
        assert!(named("th").all(|head| head.has_attribute("scope")));
        let anchors = named("a").filter_map(|anchor| anchor.attribute("href"));
        assert!(anchors.map(|href| &href[1..]).all(|target| ids.iter().any(|id| id == target)));
        for judged in document.descendants().filter(|node| node.attribute("class") == Some("judged failed")) {
            let text: String = judged.descendants().filter_map(|node| node.text()).collect();
            assert!(text.contains("✗ failed:"), "{text}");
        }
    }
}

#[test]
fn lists_of_what_there_is_are_well_formed() {
    let teller = Teller::english(Details::default());
    let functions = CURRICULUM.iter().flat_map(|chapter| chapter.functions);
    let fresnel = &chapters::fresnel::CHAPTER;
    let folded = teller.lecture(fresnel, &fresnel.steps[0], &report(fresnel, &fresnel.steps[0]), true);
    for blocks in [
        teller.map(),
        teller.contents(fresnel),
        teller.chapters_help(CURRICULUM),
        teller.step_help(fresnel, &fresnel.steps[0]),
        folded,
        teller.coverage(),
        teller.functions(functions),
    ] {
        let html = document(&Phrase::parse("R_s & more"), "en", teller.words(), &blocks);
        assert!(parsed(&html).root_element().has_tag_name("html"));
        assert_eq!(blocks.len(), crate::json::blocks(&blocks).as_array().unwrap().len());
    }
}

#[test]
fn figures_stand_inside() {
    let step =
        CURRICULUM.iter().flat_map(|chapter| chapter.steps).find(|step| !step.exhibit.figures.is_empty()).unwrap();
    let svg = plot::svg(&(step.exhibit.figures[0].plot)(&Setting::defaults(step.parameters())));
    let says = Phrase::parse("it's \"R_s\" < 1");
    let figure = Figure { address: "a/b/c".into(), says, picture: Picture::Svg(svg) };
    let html = fragment(Words::ENGLISH, &[Block::Figure(figure.clone()), Block::Figure(figure)]);
    let html = format!("<main>{html}</main>");
    let document = parsed(&html);
    assert_eq!(ids(&document), ["a/b/c"], "what is told twice has one id");
    let image = document.descendants().find(|node| node.attribute("role") == Some("img")).unwrap();
    assert_eq!(image.attribute("aria-label"), Some("it's \"Rₛ\" < 1"));
    assert!(image.children().any(|child| child.tag_name().name() == "svg"));
}

#[test]
fn answers_are_folded() {
    let choice = |says: &str, right| Choice { says: Phrase::parse(says), right, response: Phrase::parse("by R_0 < 1") };
    let choices = Answers::Choices(vec![choice("R_s", false), choice("R_p", true)]);
    let number = Answers::Number { value: 0.04, unit: "1".into(), tolerance: 0.01, response: Phrase::parse("by R_0") };
    for (answers, folds) in [(choices, 2), (number, 1)] {
        let question = Question { address: "a/b/q".into(), prompt: vec![Span::plain("Which?")], answers, open: false };
        let blocks = [Block::Question(question)];
        let html = format!("<main>{}</main>", fragment(Words::ENGLISH, &blocks));
        let document = parsed(&html);
        let details: Vec<_> = document.descendants().filter(|node| node.has_tag_name("details")).collect();
        assert_eq!(details.len(), folds);
        let inside = |node: &roxmltree::Node| node.ancestors().any(|node| node.has_tag_name("details"));
        let responses: Vec<_> =
            document.descendants().filter(|node| node.text().is_some_and(|t| t.contains("by "))).collect();
        assert!(responses.len() >= folds && responses.iter().all(inside));
        assert!(details.iter().all(|node| !node.has_attribute("open")));
        let json = crate::json::blocks(&blocks);
        assert!(json[0]["fold"]["answer"].is_object() && json[0]["prompt"][0]["text"] == "Which?");
    }
}

#[test]
fn what_is_typed_stays_as_it_is() {
    let blocks = [
        Block::Setting(vec![Assignment { name: "n_t".into(), text: "<gold>".into() }]),
        Block::Code("a_b & c\n  d".into()),
        Block::Line("1e-5".into()),
        Block::paragraph(0, 0, vec![Span::verbatim(Tone::Code, "--set n_t")]),
    ];
    let html = format!("<main>{}</main>", fragment(Words::ENGLISH, &blocks));
    let document = parsed(&html);
    let words: Vec<_> = document.descendants().filter(|node| node.is_text()).filter_map(|node| node.text()).collect();
    for due in ["n_t=<gold>", "a_b & c\n  d", "1e-5", "--set n_t"] {
        assert!(words.contains(&due), "{due}: {words:?}");
    }
}
