//! C17, first half: rough surfaces as facets, how their slopes lie, which of them are seen.

use super::models::{ALPHA, SLOPES, THETA, made_from, way};
use super::symbols::{ALPHA as A, C_I, C_M, C_O, D_M, F, F_R, G_1, G_2, LAMBDA, MU, PDF, PSI, PSI_0, THETA_H, THETA_I};
use crate::diagram::{Behind, Diagram, Part};
use crate::figure::{Axis, Chart, Dash, Hue, Plot};
use crate::parameter::Setting;
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Extreme, Measured, Quantity, Step, check, choice, derivation, exhibit, figure,
    question, statement, step, stress,
};
use equation::derivation::Chain;
use equation::expr::{cos, integral_between, partial, pi, ratio, sin, tan};
use equation::{Equation, Expr};
use glam::DVec3;
use light::bsdf::microfacet::{Beckmann, Distribution, Ggx, Slopes, lambda, masking, projected, visible_density};
use light::number::Vector;
use light::references::microfacet::{NAMES, microfacet};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use yardstick::precise;
use yardstick::quadrature::{gauss_legendre, trapezoid};
use yardstick::random::uniform;

pub(super) const EXHIBIT: Exhibit = exhibit(
    "facets",
    &[SLOPES, ALPHA, THETA],
    &[
        figure("half", "Only facets whose normal is the half vector send light from ω_i to ω_o.", half_vector),
        figure(
            "shapes",
            "How slopes lie: Gauss's and the one with long tails; and what of a facet is seen from aside.",
            shapes,
        ),
    ],
);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Rough surfaces are facets",
    "Each facet obeys the mirror's law; how they lie and which of them are seen makes the BRDF.",
)
.rows(&["C17"])
.statements(&[
    statement("torrance_sparrow", "facets D, Fresnel F, and what is seen from both sides G₂", || {
        Equation::new(F_R, D_M * F * G_2 / (4 * C_I * C_O))
    }),
    statement("smith", "what is masked, for slopes with long tails: tan ψ₀ = μ/α with μ = cot θ", || {
        Equation::new(LAMBDA, (1 / sin(PSI_0) - 1) / 2)
    }),
])
.derivations(&[
    derivation("half_vector", "turn the facet: the reflected direction turns twice as far, and so dω_i = 4 (ω_o·m) dω_m", || {
        half(4 * cos(THETA_H))
    })
    .slip("twice as far along, but not across", || half(Expr::from(2))),
    derivation("lambda", "Smith's Λ: all facets steeper than the view, by how much they stand in its way", || {
        smith((1 / sin(PSI_0) - 1) / 2)
    })
    .slip("the sign of what is grazed", || smith((1 / sin(PSI_0) + 1) / 2)),
    derivation("root", "the same as textbooks have it: 1 + 2Λ = √(1 + α² tan² θ)", || root(1 + (A / MU).pow(2)))
        .slip("α tan θ for its square", || root(1 + A / MU)),
    derivation("weight", "drawn from the visible facets, a direction's weight is F G₂/G₁: no D, and never above 1", || {
        weight(F * G_2 / G_1)
    })
    .slip("masking from one side forgotten", || weight(F * G_2)),
])
.questions(&[question(
    "glare",
    "A wet road at sunset: why does a rough surface glare when seen at a flat angle, far from the mirror's direction of most \
     of its facets?",
    Answer::Choice {
        options: &[
            choice("its roughness disappears", "The slopes are what they were."),
            choice(
                "the facets that are seen are met at flatter angles too, and there Fresnel's share is near 1",
                "",
            ),
            choice("more facets are seen", "Fewer are: they hide each other."),
        ],
        right: |_| {
            // The mean cosine at which facets that are seen are met, face on and flat.
            let mean = |theta: f64| {
                let w = way(theta, 0.0);
                let met = |m: Vector<f64>| w.dot(m).max(0.0);
                over_facets(Slopes::Ggx, 0.3, |m| met(m) * met(m)) / over_facets(Slopes::Ggx, 0.3, met)
            };
            usize::from(mean(1.5) < mean(0.5))
        },
        slip: |_| 2,
    },
    "Masking leaves facets that lean towards the eye, and even these are met at flatter angles.",
)])
.readout(|setting| {
    let [d, hidden, g1] = at(setting);
    let quantity = |key, symbol, says, value, unit| Quantity { key, symbol, says, value, unit };
    vec![
        quantity("D", "D", "facets with their normal at θ", d, "1/sr"),
        quantity("lambda", "Λ", "hidden over seen, from θ", hidden, "1"),
        quantity("G1", "G_1", "share of those that face θ and are seen", g1, "1"),
    ]
})
.checks(&[&AREA, &ELLIPSOID, &SEEN, &SIDES, &DRAWN])
.stress(&[stress("forms", "D, Λ and G₁ keep their digits from α = 10⁻⁴ to 1 and from the normal to grazing", |_| forms())
    .rows(&["C17"])
    .textbook("D with tan² θ = 1/cos² θ − 1, Λ with √(1 + α² tan² θ) − 1, erfc for Gauss's slopes")
    .against("the same in 256 bits and more, and condition numbers")]);

