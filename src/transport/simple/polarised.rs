//! Light with its polarisation: what mirrors, metal and glass do to it by E36–E40, and what a filter before the camera sees of that.
//!
//! A path is followed from the eye, and carries what is *asked* of light by what it has met: the row of a Mueller matrix that gives what
//! the pixel sees of a Stokes vector here ([`crate::stokes`]). Without a filter it begins as (1, 0, 0, 0), the intensity; behind a
//! polariser as ½(1, cos 2α, sin 2α, 0). One row of four numbers is enough, for a pixel asks one question; all four rows would be
//! four pictures. Lamps and the sky send out natural light, of which the first number counts alone. What is matt returns natural light, whatever
//! falls on it.

use super::lamps::from_lamps;
use super::{Numbers, gathered};
use crate::bsdf::{Rgb, rgb};
use crate::geometry::Ray;
use crate::number::Vector;
use crate::optics::Incidence;
use crate::sampling::balance;
use crate::stokes::Mueller;
use crate::transport::surfaces::Polished;
use crate::transport::{Stage, Vertex};

/// Vertices before a path may end by chance.
const PATIENCE: u32 = 6;

/// What is asked of light that comes along a ray.
#[derive(Clone, Copy, Debug)]
struct Asked {
    /// Of S₀ … S₃ in each channel.
    rows: Rgb<[f64; 4]>,
    /// The axis x of these, across the ray.
    axis: Vector<f64>,
}

/// The part of a vector across a unit vector, of length 1; None if there is hardly any.
fn across(v: Vector<f64>, way: Vector<f64>) -> Option<Vector<f64>> {
    let off = v - way.scaled(v.dot(way));
    let length = off.dot(off).sqrt();
    (length > 1e-9).then(|| off.scaled(1.0 / length))
}

impl Asked {
    /// At the eye: by the filter's angle [rad] from the picture's right to its up, if there is one.
    fn at_eye(stage: &Stage<f64>, ray: &Ray<f64>) -> Self {
        let axis = across(stage.lens().right(), ray.direction).unwrap_or_else(|| beside(ray.direction));
        let row = match stage.polariser() {
            None => [1.0, 0.0, 0.0, 0.0],
            Some(angle) => Mueller::polariser(angle).asked([1.0, 0.0, 0.0, 0.0]),
        };
        Self { rows: [row; 3], axis }
    }

    /// The share of natural light.
    fn of_natural(&self) -> Rgb<f64> {
        rgb(|c| self.rows[c][0])
    }

    /// Of light that is natural again, what it was turned into times a weight.
    fn depolarised(&self, weight: Rgb<f64>, ray: &Ray<f64>) -> Self {
        let rows = rgb(|c| Mueller::depolariser(weight[c]).asked(self.rows[c]));
        Self { rows, axis: beside(ray.direction) }
    }

    /// Of light that goes along `from` and is turned into what goes along `to` by matrices whose axis is `s`.
    fn before(&self, matrices: Rgb<Mueller>, s: Vector<f64>, to: Vector<f64>) -> Self {
        // How far s is turned from the axis, about where the light goes.
        let y = to.cross(self.axis);
        let turn = Mueller::turn(-s.dot(y).atan2(s.dot(self.axis)));
        Self { rows: rgb(|c| matrices[c].asked(turn.asked(self.rows[c]))), axis: s }
    }
}

/// A vector across a unit vector.
fn beside(way: Vector<f64>) -> Vector<f64> {
    crate::number::Frame::about(way).x
}

/// The matrices by channel of what is polished, for light that comes from `wi` and goes to `wo` along the vertex's axes, over the chance
/// that it was drawn.
fn matrices(
    polished: &Polished,
    vertex: &Vertex<'_, f64>,
    is_transmitted: bool,
    chance: f64,
    squeeze: f64,
) -> Rgb<Mueller> {
    let cos = vertex.wo.z.abs().min(1.0);
    let scaled = |matrix: Mueller, by: f64| Mueller(matrix.0.map(|row| row.map(|m| m * by)));
    match polished {
        Polished::Mirror(reflectance) => rgb(|c| Mueller::mirror(reflectance[c])),
        Polished::Metal(indices) => rgb(|c| Mueller::reflection(Incidence::from_cos(cos), 1.0, indices[c])),
        Polished::Clear(index) => {
            let (n_o, n_i) = if vertex.wo.z < 0.0 { (*index, 1.0) } else { (1.0, *index) };
            // Light runs the other way than the path; a reflection is the same both ways, and so is a passage's share.
            let one = if is_transmitted {
                Mueller::transmission(Incidence::from_cos(cos), n_o, n_i)
            } else {
                Mueller::reflection(Incidence::from_cos(cos), n_o, n_i.into())
            };
            [scaled(one, squeeze / chance); 3]
        }
    }
}

/// The radiance [W m⁻² sr⁻¹] that comes along a ray and through the camera's filter.
// ANCHOR: polarised
pub fn radiance(stage: &Stage<f64>, mut ray: Ray<f64>, numbers: &mut Numbers<'_>, depth: u32) -> Rgb<f64> {
    let mut light = [0.0; 3];
    let mut asked = Asked::at_eye(stage, &ray);
    let (mut pdf, mut squeeze) = (f64::INFINITY, 1.0);
    for edge in 1..=depth {
        let Some(vertex) = stage.meet(&ray) else {
            let weight = balance(pdf, stage.density_to_sky(&ray));
            return gathered(light, asked.of_natural(), stage.sky(&ray).map(|sky| sky * weight));
        };
        asked.rows = rgb(|c| asked.rows[c].map(|part| part * vertex.clarity[c]));
        let weight = balance(pdf, stage.density_to(&ray, &vertex, true));
        light = gathered(light, asked.of_natural(), vertex.emitted().map(|emitted| emitted * weight));
        if edge == depth {
            break;
        }
        let row = numbers.of_next_vertex();
        let polished = vertex.met.polished();
        if polished.is_none() {
            light = gathered(light, asked.of_natural(), from_lamps(stage, &vertex, row.lamp, balance));
        }
        let drawn = vertex.scatter(row.surface);
        if drawn.weight == [0.0; 3] {
            break;
        }
        let next = stage.leave(&vertex, vertex.frame.outward(drawn.wi));
        asked = match polished {
            None => asked.depolarised(drawn.weight, &next),
            Some(polished) => {
                let (from, to) = (-next.direction, -ray.direction);
                // Square to the surface any axis will do.
                let s = across(vertex.frame.z.cross(to), to).unwrap_or(asked.axis);
                let chance = polished.chance(vertex.wo.z, drawn.is_transmitted);
                let turned = matrices(polished, &vertex, drawn.is_transmitted, chance, drawn.compression);
                let before = asked.before(turned, s, to);
                Asked { axis: across(s, from).unwrap_or_else(|| beside(from)), ..before }
            }
        };
        pdf = if drawn.is_delta { f64::INFINITY } else { drawn.pdf };
        squeeze *= drawn.compression;
        ray = next;
        // No part of a row is larger than the first.
        let left = asked.of_natural().into_iter().fold(0.0, f64::max) / squeeze;
        let chance = if edge < PATIENCE { 1.0 } else { left };
        if row.survival >= chance {
            break;
        }
        asked.rows = rgb(|c| asked.rows[c].map(|part| part / chance.min(1.0)));
    }
    light
}
// ANCHOR_END: polarised
