//! C2: the grid beside the closed forms, at interfaces, on films and in conductors.

use super::scattering::{Scene, exact_wave_number, wave_number_on_grid};
use crate::figure::{Axis, Chart, Dash, Hue, Map, Mark, Panel, Plot, Ramp, Shape};
use crate::fresnel::media;
use crate::parameter::{Alias, Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Bound, Check, Exhibit, Measured, Misled, Quantity, Question, Step, check, exhibit, figure,
    fitted_order, question, statement, step,
};
use equation::{Dimension, Equation, Symbol};
use light::Complex64;
use light::Polarisation;
use light::em::line::{Ends, Line, Setup};
use light::em::plane::{self, Plane};
use light::em::pulse::amplitude;
use light::em::{C, Medium, Pulse, Stepping};
use light::optics::Incidence;
use light::optics::fresnel::powers;
use yardstick::statistics::rms;

const INDEX: Parameter = Parameter::new("n_t", "n_2", "index behind the interface", Kind::number(1.0, 4.0, "1"))
    .default("1.5")
    .aliases(&[Alias::same("n")]);
const TANGENT: Parameter = Parameter::new(
    "loss_tangent",
    "σ/(ωε)",
    "conduction over displacement current, of the conductor",
    Kind::number(0.1, 100.0, "1"),
)
.default("10");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "agreement",
    &[INDEX, TANGENT],
    &[
        figure(
            "pulse_at_an_interface",
            "A pulse runs into glass: place to the right, time upwards. It splits, slows down \
             and shortens.",
            space_time,
        ),
        figure("reflectance", "Fresnel's curves, and what the grid finds without knowing them.", reflectance),
        figure(
            "conductor",
            "A harmonic wave driven into a conductor: the field on the grid, and the formula for a wave that decays.",
            conductor,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Grid and formula agree",
    "Reflection, transmission, films and the decay in a conductor come out of the grid \
     alone, with an error that falls as the square of the cell.",
)
.rows(&["C2"])
.statements(&[statement("second_order", "what is left between grid and formula", || {
    Equation::proportional(DELTA_R, CELL.pow(2))
})])
.questions(&[HALVED])
.readout(readout)
.checks(&[&OPEN_SPACE, &INTERFACES, &LIMITS, &FILMS, &METALS, &CONDUCTORS]);

const HALVED: Question = question(
    "halved",
    "On a grid of 16 cells to a wave the reflectance of glass is a little wrong. With 32 cells, which share of that \
     error is left?",
    Answer::Number {
        unit: "1",
        tolerance: 0.1,
        right: |_| {
            let glass =
                Scene { theta: 0.0, polarisation: Polarisation::S, films: vec![], substrate: Medium::dielectric(2.25) };
            let off = |cells| glass.on_grid(cells).0 - glass.exact().0;
            off(32) / off(16)
        },
        slips: &[
            Misled {
                value: |_| 0.5,
                reply: "So it is with a jump of ε that is laid half a cell off. Centred differences err by the \
                 square.",
            },
            Misled {
                value: |_| 0.0625,
                reply: "That would be the fourth order. Differences of two neighbours have the second.",
            },
        ],
    },
    "About a quarter: the error goes as the square of the cell. Were it a half, we should look for a mistake.",
);

const DELTA_R: Symbol = Symbol::scalar("Delta_R", Dimension::ONE);
const CELL: Symbol = Symbol::scalar("Delta", Dimension::METRE);

const BOTH: [Polarisation; 2] = [Polarisation::S, Polarisation::P];
/// Cells to the vacuum wavelength; a quarter of it is a whole number of them.
const REFINED: [usize; 3] = [16, 24, 36];

/// The order with which the grid's (R, T) approach `exact`, the worst of `groups`; of the scenes of a group the RMS
/// error counts, since one alone may pass through zero.
fn order_of(groups: impl Iterator<Item = Vec<Scene>>, exact: fn(&Scene) -> (f64, f64)) -> Measured {
    order_at(REFINED, groups, exact)
}

fn order_at(
    refined: [usize; 3],
    groups: impl Iterator<Item = Vec<Scene>>,
    exact: fn(&Scene) -> (f64, f64),
) -> Measured {
    worst_order(
        2.0,
        groups.map(|scenes| {
            let error = |cells: usize| {
                let errors = scenes.iter().flat_map(|scene| {
                    let (found, exact) = (scene.on_grid(cells), exact(scene));
                    [found.0 - exact.0, found.1 - exact.1]
                });
                (cells as f64, rms(&errors.collect::<Vec<_>>()))
            };
            let first = &scenes[0];
            let place = format!("{:?}, θ = {:.2}, {} films", first.polarisation, first.theta, first.films.len());
            (fitted_order(&refined.map(error)).unwrap_or(f64::NAN), place)
        }),
    )
}

/// The order farthest from the one expected.
pub(super) fn worst_order(expected: f64, orders: impl Iterator<Item = (f64, String)>) -> Measured {
    let orders: Vec<(f64, String)> = orders.collect();
    let away = |order: f64| (order - expected).abs();
    let worst = orders.iter().max_by(|a, b| away(a.0).total_cmp(&away(b.0))).expect("some orders");
    Measured::new(worst.0, worst.1.clone(), orders.len())
}

fn interfaces(angles: &'static [f64]) -> impl Iterator<Item = Vec<Scene>> {
    let cases = angles.iter().flat_map(|&theta| BOTH.map(|polarisation| (theta, polarisation)));
    let bare = |theta, polarisation| Scene { theta, polarisation, films: vec![], substrate: Medium::dielectric(2.25) };
    cases.map(move |(theta, polarisation)| vec![bare(theta, polarisation)])
}

/// Two films on glass at several angles, for s and for p.
fn films() -> impl Iterator<Item = Vec<Scene>> {
    BOTH.into_iter().map(|polarisation| {
        let at = |theta| Scene {
            theta,
            polarisation,
            films: vec![(0.25, 4.0), (0.25, 1.9)],
            substrate: Medium::dielectric(2.25),
        };
        [0.0, 0.25, 0.5].map(at).into()
    })
}

const SECOND: Bound = Bound::Order {
    order: 2.0,
    tolerance: 0.25,
    why: "centred differences, and media averaged where E lies on an interface; 16 to 36 \
          cells a wave are not yet the limit",
};

/// R and T of a scene [1] in closed form.
type Exact = fn(&Scene) -> (f64, f64);

const INTERFACES: Check<Exact> = check(
    "interfaces",
    "reflectance and transmittance of glass on the grid approach E36 to E41 with the \
     second power of the cell, s and p",
)
.against(
    "the two-dimensional solver, a pulse at 17°, 34° and 45°, the fields Fourier \
     transformed where they come back and behind the interface",
)
.bound(SECOND)
.of::<Exact>(|_, exact| order_of(interfaces(&[0.3, 0.6, 0.785]), exact), Scene::exact)
.slip("s for p", |scene| {
    let other = if scene.polarisation == Polarisation::S { Polarisation::P } else { Polarisation::S };
    Scene { polarisation: other, ..scene.clone() }.exact()
});

const OPEN_SPACE: Check<usize> = check(
    "open_space",
    "the absorbing layers send back less than a millionth of a wave, in vacuum and in \
     media of index 3 and 9, at every side, corners and slanting waves included",
)
.against(
    "the same lamp in a plane so large that nothing comes back in time, both Fourier \
     transformed at its carrier",
)
.within(
    1e-6,
    "1",
    "what a layer is asked for; its loss alone would leave 10⁻¹² at right angles, the \
     steps of its grading more",
)
.of(echo, 30)
.slip("layers of 6 cells", 6);

/// What layers of so many cells on four sides send back of a lamp's carrier, beside all of them and in two corners of an
/// open square of 60 cells with the lamp off its middle.
fn echo(_: &mut Bench, layers: usize) -> Measured {
    const OPEN: usize = 60;
    /// Cells to a wave in the medium.
    const WAVE: f64 = 20.0;
    const STEPS: u64 = 260;
    // Nothing comes back over so many cells in so many steps of 0.7 cells.
    const FAR: usize = 110;
    let lit = |index: f64, polarisation: Polarisation, margin: usize| {
        let side = OPEN + 2 * margin;
        let vacuum = plane::Setup::vacuum([side; 2], 1.0, polarisation, Stepping::at(0.7 * index));
        let background = Medium::dielectric(index * index);
        let mut plane = Plane::new(plane::Setup { background, ..vacuum.open(layers) }).expect("within all limits");
        let speed = C / index;
        let lamp = Pulse::Modulated { frequency: speed / WAVE, delay: 60.0 / speed, width: 15.0 / speed };
        plane.inject([margin + 20, margin + 30], 1.0, lamp).expect("a stepped place");
        let places = [[2, 30], [57, 30], [30, 2], [30, 57], [3, 3], [57, 57]];
        let probes = places.map(|[x, y]| plane.probe([margin + x, margin + y]).expect("on the grid"));
        plane.run(STEPS).expect("some steps");
        probes.map(|probe| plane.record(probe))
    };
    // In steps: 0.7 cells each.
    let carrier = |record: &[Complex64]| amplitude(record, 0.0, 0.7, std::f64::consts::TAU / WAVE).norm();
    let names = ["on the left", "on the right", "below", "above", "in the first corner", "in the last corner"];
    let cases = [1.0, 3.0, 9.0].into_iter().flat_map(|index| BOTH.map(|polarisation| (index, polarisation)));
    Measured::worst(cases.flat_map(|(index, polarisation)| {
        let (near, far) = (lit(index, polarisation, layers), lit(index, polarisation, FAR));
        near.into_iter().zip(far).zip(names).map(move |((near, far), place)| {
            let back: Vec<_> = near.iter().zip(&far).map(|(near, far)| near - far).collect();
            (carrier(&back) / carrier(&far), format!("n = {index}, {polarisation:?}, {place}"))
        })
    }))
}

/// What the grid tends to: two runs, from which the second power of the cell is taken out (Richardson 1911).
fn limit(scene: &Scene) -> (f64, f64) {
    const CELLS: [usize; 2] = [40, 60];
    let [coarse, fine] = CELLS.map(|cells| scene.on_grid(cells));
    let gain = (CELLS[1] as f64 / CELLS[0] as f64).powi(2);
    let beyond = |coarse: f64, fine: f64| (gain * fine - coarse) / (gain - 1.0);
    (beyond(coarse.0, fine.0), beyond(coarse.1, fine.1))
}

const LIMITS: Check<f64> =
    check("limits", "and where the cell goes to nothing they are those of the formulas, up to 57°")
        .against(
            "the two-dimensional solver at 40 and 60 cells a wave, extrapolated, at 0°, 34° \
             and 57°",
        )
        .within(1e-4, "1", "the fourth power of the cell, which is left")
        .of(off_limits, 1.0)
        .slip("an ε that is 0.3 per cent too large in the formula", 1.003);

/// Largest difference of R and T between the grid's limit and a formula whose ε is wrong by a factor.
fn off_limits(_: &mut Bench, factor: f64) -> Measured {
    Measured::worst(interfaces(&[0.0, 0.6, 1.0]).flatten().flat_map(|scene| {
        let substrate = Medium::dielectric(scene.substrate.eps_r * factor);
        let (found, exact) = (limit(&scene), Scene { substrate, ..scene.clone() }.exact());
        let place = format!("{:?}, θ = {:.2}", scene.polarisation, scene.theta);
        [(found.0 - exact.0, format!("R of {place}")), (found.1 - exact.1, format!("T of {place}"))]
    }))
}

/// Free electrons with ω_p = 2ω: ε = −3 and some loss.
const METAL: Medium = Medium::metal(2.0 * std::f64::consts::TAU * C, 0.2 * std::f64::consts::TAU * C);

/// The metal at several angles, for s and for p.
fn metals(metal: Medium) -> impl Iterator<Item = Vec<Scene>> {
    BOTH.into_iter().map(move |polarisation| {
        let at = |theta| Scene { theta, polarisation, films: vec![], substrate: metal };
        [0.0, 0.5, 1.0].map(at).into()
    })
}

const METALS: Check<Exact> = check(
    "metals",
    "a metal of free electrons reflects as its complex index says, with an error of \
     the second power of the cell",
)
.against(
    "the electrons' equation stepped along with the fields, at 0°, 29° and 57°, \
     against Fresnel with ε = 1 − ω_p²/(ω² + iγω)",
)
.order(
    2.0,
    0.3,
    "centred differences; 24 to 54 cells a wave are two to five to the depth that \
     light reaches",
)
.of::<Exact>(|_, exact| order_at([24, 36, 54], metals(METAL), exact), Scene::exact)
.slip("a plasma frequency two per cent too high in the formula", |scene| {
    let more = METAL.drude.map_or(0.0, |drude| 1.02 * drude.plasma);
    let substrate = Medium::metal(more, 0.2 * std::f64::consts::TAU * C);
    Scene { substrate, ..scene.clone() }.exact()
});

const FILMS: Check<Exact> = check("films", "and so do those of two films on glass, every bounce included")
    .against(
        "the two-dimensional solver at 0°, 14° and 29° against the stack solver of chapter \
             fresnel",
    )
    .bound(SECOND)
    .of::<Exact>(|_, exact| order_of(films(), exact), Scene::exact)
    .slip("the films in the wrong order", |scene| {
        let films = scene.films.iter().rev().copied().collect();
        Scene { films, ..scene.clone() }.exact()
    });

const CONDUCTORS: Check<fn(f64) -> light::Complex64> = check(
    "conductors",
    "wave length and decay in a conductor approach E18 with the second power of the \
     cell",
)
.against(
    "the one-dimensional solver: ratio of the fields at two depths, against √(ω²με + \
     iωμσ)",
)
.order(2.0, 0.2, "centred differences")
.of(decay, exact_wave_number)
.slip("a conductivity one per cent too high in the formula", |tau| exact_wave_number(1.01 * tau));

fn decay(_: &mut Bench, exact: fn(f64) -> light::Complex64) -> Measured {
    worst_order(
        2.0,
        [0.1, 1.0, 10.0].into_iter().map(|tau| {
            let points = [6, 9, 14].map(|cells| (cells as f64, (wave_number_on_grid(tau, cells) - exact(tau)).norm()));
            (fitted_order(&points).unwrap_or(f64::NAN), format!("σ/(ωε) = {tau}"))
        }),
    )
}

fn glass(setting: &Setting, theta: f64, polarisation: Polarisation) -> Scene {
    Scene { theta, polarisation, films: vec![], substrate: Medium::dielectric(setting.number("n_t").powi(2)) }
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let scene = glass(setting, 0.0, Polarisation::S);
    let value = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    vec![
        value("r_grid", "R", "reflectance at normal incidence, grid of 16 cells to a wave", scene.on_grid(16).0),
        value("r_fine", "R", "the same, 32 cells", scene.on_grid(32).0),
        value("r_formula", "R", "by Fresnel's formula", scene.exact().0),
    ]
}

/// A pulse of a few waves that runs into glass half-way.
fn space_time(setting: &Setting) -> Plot {
    const CELLS: usize = 600;
    const FRAMES: usize = 220;
    const SHOWN: std::ops::Range<usize> = 40..CELLS - 40;
    let n = setting.number("n_t");
    // Cells of 1/30 of a unit of length; time is counted in the same units, ct.
    let spacing = 1.0 / 30.0;
    let setup = Setup {
        layers: vec![(CELLS / 2..CELLS, Medium::dielectric(n * n))],
        ..Setup::vacuum(CELLS, spacing, Ends::open(20), Stepping::at(0.5))
    };
    let mut line = Line::new(setup).expect("a line within all limits");
    let width = 0.8 / C;
    line.illuminate(30, 1.0, Pulse::Modulated { frequency: C / 1.6, delay: 3.0 * width, width }).expect("an open node");
    let steps = 8;
    let mut values = Vec::new();
    for _ in 0..FRAMES {
        line.run(steps).expect("some steps");
        values.extend(line.e()[SHOWN].iter().step_by(2));
    }
    let far = (SHOWN.end - CELLS / 2) as f64 * spacing;
    let until = (FRAMES as u64 * steps) as f64 * 0.5 * spacing;
    let map = Map {
        title: String::new(),
        x: Axis::linear("z", "m").range(-far, far),
        y: Axis::linear("ct", "m").range(0.0, until),
        colour: Axis::linear("E over the incident amplitude", "").range(-1.0, 1.0),
        ramp: Ramp::Diverging,
        columns: SHOWN.len() / 2,
        values,
        marks: vec![Mark::AtX { x: 0.0, label: media(1.0, n.into()) }],
    };
    Plot::of("A pulse at an interface", map)
}

fn reflectance(setting: &Setting) -> Plot {
    let n = setting.number("n_t");
    let chart = Chart::new(
        "",
        Axis::linear("angle of incidence", "°").range(0.0, 90.0).tick(15.0),
        Axis::share("reflectance R"),
    );
    let chart = [(Polarisation::S, Hue::S, "s"), (Polarisation::P, Hue::P, "p")].into_iter().fold(
        chart,
        |chart, (polarisation, hue, name)| {
            let formula = (0..=180).map(|half| f64::from(half) / 2.0).map(|degrees: f64| {
                let powers = powers(Incidence::from_angle(degrees.min(89.99).to_radians()), 1.0, n.into());
                [degrees, if polarisation == Polarisation::S { powers.r_s } else { powers.r_p }]
            });
            let grid = [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0]
                .map(|degrees: f64| [degrees, glass(setting, degrees.to_radians(), polarisation).on_grid(24).0]);
            chart.line(hue, format!("{name}, formula"), formula.collect()).with(Mark::Points {
                label: format!("{name}, grid of λ/24"),
                hue,
                shape: Shape::Disc,
                joined: false,
                points: grid.into(),
            })
        },
    );
    Plot::of("Reflection from the fields alone", chart)
}

/// A wave that has been driven into a conductor for long, at two moments.
fn conductor(setting: &Setting) -> Plot {
    let tau = setting.number("loss_tangent");
    let k = exact_wave_number(tau);
    let depth = k.im.recip();
    let omega = std::f64::consts::TAU * C;
    let period = std::f64::consts::TAU / omega;
    let spacing = depth.min(std::f64::consts::TAU / k.re) / 40.0;
    let medium = Medium::conductor(1.0, tau * omega * light::em::EPSILON_0);
    let (first, cells_deep) = (11, depth / spacing);
    let seen = (5.0 * cells_deep) as usize;
    let setup = Setup {
        background: medium,
        ..Setup::vacuum(first + seen + 2 * cells_deep as usize, spacing, Ends::open(10), Stepping::at(0.9))
    };
    let mut line = Line::new(setup).expect("a line within all limits");
    // Switched on within three periods, and driven until all that is shown has been crossed twice.
    let drive = move |t: f64| (omega * t).cos() * (0.5 - 0.5 * (omega * t / 6.0).min(std::f64::consts::PI).cos());
    line.impose(first, 1.0, Pulse::custom(drive)).expect("a node of the line");
    let dt = line.dt();
    let crossed = 5.0 * depth * k.re / omega;
    // Whole periods, so that it ends at a crest.
    let periods = (12.0 + 2.0 * crossed / period).ceil();
    line.run((periods * period / dt).round() as u64).expect("some steps");
    let shown = first..first + seen;
    let z = |node: usize| (node - first) as f64 / cells_deep;
    let mut chart = Chart::new(
        format!("σ/(ωε) = {tau}"),
        Axis::linear("depth over skin depth", "").range(0.0, 5.0),
        Axis::linear("E over its amplitude at the surface", "").range(-0.25, 1.05),
    );
    for (at, name) in [(0, "at a crest"), (1, "a quarter period later")] {
        let now = line.steps() as f64 * dt;
        let formula = shown.clone().map(|node| {
            let here = (Complex64::i() * (k * z(node) * depth - omega * now)).exp();
            [z(node), here.re]
        });
        let grid = shown.clone().step_by((seen / 60).max(10)).map(|node| [z(node), line.e()[node]]);
        chart = chart.line(Hue::Nth(at), format!("formula, {name}"), formula.collect()).with(Mark::Points {
            label: String::new(),
            hue: Hue::Nth(at),
            shape: Shape::Disc,
            joined: false,
            points: grid.collect(),
        });
        line.run((0.25 * period / dt).round().max(1.0) as u64).expect("some steps");
    }
    let envelope = (0..=100).map(|at| f64::from(at) / 20.0);
    chart = chart.with(Mark::Line {
        label: "e^{−z/δ}".into(),
        hue: Hue::Reference,
        dash: Dash::Dashed,
        points: envelope.map(|z| [z, (-z).exp()]).collect(),
    });
    Plot::of("A wave in a conductor: grid (points) and formula (lines)", Panel::Chart(chart))
}
