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
mod work;

pub use goal::{Goal, MOST};
pub use pictures::{About, Picture, Shown};
pub use race::Course;

use crate::figures::Format;
use crate::film;
use crate::out::{self, Draft, Folder};
use crate::scene;
use crate::stop::{Stop, plain};
use chapters::parameter::Fault;
use light::scene::{Environment, Light, Scene};
use light::transport::estimate::Estimate;
use light::transport::{Manner, Method, Needs};
use stats::Facts;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use work::{Rendered, rendered};

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
    /// Width and height [pixels], instead of the scene's; of one that is left out the picture's shape stays.
    pub size: [Option<u32>; 2],
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

/// Renders, writes the files, and says where they are.
pub fn serve(job: &Job, folder: &Path) -> Result<ExitCode, Stop> {
    let mut scene = scene::load(&job.scene)?;
    if job.depth.is_some() {
        scene.max_depth = job.depth;
    }
    resize(&mut scene, job.size)?;
    if is_dark(&scene) {
        out::say("note: nothing in it emits light: the picture is black");
    }
    let method = match &job.integrator {
        Some(name) => integrator(name, &scene)?,
        None => usual(&scene)?,
    };
    if let Some(threads) = job.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
        pool.map_err(|error| Stop::at("--threads", error))?;
    }
    let manner = Manner { method, seed: job.seed, ..Manner::default() };
    let name = method.name();
    if let Some(course) = &job.race {
        if job.explain {
            out::show(&explain::told(&scene, name, &manner)?)?;
        }
        return race::serve(&scene, course, job.shown);
    }
    // What cannot be written is found before the work, not after.
    let usual = [folder.join(usual_name(&job.scene, &scene.name))];
    let paths = if job.out.is_empty() { &usual[..] } else { &job.out[..] };
    let _made = if job.out.is_empty() { Some(Folder::open(folder)?) } else { None };
    let places = paths.iter().map(|path| Place::of(path)).collect::<Result<Vec<_>, _>>()?;
    let besides = Besides::of(job)?;
    let files = [("--film", &job.film), ("--error-map", &job.error_map), ("--stats", &job.stats)];
    let files = files.into_iter().filter_map(|(option, path)| Some((option, path.as_deref()?)));
    let own = Some(("the scene", Path::new(&job.scene))).filter(|(_, path)| path.is_file());
    distinct(own.into_iter().chain(paths.iter().map(|path| ("--out", path.as_path()))).chain(files))?;
    if job.explain {
        out::show(&explain::told(&scene, name, &manner)?)?;
    }
    let kinds: Vec<&pictures::Kind> = places.iter().map(|place| place.kind).collect();
    let made = rendered(&scene, &manner, job, &kinds)?;
    let about = About { scene: scene::stem(&scene.name), spp: made.spp, manner: film::manner(&scene, &manner) };
    let mut drafts = drafts(&places, &made.picture(&about), &job.shown);
    drafts.extend(besides.drafts(&scene, job, &method, &made, &about));
    let code = publish(drafts, made.found.broken)?;
    Ok(made.interrupted.filter(|_| code == ExitCode::SUCCESS).map_or(code, ExitCode::from))
}

/// The name of a scene's picture if nothing is said: after its file, or what it is called among those of the lecture.
fn usual_name(asked: &str, name: &str) -> String {
    let path = Path::new(asked);
    let stem = path.file_stem().filter(|_| path.extension().is_some());
    format!("{}.png", stem.map_or_else(|| scene::stem(name), |stem| stem.to_string_lossy().into_owned()))
}

