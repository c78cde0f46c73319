//! What a scene needs, what was left out of its picture, and what that saves: measured, or not given a number.

use super::clock::Watch;
use crate::run::machine;
use crate::stop::Stop;
use chapters::text::Phrase;
use light::geometry::Structure;
use light::radiosity::Routes;
use light::scene::{Geometry, Scene};
use light::transport::estimate::{colour, relative_mse_less};
use light::transport::film::{Film, Halves};
use light::transport::kernel::Tactics;
use light::transport::radiosity::{Facts, Radiosity, Solver};
use light::transport::{LeftOut, Manner, Method, Needless, Needs, Renderer};
use std::ops::Range;
use views::block::{Block, Column, Details, Heading, Rank, Span, Table, Tone};
use views::tell::Teller;
use yardstick::statistics::Moments;

/// Pixels along the longer side of the picture that is measured.
const SIDE: u32 = 48;
/// How often either way is taken.
const TURNS: u32 = 8;
/// How long a turn lasts at least [CPU s]: long against what a clock tells apart.
const TURN: f64 = 0.02;
/// The most pairs of samples in a turn.
const MOST: u32 = 1 << 10;
/// Shapes up to which trying all of them is tried.
const FEW: usize = 2000;
/// A tactic of the fast integrator, as it is called where it is needed, where it is left out, and where it is measured.
const MORE: &str = "more samples where a mirror, glass or the rim of a lamp is seen";

/// What a scene needs, in words.
pub fn needed(needs: &Needs) -> Vec<String> {
    let lamps = match needs.lamps {
        0 => None,
        1 => Some("rays to one lamp".to_owned()),
        lamps => Some(format!("rays to lamps, one of {lamps} kept")),
    };
    let all = [
        (needs.hierarchy, "a hierarchy of boxes"),
        (needs.environment && !needs.panorama, "light from the sky"),
        (needs.panorama, "light from the sky's image, and rays to where it is bright"),
        (needs.light_paths, "paths from lamps by way of mirrors, glass and polished metal"),
        (needs.glossy, "models of surfaces"),
        (needs.specular || needs.rims, MORE),
        (needs.clear, "ways into what is clear"),
        (needs.absorption, "absorption on the way"),
        (needs.polariser, "polarisation, which a filter sees"),
        (needs.patterns, "places on images, for reflectances that change from place to place"),
        (needs.wavelength, "a wavelength for paths that glass disperses"),
        (needs.lens, "places on the lens"),
    ];
    let others = all.into_iter().filter(|(is_needed, _)| *is_needed).map(|(_, what)| what.to_owned());
    lamps.into_iter().chain(others).collect()
}

/// What is left out of a picture: an integrator to read has less to leave out than the fast one.
pub fn left_out(needs: &Needs, method: &Method) -> Vec<LeftOut> {
    let is_fast = matches!(method, Method::Fast(_));
    let has = |one: &LeftOut| is_fast || one.needless.is_some_and(|needless| !needless.looks);
    needs.left_out().into_iter().filter(has).collect()
}

/// A quotient of two measured numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ratio {
    value: f64,
    /// Its standard error.
    error: f64,
}

impl Ratio {
    /// Of means of numbers that know nothing of each other.
    fn of_means(a: &Moments, b: &Moments) -> Self {
        let relative = |x: &Moments| x.standard_error() / x.mean();
        let value = a.mean() / b.mean();
        Self { value, error: value * relative(a).hypot(relative(b)) }
    }

    /// Of numbers that were measured in pairs: a machine that is slow for a while is so for both.
    fn of_pairs(pairs: &[[f64; 2]]) -> Self {
        let mut logs = Moments::default();
        pairs.iter().for_each(|[a, b]| logs.add((a / b).ln()));
        Self { value: logs.mean().exp(), error: logs.mean().exp() * logs.standard_error() }
    }

    /// With as many digits as its error leaves.
    fn face(self) -> String {
        if !(self.value.is_finite() && self.error.is_finite()) {
            return "not measurable".to_owned();
        }
        let digits = (1.0 - self.error.max(1e-6).log10()).ceil().clamp(0.0, 3.0) as usize;
        format!("× {:.digits$} ± {:.digits$}", self.value, self.error)
    }
}

/// What it takes to make a picture in one manner, over what it takes in another.
#[derive(Clone, Copy, Debug)]
struct Price {
    /// Time of a processor.
    time: Ratio,
    /// Relative mean square error at as many samples, if the pictures are not the same and the error is asked for.
    error: Option<Ratio>,
    /// Whether the pictures are the same, bit for bit.
    is_same: bool,
}

