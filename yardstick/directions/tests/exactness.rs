//! What rules should integrate, they do, and no more.

use super::super::{Domain, Rule, TOP_LEVEL, integral, lebedev, product};
use super::{axis, cosine};
use crate::random::stream;
use libm::tgamma;

/// ∫ x^a y^b z^c over `domain` (G. B. Folland, *Amer. Math. Monthly* 108 (2001) 446; halved where z ≥ 0).
fn moment(domain: Domain, [a, b, c]: [i32; 3]) -> f64 {
    let c = c + i32::from(domain == Domain::Cosine);
    let odd = |power: i32| power % 2 == 1;
    if odd(a) || odd(b) || (odd(c) && domain == Domain::Sphere) {
        return 0.0;
    }
    let half = |power: i32| 0.5 * f64::from(power + 1);
    let octants = if domain == Domain::Sphere { 2.0 } else { 1.0 };
    octants * tgamma(half(a)) * tgamma(half(b)) * tgamma(half(c)) / tgamma(half(a) + half(b) + half(c))
}

/// The monomials of `degree`.
fn monomials(degree: i32) -> impl Iterator<Item = [i32; 3]> {
    (0..=degree).flat_map(move |a| (0..=degree - a).map(move |b| [a, b, degree - a - b]))
}

/// The largest error of `rule` among the monomials of `degree` [sr].
fn worst(rule: &Rule, domain: Domain, degree: i32) -> f64 {
    let error = |powers: [i32; 3]| {
        let found = integral(rule, |[x, y, z]| x.powi(powers[0]) * y.powi(powers[1]) * z.powi(powers[2]));
        (found - moment(domain, powers)).abs()
    };
    monomials(degree).map(error).max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

#[test]
fn products_are_exact_to_their_degree_and_no_further() {
    for domain in Domain::ALL {
        for polar in 1..=12 {
            let rule = product(domain, polar);
            let degree = 2 * polar as i32 - 1 - i32::from(domain == Domain::Cosine);
            assert_eq!(rule.len(), 2 * polar * polar);
            for within in 0..=degree {
                let error = worst(&rule, domain, within);
                // A hundred or so roundings of numbers up to 4π.
                assert!(error < 1e-13, "{domain:?} {polar} {within}: {error}");
            }
            // The error is that of Gauss's rule for z^2n: it falls as 4^−n (Abramowitz & Stegun 25.4.30).
            let beyond = worst(&rule, domain, degree + 1);
            assert!(beyond > 0.3 * 0.0625_f64.powi(polar as i32), "{domain:?} {polar}: {beyond}");
        }
    }
}

/// The largest |Σ w P_l(ω·axis)| of the degrees l in `degrees` and eight axes [sr]: each axis sees all 2l + 1 harmonics
/// of a degree at once, and none can hide from all.
fn worst_zonal(rule: &Rule, degrees: std::ops::RangeInclusive<usize>) -> f64 {
    let mut stream = stream(1, "directions/zonal");
    let mut worst = 0.0_f64;
    for _ in 0..8 {
        let axis = axis(&mut stream);
        let mut sums = vec![0.0; degrees.end() + 1];
        for &(direction, weight) in rule {
            let c = cosine(axis, direction);
            let (mut value, mut before) = (1.0, 0.0);
            for (l, sum) in sums.iter_mut().enumerate() {
                *sum += weight * value;
                let l = l as f64;
                (value, before) = (((2.0 * l + 1.0) * c * value - l * before) / (l + 1.0), value);
            }
        }
        worst = sums[degrees.clone()].iter().fold(worst, |worst, sum| worst.max(sum.abs()));
        assert!(sums.iter().all(|sum| sum.is_finite()));
    }
    worst
}

#[test]
fn lebedevs_rules_are_exact_to_their_degree_and_no_further() {
    for level in 1..=TOP_LEVEL {
        let rule = lebedev(level);
        let degree = 6 * level - 1;
        assert_eq!(rule.len(), 12 * level * level + 2);
        assert!(rule.iter().all(|(_, weight)| *weight > 0.0), "{level}");
        assert!(rule.iter().all(|(at, _)| (cosine(*at, *at) - 1.0).abs() < 1e-15), "{level}");
        // Points and weights are known to a few roundings times the degree, which is how fast P_l can turn.
        let limit = Domain::Sphere.size() * f64::EPSILON * (degree * degree) as f64;
        let sum = (integral(&rule, |_| 1.0) - Domain::Sphere.size()).abs();
        let error = worst_zonal(&rule, 1..=degree).max(sum);
        assert!(error < limit, "{level}: {error}");
        let beyond = worst_zonal(&rule, degree + 1..=degree + 1);
        assert!(beyond > 1e-3, "{level}: {beyond}");
    }
}

#[test]
fn the_rule_of_fifty_points_is_mclarens() {
    // A. D. McLaren, *Math. Comp.* 17 (1963) 361: axes, sides, diagonals, and (1, 1, 3)/√11.
    let rule = lebedev(2);
    let mean = Domain::Sphere.size();
    for (point, share) in [
        ([0.0, 0.0, 1.0], 4.0 / 315.0),
        ([0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0], 64.0 / 2835.0),
        ([3.0_f64.sqrt().recip(); 3], 27.0 / 1280.0),
        ([1.0, 1.0, 3.0].map(|part| part / 11.0_f64.sqrt()), 14641.0 / 725_760.0),
    ] {
        let (_, weight) = rule.iter().find(|(at, _)| cosine(*at, point) > 1.0 - 1e-14).expect("one of its points");
        assert!((weight / mean / share - 1.0).abs() < 1e-13, "{point:?}: {weight}");
    }
}
