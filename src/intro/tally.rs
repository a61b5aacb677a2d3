//! Statistics of a run.

use core::fmt::{self, Write};

use eightfold_window::{
    clock::SECOND,
    line::{Decimal, Hundredths, Tenths, Writer},
};

use super::qualities::NAMED;

/// Statistics of a run. All times are in nanoseconds.
#[derive(Default)]
pub struct Tally {
    frames: u64,
    /// The time from the start to the last frame, or to the end.
    time: u64,
    /// The number of frames in the slowest complete second.
    slowest: Option<u64>,
    /// The current second, counted from the start.
    second: u64,
    /// Frames in the current second so far.
    frames_in_second: u64,
    /// The width and height of the last frame in pixels.
    size: (usize, usize),
    /// The time for which each quality of [`NAMED`] was used.
    used: [u64; NAMED.len()],
}

impl Tally {
    /// Counts a frame: the time at which it was shown, its size, and the index of its quality in [`NAMED`].
    pub fn count(&mut self, time: u64, size: (usize, usize), quality: usize) {
        self.frames += 1;
        self.size = size;
        self.used[quality] += time - self.time;
        self.time = time;
        let second = time / SECOND;
        if second != self.second {
            // If a frame took longer than a second, there was a second without frames.
            let is_next = second == self.second + 1;
            let frames = if is_next { self.frames_in_second } else { 0 };
            self.slowest = Some(self.slowest.map_or(frames, |slowest| slowest.min(frames)));
            self.second = second;
            self.frames_in_second = 0;
        }
        self.frames_in_second += 1;
    }

    /// Notes the time at which the show ended.
    pub fn end(&mut self, time: u64) {
        self.time = time;
    }

    /// Writes the statistics in one line, with the number of threads and the name of the instruction set.
    pub fn report(&self, output: &mut Writer, threads: usize, isa: &str) -> fmt::Result {
        let mean = self.frames * 10 * SECOND / self.time.max(1);
        let worst = self.slowest.map_or(mean, |frames| frames * 10);
        let hundredths = |time: u64| Hundredths(time / (SECOND / 100));
        write!(
            output,
            "{} frames in {} s: {} fps, worst second {} fps, {}x{}, threads {}, {isa}",
            Decimal(self.frames),
            hundredths(self.time),
            Tenths(mean),
            Tenths(worst),
            Decimal(self.size.0 as u64),
            Decimal(self.size.1 as u64),
            Decimal(threads as u64),
        )?;
        for ((name, _), &time) in NAMED.iter().zip(&self.used) {
            if time > 0 {
                write!(output, ", {name} {} s", hundredths(time))?;
            }
        }
        writeln!(output)
    }
}
