//! Scenes, as the real program takes and prints them.

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{Run, command, folder, lesson, lesson_fed};
use std::path::Path;

/// A scene without a flaw, of which each line can be replaced.
const SCENE: &str = r#"max_depth = 16
[camera]
origin = [0, 1, -5]
target = [0, 1, 0]
fov_y_deg = 40
width = 64
height = 64
[materials.white]
type = "diffuse"
reflectance = [0.7, 0.7, 0.7]
[materials.gold]
type = "rough_conductor"
metal = "gold"
alpha = 0.1
[materials.clear]
type = "dielectric"
ior = 1.5
[[shapes]]
type = "sphere"
center = [0, 1, 0]
radius = 1
material = "gold"
[[shapes]]
type = "quad"
vertices = [[-5, 0, -5], [-5, 0, 5], [5, 0, 5], [5, 0, -5]]
material = "white"
emission = [1, 1, 1]
[[lights]]
type = "point"
position = [0, 5, 0]
intensity = [100, 100, 100]
"#;

fn print(path: &Path) -> Run {
    lesson_fed(&["render", "--print", path.to_str().unwrap()], b"")
}

/// Refused with exit code 2, one message that begins with `place`, and each of `words`; or how it is not.
fn refusal(path: &Path, place: &str, words: &[&str]) -> Result<(), String> {
    let run = print(path);
    let expected = format!("error: {}{place}", path.display());
    let missing = words.iter().find(|word| !run.err.contains(**word));
    match missing {
        _ if (run.code, run.out.as_str()) != (2, "") => Err(format!("{place} is not refused: {run:?}")),
        _ if !run.err.starts_with(&expected) => Err(format!("should begin with `{expected}`: {}", run.err)),
        _ if run.err.matches("error: ").count() != 1 => Err(format!("more than one: {}", run.err)),
        Some(word) => Err(format!("should say `{word}`: {}", run.err)),
        None => Ok(()),
    }
}

fn refused(path: &Path, place: &str, words: &[&str]) {
    refusal(path, place, words).unwrap();
}

#[test]
fn the_keys_of_a_scene_file_are_told() {
    let run = lesson("render --keys");
    assert!(run.code == 0 && run.err.is_empty(), "{run:?}");
    for words in ["[camera]", "[materials.NAME]  type = \"rough_conductor\"", "thickness_nm", "[[lights]]", "not yet: "]
    {
        assert!(run.out.contains(words), "{words}: {}", run.out);
    }
    assert!(run.out.lines().all(|line| line.chars().count() <= 80), "{}", run.out);
    assert_eq!(lesson("render cornell --keys").code, 2);
}

