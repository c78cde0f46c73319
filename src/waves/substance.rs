//! Media by name, from circuits to light: constant ε_r, μ_r and loss with their source and the band in which they may
//! be taken as constant; beyond it, where it was measured, the refractive index of [`crate::optics::material`].

use super::constants::{C, EPSILON_0};
use super::plane::{Medium, Wave};
use crate::optics::material;
use std::f64::consts::TAU;
use std::fmt;

/// How a substance turns energy to heat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Loss {
    /// σ [S m⁻¹], the same at every frequency of the band.
    Conductivity(f64),
    /// tan δ = σ/(ωε) [1], the same at every frequency of the band: dielectric loss, spread over many relaxations.
    Tangent(f64),
}

/// A medium by name.
#[derive(Debug)]
pub struct Substance {
    /// Command-line word (`sea-water`).
    pub name: &'static str,
    /// Other words for it.
    pub aliases: &'static [&'static str],
    /// What it is, with what was left out.
    pub says: &'static str,
    /// Where the numbers come from.
    pub source: &'static str,
    /// ε_r [1].
    pub epsilon_r: f64,
    /// μ_r [1].
    pub mu_r: f64,
    /// What it loses.
    pub loss: Loss,
    /// Lowest and highest frequency [Hz] at which these parameters hold.
    pub band: (f64, f64),
    /// Its name in [`material::MATERIALS`], for light.
    pub optical: Option<&'static str>,
}

impl Substance {
    /// ε, μ, σ at a `frequency` [Hz] within the band.
    pub fn medium(&self, frequency: f64) -> Result<Medium, OutOfBand> {
        let (lowest, highest) = self.band;
        if !(frequency > 0.0 && frequency.is_finite() && (lowest..=highest).contains(&frequency)) {
            return Err(self.out_of_band(frequency));
        }
        let sigma = match self.loss {
            Loss::Conductivity(sigma) => sigma,
            Loss::Tangent(tangent) => tangent * TAU * frequency * self.epsilon_r * EPSILON_0,
        };
        Medium::relative(self.epsilon_r, self.mu_r, sigma).map_err(|_| self.out_of_band(frequency))
    }

    /// The wave of a `frequency` [Hz] in it: by ε, μ and σ within the band, by its refractive index where that was
    /// measured, refused elsewhere.
    pub fn wave(&self, frequency: f64) -> Result<Wave, OutOfBand> {
        let refused = |_| self.out_of_band(frequency);
        match self.medium(frequency) {
            Ok(medium) => Wave::new(&medium, TAU * frequency).map_err(refused),
            Err(outside) => {
                let index = self.material().and_then(|material| material.index(C / frequency).ok()).ok_or(outside)?;
                Wave::with_index(index, TAU * frequency).map_err(refused)
            }
        }
    }

    fn material(&self) -> Option<&'static material::Material> {
        self.optical.and_then(material::named)
    }

    fn out_of_band(&self, frequency: f64) -> OutOfBand {
        let light = self.material().map(|material| (C / material.range.1, C / material.range.0));
        OutOfBand { substance: self.name, source: self.source, frequency, band: self.band, light }
    }
}

/// The substance called `name`, by its name or an alias; case, `_`, `-` and spaces do not matter.
pub fn named(name: &str) -> Option<&'static Substance> {
    let called = |own: &&str| material::same(own, name);
    SUBSTANCES.iter().find(|substance| std::iter::once(&substance.name).chain(substance.aliases).any(called))
}

/// A frequency at which a substance's parameters are not known to hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfBand {
    /// The substance.
    pub substance: &'static str,
    /// Where its parameters come from.
    pub source: &'static str,
    /// Frequency asked for [Hz].
    pub frequency: f64,
    /// Where the parameters hold [Hz].
    pub band: (f64, f64),
    /// Where its refractive index is known [Hz].
    pub light: Option<(f64, f64)>,
}

impl fmt::Display for OutOfBand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { substance, source, frequency, band, light } = self;
        write!(
            f,
            "{substance} at {frequency:e} Hz: its ε, μ, σ ({source}) hold from {:e} Hz to {:e} Hz",
            band.0, band.1
        )?;
        light.map_or(Ok(()), |(lowest, highest)| {
            write!(f, ", its refractive index from {lowest:.3e} Hz to {highest:.3e} Hz")
        })
    }
}

impl std::error::Error for OutOfBand {}

