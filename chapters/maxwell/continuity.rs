//! E2: charge is conserved, because a curl has no divergence.

use super::heat::HEAT;
use crate::parameter::Setting;
use crate::symbols::{D, E, EPSILON, H, J, RHO, SIGMA, T};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Question, Step, check, derivation, exhibit, question, statement,
    step,
};
use equation::derivation::Chain;
use equation::expr::{curl, divergence, partial};
use equation::{Equation, Expr};
use light::Polarisation;
use light::em::ledger::Balance;
use light::em::line::{self, Ends};
use light::em::plane::{Plane, Region, Setup, Sides};
use light::em::{C, Line, Medium, Pulse, Stepping, Z_0};
use light::media;
use light::waves::constants::EPSILON_0;
use yardstick::random::uniform;

pub(super) const EXHIBIT: Exhibit = exhibit("continuity", &[], &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Charge is conserved",
    "The four laws leave charge no way to vanish: what leaves a place as current is \
     missing there.",
)
.rows(&["E2"])
.statements(&[
    statement("continuity", "what flows away is missing", || Equation::new(divergence(J), -partial(RHO, T))),
    statement("relaxation", "in a uniform conductor charge dies away where it is, in the time ε/σ", || {
        Equation::new(partial(RHO, T), -(SIGMA / EPSILON * RHO))
    }),
])
.questions(&[SURPLUS])
.derivations(&[
    derivation("from_maxwell", "the divergence of Ampère's law, with Gauss's", || continuity(divergence(J)))
        .slip("the sign of the current in ∇×H = J + ∂D/∂t", || continuity(-divergence(J))),
    derivation("dies_away", "continuity with J = σE and D = εE: no place and no wave in it, only a time", || {
        relaxation(-(SIGMA / EPSILON * RHO))
    })
    .slip("the charge draws more to itself", || relaxation(SIGMA / EPSILON * RHO)),
])
.readout(readout)
.checks(&[&KEPT, &ENERGY_KEPT, &HEAT]);

const SURPLUS: Question = question(
    "surplus",
    "In the middle of a block of salt water there is, for a moment, a little too much positive charge. Which sign \
     has ∇·J there?",
    Answer::Sign {
        replies: [
            "Then current would run together where there is too much already, and the surplus would grow. But field \
             lines begin at positive charge, and drive the current away from it.",
            "So it is in a wire under a steady current, where no charge is left over. Here the charge makes a \
             field, and the field a current.",
            "The field begins at positive charge and takes the current with it, outwards.",
        ],
        // ∇·J = σ ∇·E = σρ/ε, for a surplus of 1 C/m³.
        right: |_| {
            let water = media::named("sea-water").and_then(|water| water.medium(50.0).ok()).expect("known at 50 Hz");
            water.sigma() * (1.0 / water.epsilon())
        },
        slip: |_| 0.0,
    },
    "Current leaves, so ∇·J is positive and the surplus dies away, in the time ε/σ and without a wave: it never \
     spreads through the block, it appears on the outside.",
);

fn continuity(last: Expr) -> Chain {
    Chain::new(-partial(RHO, T))
        .given(RHO, divergence(D), "∇·D = ρ")
        .given(partial(D, T), curl(H) - J, "∇×H = J + ∂D/∂t")
        .then(-partial(divergence(D), T), ["∇·D = ρ"])
        .then(-divergence(partial(D, T)), ["derivatives commute"])
        .then(-divergence(curl(H) - J), ["∇×H = J + ∂D/∂t"])
        .then(last, ["∇·(∇×H) = 0"])
        .because("a field that only circles carries nothing out of any volume")
}

fn relaxation(last: Expr) -> Chain {
    Chain::new(partial(RHO, T))
        .given(RHO, divergence(D), "∇·D = ρ")
        .given(D, EPSILON * E, "D = εE")
        .given(J, SIGMA * E, "J = σE")
        .given(partial(E, T), (curl(H) - J) / EPSILON, "∇×H = J + ∂D/∂t")
        .then(-divergence(J), ["continuity"])
        .then(-(SIGMA * divergence(E)), ["J = σE", "σ is the same everywhere"])
        .then(last, ["D = εE", "∇·D = ρ"])
}

fn readout(_: &Setting) -> Vec<Quantity> {
    let forgets =
        |key, says, epsilon: f64, sigma: f64| Quantity {
            key, symbol: "ε/σ", says, value: epsilon / sigma, unit: "s"
        };
    let named = |key, says, name| {
        let medium = media::named(name).and_then(|substance| substance.medium(50.0).ok()).expect("known at 50 Hz");
        forgets(key, says, medium.epsilon(), medium.sigma())
    };
    vec![
        named("copper", "copper forgets a charge in", "copper"),
        named("sea_water", "sea water in", "sea-water"),
        named("water", "pure water in", "water"),
        forgets("fused_silica", "fused silica of σ = 10⁻¹⁸ S/m in", 3.78 * EPSILON_0, 1e-18),
    ]
}

