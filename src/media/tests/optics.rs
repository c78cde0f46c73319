//! Every family against two sources that share no numbers: another laboratory, another formula, a catalogue's own lines.

use crate::media::Dispersion::{Gas, LorentzDrude, Sellmeier, Table};
use crate::media::optics::Nanometres;
use crate::media::{Dispersion, Medium, Optics, Oscillator, Row, Substance, cauchy, named, optical};
use num_complex::Complex64;
use proptest::prelude::*;

/// Spectral lines [m] as catalogues name them.
const D: f64 = 587.5618e-9;
const F: f64 = 486.1327e-9;
const C: f64 = 656.2725e-9;
const SODIUM: f64 = 589.3e-9;

fn index(name: &str, wavelength: f64) -> Complex64 {
    named(name).unwrap().index(wavelength).unwrap()
}

fn n(name: &str, wavelength: f64) -> f64 {
    index(name, wavelength).re
}

/// Reflectance [1] from vacuum at normal incidence.
fn reflectance(index: Complex64) -> f64 {
    ((index - 1.0) / (index + 1.0)).norm_sqr()
}

/// 380 nm to 750 nm in steps of 1 nm.
fn visible() -> impl Iterator<Item = f64> {
    (380..=750).map(|nanometres| f64::from(nanometres) * 1e-9)
}

/// |a − b| ≤ limit, at a wavelength [m] that a failure names.
fn assert_near(a: f64, b: f64, limit: f64, wavelength: f64) {
    assert!((a - b).abs() <= limit, "{a} against {b} at {}", Nanometres(wavelength));
}

/// Two laws of n, everywhere in the visible.
fn assert_agree(name: &str, other: &Dispersion, limit: f64) {
    for wavelength in visible() {
        assert_near(n(name, wavelength), other.index(wavelength).re, limit, wavelength);
    }
}

#[test]
fn glasses_have_the_n_and_v_of_the_catalogue() {
    // Schott's catalogue prints five and two decimals.
    for (name, n_d, v_d) in [("bk7", 1.51680, 64.17), ("sf10", 1.72828, 28.53), ("sf11", 1.78472, 25.68)] {
        let abbe = (n(name, D) - 1.0) / (n(name, F) - n(name, C));
        assert_near(n(name, D), n_d, 0.6e-5, D);
        assert_near(abbe, v_d, 0.006, D);
    }
}

#[test]
fn bk7_has_the_lines_of_its_data_sheet() {
    let lines =
        [(546.0740, 1.51872), (486.1327, 1.52238), (435.8343, 1.52668), (656.2725, 1.51432), (365.0146, 1.53627)];
    for (nanometres, expected) in lines {
        assert_near(n("bk7", nanometres * 1e-9), expected, 0.6e-5, nanometres * 1e-9);
    }
}

#[test]
fn silica_agrees_with_another_laboratory() {
    assert_near(n("fused-silica", D), 1.45846, 0.6e-5, D);
    // Arosa & de la Fuente, Opt. Lett. 45, 4268 (2020); they state lower accuracy than Malitson: 1e-4.
    let arosa = Sellmeier(&[(0.9310, 0.079 * 0.079), (0.1735, 0.130 * 0.130), (2.1121, 14.918 * 14.918)]);
    assert_agree("fused-silica", &arosa, 1e-4);
}

#[test]
fn water_agrees_with_the_release_of_iapws() {
    assert_near(n("water", SODIUM), 1.3330, 4e-4, SODIUM); // handbooks: relative to air
    for wavelength in visible() {
        // The uncertainty that the release claims for liquid water at ambient conditions.
        assert_near(n("water", wavelength), iapws(wavelength), 1.5e-5, wavelength);
    }
}

