//! Diagrams as data: the geometry of an arrangement, in a plane of its own with x to the right, y upwards and the same
//! scale both ways. Where the labels go is found when it is drawn, so that none hides anything at any setting.

use crate::figure::{Dash, Hue, Mark};

/// A place in the plane of a diagram.
pub type Spot = [f64; 2];

/// Geometry with names: rays, waves and surfaces rather than curves on axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagram {
    /// Heading of the panel; may be empty.
    pub title: String,
    /// The lower left corner of what is shown. Fixed by the author: a window that followed the parts would jump about
    /// under a slider.
    pub low: Spot,
    /// The upper right corner.
    pub high: Spot,
    /// Drawn in order, the last on top.
    pub parts: Vec<Part>,
    /// What the key explains, as the lines and points of a chart without their places; there is none if empty.
    pub key: Vec<Mark>,
}

impl Diagram {
    /// An empty window from its lower left to its upper right corner.
    pub fn new(title: impl Into<String>, low: Spot, high: Spot) -> Self {
        Self { title: title.into(), low, high, parts: Vec::new(), key: Vec::new() }
    }

    /// With one more part.
    pub fn with(mut self, part: Part) -> Self {
        self.parts.push(part);
        self
    }

    /// With more parts.
    pub fn with_all(mut self, parts: impl IntoIterator<Item = Part>) -> Self {
        self.parts.extend(parts);
        self
    }

    /// With a line in the key.
    pub fn explain(mut self, hue: Hue, dash: Dash, label: impl Into<String>) -> Self {
        self.key.push(Mark::Line { label: label.into(), hue, dash, points: Vec::new() });
        self
    }
}

/// Something in a diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// What it is and where.
    pub form: Form,
    /// Colour.
    pub hue: Hue,
    /// Stroke of its lines.
    pub dash: Dash,
    /// Written beside it, in the label markup; may be empty.
    pub label: String,
}

/// What may be in a diagram. Places that are not finite are not drawn; what lies beyond the window is cut off.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A thin straight line, such as a normal.
    Line {
        /// Start.
        from: Spot,
        /// End.
        to: Spot,
    },
    /// A bold line with arrow heads.
    Ray {
        /// Start.
        from: Spot,
        /// End.
        to: Spot,
        /// Where the tips of the heads are, as shares of the way.
        heads: Vec<f64>,
    },
    /// A short arrow with its head at the end.
    Vector {
        /// Start.
        from: Spot,
        /// Tip.
        to: Spot,
    },
    /// Thin lines across a ray: its planes of equal phase.
    Wavefronts {
        /// Start of the ray.
        from: Spot,
        /// End of the ray.
        to: Spot,
        /// Distance of the first from the start.
        first: f64,
        /// From one to the next.
        spacing: f64,
        /// How far each reaches to the left and to the right of the way.
        sides: [f64; 2],
    },
    /// A surface or an interface, seen edge on.
    Surface {
        /// Start.
        from: Spot,
        /// End.
        to: Spot,
        /// What lies behind it, to the right of the way from start to end.
        behind: Behind,
    },
    /// An angle between two directions.
    Arc {
        /// Where the directions meet.
        centre: Spot,
        /// Distance from there.
        radius: f64,
        /// First direction [rad], counter-clockwise from x.
        from: f64,
        /// Second direction [rad].
        to: f64,
    },
    /// A point.
    Point {
        /// Where.
        at: Spot,
    },
    /// A vector across the plane, out of it (⊙) or into it (⊗).
    Across {
        /// Where.
        at: Spot,
        /// Whether it points at the reader.
        is_out: bool,
    },
    /// A curve.
    Curve {
        /// Places along it.
        points: Vec<Spot>,
    },
    /// Nothing but the label.
    Note {
        /// Where it starts, if there is room.
        at: Spot,
    },
}

/// What lies behind a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Behind {
    /// Nothing to be seen.
    Nothing,
    /// What lets no light through.
    Hatched,
    /// A medium, the deeper the denser: from 0, none, to 1.
    Tinted(f64),
}

impl Part {
    /// A part in black, unbroken and without a name.
    pub fn new(form: Form) -> Self {
        Self { form, hue: Hue::Natural, dash: Dash::Solid, label: String::new() }
    }

    /// A thin straight line.
    pub fn line(from: Spot, to: Spot) -> Self {
        Self::new(Form::Line { from, to })
    }

    /// A ray with its head at the end.
    pub fn ray(from: Spot, to: Spot) -> Self {
        Self::ray_with_heads(from, to, &[1.0])
    }

    /// A ray with heads at shares of the way.
    pub fn ray_with_heads(from: Spot, to: Spot, heads: &[f64]) -> Self {
        Self::new(Form::Ray { from, to, heads: heads.to_vec() })
    }

    /// A short arrow.
    pub fn vector(from: Spot, to: Spot) -> Self {
        Self::new(Form::Vector { from, to })
    }

    /// A surface and what is behind it, to the right of its way.
    pub fn surface(from: Spot, to: Spot, behind: Behind) -> Self {
        Self::new(Form::Surface { from, to, behind })
    }

    /// The angle between two directions [rad].
    pub fn arc(centre: Spot, radius: f64, from: f64, to: f64) -> Self {
        Self::new(Form::Arc { centre, radius, from, to })
    }

    /// A point.
    pub fn point(at: Spot) -> Self {
        Self::new(Form::Point { at })
    }

    /// A vector out of the plane or into it.
    pub fn across(at: Spot, is_out: bool) -> Self {
        Self::new(Form::Across { at, is_out })
    }

    /// A curve.
    pub fn curve(points: Vec<Spot>) -> Self {
        Self::new(Form::Curve { points })
    }

    /// A label that starts at a place.
    pub fn note(at: Spot, label: impl Into<String>) -> Self {
        Self::new(Form::Note { at }).label(label)
    }

    /// In another colour.
    pub fn hue(self, hue: Hue) -> Self {
        Self { hue, ..self }
    }

    /// With another stroke.
    pub fn dash(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// With a name.
    pub fn label(self, label: impl Into<String>) -> Self {
        Self { label: label.into(), ..self }
    }
}
