//! Rules of sines, cosines and their kin.

use super::algebra::{Found, Pair, pairs, same_size};
use super::number::compare;
use super::scene::Scene;
use super::term::{Form, Power, Term};
use crate::expr::Function;
use crate::rational::Rational;
use std::cmp::Ordering;

const TWO: Rational = Rational::integer(2);
const ONE: Rational = Rational::ONE;

fn sin(x: &Term) -> Term {
    Term::function(Function::Sin, x.clone())
}

fn cos(x: &Term) -> Term {
    Term::function(Function::Cos, x.clone())
}

fn half(x: &Term) -> Term {
    x.times(&Term::half())
}

fn double(x: &Term) -> Term {
    x.scaled(TWO)
}

/// The function and its argument, of sin x and cos x.
fn wave(term: &Term) -> Option<(Function, &Term)> {
    match term.form() {
        Form::Function(function @ (Function::Sin | Function::Cos), of) => Some((*function, of)),
        _ => None,
    }
}

/// c f(x)ⁿ as (c, f, x), for the given n.
fn lone_wave(term: &Term, exponent: Rational) -> Option<(Rational, Function, Term)> {
    let (c, factors) = term.factors();
    let [(base, e)] = factors.as_slice() else { return None };
    let (function, of) = wave(base)?;
    (*e == exponent).then(|| (c, function, of.clone()))
}

/// c f(x) g(y), sines first.
fn two_waves(term: &Term) -> Option<(Rational, [(Function, Term); 2])> {
    let (c, factors) = term.factors();
    let waves: Vec<(Function, Term)> = match factors.as_slice() {
        [(base, e)] if *e == TWO => wave(base).map(|(f, of)| vec![(f, of.clone()); 2])?,
        [(a, e), (b, f)] if *e == ONE && *f == ONE => {
            [a, b].into_iter().map(|t| wave(t).map(|(f, of)| (f, of.clone()))).collect::<Option<_>>()?
        }
        _ => return None,
    };
    let [a, b]: [_; 2] = waves.try_into().ok()?;
    Some((c, if a.0 == Function::Cos && b.0 == Function::Sin { [b, a] } else { [a, b] }))
}

/// tan x → sin x/cos x
pub(super) fn tangent(term: &Term, _: &Scene, found: &mut Found) {
    if let Form::Function(Function::Tan, of) = term.form() {
        found.push(sin(of).over(&cos(of)).into());
    }
}

/// sin x/cos x → tan x
pub(super) fn to_tangent(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Product(_, factors) = term.form() else { return };
    for (base, e) in factors {
        let Some((Function::Sin, of)) = wave(base) else { continue };
        let below = cos(of);
        let Some((_, f)) = factors.iter().find(|(known, f)| *known == below && f.is_negative() != e.is_negative())
        else {
            continue;
        };
        let size = |n: Rational| if n.is_negative() { n.negated() } else { n };
        let n = if compare(size(*e), size(*f)) == Ordering::Less { *e } else { f.negated() };
        let ratio = Term::function(Function::Tan, of.clone()).times(&cos(of)).over(base);
        found.push(term.times(&ratio.power(n)).into());
    }
}

/// How an argument falls in two: its first term and the rest; (n − 1)x and x.
fn parts_of(angle: &Term) -> Option<(Term, Term)> {
    let terms = angle.terms();
    if terms.len() > 1 {
        return Some((terms[0].clone(), Term::sum(terms[1..].iter().cloned())));
    }
    let n = angle.coefficient().as_integer().filter(|n| (3..=6).contains(n) && angle.as_number().is_none())?;
    let once = angle.scaled(Rational::new(1, n)?);
    Some((once.scaled(Rational::integer(n - 1)), once))
}

/// sin(a + b) → sin a cos b + cos a sin b, cos(a + b) → cos a cos b − sin a sin b
pub(super) fn angle_sum(term: &Term, _: &Scene, found: &mut Found) {
    let Some((function, of)) = wave(term) else { return };
    let Some((a, b)) = parts_of(of) else { return };
    found.push(match function {
        Function::Sin => sin(&a).times(&cos(&b)).plus(&cos(&a).times(&sin(&b))).into(),
        _ => cos(&a).times(&cos(&b)).minus(&sin(&a).times(&sin(&b))).into(),
    });
}

