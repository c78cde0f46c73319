//! How wrong a picture is, pixel by pixel, in false colours.

use super::pictures::{About, Picture};
use chapters::figure::{Axis, Map, Plot, Ramp};
use light::transport::estimate::{Estimate, pixel_errors};

/// Cells along the longer side at most: a sheet shows no more.
const CELLS: u32 = 512;
/// Decades of the colours.
const DECADES: f64 = 2.0;

/// The map of a picture. A cell is a pixel, or of large pictures a square of them.
pub fn plot(picture: &Picture) -> Plot {
    let found = Estimate::of(picture.halves, picture.width);
    let errors = pixel_errors(picture.halves, picture.width);
    let side = picture.width.max(picture.height).div_ceil(CELLS);
    let (columns, rows) = (picture.width.div_ceil(side), picture.height.div_ceil(side));
    let cells: Vec<f64> = (0..rows)
        .flat_map(|row| (0..columns).map(move |column| [column, row]))
        .map(|at| cell(&errors, [picture.width, picture.height], side, at))
        .collect();
    let mut ranked: Vec<f64> = cells.iter().copied().filter(|error| error.is_finite()).collect();
    ranked.sort_by(f64::total_cmp);
    // Up to the worst but one in a hundred, which may be one stray path; those above have the last colour.
    let most = ranked.get(ranked.len() * 99 / 100).copied().filter(|most| *most > 0.0).unwrap_or(1.0);
    let what = match side {
        1 => "relative error of a pixel".to_owned(),
        _ => format!("relative error, rms of {side} × {side} pixels"),
    };
    let map = Map {
        title: String::new(),
        x: Axis::bare(0.0, f64::from(columns)),
        y: Axis::bare(0.0, f64::from(rows)),
        colour: Axis::log(what, "").range(most / 10f64.powf(DECADES), most),
        ramp: Ramp::Sequential,
        columns: columns as usize,
        // A map begins at the bottom, a picture at the top.
        values: cells.chunks(columns as usize).rev().flatten().copied().collect(),
        marks: Vec::new(),
    };
    let whole = format!("{:.2} %", 100.0 * found.relative_error());
    let About { scene, spp, .. } = picture.about;
    Plot::of(format!("{scene}, {spp} spp: relative error {whole}"), map)
}

/// The root mean square [1] of the relative errors of a square of pixels; not a number if one of them is none.
fn cell(errors: &[f64], [width, height]: [u32; 2], side: u32, [column, row]: [u32; 2]) -> f64 {
    let of = |start: u32, end: u32| start * side..((start + 1) * side).min(end);
    let (mut sum, mut count) = (0.0, 0.0);
    for y in of(row, height) {
        for x in of(column, width) {
            sum += errors[y as usize * width as usize + x as usize];
            count += 1.0;
        }
    }
    let mean: f64 = sum / count;
    if mean.is_finite() { mean.sqrt() } else { f64::NAN }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chapters::figure::Panel;
    use light::transport::film::Halves;

    fn map(width: u32, height: u32, halves: &[Halves]) -> Map {
        let about = About { scene: "a".to_owned(), spp: 2, ..About::default() };
        match plot(&Picture { width, height, halves, features: None, about: &about }).panels.remove(0) {
            Panel::Map(map) => map,
            other => panic!("{other:?}"),
        }
    }

    /// Halves of a relative error: (A − B)²/4 over m² + 0.01 with m² = 0.99.
    fn of_error(error: f64) -> Halves {
        let (mean, off) = (0.99f64.sqrt(), error);
        [[(mean - off) as f32; 3], [(mean + off) as f32; 3]]
    }

    #[test]
    fn errors_stand_where_their_pixels_are_and_broken_ones_are_marked() {
        let mut halves = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6].map(of_error);
        halves[5][0][1] = f32::NAN;
        let map = map(2, 3, &halves);
        // From the bottom row on.
        let expected = [0.5, f64::NAN, 0.3, 0.4, 0.1, 0.2];
        for (found, expected) in map.values.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-6 || (found.is_nan() && expected.is_nan()), "{:?}", map.values);
        }
        assert_eq!((map.columns, map.ramp), (2, Ramp::Sequential));
        let (low, high) = map.colour.range.unwrap();
        assert!((high / low).log10() - DECADES < 1e-9 && (high - 0.5).abs() < 1e-6, "{low} to {high}");
    }

    #[test]
    fn a_large_picture_is_shown_by_squares() {
        // Of every four pixels one is wrong: by 0.2, root mean square 0.1.
        let side = 2 * CELLS as usize;
        let halves: Vec<_> = (0..3 * side)
            .map(|at| of_error(if at % 2 == 0 && (at / side).is_multiple_of(2) { 0.2 } else { 0.0 }))
            .collect();
        let map = map(side as u32, 3, &halves);
        assert_eq!((map.columns, map.values.len()), (CELLS as usize, 2 * CELLS as usize));
        // The last row of squares is half as high: one pixel of two.
        let (below, above) = map.values.split_at(CELLS as usize);
        assert!(above.iter().all(|error| (error - 0.1).abs() < 1e-6));
        assert!(below.iter().all(|error| (error - 0.2 / 2f64.sqrt()).abs() < 1e-6));
    }

    #[test]
    fn a_picture_without_error_has_a_scale_all_the_same() {
        let map = map(1, 1, &[[[1.0; 3]; 2]]);
        assert_eq!(map.values, [0.0]);
        assert_eq!(map.colour.range, Some((1.0 / 10f64.powf(DECADES), 1.0)));
    }
}
