//! Blocks as semantic HTML that is well-formed XML too: no scripts, nothing from elsewhere.
//!
//! The id of what has an address is that address. What is judged says so in words, colour comes on top; what need not
//! be read at once is folded.

mod phrase;
#[cfg(test)]
mod tests;

use crate::block::{
    Answers, Block, Cases, Choice, Figure, Fold, Formula, Heading, Judged, Line, Lines, Picture, Quantity, Question,
    Rank, Section, Table, Terms,
};
use crate::report::Verdict;
use crate::words::Words;
use crate::xml::escape;
use chapters::text::Phrase;
use phrase::{phrase, span, spans};
use std::collections::HashSet;

/// What a page looks like without a book around it.
const STYLE: &str = "body{max-width:46rem;margin:2rem auto;padding:0 1rem;font:1rem/1.5 sans-serif}\
    table{border-collapse:collapse}th,td{padding:.1rem .6rem;text-align:start}td.number{text-align:end}\
    .aside,.address,.rows{opacity:.75;font-size:.9em}\
    .judged{margin:1rem 0;padding-inline-start:.8rem;border-inline-start:.2rem solid}\
    .passed{border-color:#070}.failed{border-color:#b00}.good{color:#060}.bad{color:#a00;font-weight:bold}\
    math[display=block],figure{overflow-x:auto}@media(prefers-color-scheme:dark){:root{color-scheme:dark}\
    .good{color:#7d7}.bad{color:#f88}}";

/// A whole page.
pub fn document(title: &Phrase, language: &str, words: Words, blocks: &[Block]) -> String {
    let (language, title) = (escape(language), escape(&title.to_string()));
    format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width\"/>\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n\
         <body>\n<main>\n{}</main>\n</body>\n</html>\n",
        fragment(words, blocks)
    )
}

/// An end of a line that is kept: written as a reference, so that no line of a fragment is empty.
const BREAK: &str = "&#10;";

/// A part of a page. It has no empty line, which would end it where it stands in Markdown.
pub fn fragment(words: Words, blocks: &[Block]) -> String {
    written(words, blocks, false)
}

/// The same of a step on a page of its own, whose heading is the page's and stands there already.
pub fn page(words: Words, blocks: &[Block]) -> String {
    written(words, blocks, true)
}

fn written(words: Words, blocks: &[Block], is_page: bool) -> String {
    let mut writer = Writer { html: String::new(), words, ids: HashSet::new(), is_page };
    writer.blocks(blocks);
    writer.html
}

/// A few words within a paragraph.
pub fn inline(text: &Phrase) -> String {
    phrase(text)
}

struct Writer<'a> {
    html: String,
    words: Words<'a>,
    ids: HashSet<String>,
    /// Whether the page has the heading of the step already.
    is_page: bool,
}

