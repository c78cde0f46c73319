//! Single primitives against exact arithmetic on the very numbers that they were given.
//!
//! What is asked of a t is that the point there, exactly, lies on the exact primitive, to some roundings of the places
//! and sizes at hand: that is what rounding can keep, whatever the angle. Whether a ray meets at all is asked of those that
//! do or do not by more than that.

use super::*;
use crate::number::Mask;
use yardstick::precise::{Real, real, to_f64};

/// Roundings that a primitive may be off: in each of three components half of one for each of about ten operations.
const ROUNDINGS: f64 = 16.0;

/// How many rays.
const RAYS: usize = 3000;

#[derive(Clone)]
struct Exact([Real; 3]);

impl Exact {
    fn of(v: Triple) -> Self {
        Self(v.map(real))
    }

    fn zip(&self, other: &Self, f: impl Fn(&Real, &Real) -> Real) -> Self {
        Self(std::array::from_fn(|axis| f(&self.0[axis], &other.0[axis])))
    }

    fn minus(&self, other: &Self) -> Self {
        self.zip(other, |a, b| a - b)
    }

    fn along(&self, direction: &Self, t: &Real) -> Self {
        self.zip(direction, |o, d| o + t * d)
    }

    fn dot(&self, other: &Self) -> Real {
        let [x, y, z] = self.zip(other, |a, b| a * b).0;
        x + y + z
    }

    fn cross(&self, other: &Self) -> Self {
        let term = |i: usize, j: usize| &self.0[i] * &other.0[j] - &self.0[j] * &other.0[i];
        Self([term(1, 2), term(2, 0), term(0, 1)])
    }

    fn length(&self) -> f64 {
        to_f64(&self.dot(self)).sqrt()
    }
}

/// A plane's t, and the coordinates there along two edges from a corner.
fn plane(o: &Exact, d: &Exact, corner: &Exact, [u, v]: [&Exact; 2]) -> Option<(Real, [Real; 2])> {
    let normal = u.cross(v);
    let along = normal.dot(d);
    if to_f64(&along) == 0.0 {
        return None;
    }
    let t = normal.dot(&corner.minus(o)) / along;
    Some((t.clone(), coordinates(&o.along(d, &t), corner, [u, v])))
}

/// Along two edges from a corner, of a point seen along their normal.
fn coordinates(point: &Exact, corner: &Exact, [u, v]: [&Exact; 2]) -> [Real; 2] {
    let normal = u.cross(v);
    let square = normal.dot(&normal);
    let from = point.minus(corner);
    [from.cross(v).dot(&normal) / &square, u.cross(&from).dot(&normal) / square]
}

/// Corners and rays of all sizes that a width is good for: the ray towards about the middle.
fn case<N: Width>(even: &mut Even, from_middle: f64) -> ([Triple; 3], (Triple, Triple)) {
    let place = even.power(-3.0, 3.0);
    let size = even.power(-2.0, 2.0);
    let corner = even.point().map(|part| place * part);
    let edge = |even: &mut Even| even.point().map(|part| size * part);
    let [u, v] = [edge(even), edge(even)];
    let [a, b, c] = [u, v, corner].map(rounded::<N>);
    let (s, r) = (0.5 + from_middle * even.between(-0.5, 0.5), 0.5 + from_middle * even.between(-0.5, 0.5));
    let target = plus(plus(c, a, s), b, r);
    let away = even.power(-2.0, 2.0);
    let origin = rounded::<N>(plus(target, even.direction(), away));
    let direction = rounded::<N>(triple((vector(target) - vector(origin)).normalised()));
    ([c, a, b], (origin, direction))
}

