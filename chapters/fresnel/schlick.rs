//! E44: Schlick's approximation, what it is good for, and what its speed costs.

use super::amplitudes::contrast;
use super::symbols::{N_1, N_2, R_0, R_N, THETA_1, THETA_2};
use super::{INTERFACE, extremes, incidence, interface, over_angle, over_angle_near};
use crate::figure::{Axis, Chart, Hue, Map, Panel, Plot, Ramp};
use crate::setting::{DEFAULT_WAVELENGTH, Setting};
use crate::vocabulary::{
    ALLOWED_ULPS, Bench, Bound, Check, Derivation, Expects, Extreme, Figure, Heat, Lane, Measured, Quantity, Race,
    Statement, Step, Stress,
};
use equation::derivation::Chain;
use equation::expr::{cos, d, pi, ratio};
use equation::value::Bindings;
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::media;
use light::optics::fresnel::{critical_angle, natural_reflectance, natural_reflectance_absorbing, powers};
use light::optics::schlick::{Dipped, normal_reflectance, schlick, schlick_rarer_side};
use light::optics::{Direction, Incidence};
use light::references::fresnel::{Exact, Input, NAMES};
use std::f64::consts::FRAC_PI_2;
use std::hint::black_box;
use yardstick::precise;
use yardstick::random::uniform;

pub(super) const STEP: Step = Step {
    id: "schlick",
    title: "Schlick's approximation",
    says: "A fifth power stands in for R_n: close for glass in air, wrong from inside it.",
    rows: &["E44"],
    parameters: INTERFACE,
    statements: &[
        Statement {
            id: "r_0",
            says: "reflectance at normal incidence",
            rows: &["E44"],
            equation: || Equation::new(R_0, ((N_1 - N_2) / (N_1 + N_2)).pow(2)),
        },
        Statement {
            id: "schlick",
            says: "Schlick's approximation",
            rows: &["E44"],
            equation: || Equation::approximate(R_N, fifth_power(cos(THETA_1))),
        },
        Statement {
            id: "rarer_side",
            says: "out of the denser medium it is the refracted angle that reaches 90°",
            rows: &["E44"],
            equation: || Equation::approximate(R_N, fifth_power(cos(THETA_2))),
        },
    ],
    derivations: &[
        Derivation {
            id: "normal_incidence",
            says: "R_n from E35 and E38 at θ = 0, where E36 and E39 themselves are 0/0",
            rows: &["E44"],
            chain: || at_normal(((N_1 - N_2) / (N_1 + N_2)).pow(2)),
            spoiled: || at_normal(((N_1 - N_2) / (N_1 + N_2)).pow(2) / 2),
            slip: "s and p do not add",
        },
        Derivation {
            id: "slope",
            says: "how the approximation starts at grazing incidence",
            rows: &["E44"],
            chain: || grazing(-5 * (1 - R_0)),
            spoiled: || grazing(Expr::from(-5)),
            slip: "the fifth power is differentiated without its factor",
        },
    ],
    readout: Some(readout),
    checks: &[AS_WRITTEN, ENDS, GRAZING_SLOPE, GLASS, INSIDE, METALS],
    stress: &[Stress {
        id: "beyond_glass",
        claim: "where Schlick keeps no digit the exact form costs little more and keeps them all",
        rows: &["E44"],
        textbook: "Schlick's R₀ + (1 − R₀)(1 − cos θ₁)⁵",
        reference: "R_n from the boundary conditions in 256 bits",
        cases: beyond_glass,
    }],
    races: &[SPEED, TABLE],
    figures: &[
        Figure {
            id: "error_map",
            says: "Schlick's error over angle and index, with the cosine of either side.",
            rows: &["E44"],
            plot: error_map,
        },
        Figure {
            id: "curves",
            says: "Exact and approximate reflectance: the setting's, out of glass, of a high index, and of a metal.",
            rows: &["E44"],
            plot: curves,
        },
    ],
};

/// R₀ + (1 − R₀)(1 − cos)⁵
fn fifth_power(cosine: Expr) -> Expr {
    R_0 + (1 - R_0) * (1 - cosine).pow(5)
}

