//! The terminal's mode and alternate screen, taken over and restored, also after signals.

use core::cell::UnsafeCell;
use core::ffi::c_int;
use core::mem::{MaybeUninit, zeroed};
use core::ptr::null_mut;
use core::sync::atomic::{AtomicBool, AtomicI32, Ordering::*};

use libc::{
    SIGABRT, SIGBUS, SIGCHLD, SIGCONT, SIGFPE, SIGILL, SIGPIPE, SIGSEGV, SIGSYS, SIGTRAP, SIGTSTP,
    SIGTTIN, SIGTTOU, SIGURG, SIGWINCH,
};

use crate::{cpu::bits, line, system};

/// Switches to the alternate screen, hides the cursor, and disables wrapping at the right edge.
const ENTER: &[u8] = b"\x1b[?1049h\x1b[?25l\x1b[?7l\x1b[2J";

/// Reverts [`ENTER`] and resets the colours.
const LEAVE: &[u8] = b"\x1b[0m\x1b[?7h\x1b[?25h\x1b[?1049l";

/// Signals that do not end a process. Bit 0 stands for signal 64.
const HARMLESS: u64 =
    bits(&[SIGPIPE, SIGCHLD, SIGCONT, SIGTSTP, SIGTTIN, SIGTTOU, SIGURG, SIGWINCH]);

/// Signals of errors in the process, which cannot continue.
const MISTAKES: u64 = bits(&[SIGILL, SIGTRAP, SIGABRT, SIGBUS, SIGFPE, SIGSEGV, SIGSYS]);

pub struct Saved {
    active: AtomicBool,
    /// One more than the descriptor of the keyboard's terminal, or 0.
    keyboard: AtomicI32,
    mode: UnsafeCell<MaybeUninit<libc::termios>>,
}

// SAFETY: `mode` is written before `active` is set, and only read afterwards.
unsafe impl Sync for Saved {}

pub static SAVED: Saved = Saved {
    active: AtomicBool::new(false),
    keyboard: AtomicI32::new(0),
    mode: UnsafeCell::new(MaybeUninit::uninit()),
};

/// The signal that asked a process with a [`Terminal`] to end, or 0.
pub static SIGNAL: AtomicI32 = AtomicI32::new(0);

/// The timeout of a blocked write in milliseconds: infinite (-1), or a second for a [`Terminal`].
pub static PATIENCE: AtomicI32 = AtomicI32::new(-1);

extern "C" fn note(signal: c_int) {
    if MISTAKES >> (signal % 64) & 1 == 0 {
        SIGNAL.store(signal, Relaxed);
        return;
    }
    restore();
    // SAFETY: signal handlers may call both. The signal is delivered again when this handler has
    // returned.
    unsafe {
        on_signal(signal, libc::SIG_DFL);
        libc::raise(signal);
    }
}

/// Sets a signal's action.
///
/// # Safety
/// The action has to be `SIG_IGN`, `SIG_DFL`, or a function that is async-signal-safe.
#[inline(never)]
pub unsafe fn on_signal(signal: c_int, action: libc::sighandler_t) {
    // SAFETY: zero is valid for all fields. Without SA_RESTART, signals interrupt blocked writes.
    unsafe {
        let mut change: libc::sigaction = zeroed();
        change.sa_sigaction = action;
        libc::sigaction(signal, &change, null_mut());
    }
}

pub fn mode(file: c_int) -> Option<libc::termios> {
    // SAFETY: zero is valid for all fields.
    let mut mode: libc::termios = unsafe { zeroed() };
    // SAFETY: `mode` is writable.
    let is_known = unsafe { libc::tcgetattr(file, &mut mode) } == 0;
    is_known.then_some(mode)
}

fn set_mode(file: c_int, mode: &libc::termios) {
    // SAFETY: the mode outlives the call.
    unsafe { libc::tcsetattr(file, libc::TCSAFLUSH, mode) };
}

impl Saved {
    pub fn keyboard(&self) -> c_int {
        self.keyboard.load(Acquire) - 1
    }

    pub fn take_over(&self) {
        // SAFETY: `note` is async-signal-safe. `mode` is written while `active` is not set.
        unsafe {
            // The last are real-time signals; invalid numbers are refused.
            for signal in (1..65).filter(|signal| HARMLESS >> (signal % 64) & 1 == 0) {
                on_signal(signal, note as extern "C" fn(c_int) as libc::sighandler_t);
            }
            PATIENCE.store(1000, Relaxed);
            system::never_wait(line::OUTPUT, c"/dev/stdout");
            if line::is_terminal(line::ERROR) {
                system::never_wait(line::ERROR, c"/dev/stderr");
            }
            let mut keyboard = libc::STDIN_FILENO;
            if !line::is_terminal(keyboard) {
                keyboard = system::open(c"/dev/tty");
            }
            if let Some(mode) = mode(keyboard) {
                (*self.mode.get()).write(mode);
                self.keyboard.store(keyboard + 1, Relaxed);
            }
        }
        self.active.store(true, Release);
        self.enter();
    }

    fn mode(&self) -> Option<libc::termios> {
        // SAFETY: `keyboard` is set after `mode`.
        (self.keyboard() >= 0).then(|| unsafe { (*self.mode.get()).assume_init() })
    }

    #[inline(never)]
    fn enter(&self) {
        if let Some(mut mode) = self.mode() {
            // Keys without delay and echo, including Ctrl-C.
            mode.c_lflag &= !(libc::ICANON | libc::ECHO | libc::ISIG | libc::IEXTEN);
            mode.c_iflag &= !libc::IXON;
            set_mode(self.keyboard(), &mode);
        }
        line::write(line::OUTPUT, ENTER);
    }
}

/// Takes the terminal over again after a stop. Async-signal-safe.
pub fn resume() {
    if SAVED.active.load(Acquire) {
        SAVED.enter();
    }
}

/// Restores the terminal, if it was taken over. Async-signal-safe.
#[inline(never)]
pub fn restore() {
    if SAVED.active.swap(false, AcqRel) {
        // A pending signal must not interrupt these writes.
        SIGNAL.store(0, Relaxed);
        line::write(line::OUTPUT, LEAVE);
        if let Some(mode) = SAVED.mode() {
            set_mode(SAVED.keyboard(), &mode);
        }
    }
}
