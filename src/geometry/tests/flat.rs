//! Shapes as primitives: where they are put, which way they face, and whose they are.

use super::*;
use crate::number::Frame;
use crate::scene::{Camera, Filter, Geometry, Mesh, Normals, Scene, Shape, Transform};
use std::sync::Arc;

fn shape(geometry: Geometry, transform: Transform) -> Shape {
    Shape { geometry, material: String::new(), emission: None, transform }
}

fn scene(shapes: Vec<Shape>) -> Scene {
    let camera = Camera {
        origin: [0.0; 3],
        target: [1.0; 3],
        up: [0.0, 0.0, 1.0],
        fov_y_deg: 40.0,
        width: 1,
        height: 1,
        aperture: 0.0,
        focus: None,
        polariser_deg: None,
    };
    Scene {
        name: String::new(),
        max_depth: None,
        filter: Filter::default(),
        camera,
        environment: None,
        materials: Vec::new(),
        shapes,
        lights: Vec::new(),
    }
}

/// The transform by its words: scaled, turned about one axis after the other, moved.
fn put(point: Triple, transform: &Transform) -> Triple {
    let mut v: Triple = std::array::from_fn(|axis| transform.scale[axis] * point[axis]);
    for axis in 0..3 {
        let (sin, cos) = transform.rotate_deg[axis].to_radians().sin_cos();
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        (v[i], v[j]) = (cos * v[i] - sin * v[j], sin * v[i] + cos * v[j]);
    }
    plus(v, transform.translate, 1.0)
}

fn near(one: Triple, other: Triple) -> bool {
    length(vector(one) - vector(other)) < 1e-12
}

fn transforms() -> Vec<Transform> {
    let mut even = Even::new("flat/transforms");
    let mut all = vec![Transform::default()];
    for _ in 0..50 {
        let scale = [0; 3].map(|_| even.power(-0.5, 0.5));
        let rotate_deg = [0; 3].map(|_| even.between(-360.0, 360.0));
        all.push(Transform { scale, rotate_deg, translate: even.point() });
    }
    all
}

/// Of a flat primitive: its corner and the normal that it shows.
fn facing(primitive: &Primitive) -> (Triple, Triple) {
    match *primitive {
        Primitive::Quad { corner, edges: [u, v] } => (corner, triple(vector(u).cross(vector(v)).normalised())),
        Primitive::Triangle { corners: [a, b, c], .. } => {
            (a, triple((vector(b) - vector(a)).cross(vector(c) - vector(a)).normalised()))
        }
        Primitive::Disc { center, normal, .. } => (center, triple(vector(normal).normalised())),
        Primitive::Sphere { .. } => panic!("round"),
    }
}

#[test]
fn quads_and_triangles_go_where_their_corners_go() {
    let [a, b, d] = [[0.1, 0.2, 0.3], [1.1, 0.4, 0.2], [0.3, 1.2, 0.9]];
    let c = triple(vector(b) + vector(d) - vector(a));
    // On the side that the normal shows.
    let above = plus(a, triple((vector(b) - vector(a)).cross(vector(d) - vector(a))), 1.0);
    for transform in transforms() {
        let quad = flatten::primitives(&shape(Geometry::Quad { vertices: [a, b, c, d] }, transform));
        let corners = quad[0].corners().expect("some");
        let is_there = |point: Triple| corners.iter().any(|corner| near(*corner, put(point, &transform)));
        assert!(quad.len() == 1 && [a, b, c, d].into_iter().all(is_there), "{transform:?}");
        let mesh = Mesh {
            positions: [a, b, d].map(|v| v.map(|part| part as f32)).to_vec(),
            normals: vec![[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
            triangles: vec![[0, 1, 2], [2, 1, 0]],
            ..Mesh::default()
        };
        let positions = mesh.positions.clone();
        let geometry = Geometry::Mesh { file: None, normals: Normals::Smooth, mesh: Arc::new(mesh) };
        let triangles = flatten::primitives(&shape(geometry, transform));
        assert_eq!(triangles.len(), 2);
        for triangle in &triangles {
            let Primitive::Triangle { corners, normals: Some(normals) } = *triangle else { panic!("smooth") };
            for (corner, normal) in corners.into_iter().zip(normals) {
                let at = positions.iter().position(|position| near(corner, put(position.map(f64::from), &transform)));
                // Its own normal: what was square to it is so still, and on the same side.
                let old = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]][at.expect("a corner")];
                let way = |v: Triple| vector(put(v, &transform)) - vector(put([0.0; 3], &transform));
                let new = vector(normal.map(f64::from)).normalised();
                for axis in 0..3 {
                    let unit: Triple = std::array::from_fn(|other| if other == axis { 1.0 } else { 0.0 });
                    let along = new.dot(way(unit).normalised());
                    assert!(if vector(unit).dot(vector(old)) > 0.5 { along > 0.0 } else { along.abs() < 1e-6 });
                }
            }
        }
        // The side that was in front is in front.
        for (primitive, sign) in [(&quad[0], 1.0), (&triangles[0], 1.0), (&triangles[1], -1.0)] {
            let (corner, normal) = facing(primitive);
            let height = vector(normal).dot(vector(put(above, &transform)) - vector(corner));
            assert!(sign * height > 0.0, "{transform:?} {primitive:?}");
        }
    }
}

