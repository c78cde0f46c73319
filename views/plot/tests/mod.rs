//! What is on the pictures, by content.

mod canvases;

use super::axes::Direction;
use super::canvas::{Frame, Place};
use super::palette::Colour;
use super::sheet::Sheet;
use super::ticks::Extent;
use super::{AMONG, DENSITY, chart, gallery, marks, palette, png, svg};
use chapters::figure::*;
use image::RgbImage;
use proptest::prelude::*;

fn draw(plot: &Plot) -> Sheet {
    super::draw::<super::Usual>(plot)
}

fn decoded(plot: &Plot) -> RgbImage {
    image::load_from_memory(&png(plot)).expect("a PNG").to_rgb8()
}

fn straight(y: f64) -> Chart {
    let axis = || Axis::linear("", "").range(0.0, 1.0);
    Chart::new("", axis(), axis()).line(Hue::S, "", vec![[0.0, y], [1.0, y]])
}

/// The frame of a figure that is one chart without any title.
fn frame(chart: &Chart) -> Frame {
    let room = Frame::at((super::MARGIN, super::MARGIN), super::ALONE.0, super::ALONE.1);
    chart::arrange(chart, &room).axes.frame
}

/// Middle of the pixels of a hue in a column of the PNG, each weighted by its coverage.
fn middle(image: &RgbImage, column: u32, hue: Hue) -> Option<f64> {
    let [red, _, _] = palette::colour(hue).rgb();
    let [own_red, own_green, own_blue] = palette::colour(hue).rgb();
    let (mut weights, mut sum) = (0.0, 0.0);
    for row in 0..image.height() {
        let [r, g, b] = image.get_pixel(column, row).0.map(f64::from);
        // On white, coverage moves every component by the same share towards the hue.
        let share = (255.0 - r) / (255.0 - f64::from(red));
        let expected = [own_red, own_green, own_blue].map(|c| 255.0 + share * (f64::from(c) - 255.0));
        let off = [r, g, b].iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if share > 0.02 && off < 3.0 {
            weights += share;
            sum += share * (f64::from(row) + 0.5);
        }
    }
    (weights > 1.0).then(|| sum / weights)
}

#[test]
fn curves_go_where_the_data_say() {
    let axis = || Axis::linear("", "").range(0.0, 1.0).tick(1.0);
    let wave = |x: f64| 0.5 + 0.3 * (7.0 * x).sin();
    let points = (0..=2000).map(|k| f64::from(k) / 2000.0).map(|x| [x, wave(x)]).collect();
    let chart = Chart::new("", axis(), axis()).line(Hue::S, "", points);
    let (frame, image) = (frame(&chart), decoded(&Plot::of("", chart)));
    let density = f64::from(DENSITY);
    let mut seen = 0;
    for column in (0..image.width()).step_by(7) {
        let x = ((f64::from(column) + 0.5) / density - frame.left) / frame.width();
        if !(0.02..0.98).contains(&x) {
            assert!((-0.01..=1.01).contains(&x) || middle(&image, column, Hue::S).is_none());
            continue;
        }
        let expected = density * frame.place(x, wave(x)).1;
        let found = middle(&image, column, Hue::S).expect("a curve in every column");
        assert!((found - expected).abs() < 0.5, "column {column}: {found} instead of {expected}");
        seen += 1;
    }
    assert!(seen > 100);
}

#[test]
fn a_third_of_a_pixel_shows() {
    let frame = frame(&straight(0.5));
    let third = 1.0 / (3.0 * f64::from(DENSITY) * frame.height());
    let column = ((frame.left + frame.right) / 2.0) as u32 * DENSITY;
    let at = |k: i32| middle(&decoded(&Plot::of("", straight(0.45 + f64::from(k) * third))), column, Hue::S).unwrap();
    for k in 1..6 {
        let moved = at(0) - at(k);
        // The rasteriser has four rows of samples to a pixel.
        assert!((moved - f64::from(k) / 3.0).abs() <= 0.25, "{k} thirds of a pixel moved the curve by {moved}");
    }
}

