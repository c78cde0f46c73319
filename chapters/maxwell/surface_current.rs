//! C1: charge and current on the interface itself.

use super::agreement::worst_order;
use super::interface::{AREA, HEIGHT, INSIDE, WALL_D, around_interface, out_of_box, turn_across};
use super::symbols::{D_1, D_2, H_1, H_2, K_S, NORMAL, RHO_S, Z_0};
use crate::diagram::Part;
use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Question, Step, check, derivation, exhibit, figure,
    fitted_order, question, statement, step,
};
use equation::derivation::Chain;
use equation::expr::{cross, dot, vector};
use equation::{Dimension, Equation, Expr, Symbol};
use light::Complex64;
use light::Polarisation;
use light::fields::surface::Sheet;
use light::optics::Incidence;
use light::optics::film::{Layer, Stack};
use light::waves::constants;
use std::f64::consts::{PI, TAU};

const SHEET: Parameter =
    Parameter::new("sheet", "1/G", "resistance of a square of the sheet", Kind::number(1e-6, 1e12, "Ω"))
        .default("188.365156706Ω");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "surface_current",
    &[SHEET],
    &[
        figure(
            "box_and_loop",
            "What no box can be too flat for, and no loop too narrow: charge and current in the interface itself.",
            box_and_loop,
        ),
        figure(
            "sheet",
            "A sheet takes most, one half, where its resistance is half that of the vacuum; \
         graphene takes πα.",
            powers,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Charge and current between",
    "Where the interface itself holds charge or carries current, the normal D and the \
     tangential H jump by just that much.",
)
.rows(&["C1"])
.about("carrying")
.statements(&[
    statement("charged", "charge on the interface is where electric flux begins", || {
        Equation::new(dot(NORMAL, D_2 - D_1), RHO_S)
    }),
    statement("carrying", "current in the interface turns the magnetic field", || {
        Equation::new(cross(NORMAL, H_2 - H_1), K_S)
    }),
    statement("reflection", "what a sheet with K = GE throws back at normal incidence", || {
        Equation::new(R, reflected(&(Z_0 * G)))
    }),
])
.questions(&[MOST])
.derivations(&[
    derivation(
        "box_with_charge",
        "the box of E4 made flat around a charge that stays in it, however flat it is",
        || charged_box(dot(NORMAL, D_2 - D_1)),
    )
    .slip("both lids take n for their way out", || charged_box(dot(NORMAL, D_2 + D_1))),
    derivation(
        "loops_with_current",
        "the loops of E4 made narrow around a current that stays in them, however narrow \
         they are",
        || loops().then(Equation::new(cross(NORMAL, H_2 - H_1), K_S), ["h → 0"]),
    )
    .slip("E4 as written: no current", || loops().then(Equation::new(cross(NORMAL, H_2 - H_1), 0), ["h → 0"])),
    derivation("sheet_from_jump", "E runs on, H jumps by the current GE: two equations for two waves", || {
        sheet(reflected(&(Z_0 * G)))
    })
    .slip("the current gives energy instead of taking it", || sheet(reflected(&-(Z_0 * G)))),
])
.readout(readout)
.checks(&[&THIN_FILM, &JUMP]);

const MOST: Question = question(
    "most",
    "Light falls squarely on a sheet without thickness, in empty space, whose resistance may be chosen. Which share \
     of the light can it turn to heat at most?",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let taken = (-300..=300).map(|at| {
                let conductance = 10f64.powf(f64::from(at) / 100.0) / constants::Z_0;
                at_normal_incidence(conductance).absorptance
            });
            taken.fold(0.0, f64::max)
        },
        slips: &[
            Misled {
                value: |_| 1.0,
                reply: "A current that takes much also radiates much, alike to both sides. Only with a mirror \
                 behind it can a sheet take all.",
            },
            Misled {
                value: |_| at_normal_incidence(constants::Z_0.recip()).absorptance,
                reply: "That is what a sheet with the resistance of the vacuum takes. It stands between two halves \
                 of space: the best has half as much.",
            },
        ],
    },
    "One half, where Z₀G = 2; a quarter goes on and a quarter comes back. What conducts better reflects, what \
     conducts less lets pass.",
);

const SHORT_H: Symbol = Symbol::scalar("H_s", Dimension::AMPERE_PER_METRE);
const THROUGH: Symbol = Symbol::scalar("j", Dimension::AMPERE_PER_SQUARE_METRE);
const G: Symbol = Symbol::scalar("G", Dimension::SIEMENS).real(0.5, 2.0);
const N_1: Symbol = Symbol::scalar("n_1", Dimension::ONE).within(1.0, 2.0);
const N_2: Symbol = Symbol::scalar("n_2", Dimension::ONE).within(1.0, 2.5);
const INCIDENT: Symbol = Symbol::scalar("E_1", Dimension::VOLT_PER_METRE).within(1.0, 2.0);
const REFLECTED: Symbol = Symbol::scalar("E_1'", Dimension::VOLT_PER_METRE);
const TRANSMITTED: Symbol = Symbol::scalar("E_2", Dimension::VOLT_PER_METRE);
const R: Symbol = Symbol::scalar("r", Dimension::ONE);

