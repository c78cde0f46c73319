//! Points of the unit square, by chance and by plan.

use crate::random::{Stream, uniform};
use rand::Rng;
use sobol_burley::parts::{owen_scramble_rev, sobol_rev};

/// The most points that [`Points::Sobol`] has.
pub const MOST_SOBOL: usize = 1 << 16;

/// How points are drawn. Of each kind every single point is even over the square, so all means are unbiased.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Points {
    /// Independent of each other. The error of a mean falls as n^−½.
    Random,
    /// One in each cell of a grid as square as n allows (a prime n makes strips). As n^−1 where f is smooth, at least as
    /// n^−¾ at a step (D. P. Mitchell, *SIGGRAPH '96*, 277).
    Stratified,
    /// Sobol's net under Owen's scrambling, by hashes (B. Burley, *JCGT* 9(4) (2020) 1); meant for n a power of two, up
    /// to [`MOST_SOBOL`]. As n^−3/2 up to logarithms where f is smooth (A. B. Owen, *Ann. Statist.* 25 (1997) 1541), less
    /// where it is not.
    Sobol,
}

impl Points {
    /// All kinds.
    pub const ALL: [Self; 3] = [Self::Random, Self::Stratified, Self::Sobol];

    /// `n` points (u, v), 0 ≤ u, v < 1, that `stream` alone decides.
    ///
    /// # Panics
    /// If n is more than [`MOST_SOBOL`] for Sobol's.
    pub fn draw(self, n: usize, stream: &mut Stream) -> Vec<[f64; 2]> {
        match self {
            Self::Random => (0..n).map(|_| even(stream)).collect(),
            Self::Stratified => stratified(n, stream),
            Self::Sobol => sobol(n, stream),
        }
    }
}

fn even(stream: &mut Stream) -> [f64; 2] {
    std::array::from_fn(|_| uniform(stream, 0.0, 1.0))
}

fn stratified(n: usize, stream: &mut Stream) -> Vec<[f64; 2]> {
    let rows = (1..=n.isqrt()).rev().find(|rows| n.is_multiple_of(*rows)).unwrap_or(1);
    let columns = n / rows;
    let jittered = |cell: usize| {
        let [u, v] = even(stream);
        [((cell / columns) as f64 + u) / rows as f64, ((cell % columns) as f64 + v) / columns as f64].map(below_one)
    };
    (0..n).map(jittered).collect()
}

fn sobol(n: usize, stream: &mut Stream) -> Vec<[f64; 2]> {
    assert!(n <= MOST_SOBOL, "Sobol's net has {MOST_SOBOL} points, not {n}");
    let scrambles: [u32; 2] = std::array::from_fn(|_| stream.next_u32());
    let point = |index: u32| {
        // The middle of the 2⁻³² that is left open.
        std::array::from_fn(|axis| (f64::from(net(index, axis as u32, scrambles[axis])) + 0.5) / 2f64.powi(32))
    };
    (0..n as u32).map(point).collect()
}

/// Along one of 256 axes the `index`-th point of Sobol's net, of [`MOST_SOBOL`], under Owen's scrambling by a hash:
/// 32 bits after the point.
///
/// # Panics
/// If there is no such axis.
pub fn net(index: u32, axis: u32, scramble: u32) -> u32 {
    // The crate keeps bits in reverse order, as the hash needs them.
    owen_scramble_rev(sobol_rev(index.reverse_bits(), axis), scramble).reverse_bits()
}

/// `index` by a permutation that keeps every block of 2^k numbers together that begins at a multiple of 2^k: another order of
/// the same net, for another pair of its axes.
pub fn shuffled(index: u32, key: u32) -> u32 {
    owen_scramble_rev(index.reverse_bits(), key).reverse_bits()
}

/// Rounding may carry the last cell's end to 1.
fn below_one(part: f64) -> f64 {
    part.min(1.0_f64.next_down())
}
