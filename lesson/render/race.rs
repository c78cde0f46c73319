//! Integrators on one scene, each as long as the others: error against time.

use super::clock::{Spent, Watch, efficiency};
use super::goal::{Done, Goal};
use super::preview::{Preview, clock, left};
use super::{Shown, fitting};
use crate::figures::Format;
use crate::out::{self, Folder};
use crate::run::machine;
use crate::scene;
use crate::stop::Stop;
use chapters::figure::{Axis, Chart, Hue, Mark, Plot, Shape};
use chapters::text::Phrase;
use light::bsdf::Rgb;
use light::scene::Scene;
use light::transport::estimate::{Estimate, colour, relative_mse_less};
use light::transport::film::{Film, Halves};
use light::transport::{Manner, Renderer};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;
use views::block::{Block, Column, Details, Heading, Rank, Span, Table, Tone};
use views::number::significant;
use views::tell::Teller;
use yardstick::order;

/// A race to be run.
#[derive(Clone, Debug)]
pub struct Course {
    /// The processors' time that each integrator has.
    pub time: Duration,
    /// The most samples a pixel.
    pub spp: Option<u32>,
    /// Of all random numbers.
    pub seed: u64,
    /// Where the figure goes, if one is wanted: a file of its kind, or a folder; and as what in a folder, if that is said.
    pub plot: Option<(PathBuf, Option<Format>)>,
}

/// How much longer than an integrator the picture is made that stands for the truth: its own noise is then an eighth of the
/// fast one's, and is taken off besides.
const LONGER: u32 = 8;
/// More pairs than the last point by which the next one is told, lest the points at the end of the time lie on each other.
const APART: f64 = 1.5;

/// What was found of an integrator after some of its time.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Point {
    spp: u32,
    cpu_seconds: f64,
    relative_mse: f64,
    deviation: f64,
}

impl Point {
    fn efficiency(&self) -> f64 {
        efficiency(self.relative_mse, self.cpu_seconds)
    }
}

/// An integrator, and its points.
struct Lane {
    name: &'static str,
    about: &'static str,
    points: Vec<Point>,
    /// Pixels that are not numbers in the end.
    broken: usize,
}

/// A picture while it is made, with what its pairs took.
struct Run {
    film: Film,
    spent: Spent,
}

/// Renders round by round, as long as the processors' time lasts; what there is after each is handed to `after`.
fn run(
    scene: &Scene,
    manner: &Manner,
    goal: &Goal,
    mut after: impl FnMut(&Run, &Estimate),
) -> Result<(Run, Estimate), Stop> {
    let mut renderer = Renderer::new(scene, manner, 1).map_err(|flaw| Stop::Refused(flaw.to_string()))?;
    let film = Film::new(scene.camera.width, scene.camera.height);
    let (mut run, mut found) = (Run { film, spent: Spent::default() }, Estimate::default());
    loop {
        let ranges = run.film.ranges();
        let done = Done { ranges: &ranges, now: run.film.pairs(), elapsed: run.spent.cpu() };
        let Some(pairs) = goal.next(&done, &found) else { return Ok((run, found)) };
        let watch = Watch::started();
        renderer.expect(pairs.end.next_power_of_two());
        let sums = renderer.sums(0..scene.camera.height, pairs.clone());
        let splats = renderer.splats(pairs.clone());
        run.film.add_lit(pairs, sums, splats).expect("pairs that are new");
        run.spent = run.spent.plus(watch.spent());
        found = Estimate::of(&run.film.halves(), scene.camera.width);
        after(&run, &found);
    }
}

