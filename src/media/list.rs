//! The list: what is known of each medium, and whence.

use super::dispersion::Dispersion::{Gas, LorentzDrude, Sellmeier, Table};
use super::dispersion::Oscillator;
use super::electric::{Electric, Loss};
use super::optics::Optics;
use super::{Substance, tables};

const IN_AIR: &str = "20 °C, relative to air";
const GROUND: &str = "Recommendation ITU-R P.527-3 (1992), fig. 1, kept as fig. 24 of P.527-6 (2021)";
const METALS: &str = "CRC Handbook of Chemistry and Physics, Electrical resistivity of pure metals, 293 K";

/// Ground and fresh water: the figure starts at 10 kHz, and from 30 MHz on its conductivities rise.
const GROUND_BAND: (f64, f64) = (1e4, 3e7);

/// Every medium.
pub const SUBSTANCES: &[Substance] = &[
    Substance {
        name: "vacuum",
        aliases: &[],
        optics: Some(Optics {
            says: "empty space, n = 1",
            source: "by definition",
            conditions: "",
            range: (0.0, f64::INFINITY),
            dispersion: Sellmeier(&[]),
        }),
        electric: Some(Electric {
            says: "empty space",
            source: "by definition",
            epsilon_r: 1.0,
            mu_r: 1.0,
            loss: Loss::Conductivity(0.0),
            band: (0.0, f64::INFINITY),
        }),
    },
    Substance {
        name: "air",
        aliases: &[],
        optics: Some(Optics {
            says: "dry standard air with 450 ppm carbon dioxide",
            source: "Ciddor 1996, Appl. Opt. 35, 1566, eq. 1",
            conditions: "15 °C, 101325 Pa",
            range: (230e-9, 1690e-9),
            dispersion: Gas(&[(0.05792105, 238.0185), (0.00167917, 57.362)]),
        }),
        electric: Some(Electric {
            says: "dry air, 20 °C, 1013.25 hPa; its few fS/m are left out",
            source: "Recommendation ITU-R P.453-14 (2019), up to 100 GHz: n = 1 + 77.6e−6 · 1013.25/293.15",
            epsilon_r: 1.000_536,
            mu_r: 1.0,
            loss: Loss::Conductivity(0.0),
            band: (0.0, 1e11),
        }),
    },
    Substance {
        name: "fused-silica",
        aliases: &["SiO2", "silica", "fused-quartz"],
        optics: Some(Optics {
            says: "fused silica, SiO₂ glass",
            source: "Malitson 1965, J. Opt. Soc. Am. 55, 1205",
            conditions: IN_AIR,
            range: (210e-9, 3710e-9),
            dispersion: Sellmeier(&[
                (0.6961663, square(0.0684043)),
                (0.4079426, square(0.1162414)),
                (0.8974794, square(9.896161)),
            ]),
        }),
        electric: Some(Electric {
            says: "fused silica; its loss, tan δ < 1e−3, is left out",
            source: "von Hippel 1954, Dielectric Materials and Applications; Pozar, Microwave Engineering, appendix G, 10 GHz",
            epsilon_r: 3.78,
            mu_r: 1.0,
            loss: Loss::Conductivity(0.0),
            band: (1e2, 1e10),
        }),
    },
    Substance {
        name: "glass",
        aliases: &["borosilicate"],
        optics: Some(N_BK7),
        electric: Some(Electric {
            says: "borosilicate glass; as light meets it, N-BK7",
            source: "SCHOTT DURAN, borosilicate glass 3.3 (ISO 3585), 1 MHz, taken a decade to either side",
            epsilon_r: 4.6,
            mu_r: 1.0,
            loss: Loss::Tangent(0.0037),
            band: (1e5, 1e7),
        }),
    },
    Substance { name: "bk7", aliases: &["N-BK7"], optics: Some(N_BK7), electric: None },
    Substance {
        name: "sf10",
        aliases: &["N-SF10"],
        optics: Some(Optics {
            says: "dense flint N-SF10",
            source: "Schott 2017, optical glass catalogue, N-SF10 728285.305",
            conditions: IN_AIR,
            range: (380e-9, 2500e-9),
            dispersion: Sellmeier(&[(1.62153902, 0.0122241457), (0.256287842, 0.0595736775), (1.64447552, 147.468793)]),
        }),
        electric: None,
    },
    Substance {
        name: "sf11",
        aliases: &["N-SF11"],
        optics: Some(Optics {
            says: "dense flint N-SF11",
            source: "Schott 2017, optical glass catalogue, N-SF11 785257.322",
            conditions: IN_AIR,
            range: (370e-9, 2500e-9),
            dispersion: Sellmeier(&[(1.73759695, 0.013188707), (0.313747346, 0.0623068142), (1.89878101, 155.23629)]),
        }),
        electric: None,
    },
    Substance {
        name: "sapphire",
        aliases: &["Al2O3", "corundum"],
        optics: Some(Optics {
            says: "synthetic sapphire, ordinary ray",
            source: "Malitson & Dodge 1972, J. Opt. Soc. Am. 62, 1405; formula in Dodge 1986, CRC Handbook of Laser Science IV, p. 30",
            conditions: IN_AIR,
            range: (200e-9, 5000e-9),
            dispersion: Sellmeier(&[
                (1.4313493, square(0.0726631)),
                (0.65054713, square(0.1193242)),
                (5.3414021, square(18.028251)),
            ]),
        }),
        electric: None,
    },
    Substance {
        name: "diamond",
        aliases: &[],
        optics: Some(Optics {
            says: "diamond (the formula is extended from 644 nm, where its measurements end)",
            source: "Peter 1923, Z. Phys. 15, 358",
            conditions: "room temperature",
            range: (226e-9, 760e-9),
            dispersion: Sellmeier(&[(0.3306, square(0.1750)), (4.3356, square(0.1060))]),
        }),
        electric: None,
    },
    Substance {
        name: "mgf2",
        aliases: &["magnesium-fluoride"],
        optics: Some(Optics {
            says: "magnesium fluoride, ordinary ray: the antireflection coating",
            source: "Dodge 1984, Appl. Opt. 23, 1980",
            conditions: "19 °C, relative to air",
            range: (200e-9, 7000e-9),
            dispersion: Sellmeier(&[
                (0.48755108, square(0.04338408)),
                (0.39875031, square(0.09461442)),
                (2.3120353, square(23.793604)),
            ]),
        }),
        electric: None,
    },
    Substance {
        name: "tio2",
        aliases: &["titania", "titanium-dioxide"],
        optics: Some(Optics {
            says: "titanium dioxide, a film of 350 nm from atomic layer deposition",
            source: "Siefke et al. 2016, Adv. Opt. Mater. 4, 1780",
            conditions: "room temperature",
            range: (361e-9, 845e-9),
            dispersion: Table(&tables::TITANIA),
        }),
        electric: None,
    },
    Substance {
        name: "ice",
        aliases: &[],
        optics: Some(Optics {
            says: "water ice",
            source: "Warren & Brandt 2008, J. Geophys. Res. 113, D14220",
            conditions: "−7 °C",
            range: (350e-9, 1000e-9),
            dispersion: Table(&tables::ICE),
        }),
        electric: None,
    },
    Substance {
        name: "water",
        aliases: &["H2O", "pure-water"],
        optics: Some(Optics {
            says: "distilled water",
            source: "Daimon & Masumura 2007, Appl. Opt. 46, 3811, fit at 20.0 °C",
            conditions: "20 °C, absolute",
            range: (182e-9, 1129e-9),
            dispersion: Sellmeier(&[
                (0.5684027565, 0.005101829712),
                (0.1726177391, 0.01821153936),
                (0.02086189578, 0.02620722293),
                (0.1130748688, 10.69792721),
            ]),
        }),
        electric: Some(Electric {
            says: "pure water, 25 °C; above the band its dipoles lose more than 1 % of what its ions do",
            source: "Malmberg & Maryott 1956, J. Res. NBS 56, 1; Light et al. 2005, Electrochem. Solid-State Lett. 8, E16",
            epsilon_r: 78.3,
            mu_r: 1.0,
            loss: Loss::Conductivity(5.5e-6),
            band: (0.0, 5e5),
        }),
    },
    Substance {
        name: "fresh-water",
        aliases: &["lake"],
        optics: None,
        electric: Some(ground("lakes and rivers, 20 °C", 80.0, 3e-3)),
    },
    Substance {
        name: "sea-water",
        aliases: &["sea"],
        optics: None,
        electric: Some(Electric {
            says: "sea water, 20 °C, salinity 35; the loss of its dipoles, at 1 GHz 4.5 % of its ions', is left out",
            source: "Klein & Swift 1977, IEEE Trans. Antennas Propag. 25, 104",
            epsilon_r: 72.5,
            mu_r: 1.0,
            loss: Loss::Conductivity(4.79),
            band: (0.0, 1e9),
        }),
    },
    Substance {
        name: "wet-soil",
        aliases: &["wet-ground"],
        optics: None,
        electric: Some(ground("wet ground", 30.0, 1e-2)),
    },
    Substance {
        name: "soil",
        aliases: &["ground"],
        optics: None,
        electric: Some(ground("medium dry ground", 15.0, 1e-3)),
    },
    Substance {
        name: "dry-soil",
        aliases: &["dry-ground"],
        optics: None,
        electric: Some(ground("very dry ground", 3.0, 1e-4)),
    },
    Substance {
        name: "copper",
        aliases: &["Cu"],
        optics: Some(Optics {
            says: "evaporated copper",
            source: "Johnson & Christy 1972, Phys. Rev. B 6, 4370, table I",
            conditions: "room temperature",
            range: (188e-9, 1937e-9),
            dispersion: Table(&tables::COPPER),
        }),
        electric: Some(Electric {
            source: "IEC 60028 (1925): annealed copper, 100 % IACS, 20 °C, 1/58 Ω mm² m⁻¹",
            ..metal("annealed copper", 5.8e7, 5e11)
        }),
    },
    Substance {
        name: "silver",
        aliases: &["Ag"],
        optics: Some(Optics {
            says: "evaporated silver",
            source: "Johnson & Christy 1972, Phys. Rev. B 6, 4370, table I",
            conditions: "room temperature",
            range: (188e-9, 1937e-9),
            dispersion: Table(&tables::SILVER),
        }),
        electric: Some(metal("silver, 15.87 nΩ m", 6.301e7, 4e11)),
    },
    Substance {
        name: "gold",
        aliases: &["Au"],
        optics: Some(Optics {
            says: "evaporated gold",
            source: "Johnson & Christy 1972, Phys. Rev. B 6, 4370, table I",
            conditions: "room temperature",
            range: (188e-9, 1937e-9),
            dispersion: Table(&tables::GOLD),
        }),
        electric: Some(metal("gold, 22.14 nΩ m", 4.517e7, 5e11)),
    },
    Substance {
        name: "aluminium",
        aliases: &["Al", "aluminum"],
        optics: Some(Optics {
            says: "aluminium",
            source: "Rakić et al. 1998, Appl. Opt. 37, 5271, Lorentz–Drude model, tables 1 and 2",
            conditions: "room temperature",
            range: (62e-9, 247e-6),
            dispersion: LorentzDrude {
                plasma: 14.98,
                oscillators: &[
                    oscillator(0.523, 0.047, 0.0),
                    oscillator(0.227, 0.333, 0.162),
                    oscillator(0.050, 0.312, 1.544),
                    oscillator(0.166, 1.351, 1.808),
                    oscillator(0.030, 3.382, 3.473),
                ],
            },
        }),
        electric: Some(metal("aluminium, 26.50 nΩ m", 3.774e7, 2e12)),
    },
    Substance {
        name: "chromium",
        aliases: &["Cr", "chrome"],
        optics: Some(Optics {
            says: "chromium",
            source: "Rakić et al. 1998, Appl. Opt. 37, 5271, Lorentz–Drude model, tables 1 and 2",
            conditions: "room temperature",
            range: (248e-9, 61_900e-9),
            dispersion: LorentzDrude {
                plasma: 10.75,
                oscillators: &[
                    oscillator(0.168, 0.047, 0.0),
                    oscillator(0.151, 3.175, 0.121),
                    oscillator(0.150, 1.305, 0.543),
                    oscillator(1.149, 2.676, 1.970),
                    oscillator(0.825, 1.335, 8.775),
                ],
            },
        }),
        electric: None,
    },
    Substance {
        name: "iron",
        aliases: &["Fe"],
        optics: None,
        electric: Some(Electric {
            source: "σ: CRC Handbook, 96.1 nΩ m at 293 K; μ_r: round, between Hyperm 0 iron, 123, and AISI 1008 steel, 200, \
                 Modelica Standard Library, FluxTubes.Material.SoftMagnetic; band: Bowler, Frequency-dependence of \
                 relative permeability in steel, relaxation near 5 kHz",
            mu_r: 150.0,
            ..metal("iron in weak fields, μ_r = 150 (thousands in stronger ones)", 1.041e7, 1e3)
        }),
    },
    Substance {
        name: "graphite",
        aliases: &[],
        optics: None,
        electric: Some(Electric {
            source: "Toyo Tanso catalogue, Carbon-Graphite Products: isotropic graphite IG-110, 11 µΩ m",
            ..metal("fine-grained isotropic graphite; grades span 5 to 30 µΩ m", 9.1e4, 1e11)
        }),
    },
    Substance {
        name: "silicon",
        aliases: &["Si"],
        optics: Some(Optics {
            says: "crystalline silicon",
            source: "Green 2008, Sol. Energy Mater. Sol. Cells 92, 1305, table 1",
            conditions: "300 K",
            range: (250e-9, 1450e-9),
            dispersion: Table(&tables::SILICON),
        }),
        electric: Some(Electric {
            says: "intrinsic silicon, 300 K",
            source: "ε, mobilities 1350 + 450 cm² V⁻¹ s⁻¹: Kasap 2002, Principles of Electronic Materials and Devices (2nd ed.), \
                 table 5.1; n_i = 9.65e9 cm⁻³: Altermatt et al. 2003, J. Appl. Phys. 93, 1598",
            epsilon_r: 11.9,
            mu_r: 1.0,
            loss: Loss::Conductivity(2.78e-4),
            band: (0.0, 1e11),
        }),
    },
];

