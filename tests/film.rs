//! Coherent stacks against arbitrary precision, over the extremes that break other forms; against conservation laws;
//! and against published values.

use light::Complex64;
use light::Polarisation;
use light::optics::film::{Layer, Powers, Stack};
use light::optics::incidence::normal_squared;
use light::optics::{Direction, Incidence};
use light::references::film::{Condition, condition, reference};
use rand::RngExt;
use std::f64::consts::{FRAC_PI_2, PI};
use yardstick::precise::{Real, relative_error, to_f64};
use yardstick::random::{Stream, stream};

const EPSILON: f64 = f64::EPSILON;
const BOTH: [Polarisation; 2] = [Polarisation::S, Polarisation::P];
const GREEN: f64 = 550e-9;

#[derive(Clone, Debug)]
struct Case {
    n_i: f64,
    layers: Vec<Layer>,
    substrate: Complex64,
    wavelength: f64,
    angle: Direction,
}

impl Case {
    fn stack(&self) -> Stack<'_> {
        Stack { n_i: self.n_i, layers: &self.layers, substrate: self.substrate }
    }
}

fn clear(n: f64) -> Complex64 {
    Complex64::from(n)
}

fn layer(n: f64, k: f64, thickness: f64) -> Layer {
    Layer { index: Complex64::new(n, k), thickness }
}

/// `count` layers of quarter-wave thickness at `GREEN` and normal incidence, of alternating indices.
fn quarter_waves(count: usize, first: f64, second: f64) -> Vec<Layer> {
    (0..count).map(|i| if i % 2 == 0 { first } else { second }).map(|n| layer(n, 0.0, GREEN / (4.0 * n))).collect()
}

/// Worst error of each output in units of ulp · (1 + cond).
#[derive(Default)]
struct Worst {
    reflectance: f64,
    transmittance: f64,
    ln_transmittance: f64,
    absorptance: f64,
    energy: f64,
    count: usize,
}

const LIMIT: f64 = 16.0;

fn judge(case: &Case, polarisation: Polarisation, worst: &mut Worst) {
    let kappa = condition(&case.stack(), case.wavelength, case.angle, polarisation);
    judge_by(&kappa, case, polarisation, worst);
}

fn judge_by(kappa: &Condition, case: &Case, polarisation: Polarisation, worst: &mut Worst) {
    let stack = case.stack();
    let exact = reference(&stack, case.wavelength, case.angle, polarisation);
    let ours = stack.response(case.wavelength, Incidence::from(case.angle), polarisation);
    let describe = || {
        let mut layers = case.layers.clone();
        layers.truncate(6);
        format!(
            "{polarisation:?} n_i {} {} layers {layers:?} substrate {} wavelength {:e} {:?}\nours {ours:?}\n{kappa:?}\n\
             exact R {:e} T {:e} A {:e}",
            case.n_i,
            case.layers.len(),
            case.substrate,
            case.wavelength,
            case.angle,
            to_f64(&exact.reflectance),
            to_f64(&exact.transmittance),
            to_f64(&exact.absorptance),
        )
    };
    let check = |name: &str, worst: &mut f64, ours: f64, exact: &Real, kappa: f64| {
        assert!(kappa >= 0.0, "{name}: condition {kappa} of {}", describe());
        let error = relative_error(ours, exact);
        let bound = EPSILON * (1.0 + kappa);
        let units = if error == 0.0 { 0.0 } else { error / bound };
        // A relative error x of an amplitude makes 2x + x² of a power: the square counts where no digit is left.
        let limit = LIMIT * (1.0 + LIMIT * bound / 4.0);
        assert!(units <= limit, "{name}: {ours:e}, {units} ulp · (1 + cond) off: {}", describe());
        *worst = worst.max(units);
    };
    // Below, the reference has no digits.
    const FLOOR: f64 = 1e-60;
    if to_f64(&exact.reflectance) < FLOOR {
        assert!(ours.reflectance <= 1e-24, "R of {}", describe());
    } else {
        check("R", &mut worst.reflectance, ours.reflectance, &exact.reflectance, kappa.reflectance);
    }
    // Within rounding of the substrate's critical angle total reflection and a trace of light are both right.
    let incidence = Incidence::from(case.angle);
    let substrate = normal_squared(incidence, case.n_i, case.substrate).norm() / case.substrate.norm_sqr();
    match &exact.ln_transmittance {
        _ if substrate < LIMIT * EPSILON && (to_f64(&exact.transmittance) == 0.0 || ours.transmittance == 0.0) => {
            assert!(ours.transmittance.max(to_f64(&exact.transmittance)) < 1e-6, "T of {}", describe());
        }
        None => assert_eq!((ours.transmittance, ours.ln_transmittance), (0.0, f64::NEG_INFINITY), "{}", describe()),
        Some(ln) if to_f64(ln).abs() < FLOOR => assert!(ours.ln_transmittance.abs() <= 1e-24),
        Some(ln) => {
            check("ln T", &mut worst.ln_transmittance, ours.ln_transmittance, ln, kappa.ln_transmittance);
            if to_f64(ln) > f64::MIN_POSITIVE.ln() {
                check("T", &mut worst.transmittance, ours.transmittance, &exact.transmittance, kappa.transmittance);
            } else {
                assert!(ours.transmittance <= f64::MIN_POSITIVE, "T of {}", describe());
            }
        }
    }
    let media = || case.layers.iter().map(|layer| layer.index).chain([case.substrate]);
    if case.layers.iter().all(|layer| layer.index.re * layer.index.im == 0.0) {
        assert_eq!(ours.absorptance, 0.0, "{}", describe());
    } else if to_f64(&exact.absorptance) > FLOOR {
        check("A", &mut worst.absorptance, ours.absorptance, &exact.absorptance, kappa.absorptance);
    }
    if media().all(|index| index.im == 0.0) {
        let units = ((ours.reflectance + ours.transmittance) - 1.0).abs() / EPSILON;
        assert!(units <= 8.0, "R + T is {units} ε off: {}", describe());
        worst.energy = worst.energy.max(units);
    }
    worst.count += 1;
}

