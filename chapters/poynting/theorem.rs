//! C3: which way the energy flows, and that none is lost on the books.

use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Hue, Plot};
use crate::parameter::{FREQUENCY, MEDIUM, Setting};
use crate::plane_wave::fields::{Plane, crowd, direction, outflows, over_time};
use crate::plane_wave::transverse::across_k;
use crate::plane_wave::{quantity, wave};
use crate::symbols::{A_VECTOR, B, D, E, EPSILON, H, J, K_VECTOR, MU, OMEGA, S, T, U_DENSITY};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Misled, Quantity, Question, Step, check, derivation, exhibit,
    figure, question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{cross, curl, divergence, dot, partial};
use equation::{Equation, Expr};
use glam::DVec3;
use light::Complex64;
use light::media;
use light::references::waves::{NAMES, PlaneWave};
use light::waves::constants::{C, EPSILON_0, MU_0};
use light::waves::energy::Running;
use light::waves::{Medium, Wave};
use std::f64::consts::TAU;
use yardstick::precise::{self, Real};
use yardstick::quadrature::gauss_legendre;
use yardstick::random::uniform;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "theorem",
    &[MEDIUM, FREQUENCY],
    &[figure(
        "books",
        "The books of the slab: what enters, what leaves, and what it turns to heat. Over a whole period nothing more is stored.",
        books,
    )],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "The balance",
    "What flows into a box is stored there or turned to heat; the flow runs with the wave.",
)
.rows(&["C3"])
.statements(&[
    statement(
        "work",
        "Poynting's theorem, whatever the medium: what the flow brings works on fields and matter",
        || Equation::new(divergence(S) + work(), -dot(J, E)),
    ),
    statement("density", "the energy that the fields hold, where ε and μ are constants that answer at once", || {
        Equation::new(U_DENSITY, density())
    }),
    statement("balance", "the same theorem in such a medium", || {
        Equation::new(divergence(S) + partial(U_DENSITY, T), -dot(J, E))
    }),
    statement("direction", "the flow of a plane wave in a clear medium runs along k", || {
        Equation::new(S, dot(E, E) / (OMEGA * MU) * K_VECTOR)
    }),
])
.questions(&[PASSES])
.derivations(&[
    derivation("any_medium", "from the two curls of Maxwell's equations alone", || any_medium(-dot(J, E)))
        .slip("the work of the field on the current counted as a gain", || any_medium(dot(J, E))),
    derivation("poynting", "and where D = εE and B = μH with constants", || balance(-dot(J, E)))
        .slip("the work of the field on the current counted as a gain", || balance(dot(J, E))),
    derivation("along_k", "B is k×E/ω, and E stands across k", || along_k(dot(E, E) / (OMEGA * MU) * K_VECTOR))
        .slip("the two factors of E×B interchanged", || along_k(-(dot(E, E) / (OMEGA * MU) * K_VECTOR))),
])
.readout(readout)
.checks(&[&BOX, &SLAB, &SILVER, &ALONG_K])
.stress(&[stress(
    "thin_and_weak",
    "what a slab takes from the flow keeps its digits however thin or clear it is",
    |_| thin_and_weak(),
)
.textbook("the flow at the far face less that at the near one")
.against("⟨S⟩(e^(−2 Im k d) − 1) in 256 bits, from ε, μ, σ and ω")]);

const PASSES: Question = question(
    "passes",
    "Power flows into copper, where the field falls to 1/e over a skin depth. Which share of the power passes the \
     first skin depth? The rest is heat.",
    Answer::Number {
        unit: "1",
        tolerance: 0.01,
        right: |_| {
            let copper = media::named("copper").and_then(|copper| copper.medium(1e9).ok()).expect("known at 1 GHz");
            let running = Running::new(copper, TAU * 1e9, 1.0).expect("a positive frequency");
            let wave = running.wave();
            // By Ohm's heat, not by the flow.
            1.0 - running.mean_balance(0.0, wave.skin_depth).heat / wave.mean_flux
        },
        slips: &[
            Misled {
                value: |_| (-1f64).exp(),
                reply: "So much of the field. S is a product of two fields, and both \
             fall.",
            },
            Misled {
                value: |_| 0.5,
                reply: "1/e is no half, and it is the field that falls to it; S has two of \
             them.",
            },
        ],
    },
    "e⁻², 13.5 %: nearly all the heat is made within a skin depth.",
);

fn density() -> Expr {
    (EPSILON * dot(E, E) + MU * dot(H, H)) / 2
}

/// What the fields do to matter and to each other, per time and volume.
fn work() -> Expr {
    dot(E, partial(D, T)) + dot(H, partial(B, T))
}