/// What light knows of N-BK7, and so of `glass`.
const N_BK7: Optics = Optics {
    says: "borosilicate crown N-BK7: what `glass` alone means to light here",
    source: "Schott 2017, optical glass catalogue, N-BK7 517642.251",
    conditions: IN_AIR,
    range: (300e-9, 2500e-9),
    dispersion: Sellmeier(&[(1.03961212, 0.00600069867), (0.231792344, 0.0200179144), (1.01046945, 103.560653)]),
};

/// A non-magnetic metal: the displacement current beside σ is that of ε_r = 1, and σ is the static one while ωt < 0.1 for
/// the relaxation time t of Ashcroft & Mermin, *Solid State Physics*, table 1.3.
const fn metal(says: &'static str, sigma: f64, highest: f64) -> Electric {
    let loss = Loss::Conductivity(sigma);
    Electric { says, source: METALS, epsilon_r: 1.0, mu_r: 1.0, loss, band: (0.0, highest) }
}

const fn ground(says: &'static str, epsilon_r: f64, sigma: f64) -> Electric {
    Electric { says, source: GROUND, epsilon_r, mu_r: 1.0, loss: Loss::Conductivity(sigma), band: GROUND_BAND }
}

/// Some sources print the resonance's wavelength, others its square.
const fn square(x: f64) -> f64 {
    x * x
}

const fn oscillator(strength: f64, damping: f64, resonance: f64) -> Oscillator {
    Oscillator { strength, damping, resonance }
}