/// Runs the race, prints what came of it, and draws it if that is asked for.
pub fn serve(scene: &Scene, course: &Course, shown: Shown) -> Result<ExitCode, Stop> {
    let plot = course.plot.as_ref().map(|(path, format)| {
        let of_file = Format::of(path).filter(|_| !path.is_dir());
        if let Some(own) = of_file {
            if format.is_some_and(|format| format != own) {
                return Err(Stop::at("--format", format!("is not that of {}", path.display())));
            }
            let (folder, name) = Folder::of(path)?;
            return Ok((folder, name, own));
        }
        let (folder, format) = (Folder::open(path)?, format.unwrap_or(Format::Png));
        let name = format.file(&format!("render/{}/race", scene::stem(&scene.name)));
        folder.expect(&name)?;
        Ok::<_, Stop>((folder, name, format))
    });
    let plot = plot.transpose()?;
    let entrants: Vec<_> = fitting(scene).map(|method| (method.name(), method.about(), method)).collect();

    let goal = Goal { spp: course.spp, time: Some(course.time), ..Goal::default() };
    // The truth takes as long as the course says, whatever number of samples that is.
    let longer = Goal { spp: None, time: Some(course.time * LONGER), ..goal };
    let parts = entrants.len() as u32 + LONGER;
    let mut preview = Preview::new(1000, shown);
    let begun = Watch::started();
    let tell = |preview: &mut Preview, part: f64, name: &str, spent: Spent, time: Duration, weight: f64| {
        let share = (part + weight * (spent.cpu_seconds / time.as_secs_f64()).min(1.0)) / f64::from(parts);
        let left = left(share, Duration::from_secs_f64(begun.spent().seconds))
            .map_or(String::new(), |left| format!(", {} left", clock(left)));
        preview.tell((1000.0 * share) as u64, &format!("{name}{left}"));
    };
    let width = scene.camera.width;
    let seed = course.seed.wrapping_add(1);
    let manner = Manner { seed, ..Manner::default() };
    let (truth, sure) = run(scene, &manner, &longer, |run, _| {
        preview.show(&run.film.halves(), width);
        tell(&mut preview, 0.0, "reference", run.spent, course.time * LONGER, f64::from(LONGER));
    })?;
    let reference = truth.film.halves();

    let mut lanes = Vec::new();
    for (at, (name, about, method)) in (0_u32..).zip(entrants) {
        let manner = Manner { method, seed: course.seed, ..Manner::default() };
        let mut points: Vec<Point> = Vec::new();
        let (mut last, mut broken) = (None, 0);
        run(scene, &manner, &goal, |run, found| {
            let halves = run.film.halves();
            preview.show(&halves, width);
            tell(&mut preview, f64::from(at + LONGER), name, run.spent, course.time, 1.0);
            let point = point(&halves, &reference, 2 * run.film.pairs(), run.spent.cpu_seconds);
            if points.last().is_none_or(|before| f64::from(point.spp) >= APART * f64::from(before.spp)) {
                points.push(point);
                last = None;
            } else {
                last = Some(point);
            }
            broken = found.broken;
        })?;
        // The last one always counts.
        points.extend(last);
        lanes.push(Lane { name, about, points, broken });
    }
    preview.end();

    let reference = format!(
        "{}, seed {seed}, {} spp in {:.1} CPU s; its own noise, relMSE {:.1e} by its halves, is taken off",
        manner.method.name(),
        2 * truth.film.pairs(),
        truth.spent.cpu_seconds,
        sure.relative_mse,
    );
    out::show(&told(scene, course, &lanes, &reference))?;
    if let Some((folder, name, format)) = plot {
        let draft = folder.draft(&name, &format.draw(&figure(scene, &lanes)))?;
        let path = format!("{}\n", draft.path().display());
        out::publish(&[draft])?;
        out::print(path.as_bytes())?;
    }
    let broken: usize = lanes.iter().map(|lane| lane.broken).sum::<usize>() + sure.broken;
    if broken > 0 {
        out::say(&format!("error: {broken} pixels are not numbers, and left out of all errors"));
        return Ok(ExitCode::from(1));
    }
    Ok(ExitCode::SUCCESS)
}

