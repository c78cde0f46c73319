//! Text on the pictures: labels, keys, names and ticks, and what an SVG says.

use super::super::axes::{Axes, Direction};
use super::super::canvas::Frame;
use super::super::palette::Colour;
use super::super::ticks::Extent;
use super::super::{ALONE, AMONG, LEAST, Laid, TEXT, chart, colours, gallery, lay, size, svg, text, under_title};
use super::{draw, grey_map, straight};
use chapters::figure::*;
use proptest::prelude::*;

/// The length of curve within a rectangle, by sampling every tenth of a pixel.
fn covered(chart: &Chart, arrangement: &chart::Arrangement, hidden: &Frame) -> usize {
    let frame = arrangement.axes.frame;
    let curves = chart.marks.iter().flat_map(|mark| match mark {
        Mark::Line { points, .. } | Mark::Points { points, joined: true, .. } => arrangement.axes.plane.pieces(points),
        _ => Vec::new(),
    });
    let segments = curves.flat_map(|piece| piece.windows(2).map(|pair| (pair[0], pair[1])).collect::<Vec<_>>());
    let hits = segments.map(|((x0, y0), (x1, y1))| {
        let steps = (10.0 * ((x1 - x0) * frame.width()).hypot((y1 - y0) * frame.height())).ceil() as usize;
        let at = |k: usize| k as f64 / steps.max(1) as f64;
        let places = (0..=steps).map(|k| frame.place(x0 + at(k) * (x1 - x0), y0 + at(k) * (y1 - y0)));
        places.filter(|place| hidden.meets(&Frame::at(*place, 1e-9, 1e-9))).count()
    });
    hits.sum()
}

fn key_hides_nothing(chart: &Chart, room: &Frame) -> Result<(), TestCaseError> {
    let arrangement = chart::arrange(chart, room);
    if let Some((key, place)) = &arrangement.key {
        let (width, height) = key.size();
        prop_assert_eq!(covered(chart, &arrangement, &Frame::at(*place, width, height)), 0);
    }
    for (k, (label, place)) in arrangement.names.iter().enumerate() {
        let name = chart::name_box(*place, text::width(label, TEXT));
        let others = arrangement.names[..k].iter();
        let touches = others.filter(|(label, place)| name.meets(&chart::name_box(*place, text::width(label, TEXT))));
        prop_assert_eq!(touches.count(), 0, "{} touches another name", label);
    }
    Ok(())
}

#[test]
fn keys_of_the_gallery_hide_nothing() {
    for (_, plot) in gallery::all() {
        for panel in &plot.panels {
            if let Panel::Chart(chart) = panel {
                key_hides_nothing(chart, &Frame::at((0.0, 0.0), AMONG.0, AMONG.1)).unwrap();
                key_hides_nothing(chart, &Frame::at((0.0, 0.0), ALONE.0, ALONE.1)).unwrap();
            }
        }
    }
}

/// Every label of an SVG, its runs joined.
pub fn labels(document: &roxmltree::Document) -> Vec<String> {
    let is_label = |node: &roxmltree::Node| {
        node.has_tag_name("text") && !node.parent().is_some_and(|group| group.has_attribute("aria-label"))
            || node.has_attribute("aria-label")
    };
    let joined =
        |node: roxmltree::Node| node.descendants().filter_map(|part| part.is_text().then(|| part.text())?).collect();
    document.descendants().filter(is_label).map(joined).collect()
}

/// A label as it reads without markup.
fn plain(label: &str) -> String {
    text::runs(label).into_iter().map(|run| run.text).collect()
}

#[test]
fn svg_holds_every_label_as_text() {
    let race = svg(&gallery::race());
    let document = roxmltree::Document::parse(&race).expect("well-formed XML");
    let found = labels(&document);
    let wanted = [
        "time [s]",
        "relative error",
        "10^{−6}",
        "10^{−14}",
        "1",
        "Gauss–Legendre",
        "Sobol’ points",
        "slope −½",
        "ulp",
    ];
    for label in wanted {
        assert!(found.contains(&plain(label)), "{label} is not among {found:?}");
    }
    let reflectance = svg(&gallery::reflectance());
    let document = roxmltree::Document::parse(&reflectance).expect("well-formed XML");
    let found = labels(&document);
    for label in [
        "angle of incidence θ_i [°]",
        "reflectance R",
        "R_s",
        "R_p",
        "R_n = ½ (R_s + R_p)",
        "θ_B = 56.31°",
        "45",
        "0.6",
    ] {
        assert!(found.contains(&plain(label)), "{label} is not among {found:?}");
    }
    let raised = document.descendants().any(|node| node.attribute("aria-label") == Some("R_s"));
    assert!(raised, "runs of a label form a group");
    for name in ["title", "desc"] {
        let node = document.descendants().find(|node| node.has_tag_name(name)).expect(name);
        assert!(node.text().is_some_and(|text| text.contains("reflect")));
    }
}

