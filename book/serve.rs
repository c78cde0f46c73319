//! The book for browsers on this machine, built again when its sources change.

use crate::Fault;
use crate::press::{self, OUT, ROOT};
use std::fs::{self, File};
use std::path::{Component, Path, PathBuf};
use std::time::{Duration, SystemTime};
use tiny_http::{Header, Method, Request, Response, Server};

/// What the book is made of, from the repository's root.
const SOURCES: [&str; 7] = ["book", "chapters", "equation", "lesson", "src", "views", "yardstick"];

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
    let mut built = newest();
    press::build(Path::new(OUT), modules)?;
    println!("http://{}/", server.server_addr());
    std::thread::scope(|scope| {
        scope.spawn(|| server.incoming_requests().for_each(answer));
        loop {
            std::thread::sleep(WAIT);
            let now = newest();
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

/// When something of the sources was changed last.
fn newest() -> Option<SystemTime> {
    let root = Path::new(ROOT).parent().unwrap_or(Path::new(ROOT));
    SOURCES.iter().filter_map(|source| newest_in(&root.join(source))).max()
}

fn newest_in(path: &Path) -> Option<SystemTime> {
    let about = fs::symlink_metadata(path).ok()?;
    if !about.is_dir() {
        return about.modified().ok();
    }
    // What is built is no source.
    let is_source = |path: &PathBuf| path != Path::new(OUT) && !hidden(path);
    let entries = fs::read_dir(path).ok()?.flatten().map(|entry| entry.path());
    entries.filter(is_source).filter_map(|path| newest_in(&path)).max()
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
        assert!(newest().is_some());
    }
}
