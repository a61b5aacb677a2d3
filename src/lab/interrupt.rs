//! Ctrl-C: the first one makes a command end early and write its results so far, the second one ends the program at once.

use std::fmt;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering::SeqCst};

static STOPPED: AtomicBool = AtomicBool::new(false);

/// The exit code after Ctrl-C, by the convention of shells.
pub const EXIT_CODE: u8 = 130;

/// From here on Ctrl-C and SIGTERM only set a flag, see [`is_stopped`].
pub fn listen() {
    // It can only fail if it has been called before.
    let _ = ctrlc::set_handler(|| {
        if STOPPED.swap(true, SeqCst) {
            process::exit(i32::from(EXIT_CODE));
        }
    });
}

/// Whether the command has to end.
pub fn is_stopped() -> bool {
    STOPPED.load(SeqCst)
}

/// The error of a command that ended early. It says where the results so far are.
#[derive(Debug)]
pub struct Stopped(pub String);

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "stopped early; {}", self.0)
    }
}

impl std::error::Error for Stopped {}
