//! What is on the pictures, by content: here by their pixels.

mod canvases;
mod words;

use super::canvas::{Frame, Place};
use super::palette::Colour;
use super::sheet::Sheet;
use super::{DENSITY, chart, gallery, marks, palette, png, svg};
use chapters::figure::*;
use image::RgbImage;
use words::labels;

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
