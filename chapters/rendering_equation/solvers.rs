//! Races of C20: ways to solve the equations of a room, and ways to cut it.

use super::rooms::{extrapolated, graded, means, network, unequal};
use crate::vocabulary::{Entrant, Heat, Race, lane, largest, race};
use light::radiosity::{Light, Network, hierarchy, limit, solve};
use std::sync::OnceLock;

/// A room of unequal walls in 216 patches, solved by elimination.
fn raced() -> &'static (Network, Light, Vec<f64>) {
    static MADE: OnceLock<(Network, Light, Vec<f64>)> = OnceLock::new();
    MADE.get_or_init(|| {
        let (_, network, light) = network(&unequal(), 6);
        let exact = solve::direct(&network, &light);
        (network, light, exact)
    })
}

/// A solver of that network; its error is the largest of any patch, over the brightest.
fn solved(by: impl Fn(&Network, &Light) -> Vec<f64> + 'static) -> Heat {
    // Made before anything is timed.
    raced();
    Heat {
        run: Box::new(move || {
            let (network, light, _) = raced();
            by(network, light)
        }),
        error: Box::new(|found| {
            let exact = &raced().2;
            let most = exact.iter().copied().fold(0.0, f64::max);
            largest(found.iter().zip(exact).map(|(one, other)| (one - other) / most))
        }),
    }
}

pub(super) const SOLVERS: Race = race(
    "solvers",
    "one room, 216 patches: bounce by bounce, patch by patch, shot by shot, along conjugate directions, at once",
)
.work("rows of the network that were summed")
.error(
    "error of L over its largest",
    "largest error of any patch, over the brightest; against elimination without differences, which another lane times",
)
.lanes(&[
    lane("series", "bounce by bounce (Neumann)", &[432, 864, 1728, 3456, 6912], |_, work| {
        solved(move |network, light| solve::series(network, light, (work / 216) as u32))
    })
    .converges(1e-7, "32 terms, the largest eigenvalue of this room is 0.6"),
    lane("seidel", "patch by patch (Gauss and Seidel)", &[216, 432, 864, 1728, 3456], |_, work| {
        solved(move |network, light| solve::seidel(network, light, (work / 216) as u32))
    })
    .converges(1e-7, "about twice as many digits a sweep as the series"),
    lane("shooting", "shot by shot (Cohen and others)", &[27, 108, 432, 1728, 6912], |_, work| {
        solved(move |network, light| solve::shooting(network, light, work as u32).0)
    })
    .converges(1e-5, "the brightest first: no worse than the series in the end"),
    lane("conjugate", "conjugate gradients", &[216, 432, 864, 1728, 2592], |_, work| {
        solved(move |network, light| solve::conjugate(network, light, (work / 216) as u32))
    })
    .converges(1e-9, "a few eigenvalues stand apart, and each step takes one away"),
    lane("direct", "at once, without a difference", &[216], |_, _| solved(solve::direct))
        .within(1e-15, "the same numbers again: it is the reference"),
    lane("plain", "at once, by plain elimination", &[216], |_, _| solved(solve::plain))
        .within(1e-12, "two hundred roundings at each of two hundred steps, of a well conditioned room"),
]);

/// The face whose mean is looked at: the floor.
const FLOOR: usize = 2;

/// What it is, by graded cuts of which the finest makes 1536 patches.
fn converged() -> f64 {
    static MADE: OnceLock<f64> = OnceLock::new();
    *MADE.get_or_init(|| extrapolated(&unequal(), 10)[FLOOR])
}

/// By three cuts, each half of the one before.
fn twice(cuts: [usize; 3]) -> f64 {
    let [a, b, c] = cuts.map(|n| means(&unequal(), n)[FLOOR]);
    limit::richardson([limit::richardson([a, b], ORDER), limit::richardson([b, c], ORDER)], NEXT)
}

/// The order of constant patches' means, and what is left when that is taken off.
const ORDER: f64 = 2.0;
const NEXT: f64 = 3.0;

fn cut(by: impl Fn() -> f64 + 'static) -> Heat {
    // Made before anything is timed.
    let exact = converged();
    Heat { run: Box::new(move || vec![by()]), error: Box::new(move |found| (found[0] / exact - 1.0).abs()) }
}

