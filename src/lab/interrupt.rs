//! Ends a command early on Ctrl-C, with its results so far.

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering::SeqCst};
use std::sync::{Arc, LazyLock};

/// Whether a signal asked for the end.
static STOPPED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// The exit code of a command that ended early: by the convention of shells, 128 and the number of Ctrl-C's signal.
pub const EXIT_CODE: u8 = 128 + SIGINT as u8;

/// From here on the first signal that asks for the end sets a flag, see [`is_stopped`]; the second one ends the program.
///
/// # Panics
/// If the system refuses.
pub fn listen() {
    for signal in [SIGINT, SIGTERM] {
        let exits = flag::register_conditional_shutdown(signal, EXIT_CODE.into(), STOPPED.clone());
        let stops = flag::register(signal, STOPPED.clone());
        exits.and(stops).expect("the signal can be handled");
    }
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
