//! Colour maps with their colour bar.

use super::axes::{self, Axes, Direction, Spare};
use super::canvas::{Across, Anchor, Canvas, Down, Frame, Place};
use super::chart;
use super::key::Key;
use super::label::Label;
use super::marks::{self, Plane};
use super::palette::{self, Colour};
use super::ticks::{Extent, Tick};
use super::{TEXT, text};
use chapters::figure::{Map, Mark, Ramp, Scale};

/// Width of the colour bar and its distance from the frame.
const BAR: f64 = 18.0;
const APART: f64 = 16.0;
/// Height kept under the bar for the sign of what is broken.
const SIGN: f64 = 36.0;
/// Between two strokes of the hatching, along an edge.
const HATCH: f64 = 7.0;
/// What the key says of cells without a value.
const BROKEN_NAME: &str = "broken";

/// Where everything goes.
pub struct Arrangement<'a> {
    /// The frame with its ticks and labels.
    pub axes: Axes<'a>,
    bar: Bar,
    has_bar: bool,
    key: Option<Key<'a>>,
    /// Across and down: what is left of the room, so that cells of a picture are as high as wide.
    pub spare: (f64, f64),
}

/// How much longer one side of a picture's frame may be than the other, before its cells are not as high as wide.
const LONGEST: f64 = 3.0;

/// The width of a frame over its height, if its cells are a picture's: those of axes without ticks, or of a square in
/// space, in which what is round must look round.
fn aspect(map: &Map) -> Option<f64> {
    let is_square = map.x.unit == map.y.unit && !map.x.unit.is_empty() && map.x.range == map.y.range;
    if is_square && map.x.scale == Scale::Linear && map.y.scale == Scale::Linear {
        return Some(1.0);
    }
    let rows = map.values.len().checked_div(map.columns).filter(|rows| *rows > 0)?;
    let aspect = map.columns as f64 / rows as f64;
    (map.x.is_bare() && map.y.is_bare()).then(|| aspect.clamp(1.0 / LONGEST, LONGEST))
}

/// The room that the colour bar of a map takes in a room of that height.
pub fn bar_width(map: &Map, height: f64) -> f64 {
    Bar::new(map, height).width()
}

/// Whether a map beside `map` says by its own colour bar what the colours of `map` mean.
pub fn is_explained_by(map: &Map, beside: &Map) -> bool {
    map.colour == beside.colour && map.ramp == beside.ramp && !Bar::new(map, 1.0).is_broken
}

/// Places frame, key and, unless it stands beside another map, the colour bar.
pub fn arrange<'a>(map: &'a Map, room: &Frame, has_bar: bool) -> Arrangement<'a> {
    let bar = Bar::new(map, room.height());
    let right = if has_bar { bar.width() } else { 0.0 };
    let key = Some(Key::new(&map.marks)).filter(|key| !key.is_empty()).map(|key| key.below(room));
    let below = key.as_ref().map_or(0.0, |key| key.size().1);
    let plane = chart::plane(&map.x, &map.y, &map.marks);
    let beside = || Spare { right, below };
    let within = |room: &Frame| Axes::new(&map.x, &map.y, plane, &map.marks, room, beside());
    let mut axes = within(room);
    let mut spare = (0.0, 0.0);
    if let Some(aspect) = aspect(map) {
        let (width, height) = (axes.frame.width(), axes.frame.height());
        spare = ((width - height * aspect).max(0.0), (height - width / aspect).max(0.0));
        axes = within(&Frame { right: room.right - spare.0, bottom: room.bottom - spare.1, ..*room });
    }
    Arrangement { axes, bar, has_bar, key, spare }
}

/// Draws a map into `room` as arranged.
pub fn draw(canvas: &dyn Canvas, map: &Map, Arrangement { axes, bar, has_bar, key, .. }: &Arrangement, room: &Frame) {
    let plane = axes.plane;
    let cells = Cells { values: &map.values, columns: map.columns };
    cells.draw(canvas, &axes.frame, &bar.extent, map.ramp);
    marks::draw(canvas, &axes.frame, &plane, &map.marks, true);
    axes.draw(canvas);
    name_lines(canvas, &axes.frame, &plane, &map.marks);
    if *has_bar {
        bar.draw(canvas, &axes.frame);
    }
    if let Some(key) = key {
        key.draw(canvas, chart::outside_place(key, &axes.frame, room, 0.0));
    }
}

