//! Figures as pictures: [`chapters::figure::Plot`] to SVG and, with the feature `png`, to PNG.
//!
//! A figure is drawn once, on a `canvas::Canvas`, onto a `sheet::Sheet` that keeps vector shapes; `png` and `svg` write
//! that sheet down. All lengths are in pixels of the sheet, which are CSS pixels; the PNG has `DENSITY` of its own to
//! each.

mod axes;
mod canvas;
#[cfg(feature = "png")]
mod cells;
mod chart;
mod diagram;
mod encode;
#[cfg(all(test, feature = "png", feature = "plotters"))]
mod gallery;
mod ink;
mod key;
mod label;
mod map;
mod marks;
#[cfg(feature = "png")]
mod outline;
mod palette;
#[cfg(feature = "png")]
mod pixels;
#[cfg(feature = "png")]
mod png;
mod sheet;
mod svg;
#[cfg(all(test, feature = "png", feature = "plotters"))]
mod tests;
mod text;
mod ticks;

#[cfg(feature = "png")]
pub use cells::cells;
#[cfg(feature = "png")]
pub use pixels::{Pixels, pixels};

use axes::Axes;
use canvas::{Across, Anchor, Canvas, Down, Frame, Place, Usual};
use chapters::diagram::Diagram;
use chapters::figure::{Chart, Map, Mark, Panel, Picture, Plot};
use palette::Colour;
use sheet::Sheet;

/// Pixels of a PNG to a pixel of the sheet: sharp on dense screens and on a projector.
const DENSITY: u32 = 2;
/// Size of the text: still readable when a figure 640 wide is shown at 400.
const TEXT: f64 = 15.0;
/// Size of a panel's title.
const HEADING: f64 = 16.0;
/// Size of a figure's title.
const TITLE: f64 = 19.0;
/// Height of a line against the size of its text.
const LEADING: f64 = 1.3;
/// Around the figure and between panels.
const MARGIN: f64 = 10.0;
/// Size of the only panel in a row.
const ALONE: (f64, f64) = (620.0, 400.0);
/// Size of one of several panels in a row.
const AMONG: (f64, f64) = (390.0, 320.0);
/// Share of a panel's usual height that the frame gets at least.
const LEAST: f64 = 0.5;

/// The figure as a PNG.
#[cfg(feature = "png")]
pub fn png(plot: &Plot) -> Vec<u8> {
    png::write(&draw::<Usual>(plot))
}

/// The figure as an SVG, named and described for readers who listen. A page that shows it inline may set its colours;
/// see [`colours`].
pub fn svg(plot: &Plot) -> String {
    svg::write(&draw::<Usual>(plot), &plot.title, &description(plot))
}

/// The CSS variables that an inline figure's colours follow, each with its colour where a page does not set it.
pub fn colours() -> impl Iterator<Item = (String, String)> {
    let named = Colour::ALL.into_iter().filter_map(|colour| Some((colour.role()?, colour.hex())));
    named.map(|(role, hex)| (format!("--lesson-{role}"), hex))
}

/// The figure on a sheet.
fn draw<C: Canvas>(plot: &Plot) -> Sheet {
    let columns = columns(plot);
    draw_as::<C>(plot, columns, if columns == 1 { ALONE } else { AMONG })
}

