use super::kernels::Kernels;
use crate::coverage::Coverage;
use crate::plan::FramePlan;
use crate::prepare::{VisibleGroups, World};
use crate::quality::Quality;
use crate::trace::Batch;

/// A frame, shared by all threads.
pub(crate) struct Context<'a, O> {
    pub plan: &'a FramePlan,
    pub kernels: Kernels,
    pub world: World<'a>,
    pub coverage: &'a Coverage,
    pub observer: O,
}

impl<O> Context<'_, O> {
    pub fn trace(&self, quality: &Quality, visible: VisibleGroups, batch: &mut Batch) {
        (self.kernels.trace)(self.kernels.level, self.world, quality, visible, batch);
    }
}
