//! What is on the pictures, by content.

use super::{gallery, png, svg};

/// Writes the gallery to a folder named by `LESSON_GALLERY`, for looking at.
#[test]
fn gallery_can_be_written() {
    for (name, plot) in gallery::all() {
        let (png, svg) = (png(&plot), svg(&plot));
        assert!(png.len() < 200_000, "{name}.png has {} bytes", png.len());
        if let Some(folder) = std::env::var_os("LESSON_GALLERY") {
            let folder = std::path::Path::new(&folder);
            std::fs::create_dir_all(folder).unwrap();
            std::fs::write(folder.join(format!("{name}.png")), png).unwrap();
            std::fs::write(folder.join(format!("{name}.svg")), svg).unwrap();
        }
    }
}
