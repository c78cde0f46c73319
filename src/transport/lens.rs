//! The camera: a pinhole, or a thin lens.

use crate::number::{Number, Vector, length_and_way, ln, sin_cos_turns};
use crate::sampling::warp;
use crate::scene::{Camera, Filter, Triple};

/// Rays of a picture.
#[derive(Clone, Debug)]
pub struct Lens<N> {
    origin: Vector<N>,
    /// From the origin to the picture's upper left corner, in the sharp plane.
    corner: Vector<N>,
    /// A pixel to the right, and one down.
    pixel: [Vector<N>; 2],
    /// The lens's radius along both axes; None for a pinhole.
    aperture: Option<[Vector<N>; 2]>,
    filter: Filter,
    is_pinhole: bool,
    /// Where it looks.
    forward: Vector<N>,
    /// How far away a pixel has length 1.
    reach: N,
    /// What gives the pixels to the right and down of a vector in the sharp plane.
    duals: [Vector<N>; 2],
}

impl<N: Number> Lens<N> {
    /// Of a camera, seen from where `shifted` [m] is the origin and in a unit of which `scale` make a metre.
    /// If `always_open`, a pinhole is a lens whose opening has no size.
    pub fn new(camera: &Camera, filter: Filter, (shifted, scale): (Triple, f64), always_open: bool) -> Self {
        let part = |k: usize| camera.target[k] - camera.origin[k];
        let (distance, forward) = length_and_way(Vector::<f64>::new(part(0), part(1), part(2)));
        let right = length_and_way(forward.cross(Vector::of(camera.up))).1;
        let up = right.cross(forward);
        let focus = camera.focus.unwrap_or(distance) * scale;
        let (width, height) = (f64::from(camera.width), f64::from(camera.height));
        let pixel = 2.0 * focus * (0.5 * camera.fov_y_deg.to_radians()).tan() / height;
        let corner = forward.scaled(focus) - right.scaled(0.5 * width * pixel) + up.scaled(0.5 * height * pixel);
        let of = |v: Vector<f64>| Vector::of(v.lane(0));
        Self {
            origin: Vector::of(std::array::from_fn(|k| (camera.origin[k] - shifted[k]) * scale)),
            corner: of(corner),
            pixel: [of(right.scaled(pixel)), of(up.scaled(-pixel))],
            aperture: (camera.aperture > 0.0 || always_open)
                .then(|| [right, up].map(|axis| of(axis.scaled(camera.aperture * scale)))),
            filter,
            is_pinhole: camera.aperture <= 0.0,
            forward: of(forward),
            reach: N::of(focus / pixel),
            duals: [of(right.scaled(1.0 / pixel)), of(up.scaled(-1.0 / pixel))],
        }
    }

    /// Whether the picture is that of a pinhole, and each of its places counts for one pixel alone.
    pub fn is_plain(&self) -> bool {
        self.is_pinhole && self.filter == Filter::Box
    }

    /// The picture's right, of length 1.
    pub fn right(&self) -> Vector<N> {
        length_and_way(self.pixel[0]).1
    }

    /// Where the pinhole is.
    pub fn origin(&self) -> Vector<N> {
        self.origin
    }

    /// The density [sr⁻¹] with which rays through a pixel go in a direction of length 1 that lies within it: pixels of area
    /// 1 as far away as they seem so large.
    #[inline(always)]
    pub fn density(&self, direction: Vector<N>) -> N {
        let cos = self.forward.dot(direction);
        self.reach.squared() / (cos.squared() * cos).max(N::of(f64::from(f32::MIN_POSITIVE)))
    }

    /// The place in the picture, in pixels right and down of its corner, where a direction from the pinhole lies; outside it
    /// if that is behind.
    #[inline(always)]
    pub fn place(&self, direction: Vector<N>) -> [N; 2] {
        let cos = self.forward.dot(direction);
        let is_ahead = cos.gt(N::of(0.0));
        let focus = self.forward.dot(self.corner);
        let from_corner = direction.scaled(focus / N::select(is_ahead, cos, N::of(1.0))) - self.corner;
        let along = |dual: Vector<N>| N::select(is_ahead, dual.dot(from_corner), N::of(-1.0));
        [along(self.duals[0]), along(self.duals[1])]
    }

    /// Origin and direction of the ray through a pixel that belongs to four numbers: the place in the pixel, and that on the
    /// lens.
    #[inline(always)]
    pub fn ray(&self, [column, row]: [N; 2], u: [N; 4]) -> [Vector<N>; 2] {
        let [x, y] = self.filter.offset([u[0], u[1]]);
        let half = N::of(0.5);
        let aim = self.corner + self.pixel[0].scaled(column + half + x) + self.pixel[1].scaled(row + half + y);
        match &self.aperture {
            None => [self.origin, aim.normalised()],
            Some(axes) => {
                let [x, y] = warp::disc([u[2], u[3]]);
                let start = axes[0].scaled(x) + axes[1].scaled(y);
                [self.origin + start, (aim - start).normalised()]
            }
        }
    }
}

impl Filter {
    /// Where in the picture, in pixels from a pixel's centre, a sample of it lies that two numbers 0 ≤ u < 1 draw: densely where
    /// the filter is large, so that the plain mean of a pixel's own samples is the filtered picture (M. Ernst et al., *Filter
    /// importance sampling*, IEEE Symposium on Interactive Ray Tracing (2006)).
    #[inline(always)]
    pub fn offset<N: Number>(self, u: [N; 2]) -> [N; 2] {
        let (half, one) = (N::of(0.5), N::of(1.0));
        let tent = |u: N| {
            let is_low = u.lt(half);
            let part = N::select(is_low, u + u, N::of(2.0) - (u + u)).max(N::of(0.0)).sqrt();
            N::select(is_low, part - one, one - part)
        };
        match self {
            Self::Box => [u[0] - half, u[1] - half],
            Self::Tent => [tent(u[0]), tent(u[1])],
            Self::Gaussian => {
                // Within four standard deviations of ½, by radius and angle.
                let (sin, cos) = sin_cos_turns(u[1]);
                let within = 1.0 - f64::exp(-8.0);
                let radius = (N::of(-0.5) * ln(one - u[0] * N::of(within))).max(N::of(0.0)).sqrt();
                [radius * cos, radius * sin]
            }
        }
    }
}
