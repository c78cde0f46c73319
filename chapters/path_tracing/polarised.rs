//! C27, second part: polarisation, only where a filter sees it.

use super::one_ray::judged;
use super::scenes::{greens, polariscope, rendered, runs, small};
use super::symbols::{ALPHA, BETA, COS_1, COS_2, N};
use super::ways::{shown, smallest};
use crate::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use crate::parameter::{Kind, Parameter, Setting};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Quantity, Step, check, choice, derivation, exhibit, figure,
    question, step, stress,
};
use equation::Expr;
use equation::derivation::Chain;
use equation::expr::{cos, sin, sqrt};
use light::Complex64;
use light::optics::Incidence;
use light::optics::fresnel::{brewster_angle, powers};
use light::scene::Material;
use light::scene::builtin::rhomb;
use light::stokes::{Mueller, degree, natural, reflected_degree};
use light::transport::simple::{Integrator, RARE};
use light::transport::{Manner, Method};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::OnceLock;
use yardstick::precise::{self, Real};
use yardstick::random::uniform;

const INDEX: Parameter = Parameter::new("n", "n", "index of the glass", Kind::number(1.05, 3.0, "1")).default("1.5");
const TURNED: Parameter =
    Parameter::new("turned", "ψ", "by how much the second plate is turned", Kind::number(0.0, PI, "rad"))
        .default("30deg");

pub(super) const EXHIBIT: Exhibit = exhibit(
    "polarised",
    &[INDEX, TURNED],
    &[
        figure(
            "degree",
            "How much of natural light is polarised after one reflection, and after passing piles of plates, over the angle of incidence.",
            degrees,
        ),
        figure(
            "glare",
            "A pool under a grey sky, seen at Brewster's angle: without a filter, darkened by the stop that a filter costs, and through a polariser on its side and upright.",
            glare,
        ),
        figure(
            "polariscope",
            "Malus's two plates: what the second returns, turned about the light that the first sends it. Points are the renderer's.",
            plates,
        ),
        figure(
            "circular",
            "Fresnel's rhomb before dark glass that mirrors a lamp at Brewster's angle, through a polariser that is turned: the mirror's light is linear and goes out once, behind the rhomb it is circular and stays.",
            circular,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Polarisation where a filter sees it",
    "Of two polished surfaces the mean of the products counts, not the product of the means; a path that asks four numbers of light instead of one has it right.",
)
.rows(&["C27"])
.derivations(&[
    derivation("malus", "what two polarisers pass of natural light, by their rows and columns", || {
        malus(cos(ALPHA - BETA).pow(2) / 2)
    })
    .slip("the cosine for its square", || malus(cos(ALPHA - BETA) / 2)),
    derivation("face", "what one face passes of s at Brewster's angle, where the two rays are at right angles", || {
        face(4 * N.pow(2) / (1 + N.pow(2)).pow(2))
    })
    .slip("as at normal incidence", || face(4 * N / (1 + N).pow(2))),
])
.questions(&[question(
    "crossed",
    "Light falls on a plate of glass at Brewster's angle, and from there on a second one, again at Brewster's angle, but in a plane at right angles to the first. Each plate returns 7 % of natural light. How much is left?",
    Answer::Choice {
        options: &[
            choice("7 % of 7 %", "So it would be if light forgot what the first plate did to it. It is all s now."),
            choice("half of that", "Half of natural light is s; but this is no natural light any more."),
            choice("nothing", ""),
        ],
        right: |_| {
            let left = returned(1.5, FRAC_PI_2);
            let each = reflected(1.5).apply(natural(1.0))[0];
            if left > 0.75 * each * each { 0 } else if left > 0.01 * each * each { 1 } else { 2 }
        },
        slip: |_| 0,
    },
    "What is s to the first plate is p to the second, and at Brewster's angle p is not returned at all. Étienne-Louis Malus saw it in 1808, in a window of the Palais du Luxembourg.",
)])
.readout(|setting| {
    let (n, turned) = (setting.number("n"), setting.number("turned"));
    let theta = brewster_angle(1.0, n);
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("theta_b", "θ_B", "Brewster's angle", theta.to_degrees(), "°"),
        quantity("returned", "I/I_0", "what two plates at that angle return of natural light", returned(n, turned), "1"),
        quantity("forgotten", "R_n²", "the same if light forgot its polarisation between them", reflected(n).0[0][0].powi(2), "1"),
        quantity("plates", "P", "degree of polarisation behind ten plates at that angle", degree(passed(n, 10)), "1"),
    ]
})
.checks(&[&TURNS, &CIRCLES, &DRAWN, &PILES, &POSSIBLE])
.stress(&[stress(
        "faint_degree", "the degree of polarisation of what is reflected, from the normal to grazing and at Brewster's angle", degrees_kept)
    .textbook("(R_s − R_p)/(R_s + R_p), with E36 and E39 as they are printed")
    .against("the same in 4096 bits")]);

/// ½(1, cos 2β, sin 2β)·(1, cos 2α, sin 2α)/2 of natural light.
fn malus(last: Expr) -> Chain {
    let row = (cos(2 * ALPHA), sin(2 * ALPHA), cos(2 * BETA), sin(2 * BETA));
    Chain::new((1 + &row.0 * &row.2 + &row.1 * &row.3) / 4)
        .because("a row of the second times a column of the first")
        .then((1 + cos(2 * (ALPHA - BETA))) / 4, ["cosine of a difference"])
        .then(last, ["cosine of twice an angle"])
}

/// T_s where tan θ₁ = n.
fn face(last: Expr) -> Chain {
    let root = sqrt(1 + N.pow(2));
    Chain::new(4 * N * COS_1 * COS_2 / (COS_1 + N * COS_2).pow(2))
        .because("T_s = n cos θ₂/cos θ₁ t_s²")
        .given(COS_1, 1 / &root, "tan θ₁ = n")
        .given(COS_2, N / &root, "θ₂ = ½π − θ₁")
        .then(last, ["cancel"])
}

fn polarised() -> &'static Integrator {
    RARE.iter().find(|one| one.name == "polarised").expect("an integrator of the lecture")
}