/// The colours of a page reach every shape but those on a map, and where there are none the attributes say the same.
#[test]
fn colours_can_be_set_by_the_page_and_hold_without_it() {
    for (name, plot) in gallery::all() {
        let written = svg(&plot);
        let document = roxmltree::Document::parse(&written).unwrap();
        let style = document.descendants().find(|node| node.has_tag_name("style")).expect("a style");
        let style = style.text().unwrap();
        assert!(style.starts_with("@supports(color:var(--a))"), "readers without variables drop it whole");
        for node in document.descendants().filter(|node| node.is_element()) {
            let painted = ["fill", "stroke"].into_iter().find_map(|property| {
                let colour = node.attribute(property).filter(|colour| *colour != "none")?;
                Some((property, colour))
            });
            let Some((property, colour)) = painted else { continue };
            match node.attribute("class") {
                Some(class) => {
                    let role = &class[2..];
                    let rule = format!(".lesson-figure .{class}{{{property}:var(--lesson-{role},{colour})}}");
                    assert!(style.contains(&rule), "{name}: {class} is not {rule}");
                    assert!(colours().any(|(variable, hex)| variable == format!("--lesson-{role}") && hex == colour));
                }
                None => assert!(
                    [Colour::Hatch, Colour::Blank].iter().any(|plain| plain.hex() == colour),
                    "{name}: {colour} has no role"
                ),
            }
        }
    }
}

#[test]
fn markup_characters_do_not_break_the_svg() {
    let hostile = "a<b & \"c\" > 'd'\u{7}]]>";
    let chart = Chart::new(hostile, Axis::linear(hostile, hostile), Axis::log(hostile, ""))
        .line(Hue::Nth(200), hostile, vec![[1.0, 1.0], [2.0, 3.0]])
        .at_x(1.5, hostile)
        .at_y(2.0, hostile);
    let written = svg(&Plot::of(hostile, chart));
    roxmltree::Document::parse(&written).expect("well-formed XML");
}

#[test]
fn reference_names_keep_apart() {
    let chart = Chart::new("", Axis::linear("", "").range(0.0, 90.0), Axis::linear("", ""))
        .line(Hue::S, "", vec![[0.0, 0.0], [90.0, 1.0]])
        .at_x(41.8, "θ_c = 41.81°")
        .at_x(33.7, "θ_B = 33.69°")
        .at_x(43.0, "least phase")
        .at_x(89.9, "grazing incidence");
    let written = svg(&Plot::of("", chart));
    let document = roxmltree::Document::parse(&written).unwrap();
    let number =
        |node: &roxmltree::Node, name| node.attribute(name).and_then(|value| value.parse::<f64>().ok()).unwrap();
    let boxes: Vec<Frame> = document
        .descendants()
        .filter(|node| node.has_tag_name("text") && node.attribute("fill") == Some("#606060"))
        .map(|node| Frame::at((number(&node, "x"), number(&node, "y") - 10.0), number(&node, "textLength"), 10.0))
        .collect();
    assert!(boxes.len() >= 6);
    for (k, a) in boxes.iter().enumerate() {
        assert!(boxes[..k].iter().all(|b| !a.grown(-0.5).meets(&b.grown(-0.5))), "{a:?} of {boxes:?}");
    }
}

#[test]
fn markers_beyond_the_axis_are_named_with_an_arrow() {
    let chart = Chart::new("", Axis::log("x", "").range(1.0, 10.0), Axis::linear("y", ""));
    let written = svg(&Plot::of("", chart.at_x(0.0, "none").at_x(20.0, "far").at_x(2.0, "here").at_x(-1.0, "nowhere")));
    let document = roxmltree::Document::parse(&written).unwrap();
    let found = labels(&document);
    assert!(["← none", "far →", "here"].iter().all(|name| found.iter().any(|label| label == name)), "{found:?}");
    assert!(!found.iter().any(|label| label.contains("nowhere")));
}

#[test]
fn long_axes_have_enough_labels_and_say_where_they_start() {
    let labels = |first: f64, last: f64, length: f64| {
        let axis = Axis::log("", "").range(first, last);
        let ticks =
            super::super::axes::ticks(&Extent::new(&axis, std::iter::empty(), 0.0), &axis, length, Direction::Up);
        ticks.into_iter().filter_map(|tick| tick.label).collect::<Vec<_>>()
    };
    for length in [115.0, 150.0, 250.0, 320.0] {
        let found = labels(1e-16, 1.0, length);
        assert!(found.len() >= 4, "{length}: {found:?}");
    }
    assert_eq!(labels(3.0, 1000.0, 250.0), ["5", "10", "100", "1000"]);
}

