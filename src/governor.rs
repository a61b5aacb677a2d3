//! The quality that holds the frame rate.
//!
//! A function of how long frames take, and of nothing else: it has no clock, so the same times always lead to the same
//! qualities.

use crate::quality::Quality;

/// Nanoseconds in a second.
const SECOND: u64 = 1_000_000_000;

/// Rungs of the ladder.
const RUNGS: usize = Quality::LADDER.len();

/// Late frames in a row that are too many: 0.1 s at 60 a second. One that takes as long as several counts as several.
const TOO_LATE: u64 = 6;

/// The most late frames that one counts as, so that a single one is never too many: something else came between.
const ONE_IS_AT_MOST: u64 = 4;

/// Time for which a finer rung has to look possible before it is tried. With what [`Governor::mean`] takes to follow,
/// half a second at 30 frames a second.
const CALM: u64 = SECOND / 5;

/// Frames after a change in which the new rung is compared with the one before.
const COMPARED: u64 = 8;

/// Walks the [`Quality::LADDER`] so that frames come in time: down when they are late, and up again once the next
/// finer rung would leave a sixth of the time unused, to judge by what the step down from it had saved.
///
/// While the load stays the same it stays on a rung, however the times spread; when it changes, it takes its first step
/// within half a second, or within two frames if they are longer.
pub struct Governor {
    /// Time that a frame may take, in nanoseconds, as all times are.
    budget: u64,
    rung: usize,
    /// What late frames since the last change count as; frames in time are taken off again.
    late: u64,
    /// Frames in which the next finer rung has looked possible.
    calm: u64,
    /// Frames since the last change.
    age: u64,
    /// The time of a frame on this rung: a mean of the last ones, mostly the last four.
    mean: u64,
    /// That of the next finer rung when it was left, or 0 when this one was come to from below.
    before: u64,
    /// For each rung the mean time below which the next finer one looks possible.
    room: [u64; RUNGS],
}

impl Governor {
    /// Starts on the finest rung, to hold so many frames a second, at least 1.
    #[must_use]
    pub fn new(frames_a_second: u64) -> Self {
        Self {
            budget: (SECOND / frames_a_second.max(1)).max(1),
            rung: 0,
            late: 0,
            calm: 0,
            age: 0,
            mean: 0,
            before: 0,
            room: [0; RUNGS],
        }
    }

    /// The number of the rung for the next frame.
    #[must_use]
    pub fn rung(&self) -> usize {
        self.rung
    }

    /// Takes note of how long the last frame took, until it was shown, in nanoseconds.
    pub fn frame(&mut self, time: u64) {
        let budget = self.budget;
        let time = time.min(ONE_IS_AT_MOST * budget);
        self.age += 1;
        self.mean = if self.age == 1 {
            time
        } else {
            (3 * self.mean + time) / 4
        };
        let hold = (CALM / budget).max(2);
        let too_late = TOO_LATE.min(hold);
        // The last sixteenth is for what the clock and the system take.
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