/// What a plate of an index returns at Brewster's angle.
fn reflected(n: f64) -> Mueller {
    Mueller::reflection(Incidence::from_angle(brewster_angle(1.0, n)), 1.0, n.into())
}

/// What two of them do, the second turned by an angle [rad], of natural light [1].
fn returned(n: f64, turned: f64) -> f64 {
    reflected(n).after(&Mueller::turn(turned)).after(&reflected(n)).apply(natural(1.0))[0]
}

/// Natural light behind so many plates at Brewster's angle, without what is reflected within.
fn passed(n: f64, plates: u32) -> [f64; 4] {
    let theta = brewster_angle(1.0, n);
    let plate = Mueller::transmission(Incidence::from_angle(FRAC_PI_2 - theta), n, 1.0).after(&Mueller::transmission(
        Incidence::from_angle(theta),
        1.0,
        n,
    ));
    (0..plates).fold(natural(1.0), |light, _| plate.apply(light))
}

const TURNS: Check<fn(f64, f64) -> f64> =
    check("two_plates", "two plates at Brewster's angle return ½R_s² cos² ψ of natural light")
        .against("the closed form, against 64 runs of a needle's ray each at ψ = 0, 0.5, 1.2 and ½π (t-tests)")
        .significant(1e-3)
        .of(
            |_: &mut Bench, exact: fn(f64, f64) -> f64| {
                let n = 1.5;
                let found = [0.0, 0.5, 1.2, FRAC_PI_2].map(|turned: f64| {
                    let scene = polariscope(n, brewster_angle(1.0, n), turned);
                    let manner = Manner { method: Method::Simple(polarised()), ..Manner::default() };
                    let found = runs(64, &scene, manner, 512);
                    let exact = exact(n, turned);
                    // Where nothing comes back there is no scatter to test by: any light at all would be wrong.
                    if exact < 1e-20 && found.mean() < 1e-12 {
                        return Measured::new(1.0, "dark", 64);
                    }
                    let of = judged(&found, exact);
                    Measured { at: format!("ψ = {turned:.3}: {}", of.at), ..of }
                });
                smallest(found.into())
            },
            |n, turned| {
                let r_s = ((n * n - 1.0) / (n * n + 1.0)).powi(2);
                0.5 * r_s * r_s * turned.cos().powi(2)
            },
        )
        .slip("light that is natural again between the plates", |n, _| {
            let r_s = ((n * n - 1.0) / (n * n + 1.0)).powi(2);
            0.25 * r_s * r_s
        });

