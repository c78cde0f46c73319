//! How the hierarchy is made: from the top, each time at the plane that promises the least work (binned surface area
//! heuristic, I. Wald, "On fast construction of SAH-based bounding volume hierarchies", *RT '07* (2007) 33).

use super::{Bvh, Disc, Kind, Link, Node, PAD, Primitive, Quad, Sphere, Triangle};
use crate::geometry::Bounds;
use crate::geometry::planar::{Skew, is_skew};
use crate::number::Width;
use crate::number::{Eight, Number};

/// Planes tried along each axis, and one more.
const BINS: usize = 16;

/// Levels of nodes below which ranges are halved: what keeps pathological scenes from growing a list.
const MOST_LEVELS: usize = 14;

/// The most levels there are: 8 more for 2²⁴ = 8⁸ items by eighths, one for uneven ones, one for the kinds in a leaf.
pub(in crate::geometry) const DEEPEST: usize = MOST_LEVELS + 10;

/// The most that a search may have to come back to: all but one child of a node on each level.
pub(super) const MOST_WAITING: usize = 7 * DEEPEST + 1;

/// A box of `f32`.
#[derive(Clone, Copy, Debug)]
struct Box32 {
    low: [f32; 3],
    high: [f32; 3],
}

impl Box32 {
    const NOTHING: Self = Self { low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] };

    /// Larger than what it holds by the roundings of a search.
    fn around(bounds: &Bounds) -> Self {
        let pad = PAD * f64::from(f32::EPSILON) * bounds.reach() + f64::from(f32::MIN_POSITIVE);
        Self { low: bounds.low.map(|low| (low - pad) as f32), high: bounds.high.map(|high| (high + pad) as f32) }
    }

    #[inline(always)]
    fn grow(&mut self, other: &Self) {
        for axis in 0..3 {
            self.low[axis] = if other.low[axis] < self.low[axis] { other.low[axis] } else { self.low[axis] };
            self.high[axis] = if other.high[axis] > self.high[axis] { other.high[axis] } else { self.high[axis] };
        }
    }

    /// Half of its area; 0 of nothing.
    #[inline(always)]
    fn area(&self) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|axis| (self.high[axis] - self.low[axis]).max(0.0));
        x * y + y * z + z * x
    }
}

/// A primitive while it is sorted.
#[derive(Clone, Copy, Debug)]
struct Item {
    bounds: Box32,
    at: u32,
    kind: Kind,
}

impl Item {
    /// Twice its middle.
    #[inline(always)]
    fn middle(&self, axis: usize) -> f32 {
        self.bounds.low[axis] + self.bounds.high[axis]
    }
}

/// Some neighbouring items.
#[derive(Clone, Copy, Debug)]
struct Range {
    from: usize,
    to: usize,
    bounds: Box32,
}

impl Range {
    fn new(items: &[Item], from: usize, to: usize) -> Self {
        let mut bounds = Box32::NOTHING;
        for item in &items[from..to] {
            bounds.grow(&item.bounds);
        }
        Self { from, to, bounds }
    }

    fn len(&self) -> usize {
        self.to - self.from
    }
}

impl<P: Width> Bvh<P> {
    /// The most primitives in a leaf.
    const LEAF: usize = if P::LANES > 1 { P::LANES } else { 4 };

    /// Over those primitives whose place `is_kept`.
    pub fn new(primitives: &[Primitive], is_kept: impl Fn(usize) -> bool) -> Self {
        let mut bvh = Self {
            nodes: Vec::new(),
            triangles: Vec::new(),
            quads: Vec::new(),
            skew: Vec::new(),
            spheres: Vec::new(),
            discs: Vec::new(),
        };
        let item = |(at, primitive): (usize, &Primitive)| Item {
            bounds: Box32::around(&primitive.bounds()),
            at: at as u32,
            kind: match *primitive {
                Primitive::Triangle { .. } => Kind::Triangle,
                Primitive::Quad { edges, .. } if is_skew::<P>(edges) => Kind::Skew,
                Primitive::Quad { .. } => Kind::Quad,
                Primitive::Sphere { .. } => Kind::Sphere,
                Primitive::Disc { .. } => Kind::Disc,
            },
        };
        let mut items: Vec<Item> = primitives.iter().enumerate().filter(|(at, _)| is_kept(*at)).map(item).collect();
        let all = Range::new(&items, 0, items.len());
        bvh.node(primitives, &mut items, all, 0);
        bvh
    }

