//! `lesson render`: pictures of scenes.

mod archive;
mod clock;
mod error_map;
mod explain;
mod exr;
mod goal;
mod pictures;
mod preview;
mod race;
mod stats;

pub use goal::{Goal, MOST};
pub use pictures::Shown;
pub use race::Course;

use crate::figures::Format;
use crate::out::{self, Draft, Folder};
use crate::scene;
use crate::stop::{Stop, plain};
use archive::Archive;
use chapters::parameter::Fault;
use clock::{Spent, Watch};
use goal::Done;
use light::scene::Scene;
use light::transport::estimate::Estimate;
use light::transport::film::Film;
use light::transport::simple::{INTEGRATORS, Integrator};
use light::transport::{Feature, Manner, Method, Needs, Renderer};
use pictures::Picture;
use preview::Preview;
use stats::{Facts, Round};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

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
    /// A file for the error of every pixel, in false colours.
    pub error_map: Option<PathBuf>,
    /// A file for what is known of the picture and what it took.
    pub stats: Option<PathBuf>,
    /// Whether it is said what the scene needs, and what is left out.
    pub explain: bool,
    /// A race of integrators instead of a picture.
    pub race: Option<Course>,
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
    if let Some(threads) = job.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
        pool.map_err(|error| Stop::at("--threads", error))?;
    }
    let manner = Manner { method, seed: job.seed, ..Manner::default() };
    let name = integrator_name(&method);
    if let Some(course) = &job.race {
        if job.explain {
            out::show(&explain::told(&scene, name, &manner)?)?;
        }
        return race::serve(&scene, course, job.shown);
    }
    // What cannot be written is found before the work, not after.
    let usual = [folder.join(format!("{}.png", scene::stem(&scene.name)))];
    let paths = if job.out.is_empty() { &usual[..] } else { &job.out[..] };
    let places = paths.iter().map(|path| Place::of(path)).collect::<Result<Vec<_>, _>>()?;
    let besides = Besides::of(job)?;
    distinct(job, paths)?;
    if job.explain {
        out::show(&explain::told(&scene, name, &manner)?)?;
    }
    let made = rendered(&scene, &manner, job, places.iter().any(|place| place.kind.features))?;
    let (mut drafts, found) = drafts(&places, &made.film, made.features.as_deref(), &job.shown)?;
    drafts.extend(besides.drafts(&scene, job, &method, &made)?);
    publish(&drafts, found.broken)
}

/// What an integrator is called.
fn integrator_name(method: &Method) -> &'static str {
    match method {
        Method::Fast(_) => FAST,
        Method::Simple(integrator) => integrator.name,
    }
}

/// Files that are no pictures.
struct Besides {
    error_map: Option<(Folder, String, Format)>,
    stats: Option<(Folder, String)>,
}

impl Besides {
    fn of(job: &Job) -> Result<Self, Stop> {
        let extension = |path: &Path| path.extension().map_or(String::new(), |word| plain(&word.to_string_lossy()));
        let error_map = job.error_map.as_ref().map(|path| {
            let format = match extension(path).as_str() {
                "png" => Format::Png,
                "svg" => Format::Svg,
                _ => return Err(refused("--error-map", path, "is no kind of figure that is known; valid: .png, .svg")),
            };
            let (folder, name) = Folder::of(path)?;
            Ok((folder, name, format))
        });
        let stats = job.stats.as_ref().map(|path| match extension(path).as_str() {
            "json" => Folder::of(path),
            _ => Err(refused("--stats", path, "is written as JSON; valid: .json")),
        });
        Ok(Self { error_map: error_map.transpose()?, stats: stats.transpose()? })
    }

