//! C6, E26: power through a surface.

use super::symbols::{ALPHA, AREA, FLUX};
use crate::symbols::S;
use crate::vocabulary::{Exhibit, Step, exhibit, statement, step};
use equation::Equation;
use equation::expr::{Range, abs, cos, integral, mean};

pub(super) const EXHIBIT: Exhibit = exhibit("flux", &[], &[]);

pub(super) const STEP: Step = step(
    EXHIBIT,
    "Power through a surface",
    "Of the mean flow a surface meets the part along its normal; summed over its area that is a power.",
)
.rows(&["E26", "C6"])
.statements(&[statement("flux", "radiant flux, in watts", || {
    Equation::new(
        FLUX,
        integral(
            mean(abs(S)) * cos(ALPHA),
            [AREA.into()],
            Range::Region(equation::Symbol::scalar("Sigma", equation::Dimension::SQUARE_METRE)),
        ),
    )
})
.rows(&["E26"])]);
