//! Chooses the quality that holds the frame rate, or an accuracy.
//!
//! The choice depends on nothing but how long the frames took, or on what their probes found. The governors have no clock of their
//! own, so the same times, or probes, always lead to the same qualities.

use crate::counts::Probes;
use crate::quality::Quality;
use core::time::Duration;

/// Nanoseconds in a second.
const SECOND: u64 = 1_000_000_000;

/// The number of presets of the ladder.
const PRESETS: usize = Quality::LADDER.len();

/// The number of late frames after which it steps down: 0.1 s at 60 frames per second. A frame that takes as long as several
/// counts as several.
const TOO_LATE: u64 = 6;

/// The most late frames that one frame counts as, so that a single one, which something else may have delayed, never causes a
/// step.
const MAX_LATENESS: u64 = 4;

/// The time in nanoseconds for which a finer preset has to look possible before it is tried. Together with the delay of
/// [`Governor::mean`] it takes half a second at 30 frames per second.
const CALM: u64 = SECOND / 5;

/// The number of frames after a step down in which the new preset's times are compared with the old one's.
const COMPARED: u64 = 8;

/// Steps along the [`Quality::LADDER`] to hold a frame rate: down when frames are late, and up again once the next finer preset
/// would leave a sixth of the time unused. How long frames would take there is estimated from what the step down saved.
///
/// Under a constant load it stays on one preset, even if the times vary. When the load changes, it takes its first step within half
/// a second, or within two frames if these are longer. If it gets lighter within eight frames of a step down, that counts as saved by
/// the step, since times alone cannot tell them apart: then it may stay where it is until the load changes again.
///
/// ```
/// use core::time::Duration;
/// use eightfold_tracer::{Governor, Quality};
///
/// let mut governor = Governor::new(Duration::from_secs(1) / 60);
/// assert_eq!(governor.quality(), &Quality::LADDER[0]);
/// for _ in 0..10 {
///     governor.frame(Duration::from_millis(33));
/// }
/// assert_ne!(governor.quality(), &Quality::LADDER[0]);
/// ```
pub struct Governor {
    /// The time that a frame may take, as all times in nanoseconds.
    budget: u64,
    /// The current preset, an index in the ladder.
    preset: usize,
    /// The number of late frames since the last step, less the number of frames in time.
    late: u64,
    /// The number of successive frames in which the next finer preset has looked possible.
    calm: u64,
    /// Frames since the last step.
    age: u64,
    /// The time of a frame on this preset: an exponential moving average, mostly of the last four.
    mean: u64,
    /// The mean on the next finer preset when it was left; 0 if the last step was up.
    before: u64,
    /// For each preset, the mean time below which the next finer one looks possible.
    room: [u64; PRESETS],
}

impl Governor {
    /// Returns a governor for frames of this duration, a second at most. It starts on the finest preset.
    #[must_use]
    #[inline]
    pub fn new(budget: Duration) -> Self {
        Self {
            budget: (budget.as_nanos() as u64).clamp(1, SECOND),
            preset: 0,
            late: 0,
            calm: 0,
            age: 0,
            mean: 0,
            before: 0,
            room: [0; PRESETS],
        }
    }

    /// The quality for the next frame.
    #[must_use]
    pub fn quality(&self) -> &'static Quality {
        &Quality::LADDER[self.preset]
    }

    /// Its preset, as an index in [`Quality::LADDER`].
    #[must_use]
    pub fn preset(&self) -> usize {
        self.preset
    }

    /// Records the time from the start of the last frame until it was shown.
    #[inline]
    pub fn frame(&mut self, time: Duration) {
        let budget = self.budget;
        let time = (time.as_nanos() as u64).min(MAX_LATENESS * budget);
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
        let Some(room) = self.room.get_mut(self.preset) else {
            return;
        };
        if self.before > 0 && self.age <= COMPARED {
            *room = self.mean * (budget / 6 * 5) / self.before;
        }
        self.calm = if self.mean < *room { self.calm + 1 } else { 0 };
        if self.late == too_late && self.preset + 1 < PRESETS {
            self.before = self.mean;
            self.preset += 1;
        } else if self.calm == hold && self.preset > 0 {
            self.before = 0;
            self.preset -= 1;
        } else {
            return;
        }
        (self.late, self.calm, self.age) = (0, 0, 0);
    }
}

/// The fewest probes that a step of an [`AccuracyGovernor`] is decided by: 13 frames of [`Frame::PROBES`](crate::Frame::PROBES).
const FEWEST: u64 = 1_000;

/// The most probes that it remembers, 1.7 s at 60 frames per second: then each counts half.
const MOST: u64 = 8_000;

/// dB that a preset may be expected to be worse than the next finer one: the least of the ladder, and more than its most.
const WORSE: [f32; 2] = [1.4, 3.0];

/// dB that are left to chance before a preset is tried again that was left.
const CHANCE: f32 = 0.5;

/// Steps along the [`Quality::LADDER`] to hold an accuracy, by what probes find (see
/// [`Frame::with_probes`](crate::Frame::with_probes)): to a finer preset when frames are certainly less accurate, and to a faster one
/// once that would certainly be accurate enough. How accurate frames would be there is estimated from what the step to the finer one
/// gained.
///
/// Few pixels make most of the error, so a second of frames is known to some dB: it takes its steps when the difference is larger than
/// that, within a second or two if it is 6 dB. Where the accuracy is constant it stays on one preset. Unless
/// that is the finest, it is at most 1 dB less accurate than asked for, or 2 dB in two cases of a thousand, and up to 4 dB more.
pub struct AccuracyGovernor {
    /// The accuracy to hold, in dB.
    target: f32,
    /// The current preset, an index in the ladder.
    preset: usize,
    /// The findings of probes on it.
    probes: Probes,
    /// The dB on the next faster preset when it was left, until it is known what that gained.
    before: Option<f32>,
    /// For each preset, the dB above which the next faster one looks accurate enough.
    room: [f32; PRESETS],
}

impl AccuracyGovernor {
    /// A governor that holds a peak signal-to-noise ratio, in dB. It starts on the finest preset.
    #[must_use]
    pub fn new(target: f32) -> Self {
        Self {
            target,
            preset: 0,
            probes: Probes::NONE,
            before: None,
            room: [target + WORSE[0]; PRESETS],
        }
    }

    /// The quality for the next frame.
    #[must_use]
    pub fn quality(&self) -> &'static Quality {
        &Quality::LADDER[self.preset]
    }

    /// Its preset, as an index in [`Quality::LADDER`].
    #[must_use]
    pub fn preset(&self) -> usize {
        self.preset
    }

    /// Records what the last frame's probes found.
    pub fn frame(&mut self, probes: Probes) {
        self.probes += probes;
        if self.probes.pixels < FEWEST {
            return;
        }
        // Without any error there is no margin. Errors that no probe met are those of the next steps.
        let margin = self.probes.margin_with(0.0).max(0.0);
        let psnr = self.probes.psnr();
        let room = &mut self.room[self.preset];
        if let Some(before) = self.before {
            *room = self.target + (psnr - before).clamp(WORSE[0], WORSE[1]) + CHANCE;
        }
        if self.probes.pixels > MOST {
            self.probes.halve();
            self.before = None;
        }
        if psnr + margin < self.target && self.preset > 0 {
            self.preset -= 1;
            self.before = Some(psnr);
        } else if psnr - margin > *room && self.preset + 1 < PRESETS {
            self.preset += 1;
            self.before = None;
        } else {
            return;
        }
        self.probes = Probes::NONE;
    }
}