const CIRCLES: Check<u32> = check(
    "rhomb",
    "two total reflections in glass of 1.51, at 48°37′ or 54°37′, make circular light of linear light at 45°",
)
.against("Born & Wolf, Principles of Optics (7th ed.), §1.5.4: S₁ and S₂ vanish, S₃ is all")
.within(
    3.5e-3,
    "1",
    "of S₁/S₀ and S₂/S₀: the angles are printed to a minute, over which the phase moves by up to 0.1°, twice",
)
.of(
    |_: &mut Bench, times: u32| {
        Measured::worst([48.0 + 37.0 / 60.0, 54.0 + 37.0 / 60.0].into_iter().flat_map(|degrees: f64| {
            let incidence = Incidence::from_angle(degrees.to_radians());
            let once = Mueller::reflection(incidence, 1.51, Complex64::from(1.0));
            let light = (0..times).fold([1.0, 0.0, 1.0, 0.0], |light, _| once.apply(light));
            [1, 2].map(|k| (light[k] / light[0], format!("S_{k}/S_0 at {degrees:.3}°")))
        }))
    },
    2,
)
.slip("reflected once", 1);

const DRAWN: Check<f64> =
    check("rhomb_drawn", "through a rhomb in a scene linear light is as bright behind a filter at any angle")
        .against("the same seen without a filter, halved: circular light passes one by half, whatever its angle")
        .within(
            1e-5,
            "1",
            "corners of meshes are single numbers, so walls are off by some 1e−7 rad, and the phase by as much",
        )
        .of(
            |_: &mut Bench, ior: f64| {
                let seen = |filter: Option<f64>| {
                    let mut scene = small("rhomb", 1);
                    (scene.camera.fov_y_deg, scene.camera.polariser_deg) = (1e-6, filter);
                    let glass = scene.materials.iter_mut().find(|(name, _)| name == "glass").expect("the rhomb's");
                    glass.1 = Material::Dielectric { ior, outside: 1.0, absorption: [0.0; 3], coating: None };
                    let manner = Manner { method: Method::Simple(polarised()), ..Manner::default() };
                    greens(&rendered(&scene, &manner, 256)).mean()
                };
                let whole = seen(None);
                Measured::worst(
                    [0.0, 30.0, 45.0, 90.0, 135.0]
                        .map(|degrees| (2.0 * seen(Some(degrees)) / whole - 1.0, format!("a filter at {degrees}°"))),
                )
            },
            rhomb::INDEX,
        )
        .slip("a rhomb of denser glass, cut alike", 1.7);

const PILES: Check<fn(f64, u32) -> f64> = check(
    "pile",
    "a pile of plates at Brewster's angle polarises: (1 − T^m)/(1 + T^m), T = 4n²/(1 + n²)² to the square for each",
)
.against("the closed form, against products of matrices of E37 and E40, for one to forty plates")
.within(64.0, "ulp", "some rounding at each of up to eighty faces, of a number near 1")
.of(
    |bench: &mut Bench, exact: fn(f64, u32) -> f64| {
        let own = bench.setting().number("n");
        let cases = [1.333, 1.5, 2.4, own].into_iter().flat_map(|n| [1, 2, 5, 10, 40].map(|plates| (n, plates)));
        Measured::worst(cases.map(|(n, plates)| {
            let off = degree(passed(n, plates)) - exact(n, plates);
            (off / f64::EPSILON, format!("{plates} plates of n = {n}"))
        }))
    },
    |n, plates| {
        let left = (4.0 * n * n / (1.0 + n * n).powi(2)).powi(2 * plates as i32);
        (1.0 - left) / (1.0 + left)
    },
)
.slip("the share of the field for that of the power", |n: f64, plates| {
    let left = (2.0 * n / (1.0 + n * n)).powi(2 * plates as i32);
    (1.0 - left) / (1.0 + left)
});