#[test]
fn one_wrong_line_is_shown_with_what_would_be_right() {
    let folder = folder("scene-lines");
    let slips: &[(&str, &str, &str, &[&str])] = &[
        (
            "radius = 1",
            "radius = -1",
            ":21:10: shapes[0].radius: ",
            &["-1 is out of range; valid: above 0", "21 | radius = -1", "         ^^"],
        ),
        ("radius = 1", "radius = nan", ":21:10: shapes[0].radius: ", &["NaN is out of range"]),
        ("radius = 1", "radius = inf", ":21:10: ", &["inf is out of range"]),
        ("radius = 1", "radius = 1e999", ":21:10: ", &["inf is out of range"]),
        ("radius = 1", "radius = \"1\"", ":21:10: ", &["must be a number, found the text `1`"]),
        ("radius = 1", "radius = 2020-01-01", ":21:10: ", &["must be a number, found a date"]),
        (
            "radius = 1",
            "radus = 1",
            ":21:1: shapes[0].radus: ",
            &["no such key in type `sphere`", "did you mean `radius`", "Known: type, center, radius, material"],
        ),
        ("radius = 1", "radius = 1\nradius = 2", ":22:1: ", &["duplicate key"]),
        ("radius = 1", "", ":18:1: shapes[0].radius: ", &["missing, and type `sphere` needs it", "[[shapes]]"]),
        ("radius = 1", "radius = 1 m", ":21:10: ", &["cannot be read"]),
        (
            "\"sphere\"",
            "\"sphree\"",
            ":19:8: shapes[0].type: ",
            &["`sphree` is no type of shape", "did you mean `sphere`", "Known: quad, sphere, disc, box, mesh"],
        ),
        ("type = \"sphere\"", "", ":18:1: shapes[0].type: ", &["missing, and a shape needs it"]),
        (
            "material = \"gold\"",
            "material = \"glod\"",
            ":22:12: shapes[0].material: ",
            &["no such material in the scene", "did you mean `gold`", "Known: white, gold, clear"],
        ),
        ("metal = \"gold\"", "metal = \"glod\"", ":13:9: materials.gold.metal: ", &["did you mean `gold`", "silver"]),
        (
            "metal = \"gold\"",
            "metal = \"gold\"\neta = [1, 1, 1]",
            ":14:7: materials.gold.eta: ",
            &["given beside metal"],
        ),
        ("metal = \"gold\"", "", ":11:1: materials.gold.metal: ", &["missing"]),
        ("alpha = 0.1", "alpha = 0", ":14:9: materials.gold.alpha: ", &["0 is out of range; valid: 0.0001 to 1"]),
        ("alpha = 0.1", "alpha_x = 0.1", ":11:1: materials.gold.alpha_y: ", &["missing"]),
        ("alpha = 0.1", "alpha = 0.1\nalpha_y = 0.1", ":15:11: materials.gold.alpha_y: ", &["given beside alpha"]),
        ("alpha = 0.1", "alpha_x = 2\nalpha_y = 2", ":14:11: materials.gold.alpha: ", &["2 is out of range"]),
        (
            "alpha = 0.1",
            "alpha = 0.1\nmasking = \"smith\"",
            ":15:11: ",
            &["`smith` is no kind of masking", "Known: correlated, separable"],
        ),
        (
            "alpha = 0.1",
            "alpha = 0.1\ncoating = {}",
            ":15:11: materials.gold.coating.medium: ",
            &["missing, and a coating needs it"],
        ),
        (
            "type = \"dielectric\"",
            "type = \"rough_dielectric\"\nalpha = 0.1\ncoating = { medium = \"mgf2\", thickness_nm = 100 }",
            ":18:1: materials.clear.coating: ",
            &["not yet: a film on rough glass"],
        ),
        ("ior = 1.5", "ior = 20", ":17:7: materials.clear.ior: ", &["20 is out of range; valid: 0.1 to 10"]),
        ("ior = 1.5", "ior = 1.5\nglass = \"bk7\"", ":17:7: materials.clear.ior: ", &["given beside glass"]),
        ("ior = 1.5", "glass = \"bk8\"", ":17:9: materials.clear.glass: ", &["no clear medium", "did you mean `bk7`"]),
        ("ior = 1.5", "glass = \"gold\"", ":17:9: materials.clear.glass: ", &["no clear medium", "Known: "]),
        (
            "ior = 1.5",
            "glass = \"bk7\"\noutside = 20",
            ":18:11: materials.clear.outside: ",
            &["20 is out of range; valid: 0.1 to 10"],
        ),
        (
            "ior = 1.5",
            "glass = \"bk7\"\ncoating = { medium = \"mgf2\", thickness_nm = 100 }",
            ":18:11: materials.clear.coating: ",
            &["cannot be used so far"],
        ),
        (
            "type = \"dielectric\"\nior = 1.5",
            "type = \"rough_dielectric\"\nalpha = 0.1\nglass = \"bk7\"",
            ":18:1: materials.clear.glass: ",
            &["not yet: a glass by name"],
        ),
        (
            "ior = 1.5",
            "ior = 1.5\ncoating = { medium = \"mgf3\", thickness_nm = 1 }",
            ":18:22: materials.clear.coating.medium: ",
            &["did you mean `mgf2`"],
        ),
        (
            "[0.7, 0.7, 0.7]",
            "[0.7, 1.2, 0.7]",
            ":10:21: materials.white.reflectance[1]: ",
            &["1.2 is out of range; valid: 0 to 1"],
        ),
        (
            "[0.7, 0.7, 0.7]",
            "[0.7, 0.7]",
            ":10:15: materials.white.reflectance: ",
            &["must be a list of three numbers, found a list of 2"],
        ),
        ("[0.7, 0.7, 0.7]", "0.7", ":10:15: ", &["must be a list of three numbers, found the number 0.7"]),
        (
            "[0.7, 0.7, 0.7]",
            "[0.7, 0.7, true]",
            ":10:26: materials.white.reflectance[2]: ",
            &["must be a number, found true"],
        ),
        (
            "[0.7, 0.7, 0.7]",
            "{ image = \"wood.png\" }",
            ":10:25: materials.white.reflectance.image: ",
            &["wood.png cannot be read"],
        ),
        (
            "[0.7, 0.7, 0.7]",
            "{ checker = [], scale = 8 }",
            ":10:27: materials.white.reflectance.checker: ",
            &["must be two colours, found 0"],
        ),
        ("[[-5, 0, -5], ", "[", ":25:12: shapes[1].vertices: ", &["must be four corners, found 3"]),
        (
            "[5, 0, 5]",
            "[6, 0, 5]",
            ":25:12: shapes[1].vertices: ",
            &["are no parallelogram; valid: [5, 0, 5] as the third"],
        ),
        ("[5, 0, 5]", "[5, 0]", ":25:38: shapes[1].vertices[2]: ", &["must be a list of three numbers"]),
        (
            "emission = [1, 1, 1]",
            "two_sided = true",
            ":27:13: shapes[1].two_sided: ",
            &["says nothing without emission"],
        ),
        ("emission = [1, 1, 1]", "emission = [1, -1, 1]", ":27:16: shapes[1].emission[1]: ", &["-1 is out of range"]),
        (
            "emission = [1, 1, 1]",
            "transform = { scale = 0 }",
            ":27:23: shapes[1].transform.scale[0]: ",
            &["leaves nothing"],
        ),
        ("emission = [1, 1, 1]", "transform = { scale = [1, 2] }", ":27:23: ", &["must be a list of three numbers"]),
        ("emission = [1, 1, 1]", "transform = { scale = \"2\" }", ":27:23: ", &["must be a number or a list of three"]),
        (
            "radius = 1",
            "radius = 1\ntransform = { scale = [1, 2, 1] }",
            ":22:23: shapes[0].transform.scale: ",
            &["ellipsoid"],
        ),
        ("width = 64", "width = 0", ":6:9: camera.width: ", &["0 is out of range; valid: at least 1"]),
        ("width = 64", "width = -1", ":6:9: ", &["must be a whole number from 0 to 4294967295, found the number -1"]),
        ("width = 64", "width = 64.5", ":6:9: ", &["must be a whole number"]),
        ("width = 64", "width = 99999999999999999999999", ":6:9: ", &["must be a whole number"]),
        (
            "width = 64",
            "width = 4000000000",
            ":6:9: camera.width: ",
            &["GiB of memory; valid: width × height up to 89478485"],
        ),
        ("fov_y_deg = 40", "fov_y_deg = 180", ":5:13: camera.fov_y_deg: ", &["valid: above 0, below 180 deg"]),
        ("fov_y_deg = 40", "fov_y_deg = 40\nfocus = 0", ":6:9: camera.focus: ", &["valid: above 0"]),
        ("target = [0, 1, 0]", "target = [0, 1, -5]", ":4:10: camera.target: ", &["is where the camera stands"]),
        ("target = [0, 1, 0]", "target = [0, 9, -5]", ":2:1: camera.up: ", &["is along the view"]),
        ("max_depth = 16", "max_depth = 0", ":1:13: max_depth: ", &["valid: at least 1"]),
        (
            "max_depth = 16",
            "filter = \"boxx\"",
            ":1:10: filter: ",
            &["`boxx` is no pixel filter", "did you mean `box`"],
        ),
        ("max_depth = 16", "environment = 1", ":1:15: environment: ", &["must be a table, found the number 1"]),
        (
            "max_depth = 16",
            "environment = { image = \"sky.exr\", scale = 1 }",
            ":1:25: environment.image: ",
            &["sky.exr cannot be read"],
        ),
        (
            "max_depth = 16",
            "environment = { image = \"sky.png\" }",
            ":1:25: environment.image: ",
            &["valid: .exr, .hdr"],
        ),
        (
            "max_depth = 16",
            "environment = { image = \"sky.exr\", radiance = [1, 1, 1] }",
            ":1:47: environment.radiance: ",
            &["given beside image"],
        ),
        (
            "max_depth = 16",
            "environment = { radiance = [1, 1, 1], rotate_deg = 1 }",
            ":1:52: environment.rotate_deg: ",
            &["says nothing without image"],
        ),
        ("max_depth = 16", "environment = { rotate_deg = 1 }", ":1:15: environment.radiance: ", &["missing"]),
        ("max_depth = 16", "environment = { radience = [1, 1, 1] }", ":1:17: ", &["did you mean `radiance`"]),
        ("max_depth = 16", "lihgts = []", ":1:1: lihgts: ", &["no such key in a scene", "did you mean `lights`"]),
        ("max_depth = 16", "name = 1", ":1:8: name: ", &["must be a text"]),
        ("[camera]", "[camra]", ":2:2: camra: ", &["did you mean `camera`"]),
        ("[[lights]]", "[lights]", ":28:1: lights: ", &["must be a list, found a table"]),
        (
            "\"point\"",
            "\"spot\"",
            ":29:8: lights[0].type: ",
            &["`spot` is no type of light", "Known: point, directional"],
        ),
        ("[100, 100, 100]", "[100, 100, 1e300]", ":31:24: lights[0].intensity[2]: ", &["1e300 is out of range"]),
        ("material = \"gold\"", "material = \"gold", ":22:17: ", &["cannot be read"]),
    ];
    let tried = slips.iter().enumerate().map(|(at, (line, slip, place, words))| {
        assert!(SCENE.contains(line), "{line}");
        let path = folder.join(format!("{at}.toml"));
        std::fs::write(&path, SCENE.replacen(line, slip, 1)).unwrap();
        refusal(&path, place, words)
    });
    let wrong: Vec<_> = tried.filter_map(Result::err).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_wrong_json_is_told_like_a_wrong_toml() {
    let folder = folder("scene-json");
    let camera = r#""camera": {"origin": [0, 0, -1], "target": [0, 0, 0], "fov_y_deg": 40, "width": 1, "height": 1}"#;
    let slips: &[(String, &str, &[&str])] = &[
        (format!("{{{camera},\n \"environment\": 1}}"), ":2:17: environment: ", &["must be a table"]),
        (format!("{{{camera},\n \"filter\": null}}"), ":2:12: filter: ", &["must be a text, found null"]),
        (format!("{{{camera},\n {camera}}}"), ":2:2: cannot be read: ", &["duplicate key"]),
        (format!("{{{camera},}}"), ":1:97: cannot be read: ", &["a comma after the last value"]),
        (format!("{{{camera},\n \"max_depth\": NaN}}"), ":2:15: cannot be read: ", &["a word without quotes"]),
        (format!("{{{camera},\n \"max_depth\": 1e99}}"), ":2:15: max_depth: ", &["must be a whole number"]),
        ("[1, 2]".into(), ": ", &["must be a table, found a list of 2"]),
        ("{}".into(), ": camera: ", &["missing, and a scene needs it"]),
        ("[".repeat(1 << 20), ":1:513: cannot be read: ", &["nested too deep"]),
        ("{\"a\":".repeat(1 << 20), ":1:", &["nested too deep"]),
    ];
    for (at, (text, place, words)) in slips.iter().enumerate() {
        let path = folder.join(format!("{at}.json"));
        std::fs::write(&path, text).unwrap();
        refused(&path, place, words);
        // No excerpt repeats a megabyte.
        assert!(print(&path).err.len() < 1000);
    }
}

#[test]
fn what_is_no_scene_file_is_refused() {
    let folder = folder("scene-files");
    let file = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    };
    refused(&file("empty.toml", b""), ": is empty", &[]);
    refused(&file("blank.json", b"\xef\xbb\xbf\r\n"), ": is empty", &[]);
    refused(&file("binary.toml", b"\x7fELF\x02\x01\xff\xfe"), ": is no text: from byte 6 on it is not UTF-8", &[]);
    refused(&file("zeros.json", &[0; 4096]), ": is no text: byte 0 is 0", &[]);
    refused(&file("zeros.toml", &[0; 4096]), ": is no text: byte 0 is 0", &[]);
    refused(&file("deep.toml", format!("a = {}", "[".repeat(1 << 20)).as_bytes()), ":1:", &["cannot be read"]);
    refused(&file("large.toml", &vec![b'#'; (8 << 20) + 1]), ": is larger than 8 MiB, the most that is read", &[]);
    refused(&file("scene.gltf", b"{}"), ": cannot be read: ", &["asset"]);
    refused(&file("scene.glb", b"glTF"), ": ends within its header", &[]);
    refused(&file("scene.xml", b"<scene/>"), ": scenes are not read from files of that kind", &["valid: .toml, .json"]);
    refused(&file("scene", b""), ": is no file of a scene", &["valid: .toml, .json"]);
    refused(&folder.join("nowhere.toml"), ": cannot be read: ", &[]);
    std::fs::create_dir(folder.join("folder.toml")).unwrap();
    refused(&folder.join("folder.toml"), ": is a folder", &[]);
    #[cfg(target_os = "linux")]
    {
        std::os::unix::fs::symlink("/dev/zero", folder.join("endless.toml")).unwrap();
        refused(&folder.join("endless.toml"), ": is no file", &[]);
    }
}

