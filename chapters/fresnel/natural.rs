//! E42: natural light.

use super::amplitudes::{r_p, r_s};
use super::extremes::cases;
use super::symbols::{R_N, THETA_1, THETA_2};
use super::{INTERFACE, hemisphere, incidence, interface, over_angle, over_angle_near, sample_inputs};
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Heat, Measured, Misled, Quantity, Question, Race, Step, check, derivation, exhibit,
    figure, lane, question, race, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{cos, integral_between, pi, ratio, sin, tan};
use equation::{Dimension, Equation, Expr, Symbol};
use light::optics::fresnel::{
    Amplitudes, amplitudes, brewster_angle, critical_angle, diffuse_reflectance, natural_reflectance, powers,
};
use light::optics::{Direction, Incidence};
use light::references::fresnel::Input;
use std::f64::consts::TAU;
use yardstick::quadrature::gauss_legendre;
use yardstick::random::uniform;

const R_S: Symbol = Symbol::scalar("R_s", Dimension::ONE);
const R_P: Symbol = Symbol::scalar("R_p", Dimension::ONE);

pub(super) const EXHIBIT: Exhibit = exhibit(
    "natural",
    INTERFACE,
    &[figure("against_angle", "R_s, R_p, R_n and T_n against the angle, into the medium and out of it.", reflectance)],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Natural light",
    "Light of every polarisation at once reflects as the mean of s and p: powers are averaged, not fields.",
)
.rows(&["E42"])
.statements(&[statement("reflectance", "reflected share of natural light", || Equation::new(R_N, natural()))])
.questions(&[MEAN_OF_POWERS])
.derivations(&[derivation("mean", "the mean over all directions of vibration, with E36 and E39", || mean(natural()))
    .slip("the mean of the fields, squared", || {
        mean(
            ((tan(THETA_1 - THETA_2) / tan(THETA_1 + THETA_2) - sin(THETA_1 - THETA_2) / sin(THETA_1 + THETA_2)) / 2)
                .pow(2),
        )
    })])
.readout(|setting| {
    let input = interface(setting);
    let powers = powers(incidence(setting), input.n_i, input.n_t);
    vec![
        Quantity {
            key: "R_n",
            symbol: "R_n",
            says: "reflected share of natural light",
            value: powers.r_n(),
            unit: "1",
        },
        Quantity { key: "T_n", symbol: "T_n", says: "transmitted share", value: powers.t_n(), unit: "1" },
        Quantity {
            key: "polarisation",
            symbol: "(R_s−R_p)/(R_s+R_p)",
            says: "degree of polarisation of the reflected light",
            value: (powers.r_s - powers.r_p) / (powers.r_s + powers.r_p),
            unit: "1",
        },
    ]
})
.checks(&[&EVERY_AZIMUTH, &WALSH, &hemisphere::MEAN, &hemisphere::ANGLES])
.stress(&[stress(
    "normal_and_alike",
    "R_n keeps its digits at normal incidence and between nearly equal media",
    |setting| {
        let clear = |direction, n_i: f64, n_t: f64| Input { direction, n_i, n_t: n_t.into() };
        let inputs = [
            interface(setting),
            clear(Direction::Angle(0.0), 1.0, 1.5),
            clear(Direction::Cos(1.0 - 1e-16), 1.0, 1.5),
            clear(Direction::Angle(0.5), 1.0, 1.0 + 1e-9),
            clear(Direction::Angle(0.5), 1.0, 1.0 + 1e-15),
            clear(Direction::Grazing(1e-6), 1.0, 1.0 + 1e-12),
            clear(Direction::Angle(0.5), 1.5, 1.5 - 1e-12),
        ];
        cases(&["R_n"], &inputs)
    },
)
.textbook("½[sin²(θ₁−θ₂)/sin²(θ₁+θ₂) + tan²(θ₁−θ₂)/tan²(θ₁+θ₂)]")
.against("256 bits")])
.races(&[HEMISPHERE]);

const MEAN_OF_POWERS: Question = question(
    "mean_of_powers",
    "Natural light falls on glass of n = 1.5 at Brewster's angle, where r_s = −0.385 and r_p = 0. Which share of \
     its power comes back?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| at_brewster().1,
        slips: &[
            Misled {
                value: |_| (0.5 * at_brewster().0).powi(2),
                reply: "The mean of the fields, squared. s and p of natural light keep no step; their powers add, \
                 not their fields.",
            },
            Misled { value: |_| at_brewster().0.powi(2), reply: "That is R_s. Half of natural light is p." },
            Misled {
                value: |_| 0.5 * at_brewster().0.abs(),
                reply: "A mean of amplitudes; power goes as their \
             squares.",
            },
        ],
    },
    "0.074, half of R_s: powers are averaged, not fields.",
);

