//! Pictures that are drawn somewhere else.

use super::Look;
use crate::reader::work::Order;
use chapters::figure::Plot;
use std::sync::Arc;
use views::block::{Cells, Picture};

/// A picture that is drawn somewhere else.
#[derive(Default)]
pub(super) struct Drawing {
    pub plot: Option<(u32, Arc<Plot>)>,
    pub picture: Option<(Order, Picture)>,
    pub asked: Option<Order>,
    /// Whether the last attempt failed.
    pub is_lost: bool,
}

impl Drawing {
    /// Whether it has to be drawn so; if it has, it is asked for.
    pub(super) fn wants(&mut self, order: Order) -> bool {
        let is_there = self.picture.as_ref().is_some_and(|(made, _)| *made == order);
        let wants = !is_there && self.asked.is_none() && !self.is_lost;
        if wants {
            self.asked = Some(order);
        }
        wants
    }

    /// The picture, put back while a newer one is on its way.
    pub(super) fn shown(&self, look: &Look, edition: u32) -> Picture {
        match &self.picture {
            Some((made, picture)) if made.edition == edition => picture.clone(),
            Some((_, picture)) if !self.is_lost => picture.dimmed(),
            _ => {
                let note = if self.is_lost { "this figure could not be drawn" } else { "drawing …" };
                Picture::Cells(Cells::note(look.width.min(60), picture_rows(look), note))
            }
        }
    }
}

/// Rows of a picture: less than a screen, so that what it belongs to stands beside it, and no more than its width calls
/// for.
pub(super) fn picture_rows(look: &Look) -> usize {
    (look.height * 5 / 8).min(look.width * 3 / 8).max(8)
}
