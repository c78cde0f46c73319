//! Films: sums of samples as files, to go on from and to put together.
//!
//! All numbers little-endian, one after the other, without gaps:
//!
//! | bytes | what |
//! |---|---|
//! | 8 | [`MAGIC`] |
//! | u32 | [`VERSION`] |
//! | u32, u32 | width and height \[pixels\], each at least 1 |
//! | 32 | SHA-256 of the scene: its TOML without its name and its depth, then of every mesh the length (u64) and bytes of its PLY |
//! | f64 | seconds it took to render, ≥ 0 |
//! | u32, text | length and UTF-8 of what is told: on the first line the scene's name, then a line `key: value` for each thing besides the scene that decides the samples |
//! | u32, i32 | whether paths from lamps brought light, 0 or 1; the power of two that is a unit of it \[W m⁻² sr⁻¹\], else 0 |
//! | u32 | branches, at least 1 |
//! | … | the branches, by rising start |
//! | u32 | CRC-32 (IEEE 802.3) of all bytes before |
//!
//! A branch is a sum over pairs of samples, pair n being the samples 2n and 2n + 1 ([`light::transport::film`]):
//!
//! | bytes | what |
//! |---|---|
//! | u32, u32 | the first pair; pairs, a power of two that divides it |
//! | 6 × f32 a pixel | sums \[W m⁻² sr⁻¹\] of red, green, blue of the first half, then of the second; row by row from the top |
//! | 6 × i64 a pixel | the same of light from paths from lamps, in its unit, if there is any; −2⁶³ is no number |
//!
//! Files come from anybody: before anything is held, the length of the file must be what its counts say, so that memory is
//! bounded by the file; and nothing is believed before the checksum.

mod bytes;
mod command;
#[cfg(test)]
mod tests;

#[cfg(test)]
pub use bytes::{read, write};
pub use command::{Merge, merge, show};

use crate::memory;
use crate::out::{Draft, Folder};
use crate::render::{About, MOST};
use crate::scene;
use crate::stop::{Stop, plain};
use light::scene::Scene;
use light::transport::film::{Clash, Film};
use light::transport::kernel::Tactics;
use light::transport::{Manner, Method};
use sha2::{Digest, Sha256};
use std::fs::{self, File};
use std::io::BufReader;
use std::ops::Range;
use std::path::Path;

/// How every film begins: no text, and what a transfer as text would change.
pub const MAGIC: [u8; 8] = *b"\x89film\r\n\x1a";

/// Of the format.
pub const VERSION: u32 = 2;

/// Whence a film's samples are.
#[derive(Clone, Debug, PartialEq)]
pub struct Head {
    /// What the scene is called: told, and of no consequence.
    pub name: String,
    /// SHA-256 of the scene.
    pub scene: [u8; 32],
    /// What else decides the samples, by name.
    pub manner: Vec<(String, String)>,
    /// Time to render them [s].
    pub seconds: f64,
}

impl Head {
    /// Of pictures of a scene, none yet rendered.
    pub fn new(scene: &Scene, manner: &Manner) -> Self {
        let manner = self::manner(scene, manner);
        Self { name: scene::stem(&scene.name), scene: hash(scene), manner, seconds: 0.0 }
    }

    /// What a picture of so many samples a pixel tells of itself.
    fn about(&self, spp: u32) -> About {
        let manner = self.manner.iter().filter(|(key, _)| key != ARITHMETIC).cloned().collect();
        About { scene: self.name.clone(), spp, manner }
    }

    /// Why samples of `other`, which are those of `whom`, are none of the same picture, if so.
    fn differs(&self, other: &Self, whom: &str) -> Option<String> {
        if self.scene != other.scene {
            let [own, others] = [&self.name, &other.name];
            return Some(match own == others {
                true => format!("is of the scene {own} as it was otherwise than that of {whom}"),
                false => format!("is of the scene {own}, {whom} of {others}"),
            });
        }
        let value = |head: &Self, key: &str| {
            let found = head.manner.iter().find(|(own, _)| own == key);
            found.map_or_else(|| "not said".to_owned(), |(_, value)| value.clone())
        };
        let keys = self.manner.iter().chain(&other.manner).map(|(key, _)| key);
        keys.map(|key| (key, value(self, key), value(other, key)))
            .find(|(_, own, others)| own != others)
            .map(|(key, own, others)| format!("has {key} {own}, {whom} {others}"))
    }
}

/// What besides the scene decides the samples, by name, in words; its depth is told apart.
pub fn manner(scene: &Scene, manner: &Manner) -> Vec<(String, String)> {
    // No field can be forgotten here when one comes to be.
    // What is done needlessly changes no bit.
    let Manner { method, structure, choice, seed, needless: _ } = manner;
    let method = match method {
        Method::Fast(tactics) if *tactics != Tactics::default() => format!("{}, {tactics:?}", method.name()),
        Method::Fast(_) | Method::Simple(_) | Method::Photons | Method::Cached | Method::Radiosity => {
            method.name().to_owned()
        }
    };
    let manner = [
        ("integrator", method),
        ("depth", scene.max_depth.map_or("unlimited".to_owned(), |depth| depth.to_string())),
        ("seed", seed.to_string()),
        ("numbers", format!("{choice:?}").to_lowercase()),
        ("structure", format!("{structure:?}").to_lowercase()),
    ];
    manner.map(|(key, value)| (key.to_owned(), value)).to_vec()
}

