//! Time that only goes forward, in nanoseconds.

use core::ptr::null_mut;

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

fn sleep_until(end: u64) {
    let end = libc::timespec {
        tv_sec: (end / SECOND) as libc::time_t,
        tv_nsec: (end % SECOND) as libc::c_long,
    };
    // SAFETY: the time outlives the call, and nothing is written to the null pointer.
    unsafe {
        libc::clock_nanosleep(libc::CLOCK_MONOTONIC, libc::TIMER_ABSTIME, &end, null_mut());
    }
}

fn now() -> u64 {
    let mut now = libc::timespec {
        tv_sec: 0,
        tv_nsec: 0,
    };
    // SAFETY: `now` is there to be written to.
    unsafe { libc::clock_gettime(libc::CLOCK_MONOTONIC, &mut now) };
    now.tv_sec as u64 * SECOND + now.tv_nsec as u64
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
