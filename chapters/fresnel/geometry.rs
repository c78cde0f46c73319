//! The three waves at the interface as a drawing: directions, wavelengths and the fields that count as positive.

use super::fields::{self, Vector};
use super::incidence;
use crate::diagram::{Behind, Diagram, Form, Part, Spot};
use crate::figure::{Dash, Hue, Plot};
use crate::parameter::Setting;
use light::Complex64;
use light::Polarisation;
use light::optics::fresnel::{self, Amplitudes};
use light::optics::incidence::{normal_squared, outgoing_root};
use std::f64::consts::FRAC_PI_2;

/// Half the width and half the height of the window.
const WINDOW: Spot = [1.55, 1.05];
/// How far from the window's edge the rays end.
const EDGE: f64 = 0.07;
/// The longest ray.
const LONGEST: f64 = 1.15;
/// The wavelength in vacuum. Denser media than [`DENSE`] would fill with wavefronts: there all of them are longer.
const WAVELENGTH: f64 = 0.12;
const DENSE: f64 = 3.0;
/// How far a wavefront reaches to either side of its ray.
const FRONT: f64 = 0.12;
/// Radius of the arcs.
const ARC: f64 = 0.27;
/// The narrowest angle [rad] whose name still stands on its own side of the normal; its value is in a corner anyway.
const NARROW: f64 = 0.1;
/// The least extinction [1] that is drawn as a metal: the wave is gone within a wavelength or two.
const METALLIC: f64 = 0.1;
/// Where on the incident ray its head is, as a distance from the origin.
const HEAD: f64 = 0.18;
/// Where wavefronts begin, as a distance from the origin, and where they end, as a share of the ray.
const FRONTS: (f64, f64) = (0.33, 0.61);
/// Where on incident, reflected and refracted ray the fields stand, as shares of them: the first two apart, since at
/// normal incidence they lie on each other.
const FIELDS: [f64; 3] = [0.87, 0.72, 0.8];
/// Length of an electric field in the plane.
const FIELD: f64 = 0.19;
/// How many times its 1/e depth an evanescent wave is drawn.
const FADED: f64 = 3.0;
/// Heights of the lines of text in the corners.
const LINES: (f64, f64) = (0.95, 0.83);
/// The deepest that an evanescent wave is drawn.
const DEEPEST: f64 = 0.6;
/// Less than this share of the power is no reflected wave: what rounding leaves where the media are equal.
const NOTHING: f64 = 1e-20;

/// The arc between two directions [rad] at the origin, with its name where there is room for it.
fn arc(from: f64, to: f64, name: &str) -> Part {
    let arc = Part::arc([0.0; 2], ARC, from, to);
    if (to - from).abs() < NARROW { arc } else { arc.label(name) }
}

/// Interface, normal, three waves and their angles. x runs to the right and z down into the second medium, so that y
/// points at the reader.
pub(super) fn plot(setting: &Setting) -> Plot {
    let (n_i, n_t) = (setting.index("n_i").re, setting.index("n_t"));
    let scene = Scene::new(setting);
    let [wide, high] = WINDOW;
    let behind = if n_t.im >= METALLIC { Behind::Hatched } else { Behind::Tinted(depth(n_t.re)) };
    let diagram = Diagram::new("", [-wide, -high], [wide, high])
        .with(Part::surface([wide, 0.0], [-wide, 0.0], Behind::Tinted(depth(n_i))))
        .with(Part::surface([-wide, 0.0], [wide, 0.0], behind))
        .with(Part::line([0.0, EDGE - high], [0.0, high - EDGE]).dash(Dash::Dashed).hue(Hue::Reference).label("normal"))
        .with_all(scene.incident())
        .with_all(scene.reflected())
        .with_all(scene.behind())
        .with_all(scene.values());
    Plot::of("Three waves at an interface", diagram)
}

/// How dark a medium is drawn.
pub(super) fn depth(n: f64) -> f64 {
    if n > 1.0 { 1.0 - n.recip() } else { 0.0 }
}

fn short(n: f64) -> String {
    let rounded = (n * 1e3).round() / 1e3;
    if (1e-2..1e4).contains(&n.abs()) { format!("{rounded}") } else { format!("{n:.2e}") }
}

