//! The film beside a run: what was there when it began, and what is kept while it lasts.

use crate::film::{ARITHMETIC, Head, Reel, Shelf};
use crate::out;
use crate::stop::Stop;
use light::scene::Scene;
use light::transport::film::Film;
use light::transport::{Manner, Renderer};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// How long a round of work may last that is to be kept: with [`UNSAVED`], what is lost is younger than ten seconds.
pub const ROUND: Duration = Duration::from_secs(2);

/// How old what is not kept may become; in the beginning no older than half the run, for who ends it soon.
const UNSAVED: Duration = Duration::from_secs(8);

/// How old it may become in any case.
const YOUNG: Duration = Duration::from_millis(500);

/// A film's file while a picture is made.
#[derive(Debug)]
pub struct Archive {
    path: PathBuf,
    shelf: Shelf,
    head: Head,
    /// What the file was when it was last looked at.
    seen: Option<Stamp>,
    /// When what is not kept was begun.
    saved: Instant,
    /// How long it took to keep it.
    saving: Duration,
}

/// What tells a file from another in its place.
type Stamp = (u64, Option<SystemTime>);

fn stamp(path: &Path) -> Option<Stamp> {
    fs::metadata(path).ok().map(|about| (about.len(), about.modified().ok()))
}

impl Archive {
    /// The film in a file, to go on from, if there is one; refused if its samples are none of this picture.
    pub fn open(path: &Path, scene: &Scene, manner: &Manner, renderer: &Renderer) -> Result<(Self, Film), Stop> {
        let size = [scene.camera.width, scene.camera.height];
        let mut head = Head::new(scene, manner);
        head.manner.push((ARITHMETIC.to_owned(), arithmetic(renderer, size[1])));
        let seen = stamp(path);
        let shelf = Shelf::of(path)?;
        let mut film = Film::new(size[0], size[1]);
        if seen.is_some() {
            let reel = Reel::open(path)?;
            if let Some(why) = reel.refuse(&head, size, "this run") {
                return Err(Stop::at(path.display(), why));
            }
            head.seconds = reel.head.seconds;
            film = reel.film;
            out::say(&format!("{}: going on from {} spp", path.display(), 2 * film.pairs()));
        }
        let (saved, saving) = (Instant::now(), Duration::ZERO);
        Ok((Self { path: path.to_owned(), shelf, head, seen, saved, saving }, film))
    }

    /// Keeps the film, unless what is new will be young enough after one more round that takes so long.
    pub fn look_after(&mut self, film: &Film, spent: Duration, next: Duration) -> Result<(), Stop> {
        let oldest = (spent / 2).clamp(YOUNG, UNSAVED);
        if self.saved.elapsed() + next + self.saving < oldest { Ok(()) } else { self.save(film, spent) }
    }

    /// Keeps the film of a run that has lasted so long, in place of what was there.
    pub fn save(&mut self, film: &Film, spent: Duration) -> Result<(), Stop> {
        let begun = Instant::now();
        let seconds = self.head.seconds + spent.as_secs_f64();
        let draft = self.shelf.draft(&Head { seconds, ..self.head.clone() }, film)?;
        if stamp(&self.path) != self.seen {
            let why = "was changed by somebody else meanwhile, and is left as it is";
            return Err(Stop::at(self.path.display(), why));
        }
        out::publish(&[draft])?;
        self.seen = stamp(&self.path);
        (self.saved, self.saving) = (Instant::now(), begun.elapsed());
        Ok(())
    }
}

/// Rows whose first samples tell one arithmetic from another.
const ROWS: u32 = 8;

/// What comes of some first samples, in short: another version of the program, or another machine whose arithmetic rounds
/// otherwise, makes other samples of the same numbers, and no film of both would be the picture of one run.
fn arithmetic(renderer: &Renderer, height: u32) -> String {
    let mut hasher = crc32fast::Hasher::new();
    for row in (0..ROWS.min(height)).map(|k| (u64::from(height) * u64::from(k) / u64::from(ROWS.min(height))) as u32) {
        for number in renderer.sums(row..row + 1, 0..1).as_flattened().as_flattened() {
            hasher.update(&number.to_le_bytes());
        }
    }
    format!("{:08x}", hasher.finalize())
}
