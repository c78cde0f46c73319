//! The lecture's rows and what the curriculum has for each.

use super::{Teller, section_at};
use crate::block::{Block, Column, Heading, Rank, Span, Table, Tone};
use chapters::CURRICULUM;
use chapters::lecture::{Coverage, chapter_names, coverage};
use chapters::text::Phrase;

impl Teller<'_> {
    /// The rows, chapter by chapter.
    pub fn coverage(&self) -> Vec<Block> {
        let rows = coverage(CURRICULUM);
        let legend = self.say(
            "D derived · U units checked · N checked against another route · X extreme cases · P plotted · R raced",
            &[],
        );
        let mut blocks = vec![Block::text(0, Tone::Dim, legend)];
        blocks.extend(chapter_names().into_iter().map(|chapter| {
            let own: Vec<_> = rows.iter().filter(|row| row.row.chapter == chapter).collect();
            section_at(chapter, vec![Block::Group(vec![self.summary(chapter, &own), self.rows(chapter, &own)])])
        }));
        let letters = |of: fn(&Coverage) -> usize| rows.iter().map(of).sum::<usize>();
        let (met, missing) = (letters(|row| row.met.len()), letters(|row| row.missing.len()));
        let (whole, all) = (whole(rows.iter()), rows.len());
        blocks.push(Block::Line(format!("{whole} of {all} rows whole, {met} of {} letters met", met + missing)));
        blocks
    }

    fn summary(&self, chapter: &str, own: &[&Coverage]) -> Block {
        let parts = [
            ("whole", Phrase::verbatim(whole(own.iter().copied()).to_string())),
            ("all", Phrase::verbatim(own.len().to_string())),
        ];
        let summary = self.say("{whole} of {all} rows have all they need", &parts);
        Block::Heading(Heading {
            rank: Rank::Entry,
            text: vec![Span::verbatim(Tone::Strong, chapter), Span::plain("  "), Span::new(Tone::Dim, summary)],
            address: None,
            rows: Vec::new(),
        })
    }

    fn rows(&self, chapter: &str, own: &[&Coverage]) -> Block {
        let column = |head: &str, width| Column { head: self.say(head, &[]), width };
        Block::Table(Table {
            caption: Phrase::verbatim(chapter),
            columns: vec![column("row", 3), column("met", 5), column("lacks", 13), column("steps", 0)],
            rows: own.iter().map(|row| self.row(row)).collect(),
            headed: false,
            inset: 2,
        })
    }

    fn row(&self, row: &Coverage) -> Vec<Span> {
        let letters = |letters: &[char]| Phrase::verbatim(letters.iter().collect::<String>());
        let lacks = match row.missing[..] {
            [] => Phrase::default(),
            _ => self.say("lacks {letters}", &[("letters", letters(&row.missing))]),
        };
        let steps: Vec<_> = row.steps.iter().map(|step| step.rsplit('/').next().unwrap_or(step)).collect();
        vec![
            Span::plain(row.row.id),
            Span::new(Tone::Good, letters(&row.met)),
            Span::new(Tone::Bad, lacks),
            Span::verbatim(Tone::Dim, steps.join(" ")),
        ]
    }
}

fn whole<'a>(rows: impl Iterator<Item = &'a Coverage>) -> usize {
    rows.filter(|row| row.missing.is_empty()).count()
}