#[test]
fn values_that_are_no_numbers_break_a_curve() {
    let points =
        vec![[0.0, 0.5], [0.4, 0.5], [0.45, f64::NAN], [0.6, 0.5], [0.7, f64::INFINITY], [0.8, 0.5], [1.0, 0.5]];
    let axis = || Axis::linear("", "").range(0.0, 1.0).tick(1.0);
    let chart = Chart::new("", axis(), axis()).line(Hue::P, "", points);
    let (frame, image) = (frame(&chart), decoded(&Plot::of("", chart)));
    let is_there = |x: f64| middle(&image, (frame.place(x, 0.0).0 * f64::from(DENSITY)) as u32, Hue::P).is_some();
    assert!(is_there(0.2) && is_there(0.9) && is_there(0.6), "the lone point at 0.6 is a dot");
    assert!(!is_there(0.5) && !is_there(0.7));
}

#[test]
fn curves_end_at_the_frame() {
    let steep = vec![[-5.0, -40.0], [6.0, 48.0], [7.0, -1e300]];
    let axis = || Axis::linear("", "").range(0.0, 1.0);
    let chart = Chart::new("", axis(), axis()).line(Hue::Ours, "", steep);
    let (frame, image) = (frame(&chart).grown(2.0), decoded(&Plot::of("", chart)));
    let [red, green, blue] = palette::colour(Hue::Ours).rgb();
    let inked = image.enumerate_pixels().filter(|(_, _, pixel)| pixel.0 == [red, green, blue]);
    let places = inked.map(|(x, y, _)| (f64::from(x) / f64::from(DENSITY), f64::from(y) / f64::from(DENSITY)));
    let places: Vec<Place> = places.collect();
    assert!(places.len() > 500);
    assert!(places.iter().all(|(x, y)| frame.meets(&Frame::at((*x, *y), 1e-6, 1e-6))));
}

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
        let name = chart::name_box(*place, super::text::width(label, super::TEXT));
        let others = arrangement.names[..k].iter();
        let touches = others
            .filter(|(label, place)| name.meets(&chart::name_box(*place, super::text::width(label, super::TEXT))));
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
                key_hides_nothing(chart, &Frame::at((0.0, 0.0), super::ALONE.0, super::ALONE.1)).unwrap();
            }
        }
    }
}

/// Every label of an SVG, its runs joined.
fn labels(document: &roxmltree::Document) -> Vec<String> {
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
    super::text::runs(label).into_iter().map(|run| run.text).collect()
}

