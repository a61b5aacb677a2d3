use super::functions::{QueryPerformanceCounter, QueryPerformanceFrequency, Sleep};
use crate::clock::SECOND;

const MILLISECOND: u64 = SECOND / 1000;

/// The maximum duration of a sleep in milliseconds: a day.
const LONGEST: u64 = 86_400_000;

/// Sleeps up to 2 ms longer, as Windows sleeps in milliseconds.
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

pub fn now() -> u64 {
    let [mut count, mut rate] = [0; 2];
    // SAFETY: the results are writable.
    unsafe {
        QueryPerformanceCounter(&mut count);
        QueryPerformanceFrequency(&mut rate);
    }
    count / rate * SECOND + count % rate * SECOND / rate
}
