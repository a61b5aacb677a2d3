//! Governors have no clock: equal times or probes give equal presets.

use crate::counts::Probes;
use crate::quality::Preset;
use crate::zero::Zero;
use core::time::Duration;

const SECOND: u64 = 1_000_000_000;

const PRESETS: usize = Preset::LADDER.len();

/// The presets at full size, then the fastest one at a half and at a third of each side.
const RUNGS: usize = PRESETS + 2;

/// Late frames before a step down: 0.1 s at 60 frames per second. A frame of several periods counts
/// several times.
const TOO_LATE: u64 = 6;

/// The most late frames that one frame counts as: one outlier causes no step.
const MAX_LATENESS: u64 = 4;

/// The nanoseconds for which a finer preset must look possible: with the delay of `mean`, half a
/// second at 30 frames per second.
const CALM: u64 = SECOND / 5;

/// The factor on [`CALM`] before frames grow, unless half of the time is left: changes of size are
/// more visible.
const SIZE_CALM: u64 = 5;

/// The fifths of the budget below which a finer rung of unknown time looks possible. The next
/// preset takes a quarter longer, larger frames 1.7 to 3 times as long.
const GUESS: u64 = 3;

/// Frames after a step down that are compared with the frames before it.
const COMPARED: u64 = 8;

/// Selects presets of [`Preset::LADDER`] to hold a frame rate.
///
/// It steps down when frames are late, and up if the next finer preset would leave a sixth of the
/// time unused, predicted by the ratio of the times before and after the last step down.
///
/// A constant load keeps the preset, even if times vary. After a change of the load, the first step
/// follows within half a second, or two frames if these are longer. If the load falls within eight
/// frames of a step down, the preset may stay too fast until the next change.
///
/// ```
/// use core::time::Duration;
/// use eightfold_tracer::{Governor, Preset};
///
/// let mut governor = Governor::new(Duration::from_secs(1) / 60);
/// for _ in 0..10 {
///     governor.frame(Duration::from_millis(33));
/// }
/// assert_ne!(governor.preset(), Preset::Finest);
/// ```
#[derive(Debug)]
pub struct Governor {
    /// Times are in nanoseconds.
    budget: u64,
    /// 0 to `last`, below [`RUNGS`].
    rung: usize,
    last: usize,
    /// Late frames since the last step, minus punctual ones, at least 0.
    late: u64,
    /// Successive frames in which the next finer rung looked possible.
    calm: u64,
    age: u64,
    /// An exponential moving average, mostly of the last four frames.
    mean: u64,
    before: u64,
    /// For each rung, the mean below which the next finer one looks possible.
    threshold: [u64; RUNGS],
}

zero! { Governor { budget, rung, last, late, calm, age, mean, before, threshold } }

impl Governor {
    /// Returns a governor at the finest preset, for a time of `budget` per frame, at most one
    /// second.
    #[must_use]
    #[inline]
    pub fn new(budget: Duration) -> Self {
        let budget = (budget.as_nanos() as u64).clamp(1, SECOND);
        let threshold = [budget / 5 * GUESS; RUNGS];
        Self { budget, last: PRESETS - 1, threshold, ..Self::ZERO }
    }

    /// Also selects a [divisor](Governor::divisor) if the fastest preset is too slow.
    #[must_use]
    pub fn with_smaller_frames(self) -> Self {
        Self { last: RUNGS - 1, ..self }
    }

    /// Selects the fastest frames, for a start or a sudden load: steps down would take a second.
    pub fn select_fastest(&mut self) {
        self.rung = self.last;
        (self.late, self.calm, self.age, self.before) = (0, 0, 0, 0);
    }

    /// Returns the preset for the next frame.
    #[must_use]
    pub fn preset(&self) -> Preset {
        Preset::LADDER[self.rung.min(PRESETS - 1)]
    }

    /// Returns the number that divides the sides of the next frame: 1, or 2 or 3 with
    /// [`Governor::with_smaller_frames`].
    #[must_use]
    pub fn divisor(&self) -> usize {
        1 + self.rung.saturating_sub(PRESETS - 1)
    }