fn any_medium(heat: Expr) -> Chain {
    Chain::new(divergence(S))
        .given(S, cross(E, H), "S = E×H")
        .given(partial(B, T), -curl(E), "∇×E = −∂B/∂t")
        .given(partial(D, T), curl(H) - J, "∇×H = J + ∂D/∂t")
        .then(dot(H, curl(E)) - dot(E, curl(H)), ["∇·(E×H)"])
        .then(-work() - dot(J, E), ["∇×E = −∂B/∂t", "∇×H = J + ∂D/∂t"])
        .then(Equation::new(divergence(S) + work(), heat), ["to the left"])
}

fn balance(heat: Expr) -> Chain {
    Chain::new(divergence(S))
        .given(S, cross(E, H), "S = E×H")
        .given(U_DENSITY, density(), "u = ½(εE² + μH²)")
        .given(partial(H, T), -curl(E) / MU, "∇×E = −∂B/∂t")
        .given(partial(E, T), (curl(H) - J) / EPSILON, "∇×H = J + ∂D/∂t")
        .then(dot(H, curl(E)) - dot(E, curl(H)), ["∇·(E×H)"])
        .then(
            -(MU * dot(H, partial(H, T))) - EPSILON * dot(E, partial(E, T)) - dot(J, E),
            ["∇×E = −∂B/∂t", "∇×H = J + ∂D/∂t"],
        )
        .then(-partial(U_DENSITY, T) - dot(J, E), ["u = ½(εE² + μH²)"])
        .then(Equation::new(divergence(S) + partial(U_DENSITY, T), heat), ["to the left"])
}

fn along_k(last: Expr) -> Chain {
    let chain = Chain::new(cross(E, B) / MU)
        .because("S of a wave in the direction k, where and when E = A")
        .given(E, A_VECTOR, "E at this place and time")
        .given(B, cross(K_VECTOR, E) / OMEGA, "B = k×E/ω");
    across_k(chain)
        .then((dot(E, E) * K_VECTOR - dot(K_VECTOR, E) * E) / (OMEGA * MU), ["a×(b×a)"])
        .then(last, ["k·A = 0"])
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let wave = wave(setting);
    let depth = if wave.skin_depth.is_finite() { wave.skin_depth } else { wave.wavelength };
    let heat = -wave.mean_flux * (-2.0 * wave.k.im * depth).exp_m1();
    vec![
        quantity("slab", "d", "a slab one skin depth thick; a wavelength where there is none", depth, "m"),
        quantity("entering", "⟨S⟩", "what enters it, at 1 V/m", wave.mean_flux, "W/m²"),
        quantity("heat", "Q", "what it turns to heat", heat, "W/m²"),
        quantity("leaving", "⟨S⟩(d)", "what leaves it", wave.mean_flux - heat, "W/m²"),
    ]
}

const BOX: Check<f64> = check("box", "in a tangle of twenty waves, what a box gains is what flows in")
    .against("the energy in the box at two times, against the flow through its faces in between, by Gauss's rule")
    .within(
        1e-11,
        "1",
        "Gauss's rule is exact to rounding here; the flow is a small difference of what twenty waves carry",
    )
    .of(tangled, 1.0)
    .slip("half of the magnetic energy forgotten", 0.5);

fn tangled(bench: &mut Bench, magnetic: f64) -> Measured {
    let glass = Medium::relative(2.25, 1.2, 0.0).expect("a clear medium");
    let lambda = 550e-9;
    let omega = TAU * C / lambda;
    let waves: Vec<Plane> = crowd(&mut bench.stream, &glass, omega, 20);
    let fields = |place, time| {
        let both = waves.iter().map(|wave| wave.at(place, time));
        both.fold((DVec3::ZERO, DVec3::ZERO), |(e, b), (more_e, more_b)| (e + more_e, b + more_b))
    };
    let flow = |place, time| {
        let (e, b) = fields(place, time);
        e.cross(b) / glass.mu()
    };
    let density = |place, time| {
        let (e, b) = fields(place, time);
        0.5 * (glass.epsilon() * e.length_squared() + magnetic * b.length_squared() / glass.mu())
    };
    let rule = gauss_legendre(10);
    let side = 0.25 * lambda;
    Measured::worst((0..3).map(|round| {
        let mut length = || uniform(&mut bench.stream, -3.0, 3.0) * lambda;
        let corner = DVec3::new(length(), length(), length());
        let held = |time: f64| {
            let mut total = 0.0;
            for (x, a) in &rule {
                for (y, b) in &rule {
                    for (z, c) in &rule {
                        total += a * b * c * density(corner + side * DVec3::new(*x, *y, *z), time);
                    }
                }
            }
            total * side.powi(3)
        };
        let (from, to) = (0.0, 0.7 / omega);
        let out = |time: f64| outflows(&flow, corner, side, time);
        let lost = over_time(from, to, |time| out(time).iter().sum());
        let crossed = over_time(from, to, |time| out(time).iter().map(|flow| flow.abs()).sum());
        ((held(to) - held(from) + lost) / crossed, format!("round {round}"))
    }))
}

