//! Pictures, as the real program makes, measures and tells of them.

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{Run, command, folder, lesson, lesson_fed};
use light::transport::estimate::Estimate;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// A scene of the lecture in a few pixels, as a file in `folder`.
fn small(folder: &Path, name: &str) -> PathBuf {
    let printed = lesson(&format!("render {name} --print"));
    assert_eq!(printed.code, 0, "{printed:?}");
    let side = |line: &str| line.starts_with("width = ") || line.starts_with("height = ");
    let key = |line: &str| line.split(' ').next().map(|key| format!("{key} = {}", if key == "width" { 6 } else { 5 }));
    let lines = printed.out.lines().map(|line| if side(line) { key(line).unwrap() } else { line.to_owned() });
    let path = folder.join(format!("{name}.toml"));
    fs::write(&path, lines.collect::<Vec<_>>().join("\n")).unwrap();
    path
}

/// `lesson render SCENE ARGUMENTS`, the files among them in `folder`, where they begin with `@`.
fn render(folder: &Path, scene: &Path, arguments: &str) -> Run {
    let all = arguments.split_whitespace().map(|word| match word.strip_prefix('@') {
        Some(name) => folder.join(name).to_str().unwrap().to_owned(),
        None => word.to_owned(),
    });
    let all: Vec<String> = ["render".to_owned(), scene.to_str().unwrap().to_owned()].into_iter().chain(all).collect();
    lesson_fed(&all.iter().map(String::as_str).collect::<Vec<_>>(), b"")
}

/// The names of files in a folder, in order.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        fs::read_dir(folder).unwrap().map(|one| one.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// A channel of an EXR.
fn channel(path: &Path, name: &str) -> Vec<f32> {
    use exr::prelude::*;
    let image = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer().all_attributes();
    let image = image.from_file(path).unwrap();
    let channel = image.layer_data.channel_data.list.iter().find(|channel| channel.name.to_string() == name);
    channel.unwrap_or_else(|| panic!("no {name}")).sample_data.values_as_f32().collect()
}

#[test]
fn one_run_writes_all_that_is_known_of_a_picture() {
    let folder = folder("render-all");
    let scene = small(&folder, "cornell");
    let outs = "--spp 8 --out @a.png --out @a.exr --out @a.pfm --error-map @e.svg --stats @s.json";
    let run = render(&folder, &scene, outs);
    assert_eq!(run.code, 0, "{run:?}");
    let written: Vec<_> = run.out.lines().map(|line| Path::new(line).file_name().unwrap().to_str().unwrap()).collect();
    assert_eq!(written, ["a.png", "a.exr", "a.pfm", "e.svg", "s.json"]);
    assert_eq!(names(&folder), ["a.exr", "a.pfm", "a.png", "cornell.toml", "e.svg", "s.json"]);
    // The same radiance in both, to the last bit; a float map begins at the bottom.
    let red = channel(&folder.join("a.exr"), "R");
    let pfm = fs::read(folder.join("a.pfm")).unwrap();
    let floats: Vec<f32> = pfm[pfm.len() - 6 * 5 * 12..]
        .chunks(12)
        .map(|pixel| f32::from_le_bytes(pixel[..4].try_into().unwrap()))
        .collect();
    let upright: Vec<f32> = floats.chunks(6).rev().flatten().copied().collect();
    assert_eq!(red, upright);
    // All that is seen of the box is at least as far as its open side, whatever part of a pixel it is, and its normals are no
    // longer than one.
    let depth = channel(&folder.join("a.exr"), "depth.Z");
    let normals = ["X", "Y", "Z"].map(|axis| channel(&folder.join("a.exr"), &format!("normal.{axis}")));
    assert!(depth.iter().any(|z| z.is_finite()) && depth.iter().all(|z| *z > 1.0));
    assert!((0..30).all(|at| normals.iter().map(|axis| axis[at] * axis[at]).sum::<f32>() <= 1.0 + 1e-5));
    // The errors that the statistics tell are those of the variances.
    let stats: Value = serde_json::from_slice(&fs::read(folder.join("s.json")).unwrap()).unwrap();
    let of = |name: &str| channel(&folder.join("a.exr"), name).into_iter().map(f64::from).collect::<Vec<_>>();
    let mut halves = vec![[[0.0; 3]; 2]; 30];
    for (c, letter) in ["R", "G", "B"].into_iter().enumerate() {
        let pairs = of(letter).into_iter().zip(of(&format!("variance.{letter}")));
        for (halves, (mean, variance)) in halves.iter_mut().zip(pairs) {
            // Which of the halves is the larger says nothing of the error.
            (halves[0][c], halves[1][c]) = ((mean - variance.sqrt()) as f32, (mean + variance.sqrt()) as f32);
        }
    }
    let (told, expected) = (stats["relative_mse"].as_f64().unwrap(), Estimate::of(&halves, 6).relative_mse);
    // Floats of 24 bits.
    assert!((told / expected - 1.0).abs() < 1e-5, "{told} and {expected}");
    for (key, value) in [("spp", 8), ("width", 6), ("height", 5), ("seed", 1), ("spp_before", 0), ("broken_pixels", 0)]
    {
        assert_eq!(stats[key], value, "{key}");
    }
    assert_eq!((&stats["scene"], &stats["integrator"]), (&"cornell".into(), &"fast".into()));
    let rounds = stats["rounds"].as_array().unwrap();
    assert_eq!(rounds.iter().map(|round| round["spp"].as_u64().unwrap()).collect::<Vec<_>>(), [2, 4, 8]);
    assert_eq!(rounds[2]["relative_mse"], stats["relative_mse"]);
    let time = |round: &Value| round["cpu_seconds"].as_f64().unwrap();
    assert!(rounds.windows(2).all(|two| time(&two[0]) <= time(&two[1])));
    assert!(fs::read_to_string(folder.join("e.svg")).unwrap().contains("relative error of a pixel"));
}

