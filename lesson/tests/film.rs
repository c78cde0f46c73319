//! Films, as the real program keeps, goes on from and puts together.

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{Run, command, folder, lesson_fed};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Where a test works, with small scenes of the lecture.
struct Place(PathBuf);

impl Place {
    fn new(name: &str, scenes: &[&str]) -> Self {
        let place = Self(folder(name));
        for scene in scenes {
            let printed = lesson_fed(&["render", scene, "--print"], b"");
            assert_eq!(printed.code, 0, "{printed:?}");
            place
                .write(scene, &printed.out.replace("width = 256", "width = 16").replace("height = 256", "height = 12"));
        }
        place
    }

    fn write(&self, scene: &str, text: &str) {
        assert!(text.contains("width = 16") && text.contains("height = 12"));
        std::fs::write(self.path(&format!("{scene}.toml")), text).unwrap();
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap()
    }

    /// Arguments, of which those that name files are here.
    fn arguments(&self, line: &str) -> Vec<String> {
        let is_file = |word: &str| {
            Path::new(word).extension().is_some() && !word.starts_with(|c: char| c == '-' || c.is_ascii_digit())
        };
        let here = |word: &str| match is_file(word) {
            true => self.path(word).to_str().unwrap().to_owned(),
            false => word.to_owned(),
        };
        line.split_whitespace().map(here).collect()
    }

    fn run(&self, line: &str) -> Run {
        let arguments = self.arguments(line);
        lesson_fed(&arguments.iter().map(String::as_str).collect::<Vec<_>>(), b"")
    }

    fn ok(&self, line: &str) -> Run {
        let run = self.run(line);
        assert_eq!(run.code, 0, "{line}: {run:?}");
        run
    }

    /// Refused with one message about `file`, and nothing changed.
    fn refused(&self, line: &str, place: &str, words: &str) {
        let before = self.files();
        let run = self.run(line);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{line}: {run:?}");
        let expected = format!(
            "error: {}: ",
            if place.contains('.') { self.path(place).display().to_string() } else { place.to_owned() }
        );
        // Of several files of one option, the option is named too.
        let err = run.err.replacen("error: --out ", "error: ", 1);
        assert!(err.starts_with(&expected), "{line} should begin with `{expected}`: {}", run.err);
        assert!(run.err.contains(words), "{line} should say `{words}`: {}", run.err);
        assert_eq!(run.err.lines().count(), 1, "{line}: {}", run.err);
        assert!(self.files() == before, "{line} has changed a file");
    }

    /// What is there, with what is in it.
    fn files(&self) -> Vec<(String, Option<Vec<u8>>)> {
        let entries = std::fs::read_dir(&self.0).unwrap().map(|entry| entry.unwrap().path());
        let mut files: Vec<_> = entries
            .map(|path| (path.file_name().unwrap().to_str().unwrap().to_owned(), std::fs::read(&path).ok()))
            .collect();
        files.sort();
        files
    }

    /// A line of what is in a film.
    fn told(&self, film: &str, key: &str) -> String {
        let shown = self.ok(&format!("film show {film}")).out;
        let line = shown.lines().find_map(|line| line.strip_prefix(key).filter(|rest| rest.starts_with(' ')));
        line.unwrap_or_else(|| panic!("no `{key}` in {shown}")).trim().to_owned()
    }

    fn seconds(&self, film: &str) -> f64 {
        self.told(film, "seconds").parse().unwrap()
    }

    fn spp(&self, film: &str) -> u32 {
        self.told(film, "spp").parse().unwrap()
    }
}