/// The same view, in so few pixels that a turn takes no time.
fn reduced(scene: &Scene) -> Scene {
    let mut small = scene.clone();
    let [width, height] = [scene.camera.width, scene.camera.height];
    let longer = width.max(height);
    let side = |side: u32| {
        let shrunk = u64::from(side) * u64::from(SIDE) / u64::from(longer.max(SIDE));
        (shrunk as u32).max(1)
    };
    (small.camera.width, small.camera.height) = (side(width), side(height));
    small
}

/// A manner of making pictures, ready, and what it has taken.
struct Way {
    renderer: Renderer,
    film: Film,
    /// The picture of each turn.
    turns: Vec<Vec<Halves>>,
}

impl Way {
    fn new(scene: &Scene, manner: &Manner) -> Result<Self, Stop> {
        let renderer = Renderer::new(scene, manner, 1).map_err(|flaw| Stop::Refused(flaw.to_string()))?;
        let film = Film::new(scene.camera.width, scene.camera.height);
        Ok(Self { renderer, film, turns: Vec::new() })
    }

    /// Renders some pairs: the processor's time [s], and they.
    fn rendered(&self, pairs: Range<u32>) -> (f64, Film) {
        let [width, height] = self.film.size();
        let watch = Watch::started();
        let sums = self.renderer.sums(0..height, pairs.clone());
        let splats = self.renderer.splats(pairs.clone());
        let seconds = watch.spent().cpu_seconds;
        let mut film = Film::new(width, height);
        film.add_lit(pairs, sums, splats).expect("an empty film");
        (seconds, film)
    }

    /// Renders so many pairs, the `turn`-th of their kind; the processor's time [s].
    fn turn(&mut self, pairs: u32, turn: u32) -> f64 {
        let (seconds, alone) = self.rendered(turn * pairs..(turn + 1) * pairs);
        self.turns.push(alone.halves());
        self.film.merge(alone).expect("pairs that are new");
        seconds
    }
}

/// Pairs of samples in a turn that lasts long enough. What is rendered on the way to know that also warms up.
fn enough(scene: &Scene, manner: &Manner) -> Result<u32, Stop> {
    let (mut way, mut pairs) = (Way::new(scene, manner)?, 1);
    while pairs < MOST && way.rendered(0..pairs).0 < TURN {
        pairs *= 2;
        way.renderer.expect(pairs);
    }
    Ok(pairs)
}

/// What one manner takes over another, turn by turn: who begins changes, so that a machine that slows down slows both.
fn price(scene: &Scene, with: &Manner, without: &Manner, pairs: u32, is_error_asked: bool) -> Result<Price, Stop> {
    let mut ways = [Way::new(scene, with)?, Way::new(scene, without)?];
    ways.iter_mut().for_each(|way| way.renderer.expect(TURNS * pairs));
    let mut times = Vec::new();
    for turn in 0..TURNS {
        let mut seconds = [0.0; 2];
        for which in if turn % 2 == 0 { [0, 1] } else { [1, 0] } {
            seconds[which] = ways[which].turn(pairs, turn);
        }
        times.push(seconds);
    }
    let is_same = ways[0].film.halves() == ways[1].film.halves();
    let mut error = None;
    if is_error_asked && !is_same {
        // By other numbers, lest their noise be that of what it is held against.
        let mut reference = Way::new(scene, &Manner { seed: with.seed.wrapping_add(1), ..*with })?;
        reference.renderer.expect(2 * TURNS * pairs);
        (0..2 * TURNS).for_each(|turn| _ = reference.turn(pairs, turn));
        let reference = reference.film.halves();
        let errors = ways.each_ref().map(|way| {
            let mut errors = Moments::default();
            for turn in &way.turns {
                let picture: Vec<_> = turn.iter().map(colour).collect();
                errors.add(relative_mse_less(&picture, &reference).0);
            }
            errors
        });
        error = Some(Ratio::of_means(&errors[0], &errors[1]));
    }
    Ok(Price { time: Ratio::of_pairs(&times), error, is_same })
}

/// Something that is done, and how to do without it.
struct LeftIn {
    what: &'static str,
    /// None if that would take too long to try.
    without: Option<Manner>,
}

