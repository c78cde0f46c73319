//! Figures such as the chapters make, for looking at and for the tests.

use chapters::diagram::{Behind, Diagram, Form, Part};
use chapters::figure::*;

/// R_s, R_p, R_n of glass against angle.
pub fn reflectance() -> Plot {
    let curve = |power: fn(f64, f64) -> f64| {
        (0..=360).map(|k| f64::from(k) / 4.0).map(|deg| [deg, power(deg.to_radians(), 1.5)]).collect::<Vec<_>>()
    };
    let brewster = 1.5f64.atan().to_degrees();
    Plot::of(
        "Glass in air: what is reflected",
        Chart::new(
            "",
            Axis::linear("angle of incidence θ_i", "°").range(0.0, 90.0).tick(15.0),
            Axis::linear("reflectance R", "").range(0.0, 1.0),
        )
        .line(Hue::S, "R_s", curve(|t, n| amplitudes(t, n).0.powi(2)))
        .line(Hue::P, "R_p", curve(|t, n| amplitudes(t, n).1.powi(2)))
        .dashed(
            Hue::Natural,
            "R_n = ½ (R_s + R_p)",
            curve(|t, n| {
                let (s, p) = amplitudes(t, n);
                0.5 * (s * s + p * p)
            }),
        )
        .at_x(brewster, "θ_B = 56.31°"),
    )
}

fn amplitudes(theta: f64, n: f64) -> (f64, f64) {
    let (cos_i, sin_t) = (theta.cos(), theta.sin() / n);
    let cos_t = (1.0 - sin_t * sin_t).sqrt();
    ((cos_i - n * cos_t) / (cos_i + n * cos_t), (n * cos_i - cos_t) / (n * cos_i + cos_t))
}

/// Error against run time of six methods.
pub fn race() -> Plot {
    let shapes = [Shape::Disc, Shape::Square, Shape::Triangle, Shape::Diamond, Shape::Cross, Shape::Ring];
    let names = ["midpoint rule", "Gauss–Legendre", "Monte Carlo", "Sobol’ points", "adaptive Simpson", "closed form"];
    let orders = [-2.0, -6.0, -0.5, -1.0, -4.0, 0.0];
    let mut chart = Chart::new("", Axis::log("time", "s"), Axis::log("relative error", ""));
    for (k, ((shape, name), order)) in shapes.into_iter().zip(names).zip(orders).enumerate() {
        let points: Vec<[f64; 2]> = (0..9)
            .map(|j| {
                let work = 2f64.powi(j) * (1.0 + 0.4 * k as f64);
                [work * 3e-8, (0.2 * work.powf(order) * (1.0 + 0.3 * (j as f64 * 2.3 + k as f64).sin())).max(2.2e-16)]
            })
            .collect();
        chart = chart.with(Mark::Points { label: name.into(), hue: Hue::Nth(k as u8), shape, joined: true, points });
    }
    let slope = (0..2).map(|k| [10f64.powi(-7 + 2 * k), 10f64.powi(-1 - k)]).collect();
    let chart =
        chart.with(Mark::Line { label: "slope −½".into(), hue: Hue::Reference, dash: Dash::Dotted, points: slope });
    Plot::of("Mean reflectance of a rough sea: error against time", chart.at_y(f64::EPSILON, "ulp"))
}

/// Digits lost over two log axes, with places where nothing is left.
pub fn digits() -> Plot {
    let (columns, rows) = (160, 110);
    let values = (0..rows).flat_map(|row| {
        (0..columns).map(move |column| {
            let (x, y) = (column as f64 / columns as f64, row as f64 / rows as f64);
            if x + 1.2 * y > 1.75 {
                f64::NAN
            } else {
                (16.0 * x * y + (37.0 * x).sin() * (23.0 * y).cos() * 0.6).clamp(0.0, 16.0)
            }
        })
    });
    let map = |title: &str| Map {
        title: title.into(),
        x: Axis::log("n_t/n_i − 1", "").range(1e-15, 1e3),
        y: Axis::log("90° − θ_i", "rad").range(1e-16, 1.0),
        colour: Axis::linear("digits lost", "").range(0.0, 16.0),
        ramp: Ramp::Sequential,
        columns,
        values: values.clone().collect(),
        marks: vec![
            Mark::Line {
                label: "r_p = 0".into(),
                hue: Hue::P,
                dash: Dash::Solid,
                points: vec![[1e-15, 1e-2], [1e-3, 0.2], [1e3, 1e-3]],
            },
            Mark::AtX { x: 1e-8, label: "√ε".into() },
            Mark::AtY { y: 1e-8, label: "half the digits".into() },
        ],
    };
    Plot::of("Digits lost by the textbook form of R_p", map(""))
}

