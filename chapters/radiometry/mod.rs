//! Radiometry: rows E26–E32 and C6–C9. One module a step, in teaching order.

mod any_surface;
mod flux;
mod intensity;
mod irradiance;
mod radiance;
mod ray;
mod solid_angle;
mod sums;
mod surfaces;
mod symbols;

use crate::vocabulary::{Chapter, Gallery, gallery};

/// The chapter.
pub const CHAPTER: Chapter = Chapter {
    id: "radiometry",
    title: "Radiometry",
    says: "Flux, intensity, radiance, irradiance: where energy goes.",
    builds_on: &["poynting"],
    prose: include_str!("prose.md"),
    steps: &[
        flux::STEP,
        solid_angle::STEP,
        intensity::STEP,
        any_surface::STEP,
        radiance::STEP,
        ray::STEP,
        irradiance::STEP,
    ],
    figures: FIGURES,
    functions: &[],
};

/// What its steps show, apart from the evidence.
pub const FIGURES: Gallery = gallery(
    "radiometry",
    &[
        flux::EXHIBIT,
        solid_angle::EXHIBIT,
        intensity::EXHIBIT,
        any_surface::EXHIBIT,
        radiance::EXHIBIT,
        ray::EXHIBIT,
        irradiance::EXHIBIT,
    ],
);
#[cfg(test)]
mod scratch {
    #[test]
    fn all() {
        for step in super::CHAPTER.steps {
            for item in step.items() {
                let setting = crate::parameter::Setting::defaults(step.parameters());
                let h = crate::judge::holds(item, &setting, item.id());
                if matches!(item, crate::vocabulary::Item::Race(_)) { continue; }
                let f = crate::judge::can_fail(item, &setting, item.id());
                println!("{}/{}: {h:?} {f:?}", step.id, item.id());
            }
        }
    }
}
