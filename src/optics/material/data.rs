//! The media, each with its source.

use super::dispersion::Dispersion::{Gas, LorentzDrude, Sellmeier, Table};
use super::dispersion::Oscillator;
use super::{Material, tables};

const IN_AIR: &str = "20 °C, relative to air";

/// Every material.
pub const MATERIALS: &[Material] = &[
    Material {
        name: "vacuum",
        aliases: &[],
        says: "empty space, n = 1",
        source: "by definition",
        conditions: "",
        range: (0.0, f64::INFINITY),
        dispersion: Sellmeier(&[]),
    },
    Material {
        name: "air",
        aliases: &[],
        says: "dry standard air with 450 ppm carbon dioxide",
        source: "Ciddor 1996, Appl. Opt. 35, 1566, eq. 1",
        conditions: "15 °C, 101325 Pa",
        range: (230e-9, 1690e-9),
        dispersion: Gas(&[(0.05792105, 238.0185), (0.00167917, 57.362)]),
    },
    Material {
        name: "water",
        aliases: &["H2O"],
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
    },
    Material {
        name: "ice",
        aliases: &[],
        says: "water ice",
        source: "Warren & Brandt 2008, J. Geophys. Res. 113, D14220",
        conditions: "−7 °C",
        range: (350e-9, 1000e-9),
        dispersion: Table(&tables::ICE),
    },
    Material {
        name: "fused-silica",
        aliases: &["SiO2", "silica", "fused-quartz"],
        says: "fused silica, SiO₂ glass",
        source: "Malitson 1965, J. Opt. Soc. Am. 55, 1205",
        conditions: IN_AIR,
        range: (210e-9, 3710e-9),
        dispersion: Sellmeier(&[
            (0.6961663, square(0.0684043)),
            (0.4079426, square(0.1162414)),
            (0.8974794, square(9.896161)),
        ]),
    },
    Material {
        name: "bk7",
        aliases: &["N-BK7", "glass"],
        says: "borosilicate crown N-BK7: what `glass` alone means here",
        source: "Schott 2017, optical glass catalogue, N-BK7 517642.251",
        conditions: IN_AIR,
        range: (300e-9, 2500e-9),
        dispersion: Sellmeier(&[(1.03961212, 0.00600069867), (0.231792344, 0.0200179144), (1.01046945, 103.560653)]),
    },
    Material {
        name: "sf10",
        aliases: &["N-SF10"],
        says: "dense flint N-SF10",
        source: "Schott 2017, optical glass catalogue, N-SF10 728285.305",
        conditions: IN_AIR,
        range: (380e-9, 2500e-9),
        dispersion: Sellmeier(&[(1.62153902, 0.0122241457), (0.256287842, 0.0595736775), (1.64447552, 147.468793)]),
    },
    Material {
        name: "sf11",
        aliases: &["N-SF11"],
        says: "dense flint N-SF11",
        source: "Schott 2017, optical glass catalogue, N-SF11 785257.322",
        conditions: IN_AIR,
        range: (370e-9, 2500e-9),
        dispersion: Sellmeier(&[(1.73759695, 0.013188707), (0.313747346, 0.0623068142), (1.89878101, 155.23629)]),
    },
    Material {
        name: "sapphire",
        aliases: &["Al2O3", "corundum"],
        says: "synthetic sapphire, ordinary ray",
        source: "Malitson & Dodge 1972, J. Opt. Soc. Am. 62, 1405; formula in Dodge 1986, CRC Handbook of Laser Science IV, p. 30",
        conditions: IN_AIR,
        range: (200e-9, 5000e-9),
        dispersion: Sellmeier(&[
            (1.4313493, square(0.0726631)),
            (0.65054713, square(0.1193242)),
            (5.3414021, square(18.028251)),
        ]),
    },
    Material {
        name: "diamond",
        aliases: &[],
        says: "diamond (the formula is extended from 644 nm, where its measurements end)",
        source: "Peter 1923, Z. Phys. 15, 358",
        conditions: "room temperature",
        range: (226e-9, 760e-9),
        dispersion: Sellmeier(&[(0.3306, square(0.1750)), (4.3356, square(0.1060))]),
    },
    Material {
        name: "mgf2",
        aliases: &["magnesium-fluoride"],
        says: "magnesium fluoride, ordinary ray: the antireflection coating",
        source: "Dodge 1984, Appl. Opt. 23, 1980",
        conditions: "19 °C, relative to air",
        range: (200e-9, 7000e-9),
        dispersion: Sellmeier(&[
            (0.48755108, square(0.04338408)),
            (0.39875031, square(0.09461442)),
            (2.3120353, square(23.793604)),
        ]),
    },
    Material {
        name: "tio2",
        aliases: &["titania", "titanium-dioxide"],
        says: "titanium dioxide, a film of 350 nm from atomic layer deposition",
        source: "Siefke et al. 2016, Adv. Opt. Mater. 4, 1780",
        conditions: "room temperature",
        range: (361e-9, 845e-9),
        dispersion: Table(&tables::TITANIA),
    },
    Material {
        name: "gold",
        aliases: &["Au"],
        says: "evaporated gold",
        source: "Johnson & Christy 1972, Phys. Rev. B 6, 4370, table I",
        conditions: "room temperature",
        range: (188e-9, 1937e-9),
        dispersion: Table(&tables::GOLD),
    },
    Material {
        name: "silver",
        aliases: &["Ag"],
        says: "evaporated silver",
        source: "Johnson & Christy 1972, Phys. Rev. B 6, 4370, table I",
        conditions: "room temperature",
        range: (188e-9, 1937e-9),
        dispersion: Table(&tables::SILVER),
    },
    Material {
        name: "copper",
        aliases: &["Cu"],
        says: "evaporated copper",
        source: "Johnson & Christy 1972, Phys. Rev. B 6, 4370, table I",
        conditions: "room temperature",
        range: (188e-9, 1937e-9),
        dispersion: Table(&tables::COPPER),
    },
    Material {
        name: "aluminium",
        aliases: &["Al", "aluminum"],
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
    },
    Material {
        name: "chromium",
        aliases: &["Cr", "chrome"],
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
    },
    Material {
        name: "silicon",
        aliases: &["Si"],
        says: "crystalline silicon",
        source: "Green 2008, Sol. Energy Mater. Sol. Cells 92, 1305, table 1",
        conditions: "300 K",
        range: (250e-9, 1450e-9),
        dispersion: Table(&tables::SILICON),
    },
];

/// Some sources print the resonance's wavelength, others its square.
const fn square(x: f64) -> f64 {
    x * x
}

const fn oscillator(strength: f64, damping: f64, resonance: f64) -> Oscillator {
    Oscillator { strength, damping, resonance }
}
