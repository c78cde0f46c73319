//! C20: patches that touch at a slant, where r is 0 and nothing is square.

use crate::vocabulary::{Bench, Check, Measured, check, largest};
use light::radiosity::exchange::{around, by_rim, exchange};
use light::radiosity::{Face, Patch, Room, hinge};
use light::scene::Triple;
use std::f64::consts::PI;

/// F between two rectangles at a common edge, by their widths and the angle.
type Hinged = fn(f64, f64, f64) -> f64;

pub(super) const HINGE: Check<Hinged> = check("hinge", "around both, two rectangles with a common edge exchange what the catalogue says, at any angle")
    .against("Feingold's formula of 1966 (Howell C-16), for widths of 0.3 … 2 edges and angles of 0.4 … 2.6")
    .within(1e-12, "1", "the formula's terms are of order 1/sin² 0.4 ~ 7 and more over widths of 0.3, some thirty of them in ulp; the way around is left with 10⁻¹⁴ a pair of edges")
    .of(
        |_: &mut Bench, hinged: Hinged| {
            let cases = [(1.0, 1.0), (0.3, 1.0), (2.0, 0.5)];
            let cases = cases.into_iter().flat_map(|(a, b)| [0.4, 1.0, 1.5, 2.0, 2.6].map(|angle| (a, b, angle)));
            Measured::worst(cases.map(|(a, b, angle)| {
                (hinged(a, b, angle) - hinge::factor(a, b, angle), format!("widths {a} and {b}, φ = {angle}"))
            }))
        },
        opened as Hinged,
    )
    .slip("the angle between the normals for that between the plates", |a, b, angle| opened(a, b, PI - angle));

/// The same by the way around both.
fn opened(width: f64, other: f64, angle: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let one = Patch::parallelogram([0.0; 3], [[width, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let other = Patch::parallelogram([0.0; 3], [[0.0, 1.0, 0.0], [other * cos, 0.0, other * sin]]);
    around(&one, &other) / one.area()
}

/// What two patches exchange [m²].
type Exchange = fn(&Patch, &Patch) -> f64;

pub(super) const SLANTED: Check<Exchange> = check("slanted", "rooms without a right angle are closed too, and exchange is the same from either side: a tetrahedron, where each face sees a third of each other, an octahedron and a sheared box")
    .against("Σ F = 1 for every piece, whole and cut in nine, A F the same from either side, and 1/3 by symmetry for faces of the tetrahedron")
    .within(1e-11, "1", "around a pair of pieces 10⁻¹⁴ of the square of a clipped edge is left, over a piece of a ninth of it; a hundred of them in a row, at worst all one way")
    .of(
        |_: &mut Bench, exchange: Exchange| {
            let rooms = [("tetrahedron", tetrahedron()), ("octahedron", octahedron()), ("sheared box", sheared())];
            let cut = rooms.iter().flat_map(|(name, room)| [1, 3].map(|n| (*name, n, room.cut(n).list)));
            let found = cut.flat_map(|(name, n, patches)| {
                let between = |one: &Patch, other: &Patch| if one == other { 0.0 } else { exchange(one, other) };
                let all: Vec<Vec<f64>> =
                    patches.iter().map(|one| patches.iter().map(|other| between(one, other)).collect()).collect();
                let place = format!("{name}, {n} × {n} a face");
                let over = |row: usize, exchanged: f64| exchanged / patches[row].area();
                let open = (0..all.len()).map(|row| over(row, all[row].iter().sum()) - 1.0);
                let pairs = (0..all.len()).flat_map(|row| (0..row).map(move |column| (row, column)));
                let uneven = pairs.map(|(row, column)| over(row, all[row][column] - all[column][row]));
                [(largest(open), place.clone()), (largest(uneven), format!("{place}, from either side"))]
            });
            let [one, other] = [0, 3].map(|face| rooms[0].1.faces[face].patch);
            let third = exchange(&one, &other) / one.area() - 1.0 / 3.0;
            Measured::worst(found.chain([(third, "a face of the tetrahedron and another".to_owned())]))
        },
        exchange as Exchange,
    )
    .slip("sixteen points of one and the rim of the other, also where they touch", |one, other| by_rim(one, other, 4));

/// A face that shines and absorbs a half.
fn face(patch: Patch) -> Face {
    Face { patch, absorbed: [0.5; 3], emitted: [1.0; 3] }
}

/// Triangles about the origin, turned inward.
fn inward(faces: impl Iterator<Item = [Triple; 3]>) -> Room {
    let turned = |[a, b, c]: [Triple; 3]| {
        let patch = Patch::triangle([a, b, c]);
        face(if patch.before([0.0; 3]) > 0.0 { patch } else { Patch::triangle([a, c, b]) })
    };
    Room { faces: faces.map(turned).collect(), is_closed: true }
}

fn tetrahedron() -> Room {
    let [a, b, c, d] = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    inward([[a, b, c], [a, b, d], [a, c, d], [b, c, d]].into_iter())
}

fn octahedron() -> Room {
    let corner = |axis: usize, signs: usize| -> Triple {
        let sign = if signs >> axis & 1 == 0 { 1.0 } else { -1.0 };
        std::array::from_fn(|at| if at == axis { sign } else { 0.0 })
    };
    inward((0..8).map(|signs| [0, 1, 2].map(|axis| corner(axis, signs))))
}

/// A box whose edges are along no right angle.
fn sheared() -> Room {
    let [a, b, c] = [[1.0, 0.2, -0.1], [0.3, 0.9, 0.25], [-0.2, 0.35, 1.2]];
    let near = [[a, b], [b, c], [c, a]].map(|edges| face(Patch::parallelogram([0.0; 3], edges)));
    let far = [(c, [b, a]), (a, [c, b]), (b, [a, c])].map(|(way, edges)| face(Patch::parallelogram(way, edges)));
    Room { faces: near.into_iter().chain(far).collect(), is_closed: true }
}