const GROUND: &str = "Recommendation ITU-R P.527-3 (1992), fig. 1";
const METALS: &str = "CRC Handbook of Chemistry and Physics, Electrical resistivity of pure metals, 293 K";

/// Ground and fresh water: the figure starts at 10 kHz, and from 30 MHz on its conductivities rise.
const GROUND_BAND: (f64, f64) = (1e4, 3e7);

/// A non-magnetic metal: the displacement current beside σ is that of ε_r = 1, and σ is the static one while ωt < 0.1 for
/// the relaxation time t of Ashcroft & Mermin, *Solid State Physics*, table 1.3.
const fn metal(
    name: &'static str,
    symbol: &'static [&'static str],
    says: &'static str,
    sigma: f64,
    highest: f64,
) -> Substance {
    Substance {
        name,
        aliases: symbol,
        says,
        source: METALS,
        epsilon_r: 1.0,
        mu_r: 1.0,
        loss: Loss::Conductivity(sigma),
        band: (0.0, highest),
        optical: Some(name),
    }
}

const fn ground(
    name: &'static str,
    aliases: &'static [&'static str],
    says: &'static str,
    epsilon_r: f64,
    sigma: f64,
) -> Substance {
    Substance {
        name,
        aliases,
        says,
        source: GROUND,
        epsilon_r,
        mu_r: 1.0,
        loss: Loss::Conductivity(sigma),
        band: GROUND_BAND,
        optical: None,
    }
}