fn point(halves: &[Halves], reference: &[Halves], spp: u32, cpu_seconds: f64) -> Point {
    let picture: Vec<Rgb<f64>> = halves.iter().map(colour).collect();
    let (relative_mse, deviation) = relative_mse_less(&picture, reference);
    Point { spp, cpu_seconds, relative_mse, deviation }
}

/// The order in which the squared error falls with the samples; none by fewer than three points.
fn fall(points: &[Point]) -> Option<f64> {
    let of: Vec<_> = points.iter().map(|point| (f64::from(point.spp), point.relative_mse)).collect();
    (points.len() > 2).then(|| order::slope(&of)).flatten()
}

fn told(scene: &Scene, course: &Course, lanes: &[Lane], reference: &str) -> Vec<Block> {
    let plain = |indent, tone, text: String| Block::text(indent, tone, Phrase::verbatim(text));
    let [width, height] = [scene.camera.width, scene.camera.height];
    let title = format!("{}, {width} × {height}: error against run time", scene.name);
    let text = vec![Span::new(Tone::Heading, Phrase::verbatim(title))];
    let time = course.time.as_secs_f64();
    let head = vec![
        Block::Heading(Heading { rank: Rank::Part, text, address: None, rows: Vec::new() }),
        plain(
            2,
            Tone::Dim,
            format!(
                "{time} CPU s each, of all threads, without making ready; error: relMSE, the mean over pixels and channels of (x − ref)²/(ref² + 0.01); ±: its standard error, by how pixels differ, the reference's noise included, which all rows share; efficiency: 1/(relMSE × CPU s)"
            ),
        ),
        plain(2, Tone::Dim, format!("reference: {reference}")),
    ];
    let mut blocks = vec![Block::Group(head)];
    for Lane { name, about, points, .. } in lanes {
        let fall = fall(points).map_or(String::new(), |slope| format!("; relMSE falls as spp^{slope:.2}"));
        let title = vec![
            Span::new(Tone::Strong, Phrase::verbatim(*name)),
            Span::new(Tone::Plain, Phrase::verbatim(format!(": {about}{fall}"))),
        ];
        let columns = [("spp", -10), ("relMSE", -12), ("±", -9), ("CPU s", -8), ("efficiency", -12)];
        let table = Table {
            caption: Phrase::verbatim(*name),
            columns: columns.map(|(head, width)| Column { head: Phrase::verbatim(head), width }).into(),
            rows: points.iter().map(cells).collect(),
            headed: true,
            inset: 4,
        };
        blocks.push(Block::Group(vec![Block::paragraph(2, 4, title), Block::Table(table)]));
    }
    blocks.extend(Teller::english(Details::default()).machine(&machine()));
    vec![Block::section(blocks)]
}

fn cells(point: &Point) -> Vec<Span> {
    let efficiency = point.efficiency();
    // Below its own uncertainty an error is no number to divide by.
    let is_known = point.relative_mse > point.deviation;
    let cells = [
        point.spp.to_string(),
        format!("{:.3e}", point.relative_mse),
        format!("{:.0e}", point.deviation),
        significant(point.cpu_seconds, 3),
        if is_known { significant(efficiency, 3) } else { "unknown".to_owned() },
    ];
    cells.map(|cell| Span::verbatim(Tone::Plain, cell)).into()
}

/// Error against time on logarithmic axes.
fn figure(scene: &Scene, lanes: &[Lane]) -> Plot {
    const SHAPES: [Shape; 5] = [Shape::Disc, Shape::Square, Shape::Triangle, Shape::Diamond, Shape::Ring];
    let mut chart = Chart::new("", Axis::log("CPU time", "s"), Axis::log("relMSE", ""));
    for (at, lane) in lanes.iter().enumerate() {
        let points = lane.points.iter().filter(|point| point.relative_mse > 0.0);
        chart = chart.with(Mark::Points {
            label: lane.name.to_owned(),
            hue: if at == 0 { Hue::Ours } else { Hue::Nth(at as u8 - 1) },
            shape: SHAPES[at % SHAPES.len()],
            joined: true,
            points: points.map(|point| [point.cpu_seconds, point.relative_mse]).collect(),
        });
    }
    let [width, height] = [scene.camera.width, scene.camera.height];
    Plot::of(format!("{}, {width} × {height}: error against run time", scene.name), chart)
}