fn parallelograms<N: Width>(name: &str) {
    let mut even = Even::new(name);
    let (mut met, mut missed) = (0, 0);
    for _ in 0..RAYS {
        let ([corner, u, v], (origin, direction)) = case::<N>(&mut even, 1.4);
        let meeting = Quad::<N>::new(corner, [u, v]).meet(&ray(origin, direction));
        let [o, d, c, eu, ev] = [origin, direction, corner, u, v].map(Exact::of);
        let Some((t, place)) = plane(&o, &d, &c, [&eu, &ev]) else { continue };
        let normal = eu.cross(&ev);
        let reach = [origin, corner, u, v].map(|v| length(vector(v))).iter().sum::<f64>();
        let off = ROUNDINGS * N::EPSILON * reach;
        let cos = (to_f64(&normal.dot(&d)) / normal.length()).abs();
        // How far in its own coordinates a point may be displaced: across the edges, and along the plane by the angle.
        let sine = normal.length() / (eu.length() * ev.length());
        let [su, sv] = [&eu, &ev].map(|edge| off / cos / (edge.length() * sine));
        let [pu, pv] = place.map(|part| to_f64(&part));
        let depth = |part: f64, slack: f64| (part.min(1.0 - part) / slack).clamp(-2.0, 2.0);
        let depth = depth(pu, su).min(depth(pv, sv));
        let expected = to_f64(&t) > 0.0 && depth > 0.0;
        if depth.abs() > 1.0 && to_f64(&t).abs() > off / cos {
            assert_eq!(meeting.is_met.lane(0), expected, "{name}: {corner:?} {u:?} {v:?} {origin:?} {direction:?}");
        }
        if !meeting.is_met.lane(0) {
            missed += 1;
            continue;
        }
        met += 1;
        let point = o.along(&d, &real(meeting.t.lane(0)));
        let height = to_f64(&normal.dot(&point.minus(&c))).abs() / normal.length();
        assert!(height <= off, "{name}: {height:e} off the plane, {off:e} allowed");
        let there = coordinates(&point, &c, [&eu, &ev]).map(|part| 2.0 * to_f64(&part) - 1.0);
        for (ours, exact, edge) in [(meeting.u, there[0], &eu), (meeting.v, there[1], &ev)] {
            let gap = (ours.lane(0) - exact).abs();
            // Beside roundings, the growth that closes slits.
            let slack = 2.0 * off / (edge.length() * sine) + 1.1e-4;
            assert!(gap <= slack, "{name}: {ours:?} against {exact}, {slack:e} allowed");
        }
    }
    assert!(met > RAYS / 8 && missed > RAYS / 8, "{met} {missed}");
}

fn discs<N: Width>(name: &str) {
    let mut even = Even::new(name);
    let (mut met, mut missed) = (0, 0);
    for _ in 0..RAYS {
        let ([center, normal, edge], (origin, direction)) = case::<N>(&mut even, 2.0);
        let radius = N::of(length(vector(edge))).lane(0);
        let meeting = Disc::<N>::new(center, normal, radius).meet(&ray(origin, direction));
        let [o, d, c, n] = [origin, direction, center, normal].map(Exact::of);
        let along = n.dot(&d);
        let t = n.dot(&c.minus(&o)) / &along;
        let off = ROUNDINGS * N::EPSILON * ([origin, center].map(|v| length(vector(v))).iter().sum::<f64>() + radius);
        let cos = (to_f64(&along) / n.length()).abs();
        let distance = o.along(&d, &t).minus(&c).length();
        if (distance - radius).abs() > off / cos && to_f64(&t).abs() > off / cos {
            let expected = to_f64(&t) > 0.0 && distance < radius;
            assert_eq!(
                meeting.is_met.lane(0),
                expected,
                "{name}: {center:?} {normal:?} {radius} {origin:?} {direction:?}"
            );
        }
        if !meeting.is_met.lane(0) {
            missed += 1;
            continue;
        }
        met += 1;
        let point = o.along(&d, &real(meeting.t.lane(0))).minus(&c);
        let height = to_f64(&n.dot(&point)).abs() / n.length();
        assert!(height <= off, "{name}: {height:e} off the plane, {off:e} allowed");
        let ours = meeting.u.lane(0).hypot(meeting.v.lane(0)) * radius;
        assert!((ours - point.length()).abs() <= 2.0 * off, "{name}: {ours} against {}", point.length());
    }
    assert!(met > RAYS / 10 && missed > RAYS / 10, "{met} {missed}");
}