impl Writer<'_> {
    fn blocks(&mut self, blocks: &[Block]) {
        blocks.iter().for_each(|block| self.block(block));
    }

    fn line(&mut self, line: impl AsRef<str>) {
        self.html.push_str(line.as_ref());
        self.html.push('\n');
    }

    /// `name` with attributes around what `inner` writes.
    fn within(&mut self, name: &str, attributes: &str, inner: impl FnOnce(&mut Self)) {
        self.line(format!("<{name}{attributes}>"));
        inner(self);
        self.line(format!("</{name}>"));
    }

    /// The id of what stands at `address`; what is told again has none.
    fn id(&mut self, address: &str) -> String {
        let id = escape(address);
        if self.ids.insert(id.clone()) { format!(" id=\"{id}\"") } else { String::new() }
    }

    fn word(&self, english: &str) -> String {
        phrase(&self.words.say(english, &[]))
    }

    fn block(&mut self, block: &Block) {
        match block {
            Block::Section(Section { address, blocks }) if address.is_some() || !blocks.is_empty() => {
                let attributes = address.as_deref().map_or(String::new(), |address| self.id(address));
                self.within("section", &attributes, |writer| writer.blocks(blocks));
            }
            Block::Section(_) => {}
            Block::Group(blocks) => self.blocks(blocks),
            Block::Heading(heading) => self.heading(heading),
            Block::Paragraph(paragraph) => self.line(format!("<p>{}</p>", spans(&paragraph.spans))),
            Block::List(list) => self.within("ul", "", |writer| {
                for item in &list.items {
                    writer.within("li", "", |writer| writer.blocks(item));
                }
            }),
            Block::Code(text) => {
                let lines: Vec<_> = text.lines().map(escape).collect();
                self.line(format!("<pre><code>{}</code></pre>", lines.join(BREAK)));
            }
            Block::Line(line) => self.line(format!("<p><samp>{}</samp></p>", escape(line))),
            Block::Terms(terms) => self.terms(terms),
            Block::Formula(formula) => self.formula(formula),
            Block::Lines(lines) => self.lines(lines),
            Block::Table(table) => self.table(table),
            Block::Judged(judged) => self.judged(judged),
            Block::Cases(cases) => self.cases(cases),
            Block::Fold(fold) => self.fold(fold),
            Block::Setting(setting) => {
                let set = |set: &crate::block::Assignment| {
                    format!("<code>{}={}</code>", escape(&set.name), escape(&set.text))
                };
                let setting: Vec<_> = setting.iter().map(set).collect();
                let at = self.word("At");
                self.line(format!("<p>{at} {}:</p>", setting.join(", ")));
            }
            Block::Quantities(quantities) => self.quantities(quantities),
            Block::Figure(figure) => self.figure(figure, "plot"),
            Block::Question(question) => self.question(question),
        }
    }

    fn heading(&mut self, heading: &Heading) {
        let level = match heading.rank {
            Rank::Chapter => 1,
            Rank::Step => 2,
            Rank::Entry | Rank::Part => 3,
        };
        let level = level - usize::from(self.is_page);
        if level > 1 || !self.is_page {
            self.line(format!("<h{level}>{}</h{level}>", spans(&heading.text)));
        }
        if let Some(address) = &heading.address {
            let rows = rows(&heading.rows);
            self.line(format!("<p><a class=\"address\" href=\"#{0}\">{0}</a>{rows}</p>", escape(address)));
        }
    }

    fn terms(&mut self, terms: &Terms) {
        if terms.items.is_empty() {
            return;
        }
        self.within("dl", "", |writer| {
            for term in &terms.items {
                let note = term.note.as_ref().map_or(String::new(), |note| format!("<br/>{}", span(note)));
                writer.line(format!("<dt>{}</dt>\n<dd>{}{note}</dd>", span(&term.name), spans(&term.says)));
            }
        });
    }

    fn formula(&mut self, formula: &Formula) {
        let unit = match formula.verdict {
            Verdict::Passed => format!("<span class=\"aside\">[{}]</span>", escape(&formula.unit)),
            Verdict::Failed => format!("<span class=\"bad\">{}</span>", escape(&formula.unit)),
        };
        let attributes = format!("{} class=\"formula\"", self.id(&formula.address));
        self.within("div", &attributes, |writer| {
            writer.line(&formula.face.mathml);
            writer.line(format!("<p>{} {unit}</p>", phrase(&formula.says)));
        });
    }

    fn lines(&mut self, lines: &Lines) {
        if lines.lines.is_empty() {
            return;
        }
        self.within("ol", " class=\"derivation\"", |writer| {
            for line in &lines.lines {
                writer.within("li", "", |writer| {
                    writer.derived(line);
                    if !line.steps.is_empty() {
                        let summary = writer.words.tell("{count} steps", &[("count", &line.steps.len().to_string())]);
                        writer.details(&escape(&summary), lines.details.unfold, |writer| {
                            writer.within("ol", "", |writer| {
                                for step in &line.steps {
                                    writer.within("li", "", |writer| writer.derived(step));
                                }
                            });
                        });
                    }
                });
            }
        });
    }

    fn derived(&mut self, line: &Line) {
        self.line(format!("{} <span class=\"aside\">[{}]</span>", line.face.mathml, escape(&line.unit)));
        let by = phrase(&line.by);
        match &line.found {
            Some(found) => {
                let class = if found.verdict == Verdict::Passed { "good" } else { "bad" };
                let by = if by.is_empty() { by } else { by + ": " };
                self.line(format!("<p>{by}<span class=\"{class}\">{}</span></p>", phrase(&found.says)));
            }
            None if !by.is_empty() => self.line(format!("<p>{by}</p>")),
            None => {}
        }
        if !line.says.is_empty() {
            self.line(format!("<p class=\"aside\">{}</p>", phrase(&line.says)));
        }
    }

    fn table(&mut self, table: &Table) {
        self.within("table", "", |writer| {
            writer.line(format!("<caption>{}</caption>", phrase(&table.caption)));
            let heads = table.columns.iter().map(|column| format!("<th scope=\"col\">{}</th>", phrase(&column.head)));
            writer.line(format!("<thead><tr>{}</tr></thead>", heads.collect::<String>()));
            writer.within("tbody", "", |writer| {
                for row in &table.rows {
                    let cells = row.iter().zip(&table.columns).enumerate().map(|(at, (cell, column))| match at {
                        0 => format!("<th scope=\"row\">{}</th>", span(cell)),
                        _ if column.width < 0 => format!("<td class=\"number\">{}</td>", span(cell)),
                        _ => format!("<td>{}</td>", span(cell)),
                    });
                    let cells: String = cells.collect();
                    writer.line(format!("<tr>{cells}</tr>"));
                }
            });
        });
    }

    fn judged(&mut self, judged: &Judged) {
        let (class, sign) = match judged.verdict {
            Some(Verdict::Passed) => (" passed", format!("<span class=\"good\">✓ {}:</span> ", self.word("passed"))),
            Some(Verdict::Failed) => (" failed", format!("<span class=\"bad\">✗ {}:</span> ", self.word("failed"))),
            None => ("", String::new()),
        };
        let attributes = format!("{} class=\"judged{class}\"", self.id(&judged.address));
        self.within("div", &attributes, |writer| {
            writer.line(format!("<p>{sign}{}</p>", spans(&judged.claim)));
            let rows = rows(&judged.rows);
            writer.line(format!("<p><a class=\"address\" href=\"#{0}\">{0}</a>{rows}</p>", escape(&judged.address)));
            writer.blocks(&judged.details);
        });
    }

    fn cases(&mut self, cases: &Cases) {
        let count = cases.cases.len().to_string();
        let summary = match cases.hidden {
            0 => self.words.tell("{count} cases", &[("count", &count)]),
            hidden => self.words.tell(
                "{count} of {all} cases",
                &[("count", &count), ("all", &(cases.cases.len() + hidden).to_string())],
            ),
        };
        if cases.cases.is_empty() {
            return;
        }
        self.details(&escape(&summary), false, |writer| {
            writer.within("table", "", |writer| {
                writer.line(format!("<caption>{}</caption>", escape(&summary)));
                let heads = ["quantity", "input", "method", "value", "digits kept"];
                let heads = heads.map(|head| format!("<th scope=\"col\">{}</th>", writer.word(head))).concat();
                writer.line(format!("<thead><tr>{heads}</tr></thead>"));
                for case in &cases.cases {
                    writer.within("tbody", "", |writer| {
                        let of = match case.worst_of {
                            0 | 1 => String::new(),
                            count => writer.words.tell(" (worst of {count})", &[("count", &count.to_string())]),
                        };
                        let of = escape(&of);
                        let head = format!(
                            "<th scope=\"rowgroup\" rowspan=\"3\">{}</th><td rowspan=\"3\">{}{of}</td>",
                            phrase(&case.quantity),
                            phrase(&case.input)
                        );
                        let owed = writer
                            .words
                            .tell("at least {digits} digits owed", &[("digits", &format!("{:.1}", case.owed))]);
                        let verdict = if case.verdict == Verdict::Passed { "passed" } else { "failed" };
                        let ours = format!("{:.1} ({})", case.our_digits, writer.word(verdict));
                        for (head, name, value, digits) in [
                            (head.as_str(), "reference", &case.reference, escape(&owed)),
                            ("", "textbook", &case.textbook, format!("{:.1}", case.textbook_digits)),
                            ("", "ours", &case.ours, ours),
                        ] {
                            let (name, value) = (writer.word(name), phrase(value));
                            writer.line(format!("<tr>{head}<td>{name}</td><td>{value}</td><td>{digits}</td></tr>"));
                        }
                    });
                }
            });
        });
    }

    fn details(&mut self, summary: &str, open: bool, inner: impl FnOnce(&mut Self)) {
        self.within("details", if open { " open=\"open\"" } else { "" }, |writer| {
            writer.line(format!("<summary>{summary}</summary>"));
            inner(writer);
        });
    }

    /// Folded whatever a page that cannot fold shows.
    fn fold(&mut self, fold: &Fold) {
        self.details(&spans(&fold.summary), false, |writer| writer.blocks(&fold.blocks));
    }

    fn quantities(&mut self, quantities: &[Quantity]) {
        if quantities.is_empty() {
            return;
        }
        self.within("table", "", |writer| {
            let caption = writer.word("what the program computes");
            writer.line(format!("<caption>{caption}</caption>"));
            let heads = ["quantity", "value", "meaning"];
            let heads = heads.map(|head| format!("<th scope=\"col\">{}</th>", writer.word(head))).concat();
            writer.line(format!("<thead><tr>{heads}</tr></thead>"));
            writer.within("tbody", "", |writer| {
                for quantity in quantities {
                    writer.line(format!(
                        "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td></tr>",
                        phrase(&quantity.symbol),
                        phrase(&quantity.value),
                        phrase(&quantity.says)
                    ));
                }
            });
        });
    }

    fn figure(&mut self, figure: &Figure, class: &str) {
        let attributes = format!("{} class=\"{class}\"", self.id(&figure.address));
        let says = escape(&figure.says.to_string());
        self.within("figure", &attributes, |writer| {
            match &figure.picture {
                Picture::File(path) => writer.line(format!("<img src=\"{}\" alt=\"{says}\"/>", escape(path))),
                Picture::Svg(svg) => {
                    // A declaration may only stand at the beginning of a document.
                    let svg = svg.trim_start();
                    let svg =
                        svg.strip_prefix("<?xml").and_then(|rest| rest.split_once("?>")).map_or(svg, |(_, svg)| svg);
                    let lines: Vec<_> = svg.lines().filter(|line| !line.trim().is_empty()).collect();
                    let svg = lines.join("\n");
                    writer.line(format!("<div role=\"img\" aria-label=\"{says}\">{svg}</div>"));
                }
                Picture::Cells(_) | Picture::Strips(_) | Picture::Absent => {}
            }
            writer.line(format!("<figcaption>{}</figcaption>", phrase(&figure.says)));
        });
    }

    fn question(&mut self, question: &Question) {
        let attributes = format!("{} class=\"question\"", self.id(&question.address));
        self.within("section", &attributes, |writer| {
            writer.line(format!("<p>{}</p>", spans(&question.prompt)));
            if let Answers::Choices(choices) = &question.answers {
                writer.choices(choices, question.open);
                return;
            }
            let summary = writer.word("answer");
            let (words, answers) = (writer.words, &question.answers);
            writer.details(&summary, question.open, |writer| {
                writer.line(format!("<p>{}</p>", phrase(&answers.told(words))));
                if let Answers::Number { response, .. } = answers {
                    writer.line(format!("<p>{}</p>", phrase(response)));
                }
            });
        });
    }

    /// Every choice opens on what is said to it.
    fn choices(&mut self, choices: &[Choice], open: bool) {
        self.within("ol", " type=\"a\"", |writer| {
            for choice in choices {
                writer.within("li", "", |writer| {
                    let (class, word) = if choice.right { ("good", "right") } else { ("bad", "wrong") };
                    let word = writer.word(word);
                    let response = phrase(&choice.response);
                    writer.details(&phrase(&choice.says), open, |writer| {
                        writer.line(format!("<p><span class=\"{class}\">{word}</span>: {response}</p>"));
                    });
                });
            }
        });
    }
}

/// The rows of the lecture behind an address.
fn rows(rows: &[String]) -> String {
    if rows.is_empty() { String::new() } else { format!(" <span class=\"rows\">{}</span>", escape(&rows.join(" "))) }
}
