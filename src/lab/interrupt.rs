use crate::arguments::Exit;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::sync::atomic::{AtomicBool, Ordering::SeqCst};
use std::sync::{Arc, LazyLock};

static STOPPED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// The exit code of an interrupted program in shells.
const EXIT_CODE: u8 = 128 + SIGINT as u8;

/// Makes the first signal set a flag and the second end the program. Panics if the system refuses.
pub fn listen() {
    for signal in [SIGINT, SIGTERM] {
        let exits = flag::register_conditional_shutdown(signal, EXIT_CODE.into(), STOPPED.clone());
        let stops = flag::register(signal, STOPPED.clone());
        exits.and(stops).expect("the signal can be handled");
    }
}

pub fn is_stopped() -> bool {
    STOPPED.load(SeqCst)
}

/// Returns an error after a signal.
pub fn check(results: &str) -> Result<(), Exit> {
    if is_stopped() {
        return Err(Exit::new(EXIT_CODE, format!("interrupted; {results}")));
    }
    Ok(())
}
