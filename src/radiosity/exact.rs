//! Rooms whose light is known, by what their walls absorb.

/// A surface that is the same all over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// 1 − ρ [1].
    pub absorbed: f64,
    /// The radiance [W m⁻² sr⁻¹] that it sends out by itself.
    pub emitted: f64,
}

impl Wall {
    /// With what arrives there reflected.
    fn lit(self, arriving: f64) -> f64 {
        self.emitted + (1.0 - self.absorbed) * arriving
    }
}

/// The radiances [W m⁻² sr⁻¹] inside a sphere of pieces, each of such a share [1] of it. To every place the same arrives, for a
/// sphere's inside sees all of itself alike: what is sent out over what is absorbed.
pub fn sphere(pieces: &[(f64, Wall)]) -> Vec<f64> {
    let sum = |of: fn(&Wall) -> f64| pieces.iter().map(|(share, wall)| share * of(wall)).sum::<f64>();
    let arriving = sum(|wall| wall.emitted) / sum(|wall| wall.absorbed);
    pieces.iter().map(|(_, wall)| wall.lit(arriving)).collect()
}

/// The radiances of the outside of a ball and of the inside of a sphere about it, with `ratio` [1] of the ball's area over the
/// sphere's, 0 … 1. Two plates without end have the ratio 1 (C. Christiansen, *Ann. Phys.* 255 (1883) 267).
pub fn concentric(ratio: f64, ball: Wall, shell: Wall) -> [f64; 2] {
    let rho = 1.0 - shell.absorbed;
    // The shell sees the ball as `ratio` and itself as the rest.
    let outside = (shell.emitted + rho * ratio * ball.emitted) / (shell.absorbed + rho * ratio * ball.absorbed);
    [ball.lit(outside), outside]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_arrives_is_what_is_seen() {
        let (ball, shell) = (Wall { absorbed: 0.3, emitted: 1.0 }, Wall { absorbed: 0.6, emitted: 0.2 });
        for ratio in [0.0, 0.25, 1.0] {
            let [inner, outer] = concentric(ratio, ball, shell);
            let arriving = ratio * inner + (1.0 - ratio) * outer;
            assert!((inner - 1.0 - 0.7 * outer).abs() < 1e-15 && (outer - 0.2 - 0.4 * arriving).abs() < 1e-15);
        }
        // Without a ball to see, a sphere of one piece: emitted over absorbed.
        assert!((concentric(0.0, ball, shell)[1] - sphere(&[(1.0, shell)])[0]).abs() < 1e-15);
        assert!((sphere(&[(1.0, shell)])[0] - 1.0 / 3.0).abs() < 1e-15);
    }
}
