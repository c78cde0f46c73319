//! Pictures that a scene is made with: of what is behind everything.

use super::Triple;
use super::triple::times;
use crate::number::{atan2, sin_cos_turns};
use std::f64::consts::{PI, TAU};
use std::path::PathBuf;
use std::sync::Arc;

/// Texels of linear RGB in rows and columns. Each has one colour all over.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    size: [u32; 2],
    texels: Vec<[f32; 3]>,
}

impl Image {
    /// The most texels: 8192 × 4096, with what a sky needs besides a gigabyte.
    pub const MOST: u64 = 1 << 25;

    /// Of so many columns and rows, row by row from the top, each from the left; None if that many texels there are not, or
    /// none at all.
    pub fn new(size: [u32; 2], texels: Vec<[f32; 3]>) -> Option<Self> {
        let count = u64::from(size[0]) * u64::from(size[1]);
        (count > 0 && count == texels.len() as u64).then_some(Self { size, texels })
    }

    /// Columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// All texels, row by row from the top.
    pub fn texels(&self) -> &[[f32; 3]] {
        &self.texels
    }

    /// The texel of a column and a row.
    ///
    /// # Panics
    /// If there is none.
    pub fn at(&self, [column, row]: [u32; 2]) -> Triple {
        self.texels[row as usize * self.size[0] as usize + column as usize].map(f64::from)
    }
}

/// What is behind all shapes.
#[derive(Clone, Debug, PartialEq)]
pub enum Environment {
    /// The same radiance [W m⁻² sr⁻¹] from everywhere.
    Constant(Triple),
    /// That of an image.
    Image(Sky),
}

impl Environment {
    /// Whether no light comes from it.
    pub fn is_black(&self) -> bool {
        match self {
            Self::Constant(radiance) => *radiance == [0.0; 3],
            Self::Image(sky) => sky.scale == 0.0 || sky.image.texels.iter().all(|texel| *texel == [0.0; 3]),
        }
    }
}

/// An image all around: rows by latitude, columns by longitude, as OpenEXR has it (`ENVMAP_LATLONG` in `ImfEnvmap.h`): the top
/// looks to +y, the middle to +z, a quarter of the width left of it to +x, so that whoever stands inside sees it unmirrored. Texels
/// here are areas, π/height high and 2π/width wide, each of one radiance.
#[derive(Clone, Debug, PartialEq)]
pub struct Sky {
    /// Where it was read from, as a scene file names it; None if it was made.
    pub file: Option<PathBuf>,
    /// Radiance [W m⁻² sr⁻¹] over [`Sky::scale`].
    pub image: Arc<Image>,
    /// [1].
    pub scale: f64,
    /// A turn [deg] about y, from z towards x.
    pub rotate_deg: f64,
}

impl Sky {
    /// The turn as a share [1] of a whole one, 0 ≤ t < 1.
    fn turn(&self) -> f64 {
        let turn = (self.rotate_deg / 360.0).rem_euclid(1.0);
        if turn < 1.0 { turn } else { 0.0 }
    }

    /// The direction, of length 1, whose longitude is that of a place `u` [1] from the image's left edge, 0 ≤ u ≤ 1, and whose
    /// height is `y` = cos θ [1].
    pub fn direction(&self, u: f64, y: f64) -> Triple {
        let turns = 0.5 - u + self.turn();
        let (sin, cos) = sin_cos_turns(turns - turns.round());
        // No difference of squares: near the poles it would have no digits.
        let aside = ((1.0 - y) * (1.0 + y)).max(0.0).sqrt();
        [aside * sin, y, aside * cos]
    }

    /// Column and row of the texel that a direction of any length but 0 looks at.
    pub fn texel(&self, [x, y, z]: Triple) -> [u32; 2] {
        let [width, height] = self.image.size;
        let from_up = angle((x * x + z * z).sqrt(), y) / PI;
        let across = 0.5 + self.turn() - angle(x, z) / TAU;
        let place = |share: f64, count: u32| ((share * f64::from(count)) as u32).min(count - 1);
        [place(across - across.floor(), width), place(from_up, height)]
    }

