//! The book in a real browser: what a reader without any other host gets to see.
//!
//! `cargo test --release -p book --test browser` builds the book first. Chromium and its driver must be installed
//! (`apt-get install chromium chromium-driver`); without them nothing is tried, but where `CI` is `true` that fails. `LESSON_WASM` may
//! name a folder with the figures' modules.

mod driver;

use driver::Browser;
use libtest_mimic::{Arguments, Failed, Trial};
use serde_json::{Value, json};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, ExitCode, Stdio};
use std::sync::Arc;

/// The book, shown by the program that builds it.
struct Book {
    server: Child,
    /// Kept, since what writes to a pipe that nobody has ends.
    _told: BufReader<ChildStdout>,
    url: String,
}

impl Book {
    fn serve() -> Self {
        let mut server = Command::new(env!("CARGO_BIN_EXE_book"))
            .args(["serve", "--port", "0"])
            .args(std::env::var_os("LESSON_WASM").into_iter().flat_map(|folder| ["--modules".into(), folder]))
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program of the book runs");
        let mut told = BufReader::new(server.stdout.take().expect("piped"));
        let url = told.by_ref().lines().map_while(Result::ok).find(|line| line.starts_with("http://"));
        let url = url.expect("the book is built, and where it is shown is said");
        Self { server, _told: told, url }
    }
}

impl Drop for Book {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

fn main() -> ExitCode {
    let mut arguments = Arguments::from_args();
    // One damages a module that others read.
    arguments.test_threads.get_or_insert(1);
    let Some(browser) = Browser::start() else {
        println!("skipped: no chromedriver on this machine");
        return if must() { ExitCode::FAILURE } else { ExitCode::SUCCESS };
    };
    drop(browser);
    let book = Arc::new(Book::serve());
    let tests: [(&str, fn(&Book) -> Result<(), String>); 9] = [
        ("pages_are_whole", pages_are_whole),
        ("links_lead_somewhere", links_lead_somewhere),
        ("chapters_have_their_names", chapters_have_their_names),
        ("nothing_is_wider_than_a_phone", nothing_is_wider_than_a_phone),
        ("figures_answer", figures_answer),
        ("steps_on_one_page_keep_apart", steps_on_one_page_keep_apart),
        ("modules_agree_with_the_program", modules_agree_with_the_program),
        ("modules_say_what_is_wrong", modules_say_what_is_wrong),
        ("damaged_modules_leave_figures", damaged_modules_leave_figures),
    ];
    let trials = tests.map(|(name, test)| {
        let book = Arc::clone(&book);
        Trial::test(name, move || test(&book).map_err(Failed::from))
    });
    let conclusion = libtest_mimic::run(&arguments, trials.into());
    drop(book);
    conclusion.exit_code()
}

/// Whether this machine must have all that is needed.
fn must() -> bool {
    std::env::var("CI").is_ok_and(|ci| ci == "true")
}

fn browser() -> Browser {
    Browser::start().expect("there was one")
}

/// The folder that the book was built into.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("out")
}

/// Every page, from the book's root; the one for printing is all of them once more.
fn pages() -> Vec<String> {
    fn collect(folder: &Path, pages: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).expect("there").flatten() {
            let path = entry.path();
            if path.is_dir() {
                collect(&path, pages);
            } else if path.extension().is_some_and(|extension| extension == "html") {
                pages.push(path);
            }
        }
    }
    let mut found = Vec::new();
    collect(&folder(), &mut found);
    let names = found.iter().map(|path| path.strip_prefix(folder()).expect("inside").display().to_string());
    let mut names: Vec<String> =
        names.filter(|name| !["404.html", "toc.html", "print.html"].contains(&&**name)).collect();
    names.sort();
    names
}