/// Signed error of an approximation over angle and index, in two colours.
pub fn signed() -> Map {
    let (columns, rows) = (90, 70);
    let value = |row: usize, column: usize| {
        let (theta, n) = ((column as f64 + 0.5) * 90.0 / 90.0, 1.05 + row as f64 * 0.04);
        let (s, p) = amplitudes(theta.to_radians(), n);
        let normal = ((n - 1.0) / (n + 1.0)).powi(2);
        normal + (1.0 - normal) * (1.0 - theta.to_radians().cos()).powi(5) - 0.5 * (s * s + p * p)
    };
    Map {
        title: "Schlick’s R minus the exact R_n".into(),
        x: Axis::linear("θ_i", "°").range(0.0, 90.0).tick(30.0),
        y: Axis::linear("n_t", "").range(1.05, 3.85),
        colour: Axis::linear("error", "").range(-0.15, 0.15),
        ramp: Ramp::Diverging,
        columns,
        values: (0..rows).flat_map(|row| (0..columns).map(move |column| value(row, column))).collect(),
        marks: Vec::new(),
    }
}

/// Four panels of different kinds.
pub fn grid() -> Plot {
    let wave = |phase: f64, damp: f64| -> Vec<[f64; 2]> {
        (0..=400).map(|k| f64::from(k) / 100.0).map(|z| [z, (-damp * z).exp() * (6.0 * z - phase).cos()]).collect()
    };
    let waves = Chart::new("A damped wave", Axis::linear("depth z/δ", ""), Axis::linear("field", "V/m"))
        .line(Hue::Nth(0), "E", wave(0.0, 1.0))
        .line(Hue::Nth(1), "H · Z_0", wave(0.785, 1.0))
        .at_y(0.0, "");
    let spectrum: Vec<[f64; 2]> = (0..=300)
        .map(|k| 380.0 + f64::from(k) * 1.5)
        .map(|nm| [nm * 1e-9, 0.99 / (1.0 + (-(nm - 480.0) / 12.0).exp()) + 1e-3 * (nm / 9.0).sin()])
        .collect();
    let mirror = Chart::new("A stack of 21 films", Axis::linear("wavelength λ", "m"), Axis::linear("R", ""))
        .line(Hue::Natural, "R", spectrum)
        .at_x(5.32e-7, "532 nm")
        .at_x(5.50e-7, "550 nm");
    let noise = (0..2000).map(|k| [10f64.powf(f64::from(k) / 500.0), 1e-16 * f64::from(1 + k * 7919 % 97)]).collect();
    let dots = Chart::new("Rounding", Axis::log("n", ""), Axis::log("error", ""))
        .with(Mark::Points {
            label: "2000 samples".into(),
            hue: Hue::Ours,
            shape: Shape::Disc,
            joined: false,
            points: noise,
        })
        .at_y(1.1e-16, "½ ε");
    Plot::grid("Four panels", 2, vec![waves.into(), mirror.into(), dots.into(), signed().into()])
}

/// Two shaded spheres.
pub fn spheres() -> Plot {
    let sphere = |n: f64, side: usize| {
        let pixel = |k: usize| {
            let (x, y) = ((k % side) as f32 / side as f32 * 2.1 - 1.05, (k / side) as f32 / side as f32 * 2.1 - 1.05);
            let z2 = 1.0 - x * x - y * y;
            if z2 <= 0.0 {
                return [0.85, 0.87, 0.9];
            }
            let (s, p) = amplitudes(f64::from(z2.sqrt()).acos(), n);
            let r = (0.5 * (s * s + p * p)) as f32;
            [r + 0.05 * (1.0 - y), r + 0.06 * (1.0 - y), r + 0.1 * (1.0 - y)]
        };
        Picture {
            title: format!("n_t = {n}: bright only at the rim, as the mirror image takes over"),
            width: side,
            pixels: (0..side * side).map(pixel).collect(),
        }
    };
    Plot::grid(
        "A sphere of glass and one of diamond",
        2,
        vec![Panel::Picture(sphere(1.5, 256)), Panel::Picture(sphere(2.42, 100))],
    )
}

/// Five curves that cross all over the frame, with names that need more than one row.
pub fn metals() -> Plot {
    let curve = |edge: f64, low: f64, high: f64| -> Vec<[f64; 2]> {
        let step = |nm: f64| low + (high - low) / (1.0 + (-(nm - edge) / 18.0).exp());
        (0..=200).map(|k| 380.0 + 2.0 * f64::from(k)).map(|nm| [nm, step(nm)]).collect()
    };
    let chart = Chart::new(
        "",
        Axis::linear("wavelength in vacuum λ", "nm"),
        Axis::linear("reflectance at normal incidence", "").range(0.0, 1.0),
    )
    .line(Hue::Nth(0), "silver", curve(330.0, 0.1, 0.97))
    .line(Hue::Nth(1), "gold", curve(510.0, 0.36, 0.96))
    .line(Hue::Nth(2), "copper", curve(565.0, 0.48, 0.93))
    .line(Hue::Nth(3), "chromium (Johnson and Christy)", curve(700.0, 0.68, 0.62))
    .line(Hue::Nth(4), "aluminium", curve(820.0, 0.92, 0.70))
    .dashed(
        Hue::Nth(5),
        "glass, rising",
        (0..=20).map(|k| [380.0 + 20.0 * f64::from(k), 0.02 + 0.045 * f64::from(k)]).collect(),
    )
    .at_x(532.0, "frequency-doubled Nd:YAG")
    .at_x(543.5, "green He–Ne")
    .at_x(632.8, "He–Ne")
    .at_y(0.04, "window glass")
    .at_y(0.5, "one half");
    Plot::of("How metals reflect over the visible: where each takes its colour from, and why glass has none", chart)
}