fn left_in(scene: &Scene, needs: &Needs, manner: &Manner) -> Vec<LeftIn> {
    let mut all = Vec::new();
    if needs.hierarchy {
        let shapes: usize = scene.shapes.iter().map(|shape| shapes(&shape.geometry)).sum();
        let without = (shapes <= FEW).then_some(Manner { structure: Structure::Brute, ..*manner });
        all.push(LeftIn { what: "hierarchy of boxes, over trying all", without });
    }
    if let Method::Fast(tactics) = manner.method {
        let tactic = |what, tactics: Tactics| LeftIn {
            what,
            without: Some(Manner { method: Method::Fast(tactics), ..*manner }),
        };
        if needs.light_paths {
            all.push(tactic("paths from lamps, over meeting them by chance", Tactics { caustics: false, ..tactics }));
        }
        if needs.specular || needs.rims {
            all.push(tactic(MORE, Tactics { extra: 1, ..tactics }));
        }
        let what = "samples as two of each pixel advise, over as many everywhere";
        all.push(tactic(what, Tactics { pilot: false, ..tactics }));
        if needs.lamps > 1 {
            let what = "a lamp chosen by what it would bring, over blindly";
            all.push(tactic(what, Tactics { blind_choice: true, ..tactics }));
        }
    }
    all
}

fn shapes(geometry: &Geometry) -> usize {
    match geometry {
        Geometry::Mesh { mesh, .. } => mesh.triangles.len(),
        Geometry::Box { .. } => 6,
        Geometry::Quad { .. } | Geometry::Sphere { .. } | Geometry::Disc { .. } => 1,
    }
}

/// What is told of a scene and the manner in which its picture is to be made: it takes some seconds.
pub fn told(scene: &Scene, integrator: &str, manner: &Manner) -> Result<Vec<Block>, Stop> {
    // One thread: its own time is then the work, and none goes by waiting for others.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(|why| Stop::at("--explain", why))?;
    pool.install(|| tell(scene, integrator, manner))
}

fn tell(scene: &Scene, integrator: &str, manner: &Manner) -> Result<Vec<Block>, Stop> {
    let small = reduced(scene);
    let pairs = enough(&small, manner)?;
    let renderer = Renderer::new(scene, manner, 1).map_err(|flaw| Stop::Refused(flaw.to_string()))?;
    let (needs, bytes) = (*renderer.needs(), renderer.bytes());
    let patches = renderer.radiosity().map(patches);
    drop(renderer);

    let mut out = Vec::new();
    let mut same = true;
    for LeftOut { what, why, needless } in left_out(&needs, &manner.method) {
        let time = match needless {
            None => "nothing to do".to_owned(),
            Some(needless) => {
                let price = price(&small, &Manner { needless, ..*manner }, manner, pairs, false)?;
                same &= price.is_same;
                price.time.face()
            }
        };
        out.push([time, format!("{what}: {why}")]);
    }
    let everything = Manner { needless: Needless::EVERYTHING, ..*manner };
    let everything = price(&small, &everything, manner, pairs, false)?;
    same &= everything.is_same;
    out.push([everything.time.face(), "everything of it together".to_owned()]);

    let mut kept = Vec::new();
    for LeftIn { what, without } in left_in(scene, &needs, manner) {
        let faces = match without {
            None => ["not measured".to_owned(), "of so many shapes that takes too long".to_owned()],
            Some(without) => {
                let price = price(&small, manner, &without, pairs, true)?;
                let error = price.error.map_or("the same".to_owned(), Ratio::face);
                [price.time.face(), error]
            }
        };
        let [time, error] = faces;
        kept.push([time, error, what.to_owned()]);
    }

    let [width, height] = [small.camera.width, small.camera.height];
    let mut list: Vec<Block> = vec![part(&format!("{} needs", scene.name))];
    list.extend(needed(&needs).into_iter().map(|what| text(2, Tone::Plain, &what)));
    list.push(text(2, Tone::Dim, &format!("in all {bytes} bytes of shapes, made ready for {integrator}")));
    let mut blocks = vec![Block::Group(list)];
    blocks.extend(patches);
    let verdict = if same { "the same picture, bit for bit" } else { "and ANOTHER picture, which should not be" };
    blocks.push(Block::Group(vec![
        part("Left out"),
        text(2, Tone::Dim, &format!("time with it, over the time without: {verdict}")),
        table(&[-16, 0], out.iter().map(<[String; 2]>::as_slice)),
    ]));
    if !kept.is_empty() {
        blocks.push(Block::Group(vec![
            part("Left in"),
            text(2, Tone::Dim, "time and squared error with it, over those without, at as many samples"),
            table(&[-16, -16, 0], kept.iter().map(<[String; 3]>::as_slice)),
        ]));
    }
    let how = format!(
        "Measured on {width} × {height} pixels of the same view, {TURNS} × {} spp of either way in turn, on one thread and by its own time; errors against {} spp by other numbers; ± is the standard error over the turns.",
        2 * pairs,
        4 * TURNS * pairs,
    );
    blocks.push(text(0, Tone::Dim, &how));
    blocks.extend(Teller::english(Details::default()).machine(&machine()));
    Ok(vec![Block::section(blocks)])
}