#[test]
fn a_film_is_gone_on_from_to_the_same_picture() {
    let place = Place::new("film-on", &["cornell", "glass"]);
    for (scene, integrator) in [("cornell", "fast"), ("glass", "fast"), ("cornell", "both")] {
        let render = format!("render {scene}.toml --integrator {integrator} --out {scene}-{integrator}");
        let film = format!("{scene}-{integrator}.film");
        place.ok(&format!("{render}-whole.pfm --spp 44"));
        place.ok(&format!("{render}-a.pfm --spp 6 --film {film} --threads 1"));
        let on = place.ok(&format!("{render}-b.pfm --spp 44 --film {film}"));
        assert!(on.err.contains(&format!("{film}: going on from 6 spp")), "{}", on.err);
        let [whole, short, on] =
            ["whole", "a", "b"].map(|name| place.bytes(&format!("{scene}-{integrator}-{name}.pfm")));
        assert!(on == whole && short != whole, "{film}");
        assert_eq!(place.told(&film, "samples"), "0..44");
        assert_eq!(place.told(&film, "light paths"), if scene == "glass" { "yes" } else { "no" });
        // As many as are asked for or more: nothing is rendered, the picture is written, the film is let be.
        let kept = place.bytes(&film);
        place.ok(&format!("{render}-c.pfm --spp 20 --film {film}"));
        assert!(place.bytes(&film) == kept && place.bytes(&format!("{scene}-{integrator}-c.pfm")) == whole);
    }
    let names: Vec<String> = place.files().into_iter().map(|(name, _)| name).collect();
    assert!(
        names.iter().all(|name| name.ends_with(".toml") || name.ends_with(".film") || name.ends_with(".pfm")),
        "{names:?}"
    );
}

#[test]
fn films_of_parts_are_the_film_of_the_whole() {
    let place = Place::new("film-parts", &["cornell", "glass"]);
    for scene in ["cornell", "glass"] {
        let render = format!("render {scene}.toml --out part.png");
        place.ok(&format!("render {scene}.toml --spp 64 --out whole.pfm --out whole.png"));
        for (name, samples) in [("a", "0..14"), ("b", "14..40"), ("c", "40..64")] {
            place.ok(&format!("{render} --samples {samples} --film {name}.film"));
        }
        place.ok("film merge c.film a.film b.film --out all.film --out all.pfm --out all.png");
        place.ok("film merge all.film --out again.pfm");
        for (one, other) in [("all.pfm", "whole.pfm"), ("all.png", "whole.png"), ("again.pfm", "whole.pfm")] {
            assert!(place.bytes(one) == place.bytes(other), "{scene}: {one} is not {other}");
        }
        assert_eq!((place.told("all.film", "samples").as_str(), place.spp("all.film")), ("0..64", 64));
        // With a hole, which is filled later; in one film too.
        place.ok("film merge c.film a.film --out holed.film --out holed.png");
        place.refused("film merge all.film holed.film --out no.png", "holed.film", "samples 0..14, 40..64 that");
        assert_eq!((place.told("holed.film", "samples").as_str(), place.spp("holed.film")), ("0..14, 40..64", 38));
        place.ok(&format!("render {scene}.toml --spp 64 --film holed.film --out filled.pfm"));
        assert!(place.bytes("filled.pfm") == place.bytes("whole.pfm"), "{scene}: filled");
        place.ok(&format!("{render} --samples 14..40 --film a.film"));
        assert_eq!(place.told("a.film", "samples"), "0..40");
        // What a screen shows of it.
        place.ok("film merge a.film c.film --out bright.png --exposure 2 --tone aces");
        assert!(place.bytes("bright.png") != place.bytes("whole.png"));
        place.refused("film merge b.film all.film --out no.png", "all.film", "samples 14..40 that there are already");

        place.refused("film merge a.film a.film --out no.png", "a.film", "samples 0..40 that");
        for film in ["a", "b", "c", "all", "holed"] {
            std::fs::remove_file(place.path(&format!("{film}.film"))).unwrap();
        }
    }
}

