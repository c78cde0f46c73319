//! Pixels that are worth more samples than others, as a few rays through each tell before there is any light.
//!
//! What is specular shows the picture's darkest corners and its lamps side by side; and where the rim of a lamp crosses a pixel,
//! a ray has all of its light or nothing. There a sample is the mean of several, of numbers of their own. It is where things
//! are that decides, not what samples bring: the mean stays what it is.

use super::Stage;
use super::kernel::Tactics;
use crate::number::{Mask, Width, vectorised_lanes};

/// Where it is looked, in pixels from a pixel's middle: there first, then around it, a little outside, so that no rim that
/// bulges into the pixel is missed.
const LOOKS: [[f64; 2]; 9] = {
    let far = 0.6;
    [[0.0, 0.0], [-far, -far], [0.0, -far], [far, -far], [-far, 0.0], [far, 0.0], [-far, far], [0.0, far], [far, far]]
};

/// Of how many samples each one of a pixel is the mean, by column and row.
pub fn several<N: Width>(stage: &Stage<N>, tactics: &Tactics, pixels: &[[u32; 2]]) -> Vec<u32> {
    let extra = tactics.extra.max(1);
    if extra == 1 || !stage.is_looked_at() {
        return vec![1; pixels.len()];
    }
    vectorised_lanes::<N, _>(
        #[inline(always)]
        || looked(stage, extra, pixels),
    )
}

#[inline(always)]
fn looked<N: Width>(stage: &Stage<N>, extra: u32, pixels: &[[u32; 2]]) -> Vec<u32> {
    let looks = if stage.needs().rims { &LOOKS[..] } else { &LOOKS[..1] };
    let half = N::of(0.5);
    let all = pixels.len() * looks.len();
    // The least and the greatest number of a lamp that was seen, −1 of none.
    let mut lamps = vec![[f64::INFINITY, f64::NEG_INFINITY]; pixels.len()];
    let mut is_specular = vec![false; pixels.len()];
    for start in (0..all).step_by(N::LANES) {
        let of = |lane: usize| (start + lane).min(all - 1);
        let place = |axis: usize| {
            N::from_lanes(
                #[inline(always)]
                |lane| f64::from(pixels[of(lane) / looks.len()][axis]) + looks[of(lane) % looks.len()][axis],
            )
        };
        let ray = stage.camera([place(0), place(1)], [half; 4]);
        let hit = stage.closest(&ray, N::Mask::of(true));
        let is_met = hit.is_some();
        let vertex = stage.vertex(&ray, &hit, is_met);
        for lane in 0..N::LANES.min(all - start) {
            let (pixel, look) = (of(lane) / looks.len(), of(lane) % looks.len());
            let is_met = is_met.lane(lane);
            is_specular[pixel] |= look == 0 && is_met && vertex.met.is_specular(lane);
            let lamp = if is_met { vertex.lamp.lane(lane) } else { -1.0 };
            let [least, greatest] = &mut lamps[pixel];
            (*least, *greatest) = (least.min(lamp), greatest.max(lamp));
        }
    }
    let is_worth = |(is_specular, [least, greatest]): (bool, [f64; 2])| is_specular || least < greatest;
    is_specular.into_iter().zip(lamps).map(|one| if is_worth(one) { extra } else { 1 }).collect()
}