fn index(n: Complex64) -> String {
    if n.im == 0.0 { short(n.re) } else { format!("{} + {}i", short(n.re), short(n.im)) }
}

/// What the setting says of the three waves.
struct Scene {
    n_i: f64,
    n_t: Complex64,
    sin: f64,
    cos: f64,
    /// Share of natural light that is reflected.
    reflected: f64,
    /// Angle of incidence [rad].
    angle: f64,
    /// Wavelength in vacuum, in the drawing.
    wavelength: f64,
    /// Electric fields of incident, reflected and refracted wave where they count as positive, s and p.
    fields: [[Vector; 3]; 2],
    /// Normal wave number behind the interface over that of the vacuum.
    q_t: Complex64,
    /// Whether the wave behind the interface only fades.
    is_total: bool,
    /// 1/e depth of an evanescent field, in the drawing.
    depth: f64,
}

impl Scene {
    fn new(setting: &Setting) -> Self {
        let (n_i, n_t, incidence) = (setting.index("n_i").re, setting.index("n_t"), incidence(setting));
        let one = Complex64::ONE;
        let unit = Amplitudes { r_s: one, t_s: one, r_p: one, t_p: one };
        let fields = [Polarisation::S, Polarisation::P]
            .map(|polarisation| fields::waves(polarisation, incidence, n_i, n_t, &unit).map(|wave| wave.e));
        let q_t = outgoing_root(normal_squared(incidence, n_i, n_t));
        let wavelength = WAVELENGTH * (n_i.max(n_t.norm()) / DENSE).max(1.0);
        Self {
            n_i,
            n_t,
            sin: incidence.sin(),
            cos: incidence.cos(),
            angle: setting.number("theta"),
            reflected: fresnel::powers(incidence, n_i, n_t).r_n(),
            wavelength,
            fields,
            q_t,
            is_total: n_t.im == 0.0 && fresnel::refract(incidence, n_i, n_t.re).is_none(),
            depth: wavelength * fresnel::evanescent_depth(incidence, n_i, n_t.re),
        }
    }

    /// The angle of the refracted wave's direction [rad]; in an absorbing medium that of its planes of equal phase.
    fn refraction(&self) -> f64 {
        (self.n_i * self.sin).atan2(self.q_t.re)
    }

    /// Indices and angles, in the corners that no wave crosses.
    fn values(&self) -> [Part; 4] {
        let also = if self.reflected > NOTHING { " = θ_1′" } else { "" };
        let refraction = format!("θ_2 = {:.1}°", self.refraction().to_degrees());
        let lines = [
            format!("n_1 = {}", short(self.n_i)),
            format!("θ_1{also} = {:.1}°", self.angle.to_degrees()),
            format!("n_2 = {}", index(self.n_t)),
            if self.is_total { "total reflection".into() } else { refraction },
        ];
        let heights = [LINES.0, LINES.1, -LINES.1, -LINES.0];
        std::array::from_fn(|k| Part::note([EDGE - WINDOW[0], heights[k]], lines[k].as_str()))
    }

    fn incident(&self) -> Vec<Part> {
        let ray = Ray::new([-self.sin, self.cos], Hue::Natural);
        let mut parts = ray.fronts(self.wavelength / self.n_i);
        let head = 1.0 - HEAD / ray.length;
        parts.push(Part::ray_with_heads(ray.at(ray.length), [0.0; 2], &[head]).label("k_1"));
        parts.extend(ray.fields(&self.fields, 0, ["E_s", "E_p"]));
        parts.push(arc(FRAC_PI_2, FRAC_PI_2 + self.angle, "θ_1"));
        parts
    }

    fn reflected(&self) -> Vec<Part> {
        let ray = Ray::new([self.sin, self.cos], Hue::Natural);
        if self.reflected <= NOTHING {
            // Where it would run: equal media reflect nothing.
            return vec![ray.drawn().dash(Dash::Dotted).label("no reflected wave")];
        }
        let mut parts = ray.fronts(self.wavelength / self.n_i);
        parts.push(ray.drawn().label("k_1′"));
        parts.extend(ray.fields(&self.fields, 1, ["E_s′", "E_p′"]));
        parts.push(arc(FRAC_PI_2, FRAC_PI_2 - self.angle, "θ_1′"));
        parts
    }