#[test]
fn a_mesh_is_found_beside_its_scene() {
    let folder = folder("scene-mesh");
    let scene = |file: &str| {
        let mesh =
            format!("[[shapes]]\ntype = \"mesh\"\nfile = \"{file}\"\nnormals = \"smooth\"\nmaterial = \"white\"\n");
        let path = folder.join("scene.toml");
        std::fs::write(&path, format!("{SCENE}{mesh}")).unwrap();
        path
    };
    std::fs::create_dir(folder.join("sub")).unwrap();
    std::fs::write(folder.join("sub/a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n").unwrap();
    let run = print(&scene("sub/a.obj"));
    assert_eq!(run.code, 0, "{run:?}");
    assert!(run.out.contains("file = \"sub/a.obj\" # 1 triangles"), "{}", run.out);
    assert_eq!(run.err, "note: sub/a.obj: 1 of 2 triangles have no area and are left out\n");
    // With its mesh, elsewhere, it is the same scene.
    let other = folder.join("other");
    let scene = scene("sub/a.obj");
    let arguments = ["render", "--print", scene.to_str().unwrap(), "--out", other.to_str().unwrap()];
    let written = lesson_fed(&arguments, b"");
    let files: Vec<_> = written.out.lines().map(Path::new).collect();
    assert_eq!(files, [other.join("scene.toml"), other.join("scene.ply")], "{written:?}");
    let there = print(files[0]);
    assert_eq!((there.code, there.out.replace("scene.ply", "sub/a.obj")), (0, run.out));
    // Hostile ones end in one message.
    std::fs::write(folder.join("cut.ply"), "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n").unwrap();
    let scene = |file| self::mesh(&folder, file);
    refused(
        &scene("cut.ply"),
        ":34:8: shapes[2].file: cut.ply: ",
        &["the header promises 4000000000 elements `vertex`"],
    );
    refused(&scene("none.ply"), ":34:8: shapes[2].file: none.ply cannot be read: ", &[]);
    refused(&scene("sub"), ":34:8: shapes[2].file: must be the name of a mesh's file", &[]);
    std::fs::create_dir(folder.join("folder.obj")).unwrap();
    refused(&scene("folder.obj"), ":34:8: shapes[2].file: folder.obj is a folder", &[]);
}

/// [`SCENE`] with one more shape, a mesh of that file.
fn mesh(folder: &Path, file: &str) -> std::path::PathBuf {
    let path = folder.join("with-mesh.toml");
    let mesh = format!("[[shapes]]\ntype = \"mesh\"\nfile = \"{file}\"\nmaterial = \"white\"\n");
    std::fs::write(&path, format!("{SCENE}{mesh}")).unwrap();
    path
}

#[test]
fn a_printed_scene_that_somebody_changed_is_left_as_it_is() {
    let folder = folder("scene-kept");
    let to = |to: &Path| lesson_fed(&["render", "mesh", "--print", "--out", to.to_str().unwrap()], b"");
    let (own, below) = (folder.join("own.toml"), folder.join("below"));
    for place in [&own, &below] {
        // The same again changes nothing.
        for _ in 0..2 {
            let run = to(place);
            assert_eq!((run.code, run.out.lines().count()), (0, 2), "{run:?}");
        }
    }
    assert!(own.is_file() && folder.join("mesh.ply").is_file() && below.join("mesh.toml").is_file());
    assert_eq!(print(&own).code, 0);
    for (place, file) in [(&own, own.clone()), (&below, below.join("mesh.toml"))] {
        std::fs::write(&file, "mine").unwrap();
        let run = to(place);
        assert!(run.code == 2 && run.err.contains("it is there already, with other content"), "{run:?}");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "mine");
    }
}

