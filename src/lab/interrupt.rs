//! Signals that ask a command to end, such as that of Ctrl-C. A command that [listens](listen) ends early after the first one and
//! writes its results so far. Another one, and the first for other commands, ends the program at once, with one line and without
//! a part of a file left.

use crate::output;
use eightfold_window::is_signal_ignored;
use signal_hook::{consts, flag, iterator::Signals, low_level};
use std::fmt;
use std::io;
use std::process::{Child, ExitStatus};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::SeqCst};
use std::sync::{Arc, LazyLock};
use std::thread;
use std::time::Duration;

/// The last signal that asked for the end, or 0.
static SIGNAL: LazyLock<Arc<AtomicUsize>> = LazyLock::new(Arc::default);

/// Whether the next one ends the program at once.
static ENDS: AtomicBool = AtomicBool::new(true);

/// The signals that ask for the end.
const SIGNALS: [i32; 3] = [consts::SIGINT, consts::SIGTERM, consts::SIGHUP];

/// Has these signals end the program with a line, from its start on. One that the program was started to ignore, as `nohup` has it
/// ignore the end of its terminal, stays ignored.
///
/// # Errors
/// If the system refuses.
pub fn watch() -> io::Result<()> {
    let heard = SIGNALS.into_iter();
    let heard: Vec<i32> = heard.filter(|&signal| !is_signal_ignored(signal)).collect();
    // First what the thread hears, so that it misses none.
    let mut signals = Signals::new(&heard)?;
    for signal in heard {
        flag::register_usize(signal, Arc::clone(&SIGNAL), signal as usize)?;
    }
    let wait = move || {
        for signal in signals.forever() {
            SIGNAL.store(signal as usize, SeqCst);
            if ENDS.swap(true, SeqCst) {
                end(signal);
            }
        }
    };
    thread::Builder::new().spawn(wait).map(drop)
}

/// Ends the program.
fn end(signal: i32) -> ! {
    output::discard();
    if !output::is_quiet() {
        eprintln!("error: stopped at once; what was not complete is left as it was");
    }
    low_level::exit(128 + signal)
}

/// From here on the first signal that asks for the end does nothing but set a flag, see [`is_stopped`].
pub fn listen() {
    if !is_stopped() {
        ENDS.store(false, SeqCst);
    }
}

/// Whether the command has to end.
pub fn is_stopped() -> bool {
    SIGNAL.load(SeqCst) != 0
}

/// How often another program is asked whether it has ended: hardly any work beside what it does.
const INTERVAL: Duration = Duration::from_millis(50);

/// Waits for the end of another program, and ends it where the command has to end.
///
/// # Errors
/// If the system loses it.
pub fn wait(child: &mut Child) -> io::Result<ExitStatus> {
    loop {
        if is_stopped() {
            // It may have ended already.
            let _ = child.kill();
        }
        match child.try_wait()? {
            Some(status) => return Ok(status),
            None => thread::sleep(INTERVAL),
        }
    }
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
