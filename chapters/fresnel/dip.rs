//! C11, second half: reflectance does not always rise with the angle.

use super::amplitudes::contrast;
use super::symbols::{N_1, N_2, N_REL, R_N, THETA_1, THETA_2};
use super::{INTERFACE, golden_section, interface};
use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Question, Step, check, derivation, exhibit, figure, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::{cos, d, ratio, sqrt};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::optics::fresnel::{Dip, Powers, dip, powers};
use light::optics::{Direction, Incidence};
use light::references::fresnel::{Exact, Input, NAMES};
use std::f64::consts::FRAC_PI_2;
use yardstick::precise::{self, Real};

const X: Symbol = Symbol::scalar("x", Dimension::ONE).within(1.5, 3.0);
const X_DIP: Symbol = Symbol::scalar("x_d", Dimension::ONE).within(4.0, 9.0);
const R_MIN: Symbol = Symbol::scalar("R_d", Dimension::ONE);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "dip",
    INTERFACE,
    &[figure(
        "curves",
        "R_n relative to normal incidence: below 2+√3 it only rises, above it dips first; metals may do so too. Rings: the least, by its closed form.",
        dips,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Where reflectance falls first",
    "Above n₂/n₁ = 2+√3, or from inside below 2−√3, natural light is reflected least at an oblique angle.",
)
.rows(&["C11"])
.about("place")
.statements(&[
    statement("least_index", "the least relative index that dips", || {
        Equation::new(N_REL.pow(2) - 4 * N_REL + 1, Expr::from(0))
    }),
    statement("place", "the dip, where x = n₂cosθ₂/(n₁cosθ₁) and n = n₂/n₁", || {
        Equation::new(X_DIP + N_REL.pow(2) / X_DIP, sum_at_the_dip())
    }),
    statement("depth", "its value", || Equation::new(R_MIN, depth())),
])
.questions(&[RADIO])
.derivations(&[
    derivation("in_one_variable", "R_n from E35 and E38, with x for both cosines and n for both indices", || {
        in_one_variable(natural(&X.into()))
    })
    .slip("x upside down", || in_one_variable(natural(&(1 / X)))),
    derivation("symmetry", "n²/x for x exchanges s and p, so R_n is level at x = n: at normal incidence", || {
        symmetry(N_REL.pow(2) / X)
    })
    .slip("n for n²", || symmetry(N_REL / X)),
    derivation("stationary", "dR_n/dx vanishes at normal incidence, x² = n², and at the dip", || stationary(6))
        .slip("4n² for 6n²", || stationary(4)),
    derivation(
        "threshold_from_place",
        "the dip parts from normal incidence where its x is n: the two sides of its equation are equal there",
        || at_normal((N_REL + 1).pow(2)),
    )
    .slip("n − 1 for n + 1", || at_normal((N_REL - 1).pow(2))),
    derivation("two_plus_root_three", "the least index that dips, and from inside its inverse", || {
        by_its_roots(2 + root_of_three())
    })
    .slip("1 + √3 for 2 + √3", || by_its_roots(1 + root_of_three())),
    derivation("at_the_dip", "R_n at the dip's x", || at_the_dip(depth()))
        .slip("n² + 1 for n² − 1", || at_the_dip(ratio(1, 2) - 2 * N_REL.pow(2) / (N_REL.pow(2) + 1).pow(2))),
])
.readout(readout)
.checks(&[&THRESHOLD, &FLAT, &PLACE_AND_DEPTH, &METALS]);

const RADIO: Question = question(
    "radio",
    "For radio waves water has n = 9. From the normal to grazing, how does R_n run, the reflectance of s and p \
     together?",
    Answer::Trend {
        replies: [
            "At grazing incidence everything is a mirror: the curve ends at 1.",
            "Near the normal it does, nearly: what s gains p loses. Not further on.",
            "So it is with s alone, and with both below n = 2 + √3. At high indices p falls faster than s can rise.",
            "p falls before it rises, and at a high index it takes the mean with it.",
            "At grazing incidence everything is a mirror: the curve ends at its highest.",
        ],
        right: |_, at| radio_waves(at).r_n(),
        slip: |_, at| radio_waves(at).r_s,
    },
    "It falls first, from 0.64 to 0.47, and climbs to 1 at grazing. *Reflectance rises with the angle* is true of \
     glass, not of every medium.",
);

/// What water reflects of radio waves, at a share of a right angle.
fn radio_waves(at: f64) -> Powers {
    powers(Incidence::from_angle(at * FRAC_PI_2), 1.0, 9.0.into())
}

fn depth() -> Expr {
    ratio(1, 2) - 2 * N_REL.pow(2) / (N_REL.pow(2) - 1).pow(2)
}

/// R_n as a function of x: r_s = (1 − x)/(1 + x), r_p = (n² − x)/(n² + x).
fn natural(x: &Expr) -> Expr {
    let square = N_REL.pow(2);
    ratio(1, 2) * (((1 - x) / (1 + x)).pow(2) + ((&square - x) / (&square + x)).pow(2))
}

/// What x + n²/x is at the dip.
fn sum_at_the_dip() -> Expr {
    (N_REL.pow(4) - 6 * N_REL.pow(2) + 1) / (N_REL.pow(2) + 1)
}

fn in_one_variable(last: Expr) -> Chain {
    let s = contrast(N_1 * cos(THETA_1), N_2 * cos(THETA_2));
    let p = contrast(N_2 * cos(THETA_1), N_1 * cos(THETA_2));
    Chain::new(ratio(1, 2) * (s.pow(2) + p.pow(2)))
        .because("E42 with the ratios that E35 and E38 give")
        .given(N_2, N_REL * N_1, "n = n₂/n₁")
        .given(cos(THETA_2), X * cos(THETA_1) / N_REL, "x = n₂cosθ₂/(n₁cosθ₁)")
        .then(last, ["n = n₂/n₁", "x = n₂cosθ₂/(n₁cosθ₁)", "cancel n₁ cos θ₁"])
}

fn symmetry(image: Expr) -> Chain {
    let x = Expr::from(X);
    let square = N_REL.pow(2);
    Chain::new(natural(&image))
        .then(ratio(1, 2) * (((&x - &square) / (&x + &square)).pow(2) + ((&x - 1) / (&x + 1)).pow(2)), ["cancel n²/x"])
        .then(natural(&x), ["order"])
}

/// What is zero at the dip; `middle` is what −n² is multiplied with.
fn dip_factor(x: &Expr, middle: i32) -> Expr {
    let square = N_REL.pow(2);
    (&square + 1) * (x.pow(2) + &square) - (N_REL.pow(4) - middle * square + 1) * x
}

/// The derivative of R_n by its factors.
fn stationary(middle: i32) -> Chain {
    let square = N_REL.pow(2);
    Chain::new(d(R_N) / d(X))
        .given(R_N, natural(&X.into()), "E42")
        .then(
            2 * (X - 1) / (X + 1).pow(3) + 2 * &square * (X - &square) / (X + &square).pow(3),
            ["derivative of a square", "derivative of a quotient"],
        )
        .then(
            2 * (X.pow(2) - &square) * dip_factor(&X.into(), middle) / ((X + 1).pow(3) * (X + &square).pow(3)),
            ["common denominator", "factor x² − n²"],
        )
}

/// The dip's equation at x = n.
fn at_normal(factor: Expr) -> Chain {
    Chain::new(sum_at_the_dip() - (X + N_REL.pow(2) / X))
        .because("what the dip's x makes zero")
        .given(X, N_REL, "normal incidence")
        .then(
            (N_REL.pow(4) - 2 * N_REL.pow(3) - 6 * N_REL.pow(2) - 2 * N_REL + 1) / (N_REL.pow(2) + 1),
            ["x = n", "common denominator"],
        )
        .then((N_REL.pow(2) - 4 * N_REL + 1) * factor / (N_REL.pow(2) + 1), ["factor (n + 1)²"])
}

fn root_of_three() -> Expr {
    sqrt(Expr::from(3))
}

/// The quadratic of the threshold by its roots, `root` and 1/`root`.
fn by_its_roots(root: Expr) -> Chain {
    Chain::new(N_REL.pow(2) - 4 * N_REL + 1)
        .then((N_REL - 2).pow(2) - 3, ["complete the square"])
        .then((N_REL - (2 + root_of_three())) * (N_REL - (2 - root_of_three())), ["difference of squares"])
        .then((N_REL - &root) * (N_REL - 1 / &root), ["(2 + √3)(2 − √3) = 1"])
}

/// The larger root of the quadratic that the place is given by.
fn at_the_dip(last: Expr) -> Chain {
    let sum = sum_at_the_dip();
    let place = (&sum + sqrt(sum.pow(2) - 4 * N_REL.pow(2))) / 2;
    Chain::new(Equation::new(dip_factor(&X_DIP.into(), 6), 0))
        .because("the second factor of dR_n/dx, at the larger root")
        .given(X_DIP, place, "quadratic formula")
        .then(Equation::new(X_DIP + N_REL.pow(2) / X_DIP, sum), ["divide by x (n² + 1)"])
        .then(Equation::new(natural(&Expr::from(X_DIP)), last), ["quadratic formula", "clear the root"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let input = interface(setting);
    let normal = powers(Incidence::NORMAL, input.n_i, input.n_t).r_n();
    let (theta, least) = least(input.n_i, input.n_t);
    let all = [
        ("R_0", "R_0", "R_n at normal incidence", normal, "1"),
        ("R_min", "R_{min}", "its least value over all angles", least, "1"),
        ("theta_min", "θ_{min}", "where that is", theta, "rad"),
    ];
    all.map(|(key, symbol, says, value, unit)| Quantity { key, symbol, says, value, unit }).into()
}

/// Place [rad] and value of the least R_n, by search.
fn least(n_i: f64, n_t: Complex64) -> (f64, f64) {
    let natural = |theta: f64| powers(Incidence::from_angle(theta), n_i, n_t).r_n();
    // Within √ulp of normal incidence the curve is flat to rounding: the search starts from the best of a fan.
    let step = FRAC_PI_2 / 400.0;
    let best =
        (0..400).map(|at| f64::from(at) * step).min_by(|a, b| natural(*a).total_cmp(&natural(*b))).unwrap_or(0.0);
    if best == 0.0 {
        return (0.0, natural(0.0));
    }
    let theta = golden_section(natural, best - step, (best + step).min(FRAC_PI_2));
    (theta, natural(theta))
}

/// R_n in arbitrary precision at the angle `theta`, clear media.
fn exact(theta: f64, n: f64) -> Real {
    let at = NAMES.iter().position(|name| *name == "R_n").expect("an output");
    Exact::new(&Input { direction: Direction::Angle(theta), n_i: 1.0, n_t: n.into() }).outputs[at].clone()
}

const SMALL: f64 = 1e-10;

const THRESHOLD: Check<fn(f64) -> bool> =
    check("threshold", "the dip begins at n₂/n₁ = 2+√3 into a medium, 2−√3 out of it")
        .against("bisection for the index at which R_n(1e−10) − R_n(0) changes sign, in 256-bit arithmetic")
        .within(1e-14, "1", "bisection to rounding; the finite angle moves it by 1e−20")
        .of(threshold, |n| dip(n).is_some())
        .slip("−1 for +1 in n² − 4n + 1", |n| n * n - 4.0 * n - 1.0 > 0.0);

/// Distance between where the program's closed form begins to dip and where R_n itself does; and that the former is
/// 2 ± √3.
fn threshold(_: &mut Bench, dips: fn(f64) -> bool) -> Measured {
    let bisect = |rises: &dyn Fn(f64) -> bool, mut rising: f64, mut falling: f64| {
        for _ in 0..60 {
            let middle = 0.5 * (rising + falling);
            *(if rises(middle) { &mut rising } else { &mut falling }) = middle;
        }
        0.5 * (rising + falling)
    };
    let (truly, claimed) = (|n: f64| exact(SMALL, n) > exact(0.0, n), |n: f64| !dips(n));
    let ends = [(2.0, 6.0, 2.0 + 3f64.sqrt(), "into the medium"), (0.5, 0.2, 2.0 - 3f64.sqrt(), "out of it")];
    Measured::worst(ends.into_iter().flat_map(|(rising, falling, closed, name)| {
        let (found, told) = (bisect(&truly, rising, falling), bisect(&claimed, rising, falling));
        [(found - told, format!("{name}, the program")), (found - closed, format!("{name}, 2 ± √3"))]
    }))
}

const FLAT: Check<&'static str> =
    check("flat", "near normal incidence the θ² terms of R_s and R_p cancel: R_n = R₀ + O(θ⁴)")
        .against("order of R_n(θ) − R₀ between θ = 1e−6 and 1e−10 in 256-bit arithmetic")
        .order(4.0, 1e-6, "the next term is θ², 1e−12 at most")
        .of(order_at_normal, "R_n")
        .slip("R_s alone, whose θ² term stays", "R_s");

fn order_at_normal(_: &mut Bench, name: &str) -> Measured {
    let at = NAMES.iter().position(|known| *known == name).expect("an output");
    let rise = |theta: f64, n: f64| {
        let value = |theta| {
            Exact::new(&Input { direction: Direction::Angle(theta), n_i: 1.0, n_t: n.into() }).outputs[at].clone()
        };
        precise::to_f64(&(value(theta) - value(0.0))).abs()
    };
    let orders = [1.33, 1.5, 2.4, 4.0, 0.8].map(|n| ((rise(1e-6, n) / rise(1e-10, n)).log10() / 4.0, n));
    let farthest = orders.into_iter().max_by(|a, b| (a.0 - 4.0).abs().total_cmp(&(b.0 - 4.0).abs()));
    farthest.map_or_else(|| Measured::worst([]), |(order, n)| Measured::new(order, format!("n = {n}"), orders.len()))
}

const PLACE_AND_DEPTH: Check<fn(f64) -> Option<Dip>> =
    check("place_and_depth", "the dip lies where the closed form says, as deep as ½ − 2n²/(n²−1)²")
        .against("golden-section search over the angle")
        .within(
            1e-6,
            "1",
            "the place of a flat minimum is known to the root of an ulp over the curvature; the depth, to rounding",
        )
        .of(dip_found, dip)
        .slip("n² + 1 for n² − 1 in the depth", |n| {
            dip(n).map(|dip| Dip { r_n: 0.5 - 2.0 * n * n / ((n * n + 1.0) * (n * n + 1.0)), ..dip })
        });

fn dip_found(_: &mut Bench, closed: fn(f64) -> Option<Dip>) -> Measured {
    Measured::worst([4.5, 5.0, 6.0, 10.0, 0.2, 0.1].into_iter().flat_map(|n: f64| {
        let (theta, value) = least(1.0, n.into());
        let closed = closed(n).unwrap_or(Dip { theta: f64::NAN, r_n: f64::NAN });
        [(theta - closed.theta, format!("place, n = {n}")), (value - closed.r_n, format!("depth, n = {n}"))]
    }))
}

const METALS: Check<fn(&Powers) -> f64> =
    check("metals", "metals dip too: R_n of aluminium and chromium is less at some angle than along the normal")
        .against("the least over a fan of angles against normal incidence, from the published indices at 550 nm")
        .within(1.0, "R_n(0°)", "to dip is to fall below the value that it starts from; what only rises stays above")
        .of(dip_of_metals, |powers| powers.r_n())
        .slip("s alone, which only rises", |powers| powers.r_s);

fn dip_of_metals(_: &mut Bench, share: fn(&Powers) -> f64) -> Measured {
    Measured::worst(["aluminium", "chromium"].into_iter().map(|name| {
        let index = light::media::named(name).and_then(|material| material.index(550e-9).ok());
        let index = index.unwrap_or(Complex64::new(f64::NAN, 0.0));
        let at = |degrees: u32| share(&powers(Incidence::from_angle(f64::from(degrees).to_radians()), 1.0, index));
        let least = (1..90).map(at).fold(f64::INFINITY, |least, share| if share < least { share } else { least });
        (least / at(0), name.to_owned())
    }))
}

fn dips(setting: &Setting) -> Plot {
    let axes = |title: &str| {
        Chart::new(
            title,
            Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
            Axis::linear("R_n / R_n(0)", "").range(0.6, 1.5),
        )
        .at_y(1.0, "")
    };
    let relative = |n_i: f64, n_t: Complex64| {
        let normal = powers(Incidence::NORMAL, n_i, n_t).r_n();
        super::over_angle(move |incidence| powers(incidence, n_i, n_t).r_n() / normal)
    };
    let mut clear = axes("clear media, n_2/n_1");
    let mut lowest = Vec::new();
    for (at, n) in [1.5, 2.4, 2.0 + 3f64.sqrt(), 5.0, 7.0, 12.0].into_iter().enumerate() {
        let label = if at == 2 { "2+√3".to_owned() } else { format!("{n}") };
        clear = clear.line(Hue::Nth(at as u8), label, relative(1.0, n.into()));
        let normal = powers(Incidence::NORMAL, 1.0, n.into()).r_n();
        lowest.extend(dip(n).map(|dip| [dip.theta.to_degrees(), dip.r_n / normal]));
    }
    let clear = clear.with(Mark::Points {
        label: "least".into(),
        hue: Hue::Reference,
        shape: Shape::Ring,
        joined: false,
        points: lowest,
    });
    let own = interface(setting);
    let mut absorbing = axes("absorbing media at 550 nm");
    for (at, name) in ["gold", "aluminium", "chromium", "silicon"].into_iter().enumerate() {
        let medium = light::media::named(name).and_then(|material| material.index(550e-9).ok());
        if let Some(index) = medium {
            absorbing = absorbing.line(Hue::Nth(at as u8), name, relative(1.0, index));
        }
    }
    let absorbing = absorbing.dashed(Hue::Natural, super::own_media(setting), relative(own.n_i, own.n_t));
    Plot::grid("Reflectance of natural light relative to normal incidence", 2, vec![clear.into(), absorbing.into()])
}
