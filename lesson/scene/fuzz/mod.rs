//! Hostile files: whatever is read of others, changed at random in ways that break readers, and read as the program reads it.
//!
//! No case may panic, recurse beyond a stack of [`STACK`] or ask for more than [`MEMORY`] of addresses: cases run in a process
//! of their own under that limit, one for each format. Every refusal is one message that names its place, and whatever is
//! accepted has no flaw. What broke a reader once stands in [`found`].
//!
//! `cargo test` takes a few cases of fixed seeds. `LESSON_FUZZ_SECONDS=600 cargo test -p lesson fuzz -- --nocapture` goes on
//! for so long with each format, counts, and tells of the slowest; `LESSON_FUZZ_FORMAT=glb` is for one alone,
//! `LESSON_FUZZ_SEED=7` for other numbers, and `LESSON_FUZZ_CASE=81` for one case again. Cases that broke a reader are left in
//! the folder that the message names.

mod found;
mod mutate;
mod seeds;

use super::gltf::mesh;
use super::images::drawn;
use super::meshes::Files;
use super::source::Source;
use super::{json, read, read_gltf, toml};
use crate::film;
use crate::stop::Stop;
use cpu_time::ThreadTime;
use light::scene::Scene;
use mutate::{Chance, Shape};
use std::env;
use std::fs;
use std::io::{Seek, SeekFrom, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};
use yardstick::random::stream;

/// Address space of who reads [B]: the program and its stacks, and the largest image as texels, with what decoding it takes.
const MEMORY: u64 = 1 << 30;
/// Stack of who reads [B]: a quarter of the program's own.
const STACK: usize = 2 << 20;
/// Cases of each format where nothing is said.
const FEW: u64 = 120;
/// The most that one case may take in a long run [CPU s]: an image of the most texels takes half of one.
const SLOW: f64 = 5.0;
/// How long who reads may take [CPU s] if it is to end at all.
const ENDLESS: u64 = 300;
/// How often a format is gone on with after its process was ended.
const ENDED: u32 = 20;

/// What reads a file, and what its files are like.
struct Format {
    name: &'static str,
    seeds: fn() -> Vec<Vec<u8>>,
    shape: Shape,
    read: fn(Vec<u8>) -> Result<Option<Scene>, Stop>,
}

const FORMATS: [Format; 11] = [
    Format {
        name: "toml",
        seeds: seeds::toml,
        shape: mutate::TEXT,
        read: |bytes| text("case.toml", bytes, toml::parse),
    },
    Format {
        name: "json",
        seeds: seeds::json,
        shape: mutate::TEXT,
        read: |bytes| text("case.json", bytes, json::parse),
    },
    Format { name: "gltf", seeds: seeds::gltf, shape: mutate::TEXT, read: |bytes| model("case.gltf", &bytes) },
    Format { name: "glb", seeds: seeds::glb, shape: mutate::GLB, read: |bytes| model("case.glb", &bytes) },
    Format {
        name: "exr",
        seeds: seeds::exr,
        shape: mutate::BYTES,
        read: |bytes| named(seeds::SKY_AND_WALL, "exr", &bytes),
    },
    Format { name: "hdr", seeds: seeds::hdr, shape: mutate::HDR, read: |bytes| named(seeds::SKY, "hdr", &bytes) },
    Format { name: "png", seeds: seeds::png, shape: mutate::PNG, read: |bytes| named(seeds::WALL, "png", &bytes) },
    Format { name: "jpg", seeds: seeds::jpeg, shape: mutate::BYTES, read: |bytes| named(seeds::WALL, "jpg", &bytes) },
    Format { name: "ply", seeds: seeds::ply, shape: mutate::PLY, read: |bytes| named(seeds::MESHES, "ply", &bytes) },
    Format { name: "obj", seeds: seeds::obj, shape: mutate::TEXT, read: |bytes| named(seeds::MESHES, "obj", &bytes) },
    Format { name: "film", seeds: seeds::film, shape: mutate::FILM, read: reel },
];

