//! Coatings, mirrors and tunnels over wavelength, angle and gap.

use super::extremes::between;
use super::{Films, film, mirror};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Axis, Chart, Hue, Map, Plot, Ramp};
use crate::parameter::{DEFAULT_WAVELENGTH, Setting};
use light::Polarisation;
use light::media::{self, Medium};
use light::optics::film::Layer;
use light::optics::{Direction, Incidence};
use std::f64::consts::FRAC_PI_2;

/// Coatings of the setting's substrate, of real media, each film a quarter of 550 nm thick; the third has a half wave of
/// titania between the other two, which does nothing at the centre and widens the band.
pub(super) fn antireflection(setting: &Setting) -> Plot {
    let designs: [(&str, &[(&str, f64)]); 4] = [
        ("bare", &[]),
        ("MgF_2", &[("mgf2", 1.0)]),
        ("MgF_2, Al_2O_3", &[("mgf2", 1.0), ("sapphire", 1.0)]),
        ("MgF_2, 2 TiO_2, Al_2O_3", &[("mgf2", 1.0), ("tio2", 2.0), ("sapphire", 1.0)]),
    ];
    let curves = designs.map(|(label, coats)| {
        let curve = (0..=175).map(|step| 400.0 + 2.0 * f64::from(step)).map(|nanometres| {
            let films = coated(setting, coats, nanometres * 1e-9);
            let reflectance = films.map(|films| films.natural(nanometres * 1e-9, Incidence::NORMAL));
            [nanometres, reflectance.unwrap_or(f64::NAN)]
        });
        (label, curve.collect::<Vec<_>>())
    });
    let most = curves[0].1.iter().map(|point| point[1]).filter(|r| r.is_finite()).fold(0.01, f64::max);
    let axes = Chart::new(
        format!("on {}; each a quarter of 550 nm thick, 2 TiO_2 a half", substrate(setting)),
        Axis::linear("vacuum wavelength λ", "nm").range(400.0, 750.0).tick(50.0),
        Axis::linear("reflectance R", "").range(0.0, 1.1 * most),
    );
    let hues = (0..).map(Hue::Nth);
    let chart = curves.into_iter().zip(hues).fold(axes, |chart, ((label, curve), hue)| chart.line(hue, label, curve));
    Plot::of("Antireflection coatings", chart)
}

/// `glass`, or `n = 1.52`: what the films lie on.
fn substrate(setting: &Setting) -> String {
    let name = setting.text("n_s");
    if name.starts_with(char::is_alphabetic) { name.into() } else { format!("n = {name}") }
}

/// The setting's substrate under films of the named materials, `quarters` quarter waves of 550 nm thick.
fn coated(setting: &Setting, coats: &[(&str, f64)], wavelength: f64) -> Option<Films> {
    let layers = coats.iter().map(|&(name, quarters)| {
        let medium = Medium::Named(media::named(name)?);
        let design = medium.index(DEFAULT_WAVELENGTH).ok()?.re;
        Some(Layer { index: medium.index(wavelength).ok()?, thickness: quarters * DEFAULT_WAVELENGTH / (4.0 * design) })
    });
    let substrate = setting.medium("n_s").index(wavelength).ok()?;
    let n_i = setting.medium("n_i").index(wavelength).ok()?.re;
    Some(Films { n_i, layers: layers.collect::<Option<_>>()?, substrate })
}

/// Wavelengths [m] about the setting's, as far as its mirror's first band reaches.
const BAND: (f64, f64) = (0.7, 1.4);

pub(super) fn mirror_band(setting: &Setting) -> Plot {
    let design = setting.wavelength();
    let oblique = crate::fresnel::incidence(setting);
    let curve = |value: &dyn Fn(&Films, f64) -> f64| -> Vec<[f64; 2]> {
        let steps = (0..=700).map(|step| design * (BAND.0 + (BAND.1 - BAND.0) * f64::from(step) / 700.0));
        let reflectance = |wavelength| mirror(setting, wavelength).map_or(f64::NAN, |films| value(&films, wavelength));
        steps.map(|wavelength| [wavelength * 1e9, reflectance(wavelength)]).collect()
    };
    let polarised = |polarisation| {
        curve(&move |films: &Films, wavelength| films.stack().response(wavelength, oblique, polarisation).reflectance)
    };
    let degrees = setting.number("theta").to_degrees();
    let chart = Chart::new(
        "",
        Axis::linear("vacuum wavelength λ", "nm").range(design * BAND.0 * 1e9, design * BAND.1 * 1e9),
        Axis::share("reflectance R"),
    )
    .line(Hue::Natural, "θ_1 = 0°", curve(&|films, wavelength| films.natural(wavelength, Incidence::NORMAL)))
    .line(Hue::S, format!("R_s, θ_1 = {degrees:.0}°"), polarised(Polarisation::S))
    .line(Hue::P, format!("R_p, θ_1 = {degrees:.0}°"), polarised(Polarisation::P));
    Plot::of(format!("A mirror of {} films", 2 * setting.number("pairs").round() as usize + 1), chart)
}

