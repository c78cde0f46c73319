//! Gaussian slopes: P. Beckmann and A. Spizzichino, *The Scattering of Electromagnetic Waves from Rough Surfaces* (1963).

use super::{Distribution, Slopes, held, stretched2};
use crate::number::{Number, Vector, erfcx, exp, ln};
use std::f64::consts::PI;

/// Facets of a surface of Gaussian heights.
#[derive(Clone, Copy, Debug)]
pub struct Beckmann<N> {
    alpha: [N; 2],
}

/// Facets steeper than this [1] are as good as none, e^(−10¹²); and their cos⁴ would leave the range of `f32`.
const LEAST_HEIGHT: f64 = 1e-6;

impl<N: Number> Distribution<N> for Beckmann<N> {
    const SLOPES: Slopes = Slopes::Beckmann;
    const HAS_TAIL: bool = false;

    #[inline(always)]
    fn new(alpha: [N; 2]) -> Self {
        Self { alpha: held(alpha) }
    }

    #[inline(always)]
    fn alpha(&self) -> [N; 2] {
        self.alpha
    }

    #[inline(always)]
    fn density(&self, m: Vector<N>) -> N {
        let [along, across] = self.alpha;
        let z = m.z.abs().max(N::of(LEAST_HEIGHT));
        let steep = ((m.x / along).squared() + (m.y / across).squared()) / z.squared();
        exp(-steep) / (N::of(PI) * along * across * z.squared().squared())
    }

    /// With x = z/s: h = s e^(−x²)(1 − √π x erfcx x)/(2√π), whose bracket keeps its digits.
    #[inline(always)]
    fn hidden(&self, w: Vector<N>) -> N {
        let s2 = stretched2(self.alpha, w);
        let (s, z) = (s2.sqrt(), w.z.abs());
        // Where x² passes 88 nothing is hidden that `f32` could tell from nothing; there the quotient may be anything.
        let is_seen = z.squared().lt(N::of(700.0) * s2);
        let s2 = N::select(is_seen, s2, N::of(1.0));
        let gauss = exp(-(z.squared() / s2)) * erfcx(z, s).rest;
        (N::of(0.5 / PI.sqrt()) * s * gauss).only(is_seen)
    }

    /// In slopes along and across the view (E. Heitz and E. d'Eon, *Importance sampling microfacet-based BSDFs using the
    /// distribution of visible normals*, CGF 33(4) (2014), supplement): the one across is Gaussian, the one along has the
    /// density (z − s p)e^(−p²) for p < z/s, whose integral is inverted by Newton's steps.
    #[inline(always)]
    fn visible(&self, w: Vector<N>, u: [N; 2]) -> Vector<N> {
        let [along, across] = self.alpha;
        let view = View::new(self.alpha, w);
        let p = view.invert(u[0]);
        let q = gaussian(u[1]);
        // Turned back from the view's azimuth, and unstretched.
        let (x, y) = (p * view.cos - q * view.sin, p * view.sin + q * view.cos);
        Vector::new(-(along * x), -(across * y), N::of(1.0)).normalised()
    }

    #[inline(always)]
    fn place(&self, w: Vector<N>, m: Vector<N>) -> [N; 2] {
        let [along, across] = self.alpha;
        let view = View::new(self.alpha, w);
        let (x, y) = (-(m.x / (along * m.z)), -(m.y / (across * m.z)));
        let (p, q) = (x * view.cos + y * view.sin, y * view.cos - x * view.sin);
        [view.share(p), below(q)]
    }
}

/// Slopes beyond ±6 [1] are a share of 10⁻¹⁷.
const STEEPEST: f64 = 6.0;

/// A direction as the stretched slopes see it.
struct View<N> {
    /// Of its azimuth.
    sin: N,
    cos: N,
    /// Its height and stretched sine, over their length.
    z: N,
    s: N,
    /// The steepest slope seen, z/s, or [`STEEPEST`].
    edge: N,
}

impl<N: Number> View<N> {
    #[inline(always)]
    fn new(alpha: [N; 2], w: Vector<N>) -> Self {
        let s2 = stretched2(alpha, w);
        let length = N::of(1.0) / (s2 + w.z.squared()).sqrt();
        let s = s2.sqrt();
        // Along the normal any azimuth will do.
        let is_turned = s.gt(N::of(1e-18));
        let over = N::of(1.0) / N::select(is_turned, s, N::of(1.0));
        let cos = N::select(is_turned, alpha[0] * w.x * over, N::of(1.0));
        let steepest = N::of(STEEPEST);
        let is_edged = w.z.lt(steepest * s);
        let edge = N::select(is_edged, w.z * over, steepest).max(-steepest);
        Self { sin: (alpha[1] * w.y * over).only(is_turned), cos, z: w.z * length, s: s * length, edge }
    }