/// Samples whose patches are told of: the first, and the last if nothing is said.
const TOLD: [u32; 2] = [0, 63];

/// What is told of a picture's patches.
fn patches(radiosity: &Radiosity) -> Block {
    let found = TOLD.map(|sample| radiosity.of_sample(sample).facts);
    let [first, last] = &found;
    let mut list = vec![part("Patches")];
    let backs =
        if first.backs > 0 { format!(", of them {} backs that light gets to", first.backs) } else { String::new() };
    let head = format!(
        "{} faces{backs}; {} patches for the first two samples of a pixel, {} from the 33rd to the 64th: as the root of their number",
        first.faces, first.patches, last.patches
    );
    list.push(text(2, Tone::Plain, &head));
    for facts in &found {
        let Facts { patches, routes, sums: [least, most], solver, residual, .. } = facts;
        let by = match solver {
            Solver::Direct => "elimination without differences".to_owned(),
            Solver::Conjugate(steps) => format!("{steps} steps of conjugate gradients"),
            Solver::Bounces(bounces) => format!("{bounces} bounces, as many as paths may have"),
        };
        let Routes { behind, closed, points, contour, hidden } = routes;
        list.push(text(
            2,
            Tone::Plain,
            &format!(
                "{patches} patches: form factors of {closed} pairs by closed forms, {contour} around both, {points} from afar; {behind} behind each other; {hidden} hidden at least in part, as rays between 3 × 3 places of either tell"
            ),
        ));
        let sums = format!(
            "what one sees of all others sums to {least:.4} … {most:.4}; solved by {by}, residual {residual:.1e}"
        );
        list.push(text(4, Tone::Plain, &sums));
    }
    let change = 100.0 * (first.mean / last.mean - 1.0).abs();
    let change = if change.is_finite() { format!("{change:.2} %") } else { "nothing".to_owned() };
    let wrong = format!(
        "From the one to the other the mean of what they send back changes by {change}: about as much is wrong with the first, and with the last less; no number of samples, and no error that is told, shows it."
    );
    list.push(text(2, Tone::Dim, &wrong));
    Block::Group(list)
}

fn part(text: &str) -> Block {
    let text = vec![Span::new(Tone::Heading, Phrase::verbatim(text))];
    Block::Heading(Heading { rank: Rank::Part, text, address: None, rows: Vec::new() })
}

fn text(indent: usize, tone: Tone, text: &str) -> Block {
    Block::text(indent, tone, Phrase::verbatim(text))
}