    /// Records the time from the start of the last frame until it was shown.
    #[inline]
    pub fn frame(&mut self, time: Duration) {
        let budget = self.budget;
        let time = (time.as_nanos() as u64).min(MAX_LATENESS * budget);
        self.age += 1;
        self.mean = if self.age == 1 { time } else { (3 * self.mean + time) / 4 };
        let calm_frames = (CALM / budget).max(2);
        let too_late = TOO_LATE.min(calm_frames);
        // A sixteenth of the budget is reserved for the system.
        if time > budget / 16 * 15 {
            let frames = (time / budget).max(1).min(too_late - 1);
            self.late = (self.late + frames).min(too_late);
        } else {
            self.late = self.late.saturating_sub(1);
        }
        let Some(threshold) = self.threshold.get_mut(self.rung) else {
            return;
        };
        if self.before > 0 && self.age <= COMPARED {
            *threshold = self.mean * (budget / 6 * 5) / self.before;
        }
        self.calm = if self.mean < *threshold { self.calm + 1 } else { 0 };
        let has_doubt = self.rung >= PRESETS && self.mean > *threshold / 2;
        let calm_frames = if has_doubt { SIZE_CALM * calm_frames } else { calm_frames };
        if self.late == too_late && self.rung < self.last {
            self.before = self.mean;
            self.rung += 1;
        } else if self.calm >= calm_frames && self.rung > 0 {
            self.before = 0;
            self.rung -= 1;
        } else {
            return;
        }
        (self.late, self.calm, self.age) = (0, 0, 0);
    }
}

/// The least number of probes for a step: 13 frames of [`Frame::PROBES`](crate::Frame::PROBES).
const MIN_PROBES: u64 = 1_000;

/// Bounds on the assumed loss from a preset to the next faster one, in dB.
const STEP_LOSS: [f32; 2] = [1.4, 3.0];

/// The additional dB that are required to try a preset again.
const RETRY_GAIN: f32 = 0.5;

/// Selects presets of [`Preset::LADDER`] to hold an accuracy.
///
/// It steps to a finer preset if the accuracy is certainly below the target, and to a faster one
/// that would certainly reach it, predicted by the gain of the last step. A difference of 6 dB
/// causes a step within two seconds; a constant accuracy keeps the preset. The accuracy is at most
/// 4 dB above the target and, except at the finest preset, at most 1 dB below it (2 dB in two cases
/// of a thousand).
#[derive(Debug)]
pub struct AccuracyGovernor {
    target: f32,
    /// The index in [`Preset::LADDER`].
    rung: usize,
    probes: Probes,
    /// The dB before the last step to a finer preset, until its gain is known.
    before: Option<f32>,
    /// For each preset, the dB above which the next faster one looks accurate enough.
    threshold: [f32; PRESETS],
}

impl AccuracyGovernor {
    /// Returns a governor at the finest preset, for a target PSNR to exhaustive frames in dB.
    #[must_use]
    pub fn new(target: f32) -> Self {
        Self {
            target,
            rung: 0,
            probes: Probes::NONE,
            before: None,
            threshold: [target + STEP_LOSS[0]; PRESETS],
        }
    }

    /// Returns the preset for the next frame.
    #[must_use]
    pub fn preset(&self) -> Preset {
        Preset::LADDER[self.rung]
    }

    /// Records the probes ([`Frame::with_probes`](crate::Frame::with_probes)) of the last frame.
    pub fn frame(&mut self, probes: Probes) {
        self.probes += probes;
        if self.probes.pixels < MIN_PROBES {
            return;
        }
        // `max` replaces NaN (no errors). Later steps correct for errors that no probe met.
        let margin = self.probes.margin_with(0.0).max(0.0);
        let psnr = self.probes.psnr();
        let threshold = &mut self.threshold[self.rung];
        if let Some(before) = self.before {
            *threshold =
                self.target + (psnr - before).clamp(STEP_LOSS[0], STEP_LOSS[1]) + RETRY_GAIN;
        }
        if self.probes.pixels > Probes::MAX_RECENT {
            self.probes.halve();
            self.before = None;
        }
        if psnr + margin < self.target && self.rung > 0 {
            self.rung -= 1;
            self.before = Some(psnr);
        } else if psnr - margin > *threshold && self.rung + 1 < PRESETS {
            self.rung += 1;
            self.before = None;
        } else {
            return;
        }
        self.probes = Probes::NONE;
    }
}
