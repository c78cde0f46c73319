//! Where a page of the book speaks of another part of the lecture: `lesson:fresnel/brewster` leads to the page that shows it.

use super::directive::is_code;
use crate::stop::Stop;
use chapters::parameter::excerpt;
use std::collections::{HashMap, HashSet};

/// How an author's link names a part of the lecture.
const SCHEME: &str = "lesson:";

/// What stands before that in a link, in Markdown and in HTML; elsewhere the word is a word.
const BEFORE: [&str; 4] = ["](", "](<", "]: ", "href=\""];

/// The same of a link of our own, which leads nowhere if no page shows what it means.
const OWN: &str = " href=\"lesson?";

/// A link of our own to what stands at an address.
pub fn link(address: &str, text: &str) -> String {
    format!("<a{OWN}{address}\">{text}</a>")
}

/// The pages that show parts of the lecture, by their addresses.
#[derive(Debug, Default)]
pub struct Links {
    shown: HashMap<String, String>,
    pages: HashSet<String>,
}

impl Links {
    /// Whether there was no page of this path yet; there is one then.
    pub fn claim(&mut self, path: &str) -> bool {
        self.pages.insert(path.to_owned())
    }

    /// The part at an `address` is shown on a `page`, by its path; where it is shown first counts.
    pub fn add(&mut self, address: String, page: &str) {
        self.shown.entry(address).or_insert_with(|| page.to_owned());
    }

    /// The text of a page at a path, its links leading to pages. What is ours and leads nowhere is no link any more.
    ///
    /// # Errors
    /// An author's link that leads nowhere, and its line in `place`.
    pub fn resolved(&self, text: &str, page: &str, place: &str) -> Result<String, Stop> {
        let mut whole = String::new();
        let mut parts = text.split(OWN);
        whole.push_str(parts.next().unwrap_or_default());
        for part in parts {
            let (address, rest) = part.split_once('"').unwrap_or((part, ""));
            let way = self.way(page, address).map(|way| format!(" href=\"{way}\""));
            whole.push_str(&way.unwrap_or_default());
            whole.push_str(rest);
        }
        let mut parts = whole.split(SCHEME);
        let mut text = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            if is_code(&text) || !BEFORE.iter().any(|before| text.ends_with(before)) {
                text.push_str(SCHEME);
                text.push_str(part);
                continue;
            }
            let end = part.find(['"', ')', '>', ' ', '\r', '\n']).unwrap_or(part.len());
            let (address, rest) = part.split_at(end);
            let lost = || format!("{SCHEME}{}: no page of this book shows it", excerpt(address));
            text.push_str(&self.way(page, address).ok_or_else(|| Stop::at(place, lost()))?);
            text.push_str(rest);
        }
        Ok(text)
    }

    /// The way from a page to what stands at an address. A chapter stands at the top of its page.
    fn way(&self, page: &str, address: &str) -> Option<String> {
        let target = relative(page, self.shown.get(address)?);
        Some(if address.contains('/') { format!("{target}#{address}") } else { target })
    }
}

/// The way from one page to another.
fn relative(from: &str, to: &str) -> String {
    let folders = |path: &str| path.matches('/').count();
    let shared = from.split('/').zip(to.split('/')).take_while(|(one, other)| one == other).count();
    let shared = shared.min(folders(from)).min(folders(to));
    let rest: Vec<&str> = to.split('/').skip(shared).collect();
    "../".repeat(folders(from) - shared) + &rest.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_lead_from_page_to_page() {
        assert_eq!(relative("fresnel.md", "fresnel/snell.md"), "fresnel/snell.md");
        assert_eq!(relative("fresnel/snell.md", "fresnel/brewster.md"), "brewster.md");
        assert_eq!(relative("a/b/c.md", "a/bd.md"), "../bd.md");
        assert_eq!(relative("a/é.md", "a/è.md"), "è.md");
        assert_eq!([relative("a/b.md", "a/b.md"), relative("a.md", "a.md")], ["b.md", "a.md"], "within a page");
    }

    #[test]
    fn only_links_are_changed_and_lost_ones_are_refused() {
        let mut links = Links::default();
        links.add("fresnel/brewster".to_owned(), "fresnel/brewster.md");
        links.add("fresnel/brewster".to_owned(), "later.md");
        links.add("fresnel".to_owned(), "fresnel.md");
        let resolved = |text: &str| links.resolved(text, "slips.md", "src/slips.md").map_err(|stop| stop.to_string());
        let way = "fresnel/brewster.md#fresnel/brewster";
        for (before, after) in [("[it](", ")"), ("[it](<", ">)"), ("[it]: ", "\n"), ("<a href=\"", "\">it</a>")] {
            let text = format!("lesson:x {before}lesson:fresnel/brewster{after}");
            assert_eq!(resolved(&text).unwrap(), format!("lesson:x {before}{way}{after}"));
            let lost = format!("{before}lesson:a/b{after}");
            assert_eq!(resolved(&lost).unwrap_err(), "src/slips.md: lesson:a/b: no page of this book shows it");
        }
        for code in ["`[it](lesson:a/b)`", "```text\n[it](lesson:a/b)\n```\n"] {
            assert_eq!(resolved(code).unwrap(), code);
        }
        assert_eq!(resolved(&link("a/b", "it")).unwrap(), "<a>it</a>");
        assert_eq!(resolved(&link("fresnel", "it")).unwrap(), "<a href=\"fresnel.md\">it</a>");
    }
}
