use core::ptr::null_mut;

use crate::clock::SECOND;

#[inline(never)]
pub fn sleep_until(end: u64) {
    let end = libc::timespec {
        tv_sec: (end / SECOND) as libc::time_t,
        tv_nsec: (end % SECOND) as libc::c_long,
    };
    // SAFETY: the time outlives the call, and null is allowed.
    unsafe {
        libc::clock_nanosleep(libc::CLOCK_MONOTONIC, libc::TIMER_ABSTIME, &end, null_mut());
    }
}

pub fn now() -> u64 {
    let mut now = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: `now` is writable.
    unsafe { libc::clock_gettime(libc::CLOCK_MONOTONIC, &mut now) };
    now.tv_sec as u64 * SECOND + now.tv_nsec as u64
}
