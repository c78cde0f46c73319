//! Irradiances and solid angles.

use super::is_zero;
use super::shares::{number, one, pi_of};
use yardstick::precise::Real;

/// What inputs give.
pub(super) type Source = fn(&[Real]) -> Real;

/// Half of ∮ n·(r × dr)/r² along the rim (a + R cos φ, R sin φ, h), |φ| ≤ Φ, and back along the chord.
pub(super) fn disc(inputs: &[Real]) -> Real {
    let [radius, height, offset, tilt] = [&inputs[0], &inputs[1], &inputs[2], &inputs[3]];
    let zero = number(0.0, radius);
    // Turned over, what leans back leans forward.
    let (tilt, offset) = if *tilt < zero { (-tilt.clone(), -offset.clone()) } else { (tilt.clone(), offset.clone()) };
    let (two, half) = (number(2.0, radius), number(0.5, radius));
    let (sin, cos) = tilt.sin_cos();
    let up = |x: Real| x * &sin + height * &cos;
    let (near, far) = (up(&offset - radius), up(&offset + radius));
    if near <= zero && far <= zero {
        return zero;
    }
    // Φ, tan Φ/2 if the horizon cuts, and half the chord.
    let (tangent, chord) = if near < zero {
        let (below, above) = (-near, far);
        (Some((&above / &below).sqrt()), (below * above).sqrt() / &sin)
    } else {
        (None, zero.clone())
    };
    let turn = |factor: &Real| match &tangent {
        Some(tangent) => two.clone() * (factor * tangent).atan(),
        None => pi_of(radius),
    };
    let angle = turn(&one(radius));
    let cross = &two * &offset * radius;
    let sum = height * height + &offset * &offset + radius * radius;
    // ∫ dφ/r² and ∫ cos φ dφ/r².
    let root = (&sum * &sum - &cross * &cross).sqrt();
    let even = &two * turn(&((&sum - &cross) / &root)) / &root;
    let swing = if is_zero(&offset) { &two * angle.sin() / &sum } else { (&two * &angle - &sum * &even) / &cross };
    let facing = radius * radius * even + &offset * radius * &swing;
    let aside = -(height * radius * swing);
    half * (cos * facing + &sin * aside) + (chord * sin / height).atan()
}

pub(super) fn sphere(inputs: &[Real]) -> Real {
    let [radius, distance, omega] = [&inputs[0], &inputs[1], &inputs[2]];
    let (zero, one) = (number(0.0, radius), one(radius));
    let (sin, cos) = omega.sin_cos();
    let ratio = distance / radius;
    let square = &ratio * &ratio;
    let level = &cos * &ratio;
    if level >= one {
        return pi_of(radius) * cos / square;
    }
    if level <= -one.clone() {
        return zero;
    }
    let x = (&square - &one).sqrt();
    let y = -(&x * &cos / &sin);
    let half = (&one - &y * &y).sqrt();
    let rest = sin * &half;
    (cos * half.atan2(&y) - &x * &rest) / square + (rest / x).atan()
}

type Vector = [Real; 3];

fn dot(a: &Vector, b: &Vector) -> Real {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

fn vectors(flat: &[Real]) -> Vec<Vector> {
    flat.chunks_exact(3).map(|part| std::array::from_fn(|axis| part[axis].clone())).collect()
}

/// Normal, then corners.
pub(super) fn polygon(inputs: &[Real]) -> Real {
    let (normal, corners) = (&vectors(&inputs[..3])[0], vectors(&inputs[3..]));
    let zero = number(0.0, &inputs[0]);
    let mut seen: Vec<Vector> = Vec::new();
    for (at, here) in corners.iter().enumerate() {
        let there = &corners[(at + 1) % corners.len()];
        let (height, other) = (dot(here, normal), dot(there, normal));
        if height >= zero {
            seen.push(here.clone());
        }
        if (height >= zero) != (other >= zero) {
            let share = &height / (&height - &other);
            seen.push(std::array::from_fn(|axis| &here[axis] + &share * (&there[axis] - &here[axis])));
        }
    }
    let mut sum = zero.clone();
    for (at, here) in seen.iter().enumerate() {
        let there = &seen[(at + 1) % seen.len()];
        let across = cross(here, there);
        let size = dot(&across, &across).sqrt();
        if !is_zero(&size) {
            sum += size.atan2(&dot(here, there)) * dot(&across, normal) / size;
        }
    }
    let total = sum / (number(2.0, &zero) * dot(normal, normal).sqrt());
    if total < zero { -total } else { total }
}

fn sides(inputs: &[Real]) -> [Real; 3] {
    let [a, b, h] = [&inputs[0], &inputs[1], &inputs[2]];
    [(a * a + h * h).sqrt(), (b * b + h * h).sqrt(), (a * a + b * b + h * h).sqrt()]
}

pub(super) fn corner_parallel(inputs: &[Real]) -> Real {
    let [along, across, _] = sides(inputs);
    let (a, b) = (&inputs[0], &inputs[1]);
    (a / &along * (b / &along).atan() + b / &across * (a / &across).atan()) / number(2.0, a)
}

pub(super) fn corner_perpendicular(inputs: &[Real]) -> Real {
    let [along, ..] = sides(inputs);
    let (b, h) = (&inputs[1], &inputs[2]);
    ((b / h).atan() - h / &along * (b / &along).atan()) / number(2.0, b)
}

pub(super) fn corner_solid_angle(inputs: &[Real]) -> Real {
    let [.., diagonal] = sides(inputs);
    (&inputs[0] * &inputs[1] / (&inputs[2] * diagonal)).atan()
}

/// A + B + C − π, each angle between the planes that meet in a corner.
pub(super) fn triangle(inputs: &[Real]) -> Real {
    let corners = vectors(inputs);
    let angle = |at: usize| {
        let (here, one, other) = (&corners[at], &corners[(at + 1) % 3], &corners[(at + 2) % 3]);
        let (p, q) = (cross(here, one), cross(here, other));
        let turned = cross(&p, &q);
        dot(&turned, &turned).sqrt().atan2(&dot(&p, &q))
    };
    angle(0) + angle(1) + angle(2) - pi_of(&inputs[0])
}

pub(super) fn cone(inputs: &[Real]) -> Real {
    let alpha = &inputs[0];
    number(2.0, alpha) * pi_of(alpha) * (one(alpha) - alpha.cos())
}

pub(super) fn solid_angle_of_disc(inputs: &[Real]) -> Real {
    let (radius, distance) = (&inputs[0], &inputs[1]);
    let slant = (radius * radius + distance * distance).sqrt();
    number(2.0, radius) * pi_of(radius) * (one(radius) - distance / slant)
}

pub(super) fn point(inputs: &[Real]) -> Real {
    let [flux, distance, theta] = [&inputs[0], &inputs[1], &inputs[2]];
    let cos = theta.cos();
    let zero = number(0.0, flux);
    if cos <= zero { zero } else { flux * cos / (number(4.0, flux) * pi_of(flux) * distance * distance) }
}
