//! How wrong a picture is, told from its own two halves.
//!
//! The halves A and B of a pixel know nothing of each other ([`crate::sampling`]), whatever the points within each, so that
//! ⟨(A − B)²⟩/4 is the variance of their mean (A + B)/2. Independent samples would say as much by their spread; those of a net
//! would say too much by it, since they make up for each other.
//!
//! A relative error is that over truth² + [`DARK`], and the truth is not known. With d = m² + [`DARK`] of the pixel's own mean
//! m in its place, a bright sample that few pixels meet divides itself away: of light that λ samples of a pixel meet on
//! average, λ < 1, the error is 1/λ, and a pixel that meets it says 1. What stands in the place of truth² + [`DARK`] is
//! therefore, as far as the halves do not agree, what the eight pixels around say, since they know nothing of the own noise:
//! see [`pixel_errors`].
//!
//! Told over true, means over seeds, from own means alone and as it is told, of pictures of 256 × 256 pixels, by spp:
//!
//! | scene | 4 | 8 | 16 | 64 |
//! |---|---|---|---|---|
//! | cornell | 0.65, 0.98 | 0.79, 1.01 | 0.92, 1.05 | 0.98, 1.01 |
//! | glass | 0.62, 0.98 | 0.74, 1.03 | 0.87, 1.08 | 0.91, 0.98 |
//! | veach | 0.54, 1.02 | 0.65, 0.98 | 0.77, 0.96 | 0.88, 0.94 |
//! | metals | 0.32, 0.88 | 0.38, 0.96 | 0.50, 0.99 | 0.77, 0.96 |
//! | mesh | 1.01, 1.03 | 1.02, 1.03 | 1.00, 1.00 | 1.01, 1.00 |
//!
//! Of 64 × 64 pixels, more of which are at edges of lamps, it is 0.75 to 1.1 from four samples on; 1.0 to 1.5 in veach, whose
//! smallest lamps are then smaller than a pixel.

use super::film::Halves;
use crate::bsdf::Rgb;
use crate::threads::mapped;

/// What keeps the relative error of black finite: the square of a tenth of white [W² m⁻⁴ sr⁻²].
pub const DARK: f64 = 0.01;

/// What is known of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// The relative mean square error [1]: the mean over pixels and channels of (x − truth)²/(truth² + [`DARK`]).
    pub relative_mse: f64,
    /// The standard error [1] of that, by how pixels differ.
    pub deviation: f64,
    /// The picture's mean [W m⁻² sr⁻¹].
    pub mean: Rgb<f64>,
    /// Pixels that are not numbers: left out of everything here.
    pub broken: usize,
}

impl Estimate {
    /// Of the means of the halves of every pixel, row by row of so many pixels.
    ///
    /// # Panics
    /// If the rows are not whole.
    pub fn of(halves: &[Halves], width: u32) -> Self {
        let (mut sum, mut squares, mut mean, mut count) = (0.0, 0.0, [0.0; 3], 0_usize);
        for (pixel, error) in halves.iter().zip(pixel_errors(halves, width)) {
            if !error.is_finite() {
                continue;
            }
            count += 1;
            sum += error;
            squares += error * error;
            let colour = colour(pixel);
            mean = std::array::from_fn(|c| mean[c] + colour[c]);
        }
        let n = count.max(1) as f64;
        let variance = (squares / n - (sum / n) * (sum / n)).max(0.0);
        Self {
            relative_mse: sum / n,
            deviation: (variance / n).sqrt(),
            mean: mean.map(|sum| sum / n),
            broken: halves.len() - count,
        }
    }

    /// The relative error [1], as a root of a mean square.
    pub fn relative_error(&self) -> f64 {
        self.relative_mse.sqrt()
    }
}

/// The mean of the halves of a pixel [W m⁻² sr⁻¹].
pub fn colour(halves: &Halves) -> Rgb<f64> {
    std::array::from_fn(|c| 0.5 * (f64::from(halves[0][c]) + f64::from(halves[1][c])))
}

/// The variance [W² m⁻⁴ sr⁻²] of that mean, by one degree of freedom.
pub fn variance(halves: &Halves) -> Rgb<f64> {
    std::array::from_fn(|c| 0.25 * (f64::from(halves[0][c]) - f64::from(halves[1][c])).powi(2))
}

