//! E33: the directions, from phase matching along the interface.

use super::symbols::{C, K, K_1, K_2, N_1, N_2, OMEGA, T, THETA_1, THETA_1R, THETA_2, V_1, V_2, X, Z};
use super::{INTERFACE, extremes, incidence};
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Question, Step, check, derivation, exhibit,
    figure, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{asin, cos, partial, pi, sin};
use equation::{Dimension, Equation, Expr, Symbol};
use glam::DVec3;
use light::Complex64;
use light::optics::fresnel::refract;
use light::optics::incidence::{mirrored, normal_squared, outgoing_root};
use light::optics::{Direction, Incidence, fresnel};
use yardstick::precise;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "snell",
    INTERFACE,
    &[
        figure(
            "geometry",
            "The three waves at the interface: their directions and wavelengths, and which way E_s and E_p count.",
            super::geometry::plot,
        ),
        figure(
            "refraction",
            "The angle of refraction against the angle of incidence, into and out of the medium.",
            refraction,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Where the waves go",
    "Along the interface all three waves keep step, and that alone fixes their directions.",
)
.rows(&["E33"])
.about("snell")
.statements(&[
    statement("reflection", "the reflected wave leaves at the angle of incidence", || Equation::new(THETA_1, THETA_1R)),
    statement("velocities", "the sines go as the phase velocities", || {
        Equation::new(sin(THETA_1) / V_1, sin(THETA_2) / V_2)
    }),
    statement("snell", "Snell's law", || Equation::new(N_1 * sin(THETA_1), N_2 * sin(THETA_2))),
])
.questions(&[INTO_GLASS])
.derivations(&[
    derivation(
        "mirror",
        "the incident and the reflected wave are in step along the interface, with the same wave number",
        || mirror(THETA_1.into(), THETA_1R.into()),
    )
    .slip("the angle to the surface for that to the normal", || mirror(THETA_1.into(), pi() / 2 - THETA_1R)),
    derivation(
        "phase_matching",
        "the incident and the transmitted wave are in step along the interface: Snell's law",
        || phase_matching(N_1 * sin(THETA_1), N_2 * sin(THETA_2)),
    )
    .slip("the indices stand on the wrong sides", || phase_matching(N_2 * sin(THETA_1), N_1 * sin(THETA_2))),
])
.readout(readout)
.checks(&[&FERMAT, &MIRROR])
.stress(&[stress(
    "refracted_cosine",
    "cos θ₂ keeps its digits at grazing incidence, near equal indices and at the critical angle",
    refracted_cosines,
)
.textbook("cos(asin(n₁ sin θ₁/n₂))")
.against("√(1 − (n₁ sin θ₁/n₂)²) in 256 bits")]);

const INTO_GLASS: Question = question(
    "into_glass",
    "Light falls from air on glass of n = 1.5, at 60° from the normal. At which angle from the normal does it go \
     on?",
    Answer::Number {
        unit: "rad",
        tolerance: 0.01,
        right: |_| {
            let (sin, cos) =
                refract(Incidence::from_angle(60f64.to_radians()), 1.0, 1.5).unwrap_or((f64::NAN, f64::NAN));
            sin.atan2(cos)
        },
        slips: &[
            Misled {
                value: |_| 40f64.to_radians(),
                reply: "60/1.5: as if angles were in the ratio of the indices. Their *sines* are, for it is along \
                 the interface that crests must meet.",
            },
            Misled {
                value: |_| (30f64.to_radians().sin() / 1.5).asin(),
                reply: "That is with the angle to the surface for the one to the normal.",
            },
            Misled {
                value: |_| 60f64.to_radians(),
                reply: "So the reflected wave leaves. Behind the interface crests are closer, and must lean to stay \
                 in step along it.",
            },
        ],
    },
    "35.3°, whose sine is sin 60°/1.5: shorter waves lean closer to the normal to keep step along the interface.",
);

/// k·r − ωt in the plane of incidence; a wave that `runs_back` from the interface has −cos θ.
fn phase(k: Symbol, angle: Symbol, runs_back: bool) -> Expr {
    let (along, across) = (X * sin(&angle), Z * cos(angle));
    let way = if runs_back { along - across } else { along + across };
    way * k - OMEGA * T
}

/// Wherever one looks along z = 0, the incident and another wave are in step: their phases change alike with x.
fn in_step(k: Symbol, angle: Symbol, runs_back: bool) -> Chain {
    let change = |phase: Expr| partial(phase, X);
    let premise = Equation::new(change(phase(K_1, THETA_1, false)), change(phase(k, angle, runs_back)));
    Chain::assume(premise, "E4 holds at every x of the interface")
}

/// k₁ sin θ₁ = k₂ sin θ₂ with k = ω/v and n = c/v.
fn phase_matching(left: Expr, right: Expr) -> Chain {
    in_step(K_2, THETA_2, false)
        .given(V_1, OMEGA / K_1, "k = ω/v")
        .given(V_2, OMEGA / K_2, "k = ω/v")
        .given(N_1, C / V_1, "n = c/v")
        .given(N_2, C / V_2, "n = c/v")
        .then(Equation::new(K_1 * sin(THETA_1), K_2 * sin(THETA_2)), ["derivative"])
        .then(Equation::new(sin(THETA_1) / V_1, sin(THETA_2) / V_2), ["k = ω/v", "divide by ω"])
        .then(Equation::new(left, right), ["n = c/v", "times c"])
}

/// The sines of the angles of incidence and reflection.
const SINES: [Symbol; 2] =
    [Symbol::scalar("s", Dimension::ONE).within(0.2, 0.9), Symbol::scalar("s'", Dimension::ONE).within(0.2, 0.9)];

/// k₁ sin θ₁ = k₁ sin θ₁′: both waves run in the same medium.
fn mirror(left: Expr, right: Expr) -> Chain {
    let [incident, reflected] = SINES;
    in_step(K_1, THETA_1R, true)
        .given(THETA_1, asin(incident), "an angle below π/2 is known by its sine")
        .given(THETA_1R, asin(reflected), "an angle below π/2 is known by its sine")
        .then(Equation::new(K_1 * sin(THETA_1), K_1 * sin(THETA_1R)), ["derivative"])
        .then(Equation::new(sin(THETA_1), sin(THETA_1R)), ["divide by k₁"])
        .then(Equation::new(left, right), ["an angle below π/2 is known by its sine"])
}

/// `chain` under Snell's law in its symmetric form n₁ = k sin θ₂, n₂ = k sin θ₁.
pub(super) fn with_snell(chain: Chain) -> Chain {
    chain.given(N_1, K * sin(THETA_2), "Snell").given(N_2, K * sin(THETA_1), "Snell")
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let (n_i, n_t) = (setting.index("n_i").re, setting.index("n_t"));
    let direction = incidence(setting);
    // In an absorbing medium the planes of constant phase turn by the real angle atan2(n_i sin θ₁, Re q_t).
    let q_t = outgoing_root(normal_squared(direction, n_i, n_t));
    let tangential = n_i * direction.sin();
    vec![
        Quantity {
            key: "theta_t",
            symbol: "θ_2",
            says: "angle of the refracted planes of phase",
            value: tangential.atan2(q_t.re),
            unit: "rad",
        },
        Quantity {
            key: "tangential",
            symbol: "n_1 sin θ_1",
            says: "what all three waves share",
            value: tangential,
            unit: "1",
        },
        Quantity {
            key: "q_t_re",
            symbol: "Re n_2 cos θ_2",
            says: "normal wave number over that of the vacuum",
            value: q_t.re,
            unit: "1",
        },
        Quantity {
            key: "q_t_im",
            symbol: "Im n_2 cos θ_2",
            says: "decay rate over the vacuum wave number",
            value: q_t.im,
            unit: "1",
        },
    ]
}

/// The second route knows no waves: of all points of the interface the ray crosses where the optical path is least.
const FERMAT: Check<fn(f64, f64, f64) -> f64> = check("fermat", "the refracted ray takes the least time")
    .against("Fermat's principle: golden-section search for the crossing point of least optical path")
    .within(
        1e-7,
        "1",
        "a minimum of a path of length 1 is flat to the root of an ulp, 1.5e−8, so its place is known no better",
    )
    .of(least_time, refracted)
    .slip("Snell's law with the indices interchanged", |theta, n_i, n_t| refracted(theta, n_t, n_i));

/// The sine of the refracted ray, by the program; NaN beyond the critical angle.
fn refracted(theta: f64, n_i: f64, n_t: f64) -> f64 {
    refract(Incidence::from_angle(theta), n_i, n_t).map_or(f64::NAN, |(sin, _)| sin)
}

/// The angle of incidence [rad] and both indices to the sine of the refracted ray [1].
fn least_time(_: &mut Bench, sine: fn(f64, f64, f64) -> f64) -> Measured {
    let media = [(1.0, 1.5), (1.5, 1.0), (1.33, 2.4), (1.0, 1.0003)];
    let crossing = [0.1, 0.3, 0.5, 0.9];
    Measured::worst(media.into_iter().flat_map(|(n_i, n_t)| crossing.map(|span| (n_i, n_t, span))).map(
        |(n_i, n_t, span)| {
            // From (0, 1) above the interface to (span, −1) below it, crossing at (x, 0).
            let path = |x: f64| n_i * x.hypot(1.0) + n_t * (span - x).hypot(1.0);
            let x = super::golden_section(path, 0.0, span);
            (sine(x.atan(), n_i, n_t) - (span - x).atan().sin(), format!("n {n_i} → {n_t}, crossing {x:.3}"))
        },
    ))
}

/// Where a mirror of the given normal sends what runs in a direction.
type Mirror = fn([f64; 3], [f64; 3]) -> [f64; 3];

const MIRROR: Check<Mirror> = check(
    "shortest_way",
    "a mirror sends the ray on along the shortest way to where it goes: at the angle of incidence",
)
.against("Fermat's principle: golden-section search for the point of the shortest way by way of the interface")
.within(1e-7, "1", "as for the refracted ray: the root of an ulp")
.of(shortest_way, mirrored)
.slip("the normal part is taken away once, not twice", |direction, normal| {
    let [direction, normal] = [direction, normal].map(DVec3::from);
    (direction - direction.dot(normal) * normal).normalize().into()
});

/// From (0, 0, −1) by way of (x, 0, 0) to (1, 0, −`height`): how far the program's mirror points past the end.
fn shortest_way(_: &mut Bench, mirror: Mirror) -> Measured {
    Measured::worst([0.2, 0.5, 2.0, 3.0].map(|height| {
        let way = |x: f64| x.hypot(1.0) + (1.0 - x).hypot(height);
        let x = super::golden_section(way, 0.0, 1.0);
        let towards = DVec3::new(1.0 - x, 0.0, -height).normalize();
        let sent = mirror(DVec3::new(x, 0.0, 1.0).normalize().into(), DVec3::Z.into());
        ((DVec3::from(sent) - towards).length(), format!("height {height}"))
    }))
}

fn refracted_cosines(setting: &Setting) -> Vec<Extreme> {
    let critical = fresnel::critical_angle(1.5, 1.0).expect("into the rarer medium");
    let cases = [
        (Direction::Angle(setting.number("theta")), setting.index("n_i").re, setting.index("n_t").re),
        (Direction::Angle(critical - 1e-15), 1.5, 1.0),
        (Direction::Angle(critical - 1e-10), 1.5, 1.0),
        (Direction::Angle(std::f64::consts::FRAC_PI_2 - 1e-9), 1.0, 1.0 + 1e-15),
        (Direction::Grazing(1e-12), 1.0, 1.0),
        (Direction::Grazing(1e-9), 1.0, 1.0 + 1e-15),
    ];
    let propagating = cases.into_iter().filter_map(|(direction, n_i, n_t)| {
        let incidence = Incidence::from(direction);
        let (_, cos_t) = refract(incidence, n_i, n_t)?;
        let input = light::references::fresnel::Input { direction, n_i, n_t: Complex64::from(n_t) };
        let (exact, condition) = light::references::fresnel::refracted_cosine(&input);
        Some(Extreme {
            input: extremes::describe(&input),
            quantity: "cos θ_2",
            textbook: (n_i * incidence.sin() / n_t).asin().cos(),
            ours: cos_t,
            condition,
            reference: exact,
            worst_of: 1,
        })
    });
    propagating.filter(|case| precise::to_f64(&case.reference) > 0.0).collect()
}

fn refraction(setting: &Setting) -> Plot {
    let (n_i, n_t) = (setting.index("n_i").re, setting.index("n_t"));
    let curve = |from: f64, to: Complex64| {
        let critical = if to.im == 0.0 { fresnel::critical_angle(from, to.re) } else { None };
        let all = super::over_angle_near(critical.map_or(90.0, f64::to_degrees), |incidence| {
            let q_t = outgoing_root(normal_squared(incidence, from, to));
            if q_t.re > 0.0 { (from * incidence.sin()).atan2(q_t.re).to_degrees() } else { f64::NAN }
        });
        (super::media(from, to), all)
    };
    let chart = |y: &str| {
        Chart::new(
            "",
            Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
            Axis::linear(y, "°").range(0.0, 90.0).tick(15.0),
        )
    };
    let (there, bent) = curve(n_i, n_t);
    if n_t.im > 0.0 {
        // No way back is drawn: a wave from inside an absorbing medium has no angle of incidence.
        return Plot::of(
            "Snell's law",
            chart("angle of the refracted planes of phase θ_2").line(Hue::Nth(0), there, bent),
        );
    }
    let mut chart = chart("angle of refraction θ_2").line(Hue::Nth(0), there, bent);
    if n_i != n_t.re {
        let (back, bent) = curve(n_t.re, n_i.into());
        chart = chart.line(Hue::Nth(1), back, bent);
    }
    if let Some(critical) = fresnel::critical_angle(n_i.max(n_t.re), n_i.min(n_t.re)) {
        chart = chart.at_x(critical.to_degrees(), "θ_c");
    }
    Plot::of("Snell's law", chart)
}
