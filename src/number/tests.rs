use super::*;
use proptest::prelude::*;
use yardstick::precise::{self, Real, real, relative_error};

/// erfc x for x ≥ 0 in arbitrary precision, by Taylor's series of erf (DLMF 7.6.2), all of whose terms are positive.
fn erfc(x: &Real) -> Real {
    let (one, two) = (precise::real_at(1.0, 2000), precise::real_at(2.0, 2000));
    let x = x.clone().with_precision(2000).value();
    let square = &two * &x * &x;
    let (mut term, mut sum, mut k) = (x.clone(), x.clone(), 1);
    while precise::to_f64(&(&term / &sum)) > 1e-320 && k < 6000 {
        term = term * &square / precise::real_at(f64::from(2 * k + 1), 2000);
        sum += &term;
        k += 1;
    }
    let erf = two / precise::pi(2000).sqrt() * (-(&x * &x)).exp() * sum;
    one - erf
}

/// The worst error of `ours` in units of the width's ε, beside what is asked.
fn check<N: Number>(name: &str, limit: f64, cases: impl Iterator<Item = f64>, both: impl Fn(N) -> (N, Real)) {
    for x in cases {
        let (ours, exact) = both(N::of(x));
        let error = relative_error(ours.lane(0), &exact) / N::EPSILON;
        assert!(error <= limit, "{name}({x:e}) = {:e}: {error} ε", ours.lane(0));
    }
}

fn exact<N: Number>(x: N) -> Real {
    real(x.lane(0))
}

fn powers(from: f64, to: f64) -> impl Iterator<Item = f64> {
    (0..=300).map(move |i| 10f64.powf(from + (to - from) * f64::from(i) / 300.0))
}

fn elementary_functions_keep_their_digits<N: Number>() {
    let least = N::TERMS.least_exponent;
    check::<N>("exp", 2.0, powers(-5.0, (-0.99 * least).log10()), |x| (exp(-x), (-exact(x)).exp()));
    check::<N>("exp", 2.0, powers(-5.0, 1.9), |x| (exp(x), exact(x).exp()));
    check::<N>("ln", 2.0, powers(-30.0, 30.0).chain(powers(-0.2, 0.2)).filter(|x| *x != 1.0), |x| {
        (ln(x), exact(x).ln())
    });
    check::<N>("ln_1p", 4.0, powers(-20.0, 10.0), |x| (ln_1p(x), exact(x).ln_1p()));
    check::<N>("atan", 4.0, powers(-9.0, 9.0), |x| (atan2(x, N::of(1.0)), exact(x).atan()));
    let turns = || (0..=1000).map(|i| f64::from(i) / 500.0 - 1.0);
    let two_pi = || precise::real(2.0) * precise::pi(precise::BITS);
    for x in turns().map(N::of) {
        let ((sin, cos), (exact_sin, exact_cos)) = (sin_cos_turns(x), (exact(x) * two_pi()).sin_cos());
        let off = |ours: N, exact: Real| precise::to_f64(&(real(ours.lane(0)) - exact)).abs();
        assert!(off(sin, exact_sin) <= 2.0 * N::EPSILON && off(cos, exact_cos) <= 2.0 * N::EPSILON, "{x:?}");
    }
    check::<N>("sin", 4.0, powers(-9.0, -2.0), |x| (sin_cos_turns(x).0, (exact(x) * two_pi()).sin()));
}

fn the_gaussians_remainder_keeps_its_digits<N: Number>() {
    let one = N::of(1.0);
    let scaled = |x: N| (exact(x) * exact(x)).with_precision(2000).value().exp() * erfc(&exact(x));
    check::<N>("erfcx", 4.0, powers(-5.0, 1.0), |x| (erfcx(x, one).scaled, scaled(x)));
    check::<N>("1 - √π x erfcx", 4.0, powers(-5.0, 1.0), |x| {
        let root = precise::pi(2000).sqrt();
        (erfcx(x, one).rest, precise::real_at(1.0, 2000) - root * exact(x) * scaled(x))
    });
    // Far out 1/(2x²) (1 − 3/(2x²) …), and at the end a quotient over 0.
    check::<N>("1 - √π x erfcx", 4.0, powers(5.0, 8.0), |x| {
        let x2 = exact(x) * exact(x);
        (erfcx(x, one).rest * x * x, real(0.5) - real(0.75) / x2)
    });
    assert_eq!(erfcx(one, N::of(0.0)).rest.lane(0), 0.0);
}

#[test]
fn functions_in_f64() {
    elementary_functions_keep_their_digits::<f64>();
    the_gaussians_remainder_keeps_its_digits::<f64>();
}

#[test]
fn functions_in_f32() {
    elementary_functions_keep_their_digits::<f32>();
    the_gaussians_remainder_keeps_its_digits::<f32>();
}

#[test]
fn beta_is_eulers() {
    // B(m, n) = (m − 1)!(n − 1)!/(m + n − 1)! and B(1, y) = 1/y, B(½ + …) by DLMF 5.12.1.
    let factorial = |n: u32| (1..=n).map(f64::from).product::<f64>();
    for (m, n) in (1..12).flat_map(|m| (1..12).map(move |n| (m, n))) {
        let exact = factorial(m - 1) * factorial(n - 1) / factorial(m + n - 1);
        let (wide, narrow) = (beta(f64::from(m), f64::from(n)), beta(m as f32, n as f32));
        assert!((wide / exact - 1.0).abs() < 1e-11, "B({m}, {n}) = {wide}");
        assert!((f64::from(narrow) / exact - 1.0).abs() < 1e-5, "B({m}, {n}) = {narrow}");
    }
    for y in powers(0.0, 7.0) {
        assert!((beta(1.0, y) * y - 1.0).abs() < 1e-10, "{y}");
        assert!((f64::from(beta(1.0_f32, y as f32)) * y - 1.0).abs() < 1e-4, "{y}");
    }
    assert!((beta(1.5, 2.5) - std::f64::consts::PI / 16.0).abs() < 1e-11);
}

