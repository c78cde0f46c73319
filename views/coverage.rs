//! The lecture's rows and what the curriculum has for each.

use crate::page::{Page, Span, Tone};
use chapters::CURRICULUM;
use chapters::lecture::chapter_names;
use chapters::lecture::{Coverage, coverage};
use serde_json::json;

/// The table, chapter by chapter.
pub fn table(page: &mut Page) {
    let rows = coverage(CURRICULUM);
    page.line(
        0,
        Tone::Dim,
        "D derived · U units checked · N checked against another route · X extreme cases · P plotted · R raced",
    );
    for chapter in chapter_names() {
        let own: Vec<_> = rows.iter().filter(|row| row.row.chapter == chapter).collect();
        page.gap();
        let summary = format!("{} of {} rows have all they need", whole(own.iter().copied()), own.len());
        page.wrap(0, 4, &[(Tone::Strong, chapter), (Tone::Plain, "  "), (Tone::Dim, &summary)]);
        for row in own {
            line(page, row);
        }
    }
    page.gap();
    let letters = |of: fn(&Coverage) -> usize| rows.iter().map(of).sum::<usize>();
    let (met, missing) = (letters(|row| row.met.len()), letters(|row| row.missing.len()));
    page.verbatim(&format!(
        "{} of {} rows whole, {met} of {} letters met",
        whole(rows.iter()),
        rows.len(),
        met + missing
    ));
}

fn whole<'a>(rows: impl Iterator<Item = &'a Coverage>) -> usize {
    rows.filter(|row| row.missing.is_empty()).count()
}

fn line(page: &mut Page, row: &Coverage) {
    let (met, missing) = (row.met.iter().collect::<String>(), row.missing.iter().collect::<String>());
    let lacks = if missing.is_empty() { String::new() } else { format!("lacks {missing}") };
    let steps: Vec<_> = row.steps.iter().map(|step| step.rsplit('/').next().unwrap_or(step)).collect();
    let steps = format!("  {}", steps.join(" "));
    let columns = [format!("{:<5}", row.row.id), format!("{met:<7}"), format!("{lacks:<13}")];
    let spans: [Span; 4] =
        [(Tone::Plain, &columns[0]), (Tone::Good, &columns[1]), (Tone::Bad, &columns[2]), (Tone::Dim, &steps)];
    page.wrap(2, 29, &spans);
}

/// The table as one JSON document.
pub fn json() -> String {
    let rows: Vec<_> = coverage(CURRICULUM)
        .iter()
        .map(|row| {
            json!({
                "id": row.row.id,
                "chapter": row.row.chapter,
                "steps": row.steps,
                "need": row.row.needs.chars().collect::<Vec<_>>(),
                "met": row.met,
                "missing": row.missing,
            })
        })
        .collect();
    format!("{:#}\n", json!({ "rows": rows }))
}
