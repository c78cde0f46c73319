use super::response::{BAND, response};
use super::*;

fn near(found: &[f64], expected: &[f64], within: f64) {
    let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= within, "{found:?} against {expected:?}");
}

#[test]
fn the_tables_are_those_of_the_cie() {
    // Colorimetry's own sums of every nanometre (CIE 15:2004, table T.4): 106.865, 106.857 and 106.892 [nm].
    near(&tristimulus(|_| 1.0).map(|x| x * 1e9), &[106.865, 106.857, 106.892], 2e-3);
    near(&chromaticity(tristimulus(|_| 1.0)), &[1.0 / 3.0; 2], 5e-5);
    assert_eq!(matching(555e-9)[1], 1.0);
    // D65 itself: x 0.31272, y 0.32903 (CIE 15:2004, table T.3), of a table that goes on to 830 nm: beyond 780 are 2e-5 of X and Y.
    near(&chromaticity(tristimulus(daylight)), &[0.31272, 0.32903], 3e-5);
    near(&[daylight(560e-9)], &[100.0], 1e-12);
    assert_eq!((matching(359e-9), matching(831e-9), daylight(790e-9)), ([0.0; 3], [0.0; 3], 0.0));
}

#[test]
fn the_matrix_is_the_one_that_the_standard_prints() {
    let printed = [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];
    for (found, printed) in srgb().iter().zip(&printed) {
        near(found, printed, 6e-4);
    }
    let [x, y] = WHITE;
    near(&linear_srgb([x / y, 1.0, (1.0 - x - y) / y]), &[1.0; 3], 1e-14);
}

#[test]
fn what_glows_has_the_published_colours() {
    // CIE 15:2004, table T.3. Illuminant A is defined by T = 2848 K and c₂ = 1.4350e−2 m K, which is today's c₂ at 2855.5 K.
    near(&chromaticity(tristimulus(|l| blackbody(l, 2855.54))), &[0.44758, 0.40745], 2e-5);
    // The locus in u = 4X/(X + 15Y + 3Z), v = 6Y/(…), printed to five digits: A. R. Robertson, J. Opt. Soc. Am. 58 (1968) 1528; Wyszecki and
    // Stiles, *Color Science* (2nd ed.), table 1(3.11).
    let printed = [
        (10.0, [0.18066, 0.26589]),
        (50.0, [0.18388, 0.27709]),
        (100.0, [0.19032, 0.29326]),
        (150.0, [0.19962, 0.30921]),
        (250.0, [0.22511, 0.33439]),
        (400.0, [0.27218, 0.35407]),
        (600.0, [0.33724, 0.36051]),
    ];
    for (mired, printed) in printed {
        let [x, y, z] = tristimulus(|l| blackbody(l, 1e6 / mired));
        let whole = x + 15.0 * y + 3.0 * z;
        near(&[4.0 * x / whole, 6.0 * y / whole], &printed, 8e-6);
    }
    // The candela of 1948: a black body as hot as freezing platinum, 2042 K, has 60 cd/cm². The one of 1979 was rounded to agree
    // within a hundredth.
    let luminance = EFFICACY * tristimulus(|l| blackbody(l, 2042.0))[1];
    assert!((luminance / 6e5 - 1.0).abs() < 0.01, "{luminance}");
    // Stefan and Boltzmann: π∫L dλ = σT⁴, σ = 5.670374419e−8, by the midpoint rule in ln λ.
    let steps = 4000;
    let integral: f64 = (0..steps)
        .map(|k| (1e-7f64.ln() + (f64::from(k) + 0.5) * (1e-2f64 / 1e-7).ln() / f64::from(steps)).exp())
        .map(|l| l * blackbody(l, 3000.0) * (1e-2f64 / 1e-7).ln() / f64::from(steps))
        .sum();
    let law = 5.670_374_419e-8 * 3000f64.powi(4);
    assert!((std::f64::consts::PI * integral / law - 1.0).abs() < 1e-6, "{integral}");
}

#[test]
fn a_channel_sees_white_as_one() {
    near(&response().mean(|_| 1.0), &[1.0; 3], 1e-14);
    // Each has parts below 0, and red most: between blue and green no screen reaches the light of one wavelength.
    for c in 0..3 {
        let least = (380..=760).map(|nm| response().at(f64::from(nm) * 1e-9)[c]).fold(f64::INFINITY, f64::min);
        assert!(least < -1e5, "{c}: {least}");
    }
    assert!(response().at(500e-9)[0] < -1e6);
    assert_eq!((response().at(379.9e-9), response().at(760.1e-9)), ([0.0; 3], [0.0; 3]));
}

#[test]
fn wavelengths_are_drawn_so_that_means_are_right() {
    // ∫r_c f dλ is the mean of f and the weight over even numbers, by the midpoint rule; the weight, below 8, leaps at 75 nodes, each of
    // which may lie anywhere between two points.
    let count: u32 = 1 << 20;
    let within = 0.5 * 75.0 * 8.0 / f64::from(count);
    let of = |f: &dyn Fn(f64) -> f64| {
        let drawn = (0..count).map(|k| response().draw((f64::from(k) + 0.5) / f64::from(count)));
        drawn.fold([0.0; 3], |sum: [f64; 3], one| {
            let value = f(one.wavelength) / f64::from(count);
            std::array::from_fn(|c| sum[c] + one.weight[c] * value)
        })
    };
    near(&of(&|_| 1.0), &[1.0; 3], within);
    let smooth = |l: f64| (l * 3e7).sin();
    near(&of(&smooth), &response().mean(smooth), within + 1e-5);
    for u in [0.0, 1e-9, 0.5, 1.0 - f64::EPSILON] {
        let drawn = response().draw(u);
        assert!(drawn.wavelength >= BAND[0] && drawn.wavelength <= BAND[1] * (1.0 + 1e-15), "{u}: {drawn:?}");
        assert!(drawn.weight.iter().all(|w| w.abs() < 8.0), "{u}: {drawn:?}");
    }
}