fn judge_all(family: &str, cases: impl IntoIterator<Item = Case>) {
    let mut worst = Worst::default();
    for case in cases {
        for polarisation in BOTH {
            judge(&case, polarisation, &mut worst);
        }
    }
    worst.report(family);
}

impl Worst {
    fn report(&self, family: &str) {
        let Self { reflectance, transmittance, ln_transmittance, absorptance, energy, count } = self;
        assert!(*count > 0);
        println!(
            "{family:28} {count:4} cases: R {reflectance:6.2} T {transmittance:6.2} ln T {ln_transmittance:6.2} \
             A {absorptance:6.2} ulp · (1 + cond); |R + T − 1| {energy:6.2} ulp"
        );
    }
}

/// From the normal to grazing.
fn angles() -> Vec<Direction> {
    let normal = [0.0, 1e-12, 1e-3, 0.3, 0.7, 1.1, 1.4, 1.5];
    let surface = [1e-3, 1e-6, 1e-9, 1e-12, 1e-15];
    normal.into_iter().map(Direction::Angle).chain(surface.into_iter().map(Direction::Grazing)).collect()
}

/// A few ulp and a few powers of ten to both sides of an angle.
fn around(theta: f64) -> impl Iterator<Item = Direction> {
    [0.0, 2e-16, 1e-15, 1e-12, 1e-9, 1e-5]
        .into_iter()
        .flat_map(move |x| [Direction::Angle(theta * (1.0 + x)), Direction::Angle(theta * (1.0 - x))])
}

#[test]
fn no_layers_is_an_interface() {
    let substrates = [
        clear(1.5),
        clear(1.0 + 1e-9),
        clear(0.7),
        clear(1e6),
        Complex64::new(0.16, 3.5),
        Complex64::new(1.5, 1e-12),
        Complex64::new(3.0, 1e3),
    ];
    judge_all(
        "no layers",
        substrates.into_iter().flat_map(|substrate| {
            angles().into_iter().map(move |angle| Case {
                n_i: 1.0,
                layers: vec![],
                substrate,
                wavelength: GREEN,
                angle,
            })
        }),
    );
}

#[test]
fn one_clear_layer_of_any_thickness() {
    let thicknesses = [1e-18, 1e-12, 1e-9, 1e-7, GREEN / 4.0 / 1.38, GREEN / 2.0 / 1.38, 1e-5, 1e-2, 3.0];
    judge_all(
        "one clear layer",
        thicknesses.into_iter().flat_map(|d| {
            angles().into_iter().map(move |angle| Case {
                n_i: 1.0,
                layers: vec![layer(1.38, 0.0, d)],
                substrate: clear(1.52),
                wavelength: GREEN,
                angle,
            })
        }),
    );
}

#[test]
fn quarter_wave_mirrors() {
    let few = [0.0, 0.4, 1.3].map(Direction::Angle).into_iter().chain([Direction::Grazing(1e-8)]);
    let cases = few.flat_map(|angle| {
        [(2, GREEN), (5, GREEN), (21, GREEN), (21, 431e-9), (101, GREEN), (101, 700e-9), (1000, GREEN)].map(
            |(count, wavelength)| Case {
                n_i: 1.0,
                layers: quarter_waves(count, 2.35, 1.38),
                substrate: clear(1.52),
                wavelength,
                angle,
            },
        )
    });
    judge_all("quarter-wave mirrors", cases);
}

#[test]
fn a_thousand_layers_that_hardly_matter() {
    let base = |layers, n_i, substrate| Case {
        n_i,
        layers,
        substrate: clear(substrate),
        wavelength: GREEN,
        angle: Direction::Angle(0.3),
    };
    let mut random = stream(1, "film/faint");
    let mut uniform = move || random.random::<f64>();
    let alternating =
        |a: f64, b: f64, d: f64| (0..1000).map(|i| layer(if i % 2 == 0 { a } else { b }, 0.0, d)).collect();
    let faint = (0..1000).map(|_| layer(1.5 + 1e-6 * uniform(), 0.0, 1e-7)).collect();
    judge_all(
        "1000 faint layers",
        [
            base(alternating(2.35, 1.38, 1e-13), 1.0, 1.52),
            base(alternating(2.35, 1.38, 1e-13), 1.5, 1.5),
            base(alternating(1.5, 1.5, 1e-7), 1.5, 1.5),
            base(alternating(1.5, 1.5, 4.321e-7), 1.0, 15.0),
            base(alternating(1.5, 1.500001, 1.1e-7), 1.5, 1.5),
            base(faint, 1.5, 1.5),
        ],
    );
}

