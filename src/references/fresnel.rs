//! The interface in arbitrary precision: E36–E43 by the plainest formulas, in numbers wide enough not to mind.

use crate::optics::Direction;
use num_complex::Complex64;
use yardstick::precise::{self, Real};

/// The inputs of an interface, exactly as `f64` holds them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Direction of incidence.
    pub direction: Direction,
    /// Index of the clear incident medium [1].
    pub n_i: f64,
    /// Index n + iκ behind the interface [1].
    pub n_t: Complex64,
}

/// Everything an interface gives, real and imaginary parts apart, in the order of [`NAMES`].
pub type Outputs = [Real; NAMES.len()];

/// The names of [`Outputs`].
pub const NAMES: [&str; 14] = [
    "r_s_re", "r_s_im", "t_s_re", "t_s_im", "r_p_re", "r_p_im", "t_p_re", "t_p_im", "R_s", "T_s", "R_p", "T_p", "R_n",
    "T_n",
];

/// The outputs at an input, exact for every purpose of `f64`.
#[derive(Debug)]
pub struct Exact {
    resolved: Resolved,
    /// In the order of [`NAMES`].
    pub outputs: Outputs,
}

impl Exact {
    /// Solves the interface at `input`.
    pub fn new(input: &Input) -> Self {
        let resolved = Resolved::new(input);
        Self { outputs: resolved.outputs(), resolved }
    }

    /// The condition number of each output [1]: Σ |x ∂y/∂x| / |y| over the inputs x (the direction and both indices'
    /// parts); infinite where y = 0 although it could move, 0 where nothing moves it.
    pub fn conditions(&self) -> [f64; NAMES.len()] {
        let mut condition = [0.0; NAMES.len()];
        for moved in self.resolved.neighbours(&precise::real(STEP)) {
            for ((sum, there), here) in condition.iter_mut().zip(&moved.outputs()).zip(&self.outputs) {
                let change = there - here;
                if !is_zero(&change) {
                    *sum += if is_zero(here) { f64::INFINITY } else { precise::to_f64(&(change / here)).abs() / STEP };
                }
            }
        }
        condition
    }
}

/// cos θ_t [1] between clear media up to the critical angle, and its condition number.
pub fn refracted_cosine(input: &Input) -> (Real, f64) {
    let square = |resolved: &Resolved| {
        let sin_t = &resolved.n_i * &resolved.sin / &resolved.n;
        precise::real(1.0) - &sin_t * &sin_t
    };
    let resolved = Resolved::new(input);
    let here = square(&resolved);
    // Half that of the square, which a step may well take below zero.
    let change = |moved: Resolved| precise::to_f64(&((square(&moved) - &here) / &here)).abs() / (2.0 * STEP);
    let condition = resolved.neighbours(&precise::real(STEP)).map(change).sum();
    (here.sqrt(), condition)
}

/// Relative step of the difference quotients: far below f64, far above the rounding of [`precise::BITS`].
const STEP: f64 = 1e-30;

fn is_zero(x: &Real) -> bool {
    x.repr().significand().is_zero()
}

/// The inputs with sine and cosine resolved.
#[derive(Clone, Debug)]
struct Resolved {
    sin: Real,
    cos: Real,
    /// What a relative step of the direction's own number changes: (d sin, d cos) per unit of relative step.
    turn: (Real, Real),
    n_i: Real,
    n: Real,
    k: Real,
}

impl Resolved {
    fn new(input: &Input) -> Self {
        let (sin, cos, turn) = match input.direction {
            Direction::Angle(theta) => {
                let theta = precise::real(theta);
                let (sin, cos) = theta.sin_cos();
                let turn = (&theta * &cos, -(&theta * &sin));
                (sin, cos, turn)
            }
            Direction::Grazing(delta) => {
                let delta = precise::real(delta);
                let (cos, sin) = delta.sin_cos();
                let turn = (-(&delta * &cos), &delta * &sin);
                (sin, cos, turn)
            }
            Direction::Cos(cos) => {
                let cos = precise::real(cos);
                let sin = (precise::real(1.0) - &cos * &cos).sqrt();
                // d sin / d cos = −cos/sin; at normal incidence the powers depend on cos alone.
                let slope = if is_zero(&sin) { precise::real(0.0) } else { -(&cos * &cos) / &sin };
                let turn = (slope, cos.clone());
                (sin, cos, turn)
            }
        };
        let [n_i, n, k] = [input.n_i, input.n_t.re, input.n_t.im].map(precise::real);
        Self { sin, cos, turn, n_i, n, k }
    }

