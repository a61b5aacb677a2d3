//! The system's clock that only goes forward, in nanoseconds.

use super::functions::{QueryPerformanceCounter, QueryPerformanceFrequency, Sleep};
use crate::clock::SECOND;

/// Nanoseconds.
const MILLISECOND: u64 = SECOND / 1000;

/// Milliseconds that it sleeps at a time: a day.
const LONGEST: u64 = 86_400_000;

/// Sleeps until a time, and up to a millisecond or two longer: Windows sleeps by whole ones.
pub fn sleep_until(end: u64) {
    loop {
        let left = end.saturating_sub(now());
        if left == 0 {
            return;
        }
        // SAFETY: it may be called at any time.
        unsafe { Sleep((left / MILLISECOND).min(LONGEST) as u32 + 1) };
    }
}

/// The time now.
pub fn now() -> u64 {
    let [mut count, mut rate] = [0; 2];
    // SAFETY: there is room for the answers.
    unsafe {
        QueryPerformanceCounter(&mut count);
        QueryPerformanceFrequency(&mut rate);
    }
    count / rate * SECOND + count % rate * SECOND / rate
}