#[test]
fn opaque_absorbers() {
    let metals = [(0.16, 3.5), (1.5, 1.9), (3.0, 1e3), (0.05, 4.0), (1.0, 1.0)];
    let thicknesses = [1e-10, 1e-9, 5e-8, 1e-6, 1e-3, 1.0];
    judge_all(
        "opaque absorbers",
        metals.into_iter().flat_map(|(n, k)| {
            thicknesses.into_iter().flat_map(move |d| {
                [0.0, 0.8, 1.5].map(Direction::Angle).into_iter().chain([Direction::Grazing(1e-10)]).map(move |angle| {
                    Case {
                        n_i: 1.0,
                        layers: vec![layer(1.38, 0.0, 1e-7), layer(n, k, d), layer(2.0, 0.0, 2e-7)],
                        substrate: clear(1.52),
                        wavelength: GREEN,
                        angle,
                    }
                })
            })
        }),
    );
}

#[test]
fn faint_absorbers() {
    let cases = [1e-300, 1e-30, 1e-12, 1e-6, 1e-3].into_iter().flat_map(|k| {
        [1e-12, 1e-8, 3e-7, 1e-5].into_iter().flat_map(move |d| {
            [0.0, 0.9, (1.2_f64 / 1.7).asin()].map(Direction::Angle).map(|angle| Case {
                n_i: 1.7,
                layers: vec![layer(1.5, k, d), layer(2.3, 0.0, 1e-7), layer(1.2, k, d)],
                substrate: clear(1.8),
                wavelength: GREEN,
                angle,
            })
        })
    });
    judge_all("faint absorbers", cases);
    let many = [1e-12, 1e-5, 1e-3].map(|k| Case {
        n_i: 1.0,
        layers: (0..1000).map(|i| layer(if i % 2 == 0 { 1.52 } else { 1.5 }, k, 1e-7)).collect(),
        substrate: clear(1.52),
        wavelength: GREEN,
        angle: Direction::Angle(0.5),
    });
    judge_all("1000 faint absorbers", many);
}

#[test]
fn frustrated_gaps() {
    let cases = [1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-2, 1.0].into_iter().flat_map(|gap| {
        let layers = [
            vec![layer(1.0, 0.0, gap)],
            vec![layer(1.38, 0.0, 1e-7), layer(1.0, 0.0, gap), layer(2.0, 0.0, 1e-7)],
            vec![layer(1.0, 0.0, gap), layer(1.5, 0.0, 3e-7), layer(1.0, 0.0, gap)],
        ];
        layers.into_iter().flat_map(|layers| {
            [0.75, 1.0, 1.5].map(Direction::Angle).into_iter().chain([Direction::Grazing(1e-9)]).map(move |angle| {
                Case { n_i: 1.5, layers: layers.clone(), substrate: clear(1.5), wavelength: GREEN, angle }
            })
        })
    });
    judge_all("frustrated gaps", cases);
}

#[test]
fn layers_and_substrates_at_their_critical_angle() {
    let critical = (1.0_f64 / 1.5).asin();
    let cases = around(critical).flat_map(|angle| {
        [1e-9, 1e-7, 1e-4].into_iter().flat_map(move |d| {
            let case = |layers, substrate| Case { n_i: 1.5, layers, substrate, wavelength: GREEN, angle };
            [
                case(vec![layer(1.0, 0.0, d)], clear(1.5)),
                case(vec![layer(2.0, 0.0, 1e-7), layer(1.0, 0.0, d), layer(1.0, 0.0, 1e-7)], clear(1.4)),
                case(vec![layer(1.0, 1e-12, d)], clear(1.5)),
                case(vec![layer(2.0, 0.0, d)], clear(1.0)),
                case(vec![layer(0.5, 0.0, 1e-7), layer(1.4, 0.0, d)], clear(1.0)),
            ]
        })
    });
    judge_all("critical angles", cases);
}

#[test]
fn exactly_critical_layers_stay_finite() {
    // At grazing incidence a layer of the incident medium's own index stands exactly at its critical angle.
    for polarisation in BOTH {
        let layers = [layer(1.5, 0.0, 1e-6), layer(2.0, 0.0, 1e-7)];
        let stack = Stack { n_i: 1.5, layers: &layers, substrate: clear(1.7) };
        let response = stack.response(GREEN, Incidence::from(Direction::Grazing(0.0)), polarisation);
        assert_eq!((response.reflectance, response.transmittance), (1.0, 0.0));
        let nothing = Stack { n_i: 1.5, layers: &layers[..1], substrate: clear(1.5) };
        let response = nothing.response(GREEN, Incidence::from(Direction::Grazing(0.0)), polarisation);
        assert_eq!((response.reflectance, response.transmittance), (0.0, 1.0));
    }
}

#[test]
fn a_matched_stack_reflects_nothing_at_all() {
    let angles = (0..16).map(|step| Direction::Angle(0.1 * f64::from(step)));
    for direction in angles.chain([Direction::Cos(1e-9)]) {
        for polarisation in BOTH {
            let layers = [0.3e-6, 1e-6, 0.0, 7e-3].map(|thickness| layer(1.37, 0.0, thickness));
            let stack = Stack { n_i: 1.37, layers: &layers, substrate: clear(1.37) };
            let incidence = Incidence::from(direction);
            let found = stack.response(GREEN, incidence, polarisation);
            assert_eq!((found.r, found.reflectance), (Complex64::ZERO, 0.0), "{direction:?}");
            assert_eq!((found.transmittance, found.absorptance, found.ln_transmittance), (1.0, 0.0, 0.0));
            let exact = yardstick::precise::to_complex64(&reference(&stack, GREEN, direction, polarisation).t);
            // 10⁵ rad of phase across the stack, each layer's path rounded twice.
            assert!((found.t - exact).norm() <= 4.0 * EPSILON * 1e5, "{found:?} {exact}");
        }
    }
}