fn half(last: Expr) -> Chain {
    Chain::new(sin(THETA_I) * partial(THETA_I, THETA_H) / sin(THETA_H))
        .because("polar angles about ω_o; the azimuth is the same for both")
        .given(THETA_I, 2 * THETA_H, "the mirror's law")
        .then(last, ["sin 2θ = 2 sin θ cos θ"])
}

/// With slopes m = α tan ψ, of which dψ ½ cos ψ lie between ψ and ψ + dψ along one direction.
fn smith(last: Expr) -> Chain {
    let steeper = ratio(1, 2) * (A * sin(PSI) - MU * cos(PSI));
    Chain::new(1 / MU * integral_between(steeper, PSI, PSI_0, pi() / 2))
        .because("(m − μ)/μ over the slopes m > μ; α²/2(α² + m²)^{3/2} dm = ½ cos ψ dψ")
        .given(MU, A * tan(PSI_0), "the slope that is grazed")
        .primitive(-(ratio(1, 2) * (A * cos(PSI) + MU * sin(PSI))), PSI)
        .then(last, ["the slope that is grazed", "sin² + cos² = 1"])
}

fn root(last: Expr) -> Chain {
    Chain::new((1 + 2 * LAMBDA).pow(2))
        .given(LAMBDA, (1 / sin(PSI_0) - 1) / 2, "Smith's Λ")
        .given(MU, A * tan(PSI_0), "the slope that is grazed")
        .then(last, ["1/sin² = 1 + cot²"])
}

fn weight(last: Expr) -> Chain {
    Chain::new(F_R * C_I / PDF)
        .because("f_r cos θ_i over the density with which it was drawn")
        .given(F_R, D_M * F * G_2 / (4 * C_I * C_O), "Torrance and Sparrow")
        .given(PDF, G_1 * D_M * C_M / C_O * (1 / (4 * C_M)), "visible facets, over dω_i/dω_m")
        .then(last, ["cancel"])
}

fn at(setting: &Setting) -> [f64; 3] {
    let of = made_from(setting);
    let w = way(setting.number("theta"), 0.0);
    measured(of.slopes, of.alpha[0], w)
}

/// D, Λ and G₁.
pub(super) fn measured(slopes: Slopes, alpha: f64, w: Vector<f64>) -> [f64; 3] {
    fn of<D: Distribution<f64>>(alpha: f64, w: Vector<f64>) -> [f64; 3] {
        let facets = D::new([alpha; 2]);
        [facets.density(w), lambda(&facets, w), masking(&facets, w)]
    }
    match slopes {
        Slopes::Ggx => of::<Ggx<f64>>(alpha, w),
        Slopes::Beckmann => of::<Beckmann<f64>>(alpha, w),
    }
}

pub(super) const KINDS: [Slopes; 2] = [Slopes::Ggx, Slopes::Beckmann];

pub(super) fn name(slopes: Slopes) -> &'static str {
    match slopes {
        Slopes::Ggx => "GGX",
        Slopes::Beckmann => "Beckmann",
    }
}

/// ∫ f(m) D(m) dω_m over facets seen in slopes R = α tan ψ and azimuths.
fn over_facets(slopes: Slopes, alpha: f64, f: impl Fn(Vector<f64>) -> f64) -> f64 {
    // Gauss's slopes end for every purpose at six α.
    let end = match slopes {
        Slopes::Ggx => FRAC_PI_2,
        Slopes::Beckmann => 6.5_f64.atan(),
    };
    let (radii, turns) = (gauss_legendre(200), trapezoid(400));
    let ring = |(u, weight): &(f64, f64)| {
        let psi = end * u;
        let slope = alpha * psi.tan();
        let along = |(v, share): &(f64, f64)| {
            let (s, c) = (TAU * v).sin_cos();
            let m = Vector::new(-slope * c, -slope * s, 1.0).normalised();
            share * f(m) * measured(slopes, alpha, m)[0] * m.z.powi(3)
        };
        weight * end * alpha / psi.cos().powi(2) * slope * TAU * turns.iter().map(along).sum::<f64>()
    };
    radii.iter().map(ring).sum()
}

