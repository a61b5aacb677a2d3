//! Files, signals and the start of a process on Unix.

use core::{
    ffi::{CStr, c_int, c_short},
    mem::zeroed,
    ptr::null_mut,
    sync::atomic::{AtomicU32, Ordering::Relaxed},
};

use crate::{line, terminal};

/// The number of standard output.
pub const OUTPUT: c_int = libc::STDOUT_FILENO;
/// The number of standard error.
pub const ERROR: c_int = libc::STDERR_FILENO;

/// The least bytes of stack to start with. Drawing takes 56 kB of each thread's; the rest is for libraries.
const STACK: libc::rlim_t = 96 << 10;

/// Prepares the process: a broken pipe is an error of the write, not a signal, and the standard streams are open. Ends it where it
/// has so little stack that it would end without a word.
///
/// # Safety
/// No other thread may be running yet.
pub unsafe fn start() {
    // SAFETY: nobody relies on what is done on SIGPIPE.
    unsafe { terminal::on_signal(libc::SIGPIPE, libc::SIG_IGN) };
    // One heap for all threads: glibc reserves 64 MB of addresses for a thread's own.
    // SAFETY: it may be called at any time.
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    unsafe {
        libc::mallopt(libc::M_ARENA_MAX, 1)
    };
    // What is closed of standard input, output and error gets something that is open for reading only, so that no file or display
    // opened later takes its number and is written to by mistake: writing fails, as it would have when closed. One more stays
    // open, as the sign that the first three are.
    while (0..=2).contains(&open(c"/dev/null")) {}
    // SAFETY: zero is a value of both fields of the limit, which outlives the call.
    unsafe {
        let mut stack: libc::rlimit = zeroed();
        libc::getrlimit(libc::RLIMIT_STACK, &mut stack);
        if stack.rlim_cur < STACK {
            line::complain(format_args!("it takes 96 kB of stack"));
            libc::_exit(1);
        }
    }
}

/// How often the process has gone on after a stop.
static STOPS: AtomicU32 = AtomicU32::new(0);

extern "C" fn go_on(_: c_int) {
    STOPS.fetch_add(1, Relaxed);
    terminal::resume();
}

/// Counts stops from now on, as by Ctrl-Z or SIGSTOP, and takes the terminal again after each.
pub fn heed_stops() {
    // SAFETY: the function does only what a signal's function may.
    unsafe { terminal::on_signal(libc::SIGCONT, go_on as extern "C" fn(c_int) as _) };
}

/// How often the process was stopped.
pub fn stops() -> u32 {
    STOPS.load(Relaxed)
}

/// Starts something, such as a thread, that signals do not go to.
pub fn without_signals<T>(start: impl FnOnce() -> T) -> T {
    // SAFETY: zero is a value of a set of signals, and the sets outlive the calls.
    unsafe {
        let [mut all, mut before]: [libc::sigset_t; 2] = zeroed();
        libc::sigfillset(&mut all);
        libc::pthread_sigmask(libc::SIG_SETMASK, &all, &mut before);
        let started = start();
        libc::pthread_sigmask(libc::SIG_SETMASK, &before, null_mut());
        started
    }
}

/// Whether a file descriptor is a terminal.
pub fn is_terminal(file: c_int) -> bool {
    terminal::mode(file).is_some()
}

/// Writes everything to a file descriptor, waiting while it is full. False if that fails, if a signal that ends the program
/// arrives meanwhile, or, once there is a [`Terminal`](crate::terminal::Terminal), if it is full for a second.
pub fn write(file: c_int, mut bytes: &[u8]) -> bool {
    while !bytes.is_empty() {
        let written = write_some(file, bytes);
        if written > 0 {
            bytes = &bytes[written as usize..];
            continue;
        }
        match error() {
            libc::EINTR | libc::EAGAIN
                if terminal::signal() == 0
                    && is_ready(file, libc::POLLOUT, terminal::patience()) => {}
            _ => return false,
        }
    }
    true
}

/// Opens a file for reading. Its descriptor, or -1.
pub fn open(path: &CStr) -> c_int {
    // SAFETY: the path outlives the call.
    unsafe { libc::open(path.as_ptr(), libc::O_RDONLY | libc::O_CLOEXEC) }
}

/// Writes some bytes to a file descriptor, and returns how many, or -1.
fn write_some(file: c_int, bytes: &[u8]) -> isize {
    // SAFETY: the pointer and the length are those of a slice.
    unsafe { libc::write(file, bytes.as_ptr().cast(), bytes.len()) }
}

/// Why the last call of this thread failed.
pub fn error() -> c_int {
    // SAFETY: errno is this thread's own.
    #[cfg(target_os = "linux")]
    return unsafe { *libc::__errno_location() };
    #[cfg(not(target_os = "linux"))]
    std::io::Error::last_os_error().raw_os_error().unwrap_or(0)
}

/// Waits until one of some events is there, such as `POLLIN`, that a file has something to read, or so many milliseconds; without
/// end if they are negative. False if there is none still.
pub fn is_ready(file: c_int, events: c_short, milliseconds: c_int) -> bool {
    let mut ready = libc::pollfd {
        fd: file,
        events,
        revents: 0,
    };
    // SAFETY: there is one of them.
    unsafe { libc::poll(&mut ready, 1, milliseconds) != 0 }
}

/// Has writing to a terminal not wait for room any more, for this process alone: others that have the same terminal wait as
/// before. Does nothing if the terminal can't be opened by this path of its descriptor.
pub fn never_wait(file: c_int, path: &CStr) {
    let flags = libc::O_WRONLY | libc::O_NONBLOCK | libc::O_NOCTTY | libc::O_CLOEXEC;
    // SAFETY: the path outlives the call.
    unsafe {
        let own = libc::open(path.as_ptr(), flags);
        libc::dup2(own, file);
    }
}