#[test]
fn the_faintest_film_between_equal_media_keeps_its_digits() {
    // One atom's layer thinned by twenty orders: R is far below the square of any rounding.
    let faint = [1e-30, 1e-24, 1e-20].into_iter().flat_map(|d| {
        [0.0, 0.3, 1.4].map(|angle| Case {
            n_i: 1.33,
            layers: vec![layer(1.5, 0.0, d), layer(1.7, 0.0, d)],
            substrate: clear(1.33),
            wavelength: GREEN,
            angle: Direction::Angle(angle),
        })
    });
    judge_all("faintest films", faint);
}

#[test]
fn metals_without_loss_absorb_nothing() {
    // Re(n²) < 0 and Im(n²) = 0: films that waves tunnel through, and substrates that send everything back.
    let angles = [0.0, 0.8, 1.5].map(Direction::Angle).into_iter().chain([Direction::Grazing(1e-9)]);
    let cases = angles.flat_map(|angle| {
        [1e-9, 20e-9, 3e-7, 1e-3].into_iter().flat_map(move |d| {
            let case = |layers, substrate| Case { n_i: 1.5, layers, substrate, wavelength: GREEN, angle };
            [
                case(vec![layer(0.0, 2.0, d)], clear(1.5)),
                case(vec![layer(1.38, 0.0, 1e-7), layer(0.0, 1e9, d)], clear(1.0)),
                case(vec![layer(2.3, 0.0, d), layer(0.0, 1e-9, 1e-7)], Complex64::new(0.0, 3.0)),
                case(vec![layer(1.38, 0.01, d)], Complex64::new(0.0, 1.2)),
            ]
        })
    });
    judge_all("metals without loss", cases);
}

#[test]
fn surface_plasmons() {
    let cases = [30e-9, 50e-9, 70e-9].into_iter().flat_map(|d| {
        (0..12).map(move |i| Case {
            n_i: 1.515,
            layers: vec![layer(0.0562, 4.2776, d)],
            substrate: clear(1.0),
            wavelength: 633e-9,
            angle: Direction::Angle(0.73 + 0.01 * f64::from(i)),
        })
    });
    judge_all("surface plasmons", cases);
}

/// A stack of `count` layers of every kind.
fn random_case(random: &mut Stream, count: usize) -> Case {
    let mut between = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let mut index = |lossy: f64| {
        let k = if between(0.0, 1.0) < lossy { 10f64.powf(between(-14.0, 1.0)) } else { 0.0 };
        Complex64::new(between(0.05, 4.0), k)
    };
    let (lossy, n_i, substrate) = ([0.0, 0.2, 1.0][count % 3], index(0.0).re, index(0.2));
    let indices: Vec<_> = (0..count).map(|_| index(lossy)).collect();
    let thin = between(-9.0, -6.0);
    let layers = indices.into_iter().map(|index| Layer { index, thickness: 10f64.powf(between(thin, -6.0)) }).collect();
    let angle = match between(0.0, 3.0) {
        x if x < 1.0 => Direction::Grazing(10f64.powf(between(-15.0, -0.5))),
        x if x < 2.0 => Direction::Angle(between(0.0, 1.5)),
        _ => Direction::Angle(0.0),
    };
    Case { n_i, layers, substrate, wavelength: between(300e-9, 900e-9), angle }
}

#[test]
fn random_stacks() {
    let mut random = stream(2, "film/random");
    let counts = (0..120).map(|i| 1 + i % 8).chain([20, 21, 22, 60, 61, 62]);
    let cases: Vec<_> = counts.map(|count| random_case(&mut random, count)).collect();
    judge_all("random stacks", cases);
}

