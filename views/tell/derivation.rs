//! Derivations: the verdict, the lines behind it, and what they rest on.

use super::{Teller, owned, tone};
use crate::block::{Block, Face, Fold, Found, Judged, Line, Lines, Span, Tone};
use crate::report::{DerivationReport, LineReport, Verdict};
use chapters::text::Phrase;

impl Teller<'_> {
    /// The derivations of a step. What all of them rest on is said once, and what one shares with an earlier one there.
    pub(super) fn derivations(&self, derivations: &[DerivationReport], open: bool) -> Vec<Block> {
        let shared = if open { shared(derivations) } else { Vec::new() };
        let mut blocks: Vec<Block> =
            self.listed("in all that follows {list}", 2, hypotheses(&shared)).into_iter().collect();
        for (at, derivation) in derivations.iter().enumerate() {
            let is_said = |line: &&LineReport| shared.iter().any(|other| is_same(other, line));
            let own: Vec<&LineReport> = derivation.hypotheses.iter().filter(|line| !is_said(line)).collect();
            let earlier = if open { &derivations[..at] } else { &[] };
            blocks.push(self.derivation(derivation, self.under(&own, earlier), open));
        }
        blocks
    }

    /// The hypotheses `own`, with those that one of the `earlier` derivations has too by their names.
    fn under(&self, own: &[&LineReport], earlier: &[DerivationReport]) -> Vec<String> {
        let common = |other: &DerivationReport| own.iter().filter(|line| has(other, line)).count();
        // The first of those that share most.
        let Some(other) = earlier.iter().rev().max_by_key(|other| common(other)).filter(|other| common(other) > 1)
        else {
            return hypotheses(own);
        };
        let (known, rest): (Vec<&LineReport>, Vec<_>) = own.iter().partition(|line| has(other, line));
        let names = known.iter().filter_map(|line| subject(line)).collect::<Vec<_>>().join(", ");
        let place = other.address.rsplit('/').next().unwrap_or_default();
        let parts = [("names", Phrase::verbatim(names)), ("place", Phrase::verbatim(place))];
        let known = self.say("{names} as in {place}", &parts).to_string();
        std::iter::once(known).chain(hypotheses(&rest)).collect()
    }

    /// A derivation: `open` with its lines, otherwise what became of its hops.
    fn derivation(&self, derivation: &DerivationReport, under: Vec<String>, open: bool) -> Block {
        let says = self.phrase(&derivation.address, "says", derivation.says);
        let mut details = Vec::new();
        if let Some(mismatch) = &derivation.mismatch {
            details.push(Block::text(6, Tone::Bad, Phrase::verbatim(mismatch)));
        }
        details.push(Block::Fold(Fold {
            summary: vec![Span::new(Tone::Plain, self.hops(derivation))],
            blocks: self.argument(derivation, under),
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

    fn argument(&self, derivation: &DerivationReport, under: Vec<String>) -> Vec<Block> {
        let mut blocks = vec![self.lines(&derivation.address, &derivation.lines)];
        blocks.extend(self.listed("where {list}", 6, derivation.conditions.clone()));
        // The hypotheses as substitutions: they place the sample points, the lines above are the argument.
        blocks.extend(self.listed("under {list}", 6, under));
        blocks
    }

    fn listed(&self, template: &str, indent: usize, parts: Vec<String>) -> Option<Block> {
        let list = || self.say(template, &[("list", Phrase::verbatim(parts.join(", ")))]);
        (!parts.is_empty()).then(|| Block::text(indent, Tone::Dim, list()))
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

/// What all of several derivations rest on.
fn shared(derivations: &[DerivationReport]) -> Vec<&LineReport> {
    let Some((first, rest)) = derivations.split_first().filter(|(_, rest)| !rest.is_empty()) else { return Vec::new() };
    first.hypotheses.iter().filter(|line| rest.iter().all(|other| has(other, line))).collect()
}

fn has(derivation: &DerivationReport, line: &LineReport) -> bool {
    derivation.hypotheses.iter().any(|other| is_same(other, line))
}

fn is_same(a: &LineReport, b: &LineReport) -> bool {
    a.unicode == b.unicode && a.by == b.by
}

/// What a hypothesis is about: its left side.
fn subject(line: &LineReport) -> Option<&str> {
    line.unicode.split(" = ").next()
}

/// Hypotheses in a row, each run that one rule gives with the rule after it.
fn hypotheses(lines: &[&LineReport]) -> Vec<String> {
    let told = |run: &[&LineReport]| {
        let faces: Vec<&str> = run.iter().map(|line| line.unicode.as_str()).collect();
        match (faces.join(", "), run[0].by.join(", ")) {
            (faces, by) if by == faces => faces,
            (faces, by) => format!("{faces} ({by})"),
        }
    };
    lines.chunk_by(|a, b| a.by == b.by).map(told).collect()
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
