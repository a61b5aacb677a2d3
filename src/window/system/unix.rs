use core::ffi::{CStr, c_int, c_short};
use core::mem::zeroed;
use core::ptr::null_mut;
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};

use crate::{line, terminal};

pub const OUTPUT: c_int = libc::STDOUT_FILENO;
pub const ERROR: c_int = libc::STDERR_FILENO;

/// The minimum stack in bytes. Drawing takes 56 kB of each thread's stack; the rest is for
/// libraries.
const STACK: libc::rlim_t = 96 << 10;

/// Prepares signals and standard streams. Ends the process with a message if the stack is too
/// small.
///
/// # Safety
/// No other thread may be running.
pub unsafe fn start() {
    // SAFETY: nothing relies on the action of SIGPIPE.
    unsafe { terminal::on_signal(libc::SIGPIPE, libc::SIG_IGN) };
    // One heap for all threads, since glibc reserves 64 MB of addresses for each additional one.
    // SAFETY: it may be called at any time.
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    unsafe {
        libc::mallopt(libc::M_ARENA_MAX, 1)
    };
    // Opens closed standard streams for reading, so that later files get numbers above 2.
    while (0..=2).contains(&open(c"/dev/null")) {}
    // SAFETY: zero is valid for both fields of the limit, which outlives the call.
    unsafe {
        let mut stack: libc::rlimit = zeroed();
        libc::getrlimit(libc::RLIMIT_STACK, &mut stack);
        if stack.rlim_cur < STACK {
            line::complaint()
                .format("stack limit in kB is #; must be 96 or more\n", &[stack.rlim_cur >> 10])
                .flush();
            libc::_exit(1);
        }
    }
}

static STOPS: AtomicU32 = AtomicU32::new(0);

extern "C" fn go_on(_: c_int) {
    STOPS.fetch_add(1, Relaxed);
    terminal::resume();
}

/// Counts stops from now on, as by Ctrl-Z or SIGSTOP, and takes the terminal over again after each.
pub fn heed_stops() {
    // SAFETY: the function is async-signal-safe.
    unsafe { terminal::on_signal(libc::SIGCONT, go_on as extern "C" fn(c_int) as _) };
}

pub fn stops() -> u32 {
    STOPS.load(Relaxed)
}

/// Calls a function with all signals blocked: the threads that it starts inherit this.
pub fn without_signals<T>(start: impl FnOnce() -> T) -> T {
    // SAFETY: zero is a valid set of signals, and the sets outlive the calls.
    unsafe {
        let [mut all, mut before]: [libc::sigset_t; 2] = zeroed();
        libc::sigfillset(&mut all);
        libc::pthread_sigmask(libc::SIG_SETMASK, &all, &mut before);
        let started = start();
        libc::pthread_sigmask(libc::SIG_SETMASK, &before, null_mut());
        started
    }
}

#[must_use]
#[inline(never)]
pub fn is_terminal(file: c_int) -> bool {
    terminal::mode(file).is_some()
}

/// Writes all bytes. Waits while the file is full, with a [`Terminal`](crate::terminal::Terminal)
/// for at most a second. Returns false on an error or a signal.
pub fn write(file: c_int, mut bytes: &[u8]) -> bool {
    while !bytes.is_empty() {
        // SAFETY: pointer and length are from a slice.
        let written = unsafe { libc::write(file, bytes.as_ptr().cast(), bytes.len()) };
        if written > 0 {
            bytes = &bytes[written as usize..];
            continue;
        }
        match error() {
            libc::EINTR | libc::EAGAIN
                if terminal::SIGNAL.load(Relaxed) == 0
                    && is_ready(file, libc::POLLOUT, terminal::PATIENCE.load(Relaxed)) => {}
            _ => return false,
        }
    }
    true
}

pub fn open(path: &CStr) -> c_int {
    // SAFETY: the path outlives the call.
    unsafe { libc::open(path.as_ptr(), libc::O_RDONLY | libc::O_CLOEXEC) }
}

pub fn error() -> c_int {
    // SAFETY: errno is thread-local.
    #[cfg(target_os = "linux")]
    return unsafe { *libc::__errno_location() };
    #[cfg(not(target_os = "linux"))]
    std::io::Error::last_os_error().raw_os_error().unwrap_or(0)
}

/// Waits for one of `events` for at most `milliseconds`, or indefinitely if negative. Returns
/// whether one occurred.
pub fn is_ready(file: c_int, events: c_short, milliseconds: c_int) -> bool {
    let mut ready = libc::pollfd { fd: file, events, revents: 0 };
    // SAFETY: there is one entry.
    unsafe { libc::poll(&mut ready, 1, milliseconds) != 0 }
}

/// Makes writes to a terminal non-blocking, for this process only, if the path of the descriptor
/// can be opened.
pub fn never_wait(file: c_int, path: &CStr) {
    let flags = libc::O_WRONLY | libc::O_NONBLOCK | libc::O_NOCTTY | libc::O_CLOEXEC;
    // SAFETY: the path outlives the call.
    unsafe {
        let own = libc::open(path.as_ptr(), flags);
        libc::dup2(own, file);
    }
}