#[test]
fn a_film_without_its_scene_has_no_features_to_write() {
    let folder = folder("render-film-exr");
    let scene = small(&folder, "furnace");
    let run = render(&folder, &scene, "--spp 2 --film @a.film --out @a.pfm");
    assert_eq!(run.code, 0, "{run:?}");
    let [film, out] = ["a.film", "a.exr"].map(|name| folder.join(name).to_str().unwrap().to_owned());
    let run = lesson_fed(&["film", "merge", &film, "--out", &out], b"");
    assert_eq!(run.code, 0, "{run:?}");
    assert_eq!(channel(Path::new(&out), "variance.G").len(), 30);
    let bytes = fs::read(&out).unwrap();
    assert!(!bytes.windows(7).any(|seven| seven == b"depth.Z"));
}

#[test]
fn what_a_scene_needs_is_explained_with_what_was_measured() {
    let folder = folder("render-explain");
    let scene = small(&folder, "glass");
    let run = render(&folder, &scene, "--spp 2 --explain --out @a.pfm");
    assert_eq!(run.code, 0, "{run:?}");
    for words in [
        "glass needs",
        "paths from lamps by way of mirrors, glass and polished metal",
        "the same picture, bit for bit",
        "nothing to do",
        "everything of it together",
        "Left in",
        "Measured on 6 × 5 pixels",
    ] {
        assert!(run.out.contains(words), "should say `{words}`: {}", run.out);
    }
    // The paths stand last, for who reads them off.
    assert_eq!(run.out.lines().last(), folder.join("a.pfm").to_str());
    let simple = render(&folder, &scene, "--spp 2 --explain --integrator lamps --out @b.pfm");
    assert!(simple.code == 0 && !simple.out.contains("Left in"), "{simple:?}");
}

#[test]
fn radiosity_says_what_it_did_and_what_it_cannot_do() {
    let folder = folder("render-radiosity");
    let scene = small(&folder, "cornell");
    let run = render(&folder, &scene, "--spp 2 --integrator radiosity --explain --out @a.pfm --stats @a.json");
    assert_eq!(run.code, 0, "{run:?}");
    for words in
        ["17 faces, of them 1 backs", "by closed forms", "residual", "of all others sums to", "hidden at least in part"]
    {
        assert!(run.out.contains(words), "should say `{words}`: {}", run.out);
    }
    let stats: serde_json::Value = serde_json::from_slice(&fs::read(folder.join("a.json")).unwrap()).unwrap();
    let patches = &stats["patches"][0];
    assert_eq!((&stats["integrator"], stats["patches"].as_array().map(Vec::len)), (&"radiosity".into(), Some(1)));
    // As many as --explain tells of, solved as it tells.
    let residual = patches["residual"].as_f64().expect("a number");
    for words in [
        format!("{} faces", patches["faces"]),
        format!("{} patches for the first two", patches["patches"]),
        format!("solved by {} bounces", patches["iterations"]),
        format!("residual {residual:.1e}"),
    ] {
        assert!(run.out.contains(&words), "should say `{words}`: {}", run.out);
    }
    assert_eq!(patches["solver"], "bounces");
    let glass = small(&folder, "glass");
    let run = render(&folder, &glass, "--spp 2 --integrator radiosity --out @b.pfm");
    assert_eq!(run.code, 2, "{run:?}");
    let words = [
        "--integrator: radiosity cannot do this scene",
        "shapes[6].geometry",
        "is not made of flat patches",
        "valid here: ",
    ];
    assert!(words.iter().all(|words| run.err.contains(words)), "{run:?}");
    assert!(!folder.join("b.pfm").exists());
}

