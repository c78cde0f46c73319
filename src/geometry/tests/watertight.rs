//! No ray slips between triangles that share an edge or a corner, nor between walls.

use super::*;

/// Rays in units of 8, each with so many different aims.
const PACKETS: usize = 40_000;

/// A point on an edge or a corner of a face, or anywhere in it, as single precision rounds it.
fn aim(face: &[Triple; 3], even: &mut Even) -> Triple {
    let [a, b, c] = *face;
    let s = even.number();
    let target = match (even.number() * 8.0) as u32 {
        0 => a,
        1 => b,
        2..=6 => plus(a, triple(vector(b) - vector(a)), s),
        _ => plus(plus(a, triple(vector(b) - vector(a)), 0.5 * s), triple(vector(c) - vector(a)), 0.3),
    };
    rounded::<f32>(target)
}

/// Rays from inside that meet nothing.
fn leaks(address: &str, faces: &[[Triple; 3]], mut inside: impl FnMut(&mut Even) -> Triple) -> usize {
    let mut even = Even::new(address);
    let primitives: Vec<Primitive> = faces.iter().copied().map(flat).collect();
    let world = World::<F32x8>::new(&primitives);
    let mut missed = 0;
    for _ in 0..PACKETS {
        let packet: [(Triple, Triple); 8] = std::array::from_fn(|_| {
            let origin = rounded::<f32>(inside(&mut even));
            let face = &faces[(even.number() * faces.len() as f64) as usize];
            let way = vector(aim(face, &mut even)) - vector(origin);
            // Of length 1, or as it is: of both the direction is exact to a rounding only.
            (origin, triple(if even.number() < 0.5 { way.normalised() } else { way }))
        });
        let hit = world.closest(&rays(|lane| packet[lane]), active::<F32x8>());
        missed += (0..8).filter(|&lane| hit.primitive.lane(lane) < 0.0).count();
    }
    missed
}

#[test]
fn closed_meshes_hold_light() {
    let bumpy = |[x, y, z]: Triple| {
        let r = 1.0 + 0.1 * (5.0 * x).sin() * (7.0 * y).cos();
        [r * x, r * y, r * z]
    };
    let centre = |scale: f64| move |even: &mut Even| even.point().map(|part| 0.3 * scale * part);
    assert_eq!(leaks("watertight/ball", &ball(3, bumpy), centre(1.0)), 0);
    for scale in [1e-6, 1e6] {
        let scaled = |v: Triple| bumpy(v).map(|part| scale * part);
        assert_eq!(leaks("watertight/scaled", &ball(3, scaled), centre(scale)), 0, "{scale}");
    }
    // Needles: a thousandth as thick as long; and far from the world's origin.
    let thin = |v: Triple| [1e3 * bumpy(v)[0], bumpy(v)[1], bumpy(v)[2]];
    let along = |even: &mut Even| [500.0 * even.between(-1.0, 1.0), 0.2 * even.between(-1.0, 1.0), 0.1];
    assert_eq!(leaks("watertight/thin", &ball(3, thin), along), 0);
    let away = |v: Triple| plus([100.0, 200.0, -300.0], bumpy(v), 1.0);
    let there = |even: &mut Even| plus([100.0, 200.0, -300.0], even.point(), 0.3);
    assert_eq!(leaks("watertight/away", &ball(3, away), there), 0);
}

/// From on the corners, edges and faces themselves, inwards: what starts on a face may miss that, but not all.
#[test]
fn rays_from_the_mesh_itself_stay_inside() {
    let faces = ball(2, |v| v.map(|part| 1.5 * part));
    let mut even = Even::new("watertight/own faces");
    let starts: Vec<Triple> = (0..1000).map(|at| aim(&faces[at % faces.len()], &mut even)).collect();
    let mut count = 0;
    // Drawn in by a tenth: a ball's chords stay inside.
    let inside = move |_: &mut Even| {
        count += 1;
        starts[count % starts.len()].map(|part| 0.9 * part)
    };
    assert_eq!(leaks("watertight/inwards", &faces, inside), 0);
}

/// A fan of thin triangles about a corner, seen along each: exactly at the corner and its edges.
#[test]
fn a_fan_is_met_at_its_middle() {
    let mut even = Even::new("watertight/fan");
    for _ in 0..20_000 {
        let count = 3 + (even.number() * 30.0) as usize;
        let middle = rounded::<f32>(even.point());
        let tilt = even.between(-1.0, 1.0);
        let rim: Vec<Triple> = (0..count)
            .map(|at| {
                let phi = std::f64::consts::TAU * (at as f64 + 0.3 * even.number()) / count as f64;
                let r = even.power(-3.0, 0.0).abs();
                rounded::<f32>(plus(middle, [r * phi.cos(), r * phi.sin(), tilt * r * phi.cos()], 1.0))
            })
            .collect();
        let origin = rounded::<f32>(plus(middle, [even.between(-1.0, 1.0), even.between(-1.0, 1.0), 2.0], 1.0));
        let spoke = rim[(even.number() * count as f64) as usize];
        let s = if even.number() < 0.5 { 0.0 } else { 0.9 * even.number() };
        let target = rounded::<f32>(plus(middle, triple(vector(spoke) - vector(middle)), s));
        let ray = ray::<f32>(origin, triple(vector(target) - vector(origin)));
        let is_met = |at: usize| {
            let corners = [middle, rim[at], rim[(at + 1) % count]];
            // Neighbours need not run the same way around.
            let corners = if at.is_multiple_of(2) { corners } else { [corners[2], corners[1], corners[0]] };
            Triangle::<f32>::new(corners).meet(&ray).is_met
        };
        assert!((0..count).any(is_met), "{middle:?} {rim:?} {origin:?} {target:?}");
    }
}

/// Rooms of quads, seen from inside at their edges and corners.
#[test]
fn walls_leave_no_slit() {
    let mut even = Even::new("watertight/room");
    for (low, high) in
        [([-1.0; 3], [1.0; 3]), ([0.1, -0.3, 0.7], [0.9, 0.5, 1.1]), ([-3.0, -1.0, -0.1], [7.0, 1.0, 0.2])]
    {
        // Turned, so that nothing is exact.
        let [x, y, z] = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]];
        let turned = |v: Triple| [x, y, z].map(|row| vector(row).dot(vector(v)));
        let room: Vec<Primitive> = cube(low, high)
            .into_iter()
            .map(|wall| match wall {
                Primitive::Quad { corner, edges } => quad(turned(corner), edges.map(turned)),
                other => other,
            })
            .collect();
        let world = World::<F32x8>::new(&room);
        for _ in 0..PACKETS {
            let packet: [(Triple, Triple); 8] = std::array::from_fn(|_| {
                let inside = |even: &mut Even, axis: usize| even.between(low[axis], high[axis]);
                let origin = rounded::<f32>(turned([0, 1, 2].map(|axis| inside(&mut even, axis))));
                // On an edge: two coordinates at their ends; on a corner all three.
                let free = (even.number() * 4.0) as usize;
                let end = |even: &mut Even, axis: usize| if even.number() < 0.5 { low[axis] } else { high[axis] };
                let target =
                    [0, 1, 2].map(|axis| if axis == free { inside(&mut even, axis) } else { end(&mut even, axis) });
                (origin, triple((vector(turned(target)) - vector(origin)).normalised()))
            });
            let hit = world.closest(&rays(|lane| packet[lane]), active::<F32x8>());
            for (lane, packet) in packet.iter().enumerate() {
                assert!(hit.primitive.lane(lane) >= 0.0, "{packet:?}");
            }
        }
    }
}
