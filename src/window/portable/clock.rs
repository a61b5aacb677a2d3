//! The system's monotonic clock, by std.

use std::{
    sync::LazyLock,
    thread,
    time::{Duration, Instant},
};

static START: LazyLock<Instant> = LazyLock::new(Instant::now);

/// Returns the time since the first call.
pub fn now() -> u64 {
    START.elapsed().as_nanos() as u64
}

/// Sleeps until a time.
pub fn sleep_until(end: u64) {
    thread::sleep(Duration::from_nanos(end.saturating_sub(now())));
}
