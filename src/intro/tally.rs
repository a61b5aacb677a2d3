//! How a run went.

use core::fmt::{self, Write};

use eightfold_window::{
    clock::SECOND,
    line::{Hundredths, Tenths, Writer},
};

use super::qualities::NAMED;

/// Counts of a run. All times are in nanoseconds.
#[derive(Default)]
pub struct Tally {
    frames: u64,
    /// From the start to the last frame, or to the end.
    time: u64,
    /// Frames of the slowest second that is over.
    slowest: Option<u64>,
    /// The second that is running, counted from the start.
    second: u64,
    /// Frames in that second so far.
    frames_in_second: u64,
    /// Width and height of the last frame.
    size: (usize, usize),
    /// How long each quality was used, in the order of [`NAMED`].
    used: [u64; NAMED.len()],
}

impl Tally {
    /// Counts a frame by the time when it was shown, its size, and the number of its quality.
    pub fn count(&mut self, time: u64, size: (usize, usize), quality: usize) {
        self.frames += 1;
        self.size = size;
        self.used[quality] += time - self.time;
        self.time = time;
        let second = time / SECOND;
        if second != self.second {
            // A frame that took longer than a second leaves a second without any.
            let is_next = second == self.second + 1;
            let frames = if is_next { self.frames_in_second } else { 0 };
            self.slowest = Some(self.slowest.map_or(frames, |slowest| slowest.min(frames)));
            self.second = second;
            self.frames_in_second = 0;
        }
        self.frames_in_second += 1;
    }

    /// Takes note that the run has ended by itself.
    pub fn end(&mut self, time: u64) {
        self.time = time;
    }

    /// Says in one line how it went, with so many threads and an instruction set of this name.
    pub fn report(&self, output: &mut Writer, threads: usize, isa: &str) -> fmt::Result {
        let mean = self.frames * 10 * SECOND / self.time.max(1);
        let worst = self.slowest.map_or(mean, |frames| frames * 10);
        let hundredths = |time: u64| Hundredths(time / (SECOND / 100));
        write!(
            output,
            "{} frames in {} s: {} fps, worst second {} fps, {}x{}, threads {threads}, {isa}",
            self.frames,
            hundredths(self.time),
            Tenths(mean),
            Tenths(worst),
            self.size.0,
            self.size.1,
        )?;
        for ((name, _), &time) in NAMED.iter().zip(&self.used) {
            if time > 0 {
                write!(output, ", {name} {} s", hundredths(time))?;
            }
        }
        writeln!(output)
    }
}