/// The key of what tells one machine's arithmetic from another's.
pub const ARITHMETIC: &str = "arithmetic";

/// What a scene is, in 32 bytes; its name and its depth are no part of it.
fn hash(scene: &Scene) -> [u8; 32] {
    let (text, meshes) = scene::written(&Scene { name: String::new(), max_depth: None, ..scene.clone() });
    let mut hash = Sha256::new();
    hash.update(text.as_bytes());
    for mesh in meshes {
        hash.update((mesh.len() as u64).to_le_bytes());
        hash.update(&mesh);
    }
    hash.finalize().into()
}

/// Samples, and whence they are.
#[derive(Clone, Debug, PartialEq)]
pub struct Reel {
    pub head: Head,
    pub film: Film,
}

impl Reel {
    /// What is in a file.
    pub fn open(path: &Path) -> Result<Self, Stop> {
        let read = || {
            let cannot = |error| format!("cannot be read: {error}");
            let about = fs::metadata(path).map_err(cannot)?;
            // A pipe or a device has no length to hold its counts to, and to open it may take forever.
            if !about.is_file() {
                return Err("is no film".to_owned());
            }
            let file = File::open(path).map_err(cannot)?;
            memory::suffices("all of it", about.len(), "a film of fewer pixels").map_err(|stop| stop.to_string())?;
            bytes::read(BufReader::new(file), about.len())
        };
        read().map_err(|why| Stop::at(path.display(), why))
    }

    /// With all the samples of another, which was found in `path`.
    pub fn join(&mut self, path: &Path, other: Self) -> Result<(), Stop> {
        let refused = |why: String| Stop::at(path.display(), why);
        let why = other.refuse(&self.head, self.film.size(), "the films before it");
        why.map_or(Ok(()), |why| Err(refused(why)))?;
        let twice = shared(&self.film, &other.film);
        if !twice.is_empty() {
            let twice: Vec<String> = twice.iter().map(samples).collect();
            let why = "that there are already; valid: films of other samples";
            return Err(refused(format!("has samples {} {why}", twice.join(", "))));
        }
        self.film.merge(other.film).map_err(|clash| refused(told(&clash)))?;
        self.head.seconds += other.head.seconds;
        Ok(())
    }

    /// Why samples of such an origin and size, which are those of `whom`, are none of the same picture, if so.
    pub fn refuse(&self, head: &Head, size: [u32; 2], whom: &str) -> Option<String> {
        let [own, others] = [self.film.size(), size];
        if own != others {
            return Some(format!("has {} × {} pixels, {whom} {} × {}", own[0], own[1], others[0], others[1]));
        }
        self.head.differs(head, whom)
    }
}

/// Pairs that two films have both.
fn shared(one: &Film, other: &Film) -> Vec<Range<u32>> {
    let others = other.ranges();
    let both = |a: &Range<u32>, b: &Range<u32>| a.start.max(b.start)..a.end.min(b.end);
    let of = |own: &Range<u32>| others.iter().map(|range| both(own, range)).collect::<Vec<_>>();
    one.ranges().iter().flat_map(of).filter(|range| !range.is_empty()).collect()
}

/// Why two films cannot be one, said of the second.
fn told(clash: &Clash) -> String {
    match clash {
        Clash::Size([own, other]) => format!("has {} × {} pixels, and not {} × {}", other[0], other[1], own[0], own[1]),
        Clash::Overlap(pairs) => format!("has samples {} that there are already", samples(pairs)),
        Clash::Light => "has the light of paths from lamps otherwise than the others".to_owned(),
    }
}

/// Pairs as the numbers of their samples.
fn samples(pairs: &Range<u32>) -> String {
    format!("{}..{}", 2 * pairs.start, 2 * pairs.end)
}

/// The extension of their files.
const EXTENSION: &str = "film";

/// Whether a file is a film by its name.
pub fn is_film(path: &Path) -> bool {
    path.extension().is_some_and(|extension| plain(&extension.to_string_lossy()) == EXTENSION)
}

/// Where a film is to be written.
#[derive(Debug)]
pub struct Shelf {
    folder: Folder,
    name: String,
}

impl Shelf {
    /// Finds out whether it can be, before the work, and keeps others from writing it.
    pub fn of(path: &Path) -> Result<Self, Stop> {
        if !is_film(path) {
            return Err(Stop::at(path.display(), format!("is no film by its name; valid: .{EXTENSION}")));
        }
        let (folder, name) = Folder::of(path)?;
        folder.reserve(&name)?;
        Ok(Self { folder, name })
    }

    /// Writes it among the drafts.
    pub fn draft(&self, head: &Head, film: &Film) -> Result<Draft, Stop> {
        self.folder.draft_by(&self.name, |file| bytes::write(head, film, file))
    }
}

/// Pairs that there can be at most.
const MOST_PAIRS: u32 = MOST / 2;
