//! SI dimensions: the exponents of the seven base units.

use super::glyph::superscript;
use super::rational::{Rational, greatest_common_divisor};
use std::fmt;

/// A product of powers of m, kg, s, A, K, mol and cd. Radian and steradian are 1, as in the SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// Exponents times their least common denominator.
    numerators: [i16; 7],
    denominator: i16,
}

const BASE: [&str; 7] = ["m", "kg", "s", "A", "K", "mol", "cd"];
/// The customary order in a product.
const ORDER: [usize; 7] = [1, 0, 2, 3, 4, 5, 6];

const fn base(which: usize) -> Dimension {
    let mut numerators = [0; 7];
    numerators[which] = 1;
    Dimension { numerators, denominator: 1 }
}

#[allow(missing_docs, reason = "each name is its own documentation")]
impl Dimension {
    pub const ONE: Self = Self { numerators: [0; 7], denominator: 1 };
    pub const METRE: Self = base(0);
    pub const KILOGRAM: Self = base(1);
    pub const SECOND: Self = base(2);
    pub const AMPERE: Self = base(3);
    pub const KELVIN: Self = base(4);
    pub const MOLE: Self = base(5);
    pub const CANDELA: Self = base(6);
    pub const SQUARE_METRE: Self = Self::METRE.times(Self::METRE);
    pub const CUBIC_METRE: Self = Self::SQUARE_METRE.times(Self::METRE);
    pub const HERTZ: Self = Self::ONE.per(Self::SECOND);
    pub const METRE_PER_SECOND: Self = Self::METRE.per(Self::SECOND);
    pub const RADIAN_PER_METRE: Self = Self::ONE.per(Self::METRE);
    pub const NEWTON: Self = Self::KILOGRAM.times(Self::METRE_PER_SECOND).per(Self::SECOND);
    pub const JOULE: Self = Self::NEWTON.times(Self::METRE);
    pub const WATT: Self = Self::JOULE.per(Self::SECOND);
    pub const COULOMB: Self = Self::AMPERE.times(Self::SECOND);
    pub const VOLT: Self = Self::WATT.per(Self::AMPERE);
    pub const OHM: Self = Self::VOLT.per(Self::AMPERE);
    pub const SIEMENS: Self = Self::AMPERE.per(Self::VOLT);
    pub const FARAD: Self = Self::COULOMB.per(Self::VOLT);
    pub const WEBER: Self = Self::VOLT.times(Self::SECOND);
    pub const TESLA: Self = Self::WEBER.per(Self::SQUARE_METRE);
    pub const HENRY: Self = Self::WEBER.per(Self::AMPERE);
    pub const VOLT_PER_METRE: Self = Self::VOLT.per(Self::METRE);
    pub const AMPERE_PER_METRE: Self = Self::AMPERE.per(Self::METRE);
    pub const AMPERE_PER_SQUARE_METRE: Self = Self::AMPERE.per(Self::SQUARE_METRE);
    pub const COULOMB_PER_SQUARE_METRE: Self = Self::COULOMB.per(Self::SQUARE_METRE);
    pub const COULOMB_PER_CUBIC_METRE: Self = Self::COULOMB.per(Self::CUBIC_METRE);
    pub const FARAD_PER_METRE: Self = Self::FARAD.per(Self::METRE);
    pub const HENRY_PER_METRE: Self = Self::HENRY.per(Self::METRE);
    pub const SIEMENS_PER_METRE: Self = Self::SIEMENS.per(Self::METRE);
    pub const WATT_PER_METRE: Self = Self::WATT.per(Self::METRE);
    pub const WATT_PER_SQUARE_METRE: Self = Self::WATT.per(Self::SQUARE_METRE);
    pub const WATT_PER_CUBIC_METRE: Self = Self::WATT.per(Self::CUBIC_METRE);
    pub const WATT_PER_SECOND: Self = Self::WATT.per(Self::SECOND);
    pub const JOULE_PER_CUBIC_METRE: Self = Self::JOULE.per(Self::CUBIC_METRE);
}