    /// Adds the node of a range, and all below it.
    fn node(&mut self, primitives: &[Primitive], items: &mut [Item], range: Range, level: usize) -> Link {
        let mut ranges = [range; 8];
        let mut count = usize::from(range.len() > 0);
        let in_halves = level >= MOST_LEVELS;
        // The largest that is not yet a leaf is divided until there are eight.
        while count < 8 {
            let open = (0..count).filter(|&at| !is_leaf::<P>(items, &ranges[at]));
            let size = |&at: &usize| if in_halves { ranges[at].len() as f32 } else { ranges[at].bounds.area() };
            let Some(at) = open.max_by(|one, other| size(one).total_cmp(&size(other))) else {
                break;
            };
            let middle = divide::<P>(items, &ranges[at], in_halves);
            let Range { from, to, .. } = ranges[at];
            ranges[at] = Range::new(items, from, middle);
            ranges[count] = Range::new(items, middle, to);
            count += 1;
        }
        let at = self.nodes.len();
        let plane = |high: bool, axis: usize| {
            let bounds = |child: usize| if child < count { ranges[child].bounds } else { Box32::NOTHING };
            Eight(std::array::from_fn(|child| if high { bounds(child).high[axis] } else { bounds(child).low[axis] }))
        };
        let planes = std::array::from_fn(|axis| [plane(false, axis), plane(true, axis)]);
        self.nodes.push(Node { planes, children: [Link::leaf(Kind::Triangle, 0, 0); 8] });
        for (child, range) in ranges.into_iter().enumerate().take(count) {
            let link = if is_leaf::<P>(items, &range) {
                self.leaf(primitives, &items[range.from..range.to])
            } else {
                self.node(primitives, items, range, level + 1)
            };
            self.nodes[at].children[child] = link;
        }
        Link::node(at)
    }

    /// Adds the packs of a leaf.
    fn leaf(&mut self, primitives: &[Primitive], items: &[Item]) -> Link {
        let kind = items[0].kind;
        let mut link = None;
        let mut add = |first: usize| {
            link = link.or(Some(first));
        };
        for pack in items.chunks(P::LANES) {
            let place = |lane: usize| pack.get(lane).map_or(-1.0, |item| f64::from(item.at));
            let places = P::each(|lane| P::Scalar::of(place(lane)));
            let primitive = |lane: usize| pack.get(lane).map(|item| primitives[item.at as usize]);
            macro_rules! push {
                ($list:ident, $type:ident, $pattern:pat => $value:expr, $nothing:expr) => {{
                    add(self.$list.len());
                    let packed = $type::packed(|lane| match primitive(lane) {
                        Some($pattern) => $value,
                        _ => $nothing,
                    });
                    self.$list.push((packed, places));
                }};
            }
            let (null, nan) = ([0.0; 3], f64::NAN);
            match kind {
                Kind::Triangle => {
                    push!(triangles, Triangle, Primitive::Triangle { corners, .. } => Triangle::new(corners), Triangle::new([[nan; 3]; 3]))
                }
                Kind::Quad => {
                    push!(quads, Quad, Primitive::Quad { corner, edges } => Quad::new(corner, edges), Quad::new(null, [null; 2]))
                }
                Kind::Skew => {
                    push!(skew, Skew, Primitive::Quad { corner, edges } => Skew::new(corner, edges), Skew::new(null, [null; 2]))
                }
                Kind::Sphere => {
                    push!(spheres, Sphere, Primitive::Sphere { center, radius } => Sphere::new(center, radius), Sphere::new(null, nan))
                }
                Kind::Disc => {
                    push!(discs, Disc, Primitive::Disc { center, normal, radius } => Disc::new(center, normal, radius), Disc::new(null, null, 0.0))
                }
            }
        }
        Link::leaf(kind, link.unwrap_or(0), items.len().div_ceil(P::LANES))
    }
}