#[test]
fn svg_holds_every_label_as_text() {
    let race = svg(&gallery::race());
    let document = roxmltree::Document::parse(&race).expect("well-formed XML");
    let found = labels(&document);
    let wanted =
        ["time [s]", "relative error", "10^{−6}", "10^{−14}", "1", "Gauss–Legendre", "Sobol’ points", "slope −½", "ε"];
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

fn grey_map(values: Vec<f64>, columns: usize) -> Map {
    let axis = |to: f64| Axis::linear("", "").range(0.0, to);
    Map {
        title: String::new(),
        x: axis(1.0),
        y: axis(1.0),
        colour: axis(1.0),
        ramp: Ramp::Sequential,
        columns,
        values,
        marks: Vec::new(),
    }
}

#[test]
fn cells_of_a_map_run_from_the_bottom_left() {
    let values = vec![0.0, 0.25, 0.5, 0.75, f64::NAN, 1.0];
    let sheet = draw(&Plot::of("", grey_map(values.clone(), 3)));
    let place = sheet.items.iter().find_map(|item| match item {
        super::sheet::Item::Image(image) if image.columns == 3 => Some(image.place),
        _ => None,
    });
    let (place, image) = (place.unwrap(), decoded(&Plot::of("", grey_map(values.clone(), 3))));
    for (k, value) in values.iter().enumerate() {
        let (column, row) = ((k % 3) as f64, (k / 3) as f64);
        let left = (2.0 * (place.left + column * place.width() / 3.0)) as u32 + 4;
        let top = (2.0 * (place.bottom - (row + 1.0) * place.height() / 2.0)) as u32 + 4;
        let inside = |x, y| image.get_pixel(left + x, top + y).0;
        match palette::ramp(Ramp::Sequential, *value) {
            Some(colour) => assert!((0..50).all(|k| inside(k, k) == colour), "cell {k}"),
            None => {
                let [red, green, blue] = Colour::Blank.rgb();
                let shades: std::collections::HashSet<_> = (0..50).map(|k| inside(k, 20)).collect();
                assert!(shades.contains(&[red, green, blue]) && shades.len() > 1, "a broken cell is hatched");
            }
        }
    }
    let document = svg(&Plot::of("", grey_map(values, 3)));
    assert!(document.contains(">broken</text>"));
    assert!(!svg(&Plot::of("", grey_map(vec![0.0; 6], 3))).contains(">broken</text>"));
}

#[test]
fn pixels_of_a_picture_are_whole() {
    let pixels: Vec<[f32; 3]> = (0..64 * 48).map(|k| [k as f32 / 3072.0, 0.5, 0.0]).collect();
    let image =
        decoded(&Plot::of("", Panel::Picture(Picture { title: String::new(), width: 64, pixels: pixels.clone() })));
    let first = image.enumerate_pixels().find(|(_, _, pixel)| pixel.0 != [255; 3]).map(|(x, y, _)| (x, y)).unwrap();
    let last =
        image.enumerate_pixels().filter(|(_, _, pixel)| pixel.0 != [255; 3]).map(|(x, y, _)| (x, y)).last().unwrap();
    let times = (last.0 + 1 - first.0) / 64;
    assert_eq!((last.0 + 1 - first.0, last.1 + 1 - first.1), (64 * times, 48 * times));
    assert!(times >= 8);
    for (k, pixel) in pixels.iter().enumerate() {
        let (x, y) = (first.0 + k as u32 % 64 * times, first.1 + k as u32 / 64 * times);
        let expected = pixel.map(palette::encoded);
        assert_eq!(image.get_pixel(x, y).0, expected);
        assert_eq!(image.get_pixel(x + times - 1, y + times - 1).0, expected);
    }
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
fn lines_end_below_their_names() {
    let axis = || Axis::linear("", "").range(0.0, 1.0);
    let chart = Chart::new("", axis(), axis()).at_x(0.4, "θ_B").at_x(0.6, "θ_c");
    let (frame, image) = (frame(&chart), decoded(&Plot::of("", chart)));
    let is_white = |y: f64| {
        let row = (y * f64::from(DENSITY)) as u32;
        let columns = (frame.left as u32 + 1) * DENSITY..(frame.right as u32 - 1) * DENSITY;
        columns.into_iter().all(|column| image.get_pixel(column, row).0 == [255; 3])
    };
    assert!(is_white(frame.top - 1.6), "a line goes on above the frame");
    assert!(!is_white(frame.top - 10.0) && !is_white(frame.top + 10.0));
}

#[test]
fn what_is_not_finite_is_above_the_frame() {
    let chart = Chart::new("", Axis::log("t", "ns").range(1.0, 100.0), Axis::log("error", "").range(1e-16, 1.0))
        .with(Mark::Points { label: "lane".into(), hue: Hue::P, shape: Shape::Disc, joined: false, points: vec![] })
        .with(Mark::Broken { hue: Hue::P, shape: Shape::Disc, at: vec![10.0, 1e9, f64::NAN] })
        .at_x(30.0, "θ_B");
    let room = Frame::at((super::MARGIN, super::MARGIN), super::ALONE.0, super::ALONE.1);
    let arrangement = chart::arrange(&chart, &room);
    let (frame, band) = (arrangement.axes.frame, arrangement.axes.band.expect("a band"));
    assert!(room.top < band.top && band.bottom < frame.top && (band.left, band.right) == (frame.left, frame.right));
    let image = decoded(&Plot::of("", chart.clone()));
    let at = |(x, y): Place| image.get_pixel(x as u32 * DENSITY, y as u32 * DENSITY).0;
    let [red, green, blue] = palette::colour(Hue::P).rgb();
    assert_eq!(at(band.place(0.5, 0.5)), [red, green, blue]);
    assert_ne!(at(band.place(0.25, 0.5)), [red, green, blue]);
    let written = svg(&Plot::of("", chart));
    let document = roxmltree::Document::parse(&written).unwrap();
    let found = labels(&document);
    for once in ["not finite", "lane"] {
        assert_eq!(found.iter().filter(|label| *label == once).count(), 1, "{once} in {found:?}");
    }
    assert!(!svg(&gallery::race()).contains("not finite"));
}

#[test]
fn what_is_zero_is_under_the_frame_and_stays_in_its_band() {
    let chart = Chart::new("", Axis::log("t", "ns").range(1.0, 100.0), Axis::log("error", "").range(1e-16, 1.0))
        .with(Mark::Vanished { hue: Hue::P, shape: Shape::Triangle, at: vec![10.0, 100.0] });
    let room = Frame::at((super::MARGIN, super::MARGIN), super::ALONE.0, super::ALONE.1);
    let axes = chart::arrange(&chart, &room).axes;
    let (frame, band) = (axes.frame, axes.zeros.expect("a band"));
    assert!(frame.bottom < band.top && band.bottom < room.bottom && axes.band.is_none());
    let image = decoded(&Plot::of("", chart.clone()));
    let [red, green, blue] = palette::colour(Hue::P).rgb();
    let at = |(x, y): Place| image.get_pixel(x as u32 * DENSITY, y as u32 * DENSITY).0;
    assert_eq!(at(band.place(0.5, 0.5)), [red, green, blue]);
    let outside = (band.right as u32 + 2) * DENSITY..image.width();
    assert!(outside.into_iter().all(|x| image.get_pixel(x, band.place(0.0, 0.5).1 as u32 * DENSITY).0 == [255; 3]));
    assert!(svg(&Plot::of("", chart)).contains("exactly 0"));
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
        let ticks = super::axes::ticks(&Extent::new(&axis, std::iter::empty(), 0.0), &axis, length, Direction::Up);
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
            panels.iter().map(|panel| super::lay(panel, Frame::at((0.0, 0.0), AMONG.0, AMONG.1))).collect();
        let ticks = |laid: &mut super::Laid| laid.axes().map(|axes| axes.x_ticks.clone()).unwrap();
        assert_ne!(ticks(&mut laid[0]), ticks(&mut laid[1]), "the panels differ in room");
        super::Axes::agree(&mut laid.iter_mut().filter_map(super::Laid::axes).collect::<Vec<_>>());
        assert_eq!(ticks(&mut laid[0]), ticks(&mut laid[1]));
    }
}

#[test]
fn text_of_grids_is_readable_on_narrow_pages() {
    for columns in 1..5 {
        let sheet = draw(&Plot::grid("", columns, vec![Panel::Chart(straight(0.5)); 5]));
        let shown = |page: f64| super::TEXT * (page / f64::from(sheet.width)).min(1.0);
        assert!(shown(640.0) >= 9.0 && shown(400.0) >= 7.0, "{columns} columns: {} wide", sheet.width);
    }
    let picture = Picture { title: String::new(), width: 100, pixels: vec![[0.5; 3]; 10_000] };
    let sheet = draw(&Plot::grid("", 3, vec![Panel::Picture(picture); 3]));
    assert!(sheet.width > 2 * sheet.height, "pictures stay in a row");
}

#[test]
fn the_same_figure_is_the_same_bytes() {
    assert_eq!(png(&gallery::grid()), png(&gallery::grid()));
    assert_eq!(svg(&gallery::grid()), svg(&gallery::grid()));
}

fn can_be_drawn(plot: &Plot) {
    assert!(decoded(plot).width() > 0);
    roxmltree::Document::parse(&svg(plot)).expect("well-formed XML");
}

#[test]
fn degenerate_figures_can_be_drawn() {
    can_be_drawn(&Plot::grid("", 0, Vec::new()));
    can_be_drawn(&Plot { title: String::new(), panels: Vec::new(), columns: 0 });
    let axes: Vec<fn() -> Axis> = vec![
        || Axis::linear("x", "1"),
        || Axis::log("x", "m"),
        || Axis::linear("x", "").range(1.0, 1.0),
        || Axis::linear("x", "").range(1.0, -1.0),
        || Axis::linear("x", "").range(f64::NAN, f64::INFINITY),
        || Axis::linear("x", "").range(f64::MIN, f64::MAX).tick(0.0),
        || Axis::linear("x", "").range(0.0, 5e-324).tick(-1.0),
        || Axis::linear("x", "").range(1.0, 1.0 + f64::EPSILON).tick(f64::NAN),
        || Axis::log("x", "").range(-1.0, 0.0),
        || Axis::log("x", "").range(5e-324, f64::MAX),
        || Axis::log("x", "").range(10.0, 1.0),
        || Axis::linear("x", "").range(0.0, 1.0).tick(1e-300),
    ];
    let data: Vec<Vec<[f64; 2]>> = vec![
        Vec::new(),
        vec![[1.0, 1.0]],
        vec![[f64::NAN; 2]; 3],
        vec![[0.0, 0.0], [0.0, 0.0]],
        vec![[-1.0, -1.0], [0.0, -2.0]],
        vec![[f64::MIN, f64::MAX], [f64::MAX, f64::MIN]],
        vec![[5e-324, 5e-324], [1e-310, 1e-320]],
        vec![[1.0, 2.0], [f64::INFINITY, 3.0], [2.0, f64::NEG_INFINITY], [3.0, 1e-300]],
    ];
    for (x, points) in axes.iter().flat_map(|x| data.iter().map(move |points| (x, points))) {
        for y in [|| Axis::linear("y", ""), || Axis::log("y", "")] {
            let chart = Chart::new("", x(), y())
                .line(Hue::S, "a", points.clone())
                .with(Mark::Points {
                    label: "b".into(),
                    hue: Hue::P,
                    shape: Shape::Cross,
                    joined: true,
                    points: points.clone(),
                })
                .at_x(f64::NAN, "nowhere")
                .at_y(f64::INFINITY, "nowhere");
            let sheet = draw(&Plot::of("t", chart));
            assert!(!sheet.items.is_empty());
            roxmltree::Document::parse(&super::svg::write(&sheet, "", "")).expect("well-formed XML");
        }
    }
    for (columns, values) in
        [(0, vec![]), (0, vec![1.0]), (5, vec![1.0]), (1, vec![f64::NAN]), (2, vec![f64::INFINITY, f64::NEG_INFINITY])]
    {
        can_be_drawn(&Plot::of("", grey_map(values, columns)));
    }
    for (width, pixels) in
        [(0, vec![]), (0, vec![[1.0; 3]]), (3, vec![[1.0; 3]]), (1, vec![[f32::NAN; 3]]), (usize::MAX, vec![])]
    {
        can_be_drawn(&Plot::of("", Panel::Picture(Picture { title: "p".into(), width, pixels })));
    }
    let many = (0..20_000).map(|k| [f64::from(k), f64::from(k * 7919 % 1000)]).collect();
    can_be_drawn(&Plot::of(
        "",
        Chart::new("", Axis::linear("", ""), Axis::linear("", "")).line(Hue::Nth(9), "many", many),
    ));
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
fn crowds_stay_small() {
    let points: Vec<[f64; 2]> = (0..5000).map(|k| [f64::from(k % 70), f64::from(k % 71)]).collect();
    assert_eq!(
        marks::points(&[Mark::Points {
            label: String::new(),
            hue: Hue::S,
            shape: Shape::Disc,
            joined: false,
            points: points.clone()
        }])
        .count(),
        5000
    );
    let chart = Chart::new("", Axis::linear("", ""), Axis::linear("", "")).with(Mark::Points {
        label: String::new(),
        hue: Hue::S,
        shape: Shape::Disc,
        joined: false,
        points: points.iter().chain(&points).copied().collect(),
    });
    let written = svg(&Plot::of("", chart));
    assert!(written.matches("<circle").count() <= 71 * 70, "points that hide each other are drawn once");
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
    let (width, height) = super::size(&Panel::Chart(chart.clone()), AMONG);
    assert!(height > AMONG.1 && height < 3.0 * AMONG.1, "{height}");
    let room = super::under_title(&chart.title, &Frame::at((0.0, 0.0), width, height)).1;
    let arrangement = chart::arrange(&chart, &room);
    assert!(arrangement.axes.frame.height() >= super::LEAST * AMONG.1 - 2.0);
    let (key, place) = arrangement.key.as_ref().unwrap();
    assert!(place.1 + key.size().1 <= room.bottom + 1e-9 && place.1 > arrangement.axes.frame.bottom);
    key_hides_nothing(&chart, &room).unwrap();
}

/// Writes the gallery to a folder named by `LESSON_GALLERY`, for looking at.
#[test]
fn gallery_can_be_written() {
    for (name, plot) in gallery::all() {
        let (png, svg) = (png(&plot), svg(&plot));
        assert!(png.len() < 200_000, "{name}.png has {} bytes", png.len());
        if let Some(folder) = std::env::var_os("LESSON_GALLERY") {
            let folder = std::path::Path::new(&folder);
            std::fs::create_dir_all(folder).unwrap();
            std::fs::write(folder.join(format!("{name}.png")), png).unwrap();
            std::fs::write(folder.join(format!("{name}.svg")), svg).unwrap();
        }
    }
}
