//! `lesson render`: pictures of scenes.

mod archive;
mod goal;
mod pictures;

pub use goal::{Goal, MOST};
pub use pictures::Shown;

use crate::out::{self, Draft, Folder};
use crate::scene;
use crate::stop::{Stop, plain};
use archive::Archive;
use chapters::parameter::Fault;
use goal::Done;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use light::scene::Scene;
use light::transport::estimate::Estimate;
use light::transport::film::Film;
use light::transport::simple::{INTEGRATORS, Integrator};
use light::transport::{Manner, Method, Renderer};
use pictures::Picture;
use std::io::{IsTerminal, stderr};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// A picture to be made.
#[derive(Debug)]
pub struct Job {
    /// A scene of the lecture, or a file.
    pub scene: String,
    /// When it is good enough.
    pub goal: Goal,
    /// Files for it, of one or several kinds.
    pub out: Vec<PathBuf>,
    /// Of all random numbers.
    pub seed: u64,
    /// Threads; None is one a core.
    pub threads: Option<usize>,
    /// An integrator to read instead of the fast one.
    pub integrator: Option<String>,
    /// The most edges of a path, instead of the scene's.
    pub depth: Option<u32>,
    /// How radiance is shown.
    pub shown: Shown,
    /// A film to go on from, and to keep.
    pub film: Option<PathBuf>,
}

/// The fast integrator's name.
const FAST: &str = "fast";

/// Renders, writes the files, and says where they are.
pub fn serve(job: &Job, folder: &Path) -> Result<ExitCode, Stop> {
    let mut scene = scene::load(&job.scene)?;
    if job.depth.is_some() {
        scene.max_depth = job.depth;
    }
    let method = match &job.integrator {
        Some(name) if plain(name) != FAST => Method::Simple(integrator(name, &scene)?),
        _ => Method::default(),
    };
    // What cannot be written is found before the work, not after.
    let usual = [folder.join(format!("{}.png", scene::stem(&scene.name)))];
    let paths = if job.out.is_empty() { &usual[..] } else { &job.out[..] };
    let places = paths.iter().map(|path| Place::of(path)).collect::<Result<Vec<_>, _>>()?;
    if let Some(threads) = job.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
        pool.map_err(|error| Stop::at("--threads", error))?;
    }
    let manner = Manner { method, seed: job.seed, ..Manner::default() };
    let (film, _) = rendered(&scene, &manner, &job.goal, job.film.as_deref())?;
    let (drafts, found) = drafts(&places, &film, &job.shown)?;
    publish(&drafts, found.broken)
}

/// A picture among the drafts, and how wrong it is.
pub fn drafts(places: &[Place], film: &Film, shown: &Shown) -> Result<(Vec<Draft>, Estimate), Stop> {
    let [width, height] = film.size();
    let halves = film.halves();
    let picture = Picture { width, height, halves: &halves };
    let drafts = places.iter().map(|place| place.folder.draft(&place.name, &(place.kind.encode)(&picture, shown)));
    Ok((drafts.collect::<Result<_, _>>()?, Estimate::of(&halves)))
}

/// Puts files in place, and says where they are, and whether pixels are broken.
pub fn publish(drafts: &[Draft], broken: usize) -> Result<ExitCode, Stop> {
    out::publish(drafts)?;
    let paths: String = drafts.iter().map(|draft| format!("{}\n", draft.path().display())).collect();
    out::print(paths.as_bytes())?;
    if broken > 0 {
        out::say(&format!("error: {broken} pixels are not numbers, and black in the picture"));
        return Ok(ExitCode::from(1));
    }
    Ok(ExitCode::SUCCESS)
}

/// A file to be written.
pub struct Place {
    folder: Folder,
    name: String,
    kind: &'static pictures::Kind,
}

impl Place {
    /// Finds out whether it can be, before the work.
    pub fn of(path: &Path) -> Result<Self, Stop> {
        let kind = pictures::kind(path)?;
        let (folder, name) = Folder::of(path)?;
        Ok(Self { folder, name, kind })
    }
}

