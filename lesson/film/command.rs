//! `lesson film`: films put together, and what is in one.

use super::{Reel, Shelf, is_film, samples};
use crate::out;
use crate::render::{self, Picture, Place, Shown};
use crate::stop::Stop;
use light::transport::estimate::Estimate;
use std::collections::BTreeSet;
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
    let own: BTreeSet<&PathBuf> = job.films.iter().collect();
    let own = own.into_iter().map(|path| ("one of the films", path.as_path()));
    render::distinct(own.chain(job.out.iter().map(|path| ("--out", path.as_path()))))?;
    let mut films = job.films.iter();
    let first = films.next().ok_or_else(|| Stop::at("films", "missing: at least one"))?;
    let mut reel = Reel::open(first)?;
    for path in films {
        reel.join(path, Reel::open(path)?)?;
    }
    let mut drafts: Vec<_> = shelves.iter().map(|shelf| shelf.draft(&reel.head, &reel.film)).collect();
    let Reel { head, film } = reel;
    let ([width, height], spp) = (film.size(), 2 * film.pairs());
    let (halves, about) = (film.halves(), head.about(spp));
    drop(film);
    let picture = Picture { width, height, halves: &halves, features: None, about: &about };
    drafts.extend(render::drafts(&places, &picture, &job.shown));
    let count = job.films.len();
    out::say(&format!("{}: {spp} spp of {count} film{}", head.name, if count == 1 { "" } else { "s" }));
    render::publish(drafts, Estimate::of(&halves, width).broken)
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
        ("error", render::error_told(&found, width as usize * height as usize)),
        ("not numbers", format!("{} pixels", found.broken)),
        ("light paths", if is_lit { "yes" } else { "no" }.to_owned()),
    ];
    lines.extend(head.manner.iter().map(|(key, value)| (key.as_str(), value.clone())));
    let text: String = lines.iter().map(|(key, value)| format!("{key:<13}{value}\n")).collect();
    out::print(text.as_bytes())
}
