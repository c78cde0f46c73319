//! Derivations: the verdict, the lines behind it, and what they rest on.

use super::{Teller, owned, tone};
use crate::block::{Block, Face, Fold, Found, Judged, Line, Lines, Span, Tone};
use crate::report::{DerivationReport, LineReport, Verdict};
use chapters::text::Phrase;

impl Teller<'_> {
    /// A derivation: `open` with its lines, otherwise what became of its hops.
    pub(super) fn derivation(&self, derivation: &DerivationReport, open: bool) -> Block {
        let says = self.phrase(&derivation.address, "says", derivation.says);
        let mut details = Vec::new();
        if let Some(mismatch) = &derivation.mismatch {
            details.push(Block::text(6, Tone::Bad, Phrase::verbatim(mismatch)));
        }
        details.push(Block::Fold(Fold {
            summary: vec![Span::new(Tone::Plain, self.hops(derivation))],
            blocks: self.argument(derivation),
            open,
        }));
        if !open {
            details.extend(failures(derivation));
        }
        Block::Judged(Judged {
            address: derivation.address.clone(),
            verdict: Some(derivation.verdict),
            claim: vec![Span::new(if open { Tone::Strong } else { Tone::Plain }, says)],
            rows: owned(derivation.rows),
            details,
        })
    }

    /// How many hops there are, and how well the sampled ones agree.
    fn hops(&self, derivation: &DerivationReport) -> Phrase {
        let hops = derivation.lines.iter().filter_map(|line| line.hop.as_ref());
        let count = match hops.clone().count() {
            1 => self.say("1 hop", &[]),
            count => self.say("{count} hops", &[("count", Phrase::verbatim(count.to_string()))]),
        };
        match hops.filter_map(|hop| Some(hop.digits?.0)).min_by(f64::total_cmp) {
            None => count,
            Some(digits) => {
                let parts = [("hops", count), ("digits", Phrase::verbatim(format!("{digits:.0}")))];
                self.say("{hops}, {digits} digits agree at the worst", &parts)
            }
        }
    }

    fn argument(&self, derivation: &DerivationReport) -> Vec<Block> {
        let mut blocks = vec![self.lines(&derivation.address, &derivation.lines)];
        let listed = |template: &str, parts: &[String]| {
            let list = self.say(template, &[("list", Phrase::verbatim(parts.join(", ")))]);
            (!parts.is_empty()).then(|| Block::text(6, Tone::Dim, list))
        };
        blocks.extend(listed("where {list}", &derivation.conditions));
        // The hypotheses as substitutions: they place the sample points, the lines above are the argument.
        let given = |line: &LineReport| match line.by.join(", ") {
            by if by == line.unicode => by,
            by => format!("{} ({by})", line.unicode),
        };
        let points: Vec<String> = derivation.hypotheses.iter().map(given).collect();
        blocks.extend(listed("under {list}", &points));
        blocks
    }

    /// Lines, each with its rules and what was found.
    pub(super) fn lines(&self, address: &str, lines: &[LineReport]) -> Block {
        let lines = lines.iter().map(|line| self.line(address, line)).collect();
        Block::Lines(Lines { lines, details: self.details })
    }

    fn line(&self, address: &str, line: &LineReport) -> Line {
        Line {
            face: face(line),
            unit: line.dimension.clone(),
            by: self.phrase(address, "rule", &line.by.join(", ")),
            found: line.hop.as_ref().map(|hop| Found { verdict: hop.verdict, says: Phrase::parse(&hop.found) }),
            says: self.phrase(address, "line", line.says),
            steps: line.unfolded.iter().map(|step| self.line(address, step)).collect(),
        }
    }
}

/// The hops that do not hold.
fn failures(derivation: &DerivationReport) -> impl Iterator<Item = Block> + '_ {
    let failed = derivation.lines.iter().filter_map(|line| Some((line, line.hop.as_ref()?)));
    failed.filter(|(_, hop)| hop.verdict == Verdict::Failed).map(|(line, hop)| {
        let found = Phrase::verbatim("  ").then(Phrase::parse(&hop.found));
        Block::paragraph(6, 8, vec![Span::equation(&line.unicode, &line.mathml), Span::new(tone(hop.verdict), found)])
    })
}

fn face(line: &LineReport) -> Face {
    Face {
        unicode: line.unicode.clone(),
        layout: line.layout.clone(),
        mathml: line.mathml.clone(),
        latex: line.latex.clone(),
    }
}