/// Units that readers expect to see, by themselves or per something. Where two fit, the earlier stands: V/m², not T/s.
/// The newton is left out: N/m² would come before the J/m³ of an energy density.
const NAMED: [(Dimension, &str); 17] = [
    (Dimension::ONE, "1"),
    (Dimension::METRE, "m"),
    (Dimension::SECOND, "s"),
    (Dimension::KILOGRAM, "kg"),
    (Dimension::SQUARE_METRE, "m²"),
    (Dimension::CUBIC_METRE, "m³"),
    (Dimension::WATT, "W"),
    (Dimension::VOLT, "V"),
    (Dimension::AMPERE, "A"),
    (Dimension::COULOMB, "C"),
    (Dimension::TESLA, "T"),
    (Dimension::WEBER, "Wb"),
    (Dimension::OHM, "Ω"),
    (Dimension::SIEMENS, "S"),
    (Dimension::FARAD, "F"),
    (Dimension::HENRY, "H"),
    (Dimension::JOULE, "J"),
];
const PER: [(Dimension, &str); 8] = [
    (Dimension::ONE, ""),
    (Dimension::METRE, "/m"),
    (Dimension::SQUARE_METRE, "/m²"),
    (Dimension::CUBIC_METRE, "/m³"),
    (Dimension::SECOND, "/s"),
    (Dimension::METRE.times(Dimension::SECOND), "/(m s)"),
    (Dimension::SECOND.times(Dimension::SECOND), "/s²"),
    (Dimension::METRE.times(Dimension::SECOND).times(Dimension::SECOND), "/(m s²)"),
];
/// How many of the units, counted from the last, may stand in a product of two: V T/m.
const DERIVED: usize = 11;

impl Dimension {
    /// The exponent of each base unit, in the order m, kg, s, A, K, mol, cd.
    pub fn exponents(&self) -> [Rational; 7] {
        let denominator = self.denominator.into();
        self.numerators.map(|n| Rational::new(n.into(), denominator).expect("a positive denominator"))
    }

    /// The product, for definitions.
    ///
    /// # Panics
    /// If an exponent is out of range; [`Self::checked_times`] does not.
    pub const fn times(self, other: Self) -> Self {
        self.checked_times(other).expect("exponents of a unit within range")
    }

    /// The quotient, for definitions.
    ///
    /// # Panics
    /// As [`Self::times`].
    pub const fn per(self, other: Self) -> Self {
        self.times(other.inverse())
    }

    /// 1 over it.
    pub const fn inverse(self) -> Self {
        let mut numerators = self.numerators;
        let mut at = 0;
        while at < 7 {
            numerators[at] = -numerators[at];
            at += 1;
        }
        Self { numerators, ..self }
    }

    /// The product; `None` if numerator or denominator of an exponent would exceed 32 767.
    pub const fn checked_times(self, other: Self) -> Option<Self> {
        let mut sums = [0; 7];
        let mut at = 0;
        while at < 7 {
            sums[at] = self.numerators[at] as i64 * other.denominator as i64
                + other.numerators[at] as i64 * self.denominator as i64;
            at += 1;
        }
        Self::reduce(sums, self.denominator as i64 * other.denominator as i64)
    }

    /// The power; `None` if numerator or denominator of an exponent would exceed 32 767.
    pub const fn checked_power(self, power: Rational) -> Option<Self> {
        let (Some(numerator), Some(denominator)) = (small(power.numerator()), small(power.denominator())) else {
            return None;
        };
        let mut products = [0; 7];
        let mut at = 0;
        while at < 7 {
            products[at] = self.numerators[at] as i64 * numerator as i64;
            at += 1;
        }
        Self::reduce(products, self.denominator as i64 * denominator as i64)
    }

    /// In lowest terms.
    const fn reduce(numerators: [i64; 7], denominator: i64) -> Option<Self> {
        let mut divisor = denominator.unsigned_abs() as u128;
        let mut at = 0;
        while at < 7 {
            divisor = greatest_common_divisor(divisor, numerators[at].unsigned_abs() as u128);
            at += 1;
        }
        let mut reduced = [0; 7];
        at = 0;
        while at < 7 {
            let Some(numerator) = small(numerators[at] / divisor as i64) else { return None };
            reduced[at] = numerator;
            at += 1;
        }
        match small(denominator / divisor as i64) {
            Some(denominator) => Some(Self { numerators: reduced, denominator }),
            None => None,
        }
    }
}

