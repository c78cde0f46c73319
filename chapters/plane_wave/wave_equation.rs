//! E6–E8: the two first-order laws made one of second order, for either field.

use super::fields::{Dipole, Field, Plane, acceleration, curl as curl_of, direction, laplacian as laplacian_of, rate};
use crate::symbols::{B, E, EPSILON, MU, T};
use crate::vocabulary::{
    Answer, Bench, Bound, Check, Exhibit, Measured, Question, Step, check, derivation, exhibit, fitted_order, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::{curl, divergence, gradient, laplacian, partial};
use equation::{Equation, Expr, Symbol};
use glam::DVec3;
use light::waves::{Medium, constants::C};
use yardstick::random::uniform;
use yardstick::statistics::rms;

pub(super) const EXHIBIT: Exhibit = exhibit("wave_equation", &[], &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "The wave equation",
    "Each field drives the other; take one of them out and what is left is an equation of waves.",
)
.rows(&["E6", "E7", "E8"])
.about("wave_e")
.statements(&[
    statement("curl_twice", "Faraday's law, wound round once more", || {
        Equation::new(curl(curl(E)), -partial(curl(B), T))
    })
    .rows(&["E6"]),
    statement("curl_twice_e", "and Ampère's law put in", || {
        Equation::new(-partial(curl(B), T), -(EPSILON * MU * twice(E, T)))
    })
    .rows(&["E6"]),
    statement("wave_e", "the wave equation of the electric field", || wave(&E, EPSILON * MU)).rows(&["E7"]),
    statement("wave_b", "the wave equation of the magnetic field", || wave(&B, EPSILON * MU)).rows(&["E8"]),
])
.questions(&[CREST])
.derivations(&[
    derivation("from_e5", "the curl of Faraday's law, and Ampère's law for the curl of B", || {
        curl_twice(-(EPSILON * MU * twice(E, T)))
    })
    .rows(&["E6"])
    .slip("the minus of Faraday's law is lost on the way", || curl_twice(EPSILON * MU * twice(E, T))),
    derivation("electric", "∇×∇× = ∇∇· − ∇², and no charges", || electric(EPSILON * MU))
        .rows(&["E7"])
        .slip("the sign of Laplace's equation in four dimensions", || electric(-(EPSILON * MU))),
    derivation("magnetic", "the same way round for B", || magnetic(EPSILON * MU))
        .rows(&["E8"])
        .slip("each of the two laws counted with its own εμ", || magnetic(2 * EPSILON * MU)),
])
.checks(&[&CURL_TWICE, &DIPOLE_E, &DIPOLE_B]);

const CREST: Question = question(
    "crest",
    "At the crest of a wave E is at its highest. Which sign has ∂²E/∂t² there, at that moment?",
    Answer::Sign {
        replies: [
            "In space the field bends down on both sides of a crest, and the wave equation makes time follow space.",
            "Its *rate* is zero there. What it changes by next is another matter: a ball at its highest still \
             falls.",
            "Then the crest would go on growing, faster and faster, and never come back: such fields do not swing.",
        ],
        right: |_| {
            let wave = Plane::new(&Medium::VACUUM, C, DVec3::Z, DVec3::X, 0.0);
            acceleration(&|place, time| wave.at(place, C.recip() * time).0, DVec3::ZERO, 0.0, 1e-3).dot(wave.e)
        },
        slip: |_| 0.0,
    },
    "Negative: a crest bends down in space, and the wave equation says that it bends in time as it does in space. \
     So the field comes back, and swings.",
);

/// ∂²f/∂x²
pub(super) fn twice(f: impl Into<Expr>, x: Symbol) -> Expr {
    partial(partial(f, &x), x)
}

/// (∇² − `slowness` ∂²/∂t²) F = 0
fn wave(field: &Symbol, slowness: Expr) -> Equation {
    Equation::new(laplacian(field) - slowness * twice(field, T), 0)
}

/// E5 as hypotheses: each law says what its derivative is.
fn source_free(chain: Chain) -> Chain {
    chain
        .given(divergence(E), 0, "∇·E = 0")
        .given(divergence(B), 0, "∇·B = 0")
        .given(partial(B, T), -curl(E), "∇×E = −∂B/∂t")
        .given(partial(E, T), curl(B) / (EPSILON * MU), "∇×B = εμ ∂E/∂t")
}

fn curl_twice(last: Expr) -> Chain {
    source_free(Chain::new(curl(curl(E))))
        .then(-curl(partial(B, T)), ["∇×E = −∂B/∂t"])
        .then(-partial(curl(B), T), ["derivatives commute"])
        .then(last, ["∇×B = εμ ∂E/∂t"])
}

fn electric(slowness: Expr) -> Chain {
    source_free(Chain::new(Equation::new(curl(curl(E)), gradient(divergence(E)) - laplacian(E))))
        .because("true of every vector field")
        .then(-laplacian(E), ["∇·E = 0"])
        .then(wave(&E, slowness), ["∇×(∇×E) = −εμ ∂²E/∂t²"])
}

fn magnetic(slowness: Expr) -> Chain {
    source_free(Chain::new(curl(curl(B))))
        .then(EPSILON * MU * partial(curl(E), T), ["∇×B = εμ ∂E/∂t", "derivatives commute"])
        .then(-(EPSILON * MU * twice(B, T)), ["∇×E = −∂B/∂t"])
        .then(Equation::new(curl(curl(B)), gradient(divergence(B)) - laplacian(B)), ["true of every vector field"])
        .then(-laplacian(B), ["∇·B = 0"])
        .then(wave(&B, slowness), ["∇×(∇×B) = −εμ ∂²B/∂t²"])
}

const SECOND_ORDER: Bound = Bound::Order {
    order: 2.0,
    tolerance: 0.1,
    why: "central differences err by h²; the next term, h⁴, still shows at the widest of the four steps",
};

/// What a law leaves over at a place and time, by differences of step h.
type Residual = fn(&Dipole, DVec3, f64, f64) -> f64;

const CURL_TWICE: Check<Residual> = check(
    "curl_twice_of_a_dipole",
    "∇×(∇×E), −∂(∇×B)/∂t and −εμ ∂²E/∂t² are one and the same in the field of a dipole",
)
.rows(&["E6"])
.against("Jackson's dipole field (9.18), far from plane, by central differences that shrink")
.bound(SECOND_ORDER)
.of(differences, |dipole, place, time, h| curl_twice_residual(dipole, place, time, h, 1.0))
.slip("the minus of Faraday's law is lost on the way", |dipole, place, time, h| {
    curl_twice_residual(dipole, place, time, h, -1.0)
});

const DIPOLE_E: Check<Residual> =
    check("dipole_e", "the electric field of a dipole obeys the wave equation, near field included")
        .rows(&["E7"])
        .against("Jackson's dipole field (9.18), by central differences that shrink")
        .bound(SECOND_ORDER)
        .of(differences, |dipole, place, time, h| {
            wave_residual(&|r, t| dipole.e(r, t), place, time, h, dipole.speed.powi(-2))
        })
        .slip("1/v for 1/v²", |dipole, place, time, h| {
            wave_residual(&|r, t| dipole.e(r, t), place, time, h, dipole.speed.powi(-1))
        });

const DIPOLE_B: Check<Residual> = check("dipole_b", "so does its magnetic field")
    .rows(&["E8"])
    .against("Jackson's dipole field (9.18), by central differences that shrink")
    .bound(SECOND_ORDER)
    .of(differences, |dipole, place, time, h| {
        wave_residual(&|r, t| dipole.b(r, t), place, time, h, dipole.speed.powi(-2))
    })
    .slip("the sign of Laplace's equation in four dimensions", |dipole, place, time, h| {
        wave_residual(&|r, t| dipole.b(r, t), place, time, h, -dipole.speed.powi(-2))
    });

/// How fast the residual of a law falls as the differences shrink, over places about the dipole.
fn differences(bench: &mut Bench, residual: fn(&Dipole, DVec3, f64, f64) -> f64) -> Measured {
    let dipole = Dipole { speed: 0.7 };
    let places: Vec<(DVec3, f64)> = (0..12)
        .map(|_| {
            let distance = uniform(&mut bench.stream, 1.0, 6.0);
            (direction(&mut bench.stream) * distance, uniform(&mut bench.stream, 0.0, 9.0))
        })
        .collect();
    let widths = [0.1, 0.05, 0.025, 0.0125];
    let points = widths.map(|h| {
        let residuals: Vec<f64> = places.iter().map(|(place, time)| residual(&dipole, *place, *time, h)).collect();
        (1.0 / h, rms(&residuals))
    });
    let value = fitted_order(&points).unwrap_or(f64::NAN);
    Measured::new(value, format!("h = {} … {}", widths[0], widths[3]), places.len() * widths.len())
}

fn curl_twice_residual(dipole: &Dipole, place: DVec3, time: f64, h: f64, sign: f64) -> f64 {
    let (e, b) = (|r: DVec3, t: f64| dipole.e(r, t), |r: DVec3, t: f64| dipole.b(r, t));
    let twice = curl_of(&|r, t| curl_of(&e, r, t, h), place, time, h);
    let by_b = -sign * rate(&|r, t| curl_of(&b, r, t, h), place, time, h);
    let by_e = -sign * dipole.speed.powi(-2) * acceleration(&e, place, time, h);
    (twice - by_b).length().max((twice - by_e).length())
}

fn wave_residual(field: Field, place: DVec3, time: f64, h: f64, epsilon_mu: f64) -> f64 {
    (laplacian_of(field, place, time, h) - epsilon_mu * acceleration(field, place, time, h)).length()
}
