//! What one bounce loses, as a table over directions: 1 − ∫f cos θ_i dω_i of facets that absorb nothing, which a second
//! lobe gives back; and what a coat lets through.
//!
//! The coordinate decides how few nodes will do. With y the cosine of the stretched direction and r = √((1 − y)/y),
//! x = 1/(1 + r) resolves both ends: at grazing losses go with √y, along the normal with √(1 − y). Across the azimuth it is
//! cos² of the one stretched by √α, halfway between that of masking and that of Fresnel.

use super::Bsdf;
use super::fresnel::{Conductor, Reflecting};
use super::microfacet::{Beckmann, Distribution, Ggx, Joint, Slopes, stretched2};
use super::rough_conductor::RoughConductor;
use super::rough_dielectric::RoughDielectric;
use super::rules::golden;
use crate::number::{F32x8, Number, Table, Vector, vectorised};
use std::f64::consts::TAU;
use std::sync::Arc;

/// 1 − E [1] by direction, of one side of a surface: to 1e−4 for metal, 5e−4 for glass.
#[derive(Clone, Debug)]
pub struct Losses {
    alpha: [f64; 2],
    table: Table,
    azimuths: usize,
    mean: f64,
    largest: f64,
}

/// Nodes along the coordinate.
const NODES: usize = 48;
/// Nodes across the azimuth where the roughness is not the same all around.
const AZIMUTHS: usize = 17;
/// The coordinate of the first node; the cosine is about its square.
const FIRST: f64 = 1e-3;
/// Facets that a node sums over, on a golden lattice: its sums converge faster than those of a grid across the kinks where
/// light begins to go the other way.
const FACETS: usize = 10_944;
/// The same where there are azimuths to fill.
const FEWER_FACETS: usize = 4_184;

impl Losses {
    /// Of metal.
    pub fn metal(slopes: Slopes, alpha: [f64; 2]) -> Self {
        fn tabulate<D: Distribution<F32x8>>(alpha: [f64; 2]) -> Losses {
            let (facets, metal) = (D::new(alpha.map(F32x8::of)), Conductor::perfect());
            let model = RoughConductor { facets, joint: Joint::Correlated, metal };
            Losses::tabulate(alpha, 1.0, |wo, [u, v]| model.sample(wo, [u, v, F32x8::of(0.0)]).weight[0])
        }
        match slopes {
            Slopes::Ggx => tabulate::<Ggx<F32x8>>(alpha),
            Slopes::Beckmann => tabulate::<Beckmann<F32x8>>(alpha),
        }
    }

    /// Of glass, seen from outside and from inside.
    pub fn glass(slopes: Slopes, alpha: [f64; 2], index: f64) -> [Self; 2] {
        fn tabulate<D: Distribution<F32x8>>(alpha: [f64; 2], index: f64) -> [Losses; 2] {
            let model = RoughDielectric::new(D::new(alpha.map(F32x8::of)), Joint::Correlated, F32x8::of(index));
            [1.0, -1.0].map(|side| Losses::tabulate(alpha, side, |wo, u| model.energy(wo, u)))
        }
        match slopes {
            Slopes::Ggx => tabulate::<Ggx<F32x8>>(alpha, index),
            Slopes::Beckmann => tabulate::<Beckmann<F32x8>>(alpha, index),
        }
    }

    /// 1 − E/R of a clear coat: of what it returns, over what it would if polished.
    pub fn coat(slopes: Slopes, alpha: [f64; 2], index: f64) -> Self {
        fn tabulate<D: Distribution<F32x8>>(alpha: [f64; 2], index: f64) -> Losses {
            let metal = Conductor { n: [F32x8::of(index); 3], k: [F32x8::of(0.0); 3] };
            let model = RoughConductor { facets: D::new(alpha.map(F32x8::of)), joint: Joint::Correlated, metal };
            let least = F32x8::of(f64::from(f32::MIN_POSITIVE));
            Losses::tabulate(alpha, 1.0, |wo, [u, v]| {
                let [polished, ..] = metal.reflectance(wo.z);
                let [returned, ..] = model.sample(wo, [u, v, F32x8::of(0.0)]).weight;
                (returned + least) / (polished + least)
            })
        }
        match slopes {
            Slopes::Ggx => tabulate::<Ggx<F32x8>>(alpha, index),
            Slopes::Beckmann => tabulate::<Beckmann<F32x8>>(alpha, index),
        }
    }

    /// 1 less the mean `energy` [1] that a facet sends on, seen from the given side, +1 or −1.
    fn tabulate(alpha: [f64; 2], side: f64, energy: impl Fn(Vector<F32x8>, [F32x8; 2]) -> F32x8) -> Self {
        let azimuths = if alpha[0] == alpha[1] { 1 } else { AZIMUTHS };
        let facets = if azimuths == 1 { FACETS } else { FEWER_FACETS };
        let lattice: Vec<[F32x8; 2]> = (0..facets / 8)
            .map(|k| {
                let part = |axis: usize| F32x8::from_lanes(|lane| golden(8 * k + lane, facets)[axis]);
                [part(0), part(1)]
            })
            .collect();
        let loss = |node: usize| {
            let (row, column) = (node / NODES, node % NODES);
            let x = (column as f64 / (NODES - 1) as f64).max(FIRST);
            let cos2 = if azimuths == 1 { 1.0 } else { row as f64 / (AZIMUTHS - 1) as f64 };
            let [along, across, z] = direction(alpha, x, cos2);
            let wo = Vector::of([along, across, side * z]);
            let sum = vectorised(
                #[inline(always)]
                || lattice.iter().fold(F32x8::of(0.0), |sum, u| sum + energy(wo, *u)),
            );
            1.0 - (0..8).map(|lane| sum.lane(lane)).sum::<f64>() / facets as f64
        };
        let table: Arc<[f64]> = (0..azimuths * NODES).map(loss).collect();
        let largest = table.iter().copied().fold(0.0, f64::max);
        let mut losses = Self { alpha, table: Table::new(table), azimuths, mean: 0.0, largest };
        losses.mean = losses.average();
        losses
    }

