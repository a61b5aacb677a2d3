use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, stderr};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Between lines: few in a log, and no doubt whether the program hangs.
const LINE_EVERY: Duration = Duration::from_secs(10);

/// A bar on a terminal, else a line now and then. It has no thread, which would disturb measurements.
pub struct Progress {
    bar: ProgressBar,
    start: Instant,
    /// The time of the last line; `None` on a terminal.
    line: Option<Mutex<Instant>>,
}

pub fn bar(steps: usize) -> Progress {
    Progress::new(steps, stderr().is_terminal(), Instant::now())
}

impl Progress {
    pub fn new(steps: usize, is_terminal: bool, start: Instant) -> Self {
        let target =
            if is_terminal { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} %, {eta} to go");
        let bar = ProgressBar::with_draw_target(Some(steps as u64), target);
        Self {
            bar: bar.with_style(style.expect("the template is right")),
            start,
            line: (!is_terminal).then(|| start.into()),
        }
    }

    pub fn inc(&self, steps: u64) {
        self.bar.inc(steps);
        if let Some(line) = self.due(Instant::now()) {
            eprintln!("{line}");
        }
    }

    /// Returns a line if the last one is long ago.
    pub fn due(&self, now: Instant) -> Option<String> {
        let mut last = self.line.as_ref()?.lock().ok()?;
        if now - *last < LINE_EVERY {
            return None;
        }
        *last = now;
        let share = self.bar.position() as f64 / self.bar.length()? as f64;
        let left = (now - self.start).as_secs_f64() * (1.0 / share - 1.0);
        Some(format!("{:.0} %, {left:.0} s to go", 1e2 * share))
    }

    pub fn finish_and_clear(&self) {
        self.bar.finish_and_clear();
    }
}
