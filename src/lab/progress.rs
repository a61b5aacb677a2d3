use std::io::{IsTerminal, Write, stderr};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Between lines: few in a log, and no doubt whether the program hangs; smooth on a terminal.
const EVERY: [Duration; 2] = [Duration::from_secs(10), Duration::from_millis(100)];

/// A line that changes on a terminal, else a line now and then. It has no thread, which would disturb measurements.
pub struct Progress {
    steps: usize,
    start: Instant,
    is_terminal: bool,
    /// Finished steps, and the time of the last line.
    state: Mutex<(usize, Instant)>,
}

pub fn bar(steps: usize) -> Progress {
    Progress::new(steps, stderr().is_terminal(), Instant::now())
}

impl Progress {
    pub fn new(steps: usize, is_terminal: bool, start: Instant) -> Self {
        Self {
            steps,
            start,
            is_terminal,
            state: Mutex::new((0, start)),
        }
    }

    pub fn inc(&self, steps: usize) {
        if let Some(line) = self.after(steps, Instant::now()) {
            let (before, end) = [("", "\n"), ("\r", "\x1b[K")][usize::from(self.is_terminal)];
            // A closed terminal shows none.
            let _ = write!(stderr(), "{before}{line}{end}");
        }
    }

    /// Counts finished steps. Returns a line if the last one is long ago.
    pub fn after(&self, steps: usize, now: Instant) -> Option<String> {
        let (finished, last) = &mut *self.state.lock().ok()?;
        *finished += steps;
        if now - *last < EVERY[usize::from(self.is_terminal)] {
            return None;
        }
        *last = now;
        let share = *finished as f64 / self.steps as f64;
        let left = (now - self.start).as_secs_f64() * (1.0 / share - 1.0);
        Some(format!("{:.0} %, {left:.0} s to go", 1e2 * share))
    }

    pub fn finish_and_clear(&self) {
        if self.is_terminal {
            let _ = write!(stderr(), "\r\x1b[K");
        }
    }
}