fn join(term: &Term, found: &mut Found, rule: impl Fn(&Pair) -> Option<Term>) {
    found.extend(pairs(term).iter().filter_map(|pair| Some(pair.replace(&rule(pair)?))));
}

/// sin a cos b ± cos a sin b → sin(a ± b), cos a cos b ∓ sin a sin b → cos(a ± b)
pub(super) fn to_angle_sum(term: &Term, _: &Scene, found: &mut Found) {
    join(term, found, |pair| {
        let (c, [(f, a), (g, b)]) = two_waves(&pair.a)?;
        let (d, [(p, y), (q, z)]) = two_waves(&pair.b)?;
        if !same_size(c, d) || a == b {
            return None;
        }
        let (sum, difference) = (a.plus(&b), a.minus(&b));
        match (f, g, p, q) {
            (Function::Sin, Function::Cos, Function::Sin, Function::Cos) if a == z && b == y => {
                Some(sin(if c == d { &sum } else { &difference }).scaled(c))
            }
            (Function::Cos, Function::Cos, Function::Sin, Function::Sin)
                if (a == y && b == z) || (a == z && b == y) =>
            {
                Some(cos(if c == d { &difference } else { &sum }).scaled(c))
            }
            _ => None,
        }
    });
}

/// sin 2x → 2 sin x cos x, and the three forms of cos 2x.
pub(super) fn double_angle(term: &Term, scene: &Scene, found: &mut Found) {
    let Some((function, of)) = wave(term) else { return };
    let x = half(of);
    if !scene.welcomes(&x) || of.as_number().is_some() {
        return;
    }
    if function == Function::Sin {
        found.push(sin(&x).times(&cos(&x)).scaled(TWO).into());
        return;
    }
    let (sine, cosine, one) = (sin(&x).squared(), cos(&x).squared(), Term::integer(1));
    found.push(cosine.minus(&sine).into());
    found.push(one.minus(&double(&sine)).into());
    found.push(double(&cosine).minus(&one).into());
}

/// sin x cos x → ½ sin 2x
pub(super) fn to_sine_of_double(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Product(_, factors) = term.form() else { return };
    for (base, e) in factors {
        let Some((Function::Sin, x)) = wave(base) else { continue };
        let other = cos(x);
        let Some((_, f)) = factors.iter().find(|(known, f)| *known == other && f.is_negative() == e.is_negative())
        else {
            continue;
        };
        let nearest = if (compare(*e, *f) == Ordering::Less) == e.is_negative() { *f } else { *e };
        let ratio = half(&sin(&double(x))).over(&base.times(&other));
        found.push(term.times(&ratio.power(nearest)).into());
    }
}

/// cos² x − sin² x, 1 − 2 sin² x and 2 cos² x − 1 → cos 2x
pub(super) fn to_cosine_of_double(term: &Term, _: &Scene, found: &mut Found) {
    join(term, found, |pair| {
        let (d, function, x) = lone_wave(&pair.b, TWO)?;
        let wave = cos(&double(&x));
        if let Some(c) = pair.a.as_number() {
            let sign = if function == Function::Sin { c } else { c.negated() };
            return (double(&Term::number(c)) == Term::number(d.negated())).then(|| wave.scaled(sign));
        }
        let (c, Function::Cos, y) = lone_wave(&pair.a, TWO)? else { return None };
        (function == Function::Sin && x == y && c == d.negated()).then(|| wave.scaled(c))
    });
}

/// 1 − cos 2x → 2 sin² x, 1 + cos 2x → 2 cos² x
pub(super) fn from_half_angle(term: &Term, scene: &Scene, found: &mut Found) {
    join(term, found, |pair| {
        let c = pair.a.as_number()?;
        let (d, Function::Cos, of) = lone_wave(&pair.b, ONE)? else { return None };
        let x = half(&of);
        let square = if c == d { cos(&x) } else { sin(&x) }.squared();
        (same_size(c, d) && scene.welcomes(&x)).then(|| double(&square).scaled(c))
    });
}