#[cfg(test)]
mod tests {
    use super::*;
    use chapters::figure::Panel;
    use light::scene::builtin::BUILTIN;

    fn small(name: &str) -> Scene {
        let mut scene = (BUILTIN.iter().find(|one| one.name == name).expect("a scene of the lecture").make)();
        (scene.camera.width, scene.camera.height) = (8, 8);
        scene
    }

    #[test]
    fn errors_fall_as_work_grows_and_are_those_against_the_truth() {
        let scene = small("cornell");
        let of = |spp, seed| {
            let goal = Goal { spp: Some(spp), ..Goal::default() };
            let mut seen = Vec::new();
            let manner = Manner { seed, ..Manner::default() };
            let (run, _) =
                run(&scene, &manner, &goal, |run, _| seen.push((run.film.pairs(), run.film.halves()))).unwrap();
            assert_eq!(2 * run.film.pairs(), spp);
            seen
        };
        let (_, reference) = of(4096, 2).pop().unwrap();
        let seen = of(64, 1);
        assert_eq!(seen.iter().map(|(pairs, _)| *pairs).collect::<Vec<_>>(), [1, 2, 4, 8, 16, 32]);
        let points: Vec<_> = seen.iter().map(|(pairs, halves)| point(halves, &reference, 2 * pairs, 1.0)).collect();
        // Between independent numbers and what a net reaches on the box; of 64 pixels known to 0.3.
        let fall = fall(&points).unwrap();
        assert!((-1.6..-0.7).contains(&fall), "{fall}");
        let [first, .., last] = &points[..] else { panic!("{points:?}") };
        assert!(last.relative_mse > 3.0 * last.deviation && first.relative_mse > 8.0 * last.relative_mse);
        // The same seed is no truth: its noise is the picture's own, and taking it off leaves less than nothing.
        let own = point(&seen[5].1, &seen[5].1, 64, 1.0);
        assert!(own.relative_mse < 0.0);
    }

    #[test]
    fn what_is_not_known_is_given_no_efficiency() {
        let point = |relative_mse, deviation| Point { spp: 4, cpu_seconds: 0.5, relative_mse, deviation };
        let face = |point| cells(&point)[4].text.to_string();
        assert_eq!(face(point(0.01, 0.001)), "200");
        assert_eq!(face(point(0.01, 0.02)), "unknown");
        assert_eq!(face(point(-0.01, 0.001)), "unknown");
        assert_eq!(fall(&[point(1.0, 0.0); 2]), None);
    }

    #[test]
    fn the_figure_has_every_lane_and_no_point_that_a_logarithm_lacks() {
        let point = |cpu_seconds, relative_mse| Point { spp: 2, cpu_seconds, relative_mse, deviation: 0.0 };
        let lane = |name, points| Lane { name, about: "", points, broken: 0 };
        let lanes = [lane("fast", vec![point(1.0, 0.1), point(2.0, -0.1)]), lane("both", vec![point(3.0, 0.2)])];
        let Panel::Chart(chart) = figure(&small("cornell"), &lanes).panels.remove(0) else { panic!("no chart") };
        let of = |mark: &Mark| match mark {
            Mark::Points { label, points, .. } => (label.clone(), points.clone()),
            other => panic!("{other:?}"),
        };
        let found: Vec<_> = chart.marks.iter().map(of).collect();
        assert_eq!(found, [("fast".to_owned(), vec![[1.0, 0.1]]), ("both".to_owned(), vec![[3.0, 0.2]])]);
    }
}