/// A stack of `count` layers whose values are those that break formulas: equal and nearly equal indices, huge and tiny
/// ones, quarter and half waves, directions along, across and just at the critical angle.
fn awkward_case(random: &mut Stream, count: usize) -> Case {
    const INDICES: [f64; 10] = [1.0, 1.38, 1.5, 1.5000000001, 2.35, 0.05, 4.0, 1e-3, 100.0, 1.0 + 1e-12];
    const EXTINCTIONS: [f64; 8] = [0.0, 0.0, 1e-15, 1e-9, 1e-4, 0.1, 3.0, 300.0];
    let mut uniform = || random.random::<f64>();
    let pick = |x: f64, values: &[f64]| values[(x * values.len() as f64) as usize];
    let (n_i, clear_stack) = (pick(uniform(), &INDICES), uniform() < 0.4);
    let index = |[choice, n, k, scale]: [f64; 4]| {
        let n = if choice < 0.6 { pick(n, &INDICES) } else { 10f64.powf(3.0 * n - 1.5) };
        Complex64::new(n, if clear_stack { 0.0 } else { pick(k, &EXTINCTIONS) * (0.5 + scale) })
    };
    let layers: Vec<Layer> = (0..count)
        .map(|_| {
            let index = index([uniform(), uniform(), uniform(), uniform()]);
            let thickness = match uniform() {
                x if x < 0.25 => 10f64.powf(14.0 * uniform() - 14.0),
                x if x < 0.5 => GREEN / 4.0 / index.re,
                x if x < 0.75 => GREEN / 2.0 / index.re,
                _ => 10f64.powf(4.0 * uniform() - 9.0),
            };
            Layer { index, thickness }
        })
        .collect();
    let substrate = if uniform() < 0.3 { clear(n_i) } else { index([uniform(), uniform(), uniform(), uniform()]) };
    let tiny = 10f64.powf(-16.0 * uniform());
    let angle = match uniform() {
        x if x < 0.2 => Direction::Angle(0.0),
        x if x < 0.4 => Direction::Grazing(tiny),
        x if x < 0.6 => Direction::Angle(tiny),
        x if x < 0.7 => Direction::Angle(1.57 * uniform()),
        _ => {
            let rarer = layers.iter().map(|layer| layer.index.re).find(|n| *n < n_i).unwrap_or(0.5 * n_i);
            Direction::Angle(((rarer / n_i).asin() * (1.0 + tiny * (uniform() - 0.5))).min(1.57))
        }
    };
    Case { n_i, layers, substrate, wavelength: GREEN * pick(uniform(), &[1.0, 1.0, 0.7, 1.3]), angle }
}

#[test]
fn awkward_stacks() {
    let mut random = stream(10, "film/awkward");
    let cases: Vec<_> = (0..150).map(|i| awkward_case(&mut random, i % 7)).collect();
    judge_all("awkward stacks", cases);
}

#[test]
fn a_thousand_random_layers() {
    let mut random = stream(3, "film/thousand");
    let cases = [random_case(&mut random, 1000)];
    judge_all("1000 random layers", cases);
}

/// `count` slices, each a share of one of the films in turn, which together are as thick as those.
fn sliced(films: &[Layer], count: usize) -> Vec<Layer> {
    let share = |film: &Layer| Layer { thickness: film.thickness * films.len() as f64 / count as f64, ..*film };
    (0..count).map(|at| share(&films[at % films.len()])).collect()
}

/// Films cut into `count` slices. The condition is that of a thousand: how finely a film is cut does not change how much
/// its answer depends on what it is made of.
fn slices(count: usize, cases: &[(f64, &[Layer], f64)]) {
    let mut worst = Worst::default();
    for &(n_i, films, angle) in cases {
        let cut = |count| Case {
            n_i,
            layers: sliced(films, count),
            substrate: clear(1.52),
            wavelength: GREEN,
            angle: Direction::Angle(angle),
        };
        for polarisation in BOTH {
            let kappa = condition(&cut(1000).stack(), GREEN, Direction::Angle(angle), polarisation);
            for (part, name) in [(kappa.reflectance, "R"), (kappa.transmittance, "T")] {
                assert!(part < 1e4, "{name} of {films:?} tells nothing: {part}");
            }
            judge_by(&kappa, &cut(count), polarisation, &mut worst);
        }
    }
    worst.report(&format!("{count} slices"));
}

#[test]
fn a_film_of_thousands_of_slices_is_as_exact_as_one() {
    let cases: [(f64, &[Layer], f64); 6] = [
        (1.0, &[layer(2.0, 0.1, 64e-9)], 0.0),
        (1.0, &[layer(2.0, 0.0, 64e-9)], 0.8),
        (1.0, &[layer(0.2, 3.4, 40e-9), layer(2.3, 1e-3, 90e-9)], 0.8),
        (1.0, &[layer(0.0, 2.0, 30e-9), layer(1.38, 0.0, 1e-6)], 0.0),
        (1.5, &[layer(1.0, 0.0, 100e-9), layer(1.0, 1e-6, 1e-7)], 1.0),
        (1.0, &[layer(1.5, 0.5, 3e-6)], 0.8),
    ];
    slices(1000, &cases);
    slices(1 << 14, &cases[..3]);
}

#[test]
fn a_hundred_thousand_slices_keep_the_promise() {
    slices(100_000, &[(1.0, &[layer(2.0, 0.1, 64e-9)], 0.8), (1.0, &[layer(2.0, 0.0, 64e-9)], 0.8)]);
}

#[test]
fn amplitudes_of_a_hundred_thousand_slices_keep_their_phase() {
    // 900 rad of phase in absorbing slices: what rounds off on the way must not add up.
    let layers = sliced(&[layer(1.5, 1e-5, 55e-6)], 100_000);
    let stack = Stack { n_i: 1.0, layers: &layers, substrate: clear(1.5) };
    let angle = Direction::Angle(0.3);
    let (ours, exact) = (
        stack.response(GREEN, Incidence::from(angle), Polarisation::S),
        reference(&stack, GREEN, angle, Polarisation::S),
    );
    let off = |ours: Complex64, exact| (ours - yardstick::precise::to_complex64(exact)).norm() / ours.norm();
    // The phase itself is the condition: a relative change of any thickness turns t by that share of it.
    let limit = LIMIT * EPSILON * 1000.0;
    assert!(off(ours.t, &exact.t) <= limit && off(ours.r, &exact.r) <= limit, "{ours:?}");
}