    fn drafts(&self, scene: &Scene, job: &Job, method: &Method, made: &Rendered) -> Result<Vec<Draft>, Stop> {
        let [width, height] = made.film.size();
        let spp = 2 * made.film.pairs();
        let mut drafts = Vec::new();
        if let Some((folder, name, format)) = &self.error_map {
            let picture = Picture { width, height, halves: &made.film.halves(), features: None };
            let map = error_map::plot(&picture, &scene.name, spp);
            drafts.push(folder.draft(name, &format.draw(&map))?);
        }
        if let Some((folder, name)) = &self.stats {
            let left_out = explain::left_out(&made.needs, method);
            let facts = Facts {
                scene: &scene.name,
                size: [width, height],
                integrator: integrator_name(method),
                seed: job.seed,
                max_depth: scene.max_depth,
                needs: explain::needed(&made.needs),
                left_out: left_out.iter().map(|one| (one.what, one.why)).collect(),
                bytes: made.bytes,
                making_ready: made.making_ready,
                spent: made.spent,
                spp,
                spp_before: 2 * made.before,
                found: made.found,
                rounds: &made.rounds,
            };
            drafts.push(folder.draft(name, &facts.json())?);
        }
        Ok(drafts)
    }
}

fn refused(option: &str, path: &Path, why: &str) -> Stop {
    Stop::at(format!("{option} {}", path.display()), why)
}

/// Refuses two files of one name, and one that is the scene's own: the last one written would be all there is.
fn distinct(job: &Job, pictures: &[PathBuf]) -> Result<(), Stop> {
    // Their folders are there by now.
    let place = |path: &Path| {
        let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Some(fs::canonicalize(parent).ok()?.join(path.file_name()?))
    };
    let pictures = pictures.iter().map(|path| ("--out", path));
    let besides = [("--film", &job.film), ("--error-map", &job.error_map), ("--stats", &job.stats)];
    let besides = besides.into_iter().filter_map(|(option, path)| Some((option, path.as_ref()?)));
    let scene = PathBuf::from(&job.scene);
    let scene = Some(("the scene", &scene)).filter(|(_, path)| path.is_file());
    let mut seen: Vec<(&str, PathBuf)> = Vec::new();
    for (option, path) in scene.into_iter().chain(pictures).chain(besides) {
        let Some(own) = place(path) else { continue };
        if let Some((other, _)) = seen.iter().find(|(_, taken)| *taken == own) {
            let other = if *other == option { "another one" } else { other };
            return Err(refused(option, path, &format!("is the file of {other} already")));
        }
        seen.push((option, own));
    }
    Ok(())
}

