//! Scenes: the lecture's own by name, others from files; and back into files.

mod fields;
#[cfg(test)]
mod fuzz;
mod gltf;
mod images;
mod json;
mod keys;
mod meshes;
mod obj;
mod ply;
mod print;
mod read;
mod reference;
mod rgbe;
mod source;
#[cfg(test)]
mod tests;
mod toml;
mod tree;

pub use print::stem;
pub use reference::blocks as keys;

use crate::out::{self, Folder};
use crate::stop::{Stop, harmless, plain};
use chapters::parameter::{Fault, excerpt};
use chapters::text::Phrase;
use images::Images;
use light::scene::Scene;
use light::scene::builtin::{self, BUILTIN};
use meshes::{Files, Meshes};
use source::{Snag, Source, bounded};
use std::path::Path;
use tree::{Malformed, Node};
use views::block::{Block, Span, Term, Terms, Tone};

/// The scene called `name`, or that of a file of that name. It has no flaw; what was left out of its files is said on
/// standard error.
pub fn load(name: &str) -> Result<Scene, Stop> {
    let path = Path::new(name);
    let folder = path.parent().unwrap_or(Path::new(""));
    let files = |file: &Path| bounded(&folder.join(file), meshes::LARGEST);
    let (scene, notes) = match format(path)? {
        None => return Ok((known(name)?.make)()),
        Some(Format::Text(parse)) => read(&Source::open(path)?, parse, &files)?,
        Some(Format::Gltf) => {
            let bytes = bounded(path, meshes::LARGEST).map_err(|why| Stop::at(path.display(), why))?;
            read_gltf(path, &bytes, &files)?
        }
    };
    notes.iter().for_each(|note| out::say(&format!("note: {}", harmless(note))));
    Ok(scene)
}

/// How a scene's file is written.
#[derive(Clone, Copy)]
enum Format {
    Text(Parse),
    Gltf,
}

/// Makes a tree of a text.
type Parse = fn(&str) -> Result<Node, Malformed>;

/// The format of a file by its name; None if that is no file's.
fn format(path: &Path) -> Result<Option<Format>, Stop> {
    const FILES: &str = "valid: .toml, .json, .gltf, .glb, or the name of a scene of the lecture";
    let extension = match path.extension() {
        Some(extension) => plain(&extension.to_string_lossy()),
        None if path.components().count() > 1 => {
            return Err(Stop::at(path.display(), format!("is no file of a scene; {FILES}")));
        }
        None => return Ok(None),
    };
    match extension.as_str() {
        "toml" => Ok(Some(Format::Text(toml::parse))),
        "json" => Ok(Some(Format::Text(json::parse))),
        "gltf" | "glb" => Ok(Some(Format::Gltf)),
        _ => Err(Stop::at(path.display(), format!("scenes are not read from files of that kind; {FILES}"))),
    }
}

/// The lecture's scene of that name.
fn known(name: &str) -> Result<&'static builtin::Builtin, Stop> {
    let wanted = plain(name);
    BUILTIN.iter().find(|builtin| plain(builtin.name) == wanted).ok_or_else(|| {
        let names = BUILTIN.iter().map(|builtin| builtin.name);
        Fault::unknown(
            excerpt(name),
            name,
            "no such scene, and no file, which ends in .toml, .json, .gltf or .glb",
            names,
        )
        .into()
    })
}

/// Reads glTF, and what was left out of it. The scene has no flaw.
fn read_gltf(path: &Path, bytes: &[u8], files: Files) -> Result<(Scene, Vec<String>), Stop> {
    let refused = |why: String| Stop::at(path.display(), why);
    let name = path.file_stem().map_or(String::new(), |stem| stem.to_string_lossy().into_owned());
    let name: String = name.chars().filter(|c| !c.is_control()).collect();
    // The files that it names lie beside it.
    let own = Path::new(path.file_name().unwrap_or_default());
    let (scene, notes) = gltf::scene(&name, own, bytes, files).map_err(refused)?;
    match scene.flaw() {
        None => Ok((scene, notes)),
        Some(flaw) => Err(refused(flaw.to_string())),
    }
}

/// Reads a text, and what was left out of the files it names.
fn read(source: &Source, parse: Parse, files: Files) -> Result<(Scene, Vec<String>), Stop> {
    let root = parse(&source.text).map_err(|Malformed { why, span }| {
        source.refuse(Snag { span: Some(span), fault: Fault::new("cannot be read", why) })
    })?;
    let name = source.path.file_stem().map_or(String::new(), |stem| stem.to_string_lossy().into_owned());
    let name: String = name.chars().filter(|c| !c.is_control()).collect();
    let (mut meshes, mut images) = (Meshes::new(files), Images::new(files));
    let scene = read::scene(&root, &name, &mut meshes, &mut images).map_err(|snag| source.refuse(snag))?;
    Ok((scene, meshes.notes))
}

/// A scene as TOML, and the files that it names: all there is of it, wherever it was read from.
pub fn written(scene: &Scene) -> (String, Vec<Vec<u8>>) {
    let printed = print::print(scene, true);
    (printed.text, printed.files.iter().map(|(_, file)| file.bytes()).collect())
}

/// The lecture's scenes.
pub fn list() -> Vec<Block> {
    let item = |builtin: &builtin::Builtin| Term {
        name: Span::verbatim(Tone::Code, builtin.name),
        says: vec![Span::new(Tone::Plain, Phrase::verbatim(builtin.about))],
        note: None,
    };
    vec![Block::section(vec![Block::Terms(Terms { width: Some(12), items: BUILTIN.iter().map(item).collect() })])]
}

/// Writes a scene as TOML to standard output; or as a file `to`, or into a folder of that name, with its meshes and images.
pub fn serve_print(name: &str, to: Option<&Path>) -> Result<(), Stop> {
    let scene = load(name)?;
    let printed = print::print(&scene, to.is_some());
    let Some(to) = to else {
        out::print(printed.text.as_bytes())?;
        for (file, _) in &printed.files {
            out::say(&format!("note: {file} is made by the program; --out DIR writes it beside the scene"));
        }
        return Ok(());
    };
    let (folder, own) = match to.extension().filter(|_| !to.is_dir()) {
        None => (Folder::open(to)?, format!("{}.toml", print::stem(&scene.name))),
        Some(extension) if plain(&extension.to_string_lossy()) == "toml" => Folder::of(to)?,
        Some(_) => {
            let why = "a scene is printed as TOML; valid: a file that ends in .toml, or a folder";
            return Err(Stop::at(format!("--out {}", to.display()), why));
        }
    };
    let besides = printed.files.iter().map(|(name, file)| (name.clone(), file.bytes()));
    let files = std::iter::once((own, printed.text.into_bytes())).chain(besides);
    let draft = |(file, bytes): (String, Vec<u8>)| {
        folder.unlike(&file, &bytes)?;
        folder.draft(&file, &bytes)
    };
    let drafts = files.map(draft).collect::<Result<Vec<_>, _>>()?;
    out::publish(&drafts)?;
    let paths: String = drafts.iter().map(|draft| format!("{}\n", draft.path().display())).collect();
    out::print(paths.as_bytes())
}