const AREA: Check<fn(Vector<f64>) -> f64> = check("area", "the facets, each as its shadow, cover the surface once")
    .against("1, against ∫ D cos θ_m dω_m")
    .within(
        1e-10,
        "1",
        "200 × 400 points of an integrand that is analytic in ψ; Gauss's slopes are cut at 6.5 α, e^−42",
    )
    .of(shadow, |m| m.z)
    .slip("D taken as a density of directions: cos θ_m forgotten", |_| 1.0);

fn shadow(_: &mut Bench, weight: fn(Vector<f64>) -> f64) -> Measured {
    let cases = KINDS.into_iter().flat_map(|slopes| [0.05, 0.3, 1.0].map(|alpha| (slopes, alpha)));
    Measured::worst(
        cases.map(|(slopes, alpha)| {
            (over_facets(slopes, alpha, weight) - 1.0, format!("{}, α = {alpha}", name(slopes)))
        }),
    )
}

const ELLIPSOID: Check<fn(f64, f64) -> f64> = check(
    "ellipsoid",
    "GGX's facets are turned as the surface of half an ellipsoid of revolution is, α as high as it is wide",
)
.against(
    "∫ D cos θ_m dω_m up to an angle, against what the zone up to that slope covers of the ellipsoid's base: \
     tan² θ/(α² + tan² θ) (T. S. Trowbridge and K. P. Reitz, J. Opt. Soc. Am. 65 (1975) 531)",
)
.within(1e-12, "1", "40 points of Gauss's rule in each of eight rings of an integrand that is analytic in the slope")
.of(zones, |alpha, cos| measured(Slopes::Ggx, alpha, way(cos.acos(), 0.0))[0])
.slip("α² taken for α, as where roughness is squared before it is used", |alpha, cos| {
    measured(Slopes::Ggx, alpha * alpha, way(cos.acos(), 0.0))[0]
});

/// α and cos θ_m to D [1/sr].
fn zones(_: &mut Bench, density: fn(f64, f64) -> f64) -> Measured {
    let rule = gauss_legendre(40);
    Measured::worst([0.05, 0.3, 1.0].into_iter().flat_map(|alpha: f64| {
        // The zones' rims in ψ, tan θ = α tan ψ, in which D cos³ θ dtan² θ is smooth up to the horizon.
        let rim = |at: i32| FRAC_PI_2 * f64::from(at) / 8.0;
        let mut covered = 0.0;
        let rule = &rule;
        (0..8)
            .map(move |at| {
                let (from, to) = (rim(at), rim(at + 1));
                let ring = |(u, weight): &(f64, f64)| {
                    let psi = from + (to - from) * u;
                    let slope = alpha * psi.tan();
                    let cos = 1.0 / slope.hypot(1.0);
                    // dω cos θ = cos⁴ θ · 2π tan θ d(tan θ).
                    weight * (to - from) * density(alpha, cos) * cos.powi(4) * TAU * slope * alpha / psi.cos().powi(2)
                };
                covered += rule.iter().map(ring).sum::<f64>();
                (covered - rim(at + 1).sin().powi(2), format!("α = {alpha}, up to ψ = {:.3}", rim(at + 1)))
            })
            .collect::<Vec<_>>()
    }))
}

/// The density of facets as they are seen: α, the view and the facet's normal to [1/sr].
type OfSeen = fn(f64, [f64; 3], [f64; 3]) -> f64;

const DRAWN: Check<OfSeen> =
    check("drawn", "facets are drawn with the density in which they are seen, D max(0, ω·m)/(cos θ (1 + Λ))")
        .against(
            "1 over the area of the sphere that the draws spread a unit of their square over, by central differences",
        )
        .within(
            1e-5,
            "1",
            "steps of 10⁻⁴: their square times a third derivative of up to some hundreds; of rounding 10⁻¹² is left",
        )
        .of(spread, |alpha, w, m| visible_density(&Ggx::new([alpha; 2]), Vector::of(w), Vector::of(m)))
        .slip("the density of all facets, D cos θ_m, seen or not", |alpha, _, m| {
            Ggx::new([alpha; 2]).density(Vector::of(m)) * m[2]
        });

