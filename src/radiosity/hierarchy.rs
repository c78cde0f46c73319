//! Patches that are only as small as their light asks for: two places far apart exchange as wholes, near ones in pieces (P.
//! Hanrahan, D. Salzman and L. Aupperle, *A rapid hierarchical radiosity algorithm*, SIGGRAPH '91, 197).
//!
//! Every face is the root of a tree of its quarters. A link says that one piece gets light from another; a link over which more
//! light goes than the bound allows is replaced by links of quarters of the larger of the two. Light is gathered over all
//! links, handed down to the smallest pieces and added up again (pushed and pulled), and links are looked at again, until
//! neither changes. As many links as pieces, up to a factor that the bound decides, in place of the square of all pieces.
//!
//! Of rooms in which nothing is in the way; in others a link would have to say how much gets through.

use super::exchange::exchange;
use super::{Patch, Room};

/// A piece of a face.
struct Piece {
    patch: Patch,
    area: f64,
    face: usize,
    /// Where its four quarters are, if it was cut.
    quarters: Option<usize>,
    /// From whom it gets light: the piece, and F [1] to it.
    links: Vec<(usize, f64)>,
    /// What arrives over its own links, a mean over the hemisphere, and the radiance [W m⁻² sr⁻¹]; and how much of all its
    /// links see [1].
    arriving: f64,
    seen: f64,
    radiance: f64,
}

/// What came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The mean radiance [W m⁻² sr⁻¹] of every face.
    pub means: Vec<f64>,
    /// Links, and pieces that were not cut further.
    pub links: usize,
    /// The smallest pieces.
    pub leaves: usize,
}

/// A room in trees.
struct Forest<'a> {
    room: &'a Room,
    channel: usize,
    pieces: Vec<Piece>,
    bound: f64,
}

/// Times that links are looked at, at most: each time light has found its way over a few bounces more.
const ROUNDS: u32 = 24;
/// Bounces between two looks.
const BOUNCES: u32 = 4;
/// Bounces in the end, of links that are not looked at again, at most, and the change [1] over the brightest piece at which
/// there is no need of more.
const LAST: u32 = 4096;
const STILL: f64 = 1e-13;

/// The radiances of a room of parallelograms in one channel, by links over which no more than `bound` [W m⁻² sr⁻¹ m²] goes: F of
/// the link times the sender's radiance times the receiver's area. Pieces smaller than a share `least` [1] of their face's edges
/// are not cut.
///
/// A face's error falls with the bound, slowly: links are as many as what goes in all over the bound, of pieces whose size is the
/// fourth root of that, and constant pieces that are not all alike are of the first order.
pub fn solve(room: &Room, channel: usize, bound: f64, least: f64) -> Found {
    let mut forest = Forest { room, channel, pieces: Vec::new(), bound };
    for (at, face) in room.faces.iter().enumerate() {
        forest.add(face.patch, at);
    }
    let faces = room.faces.len();
    for to in 0..faces {
        for from in 0..faces {
            forest.link(to, from);
        }
    }
    forest.pieces.iter_mut().for_each(|piece| piece.radiance = room.faces[piece.face].emitted[channel]);
    for _ in 0..ROUNDS {
        for _ in 0..BOUNCES {
            forest.bounce();
        }
        if !forest.refine(least) {
            break;
        }
    }
    for _ in 0..LAST {
        if forest.bounce() <= STILL {
            break;
        }
    }
    let cut = forest.pieces.iter().filter(|piece| piece.quarters.is_some()).count();
    Found {
        means: forest.pieces[..faces].iter().map(|root| root.radiance).collect(),
        links: forest.pieces.iter().map(|piece| piece.links.len()).sum(),
        leaves: forest.pieces.len() - cut,
    }
}

