//! E3: what matter adds, as numbers or as tensors.

use crate::figure::{Axis, Chart, Hue, Plot};
use crate::parameter::{Kind, Parameter, Setting};
use crate::symbols::{B, D, E, EPSILON, H, J, MU, SIGMA};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Quantity, Question, Step, check, derivation, exhibit, figure, question,
    statement, step,
};
use equation::derivation::Chain;
use equation::expr::vector;
use equation::{Dimension, Equation, Expr, Symbol};
use light::fields::tensor::{Tensor, hall_conductivity};
use light::fields::{Vector, cross, dot};
use yardstick::initial_value::runge_kutta;
use yardstick::random::uniform;

const ORDINARY: Parameter =
    Parameter::new("n_o", "n_o", "index across the crystal's axis (calcite, 589 nm)", Kind::number(1.0, 5.0, "1"))
        .default("1.6584");
const EXTRAORDINARY: Parameter =
    Parameter { name: "n_e", symbol: "n_e", says: "index along the crystal's axis", ..ORDINARY.default("1.4864") };

pub(super) const EXHIBIT: Exhibit = exhibit(
    "media",
    &[ORDINARY, EXTRAORDINARY],
    &[figure("walk_off", "In a crystal D leans away from E, except along its axes.", walk_off)],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What matter adds",
    "Three numbers, ε, μ and σ, tie the fields together; they are tensors that symmetry makes numbers.",
)
.rows(&["E3"])
.statements(&[
    statement("electric", "charges held in place give way to the field", || Equation::new(D, EPSILON * E)),
    statement("magnetic", "so do the little currents in the atoms", || Equation::new(B, MU * H)),
    statement("ohm", "free charges drift", || Equation::new(J, SIGMA * E)),
    statement("tensor", "where directions differ, the first of the three in full", || {
        Equation::new(D, of([E_X, E_Y, E_Z].map(Expr::from)))
    }),
])
.questions(&[MARBLE])
.derivations(&[derivation(
    "isotropy",
    "a medium that looks the same after quarter turns about two axes has one number for a tensor",
    || isotropy((&ENTRIES[0]).into()),
)
.slip("the trace for a third of it", || isotropy(&ENTRIES[0] + &ENTRIES[4] + &ENTRIES[8]))])
.readout(readout)
.checks(&[&POWDER, &GRAINS, &HALL]);

const MARBLE: Question = question(
    "marble",
    "Marble is a block of calcite grains that point everywhere. Take the mean of ε over all directions of a grain \
     away from the block's ε: what sign has the rest?",
    Answer::Sign {
        replies: [
            "A grain that lies with its large ε along the field weakens the field in itself, and so counts for \
             less.",
            "So it would be if the field were the same in every grain. But each weakens the field in itself, the \
             more the larger its ε along it.",
            "No arrangement of grains has more than the mean: that would be reached if the field were the same in \
             all.",
        ],
        right: |_| {
            let [across, along] = [1.6584_f64, 1.4864].map(|index| index * index);
            let calcite = Tensor::diagonal([across, across, along]);
            calcite.of_grains() - calcite.isotropic_part()
        },
        slip: |_| 0.0,
    },
    "The mean is too large, if only by a little: where ε is large, the field is weak.",
);

const fn entry(name: &'static str) -> Symbol {
    Symbol::scalar(name, Dimension::FARAD_PER_METRE)
}

/// ε as a tensor, row by row.
const ENTRIES: [Symbol; 9] = [
    entry("epsilon_xx"),
    entry("epsilon_xy"),
    entry("epsilon_xz"),
    entry("epsilon_yx"),
    entry("epsilon_yy"),
    entry("epsilon_yz"),
    entry("epsilon_zx"),
    entry("epsilon_zy"),
    entry("epsilon_zz"),
];
const E_X: Symbol = Symbol::scalar("E_x", Dimension::VOLT_PER_METRE);
const E_Y: Symbol = Symbol::scalar("E_y", Dimension::VOLT_PER_METRE);
const E_Z: Symbol = Symbol::scalar("E_z", Dimension::VOLT_PER_METRE);

/// What the tensor makes of a vector, component by component.
fn components(v: [Expr; 3]) -> [Expr; 3] {
    [0, 3, 6].map(|row| &ENTRIES[row] * &v[0] + &ENTRIES[row + 1] * &v[1] + &ENTRIES[row + 2] * &v[2])
}

fn of(v: [Expr; 3]) -> Expr {
    let [x, y, z] = components(v);
    vector(x, y, z)
}

