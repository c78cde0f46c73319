//! A wave on a line in steps, for checks and races: the least that a grid needs. The chapter `maxwell` has the solver.

/// E and B on a line, half a cell and half a step apart (Yee 1966), in a clear medium. Both ends are held at E = 0.
#[derive(Clone, Debug)]
pub struct Grid {
    /// E [V/m] at i Δz.
    pub e: Vec<f64>,
    /// B [T] at (i + ½) Δz.
    pub b: Vec<f64>,
    /// Δt/Δz [s/m].
    ratio: f64,
    /// εμ [s²/m²].
    epsilon_mu: f64,
}

impl Grid {
    /// `e` and `b` at the start, b half a step later, with one cell a step: Δt = Δz √(εμ). At this Courant number of 1
    /// the grid makes no error but rounding.
    pub fn new(e: Vec<f64>, b: Vec<f64>, epsilon_mu: f64) -> Self {
        Self { e, b, ratio: epsilon_mu.sqrt(), epsilon_mu }
    }

    /// One step of Ampère's law, then one of Faraday's.
    pub fn step(&mut self) {
        for i in 1..self.e.len() - 1 {
            self.e[i] -= self.ratio / self.epsilon_mu * (self.b[i] - self.b[i - 1]);
        }
        for i in 0..self.b.len() {
            self.b[i] -= self.ratio * (self.e[i + 1] - self.e[i]);
        }
    }
}

/// How ∂²u/∂z² is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stencil {
    /// Three points, second order.
    Three,
    /// Five points, with the fourth derivative in time replaced by that in space: fourth order in both (Dablain,
    /// *Geophysics* 51 (1986) 54).
    Five,
}

/// u_tt = v² u_zz on a ring of places, from two earlier times.
#[derive(Clone, Debug)]
pub struct Ring {
    before: Vec<f64>,
    /// u now.
    pub now: Vec<f64>,
    next: Vec<f64>,
    courant: f64,
    stencil: Stencil,
}

impl Ring {
    /// u one step before the start and at it; `courant` is vΔt/Δz, at most 1.
    pub fn new(before: Vec<f64>, now: Vec<f64>, courant: f64, stencil: Stencil) -> Self {
        let next = vec![0.0; now.len()];
        Self { before, now, next, courant, stencil }
    }

    /// At rest in the shape `now`: what it was a step before it will be a step later.
    pub fn at_rest(now: Vec<f64>, courant: f64, stencil: Stencil) -> Self {
        let mut ring = Self::new(now.clone(), now.clone(), courant, stencil);
        // From u⁻ = u one step gives u + change; at rest it is u + ½ change.
        ring.step();
        ring.before = ring.now.iter().zip(&now).map(|(next, now)| 0.5 * (next + now)).collect();
        ring.now = now;
        ring
    }

    /// One step.
    pub fn step(&mut self) {
        let square = self.courant * self.courant;
        let fourth = (square * square - square) / 12.0;
        let (now, count) = (&self.now, self.now.len());
        let at = |i: usize, reach: &[f64]| {
            let second = reach[1] - 2.0 * reach[2] + reach[3];
            let change = match self.stencil {
                Stencil::Three => square * second,
                Stencil::Five => {
                    let higher = reach[0] - 4.0 * reach[1] + 6.0 * reach[2] - 4.0 * reach[3] + reach[4];
                    square * second + fourth * higher
                }
            };
            2.0 * reach[2] - self.before[i] + change
        };
        for (i, reach) in now.windows(5).enumerate() {
            self.next[i + 2] = at(i + 2, reach);
        }
        for i in [0, 1, count - 2, count - 1] {
            self.next[i] = at(i, &[count - 2, count - 1, 0, 1, 2].map(|shift| now[(i + shift) % count]));
        }
        std::mem::swap(&mut self.before, &mut self.now);
        std::mem::swap(&mut self.now, &mut self.next);
    }
}
