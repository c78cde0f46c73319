//! What broke a reader once, each as small as it could be made.

use super::{FORMATS, judged, seeds};

/// Reads a file as the format of that name, and returns whether it was accepted.
fn read(name: &str, bytes: &[u8]) -> bool {
    let format = FORMATS.iter().find(|format| format.name == name).expect("a format");
    judged(format, bytes).unwrap_or_else(|why| panic!("{name}: {why}"))
}

/// What a message quoted was the terminal's to obey.
#[test]
fn control_characters_of_a_file_are_not_told() {
    let camera = "[camera]\norigin = \"\\u001b[31m\"\ntarget = [0, 0, 0]\nfov_y_deg = 40\nwidth = 1\nheight = 1\n";
    assert!(!read("toml", camera.as_bytes()));
    assert!(!read("hdr", b"#?RADIANCE\nFORMAT=32-bit\x1b[2J\n\n-Y 1 +X 1\n\0\0\0\0"));
    assert!(!read("obj", b"v 0 0 \x1b\n"));
    assert!(!read("gltf", br#"{"asset": {"version": "2.0"}, "extensionsRequired": ["\u001b[31m"]}"#));
}

/// A message repeated a name of any length.
#[test]
fn names_of_any_length_are_told_by_their_ends() {
    let name = "m".repeat(5000);
    for entry in ["type = \"plastic\"\nior = 1.5\n", "type = \"diffuse\"\nreflectance = [2, 0, 0]\n"] {
        let text =
            format!("{}[materials.{name}]\n{entry}", String::from_utf8(seeds::toml().swap_remove(2)).expect("a text"));
        assert!(!read("toml", text.as_bytes()));
    }
}

/// B44's differences below 0 were an overflow in builds that look.
#[test]
fn differences_of_b44_wrap() {
    let mut bytes = seeds::exr().swap_remove(6);
    let end = bytes.len() - 60;
    bytes[end..].fill(0);
    read("exr", &bytes);
}