/// A picture among the drafts, and how wrong it is.
pub fn drafts(
    places: &[Place],
    film: &Film,
    features: Option<&[Feature]>,
    shown: &Shown,
) -> Result<(Vec<Draft>, Estimate), Stop> {
    let [width, height] = film.size();
    let halves = film.halves();
    let picture = Picture { width, height, halves: &halves, features };
    let drafts = places.iter().map(|place| place.folder.draft(&place.name, &(place.kind.encode)(&picture, shown)));
    Ok((drafts.collect::<Result<_, _>>()?, Estimate::of(&halves, width)))
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

/// A picture, and what is known of it.
struct Rendered {
    film: Film,
    found: Estimate,
    /// What the camera sees without any light, if that was asked for.
    features: Option<Vec<Feature>>,
    /// After each round.
    rounds: Vec<Round>,
    /// Pairs that there were before.
    before: u32,
    making_ready: Spent,
    /// Without making ready.
    spent: Spent,
    needs: Needs,
    bytes: usize,
}

/// Renders until the goal is met, from a film on and into it if one is named; what came of it is said on standard error.
fn rendered(scene: &Scene, manner: &Manner, job: &Job, features: bool) -> Result<Rendered, Stop> {
    let beginning = Watch::started();
    let mut renderer = Renderer::new(scene, manner, 1).map_err(|flaw| Stop::Refused(flaw.to_string()))?;
    let [width, height] = [scene.camera.width, scene.camera.height];
    let mut film = Film::new(width, height);
    let mut archive = None;
    if let Some(path) = &job.film {
        let (own, found) = Archive::open(path, scene, manner, &renderer)?;
        (archive, film) = (Some(own), found);
    }
    let goal = &Goal { round: archive.as_ref().map(|_| archive::ROUND), ..job.goal };
    let before = film.pairs();
    let making_ready = beginning.spent();
    let mut preview = Preview::new(goal.whole(), job.shown);
    let mut found = Estimate::of(&film.halves(), width);
    let mut rounds = Vec::new();
    let working = Watch::started();
    loop {
        let (ranges, now, elapsed) = (film.ranges(), film.pairs() - before, working.elapsed());
        let done = Done { ranges: &ranges, now, elapsed };
        let share = if now > 0 { goal.share(&done, &found) } else { 0 };
        let Some(pairs) = goal.next(&done, &found) else { break };
        if let Some(archive) = archive.as_mut().filter(|_| now > 0) {
            archive.look_after(&film, elapsed, elapsed / now * (pairs.end - pairs.start))?;
        }
        // Numbers are made for twice as many whenever they are not enough.
        renderer.expect(pairs.end.next_power_of_two());
        let next = pairs.end - pairs.start;
        let after = shares_after(goal, &done, next, &found);
        let mut sums = Vec::with_capacity(width as usize * height as usize);
        for rows in preview::bands(height, preview.is_hidden(), elapsed, now, next) {
            let within = f64::from(rows.start) / f64::from(height);
            let share = share as f64 + within * (after.max(share) - share) as f64;
            if now > 0 {
                let left = preview::left(share / goal.whole() as f64, working.elapsed());
                let left = left.map_or(String::new(), |left| format!(", {} left", preview::clock(left)));
                preview.tell(share as u64, &format!("{} spp, error {}{left}", 2 * film.pairs(), percent(&found)));
            }
            sums.extend(renderer.sums(rows, pairs.clone()));
        }
        let splats = renderer.splats(pairs.clone());
        film.add_lit(pairs, sums, splats).expect("pairs that are new");
        let halves = film.halves();
        found = Estimate::of(&halves, width);
        preview.show(&halves, width);
        let Estimate { relative_mse, deviation, .. } = found;
        rounds.push(Round { spp: 2 * film.pairs(), spent: working.spent(), relative_mse, deviation });
    }
    let spent = working.spent();
    if let Some(archive) = archive.as_mut().filter(|_| film.pairs() > before) {
        archive.save(&film, working.elapsed())?;
    }
    preview.end();
    let earlier = if before > 0 { format!(", {} of them before,", 2 * before) } else { String::new() };
    out::say(&format!(
        "{}: {width} × {height}, {} spp{earlier} in {:.2} s after {:.2} s to make ready; relative error {} (relMSE {:.3e} ± {:.0e})",
        scene.name,
        2 * film.pairs(),
        spent.seconds,
        making_ready.seconds,
        percent(&found),
        found.relative_mse,
        found.deviation,
    ));
    if let Some(error) = goal.missed(&found) {
        out::say(&format!("note: the error asked for, {error}, was not reached"));
    }
    let (needs, bytes) = (*renderer.needs(), renderer.bytes());
    let features = features.then(|| renderer.features(0..height));
    Ok(Rendered { film, found, features, rounds, before, making_ready, spent, needs, bytes })
}

/// How far it will be, of [`Goal::whole`], after `next` more pairs that take as long as those before, each.
fn shares_after(goal: &Goal, done: &Done, next: u32, found: &Estimate) -> u64 {
    let more = f64::from(done.now + next) / f64::from(done.now.max(1));
    let elapsed = done.elapsed.mul_f64(more);
    let found = Estimate { relative_mse: found.relative_mse / more, ..*found };
    let ahead = done.ranges.last().map_or(0, |last| last.end);
    let ranges: Vec<_> =
        done.ranges.iter().cloned().chain(std::iter::once(ahead..ahead.saturating_add(next))).collect();
    goal.share(&Done { ranges: &ranges, now: done.now + next, elapsed }, &found)
}

fn percent(found: &Estimate) -> String {
    format!("{:.2} %", 100.0 * found.relative_error())
}