/// r_s and R_n of glass in air at Brewster's angle.
fn at_brewster() -> (f64, f64) {
    let incidence = Incidence::from_angle(brewster_angle(1.0, 1.5));
    (amplitudes(incidence, 1.0, 1.5.into()).r_s.re, powers(incidence, 1.0, 1.5.into()).r_n())
}

fn natural() -> Expr {
    let (sum, difference) = (THETA_1 + THETA_2, THETA_1 - THETA_2);
    ratio(1, 2) * (sin(&difference).pow(2) / sin(&sum).pow(2) + tan(&difference).pow(2) / tan(&sum).pow(2))
}

/// The direction of vibration, from that of p.
const AZIMUTH: Symbol = Symbol::scalar("psi", Dimension::ONE);

fn mean(last: Expr) -> Chain {
    let turned = R_P * cos(AZIMUTH).pow(2) + R_S * sin(AZIMUTH).pow(2);
    let ripple = sin(2 * AZIMUTH) / 4;
    Chain::new(1 / (2 * pi()) * integral_between(turned, AZIMUTH, 0, 2 * pi()))
        .because("the mean over every direction of vibration: E cos ψ in p, E sin ψ in s")
        .primitive(R_P * (AZIMUTH / 2 + &ripple) + R_S * (AZIMUTH / 2 - ripple), AZIMUTH)
        .given(R_S, r_s().pow(2), "E36")
        .given(R_P, r_p().pow(2), "E39")
        .then(ratio(1, 2) * (R_S + R_P), ["the mean of cos² and of sin² is ½"])
        .then(last, ["E41: R = r²", "E36", "E39"])
}

const EVERY_AZIMUTH: Check<fn(&Amplitudes, f64, f64) -> f64> =
    check("every_azimuth", "R_n is the mean over all directions of polarisation")
        .against("fields polarised at 16 azimuths, each split into s and p, reflected, and its power summed")
        .within(16.0, "ulp", "the trapezoid rule is exact for cos², so only rounding is left")
        .of(over_azimuths, |a, cos, sin| (a.r_s * cos).norm_sqr() + (a.r_p * sin).norm_sqr())
        .slip("the fields of s and p are added although they stand at right angles", |a, cos, sin| {
            (a.r_s * cos + a.r_p * sin).norm_sqr()
        });

fn over_azimuths(bench: &mut Bench, power: fn(&Amplitudes, f64, f64) -> f64) -> Measured {
    const AZIMUTHS: u32 = 16;
    Measured::worst(sample_inputs(bench.setting()).into_iter().map(|input| {
        let incidence = Incidence::from(input.direction);
        let a = amplitudes(incidence, input.n_i, input.n_t);
        // A quarter turn: the mean of cos² over it is that over the whole.
        let azimuths = (0..AZIMUTHS).map(|at| (f64::from(at) + 0.5) / f64::from(AZIMUTHS) * TAU / 4.0);
        let mean = azimuths.map(|azimuth| power(&a, azimuth.cos(), azimuth.sin())).sum::<f64>() / f64::from(AZIMUTHS);
        let difference = mean - powers(incidence, input.n_i, input.n_t).r_n();
        (difference / f64::EPSILON, super::extremes::describe(&input))
    }))
}

const WALSH: Check<fn(f64) -> f64> =
    check("diffuse", "under an even sky the interface reflects what Walsh's closed form says")
        .against("64-point Gauss–Legendre quadrature of R_n over the hemisphere against Walsh's closed form of 1926")
        .within(1e-12, "1", "the quadrature converges geometrically; the closed form's terms reach 100 and cancel")
        .of(against_walsh, |cos| 2.0 * cos)
        .slip("the cosine of the even sky is forgotten", |_| 1.0);

fn against_walsh(_: &mut Bench, weight: fn(f64) -> f64) -> Measured {
    let rule = gauss_legendre(64);
    Measured::worst([1.2, 1.33, 1.5, 1.8, 2.4, 4.0].map(|n| {
        let mean: f64 = rule.iter().map(|&(cos, w)| w * weight(cos) * single(cos, n)).sum();
        (mean - diffuse_reflectance(n), format!("n = {n}"))
    }))
}