fn at_normal(last: Expr) -> Chain {
    let s = contrast(N_1 * cos(THETA_1), N_2 * cos(THETA_2));
    let p = contrast(N_2 * cos(THETA_1), N_1 * cos(THETA_2));
    Chain::new(ratio(1, 2) * (s.pow(2) + p.pow(2)))
        .because("E42 with the ratios that E35 and E38 give")
        .given(THETA_1, 0, "normal incidence")
        .given(THETA_2, 0, "Snell: sin θ₂ = 0")
        .then(
            ratio(1, 2) * (contrast(N_1.into(), N_2.into()).pow(2) + contrast(N_2.into(), N_1.into()).pow(2)),
            ["cos 0 = 1"],
        )
        .then(last, ["squares do not see the sign"])
}

/// The derivative of the approximation by the cosine, where that is 0.
fn grazing(last: Expr) -> Chain {
    const COSINE: Symbol = Symbol::scalar("c", Dimension::ONE).within(0.1, 0.9);
    let factor = -5 * (1 - R_0);
    Chain::new(Equation::new(d(R_N) / d(COSINE), &factor * (1 - COSINE).pow(4)))
        .given(R_N, fifth_power(COSINE.into()), "Schlick")
        .then(Equation::new(factor * (1 - cos(pi() / 2)).pow(4), last), ["cos θ = 0"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let Input { n_i, n_t, .. } = interface(setting);
    let direction = incidence(setting);
    let r_0 = normal_reflectance(n_i, n_t);
    let (exact, plain) = (powers(direction, n_i, n_t).r_n(), schlick(direction.cos(), r_0));
    let number = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    let mut quantities = vec![
        number("R_0", "R_0", "reflectance at normal incidence", r_0),
        number("R_n", "R_n", "exact", exact),
        number("schlick", "R_S", "Schlick's approximation", plain),
        number("error", "R_S − R_n", "its error", plain - exact),
    ];
    if n_t.im == 0.0 {
        let rarer = schlick_rarer_side(direction.cos(), n_i, n_t.re);
        quantities.push(number("rarer_side", "R_S(θ_2)", "Schlick with the rarer side's cosine", rarer));
    }
    quantities
}

const AS_WRITTEN: Check = Check {
    id: "as_written",
    claim: "the program's approximation is the equation on the page",
    rows: &["E44"],
    route: "the equation above, as the object on the page, in 256-bit arithmetic",
    bound: Bound::AtMost {
        limit: ALLOWED_ULPS,
        unit: "ε",
        why: "ten operations on positive numbers; only 1 − cos θ subtracts, and cos θ is exact here",
    },
    measure: |bench| against_equation(bench, &fifth_power(cos(THETA_1))),
    spoiled: |bench| against_equation(bench, &(R_0 + (1 - R_0) * (1 - cos(THETA_1)).pow(4))),
    slip: "the fourth power",
};

/// Relative error of the program's function against `equation` [ε], at random cosines and reflectances.
fn against_equation(bench: &mut Bench, equation: &Expr) -> Measured {
    Measured::worst((0..6).map(|_| {
        let (cos_i, r_0) = (uniform(&mut bench.stream, 0.0, 1.0), uniform(&mut bench.stream, 0.0, 1.0));
        let mut bindings = Bindings::new();
        bindings.bind(THETA_1.name(), precise::from_real(precise::real(cos_i).acos()));
        bindings.bind(R_0.name(), precise::from_real(precise::real(r_0)));
        let exact = equation.evaluate(&bindings);
        let program = schlick(cos_i, r_0);
        let error = exact.map_or(f64::NAN, |exact| precise::relative_error(program, &exact.into_parts().0));
        (error / f64::EPSILON, format!("cos θ = {cos_i:.3}, R_0 = {r_0:.3}"))
    }))
}

const ENDS: Check = Check {
    id: "both_ends",
    claim: "the approximation is exact along the normal and at grazing incidence, metals included",
    rows: &["E44"],
    route: "the exact R_n",
    bound: Bound::AtMost {
        limit: 16.0, unit: "ε", why: "a few roundings; at cos θ = 1e−20 both are 1 to 18 digits"
    },
    measure: |bench| at_both_ends(bench, schlick),
    spoiled: |bench| at_both_ends(bench, |cos_i, r_0| r_0 + (1.0 - cos_i).powi(5)),
    slip: "the factor 1 − R₀ is forgotten",
};

fn at_both_ends(bench: &mut Bench, approximate: fn(f64, f64) -> f64) -> Measured {
    let own = interface(bench.setting);
    let media = super::sample_media().into_iter().chain([(own.n_i, own.n_t)]);
    // Equal media reflect nothing at any angle, which no Schlick can know.
    let different = media.filter(|(n_i, n_t)| (n_t - n_i).norm() > 0.1 * n_i);
    let cases = different.flat_map(|(n_i, n_t)| [1.0, 1e-20].map(|cos_i| (n_i, n_t, cos_i)));
    Measured::worst(cases.map(|(n_i, n_t, cos_i)| {
        let exact = powers(Incidence::from_cos(cos_i), n_i, n_t).r_n();
        let error = approximate(cos_i, normal_reflectance(n_i, n_t)) - exact;
        (error / f64::EPSILON, format!("n {n_i} → {n_t}, cos θ = {cos_i}"))
    }))
}

const GRAZING_SLOPE: Check = Check {
    id: "grazing_slope",
    claim: "at grazing incidence the approximation starts with a slope of its own, 5(1 − R₀) per cos θ",
    rows: &["E44"],
    route: "expansion of E36 and E39 at cos θ → 0: 1 − R_n = 2(n² + 1)/√(n² − 1) cos θ + O(cos² θ)",
    bound: Bound::AtMost { limit: 1e-3, unit: "1", why: "cos θ = 1e−5, and the next term's factor is some tens" },
    measure: |_| grazing_slope(|r_0| 5.0 * (1.0 - r_0)),
    spoiled: |_| grazing_slope(|_| 5.0),
    slip: "the fifth power is differentiated without its factor",
};

/// ((Schlick − exact) − (difference of the slopes) cos θ)/cos θ near grazing, with Schlick's slope from `slope`.
fn grazing_slope(slope: fn(f64) -> f64) -> Measured {
    let cos_i = 1e-5;
    Measured::worst(GLASSES.map(|n| {
        let r_0 = normal_reflectance(1.0, n.into());
        let exact = powers(Incidence::from_cos(cos_i), 1.0, n.into()).r_n();
        let wedge = 2.0 * (n * n + 1.0) / (n * n - 1.0).sqrt() - slope(r_0);
        ((schlick(cos_i, r_0) - exact) / cos_i - wedge, format!("n = {n}"))
    }))
}

/// How far Schlick may be from R_n for indices between water's and dense flint's, against air.
const GLASS_ERROR: f64 = 0.06;

const GLASS: Check = Check {
    id: "glass_in_air",
    claim: "for water and glass in air the approximation is off by a few hundredths at most, near grazing",
    rows: &["E44"],
    route: "the exact R_n, every quarter of a degree",
    bound: Bound::AtMost {
        limit: GLASS_ERROR,
        unit: "1",
        why: "the wedge between the slopes at grazing, widest for water, opens so far before the fifth power closes it",
    },
    measure: |_| for_glass(schlick),
    spoiled: |_| for_glass(|cos_i, r_0| r_0 + (1.0 - r_0) * (1.0 - cos_i).powi(4)),
    slip: "the fourth power",
};

/// Indices of water, crown glass, flint and dense flint.
const GLASSES: [f64; 4] = [1.333, 1.5, 1.6, 1.78];

fn for_glass(approximate: fn(f64, f64) -> f64) -> Measured {
    Measured::worst(GLASSES.into_iter().flat_map(|n| {
        let r_0 = normal_reflectance(1.0, n.into());
        cosines().map(move |cos_i| {
            let exact = powers(Incidence::from_cos(cos_i), 1.0, n.into()).r_n();
            (approximate(cos_i, r_0) - exact, format!("n = {n}, cos θ = {cos_i:.4}"))
        })
    }))
}

/// Cosines of angles a quarter of a degree apart.
fn cosines() -> impl Iterator<Item = f64> {
    (0..360).map(|quarter| (f64::from(quarter) / 4.0).to_radians().cos())
}

const INSIDE: Check = Check {
    id: "from_inside",
    claim: "from inside glass the rarer side's cosine keeps the bound; the incident one misses total reflection",
    rows: &["E44"],
    route: "the exact R_n, below and beyond the critical one",
    bound: Bound::AtMost {
        limit: GLASS_ERROR,
        unit: "1",
        why: "R_n is the same from both sides at angles that Snell's law joins, so the error from outside carries over",
    },
    measure: |_| from_inside(schlick_rarer_side),
    spoiled: |_| from_inside(|cos_i, n_i, n_t| schlick(cos_i, normal_reflectance(n_i, n_t.into()))),
    slip: "cos θ₁ is used in the denser medium",
};

fn from_inside(approximate: fn(f64, f64, f64) -> f64) -> Measured {
    Measured::worst(GLASSES.into_iter().flat_map(|n| {
        cosines().map(move |cos_i| {
            let exact = powers(Incidence::from_cos(cos_i), n, 1.0.into()).r_n();
            (approximate(cos_i, n, 1.0) - exact, format!("n {n} → 1, cos θ = {cos_i:.4}"))
        })
    }))
}

/// How far the form with two reflectances may be from R_n of metals.
const DIPPED_ERROR: f64 = 0.05;

const METALS: Check = Check {
    id: "metals",
    claim: "one more reflectance, at 82°, makes the approximation fit for metals",
    rows: &["E44"],
    route: "the exact R_n of gold, silver, copper, aluminium and chromium over the visible",
    bound: Bound::AtMost {
        limit: DIPPED_ERROR,
        unit: "1",
        why: "one lobe through one point: what is left beside it, largest for chromium at 87°",
    },
    measure: |_| for_metals(|_, r_82| r_82),
    spoiled: |_| for_metals(|r_0, _| schlick(Dipped::COS, r_0)),
    slip: "Schlick's own value at 82° is taken for the metal's",
};

fn for_metals(at_82: fn(f64, f64) -> f64) -> Measured {
    let metals = ["gold", "silver", "copper", "aluminium", "chromium"];
    let wavelengths = [400e-9, 450e-9, 500e-9, 550e-9, 600e-9, 650e-9, 700e-9];
    let cases = metals.into_iter().flat_map(|name| wavelengths.map(|wavelength| (name, wavelength)));
    Measured::worst(cases.flat_map(|(name, wavelength)| {
        let index = media::named(name).and_then(|metal| metal.index(wavelength).ok());
        let n_t = index.unwrap_or(Complex64::new(f64::NAN, 0.0));
        let exact = move |cos_i| powers(Incidence::from_cos(cos_i), 1.0, n_t).r_n();
        let r_0 = normal_reflectance(1.0, n_t);
        let dipped = Dipped::new(r_0, at_82(r_0, exact(Dipped::COS)));
        cosines().step_by(4).map(move |cos_i| {
            let place = format!("{name}, {:.0} nm, cos θ = {cos_i:.4}", wavelength * 1e9);
            (dipped.reflectance(cos_i) - exact(cos_i), place)
        })
    }))
}

/// From inside, about the critical angle, nearly equal and far apart indices, metals.
fn beyond_glass(setting: &Setting) -> Vec<Extreme> {
    let critical = critical_angle(1.5, 1.0).expect("into the rarer medium");
    let input = |theta, n_i, n, k| Input { direction: Direction::Angle(theta), n_i, n_t: Complex64::new(n, k) };
    let inputs = [
        interface(setting),
        input(0.5, 1.5, 1.0, 0.0),
        input(critical - 1e-6, 1.5, 1.0, 0.0),
        input(critical + 1e-6, 1.5, 1.0, 0.0),
        input(0.9, 1.0, 0.25, 0.0),
        input(1.0, 1.0, 1.0 + 1e-9, 0.0),
        input(FRAC_PI_2 - 1e-6, 1.0, 1.0 + 1e-9, 0.0),
        input(1.3, 1.0, 4.0, 0.0),
        input(1.3, 1.0, 1e6, 0.0),
        input(1.3, 1.0, 3.0, 3.0),
        input(1.4, 1.0, 1.2, 7.0),
        input(FRAC_PI_2 - 1e-3, 1.0, 1e3, 1e3),
    ];
    extremes::cases_against(&["R_n"], &inputs, |input| {
        let cos_i = Incidence::from(input.direction).cos();
        [schlick(cos_i, normal_reflectance(input.n_i, input.n_t)); NAMES.len()]
    })
}

/// The crown glass of the races: cos θ_c = ¾ from inside, so that the kink falls on an entry of every table.
const GLASS_INDEX: f64 = 1.511_857_892_036_909;

/// The metal of the races, chosen for its deep dip.
fn metal() -> Complex64 {
    media::named("chromium").and_then(|metal| metal.index(DEFAULT_WAVELENGTH).ok()).expect("a listed metal")
}

const EVALUATIONS: &[u64] = &[1 << 10, 1 << 12, 1 << 14];

const EXACT: Expects = Expects::Within { limit: 1e-15, why: "a few roundings of a number below 1" };

/// R_n of many cosines in one call.
type Batch = fn(&[f64], &mut [f64]);

const SPEED: Race = Race {
    id: "speed",
    claim: "Schlick's error buys a few nanoseconds; with the rarer side's cosine it buys none",
    rows: &["E44"],
    work: "evaluations of R_n",
    error: "largest |ΔR|",
    reference: "largest |ΔR|; R_n in 256 bits at 64 of the cosines",
    lanes: &[
        Lane {
            id: "exact",
            label: "exact, into glass",
            works: EVALUATIONS,
            expects: EXACT,
            repeats: 1,
            prepare: |_, work| {
                heat(work, GLASS_INDEX.into(), |cos_i, out| natural_reflectance(cos_i, 1.0, GLASS_INDEX, out))
            },
        },
        Lane {
            id: "schlick",
            label: "Schlick, into glass",
            works: EVALUATIONS,
            expects: Expects::Within { limit: GLASS_ERROR, why: "its known error for glass (check glass_in_air)" },
            repeats: 1,
            prepare: |_, work| {
                heat(work, GLASS_INDEX.into(), |cos_i, out| {
                    let r_0 = normal_reflectance(1.0, GLASS_INDEX.into());
                    each(cos_i, out, |cos_i| schlick(cos_i, r_0));
                })
            },
        },
        Lane {
            id: "exact_inside",
            label: "exact, from inside",
            works: EVALUATIONS,
            expects: Expects::Within {
                limit: 1e-12,
                why: "beside the critical angle the last bit of cos θ₁ moves R by its root; elsewhere a few roundings",
            },
            repeats: 1,
            prepare: |_, work| heat_inside(work, |cos_i, out| natural_reflectance(cos_i, GLASS_INDEX, 1.0, out)),
        },
        Lane {
            id: "rarer_side",
            label: "Schlick, rarer side",
            works: EVALUATIONS,
            expects: Expects::Within { limit: GLASS_ERROR, why: "reciprocity (check from_inside)" },
            repeats: 1,
            prepare: |_, work| {
                heat_inside(work, |cos_i, out| each(cos_i, out, |cos_i| schlick_rarer_side(cos_i, GLASS_INDEX, 1.0)))
            },
        },
        Lane {
            id: "schlick_inside",
            label: "Schlick with cos θ_1",
            works: EVALUATIONS,
            expects: Expects::Breaks { limit: 0.5, why: "cos θ₁ never comes near 0 before everything is reflected" },
            repeats: 1,
            prepare: |_, work| {
                heat_inside(work, |cos_i, out| {
                    let r_0 = normal_reflectance(GLASS_INDEX, 1.0.into());
                    each(cos_i, out, |cos_i| schlick(cos_i, r_0));
                })
            },
        },
        Lane {
            id: "exact_metal",
            label: "exact, chromium",
            works: EVALUATIONS,
            expects: EXACT,
            repeats: 1,
            prepare: |_, work| {
                heat(work, metal(), |cos_i, out| natural_reflectance_absorbing(cos_i, 1.0, metal(), out))
            },
        },
        Lane {
            id: "schlick_metal",
            label: "Schlick, chromium",
            works: EVALUATIONS,
            expects: Expects::Breaks { limit: DIPPED_ERROR, why: "R dips before it rises: no fifth power does" },
            repeats: 1,
            prepare: |_, work| {
                heat(work, metal(), |cos_i, out| {
                    let r_0 = normal_reflectance(1.0, metal());
                    each(cos_i, out, |cos_i| schlick(cos_i, r_0));
                })
            },
        },
        Lane {
            id: "dipped_metal",
            label: "Schlick with a dip at 82°, chromium",
            works: EVALUATIONS,
            expects: Expects::Within { limit: DIPPED_ERROR, why: "its known error for metals (check metals)" },
            repeats: 1,
            prepare: |_, work| {
                heat(work, metal(), |cos_i, out| {
                    let r_82 = powers(Incidence::from_cos(Dipped::COS), 1.0, metal()).r_n();
                    let dipped = Dipped::new(normal_reflectance(1.0, metal()), r_82);
                    each(cos_i, out, |cos_i| dipped.reflectance(cos_i));
                })
            },
        },
    ],
};

fn each(cosines: &[f64], out: &mut [f64], value: impl Fn(f64) -> f64) {
    for (out, &cos) in out.iter_mut().zip(cosines) {
        *out = value(cos);
    }
}

fn heat(work: u64, n_t: Complex64, batch: Batch) -> Heat {
    prepared(work, 1.0, n_t, batch)
}

fn heat_inside(work: u64, batch: Batch) -> Heat {
    prepared(work, GLASS_INDEX, 1.0.into(), batch)
}

/// How many results of a run are held against 256 bits.
const SAMPLE: usize = 64;

/// `work` evaluations at the midpoints of equal steps in cos θ; some of them are handed on.
fn prepared(work: u64, n_i: f64, n_t: Complex64, batch: Batch) -> Heat {
    let cosines = midpoints(work as usize);
    let places = (0..cosines.len()).step_by(cosines.len() / SAMPLE);
    let sample: Vec<f64> = places.clone().map(|place| cosines[place]).collect();
    let mut values = vec![0.0; cosines.len()];
    Heat {
        run: Box::new(move || {
            batch(&cosines, &mut values);
            places.clone().map(|place| values[place]).collect()
        }),
        error: Box::new(move |found| {
            let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
            let errors = found.iter().zip(&sample).map(|(found, &cos_i)| {
                let exact = Exact::new(&Input { direction: Direction::Cos(cos_i), n_i, n_t });
                (precise::to_f64(&(precise::real(*found) - &exact.outputs[at])), String::new())
            });
            Measured::worst(errors).value
        }),
    }
}

fn midpoints(count: usize) -> Vec<f64> {
    (0..count).map(|place| (place as f64 + 0.5) / count as f64).collect()
}

const ENTRIES: &[u64] = &[16, 32, 64, 128, 256, 512, 1024];
/// Look-ups that a table is judged by.
const JUDGED: usize = 1 << 13;

const TABLE: Race = Race {
    id: "table",
    claim: "filling a table buys digits as the square of its size, but only as the root where R has a vertical tangent",
    rows: &["E44"],
    work: "entries of the table, filled once",
    error: "largest |ΔR|",
    reference: "largest |ΔR|; the exact R_n in f64, whose error is a trillionth of a table's",
    lanes: &[
        Lane {
            id: "glass",
            label: "table in cos θ_1, into glass",
            works: ENTRIES,
            expects: Expects::Order { order: 2.0, tolerance: 0.2 },
            repeats: 1,
            prepare: |_, work| tabulated(work, 1.0, GLASS_INDEX.into()),
        },
        Lane {
            id: "metal",
            label: "table in cos θ_1, chromium",
            works: ENTRIES,
            expects: Expects::Order { order: 2.0, tolerance: 0.2 },
            repeats: 1,
            prepare: |_, work| tabulated(work, 1.0, metal()),
        },
        Lane {
            id: "inside",
            label: "table in cos θ_1, out of glass",
            works: ENTRIES,
            expects: Expects::Order { order: 0.5, tolerance: 0.2 },
            repeats: 1,
            prepare: |_, work| tabulated(work, GLASS_INDEX, 1.0.into()),
        },
        Lane {
            id: "schlick",
            label: "Schlick, into glass (no table)",
            works: &[1],
            expects: Expects::Within { limit: GLASS_ERROR, why: "its known error for glass (check glass_in_air)" },
            repeats: 1,
            prepare: |_, _| Heat {
                run: Box::new(|| vec![normal_reflectance(1.0, black_box(GLASS_INDEX).into())]),
                error: Box::new(|r_0| largest_error(1.0, GLASS_INDEX.into(), |cos_i| schlick(cos_i, r_0[0]))),
            },
        },
    ],
};

/// Filling a table of `entries` steps in cos θ₁ with the exact R_n; the error is that of looking up between them.
fn tabulated(entries: u64, n_i: f64, n_t: Complex64) -> Heat {
    let steps = entries as f64;
    let cosines: Vec<f64> = (0..=entries).map(|place| place as f64 / steps).collect();
    let mut table = vec![0.0; cosines.len()];
    Heat {
        run: Box::new(move || {
            match n_t.im == 0.0 {
                true => natural_reflectance(&cosines, n_i, n_t.re, &mut table),
                false => natural_reflectance_absorbing(&cosines, n_i, n_t, &mut table),
            }
            table.clone()
        }),
        error: Box::new(move |table| {
            largest_error(n_i, n_t, |cos_i| {
                let place = cos_i * steps;
                let left = (place as usize).min(table.len() - 2);
                let weight = place - left as f64;
                table[left] + weight * (table[left + 1] - table[left])
            })
        }),
    }
}

/// Largest |ΔR| of `approximate` against the exact R_n over the cosines.
fn largest_error(n_i: f64, n_t: Complex64, approximate: impl Fn(f64) -> f64) -> f64 {
    let error = |cos_i: f64| approximate(cos_i) - powers(Incidence::from_cos(cos_i), n_i, n_t).r_n();
    Measured::worst(midpoints(JUDGED).into_iter().map(|cos_i| (error(cos_i), String::new()))).value
}

/// Relative indices shown, from a quarter to four.
const MAP_INDEX: (f64, f64) = (0.25, 4.0);
const MAP_COLUMNS: usize = 180;
const MAP_ROWS: usize = 120;

fn error_map(_: &Setting) -> Plot {
    let plain = |cos_i: f64, n: f64| schlick(cos_i, normal_reflectance(1.0, n.into()));
    let rarer = |cos_i: f64, n: f64| schlick_rarer_side(cos_i, 1.0, n);
    Plot::grid(
        "Error of Schlick's approximation",
        2,
        vec![error_panel("with cos θ_1", plain), error_panel("with the rarer side's cosine", rarer)],
    )
}

fn error_panel(title: &str, approximate: impl Fn(f64, f64) -> f64) -> Panel {
    let mut values = Vec::with_capacity(MAP_COLUMNS * MAP_ROWS);
    for row in 0..MAP_ROWS {
        let up = (row as f64 + 0.5) / MAP_ROWS as f64;
        let n = MAP_INDEX.0 * (MAP_INDEX.1 / MAP_INDEX.0).powf(up);
        values.extend((0..MAP_COLUMNS).map(|column| {
            let theta = (column as f64 + 0.5) / MAP_COLUMNS as f64 * FRAC_PI_2;
            let incidence = Incidence::from_angle(theta);
            (approximate(incidence.cos(), n) - powers(incidence, 1.0, n.into()).r_n()).abs()
        }));
    }
    Map {
        title: title.into(),
        x: Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(30.0),
        y: Axis::log("n_2/n_1", "").range(MAP_INDEX.0, MAP_INDEX.1),
        colour: Axis::log("|ΔR|", "").range(1e-4, 1.0),
        ramp: Ramp::Sequential,
        columns: MAP_COLUMNS,
        values,
        marks: Vec::new(),
    }
    .into()
}

fn curves(setting: &Setting) -> Plot {
    let own = interface(setting);
    let aluminium = media::named("aluminium").and_then(|metal| metal.index(800e-9).ok()).expect("a listed metal");
    let panels = vec![
        panel("the setting", own.n_i, own.n_t),
        panel("out of glass", GLASS_INDEX, 1.0.into()),
        panel("n 1 → 4", 1.0, 4.0.into()),
        panel("aluminium, 800 nm", 1.0, aluminium),
    ];
    Plot::grid("Exact and approximate reflectance", 2, panels)
}

fn panel(title: &str, n_i: f64, n_t: Complex64) -> Panel {
    let r_0 = normal_reflectance(n_i, n_t);
    let exact = move |incidence: Incidence| powers(incidence, n_i, n_t).r_n();
    let critical = if n_t.im == 0.0 { critical_angle(n_i, n_t.re) } else { None };
    let exact_curve = match critical {
        Some(critical) => over_angle_near(critical.to_degrees(), exact),
        None => over_angle(exact),
    };
    let least = if r_0 > 0.5 { 0.6 } else { 0.0 };
    let mut chart = Chart::new(
        title,
        Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
        Axis::linear("reflectance R_n", "").range(least, 1.0),
    )
    .line(Hue::Natural, "exact", exact_curve)
    .dashed(Hue::Textbook, "Schlick", over_angle(|incidence| schlick(incidence.cos(), r_0)));
    if let Some(critical) = critical {
        let rarer = over_angle_near(critical.to_degrees(), |i| schlick_rarer_side(i.cos(), n_i, n_t.re));
        chart = chart.dashed(Hue::Ours, "Schlick, rarer side", rarer);
    }
    if n_t.im > 0.0 {
        let dipped = Dipped::new(r_0, exact(Incidence::from_cos(Dipped::COS)));
        chart = chart.dashed(Hue::Ours, "with a dip at 82°", over_angle(|i| dipped.reflectance(i.cos())));
    }
    chart.into()
}