fn triangles<N: Width>(name: &str) {
    let mut even = Even::new(name);
    let (mut met, mut missed) = (0, 0);
    for _ in 0..RAYS {
        let ([corner, u, v], (origin, direction)) = case::<N>(&mut even, 1.4);
        let corners = [corner, plus(corner, u, 1.0), plus(corner, v, 1.0)].map(rounded::<N>);
        let meeting = Triangle::<N>::new(corners).meet(&ray(origin, direction));
        let [o, d] = [origin, direction].map(Exact::of);
        let [a, b, c] = corners.map(Exact::of);
        let (eu, ev) = (b.minus(&a), c.minus(&a));
        let Some((t, place)) = plane(&o, &d, &a, [&eu, &ev]) else { continue };
        let normal = eu.cross(&ev);
        let off = ROUNDINGS * N::EPSILON * [origin, corner, u, v].map(|v| length(vector(v))).iter().sum::<f64>();
        // Of the triangle as the ray sees it: twice its area, and the height that its longest side leaves.
        let area = to_f64(&normal.dot(&d)).abs();
        let longest = eu.length().max(ev.length()).max(c.minus(&b).length());
        let slack = off * longest / area;
        let [pu, pv] = place.map(|part| to_f64(&part));
        let depth = pu.min(pv).min(1.0 - pu - pv);
        let forward = to_f64(&t);
        if depth.abs() > 2.0 * slack && forward.abs() > off + longest * slack {
            assert_eq!(
                meeting.is_met.lane(0),
                forward > 0.0 && depth > 0.0,
                "{name}: {corners:?} {origin:?} {direction:?}"
            );
        }
        if !meeting.is_met.lane(0) {
            missed += 1;
            continue;
        }
        met += 1;
        let gap = (meeting.t.lane(0) - forward).abs();
        assert!(gap <= off + 4.0 * longest * slack, "{name}: t {gap:e} off, {:e} allowed", off + 4.0 * longest * slack);
        for (ours, exact) in [(meeting.u, pu), (meeting.v, pv)] {
            assert!((ours.lane(0) - exact).abs() <= 4.0 * slack, "{name}: {ours:?} against {exact}, {slack:e}");
        }
    }
    assert!(met > RAYS / 8 && missed > RAYS / 8, "{met} {missed}");
}

/// How far o + t d is from a sphere, and both of the exact roots' t where there are any.
struct OnSphere {
    off: f64,
    roots: Option<[f64; 2]>,
    /// By how much the ray passes within the sphere, or outside it if negative.
    depth: f64,
}

fn on_sphere(center: Triple, radius: f64, origin: Triple, direction: Triple, t: f64) -> OnSphere {
    let [c, o, d] = [center, origin, direction].map(Exact::of);
    let (from, r) = (o.minus(&c), real(radius));
    let (a, b, power) = (d.dot(&d), from.dot(&d), from.dot(&from) - &r * &r);
    let discriminant = &b * &b - &a * &power;
    let roots = (to_f64(&discriminant) >= 0.0).then(|| {
        let root = discriminant.clone().sqrt();
        [(-&b - &root) / &a, (-&b + root) / &a].map(|root| to_f64(&root))
    });
    let point = from.along(&d, &real(t));
    let off = to_f64(&(point.dot(&point) - &r * &r)) / (2.0 * radius);
    OnSphere { off: off.abs(), roots, depth: to_f64(&(discriminant / a)) / (2.0 * radius) }
}

fn sphere<N: Width>(name: &str, center: Triple, radius: f64, origin: Triple, direction: Triple) -> bool {
    let meeting = Sphere::<N>::new(center, radius).meet(&ray(origin, direction));
    let is_met = meeting.is_met.lane(0);
    let t = if is_met { meeting.t.lane(0) } else { 0.0 };
    let found = on_sphere(center, radius, origin, direction, t);
    let distance = length(vector(center));
    // As seen from an origin beside a large sphere, what is far away of it does not count.
    let own = if 8.0 * (distance - radius).abs() <= radius { 0.0 } else { distance + radius };
    let reach = own + length(vector(origin)) + t;
    let off = ROUNDINGS * N::EPSILON * reach;
    let text =
        || format!("{name}: r = {radius} at {center:?} from {origin:?} to {direction:?}: {t}, {:?}", found.roots);
    if is_met {
        assert!(found.off <= off, "{}: {:e} off, {off:e} allowed", text(), found.off);
        assert!(t > 0.0);
    }
    if let Some([first, last]) = found.roots {
        // Nothing can be asked of roots that nearly touch, or nearly lie at the start.
        let apart = off.max((2.0 * radius * off).sqrt().min(radius));
        let is_clear = |t: f64| t.abs() > apart;
        if is_clear(first) && is_clear(last) && found.depth > 2.0 * off.max(N::EPSILON * ROUNDINGS * radius) {
            assert_eq!(is_met, last > 0.0, "{}", text());
            let expected = if first > 0.0 { first } else { last };
            assert!(!is_met || (t - expected).abs() < 0.5 * (last - first), "{}", text());
        }
    } else if found.depth.abs() > off.max(N::EPSILON * ROUNDINGS * radius) {
        assert!(!is_met, "{}", text());
    }
    is_met
}

