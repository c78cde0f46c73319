//! The work on a picture: round after round until it is good enough, or somebody ends it.

use super::archive::{self, Archive};
use super::clock::{Spent, Watch};
use super::goal::{Done, Goal};
use super::pictures::{About, Kind, Picture};
use super::preview::{self, Preview};
use super::stats::{Patches, Round};
use super::{Job, deviation, error_told, percent};
use crate::interrupt::Interrupt;
use crate::memory;
use crate::out;
use crate::stop::Stop;
use light::scene::Scene;
use light::transport::estimate::Estimate;
use light::transport::film::{Film, Halves};
use light::transport::{Feature, Manner, Method, Needs, Renderer};
use std::mem::size_of;

/// A picture, and what is known of it.
pub struct Rendered {
    /// [pixels].
    pub size: [u32; 2],
    /// The means of the halves of every pixel [W m⁻² sr⁻¹].
    pub halves: Vec<Halves>,
    pub spp: u32,
    pub found: Estimate,
    /// What the camera sees without any light, if that was asked for.
    pub features: Option<Vec<Feature>>,
    /// After each round.
    pub rounds: Vec<Round>,
    /// What is known of a radiosity's patches.
    pub patches: Vec<Patches>,
    /// Pairs that there were before.
    pub before: u32,
    pub making_ready: Spent,
    /// Without making ready.
    pub spent: Spent,
    pub needs: Needs,
    pub bytes: usize,
    /// The exit code of who ended it early, if somebody did.
    pub interrupted: Option<u8>,
}

impl Rendered {
    /// As files show it.
    pub fn picture<'a>(&'a self, about: &'a About) -> Picture<'a> {
        let [width, height] = self.size;
        Picture { width, height, halves: &self.halves, features: self.features.as_deref(), about }
    }
}

/// Renders until the goal is met, from a film on and into it if one is named; what came of it is said on standard error.
pub fn rendered(scene: &Scene, manner: &Manner, job: &Job, kinds: &[&Kind]) -> Result<Rendered, Stop> {
    let beginning = Watch::started();
    let mut renderer = Renderer::new(scene, manner, 1).map_err(|flaw| Stop::Refused(flaw.to_string()))?;
    let [width, height] = [scene.camera.width, scene.camera.height];
    let pixels = width as usize * height as usize;
    let mut film = Film::new(width, height);
    let mut archive = None;
    if let Some(path) = &job.film {
        let (own, found) = Archive::open(path, scene, manner, &renderer)?;
        (archive, film) = (Some(own), found);
    }
    let goal = &Goal { round: Some(archive::ROUND), ..job.goal };
    let before = film.pairs();
    let branches = film.branches().len() + goal.most_branches(pixels);
    let sends_light = renderer.needs().light_paths && matches!(manner.method, Method::Fast(_));
    let needed = renderer.bytes() as u64 + most(pixels, branches, sends_light, kinds);
    let what = format!("{}: {width} × {height} pixels", scene.name);
    memory::suffices(&what, needed, "fewer pixels or samples")?;
    let interrupt = Interrupt::watched();
    let making_ready = beginning.spent();
    let mut preview = Preview::new(goal.whole(), job.shown);
    let mut halves = film.halves();
    let mut found = Estimate::of(&halves, width);
    let mut rounds = Vec::new();
    let mut patches: Vec<Patches> = Vec::new();
    let working = Watch::started();
    'rounds: loop {
        let (ranges, now, elapsed) = (film.ranges(), film.pairs() - before, working.elapsed());
        let done = Done { ranges: &ranges, now, elapsed };
        let share = if now > 0 { goal.share(&done, &found) } else { 0 };
        let Some(pairs) = goal.next(&done, &found) else { break };
        if let Some(archive) = archive.as_mut().filter(|_| now > 0) {
            archive.look_after(&film, elapsed, elapsed / now * (pairs.end - pairs.start))?;
        }
        // Numbers are made for twice as many whenever they are not enough.
        renderer.expect(pairs.end.next_power_of_two());
        let next = pairs.end - pairs.start;
        let after = shares_after(goal, &done, next, &found);
        // Not held beside the sums that are to come.
        halves = Vec::new();
        let mut sums = Vec::with_capacity(pixels);
        let least = if renderer.goes_by_rows() { 1 } else { height };
        for rows in preview::bands([width, height], least, elapsed, now, next) {
            if interrupt.code().is_some() {
                break 'rounds;
            }
            let within = f64::from(rows.start) / f64::from(height);
            let share = share as f64 + within * (after.max(share) - share) as f64;
            if now > 0 {
                let left = preview::left(share / goal.whole() as f64, working.elapsed());
                let left = left.map_or(String::new(), |left| format!(", {} left", preview::clock(left)));
                preview.tell(share as u64, &format!("{} spp, error {}{left}", 2 * film.pairs(), percent(&found)));
            }
            sums.extend(renderer.sums(rows, pairs.clone()));
        }
        let splats = renderer.splats(pairs.clone());
        // They are there: the round was made with them.
        for (radiosity, pair) in
            renderer.radiosity().into_iter().flat_map(|one| pairs.clone().map(move |pair| (one, pair)))
        {
            let own = Patches::of(2 * pair, &radiosity.of_sample(2 * pair).facts);
            if patches.last().is_none_or(|last| last.count() != own.count()) {
                patches.push(own);
            }
        }
        film.add_lit(pairs, sums, splats).expect("pairs that are new");
        halves = film.halves();
        found = Estimate::of(&halves, width);
        preview.show(&halves, width);
        let Estimate { relative_mse, .. } = found;
        let deviation = deviation(&found, pixels);
        rounds.push(Round { spp: 2 * film.pairs(), spent: working.spent(), relative_mse, deviation });
    }
    let spent = working.spent();
    // Asked to end when there was nothing left to do, it is as if nobody had.
    let interrupted = interrupt.code().filter(|_| {
        let (ranges, now) = (film.ranges(), film.pairs() - before);
        goal.next(&Done { ranges: &ranges, now, elapsed: working.elapsed() }, &found).is_some()
    });
    if let Some(archive) = archive.as_mut().filter(|_| film.pairs() > before) {
        archive.save(&film, working.elapsed())?;
    }
    let spp = 2 * film.pairs();
    if let Some(code) = interrupted.filter(|_| spp == 0) {
        preview.end();
        out::say("stopped before the first samples were complete: nothing was written");
        return Err(Stop::Interrupted(code));
    }
    if halves.is_empty() {
        halves = film.halves();
    }
    drop(film);
    let features = kinds.iter().any(|kind| kind.features).then(|| seen(&renderer, [width, height], &mut preview));
    preview.end();
    let earlier = if before > 0 { format!(", {} of them before,", 2 * before) } else { String::new() };
    out::say(&format!(
        "{}: {width} × {height}, {spp} spp{earlier} in {:.2} s after {:.2} s to make ready; relative error {}",
        scene.name,
        spent.seconds,
        making_ready.seconds,
        error_told(&found, pixels),
    ));
    if let Some((_, seconds)) = &features {
        out::say(&format!("normals, albedo and depth in {seconds:.2} s"));
    }
    if interrupted.is_some() {
        let of = goal.samples_wanted().map_or(String::new(), |wanted| format!(" of {wanted}"));
        let on = if archive.is_some() { "; the same command goes on from there" } else { "" };
        out::say(&format!("stopped: {spp}{of} spp{on}"));
    } else if let Some(error) = goal.missed(&found) {
        out::say(&format!("note: the error asked for, {error}, was not reached"));
    }
    let (needs, bytes) = (*renderer.needs(), renderer.bytes());
    let features = features.map(|(features, _)| features);
    let size = [width, height];
    Ok(Rendered {
        size,
        halves,
        spp,
        found,
        features,
        rounds,
        patches,
        before,
        making_ready,
        spent,
        needs,
        bytes,
        interrupted,
    })
}