    /// Radiance [W m⁻² sr⁻¹] of a texel.
    pub fn radiance(&self, texel: [u32; 2]) -> Triple {
        times(self.image.at(texel), self.scale)
    }
}

/// cos θ [1] at a row's upper edge, of so many rows; that of one row more at the last one's lower edge.
pub fn edge(row: u32, rows: u32) -> f64 {
    sin_cos_turns(0.5 * f64::from(row) / f64::from(rows)).1
}

/// The angle [rad] of (along, aside) from the first axis towards the second, −π … π; 0 of nothing.
fn angle(aside: f64, along: f64) -> f64 {
    if aside == 0.0 && along == 0.0 {
        return 0.0;
    }
    let acute = atan2(aside.abs(), along.abs());
    let angle = if along < 0.0 { PI - acute } else { acute };
    if aside < 0.0 { -angle } else { angle }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sky(size: [u32; 2], rotate_deg: f64) -> Sky {
        let texels = (0..size[0] * size[1]).map(|k| [k as f32; 3]).collect();
        let image = Arc::new(Image::new(size, texels).expect("as many"));
        Sky { file: None, image, scale: 2.0, rotate_deg }
    }

    #[test]
    fn every_texel_lies_where_openexr_puts_it() {
        // Middles of eight columns and of three rows.
        let at = |direction: Triple| sky([8, 3], 0.0).texel(direction);
        assert_eq!([at([0.1, 9.0, -0.1]), at([0.0, -1.0, 0.0])].map(|[_, row]| row), [0, 2]);
        // The middle is an edge between columns: to its left it is +z with a little of +x.
        assert_eq!([at([0.1, 0.0, 1.0]), at([-0.1, 0.0, 1.0])], [[3, 1], [4, 1]]);
        assert_eq!([at([1.0, 0.2, 0.1]), at([-1.0, -0.2, 0.1])], [[2, 1], [5, 1]]);
        assert_eq!([at([0.1, 0.0, -1.0]), at([-0.1, 0.0, -1.0])], [[0, 1], [7, 1]]);
        // Turned by a quarter about y, z goes to x: what was straight ahead is at +x.
        let turned = |direction: Triple| sky([8, 3], 90.0).texel(direction);
        assert_eq!([turned([1.0, 0.0, -0.1]), turned([1.0, 0.0, 0.1])], [[3, 1], [4, 1]]);
        assert_eq!(sky([8, 3], -270.0 + 720.0).texel([1.0, 0.0, -0.1]), [3, 1]);
        assert_eq!(sky([8, 3], 0.0).radiance([3, 1]), [22.0; 3]);
    }

    #[test]
    fn a_texel_looks_where_its_directions_go() {
        for (size, rotate_deg) in [([1, 1], 0.0), ([7, 5], 12.5), ([64, 32], -77.0), ([3, 400], 359.999_999)] {
            let sky = sky(size, rotate_deg);
            for row in 0..size[1] {
                let [above, below] = [row, row + 1].map(|row| edge(row, size[1]));
                for column in 0..size[0] {
                    for part in [0.01, 0.5, 0.99] {
                        let u = (f64::from(column) + part) / f64::from(size[0]);
                        let direction = sky.direction(u, above + (below - above) * part);
                        assert_eq!(sky.texel(direction), [column, row], "{size:?}, {rotate_deg}, {part}");
                    }
                }
            }
        }
    }

    #[test]
    fn no_direction_is_beside_the_image() {
        let sky = sky([5, 3], 123.0);
        for direction in [[0.0; 3], [f64::NAN; 3], [0.0, -1e-300, 0.0], [-0.0, 0.0, -1.0], [1e300, -1e300, 1.0]] {
            let [column, row] = sky.texel(direction);
            assert!(column < 5 && row < 3, "{direction:?}");
        }
        assert_eq!(Image::new([2, 2], vec![[0.0; 3]; 3]), None);
        assert_eq!(Image::new([0, 7], vec![]), None);
        assert_eq!(Image::new([u32::MAX; 2], vec![[0.0; 3]]), None);
    }
}