#[test]
fn conditions_are_those_of_difference_quotients() {
    let case = Case {
        n_i: 1.2,
        layers: vec![layer(1.38, 0.02, 1.1e-7), layer(2.1, 0.0, 0.7e-7), layer(1.38, 0.02, 1.1e-7)],
        substrate: Complex64::new(1.6, 0.3),
        wavelength: GREEN,
        angle: Direction::Angle(0.7),
    };
    const STEP: f64 = 1e-5;
    fn grown(x: f64, sign: f64) -> f64 {
        x * (1.0 + sign * STEP)
    }
    type Change = Box<dyn Fn(&mut Case, f64)>;
    let mut inputs: Vec<Change> = vec![
        Box::new(|case, sign| case.n_i = grown(case.n_i, sign)),
        Box::new(|case, sign| case.substrate.re = grown(case.substrate.re, sign)),
        Box::new(|case, sign| case.substrate.im = grown(case.substrate.im, sign)),
        Box::new(|case, sign| case.wavelength = grown(case.wavelength, sign)),
        Box::new(|case, sign| case.angle = Direction::Angle(grown(0.7, sign))),
    ];
    for i in 0..case.layers.len() {
        inputs.push(Box::new(move |case, sign| case.layers[i].index.re = grown(case.layers[i].index.re, sign)));
        inputs.push(Box::new(move |case, sign| case.layers[i].index.im = grown(case.layers[i].index.im, sign)));
        inputs.push(Box::new(move |case, sign| case.layers[i].thickness = grown(case.layers[i].thickness, sign)));
    }
    for polarisation in BOTH {
        let outputs = |case: &Case| {
            let it = case.stack().response(case.wavelength, Incidence::from(case.angle), polarisation);
            [it.reflectance, it.transmittance, it.absorptance, it.ln_transmittance]
        };
        let here = outputs(&case);
        let mut sums = [0.0; 4];
        for input in &inputs {
            let [up, down] = [1.0, -1.0].map(|sign| {
                let mut changed = case.clone();
                input(&mut changed, sign);
                outputs(&changed)
            });
            for i in 0..4 {
                sums[i] += ((up[i] - down[i]) / (2.0 * STEP * here[i])).abs();
            }
        }
        let exact = condition(&case.stack(), case.wavelength, case.angle, polarisation);
        let exact = [exact.reflectance, exact.transmittance, exact.absorptance, exact.ln_transmittance];
        for (sum, exact) in sums.into_iter().zip(exact) {
            assert!((sum / exact - 1.0).abs() < 1e-7, "{polarisation:?} {sums:?} {exact}");
        }
    }
}

#[test]
fn absorption_is_counted_where_it_happens() {
    let mut random = stream(4, "film/absorption");
    for i in 0..2000 {
        let case = random_case(&mut random, 1 + i % 7);
        for polarisation in BOTH {
            let ours = case.stack().response(case.wavelength, Incidence::from(case.angle), polarisation);
            let sum = ours.reflectance + ours.transmittance + ours.absorptance;
            assert!((sum - 1.0).abs() < 1e-10, "{case:?} {ours:?}");
        }
    }
}

#[test]
fn amplitudes_agree_with_powers_and_with_the_reference() {
    let mut random = stream(5, "film/amplitudes");
    for i in 0..40 {
        let case = random_case(&mut random, i % 6);
        for polarisation in BOTH {
            let ours = case.stack().response(case.wavelength, Incidence::from(case.angle), polarisation);
            let exact = reference(&case.stack(), case.wavelength, case.angle, polarisation);
            let (r, t) = (yardstick::precise::to_complex64(&exact.r), yardstick::precise::to_complex64(&exact.t));
            assert!((ours.r - r).norm() <= 1e-10 * r.norm(), "{case:?} {ours:?} {r}");
            assert!((ours.t - t).norm() <= 1e-10 * t.norm(), "{case:?} {ours:?} {t}");
        }
    }
}

#[test]
fn amplitudes_conserve_energy() {
    // r and t are worked out without a thought of each other; R and T are not.
    let mut random = stream(9, "film/energy");
    for i in 0..400 {
        let mut case = random_case(&mut random, 3 * (i % 8));
        case.substrate.im = 0.0;
        let incidence = Incidence::from(case.angle);
        let q_s = normal_squared(incidence, case.n_i, case.substrate).re.max(0.0).sqrt();
        for polarisation in BOTH {
            let ours = case.stack().response(case.wavelength, incidence, polarisation);
            let through = q_s / (case.n_i * incidence.cos()) * ours.t.norm_sqr();
            let imbalance = (ours.r.norm_sqr() + through - 1.0).abs();
            assert!(imbalance <= 1e-12, "{case:?} {ours:?}: {imbalance:e}");
        }
    }
}

#[test]
fn many_at_once_give_the_same_bits() {
    let mut random = stream(6, "film/batch");
    for i in 0..60 {
        let case = random_case(&mut random, i % 30);
        for polarisation in BOTH {
            let waves = case.stack().waves(Incidence::from(case.angle), polarisation);
            let wavelengths: Vec<f64> = (0..23).map(|i| 2e-7 * 1.35f64.powi(i - 3)).collect();
            let nothing = Powers { reflectance: f64::NAN, transmittance: f64::NAN, absorptance: f64::NAN };
            let mut powers = vec![nothing; wavelengths.len()];
            waves.powers(&wavelengths, &mut powers);
            for (wavelength, powers) in wavelengths.into_iter().zip(powers) {
                let single = waves.response(wavelength);
                let bits = |x: [f64; 3]| x.map(f64::to_bits);
                assert_eq!(
                    bits([powers.reflectance, powers.transmittance, powers.absorptance]),
                    bits([single.reflectance, single.transmittance, single.absorptance]),
                );
            }
        }
    }
}