/// What the camera sees without any light, and the time that took [s].
fn seen(renderer: &Renderer, [width, height]: [u32; 2], preview: &mut Preview) -> (Vec<Feature>, f64) {
    let watch = Watch::started();
    let mut features = Vec::with_capacity(width as usize * height as usize);
    for rows in preview::bands([width, height], 1, watch.elapsed(), 0, 1) {
        preview.tell(preview.whole(), &format!("normals, albedo, depth: row {} of {height}", rows.start));
        features.extend(renderer.features(rows));
    }
    (features, watch.spent().seconds)
}

/// The most bytes that are held at once for a picture of so many pixels, beside the scene, of a film of so many branches.
fn most(pixels: usize, branches: usize, is_lit: bool, kinds: &[&Kind]) -> u64 {
    /// What does not depend on the picture: the program, random numbers, stacks, paths from lamps under way.
    const ANYHOW: u64 = 128 << 20;
    let sums = size_of::<Halves>() as u64;
    // Paths from lamps are counted in whole numbers twice as long.
    let branch = if is_lit { 3 * sums } else { sums };
    // A round's own sums beside the film; then the means, their sums, and what paths from lamps brought.
    let rendering = branches as u64 * branch + (branch - sums + 2 * sums).max(branch);
    let features = if kinds.iter().any(|kind| kind.features) { size_of::<Feature>() as u64 } else { 0 };
    let file = kinds.iter().map(|kind| kind.bytes).max().unwrap_or(0);
    ANYHOW + pixels as u64 * rendering.max(sums + features + file)
}

/// How far it will be, of [`Goal::whole`], after `next` more pairs that take as long as those before, each.
fn shares_after(goal: &Goal, done: &Done, next: u32, found: &Estimate) -> u64 {
    let more = f64::from(done.now + next) / f64::from(done.now.max(1));
    let elapsed = done.elapsed.mul_f64(more);
    let found = Estimate { relative_mse: found.relative_mse / more, ..*found };
    let ahead = done.ranges.last().map_or(0, |last| last.end);
    let ranges: Vec<_> =
        done.ranges.iter().cloned().chain(std::iter::once(ahead..ahead.saturating_add(next))).collect();
    goal.share(&Done { ranges: &ranges, now: done.now + next, elapsed }, &found)
}