/// IAPWS R9-97, eq. 1, for water at 20 °C and 998.2071 kg m⁻³.
fn iapws(wavelength: f64) -> f64 {
    let (density, temperature, square) = (0.9982071_f64, 293.15 / 273.15, (wavelength / 0.589e-6).powi(2));
    let sum = 0.244257733 + 9.74634476e-3 * density - 3.73234996e-3 * temperature
        + 2.68678472e-4 * square * temperature
        + 1.58920570e-3 / square
        + 2.45934259e-3 / (square - 0.2292020_f64.powi(2))
        + 0.900704920 / (square - 5.432937_f64.powi(2))
        - 1.66626219e-2 * density * density;
    let q = density * sum;
    ((1.0 + 2.0 * q) / (1.0 - q)).sqrt()
}

#[test]
fn air_agrees_with_edlen() {
    // B. Edlén, Metrologia 2, 71 (1966), eq. 1, dry air with 300 ppm CO₂ instead of 450: 2e-8 apart.
    for wavelength in visible() {
        let square = (wavelength * 1e6).powi(-2);
        let edlen = 8342.13 + 2_406_030.0 / (130.0 - square) + 15_997.0 / (38.9 - square);
        assert_near(n("air", wavelength), 1.0 + edlen * 1e-8, 3e-8, wavelength);
    }
    let peck = Gas(&[(0.05791817, 238.0185), (0.00167909, 57.362)]); // Peck & Reeder, J. Opt. Soc. Am. 62, 958 (1972)
    assert_agree("air", &peck, 3e-8);
}

#[test]
fn crystals_agree_with_another_source() {
    // Malitson, J. Opt. Soc. Am. 52, 1377 (1962), at 24 °C: dn/dT is 1.3e-5 per kelvin.
    let malitson = Sellmeier(&[
        (1.023798, 0.06144821 * 0.06144821),
        (1.058264, 0.1106997 * 0.1106997),
        (5.280792, 17.92656 * 17.92656),
    ]);
    assert_agree("sapphire", &malitson, 1e-4);
    // Li, J. Phys. Chem. Ref. Data 9, 161 (1980), ordinary ray. His constant 1.2762 is a resonance at wavelength 0.
    let li = Sellmeier(&[(0.27620, 0.0), (0.60967, 0.08636 * 0.08636), (0.0080, 324.0), (2.14973, 625.0)]);
    assert_agree("mgf2", &li, 1e-4);
    // Phillip & Taft, Phys. Rev. 136, A1445 (1964), also beyond the 644 nm of Peter's measurements.
    for (nanometres, expected) in [(442.800669, 2.441252), (563.564488, 2.420857), (688.801041, 2.406543)] {
        assert_near(n("diamond", nanometres * 1e-9), expected, 0.01, nanometres * 1e-9);
    }
    // Merwin, International Critical Tables VII (1930): ordinary and extraordinary ray at −3 °C.
    assert!((1.3091..1.3105).contains(&n("ice", SODIUM)));
    // Zhukovsky et al., Phys. Rev. Lett. 115, 177402 (2015): another film from atomic layer deposition.
    for (nanometres, expected) in [(450.965, 2.554435), (549.049, 2.436534), (650.253, 2.381385), (749.721, 2.351287)] {
        assert_near(n("tio2", nanometres * 1e-9), expected, 0.01, nanometres * 1e-9);
    }
}

/// Reflectances against another laboratory's `rows`: wavelength [nm], n, κ.
fn assert_reflectance(name: &str, limit: f64, rows: &[Row]) {
    for &[nanometres, n, k] in rows {
        let wavelength = nanometres * 1e-9;
        assert_near(reflectance(index(name, wavelength)), reflectance(Complex64::new(n, k)), limit, wavelength);
    }
}