impl Forest<'_> {
    fn add(&mut self, patch: Patch, face: usize) {
        let area = patch.area();
        self.pieces.push(Piece {
            patch,
            area,
            face,
            quarters: None,
            links: Vec::new(),
            arriving: 0.0,
            seen: 0.0,
            radiance: 0.0,
        });
    }

    /// Lets one piece get light from another, if it sees it.
    fn link(&mut self, to: usize, from: usize) {
        let [one, other] = [to, from].map(|at| &self.pieces[at]);
        if one.face != other.face {
            let factor = exchange(&one.patch, &other.patch) / one.area;
            if factor > 0.0 {
                self.pieces[to].links.push((from, factor));
            }
        }
    }

    /// The first quarter of a piece, cut now if it was whole.
    fn quartered(&mut self, at: usize) -> usize {
        if let Some(first) = self.pieces[at].quarters {
            return first;
        }
        let first = self.pieces.len();
        let (patch, face, radiance) = (self.pieces[at].patch, self.pieces[at].face, self.pieces[at].radiance);
        for number in 0..4 {
            self.add(patch.piece([2; 2], number), face);
        }
        self.pieces[first..].iter_mut().for_each(|piece| piece.radiance = radiance);
        self.pieces[at].quarters = Some(first);
        first
    }

    /// Replaces every link over which too much goes by four; whether there was any.
    fn refine(&mut self, least: f64) -> bool {
        let (mut is_changed, mut at) = (false, 0);
        // Pieces that are added are looked at too.
        while at < self.pieces.len() {
            let links = std::mem::take(&mut self.pieces[at].links);
            let mut kept = Vec::with_capacity(links.len());
            for (from, factor) in links {
                let [to_area, from_area] = [self.pieces[at].area, self.pieces[from].area];
                let goes = factor * to_area * self.pieces[from].radiance;
                let ends = if to_area >= from_area { [at, from] } else { [from, at] };
                let may_be_cut = |end: &usize| {
                    let Piece { patch, face, .. } = &self.pieces[*end];
                    patch.size() >= 2.0 * least * self.room.faces[*face].patch.size()
                };
                let larger = ends.into_iter().find(may_be_cut).filter(|_| goes > self.bound);
                let Some(larger) = larger else {
                    kept.push((from, factor));
                    continue;
                };
                is_changed = true;
                let first = self.quartered(larger);
                for quarter in first..first + 4 {
                    if larger == at { self.link(quarter, from) } else { self.link_new(&mut kept, at, quarter) }
                }
            }
            let piece = &mut self.pieces[at];
            piece.links.append(&mut kept);
            at += 1;
        }
        is_changed
    }

    /// The same as [`Forest::link`], into a list of who gets it.
    fn link_new(&self, links: &mut Vec<(usize, f64)>, to: usize, from: usize) {
        let factor = exchange(&self.pieces[to].patch, &self.pieces[from].patch) / self.pieces[to].area;
        if factor > 0.0 {
            links.push((from, factor));
        }
    }

    /// Gathers, pushes and pulls once; the largest change over the brightest.
    fn bounce(&mut self) -> f64 {
        for at in 0..self.pieces.len() {
            let links = &self.pieces[at].links;
            let arriving = links.iter().map(|(from, factor)| factor * self.pieces[*from].radiance).sum();
            let seen = links.iter().map(|(_, factor)| factor).sum();
            (self.pieces[at].arriving, self.pieces[at].seen) = (arriving, seen);
        }
        let (mut change, mut most) = (0.0, f64::MIN_POSITIVE);
        for root in 0..self.room.faces.len() {
            self.spread(root, [0.0; 2], &mut change, &mut most);
        }
        change / most
    }

    /// Hands down what arrives at those that a piece is part of, with how much they see of all, and gives back its radiance.
    ///
    /// A link of a large piece tells all its parts the mean of what they see: the smallest pieces then see more than there is,
    /// or less. Of a closed room it is known that they see all, and what arrives is a mean over that.
    fn spread(&mut self, at: usize, above: [f64; 2], change: &mut f64, most: &mut f64) -> f64 {
        let piece = &self.pieces[at];
        let below = [above[0] + piece.arriving, above[1] + piece.seen];
        let radiance = match piece.quarters {
            Some(first) => {
                let quarters = first..first + 4;
                quarters.map(|quarter| self.spread(quarter, below, change, most)).sum::<f64>() / 4.0
            }
            None => {
                let face = &self.room.faces[piece.face];
                let all = if self.room.is_closed { below[1] } else { 1.0 };
                face.emitted[self.channel] + (1.0 - face.absorbed[self.channel]) * below[0] / all
            }
        };
        *change = change.max((radiance - self.pieces[at].radiance).abs());
        *most = most.max(radiance);
        self.pieces[at].radiance = radiance;
        radiance
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::radiosity::{Light, Network, solve as solvers};

    const FACES: [(f64, f64); 6] = [(0.3, 0.0), (0.7, 0.0), (0.2, 0.0), (0.5, 1.0), (0.25, 0.4), (0.6, 0.0)];

    /// All faces' means by n × n patches each and elimination.
    fn whole(room: &Room, n: usize) -> Vec<f64> {
        let patches = room.cut(n);
        let found = solvers::direct(&Network::of(&patches), &Light::of(&patches, 1));
        (0..room.faces.len()).map(|face| patches.mean(face, &found)).collect()
    }

    fn off(found: &[f64], exact: &[f64]) -> f64 {
        found.iter().zip(exact).map(|(one, other)| (one / other - 1.0).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn links_that_are_all_cut_to_the_end_are_the_whole_matrix() {
        let room = Room::cuboid([1.0, 0.8, 0.6], FACES);
        let found = solve(&room, 1, 0.0, 0.25);
        assert_eq!((found.leaves, found.links), (96, 96 * 80));
        assert!(off(&found.means, &whole(&room, 4)) < 1e-11);
        // And none are, if everything is allowed.
        let found = solve(&room, 1, f64::INFINITY, 0.25);
        assert_eq!((found.leaves, found.links), (6, 30));
        assert!(off(&found.means, &whole(&room, 1)) < 1e-11);
    }

    #[test]
    fn the_error_falls_with_the_bound_and_links_are_far_fewer_than_pairs() {
        let room = Room::cuboid([1.0, 0.8, 0.6], FACES);
        // To 10⁻⁵, as h² has it: patches of 1/16 are that near their limit after extrapolation.
        let exact: Vec<f64> = whole(&room, 4).iter().zip(whole(&room, 8)).map(|(a, b)| b + (b - a) / 3.0).collect();
        let found = [64.0, 1024.0, 16384.0].map(|links| solve(&room, 1, 1.0 / links, 1.0 / 256.0));
        let errors = found.each_ref().map(|found| off(&found.means, &exact));
        // As the fourth root of the bound: by a half each.
        assert!(errors[1] < 0.75 * errors[0] && errors[2] < 0.75 * errors[1], "{errors:?}");
        let Found { links, leaves, .. } = found[2];
        assert!(links * 64 < leaves * leaves, "{links} {leaves}");
    }

    #[test]
    fn an_even_room_stays_even_however_its_links_are_cut() {
        let room = Room::cuboid([1.0, 0.8, 0.6], [(0.5, 1.0); 6]);
        let found = solve(&room, 1, 1e-2, 1.0 / 64.0);
        assert!(found.links > 1000 && found.means.iter().all(|mean| (mean - 2.0).abs() < 1e-11), "{found:?}");
    }
}
