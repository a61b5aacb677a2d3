//! Signals that ask a command to end, such as that of Ctrl-C: the first one makes it end early and write its results so far, the
//! second one ends the program at once.

use std::fmt;
use std::io;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::SeqCst};
use std::sync::{Arc, LazyLock};

use eightfold_window::is_signal_ignored;
use signal_hook::{consts, flag};

/// The last signal that asked for the end, or 0.
static SIGNAL: LazyLock<Arc<AtomicUsize>> = LazyLock::new(Arc::default);

/// The signals that ask for the end.
#[cfg(unix)]
const SIGNALS: [i32; 3] = [consts::SIGINT, consts::SIGTERM, consts::SIGHUP];
#[cfg(not(unix))]
const SIGNALS: [i32; 2] = [consts::SIGINT, consts::SIGTERM];

/// From here on the first signal that asks for the end only sets a flag, see [`is_stopped`]. One that the program was started to
/// ignore, as `nohup` has it ignore the end of its terminal, stays ignored. Another call changes nothing.
///
/// # Errors
/// If the system refuses.
pub fn listen() -> io::Result<()> {
    static IS_LISTENING: AtomicBool = AtomicBool::new(false);
    if IS_LISTENING.swap(true, SeqCst) {
        return Ok(());
    }
    let is_stopped = Arc::new(AtomicBool::new(false));
    for signal in SIGNALS {
        if is_signal_ignored(signal) {
            continue;
        }
        // In this order: the first signal finds the flag unset.
        flag::register_conditional_shutdown(signal, 128 + signal, Arc::clone(&is_stopped))?;
        flag::register(signal, Arc::clone(&is_stopped))?;
        flag::register_usize(signal, Arc::clone(&SIGNAL), signal as usize)?;
    }
    Ok(())
}

/// Whether the command has to end.
pub fn is_stopped() -> bool {
    SIGNAL.load(SeqCst) != 0
}

/// The exit code of a command that ended early, by the convention of shells: 128 and the signal's number.
pub fn exit_code() -> i32 {
    128 + SIGNAL.load(SeqCst) as i32
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