const KEPT: Check<usize> = check(
    "kept_on_the_grid",
    "at every node and in every step of a full-field run the charge that flows away is \
     missing, and no magnetic flux ends",
)
.rows(&["E1", "E2"])
.against(
    "the fluxes out of each cell added up before and after a step; currents from Ohm's \
     law and the electrons' equation, not from the update",
)
.within(
    64.0,
    "ulp",
    "a dozen roundings of the terms, relative to the largest of them, at the worst of \
     the 200 000 nodes and steps",
)
.of(unkept, 24)
.slip("the current of the source is not counted", 8);

/// The largest failure of continuity in the rows from `first` to 36 of a plane with glass, a conductor and a metal, lit by a current in row 12.
fn unkept(bench: &mut Bench, first: usize) -> Measured {
    const CELLS: [usize; 2] = [40, 60];
    let cases = [Polarisation::P, Polarisation::S].into_iter().flat_map(|polarisation| {
        let mut shift = || uniform(&mut bench.stream, -4.0, 4.0);
        let regions = vec![
            Region::disc([12.0 + shift(), 30.0 + shift()], 6.0, Medium::dielectric(2.25)),
            Region::disc([28.0 + shift(), 30.0 + shift()], 7.0, Medium::conductor(4.0, 5e-3)),
            Region::disc([20.0 + shift(), 34.0 + shift()], 5.0, Medium::metal(0.4 * C, 0.01 * C)),
        ];
        let vacuum = Setup::vacuum(CELLS, 1.0, polarisation, Stepping::at(0.7));
        let mut plane = Plane::new(Setup { regions, sides: Sides::Bloch(0.0), ..vacuum }).expect("within all limits");
        plane.inject([20, 12], 1.0, Pulse::Gaussian { delay: 20.0 / C, width: 5.0 / C }).expect("a stepped place");
        (1..=200).map(move |step| {
            let balance = plane.audited_step(first..=36).expect("rows between the walls");
            (balance.divergence / f64::EPSILON, format!("{polarisation:?}, step {step}"))
        })
    });
    Measured::worst(cases.collect::<Vec<_>>())
}

const ENERGY_KEPT: Check<fn(Balance) -> Balance> = check(
    "energy_kept",
    "in every step the energy of the fields and electrons in a part of the grid \
     changes by what flows in less the heat",
)
.rows(&["C3"])
.against(
    "the energies of all cells added up before and after a step, beside E × H through \
     the border and Ohm's heat; whether ε, σ and the electrons are those of the medium, \
     both sides would agree on: that is what heat_of_a_pulse is for",
)
.within(
    256.0,
    "ulp",
    "the roundings of sums over up to 520 cells, of either sign, relative to the \
     energy there is",
)
.of(unbalanced, |balance| balance)
.slip("the heat is left out", |balance| Balance { heat: 0.0, ..balance });

/// The worst balance of energy as `read`, along a line and in a plane, in vacuum and with each kind of medium.
fn unbalanced(bench: &mut Bench, read: fn(Balance) -> Balance) -> Measured {
    let media = [
        ("vacuum", Medium::VACUUM),
        ("glass", Medium::dielectric(2.25)),
        ("conductor", Medium::conductor(4.0, 5e-3)),
        ("metal", Medium::metal(0.4 * C, 0.01 * C)),
    ];
    let mut cases = Vec::new();
    for (name, medium) in media {
        let shift = uniform(&mut bench.stream, -4.0, 4.0);
        let mut line = along_a_line(medium, shift);
        let mut planes = [Polarisation::P, Polarisation::S].map(|polarisation| in_a_plane(polarisation, medium, shift));
        for step in 1..=200 {
            let mut book = |place: &str, balance: Balance| {
                cases.push((read(balance).residual() / f64::EPSILON, format!("{name}, {place}, step {step}")));
            };
            book("line", line.audited_step(20..=80).expect("nodes between the walls"));
            for plane in &mut planes {
                book("plane", plane.audited_step(24..=36).expect("rows between the walls"));
            }
        }
    }
    Measured::worst(cases)
}

/// A wave on its way into a layer of `medium`.
fn along_a_line(medium: Medium, shift: f64) -> Line {
    let vacuum = line::Setup::vacuum(100, 1.0, Ends::open(10), Stepping::at(0.7));
    let mut line = Line::new(line::Setup { layers: vec![(45..60, medium)], ..vacuum }).expect("within all limits");
    let wave = |z: f64| (-((z - 35.0 - shift) / 6.0).powi(2)).exp();
    line.set(wave, |z| wave(z) / Z_0);
    line
}

/// A disc of `medium` above a current.
fn in_a_plane(polarisation: Polarisation, medium: Medium, shift: f64) -> Plane {
    let regions = vec![Region::disc([20.0 + shift, 30.0 + shift], 7.0, medium)];
    let vacuum = Setup::vacuum([40, 60], 1.0, polarisation, Stepping::at(0.7));
    let mut plane = Plane::new(Setup { regions, sides: Sides::Bloch(0.0), ..vacuum }).expect("within all limits");
    plane.inject([20, 12], 1.0, Pulse::Gaussian { delay: 20.0 / C, width: 5.0 / C }).expect("a stepped place");
    plane
}
