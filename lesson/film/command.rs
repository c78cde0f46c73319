//! `lesson film`: films put together, and what is in one.

use super::{Reel, Shelf, is_film, samples};
use crate::out;
use crate::render::{self, Place, Shown};
use crate::stop::Stop;
use light::transport::estimate::Estimate;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Films to be put together.
#[derive(Debug)]
pub struct Merge {
    /// At least one.
    pub films: Vec<PathBuf>,
    /// Pictures, or films.
    pub out: Vec<PathBuf>,
    /// How radiance is shown.
    pub shown: Shown,
}

/// Puts films together, and says where what came of it is.
pub fn merge(job: &Merge) -> Result<ExitCode, Stop> {
    let (films, pictures): (Vec<&PathBuf>, Vec<&PathBuf>) = job.out.iter().partition(|path| is_film(path));
    let shelves = films.iter().map(|path| Shelf::of(path)).collect::<Result<Vec<_>, _>>()?;
    let places = pictures.iter().map(|path| Place::of(path)).collect::<Result<Vec<_>, _>>()?;
    let mut films = job.films.iter();
    let first = films.next().ok_or_else(|| Stop::at("films", "missing: at least one"))?;
    let mut reel = Reel::open(first)?;
    for path in films {
        reel.join(path, Reel::open(path)?)?;
    }
    let mut drafts = shelves.iter().map(|shelf| shelf.draft(&reel.head, &reel.film)).collect::<Result<Vec<_>, _>>()?;
    let (pictures, found) = render::drafts(&places, &reel.film, None, &job.shown)?;
    drafts.extend(pictures);
    out::say(&format!("{}: {} spp of {} films", reel.head.name, 2 * reel.film.pairs(), job.films.len()));
    render::publish(&drafts, found.broken)
}

/// What is in a film.
pub fn show(path: &Path) -> Result<(), Stop> {
    let Reel { head, film } = Reel::open(path)?;
    let [width, height] = film.size();
    let found = Estimate::of(&film.halves(), width);
    let ranges: Vec<String> = film.ranges().iter().map(samples).collect();
    let hash: String = head.scene.iter().map(|byte| format!("{byte:02x}")).collect();
    let is_lit = film.parts().any(|(.., splats)| splats.is_some());
    let mut lines = vec![
        ("scene", head.name),
        ("sha-256", hash),
        ("size", format!("{width} × {height}")),
        ("spp", (2 * film.pairs()).to_string()),
        ("samples", ranges.join(", ")),
        ("seconds", format!("{:.2}", head.seconds)),
        (
            "error",
            format!(
                "{:.2} % (relMSE {:.3e} ± {:.0e})",
                100.0 * found.relative_error(),
                found.relative_mse,
                found.deviation
            ),
        ),
        ("not numbers", format!("{} pixels", found.broken)),
        ("light paths", if is_lit { "yes" } else { "no" }.to_owned()),
    ];
    lines.extend(head.manner.iter().map(|(key, value)| (key.as_str(), value.clone())));
    let text: String = lines.iter().map(|(key, value)| format!("{key:<13}{value}\n")).collect();
    out::print(text.as_bytes())
}