/// A scene's text, the files that it names as they should be.
fn text(name: &str, bytes: Vec<u8>, parse: super::Parse) -> Result<Option<Scene>, Stop> {
    let source = Source::new(Path::new(name), bytes)?;
    read(&source, parse, &seeds::beside).map(|(scene, _)| Some(scene))
}

/// A model as a scene, and as a mesh of one.
fn model(name: &str, bytes: &[u8]) -> Result<Option<Scene>, Stop> {
    let alone = mesh(Path::new(name), bytes, &seeds::beside, true).map_err(|why| Stop::at(name, why));
    if let Err(why) = alone {
        told("glb", &why.to_string()).expect("a message that is one");
    }
    let scene = read_gltf(Path::new(name), bytes, &seeds::beside);
    scene.map(|(scene, _)| Some(scene))
}

/// A file `case.EXT` that a good text names as `FILE`.
fn named(text: &str, extension: &str, bytes: &[u8]) -> Result<Option<Scene>, Stop> {
    let files: Files = &|_| Ok(bytes.to_vec());
    // Textures that stand for no colour, too.
    let _ = drawn(bytes, false);
    let source = Source::new(Path::new("case.toml"), text.replace("FILE", &format!("case.{extension}")).into_bytes())?;
    read(&source, toml::parse, files).map(|(scene, _)| Some(scene))
}

fn reel(bytes: Vec<u8>) -> Result<Option<Scene>, Stop> {
    film::read(&bytes[..], bytes.len() as u64).map(|_| None).map_err(|why| Stop::at("case.film", why))
}

/// What is wrong with how a file was read, if anything is; else whether it was accepted.
fn judged(format: &Format, bytes: &[u8]) -> Result<bool, String> {
    match (format.read)(bytes.to_vec()) {
        Ok(scene) => match scene.and_then(|scene| scene.flaw()) {
            None => Ok(true),
            Some(flaw) => Err(format!("accepted with a flaw: {flaw}")),
        },
        Err(stop @ Stop::Refused(_)) => told(format.name, &stop.to_string()).map(|()| false),
        Err(stop) => Err(format!("not refused: {stop:?}")),
    }
}

/// What is wrong with a message, if anything is.
fn told(format: &str, message: &str) -> Result<(), String> {
    let mut lines = message.lines();
    let first = lines.next().unwrap_or_default();
    let more = lines.count();
    // Of a scene's text the line in question is shown.
    let most = if ["toml", "json"].contains(&format) { 8 } else { 3 };
    let (file, why) = first.split_once(": ").unwrap_or_default();
    let is_named = file.starts_with("case.") && !why.is_empty();
    let is_plain = !message.chars().any(|c| c.is_control() && c != '\n');
    match is_named && is_plain && more <= most && first.chars().count() <= 600 {
        true => Ok(()),
        false => Err(format!("a message that is none: {message:?}")),
    }
}

/// A case by its number.
fn case(format: &Format, seeds: &[Vec<u8>], seed: u64, number: u64) -> Vec<u8> {
    let mut chance = Chance::new(stream(seed, &format!("fuzz/{}/{number}", format.name)));
    mutate::changed(seeds, &format.shape, &mut chance)
}

/// A whole number from the environment.
fn set(name: &str) -> Option<u64> {
    env::var(name)
        .ok()
        .map(|text| text.parse().unwrap_or_else(|_| panic!("{name}: is `{text}`; valid: a whole number")))
}

/// Whose process this is, if it is for cases: the format's name, its first case, and where it tells which one it is at.
const CHILD: &str = "LESSON_FUZZ_CHILD";