/// Every factor that is a power of a sine or cosine, at least a square, with the square taken out of it.
fn squares(term: &Term) -> Vec<(Function, Term, Term)> {
    let (_, factors) = term.factors();
    let is_square = |(base, e): &Power| {
        let (function, of) = wave(base)?;
        let enough = e.as_integer().is_some_and(|n| n.abs() >= 2);
        let square = if e.is_negative() { TWO.negated() } else { TWO };
        enough.then(|| (function, of.clone(), base.power(square)))
    };
    factors.iter().filter_map(is_square).collect()
}

/// sin² x → 1 − cos² x, cos² x → 1 − sin² x
pub(super) fn pythagoras(term: &Term, _: &Scene, found: &mut Found) {
    for (function, x, square) in squares(term) {
        let other = if function == Function::Sin { cos(&x) } else { sin(&x) }.squared();
        found.push(replace_square(term, &square, &Term::integer(1).minus(&other)).into());
    }
}

/// sin² x → (1 − cos 2x)/2, cos² x → (1 + cos 2x)/2
pub(super) fn half_angle(term: &Term, _: &Scene, found: &mut Found) {
    for (function, x, square) in squares(term) {
        let wave = cos(&double(&x));
        let signed = if function == Function::Sin { wave.negated() } else { wave };
        found.push(replace_square(term, &square, &half(&Term::integer(1).plus(&signed))).into());
    }
}

/// `square`, which is f² or 1/f², gives way to `by` or 1/`by`.
fn replace_square(term: &Term, square: &Term, by: &Term) -> Term {
    let is_below = square.factors().1.iter().any(|(_, e)| e.is_negative());
    let rest = term.over(square);
    if is_below { rest.over(by) } else { rest.times(by) }
}

/// sin² x + cos² x → 1, 1 − sin² x → cos² x, 1 − cos² x → sin² x
pub(super) fn to_pythagoras(term: &Term, _: &Scene, found: &mut Found) {
    join(term, found, |pair| {
        let (d, function, x) = lone_wave(&pair.b, TWO)?;
        if let Some(c) = pair.a.as_number() {
            let other = if function == Function::Sin { cos(&x) } else { sin(&x) };
            return (c == d.negated()).then(|| other.squared().scaled(c));
        }
        let (c, Function::Sin, y) = lone_wave(&pair.a, TWO)? else { return None };
        (function == Function::Cos && c == d && x == y).then(|| Term::number(c))
    });
}

/// sin a cos b → ½(sin(a + b) + sin(a − b)) and its kin.
pub(super) fn product_to_sum(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Product(_, factors) = term.form() else { return };
    let waves: Vec<&Term> =
        factors.iter().filter(|(base, e)| *e == ONE && wave(base).is_some()).map(|(b, _)| b).collect();
    for (at, first) in waves.iter().enumerate() {
        for second in &waves[at + 1..] {
            let product = first.times(second);
            let Some((_, [(f, a), (g, b)])) = two_waves(&product) else { continue };
            let (sum, difference) = (a.plus(&b), a.minus(&b));
            let twice = match (f, g) {
                (Function::Sin, Function::Cos) => sin(&sum).plus(&sin(&difference)),
                (Function::Sin, _) => cos(&difference).minus(&cos(&sum)),
                _ => cos(&difference).plus(&cos(&sum)),
            };
            found.push(term.over(&product).times(&half(&twice)).into());
        }
    }
}

/// sin a ± sin b → 2 sin((a ± b)/2) cos((a ∓ b)/2), and the same of cosines.
pub(super) fn sum_to_product(term: &Term, scene: &Scene, found: &mut Found) {
    join(term, found, |pair| {
        let (c, f, a) = lone_wave(&pair.a, ONE)?;
        let (d, g, b) = lone_wave(&pair.b, ONE)?;
        let (sum, difference) = (half(&a.plus(&b)), half(&a.minus(&b)));
        if f != g || !same_size(c, d) || !scene.welcomes(&sum) || !scene.welcomes(&difference) {
            return None;
        }
        let product = match (f, c == d) {
            (Function::Sin, true) => sin(&sum).times(&cos(&difference)),
            (Function::Sin, false) => cos(&sum).times(&sin(&difference)),
            (_, true) => cos(&sum).times(&cos(&difference)),
            (_, false) => sin(&sum).times(&sin(&difference)).negated(),
        };
        Some(double(&product).scaled(c))
    });
}