/// Turning the field by a quarter turn turns D with it; three such statements leave one of nine numbers.
fn isotropy(number: Expr) -> Chain {
    let column = |at: usize| [0, 3, 6].map(|row| Expr::from(&ENTRIES[row + at]));
    let [x, y, z] = [0, 1, 2].map(column);
    let alike = |turned: [Expr; 3], own: &[Expr; 3]| {
        let [a, b, c] = turned;
        let [p, q, r] = own.clone();
        Equation::new(vector(a, b, c), vector(p, q, r))
    };
    let about_z = [-&x[1], x[0].clone(), x[2].clone()];
    let about_x = [y[0].clone(), -&y[2], y[1].clone()];
    Chain::assume(alike(about_z, &y), "turned about z, x becomes y")
        .and(alike(about_x, &z), "turned about x, y becomes z")
        .and(Equation::new(-&z[1], &z[0]), "turned about z, z stays")
        .and(Equation::new(&z[0], &z[1]), "turned about z, z stays")
        .then(Equation::new(of([E_X, E_Y, E_Z].map(Expr::from)), number * vector(E_X, E_Y, E_Z)), ["linear solve"])
        .because("the glass, the cubic crystal and the block of many grains: D = εE with a number ε")
}

/// ε/ε₀ of the setting's crystal, its axis along z.
fn crystal(setting: &Setting) -> Tensor {
    let [across, along] = ["n_o", "n_e"].map(|name| setting.number(name).powi(2));
    Tensor::diagonal([across, across, along])
}

/// The angle [rad] between two vectors.
fn between(a: Vector, b: Vector) -> f64 {
    let across = cross(a, b);
    dot(across, across).sqrt().atan2(dot(a, b))
}

/// D leans by this angle [rad] if E stands at `angle` [rad] to the crystal's axis.
fn leaning(crystal: &Tensor, angle: f64) -> f64 {
    let e = [angle.sin(), 0.0, angle.cos()];
    between(e, crystal.of(e))
}

fn readout(setting: &Setting) -> Vec<Quantity> {
    let crystal = crystal(setting);
    let angles = (0..=900).map(|tenth| (f64::from(tenth) / 10.0).to_radians());
    let most = angles.map(|angle| leaning(&crystal, angle)).max_by(f64::total_cmp).expect("some angles");
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("epsilon_across", "ε_xx/ε_0", "relative permittivity across the axis", crystal.0[0][0], "1"),
        quantity("epsilon_along", "ε_zz/ε_0", "relative permittivity along the axis", crystal.0[2][2], "1"),
        quantity(
            "epsilon_mean",
            "⟨ε⟩/ε_0",
            "mean over all directions: no block of grains has more",
            crystal.isotropic_part(),
            "1",
        ),
        quantity("epsilon_grains", "ε/ε_0", "of such a block, by Bruggeman's estimate", crystal.of_grains(), "1"),
        quantity("lean", "∠(D, E)", "largest angle between D and E", most, "rad"),
    ]
}

const POWDER: Check<fn() -> Vec<Tensor>> = check(
    "powder",
    "the mean of a tensor over the turns of a cube is a third of its trace, the same in all directions",
)
.against("random tensors turned by all 24 rotations that map a cube to itself, added up")
.within(16.0, "ulp", "products with 0 and ±1 are exact; what rounds are the 24 additions")
.of(powder, turns_of_a_cube)
.slip("turns about one axis only", || {
    let keeps_z = |turn: &Tensor| turn.0[2] == [0.0, 0.0, 1.0];
    turns_of_a_cube().into_iter().filter(keeps_z).collect()
});

const GRAINS: Check<fn(&Tensor) -> f64> = check(
    "grains",
    "grains that point everywhere, each a ball in what all of them make together, leave \
     no dipole in it on average",
)
.against(
    "the field in a ball by separation of variables: potentials inside and outside, D and \
     the potential the same on its face",
)
.within(32.0, "ε", "a dozen roundings in the solution and as many in the dipoles, as a relative change of ε")
.of::<fn(&Tensor) -> f64>(grains, Tensor::of_grains)
.slip("the mean over all directions, as if the field were the same in every grain", Tensor::isotropic_part);

/// What the balls that show each of their axes to the field leave as a dipole, over what ε changes it by, in ε: in the
/// setting's crystal and in others.
fn grains(bench: &mut Bench, estimate: fn(&Tensor) -> f64) -> Measured {
    let own = crystal(bench.setting());
    let mut axis = || uniform(&mut bench.stream, 0.0, 3.0).exp();
    let others = [(); 20].map(|()| Tensor::diagonal([axis(), axis(), axis()]));
    Measured::worst(others.into_iter().chain([own]).map(|crystal| {
        let block = estimate(&crystal);
        let axes = [0, 1, 2].map(|axis| crystal.0[axis][axis]);
        let left: f64 = axes.iter().map(|own| dipole(*own, block)).sum();
        let slope: f64 = axes.iter().map(|own| 3.0 * own * block / (own + 2.0 * block).powi(2)).sum();
        (left / slope / f64::EPSILON, format!("ε = {axes:.3?}"))
    }))
}

