//! Chapter poynting: how much flows, and which way.

use crate::exercise::formula::Of;
use crate::exercise::vocabulary::{Exercise, claim, exercise, files, one, real, slip, three, triple};
use glam::DVec3;
use num_complex::Complex64;

pub const EXERCISES: &[Exercise] = &[
    exercise("energy-flow", "which way energy flows", files!("energy-flow"))
        .of(
            "poynting/theorem",
            &[claim("flows_along_k", "The order counts: E first. Turn E into B by the right hand, and the thumb shows the way.")],
        )
        .asks("flow", &[triple("e", "V/m"), triple("b", "T")], three("V T/m"), &Of::<fn(DVec3, DVec3) -> DVec3>::NEW)
        .slips(&[
            slip("part by part. A cross product stands at right angles to both: each part is of the two others.", |x| {
                vec![x[0] * x[3], x[1] * x[4], x[2] * x[5]]
            }),
            slip("all signs positive. Each part is a difference: e_y b_z − e_z b_y.", |x| {
                vec![x[1] * x[5] + x[2] * x[4], x[2] * x[3] + x[0] * x[5], x[0] * x[4] + x[1] * x[3]]
            }),
            slip("the sign of y. Go round x → y → z → x: y = e_z b_x − e_x b_z.", |x| {
                vec![x[1] * x[5] - x[2] * x[4], x[0] * x[5] - x[2] * x[3], x[0] * x[4] - x[1] * x[3]]
            }),
        ]),
    exercise("mean-flow", "the mean flow of a wave whose H comes late", files!("mean-flow"))
        .of(
            "poynting/phasor",
            &[claim("out_of_step", "Only the part of H that is in step with E carries energy on average: a cosine of their phase is missing.")],
        )
        .asks(
            "mean_flow",
            &[real("e_re", "V/m"), real("e_im", "V/m"), real("h_re", "A/m"), real("h_im", "A/m")],
            one("W/m²"),
            &Of::<fn(Complex64, Complex64) -> f64>::NEW,
        )
        .slips(&[
            slip("½ Re(E H), without the conjugate. The phases must be subtracted: when both run on, their difference stays.", |x| {
                vec![0.5 * (x[0] * x[2] - x[1] * x[3])]
            }),
            slip("Re(E H*), the peak for the mean. cos² is a half on average.", |x| vec![x[0] * x[2] + x[1] * x[3]]),
            slip("½ Im(E H*). That is the energy that goes to and fro; what goes on is the real part.", |x| {
                vec![0.5 * (x[1] * x[2] - x[0] * x[3])]
            }),
        ]),
];
