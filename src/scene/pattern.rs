//! Reflectances that change from place to place.

use super::triple::{plus, times};
use super::{Image, Triple};
use std::path::PathBuf;
use std::sync::Arc;

/// ρ [1] by the place (s, t) [1] on an image from its lower left corner, repeated without end.
#[derive(Clone, Debug, PartialEq)]
pub enum Pattern {
    /// Between the middles of an image's texels as they are mixed by what is nearest to them, along rows and along columns.
    Image {
        /// Where it was read from, as a scene file names it; None if it was made.
        file: Option<PathBuf>,
        /// ρ [1], 0 … 1.
        image: Arc<Image>,
    },
    /// Squares of two colours in turn.
    Checker {
        /// ρ [1], 0 … 1, of the square in the lower left corner, and of those beside it.
        colours: [Triple; 2],
        /// Squares along each side of the image.
        scale: f64,
    },
}

impl Pattern {
    /// ρ [1] of a place.
    pub fn at(&self, [s, t]: [f64; 2]) -> Triple {
        match self {
            Self::Checker { colours, scale } => {
                let odd = |x: f64| (x * scale).floor().rem_euclid(2.0) == 1.0;
                colours[usize::from(odd(s) != odd(t))]
            }
            Self::Image { image, .. } => {
                let [width, height] = image.size();
                let between = |share: f64, count: u32| {
                    let place = (share - share.floor()) * f64::from(count) - 0.5;
                    let before = place.floor();
                    let wrapped = |at: f64| at.rem_euclid(f64::from(count)) as u32 % count;
                    ([wrapped(before), wrapped(before + 1.0)], place - before)
                };
                let (columns, right) = between(s, width);
                // Rows are counted from the top.
                let (rows, down) = between(1.0 - t, height);
                let along = |row: u32| mixed(columns.map(|column| image.at([column, row])), right);
                mixed(rows.map(along), down)
            }
        }
    }

    /// The mean of ρ [1].
    pub fn mean(&self) -> Triple {
        match self {
            Self::Checker { colours: [one, other], .. } => times(plus(*one, *other), 0.5),
            Self::Image { image, .. } => {
                let sum = image.texels().iter().fold([0.0; 3], |sum, texel| plus(sum, texel.map(f64::from)));
                times(sum, 1.0 / image.texels().len() as f64).map(|rho| rho.min(1.0))
            }
        }
    }
}

/// The one with the share 1 − `part`, the other with `part`.
fn mixed([one, other]: [Triple; 2], part: f64) -> Triple {
    // No part of a number that is not there: 0 to 1 stay within 0 to 1.
    plus(times(one, 1.0 - part), times(other, part)).map(|rho| rho.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_texel_lies_where_it_was_drawn() {
        // Two rows of three, the upper one first.
        let texels = (0..6).map(|k| [k as f32 / 8.0; 3]).collect();
        let image = Arc::new(Image::new([3, 2], texels).expect("six"));
        let pattern = Pattern::Image { file: None, image };
        let at = |s: f64, t: f64| pattern.at([s, t])[0] * 8.0;
        for (k, (column, row)) in [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)].into_iter().enumerate() {
            let (s, t) = ((f64::from(column) + 0.5) / 3.0, 1.0 - (f64::from(row) + 0.5) / 2.0);
            for [left, below] in [[0.0, 0.0], [1.0, -3.0], [-2.0, 7.0]] {
                assert!((at(s + left, t + below) - k as f64).abs() < 1e-12, "{column}, {row}");
            }
        }
        // Half way between two neighbours, and between the last and the first.
        assert!((at(1.0 / 3.0, 0.75) - 0.5).abs() < 1e-12 && (at(0.0, 0.25) - 4.0).abs() < 1e-12);
        assert!((at(0.5, 0.5) - 2.5).abs() < 1e-12 && (pattern.mean()[0] * 8.0 - 2.5).abs() < 1e-12);
    }

    #[test]
    fn squares_take_turns() {
        let pattern = Pattern::Checker { colours: [[0.0; 3], [1.0; 3]], scale: 8.0 };
        let at = |column: f64, row: f64| pattern.at([(column + 0.5) / 8.0, (row + 0.5) / 8.0])[0];
        for column in -9..9 {
            for row in -9..9 {
                let expected = f64::from((i32::abs(column + row)) % 2);
                assert_eq!(at(column.into(), row.into()), expected, "{column}, {row}");
            }
        }
        assert_eq!(pattern.mean(), [0.5; 3]);
    }

    #[test]
    fn no_place_is_none() {
        let image = Arc::new(Image::new([1, 1], vec![[1.0, 0.5, 0.0]]).expect("one"));
        let patterns =
            [Pattern::Image { file: None, image }, Pattern::Checker { colours: [[0.5; 3], [1.0; 3]], scale: 1e15 }];
        for pattern in patterns {
            for place in [[f64::NAN; 2], [f64::INFINITY, -1e300], [-0.0, 1.0], [1e15, 0.3]] {
                let rho = pattern.at(place);
                // What is no place may have no colour, but nothing is out of range or breaks.
                assert!(rho.iter().all(|rho| rho.is_nan() || (0.0..=1.0).contains(rho)), "{place:?}: {rho:?}");
            }
        }
    }
}