fn single(cos: f64, n: f64) -> f64 {
    let mut out = [0.0];
    natural_reflectance(&[cos], 1.0, n, &mut out);
    out[0]
}

/// The relative index of the race.
const GLASS: f64 = 1.5;

const HEMISPHERE: Race =
    race("hemisphere", "the mean reflectance under an even sky: what a smooth rule gains over dice")
        .work("evaluations of R_n")
        .error("relative error of the mean R_n", "relative error against Walsh's closed form, n = 1.5")
        .lanes(&[
            lane("monte_carlo", "Monte Carlo", &[16, 64, 256, 1024, 4096, 16384], |bench, work| {
                let cosines: Vec<f64> = (0..work).map(|_| uniform(&mut bench.stream, 0.0, 1.0)).collect();
                even(cosines)
            })
            .repeated(32)
            .order(0.5, 0.15),
            lane("golden_ratio", "golden-ratio sequence", &[16, 64, 256, 1024, 4096, 16384], |bench, work| {
                // Weyl's sequence of the golden ratio from a random start (Cranley–Patterson rotation).
                let start = uniform(&mut bench.stream, 0.0, 1.0);
                let golden = 0.5 * (5f64.sqrt() - 1.0);
                even((0..work).map(|at| (start + at as f64 * golden).fract()).collect())
            })
            .repeated(32)
            .order(1.0, 0.35),
            lane("midpoint", "midpoint rule", &[8, 32, 128, 512, 2048, 8192], |_, work| {
                even((0..work).map(|at| (at as f64 + 0.5) / work as f64).collect())
            })
            .order(2.0, 0.2),
            lane("gauss", "Gauss–Legendre", &[4, 6, 8, 12, 16, 32], |_, work| mean_of(gauss_legendre(work as usize)))
                .within(2e-3, "four points already do what thousands of dice do"),
        ]);

fn even(cosines: Vec<f64>) -> Heat {
    let weight = 1.0 / cosines.len() as f64;
    mean_of(cosines.into_iter().map(|cos| (cos, weight)).collect())
}

/// Σ w 2 cos θ R_n(cos θ), timed; its relative error against Walsh, not timed.
fn mean_of(rule: Vec<(f64, f64)>) -> Heat {
    let (cosines, weights): (Vec<f64>, Vec<f64>) = rule.into_iter().unzip();
    let mut values = vec![0.0; cosines.len()];
    Heat {
        run: Box::new(move || {
            natural_reflectance(&cosines, 1.0, GLASS, &mut values);
            vec![
                cosines
                    .iter()
                    .zip(&weights)
                    .zip(&values)
                    .map(|((cos, weight), value)| weight * 2.0 * cos * value)
                    .sum(),
            ]
        }),
        error: Box::new(|mean| (mean[0] / diffuse_reflectance(GLASS) - 1.0).abs()),
    }
}

fn reflectance(setting: &Setting) -> Plot {
    let input = interface(setting);
    let panel = |n_i: f64, n_t: light::Complex64| {
        let clear = n_t.im == 0.0;
        let critical = if clear { critical_angle(n_i, n_t.re) } else { None };
        let curve = |share: fn(&light::optics::fresnel::Powers) -> f64| {
            let value = |incidence| share(&powers(incidence, n_i, n_t));
            critical.map_or_else(|| over_angle(value), |angle| over_angle_near(angle.to_degrees(), value))
        };
        let mut chart = Chart::new(
            super::media(n_i, n_t),
            Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
            Axis::share("share of the power"),
        )
        .line(Hue::S, "R_s", curve(|p| p.r_s))
        .line(Hue::P, "R_p", curve(|p| p.r_p))
        .line(Hue::Natural, "R_n", curve(|p| p.r_n()))
        .dashed(Hue::Transmitted, "T_n", curve(|p| p.t_n()));
        if clear && n_t.re != n_i {
            chart = chart.at_x(brewster_angle(n_i, n_t.re).to_degrees(), "θ_B");
        }
        if let Some(angle) = critical {
            chart = chart.at_x(angle.to_degrees(), "θ_c");
        }
        chart
    };
    let mut panels = vec![panel(input.n_i, input.n_t).into()];
    if input.n_t.im == 0.0 && input.n_t.re != input.n_i {
        panels.push(panel(input.n_t.re, input.n_i.into()).into());
    }
    let columns = panels.len();
    Plot::grid("Reflectance and transmittance", columns, panels)
}
