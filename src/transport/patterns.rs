//! Reflectances that change from place to place, as paths ask for them.

use crate::bsdf::{Rgb, rgb};
use crate::geometry::{Chart, Flat, charts};
use crate::number::{Mask, Vector, Width};
use crate::scene::{Pattern, Scene, Shape};

/// The patterns of a scene, by shape.
#[derive(Clone, Debug)]
pub(super) struct Patterns {
    shapes: Vec<Option<Painted>>,
}

#[derive(Clone, Debug)]
struct Painted {
    pattern: Pattern,
    /// The first of its primitives.
    start: usize,
    charts: Vec<Chart>,
}

impl Patterns {
    /// Of a scene without a flaw; None if nothing in it has a pattern.
    pub fn new(scene: &Scene, flat: &Flat) -> Option<Self> {
        let painted = |(at, shape): (usize, &Shape)| {
            let pattern = scene.material(&shape.material)?.pattern()?.clone();
            Some(Painted { pattern, start: flat.owners.start(at), charts: charts(shape)? })
        };
        let shapes: Vec<_> = scene.shapes.iter().enumerate().map(painted).collect();
        shapes.iter().any(Option::is_some).then_some(Self { shapes })
    }

    /// ρ [1] of what lanes have met, by shape, primitive, u, v and outward normal, where the mask is true and it has a pattern;
    /// elsewhere what it is without.
    #[inline(never)]
    pub fn painted<N: Width>(
        &self,
        met: N::Mask,
        [shape, primitive, u, v]: [N; 4],
        normal: Vector<N>,
        plain: Rgb<N>,
    ) -> Rgb<N> {
        let rows = N::columns(|lane| {
            let painted = if met.lane(lane) { self.shapes[shape.place(lane)].as_ref() } else { None };
            let Some(painted) = painted else { return [plain[0].get(lane), plain[1].get(lane), plain[2].get(lane)] };
            let chart = &painted.charts[primitive.place(lane) - painted.start];
            let place = chart.place([u.lane(lane), v.lane(lane)], normal.lane(lane));
            painted.pattern.at(place).map(|rho| N::of(rho).get(0))
        });
        rgb(|c| rows[c])
    }
}
