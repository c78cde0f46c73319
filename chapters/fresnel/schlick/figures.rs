//! What it looks like.

use super::super::{interface, over_angle, over_angle_near};
use super::GLASS_INDEX;
use crate::figure::{Axis, Chart, Hue, Map, Panel, Plot, Ramp};
use crate::parameter::Setting;
use light::Complex64;
use light::media;
use light::optics::Incidence;
use light::optics::fresnel::{critical_angle, powers};
use light::optics::schlick::{Dipped, normal_reflectance, schlick, schlick_rarer_side};
use std::f64::consts::FRAC_PI_2;

/// Relative indices shown, from a quarter to four.
const MAP_INDEX: (f64, f64) = (0.25, 4.0);
const MAP_COLUMNS: usize = 180;
const MAP_ROWS: usize = 120;

pub(super) fn error_map(_: &Setting) -> Plot {
    let plain = |cos_i: f64, n: f64| schlick(cos_i, normal_reflectance(1.0, n.into()));
    let rarer = |cos_i: f64, n: f64| schlick_rarer_side(cos_i, 1.0, n);
    Plot::grid(
        "Error of Schlick's approximation",
        2,
        vec![error_panel("with cos θ_1", plain), error_panel("with the rarer side's cosine", rarer)],
    )
}

fn error_panel(title: &str, approximate: impl Fn(f64, f64) -> f64) -> Panel {
    let mut values = Vec::with_capacity(MAP_COLUMNS * MAP_ROWS);
    for row in 0..MAP_ROWS {
        let up = (row as f64 + 0.5) / MAP_ROWS as f64;
        let n = MAP_INDEX.0 * (MAP_INDEX.1 / MAP_INDEX.0).powf(up);
        values.extend((0..MAP_COLUMNS).map(|column| {
            let theta = (column as f64 + 0.5) / MAP_COLUMNS as f64 * FRAC_PI_2;
            let incidence = Incidence::from_angle(theta);
            (approximate(incidence.cos(), n) - powers(incidence, 1.0, n.into()).r_n()).abs()
        }));
    }
    Map {
        title: title.into(),
        x: Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(30.0),
        y: Axis::log("n_2/n_1", "").range(MAP_INDEX.0, MAP_INDEX.1),
        colour: Axis::log("|ΔR|", "").range(1e-4, 1.0),
        ramp: Ramp::Sequential,
        columns: MAP_COLUMNS,
        values,
        marks: Vec::new(),
    }
    .into()
}

pub(super) fn curves(setting: &Setting) -> Plot {
    let own = interface(setting);
    let aluminium = media::named("aluminium").and_then(|metal| metal.index(800e-9).ok()).expect("a listed metal");
    let panels = vec![
        panel(&super::super::own_media(setting), own.n_i, own.n_t),
        panel("out of glass", GLASS_INDEX, 1.0.into()),
        panel("n 1 → 4", 1.0, 4.0.into()),
        panel("aluminium, 800 nm", 1.0, aluminium),
    ];
    Plot::grid("Exact and approximate reflectance", 2, panels)
}

fn panel(title: &str, n_i: f64, n_t: Complex64) -> Panel {
    let r_0 = normal_reflectance(n_i, n_t);
    let exact = move |incidence: Incidence| powers(incidence, n_i, n_t).r_n();
    let critical = if n_t.im == 0.0 { critical_angle(n_i, n_t.re) } else { None };
    let exact_curve = match critical {
        Some(critical) => over_angle_near(critical.to_degrees(), exact),
        None => over_angle(exact),
    };
    let least = if r_0 > 0.5 { 0.6 } else { -0.03 };
    let mut chart = Chart::new(
        title,
        Axis::linear("angle of incidence θ_1", "°").range(0.0, 90.0).tick(15.0),
        Axis::linear("reflectance R_n", "").range(least, 1.03),
    )
    .line(Hue::Natural, "exact", exact_curve)
    .dashed(Hue::Textbook, "Schlick", over_angle(|incidence| schlick(incidence.cos(), r_0)));
    if let Some(critical) = critical {
        let rarer = over_angle_near(critical.to_degrees(), |i| schlick_rarer_side(i.cos(), n_i, n_t.re));
        chart = chart.dashed(Hue::Ours, "Schlick, rarer side", rarer);
    }
    if n_t.im > 0.0 {
        let dipped = Dipped::new(r_0, exact(Incidence::from_cos(Dipped::COS)));
        chart = chart.dashed(Hue::Ours, "with a dip at 82°", over_angle(|i| dipped.reflectance(i.cos())));
    }
    chart.into()
}