fn spread(bench: &mut Bench, density: OfSeen) -> Measured {
    let views = [0.0, 0.6, 1.1, 1.4].into_iter().flat_map(|theta| [0.2, 0.7].map(|alpha| (theta, alpha)));
    Measured::worst(views.flat_map(|(theta, alpha)| {
        let (facets, w): (Ggx<f64>, _) = (Ggx::new([alpha; 2]), way(theta, 0.8));
        let places = [(); 12].map(|()| [(); 2].map(|()| uniform(&mut bench.stream, 0.1, 0.9)));
        places.map(|[u, v]| {
            let h = 1e-4;
            let at = |u: f64, v: f64| {
                let m = facets.visible(w, [u, v]);
                DVec3::new(m.x, m.y, m.z)
            };
            let (along, across) = (at(u + h, v) - at(u - h, v), at(u, v + h) - at(u, v - h));
            let area = along.cross(across).length() / (4.0 * h * h);
            let m = at(u, v).to_array();
            (density(alpha, [w.x, w.y, w.z], m) * area - 1.0, format!("α = {alpha}, θ = {theta}, u = {u:.3}, {v:.3}"))
        })
    }))
}

/// What is seen of facets: their slopes, α and the view.
type Seen = fn(Slopes, f64, Vector<f64>) -> f64;

const SEEN: Check<Seen> = check(
    "seen",
    "the facets that face the view, each as it is seen, are as large as cos θ (1 + Λ) says",
)
.against("cos θ (1 + Λ), against ∫ D max(0, ω·m) dω_m: what masking has to take away to leave cos θ")
.within(
    1e-4,
    "1",
    "the integrand has a bend where facets turn away: of 200 points (1/200)² is left, and more where it is steep",
)
.of(facing, |slopes, alpha, w| {
    let [_, hidden, _] = measured(slopes, alpha, w);
    w.z * (1.0 + hidden)
})
.slip("cos θ itself: masking forgotten", |_, _, w| w.z);

fn facing(_: &mut Bench, area: fn(Slopes, f64, Vector<f64>) -> f64) -> Measured {
    let cases = KINDS
        .into_iter()
        .flat_map(|slopes| [(0.3, 0.5), (0.3, 1.3), (1.0, 0.9), (0.6, 1.5)].map(|(a, t)| (slopes, a, t)));
    Measured::worst(cases.map(|(slopes, alpha, theta)| {
        let w = way(theta, 0.0);
        let found = over_facets(slopes, alpha, |m| w.dot(m).max(0.0));
        (found / area(slopes, alpha, w) - 1.0, format!("{}, α = {alpha}, θ = {theta}", name(slopes)))
    }))
}

/// The same of GGX's facets, from anywhere.
type SeenOf = fn(&Ggx<f64>, Vector<f64>) -> f64;

const SIDES: Check<SeenOf> =
    check("below", "seen from below the surface, facets that look down show as much as those above hide")
        .against("∫ D max(0, ω·m) dω_m for ω below the surface, by a product rule")
        .within(
            1e-3,
            "1",
            "the integrand has a bend where facets turn away, and few facets reach it: (1/200)² over their share",
        )
        .of(from_below, projected)
        .slip("the same area from above and below", |facets, w| projected(facets, -w));

fn from_below(_: &mut Bench, below: SeenOf) -> Measured {
    Measured::worst([0.9, 1.4].map(|theta| {
        let (facets, w) = (Ggx::new([0.4; 2]), -way(theta, 1.0));
        let found = over_facets(Slopes::Ggx, 0.4, |m| w.dot(m).max(0.0));
        (below(&facets, w) / found - 1.0, format!("θ = {theta}"))
    }))
}

/// D, Λ and G₁ at the extremes.
fn forms() -> Vec<Extreme> {
    let alphas = [1e-4, 1e-2, 0.3, 1.0];
    let angles = [1e-9, 1e-4, 0.7, 1.57, FRAC_PI_2 - 1e-6];
    let cases = KINDS
        .into_iter()
        .flat_map(|slopes| alphas.into_iter().flat_map(move |alpha| angles.map(|theta| (slopes, alpha, theta))));
    cases
        .flat_map(|(slopes, alpha, theta)| {
            let w = way(theta, 0.0);
            let (exact, conditions) = microfacet(slopes, alpha, [w.x, w.y, w.z]);
            let (ours, textbook) = (measured(slopes, alpha, w), printed(slopes, alpha, w.z));
            exact.into_iter().enumerate().map(move |(at, reference)| Extreme {
                input: format!("{}, α = {alpha:e}, θ = {theta:e}", name(slopes)),
                quantity: NAMES[at],
                reference,
                textbook: textbook[at],
                ours: ours[at],
                condition: conditions[at],
                worst_of: 1,
            })
        })
        .filter(|case| precise::to_f64(&case.reference).abs() > f64::MIN_POSITIVE)
        .collect()
}

