//! `lesson render`: pictures of scenes.

mod goal;
mod pictures;

pub use goal::{Goal, MOST};

use crate::out::{self, Folder};
use crate::scene;
use crate::stop::{Stop, plain};
use chapters::parameter::Fault;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use light::scene::Scene;
use light::tone::Curve;
use light::transport::estimate::Estimate;
use light::transport::film::Film;
use light::transport::simple::{INTEGRATORS, Integrator};
use light::transport::{Manner, Method, Renderer};
use pictures::{Picture, Shown};
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
    /// How radiance becomes a screen's.
    pub curve: Curve,
    /// Stops [1]: radiance is shown times 2 to that.
    pub exposure: f64,
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
    let (film, found) = rendered(&scene, &manner, &job.goal)?;

    let [width, height] = film.size();
    let halves = film.halves();
    let picture = Picture { width, height, halves: &halves };
    let shown = Shown { curve: job.curve, exposure: job.exposure };
    let drafts = places
        .iter()
        .map(|place| place.folder.draft(&place.name, &(place.kind.encode)(&picture, &shown)))
        .collect::<Result<Vec<_>, _>>()?;
    out::publish(&drafts)?;
    let paths: String = drafts.iter().map(|draft| format!("{}\n", draft.path().display())).collect();
    out::print(paths.as_bytes())?;
    if found.broken > 0 {
        out::say(&format!("error: {} pixels are not numbers, and black in the picture", found.broken));
        return Ok(ExitCode::from(1));
    }
    Ok(ExitCode::SUCCESS)
}

/// A file to be written.
struct Place {
    folder: Folder,
    name: String,
    kind: &'static pictures::Kind,
}

impl Place {
    fn of(path: &Path) -> Result<Self, Stop> {
        let kind = pictures::kind(path)?;
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let folder = Folder::open(parent)?;
        folder.expect(&name)?;
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

/// Renders until the goal is met; what came of it is said on standard error.
fn rendered(scene: &Scene, manner: &Manner, goal: &Goal) -> Result<(Film, Estimate), Stop> {
    let begun = Instant::now();
    let mut renderer = Renderer::new(scene, manner, 1).map_err(|flaw| Stop::Refused(flaw.to_string()))?;
    let made_ready = begun.elapsed();
    let mut film = Film::new(scene.camera.width, scene.camera.height);
    let bar = bar(goal);
    let mut found = Estimate::default();
    let working = Instant::now();
    while let Some(pairs) = goal.next(film.pairs(), working.elapsed(), &found) {
        renderer.expect(pairs.end);
        let sums = renderer.sums(0..scene.camera.height, pairs.clone());
        let splats = renderer.splats(pairs.clone());
        film.add_lit(pairs, sums, splats).expect("pairs that are new");
        found = Estimate::of(&film.halves());
        bar.set_position(goal.share(film.pairs(), working.elapsed(), &found));
        bar.set_message(format!("{} spp, error {}", 2 * film.pairs(), percent(&found)));
    }
    bar.finish_and_clear();
    out::say(&format!(
        "{}: {} × {}, {} spp in {:.2} s after {:.2} s to make ready; relative error {} (relMSE {:.3e} ± {:.0e})",
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
