//! What could refute it.

use super::super::symbols::{R_0, THETA_1};
use super::super::{interface, sample_media};
use super::fifth_power;
use crate::vocabulary::{ALLOWED_ULPS, Bench, Check, Measured, check};
use equation::Expr;
use equation::expr::cos;
use equation::value::Bindings;
use light::Complex64;
use light::media;
use light::optics::Incidence;
use light::optics::fresnel::powers;
use light::optics::schlick::{Dipped, normal_reflectance, schlick, schlick_rarer_side};
use yardstick::precise;
use yardstick::random::uniform;

pub(super) const AS_WRITTEN: Check<fn() -> Expr> =
    check("as_written", "the program's approximation is the equation on the page")
        .against("the equation above, as the object on the page, in 256-bit arithmetic")
        .within(
            ALLOWED_ULPS,
            "ulp",
            "ten operations on positive numbers; only 1 − cos θ subtracts, and cos θ is exact here",
        )
        .of::<fn() -> Expr>(|bench, equation| against_equation(bench, &equation()), || fifth_power(cos(THETA_1)))
        .slip("the fourth power", || R_0 + (1 - R_0) * (1 - cos(THETA_1)).pow(4));

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

pub(super) const ENDS: Check<fn(f64, f64) -> f64> =
    check("both_ends", "the approximation is exact along the normal and at grazing incidence, metals included")
        .against("the exact R_n")
        .within(16.0, "ulp", "a few roundings of numbers below 1, at cos θ = 1 and at cos θ = 0 themselves")
        .of(at_both_ends, schlick)
        .slip("the factor 1 − R₀ is forgotten", |cos_i, r_0| r_0 + (1.0 - cos_i).powi(5));

fn at_both_ends(bench: &mut Bench, approximate: fn(f64, f64) -> f64) -> Measured {
    let own = interface(bench.setting());
    let media = sample_media().into_iter().chain([(own.n_i, own.n_t)]);
    // Equal media reflect nothing at any angle, which no Schlick can know.
    let different = media.filter(|&(n_i, n_t)| n_t != n_i.into());
    let cases = different.flat_map(|(n_i, n_t)| [1.0, 0.0].map(|cos_i| (n_i, n_t, cos_i)));
    Measured::worst(cases.map(|(n_i, n_t, cos_i)| {
        let exact = powers(Incidence::from_cos(cos_i), n_i, n_t).r_n();
        let error = approximate(cos_i, normal_reflectance(n_i, n_t)) - exact;
        (error / f64::EPSILON, format!("n {n_i} → {n_t}, cos θ = {cos_i}"))
    }))
}

pub(super) const GRAZING_SLOPE: Check<fn(f64) -> f64> = check(
    "grazing_slope",
    "at grazing incidence the approximation starts with a slope of its own, 5(1 − R₀) per cos θ",
)
.against("expansion of E36 and E39 at cos θ → 0: 1 − R_n = 2(n² + 1)/√(n² − 1) cos θ + O(cos² θ)")
.within(1e-3, "1", "cos θ = 1e−5, and the next term's factor is some tens")
.of(grazing_slope, |r_0| 5.0 * (1.0 - r_0))
.slip("the fifth power is differentiated without its factor", |_| 5.0);

/// ((Schlick − exact) − (difference of the slopes) cos θ)/cos θ near grazing, with Schlick's slope from `slope`.
fn grazing_slope(_: &mut Bench, slope: fn(f64) -> f64) -> Measured {
    let cos_i = 1e-5;
    Measured::worst(GLASSES.map(|n| {
        let r_0 = normal_reflectance(1.0, n.into());
        let exact = powers(Incidence::from_cos(cos_i), 1.0, n.into()).r_n();
        let wedge = 2.0 * (n * n + 1.0) / (n * n - 1.0).sqrt() - slope(r_0);
        ((schlick(cos_i, r_0) - exact) / cos_i - wedge, format!("n = {n}"))
    }))
}

/// How far Schlick is from R_n of glass of index 1.5 at most, in shares of R_n (N. Chapman, *Fresnel and Schlick*,
/// forwardscattering.org/post/65: 23.2 %).
pub(super) const GLASS_ERROR: f64 = 0.232;

pub(super) const GLASS: Check<fn(f64, f64) -> f64> =
    check("glass_in_air", "for glass in air the approximation is off by 23.2 % of R_n at most")
        .against(
            "the published maximum for n = 1.5 (N. Chapman, forwardscattering.org/post/65); every quarter of a degree",
        )
        .within(0.000_6, "1", "the maximum is printed to 0.001, and the angles beside it miss it by less than 1e−4")
        .of(for_glass, schlick)
        .slip("the fourth power", |cos_i, r_0| r_0 + (1.0 - r_0) * (1.0 - cos_i).powi(4));

