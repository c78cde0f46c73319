//! Diagrams: geometry at one scale both ways, with labels where nothing else is.

mod labels;
mod shapes;
#[cfg(all(test, feature = "png", feature = "plotters"))]
mod tests;

use super::canvas::{Across, Anchor, Canvas, Down, Frame, Place};
use super::chart;
use super::key::Key;
use super::marks::Plane;
use super::palette::Colour;
use super::{TEXT, text};
use chapters::diagram::{Diagram, Spot};
use chapters::figure::Axis;
use labels::Placed;
use shapes::Shape;

/// How much higher than the usual a panel may become for a tall window.
const TALLEST: f64 = 1.4;
/// Width of the line from a label to what it names, where that is not right beside it.
const LEADER: f64 = 0.9;

/// Where everything goes.
pub struct Arrangement<'a> {
    /// The window.
    pub frame: Frame,
    shapes: Vec<Shape>,
    labels: Vec<Placed<'a>>,
    key: Option<(Key<'a>, Place)>,
}

/// Fits the window into `room`, over the key.
pub fn arrange<'a>(diagram: &'a Diagram, room: &Frame) -> Arrangement<'a> {
    let key = key(diagram, room);
    let below = key.as_ref().map_or(0.0, |key| key.size().1);
    let (wide, high) = extents(diagram);
    let scale = (room.width() / wide).min((room.height() - below).max(1.0) / high);
    let left = (room.left + room.right - scale * wide) / 2.0;
    let sight = Sight::new(diagram, Frame::at((left, room.top), scale * wide, scale * high));
    let forms: Vec<Vec<Shape>> = diagram.parts.iter().map(|part| shapes::of(&sight, part)).collect();
    let labels = labels::place(&sight, &diagram.parts, &forms);
    let key = key.map(|key| {
        let place = chart::outside_place(&key, &sight.frame, room, 0.0);
        (key, place)
    });
    Arrangement { frame: sight.frame, shapes: forms.into_iter().flatten().collect(), labels, key }
}

/// The height a diagram takes at a width, the key included.
pub fn height(diagram: &Diagram, usual: (f64, f64)) -> f64 {
    let (wide, high) = extents(diagram);
    let key = key(diagram, &Frame::at((0.0, 0.0), usual.0, usual.1));
    (usual.0 * high / wide).min(TALLEST * usual.1).ceil() + key.map_or(0.0, |key| key.size().1)
}

/// Draws a diagram as arranged.
pub fn draw(canvas: &dyn Canvas, Arrangement { shapes, labels, key, .. }: &Arrangement) {
    shapes.iter().for_each(|shape| shape.draw(canvas));
    for Placed { label, colour, place, leader } in labels {
        if let Some((from, to)) = leader {
            canvas.line(*from, *to, Colour::Aid, LEADER);
        }
        let baseline = (place.left, place.bottom - text::DESCENT * TEXT);
        canvas.text(label, baseline, Anchor(Across::Left, Down::Bottom), TEXT, *colour);
    }
    if let Some((key, place)) = key {
        key.draw(canvas, *place);
    }
}

fn key<'a>(diagram: &'a Diagram, room: &Frame) -> Option<Key<'a>> {
    Some(Key::new(&diagram.key)).filter(|key| !key.is_empty()).map(|key| key.below(room))
}

/// Width and height of the window; those of a unit square if it has none.
fn extents(diagram: &Diagram) -> (f64, f64) {
    let (wide, high) = (diagram.high[0] - diagram.low[0], diagram.high[1] - diagram.low[1]);
    let has_size = wide > 0.0 && high > 0.0 && (1e-3..1e3).contains(&(high / wide)) && wide.is_finite();
    if has_size { (wide, high) } else { (1.0, 1.0) }
}

/// How the window lies on the sheet.
struct Sight {
    frame: Frame,
    plane: Plane,
    /// Pixels to a unit of the diagram.
    scale: f64,
}

impl Sight {
    fn new(diagram: &Diagram, frame: Frame) -> Self {
        let axis = |k: usize| Axis::bare(diagram.low[k], diagram.high[k]);
        let plane = chart::plane(&axis(0), &axis(1), &[]);
        Self { frame, plane, scale: frame.width() / extents(diagram).0 }
    }

    /// The place of a spot; NaN where it cannot be shown.
    fn place(&self, [x, y]: Spot) -> Place {
        self.frame.place(self.plane.x.fraction(x), self.plane.y.fraction(y))
    }

    /// The line through spots, cut off at the window.
    fn lines(&self, spots: &[Spot]) -> Vec<Vec<Place>> {
        let pieces = self.plane.pieces(spots);
        pieces.into_iter().map(|piece| piece.into_iter().map(|(x, y)| self.frame.place(x, y)).collect()).collect()
    }

    /// Whether a place is within the window.
    fn shows(&self, (x, y): Place) -> bool {
        let frame = self.frame.grown(0.5);
        (frame.left..=frame.right).contains(&x) && (frame.top..=frame.bottom).contains(&y)
    }
}
