//! The inner loops: one for each thing a run of cells may need, and nothing else in it.
//!
//! Every loop runs over slices cut to one length, which is what lets the compiler drop the bounds checks and work on
//! several cells at a time. Coefficients that do not vary along the run are one number, not an array.

use std::ops::Range;

/// A coefficient along a run of cells: one for all, or one for each.
pub(super) trait Coefficient: Copy {
    /// The part that belongs to a range of the run.
    fn cut(self, range: Range<usize>) -> Self;
    /// Its value at a cell.
    fn at(self, i: usize) -> f64;
}

impl Coefficient for f64 {
    #[inline(always)]
    fn cut(self, _: Range<usize>) -> Self {
        self
    }
    #[inline(always)]
    fn at(self, _: usize) -> f64 {
        self
    }
}

impl Coefficient for &[f64] {
    #[inline(always)]
    fn cut(self, range: Range<usize>) -> Self {
        &self[range]
    }
    #[inline(always)]
    fn at(self, i: usize) -> f64 {
        self[i]
    }
}

/// A component of a discrete curl along a run of cells, times the spacing.
pub(super) trait Curl: Copy {
    /// The part that belongs to a range of the run.
    fn cut(self, range: Range<usize>) -> Self;
    /// Its value at a cell.
    fn at(self, i: usize) -> f64;
}

/// One difference: `ahead` − `behind`.
#[derive(Clone, Copy)]
pub(super) struct Difference<'a> {
    pub ahead: &'a [f64],
    pub behind: &'a [f64],
}

impl Curl for Difference<'_> {
    #[inline(always)]
    fn cut(self, range: Range<usize>) -> Self {
        Self { ahead: &self.ahead[range.clone()], behind: &self.behind[range] }
    }
    #[inline(always)]
    fn at(self, i: usize) -> f64 {
        self.ahead[i] - self.behind[i]
    }
}

/// Two differences: the first minus the second.
#[derive(Clone, Copy)]
pub(super) struct Circulation<'a>(pub Difference<'a>, pub Difference<'a>);

impl Curl for Circulation<'_> {
    #[inline(always)]
    fn cut(self, range: Range<usize>) -> Self {
        Self(self.0.cut(range.clone()), self.1.cut(range))
    }
    #[inline(always)]
    fn at(self, i: usize) -> f64 {
        self.0.at(i) - self.1.at(i)
    }
}

/// E += drive·curl.
#[inline(always)]
pub(super) fn clear<D: Curl, C: Coefficient>(e: &mut [f64], curl: D, drive: C) {
    let (curl, drive) = (curl.cut(0..e.len()), drive.cut(0..e.len()));
    for (i, e) in e.iter_mut().enumerate() {
        *e += drive.at(i) * curl.at(i);
    }
}

/// The same for two components of as many cells.
#[inline(always)]
pub(super) fn clear_both<A: Curl, B: Curl>([e, f]: [&mut [f64]; 2], (a, b): (A, B), [of_a, of_b]: [f64; 2]) {
    let n = e.len();
    let (f, a, b) = (&mut f[0..n], a.cut(0..n), b.cut(0..n));
    for i in 0..n {
        e[i] += of_a * a.at(i);
        f[i] += of_b * b.at(i);
    }
}

/// E += drive·curl − rest·E.
#[inline(always)]
pub(super) fn lossy<D: Curl, C: Coefficient>(e: &mut [f64], curl: D, [drive, rest]: [C; 2]) {
    let n = e.len();
    let (curl, drive, rest) = (curl.cut(0..n), drive.cut(0..n), rest.cut(0..n));
    for (i, e) in e.iter_mut().enumerate() {
        *e += drive.at(i) * curl.at(i) - rest.at(i) * *e;
    }
}

/// E = base·E + (drive·curl − rest·E).
#[inline(always)]
pub(super) fn conducting<D: Curl, C: Coefficient>(e: &mut [f64], curl: D, [drive, rest, base]: [C; 3]) {
    let n = e.len();
    let (curl, drive, rest, base) = (curl.cut(0..n), drive.cut(0..n), rest.cut(0..n), base.cut(0..n));
    for (i, e) in e.iter_mut().enumerate() {
        *e = base.at(i) * *e + (drive.at(i) * curl.at(i) - rest.at(i) * *e);
    }
}

/// E = base·E + (drive·(curl − share·J) − rest·E), J = memory·J + gain·(E + E′).
#[inline(always)]
pub(super) fn full<D: Curl, C: Coefficient>(e: &mut [f64], j: &mut [f64], curl: D, coefficients: [C; 6]) {
    let n = e.len();
    let (curl, j) = (curl.cut(0..n), &mut j[0..n]);
    let [drive, rest, base, share, memory, gain] = coefficients.map(|c| c.cut(0..n));
    for i in 0..n {
        let before = e[i];
        let push = drive.at(i) * (curl.at(i) - share.at(i) * j[i]);
        e[i] = base.at(i) * before + (push - rest.at(i) * before);
        j[i] = memory.at(i) * j[i] + gain.at(i) * (before + e[i]);
    }
}

/// What an absorber adds: ψ = b ψ + c·d, E += drive·(ψ + k·d). `also` learns by how much each E grew.
#[inline(always)]
pub(super) fn absorb<C: Coefficient, G: Coefficient>(
    e: &mut [f64],
    psi: &mut [f64],
    d: Difference,
    [b, c, k]: [G; 3],
    drive: C,
    mut also: impl FnMut(usize, f64),
) {
    let n = e.len();
    let (d, psi, drive) = (d.cut(0..n), &mut psi[0..n], drive.cut(0..n));
    let (b, c, k) = (b.cut(0..n), c.cut(0..n), k.cut(0..n));
    for i in 0..n {
        let d = d.at(i);
        psi[i] = b.at(i) * psi[i] + c.at(i) * d;
        let added = drive.at(i) * (psi[i] + k.at(i) * d);
        e[i] += added;
        also(i, added);
    }
}

/// J += gain·added: the current follows an E that was not yet all it is.
#[inline(always)]
pub(super) fn follow<C: Coefficient>(j: &mut [f64], gain: C) -> impl FnMut(usize, f64) {
    #[inline(always)]
    move |i, added| j[i] += gain.at(i) * added
}