fn spheres<N: Width>(name: &str) {
    let mut even = Even::new(name);
    let mut met = 0;
    for _ in 0..RAYS {
        let place = even.power(-3.0, 3.0);
        let center = rounded::<N>(even.point().map(|part| place * part));
        let radius = N::of(even.power(-2.0, 3.0).abs()).lane(0);
        let within = even.between(0.0, 1.5) * radius;
        let target = plus(center, even.direction(), within);
        // From afar, from near by and from inside.
        let away = even.power(-2.0, 2.0).abs() * radius;
        let origin = rounded::<N>(plus(target, even.direction(), away));
        let direction = rounded::<N>(triple((vector(target) - vector(origin)).normalised()));
        met += usize::from(sphere::<N>(name, center, radius, origin, direction));
    }
    assert!(met > RAYS / 3 && met < RAYS * 9 / 10, "{met}");
}

/// The ground of a planet, from a man's height and from under it.
fn planets<N: Width>(name: &str) {
    let mut even = Even::new(name);
    for _ in 0..RAYS {
        let radius = N::of(even.power(3.0, 6.81).abs()).lane(0);
        let center = [0.0, -radius, 0.0];
        let height = even.power(-2.0, 1.0);
        let origin = rounded::<N>([even.between(-1.0, 1.0), height, even.between(-1.0, 1.0)]);
        let down = even.between(-1.0, 1.0);
        let [x, _, z] = even.direction();
        let direction = rounded::<N>(triple(Vector::new(x, down, z).normalised()));
        sphere::<N>(name, center, radius, origin, direction);
    }
    // Straight down from 1 m onto the Earth: the digits of the metre are kept, not those of the radius.
    let meeting = Sphere::<N>::new([0.0, -6.371e6, 0.0], 6.371e6).meet(&ray([0.0, 1.0, 0.0], [0.0, -1.0, 0.0]));
    assert!(meeting.is_met.lane(0) && (meeting.t.lane(0) - 1.0).abs() <= 4.0 * N::EPSILON, "{meeting:?}");
}

macro_rules! in_both_widths {
    ($($name:ident => $check:ident),*) => {
        $(
            #[test]
            fn $name() {
                $check::<f64>(concat!(stringify!($check), " in f64"));
                $check::<f32>(concat!(stringify!($check), " in f32"));
            }
        )*
    };
}

in_both_widths! {
    a_parallelogram_is_where_it_is => parallelograms,
    a_disc_is_where_it_is => discs,
    a_triangle_is_where_it_is => triangles,
    a_sphere_is_where_it_is => spheres,
    a_planet_keeps_the_digits_of_a_metre => planets
}

/// The slips of textbooks, which the same measure has to refuse.
#[test]
fn the_measure_of_spheres_sees_slips() {
    let (center, origin, direction) = ([0.0, -1e6, 0.0], [0.0, 1.3, 0.0], [0.0, -1.0, 0.0]);
    // b² − c of the centre in f32: the metre is lost among squares of 10¹².
    let f = 1e6_f32 + 1.3;
    let (b, c) = (-f, f * f - 1e6_f32 * 1e6);
    let t = -b - (b * b - c).sqrt();
    assert!(on_sphere(center, 1e6, origin, direction, f64::from(t)).off > 16.0 * f64::from(f32::EPSILON) * 3.0);
}