#[test]
fn dice_are_even_and_unrelated() {
    let mut dice = Dice::new(0.25_f32, 0.5);
    let throws: Vec<f64> = (0..100_000).map(|_| f64::from(dice.throw())).collect();
    // Kolmogorov's p, fixed seed; and the correlation of neighbours, whose standard error is 1/√n.
    assert!(yardstick::statistics::kolmogorov(&throws, |u| u) > 1e-3);
    let pairs = throws.windows(2).map(|w| (w[0] - 0.5) * (w[1] - 0.5) * 12.0).sum::<f64>() / 1e5;
    assert!(pairs.abs() < 4.0 / 1e5_f64.sqrt(), "{pairs}");
    // First throws of neighbouring keys, as grids of samples have.
    let firsts: Vec<f64> = (0..100_000).map(|i| f64::from(Dice::new(i as f32 / 131_072.0, 0.5_f32).throw())).collect();
    assert!(yardstick::statistics::kolmogorov(&firsts, |u| u) > 1e-3);
}

/// That lanes are as many numbers.
macro_rules! lanes_are_numbers {
    ($test:ident, $pack:ident, $count:literal, $uniform:ident) => {
        proptest! {
            #[test]
            fn $test(bits in prop::array::$uniform(any::<u32>()), more in prop::array::$uniform(any::<u32>())) {
                type Wide = $pack<f32>;
                let (a, b) = ($pack(bits.map(f32::from_bits)), $pack(more.map(f32::from_bits)));
                let unit = |x: f32| if x.is_finite() { x % 1.0 } else { 0.0 };
                type Pair = (fn(Wide, Wide) -> Wide, fn(f32, f32) -> f32);
                let pairs: [Pair; 19] = [
                    (|a, b| a + b, |a, b| a + b), (|a, b| a * b, |a, b| a * b), (|a, b| a / b, |a, b| a / b),
                    (|a, b| a - b, |a, b| a - b), (Number::min, Number::min), (Number::max, Number::max),
                    (|a, _| Number::sqrt(a), |a, _| Number::sqrt(a)), (|a, _| Number::abs(a), |a, _| Number::abs(a)),
                    (|a, _| a.round(), |a, _| Number::round(a)), (|a, _| exp(a), |a, _| exp(a)), (|a, _| -a, |a, _| -a),
                    (|a, _| ln(a.abs()), |a, _| ln(Number::abs(a))), (|a, _| ln_1p(a.abs()), |a, _| ln_1p(Number::abs(a))),
                    (|a, b| atan2(a.abs(), b.abs()), |a, b| atan2(Number::abs(a), Number::abs(b))),
                    (|a, b| erfcx(a.abs(), b.abs()).rest, |a, b| erfcx(Number::abs(a), Number::abs(b)).rest),
                    (|a, b| erfcx(a.abs(), b.abs()).scaled, |a, b| erfcx(Number::abs(a), Number::abs(b)).scaled),
                    (|a, b| beta(a.abs(), b.abs()), |a, b| beta(Number::abs(a), Number::abs(b))),
                    (|a, b| Dice::new(a, b).throw(), |a, b| Dice::new(a, b).throw()),
                    (|a, b| Wide::select(a.lt(b), a, b), |a, b| f32::select(a.lt(b), a, b)),
                ];
                for (index, (wide, narrow)) in pairs.into_iter().enumerate() {
                    let once = if best_lanes() < $count { wide(a, b) } else { vectorised_lanes::<Wide, _>(|| wide(a, b)) };
                    for lane in 0..$count {
                        let alone = narrow(a.0[lane], b.0[lane]);
                        prop_assert!(
                            once.0[lane].to_bits() == alone.to_bits() || once.0[lane].is_nan() && alone.is_nan(),
                            "{index}: {once:?} {alone}"
                        );
                    }
                }
                let turns = a.0.map(unit);
                let (sin, cos) = sin_cos_turns($pack(turns));
                for (lane, turns) in turns.into_iter().enumerate() {
                    prop_assert_eq!((sin.0[lane], cos.0[lane]), sin_cos_turns(turns));
                }
                // What sorts lanes: masks as bits and as places, and rows turned into columns.
                let mask = a.lt(b);
                let held: Vec<usize> = (0..$count).filter(|lane| a.0[*lane] < b.0[*lane]).collect();
                prop_assert_eq!(mask.lanes().collect::<Vec<_>>(), held.clone());
                prop_assert_eq!(mask.bits(), held.iter().map(|lane| 1 << lane).sum::<u32>());
                let row = |lane: usize| std::array::from_fn::<_, 7, _>(|column| (8 * lane + column) as f32);
                for (column, found) in Wide::columns(row).into_iter().enumerate() {
                    prop_assert_eq!(found.0, std::array::from_fn(|lane| (8 * lane + column) as f32));
                }
            }
        }
    };
}

lanes_are_numbers!(eight_lanes_are_eight_numbers, Eight, 8, uniform8);
lanes_are_numbers!(sixteen_lanes_are_sixteen_numbers, Sixteen, 16, uniform16);
