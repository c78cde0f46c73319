//! C17: the energy that one bounce loses, and how it is given back.

use super::facets::{KINDS, name};
use super::lambert::local;
use super::mirror::display;
use super::models::{ALPHA, METAL, SLOPES, THETA, made_from, metal, model, way};
use super::sampling::energy as mean_weight;
use crate::figure::{Axis, Chart, Hue, Map, Panel, Picture, Plot, Ramp};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Heat, Judge, Measured, Misled, Quantity, Race, Step, check, excess, exhibit, figure,
    lane, question, race, statement, step,
};
use equation::Equation;
use equation::expr::{Range, cos, integral};
use light::bsdf::albedo::{Rule, albedo};
use light::bsdf::microfacet::{Beckmann, Distribution, Ggx, Slopes};
use light::bsdf::{self, Bsdf};
use light::number::Vector;
use std::f64::consts::FRAC_PI_2;
use yardstick::directions::Points;
use yardstick::random::stream;
use yardstick::statistics::t_test;

use super::symbols::{F_R, L_IN, L_R, OMEGA_I, THETA_I};

pub(super) const EXHIBIT: Exhibit = exhibit(
    "energy",
    &[SLOPES, ALPHA, METAL, THETA],
    &[
        figure(
            "albedo",
            "What white rough metal returns at one bounce, over angle and roughness; and with its losses given back.",
            albedos,
        ),
        figure(
            "furnace",
            "White balls in a white room: what can be seen of them is energy that was lost, or, faintly, the noise of 16 directions a pixel.",
            furnace,
        ),
        figure(
            "colour",
            "Rough metal, one bounce, compensated and walked: the lobe that gives back what was lost guesses its colour.",
            colour,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "What one bounce loses",
    "Light that meets a second facet is lost to a model of one bounce, up to seven tenths of it; a second lobe gives it back.",
)
.rows(&["C17"])
.statements(&[statement("room", "in a room of one radiance L_in: what is seen of the surface", || {
    Equation::new(L_R, L_IN * integral(F_R * cos(THETA_I), [OMEGA_I.into()], Range::Whole))
})])
.questions(&[question(
    "how_much",
    "White metal of roughness α = 1 (GGX), seen along its normal. Which share of the light does one bounce lose?",
    Answer::Number {
        unit: "1",
        tolerance: 0.1,
        right: |_| 1.0 - albedo(Slopes::Ggx, 1.0, 1.0),
        slips: &[
            Misled { value: |_| 0.0, reply: "Energy is conserved by the surface, not by a model that follows one bounce." },
            Misled { value: |_| 0.1, reply: "That is what α = 0.3 loses." },
        ],
    },
    "More than two thirds: on so rough a surface most light meets another facet.",
)])
.readout(|setting| {
    let (of, wo) = (made_from(setting), way(setting.number("theta").min(FRAC_PI_2 - 1e-6), 0.0));
    let mean = |name: &str| mean_weight(model(name, &of).as_ref(), wo, 20_000, "brdf/energy/readout").mean();
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "1" };
    let (single, given_back, walked) = (mean("rough-conductor"), mean("conductor-compensated"), mean("conductor-walk"));
    vec![
        quantity("lost", "1 − E", "lost by white metal at one bounce", 1.0 - albedo(of.slopes, of.alpha[0], wo.z)),
        quantity("single", "E_1", "returned by the metal set, red: one bounce", single),
        quantity("compensated", "E_c", "with its losses given back", given_back),
        quantity("walk", "E_w", "every bounce walked", walked),
        quantity("colour", "E_c − E_w", "what the compensation gets wrong, and the noise of 20 000 walks", given_back - walked),
    ]
})
.checks(&[&QUADRATURE, &LOST, &WHITE, &WALK, &COLOUR])
.races(&[ALBEDO]);

/// What white rough metal returns at one bounce [1]: kind of slopes, α, cos θ.
type Albedo = fn(Slopes, f64, f64) -> f64;

const QUADRATURE: Check<Albedo> =
    check("quadrature", "the albedo by 4096 nodes keeps eight digits from α = 10⁻³ on, and to grazing")
        .against("1 − ln 2 of GGX at α = 1 along the normal, and for the rest rules of 160 nodes each way")
        .within(1e-8, "1", "what the program promises of it")
        .of(
            |_: &mut Bench, program: Albedo| {
                let cases = KINDS.into_iter().flat_map(|slopes| {
                    [1e-3, 0.05, 0.3, 1.0]
                        .into_iter()
                        .flat_map(move |alpha| [1.0, 0.5, 0.1, 0.01].map(|cos| (slopes, alpha, cos)))
                });
                Measured::worst(cases.map(|(slopes, alpha, cos)| {
                    let exact = match slopes {
                        Slopes::Ggx if alpha == 1.0 && cos == 1.0 => 1.0 - std::f64::consts::LN_2,
                        Slopes::Ggx => Rule::new(&Ggx::new([alpha; 2]), 160, 160).albedo(cos, |_| 1.0),
                        Slopes::Beckmann => Rule::new(&Beckmann::new([alpha; 2]), 160, 160).albedo(cos, |_| 1.0),
                    };
                    (program(slopes, alpha, cos) - exact, format!("{}, α = {alpha}, cos θ = {cos}", name(slopes)))
                }))
            },
            albedo as Albedo,
        )
        .slip("a quarter of the nodes each way", |slopes, alpha, cos| match slopes {
            Slopes::Ggx => Rule::new(&Ggx::new([alpha; 2]), 16, 16).albedo(cos, |_| 1.0),
            Slopes::Beckmann => Rule::new(&Beckmann::new([alpha; 2]), 16, 16).albedo(cos, |_| 1.0),
        });

const LOST: Check<Albedo> = check("lost", "what one bounce returns is the mean weight of its own draws")
    .against("the mean of 40 000 weights a view (Student's t, the worst of 12 views as one of a family)")
    .significant(1e-3)
    .of(
        |_: &mut Bench, program: Albedo| {
            let cases: Vec<_> = KINDS
                .into_iter()
                .flat_map(|slopes| {
                    [0.3, 0.6, 1.0].into_iter().flat_map(move |alpha| [0.5, 0.05].map(|cos| (slopes, alpha, cos)))
                })
                .collect();
            let count = cases.len();
            let worst = cases.into_iter().map(|(slopes, alpha, cos)| {
                let of = bsdf::Setting { alpha: [alpha; 2], slopes, ..bsdf::Setting::default() };
                let place = format!("{}, α = {alpha}, cos θ = {cos}", name(slopes));
                let found =
                    mean_weight(model("rough-conductor", &of).as_ref(), way(f64::acos(cos), 0.6), 40_000, &place);
                (t_test(&found, program(slopes, alpha, cos)).p, place)
            });
            let (p, at) = worst.min_by(|one, other| one.0.total_cmp(&other.0)).unwrap_or((f64::NAN, String::new()));
            Measured::new(yardstick::statistics::family(p, count), at, count)
        },
        albedo as Albedo,
    )
    .slip("nothing is lost", |_, _, _| 1.0);

const WHITE: Check<fn(&str) -> &str> = check(
    "white",
    "in a white room compensated white metal and glass of any roughness cannot be seen",
)
.against(
    "1, against the mean of 20 000 weights for views outside and inside: by how many standard errors it is off beyond \
         the 10⁻³ that tables may be",
)
.within(4.0, "σ", "four standard errors: once in 16 000 by chance, for each of ten views")
.of(
    |_: &mut Bench, which: fn(&str) -> &str| {
        let metals =
            [0.1, 0.5, 1.0].into_iter().flat_map(|alpha| [0.9, 0.2].map(|cos| ("conductor-compensated", alpha, cos)));
        let glasses =
            [0.3, 1.0].into_iter().flat_map(|alpha| [0.9, -0.3].map(|cos| ("dielectric-compensated", alpha, cos)));
        Measured::worst(metals.chain(glasses).map(|(name, alpha, cos)| {
            let of = bsdf::Setting { alpha: [alpha; 2], ..bsdf::Setting::default() };
            let place = format!("{name}, α = {alpha}, cos θ = {cos}");
            let found = mean_weight(model(which(name), &of).as_ref(), way(f64::acos(cos), 0.6), 20_000, &place);
            let beyond = excess((found.mean() - 1.0).abs() - 1e-3);
            (beyond / found.standard_error().max(1e-9), place)
        }))
    },
    |name| name,
)
.slip("one bounce", |name| if name.starts_with("cond") { "rough-conductor" } else { "rough-dielectric" });

const WALK: Check<fn(&str) -> &str> =
    check("walk", "the walk loses nothing, on metal and on glass, from outside and from inside")
        .against("1, the weight that every single walk must have on white metal and on glass")
        .within(1e-6, "1", "one walk in 10⁹ is cut; a product of ones")
        .of(
            |_: &mut Bench, which: fn(&str) -> &str| {
                let metals =
                    [0.1, 1.0].into_iter().flat_map(|alpha| [0.95, 0.05].map(|cos| ("conductor-walk", alpha, cos)));
                let glasses =
                    [0.1, 1.0].into_iter().flat_map(|alpha| [0.9, -0.5].map(|cos| ("dielectric-walk", alpha, cos)));
                Measured::worst(metals.chain(glasses).map(|(name, alpha, cos)| {
                    let of = bsdf::Setting { alpha: [alpha; 2], ..bsdf::Setting::default() };
                    let place = format!("{name}, α = {alpha}, cos θ = {cos}");
                    let found = mean_weight(model(which(name), &of).as_ref(), way(f64::acos(cos), 0.6), 4000, &place);
                    (found.mean() - 1.0, place)
                }))
            },
            |name| name,
        )
        .slip("one bounce", |name| if name.starts_with("cond") { "rough-conductor" } else { "rough-dielectric" });

const COLOUR: Check<fn(&str) -> &str> =
    check("colours", "the compensation is within a few per cent of the walk's colour")
        .against("the walk's mean over 20 000, for gold in three channels")
        .within(
            0.06,
            "1",
            "a tenth of the light that bounces again, which is up to 0.6 of all: the second lobe guesses its colour",
        )
        .of(
            |_: &mut Bench, which: fn(&str) -> &str| {
                let cases = [(0.5, 0.8), (1.0, 0.95), (1.0, 0.4)].into_iter();
                Measured::worst(cases.flat_map(|(alpha, cos)| {
                    let gold = metal("gold");
                    let wo = way(f64::acos(cos), 0.6);
                    (0..3).map(move |channel| {
                        let of =
                            bsdf::Setting { alpha: [alpha; 2], metal: [gold[channel]; 3], ..bsdf::Setting::default() };
                        let place = format!("α = {alpha}, cos θ = {cos}, channel {channel}");
                        let mean = |name: &str| mean_weight(model(name, &of).as_ref(), wo, 20_000, &place).mean();
                        (mean(which("conductor-compensated")) - mean("conductor-walk"), place)
                    })
                }))
            },
            |name| name,
        )
        .slip("one bounce", |_| "rough-conductor");

/// α and cos θ of the race.
const RACED: (f64, f64) = (0.3, 0.3);

/// The error of an albedo.
fn wrong() -> Judge {
    let exact = Rule::new(&Ggx::new([RACED.0; 2]), 200, 200).albedo(RACED.1, |_| 1.0);
    Box::new(move |found| (found[0] - exact).abs())
}

fn by_points(bench: &mut Bench, work: u64, points: Points) -> Heat {
    let points = points.draw(work as usize, &mut bench.stream);
    let of = bsdf::Setting { alpha: [RACED.0; 2], ..bsdf::Setting::default() };
    let (surface, wo) = (model("rough-conductor", &of), way(RACED.1.acos(), 0.0));
    Heat {
        run: Box::new(move || {
            vec![
                points.iter().map(|[u, v]| surface.sample(wo, [*u, *v, 0.5]).weight[0]).sum::<f64>()
                    / points.len() as f64,
            ]
        }),
        error: wrong(),
    }
}

const ALBEDO: Race =
    race("by_rules", "the albedo: weights by chance, by Sobol's points, and a rule in coordinates made for it")
        .work("facets")
        .error("error of E", "|ΔE| at α = 0.3 and cos θ = 0.3 (GGX), rms over 16 seeds, against 200 × 200 nodes")
        .lanes(&[
            lane("chance", "weights by chance", &[256, 1024, 4096, 16384], |bench, work| {
                by_points(bench, work, Points::Random)
            })
            .repeated(16)
            .order(0.5, 0.15),
            lane("sobol", "weights of Sobol's points", &[256, 1024, 4096, 16384], |bench, work| {
                by_points(bench, work, Points::Sobol)
            })
            .repeated(16)
            .order(1.1, 0.35),
            lane("rule", "the rule over slopes", &[64, 256, 1024, 4096], |_, work| {
                let side = (work as f64).sqrt() as usize;
                Heat {
                    run: Box::new(move || {
                        vec![Rule::new(&Ggx::new([RACED.0; 2]), side, side).albedo(RACED.1, |_| 1.0)]
                    }),
                    error: wrong(),
                }
            })
            .converges(1e-8, "what 64 × 64 nodes promise"),
        ]);

fn albedos(setting: &Setting) -> Plot {
    const CELLS: usize = 24;
    let slopes = made_from(setting).slopes;
    let place = |at: usize| (at as f64 + 0.5) / CELLS as f64;
    let map = |title: &str, value: &dyn Fn(f64, f64) -> f64| {
        let values = (0..CELLS * CELLS).map(|at| value(place(at % CELLS).max(1e-3), place(at / CELLS))).collect();
        Map {
            title: title.into(),
            x: Axis::linear("roughness α", "").range(0.0, 1.0).tick(0.25),
            y: Axis::linear("cos θ_o", "").range(0.0, 1.0).tick(0.25),
            colour: Axis::linear("share returned E", "").range(0.3, 1.0),
            ramp: Ramp::Sequential,
            columns: CELLS,
            values,
            marks: Vec::new(),
        }
        .into()
    };
    let single = map("one bounce", &|alpha, cos| albedo(slopes, alpha, cos));
    // A column of one roughness at a time: its table is made once.
    let columns: Vec<Vec<f64>> = (0..CELLS)
        .map(|column| {
            let of = bsdf::Setting { alpha: [place(column).max(1e-3); 2], slopes, ..bsdf::Setting::default() };
            let surface = model("conductor-compensated", &of);
            let points = Points::Sobol.draw(1 << 9, &mut stream(0, "brdf/energy/albedos"));
            let mean = |row: usize| {
                let wo = way(place(row).acos(), 0.0);
                points
                    .iter()
                    .map(|[u, v]| surface.sample(wo, [*u, *v, (7.0 * u + 3.0 * v).fract()]).weight[0])
                    .sum::<f64>()
                    / 512.0
            };
            (0..CELLS).map(mean).collect()
        })
        .collect();
    let at = |x: f64| ((x * CELLS as f64) as usize).min(CELLS - 1);
    let both = map("its losses given back", &|alpha, cos| columns[at(alpha)][at(cos)]);
    Plot::grid(format!("White metal, {} slopes", name(slopes)), 2, vec![single, both])
}

/// Pixels of a ball.
const SIDE: usize = 48;

/// A ball lit by a white room, each pixel by the same 16 directions.
fn ball(surface: &dyn Bsdf<f64>, title: String, colour: impl Fn([f64; 3]) -> [f32; 3], room: [f32; 3]) -> Panel {
    let points = Points::Sobol.draw(16, &mut stream(0, "brdf/energy/ball"));
    let pixel = |at: usize| {
        let place = |at: usize| (at as f64 + 0.5) / SIDE as f64 * 2.3 - 1.15;
        let (x, y) = (place(at % SIDE), -place(at / SIDE));
        let inside = 1.0 - x * x - y * y;
        if inside <= 0.0 {
            return room;
        }
        let wo = local([x, y, inside.sqrt()], Vector::of([0.0, 0.0, 1.0]));
        let mut sum = [0.0; 3];
        for (at, [u, v]) in points.iter().enumerate() {
            let third = (f64::from(at as u32) * 0.618_033_988_749_895 + 0.5 * u).fract();
            let drawn = surface.sample(wo, [*u, *v, third]);
            sum = [0, 1, 2].map(|c| sum[c] + drawn.weight[c] / drawn.compression / 16.0);
        }
        colour(sum)
    };
    Panel::Picture(Picture { title, width: SIDE, pixels: (0..SIDE * SIDE).map(pixel).collect() })
}

fn furnace(setting: &Setting) -> Plot {
    let slopes = made_from(setting).slopes;
    let grey = |share: [f64; 3]| [(0.8 * share[0]) as f32; 3];
    let rows =
        [("rough-conductor", "one bounce"), ("conductor-compensated", "given back"), ("conductor-walk", "walked")];
    let balls = rows.into_iter().flat_map(|(name, says)| {
        [0.1, 0.4, 0.7, 1.0].map(|alpha| {
            let of = bsdf::Setting { alpha: [alpha; 2], slopes, ..bsdf::Setting::default() };
            ball(model(name, &of).as_ref(), format!("{says}, α = {alpha}"), grey, [0.8; 3])
        })
    });
    Plot::grid("White metal in a white room", 4, balls.collect())
}

fn colour(setting: &Setting) -> Plot {
    let metal = setting.word("metal");
    let indices = super::models::metal(metal);
    let of = |alpha: f64| bsdf::Setting { alpha: [alpha; 2], metal: indices, ..made_from(setting) };
    let alpha = setting.number("alpha");
    let alphas = || (0..=10).map(|step| (0.1 * f64::from(step)).max(0.02));
    let theta = setting.number("theta").min(1.55);
    let wo = way(theta, 0.0);
    let curve = |name: &str| -> Vec<[f64; 2]> {
        alphas()
            .map(|alpha| [alpha, mean_weight(model(name, &of(alpha)).as_ref(), wo, 2_000, "brdf/energy/colour").mean()])
            .collect()
    };
    let chart =
        Chart::new("", Axis::linear("roughness α", "").range(0.0, 1.0), Axis::linear("share of red returned", ""))
            .line(Hue::Textbook, "one bounce", curve("rough-conductor"))
            .line(Hue::Ours, "its losses given back", curve("conductor-compensated"))
            .dashed(Hue::Reference, "walked", curve("conductor-walk"));
    let balls = ["rough-conductor", "conductor-compensated", "conductor-walk"].map(|name| {
        ball(
            model(name, &of(alpha)).as_ref(),
            format!("{name}, α = {alpha}"),
            |share| display(share.map(|s| 0.8 * s)),
            [0.8; 3],
        )
    });
    Plot::grid(
        format!("Rough {metal} at θ = {:.0}°", theta.to_degrees()),
        2,
        std::iter::once(chart.into()).chain(balls).collect(),
    )
}