/// Loops along x and y, through which the current K in the interface flows besides what comes with their area.
fn loops() -> Chain {
    let [x, y] = [vector(1, 0, 0), vector(0, 1, 0)].map(|way| {
        let bare = turn_across(&way, [H_1, H_2], SHORT_H, THROUGH);
        Equation::new(bare.lhs, bare.rhs - dot(way, K_S))
    });
    Chain::assume(x, "the loop for H, b along x")
        .and(y, "b along y")
        .given(NORMAL, vector(0, 0, 1), "n along z")
        .given(Symbol::scalar("K_z", Dimension::AMPERE_PER_METRE), 0, "K stays in the interface")
        .given(HEIGHT, 0, "h → 0")
}

/// The box around a patch of the interface that carries ρ_s per area, besides the charge that comes with its volume.
fn charged_box(step: Expr) -> Chain {
    let charge = AREA * HEIGHT * INSIDE + AREA * RHO_S;
    Chain::assume(Equation::new(out_of_box(D_1, D_2, WALL_D), charge), "∇·D = ρ, Gauss's theorem")
        .given(HEIGHT, 0, "h → 0")
        .then(Equation::new(AREA * dot(NORMAL, D_2) - AREA * dot(NORMAL, D_1), AREA * RHO_S), ["h → 0"])
        .then(Equation::new(step, RHO_S), ["over A"])
}

/// r of a sheet whose conductance is `own` times that of the vacuum.
fn reflected(own: &Expr) -> Expr {
    (N_1 - N_2 - own) / (N_1 + N_2 + own)
}

fn sheet(last: Expr) -> Chain {
    let current = Equation::new(N_1 / Z_0 * (INCIDENT - REFLECTED) - N_2 / Z_0 * TRANSMITTED, G * TRANSMITTED);
    Chain::assume(Equation::new(INCIDENT + REFLECTED, TRANSMITTED), "n×(E₁−E₂) = 0")
        .and(current, "n×(H₂−H₁) = K, K = GE, H = nE/Z₀")
        .solve_for([REFLECTED, TRANSMITTED])
        .then(Equation::new(TRANSMITTED, 2 * N_1 * INCIDENT / (N_1 + N_2 + Z_0 * G)), ["linear solve"])
        .then(Equation::new(REFLECTED / INCIDENT, last), ["linear solve"])
}

fn at_normal_incidence(conductance: f64) -> Sheet {
    Sheet::new(Incidence::NORMAL, Polarisation::S, 1.0, 1.0.into(), conductance)
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let resistance = setting.number("sheet");
    let sheet = at_normal_incidence(resistance.recip());
    let value = |key, symbol, says, value: f64, unit| Quantity { key, symbol, says, value, unit };
    vec![
        value("z0_g", "Z_0G", "conductance in units of the vacuum's", constants::Z_0 / resistance, "1"),
        value("reflectance", "R", "reflected, in vacuum at normal incidence", sheet.reflectance, "1"),
        value("transmittance", "T", "transmitted", sheet.transmittance, "1"),
        value("absorptance", "A", "turned into heat", sheet.absorptance, "1"),
    ]
}

/// A film of the given thickness [m] whose conductivity makes the conductance [S], at a wavelength [m].
fn film(thickness: f64, conductance: f64, wavelength: f64) -> Layer {
    let omega = TAU * constants::C / wavelength;
    let loss = conductance / (thickness * constants::EPSILON_0 * omega);
    Layer { index: Complex64::new(1.0, loss).sqrt(), thickness }
}

const THIN_FILM: Check<f64> = check(
    "thin_film",
    "a film with E4 at both faces becomes a sheet with current as it gets thinner at \
     the same conductance, with the first power of its thickness",
)
.against(
    "the film solver of chapter fresnel, whose interfaces are bare, s and p at 0.6 rad \
     between air and glass",
)
.order(1.0, 0.05, "what a film adds to its current is in proportion to its thickness")
.of(thinner, 1.0)
.slip("a sheet of 2 % less conductance", 0.98);

/// The order in the thickness with which a film approaches the sheet of `share` times its conductance, the worst case.
fn thinner(_: &mut Bench, share: f64) -> Measured {
    let (incidence, n_t, wavelength) = (Incidence::from_angle(0.6), Complex64::new(1.5, 0.0), 1e-2);
    let cases = [Polarisation::S, Polarisation::P].into_iter().flat_map(|p| [1e-4, 2e-3, 2e-2].map(|g| (p, g)));
    let orders = cases.map(|(polarisation, conductance)| {
        let sheet = Sheet::new(incidence, polarisation, 1.0, n_t, share * conductance);
        let points: Vec<_> = (0..6)
            .map(|half| {
                let thickness = 1e-7 * 0.5f64.powi(half);
                let layers = [film(thickness, conductance, wavelength)];
                let stack = Stack { n_i: 1.0, layers: &layers, substrate: n_t };
                let film = stack.response(wavelength, incidence, polarisation);
                (thickness.recip(), (film.r - sheet.r).norm())
            })
            .collect();
        (fitted_order(&points).unwrap_or(f64::NAN), format!("{polarisation:?}, G = {conductance} S"))
    });
    worst_order(1.0, orders)
}