#[test]
fn transmission_does_not_depend_on_the_side() {
    // Between media of one index, absorbing layers included (Born & Wolf, 7th ed., §1.6.2).
    let mut random = stream(7, "film/reversal");
    for i in 0..200 {
        let mut case = random_case(&mut random, 1 + i % 9);
        case.substrate = clear(case.n_i);
        let mut reversed = case.clone();
        reversed.layers.reverse();
        for polarisation in BOTH {
            let there = case.stack().response(case.wavelength, Incidence::from(case.angle), polarisation);
            let back = reversed.stack().response(case.wavelength, Incidence::from(case.angle), polarisation);
            let (there, back) = (there.ln_transmittance, back.ln_transmittance);
            assert!((there - back).abs() <= 1e-9 * there.abs(), "{case:?}\n{there:?}\n{back:?}");
        }
    }
}

#[test]
fn what_an_opaque_layer_hides_does_not_matter() {
    let mut random = stream(11, "film/hidden");
    for i in 0..300 {
        let hidden = awkward_case(&mut random, i % 7);
        let metal = Complex64::new(0.08, 281.0);
        let mut layers = vec![layer(1.7, 0.0, 1e-7), Layer { index: metal, thickness: 1e-5 }];
        let bare = Case { layers: layers[..1].to_vec(), substrate: metal, ..hidden.clone() };
        layers.extend(&hidden.layers);
        let coated = Case { layers, ..hidden };
        for polarisation in BOTH {
            let kappa = condition(&bare.stack(), bare.wavelength, bare.angle, polarisation);
            let [bare, coated] = [&bare, &coated]
                .map(|case| case.stack().response(case.wavelength, Incidence::from(case.angle), polarisation));
            let bound = LIMIT * EPSILON * (1.0 + kappa.reflectance);
            assert!((bare.reflectance - coated.reflectance).abs() <= bound * bare.reflectance);
            let difference = (bare.transmittance - coated.absorptance).abs();
            let bound = LIMIT * EPSILON * (1.0 + kappa.transmittance);
            assert!(difference <= bound * bare.transmittance, "{bare:?} {coated:?} {kappa:?}");
        }
    }
}

#[test]
fn a_layer_cut_in_two_is_the_same_layer() {
    let mut random = stream(8, "film/split");
    for i in 0..200 {
        let case = random_case(&mut random, 1 + i % 5);
        let mut split = case.clone();
        split.layers = case
            .layers
            .iter()
            .flat_map(|whole| {
                let part = |share: f64| Layer { thickness: share * whole.thickness, ..*whole };
                [part(0.25), part(0.0), part(0.75)]
            })
            .collect();
        for polarisation in BOTH {
            let one = case.stack().response(case.wavelength, Incidence::from(case.angle), polarisation);
            let two = split.stack().response(case.wavelength, Incidence::from(case.angle), polarisation);
            let close = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-9 * a.abs().max(1e-3);
            assert!(close(one.reflectance, two.reflectance) && close(one.absorptance, two.absorptance), "{case:?}");
            assert!(close(one.ln_transmittance, two.ln_transmittance), "{case:?}\n{one:?}\n{two:?}");
            assert!((one.t - two.t).norm() <= 1e-9 * one.t.norm(), "{case:?}\n{one:?}\n{two:?}");
        }
    }
}

#[test]
fn a_half_wave_layer_is_absent() {
    let layers = [layer(2.35, 0.0, GREEN / (2.0 * 2.35))];
    let coated = Stack { n_i: 1.0, layers: &layers, substrate: clear(1.52) };
    let bare = Stack { layers: &[], ..coated };
    let incidence = Incidence::from(Direction::Angle(0.0));
    let (coated, bare) =
        (coated.response(GREEN, incidence, Polarisation::S), bare.response(GREEN, incidence, Polarisation::S));
    assert!((coated.reflectance - bare.reflectance).abs() < 4.0 * EPSILON);
    assert!((coated.t + bare.t).norm() < 8.0 * EPSILON, "half a turn of phase");
}

#[test]
fn no_layers_have_the_signs_of_the_lecture() {
    // E36, E37, E39, E40 at 0.6 rad from air into glass.
    let (theta_1, n) = (0.6_f64, 1.5);
    let theta_2 = (theta_1.sin() / n).asin();
    let (minus, plus) = (theta_1 - theta_2, theta_1 + theta_2);
    let stack = Stack { n_i: 1.0, layers: &[], substrate: clear(n) };
    let [s, p] =
        BOTH.map(|polarisation| stack.response(GREEN, Incidence::from(Direction::Angle(theta_1)), polarisation));
    let close = |ours: Complex64, lecture: f64| (ours - lecture).norm() < 1e-14;
    assert!(close(s.r, -minus.sin() / plus.sin()));
    assert!(close(s.t, 2.0 * theta_2.sin() * theta_1.cos() / plus.sin()));
    assert!(close(p.r, minus.tan() / plus.tan()));
    assert!(close(p.t, 2.0 * theta_2.sin() * theta_1.cos() / (plus.sin() * minus.cos())));
}