// Films differ by their grain and roughness, hence the bounds in hundredths. Copper is compared off its absorption edge
// (560 nm to 620 nm), where McPeak's smoother films reflect 0.12 more.
#[test]
#[rustfmt::skip]
fn metals_reflect_as_measured_elsewhere() {
    // McPeak et al., ACS Photonics 2, 326 (2015): evaporated, template-stripped films.
    assert_reflectance("gold", 0.06, &[
        [450.0, 1.53833, 1.91075], [500.0, 0.84847, 1.82828], [550.0, 0.32393, 2.59716], [600.0, 0.18879, 3.24170],
        [700.0, 0.09861, 4.30508],
    ]);
    assert_reflectance("silver", 0.01, &[
        [400.0, 0.04573, 2.12294], [500.0, 0.04137, 3.15940], [600.0, 0.04741, 4.04194], [700.0, 0.05486, 4.86909],
    ]);
    assert_reflectance("copper", 0.06, &[
        [450.0, 1.04821, 2.41364], [500.0, 1.02922, 2.60096], [550.0, 0.79746, 2.56420], [650.0, 0.10423, 3.77569],
        [700.0, 0.10124, 4.27063],
    ]);
    assert_reflectance("aluminium", 0.01, &[
        [400.0, 0.37515, 4.22643], [500.0, 0.62569, 5.32048], [550.0, 0.78941, 5.85194], [650.0, 1.24636, 6.85233],
        [700.0, 1.55975, 7.27391],
    ]);
    // Sytchkova et al., Opt. Mater. 121, 111530 (2021): sputtered.
    assert_reflectance("chromium", 0.05, &[
        [396.34, 1.88367, 3.93950], [451.39, 2.34840, 4.48387], [550.85, 3.59762, 4.89768], [650.0, 4.34864, 4.68401],
    ]);
    // Aspnes & Studna, Phys. Rev. B 27, 985 (1983).
    assert_reflectance("silicon", 0.012, &[
        [295.2, 4.888, 4.639], [413.3, 5.222, 0.269], [495.9, 4.320, 0.073], [619.9, 3.906, 0.022],
        [774.9, 3.714, 0.008],
    ]);
}

#[test]
fn mirrors_reflect_as_handbooks_say() {
    assert!((0.91..0.92).contains(&reflectance(index("aluminium", 550e-9))));
    assert!(visible().all(|wavelength| reflectance(index("silver", wavelength)) > 0.95));
    assert_near(reflectance(index("silicon", 600e-9)), 0.35, 0.01, 600e-9);
    assert!(reflectance(index("gold", 450e-9)) < 0.45 && reflectance(index("gold", 650e-9)) > 0.95); // why it is yellow
}

#[test]
fn gold_agrees_with_the_oscillators_fitted_to_other_measurements() {
    const OSCILLATORS: &[Oscillator] = &[
        Oscillator { strength: 0.760, damping: 0.053, resonance: 0.0 },
        Oscillator { strength: 0.024, damping: 0.241, resonance: 0.415 },
        Oscillator { strength: 0.010, damping: 0.345, resonance: 0.830 },
        Oscillator { strength: 0.071, damping: 0.870, resonance: 2.969 },
        Oscillator { strength: 0.601, damping: 2.494, resonance: 4.304 },
        Oscillator { strength: 4.384, damping: 2.214, resonance: 13.32 },
    ];
    // Rakić et al. 1998; five Lorentzians round off the edge between the bands at 500 nm, the worst place by 0.07.
    let fit = LorentzDrude { plasma: 9.03, oscillators: OSCILLATORS };
    for wavelength in visible() {
        assert_near(reflectance(index("gold", wavelength)), reflectance(fit.index(wavelength)), 0.075, wavelength);
    }
}

#[test]
fn oscillators_are_summed_as_elsewhere() {
    // Aluminium from the same parameters in the refractiveindex.info database: κ and wavelength in five digits.
    let rows = [
        [0.10034e-6, 0.039745, 0.68444],
        [0.55033e-6, 0.96708, 6.4617],
        [0.81300e-6, 2.7157, 8.2271],
        [1.2010e-6, 1.2695, 11.577],
    ];
    for [wavelength, n, k] in rows {
        assert_near(index("aluminium", wavelength).re, n, 1e-4 * k, wavelength);
        assert_near(index("aluminium", wavelength).im, k, 1e-4 * k, wavelength);
    }
}

/// Every medium of which an index is known, with it.
fn indices() -> impl Iterator<Item = (&'static str, &'static Optics)> {
    optical().filter_map(|known| Some((known.name, known.optics.as_ref()?)))
}

