//! Rough surfaces of facets: how their slopes are distributed, which of them are seen, and how to draw one of those.
//!
//! With the stretched sine s = √((α_x x)² + (α_y y)²) of a direction, each distribution gives D of a facet and the hidden
//! area h = zΛ of a direction (B. Smith 1967); everything else follows from the two without a difference: the projected
//! area is z + h, G₁ = z/(z + h), and the whole of D G₂/(4 z_i z_o) is D/(4(z_i z_o + z_o h_i + z_i h_o)).
//! E. Heitz, *Understanding the masking-shadowing function in microfacet-based BRDFs*, JCGT 3(2) (2014).

mod beckmann;
mod ggx;

pub use beckmann::Beckmann;
pub use ggx::Ggx;

use crate::number::{Number, Vector, beta};

/// The least roughness α [1]; the largest is 1.
pub const LEAST_ALPHA: f64 = 1e-4;

/// Which distribution of slopes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slopes {
    /// Trowbridge and Reitz's, [`Ggx`].
    Ggx,
    /// Gaussian, [`Beckmann`].
    Beckmann,
}

impl Slopes {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Ggx, Self::Beckmann];

    /// Command-line word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ggx => "ggx",
            Self::Beckmann => "beckmann",
        }
    }
}

/// A distribution of slopes, stretched along x and y.
pub trait Distribution<N: Number>: Copy + Send + Sync + 'static {
    /// Which one it is.
    const SLOPES: Slopes;
    /// Whether steep facets are a power's share, rather than an exponential's.
    const HAS_TAIL: bool;

    /// With roughness α along x and y [1], each held within [`LEAST_ALPHA`] … 1.
    fn new(alpha: [N; 2]) -> Self;

    /// α along x and y [1].
    fn alpha(&self) -> [N; 2];

    /// D [sr⁻¹], of facets with the normal `m`, per area of the mean surface: ∫D m_z dω = 1.
    fn density(&self, m: Vector<N>) -> N;

    /// h = |z|Λ(|z|) [1], for a direction on either side: what facets that face away from it hide.
    fn hidden(&self, w: Vector<N>) -> N;

    /// |z| + h [1]: the area of the facets that are seen from a direction above the surface, per mean area.
    #[inline(always)]
    fn area(&self, w: Vector<N>) -> N {
        w.z.abs() + self.hidden(w)
    }

    /// A facet as seen from `w`, which may lie below the surface, from two numbers in 0 ≤ u < 1: drawn with
    /// [`visible_density`].
    fn visible(&self, w: Vector<N>, u: [N; 2]) -> Vector<N>;

    /// As [`Distribution::visible`] for w_z > 0, where facets that reflect downwards may be left out.
    #[inline(always)]
    fn visible_reflecting(&self, w: Vector<N>, u: [N; 2]) -> Vector<N> {
        self.visible(w, u)
    }

    /// The area [1] that belongs to [`Distribution::visible_reflecting`]: facets are drawn with D (w·m)/area.
    #[inline(always)]
    fn reflecting_area(&self, w: Vector<N>) -> N {
        self.area(w)
    }

    /// The (u₁, u₂) from which [`Distribution::visible`] makes `m`, for w_z > 0: where a facet lies in the sampler's own
    /// square.
    fn place(&self, w: Vector<N>, m: Vector<N>) -> [N; 2];
}

/// The area of the visible facets as seen from `w` [1] per mean area: z + h above the surface, h below it.
#[inline(always)]
pub fn projected<N: Number>(facets: &impl Distribution<N>, w: Vector<N>) -> N {
    w.z.max(N::of(0.0)) + facets.hidden(w)
}

/// D (w·m)/projected area [sr⁻¹]: the density of the facets seen from `w`.
#[inline(always)]
pub fn visible_density<N: Number>(facets: &impl Distribution<N>, w: Vector<N>, m: Vector<N>) -> N {
    facets.density(m) * w.dot(m).max(N::of(0.0)) / projected(facets, w)
}

/// Λ [1], for z > 0.
#[inline(always)]
pub fn lambda<N: Number>(facets: &impl Distribution<N>, w: Vector<N>) -> N {
    facets.hidden(w) / w.z
}

/// G₁ = 1/(1 + Λ) [1], for z > 0: the share of facets facing `w` that is not masked.
#[inline(always)]
pub fn masking<N: Number>(facets: &impl Distribution<N>, w: Vector<N>) -> N {
    w.z / facets.area(w)
}

/// How masking from two sides goes together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joint {
    /// By one height: 1/(1 + Λ_i + Λ_o) on one side, Euler's B(1 + Λ_i, 1 + Λ_o) through the surface, which is what a walk
    /// over independent heights gives.
    Correlated,
    /// As if one had nothing to do with the other: G₁(i) G₁(o).
    Separable,
}

impl Joint {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Correlated, Self::Separable];

    /// Command-line word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Correlated => "correlated",
            Self::Separable => "separable",
        }
    }

    /// G₂/(z_i z_o) [1] of two directions above the surface, from their z and area z + h.
    #[inline(always)]
    pub fn reflected<N: Number>(self, [z_i, area_i]: [N; 2], [z_o, area_o]: [N; 2]) -> N {
        match self {
            // z_i z_o + z_o h_i + z_i h_o, of which the last term here is at most the half of the rest.
            Self::Correlated => N::of(1.0) / (z_o * area_i + z_i * area_o - z_i * z_o),
            Self::Separable => N::of(1.0) / (area_i * area_o),
        }
    }

    /// G₂/(z_i z_o) [1] of two directions on either side, from their |z| and area |z| + h.
    #[inline(always)]
    pub fn transmitted<N: Number>(self, [z_i, area_i]: [N; 2], [z_o, area_o]: [N; 2]) -> N {
        match self {
            Self::Correlated => beta(area_i / z_i, area_o / z_o) / (z_i * z_o),
            Self::Separable => self.reflected([z_i, area_i], [z_o, area_o]),
        }
    }
}

/// α held within what the forms bear; the least if it is not a number.
#[inline(always)]
fn held<N: Number>([along, across]: [N; 2]) -> [N; 2] {
    [along.clamp(LEAST_ALPHA, 1.0), across.clamp(LEAST_ALPHA, 1.0)]
}

/// The stretched sine squared [1].
#[inline(always)]
pub(super) fn stretched2<N: Number>([along, across]: [N; 2], w: Vector<N>) -> N {
    (along * w.x).squared() + (across * w.y).squared()
}