/// Lets a judgement fall on every page, and names those where it falls.
fn everywhere(book: &Book, judge: impl Fn(&Browser, &str) -> Result<(), String>) -> Result<(), String> {
    let browser = browser();
    browser.resize(1280, 900);
    let faults = pages().into_iter().filter_map(|page| {
        browser.load(&format!("{}{page}", book.url));
        judge(&browser, &page).err().map(|fault| format!("{page}: {fault}"))
    });
    let faults: Vec<String> = faults.collect();
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

/// No message of the console, nothing from another host, and mathematics that can be seen.
fn pages_are_whole(book: &Book) -> Result<(), String> {
    assert!(pages().len() > 80, "a page for each step: {:?}", pages());
    everywhere(book, |browser, _| {
        let said = browser.log("browser");
        if !said.is_empty() {
            return Err(format!("the console says {said:?}"));
        }
        let own = |url: &String| url.starts_with(&book.url) || url.starts_with("data:");
        if let Some(foreign) = browser.requests().into_iter().find(|url| !own(url)) {
            return Err(format!("asks for {foreign}"));
        }
        let unseen = browser.run(
            "document.querySelectorAll('details').forEach((fold) => fold.open = true);
             await document.fonts.ready;
             const seen = (math) => { const box = math.getBoundingClientRect(); return box.width > 2 && box.height > 2; };
             const all = [...document.querySelectorAll('main math')];
             const fonts = [...document.fonts].filter((font) => font.family.includes('Lesson Math'));
             return {unseen: all.filter((math) => !seen(math)).length, all: all.length,
                     font: fonts.some((font) => font.status === 'loaded'),
                     h1: document.querySelectorAll('main h1').length};",
            json!([]),
        );
        match &unseen {
            found if found["unseen"] != 0 => Err(format!("{} equations without size", found["unseen"])),
            found if found["all"] != 0 && found["font"] == false => {
                Err("the font for mathematics is not used".to_owned())
            }
            found if found["h1"] != 1 => Err(format!("{} headings of the first rank", found["h1"])),
            _ => Ok(()),
        }
    })
}

/// Every link and every anchor within the book, read as the browser reads them.
fn links_lead_somewhere(book: &Book) -> Result<(), String> {
    let mut ids: HashMap<String, HashSet<String>> = HashMap::new();
    let mut links: Vec<(String, String)> = Vec::new();
    let mut faults = Vec::new();
    let browser = browser();
    for page in pages() {
        browser.load(&format!("{}{page}", book.url));
        let found = browser.run(
            "return {ids: [...document.querySelectorAll('[id]')].map((element) => element.id),
                     links: [...document.querySelectorAll('main a[href], nav a[href]')].map((link) => link.href)};",
            json!([]),
        );
        let texts = |list: &Value| -> Vec<String> {
            list.as_array().into_iter().flatten().filter_map(Value::as_str).map(str::to_owned).collect()
        };
        let own = texts(&found["ids"]);
        let distinct: HashSet<String> = own.iter().cloned().collect();
        if own.len() != distinct.len() {
            let twice = own.iter().find(|id| own.iter().filter(|other| other == id).count() > 1);
            faults.push(format!("{page}: the id {twice:?} stands there twice"));
        }
        ids.insert(page.clone(), distinct);
        links.extend(texts(&found["links"]).into_iter().map(|link| (page.clone(), link)));
    }
    let lost = links.iter().filter(|(_, link)| {
        let Some(inside) = link.strip_prefix(&book.url) else { return link.starts_with("http://127.0.0.1") };
        let (path, anchor) = inside.split_once('#').unwrap_or((inside, ""));
        let path = path.split('?').next().unwrap_or_default();
        let path = if path.is_empty() { "index.html" } else { path };
        let found = if path == "print.html" { return !folder().join(path).is_file() } else { ids.get(path) };
        found.is_none_or(|ids| !anchor.is_empty() && !ids.contains(anchor))
    });
    faults.extend(lost.map(|(page, link)| format!("{page}: {link}")));
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

/// The pages that were written by hand are called what the lecture calls their chapters.
fn chapters_have_their_names(book: &Book) -> Result<(), String> {
    let browser = browser();
    browser.load(&format!("{}index.html", book.url));
    let named = browser.run(
        "const chapters = [...document.querySelectorAll('ol.steps a')];
         const title = async (link) => {
             const page = new DOMParser().parseFromString(await (await fetch(link.href)).text(), 'text/html');
             return [link.textContent, page.querySelector('main h1').textContent];
         };
         return Promise.all(chapters.map(title));",
        json!([]),
    );
    let named = named.as_array().cloned().unwrap_or_default();
    let wrong: Vec<_> = named.iter().filter(|pair| pair[0] != pair[1]).collect();
    if named.len() == 8 && wrong.is_empty() { Ok(()) } else { Err(format!("of {} chapters {wrong:?}", named.len())) }
}

/// A page of 360 px scrolls in one direction.
fn nothing_is_wider_than_a_phone(book: &Book) -> Result<(), String> {
    let browser = browser();
    browser.resize(360, 740);
    let faults = pages().into_iter().filter_map(|page| {
        browser.load(&format!("{}{page}", book.url));
        let found = browser.run(
            "const width = document.documentElement.clientWidth;
             const wide = [...document.querySelectorAll('main > *, main section > *')]
                 .find((element) => element.getBoundingClientRect().right > width + 1);
             return {scroll: document.documentElement.scrollWidth - width,
                     wide: wide ? wide.outerHTML.slice(0, 120) : null};",
            json!([]),
        );
        let fits = found["scroll"].as_i64().is_some_and(|beyond| beyond <= 1) && found["wide"].is_null();
        (!fits).then(|| format!("{page}: {found}"))
    });
    let faults: Vec<String> = faults.collect();
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

/// Whether figures answer in this book. Where modules cannot be built they do not; where `CI` is `true` they must.
fn has_modules() -> bool {
    let has = folder().join("modules/fresnel.wasm.gz").is_file();
    assert!(has || !must(), "the book has no modules");
    if !has {
        println!("skipped: the book has no modules");
    }
    has
}

/// What is typed changes the figure, what is wrong is said, and the link says what was set.
fn figures_answer(book: &Book) -> Result<(), String> {
    if !has_modules() {
        return Ok(());
    }
    let browser = browser();
    let set = |name: &str, text: &str| {
        browser.run(
            "const [says, text] = given;
             const row = [...document.querySelectorAll('.live-row')].find((row) => row.textContent.includes(says));
             const typed = row.querySelector('input[type=text], select');
             typed.value = text;
             typed.dispatchEvent(new Event('change'));
             const busy = () => document.querySelector('figure.drawing');
             do await new Promise((done) => setTimeout(done, 20)); while (busy());
             return {svg: document.querySelector('figure.plot svg').outerHTML,
                     status: document.querySelector('.live-status').textContent, link: location.search};",
            json!([name, text]),
        )
    };
    let page = format!("{}fresnel/natural.html", book.url);
    browser.load(&page);
    let still = browser.run("return document.querySelector('figure.plot svg').outerHTML;", json!([]));
    let gold = set("behind the interface", "gold");
    if gold["svg"] == still || gold["status"] != "" {
        return Err(format!("gold changes nothing: {}", gold["status"]));
    }
    let wrong = set("behind the interface", "<b>cheese</b>");
    let status = wrong["status"].as_str().unwrap_or_default();
    if !status.contains("n_t") || browser.run("return !!document.querySelector('.live-status b');", json!([])) == true {
        return Err(format!("to what is wrong it says {status:?}"));
    }
    browser.load(&format!("{page}?at=fresnel%2Fnatural&n_t=gold"));
    let linked = set("behind the interface", "gold");
    if linked["svg"] != gold["svg"] {
        return Err("the link shows something else".to_owned());
    }
    Ok(())
}

/// Two steps of one chapter on one page that are changed at once: each figure is its own.
fn steps_on_one_page_keep_apart(book: &Book) -> Result<(), String> {
    if !has_modules() {
        return Ok(());
    }
    let browser = browser();
    browser.load(&format!("{}slips.html", book.url));
    let found = browser.run(
        "const typed = (id) => {
             const form = document.getElementById(id).previousElementSibling;
             const row = [...form.querySelectorAll('.live-row')].find((row) => row.textContent.includes('behind the interface'));
             const typed = row.querySelector('input[type=text]');
             typed.value = 'water';
             typed.dispatchEvent(new Event('change'));
         };
         const ids = ['fresnel/dip/curves', 'fresnel/digits/digits_lost'];
         const titles = () => ids.map((id) => document.getElementById(id).querySelector('title').textContent);
         const before = titles();
         ids.forEach(typed);
         do await new Promise((done) => setTimeout(done, 50)); while (document.querySelector('figure.drawing'));
         return {before, after: titles()};",
        json!([]),
    );
    if found["before"] == found["after"] { Ok(()) } else { Err(found.to_string()) }
}

/// Figures that a module draws with other numbers here and there, and why.
const ROUNDING: [(&str, &str); 7] = [
    ("fresnel/digits/digits_lost", "it shows which digits are lost, and the last ones differ"),
    ("poynting/theorem/books", "a last bit decides on which side of an arrow its label stands"),
    ("maxwell/grid/blow_up", "beyond the Courant limit roundings grow"),
    ("maxwell/conduction/stiffness", "curves of errors end at some ε"),
    ("plane-wave/methods/after_a_while", "curves of errors end at some ε"),
    ("fresnel/snell/refraction", "a last bit decides whether a curve has a point at the critical angle"),
    ("radiometry/shapes/digits", "it shows which digits are lost, and the last ones differ"),
];

/// What a parameter may be changed to: the first that it takes and that changes the figure.
const CHANGES: [&str; 6] = ["1.2", "33deg", "4/1/0.05", "0.5", "3", "2e9"];

/// A chapter's module on one of its pages, asked without a worker: `told(request)` is its answer as an element, or a fault's text.
const MODULE: &str = "
    const packed = await fetch(new URL(`modules/${chapter}.wasm.gz`, root));
    const module = await new Response(packed.body.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
    const opened = async (module) => {
        const lesson = (await WebAssembly.instantiate(module, {})).instance.exports;
        return (bytes) => {
            const at = lesson.lesson_request(bytes.length);
            new Uint8Array(lesson.memory.buffer, at, bytes.length).set(bytes);
            const failed = lesson.lesson_answer();
            const text = new Uint8Array(lesson.memory.buffer, lesson.lesson_text(), lesson.lesson_length());
            return [failed, new TextDecoder().decode(text)];
        };
    };
    const drawnBy = (asked) => (request) => {
        const [failed, text] = asked(new TextEncoder().encode(request));
        if (failed) return text;
        return document.importNode(new DOMParser().parseFromString(text, 'image/svg+xml').documentElement, true);
    };
    const asked = await opened(module);
    const told = drawnBy(asked);
    const plain = (svg) => svg.outerHTML.replace(/\\s+/g, ' ');
    const title = (svg) => svg.querySelector('title')?.textContent;
    // Letter by letter, but in paths places may be neighbouring 64ths of a pixel: that is what a last bit does there.
    const alike = (one, other) => {
        const [ours, theirs] = [one, other].map((svg) => plain(svg).split(/ d=\"([^\"]*)\"/));
        const numbers = (path) => path.split(/[^-.0-9]+/).map(Number);
        const near = (path, its) => {
            const [mine, others] = [numbers(path), numbers(its)];
            const letters = (text) => text.replace(/[-.0-9]+/g, '#');
            return letters(path) === letters(its) && mine.length === others.length && mine.every((place, at) => Math.abs(place - others[at]) < 0.0201);
        };
        return ours.length === theirs.length
            && ours.every((part, at) => part === theirs[at] || (at % 2 === 1 && near(part, theirs[at])));
    };";

/// A figure as the program draws it, to hold the module's against: what was asked for, and the page that tells of it.
type Drawn = (String, String);

/// Lets the program draw what is asked for, a request a page of a book.
fn drawn(requests: Vec<String>) -> Result<Vec<Drawn>, String> {
    let directive = |request: &String| format!("{{{{#lesson {}}}}}", request.replace('\n', " "));
    let pages = requests
        .iter()
        .map(|request| json!({"Chapter": {"name": "", "content": directive(request), "path": null, "sub_items": []}}));
    let context = json!({"mdbook_version": "0.5.4", "renderer": "html", "config": {"book": {"src": "src"}}});
    let book = json!([context, {"items": pages.collect::<Vec<_>>()}]);
    let program =
        Path::new(env!("CARGO_BIN_EXE_book")).with_file_name(format!("lesson{}", std::env::consts::EXE_SUFFIX));
    let mut lesson = Command::new(program)
        .arg("mdbook")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| format!("the program that the book was built with: {error}"))?;
    let mut input = lesson.stdin.take().expect("piped");
    input.write_all(book.to_string().as_bytes()).map_err(|error| error.to_string())?;
    drop(input);
    let told = lesson.wait_with_output().map_err(|error| error.to_string())?;
    let told: Value = serde_json::from_slice(&told.stdout).map_err(|error| format!("no book: {error}"))?;
    let pages = told["items"].as_array().cloned().unwrap_or_default();
    let contents = pages.iter().map(|page| page["Chapter"]["content"].as_str().unwrap_or_default().to_owned());
    Ok(requests.iter().cloned().zip(contents).collect())
}

/// A module draws what the program draws: each figure as it stands in the book, and with a parameter changed.
fn modules_agree_with_the_program(book: &Book) -> Result<(), String> {
    if !has_modules() {
        return Ok(());
    }
    let browser = browser();
    let mut changed = Vec::new();
    let mut faults = Vec::new();
    let mut compared = [0; 2];
    let judged = |figure: &Value| {
        let id = figure[0].as_str().unwrap_or_default();
        // What rounds has at least its title.
        let rounds = ROUNDING.iter().any(|(rounding, _)| Some(*rounding) == id.lines().next()) && figure[2] == true;
        (figure[1] != true && !rounds).then(|| id.replace('\n', " "))
    };
    for page in pages() {
        browser.load(&format!("{}{page}", book.url));
        let script = format!(
            "const [root, changes] = given;
             const setting = document.querySelector('script.lesson-setting');
             if (!setting || location.pathname.split('/').length < 3) return [];
             const chapter = setting.dataset.step.split('/')[0];
             {MODULE}
             const names = JSON.parse(setting.textContent).map((parameter) => parameter.name);
             const tries = (id) => names.flatMap((name) => changes.map((value) => `${{id}}\\n${{name}}=${{value}}`));
             const own = [...document.querySelectorAll('figure.plot')].filter((figure) => figure.id.split('/').length === 3);
             return own.map((figure) => {{
                 const [ours, theirs] = [told(figure.id), figure.querySelector('svg')];
                 const differs = (request) => {{ const svg = told(request); return svg.outerHTML && plain(svg) !== plain(ours); }};
                 return [figure.id, alike(ours, theirs), title(ours) !== undefined && title(ours) === title(theirs),
                         tries(figure.id).find(differs) ?? null];
             }});"
        );
        for figure in browser.run(&script, json!([book.url, CHANGES])).as_array().into_iter().flatten() {
            compared[0] += 1;
            faults.extend(judged(figure));
            changed.extend(figure[3].as_str().map(str::to_owned));
        }
    }
    let mut chapters: BTreeMap<String, Vec<Drawn>> = BTreeMap::new();
    for (request, page) in drawn(changed)? {
        let chapter = request.split('/').next().unwrap_or_default().to_owned();
        chapters.entry(chapter).or_default().push((request, page));
    }
    browser.load(&format!("{}index.html", book.url));
    for (chapter, drawn) in &chapters {
        let script = format!(
            "const [root, chapter, drawn] = given;
             {MODULE}
             return drawn.map(([request, page]) => {{
                 const holder = document.createElement('div');
                 holder.innerHTML = page;
                 const [ours, theirs] = [told(request), holder.querySelector('figure.plot svg')];
                 return [request, alike(ours, theirs), title(ours) === title(theirs)];
             }});"
        );
        for figure in browser.run(&script, json!([book.url, chapter, drawn])).as_array().into_iter().flatten() {
            compared[1] += 1;
            faults.extend(judged(figure));
        }
    }
    println!("{} figures compared as they stand, {} with a parameter changed", compared[0], compared[1]);
    if compared[0] < 80 || compared[1] < 60 {
        faults.push(format!("only {compared:?} figures were compared"));
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

/// What a module cannot draw it says in words, and goes on; a wrong constant within it is seen in what it draws.
fn modules_say_what_is_wrong(book: &Book) -> Result<(), String> {
    if !has_modules() {
        return Ok(());
    }
    let browser = browser();
    browser.load(&format!("{}fresnel/natural.html", book.url));
    let script = format!(
        "const [root] = given;
         const chapter = 'fresnel';
         {MODULE}
         const id = 'fresnel/natural/against_angle';
         const wrong = ['', 'nowhere/at/all', 'fresnel', 'maxwell/media/walk_off', `${{id}}\\nwrong`, `${{id}}\\nno=1`, `${{id}}\\nn_t=-1`];
         const faults = wrong.map((request) => asked(new TextEncoder().encode(request)));
         faults.push(asked(new Uint8Array([255, 254])));
         const whole = told(id);
         // The number of radians in a degree, wrong by less than one per cent.
         const bytes = new Uint8Array(module.slice(0));
         const degree = new Uint8Array(new Float64Array([Math.PI / 180]).buffer);
         let places = 0;
         for (let at = 0; at + 8 <= bytes.length; at += 1) {{
             if (degree.every((byte, place) => bytes[at + place] === byte)) {{ bytes[at + 5] ^= 0x10; places += 1; }}
         }}
         const corrupted = drawnBy(await opened(bytes))(id);
         const still = document.getElementById(id).querySelector('svg');
         return {{faults, places, agrees: alike(whole, still), noticed: !alike(corrupted, still)}};"
    );
    let found = browser.run(&script, json!([book.url]));
    let said = found["faults"].as_array().into_iter().flatten();
    let said = said.filter(|fault| fault[0] == 1 && fault[1].as_str().is_some_and(|text| text.len() > 10)).count();
    let notices = found["places"].as_u64() > Some(0) && found["noticed"] == true;
    if said == 8 && found["agrees"] == true && notices { Ok(()) } else { Err(found.to_string()) }
}

/// A file that is as it was afterwards, whatever happens.
struct Restored {
    path: PathBuf,
    bytes: Vec<u8>,
}

impl Drop for Restored {
    fn drop(&mut self) {
        let _ = std::fs::write(&self.path, &self.bytes);
    }
}

/// A module that is damaged leaves the figure as it was, and that is said.
fn damaged_modules_leave_figures(book: &Book) -> Result<(), String> {
    if !has_modules() {
        return Ok(());
    }
    let module = folder().join("modules/poynting.wasm.gz");
    let whole = Restored { bytes: std::fs::read(&module).map_err(|error| error.to_string())?, path: module };
    std::fs::write(&whole.path, &whole.bytes[..whole.bytes.len() / 2]).map_err(|error| error.to_string())?;
    let browser = browser();
    browser.load(&format!("{}poynting/mean.html", book.url));
    let found = browser.run(
        "const still = document.querySelector('figure.plot svg').outerHTML;
         const typed = document.querySelector('.live-row input[type=text]');
         typed.value = '1.2';
         typed.dispatchEvent(new Event('change'));
         const status = document.querySelector('.live-status');
         for (let wait = 0; wait < 500 && status.textContent === ''; wait += 1) await new Promise((done) => setTimeout(done, 20));
         return {same: document.querySelector('figure.plot svg').outerHTML === still, status: status.textContent,
                 busy: !!document.querySelector('figure.drawing')};",
        json!([]),
    );
    drop(whole);
    let stays = found["same"] == true && found["busy"] == false;
    let says = found["status"].as_str().is_some_and(|status| status.contains("they stay as the book has them"));
    if stays && says { Ok(()) } else { Err(found.to_string()) }
}