/// n where the angle is nπ/12, if it is.
fn twelfths(angle: &Term) -> Option<i64> {
    let (c, factors) = angle.factors();
    let [(base, e)] = factors.as_slice() else { return None };
    let is_pi = *base.form() == Form::Pi && *e == ONE;
    (is_pi && 12 % c.denominator() == 0).then(|| c.numerator().checked_mul(12 / c.denominator()))?
}

/// sin nπ/12 for the angles whose sines have a name.
fn named_sine(twelfths: i64) -> Option<Term> {
    let root = |n: i32| Term::function(Function::Sqrt, Term::integer(n)).times(&Term::half());
    let n = twelfths.rem_euclid(24);
    let value = match if n % 12 > 6 { 12 - n % 12 } else { n % 12 } {
        0 => Term::integer(0),
        2 => Term::half(),
        3 => root(2),
        4 => root(3),
        6 => Term::integer(1),
        _ => return None,
    };
    Some(if n > 12 { value.negated() } else { value })
}

/// sin π/6 → ½ and the like.
pub(super) fn special_value(term: &Term, _: &Scene, found: &mut Found) {
    let Some((function, of)) = wave(term) else { return };
    let shift = if function == Function::Cos { 6 } else { 0 };
    let value = twelfths(of).and_then(|n| n.checked_add(shift)).and_then(named_sine);
    found.extend(value.map(Into::into));
}

/// sin(π/2 − x) → cos x, cos(x + π) → −cos x and the like.
pub(super) fn quarter_turns(term: &Term, _: &Scene, found: &mut Found) {
    let Some((function, of)) = wave(term) else { return };
    let terms = of.terms();
    if terms.len() < 2 {
        return;
    }
    let quarters = |part: &Term| twelfths(part).filter(|n| n % 6 == 0).map(|n| n / 6);
    let Some((at, n)) = terms.iter().enumerate().find_map(|(at, part)| Some((at, quarters(part)?))) else { return };
    let x = Term::sum(terms.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, part)| part.clone()));
    // cos y = sin(y + π/2)
    let value = match (n + i64::from(function == Function::Cos)).rem_euclid(4) {
        0 => sin(&x),
        1 => cos(&x),
        2 => sin(&x).negated(),
        _ => cos(&x).negated(),
    };
    found.push(value.into());
}

/// e^(ix) → cos x + i sin x
pub(super) fn euler(term: &Term, _: &Scene, found: &mut Found) {
    let Form::Function(Function::Exp, of) = term.form() else { return };
    let i = Term::imaginary_unit();
    let x = of.over(&i);
    let is_turned = |part: &Term| part.factors().1.contains(&(i.clone(), ONE));
    if of.terms().iter().all(is_turned) {
        found.push(cos(&x).plus(&i.times(&sin(&x))).into());
    }
}

/// cos x → (e^(ix) + e^(−ix))/2, sin x → (e^(ix) − e^(−ix))/(2i)
pub(super) fn wave_to_exponentials(term: &Term, scene: &Scene, found: &mut Found) {
    let Some((function, of)) = wave(term).filter(|_| scene.is_exponential) else { return };
    let i = Term::imaginary_unit();
    let turned = of.times(&i);
    let (one, other) = (Term::function(Function::Exp, turned.clone()), Term::function(Function::Exp, turned.negated()));
    found.push(match function {
        Function::Cos => half(&one.plus(&other)).into(),
        _ => half(&one.minus(&other)).over(&i).into(),
    });
}

/// cos x + i sin x → e^(ix)
pub(super) fn to_euler(term: &Term, _: &Scene, found: &mut Found) {
    let i = Term::imaginary_unit();
    join(term, found, |pair| {
        let (c, Function::Cos, x) = lone_wave(&pair.a, ONE)? else { return None };
        let (d, Function::Sin, y) = lone_wave(&pair.b.over(&i), ONE)? else { return None };
        if x != y || !same_size(c, d) {
            return None;
        }
        let turned = if c == d { x.times(&i) } else { x.times(&i).negated() };
        Some(Term::function(Function::Exp, turned).scaled(c))
    });
}
