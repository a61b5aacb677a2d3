//! Ctrl-C: what is at work ends early and writes what it has; the second time the program ends at once.

use std::fmt;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering::SeqCst};

static STOPPED: AtomicBool = AtomicBool::new(false);

/// Exit code of a program ended by Ctrl-C, as shells have it.
pub const EXIT_CODE: u8 = 130;

/// From here on Ctrl-C, or being asked to end, is noted and not obeyed at once.
pub fn listen() {
    // It fails only where it has been called before.
    let _ = ctrlc::set_handler(|| {
        if STOPPED.swap(true, SeqCst) {
            process::exit(i32::from(EXIT_CODE));
        }
    });
}

/// Whether it is time to end.
pub fn is_stopped() -> bool {
    STOPPED.load(SeqCst)
}

/// Says that what was asked for was not done to its end, and what is left of it.
#[derive(Debug)]
pub struct Stopped(pub String);

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "stopped early; {}", self.0)
    }
}

impl std::error::Error for Stopped {}