/// Names horizontal reference lines over their right ends: on a map there is no place without ink.
fn name_lines(canvas: &dyn Canvas, frame: &Frame, plane: &Plane, marks: &[Mark]) {
    for (y, label) in marks.iter().filter_map(|mark| chart::at_y(plane, mark)) {
        let (right, height) = frame.place(1.0, y);
        let width = text::width(label, TEXT);
        let [over, under] = chart::beside_line(height).map(|baseline| (right - 8.0 - width, baseline));
        let place = if chart::name_box(over, width).top > frame.top { over } else { under };
        chart::draw_name(canvas, label, place, Colour::Ink);
    }
}

/// The values of a map, row by row from the bottom.
struct Cells<'a> {
    values: &'a [f64],
    columns: usize,
}

impl Cells<'_> {
    fn rows(&self) -> usize {
        self.values.len().checked_div(self.columns).unwrap_or(0)
    }

    fn draw(&self, canvas: &dyn Canvas, frame: &Frame, extent: &Extent, ramp: Ramp) {
        let rows = self.rows();
        let colour = |value: &f64| shade(extent, ramp, *value).unwrap_or(Colour::Blank.rgb());
        let from_top = (0..rows).rev().flat_map(|row| &self.values[row * self.columns..][..self.columns]);
        canvas.image(frame, self.columns, from_top.map(colour).collect());
        if rows > 0 {
            hatch(canvas, frame, self.columns, rows, |column, row| {
                shade(extent, ramp, self.values[row * self.columns + column]).is_none()
            });
        }
    }
}

/// Colour of a value, those beyond the range in the colour of its end; none for NaN.
fn shade(extent: &Extent, ramp: Ramp, value: f64) -> Option<[u8; 3]> {
    palette::ramp(ramp, extent.position(value))
}

/// Strokes at 45° over the cells that are broken, on one lattice for the whole frame so that they join.
fn hatch(canvas: &dyn Canvas, frame: &Frame, columns: usize, rows: usize, is_broken: impl Fn(usize, usize) -> bool) {
    let (width, height) = (frame.width(), frame.height());
    let (wide, high) = (width / columns as f64, height / rows as f64);
    let cell = |at: f64, size: f64, count: usize| ((at / size) as usize).min(count - 1);
    for k in 1..=((width + height) / HATCH) as usize {
        // The stroke runs through the points (x, offset − x) from the lower left corner, y upwards.
        let offset = k as f64 * HATCH;
        let place = |x: f64| (frame.left + x, frame.bottom - (offset - x));
        let (from, to) = ((offset - height).max(0.0), offset.min(width));
        let across = (1..columns).map(|column| column as f64 * wide);
        let up = (1..rows).map(|row| offset - row as f64 * high);
        let mut stops: Vec<f64> = across.chain(up).filter(|x| from < *x && *x < to).chain([from, to]).collect();
        stops.sort_by(f64::total_cmp);
        let is_broken = |pair: &[f64]| {
            let middle = (pair[0] + pair[1]) / 2.0;
            is_broken(cell(middle, wide, columns), cell(offset - middle, high, rows))
        };
        let parts: Vec<(&[f64], bool)> = stops.windows(2).map(|pair| (pair, is_broken(pair))).collect();
        for run in parts.chunk_by(|a, b| a.1 == b.1).filter(|run| run[0].1) {
            canvas.line(place(run[0].0[0]), place(run[run.len() - 1].0[1]), Colour::Hatch, 1.0);
        }
    }
}

/// The colour bar.
struct Bar {
    ramp: Ramp,
    label: Label,
    extent: Extent,
    ticks: Vec<Tick>,
    is_broken: bool,
}

