//! The machine, clocks, the times of frames, and statistics of measured times, for all commands that measure.

use crate::arguments::processors;
use cpu_time::ThreadTime;
use std::fs;
use std::time::Instant;

/// The frame rate, in frames per second, of frames in a row: that of most screens.
pub const FPS: f64 = 60.0;

/// Does some work. Returns its result, and the seconds of real time that it took: for work on several threads.
pub fn real_time<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64())
}

/// Does some work on this thread. Returns its result, and the seconds that the thread was on a processor, which do not include
/// those that other programs took.
pub fn thread_time<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = ThreadTime::now();
    let result = work();
    (result, start.elapsed().as_secs_f64())
}

/// The time of frame `i` of `count` that are evenly spaced from a first to a last time, in seconds.
pub fn evenly_spaced(from: f32, to: f32, i: usize, count: usize) -> f32 {
    let share = i as f64 / (count - 1).max(1) as f64;
    (f64::from(from) * (1.0 - share) + f64::from(to) * share) as f32
}

/// The time of frame `i` of those in a row from a first time on, in seconds.
pub fn frame_time(from: f32, i: usize) -> f32 {
    (f64::from(from) + i as f64 / FPS) as f32
}

/// The median: the middle one of some times, or the mean of the two in the middle.
pub fn median(times: &[f64]) -> f64 {
    let times = sorted(times);
    let middle = times.len() / 2;
    if times.len().is_multiple_of(2) {
        0.5 * (times[middle - 1] + times[middle])
    } else {
        times[middle]
    }
}

/// A percentile: the smallest of some times that `percent` in a hundred do not exceed.
pub fn percentile(times: &[f64], percent: usize) -> f64 {
    sorted(times)[(times.len() * percent).div_ceil(100) - 1]
}

fn sorted(times: &[f64]) -> Vec<f64> {
    let mut times = times.to_vec();
    times.sort_by(f64::total_cmp);
    times
}

/// The processor's name, if the system tells it, and the number of processors.
pub fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let models = info.lines().filter_map(|line| line.split_once(':'));
    let model = models
        .filter(|(name, _)| name.trim() == "model name")
        .map(|(_, model)| model.trim())
        .next()
        .unwrap_or("unknown processor");
    let count = processors();
    format!(
        "{model}, {count} processor{}",
        if count == 1 { "" } else { "s" }
    )
}