/// Whether a range is small enough, and of one kind.
fn is_leaf<P: Width>(items: &[Item], range: &Range) -> bool {
    let items = &items[range.from..range.to];
    items.len() <= Bvh::<P>::LEAF && items.iter().all(|item| item.kind == items[0].kind)
}

/// Sorts a range into two that are not empty, and says where the second begins.
fn divide<P: Width>(items: &mut [Item], range: &Range, in_halves: bool) -> usize {
    let Range { from, to, .. } = *range;
    let half = from + range.len() / 2;
    let items = &mut items[from..to];
    if items.len() <= Bvh::<P>::LEAF {
        let kind = items[0].kind;
        return from + partition(items, |item| item.kind == kind);
    }
    if in_halves {
        return half;
    }
    match best::<P>(items) {
        Some((axis, grid, bin)) => from + partition(items, |item| grid.bin(item.middle(axis)) <= bin),
        None => half,
    }
}

/// Moves those first that are `chosen`, and counts them.
fn partition(items: &mut [Item], chosen: impl Fn(&Item) -> bool) -> usize {
    let mut count = 0;
    for at in 0..items.len() {
        if chosen(&items[at]) {
            items.swap(at, count);
            count += 1;
        }
    }
    count
}

/// Equal bins along an axis.
#[derive(Clone, Copy, Debug)]
struct Grid {
    low: f32,
    scale: f32,
}

impl Grid {
    #[inline(always)]
    fn bin(&self, middle: f32) -> usize {
        // `as` takes what is not a number for 0.
        (((middle - self.low) * self.scale) as usize).min(BINS - 1)
    }
}

/// The axis, its bins, and the last bin of the first part, where dividing costs least; None if all middles are one.
fn best<P: Width>(items: &[Item]) -> Option<(usize, Grid, usize)> {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for item in items {
        for axis in 0..3 {
            let middle = item.middle(axis);
            low[axis] = low[axis].min(middle);
            high[axis] = high[axis].max(middle);
        }
    }
    let grids: [Grid; 3] =
        std::array::from_fn(|axis| Grid { low: low[axis], scale: BINS as f32 / (high[axis] - low[axis]) });
    let mut bins = [[(Box32::NOTHING, 0_usize); BINS]; 3];
    for item in items {
        for axis in 0..3 {
            let (bounds, count) = &mut bins[axis][grids[axis].bin(item.middle(axis))];
            bounds.grow(&item.bounds);
            *count += 1;
        }
    }
    let mut least = (f32::INFINITY, None);
    for axis in 0..3 {
        if !(high[axis] > low[axis] && grids[axis].scale.is_finite()) {
            continue;
        }
        // What each part costs: its area times the packs that hold it.
        let cost = |bounds: &Box32, count: usize| bounds.area() * count.div_ceil(Bvh::<P>::LEAF) as f32;
        let mut behind = [0.0; BINS];
        let (mut bounds, mut count) = (Box32::NOTHING, 0);
        for bin in (1..BINS).rev() {
            bounds.grow(&bins[axis][bin].0);
            count += bins[axis][bin].1;
            behind[bin - 1] = if count > 0 { cost(&bounds, count) } else { f32::INFINITY };
        }
        (bounds, count) = (Box32::NOTHING, 0);
        for bin in 0..BINS - 1 {
            bounds.grow(&bins[axis][bin].0);
            count += bins[axis][bin].1;
            let sum = cost(&bounds, count) + behind[bin];
            if count > 0 && sum < least.0 {
                least = (sum, Some((axis, grids[axis], bin)));
            }
        }
    }
    least.1
}