    /// 2∫(1 − E) μ dμ over what the table gives, not over what it stands for: so the second lobe gives back all.
    fn average(&self) -> f64 {
        const STEPS: usize = 2000;
        let turns = if self.azimuths == 1 { 1 } else { 32 };
        let around = |k: usize| {
            let (sin, cos) = (TAU * 0.25 * (k as f64 + 0.5) / turns as f64).sin_cos();
            let alpha = (self.alpha[0] * cos).hypot(self.alpha[1] * sin);
            let along = |x: f64| direction([alpha; 2], x.max(1e-9), 1.0);
            let step = |k: usize| {
                let [from, at, to] = [0.0, 0.5, 1.0].map(|part| along((k as f64 + part) / STEPS as f64));
                (to[2] - from[2]) * (to[2] + from[2]) * self.at(Vector::new(at[0] * cos, at[0] * sin, at[2])).max(0.0)
            };
            (0..STEPS).map(step).sum::<f64>()
        };
        (0..turns).map(around).sum::<f64>() / turns as f64
    }

    /// 2∫(1 − E) μ dμ [1].
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The largest loss [1] in the table.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// 1 − E [1] of light that goes to `w`, on either side of the surface.
    #[inline(always)]
    pub fn at<N: Number>(&self, w: Vector<N>) -> N {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let alpha = [N::of(self.alpha[0]), N::of(self.alpha[1])];
        let (s2, z) = (stretched2(alpha, w), w.z.abs());
        let near = (z * ((s2 + z.squared()).sqrt() + z)).sqrt();
        let near = Neighbours::of(near / (near + s2.sqrt()) * N::of((NODES - 1) as f64), NODES);
        if self.azimuths == 1 {
            near.mean(&self.table, zero)
        } else {
            let some = N::of(f64::from(f32::MIN_POSITIVE));
            let (along, across) = (alpha[0] * w.x.squared(), alpha[1] * w.y.squared());
            let at = along / (along + across).max(some) * N::of((AZIMUTHS - 1) as f64);
            let below = (at - N::of(0.5)).round().max(zero).min(N::of((AZIMUTHS - 2) as f64));
            let part = at - below;
            let row = |number: N| near.mean(&self.table, number * N::of(NODES as f64));
            row(below) * (one - part) + row(below + one) * part
        }
    }
}

/// Four neighbours on a line of nodes, and what each counts at a place between them (Lagrange).
#[derive(Clone, Copy)]
pub(super) struct Neighbours<N> {
    first: N,
    weights: [N; 4],
}

impl<N: Number> Neighbours<N> {
    /// Of a place 0 ≤ x ≤ `nodes` − 1, nodes being 1 apart.
    #[inline(always)]
    pub fn of(x: N, nodes: usize) -> Self {
        let first = (x - N::of(1.5)).round().max(N::of(0.0)).min(N::of((nodes - 4) as f64));
        Self { first, weights: lagrange(x - first) }
    }

    /// The weighted mean of a table's numbers on the line that begins at `start`.
    #[inline(always)]
    pub fn mean(&self, table: &Table, start: N) -> N {
        let (weights, nodes) = (self.weights, (start + self.first).look_up_four(table));
        weights[0] * nodes[0] + weights[1] * nodes[1] + weights[2] * nodes[2] + weights[3] * nodes[3]
    }
}

/// The direction of a coordinate and of cos² of the azimuth.
fn direction(alpha: [f64; 2], x: f64, cos2: f64) -> [f64; 3] {
    let r2 = ((1.0 - x) / x).powi(2);
    // tan² = 1/y² − 1 = r²(2 + r²), and back from the stretch.
    let tan = (r2 * (2.0 + r2)).sqrt();
    // Stretched by √α, cos² and sin² are shares of what is α times as much when stretched by α.
    let (cos2, sin2) = (cos2 * alpha[0], (1.0 - cos2).max(0.0) * alpha[1]);
    let whole = cos2 + sin2;
    let [along, across] = [tan * (cos2 / whole).sqrt() / alpha[0], tan * (sin2 / whole).sqrt() / alpha[1]];
    let length = along.hypot(across).hypot(1.0);
    [along / length, across / length, 1.0 / length]
}

/// The weights of four neighbours at 0, 1, 2, 3 (Lagrange).
#[inline(always)]
fn lagrange<N: Number>(x: N) -> [N; 4] {
    let (a, b, c, d) = (x, x - N::of(1.0), x - N::of(2.0), x - N::of(3.0));
    let (sixth, half) = (N::of(1.0 / 6.0), N::of(0.5));
    [-(b * c * d * sixth), a * c * d * half, -(a * b * d * half), a * b * c * sixth]
}