#[test]
fn panels_of_one_extent_agree_on_ticks() {
    let wide = |title: &str| {
        let mut map = grey_map(vec![0.5; 4], 2);
        map.title = title.into();
        map.x = Axis::log("x", "").range(1e-10, 1.0);
        map
    };
    let narrow = Map { colour: Axis::linear("a b", "").range(0.0, 123_456.0), values: vec![f64::NAN; 4], ..wide("") };
    for panels in [vec![wide("").into(), narrow.clone().into()], vec![narrow.into(), wide("").into()]] {
        let mut laid: Vec<_> =
            panels.iter().map(|panel| lay(panel, Frame::at((0.0, 0.0), AMONG.0, AMONG.1), true)).collect();
        let ticks = |laid: &mut Laid| laid.axes().map(|axes| axes.x_ticks.clone()).unwrap();
        assert_ne!(ticks(&mut laid[0]), ticks(&mut laid[1]), "the panels differ in room");
        Axes::agree(&mut laid.iter_mut().filter_map(Laid::axes).collect::<Vec<_>>());
        assert_eq!(ticks(&mut laid[0]), ticks(&mut laid[1]));
    }
}

#[test]
fn text_of_grids_is_readable_on_narrow_pages() {
    for columns in 1..5 {
        let sheet = draw(&Plot::grid("", columns, vec![Panel::Chart(straight(0.5)); 5]));
        let shown = |page: f64| TEXT * (page / f64::from(sheet.width)).min(1.0);
        assert!(shown(640.0) >= 9.0 && shown(400.0) >= 7.0, "{columns} columns: {} wide", sheet.width);
    }
    let picture = Picture { title: String::new(), width: 100, pixels: vec![[0.5; 3]; 10_000] };
    let sheet = draw(&Plot::grid("", 3, vec![Panel::Picture(picture); 3]));
    assert!(sheet.width > 2 * sheet.height, "pictures stay in a row");
}

fn any_chart() -> impl Strategy<Value = Chart> {
    let value = prop_oneof![8 => -10.0..10.0f64, 1 => Just(f64::NAN), 1 => -1e3..1e3f64];
    let points = proptest::collection::vec([value.clone(), value.clone()], 0..30);
    let lines = proptest::collection::vec((points, "[a-zA-Z_ ]{0,24}"), 0..6);
    let names = proptest::collection::vec((value, "[a-z ]{1,20}"), 0..4);
    (lines, names, any::<bool>(), any::<bool>()).prop_map(|(lines, names, log_x, log_y)| {
        let axis = |log: bool| if log { Axis::log("x", "m") } else { Axis::linear("y", "") };
        let chart = Chart::new("", axis(log_x), axis(log_y));
        let chart = lines
            .into_iter()
            .enumerate()
            .fold(chart, |chart, (k, (points, label))| chart.line(Hue::Nth(k as u8), label, points));
        names.into_iter().fold(chart, |chart, (at, label)| chart.at_x(at, label.clone()).at_y(at, label))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn keys_hide_no_curve(chart in any_chart()) {
        key_hides_nothing(&chart, &Frame::at((0.0, 0.0), 440.0, 330.0))?;
    }
}

#[test]
fn a_crowded_panel_grows_until_the_frame_has_room() {
    let wave =
        |k: u8| (0..50).map(|x| [f64::from(x), (0.3 * f64::from(x) + f64::from(k)).sin() * f64::from(k)]).collect();
    let chart = Chart::new(
        "A title that needs more than a single line to say what it says",
        Axis::linear("x", ""),
        Axis::linear("y", ""),
    );
    let chart =
        (0..12).fold(chart, |chart, k| chart.line(Hue::Nth(k), format!("the curve of number {k} of twelve"), wave(k)));
    let (width, height) = size(&Panel::Chart(chart.clone()), AMONG, true);
    assert!(height > AMONG.1 && height < 3.0 * AMONG.1, "{height}");
    let room = under_title(&chart.title, &Frame::at((0.0, 0.0), width, height)).1;
    let arrangement = chart::arrange(&chart, &room);
    assert!(arrangement.axes.frame.height() >= LEAST * AMONG.1 - 2.0);
    let (key, place) = arrangement.key.as_ref().unwrap();
    assert!(place.1 + key.size().1 <= room.bottom + 1e-9 && place.1 > arrangement.axes.frame.bottom);
    key_hides_nothing(&chart, &room).unwrap();
}
