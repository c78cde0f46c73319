//! Fresnel's reflectance of natural light, for every width. Between clear media it is that of [`crate::optics::fresnel`].

use super::{Rgb, rgb};
use crate::number::Number;
use crate::optics::fresnel::clear;

/// What a clear interface does to a ray.
#[derive(Clone, Copy, Debug)]
pub struct Interface<N> {
    /// R, the share reflected [1].
    pub reflectance: N,
    /// cos θ_t on the far side [1]; 0 beyond the critical angle.
    pub cos_t: N,
}

/// A clear interface of relative index `eta` = n_t/n_i > 0 at 0 ≤ `cos_i` ≤ 1.
#[inline(always)]
pub fn dielectric<N: Number>(cos_i: N, eta: N) -> Interface<N> {
    let one = N::of(1.0);
    let (reflectance, q) = clear(cos_i, eta.squared(), (eta - one) * (eta + one));
    Interface { reflectance: reflectance.min(one), cos_t: q / eta }
}

/// What reflects by an angle.
pub trait Reflecting<N: Number> {
    /// R [1] of natural light at 0 ≤ `cos_i` ≤ 1, by channel.
    fn reflectance(&self, cos_i: N) -> Rgb<N>;

    /// 2∫R μ dμ [1]: the reflectance of light from everywhere.
    fn mean_reflectance(&self) -> Rgb<N> {
        // The midpoint rule in μ², whose weight it is; R is smooth in μ, so it is of order 2 with a tiny constant.
        const NODES: usize = 256;
        let mut sum = [N::of(0.0); 3];
        for k in 0..NODES {
            let cos = N::of(((k as f64 + 0.5) / NODES as f64).sqrt());
            let here = self.reflectance(cos);
            sum = rgb(|c| sum[c] + here[c]);
        }
        rgb(|c| sum[c] * N::of(1.0 / NODES as f64))
    }
}

impl<N: Number, M: Reflecting<N>> Reflecting<N> for &M {
    #[inline(always)]
    fn reflectance(&self, cos_i: N) -> Rgb<N> {
        (*self).reflectance(cos_i)
    }
}

/// A metal: n + iκ over the index outside, in three channels.
#[derive(Clone, Copy, Debug)]
pub struct Conductor<N> {
    /// n ≥ 0 [1].
    pub n: Rgb<N>,
    /// κ ≥ 0 [1].
    pub k: Rgb<N>,
}

impl<N: Number> Reflecting<N> for Conductor<N> {
    #[inline(always)]
    fn reflectance(&self, cos_i: N) -> Rgb<N> {
        let one = N::of(1.0);
        let (cos2, sin2) = (cos_i.squared(), (one - cos_i) * (one + cos_i));
        rgb(
            #[inline(always)]
            |c| absorbing(cos_i, cos2, sin2, self.n[c], self.k[c]),
        )
    }
}

impl<N: Number> Conductor<N> {
    /// The metal that absorbs nothing, ε = −1.
    pub fn perfect() -> Self {
        Self { n: [N::of(0.0); 3], k: [N::of(1.0); 3] }
    }
}

/// R [1] by |r|² of s and p with q = a + ib: r_s = (c − q)/(c + q), and r_p/r_s = (sin²/c − q)/(sin²/c + q), so that both
/// differences are formed with the same q. Not the products of [`crate::optics::fresnel`], which give a trace of absorption
/// its digits by a detour with branches: a metal reflects so much that its differences keep theirs.
#[inline(always)]
fn absorbing<N: Number>(cos: N, cos2: N, sin2: N, n: N, k: N) -> N {
    let zero = N::of(0.0);
    let re = (n - k) * (n + k) - sin2;
    let im = N::of(2.0) * n * k;
    let modulus = (re.squared() + im.squared()).sqrt();
    // The larger part of the root directly, the smaller by their product.
    let some = N::of(f64::from(f32::MIN_POSITIVE));
    let larger = ((re.abs() + modulus) * N::of(0.5)).max(some);
    let smaller = N::of(0.25) * im.squared() / larger;
    let is_forward = re.ge(zero);
    let (a2, b2) = (N::select(is_forward, larger, smaller), N::select(is_forward, smaller, larger));
    let a = a2.sqrt();
    let (s, s_all) = ((cos - a).squared() + b2, (cos + a).squared() + b2);
    let (p, p_all) = ((sin2 - cos * a).squared() + cos2 * b2, (sin2 + cos * a).squared() + cos2 * b2);
    // ½ s(1 + p), their quotients in one.
    N::of(0.5) * s * (p + p_all).max(some + some) / (s_all * p_all.max(some))
}