#[test]
fn nothing_hostile_breaks_a_reader() {
    if let Ok(child) = env::var(CHILD) {
        return run(&child);
    }
    let only = env::var("LESSON_FUZZ_FORMAT").ok();
    let chosen: Vec<&Format> =
        FORMATS.iter().filter(|format| only.as_ref().is_none_or(|only| only == format.name)).collect();
    assert!(!chosen.is_empty(), "LESSON_FUZZ_FORMAT: is `{only:?}`; valid: {:?}", FORMATS.map(|format| format.name));
    let seconds = set("LESSON_FUZZ_SECONDS");
    let mut broken = Vec::new();
    for format in chosen {
        let until = seconds.map(|seconds| Instant::now() + Duration::from_secs(seconds));
        let mut first = 0;
        for _ in 0..ENDED {
            let left = until.map(|until| until.saturating_duration_since(Instant::now()).as_secs());
            let (output, at) = own_process(format.name, first, left);
            let said = String::from_utf8_lossy(&output.stdout).into_owned();
            // Behind what whoever runs tests says of itself.
            said.lines()
                .filter_map(|line| line.find("fuzz: ").map(|at| &line[at..]))
                .for_each(|line| println!("{line}"));
            if output.status.success() {
                break;
            }
            let why = String::from_utf8_lossy(&output.stderr);
            let findings: Vec<&str> = said.lines().filter(|line| line.contains("BROKEN")).collect();
            match findings.is_empty() {
                false => broken.push(findings.join("\n")),
                true => broken.push(format!("{} case {at} ended its process ({}): {why}", format.name, output.status)),
            }
            // What ended of itself has told all.
            if seconds.is_none() || output.status.code().is_some_and(|code| code == 101) {
                break;
            }
            first = at + 1;
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

/// Runs cases in a process of their own, from the first on, and says at which it ended.
fn own_process(name: &str, first: u64, left: Option<u64>) -> (Output, u64) {
    let place = folder().join(format!("{name}.at"));
    let own = env::current_exe().expect("a test knows where it is");
    let test = concat!(module_path!(), "::nothing_hostile_breaks_a_reader");
    let test = test.split_once("::").expect("a crate's name, and a module's").1;
    let limit =
        format!("ulimit -v {} && ulimit -t {} && exec \"$0\" \"$@\"", MEMORY >> 10, left.unwrap_or(0) + ENDLESS);
    let mut command = match cfg!(unix) {
        true => Command::new("sh"),
        false => Command::new(&own),
    };
    if cfg!(unix) {
        command.arg("-c").arg(limit).arg(&own);
    }
    command.args(["--exact", test, "--nocapture", "--test-threads=1"]);
    command.env(CHILD, format!("{name} {first} {}", place.display()));
    command.env_remove("LESSON_FUZZ_FORMAT").env_remove("LESSON_FUZZ_SECONDS").env_remove("RUST_BACKTRACE");
    if let Some(left) = left {
        command.env("LESSON_FUZZ_SECONDS", left.to_string());
    }
    let output = command.output().expect("a shell, and this very program");
    let at = fs::read_to_string(&place).ok().and_then(|text| text.trim().parse().ok()).unwrap_or(first);
    (output, at)
}

/// Where cases are left.
fn folder() -> PathBuf {
    let folder = env::temp_dir().join("lesson-fuzz");
    fs::create_dir_all(&folder).expect("a folder for what is found");
    folder
}

/// The cases of one process.
fn run(child: &str) {
    let mut words = child.splitn(3, ' ');
    let mut word = || words.next().expect("three words");
    let (name, first, place) = (word(), word(), word());
    let format = FORMATS.iter().find(|format| format.name == name).expect("a format");
    let first: u64 = first.parse().expect("a number");
    let mut place = fs::File::create(place).expect("a file to tell where it is");
    let reading = std::thread::Builder::new().stack_size(STACK);
    let broken = std::thread::scope(|scope| {
        let reading = reading.spawn_scoped(scope, || cases(format, first, &mut place)).expect("a thread");
        reading.join().expect("whoever reads is caught")
    });
    assert_eq!(broken, 0, "of {name}");
}

/// How many cases broke a reader.
fn cases(format: &Format, first: u64, place: &mut fs::File) -> u64 {
    let (seeds, seed) = ((format.seeds)(), set("LESSON_FUZZ_SEED").unwrap_or(1));
    let until = set("LESSON_FUZZ_SECONDS").map(|seconds| Instant::now() + Duration::from_secs(seconds));
    let (first, only) = set("LESSON_FUZZ_CASE").map_or((first, false), |only| (only, true));
    let (mut accepted, mut refused, mut broken) = (0_u64, 0_u64, 0);
    let mut slowest = (0.0, first);
    for number in first.. {
        let is_over = match until {
            _ if only => number > first,
            Some(until) => Instant::now() >= until,
            None => number >= FEW,
        };
        if is_over || broken >= 40 {
            break;
        }
        place.seek(SeekFrom::Start(0)).and_then(|_| writeln!(place, "{number:<20}")).expect("it is told");
        let bytes = case(format, &seeds, seed, number);
        let watch = ThreadTime::now();
        let found = catch_unwind(AssertUnwindSafe(|| judged(format, &bytes)));
        let spent = watch.elapsed().as_secs_f64();
        if spent > slowest.0 {
            slowest = (spent, number);
        }
        let why = match found {
            Ok(Ok(is_accepted)) => {
                *(if is_accepted { &mut accepted } else { &mut refused }) += 1;
                (until.is_some() && spent > SLOW).then(|| format!("took {spent:.1} s"))
            }
            Ok(Err(why)) => Some(why),
            Err(panic) => {
                let text = panic.downcast_ref::<String>().cloned();
                Some(text.or(panic.downcast_ref::<&str>().map(|text| (*text).to_owned())).unwrap_or_default())
            }
        };
        if let Some(why) = why {
            broken += 1;
            let file = folder().join(format!("{}-{seed}-{number}.{}", format.name, format.name));
            fs::write(&file, &bytes).expect("the case is kept");
            println!("fuzz: BROKEN {} case {number} of seed {seed}, {}: {why}", format.name, file.display());
        }
    }
    let (name, count) = (format.name, accepted + refused + broken);
    let (slow, at) = slowest;
    println!(
        "fuzz: {name}: {count} cases from {first} of seed {seed}: {accepted} accepted, {refused} refused, {broken} broke; the slowest, {at}, took {:.1} ms",
        1e3 * slow
    );
    broken
}

/// What they are made of is what readers take: a seed that is refused would test nothing but its refusal.
#[test]
fn every_seed_is_accepted() {
    for format in &FORMATS {
        for (at, seed) in (format.seeds)().into_iter().enumerate() {
            assert_eq!(
                judged(format, &seed),
                Ok(true),
                "{} {at}: {:?}",
                format.name,
                (format.read)(seed.clone()).err()
            );
        }
    }
}

/// The harness sees what it is for.
#[test]
fn what_is_broken_is_seen() {
    let broken = |read| Format { name: "obj", seeds: seeds::obj, shape: mutate::TEXT, read };
    let silent = broken(|_| Err(Stop::Refused("something".to_owned())));
    let nameless = broken(|_| Err(Stop::Refused("case.obj: ".to_owned())));
    let long = broken(|_| Err(Stop::Refused(format!("case.obj: {}", "x".repeat(1000)))));
    let flawed = broken(|_| {
        let (scene, _) = read_gltf(Path::new("case.glb"), &seeds::glb()[0], &seeds::beside)?;
        let mut flawed = scene.clone();
        flawed.camera.width = 0;
        Ok(Some(flawed))
    });
    for (at, format) in [silent, nameless, long, flawed].iter().enumerate() {
        assert!(judged(format, b"").is_err(), "{at}");
    }
    assert!(told("obj", "case.obj: \u{1b}[31m is red").is_err() && told("obj", "case.obj: is not").is_ok());
    let seeds = seeds::toml();
    let [one, again, other] = [1, 1, 2].map(|seed| case(&FORMATS[0], &seeds, seed, 5));
    assert!(one == again && one != other);
}