#[test]
fn single_quarter_wave_film_has_its_closed_form() {
    // R = ((n₀ n_s − n₁²)/(n₀ n_s + n₁²))²: Born & Wolf, 7th ed., §1.6.4; Macleod, Thin-Film Optical Filters.
    for (n_1, n_s) in [(1.38, 1.52), (2.35, 1.52), (1.38, 4.0), (1.9, 3.5)] {
        let layers = quarter_waves(1, n_1, n_1);
        let stack = Stack { n_i: 1.0, layers: &layers, substrate: clear(n_s) };
        let ours = stack.response(GREEN, Incidence::from(Direction::Angle(0.0)), Polarisation::S).reflectance;
        let closed = ((n_s - n_1 * n_1) / (n_s + n_1 * n_1)).powi(2);
        assert!((ours - closed).abs() < 4.0 * EPSILON, "{ours} {closed}");
    }
}

#[test]
fn quarter_wave_mirrors_have_their_closed_form() {
    // (HL)^N H on a substrate: admittance (n_H/n_L)^(2N) n_H²/n_s (Born & Wolf, 7th ed., §1.6.5; Macleod, ch. 6).
    for pairs in [1, 2, 4, 10, 50] {
        let layers = quarter_waves(2 * pairs + 1, 2.3, 1.35);
        let stack = Stack { n_i: 1.0, layers: &layers, substrate: clear(1.52) };
        let ours = stack.response(GREEN, Incidence::from(Direction::Angle(0.0)), Polarisation::P);
        let y = (2.3_f64 / 1.35).powi(2 * pairs as i32) * 2.3 * 2.3 / 1.52;
        let (r, t) = (((1.0 - y) / (1.0 + y)).powi(2), 4.0 * y / ((1.0 + y) * (1.0 + y)));
        assert!((ours.reflectance - r).abs() < 8.0 * EPSILON);
        assert!((ours.transmittance / t - 1.0).abs() < 1e-12);
    }
}

#[test]
fn byrnes_published_values_are_met() {
    // The Python package tmm, function basic_test in its tests.py, values from an earlier Mathematica program. Its
    // r_p compares electric fields with the opposite sign (Byrnes, arXiv:1603.02720).
    let layers = [layer(2.0, 4.0, 2.0), layer(3.0, 0.3, 3.0)];
    let stack = Stack { n_i: 1.0, layers: &layers, substrate: Complex64::new(1.0, 0.1) };
    let [s, p] = BOTH.map(|polarisation| stack.response(100.0, Incidence::from(Direction::Angle(0.1)), polarisation));
    let close = |ours: Complex64, theirs: Complex64| (ours - theirs).norm() < 1e-14;
    assert!(close(s.r, Complex64::new(-0.6033122656884577, -0.09352218165363202)));
    assert!(close(s.t, Complex64::new(0.4442953347119299, 0.16921936169383078)));
    assert!(close(p.r, Complex64::new(0.6010265425577248, 0.09448914684532368)));
    assert!(close(p.t, Complex64::new(0.4461816467503148, 0.17061408427088917)));
    let powers = [
        (s.reflectance, 0.37273208839139516),
        (s.transmittance, 0.2260449124707926),
        (p.reflectance, 0.3701611037304497),
        (p.transmittance, 0.2282437431413201),
    ];
    for (ours, theirs) in powers {
        assert!((ours - theirs).abs() < 4.0 * EPSILON, "{ours} {theirs}");
    }
}

#[test]
fn textbook_forms_agree_where_they_hold() {
    use light::optics::film::textbook::{characteristic_matrix, recursion, transfer_matrix};
    let layers = [layer(1.38, 0.0, 1e-7), layer(2.0, 0.1, 3e-8), layer(1.2, 0.0, 2e-7)];
    let stack = Stack { n_i: 1.5, layers: &layers, substrate: Complex64::new(1.3, 0.2) };
    for polarisation in BOTH {
        let incidence = Incidence::from(Direction::Angle(1.0));
        let ours = stack.response(GREEN, incidence, polarisation);
        for form in [characteristic_matrix, transfer_matrix, recursion] {
            let theirs = form(&stack, GREEN, incidence, polarisation);
            assert!((ours.reflectance - theirs.reflectance).abs() < 1e-13, "{ours:?} {theirs:?}");
            assert!((ours.transmittance - theirs.transmittance).abs() < 1e-13, "{ours:?} {theirs:?}");
        }
    }
}

#[test]
fn textbook_forms_fail_where_they_are_said_to() {
    use light::optics::film::textbook::{characteristic_matrix, transfer_matrix};
    let incidence = Incidence::from(Direction::Angle(PI / 3.0));
    let gap = [layer(1.0, 0.0, 1e-3)];
    let stack = Stack { n_i: 1.5, layers: &gap, substrate: clear(1.5) };
    assert!(characteristic_matrix(&stack, GREEN, incidence, Polarisation::S).reflectance.is_nan());
    let silver = [layer(0.06, 3.6, 5e-6)];
    let stack = Stack { n_i: 1.0, layers: &silver, substrate: clear(1.5) };
    let incidence = Incidence::from(Direction::Grazing(FRAC_PI_2));
    assert!(transfer_matrix(&stack, GREEN, incidence, Polarisation::S).transmittance > 1e-33);
    assert!(stack.response(GREEN, incidence, Polarisation::S).transmittance < 1e-170);
}