#[test]
fn a_name_is_one_that_a_terminal_shows_and_a_list_is_no_scene() -> Result<(), String> {
    let folder = folder("scene-name");
    let path = folder.join("a.toml");
    std::fs::write(&path, format!("name = \"a\\u001b[2J\"\n{SCENE}")).unwrap();
    refusal(&path, ":1:8: name: ", &["has control characters"])?;
    let path = folder.join("a.json");
    std::fs::write(&path, "[1, 2]").unwrap();
    refusal(&path, ": the scene: must be a table, found a list of 2", &[])
}

#[test]
fn the_scenes_of_the_lecture_are_listed_and_printed() {
    let list = lesson("render --list");
    assert_eq!((list.code, list.err.as_str()), (0, ""));
    for name in ["cornell", "furnace", "glass", "prism", "polariser", "rhomb", "veach", "metals", "mesh", "far", "tiny"]
    {
        assert!(
            list.out.lines().any(|line| line.trim_start().starts_with(&format!("{name} "))),
            "{name}: {}",
            list.out
        );
    }
    let cornell = lesson("render cornell --print");
    assert_eq!((cornell.code, cornell.err.as_str()), (0, ""));
    let folder = folder("scene-printed");
    let path = folder.join("again.toml");
    std::fs::write(&path, &cornell.out).unwrap();
    let again = print(&path);
    assert_eq!((again.code, again.out), (0, cornell.out));
    // A mesh that the program makes has no file yet.
    let mesh = lesson("render --print mesh");
    assert_eq!(mesh.code, 0);
    assert!(mesh.out.contains("file = \"mesh.ply\" # 200000 triangles"), "{}", mesh.out);
    assert_eq!(mesh.err, "note: mesh.ply is made by the program; --out DIR writes it beside the scene\n");
    let written = command(&["render", "--print", "mesh", "--out", folder.to_str().unwrap()]).output().unwrap();
    assert!(written.status.success(), "{written:?}");
    let there = print(&folder.join("mesh.toml"));
    assert_eq!((there.code, there.out, there.err.as_str()), (0, mesh.out, ""));
}