/// The figure on a sheet, its panels in so many columns and of a usual size.
fn draw_as<C: Canvas>(plot: &Plot, columns: usize, usual: (f64, f64)) -> Sheet {
    let bars: Vec<bool> = (0..columns).map(|column| has_bars(plot, columns, column)).collect();
    let sized = plot.panels.iter().enumerate().map(|(at, panel)| size(panel, usual, bars[at % columns]));
    let sizes: Vec<(f64, f64)> = sized.collect();
    let widths: Vec<f64> =
        (0..columns).map(|column| largest(sizes.iter().skip(column).step_by(columns).map(|size| size.0))).collect();
    let heights: Vec<f64> = sizes.chunks(columns).map(|row| largest(row.iter().map(|size| size.1))).collect();
    let gaps = |count: usize| MARGIN * (count + 1) as f64;
    let width = (widths.iter().sum::<f64>() + gaps(columns)).max(200.0);
    let lines = text::wrap(&plot.title, TITLE, width - 4.0 * MARGIN);
    let has_headings = plot.panels.iter().any(|panel| !heading(panel).is_empty());
    let apart = if has_headings && !lines.is_empty() { MARGIN } else { 0.0 };
    let head = block_height(lines.len(), TITLE) + apart;
    let height = heights.iter().sum::<f64>() + gaps(heights.len()) + head;
    let canvas = C::new(width.ceil() as u32, height.ceil() as u32);
    draw_lines(&canvas, &lines, width / 2.0, MARGIN, TITLE);
    let mut laid = Vec::new();
    let mut top = MARGIN + head;
    for (row, height) in plot.panels.chunks(columns).zip(&heights) {
        let mut left = MARGIN;
        let mut beside = Vec::new();
        for ((panel, width), has_bar) in row.iter().zip(&widths).zip(&bars) {
            let room = Frame::at((left, top), *width, *height);
            beside.push((panel, room, *has_bar, lay(panel, room, *has_bar)));
            left += width + MARGIN;
        }
        // What stands under one frame of a row stands under none of the others: all end at one height.
        let bottoms = beside.iter_mut().filter_map(|(.., laid)| Some(laid.axes()?.frame.bottom));
        let end = bottoms.fold(f64::INFINITY, f64::min);
        laid.extend(beside.into_iter().map(|(panel, room, has_bar, mut one)| {
            let over = one.axes().map_or(0.0, |axes| axes.frame.bottom - end);
            if over < 0.5 {
                return one;
            }
            // A key that no longer fits into the lower frame would take more of it: then rather unequal.
            let mut lower = lay(panel, Frame { bottom: room.bottom - over, ..room }, has_bar);
            let is_level = lower.axes().is_some_and(|axes| axes.frame.bottom > end - 2.0);
            if is_level { lower } else { one }
        }));
        top += height + MARGIN;
    }
    Axes::agree(&mut laid.iter_mut().filter_map(Laid::axes).collect::<Vec<_>>());
    laid.iter().for_each(|panel| draw_panel(&canvas, panel));
    canvas.finish()
}

/// Whether the maps in a column need colour bars: not if those on their right have the same.
fn has_bars(plot: &Plot, columns: usize, column: usize) -> bool {
    let explained = |row: &[Panel]| match row.get(column..) {
        Some([Panel::Map(map), Panel::Map(beside), ..]) => map::is_explained_by(map, beside),
        _ => false,
    };
    !plot.panels.chunks(columns).all(explained)
}

/// Panels in a row: as asked for, but no more than two with axes, whose text would be lost on a narrow page.
fn columns(plot: &Plot) -> usize {
    let has_axes = plot.panels.iter().any(|panel| !matches!(panel, Panel::Picture(_)));
    plot.columns.min(if has_axes { 2 } else { usize::MAX }).clamp(1, plot.panels.len().max(1))
}

/// A panel in its room, the title's taken off.
struct Laid<'a> {
    /// In lines, and the place of the middle of its top.
    title: (Vec<String>, Place),
    room: Frame,
    content: Content<'a>,
}

/// What a panel shows, with its arrangement.
enum Content<'a> {
    Chart(&'a Chart, chart::Arrangement<'a>),
    Map(&'a Map, map::Arrangement<'a>),
    Picture(&'a Picture),
    Diagram(diagram::Arrangement<'a>),
}

impl<'a> Laid<'a> {
    fn axes(&mut self) -> Option<&mut Axes<'a>> {
        match &mut self.content {
            Content::Chart(_, arrangement) => Some(&mut arrangement.axes),
            Content::Map(_, arrangement) => Some(&mut arrangement.axes),
            Content::Picture(_) | Content::Diagram(_) => None,
        }
    }
}

