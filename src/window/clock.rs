use core::sync::atomic::{AtomicU64, Ordering::Acquire};

use crate::backend::clock::{now, sleep_until};

pub const SECOND: u64 = 1_000_000_000;

#[derive(Clone, Copy)]
pub struct Clock {
    pub(crate) start: u64,
}

impl Clock {
    #[must_use]
    pub fn start() -> Clock {
        Clock { start: now() }
    }

    #[must_use]
    pub fn time(&self) -> u64 {
        now() - self.start
    }

    /// Sleeps until `time` nanoseconds after the start, or until a signal arrives.
    pub fn sleep_until(&self, time: u64) {
        sleep_until(self.start + time);
    }
}

/// Sleeps for `time` nanoseconds, or until a signal arrives.
pub(crate) fn sleep(time: u64) {
    sleep_until(now() + time);
}

/// Waits while `number` is `value`, for at most three seconds, which a network device may need to
/// open. Returns the number.
pub(crate) fn wait_while(number: &AtomicU64, value: u64) -> u64 {
    let clock = Clock::start();
    loop {
        let found = number.load(Acquire);
        if found != value || clock.time() > 3 * SECOND {
            return found;
        }
        sleep(SECOND / 200);
    }
}

#[cfg(test)]
mod tests {
    use super::{Clock, SECOND};

    #[test]
    fn sleep_ends_on_time_or_at_once() {
        let clock = Clock::start();
        clock.sleep_until(SECOND / 20);
        assert!(clock.time() >= SECOND / 20);
        clock.sleep_until(SECOND / 100);
        assert!(clock.time() < 5 * SECOND, "it must not sleep once the time is past");
    }
}
