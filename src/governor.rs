//! Chooses the quality that holds the frame rate.
//!
//! The choice depends on nothing but how long the frames took. The governor has no clock of its own, so the same times always
//! lead to the same qualities.

use crate::quality::Quality;

/// Nanoseconds in a second.
const SECOND: u64 = 1_000_000_000;

/// The number of rungs of the ladder.
const RUNGS: usize = Quality::LADDER.len();

/// The number of late frames after which it steps down: 0.1 s at 60 frames per second. A frame that takes as long as several
/// counts as several.
const TOO_LATE: u64 = 6;

/// The most late frames that one frame counts as, so that a single one, which something else may have delayed, never causes a
/// step.
const MAX_LATENESS: u64 = 4;

/// The time in nanoseconds for which a finer rung has to look possible before it is tried. Together with the delay of
/// [`Governor::mean`] it takes half a second at 30 frames per second.
const CALM: u64 = SECOND / 5;

/// The number of frames after a step down in which the new rung's times are compared with the old one's.
const COMPARED: u64 = 8;

/// Steps along the [`Quality::LADDER`] to hold a frame rate: down when frames are late, and up again once the next finer rung
/// would leave a sixth of the time unused. How long frames would take there is estimated from what the step down saved.
///
/// Under a constant load it stays on one rung, even if the times vary. When the load changes, it takes its first step within half
/// a second, or within two frames if these are longer.
///
/// All times are in nanoseconds.
pub struct Governor {
    /// The time that a frame may take.
    budget: u64,
    /// The current rung, an index in the ladder.
    rung: usize,
    /// The number of late frames since the last step, less the number of frames in time.
    late: u64,
    /// The number of successive frames in which the next finer rung has looked possible.
    calm: u64,
    /// Frames since the last step.
    age: u64,
    /// The time of a frame on this rung: an exponential moving average, mostly of the last four.
    mean: u64,
    /// The mean on the next finer rung when it was left; 0 if the last step was up.
    before: u64,
    /// For each rung, the mean time below which the next finer one looks possible.
    room: [u64; RUNGS],
}

impl Governor {
    /// A governor that holds a number of frames per second, at least 1. It starts on the finest rung.
    #[must_use]
    pub fn new(frames_per_second: u64) -> Self {
        Self {
            budget: (SECOND / frames_per_second.max(1)).max(1),
            rung: 0,
            late: 0,
            calm: 0,
            age: 0,
            mean: 0,
            before: 0,
            room: [0; RUNGS],
        }
    }

    /// The rung for the next frame, as an index in [`Quality::LADDER`].
    #[must_use]
    pub fn rung(&self) -> usize {
        self.rung
    }

    /// Records how long the last frame took until it was shown, in nanoseconds.
    pub fn frame(&mut self, time: u64) {
        let budget = self.budget;
        let time = time.min(MAX_LATENESS * budget);
        self.age += 1;
        self.mean = if self.age == 1 {
            time
        } else {
            (3 * self.mean + time) / 4
        };
        let hold = (CALM / budget).max(2);
        let too_late = TOO_LATE.min(hold);
        // A sixteenth of the budget is left to the system.
        if time > budget / 16 * 15 {
            let frames = (time / budget).max(1).min(too_late - 1);
            self.late = (self.late + frames).min(too_late);
        } else {
            self.late = self.late.saturating_sub(1);
        }
        let Some(room) = self.room.get_mut(self.rung) else {
            return;
        };
        if self.before > 0 && self.age <= COMPARED {
            *room = self.mean * (budget / 6 * 5) / self.before;
        }
        self.calm = if self.mean < *room { self.calm + 1 } else { 0 };
        if self.late == too_late && self.rung + 1 < RUNGS {
            self.before = self.mean;
            self.rung += 1;
        } else if self.calm == hold && self.rung > 0 {
            self.before = 0;
            self.rung -= 1;
        } else {
            return;
        }
        (self.late, self.calm, self.age) = (0, 0, 0);
    }
}
