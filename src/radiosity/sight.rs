//! What comes between two faces.

use super::{Outline, Patch, Room};
use crate::geometry::{Quad, Ray};
use crate::number::Vector;
use crate::scene::Triple;
use crate::scene::triple::{largest, minus};

/// The faces, and which of them may come between two.
pub(super) struct Sight {
    faces: Vec<Patch>,
    slack: f64,
}

/// Roundings by which a corner in a plane may seem to be off it.
const SLACK: f64 = 32.0 * f64::EPSILON;

impl Sight {
    pub fn new(room: &Room) -> Self {
        let faces: Vec<Patch> = room.faces.iter().map(|face| face.patch).collect();
        let reach = faces.iter().flat_map(Patch::corners).map(largest).fold(0.0, f64::max);
        Self { faces, slack: SLACK * reach }
    }

    /// The others that may hide something of one face from another.
    pub fn others(&self, ends: [usize; 2]) -> Vec<usize> {
        let all: Vec<usize> = (0..self.faces.len()).collect();
        self.among(&all, ends, ends.map(|end| &self.faces[end]))
    }

    /// Of these the faces that may come between patches of the two, ready for rays.
    pub fn between(&self, others: &[usize], ends: [usize; 2], patches: [&Patch; 2]) -> Vec<Screen> {
        let left = self.among(others, ends, patches);
        left.into_iter().map(|at| Screen::new(&self.faces[at])).collect()
    }

    /// Of some faces those with something of both patches on either side of their plane, and of themselves before both.
    fn among(&self, others: &[usize], ends: [usize; 2], patches: [&Patch; 2]) -> Vec<usize> {
        let between = |at: &usize| {
            let face = &self.faces[*at];
            let corners = || patches.iter().flat_map(|patch| patch.corners()).map(|corner| face.before(corner));
            let is_crossed = corners().any(|off| off > self.slack) && corners().any(|off| off < -self.slack);
            let is_before = |patch: &&Patch| face.corners().iter().any(|corner| patch.before(*corner) > self.slack);
            !ends.contains(at) && is_crossed && patches.iter().all(is_before)
        };
        others.iter().copied().filter(between).collect()
    }

    /// Whether none of them is met on the way.
    pub fn is_free(between: &[Screen], from: Triple, to: Triple) -> bool {
        let ray = Ray { origin: Vector::of(from), direction: Vector::of(minus(to, from)) };
        between.iter().all(|screen| screen.met(&ray).is_none_or(|t| t >= 1.0))
    }
}

/// A face that may be in the way.
pub(super) struct Screen {
    quad: Quad<f64>,
    is_triangle: bool,
}

impl Screen {
    fn new(face: &Patch) -> Self {
        Self { quad: Quad::new(face.corner, face.edges), is_triangle: face.outline == Outline::Triangle }
    }

    /// How far a ray goes to it, if it meets it.
    fn met(&self, ray: &Ray<f64>) -> Option<f64> {
        let meeting = self.quad.meet(ray);
        // From the corner u and v run from −1.
        (meeting.is_met && !(self.is_triangle && meeting.u + meeting.v > 0.0)).then_some(meeting.t)
    }
}

/// Places in all, of both sides of all faces, to which light is followed.
const PLACES: usize = 800;

/// The places of a patch in a sequence that fills it evenly, at shares of its edges that no edge of another is likely to have (M.
/// Roberts's generalised golden ratios): on the rim of another face it would not be known on which side a place is.
fn place(patch: &Patch, number: usize) -> Triple {
    let [u, v] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3].map(|step| (number as f64 * step).fract());
    // The far half of a parallelogram is the near one, turned.
    let is_beyond = patch.outline == Outline::Triangle && u + v > 1.0;
    patch.at(if is_beyond { [1.0 - u, 1.0 - v] } else { [u, v] })
}

/// Whether light gets to the sides of the faces: to all fronts, then to all backs.
///
/// A lamp's places are lit; so are places that a lit one sees.
pub(super) fn lit(room: &Room) -> Vec<bool> {
    let fronts = room.faces.len();
    let reach = room.faces.iter().flat_map(|face| face.patch.corners()).map(largest).fold(0.0, f64::max);
    let slack = SLACK * reach;
    let screens: Vec<Screen> = room.faces.iter().map(|face| Screen::new(&face.patch)).collect();
    let sides = room.faces.iter().map(|face| face.patch).chain(room.faces.iter().map(|face| face.patch.back()));
    let each = ((PLACES as f64 / (2.0 * fronts as f64)).sqrt() as usize).clamp(3, 5);
    let places: Vec<(usize, Patch, Triple)> = sides
        .enumerate()
        .flat_map(|(side, patch)| (1..=each * each).map(move |k| (side, patch, place(&patch, k))))
        .collect();
    let is_lamp = |side: usize| room.faces.get(side).is_some_and(|face| face.emitted != [0.0; 3]);
    let mut is_lit: Vec<bool> = places.iter().map(|(side, ..)| is_lamp(*side)).collect();
    let mut waiting: Vec<usize> = (0..places.len()).filter(|at| is_lit[*at]).collect();
    while let Some(from) = waiting.pop() {
        let (side, patch, here) = &places[from];
        for (to, (other, seen, there)) in places.iter().enumerate() {
            // Places of one plane may seem to see each other by a rounding, through whatever stands on it.
            if is_lit[to] || patch.before(*there) <= slack || seen.before(*here) <= slack {
                continue;
            }
            let ends = [side % fronts, other % fronts];
            let ray = Ray { origin: Vector::of(*here), direction: Vector::of(minus(*there, *here)) };
            let mut between = screens.iter().enumerate().filter(|(at, _)| !ends.contains(at));
            if between.all(|(_, screen)| screen.met(&ray).is_none_or(|t| t >= 1.0)) {
                is_lit[to] = true;
                waiting.push(to);
            }
        }
    }
    (0..2 * fronts).map(|side| places.iter().zip(&is_lit).any(|((of, ..), lit)| *of == side && *lit)).collect()
}