/// Gives a scene's picture another size.
fn resize(scene: &mut Scene, size: [Option<u32>; 2]) -> Result<(), Stop> {
    let [width, height] = [scene.camera.width, scene.camera.height].map(f64::from);
    // Beyond what a whole number holds it is its largest one, which is refused below.
    let scaled = |side: u32, by: f64| (f64::from(side) * by).round().max(1.0) as u32;
    let [width, height] = match size {
        [None, None] => return Ok(()),
        [Some(wide), None] => [wide, scaled(wide, height / width)],
        [None, Some(high)] => [scaled(high, width / height), high],
        [Some(wide), Some(high)] => [wide, high],
    };
    (scene.camera.width, scene.camera.height) = (width, height);
    scene.flaw().map_or(Ok(()), |flaw| Err(Stop::at("--width, --height", flaw.why)))
}

/// Whether nothing in a scene emits light.
fn is_dark(scene: &Scene) -> bool {
    let is_black = |light: &[f64; 3]| *light == [0.0; 3];
    let shapes = scene.shapes.iter().filter_map(|shape| shape.emission.as_ref());
    let lights = scene.lights.iter().map(|light| match light {
        Light::Point { intensity, .. } => intensity,
        Light::Directional { irradiance, .. } => irradiance,
    });
    let is_sky_black = scene.environment.as_ref().is_none_or(Environment::is_black);
    is_sky_black && shapes.map(|emission| &emission.radiance).chain(lights).all(is_black)
}

/// Files that are no pictures.
struct Besides {
    error_map: Option<(Folder, String, Format)>,
    stats: Option<(Folder, String)>,
}

impl Besides {
    fn of(job: &Job) -> Result<Self, Stop> {
        let error_map = job.error_map.as_ref().map(|path| {
            let unknown = || refused("--error-map", path, "is no kind of figure that is known; valid: .png, .svg");
            let format = Format::of(path).ok_or_else(unknown)?;
            let (folder, name) = Folder::of(path)?;
            Ok::<_, Stop>((folder, name, format))
        });
        let stats = job.stats.as_ref().map(|path| match path.extension() {
            Some(word) if plain(&word.to_string_lossy()) == "json" => Folder::of(path),
            _ => Err(refused("--stats", path, "is written as JSON; valid: .json")),
        });
        Ok(Self { error_map: error_map.transpose()?, stats: stats.transpose()? })
    }

    fn drafts(
        &self,
        scene: &Scene,
        job: &Job,
        method: &Method,
        made: &Rendered,
        about: &About,
    ) -> Vec<Result<Draft, Stop>> {
        let mut drafts = Vec::new();
        if let Some((folder, name, format)) = &self.error_map {
            let map = error_map::plot(&made.picture(about));
            drafts.push(folder.draft(name, &format.draw(&map)));
        }
        if let Some((folder, name)) = &self.stats {
            let left_out = explain::left_out(&made.needs, method);
            let facts = Facts {
                scene: &scene.name,
                size: made.size,
                integrator: method.name(),
                seed: job.seed,
                max_depth: scene.max_depth,
                needs: explain::needed(&made.needs),
                left_out: left_out.iter().map(|one| (one.what, one.why)).collect(),
                bytes: made.bytes,
                making_ready: made.making_ready,
                spent: made.spent,
                spp: made.spp,
                spp_before: 2 * made.before,
                found: made.found,
                rounds: &made.rounds,
                patches: &made.patches,
            };
            drafts.push(folder.draft(name, &facts.json()));
        }
        drafts
    }
}

fn refused(option: &str, path: &Path, why: &str) -> Stop {
    Stop::at(format!("{option} {}", path.display()), why)
}

/// Refuses two files of one name, each told with its option: the last one written would be all there is.
pub fn distinct<'p>(files: impl Iterator<Item = (&'p str, &'p Path)>) -> Result<(), Stop> {
    // Their folders are there by now.
    let place = |path: &Path| Some(fs::canonicalize(out::parent(path)).ok()?.join(path.file_name()?));
    let mut seen: Vec<(&str, PathBuf)> = Vec::new();
    for (option, path) in files {
        let Some(own) = place(path) else { continue };
        if let Some((other, _)) = seen.iter().find(|(_, taken)| *taken == own) {
            let other = if *other == option { "another one" } else { other };
            return Err(refused(option, path, &format!("is the file of {other} already")));
        }
        seen.push((option, own));
    }
    Ok(())
}