/// The relative square error [1] of every pixel, row by row, the mean of its channels; not finite where the pixel is not.
///
/// Of a channel with d = m² + [`DARK`], the variance v and r = v/d, it is made up of two, by how likely each is. The
/// logarithms of the neighbours' d have a mean and a variance s²; that of the own d is off by about 4r, squared.
///
/// - With the weight 4r/(4r + s²) the pixel is like its neighbours: v over what they have on average. Of nine pixels alike of
///   which only one met a light, the light is taken for that of two (Laplace's rule of succession): no less than 2/9 of the
///   own m.
/// - Else it is at an edge, and its own: r. If but one sample has met what is seen of a lamp there (r is 1), then λ may be
///   anything from next to nothing on, and the mean of 1/λ² over what it may be is about 1 + ln(m/m₀), where m₀ is what the
///   pixel has without the lamp: as much as the darkest neighbour.
///
/// # Panics
/// If the rows are not whole.
pub fn pixel_errors(halves: &[Halves], width: u32) -> Vec<f64> {
    let width = (width as usize).max(1);
    assert!(halves.len().is_multiple_of(width), "rows that are whole");
    // A pixel that is not whole is no neighbour in any channel.
    let logarithms = halves.iter().map(|pixel| {
        let mean = colour(pixel);
        let is_whole = mean.iter().all(|x| x.is_finite());
        mean.map(|mean| if is_whole { (mean * mean + DARK).ln() } else { f64::NAN })
    });
    let logarithms: Vec<Rgb<f64>> = logarithms.collect();
    let height = halves.len() / width;
    let rows: Vec<usize> = (0..height).collect();
    let of = |row: &usize| -> Vec<f64> {
        let near = |at: usize, end: usize| at.saturating_sub(1)..(at + 2).min(end);
        let error = |column: usize| {
            let own = row * width + column;
            let variance = variance(&halves[own]);
            let error = |c: usize| {
                let around = near(*row, height).flat_map(|y| near(column, width).map(move |x| y * width + x));
                let around = around.filter(|at| *at != own).map(|at| logarithms[at][c]);
                channel_error(logarithms[own][c], variance[c], around.filter(|x| x.is_finite()))
            };
            (0..3).map(error).sum::<f64>() / 3.0
        };
        (0..width).map(error).collect()
    };
    mapped(&rows, of).concat()
}

/// That of a channel whose d and whose neighbours' d have these logarithms.
fn channel_error(own: f64, variance: f64, around: impl Iterator<Item = f64>) -> f64 {
    let (mut count, mut sum, mut squares, mut least) = (0.0, 0.0, 0.0, own);
    for other in around {
        // From the own one on, lest digits cancel.
        (count, sum, squares) = (count + 1.0, sum + (other - own), squares + (other - own).powi(2));
        least = other.min(least);
    }
    let r = variance / own.exp();
    // Without two neighbours nothing says that the pixel is like them.
    if count < 2.0 || r == 0.0 {
        return r;
    }
    let spread = ((squares - sum * sum / count) / (count - 1.0)).max(0.0);
    let alike = 4.0 * r / (4.0 * r + spread);
    let stray = r / (sum / count).exp().max((2.0 / (count + 1.0)).powi(2));
    let edge = r * (1.0 + r * 0.5 * (own - least));
    alike * stray + (1.0 - alike) * edge
}

/// The relative mean square error [1] of a picture against the truth, pixel by pixel.
///
/// # Panics
/// If they are not of one size.
pub fn relative_mse(picture: &[Rgb<f64>], truth: &[Rgb<f64>]) -> f64 {
    assert_eq!(picture.len(), truth.len(), "a truth a pixel");
    let error = |(x, truth): (&Rgb<f64>, &Rgb<f64>)| -> f64 {
        (0..3).map(|c| (x[c] - truth[c]).powi(2) / (truth[c] * truth[c] + DARK)).sum()
    };
    picture.iter().zip(truth).map(error).sum::<f64>() / (3 * picture.len().max(1)) as f64
}