const POSSIBLE: Check<fn(Mueller) -> Mueller> = check(
    "possible",
    "every matrix is one that a mixture of fields can have: its coherency matrix has no eigenvalue below 0",
)
.against("Cloude's criterion, for 2000 random ways by three surfaces, clear and metal, in planes of any angle")
.within(1e-9, "1", "of the trace: roundings of a dozen products, some of them divided by a small pivot")
.of(
    |bench: &mut Bench, amend: fn(Mueller) -> Mueller| {
        let mut draw = |low, high| uniform(&mut bench.stream, low, high);
        Measured::worst((0..2000).map(|_| {
            let mut way = Mueller::IDENTITY;
            for _ in 0..3 {
                let (theta, turned) = (draw(0.0, 1.55), draw(0.0, TAU));
                let k = (draw(-4.0, 4.0)).max(0.0);
                let index = Complex64::new(draw(0.2, 3.0), k);
                let n_i = draw(1.0, 1.8);
                let there = amend(Mueller::reflection(Incidence::from_angle(theta), n_i, index));
                way = there.after(&Mueller::turn(turned)).after(&way);
            }
            (way.impossible(), format!("R = {:.3e}", way.0[0][0]))
        }))
    },
    |matrix| matrix,
)
.slip("a reflection that keeps the hand of circular light and turns S₂ alone", |matrix| {
    let mut other = matrix;
    other.0[3] = other.0[3].map(|m| -m);
    other
});

fn degrees_kept(setting: &Setting) -> Vec<Extreme> {
    let own = setting.number("n");
    let brewster = |n: f64| n * n / (1.0 + n * n);
    let tried = [
        (1e-300, own),
        (1e-30, 1.5),
        (1e-16, 1.5),
        (1e-8, 1.5),
        (0.1, 1.5),
        (brewster(1.5), 1.5),
        (brewster(own), own),
        (0.5, 1.0 + 1e-9),
        (1.0 - 1e-12, 1.5),
        (1.0 - f64::EPSILON, 1.5),
    ];
    tried
        .map(|(sin2, n): (f64, f64)| {
            // Near the normal the difference of the two is the square of what is left of 4096 bits.
            let exact = |x: f64| precise::real_at(x, 4096);
            let (x, one) = (exact(sin2), exact(1.0));
            let n2 = exact(n) * exact(n);
            let (before, behind) = ((&one - &x).sqrt(), (&n2 - &x).sqrt());
            let share = |a: &Real, b: &Real| {
                let r = (a - b) / (a + b);
                &r * &r
            };
            let (s, p) = (share(&before, &behind), share(&(&n2 * &before), &behind));
            let reference = (&s - &p) / (s + p);
            let u2 = (&one - &x) * (&n2 - &x);
            // By r = u/sin² θ: P = 2/(r + 1/r).
            let r = precise::to_f64(&(u2.sqrt() / &x));
            let q = (n - 1.0) * (n + 1.0) + (1.0 - sin2);
            let by_r = if r > 1e100 { 1.0 } else { ((1.0 - r * r) / (1.0 + r * r)).abs() };
            let by_x = (1.0 + 0.5 * sin2 * (1.0 / (1.0 - sin2) + 1.0 / q)).abs();
            let theta = sin2.sqrt().asin();
            let behind = (theta.sin() / n).asin();
            let r_s = ((theta - behind).sin() / (theta + behind).sin()).powi(2);
            let r_p = ((theta - behind).tan() / (theta + behind).tan()).powi(2);
            Extreme {
                input: format!("sin²θ = {sin2:e}, n = {n}"),
                quantity: "P",
                reference,
                textbook: (r_s - r_p) / (r_s + r_p),
                ours: reflected_degree(sin2, n),
                condition: by_r * (by_x + n * n / q),
                worst_of: 1,
            }
        })
        .into()
}

