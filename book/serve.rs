//! The book for browsers on this machine, built again when its sources change.

use crate::Fault;
use crate::press::{self, OUT, ROOT};
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::path::{Component, Path, PathBuf};
use std::time::{Duration, SystemTime};
use tiny_http::{Header, Method, Request, Response, Server};

/// What the book is made of, from the repository's root.
const SOURCES: [&str; 10] =
    ["Cargo.lock", "Cargo.toml", "bindings", "book", "chapters", "equation", "lesson", "src", "views", "yardstick"];

/// How many browsers are answered at once: one that stops reading keeps the others from nothing.
const ANSWERERS: usize = 4;

/// How often sources are looked at.
const WAIT: Duration = Duration::from_millis(500);

/// Shows the book at a port of this machine until somebody ends it.
///
/// # Errors
/// Says why there is no book or no port.
pub fn serve(port: u16, modules: Option<&Path>) -> Result<(), Fault> {
    // A port in use is found before anything is built.
    let server = Server::http(("127.0.0.1", port))
        .map_err(|error| format!("port {port}: {error}; valid: another one, or 0 for any that is free"))?;
    let mut built = sources();
    press::build(Path::new(OUT), modules)?;
    println!("http://{}/", server.server_addr());
    std::thread::scope(|scope| {
        for _ in 0..ANSWERERS {
            scope.spawn(|| server.incoming_requests().for_each(answer));
        }
        loop {
            std::thread::sleep(WAIT);
            let now = sources();
            if now != built {
                built = now;
                match press::build(Path::new(OUT), modules) {
                    Ok(()) => eprintln!("built again"),
                    Err(fault) => eprintln!("error: {fault}"),
                }
            }
        }
    })
}

/// Every source, how long it is, and when it was changed.
fn sources() -> BTreeMap<PathBuf, (u64, Option<SystemTime>)> {
    let root = Path::new(ROOT).parent().unwrap_or(Path::new(ROOT));
    let mut found = BTreeMap::new();
    SOURCES.iter().for_each(|source| collect(root.join(source), &mut found));
    found
}

fn collect(path: PathBuf, found: &mut BTreeMap<PathBuf, (u64, Option<SystemTime>)>) {
    let Ok(about) = fs::symlink_metadata(&path) else { return };
    if !about.is_dir() {
        found.insert(path, (about.len(), about.modified().ok()));
        return;
    }
    // What is built is no source.
    let is_source = |path: &PathBuf| path != Path::new(OUT) && !hidden(path);
    let entries = fs::read_dir(path).into_iter().flatten().flatten().map(|entry| entry.path());
    entries.filter(is_source).for_each(|path| collect(path, found));
}

fn hidden(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.as_encoded_bytes().starts_with(b"."))
}

/// Sends a browser what it asks for, if it is a part of the book.
fn answer(request: Request) {
    let found = match request.method() {
        Method::Get | Method::Head => file(request.url()).and_then(|path| Some((File::open(&path).ok()?, path))),
        _ => None,
    };
    // A browser that has gone away misses nothing.
    let _ = match found {
        Some((file, path)) => request.respond(Response::from_file(file).with_header(kind(&path))),
        None => request.respond(Response::from_string("not a page of this book").with_status_code(404)),
    };
}

/// The file of the book that a request means; nothing outside it.
fn file(url: &str) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next().unwrap_or_default();
    let path = Path::new(path.strip_prefix('/')?);
    let is_inside = path.components().all(|component| matches!(component, Component::Normal(_)));
    let path = is_inside.then(|| Path::new(OUT).join(path))?;
    let path = if path.is_dir() { path.join("index.html") } else { path };
    path.is_file().then_some(path)
}

/// What a browser is to take a file for.
fn kind(path: &Path) -> Header {
    let kind = match path.extension().and_then(|extension| extension.to_str()).unwrap_or_default() {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "json" => "application/json",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "gz" => "application/gzip",
        "woff2" => "font/woff2",
        _ => "application/octet-stream",
    };
    Header::from_bytes("Content-Type", kind).expect("a header of ours")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_outside_the_book_is_sent() {
        for url in ["/../Cargo.toml", "/%2e%2e/Cargo.toml", "//etc/passwd", "/a/../../book.toml", "book.toml", ""] {
            assert_eq!(file(url), None, "{url}");
        }
    }

    #[test]
    fn sources_are_seen() {
        let found = sources();
        assert!(found.keys().any(|path| path.ends_with("pages/index.md")));
        assert!(found.keys().all(|path| !path.starts_with(OUT)));
    }
}
