use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::{Duration, Instant};

/// Between lines: few in a log, but proof of progress.
const LINE_EVERY: Duration = Duration::from_secs(10);

/// Prints lines, without a thread, which would disturb measurements.
pub struct Progress {
    steps: usize,
    done: AtomicUsize,
    pub start: Instant,
    /// The time of the last line.
    line: Mutex<Instant>,
}

impl Progress {
    pub fn new(steps: usize) -> Self {
        let start = Instant::now();
        Self { steps, done: AtomicUsize::new(0), start, line: start.into() }
    }

    pub fn inc(&self, steps: usize) {
        self.done.fetch_add(steps, Relaxed);
        if let Some(line) = self.due(Instant::now()) {
            eprintln!("{line}");
        }
    }

    /// Returns a line if the last one is long ago.
    pub fn due(&self, now: Instant) -> Option<String> {
        let mut last = self.line.lock().ok()?;
        if now - *last < LINE_EVERY {
            return None;
        }
        *last = now;
        let share = self.done.load(Relaxed) as f64 / self.steps as f64;
        let left = (now - self.start).as_secs_f64() * (1.0 / share - 1.0);
        Some(format!("{:.0} %, {left:.0} s to go", 1e2 * share))
    }
}