/// Every substance.
pub const SUBSTANCES: &[Substance] = &[
    Substance {
        name: "vacuum",
        aliases: &[],
        says: "empty space",
        source: "by definition",
        epsilon_r: 1.0,
        mu_r: 1.0,
        loss: Loss::Conductivity(0.0),
        band: (0.0, f64::INFINITY),
        optical: None,
    },
    Substance {
        name: "air",
        aliases: &[],
        says: "dry air, 20 °C, 1013.25 hPa; its few fS/m are left out",
        source: "Recommendation ITU-R P.453: n = 1 + 77.6e−6 · 1013.25/293.15",
        epsilon_r: 1.000_536,
        mu_r: 1.0,
        loss: Loss::Conductivity(0.0),
        band: (0.0, 1e11),
        optical: Some("air"),
    },
    Substance {
        name: "fused-silica",
        aliases: &["SiO2", "silica", "fused-quartz"],
        says: "fused silica; its loss, tan δ < 1e−3, is left out",
        source: "von Hippel 1954, Dielectric Materials and Applications, tables of dielectric materials",
        epsilon_r: 3.78,
        mu_r: 1.0,
        loss: Loss::Conductivity(0.0),
        band: (1e2, 1e10),
        optical: Some("fused-silica"),
    },
    Substance {
        name: "glass",
        aliases: &["borosilicate"],
        says: "borosilicate glass; as light meets it, N-BK7",
        source: "Corning 7740 data sheet, 1 MHz, taken a decade to either side",
        epsilon_r: 4.6,
        mu_r: 1.0,
        loss: Loss::Tangent(0.005),
        band: (1e5, 1e7),
        optical: Some("bk7"),
    },
    Substance {
        name: "water",
        aliases: &["H2O", "pure-water"],
        says: "pure water, 25 °C; above the band its dipoles lose more than its ions",
        source: "Malmberg & Maryott 1956, J. Res. NBS 56, 1; Light et al. 2005, Electrochem. Solid-State Lett. 8, E16",
        epsilon_r: 78.3,
        mu_r: 1.0,
        loss: Loss::Conductivity(5.5e-6),
        band: (0.0, 5e5),
        optical: Some("water"),
    },
    ground("fresh-water", &["lake"], "lakes and rivers, 20 °C", 80.0, 3e-3),
    Substance {
        name: "sea-water",
        aliases: &["sea"],
        says: "sea water, 20 °C, salinity 35",
        source: "Klein & Swift 1977, IEEE Trans. Antennas Propag. 25, 104",
        epsilon_r: 72.5,
        mu_r: 1.0,
        loss: Loss::Conductivity(4.79),
        band: (0.0, 1e9),
        optical: None,
    },
    ground("wet-soil", &["wet-ground"], "wet ground", 30.0, 1e-2),
    ground("soil", &["ground"], "medium dry ground", 15.0, 1e-3),
    ground("dry-soil", &["dry-ground"], "very dry ground", 3.0, 1e-4),
    Substance {
        source: "IEC 60028: annealed copper, 100 % IACS, 20 °C",
        ..metal("copper", &["Cu"], "annealed copper", 5.8e7, 5e11)
    },
    metal("silver", &["Ag"], "silver, 15.87 nΩ m", 6.301e7, 4e11),
    metal("gold", &["Au"], "gold, 22.14 nΩ m", 4.517e7, 5e11),
    metal("aluminium", &["Al", "aluminum"], "aluminium, 26.50 nΩ m", 3.774e7, 2e12),
    Substance {
        source: "σ: CRC Handbook, 96.1 nΩ m at 293 K; μ_r: Bozorth 1951, Ferromagnetism, initial, 99.8 % Fe",
        mu_r: 150.0,
        optical: None,
        ..metal("iron", &["Fe"], "iron in weak fields, μ_r = 150 (up to 5000 in stronger ones)", 1.041e7, 1e5)
    },
    Substance {
        source: "Toyo Tanso data sheet, isotropic graphite IG-110, 11 µΩ m",
        optical: None,
        ..metal("graphite", &[], "fine-grained isotropic graphite", 9.1e4, 1e11)
    },
    Substance {
        name: "silicon",
        aliases: &["Si"],
        says: "intrinsic silicon, 300 K",
        source: "Sze 1981, Physics of Semiconductor Devices (2nd ed.), appendix H",
        epsilon_r: 11.9,
        mu_r: 1.0,
        loss: Loss::Conductivity(4.35e-4),
        band: (0.0, 1e11),
        optical: Some("silicon"),
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::schlick::normal_reflectance;

    #[test]
    fn every_name_finds_its_own_substance_and_light_finds_its_own_index() {
        for substance in SUBSTANCES {
            for name in std::iter::once(&substance.name).chain(substance.aliases) {
                assert_eq!(named(name).unwrap().name, substance.name);
            }
            assert_eq!(substance.optical.is_some(), substance.material().is_some(), "{}", substance.name);
            assert!(!substance.source.is_empty());
        }
        assert!(named("unobtainium").is_none());
    }

    #[test]
    fn skin_depths_are_the_published_ones() {
        // Copper at 50 Hz and 1 GHz (Pozar, Microwave Engineering, §1.4, scaled to 58 MS/m), sea water at 10 kHz.
        for (name, frequency, depth) in [("copper", 50.0, 9.35e-3), ("copper", 1e9, 2.09e-6), ("sea-water", 1e4, 2.30)]
        {
            let found = named(name).unwrap().wave(frequency).unwrap().skin_depth;
            assert!((found / depth - 1.0).abs() < 3e-3, "{name} {frequency}: {found}");
        }
    }

    #[test]
    fn light_takes_over_where_circuits_end() {
        let frequency = C / 550e-9;
        for name in ["copper", "silver", "gold", "aluminium", "silicon", "water", "glass", "fused-silica", "air"] {
            let substance = named(name).unwrap();
            let index = substance.material().unwrap().index(550e-9).unwrap();
            let found = substance.wave(frequency).unwrap().index();
            assert!((found / index - 1.0).norm() < 1e-14, "{name} {found} {index}");
        }
        // A metal's reflectance follows from its impedance as from its index: (Z − Z₀)/(Z + Z₀).
        let silver = named("silver").unwrap().wave(frequency).unwrap();
        let z = silver.impedance / crate::waves::constants::Z_0;
        let reflected = ((z - 1.0) / (z + 1.0)).norm_sqr();
        assert!((reflected / normal_reflectance(1.0, silver.index()) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn frequencies_in_between_are_refused_by_name() {
        let copper = named("copper").unwrap();
        for frequency in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e13, 1e17] {
            let message = copper.wave(frequency).unwrap_err().to_string();
            assert!(message.starts_with("copper at") && message.contains("5e11 Hz, its refractive index"), "{message}");
        }
        assert!(named("vacuum").unwrap().wave(f64::MAX).is_err());
        assert!(named("vacuum").unwrap().wave(1e300).is_ok());
    }

    #[test]
    fn a_constant_tangent_makes_the_loss_a_share_of_a_cycle() {
        let glass = named("glass").unwrap();
        for frequency in [1e5, 1e6, 1e7] {
            let tangent = glass.medium(frequency).unwrap().loss_tangent(TAU * frequency);
            assert!((tangent / 0.005 - 1.0).abs() < 1e-14);
        }
    }
}
