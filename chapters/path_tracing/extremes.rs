//! Where renderers break: far from the origin, far too small, and lamps that chance does not find.

use super::scenes::{greens, lit, rendered, small};
use crate::vocabulary::{
    Answer, Bench, Check, Exhibit, Measured, Misled, Quantity, Step, check, exhibit, question, step,
};
use light::scene::{Geometry, Scene};
use light::transport::simple::INTEGRATORS;
use light::transport::{Manner, Method};
use yardstick::statistics::{Moments, t_test};

pub(super) const EXHIBIT: Exhibit = exhibit("extremes", &[], &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "At the extremes",
    "The box a thousand kilometres away, or a few micrometres wide, is the same picture; a lamp of a tenth of a millimetre lights its floor.",
)
.rows(&["C24"])
.questions(&[question(
    "far",
    "Single numbers have 24 binary digits. A room stands 1000 km from the origin. How far apart are neighbouring places there?",
    Answer::Number {
        unit: "m",
        tolerance: 0.05,
        right: |_| f64::from(1e6_f32.next_up() - 1e6_f32),
        slips: &[
            Misled { value: |_| 2f64.powi(-24), reply: "That is a relative distance: it grows with the numbers." },
            Misled { value: |_| 1e6 * 2f64.powi(-52), reply: "So it is with double numbers, which half of this program does without." },
        ],
    },
    "Six centimetres. Whoever wants a room there must first move the origin into it, in double numbers.",
)])
.readout(|_| {
    let of = |name| greens(&rendered(&small(name, 12), &Manner::default(), 16)).mean();
    let quantity = |key, symbol, says, value| Quantity { key, symbol, says, value, unit: "W/(m² sr)" };
    vec![
        quantity("here", "L", "mean of the box", of("cornell")),
        quantity("far", "L", "1000 km away", of("far")),
        quantity("tiny", "L", "a millionth of its size", of("tiny")),
    ]
})
.checks(&[&PLACES, &LAMP]);

const PLACES: Check<fn(Scene) -> Scene> =
    check("places", "the box looks the same 1000 km from the origin, and a millionth of its size")
        .against("the box where it is: the difference of the means of 24 pictures by the same seeds (t-tests)")
        .significant(1e-3)
        .of(
            |_: &mut Bench, kept: fn(Scene) -> Scene| {
                let of =
                    |scene: &Scene, seed| greens(&rendered(scene, &Manner { seed, ..Manner::default() }, 16)).mean();
                let here = small("cornell", 12);
                let tests = ["far", "tiny"].map(|name| {
                    let scene = kept(small(name, 12));
                    let apart: Moments = (0..24).map(|seed| of(&scene, seed) - of(&here, seed)).collect();
                    let at = format!("{name}: {:.1e} ± {:.1e} apart", apart.mean(), apart.standard_error());
                    Measured::new(t_test(&apart, 0.0).p, at, 24)
                });
                super::ways::smallest(tests.into())
            },
            |scene| scene,
        )
        .slip("places kept in single numbers", |mut scene| {
            let single = |point: [f64; 3]| point.map(|x| f64::from(x as f32));
            (scene.camera.origin, scene.camera.target) = (single(scene.camera.origin), single(scene.camera.target));
            for shape in &mut scene.shapes {
                if let Geometry::Quad { vertices } = &mut shape.geometry {
                    *vertices = vertices.map(single);
                }
            }
            scene
        });

const LAMP: Check<fn() -> Vec<Method>> = check("lamp", "a lamp of a tenth of a millimetre lights the floor a metre below")
    .against("ρE/π by Lambert's closed form, at three places of the floor")
    .within(2e-4, "1", "rays in f32 begin a few roundings of the scene's 8 m above the floor: 1e-5 of the lamp's height, squared and halved by cosines")
    .of(
        |_: &mut Bench, methods: fn() -> Vec<Method>| {
            let cases = methods().into_iter().enumerate();
            Measured::worst(cases.flat_map(|(k, method)| {
                [[0.0, 0.0], [0.9, 0.2], [2.0, -1.0]].map(|at| {
                    let (scene, exact) = lit(at, 1e-4, 0.005, 1);
                    let found = greens(&rendered(&scene, &Manner { method, ..Manner::default() }, 32)).mean();
                    (found / exact - 1.0, format!("{at:?}, way {k}"))
                })
            }))
        },
        || vec![Method::default(), Method::Simple(&INTEGRATORS[2]), Method::Simple(&INTEGRATORS[3])],
    )
    .slip("looked for by chance alone", || vec![Method::Simple(&INTEGRATORS[1])]);