/// The relative mean square error [1] of a picture against one that is itself known by its halves only, and the standard error
/// of that, by how pixels differ. What the reference's halves tell of its own noise is taken off, so that on average the error
/// is that against the truth; by chance it may be below zero where the reference is not the better of the two. Pixels that
/// are not numbers in either are left out.
///
/// # Panics
/// If they are not of one size.
pub fn relative_mse_less(picture: &[Rgb<f64>], reference: &[Halves]) -> (f64, f64) {
    assert_eq!(picture.len(), reference.len(), "a reference a pixel");
    let errors = picture.iter().zip(reference).map(|(x, halves)| {
        let (truth, noise) = (colour(halves), variance(halves));
        (0..3).map(|c| ((x[c] - truth[c]).powi(2) - noise[c]) / (truth[c] * truth[c] + DARK)).sum::<f64>() / 3.0
    });
    let (mut sum, mut squares, mut count) = (0.0, 0.0, 0_usize);
    for error in errors.filter(|error| error.is_finite()) {
        (sum, squares, count) = (sum + error, squares + error * error, count + 1);
    }
    let n = count.max(1) as f64;
    let spread = (squares / n - (sum / n) * (sum / n)).max(0.0);
    (sum / n, (spread / n).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use yardstick::random::{stream, uniform};

    /// Pixels of a mean and a standard deviation of their halves.
    fn pixels(count: usize, mean: f64, deviation: f64) -> Vec<Halves> {
        let mut stream = stream(1, "estimate/pixels");
        let reach = deviation * 3f64.sqrt();
        let mut half = || std::array::from_fn(|_| uniform(&mut stream, mean - reach, mean + reach) as f32);
        (0..count).map(|_| [half(), half()]).collect()
    }

    #[test]
    fn the_error_is_that_of_the_mean_of_both_halves() {
        // Of halves of variance s² the mean has s²/2.
        let (mean, deviation) = (2.0, 0.01);
        let found = Estimate::of(&pixels(20_000, mean, deviation), 200);
        let expected = deviation * deviation / 2.0 / (mean * mean + DARK);
        assert!((found.relative_mse - expected).abs() < 5.0 * found.deviation, "{found:?}, expected {expected}");
        // 60 000 numbers whose squares differ by less than twice their size.
        assert!(found.deviation < 0.02 * expected && found.broken == 0);
        assert!(found.mean.iter().all(|x| (x - mean).abs() < 5.0 * deviation / 200.0));
        let truth = vec![[mean; 3]; 20_000];
        let picture: Vec<_> = pixels(20_000, mean, deviation).iter().map(colour).collect();
        assert!((relative_mse(&picture, &truth) / expected - 1.0).abs() < 0.05);
    }

    #[test]
    fn at_the_edge_of_a_lamp_a_single_sample_is_thought_to_be_rarer_than_it_says() {
        // Dark to the left, the lamp to the right, and between them a pixel of which one half has met it: by itself it says 1.
        let grey = |a: f32, b: f32| [[a; 3], [b; 3]];
        let row = |middle: Halves| [grey(0.0, 0.0), middle, grey(100.0, 100.0)];
        let rows = |own: Halves| [row(grey(0.0, 100.0)), row(own), row(grey(100.0, 0.0))].concat();
        let error = |own: Halves| pixel_errors(&rows(own), 3)[4];
        // 1 + ln(m/m₀) with m = 10 over the tenth of white that stands for black is 5.6.
        assert!((4.0..12.0).contains(&error(grey(20.0, 0.0))), "{}", error(grey(20.0, 0.0)));
        // One whose halves agree knows better than its neighbours.
        assert_eq!(error(grey(10.0, 10.0)), 0.0);
        let off = error(grey(10.1, 9.9));
        assert!((off / 1e-4 - 1.0).abs() < 0.1, "{off}");
    }

    #[test]
    fn the_noise_of_a_reference_is_not_taken_for_an_error() {
        let (mean, bias) = (2.0, 0.01);
        // The reference is as noisy as the picture is wrong: halves of variance 2·bias².
        let reference = pixels(20_000, mean, bias * 2f64.sqrt());
        let picture = vec![[mean + bias; 3]; 20_000];
        let expected = bias * bias / (mean * mean + DARK);
        let (found, deviation) = relative_mse_less(&picture, &reference);
        assert!((found - expected).abs() < 5.0 * deviation && deviation < 0.03 * expected, "{found} ± {deviation}");
        let naive = relative_mse(&picture, &reference.iter().map(colour).collect::<Vec<_>>());
        assert!((naive / expected - 2.0).abs() < 0.1, "{naive}");
        // The truth itself is off by nothing, on average.
        let (nothing, deviation) = relative_mse_less(&vec![[mean; 3]; 20_000], &reference);
        assert!(nothing.abs() < 5.0 * deviation, "{nothing} ± {deviation}");
        // One without a number changes nothing.
        let (mut more, mut broken) = (picture, reference);
        more.push([f64::NAN, 1.0, 1.0]);
        broken.push([[1.0; 3]; 2]);
        assert_eq!(relative_mse_less(&more, &broken).0, found);
        assert_eq!(relative_mse_less(&[], &[]), (0.0, 0.0));
    }

    #[test]
    fn a_pixel_that_is_no_number_is_counted_and_left_out() {
        let mut halves = pixels(100, 1.0, 0.1);
        let without = Estimate::of(&halves[1..], 99);
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            halves[0][1][2] = bad;
            assert_eq!(Estimate::of(&halves, 100), Estimate { broken: 1, ..without });
        }
        assert_eq!(Estimate::of(&[], 0), Estimate::default());
    }
}