#[test]
fn a_race_tells_of_every_integrator_that_fits_and_draws_them() {
    let folder = folder("render-race");
    let scene = small(&folder, "cornell");
    let run = render(&folder, &scene, "--time 100ms --spp 64 --race --plot --format svg --out @figures");
    assert_eq!(run.code, 0, "{run:?}");
    for name in ["fast", "hemisphere", "surface", "lamps", "both", "photon-map", "irradiance-cache", "radiosity"] {
        assert!(run.out.contains(&format!("  {name}: ")), "{name}: {}", run.out);
    }
    assert!(run.out.contains("reference: fast, seed 2, ") && run.out.contains("efficiency"), "{}", run.out);
    let figure = folder.join("figures/render-cornell-race.svg");
    assert_eq!(run.out.lines().last(), figure.to_str());
    assert!(fs::read_to_string(figure).unwrap().contains("CPU time"));
    // Glass is nothing for who looks by chance alone over the hemisphere.
    let glass = small(&folder, "glass");
    let run = render(&folder, &glass, "--time 10ms --spp 2 --race");
    assert!(run.code == 0 && run.out.contains("  both: ") && !run.out.contains("  hemisphere: "), "{run:?}");
    assert_eq!(names(&folder.join("figures")), ["render-cornell-race.svg"]);
    // A file by its name, in a folder that is there.
    let run = render(&folder, &glass, "--time 10ms --spp 2 --race --plot --out @r.svg");
    assert!(run.code == 0 && folder.join("r.svg").is_file(), "{run:?}");
}

#[test]
fn what_cannot_be_written_is_refused_before_the_work() {
    let folder = folder("render-refused");
    let scene = small(&folder, "furnace");
    fs::create_dir(folder.join("taken.json")).unwrap();
    let before = names(&folder);
    // So many samples that work which began would not end.
    for (arguments, words) in [
        ("--stats @s.txt", "valid: .json"),
        ("--stats @taken.json", "there is a folder of that name"),
        ("--stats /dev/null/s.json", "cannot be used as a folder"),
        ("--error-map @e.jpg", "valid: .png, .svg"),
        ("--error-map /dev/null/e.png", "cannot be used as a folder"),
        ("--out @a.tif", "valid: .png, .exr, .pfm"),
        ("--out @a.png --out @./a.png", "is the file of another one already"),
        ("--out @a.png --error-map @a.png", "is the file of --out already"),
        ("--race --plot --out /dev/null/figures", "cannot be used as a folder"),
        ("--race --out @figures", "needs --plot"),
        ("--race --plot --out @a --out @b", "only one file or folder"),
        ("--race --plot --format svg --out @r.png", "--format: is not that of "),
        ("--out /nowhere/at/all/x.png", "there is no folder /nowhere/at/all"),
        ("--spp 4", "--spp: given twice; valid: once"),
        ("--stats @s.json --stats @t.json", "--stats: given twice"),
        ("--threads -3", "--threads: must be a whole number from 1 to 1024, found `-3`"),
        ("--depth 0", "--depth: must be a whole number from 1 to 1000000, found `0`"),
        ("--seed -1", "--seed: must be a whole number from 0 to 18446744073709551615, found `-1`"),
        ("--time -5s", "--time: out of range"),
        ("--width 1000000", "--width, --height: 1000000 × "),
        ("--race --error 0.1", "--error"),
        ("--race --stats @s.json", "--stats"),
        ("--race --integrator fast", "--integrator"),
        ("--plot", "needs --race"),
        ("--race --format svg", "needs --plot"),
        ("--time 0s", "out of range"),
        ("--time 5parsec", "--time: `5parsec`: `parsec` is no unit here; units: fs, ps, ns, us, ms, s, min, h\n"),
        ("--time min", "is not a number"),
    ] {
        let run = render(&folder, &scene, &format!("--spp 16777216 {arguments}"));
        assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (2, "", 1), "{arguments}: {run:?}");
        assert!(run.err.contains(words), "{arguments} should say `{words}`: {}", run.err);
    }
    assert_eq!(names(&folder), before);
    // A scene is not overwritten by what is known of it.
    let json = folder.join("scene.json");
    fs::write(&json, r#"{"camera": {"origin": [0, 0, 3], "target": [0, 0, 0], "fov_y_deg": 40, "width": 4, "height": 4}, "environment": {"radiance": [1, 1, 1]}}"#).unwrap();
    let text = fs::read(&json).unwrap();
    let run = render(&folder, &json, "--spp 2 --out @b.pfm --stats @scene.json");
    assert!(run.code == 2 && run.err.contains("is the file of the scene already"), "{run:?}");
    assert_eq!(fs::read(&json).unwrap(), text);
}