fn lay(panel: &Panel, room: Frame, has_bar: bool) -> Laid<'_> {
    let whole = room;
    let (lines, room) = match panel {
        Panel::Chart(_) | Panel::Map(_) | Panel::Diagram(_) => under_title(heading(panel), &whole),
        Panel::Picture(_) => (Vec::new(), whole),
    };
    let content = match panel {
        Panel::Chart(chart) => Content::Chart(chart, chart::arrange(chart, &room)),
        Panel::Map(map) => Content::Map(map, map::arrange(map, &room, has_bar)),
        Panel::Picture(picture) => Content::Picture(picture),
        Panel::Diagram(diagram) => Content::Diagram(diagram::arrange(diagram, &room)),
    };
    let frame = match &content {
        Content::Chart(_, arrangement) => arrangement.axes.frame,
        Content::Map(_, arrangement) => arrangement.axes.frame,
        Content::Diagram(arrangement) => arrangement.frame,
        Content::Picture(_) => whole,
    };
    // Over the axes, but no further out than the panel.
    let half = largest(lines.iter().map(|line| text::width(line, HEADING))) / 2.0;
    let middle = ((frame.left + frame.right) / 2.0).min(whole.right - half).max(whole.left + half);
    Laid { title: (lines, (middle, whole.top)), room, content }
}

/// The title over a panel; a picture has a caption under it instead.
fn heading(panel: &Panel) -> &str {
    match panel {
        Panel::Chart(Chart { title, .. }) | Panel::Map(Map { title, .. }) | Panel::Diagram(Diagram { title, .. }) => {
            title
        }
        Panel::Picture(_) => "",
    }
}

fn largest(lengths: impl Iterator<Item = f64>) -> f64 {
    lengths.fold(0.0, f64::max)
}

/// Height of so many lines of text.
fn block_height(lines: usize, size: f64) -> f64 {
    (lines as f64 * LEADING * size).ceil()
}

/// Sets lines of text under each other around a middle.
fn draw_lines(canvas: &dyn Canvas, lines: &[String], middle: f64, top: f64, size: f64) {
    for (k, line) in lines.iter().enumerate() {
        let place = (middle, top + LEADING * size * k as f64 + 0.15 * size);
        canvas.text(line, place, Anchor(Across::Middle, Down::Top), size, Colour::Ink);
    }
}

/// The size a panel asks for: the usual one, or higher if title, names and key would leave too little to the frame.
fn size(panel: &Panel, usual: (f64, f64), has_bar: bool) -> (f64, f64) {
    let (mut width, mut height) = usual;
    if let (Panel::Map(map), false) = (panel, has_bar) {
        width -= map::bar_width(map, height);
    }
    if let Panel::Map(map) = panel {
        let spare = map::arrange(map, &under_title(&map.title, &Frame::at((0.0, 0.0), width, height)).1, has_bar).spare;
        if spare != (0.0, 0.0) {
            return (width - spare.0, height - spare.1);
        }
    }
    // A frame that has no room at all does not say how much it lacks: the second time it does.
    for _ in 0..3 {
        let room = |title: &str| under_title(title, &Frame::at((0.0, 0.0), width, height)).1;
        let frame = match panel {
            Panel::Chart(chart) => chart::arrange(chart, &room(&chart.title)).axes.frame,
            Panel::Map(map) => map::arrange(map, &room(&map.title), has_bar).axes.frame,
            Panel::Picture(picture) => return captioned_size(picture, usual),
            Panel::Diagram(diagram) => {
                let title = text::wrap(&diagram.title, HEADING, width - 2.0 * MARGIN);
                return (width, block_height(title.len(), HEADING) + diagram::height(diagram, usual));
            }
        };
        height += (LEAST * usual.1 - frame.height()).max(0.0);
    }
    (width, height)
}

/// The size of a picture with its caption.
fn captioned_size(picture: &Picture, usual: (f64, f64)) -> (f64, f64) {
    let (width, height) = picture_size(picture, usual);
    let width = width.max(usual.0 / 2.0);
    let caption = text::wrap(&picture.title, TEXT, width);
    (width, height + MARGIN + block_height(caption.len(), TEXT))
}

/// The size a picture is shown at: each of its pixels is a whole number of pixels of the PNG, as many as fit.
fn picture_size(picture: &Picture, usual: (f64, f64)) -> (f64, f64) {
    let density = f64::from(DENSITY);
    let (columns, rows) = (picture.width as f64, rows(picture) as f64);
    let times = (density * usual.0 / columns).min(density * usual.1 / rows).floor().max(1.0);
    if rows == 0.0 { (0.0, 0.0) } else { (columns * times / density, rows * times / density) }
}

