//! A hierarchy of boxes, eight to a node, for worlds of many primitives.
//!
//! One ray meets eight boxes at once, and in a leaf up to eight primitives of one kind. (I. Wald, C. Benthin &
//! S. Boulos, "Getting rid of packets", *RT '08* (2008) 49; H. Dammertz, J. Hanika & A. Keller, "Shallow bounding volume
//! hierarchies for fast SIMD ray tracing of incoherent rays", *CGF* 27 (2008) 1225.)
//!
//! Whatever primitive a ray meets at t, each box about it is entered no later than t as computed here: boxes are larger
//! than their contents by [`PAD`] roundings, and so is the ray. What comes out is therefore what trying all primitives
//! gives, bit for bit.

mod boxes;
mod build;
mod search;

#[cfg(test)]
pub(super) use build::DEEPEST;

use super::planar::Skew;
use super::{Disc, Primitive, Quad, Sphere, Triangle};
use crate::number::F32x8;
use crate::number::Width;

/// Roundings of `f32` by which a box is larger than its contents, in the largest of their coordinates, and a ray's origin
/// uncertain, in its own. What is met lies that near to the ray at that t: 20 roundings in a plane, as much again as a
/// parallelogram of 30° is spread at its corners, times √3 for the largest of three coordinates.
const PAD: f64 = 128.0;

/// The kinds of leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Triangle,
    Quad,
    /// A parallelogram so skew that its corners are uncertain by more than [`PAD`].
    Skew,
    Sphere,
    Disc,
}

const KINDS: [Kind; 5] = [Kind::Triangle, Kind::Quad, Kind::Skew, Kind::Sphere, Kind::Disc];

/// A child: a node, or a leaf of packs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Link(u32);

impl Link {
    const LEAF: u32 = 1 << 31;
    const MOST: usize = 1 << 24;

    fn node(at: usize) -> Self {
        Self(at as u32)
    }

    /// `count` packs from the `first` on.
    fn leaf(kind: Kind, first: usize, count: usize) -> Self {
        debug_assert!(first < Self::MOST && count < 16);
        Self(Self::LEAF | (kind as u32) << 28 | (count as u32) << 24 | first as u32)
    }

    #[inline(always)]
    fn is_leaf(self) -> bool {
        self.0 & Self::LEAF != 0
    }

    #[inline(always)]
    fn kind(self) -> Kind {
        KINDS[((self.0 >> 28 & 7) as usize).min(KINDS.len() - 1)]
    }

    #[inline(always)]
    fn packs(self) -> std::ops::Range<usize> {
        let first = (self.0 & 0x00ff_ffff) as usize;
        first..first + (self.0 >> 24 & 15) as usize
    }
}

/// Eight boxes and what is in them.
#[derive(Clone, Debug)]
struct Node {
    /// By axis: where the boxes begin and where they end.
    planes: [[F32x8; 2]; 3],
    children: [Link; 8],
}

/// The hierarchy over a list of primitives: `P` numbers at once in its leaves.
#[derive(Clone, Debug)]
pub(in crate::geometry) struct Bvh<P: Width> {
    nodes: Vec<Node>,
    /// Each pack with its primitives' places in the list; −1 where it is not full.
    triangles: Vec<(Triangle<P>, P)>,
    quads: Vec<(Quad<P>, P)>,
    skew: Vec<(Skew<P>, P)>,
    spheres: Vec<(Sphere<P>, P)>,
    discs: Vec<(Disc<P>, P)>,
}

impl<P: Width> Bvh<P> {
    /// What it occupies in memory [B].
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.nodes)
            + size_of_val(&*self.triangles)
            + size_of_val(&*self.quads)
            + size_of_val(&*self.skew)
            + size_of_val(&*self.spheres)
            + size_of_val(&*self.discs)
    }

    /// How many levels of nodes there are.
    #[cfg(test)]
    pub fn depth(&self) -> usize {
        let below =
            |node: &Node| node.children.iter().filter(|link| !link.is_leaf()).map(|link| link.0 as usize).collect();
        let (mut level, mut depth): (Vec<usize>, usize) = (vec![0], 0);
        while !level.is_empty() {
            level = level.iter().flat_map(|&at| -> Vec<usize> { below(&self.nodes[at]) }).collect();
            depth += 1;
        }
        depth
    }

    /// The place of every triangle: in the list, and in the packs, counted through.
    pub fn slots(&self) -> impl Iterator<Item = (usize, usize)> {
        let of_pack = |(pack, (_, places)): (usize, &(Triangle<P>, P))| {
            let places = *places;
            (0..P::LANES).map(move |lane| (places.lane(lane), pack * P::LANES + lane))
        };
        let all = self.triangles.iter().enumerate().flat_map(of_pack);
        all.filter(|(place, _)| *place >= 0.0).map(|(place, slot)| (place as usize, slot))
    }

    /// The corners of the triangle in a slot.
    #[inline(always)]
    pub fn corners(&self, slot: usize) -> [[P::Scalar; 3]; 3] {
        let (triangle, _) = &self.triangles[slot / P::LANES];
        let ([a, b, c], lane) = (&triangle.corners, slot % P::LANES);
        [one(a, lane), one(b, lane), one(c, lane)]
    }
}

/// One lane of a corner.
#[inline(always)]
fn one<P: Width>([x, y, z]: &[P; 3], lane: usize) -> [P::Scalar; 3] {
    [x.get(lane), y.get(lane), z.get(lane)]
}