const SLAB: Check<f64> =
    check("slab", "in a conductor what does not come out is heat, at every instant and on average")
        .against("σE² and the stored energy integrated by Gauss's rule, against the flow at the two faces")
        .within(1e-11, "1", "sixty points a slab; the smooth rest is rounding")
        .of(slabs, 1.0)
        .slip("the heat left out", 0.0);

fn slabs(_: &mut Bench, heat: f64) -> Measured {
    let omega = 1e9;
    let tangents = [0.0, 1e-3, 1.0, 30.0, 1e9];
    Measured::worst(tangents.into_iter().flat_map(|tangent| {
        let medium = Medium::relative(3.0, 1.0, tangent * omega * 3.0 * EPSILON_0).expect("a medium");
        let running = Running::new(medium, omega, 2.0).expect("a positive frequency");
        let (near, far) = (0.1 * running.wave().wavelength, 0.8 * running.wave().wavelength);
        let rule = gauss_legendre(60);
        let over = |f: &dyn Fn(f64) -> f64| -> f64 {
            rule.iter().map(|(u, weight)| weight * (far - near) * f(near + u * (far - near))).sum()
        };
        let scale = running.balance(near, far, 0.0).scale;
        (0..4)
            .map(move |quarter| {
                // A stretch of time that is no part of a period, so that storing, heating and flowing all count.
                let (from, to) = (1.3 * f64::from(quarter) / omega, (1.3 * f64::from(quarter) + 0.9) / omega);
                let stored = |time| over(&|z| running.energy_density(z, time));
                let heated = over_time(from, to, |time| over(&|z| running.heating(z, time)));
                let out = over_time(from, to, |time| running.flux(far, time) - running.flux(near, time));
                let missing = stored(to) - stored(from) + heat * heated + out;
                (missing / (scale * (to - from)), format!("σ/(ωε) = {tangent}, stretch {quarter}"))
            })
            .collect::<Vec<_>>()
    }))
}

/// The part of a complex permittivity that the displacement is taken with.
type Displaced = fn(Complex64) -> Complex64;

const SILVER: Check<Displaced> = check(
    "silver",
    "in silver at 545 THz, where ½(εE² + μH²) would be negative, the flow still balances the work E·∂D/∂t + H·∂B/∂t",
)
.against("the work integrated by Gauss's rule, D from the measured index alone, against the flow at the two faces")
.within(1e-11, "1", "sixty points a slab; the smooth rest is rounding")
.of(silver, |epsilon| epsilon)
.slip("a stored energy in its place: the permittivity without what it absorbs", |epsilon| epsilon.re.into());

fn silver(_: &mut Bench, displaced: Displaced) -> Measured {
    let (frequency, silver) = (545e12, media::named("silver").expect("a substance"));
    let wave = silver.wave(frequency).expect("measured there");
    let index = silver.optics.as_ref().and_then(|optics| optics.index(C / frequency)).expect("measured there");
    let permittivity = displaced(EPSILON_0 * index * index);
    let omega = TAU * frequency;
    // E is 1 V/m at the near face; a time derivative is a factor −iω.
    let fields = |z: f64, time: f64| {
        let e = (Complex64::i() * (wave.k * z - omega * time)).exp();
        let (h, late) = (e / wave.impedance, Complex64::new(0.0, -omega));
        (e, h, late * permittivity * e, late * MU_0 * h)
    };
    let rule = gauss_legendre(60);
    let depth = 0.5 / wave.k.im;
    let cases = (0..8).map(|eighth| {
        let time = (f64::from(eighth) + 0.3) / 8.0 / frequency;
        let flow = |z: f64| {
            let (e, h, ..) = fields(z, time);
            e.re * h.re
        };
        let power = |z: f64| {
            let (e, h, d_late, b_late) = fields(z, time);
            e.re * d_late.re + h.re * b_late.re
        };
        let work: f64 = rule.iter().map(|(u, weight)| depth * weight * power(u * depth)).sum();
        ((flow(depth) - flow(0.0) + work) / (1.0 / wave.impedance.norm()), format!("t = {time:e} s"))
    });
    Measured::worst(cases.collect::<Vec<_>>())
}