    /// The refracted wave, or what is there instead of it.
    fn behind(&self) -> Vec<Part> {
        let tangential = self.n_i * self.sin;
        if self.is_total {
            return self.evanescent(tangential);
        }
        let wave_number = tangential.hypot(self.q_t.re);
        let ray = Ray::new([tangential / wave_number, -self.q_t.re / wave_number], Hue::Transmitted);
        let mut parts = ray.fronts(self.wavelength / wave_number);
        // In an absorbing medium it fades within its first wavelengths, and only the planes of phase have a direction.
        let (name, dash) = if self.n_t.im > 0.0 { ("Re k_2", Dash::Dashed) } else { ("k_2", Dash::Solid) };
        parts.push(ray.drawn().dash(dash).label(name));
        if self.n_t.im == 0.0 {
            parts.extend(ray.fields(&self.fields, 2, ["E_{s,2}", "E_{p,2}"]));
        }
        parts.push(arc(-FRAC_PI_2, self.refraction() - FRAC_PI_2, "θ_2").hue(Hue::Transmitted));
        parts
    }

    /// A wave that runs along the interface and fades away from it.
    fn evanescent(&self, tangential: f64) -> Vec<Part> {
        let deep = (FADED * self.depth).min(DEEPEST);
        let (start, end) = ([EDGE - WINDOW[0], -deep / 2.0], [WINDOW[0] - EDGE, -deep / 2.0]);
        let spacing = self.wavelength / tangential;
        // One of them stands at the origin, in step with the waves above.
        let first = (WINDOW[0] - EDGE) % spacing;
        let fronts = Part::new(Form::Wavefronts { from: start, to: end, first, spacing, sides: [deep / 2.0; 2] });
        let ray = Part::ray([EDGE, -deep / 2.0], [0.8 * WINDOW[0], -deep / 2.0]);
        vec![
            fronts.hue(Hue::Transmitted).dash(Dash::Dotted),
            ray.hue(Hue::Transmitted),
            Part::note([EDGE, -deep - EDGE], "evanescent wave").hue(Hue::Transmitted),
        ]
    }
}

/// A wave that runs between the origin and the edge of the window.
struct Ray {
    /// From the origin outwards.
    way: Spot,
    length: f64,
    hue: Hue,
}

impl Ray {
    fn new(way: Spot, hue: Hue) -> Self {
        let room = |k: usize| (WINDOW[k] - EDGE) / way[k].abs().max(1e-9);
        Self { way, length: room(0).min(room(1)).min(LONGEST), hue }
    }

    fn at(&self, distance: f64) -> Spot {
        [distance * self.way[0], distance * self.way[1]]
    }

    fn drawn(&self) -> Part {
        Part::ray([0.0; 2], self.at(self.length)).hue(self.hue)
    }

    /// Crests at whole wavelengths from the origin, where all three waves have one. None reaches through the interface.
    fn fronts(&self, spacing: f64) -> Vec<Part> {
        let first = spacing * (FRONTS.0 / spacing).ceil();
        let near = FRONT.min(first * self.way[1].abs() / self.way[0].abs().max(1e-9));
        let sides = if self.way[0] * self.way[1] < 0.0 { [near, FRONT] } else { [FRONT, near] };
        let (from, to) = ([0.0; 2], self.at(FRONTS.1 * self.length));
        vec![Part::new(Form::Wavefronts { from, to, first, spacing, sides }).hue(self.hue)]
    }

    /// The electric fields of s and p, each in its positive sense.
    fn fields(&self, fields: &[[Vector; 3]; 2], wave: usize, names: [&str; 2]) -> [Part; 2] {
        let [s, p] = [fields[0][wave], fields[1][wave]];
        let at = self.at(FIELDS[wave] * self.length);
        // z runs down.
        let tip = [at[0] + FIELD * p[0].re, at[1] - FIELD * p[2].re];
        [Part::vector(at, tip).hue(Hue::P).label(names[1]), Part::across(at, s[1].re > 0.0).hue(Hue::S).label(names[0])]
    }
}
