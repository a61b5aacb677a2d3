//! The lead of the written sound over the clock.

use super::RATE;
use crate::clock::SECOND;

/// The buffer's length in microseconds, for threads that wake up late. Below 320 ms PulseAudio
/// drops out without reporting it: 4 s of sound take 6 s.
pub const LATENCY: u32 = 400_000;

/// The least average interval between written samples, in nanoseconds: half a percent below the
/// nominal one, for fast devices. A null device would take samples at any speed.
const PACE: u64 = SECOND * 199 / 200 / RATE as u64;

/// The maximum lead over [`PACE`] in nanoseconds: the buffer, and half of it to catch up. Beyond it
/// the thread sleeps until half the lead is left; waking up for each chunk takes four times as long
/// as the synthesis.
const SLACK: u64 = LATENCY as u64 * 1500;

/// A device may lead the clock by 1 / `FASTEST` of the time, more than by any quartz. A null device
/// reports everything as played.
const FASTEST: u64 = 1024;

#[derive(Default)]
pub struct Lead {
    samples: u64,
    /// The time from which the last of them is due by [`PACE`].
    paced: u64,
}

impl Lead {
    pub fn count(&mut self, samples: u64) {
        self.samples += samples;
        self.paced += samples * PACE;
    }

    pub fn written(&self) -> i64 {
        nanoseconds(self.samples as i64)
    }

    /// Returns the heard sound's lead over the clock in nanoseconds, with `delay` samples that
    /// wait.
    pub fn ahead(&self, now: u64, delay: i64) -> i64 {
        let heard = nanoseconds(self.samples as i64 - delay);
        (heard - now as i64).min((now / FASTEST) as i64)
    }

    /// Returns the time to sleep until, if the lead is too long. Both times are in nanoseconds.
    pub fn due(&mut self, now: u64) -> Option<u64> {
        self.paced = self.paced.max(now);
        (self.paced > now + SLACK).then(|| self.paced - SLACK / 2)
    }
}

fn nanoseconds(samples: i64) -> i64 {
    samples * (SECOND as i64 / 1000) / i64::from(RATE / 1000)
}

#[cfg(test)]
mod tests;
