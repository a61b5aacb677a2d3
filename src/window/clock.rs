//! Time that only goes forward, in nanoseconds.

use core::sync::atomic::{AtomicU64, Ordering::Acquire};

use crate::backend::clock::{now, sleep_until};

/// Nanoseconds in a second.
pub const SECOND: u64 = 1_000_000_000;

/// Time since it was started.
#[derive(Clone, Copy)]
pub struct Clock {
    /// When, on the system's clock.
    pub(crate) start: u64,
}

impl Clock {
    /// Starts at zero now.
    #[must_use]
    pub fn start() -> Clock {
        Clock { start: now() }
    }

    /// Nanoseconds from the start until now.
    #[must_use]
    pub fn time(&self) -> u64 {
        now() - self.start
    }

    /// Sleeps until so many nanoseconds from the start have gone by, or a signal arrives. Returns at
    /// once if they have.
    pub fn sleep_until(&self, time: u64) {
        sleep_until(self.start + time);
    }
}

/// Sleeps for so many nanoseconds, or until a signal arrives.
pub(crate) fn sleep(time: u64) {
    sleep_until(now() + time);
}

/// Waits while a number is `value`, for three seconds at most: as long as a device on the network takes to be opened. Returns the number.
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
    fn sleeps_until_then_and_not_at_all_when_late() {
        let clock = Clock::start();
        clock.sleep_until(SECOND / 20);
        assert!(clock.time() >= SECOND / 20);
        clock.sleep_until(SECOND / 100);
        assert!(
            clock.time() < 5 * SECOND,
            "it must not sleep once the time is past"
        );
    }
}