#[test]
fn a_picture_is_as_large_as_is_asked_and_named_after_its_file() {
    let folder = folder("render-size");
    let scene = small(&folder, "furnace");
    for (arguments, head) in
        [("", "6 5"), ("--width 12", "12 10"), ("--height 10", "12 10"), ("--width 3 --height 7", "3 7")]
    {
        let run = render(&folder, &scene, &format!("--spp 2 --out @a.pfm {arguments}"));
        assert_eq!(run.code, 0, "{run:?}");
        assert!(fs::read(folder.join("a.pfm")).unwrap().starts_with(format!("PF\n{head}\n").as_bytes()), "{arguments}");
    }
    // Of one pixel nothing tells how sure its error is.
    let run = render(&folder, &scene, "--spp 2 --width 1 --height 1 --out @a.pfm --stats @s.json");
    assert!(run.code == 0 && run.err.contains(" ± unknown)"), "{run:?}");
    let stats: Value = serde_json::from_slice(&fs::read(folder.join("s.json")).unwrap()).unwrap();
    assert!(stats["deviation"].is_null() && stats["rounds"][0]["deviation"].is_null(), "{stats}");
    fs::copy(&scene, folder.join("my scene.toml")).unwrap();
    let output = command(&["render", "my scene.toml", "--spp", "2"]).current_dir(&folder).output().unwrap();
    assert_eq!(String::from_utf8(output.stdout).unwrap(), "lesson-out/my scene.png\n");
    let output = command(&["render", "Cornell", "--spp", "2", "--width", "4"]).current_dir(&folder).output().unwrap();
    assert_eq!(String::from_utf8(output.stdout).unwrap(), "lesson-out/cornell.png\n");
}

#[test]
fn what_a_newcomer_forgets_is_told() {
    let run = lesson("render");
    assert!(run.code == 2 && run.err.contains("scene: missing") && run.err.contains("cornell"), "{run:?}");
    for command in ["", "render ", "film merge ", "eval "] {
        let version = format!("lesson {}\n", env!("CARGO_PKG_VERSION"));
        assert_eq!(lesson(&format!("{command}--version")).out, version, "{command}");
    }
    let folder = folder("render-dark");
    let dark = folder.join("dark.json");
    fs::write(
        &dark,
        r#"{"camera": {"origin": [0, 0, 3], "target": [0, 0, 0], "fov_y_deg": 40, "width": 4, "height": 4}}"#,
    )
    .unwrap();
    let run = render(&folder, &dark, "--spp 2 --out @a.png");
    assert!(run.code == 0 && run.err.contains("note: nothing in it emits light"), "{run:?}");
    let run = render(&folder, &small(&folder, "cornell"), "--spp 2 --out @a.png");
    assert!(run.code == 0 && !run.err.contains("note: "), "{run:?}");
}

