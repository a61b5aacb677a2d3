//! A tile in a thread's working memory.

use crate::coverage::Rect;
use crate::grid::Area;
use crate::observe::Observer;
use crate::picture::Band;
use crate::prepare::VisibleGroups;
use crate::refine::Context;
use crate::refine::verdict::growth;
use crate::refine::worker::Worker;
use crate::trace::Sample;

pub(super) struct Tile<'a, 'b, O: Observer> {
    pub context: &'a Context<'a, O>,
    pub area: Area,
    /// The share of split top-level squares, to the fourth power: small unless nearly all are
    /// split.
    pub crowding: f32,
    /// The part of the picture that its squares cover.
    pub rect: Rect,
    pub visible: VisibleGroups,
    pub worker: &'a mut Worker,
    pub band: &'a mut Band<'b>,
}

impl<O: Observer> Tile<'_, '_, O> {
    #[inline(never)]
    pub fn growth(&self, level: usize) -> f32 {
        growth(1 << level, self.crowding)
    }

    #[inline(never)]
    pub fn put(&mut self, x: usize, y: usize, sample: Sample) {
        let threshold = self.context.world.film.threshold(x, self.area.top + y);
        self.band.put(x, y, sample.pixel(threshold));
    }
}