/// Refused in one line.
fn refused_line(arguments: &str, words: &[&str]) {
    let run = lesson(arguments);
    assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (2, "", 1), "{arguments}: {run:?}");
    for word in words {
        assert!(run.err.contains(word), "{arguments} should say `{word}`: {}", run.err);
    }
}

#[test]
fn what_is_asked_of_render_is_refused_like_everything_else() {
    refused_line("render", &["scene: missing"]);
    refused_line("render cornel", &["no such scene", "did you mean `cornell`", "Known: cornell, glass"]);
    refused_line("render --print cornel", &["did you mean `cornell`"]);
    refused_line("render cornell --out there", &["--out there", "valid: .png, .exr, .pfm"]);
    refused_line("render cornell --out /dev/null/there.png", &["cannot be used as a folder"]);
    refused_line("render cornell --spp 0", &["--spp"]);
    refused_line("render cornell --integrator lamp", &["did you mean `lamps`"]);
    refused_line("render --list cornell", &["--list"]);
    refused_line("render cornell furnace", &["one word too many"]);
    refused_line("render ./cornell", &["valid: .toml, .json"]);
    refused_line("render cornell --print --out /dev/null/there", &["cannot be used as a folder"]);
    refused_line("render cornell --print --out cornell.json", &["valid: a file that ends in .toml, or a folder"]);
}