/// `n` where it and −`n` fit.
const fn small(n: i64) -> Option<i16> {
    if n.unsigned_abs() <= i16::MAX as u64 { Some(n as i16) } else { None }
}

impl Dimension {
    /// As a unit that has a name, or such a one per another: W/m².
    fn quotient(self) -> Option<String> {
        PER.iter().find_map(|(below, per)| {
            let above = self.checked_times(*below)?;
            NAMED.iter().find(|(dimension, _)| *dimension == above).map(|(_, name)| format!("{name}{per}"))
        })
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        if let Some(name) = self.quotient() {
            return f.write_str(&name);
        }
        let above = |below: Dimension| self.checked_times(below);
        let derived = &NAMED[NAMED.len() - DERIVED..];
        let pairs = || derived.iter().flat_map(|a| derived.iter().map(move |b| (a, b)));
        for (below, per) in PER {
            if let Some(((_, a), (_, b))) = pairs().find(|(a, b)| a.0.checked_times(b.0) == above(below)) {
                return write!(f, "{a} {b}{per}");
            }
        }
        let half = Rational::new(1.into(), 2.into()).expect("a positive denominator");
        if let Some(root) = self.checked_power(half).and_then(|root| root.quotient()) {
            return write!(f, "({root})²");
        }
        let exponents = self.exponents();
        let present = ORDER.iter().filter(|at| !exponents[**at].is_zero());
        f.write_str(&present.map(|at| factor(BASE[*at], exponents[*at])).collect::<Vec<_>>().join(" "))
    }
}

fn factor(unit: &str, exponent: Rational) -> String {
    match exponent.as_integer() {
        Some(1) => unit.to_owned(),
        Some(n) => format!("{unit}{}", superscript(&n.to_string()).expect("digits can be raised")),
        None => format!("{unit}^({exponent})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_units_as_readers_expect() {
        assert_eq!(Dimension::VOLT.per(Dimension::METRE).to_string(), "V/m");
        assert_eq!(Dimension::KILOGRAM.times(Dimension::METRE).per(Dimension::AMPERE).to_string(), "kg m A⁻¹");
        assert_eq!(Dimension::WATT.per(Dimension::SECOND).to_string(), "W/s");
        let irradiance = Dimension::WATT.per(Dimension::SQUARE_METRE);
        assert_eq!(irradiance.times(irradiance).to_string(), "(W/m²)²");
        assert_eq!(Dimension::JOULE.per(Dimension::CUBIC_METRE).to_string(), "J/m³");
        assert_eq!(Dimension::METRE_PER_SECOND.inverse().to_string(), "s/m");
        assert_eq!(Dimension::TESLA.times(Dimension::SQUARE_METRE).to_string(), "Wb");
        assert_eq!(Dimension::TESLA.per(Dimension::SECOND).to_string(), "V/m²");
        assert_eq!(Dimension::VOLT_PER_METRE.per(Dimension::SECOND).per(Dimension::SECOND).to_string(), "V/(m s²)");
        assert_eq!(Dimension::VOLT_PER_METRE.times(Dimension::TESLA).to_string(), "V T/m");
        assert_eq!(Dimension::METRE.per(Dimension::SECOND).per(Dimension::SECOND).to_string(), "m/s²");
        let root = Dimension::SECOND.checked_power(Rational::new(1, 2).unwrap()).unwrap();
        assert_eq!(root.to_string(), "s^(1/2)");
        assert_eq!(root.checked_times(root), Some(Dimension::SECOND));
    }

    #[test]
    fn derives_the_electrical_units() {
        let base = |m, kg, s, a| Dimension { numerators: [m, kg, s, a, 0, 0, 0], denominator: 1 };
        assert_eq!(Dimension::VOLT, base(2, 1, -3, -1));
        assert_eq!(Dimension::OHM, base(2, 1, -3, -2));
        assert_eq!(Dimension::FARAD, base(-2, -1, 4, 2));
        assert_eq!(Dimension::TESLA, base(0, 1, -2, -1));
        assert_eq!(Dimension::HENRY, base(2, 1, -2, -2));
    }
}
