use super::captions::Cue;
use super::environment::Environment;
use super::path::View;

/// A scene of the show. ([`eightfold_tracer::scene::Scene`] is the content of one frame.)
#[derive(Clone, Copy)]
pub(super) struct ShowScene {
    pub environment: &'static Environment,
    /// Bars since the environment's first scene began, to continue its motion.
    pub environment_since: u32,
    pub shots: &'static [Shot],
    pub captions: &'static [Cue],
}

pub(super) struct Shot {
    pub bars: u8,
    /// At least two views, at equal intervals in time.
    pub views: &'static [View],
}

impl ShowScene {
    pub const fn new(environment: &'static Environment, shots: &'static [Shot]) -> ShowScene {
        ShowScene { environment, environment_since: 0, shots, captions: &[] }
    }

    pub const fn bars(&self) -> u32 {
        let (mut bars, mut i) = (0, 0);
        while i < self.shots.len() {
            bars += self.shots[i].bars as u32;
            i += 1;
        }
        bars
    }
}

pub(super) const fn shot(bars: u8, views: &'static [View]) -> Shot {
    Shot { bars, views }
}