#[test]
fn boxes_face_outwards_and_close() {
    let (min, max) = ([-0.3, 0.1, 0.2], [0.4, 0.9, 1.5]);
    for transform in transforms() {
        let faces = flatten::primitives(&shape(Geometry::Box { min, max }, transform));
        let middle = put([0.05, 0.5, 0.85], &transform);
        assert_eq!(faces.len(), 6);
        let mut sum = Vector::of([0.0; 3]);
        for face in &faces {
            let (corner, normal) = facing(face);
            assert!(vector(normal).dot(vector(corner) - vector(middle)) > 0.0, "{transform:?} {face:?}");
            sum = sum + vector(normal).scaled(face.area());
            for corner in face.corners().expect("some") {
                let is_corner = (0..8_u32).any(|at| {
                    let pick = |axis: usize| if at >> axis & 1 == 0 { min[axis] } else { max[axis] };
                    near(corner, put([pick(0), pick(1), pick(2)], &transform))
                });
                assert!(is_corner, "{face:?}");
            }
        }
        // Of what is closed the areas sum to nothing.
        assert!(length(sum) < 1e-12);
    }
}

#[test]
fn round_shapes_keep_their_form() {
    for mut transform in transforms() {
        transform.scale = [transform.scale[0].abs(); 3];
        let center = [0.3, -0.2, 0.5];
        let radius = 0.7 * transform.scale[0];
        let sphere = flatten::primitives(&shape(Geometry::Sphere { center, radius: 0.7 }, transform));
        let Primitive::Sphere { center: found, radius: r } = sphere[0] else { panic!("a sphere") };
        assert!(near(found, put(center, &transform)) && (r - radius).abs() < 1e-12);
        let normal = [0.6, 0.0, 0.8];
        let disc = flatten::primitives(&shape(Geometry::Disc { center, normal, radius: 0.7 }, transform));
        let Primitive::Disc { center: found, radius: r, .. } = disc[0] else { panic!("a disc") };
        assert!(near(found, put(center, &transform)) && (r - radius).abs() < 1e-12);
        let tip = vector(put(plus(center, normal, 1.0), &transform)) - vector(found);
        assert!(near(facing(&disc[0]).1, triple(tip.normalised())));
    }
}

/// Cornell's box should not have walls that are off by 6e−17.
#[test]
fn quarter_turns_are_exact() {
    let transform = Transform { scale: [1.0; 3], rotate_deg: [90.0, -180.0, 450.0], translate: [0.0; 3] };
    let found = flatten::primitives(&shape(Geometry::Box { min: [0.0; 3], max: [1.0, 2.0, 3.0] }, transform));
    let numbers: Vec<f64> = found.iter().filter_map(Primitive::corners).flatten().flatten().collect();
    assert!(numbers.iter().all(|part| part.fract() == 0.0), "{numbers:?}");
}

#[test]
fn primitives_know_their_shapes() {
    let ball = |radius: f64| shape(Geometry::Sphere { center: [0.0; 3], radius }, Transform::default());
    let cube = || shape(Geometry::Box { min: [0.0; 3], max: [1.0; 3] }, Transform::default());
    let empty =
        shape(Geometry::Mesh { file: None, normals: Normals::Flat, mesh: Arc::default() }, Transform::default());
    let flat = flatten(&scene(vec![ball(1.0), cube(), empty, ball(2.0), cube()]));
    assert_eq!(flat.primitives.len(), 14);
    let expected: Vec<usize> =
        [(0, 1), (1, 6), (3, 1), (4, 6)].iter().flat_map(|&(shape, count)| vec![shape; count]).collect();
    let found: Vec<usize> = (0..14).map(|at| flat.owners.shape(at)).collect();
    assert_eq!(found, expected);
    assert_eq!([0, 1, 2, 3].map(|shape| flat.of_shape(shape).len()), [1, 6, 0, 1]);
    assert_eq!(flat.of_shape(3), &flat.primitives[7..8]);
}

#[test]
fn boxes_about_primitives_are_the_least() {
    let mut even = Even::new("flat/bounds");
    for at in 0..200 {
        let (center, size) = (even.point(), even.power(-1.0, 1.0).abs());
        let [u, v] = [even.point(), even.point()];
        let primitive = match at % 4 {
            0 => quad(center, [u, v]),
            1 => Primitive::Sphere { center, radius: size },
            2 => Primitive::Disc { center, normal: u, radius: size },
            _ => super::flat([center, u, v]),
        };
        let bounds = primitive.bounds();
        // By many of its points.
        let Frame { x: e, y: f, .. } = Frame::about(vector(u).normalised());
        let points: Vec<Triple> = (0..4000)
            .map(|at| {
                let phi = std::f64::consts::TAU * f64::from(at) / 4000.0;
                match primitive {
                    Primitive::Sphere { .. } => plus(
                        center,
                        [
                            [1.0, 0.0, 0.0],
                            [0.0, -1.0, 0.0],
                            [0.0, 0.0, 1.0],
                            [-1.0, 0.0, 0.0],
                            [0.0, 1.0, 0.0],
                            [0.0, 0.0, -1.0],
                        ][at as usize % 6],
                        size,
                    ),
                    Primitive::Disc { .. } => plus(center, triple(e.scaled(phi.cos()) + f.scaled(phi.sin())), size),
                    _ => primitive.corners().expect("some")[at as usize % 4],
                }
            })
            .collect();
        let found = Bounds::of(points);
        for axis in 0..3 {
            let slack = 1e-5 * size + 1e-12;
            assert!(
                (found.low[axis] - bounds.low[axis]).abs() < slack
                    && (found.high[axis] - bounds.high[axis]).abs() < slack
            );
        }
    }
    assert_eq!(Bounds::NOTHING.reach(), 0.0);
    assert_eq!(
        World::<f32>::new(&cube([-1.0; 3], [2.0, 3.0, 4.0])).bounds(),
        Bounds { low: [-1.0; 3], high: [2.0, 3.0, 4.0] }
    );
}