/// The dipole p of a ball of ε = `own` in ε = `around`, in units of its radius and the field: Φ = −ar cos θ inside and
/// (p/r² − r) cos θ outside make a = 1 − p, and D makes own·a = around·(1 + 2p).
fn dipole(own: f64, around: f64) -> f64 {
    (own - around) / (own + 2.0 * around)
}

const HALL: Check<f64> = check(
    "drifting_electrons",
    "the conductivity tensor in a magnetic field, and J = σE without one, are where driven electrons settle",
)
.against("Newton's law with friction for one electron, stepped by Runge and Kutta's method until it drifts steadily")
.within(
    1e-12,
    "1",
    "a fixed point of the equations is one of the steps too: what remains is e^(−40) of the start, and rounding",
)
.of(drift, 1.0)
.slip("the electron turns the wrong way round the magnetic field", -1.0);

/// The drift of u′ = e − u + `sense` u×b (time in units of τ, velocity so that J = σ₀u) against the tensor.
fn drift(bench: &mut Bench, sense: f64) -> Measured {
    let strengths = [0.0, 0.1, 1.0, 3.0];
    Measured::worst(strengths.map(|strength| {
        let mut random = |scale: f64| [0; 3].map(|_| scale * uniform(&mut bench.stream, -1.0, 1.0));
        let (e, b) = (random(1.0), random(strength));
        let rate = |u: Vector| {
            let turned = cross(u, b);
            [0, 1, 2].map(|axis| e[axis] - u[axis] + sense * turned[axis])
        };
        let mut u = [0.0; 3];
        for _ in 0..2000 {
            u = runge_kutta(u, 0.02, rate);
        }
        let steady = hall_conductivity(1.0, b).of(e);
        let missed = [0, 1, 2].map(|axis| u[axis] - steady[axis]);
        ((dot(missed, missed) / dot(e, e)).sqrt(), format!("b = {b:.2?}"))
    }))
}

/// The rotations that map a cube to itself: permutations of the axes with signs whose product keeps the sense.
fn turns_of_a_cube() -> Vec<Tensor> {
    let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let all = orders.into_iter().enumerate().flat_map(|(at, order)| {
        let parity = if at < 3 { 1.0 } else { -1.0 };
        [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[a, b]| {
            let mut rows = [[0.0; 3]; 3];
            for (row, sign) in [a, b, a * b * parity].into_iter().enumerate() {
                rows[row][order[row]] = sign;
            }
            Tensor(rows)
        })
    });
    all.collect()
}

/// Largest entry, over the tensor's largest, of mean − `isotropic_part`.
fn powder(bench: &mut Bench, turns: fn() -> Vec<Tensor>) -> Measured {
    let turns = turns();
    Measured::worst((0..20).map(|case| {
        let tensor = Tensor([[0; 3]; 3].map(|row| row.map(|_| uniform(&mut bench.stream, -1.0, 1.0))));
        let mut mean = [[0.0; 3]; 3];
        for turn in &turns {
            let turned = tensor.turned(turn);
            for (sum, entry) in mean.iter_mut().flatten().zip(turned.0.iter().flatten()) {
                *sum += entry / turns.len() as f64;
            }
        }
        let number = Tensor::diagonal([tensor.isotropic_part(); 3]);
        let missed =
            mean.iter().flatten().zip(number.0.iter().flatten()).map(|(a, b)| ((a - b) / f64::EPSILON, String::new()));
        (Measured::worst(missed).value, format!("tensor {case}"))
    }))
}

fn walk_off(setting: &Setting) -> Plot {
    let crystal = crystal(setting);
    let curve = |of: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
        (0..=180).map(|half| f64::from(half) / 2.0).map(|angle| [angle, of(angle.to_radians()).to_degrees()]).collect()
    };
    let turned = [0.5, 1.0, 2.0].map(|b: f64| {
        let conduct = hall_conductivity(1.0, [0.0, 0.0, b]);
        (b, curve(&move |angle| between([angle.sin(), 0.0, angle.cos()], conduct.of([angle.sin(), 0.0, angle.cos()]))))
    });
    let x = |what: &str| Axis::linear(format!("angle of E to the {what}"), "°").range(0.0, 90.0).tick(15.0);
    let dielectric = Chart::new("crystal: D = εE", x("crystal's axis"), Axis::linear("angle between D and E", "°"))
        .line(
            Hue::Ours,
            format!("n_o = {}, n_e = {}", setting.text("n_o"), setting.text("n_e")),
            curve(&|angle| leaning(&crystal, angle)),
        );
    let hall = turned.into_iter().enumerate().fold(
        Chart::new(
            "electrons in a magnetic field: J = σE",
            x("magnetic field"),
            Axis::linear("angle between J and E", "°").range(0.0, 90.0).tick(15.0),
        ),
        |chart, (at, (b, curve))| chart.line(Hue::Nth(at as u8), format!("ω_cτ = {b}"), curve),
    );
    Plot::grid("Where a tensor is no number", 2, vec![dielectric.into(), hall.into()])
}