const ALONG_K: Check<fn(DVec3, DVec3) -> DVec3> =
    check("flows_along_k", "S points along the propagation, whatever the direction and the moment")
        .against("E×B of waves in random directions, against k; the sign too")
        .within(16.0, "ulp", "two cross products of unit vectors")
        .of(along, |e, b| e.cross(b))
        .slip("B×E", |e, b| b.cross(e));

fn along(bench: &mut Bench, flow: fn(DVec3, DVec3) -> DVec3) -> Measured {
    let medium = Medium::relative(2.25, 1.0, 0.0).expect("a clear medium");
    Measured::worst((0..200).map(|_| {
        let (run, swing) = (direction(&mut bench.stream), direction(&mut bench.stream));
        let time = uniform(&mut bench.stream, 0.0, 1e-14);
        let (e, b) = Plane::new(&medium, 3e15, run, swing, 0.0).at(DVec3::ZERO, time);
        let off = (flow(e, b).normalize() - run).length();
        (off / f64::EPSILON, format!("k along {run:.3}"))
    }))
}

fn thin_and_weak() -> Vec<Extreme> {
    let media = [(1.0, 5.8e7), (80.0, 4.0), (2.1, 1e-12), (2.1, 1e-20), (1.0006, 1e-15)];
    let depths = [1e-12, 1e-9, 1e-6, 1e-3, 1.0];
    let each = media.into_iter().flat_map(|medium| [1e9, 5.45e14].map(|f| (medium, f)));
    let each = each.flat_map(|case| depths.map(|depth| (case, depth)));
    each.map(|(((epsilon_r, sigma), f), depth)| {
        let medium = Medium::relative(epsilon_r, 1.0, sigma).expect("a medium");
        let wave = Wave::new(&medium, TAU * f).expect("a positive frequency");
        let exact = PlaneWave::new(&medium, TAU * f);
        let conditions = exact.conditions();
        let at = |name: &str| NAMES.iter().position(|known| *known == name).expect("an output");
        let (flux, decay) = (at("S_avg"), at("k_im"));
        let finite = |at: usize| exact.outputs[at].clone().expect("a finite output");
        let fall: Real = finite(decay) * precise::real(2.0) * precise::real(depth);
        let reference = finite(flux) * (-&fall).exp_m1();
        let running = Running::new(medium, TAU * f, 1.0).expect("a finite conductivity");
        let flow = |z: f64| wave.mean_flux * (-2.0 * wave.k.im * z).exp();
        // d ln(1 − e^(−x))/d ln x = x/(e^x − 1).
        let x = precise::to_f64(&fall);
        let steepness = if x == 0.0 { 1.0 } else { x / x.exp_m1() };
        Extreme {
            input: format!("ε_r = {epsilon_r}, σ = {sigma:e} S/m, f = {f:e} Hz, d = {depth:e} m"),
            quantity: "ΔS",
            reference,
            textbook: flow(depth) - flow(0.0),
            ours: running.mean_balance(0.0, depth).outflow,
            condition: conditions[flux] + steepness * (1.0 + conditions[decay]),
            worst_of: 1,
        }
    })
    .collect()
}

/// The mean flows through the setting's slab, as long as they are large.
fn books(setting: &Setting) -> Plot {
    let wave = wave(setting);
    let depth = if wave.skin_depth.is_finite() { wave.skin_depth } else { wave.wavelength };
    let left = (-2.0 * wave.k.im * depth).exp();
    let left = if left.is_finite() { left } else { 0.0 };
    let [near, far] = [-0.8, 0.8];
    let slab = vec![[near, -0.75], [far, -0.75], [far, 0.75], [near, 0.75], [near, -0.75]];
    let share = |name: &str, of: f64| format!("{name}: {:.1} %", 100.0 * of);
    let diagram = Diagram::new(crate::plane_wave::described(setting), [-2.6, -1.2], [2.6, 1.2])
        .with(Part::surface([near, 0.75], [near, -0.75], Behind::Nothing))
        .with(Part::curve(slab))
        .with(Part::ray([near - 1.5, 0.0], [near - 0.05, 0.0]).hue(Hue::Natural).label("enters: 100 %"))
        .with(
            Part::ray([far + 0.05, 0.0], [far + 0.05 + 1.5 * left.max(0.05), 0.0])
                .hue(Hue::Transmitted)
                .label(share("leaves", left)),
        )
        .with(Part::note([-0.6, 0.25], share("heat", 1.0 - left)).hue(Hue::P))
        .with(Part::note([-0.6, -0.25], "−∇·S = J·E"))
        .with(Part::line([near, -0.95], [far, -0.95]).hue(Hue::Reference).label("d"));
    Plot::of("The books of a slab", diagram)
}
