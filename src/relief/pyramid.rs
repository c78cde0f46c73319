//! The highest points of squares of cells, so that a ray may pass over many at once.
//!
//! A. Tevs, I. Ihrke & H.-P. Seidel, "Maximum mipmaps for fast, accurate, and scalable dynamic height field rendering",
//! *I3D '08* (2008) 183.

/// For every level l = 0 … log₂ side the highest height in each square of 2^l cells a side.
#[derive(Clone, Debug)]
pub struct Pyramid {
    levels: Vec<Vec<f64>>,
}

impl Pyramid {
    pub fn over(side: usize, heights: &[f64]) -> Self {
        let corner = |x: usize, y: usize| heights[(y % side) * side + x % side];
        let cells = squares(side, |x, y| [corner(x, y), corner(x + 1, y), corner(x, y + 1), corner(x + 1, y + 1)]);
        let mut levels = vec![cells];
        let mut length = side;
        while length > 1 {
            let (below, wide) = (&levels[levels.len() - 1], length);
            length /= 2;
            let part = |x: usize, y: usize| below[y * wide + x];
            let square = |x: usize, y: usize| {
                let [x, y] = [2 * x, 2 * y];
                [part(x, y), part(x + 1, y), part(x, y + 1), part(x + 1, y + 1)]
            };
            levels.push(squares(length, square));
        }
        Self { levels }
    }

    /// The level of a single square, which is the whole relief.
    pub fn summit(&self) -> usize {
        self.levels.len() - 1
    }

    /// The highest point of all.
    pub fn top(&self) -> f64 {
        self.levels[self.summit()][0]
    }

    /// The highest point of the square of `level` that holds cell (x, y), wherever that lies.
    #[inline]
    pub fn highest(&self, level: usize, [x, y]: [isize; 2]) -> f64 {
        let bits = self.summit() - level;
        let mask = (1_usize << bits) - 1;
        let [x, y] = [x, y].map(|part| (part >> level) as usize & mask);
        self.levels[level][(y << bits) | x]
    }
}

/// The highest of what `parts` gives for each of `side`² squares.
fn squares(side: usize, parts: impl Fn(usize, usize) -> [f64; 4]) -> Vec<f64> {
    let highest = |at: usize| parts(at % side, at / side).into_iter().fold(f64::NEG_INFINITY, f64::max);
    (0..side * side).map(highest).collect()
}