fn table<'a>(widths: &[i32], rows: impl Iterator<Item = &'a [String]>) -> Block {
    let columns = widths.iter().map(|width| Column { head: Phrase::default(), width: *width }).collect();
    let row = |cells: &[String]| cells.iter().map(|cell| Span::verbatim(Tone::Plain, cell.clone())).collect();
    Block::Table(Table { caption: Phrase::default(), columns, rows: rows.map(row).collect(), headed: false, inset: 2 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use light::scene::builtin::BUILTIN;
    use light::transport::simple::INTEGRATORS;

    fn scene(name: &str) -> Scene {
        (BUILTIN.iter().find(|builtin| builtin.name == name).expect("a scene of the lecture").make)()
    }

    /// Without time, which no test may assert.
    fn few(scene: &Scene) -> Scene {
        let mut few = reduced(scene);
        (few.camera.width, few.camera.height) = (8, 8);
        few
    }

    #[test]
    fn all_that_is_left_out_is_left_out_of_the_same_picture() {
        for name in ["cornell", "glass", "metals"] {
            let (scene, usual) = (few(&scene(name)), Manner::default());
            let renderer = Renderer::new(&scene, &usual, 1).expect("a scene of the lecture");
            let left_out = left_out(renderer.needs(), &usual.method);
            let needless = left_out.iter().filter_map(|one| one.needless).chain([Needless::EVERYTHING]);
            for needless in needless {
                let price = price(&scene, &Manner { needless, ..usual }, &usual, 2, true).expect("both ways");
                assert!(price.is_same && price.error.is_none(), "{name}: {needless:?}");
                assert!(price.time.value > 0.0 && price.time.error >= 0.0);
            }
        }
    }

    #[test]
    fn what_is_left_in_earns_its_place_in_error() {
        // Glass: light by way of it, and the samples where it is seen, each take a good part of the error off.
        let (mut scene, usual) = (few(&scene("glass")), Manner::default());
        (scene.camera.width, scene.camera.height) = (16, 16);
        let renderer = Renderer::new(&scene, &usual, 1).expect("a scene of the lecture");
        let kept = left_in(&scene, renderer.needs(), &usual);
        let names: Vec<_> = kept.iter().map(|one| one.what.split(' ').next()).collect();
        assert_eq!(names, [Some("paths"), Some("more"), Some("samples")]);
        // Of the last, light on its way through glass decides little here.
        for LeftIn { what, without } in kept.into_iter().take(2) {
            let price = price(&scene, &usual, &without.expect("a way"), 64, true).expect("both ways");
            let error = price.error.expect("another picture");
            // By a good part, and not by chance.
            assert!(!price.is_same && error.value + 3.0 * error.error < 1.0, "{what}: {error:?}");
        }
    }

    #[test]
    fn integrators_to_read_are_told_only_of_what_they_could_do() {
        // The box as if its lamp had no rim: then nothing in it is worth more samples.
        let needs = Needs { rims: false, ..Needs::of(&scene("cornell")) };
        let simple = left_out(&needs, &Method::Simple(&INTEGRATORS[0]));
        assert!(simple.iter().any(|one| one.what == "absorption on the way"));
        let foreign = ["paths from lamps", MORE];
        assert!(!simple.iter().any(|one| foreign.contains(&one.what)));
        let fast = left_out(&needs, &Method::default());
        assert!(foreign.iter().all(|what| fast.iter().any(|one| one.what == *what)));
        assert_eq!(needed(&needs), ["rays to one lamp", "a hierarchy of boxes"]);
    }

    #[test]
    fn a_mesh_is_not_tried_by_brute_force() {
        let mesh = scene("mesh");
        let renderer = Renderer::new(&mesh, &Manner::default(), 1).expect("a scene of the lecture");
        let kept = left_in(&mesh, renderer.needs(), &Manner::default());
        assert!(kept.iter().any(|one| one.what.starts_with("hierarchy") && one.without.is_none()));
    }

    #[test]
    fn ratios_keep_the_digits_that_their_error_leaves() {
        let face = |value, error| Ratio { value, error }.face();
        assert_eq!(face(1.4567, 0.023), "× 1.457 ± 0.023");
        assert_eq!(face(1.4567, 0.0), "× 1.457 ± 0.000");
        assert_eq!(face(0.21, 0.4), "× 0.21 ± 0.40");
        assert_eq!(face(f64::NAN, 0.1), "not measurable");
        let moments = |all: &[f64]| {
            let mut moments = Moments::default();
            all.iter().for_each(|x| moments.add(*x));
            moments
        };
        // Twice as long each time, give or take 10 %.
        let logs = Ratio::of_pairs(&[[2.2, 1.0], [20.0, 10.0], [4.0, 2.2]]);
        assert!(
            (logs.value - 2.0).abs() < 1e-12 && (logs.error / (2.0 * 1.1f64.ln() / 3f64.sqrt()) - 1.0).abs() < 1e-12
        );
        let means = Ratio::of_means(&moments(&[3.0, 5.0]), &moments(&[2.0, 2.0]));
        assert!((means.value - 2.0).abs() < 1e-12 && (means.error - 0.5).abs() < 1e-12, "{means:?}");
    }

    #[test]
    fn a_view_keeps_its_shape() {
        let mut wide = scene("cornell");
        (wide.camera.width, wide.camera.height) = (1920, 1080);
        let small = reduced(&wide).camera;
        assert_eq!([small.width, small.height], [48, 27]);
        (wide.camera.width, wide.camera.height) = (8000, 1);
        assert_eq!(reduced(&wide).camera.height, 1);
        (wide.camera.width, wide.camera.height) = (7, 3);
        let small = reduced(&wide).camera;
        assert_eq!([small.width, small.height], [7, 3]);
    }
}