fn rows(picture: &Picture) -> usize {
    picture.pixels.len().checked_div(picture.width).unwrap_or(0)
}

fn draw_panel(canvas: &dyn Canvas, Laid { title: (lines, (middle, top)), room, content }: &Laid) {
    draw_lines(canvas, lines, *middle, *top, HEADING);
    match content {
        Content::Chart(chart, arrangement) => chart::draw(canvas, chart, arrangement),
        Content::Map(map, arrangement) => map::draw(canvas, map, arrangement, room),
        Content::Diagram(arrangement) => diagram::draw(canvas, arrangement),
        Content::Picture(picture) => draw_picture(canvas, picture, room),
    }
}

/// The lines of a panel's title, and the room under it.
fn under_title(title: &str, room: &Frame) -> (Vec<String>, Frame) {
    let lines = text::wrap(title, HEADING, room.width() - 2.0 * MARGIN);
    let top = room.top + block_height(lines.len(), HEADING);
    (lines, Frame { top, ..*room })
}

fn draw_picture(canvas: &dyn Canvas, picture: &Picture, room: &Frame) {
    let lines = text::wrap(&picture.title, TEXT, room.width());
    let caption = block_height(lines.len(), TEXT);
    let (width, height) = picture_size(picture, (room.width(), room.height() - caption - MARGIN));
    let middle = (room.left + room.right) / 2.0;
    let frame = Frame::at(((middle - width / 2.0).round(), room.top), width, height);
    let shown = picture.width * rows(picture);
    let cells = picture.pixels[..shown].iter().map(|pixel| pixel.map(palette::encoded)).collect();
    canvas.image(&frame, picture.width, cells);
    draw_lines(canvas, &lines, middle, frame.bottom + MARGIN, TEXT);
}

/// What a figure shows, in words.
fn description(plot: &Plot) -> String {
    let panels = plot.panels.iter().map(|panel| match panel {
        Panel::Chart(chart) => describe_chart(chart),
        Panel::Map(map) => describe_map(map),
        Panel::Picture(picture) => format!("Picture: {}.", picture.title),
        Panel::Diagram(diagram) => describe_diagram(diagram),
    });
    panels.collect::<Vec<_>>().join(" ")
}

fn describe_chart(Chart { title, x, y, marks }: &Chart) -> String {
    if x.is_bare() && y.is_bare() {
        return format!("{}Drawing in perspective{}.", introduction(title), describe_marks(marks));
    }
    format!("{}{} against {}{}.", introduction(title), label::full(y), label::full(x), describe_marks(marks))
}

fn describe_map(Map { title, x, y, colour, marks, .. }: &Map) -> String {
    let over = if x.is_bare() && y.is_bare() {
        String::new()
    } else {
        format!(" over {} and {}", label::full(x), label::full(y))
    };
    format!("{}Map of {}{over}{}.", introduction(title), label::full(colour), describe_marks(marks))
}

fn describe_diagram(Diagram { title, parts, key, .. }: &Diagram) -> String {
    let named: Vec<&str> = parts.iter().map(|part| part.label.as_str()).filter(|label| !label.is_empty()).collect();
    let named = if named.is_empty() { String::new() } else { format!(" with {}", named.join("; ")) };
    format!("{}Drawing{named}{}.", introduction(title), describe_marks(key))
}

fn introduction(title: &str) -> String {
    if title.is_empty() { String::new() } else { format!("{title}: ") }
}

fn describe_marks(marks: &[Mark]) -> String {
    let names = marks.iter().filter_map(|mark| match mark {
        Mark::Line { label, .. }
        | Mark::Points { label, .. }
        | Mark::Bar { label, .. }
        | Mark::AtX { label, .. }
        | Mark::AtY { label, .. } => Some(label),
        Mark::Broken { .. } | Mark::Vanished { .. } => None,
    });
    let names: Vec<&str> = names.map(String::as_str).filter(|label| !label.is_empty()).collect();
    if names.is_empty() { String::new() } else { format!(", showing {}", names.join("; ")) }
}
