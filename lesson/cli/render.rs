//! Pictures.

use super::film::ShownArgs;
use super::help::HelpArg;
use super::lesson::{FormatArg, format};
use super::values::{duration, sample_numbers, seed, share, whole};
use super::{FOLDER, Request};
use crate::render::{Course, Goal, Job, MOST as MOST_SAMPLES};
use crate::stop::Stop;
use clap::{Args, ValueHint};
use light::scene::builtin::BUILTIN;
use std::path::PathBuf;
use std::time::Duration;

pub const RENDER_EXAMPLES: &str = "\
Examples:
  lesson render --list
  lesson render --keys                     what a scene file may say
  lesson render cornell                    64 samples a pixel, as a PNG
  lesson render cornell --time 20s --out cornell.png --out cornell.pfm
  lesson render cornell --error 0.02 --tone agx --exposure -1
  lesson render glass --explain --stats glass.json --error-map glass-error.png
  lesson render cornell --out all.exr      also variance, normals, albedo, depth
  lesson render cornell --time 20s --race --plot
  lesson render cornell --integrator hemisphere --spp 16
  lesson render cornell --print > my.toml  the scene as a file
  lesson render mesh --print --out scenes  with the mesh that it names
  lesson render my.toml --spp 256 --width 640 --out my.png
  lesson render cornell --spp 4096 --film c.film
  lesson render cornell --samples 64..128 --film b.film

Scenes are TOML or JSON: metres, linear RGB, radiance in W m⁻² sr⁻¹; --keys
tells what they may say. What is wrong with one is told with its line. Of --spp, --time
and --error the first that is reached ends the work. The relative error is the
root of the mean over pixels and channels of (x − truth)²/(truth² + 0.01), as the
picture's two independent halves tell it. Same scene and seed, same picture,
whatever the number of threads.

Ctrl-C or a request to terminate ends the work after some tenths of a second, and
what there is of the picture is written; the exit status is then 130 or 143. A
second one ends the program at once.

A --film is kept at least every ten seconds, unless one pair of samples of the
whole picture takes longer. Whatever ends the program, the same line goes on from
there, and the picture is the one of a run that nothing ended, bit for bit. So is
that of films of other --samples, put together by `lesson film merge`.";

/// The processors' time of every integrator of a race, if nothing is said.
const RACE: Duration = Duration::from_secs(2);

/// The deepest path that can be asked for.
const DEEPEST: u32 = 1_000_000;