const MAP_COLUMNS: usize = 160;
const MAP_ROWS: usize = 90;

pub(super) fn mirror_map(setting: &Setting) -> Plot {
    let design = setting.wavelength();
    let stacks: Vec<_> = (0..MAP_COLUMNS)
        .map(|column| {
            let across = (column as f64 + 0.5) / MAP_COLUMNS as f64;
            let wavelength = design * (BAND.0 + (BAND.1 - BAND.0) * across);
            (wavelength, mirror(setting, wavelength))
        })
        .collect();
    let mut values = Vec::with_capacity(MAP_COLUMNS * MAP_ROWS);
    for row in 0..MAP_ROWS {
        let incidence = Incidence::from_angle((row as f64 + 0.5) / MAP_ROWS as f64 * FRAC_PI_2);
        values.extend(
            stacks.iter().map(|(wavelength, films)| {
                films.as_ref().map_or(f64::NAN, |films| films.natural(*wavelength, incidence))
            }),
        );
    }
    let map = Map {
        title: String::new(),
        x: Axis::linear("vacuum wavelength λ", "nm").range(design * BAND.0 * 1e9, design * BAND.1 * 1e9),
        y: Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(30.0),
        colour: Axis::linear("reflectance R_n", "").range(0.0, 1.0),
        ramp: Ramp::Sequential,
        columns: MAP_COLUMNS,
        values,
        marks: Vec::new(),
    };
    Plot::of("The mirror over wavelength and angle", map)
}

pub(super) fn frustrated(_: &Setting) -> Plot {
    let mut chart = Chart::new(
        "n 1.5 → air gap → 1.5",
        Axis::log("gap over wavelength d/λ", "").range(1e-2, 1e1),
        Axis::log("transmittance T", "").range(1e-12, 1.0),
    );
    for (place, degrees) in (0..).zip([45.0f64, 60.0, 75.0]) {
        let incidence = Incidence::from(Direction::Angle(degrees.to_radians()));
        let curve = |polarisation| -> Vec<[f64; 2]> {
            let gaps = (0..=240).map(|step| 10f64.powf(f64::from(step) / 80.0 - 2.0));
            let through = |gap: f64| {
                let films = between(1.5, film(1.0, 0.0, gap * DEFAULT_WAVELENGTH), 1.5);
                films.stack().response(DEFAULT_WAVELENGTH, incidence, polarisation).transmittance
            };
            gaps.map(|gap| [gap, through(gap)]).collect()
        };
        chart = chart.line(Hue::Nth(place), format!("s, {degrees:.0}°"), curve(Polarisation::S)).dashed(
            Hue::Nth(place),
            format!("p, {degrees:.0}°"),
            curve(Polarisation::P),
        );
    }
    Plot::of("Frustrated total reflection", chart)
}

/// A film and the first of the ways through it.
pub(super) fn bounces(_: &Setting) -> Plot {
    let (depth, step, slant) = (0.75, 0.5, 0.95);
    let [top, bottom] = [0.0, -depth];
    let mut diagram = Diagram::new("", [-1.3, -1.55], [2.7, 1.1])
        .with(Part::surface([-1.3, top], [2.7, top], Behind::Tinted(0.25)))
        .with(Part::surface([-1.3, bottom], [2.7, bottom], Behind::Tinted(0.45)))
        .with(Part::ray_with_heads([-slant, 1.0], [0.0, top], &[0.6]).label("1"))
        .with(Part::note([-1.2, 0.12], "n_1"))
        .with(Part::note([-1.2, -0.4], "n_2"))
        .with(Part::note([-1.2, -1.2], "n_3"));
    let out = ["r_{12}", "t_{12}r_{23}t_{21}e^{2iδ}", "… r_{21}r_{23}e^{2iδ}"];
    let through = ["t_{12}t_{23}e^{iδ}", "… r_{21}r_{23}e^{2iδ}"];
    for (bounce, label) in out.into_iter().enumerate() {
        let at = [2.0 * step * bounce as f64, top];
        let up = Part::ray_with_heads(at, [at[0] + 0.8 * slant, 0.8], &[0.7]);
        diagram = diagram.with(up.hue(Hue::Ours).label(label));
    }
    for (bounce, label) in through.into_iter().enumerate() {
        let (start, turn) = (2.0 * step * bounce as f64, 2.0 * step * bounce as f64 + step);
        diagram = diagram
            .with(Part::ray_with_heads([start, top], [turn, bottom], &[0.55]))
            .with(Part::ray_with_heads([turn, bottom], [turn + step, top], &[0.55]))
            .with(Part::ray_with_heads([turn, bottom], [turn + 0.45, -1.4], &[0.7]).hue(Hue::Transmitted).label(label));
    }
    Plot::of("Every bounce between the faces", diagram)
}
