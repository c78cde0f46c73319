//! Where a page of the book speaks of another part of the lecture: `lesson:fresnel/brewster` leads to the page that shows it.

use crate::stop::Stop;
use chapters::parameter::excerpt;
use std::collections::HashMap;

/// How an address is marked in what a link leads to.
pub const SCHEME: &str = "lesson:";

/// What stands before what a link of an author's leads to.
const IN_MARKDOWN: &str = "](";
/// The same of a link of our own.
const IN_HTML: &str = " href=\"";

/// The pages that show parts of the lecture, by their addresses.
#[derive(Debug, Default)]
pub struct Links(HashMap<String, String>);

impl Links {
    /// The part at an `address` is shown on a `page`, by its path; where it is shown first counts.
    pub fn add(&mut self, address: String, page: &str) {
        self.0.entry(address).or_insert_with(|| page.to_owned());
    }

    /// The text of a page at a path, its links leading to pages. What is ours and leads nowhere is no link any more; an
    /// author's is a fault.
    pub fn resolved(&self, text: &str, page: &str) -> Result<String, Stop> {
        let mut parts = text.split(SCHEME);
        let mut whole = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let end = part.find(['"', ')', ' ', '\n']).unwrap_or(part.len());
            let (address, rest) = part.split_at(end);
            let way = self.0.get(address).map(|target| format!("{}#{address}", relative(page, target)));
            match way {
                Some(way) if whole.ends_with(IN_MARKDOWN) || whole.ends_with(IN_HTML) => whole += &(way + rest),
                None if whole.ends_with(IN_HTML) => {
                    whole.truncate(whole.len() - IN_HTML.len());
                    whole.push_str(rest.strip_prefix('"').unwrap_or(rest));
                }
                None if whole.ends_with(IN_MARKDOWN) => {
                    let why = format!("{SCHEME}{}: no page of this book shows it", excerpt(address));
                    return Err(Stop::at(page, why));
                }
                _ => whole += &format!("{SCHEME}{part}"),
            }
        }
        Ok(whole)
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
    }

    #[test]
    fn only_links_are_changed_and_lost_ones_are_refused() {
        let mut links = Links::default();
        links.add("fresnel/brewster".to_owned(), "fresnel/brewster.md");
        links.add("fresnel/brewster".to_owned(), "later.md");
        let resolved = |text: &str| links.resolved(text, "slips.md").map_err(|stop| stop.to_string());
        assert_eq!(
            resolved("lesson:x [it](lesson:fresnel/brewster), <a href=\"lesson:fresnel/brewster\">").unwrap(),
            "lesson:x [it](fresnel/brewster.md#fresnel/brewster), <a href=\"fresnel/brewster.md#fresnel/brewster\">"
        );
        assert_eq!(resolved("<a href=\"lesson:a/b\">it</a>").unwrap(), "<a>it</a>");
        assert_eq!(resolved("[it](lesson:a/b)").unwrap_err(), "slips.md: lesson:a/b: no page of this book shows it");
    }
}