/// D, Λ and G₁ as papers print them, from cos θ.
fn printed(slopes: Slopes, alpha: f64, cos: f64) -> [f64; 3] {
    let tan2 = 1.0 / (cos * cos) - 1.0;
    let (d, hidden) = match slopes {
        Slopes::Ggx => {
            let d = alpha * alpha / (PI * cos.powi(4) * (alpha * alpha + tan2).powi(2));
            (d, 0.5 * ((1.0 + alpha * alpha * tan2).sqrt() - 1.0))
        }
        Slopes::Beckmann => {
            let d = (-tan2 / (alpha * alpha)).exp() / (PI * alpha * alpha * cos.powi(4));
            let a = 1.0 / (alpha * tan2.sqrt());
            let tail = 0.5 * (yardstick::statistics::normal_two_sided(a * std::f64::consts::SQRT_2));
            (d, (-a * a).exp() / (2.0 * a * PI.sqrt()) - tail)
        }
    };
    [d, hidden, 1.0 / (1.0 + hidden)]
}

fn half_vector(setting: &Setting) -> Plot {
    let theta = setting.number("theta").min(1.3);
    let out = 0.35;
    let ray = |angle: f64, length: f64| [length * angle.sin(), length * angle.cos()];
    let half = 0.5 * (out - theta);
    let mut diagram = Diagram::new("", [-1.7, -0.45], [1.7, 1.4]);
    // A row of facets, of which that in the middle has the half vector for its normal.
    let lean = [0.25, -0.35, -half, 0.4, -0.2];
    let mut at = [-0.28 * f64::cos(half) - 1.3, 0.0];
    for (k, slope) in lean.into_iter().enumerate() {
        let width = if k == 2 { 0.56 } else { 0.65 };
        let to = [at[0] + width * f64::cos(slope), at[1] + width * f64::sin(slope)];
        let part = Part::surface(at, to, Behind::Hatched);
        diagram = diagram.with(if k == 2 { part.hue(Hue::Ours) } else { part });
        at = to;
    }
    let first: [f64; 2] = [0, 1].map(|k| lean[k]).iter().fold([-0.28 * f64::cos(half) - 1.3, 0.0], |at, slope| {
        [at[0] + 0.65 * slope.cos(), at[1] + 0.65 * slope.sin()]
    });
    let middle = [first[0] + 0.28 * f64::cos(-half), first[1] + 0.28 * f64::sin(-half)];
    let from = |angle: f64, length: f64| {
        let [x, y] = ray(angle, length);
        [middle[0] + x, middle[1] + y]
    };
    let diagram = diagram
        .with(Part::line(middle, from(0.0, 1.2)).dash(Dash::Dashed).hue(Hue::Reference).label("n"))
        .with(Part::ray_with_heads(from(-theta, 1.3), middle, &[0.5]).hue(Hue::P).label("ω_i"))
        .with(Part::ray(middle, from(out, 1.3)).hue(Hue::P).label("ω_o"))
        .with(Part::vector(middle, from(half, 0.9)).hue(Hue::Ours).label("m"));
    Plot::of("A facet that sends ω_i to ω_o", diagram)
}

fn shapes(setting: &Setting) -> Plot {
    let of = made_from(setting);
    let alpha = of.alpha[0];
    let curve = |slopes: Slopes, which: usize| -> Vec<[f64; 2]> {
        (0..=179)
            .map(|at| f64::from(at) / 2.0)
            .map(|x| [x, measured(slopes, alpha, way(x.to_radians(), 0.0))[which]])
            .collect()
    };
    let axis = || Axis::linear("angle to the normal θ", "°").range(0.0, 90.0).tick(30.0);
    let d = Chart::new("facets", axis(), Axis::log("D", "1/sr").range(1e-6 / alpha, 1.0 / (alpha * alpha)))
        .line(Hue::Nth(0), "GGX", curve(Slopes::Ggx, 0))
        .line(Hue::Nth(1), "Beckmann", curve(Slopes::Beckmann, 0));
    let g = Chart::new("what is seen of those that face us", axis(), Axis::linear("G_1", "").range(0.0, 1.05))
        .line(Hue::Nth(0), "", curve(Slopes::Ggx, 2))
        .line(Hue::Nth(1), "", curve(Slopes::Beckmann, 2));
    Plot::grid(format!("Facets of roughness α = {alpha}"), 2, vec![d.into(), g.into()])
}