/// The integrator of that name, if it can do the scene.
fn integrator(name: &str, scene: &Scene) -> Result<&'static Integrator, Stop> {
    let wanted = plain(name);
    let found = INTEGRATORS.iter().find(|integrator| integrator.name == wanted).ok_or_else(|| {
        let names = std::iter::once(FAST).chain(INTEGRATORS.iter().map(|integrator| integrator.name));
        Stop::from(Fault::unknown("--integrator", name, "no such integrator", names))
    })?;
    if !(found.fits)(&light::transport::Needs::of(scene)) {
        let fitting = INTEGRATORS.iter().filter(|one| (one.fits)(&light::transport::Needs::of(scene)));
        let names: Vec<&str> = std::iter::once(FAST).chain(fitting.map(|one| one.name)).collect();
        let why = format!("{} cannot do this scene ({}); valid here: {}", found.name, found.about, names.join(", "));
        return Err(Stop::at("--integrator", why));
    }
    Ok(found)
}

/// Renders until the goal is met, from a film on and into it if one is named; what came of it is said on standard error.
fn rendered(scene: &Scene, manner: &Manner, goal: &Goal, kept: Option<&Path>) -> Result<(Film, Estimate), Stop> {
    let begun = Instant::now();
    let mut renderer = Renderer::new(scene, manner, 1).map_err(|flaw| Stop::Refused(flaw.to_string()))?;
    let mut film = Film::new(scene.camera.width, scene.camera.height);
    let mut archive = None;
    if let Some(path) = kept {
        let (own, found) = Archive::open(path, scene, manner, &renderer)?;
        (archive, film) = (Some(own), found);
    }
    let goal = &Goal { round: archive.as_ref().map(|_| archive::ROUND), ..*goal };
    let before = film.pairs();
    let made_ready = begun.elapsed();
    let bar = bar(goal);
    let mut found = Estimate::of(&film.halves());
    let working = Instant::now();
    loop {
        let (ranges, now, elapsed) = (film.ranges(), film.pairs() - before, working.elapsed());
        let done = Done { ranges: &ranges, now, elapsed };
        if now > 0 {
            bar.set_position(goal.share(&done, &found));
            bar.set_message(format!("{} spp, error {}", 2 * film.pairs(), percent(&found)));
        }
        let Some(pairs) = goal.next(&done, &found) else { break };
        if let Some(archive) = archive.as_mut().filter(|_| now > 0) {
            archive.look_after(&film, elapsed, elapsed / now * (pairs.end - pairs.start))?;
        }
        // Numbers are made for twice as many whenever they are not enough.
        renderer.expect(pairs.end.next_power_of_two());
        let sums = renderer.sums(0..scene.camera.height, pairs.clone());
        let splats = renderer.splats(pairs.clone());
        film.add_lit(pairs, sums, splats).expect("pairs that are new");
        found = Estimate::of(&film.halves());
    }
    if let Some(archive) = archive.as_mut().filter(|_| film.pairs() > before) {
        archive.save(&film, working.elapsed())?;
    }
    bar.finish_and_clear();
    let earlier = if before > 0 { format!(", {} of them before,", 2 * before) } else { String::new() };
    out::say(&format!(
        "{}: {} × {}, {} spp{earlier} in {:.2} s after {:.2} s to make ready; relative error {} (relMSE {:.3e} ± {:.0e})",
        scene.name,
        scene.camera.width,
        scene.camera.height,
        2 * film.pairs(),
        working.elapsed().as_secs_f64(),
        made_ready.as_secs_f64(),
        percent(&found),
        found.relative_mse,
        found.deviation,
    ));
    if let Some(error) = goal.missed(&found) {
        out::say(&format!("note: the error asked for, {error}, was not reached"));
    }
    Ok((film, found))
}

fn percent(found: &Estimate) -> String {
    format!("{:.2} %", 100.0 * found.relative_error())
}

/// On a terminal only.
fn bar(goal: &Goal) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:24} {percent} % {wide_msg}").expect("a valid template");
    let target = if stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
    ProgressBar::with_draw_target(Some(goal.whole()), target).with_style(style)
}