    /// The inputs with one of them moved by a relative `step`, one after another; zeros cannot be moved so.
    fn neighbours<'a>(&'a self, step: &'a Real) -> impl Iterator<Item = Self> + 'a {
        let grown = move |x: &Real| x + x * step;
        let base = || self.clone();
        let moved = [
            Self { sin: &self.sin + &self.turn.0 * step, cos: &self.cos + &self.turn.1 * step, ..base() },
            Self { n_i: grown(&self.n_i), ..base() },
            Self { n: grown(&self.n), ..base() },
            Self { k: grown(&self.k), ..base() },
        ];
        moved.into_iter().take(if is_zero(&self.k) { 3 } else { 4 })
    }

    fn outputs(&self) -> Outputs {
        let (n, k) = (&self.n, &self.k);
        let square = Pair(n * n - k * k, precise::real(2.0) * n * k);
        let q_i = &self.n_i * &self.cos;
        // n_t² − n_i² sin² θ by the cosine, so that the faintest grazing waves are not lost beside 1.
        let q_t = Pair(&square.0 - &self.n_i * &self.n_i + &q_i * &q_i, square.1.clone()).root();
        let n2_i = &self.n_i * &self.n_i;
        let s = Pair(&q_i + &q_t.0, q_t.1.clone());
        let r_s = Pair(q_i.clone(), precise::real(0.0)).contrast(&q_t);
        let t_s = Pair(precise::real(2.0) * &q_i, precise::real(0.0)).over(&s);
        let (straight, crossed) = (square.times(&q_i), q_t.times(&n2_i));
        let p = Pair(&straight.0 + &crossed.0, &straight.1 + &crossed.1);
        let r_p = straight.contrast(&crossed);
        let twice = precise::real(2.0) * &self.n_i * &q_i;
        let t_p = Pair(n * &twice, k * &twice).over(&p);
        // n·S_t/n·S_i with H from E: Re(q_t)/q_i |t_s|², and Re(n_t* q_t/n_t)/(n_i cos_i) |t_p|² for p.
        let (power_s, power_p) = (r_s.norm(), r_p.norm());
        let through_s = &q_t.0 / &q_i * t_s.norm();
        let lean = Pair(n.clone(), k.clone());
        let through_p = q_t.over(&lean).conj_product_re(&lean) / &q_i * t_p.norm();
        let half = precise::real(0.5);
        let natural = (&half * (&power_s + &power_p), &half * (&through_s + &through_p));
        [
            r_s.0, r_s.1, t_s.0, t_s.1, r_p.0, r_p.1, t_p.0, t_p.1, power_s, through_s, power_p, through_p, natural.0,
            natural.1,
        ]
    }
}

/// A complex number as a pair, for the four operations needed here: `dashu-cmplx` rounds each part correctly,
/// which costs ten times as much and buys nothing at 256 bits.
pub(super) struct Pair(pub(super) Real, pub(super) Real);

impl Pair {
    fn norm(&self) -> Real {
        &self.0 * &self.0 + &self.1 * &self.1
    }

    fn times(&self, x: &Real) -> Self {
        Self(&self.0 * x, &self.1 * x)
    }

    pub(super) fn over(&self, other: &Self) -> Self {
        let norm = other.norm();
        let re = (&self.0 * &other.0 + &self.1 * &other.1) / &norm;
        let im = (&self.1 * &other.0 - &self.0 * &other.1) / &norm;
        Self(re, im)
    }

    /// (self − other)/(self + other), with an imaginary part that is not lost beside a real one of 1.
    fn contrast(&self, other: &Self) -> Self {
        let norm = Pair(&self.0 + &other.0, &self.1 + &other.1).norm();
        let re = (self.norm() - other.norm()) / &norm;
        let im = precise::real(2.0) * (&self.1 * &other.0 - &self.0 * &other.1) / norm;
        Self(re, im)
    }

    /// Re(self · other*).
    fn conj_product_re(&self, other: &Self) -> Real {
        &self.0 * &other.0 + &self.1 * &other.1
    }

    /// The root in the first quadrant; `self` lies in the upper half-plane.
    pub(super) fn root(&self) -> Self {
        let zero = precise::real(0.0);
        if is_zero(&self.1) {
            let root = if self.0 < zero { (-self.0.clone()).sqrt() } else { self.0.sqrt() };
            return if self.0 < zero { Self(zero, root) } else { Self(root, zero) };
        }
        let half = precise::real(0.5);
        let modulus = self.norm().sqrt();
        let magnitude = if self.0 < zero { -self.0.clone() } else { self.0.clone() };
        let larger = ((magnitude + modulus) * &half).sqrt();
        let smaller = &half * &self.1 / &larger;
        if self.0 < zero { Self(smaller, larger) } else { Self(larger, smaller) }
    }
}