/// Waits until a file is there, while the program runs.
#[cfg(unix)]
fn awaited(child: &mut std::process::Child, path: &Path) {
    let begun = std::time::Instant::now();
    while !path.exists() {
        assert!(
            child.try_wait().unwrap().is_none() && begun.elapsed().as_secs() < 120,
            "{} is not there",
            path.display()
        );
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
}

#[cfg(unix)]
#[test]
fn who_is_asked_to_end_keeps_what_there_is() {
    let folder = folder("render-interrupted");
    let scene = small(&folder, "cornell");
    let of = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    for (signal, code, is_in_the_way) in [("INT", 130, false), ("TERM", 143, false), ("INT", 2, true)] {
        let _ = fs::remove_file(folder.join("c.film"));
        let _ = fs::remove_file(folder.join("a.png"));
        fs::create_dir_all(folder.join("sub")).unwrap();
        let [scene, png, pfm, film] = [scene.to_str().unwrap().to_owned(), of("a.png"), of("sub/b.pfm"), of("c.film")];
        let arguments = [
            "render",
            &scene,
            "--spp",
            "16777216",
            "--time",
            "600s",
            "--threads",
            "1",
            "--out",
            &png,
            "--out",
            &pfm,
            "--film",
            &film,
        ];
        let mut child = command(&arguments).spawn().unwrap();
        awaited(&mut child, Path::new(&film));
        // A second run on the same film would undo what this one does.
        let second = lesson_fed(&["render", &scene, "--spp", "2", "--out", &of("d.png"), "--film", &film], b"");
        assert!(second.code == 2 && second.err.contains("another run is writing it"), "{second:?}");
        if is_in_the_way {
            fs::remove_dir_all(folder.join("sub")).unwrap();
            fs::write(folder.join("sub"), "a file of somebody's").unwrap();
        }
        let killed = std::process::Command::new("kill").args([format!("-{signal}"), child.id().to_string()]).status();
        assert!(killed.unwrap().success());
        let output = child.wait_with_output().unwrap();
        let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
        assert_eq!(output.status.code(), Some(code), "{err}");
        assert!(
            err.contains("stopped: ") && err.contains(" of 16777216 spp; the same command goes on from there"),
            "{err}"
        );
        let written = if is_in_the_way { format!("{png}\n") } else { format!("{png}\n{pfm}\n") };
        assert_eq!(out, written, "{err}");
        assert!(folder.join("a.png").is_file() && !folder.join("d.png").exists());
        assert_eq!(err.contains("sub/b.pfm: cannot be written"), is_in_the_way, "{err}");
        let shown = lesson_fed(&["film", "show", &film], b"");
        assert!(shown.code == 0 && shown.out.contains("samples      0.."), "{shown:?}");
    }
}

/// Asks a program to end, as Ctrl-C does.
#[cfg(unix)]
fn interrupt(child: &std::process::Child) {
    let killed = std::process::Command::new("kill").args(["-INT".to_owned(), child.id().to_string()]).status();
    assert!(killed.unwrap().success());
}

#[cfg(unix)]
#[test]
fn who_is_asked_twice_ends_at_once() {
    use std::io::Write;
    use std::time::{Duration, Instant};
    let folder = folder("render-interrupted-twice");
    let scene = small(&folder, "cornell");
    let [png, film] = ["a.png", "a.film"].map(|name| folder.join(name).to_str().unwrap().to_owned());
    let arguments = ["render", scene.to_str().unwrap(), "--spp", "16777216", "--out", &png, "--film", &film];
    // A full pipe that nobody reads holds the program up where it would say that its picture is in place.
    let (reader, mut writer) = std::io::pipe().unwrap();
    let out = writer.try_clone().unwrap();
    let filling = std::thread::spawn(move || while writer.write_all(&[b' '; 4096]).is_ok() {});
    let mut child = command(&arguments).stdout(out).spawn().unwrap();
    awaited(&mut child, Path::new(&film));
    interrupt(&child);
    awaited(&mut child, Path::new(&png));
    std::thread::sleep(Duration::from_millis(200));
    assert!(child.try_wait().unwrap().is_none(), "nobody has read where the picture is");
    interrupt(&child);
    let begun = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        assert!(begun.elapsed() < Duration::from_secs(60), "a second request is none");
        std::thread::sleep(Duration::from_millis(20));
    };
    assert_eq!(status.code(), Some(130));
    drop(reader);
    filling.join().unwrap();
}

#[test]
fn times_are_taken_in_the_units_that_people_use() {
    let folder = folder("render-time");
    let scene = small(&folder, "furnace");
    for time in ["1h", "2min", "20s", "500ms", "3"] {
        let run = render(&folder, &scene, &format!("--spp 2 --time {time} --out @a.pfm"));
        assert!(run.code == 0 && run.err.contains(", 2 spp in "), "{time}: {run:?}");
    }
    // Nothing of bars and pictures goes into a pipe.
    let run = render(&folder, &scene, "--time 200ms --out @b.pfm");
    assert!(run.err.lines().count() == 1 && !run.err.contains('\u{1b}') && !run.out.contains('\u{1b}'), "{run:?}");
}