fn tables() -> impl Iterator<Item = (&'static str, &'static Optics, &'static [Row])> {
    indices().filter_map(|(name, optics)| match optics.dispersion {
        Table(rows) => Some((name, optics, rows)),
        _ => None,
    })
}

#[test]
fn tables_rise_in_wavelength_and_hold_their_range() {
    for (name, optics, rows) in tables() {
        assert!(rows.is_sorted_by(|a, b| a[0] < b[0]), "{name}");
        let (shortest, longest) = (rows[0][0] * 1e-6, rows[rows.len() - 1][0] * 1e-6);
        let slack = 1.0 + 4.0 * f64::EPSILON;
        assert!(optics.range.0 * slack >= shortest && optics.range.1 <= longest * slack, "{name}");
    }
}

#[test]
fn interpolation_passes_its_rows_and_invents_no_extremum() {
    for (name, optics, rows) in tables() {
        for [left, right] in rows.windows(2).map(|pair| [pair[0], pair[1]]) {
            for (k, t) in (0..=20).map(|k| (k, f64::from(k) / 20.0)) {
                let index = optics.dispersion.index((left[0] + t * (right[0] - left[0])) * 1e-6);
                for (y, a, b) in [(index.re, left[1], right[1]), (index.im, left[2], right[2])] {
                    let (low, high) = if k == 0 {
                        (a, a)
                    } else if k == 20 {
                        (b, b)
                    } else {
                        (a.min(b), a.max(b))
                    };
                    let rounding = 1e-13 * a.max(b) + 1e-25;
                    assert!(
                        (low - rounding..=high + rounding).contains(&y),
                        "{name}: {y} at {t} of the way from {left:?} to {right:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn interpolation_has_no_kink_at_a_row() {
    for (name, optics, rows) in tables() {
        for [before, row, after] in rows.windows(3).map(|three| [three[0], three[1], three[2]]) {
            let part = |index: Complex64| [index.re, index.im];
            // Over a thousandth of the shorter side a smooth curve turns by thousandths of its chords; a kink, by their
            // difference, whatever the step.
            let step = 1e-3 * (row[0] - before[0]).min(after[0] - row[0]);
            let [left, here, right] =
                [-step, 0.0, step].map(|offset| part(optics.dispersion.index((row[0] + offset) * 1e-6)));
            for c in 0..2 {
                let chords = [(before, row), (row, after)].map(|(a, b)| ((b[c + 1] - a[c + 1]) / (b[0] - a[0])).abs());
                let turn = ((right[c] - here[c]) - (here[c] - left[c])).abs() / step;
                let rounding = 1e-14 * here[c] / step;
                assert!(turn <= 0.01 * (chords[0] + chords[1]) + rounding, "{name} at {} µm: {turn}", row[0]);
            }
        }
    }
}

#[test]
fn rows_left_out_of_the_titania_table_lie_on_the_interpolant() {
    // The middle one of the three left out between two rows; wavelength [µm], n, κ.
    let left_out = [
        [0.365036527, 2.878735503, 0.017615748],
        [0.382240168, 2.761140053, 0.003225668],
        [0.40957772, 2.64807997, 0.00028862],
        [0.449093039, 2.552983439, 1.48e-5],
        [0.552505141, 2.434019934, 4.81e-8],
        [0.836250371, 2.334716528, 0.0],
    ];
    for [micrometres, n, k] in left_out {
        assert_near(index("tio2", micrometres * 1e-6).re, n, 1e-4, micrometres * 1e-6);
        assert_near(index("tio2", micrometres * 1e-6).im, k, 2e-4, micrometres * 1e-6);
    }
}

#[test]
fn every_material_covers_the_visible() {
    for known in optical() {
        for wavelength in visible() {
            known.index(wavelength).unwrap_or_else(|error| panic!("{error}"));
        }
    }
}

#[test]
fn ends_of_a_range_belong_to_it_however_they_are_rounded() {
    for (name, optics) in indices() {
        let (shortest, longest) = optics.range;
        for end in [shortest, longest] {
            let nanometres = (end * 1e9 * 1e3).round() / 1e3;
            assert!(optics.index(end).is_some() && optics.index(nanometres * 1e-9).is_some(), "{name}");
        }
        for outside in [shortest * 0.999, longest * 1.001].into_iter().filter(|_| name != "vacuum") {
            assert!(optics.index(outside).is_none(), "{name}");
        }
        for nonsense in [f64::NAN, -550e-9] {
            assert!(optics.index(nonsense).is_none(), "{name}");
        }
    }
}

#[test]
fn a_wavelength_out_of_range_is_told_with_the_source() {
    let message = |name, wavelength| named(name).unwrap().index(wavelength).unwrap_err().to_string();
    assert_eq!(
        message("gold", 100.0 * 1e-9),
        "gold at 100 nm: its data (Johnson & Christy 1972, Phys. Rev. B 6, 4370, table I) run from 188 nm to 1937 nm"
    );
    assert_eq!(
        message("chrome", 70e-6),
        "chromium at 70000 nm: its data (Rakić et al. 1998, Appl. Opt. 37, 5271, Lorentz–Drude model, tables 1 and 2) \
         run from 248 nm to 61900 nm"
    );
    assert!(message("bk7", 1.0).starts_with("bk7 at 1e9 nm: "));
    assert!(message("bk7", f64::NAN).starts_with("bk7 at NaN nm: "));
    assert_eq!(
        message("sea-water", 550e-9),
        "sea-water at 550 nm: its refractive index is not known here, only its ε, μ, σ from 0e0 Hz to 1e9 Hz"
    );
}

/// A medium and a wavelength [m] anywhere in its range, spread evenly over the logarithm.
fn anywhere() -> impl Strategy<Value = (&'static Substance, f64)> {
    (0..optical().count(), 0.0..=1.0_f64).prop_map(|(i, t)| {
        let known = optical().nth(i).unwrap();
        let (shortest, longest) = known.optics.as_ref().unwrap().range;
        let (shortest, longest) = (shortest.max(1e-12), longest.min(1e3));
        (known, (shortest.ln() + t * (longest.ln() - shortest.ln())).exp().clamp(shortest, longest))
    })
}

proptest! {
    #[test]
    fn an_index_is_finite_with_n_above_zero_and_absorbs_in_the_metals_alone((known, wavelength) in anywhere()) {
        let index = known.index(wavelength).unwrap();
        prop_assert!(index.is_finite() && index.re > 0.0, "{} at {wavelength}: {index}", known.name);
        match known.name {
            "gold" | "silver" | "copper" | "aluminium" | "chromium" | "silicon" => prop_assert!(index.im > 0.0),
            "tio2" => prop_assert!(index.im >= 0.0),
            _ => prop_assert_eq!(index.im, 0.0),
        }
        prop_assert_eq!(Medium::Named(known).index(wavelength), Ok(index));
    }
}

#[test]
fn two_numbers_tell_glass_between_its_lines() {
    for (index, abbe) in [(1.5168, 64.17), (1.78472, 25.68), (2.4, 3.0), (1.0, 50.0)] {
        let of = |wavelength| cauchy(index, abbe, wavelength);
        assert!((of(D) - index).abs() < 1e-15);
        assert!(((of(F) - of(C)) * abbe - (index - 1.0)).abs() < 1e-14, "{index}, {abbe}");
        assert!(index == 1.0 || of(400e-9) > of(F) && of(C) > of(700e-9));
    }
    // Schott's N-BK7 (data sheet, 2014): n_F 1.52238, n_C 1.51432, and at the g line, 435.8 nm in air, 1.52668. There is a third term.
    assert!((cauchy(1.5168, 64.17, F) - 1.52238).abs() < 1e-4 && (cauchy(1.5168, 64.17, C) - 1.51432).abs() < 1e-4);
    assert!((cauchy(1.5168, 64.17, 435.834_3e-9) - 1.52668).abs() < 1e-3);
}