/// Three panels: phases, a narrow logarithmic axis, and an axis far from zero.
pub fn row() -> Plot {
    let phase = |n: f64| -> Vec<[f64; 2]> {
        let sin_c = 1.0 / n;
        (0..=900)
            .map(|k| f64::from(k) / 10.0)
            .map(|deg| {
                let (sin, cos) = deg.to_radians().sin_cos();
                let root = sin * sin - sin_c * sin_c;
                [deg, if root < 0.0 { f64::NAN } else { -2.0 * (root.sqrt() / cos).atan().to_degrees() }]
            })
            .collect()
    };
    let phases = Chart::new(
        "Phase under total reflection",
        Axis::linear("θ_i", "°").range(0.0, 90.0).tick(30.0),
        Axis::linear("arg r", "°").range(-180.0, 0.0).tick(45.0),
    )
    .line(Hue::S, "r_s", phase(1.5))
    .line(Hue::P, "r_p", phase(1.9))
    .at_x(41.81, "θ_c");
    let narrow = Chart::new("A narrow range", Axis::log("x", "m"), Axis::log("f(x)", ""))
        .with(Mark::Points {
            label: "measured".into(),
            hue: Hue::Ours,
            shape: Shape::Ring,
            joined: true,
            points: (1..9).map(|k| [f64::from(k), 1.2 + 0.1 * f64::from(k)]).collect(),
        })
        .line(Hue::Reference, "fit", (1..9).map(|k| [f64::from(k), 1.1 + 0.11 * f64::from(k)]).collect());
    let far = Chart::new("Far from zero", Axis::linear("n", ""), Axis::linear("c", "m/s")).with(Mark::Points {
        label: String::new(),
        hue: Hue::Textbook,
        shape: Shape::Diamond,
        joined: false,
        points: (0..8).map(|k| [f64::from(k), 299_792_458.0 + f64::from(k * k)]).collect(),
    });
    Plot::grid("", 3, vec![phases.into(), narrow.into(), far.into()])
}

/// A microfacet before a wall, with one part of every form.
pub fn facet() -> Plot {
    let (tilt, out) = (0.35f64, 1.1f64);
    let way = |angle: f64, length: f64| [length * angle.sin(), length * angle.cos()];
    let dune = (0..=120).map(|k| -1.4 + f64::from(k) / 42.0).map(|x| [x, -0.55 + 0.06 * (9.0 * x).sin()]).collect();
    let diagram = Diagram::new("One facet of a rough surface", [-1.5, -0.8], [1.5, 1.1])
        .with(Part::surface([1.4, 1.0], [1.4, -0.8], Behind::Nothing).dash(Dash::Dashed).label("wall"))
        .with(Part::surface(way(tilt - 1.571, 0.7), way(tilt + 1.571, 0.7), Behind::Hatched).label("facet"))
        .with(Part::surface([-1.5, -0.7], [1.5, -0.7], Behind::Tinted(0.7)))
        .with(Part::curve(dune).hue(Hue::Nth(6)).label("height h(x)"))
        .with(Part::line([0.0, 0.0], [0.0, 1.0]).dash(Dash::Dotted).hue(Hue::Reference).label("n"))
        .with(Part::ray_with_heads([0.0, 0.0], way(out, 1.2), &[0.4, 0.7, 1.0]).hue(Hue::S).label("ω_o"))
        .with(Part::ray([0.0, 0.0], way(2.0 * tilt - out, 0.95)).hue(Hue::P).label("ω_i"))
        .with(Part::vector([0.0, 0.0], way(tilt, 0.5)).label("m"))
        .with(Part::new(Form::Wavefronts {
            from: [0.0, 0.0],
            to: way(2.0 * tilt - out, 0.9),
            first: 0.45,
            spacing: 0.1,
            sides: [0.08, 0.08],
        }))
        .with(Part::arc([0.0, 0.0], 0.3, 1.571, 1.571 - tilt).label("θ_m"))
        .with(Part::arc([0.0, 0.0], 0.45, 1.571, 1.571 - out).hue(Hue::S).label("θ_o"))
        .with(Part::across([-1.2, 0.6], false).hue(Hue::Transmitted).label("H"))
        .with(Part::across([-1.2, 0.2], true).hue(Hue::Ours).label("E"))
        .with(Part::point(way(out, 1.2)).label("eye"))
        .with(Part::note([-1.4, -0.74], "the mean plane"))
        .explain(Hue::S, Dash::Solid, "seen")
        .explain(Hue::P, Dash::Solid, "lit");
    Plot::of("Where a rough surface mirrors", diagram)
}

/// Every figure with its file name.
pub fn all() -> Vec<(&'static str, Plot)> {
    vec![
        ("reflectance", reflectance()),
        ("race", race()),
        ("digits", digits()),
        ("grid", grid()),
        ("spheres", spheres()),
        ("metals", metals()),
        ("row", row()),
        ("facet", facet()),
    ]
}
