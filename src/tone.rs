//! From radiance to what a screen shows: an exposure, a curve, and the screen's own.

use crate::bsdf::Rgb;

/// How radiance beyond a screen's range is brought into it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Curve {
    /// Cut at 1.
    #[default]
    None,
    /// x(1 + x/w²)/(1 + x) of the luminance, white at w = 4 (E. Reinhard et al., *Photographic tone reproduction for digital
    /// images*, ACM TOG 21(3) (2002) 267, eq. 4).
    Reinhard,
    /// Channel by channel, like a film's: a quotient of parabolas near the Academy's ACES (K. Narkowicz, *ACES filmic tone
    /// mapping curve* (2016)).
    Aces,
    /// Channel by channel in primaries drawn inwards, so that bright colours fade to white: T. Sobotka's AgX (2022), its base
    /// sigmoid as a polynomial (B. Wrensch, *Minimal AgX implementation* (2023)).
    Agx,
}

/// Luminance at which [`Curve::Reinhard`] is white.
const WHITE: f64 = 4.0;

impl Curve {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::None, Self::Reinhard, Self::Aces, Self::Agx];

    /// Command-line word.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Reinhard => "reinhard",
            Self::Aces => "aces",
            Self::Agx => "agx",
        }
    }

    /// What a screen is to show, linear, 0 … 1, of linear RGB; what is not a number or below 0 counts as 0.
    pub fn apply(self, colour: Rgb<f64>) -> Rgb<f64> {
        let colour = colour.map(|x| if x > 0.0 { x.min(1e30) } else { 0.0 });
        let shown = match self {
            Self::None => colour,
            Self::Reinhard => {
                let y = luminance(colour);
                let factor = (1.0 + y / (WHITE * WHITE)) / (1.0 + y);
                colour.map(|x| x * factor)
            }
            Self::Aces => colour.map(|x| {
                // Both parabolas over x², so that neither leaves the range.
                let x = x.min(1e6);
                x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)
            }),
            Self::Agx => agx(colour),
        };
        shown.map(|x| x.clamp(0.0, 1.0))
    }
}

/// Y of linear sRGB (ITU-R BT.709).
pub fn luminance([red, green, blue]: Rgb<f64>) -> f64 {
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

fn times(matrix: [[f64; 3]; 3], v: Rgb<f64>) -> Rgb<f64> {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

fn agx(colour: Rgb<f64>) -> Rgb<f64> {
    const INSET: [[f64; 3]; 3] = [
        [0.842_479_062_253_094, 0.078_433_599_999_999_2, 0.079_223_745_147_764_3],
        [0.042_328_242_260_398_4, 0.878_468_636_469_772, 0.079_166_127_460_543_4],
        [0.042_375_654_905_705_1, 0.078_433_600_000_000_4, 0.879_142_973_793_104],
    ];
    const OUTSET: [[f64; 3]; 3] = [
        [1.196_879_005_120_17, -0.098_020_881_140_136_8, -0.099_029_744_079_720_5],
        [-0.052_896_851_757_456_2, 1.151_903_129_904_17, -0.098_961_176_844_843_3],
        [-0.052_971_635_514_443_8, -0.098_043_450_117_124_1, 1.151_073_672_641_16],
    ];
    // Stops of exposure that the sigmoid spans.
    const STOPS: [f64; 2] = [-12.473_93, 4.026_069];
    let logarithms = times(INSET, colour).map(|x| {
        let stop = x.max(1e-10).log2().clamp(STOPS[0], STOPS[1]);
        (stop - STOPS[0]) / (STOPS[1] - STOPS[0])
    });
    let bent = logarithms.map(|x| {
        let coefficients = [-0.002_32, 0.1191, 0.4298, -6.868, 31.96, -40.14, 15.5];
        coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
    });
    // The sigmoid ends in what a screen takes, by a power of 2.2.
    times(OUTSET, bent).map(|x| x.max(0.0).powf(2.2))
}

/// What a screen takes, 0 … 1, to show a linear share 0 … 1 of its light (IEC 61966-2-1, sRGB).
pub fn encoded(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// The linear share of light that a screen shows of what it takes: the inverse of [`encoded`].
pub fn decoded(taken: f64) -> f64 {
    if taken <= 0.040_45 { taken / 12.92 } else { ((taken + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_screen_takes_what_the_standard_says() {
        // IEC 61966-2-1: half the light is taken as 187.5 of 255, and 18 % as 117.6.
        assert!((encoded(0.5) - 0.735_356_983_052_449_5).abs() < 1e-15);
        assert!((encoded(0.18) - 0.461_356_129_500_441_6).abs() < 1e-15);
        for k in 0..=1000 {
            let x = f64::from(k) / 1000.0;
            assert!((decoded(encoded(x)) - x).abs() < 1e-7, "{x}");
        }
    }

    #[test]
    fn curves_rise_from_black_to_white() {
        for curve in Curve::ALL {
            let grey = |x: f64| curve.apply([x; 3]);
            assert!(grey(0.0).iter().all(|x| *x < 1e-4), "{curve:?}");
            assert!(grey(1e9).iter().all(|x| *x > 0.98), "{curve:?} {:?}", grey(1e9));
            let mut before = -1e-9;
            for k in -400..400 {
                let [red, green, blue] = grey(2f64.powf(f64::from(k) / 40.0));
                // Grey stays grey, to the digits of the matrices.
                assert!((red - green).abs() < 2e-3 && (blue - green).abs() < 2e-3, "{curve:?}");
                assert!(green >= before - 1e-12, "{curve:?} falls at 2^{}", f64::from(k) / 40.0);
                before = green;
            }
        }
    }

    #[test]
    fn curves_pass_through_their_papers_points() {
        // Reinhard's eq. 4 at the white it is made for.
        let [shown, ..] = Curve::Reinhard.apply([WHITE; 3]);
        assert!((shown - 1.0).abs() < 1e-12);
        // Narkowicz's quotient at 1: 2.54/3.16.
        let [shown, ..] = Curve::Aces.apply([1.0; 3]);
        assert!((shown - 2.54 / 3.16).abs() < 1e-12);
        // AgX's sigmoid turns at middle grey: 18 % is half of what a screen takes, within the polynomial's 4e-3.
        let [_, shown, _] = Curve::Agx.apply([0.18; 3]);
        assert!((shown.powf(1.0 / 2.2) - 0.5).abs() < 4e-3, "{shown}");
    }

    proptest! {
        #[test]
        fn whatever_comes_in_a_screen_can_show(bits in any::<[u64; 3]>()) {
            for curve in Curve::ALL {
                let shown = curve.apply(bits.map(f64::from_bits));
                prop_assert!(shown.iter().all(|x| (0.0..=1.0).contains(x)), "{curve:?}: {shown:?}");
            }
        }
    }
}