#[derive(Debug, Args)]
pub struct RenderArgs {
    /// A scene of the lecture, or a file that ends in .toml, .json, .gltf or .glb.
    #[arg(value_hint = ValueHint::FilePath)]
    scene: Option<String>,
    /// The scenes of the lecture, one line each.
    #[arg(long, conflicts_with_all = ["scene", "print", "out"])]
    list: bool,
    /// The keys of scene files: what each is, in which unit and range, and what holds without it.
    #[arg(long, conflicts_with_all = ["scene", "list", "print", "out"])]
    keys: bool,
    /// Print the scene as a TOML file.
    #[arg(long, conflicts_with_all = ["tone", "exposure"])]
    print: bool,
    /// A file for the picture, .png, .exr or .pfm; may be repeated. With --print: a .toml for the scene, or a folder for it,
    /// and its meshes and images beside. With --race --plot: a .png or .svg for the figure, or a folder for it.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::AnyPath)]
    out: Vec<PathBuf>,
    /// Samples a pixel; an odd number is taken as the next even one.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, MOST_SAMPLES), allow_negative_numbers = true, conflicts_with = "print")]
    spp: Option<u32>,
    /// Numbers of the samples, such as 64..128: from the first up to but without the second, both even.
    #[arg(long, value_name = "A..B", value_parser = sample_numbers, allow_hyphen_values = true, conflicts_with_all = ["spp", "print"])]
    samples: Option<[u32; 2]>,
    /// A file for the error of every pixel in false colours, .png or .svg.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["print", "race"], value_hint = ValueHint::FilePath)]
    error_map: Option<PathBuf>,
    /// A file for what the picture took and what is known of it, .json.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["print", "race"], value_hint = ValueHint::FilePath)]
    stats: Option<PathBuf>,
    /// Say what the scene needs, what was left out, and what that saves: measured within some seconds.
    #[arg(long, conflicts_with = "print")]
    explain: bool,
    /// Instead of a picture, race every integrator that fits the scene: error against run time. It takes as long as all of
    /// them, and eight times as long as one for the picture that stands for the truth.
    #[arg(long, conflicts_with_all = ["print", "error", "integrator", "film", "samples"])]
    race: bool,
    /// With --race: draw it too.
    #[arg(long, conflicts_with = "print")]
    plot: bool,
    /// Format of the figure.
    #[arg(long, value_enum, help = "Format of the figure [default: png]")]
    format: Option<FormatArg>,
    /// A film, .film: gone on from if it is there, and kept while rendering.
    #[arg(long, value_name = "FILE", conflicts_with = "print", value_hint = ValueHint::FilePath)]
    film: Option<PathBuf>,
    /// How long to render: 20s, 500ms, 2min, 1h; a number alone is seconds. With --race: the processors' time that each
    /// integrator has [default: 2s].
    #[arg(long, value_parser = duration, allow_hyphen_values = true, conflicts_with = "print")]
    time: Option<Duration>,
    /// The relative error that is good enough, above 0 and below 1.
    #[arg(long, value_parser = share, allow_hyphen_values = true, conflicts_with = "print")]
    error: Option<f64>,
    /// Of all random numbers.
    #[arg(long, default_value_t = 1, value_parser = seed, allow_hyphen_values = true, conflicts_with = "print")]
    seed: u64,
    /// Threads; as many as there are cores if left out.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, 1024), allow_negative_numbers = true, conflicts_with = "print")]
    threads: Option<u32>,
    /// The integrator: fast, or one to read: hemisphere, surface, lamps, both; spectral where glass disperses, polarised where a filter sees it; or photon-map, whose pictures are blurred, or irradiance-cache, whose pictures are interpolated, or radiosity, of flat diffuse shapes, whose pictures are of patches: the error that is told knows of none of this.
    #[arg(long, value_name = "NAME", conflicts_with = "print")]
    integrator: Option<String>,
    /// The most edges of a path, instead of the scene's.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, DEEPEST), allow_negative_numbers = true, conflicts_with = "print")]
    depth: Option<u32>,
    /// The picture's width [pixels], instead of the scene's; without --height the picture keeps its shape.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, u32::MAX), allow_negative_numbers = true, conflicts_with = "print")]
    width: Option<u32>,
    /// The picture's height [pixels], instead of the scene's; without --width the picture keeps its shape.
    #[arg(long, value_name = "N", value_parser = |text: &str| whole(text, 1, u32::MAX), allow_negative_numbers = true, conflicts_with = "print")]
    height: Option<u32>,
    #[command(flatten)]
    shown: ShownArgs,
    #[command(flatten)]
    help: HelpArg,
}

impl RenderArgs {
    pub fn into_request(self) -> Result<Request, Stop> {
        let Some(scene) = self.scene else {
            return match (self.list, self.keys) {
                (true, _) => Ok(Request::Scenes),
                (_, true) => Ok(Request::Keys),
                _ => {
                    let names: Vec<&str> = BUILTIN.iter().map(|builtin| builtin.name).collect();
                    let valid =
                        format!("valid: a file that ends in .toml, .json, .gltf or .glb, or {}", names.join(", "));
                    Err(Stop::at("scene", format!("missing; {valid}; `lesson render --list` tells of those")))
                }
            };
        };
        if self.print {
            return match &self.out[..] {
                [] | [_] => Ok(Request::Print { scene, out: self.out.into_iter().next() }),
                _ => Err(Stop::at("--out", "with --print only one file or folder")),
            };
        }
        for (flag, given, other, is_there) in
            [("--plot", self.plot, "--race", self.race), ("--format", self.format.is_some(), "--plot", self.plot)]
        {
            if given && !is_there {
                return Err(Stop::at(flag, format!("needs {other}")));
            }
        }
        let race = self.race.then(|| {
            let plot = match &self.out[..] {
                [] => Some(FOLDER.into()),
                [folder] if self.plot => Some(folder.clone()),
                [_, ..] if self.plot => return Err(Stop::at("--out", "with --race only one file or folder")),
                [_, ..] => return Err(Stop::at("--out", "with --race needs --plot")),
            };
            Ok(Course {
                time: self.time.unwrap_or(RACE),
                spp: self.spp,
                seed: self.seed,
                plot: plot.filter(|_| self.plot).map(|path| (path, self.format.map(|word| format(Some(word))))),
            })
        });
        Ok(Request::Render(Box::new(Job {
            scene,
            race: race.transpose()?,
            error_map: self.error_map,
            stats: self.stats,
            explain: self.explain,
            goal: Goal { spp: self.spp, samples: self.samples, time: self.time, error: self.error, round: None },
            out: self.out,
            seed: self.seed,
            threads: self.threads.map(|threads| threads as usize),
            integrator: self.integrator,
            depth: self.depth,
            size: [self.width, self.height],
            shown: self.shown.into(),
            film: self.film,
        })))
    }
}