fn degrees(setting: &Setting) -> Plot {
    let own = setting.number("n");
    let angle = |k: i32| f64::from(k) * 0.5;
    let once =
        |n: f64| (0..=180).map(|k| [angle(k), reflected_degree(angle(k).to_radians().sin().powi(2), n)]).collect();
    let reflected = Chart::new(
        "reflected once",
        Axis::linear("angle of incidence θ", "°").range(0.0, 90.0).tick(15.0),
        Axis::share("degree of polarisation P"),
    )
    .line(Hue::Nth(0), "water", once(1.333))
    .line(Hue::Nth(1), "glass", once(1.5))
    .line(Hue::Nth(2), "diamond", once(2.417))
    .dashed(Hue::Natural, format!("n = {own}"), once(own))
    .at_x(brewster_angle(1.0, own).to_degrees(), "θ_B");
    let pile = |plates: i32| {
        let of = |k: i32| {
            let incidence = Incidence::from_angle(angle(k).to_radians());
            let p = powers(incidence, 1.0, own.into());
            // Both faces of a plate pass the same share.
            let [s, p] = [p.t_s, p.t_p].map(|share| share.powi(2 * plates));
            [angle(k), (p - s) / (p + s)]
        };
        (0..180).map(of).collect::<Vec<_>>()
    };
    let behind = Chart::new(
        format!("passed, n = {own}"),
        Axis::linear("angle of incidence θ", "°").range(0.0, 90.0).tick(15.0),
        Axis::share("degree of polarisation P"),
    )
    .line(Hue::Nth(0), "1 plate", pile(1))
    .line(Hue::Nth(1), "4 plates", pile(4))
    .line(Hue::Nth(2), "16 plates", pile(16))
    .at_x(brewster_angle(1.0, own).to_degrees(), "θ_B");
    Plot::grid("How reflection and passage polarise natural light", 2, vec![reflected.into(), behind.into()])
}

fn glare(_: &Setting) -> Plot {
    const PIXELS: u32 = 96;
    // It is the same in every setting.
    static DRAWN: OnceLock<Plot> = OnceLock::new();
    let panel = |title: &str, filter: Option<f64>| {
        let mut pool = small("polariser", PIXELS);
        pool.camera.polariser_deg = filter;
        let manner = Manner { method: Method::Simple(polarised()), ..Manner::default() };
        let picture = shown(title, &rendered(&pool, &manner, 32), PIXELS as usize);
        if filter.is_some() { picture } else { picture.exposed(-1.0) }.into()
    };
    let drawn = || {
        let panels = vec![panel("no filter", None), panel("on its side", Some(0.0)), panel("upright", Some(90.0))];
        Plot::grid("The sky's glare on water", 3, panels)
    };
    DRAWN.get_or_init(drawn).clone()
}

fn circular(_: &Setting) -> Plot {
    const PIXELS: u32 = 128;
    // It is the same in every setting.
    static DRAWN: OnceLock<Plot> = OnceLock::new();
    let panel = |title: &str, filter: f64| {
        let mut scene = small("rhomb", PIXELS);
        scene.camera.polariser_deg = Some(filter);
        let manner = Manner { method: Method::Simple(polarised()), ..Manner::default() };
        shown(title, &rendered(&scene, &manner, 32), PIXELS as usize).into()
    };
    let drawn = || {
        let panels = vec![panel("level", 0.0), panel("at 45°", 45.0), panel("upright", 90.0), panel("at 135°", 135.0)];
        Plot::grid("A rhomb of glass, through a filter that is turned", 2, panels)
    };
    DRAWN.get_or_init(drawn).clone()
}

fn plates(setting: &Setting) -> Plot {
    let n = setting.number("n");
    let theta = brewster_angle(1.0, n);
    let exact = (0..=180).map(|k| [f64::from(k), 100.0 * returned(n, f64::from(k).to_radians())]).collect();
    let manner = Manner { method: Method::Simple(polarised()), ..Manner::default() };
    let found = (0..=12).map(|k| {
        let turned = 15.0 * f64::from(k);
        [turned, 100.0 * runs(64, &polariscope(n, theta, turned.to_radians()), manner, 256).mean()]
    });
    let forgotten = 100.0 * reflected(n).0[0][0].powi(2);
    let chart = Chart::new(
        "",
        Axis::linear("turned by ψ", "°").range(0.0, 180.0).tick(30.0),
        Axis::linear("returned of natural light", "%"),
    )
    .line(Hue::Reference, "½R_s² cos² ψ", exact)
    .dashed(Hue::Textbook, "R_n², light that forgets", vec![[0.0, forgotten], [180.0, forgotten]])
    .with(Mark::Points {
        label: "paths".into(),
        hue: Hue::Ours,
        shape: Shape::Disc,
        joined: false,
        points: found.collect(),
    })
    .at_x(setting.number("turned").to_degrees(), "ψ");
    Plot::of(format!("Two plates of n = {n} at Brewster's angle"), chart)
}