#[test]
fn a_run_that_is_killed_loses_no_more_than_what_is_young() {
    let place = Place::new("film-killed", &["glass"]);
    // Slow enough that what is kept is a small part.
    let line = "render glass.toml --integrator surface --threads 1 --film c.film --out c.pfm";
    for _ in 0..3 {
        let before = std::fs::read(place.path("c.film")).ok();
        let arguments = place.arguments(&format!("{line} --time 600s"));
        let mut child = command(&arguments.iter().map(String::as_str).collect::<Vec<_>>()).spawn().unwrap();
        let begun = Instant::now();
        // Until it has kept something; the limit is for a program that never does.
        while std::fs::read(place.path("c.film")).ok() == before {
            assert!(
                child.try_wait().unwrap().is_none() && begun.elapsed() < Duration::from_secs(120),
                "nothing is kept"
            );
            std::thread::sleep(Duration::from_millis(20));
        }
        // In the midst of the next round.
        std::thread::sleep(Duration::from_millis(130));
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(!place.path("c.pfm").exists());
    }
    let (kept, seconds) = (place.spp("c.film"), place.seconds("c.film"));
    assert_eq!(place.told("c.film", "samples"), format!("0..{kept}"));
    let spp = kept + 10;
    let on = place.ok(&format!("{line} --spp {spp}"));
    assert!(on.err.contains(&format!("going on from {kept} spp")), "{}", on.err);
    place.ok(&format!("render glass.toml --integrator surface --spp {spp} --out whole.pfm"));
    assert!(place.bytes("c.pfm") == place.bytes("whole.pfm"));
    // The time of all runs: that of the last one alone is a small part.
    assert!(place.seconds("c.film") >= seconds && seconds > 0.0);
    // What the killed ones left is gone.
    let names: Vec<String> = place.files().into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["c.film", "c.pfm", "glass.toml", "whole.pfm"]);
}

#[test]
fn a_film_that_somebody_else_changes_meanwhile_is_left_to_them() {
    let place = Place::new("film-changed", &["cornell"]);
    let arguments = place.arguments("render cornell.toml --time 600s --film c.film --out c.png");
    let mut child = command(&arguments.iter().map(String::as_str).collect::<Vec<_>>()).spawn().unwrap();
    let begun = Instant::now();
    while !place.path("c.film").exists() && begun.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(20));
    }
    // In one step, as programs should.
    std::fs::write(place.path("mine"), "mine").unwrap();
    std::fs::rename(place.path("mine"), place.path("c.film")).unwrap();
    // Until it says so, or has done what it must not.
    while child.try_wait().unwrap().is_none() && place.bytes("c.film") == b"mine" {
        std::thread::sleep(Duration::from_millis(20));
    }
    let _ = child.kill();
    let ended = child.wait_with_output().unwrap();
    let said = String::from_utf8(ended.stderr).unwrap();
    assert_eq!(ended.status.code(), Some(2), "{said}");
    assert!(said.contains("c.film: was changed by somebody else meanwhile"), "{said}");
    assert!(place.bytes("c.film") == b"mine" && !place.path("c.png").exists());
}

