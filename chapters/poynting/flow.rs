//! E20: the Poynting vector.

use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::Setting;
use crate::plane_wave::fields::Dipole;
use crate::plane_wave::{GREEN, VACUUM, described, quantity, wave};
use crate::symbols::{B, E, MU, S};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Question, Step, check, exhibit, figure, question, statement, step,
};
use equation::Equation;
use equation::expr::cross;
use glam::DVec3;
use light::waves::flux::Flux;
use light::waves::{Medium, Wave};
use std::f64::consts::{PI, TAU};
use yardstick::quadrature::gauss_legendre;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "flow",
    &[VACUUM, GREEN],
    &[figure(
        "strip",
        "E, H and S of a travelling wave at four instants: S has its peaks wherever the \
         fields have theirs, of either sign.",
        strip,
    )],
);

pub(super) const STEP: Step =
    step(EXHIBIT, "Where the energy goes", "E × B over μ is the power that crosses a unit of area, here and now.")
        .rows(&["E20"])
        .statements(&[statement("poynting", "the instantaneous flow of energy", || {
            Equation::new(S, 1 / MU * cross(E, B))
        })])
        .questions(&[TURNED])
        .readout(|setting| {
            let flux = super::flux(setting);
            vec![
                quantity("S_now", "S(0)", "flow at z = 0 when E is at its peak of 1 V/m", flux.at(0.0), "W/m²"),
                quantity("S_mean", "⟨S⟩", "its mean", flux.mean, "W/m²"),
                quantity("S_swing", "ΔS", "by how much it swings about that", flux.swing, "W/m²"),
            ]
        })
        .checks(&[&LARMOR]);

const TURNED: Question = question(
    "turned",
    "In a clear wave E and H are at their peaks. Half a period later both have turned round. Which sign has S then, \
     counted along the wave?",
    Answer::Sign {
        replies: [
            "E and H both change sign, so their product does not.",
            "S is zero a *quarter* of a period later, where both fields are. At half a period they are at their \
             peaks again.",
            "A product of two negative numbers.",
        ],
        right: |_| half_a_period_later(|flux| flux.at(0.5 / flux.frequency)),
        slip: |_| half_a_period_later(|flux| -flux.at(0.0)),
    },
    "Positive, and as large as before: S has its peaks wherever the fields have theirs, of either sign, twice a \
     period.",
);

/// What is read off the flow of green light in the vacuum.
fn half_a_period_later(read: fn(&Flux) -> f64) -> f64 {
    read(&Flux::at_depth(&Wave::new(&Medium::VACUUM, TAU * 545e12).expect("a positive frequency"), 1.0, 0.0))
}

const LARMOR: Check<fn(f64) -> f64> =
    check("larmor", "through every sphere round an antenna the same power flows, near field or far")
        .against(
            "Larmor's formula p²ω⁴μ/(12πv) against ∮S·n dA of Jackson's dipole field (9.18), \
             averaged over a period",
        )
        .within(
            1e-12,
            "1",
            "sine squared over the sphere and over the period, both integrated exactly; near \
             the dipole fields a hundred times larger cancel",
        )
        .of(larmor, |mu| 1.0 / mu)
        .slip("S = E×B", |_| 1.0);

fn larmor(_: &mut Bench, factor: fn(f64) -> f64) -> Measured {
    let radii = [0.3, 1.0, 2.0, 10.0, 100.0];
    let media = [(1.3, 0.7), (0.2, 1.5)];
    Measured::worst(media.into_iter().flat_map(|(epsilon, speed)| {
        let mu = 1.0 / (epsilon * speed * speed);
        let dipole = Dipole { speed };
        // p = 4πε and k = 1, so ω = v.
        let power = (4.0 * PI * epsilon).powi(2) * f64::powi(speed, 4) * mu / (12.0 * PI * speed);
        radii.map(move |radius| {
            let flow = |cos: f64, time: f64| {
                // The field is the same all round.
                let n = DVec3::new((1.0 - cos * cos).sqrt(), 0.0, cos);
                let (e, b) = (dipole.e(radius * n, time), dipole.b(radius * n, time));
                factor(mu) * e.cross(b).dot(n)
            };
            let moments = 8;
            let mean = |cos: f64| {
                (0..moments).map(|at| flow(cos, TAU / speed * f64::from(at) / f64::from(moments))).sum::<f64>()
                    / f64::from(moments)
            };
            let through: f64 = gauss_legendre(6).iter().map(|(u, weight)| weight * mean(2.0 * u - 1.0)).sum();
            let through = through * 4.0 * PI * radius * radius;
            (through / power - 1.0, format!("kr = {radius}, ε = {epsilon}, v = {speed}"))
        })
    }))
}

fn strip(setting: &Setting) -> Plot {
    let wave = wave(setting);
    let (decay, lag) = (wave.k.im / wave.k.re, wave.phase_lag);
    let panel = |step: u32| {
        let turn = TAU * f64::from(step) / 8.0;
        let e = move |z: f64| (-decay * TAU * z).exp() * (TAU * z - turn).cos();
        let h = move |z: f64| (-decay * TAU * z).exp() * (TAU * z - turn + lag).cos();
        let curve = |value: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            (0..=400).map(|at| f64::from(at) / 200.0).map(|z| [z, value(z)]).collect()
        };
        let axes = Chart::new(
            format!("ωt = {}°", 45 * step),
            Axis::linear("z / λ", "").range(0.0, 2.0),
            Axis::linear("over the amplitudes", "").range(-1.1, 1.1),
        );
        // One key for all four.
        let name = |name: &str| if step == 0 { name.to_owned() } else { String::new() };
        axes.line(Hue::S, name("E"), curve(&e))
            .dashed(Hue::P, name("H"), curve(&h))
            .line(Hue::Transmitted, name("S"), curve(&|z| e(z) * h(z)))
            .at_y(0.0, "")
            .into()
    };
    Plot::grid(format!("Fields and flow in {}", described(setting)), 2, (0..4).map(panel).collect())
}