    /// ∫(z − s p′)e^(−p′²)dp′ up to p ≤ the edge, times 2: √π z erfc(−p) + s e^(−p²), below 0 without a difference. And
    /// the same from p ≥ 0 on, without bound: of the share far out the digits would be lost in a difference from all.
    #[inline(always)]
    fn areas(&self, p: N) -> [N; 2] {
        let gauss = exp(-p.squared());
        let tail = erfcx(p.abs(), N::of(1.0));
        let root_pi = N::of(PI.sqrt());
        let (bent, faced) = (self.s * tail.rest, root_pi * self.facing(p) * tail.scaled);
        let over = root_pi * self.z * (N::of(2.0) - tail.scaled * gauss) + self.s * gauss;
        [N::select(p.gt(N::of(0.0)), over, (bent + faced) * gauss), (faced - bent) * gauss]
    }

    /// z − s p: how much of a slope is seen.
    #[inline(always)]
    fn facing(&self, p: N) -> N {
        (self.z - self.s * p).max(N::of(0.0))
    }

    #[inline(always)]
    fn share(&self, p: N) -> N {
        self.areas(p)[0] / self.areas(self.edge)[0]
    }

    /// The p below which a share u lies, from the end to which it is nearer. Both logarithms are concave, so Newton's
    /// steps from a bound on the far side of the root never pass it.
    #[inline(always)]
    fn invert(&self, u: N) -> N {
        let (zero, one) = (N::of(0.0), N::of(1.0));
        let some = N::of(f64::from(f32::MIN_POSITIVE));
        let least = N::of(1e-16);
        let [total, beyond] = self.areas(self.edge);
        let total = total.max(some);
        let is_low = u.lt(N::of(0.5));
        let wanted = total * N::select(is_low, u, one - u).max(least);
        // By erfcx ≤ 1 the area below p ≤ 0 is at most (√π z + s)e^(−p²) and that above p ≥ 0 at most √π z e^(−p²); and
        // near the edge at most s(edge − p)² times the largest e^(−p²).
        let root_pi_z = N::of(PI.sqrt()) * self.z.max(zero);
        let low = -gaussian_root((root_pi_z + self.s) / wanted);
        let largest = self.s.max(least) * exp(-self.edge.min(zero).squared());
        let at_edge = self.edge - (wanted / largest).sqrt();
        let is_far = self.edge.ge(N::of(STEEPEST));
        let from_above = N::select(is_far, self.edge, at_edge);
        let high = N::select(self.z.gt(zero), from_above.min(gaussian_root(root_pi_z / wanted)), from_above);
        let start = N::select(is_low, low, high);
        let mut p = start;
        for _ in 0..if N::EPSILON > 1e-10 { 4 } else { 7 } {
            let [below, above] = self.areas(p);
            let above = N::select(p.gt(zero), above - beyond, total - below);
            let here = N::select(is_low, below, above).max(some);
            let slope = N::of(2.0) * self.facing(p) * exp(-p.squared());
            let step = ln(here / wanted) * here / slope.max(some);
            p = N::select(is_low, (p - step).max(start).min(self.edge), (p + step).min(start));
            p = p.max(N::of(-STEEPEST));
        }
        p
    }
}

/// √ln x, or 0 below 1: where e^(−p²) has fallen to 1/x.
#[inline(always)]
fn gaussian_root<N: Number>(x: N) -> N {
    ln(x.max(N::of(1.0))).sqrt()
}

/// The share [1] of e^(−q²)/√π below q.
#[inline(always)]
fn below<N: Number>(q: N) -> N {
    let tail = N::of(0.5) * erfcx(q.abs(), N::of(1.0)).scaled * exp(-q.squared());
    N::select(q.gt(N::of(0.0)), N::of(1.0) - tail, tail)
}

/// The q of which a share u lies below: the same inversion, of a view from above.
#[inline(always)]
fn gaussian<N: Number>(u: N) -> N {
    let (zero, one) = (N::of(0.0), N::of(1.0));
    View { sin: zero, cos: one, z: one, s: zero, edge: N::of(STEEPEST) }.invert(u)
}