/// Indices of water, crown glass, flint and dense flint.
const GLASSES: [f64; 4] = [1.333, 1.5, 1.6, 1.78];

fn for_glass(_: &mut Bench, approximate: fn(f64, f64) -> f64) -> Measured {
    let r_0 = normal_reflectance(1.0, 1.5.into());
    let worst = Measured::worst(cosines().map(|cos_i| {
        let exact = powers(Incidence::from_cos(cos_i), 1.0, 1.5.into()).r_n();
        (approximate(cos_i, r_0) / exact - 1.0, format!("cos θ = {cos_i:.4}"))
    }));
    Measured { value: (worst.value - GLASS_ERROR).abs(), ..worst }
}

/// Cosines of angles a quarter of a degree apart.
fn cosines() -> impl Iterator<Item = f64> {
    (0..360).map(|quarter| (f64::from(quarter) / 4.0).to_radians().cos())
}

pub(super) const INSIDE: Check<fn(f64, f64, f64) -> f64> = check(
    "from_inside",
    "from inside glass the rarer side's cosine makes the same error as from outside, and none beyond the critical angle",
)
.against("Schlick and the exact R_n from outside, at the angle that Snell's law joins")
.within(
    64.0,
    "ulp/cos θ₂",
    "R_n is the same from both sides; by Snell's law a rounding of cos θ₁ is n²cos θ₁/cos θ₂ of them in the refracted cosine, \
     times a slope of R_n of six or less",
)
.of(from_inside, schlick_rarer_side)
.slip("cos θ₁ is used in the denser medium", |cos_i, n_i, n_t| schlick(cos_i, normal_reflectance(n_i, n_t.into())));

/// Error from inside less that from outside, at angles given outside, where each has one inside; and what is missing to
/// 1 beyond the critical one.
fn from_inside(_: &mut Bench, approximate: fn(f64, f64, f64) -> f64) -> Measured {
    let r_n = |cos_i, n_i, n_t: f64| powers(Incidence::from_cos(cos_i), n_i, n_t.into()).r_n();
    Measured::worst(GLASSES.into_iter().flat_map(|n| {
        let critical = ((n - 1.0) * (n + 1.0)).sqrt() / n;
        let joined = cosines().map(move |outside| {
            let inside = critical.hypot(outside / n);
            let there = schlick(outside, normal_reflectance(1.0, n.into())) - r_n(outside, 1.0, n);
            let here = approximate(inside, n, 1.0) - r_n(inside, n, 1.0);
            ((here - there) * outside / f64::EPSILON, format!("n {n} → 1, cos θ₂ = {outside:.4}"))
        });
        let beyond = [0.0, 0.3, 0.6].map(|share| {
            let missing = 1.0 - approximate(share * critical, n, 1.0);
            (missing / f64::EPSILON, format!("n {n} → 1, cos θ₁ = {:.4}", share * critical))
        });
        joined.chain(beyond)
    }))
}

pub(super) const METALS: Check<fn(f64, f64) -> f64> = check(
    "metals",
    "one more reflectance, at 82°, bends the approximation through the metal's own, and keeps both ends",
)
.against("the exact R_n of gold, silver, copper, aluminium and chromium over the visible at 0°, 82° and 90°")
.within(16.0, "ulp", "a dozen roundings of numbers below 1: it has three numbers to choose and chooses these")
.of(for_metals, |_, r_82| r_82)
.slip("Schlick's own value at 82° is taken for the metal's", |r_0, _| schlick(Dipped::COS, r_0));

fn for_metals(_: &mut Bench, at_82: fn(f64, f64) -> f64) -> Measured {
    let metals = ["gold", "silver", "copper", "aluminium", "chromium"];
    let wavelengths = [400e-9, 450e-9, 500e-9, 550e-9, 600e-9, 650e-9, 700e-9];
    let cases = metals.into_iter().flat_map(|name| wavelengths.map(|wavelength| (name, wavelength)));
    Measured::worst(cases.flat_map(|(name, wavelength)| {
        let index = media::named(name).and_then(|metal| metal.index(wavelength).ok());
        let n_t = index.unwrap_or(Complex64::new(f64::NAN, 0.0));
        let exact = |cos_i| powers(Incidence::from_cos(cos_i), 1.0, n_t).r_n();
        let r_0 = normal_reflectance(1.0, n_t);
        let dipped = Dipped::new(r_0, at_82(r_0, exact(Dipped::COS)));
        [1.0, Dipped::COS, 0.0].map(|cos_i| {
            let place = format!("{name}, {:.0} nm, cos θ = {cos_i:.4}", wavelength * 1e9);
            ((dipped.reflectance(cos_i) - exact(cos_i)) / f64::EPSILON, place)
        })
    }))
}
