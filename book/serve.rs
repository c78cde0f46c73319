//! The book for browsers on this machine, built again when its sources change.

use crate::Fault;
use crate::press::{self, OUT, ROOT};
use hyper::server::conn::http1;
use hyper_util::rt::TokioIo;
use hyper_util::service::TowerToHyperService;
use std::collections::BTreeMap;
use std::fs;
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};
use tokio::runtime;
use tower_http::services::ServeDir;

/// What the book is made of, from the repository's root.
const SOURCES: [&str; 10] =
    ["Cargo.lock", "Cargo.toml", "bindings", "book", "chapters", "equation", "lesson", "src", "views", "yardstick"];

/// How often sources are looked at.
const WAIT: Duration = Duration::from_millis(500);

/// Shows the book at a port of this machine until somebody ends it.
///
/// # Errors
/// Says why there is no book or no port.
pub fn serve(port: u16, modules: Option<&Path>) -> Result<(), Fault> {
    // A port in use is found before anything is built.
    let listener = TcpListener::bind(("127.0.0.1", port))
        .map_err(|error| format!("port {port}: {error}; valid: another one, or 0 for any that is free"))?;
    let address = listener.local_addr().map_err(|error| format!("port {port}: {error}"))?;
    let mut built = sources();
    press::build(Path::new(OUT), modules)?;
    std::thread::spawn(move || {
        answer(listener, Path::new(OUT)).unwrap_or_else(|error| eprintln!("error: {address}: {error}"))
    });
    println!("http://{address}/");
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
}

/// Sends browsers the files of a folder, however many connections they hold and whatever they do not send on them.
fn answer(listener: TcpListener, folder: &Path) -> std::io::Result<()> {
    let files = ServeDir::new(folder);
    runtime::Builder::new_current_thread().enable_io().build()?.block_on(async {
        listener.set_nonblocking(true)?;
        let listener = tokio::net::TcpListener::from_std(listener)?;
        loop {
            // Short of descriptors, or gone before it was answered: the next one may do better.
            let Ok((stream, _)) = listener.accept().await else {
                std::thread::sleep(WAIT);
                continue;
            };
            let answers =
                http1::Builder::new().serve_connection(TokioIo::new(stream), TowerToHyperService::new(files.clone()));
            // A browser that has gone away misses nothing.
            tokio::spawn(async { answers.await.unwrap_or_default() });
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Read, Write};
    use std::net::{SocketAddr, TcpStream};

    /// The address of a folder that is shown.
    fn shown(folder: &tempfile::TempDir) -> SocketAddr {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap();
        let path = folder.path().to_owned();
        std::thread::spawn(move || answer(listener, &path));
        address
    }

    /// What is answered on an open connection.
    fn asked(stream: &mut TcpStream, path: &str) -> String {
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        write!(stream, "GET {path} HTTP/1.1\r\nHost: book\r\n\r\n").unwrap();
        let mut told = Vec::new();
        let mut length = None;
        while length.is_none_or(|length| told.len() < length) {
            let mut part = [0; 4096];
            let count = stream.read(&mut part).expect("an answer");
            assert!(count > 0, "half an answer: {}", String::from_utf8_lossy(&told));
            told.extend(&part[..count]);
            let text = String::from_utf8_lossy(&told);
            length = text.split_once("\r\n\r\n").map(|(head, _)| {
                let body = head.lines().find_map(|line| line.strip_prefix("content-length: "));
                head.len() + 4 + body.map_or(0, |body| body.parse::<usize>().expect("a length"))
            });
        }
        String::from_utf8_lossy(&told).into_owned()
    }

    #[test]
    fn nothing_outside_the_book_is_sent() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("secret"), "a secret").unwrap();
        let out = tempfile::tempdir_in(folder.path()).unwrap();
        fs::write(out.path().join("index.html"), "a page").unwrap();
        let address = shown(&out);
        let get = |path: &str| asked(&mut TcpStream::connect(address).unwrap(), path);
        assert!(get("/").ends_with("a page"));
        for path in ["/../secret", "/%2e%2e/secret", "/..%2fsecret", "//etc/passwd", "/a/../../secret", "/none"] {
            let told = get(path);
            assert!(told.starts_with("HTTP/1.1 4"), "{path}: {told}");
        }
    }

    /// A pool of threads, one a connection, had left some of a burst without any.
    #[test]
    fn connections_that_stay_open_keep_nobody_waiting() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("index.html"), "a page").unwrap();
        let address = shown(&folder);
        let burst = || -> Vec<TcpStream> { (0..8).map(|_| TcpStream::connect(address).unwrap()).collect() };
        let mut open = burst();
        open.iter_mut().for_each(|stream| assert!(asked(stream, "/").ends_with("a page")));
        // Some go away, and more come than have gone; two of them say nothing.
        open.truncate(5);
        let mut more = burst();
        more[2..].iter_mut().chain(&mut open).for_each(|stream| assert!(asked(stream, "/").ends_with("a page")));
    }

    #[test]
    fn files_are_called_what_they_are() {
        let folder = tempfile::tempdir().unwrap();
        let address = shown(&folder);
        let kinds = [
            ("a.html", "text/html"),
            ("a.css", "text/css"),
            ("a.js", "text/javascript"),
            ("a.svg", "image/svg+xml"),
            ("a.woff2", "font/woff2"),
            ("a.wasm.gz", "application/gzip"),
        ];
        for (name, kind) in kinds {
            fs::write(folder.path().join(name), "x").unwrap();
            let told = asked(&mut TcpStream::connect(address).unwrap(), &format!("/{name}"));
            assert!(told.contains(&format!("content-type: {kind}")), "{name}: {told}");
            // What is packed is the page's to unpack.
            assert!(!told.contains("content-encoding"), "{name}: {told}");
        }
    }

    #[test]
    fn sources_are_seen() {
        let found = sources();
        assert!(found.keys().any(|path| path.ends_with("pages/index.md")));
        assert!(found.keys().all(|path| !path.starts_with(OUT)));
    }
}