const fn cuts(
    id: &'static str,
    label: &'static str,
    works: &'static [u64],
    prepare: fn(&mut crate::vocabulary::Bench, u64) -> Heat,
) -> Entrant {
    lane(id, label, works, prepare)
}

pub(super) const CUTS: Race = race(
    "cuts",
    "the mean of a wall by constant patches is of order h²; two cuts together are worth one that is many times as fine",
)
.work("patches")
.error(
    "relative error of the floor's mean",
    "relative error, against graded cuts of 10, 12, 14 and 16 patches an edge, extrapolated; by their neighbours known to 10⁻⁷",
)
.lanes(&[
    cuts("constant", "constant patches", &[24, 54, 96, 216, 384, 1536], |_, work| {
        let n = (work as f64 / 6.0).sqrt().round() as usize;
        cut(move || means(&unequal(), n)[FLOOR])
    })
    .order(1.0, 0.15),
    cuts("two_cuts", "n and n/2, extrapolated", &[24, 96, 384, 1536], |_, work| {
        let n = (work as f64 / 6.0).sqrt().round() as usize;
        cut(move || limit::richardson([n / 2, n].map(|n| means(&unequal(), n)[FLOOR]), ORDER))
    })
    .order(1.5, 0.2),
    cuts("three_cuts", "n, n/2 and n/4, extrapolated twice", &[96, 384, 864], |_, work| {
        let n = (work as f64 / 6.0).sqrt().round() as usize;
        cut(move || twice([n / 4, n / 2, n]))
    })
    .within(1e-3, "what is left of n = 4; for n = 12 see the error"),
    cuts("graded", "finer towards the edges", &[96, 216, 384, 864], |_, work| {
        let n = (work as f64 / 6.0).sqrt().round() as usize;
        cut(move || graded(&unequal(), n)[FLOOR])
    })
    .order(1.0, 0.15),
    cuts("graded_cuts", "finer towards the edges, n, n − 2, n − 4 and n − 6, extrapolated", &[384, 600, 864], |_, work| {
        let n = (work as f64 / 6.0).sqrt().round() as usize;
        cut(move || extrapolated(&unequal(), n - 6)[FLOOR])
    })
    .converges(1e-6, "the next power of 1/12, the sixth, with the factor of some three that a grading has"),
]);

/// A bound on what a link may carry [W sr⁻¹], so that pieces become about as small as so many `patches`, all alike, would
/// be: of a smooth kernel a link carries what goes with the areas of both its ends.
fn bound(patches: u64) -> f64 {
    (3.0 / patches as f64).powi(2)
}

/// Quarters are cut as far as the bound asks, down to this share of an edge.
const LEAST: f64 = 1.0 / 256.0;

pub(super) const LINKS: Race = race(
    "links",
    "one patch size for all, or links between pieces as large as what goes over them allows: in a small smooth room patches that are all alike, whose errors cancel, win in the end",
)
.work("patches; or links between pieces about as small as those")
.error("largest relative error of a wall's mean", "largest relative error of the six walls' means, against graded cuts, extrapolated")
.lanes(&[
    cuts("matrix", "all pairs of patches", &[96, 384, 1536], |_, work| {
        let n = (work as f64 / 6.0).sqrt().round() as usize;
        walls(move || means(&unequal(), n))
    })
    .order(1.0, 0.15),
    // Light that is constant over pieces of unequal size, whose errors do not cancel, is off as the pieces are long.
    cuts("links", "links, each cut until it carries little", &[24, 48, 96, 192, 384], |_, work| {
        walls(move || hierarchy::solve(&unequal(), 1, bound(work), LEAST).means)
    })
    .order(0.5, 0.2),
]);

fn walls(by: impl Fn() -> Vec<f64> + 'static) -> Heat {
    static MADE: OnceLock<Vec<f64>> = OnceLock::new();
    let exact: &'static [f64] = MADE.get_or_init(|| extrapolated(&unequal(), 10));
    let worst = move |found: &[f64]| largest(found.iter().zip(exact).map(|(one, other)| one / other - 1.0));
    Heat { run: Box::new(by), error: Box::new(worst) }
}
