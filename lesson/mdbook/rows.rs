//! The lecture's rows as a table: what each states, the evidence that it has, and the steps that teach it.

use super::links::link;
use chapters::CURRICULUM;
use chapters::lecture::{Coverage, coverage};
use chapters::text::Phrase;
use views::html;

/// What the letters mean.
const LEGEND: &str = "D derived · U units checked · N checked against another route · X extreme cases · P plotted · \
                      R raced; a letter in brackets is owed.";

/// The table as HTML.
pub fn table() -> String {
    let rows: String = coverage(CURRICULUM).iter().map(row).collect();
    let heads = ["row", "what it states", "evidence", "steps"].map(|head| format!("<th scope=\"col\">{head}</th>"));
    format!(
        "<table class=\"coverage\">\n<caption>{LEGEND}</caption>\n<thead><tr>{}</tr></thead>\n<tbody>\n{rows}</tbody>\n\
         </table>\n",
        heads.concat()
    )
}

fn row(Coverage { row, steps, met, missing }: &Coverage) -> String {
    let letters = |letters: &[char]| letters.iter().collect::<String>();
    let owed = if missing.is_empty() { String::new() } else { format!(" ({})", letters(missing)) };
    format!(
        "<tr id=\"{0}\"><th scope=\"row\">{0}</th><td>{1}</td><td>{2}{owed}</td><td>{3}</td></tr>\n",
        row.id,
        html::inline(&Phrase::parse(row.states)),
        letters(met),
        steps.iter().map(|step| link(step, step)).collect::<Vec<_>>().join("<br/>")
    )
}
