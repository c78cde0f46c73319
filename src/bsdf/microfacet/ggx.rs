//! The distribution with long tails: T. S. Trowbridge and K. P. Reitz, JOSA 65 (1975) 531; B. Walter et al., *Microfacet
//! models for refraction through rough surfaces*, EGSR 2007, who named it.

use super::{Distribution, Slopes, held, stretched2};
use crate::number::{Number, Vector, sin_cos_turns};
use std::f64::consts::{FRAC_1_PI, TAU};

/// Facets like those of an ellipsoid.
#[derive(Clone, Copy, Debug)]
pub struct Ggx<N> {
    alpha: [N; 2],
}

impl<N: Number> Distribution<N> for Ggx<N> {
    const SLOPES: Slopes = Slopes::Ggx;
    const HAS_TAIL: bool = true;

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
        // (x/α_x)² + (y/α_y)² + z² times (α_x α_y)²: one division in all.
        let both = along * across;
        let q = (m.x * across).squared() + (m.y * along).squared() + (m.z * both).squared();
        N::of(FRAC_1_PI) * both * (both / q).squared()
    }

    #[inline(always)]
    fn hidden(&self, w: Vector<N>) -> N {
        let s2 = stretched2(self.alpha, w);
        let z = w.z.abs();
        N::of(0.5) * s2 / (z + (s2 + z.squared()).sqrt())
    }

    #[inline(always)]
    fn area(&self, w: Vector<N>) -> N {
        N::of(0.5) * (w.z.abs() + self.slant(w))
    }

    /// By spherical caps: J. Dupuy and A. Benyoub, *Sampling visible GGX normals with spherical caps*, CGF 42(8) (2023).
    #[inline(always)]
    fn visible(&self, w: Vector<N>, u: [N; 2]) -> Vector<N> {
        let ball = self.on_ball(w);
        self.facet(ball, N::of(1.0) + ball.z, N::of(0.0), u)
    }

    /// The cap cut where facets reflect downwards: Y. Tokuyoshi and K. Eto, *Bounded VNDF sampling for Smith–GGX
    /// reflections*, SIGGRAPH Asia 2023.
    #[inline(always)]
    fn visible_reflecting(&self, w: Vector<N>, u: [N; 2]) -> Vector<N> {
        let ball = self.on_ball(w);
        let (kept, cut) = self.cut(w);
        self.facet(ball, N::of(1.0) + kept * ball.z, cut * ball.z, u)
    }

    #[inline(always)]
    fn reflecting_area(&self, w: Vector<N>) -> N {
        let (kept, _) = self.cut(w);
        N::of(0.5) * (kept * w.z + self.slant(w))
    }

    #[inline(always)]
    fn place(&self, w: Vector<N>, m: Vector<N>) -> [N; 2] {
        // Back onto the ball, where the facet is the half vector of w and a direction of the cap: mirror w in it.
        let [along, across] = self.alpha;
        let ball = self.on_ball(w);
        let half = Vector::new(m.x / along, m.y / across, m.z).normalised();
        let twice = N::of(2.0) * half.dot(ball);
        let (x, y) = (twice * half.x - ball.x, twice * half.y - ball.y);
        let place = N::of(1.0) - twice * half.z / (N::of(1.0) + ball.z);
        [place, N::from_lanes(|lane| y.lane(lane).atan2(x.lane(lane)) / TAU)]
    }
}

impl<N: Number> Ggx<N> {
    /// √(s² + z²) [1].
    #[inline(always)]
    fn slant(&self, w: Vector<N>) -> N {
        (stretched2(self.alpha, w) + w.z.squared()).sqrt()
    }

    /// The direction from which the ellipsoid's facets are seen as those of a ball.
    #[inline(always)]
    fn on_ball(&self, w: Vector<N>) -> Vector<N> {
        let [along, across] = self.alpha;
        Vector::new(along * w.x, across * w.y, w.z).normalised()
    }

    /// Which part k of the ball's z bounds the cap from below, and 1 − k, for w_z > 0.
    #[inline(always)]
    fn cut(&self, w: Vector<N>) -> (N, N) {
        let one = N::of(1.0);
        let [along, across] = self.alpha;
        let a2 = along.min(across).squared();
        let s2 = (one + w.sin2().sqrt()).squared();
        let z2 = w.z.squared();
        let whole = N::of(1.0) / (s2 + a2 * z2);
        ((one - a2) * s2 * whole, a2 * (z2 + s2) * whole)
    }

    /// A direction of the cap of height `height` on the ball, at height `cut` above where it could begin, and halfway
    /// between it and `ball` the facet. 1 − z and z + ball.z are formed without a difference.
    #[inline(always)]
    fn facet(&self, ball: Vector<N>, height: N, cut: N, u: [N; 2]) -> Vector<N> {
        let [along, across] = self.alpha;
        let below_top = u[0] * height;
        let sin = (below_top * (N::of(2.0) - below_top)).max(N::of(0.0)).sqrt();
        let (sin_phi, cos_phi) = sin_cos_turns(u[1]);
        let half = Vector::new(sin * cos_phi + ball.x, sin * sin_phi + ball.y, (N::of(1.0) - u[0]) * height + cut);
        Vector::new(along * half.x, across * half.y, half.z).normalised()
    }
}