const JUMP: Check<f64> =
    check("jump", "the step of H is the current, and what the current takes is what R and T leave")
        .against("fields on both sides from r alone; energy from ½ Re(K E*)")
        .within(16.0, "ulp", "a handful of roundings, relative to the largest field")
        .of(jump, 1.0)
        .slip("E4 as written: H runs on", 0.0);

/// In ε: |H₁ − H₂ − share·K| over the largest of them, and R + T + A − 1, at normal incidence.
fn jump(_: &mut Bench, share: f64) -> Measured {
    let media = [(1.0, Complex64::new(1.0, 0.0)), (1.0, Complex64::new(1.5, 0.0)), (1.5, Complex64::new(0.2, 3.4))];
    let cases = media.into_iter().flat_map(|media| [1e-6, 6e-5, 2.65e-3, 1.0, 1e4].map(|g| (media, g)));
    Measured::worst(cases.flat_map(|((n_i, n_t), conductance)| {
        let sheet = Sheet::new(Incidence::NORMAL, Polarisation::S, n_i, n_t, conductance);
        let (near, far) = (n_i * (1.0 - sheet.r), n_t * (1.0 + sheet.r));
        let current = constants::Z_0 * conductance * sheet.tangential;
        let step = (near - far - share * current).norm() / (near.norm() + far.norm() + current.norm());
        let sum = sheet.reflectance + sheet.transmittance + sheet.absorptance - 1.0;
        let place = format!("G = {conductance} S, n {n_i} → {n_t}");
        [(step / f64::EPSILON, format!("H, {place}")), (sum / f64::EPSILON, format!("R + T + A, {place}"))]
    }))
}

/// The fine-structure constant (CODATA 2022) [1]; graphene conducts πα/Z₀ (Nair et al., Science 320, 1308, 2008).
const ALPHA: f64 = 7.297_352_564_3e-3;

fn powers(setting: &Setting) -> Plot {
    let curve = |of: fn(&Sheet) -> f64| -> Vec<[f64; 2]> {
        let conductances = (-240..=240).map(|at| 10f64.powf(f64::from(at) / 80.0));
        conductances.map(|y| [y, of(&at_normal_incidence(y / constants::Z_0))]).collect()
    };
    let chart = Chart::new(
        "",
        Axis::log("conductance of the sheet Z_0G", "").range(1e-3, 1e3),
        Axis::share("share of the power"),
    )
    .line(Hue::Natural, "reflected", curve(|sheet| sheet.reflectance))
    .line(Hue::Transmitted, "transmitted", curve(|sheet| sheet.transmittance))
    .line(Hue::Ours, "absorbed", curve(|sheet| sheet.absorptance))
    .at_x(PI * ALPHA, "graphene")
    .at_x(
        constants::Z_0 / setting.number("sheet"),
        format!("1/G = {}", crate::parameter::number((setting.number("sheet") * 10.0).round() / 10.0)) + " Ω",
    );
    Plot::of("A sheet that carries current", chart)
}

/// A box about a charge in the interface, and a loop about a current in it.
fn box_and_loop(_: &Setting) -> Plot {
    let places = [-0.5, -0.25, 0.0, 0.25, 0.5];
    let charged = around_interface("charge: the normal D jumps")
        .with_all(places.map(|x| {
            let charge = Part::point([x, 0.0]).hue(Hue::P);
            if x == 0.5 { charge.label("ρ_s") } else { charge }
        }))
        .with(Part::vector([-0.35, 0.4], [-0.35, 0.85]).hue(Hue::S).label("D_1"))
        .with(Part::vector([-0.35, -0.4], [-0.35, -0.85]).hue(Hue::S).label("D_2"))
        .with(Part::vector([0.35, -0.4], [0.35, -0.75]).hue(Hue::Reference).label("n"));
    let carrying = around_interface("current: the tangential H jumps")
        .with_all(places.map(|x| {
            let current = Part::across([x, 0.0], true).hue(Hue::P);
            if x == 0.5 { current.label("K_s") } else { current }
        }))
        .with(Part::vector([0.3, 0.55], [-0.3, 0.55]).hue(Hue::S).label("H_1"))
        .with(Part::vector([-0.3, -0.55], [0.3, -0.55]).hue(Hue::S).label("H_2"))
        .with(Part::vector([-1.0, 0.0], [-1.0, -0.4]).hue(Hue::Reference).label("n"));
    Plot::grid("What stays in the box and in the loop", 2, vec![charged.into(), carrying.into()])
}