#[test]
fn a_film_of_anything_else_is_refused_and_left_alone() {
    let place = Place::new("film-refused", &["cornell", "glass"]);
    place.ok("render cornell.toml --spp 4 --film c.film --out c.png");
    let render = "render cornell.toml --spp 8 --film c.film --out no.png";
    place.refused(&format!("{render} --seed 2"), "c.film", "has seed 1, this run 2");
    place.refused(&format!("{render} --integrator both"), "c.film", "has integrator fast, this run both");
    place.refused(&format!("{render} --depth 3"), "c.film", "has depth ");
    place.refused(
        "render glass.toml --film c.film --out no.png",
        "c.film",
        "is of the scene cornell, this run of glass",
    );
    let text = String::from_utf8(place.bytes("cornell.toml")).unwrap();
    place.write("brighter", &text.replace("emission = [", "emission = [1"));
    place.refused(
        "render brighter.toml --film c.film --out no.png",
        "c.film",
        "as it was otherwise than that of this run",
    );
    std::fs::write(place.path("larger.toml"), text.replace("width = 16", "width = 17")).unwrap();
    place.refused("render larger.toml --film c.film --out no.png", "c.film", "has 16 × 12 pixels, this run 17 × 12");
    // By another name and in another place it is the same scene.
    place.write("renamed", &text.replace("name = \"cornell\"", "name = \"renamed\""));
    place.ok("render renamed.toml --spp 6 --film c.film --out c.png");

    let whole = place.bytes("c.film");
    let damage = |at: usize| {
        let mut bytes = whole.clone();
        bytes[at] ^= 4;
        bytes
    };
    std::fs::write(place.path("cut.film"), &whole[..whole.len() / 2]).unwrap();
    std::fs::write(place.path("bent.film"), damage(whole.len() / 2)).unwrap();
    std::fs::write(place.path("newer.film"), damage(8)).unwrap();
    std::fs::write(place.path("none.film"), place.bytes("c.png")).unwrap();
    std::fs::write(place.path("empty.film"), []).unwrap();
    std::fs::create_dir(place.path("folder.film")).unwrap();
    for (film, words) in [
        ("cut.film", "is damaged: it has"),
        ("bent.film", "is damaged: its checksum"),
        ("newer.film", "version 6, which is not known"),
        ("none.film", "is no film"),
        ("empty.film", "is no film"),
        ("folder.film", ""),
    ] {
        place.refused(&format!("render cornell.toml --spp 8 --film {film} --out no.png"), film, words);
        place.refused(&format!("film merge c.film {film} --out no.png --out no.film"), film, words);
        place.refused(&format!("film show {film}"), film, words);
    }
    // The same numbers by another arithmetic: as if another machine had made the film.
    let text = "arithmetic: ";
    let at = whole.windows(text.len()).position(|some| some == text.as_bytes()).unwrap() + text.len();
    let mut other = whole.clone();
    other[at] = if other[at] == b'0' { b'1' } else { b'0' };
    let end = other.len() - 4;
    let sum = crc32fast::hash(&other[..end]);
    other[end..].copy_from_slice(&sum.to_le_bytes());
    std::fs::write(place.path("other.film"), other).unwrap();
    place.refused("render cornell.toml --spp 8 --film other.film --out no.png", "other.film", "has arithmetic ");

    #[cfg(unix)]
    {
        // To open it would wait for somebody who writes.
        let fifo = std::process::Command::new("mkfifo").arg(place.path("pipe.film")).status();
        assert!(fifo.unwrap().success());
        let run = place.run("film show pipe.film");
        assert!(run.code == 2 && run.err.contains("pipe.film: is no film"), "{run:?}");
        std::fs::remove_file(place.path("pipe.film")).unwrap();
    }
    place.refused("film merge c.film --out c.film", "c.film", "is the file of one of the films already");
    assert!(place.ok("film merge c.film --out d.png").err.contains(" spp of 1 film\n"));
    assert_eq!(place.told("c.film", "integrator"), "fast");
    place.refused("film show nothing.film", "nothing.film", "cannot be read");
    place.refused("film merge c.film --out no.jpg", "no.jpg", "no kind of picture that is known");
    place.refused("film merge c.film", "--out", "missing");
    place.refused("film merge --out no.png", "films", "missing");
    place.refused("film mend c.film", "mend", "unknown");
    place.refused("render cornell.toml --film c.png --out no.png", "c.png", "valid: .film");
    for (samples, words) in [
        ("0..7", "cuts a pair of samples"),
        ("1..8", "cuts a pair of samples"),
        ("8..8", "has no sample"),
        ("8..4", "has no sample"),
        ("8", "is no range"),
        ("-2..4", "is no range"),
        ("0..99999999999", "is no range"),
    ] {
        place.refused(&format!("render cornell.toml --samples={samples} --out no.png"), "--samples", words);
    }
    place.refused("render cornell.toml --samples 0..8 --spp 4 --out no.png", "--samples", "cannot stand beside --spp");
    assert!(place.bytes("c.film") == whole);
}