/// A picture among the drafts, as far as it can be.
pub fn drafts(places: &[Place], picture: &Picture, shown: &Shown) -> Vec<Result<Draft, Stop>> {
    places.iter().map(|place| place.folder.draft(&place.name, &(place.kind.encode)(picture, shown))).collect()
}

/// Puts files in place, and says where they are, which cannot be, and whether pixels are broken.
pub fn publish(drafts: Vec<Result<Draft, Stop>>, broken: usize) -> Result<ExitCode, Stop> {
    let (drafts, failures): (Vec<_>, Vec<_>) = drafts.into_iter().partition(Result::is_ok);
    let drafts: Vec<Draft> = drafts.into_iter().flatten().collect();
    let (paths, unpublished) = out::publish_each(&drafts);
    let paths: String = paths.iter().map(|path| format!("{}\n", path.display())).collect();
    out::print(paths.as_bytes())?;
    if broken > 0 {
        out::say(&format!("error: {broken} pixels are not numbers, and black in the picture"));
    }
    let failures: Vec<Stop> = failures.into_iter().filter_map(Result::err).chain(unpublished).collect();
    failures.iter().for_each(|failure| out::say(&format!("error: {failure}")));
    Ok(match (failures.len(), broken) {
        (0, 0) => ExitCode::SUCCESS,
        (0, _) => ExitCode::from(1),
        _ => ExitCode::from(2),
    })
}

/// The relative error of a picture of so many pixels in words: of one alone nothing tells how sure it is.
pub fn error_told(found: &Estimate, pixels: usize) -> String {
    let deviation = deviation(found, pixels).map_or("unknown".to_owned(), |deviation| format!("{deviation:.0e}"));
    format!("{} (relMSE {:.3e} ± {deviation})", percent(found), found.relative_mse)
}

/// The standard error [1] of the relative error of a picture of so many pixels, if there are enough to tell.
fn deviation(found: &Estimate, pixels: usize) -> Option<f64> {
    (pixels - found.broken > 1).then_some(found.deviation)
}

fn percent(found: &Estimate) -> String {
    format!("{:.2} %", 100.0 * found.relative_error())
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

/// The integrator for a scene if none is named.
fn usual(scene: &Scene) -> Result<Method, Stop> {
    let needs = Needs::of(scene);
    let usual = Method::usual(&needs);
    if usual.fits(&needs) {
        return Ok(usual);
    }
    let why = "a polariser sees what is polished and bare, or matt, and no glass by name; valid: without it, or without other materials";
    Err(Stop::at("camera.polariser_deg", why))
}

/// The integrator of that name, if it can do the scene.
fn integrator(name: &str, scene: &Scene) -> Result<Method, Stop> {
    let (wanted, needs) = (plain(name), Needs::of(scene));
    let found = Method::all().find(|method| method.name() == wanted).ok_or_else(|| {
        let names = Method::all().map(|method| method.name());
        Stop::from(Fault::unknown("--integrator", name, "no such integrator", names))
    })?;
    let flaw = found.refusal(scene);
    if flaw.is_some() || !found.fits(&needs) {
        let names: Vec<&str> = fitting(scene).map(|one| one.name()).collect();
        let names = if names.is_empty() { "none of them".to_owned() } else { names.join(", ") };
        let reason = flaw.map_or(String::new(), |flaw| format!(": {flaw}"));
        let why = format!("{} cannot do this scene ({}){reason}; valid here: {names}", found.name(), found.about());
        return Err(Stop::at("--integrator", why));
    }
    Ok(found)
}

/// The integrators that can do a scene.
pub fn fitting(scene: &Scene) -> impl Iterator<Item = Method> {
    let needs = Needs::of(scene);
    Method::all().filter(move |method| method.fits(&needs) && method.refusal(scene).is_none())
}
