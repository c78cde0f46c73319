//! SI dimensions: the exponents of the seven base units.

use super::rational::Rational;
use std::fmt;

/// A product of powers of m, kg, s, A, K, mol and cd. Radian and steradian are 1, as in the SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension([Rational; 7]);

const BASE: [&str; 7] = ["m", "kg", "s", "A", "K", "mol", "cd"];
/// The customary order in a product.
const ORDER: [usize; 7] = [1, 0, 2, 3, 4, 5, 6];

const fn base(which: usize) -> Dimension {
    let mut exponents = [Rational::ZERO; 7];
    exponents[which] = Rational::ONE;
    Dimension(exponents)
}

#[allow(missing_docs, reason = "each name is its own documentation")]
impl Dimension {
    pub const ONE: Self = Self([Rational::ZERO; 7]);
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

/// Units with a name that readers expect. Where two fit (T/s and V/m², Pa and J/m³) the one of this lecture stands.
const NAMED: [(Dimension, &str); 33] = [
    (Dimension::ONE, "1"),
    (Dimension::SQUARE_METRE, "m²"),
    (Dimension::CUBIC_METRE, "m³"),
    (Dimension::HERTZ, "1/s"),
    (Dimension::METRE_PER_SECOND, "m/s"),
    (Dimension::RADIAN_PER_METRE, "1/m"),
    (Dimension::ONE.per(Dimension::SQUARE_METRE), "1/m²"),
    (Dimension::NEWTON, "N"),
    (Dimension::JOULE, "J"),
    (Dimension::WATT, "W"),
    (Dimension::COULOMB, "C"),
    (Dimension::VOLT, "V"),
    (Dimension::OHM, "Ω"),
    (Dimension::SIEMENS, "S"),
    (Dimension::FARAD, "F"),
    (Dimension::WEBER, "Wb"),
    (Dimension::TESLA, "T"),
    (Dimension::HENRY, "H"),
    (Dimension::VOLT_PER_METRE, "V/m"),
    (Dimension::VOLT.per(Dimension::SQUARE_METRE), "V/m²"),
    (Dimension::VOLT.per(Dimension::CUBIC_METRE), "V/m³"),
    (Dimension::AMPERE_PER_METRE, "A/m"),
    (Dimension::AMPERE_PER_SQUARE_METRE, "A/m²"),
    (Dimension::COULOMB_PER_SQUARE_METRE, "C/m²"),
    (Dimension::COULOMB_PER_CUBIC_METRE, "C/m³"),
    (Dimension::FARAD_PER_METRE, "F/m"),
    (Dimension::HENRY_PER_METRE, "H/m"),
    (Dimension::SIEMENS_PER_METRE, "S/m"),
    (Dimension::WATT_PER_METRE, "W/m"),
    (Dimension::WATT_PER_SQUARE_METRE, "W/m²"),
    (Dimension::WATT_PER_CUBIC_METRE, "W/m³"),
    (Dimension::WATT_PER_SECOND, "W/s"),
    (Dimension::JOULE_PER_CUBIC_METRE, "J/m³"),
];

impl Dimension {
    /// The exponent of each base unit, in the order m, kg, s, A, K, mol, cd.
    pub const fn exponents(&self) -> &[Rational; 7] {
        &self.0
    }

    /// The product, for definitions.
    ///
    /// # Panics
    /// If an exponent leaves the range of [`Rational`]; [`Self::checked_times`] does not.
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
        let mut exponents = self.0;
        let mut at = 0;
        while at < 7 {
            exponents[at] = exponents[at].negated();
            at += 1;
        }
        Self(exponents)
    }

    /// The product; `None` if an exponent leaves the range of [`Rational`].
    pub const fn checked_times(self, other: Self) -> Option<Self> {
        let mut exponents = self.0;
        let mut at = 0;
        while at < 7 {
            let Some(sum) = exponents[at].plus(other.0[at]) else { return None };
            exponents[at] = sum;
            at += 1;
        }
        Some(Self(exponents))
    }

    /// The power; `None` if an exponent leaves the range of [`Rational`].
    pub const fn checked_power(self, power: Rational) -> Option<Self> {
        let mut exponents = self.0;
        let mut at = 0;
        while at < 7 {
            let Some(product) = exponents[at].times(power) else { return None };
            exponents[at] = product;
            at += 1;
        }
        Some(Self(exponents))
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        if let Some((_, name)) = NAMED.iter().find(|(dimension, _)| dimension == self) {
            return f.write_str(name);
        }
        let factors = ORDER.iter().filter(|at| !self.0[**at].is_zero()).map(|at| factor(BASE[*at], self.0[*at]));
        f.write_str(&factors.collect::<Vec<_>>().join(" "))
    }
}

fn factor(unit: &str, exponent: Rational) -> String {
    match exponent.as_integer() {
        Some(1) => unit.to_owned(),
        Some(n) => format!("{unit}{}", super::face::superscript(&n.to_string()).expect("digits can be raised")),
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
        let root = Dimension::SECOND.checked_power(Rational::new(1, 2).unwrap()).unwrap();
        assert_eq!(root.to_string(), "s^(1/2)");
        assert_eq!(root.checked_times(root), Some(Dimension::SECOND));
    }

    #[test]
    fn derives_the_electrical_units() {
        let base = |m, kg, s, a| Dimension([m, kg, s, a, 0, 0, 0].map(Rational::from));
        assert_eq!(Dimension::VOLT, base(2, 1, -3, -1));
        assert_eq!(Dimension::OHM, base(2, 1, -3, -2));
        assert_eq!(Dimension::FARAD, base(-2, -1, 4, 2));
        assert_eq!(Dimension::TESLA, base(0, 1, -2, -1));
        assert_eq!(Dimension::HENRY, base(2, 1, -2, -2));
    }

    #[test]
    fn no_unit_is_named_twice() {
        for (at, (dimension, name)) in NAMED.iter().enumerate() {
            assert!(NAMED[..at].iter().all(|(other, _)| other != dimension), "{name}");
        }
    }
}