impl Bar {
    fn new(map: &Map, height: f64) -> Self {
        let extent = Extent::new(&map.colour, map.values.iter().copied(), 0.0);
        let ticks = axes::ticks(&extent, &map.colour, 0.85 * height, Direction::Up);
        let is_broken = map.values.iter().any(|value| extent.position(*value).is_nan());
        Self { ramp: map.ramp, label: Label::new(&map.colour, 0.8 * height), extent, ticks, is_broken }
    }

    /// Width of bar, ticks and label with the distance from the frame.
    fn width(&self) -> f64 {
        APART + BAR + self.beside() + self.label.thickness()
    }

    /// Width of what stands right beside the bar.
    fn beside(&self) -> f64 {
        let sign = if self.is_broken { 6.0 + text::width(BROKEN_NAME, TEXT) - 20.0 } else { 0.0 };
        axes::tick_room(&self.ticks).max(sign)
    }

    fn draw(&self, canvas: &dyn Canvas, frame: &Frame) {
        let under = if self.is_broken { SIGN } else { 0.0 };
        let left = frame.right + APART;
        let bar =
            Frame { left, right: left + BAR, top: frame.top, bottom: (frame.bottom - under).max(frame.top + 1.0) };
        let shades = (0..256).rev().filter_map(|k| palette::ramp(self.ramp, (f64::from(k) + 0.5) / 256.0));
        canvas.image(&bar, 1, shades.collect());
        canvas.outline(&bar, Colour::Ink, 1.0);
        for tick in &self.ticks {
            axes::draw_y_tick(canvas, bar.place(1.0, tick.at), tick, 1.0);
        }
        let beside = bar.right + self.beside() + 4.0;
        self.label.draw_upwards(canvas, beside, bar.place(0.0, 0.5).1, (frame.top, frame.bottom));
        if self.is_broken {
            self.draw_sign(canvas, Frame { left, right: left + BAR, top: frame.bottom - BAR, bottom: frame.bottom });
        }
    }

    fn draw_sign(&self, canvas: &dyn Canvas, sign: Frame) {
        canvas.fill(&sign, Colour::Blank, 1.0);
        hatch(canvas, &sign, 1, 1, |_, _| true);
        canvas.outline(&sign, Colour::Ink, 1.0);
        let place: Place = (sign.right + 6.0, sign.place(0.0, 0.5).1);
        canvas.text(BROKEN_NAME, place, Anchor(Across::Left, Down::Middle), TEXT, Colour::Ink);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chapters::figure::Axis;

    #[test]
    fn the_cells_of_a_picture_are_as_high_as_wide_and_those_of_a_map_fill_the_room() {
        let map = |columns: usize, rows: usize, x: Axis| Map {
            title: String::new(),
            x,
            y: Axis::bare(0.0, 1.0),
            colour: Axis::linear("a", "").range(0.0, 1.0),
            ramp: Ramp::Sequential,
            columns,
            values: vec![0.5; columns * rows],
            marks: Vec::new(),
        };
        let room = Frame::at((10.0, 20.0), 620.0, 400.0);
        let frame = |map: &Map| {
            let Arrangement { axes, spare, .. } = arrange(map, &room, true);
            (axes.frame.width(), axes.frame.height(), spare)
        };
        let (full, high, _) = frame(&map(4, 4, Axis::linear("x", "").range(0.0, 1.0)));
        assert!(full > 1.2 * high);
        for (columns, rows, aspect) in
            [(4, 4, 1.0), (16, 9, 16.0 / 9.0), (3, 5, 0.6), (4000, 1, LONGEST), (1, 9, 1.0 / LONGEST)]
        {
            let (width, height, spare) = frame(&map(columns, rows, Axis::bare(0.0, 1.0)));
            // The frame's edges stand on whole units.
            assert!((width - height * aspect).abs() < 1.0 + aspect, "{columns} × {rows}: {width} × {height}");
            // As large as there is room for.
            assert!(spare.0.min(spare.1) == 0.0, "{columns} × {rows}: {spare:?}");
        }
    }
}
