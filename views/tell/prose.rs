//! The course text, Markdown, as blocks.

use super::Teller;
use crate::block::{Block, Heading, Inset, List, Paragraph, Rank, Span, Tone};
use chapters::text::{Phrase, Piece};
use pulldown_cmark::{Event, Parser, Tag, TagEnd, TextMergeStream};

/// The part of `prose` that belongs to the step `id`: from its marker to the next.
pub fn section<'a>(prose: &'a str, id: &str) -> &'a str {
    let mut sections = prose.split("<!-- step:").skip(1).filter_map(|section| section.split_once("-->"));
    sections.find(|(marker, _)| marker.trim() == id).map_or("", |(_, text)| text.trim())
}

impl Teller<'_> {
    /// The text at an `address`: paragraphs, lists, emphasis, code, the text of links. A heading that repeats `title`
    /// is left out.
    pub(super) fn prose(&self, address: &str, source: &str, title: &str) -> Vec<Block> {
        let source = self.words.0.text(address, "prose", source);
        let mut reader = Reader { events: TextMergeStream::new(Parser::new(&source)) };
        let mut blocks = reader.blocks();
        blocks.retain(|block| match block {
            Block::Heading(heading) => {
                heading.text.iter().map(|span| span.text.to_string()).collect::<String>() != title
            }
            _ => true,
        });
        blocks
    }
}

struct Reader<I> {
    events: I,
}

impl<'a, I: Iterator<Item = Event<'a>>> Reader<I> {
    /// Blocks up to the end of what they are in.
    fn blocks(&mut self) -> Vec<Block> {
        let (mut blocks, mut loose) = (Vec::new(), Vec::new());
        while let Some(event) = self.events.next() {
            let block = match event {
                Event::Start(Tag::Paragraph) => paragraph(self.inline()),
                Event::Start(Tag::Heading { .. }) => Block::Heading(Heading {
                    rank: Rank::Part,
                    text: vec![Span::new(Tone::Strong, self.inline())],
                    address: None,
                    rows: Vec::new(),
                }),
                Event::Start(Tag::List(_)) => {
                    flush(&mut loose, &mut blocks);
                    Block::List(self.list())
                }
                Event::Start(Tag::CodeBlock(_)) => Block::Code(self.code()),
                Event::Start(Tag::Emphasis) => {
                    loose.push(Piece::Emphasis(self.inline()));
                    continue;
                }
                Event::Start(Tag::Strong) => {
                    loose.push(Piece::Strong(self.inline()));
                    continue;
                }
                Event::Start(Tag::Link { .. } | Tag::BlockQuote(_)) => {
                    continue;
                }
                Event::End(TagEnd::Link | TagEnd::BlockQuote(_)) => continue,
                Event::End(_) => break,
                event => {
                    read(event, &mut loose);
                    continue;
                }
            };
            blocks.push(block);
        }
        flush(&mut loose, &mut blocks);
        blocks
    }

    /// The phrase up to the end of what it is in.
    fn inline(&mut self) -> Phrase {
        let mut pieces = Vec::new();
        while let Some(event) = self.events.next() {
            match event {
                Event::Start(Tag::Emphasis) => pieces.push(Piece::Emphasis(self.inline())),
                Event::Start(Tag::Strong) => pieces.push(Piece::Strong(self.inline())),
                // Of links, images and the like their text.
                Event::Start(_) => pieces.extend(self.inline().0),
                Event::End(_) => break,
                event => read(event, &mut pieces),
            }
        }
        Phrase(pieces)
    }

    fn list(&mut self) -> List {
        let mut items = Vec::new();
        while let Some(event) = self.events.next() {
            match event {
                Event::Start(Tag::Item) => items.push(self.blocks()),
                Event::End(_) => break,
                _ => {}
            }
        }
        let paragraphs = |item: &Vec<Block>| item.iter().filter(|block| matches!(block, Block::Paragraph(_))).count();
        let spaced = items.iter().any(|item| paragraphs(item) > 1);
        List { items, spaced }
    }

    fn code(&mut self) -> String {
        let mut code = String::new();
        for event in self.events.by_ref() {
            match event {
                Event::Text(text) => code.push_str(&text),
                Event::End(_) => break,
                _ => {}
            }
        }
        code
    }
}

/// What stands inside a line.
fn read(event: Event, pieces: &mut Vec<Piece>) {
    match event {
        Event::Text(text) => pieces.extend(Phrase::parse(&text).0),
        // The course text marks its symbols as code.
        Event::Code(text) => pieces.push(Piece::Code(Phrase::parse(&text))),
        Event::SoftBreak | Event::HardBreak => pieces.push(Piece::Plain(" ".to_owned())),
        _ => {}
    }
}

fn paragraph(text: Phrase) -> Block {
    Block::Paragraph(Paragraph { spans: vec![Span::new(Tone::Plain, text)], inset: Inset::default() })
}

/// Text that stands in an item without a paragraph of its own.
fn flush(pieces: &mut Vec<Piece>, blocks: &mut Vec<Block>) {
    if !pieces.is_empty() {
        blocks.push(paragraph(Phrase(std::mem::take(pieces))));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::Details;
    use crate::page::Page;
    use crate::terminal;
    use crate::words::Words;

    #[test]
    fn sections_run_from_marker_to_marker() {
        let prose = "intro\n<!-- step: a -->\nfirst\n<!-- step: b -->\nsecond\n";
        assert_eq!((section(prose, "a"), section(prose, "b"), section(prose, "c")), ("first", "second", ""));
    }

    #[test]
    fn markdown_becomes_paragraphs_and_lists() {
        let source = "## Title\n\nSome *soft* and\n`hard` [text](x), `r_s`.\n\n- one\n- two\n  more\n  - deep\n\n\
                      ## Else\n\n```\na_b\n```\nend";
        let blocks = Teller::english(Details::default()).prose("a/b", source, "Title");
        let mut page = Page::new(60, false);
        terminal::set(&mut page, Words::ENGLISH, &[Block::section(blocks)]);
        assert_eq!(
            page.into_text(),
            "Some soft and hard text, rₛ.\n\n  • one\n  • two more\n    • deep\n\nElse\n\n    a_b\n\nend\n\n"
        );
    }
}
