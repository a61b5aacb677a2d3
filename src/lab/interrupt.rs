use crate::arguments::Exit;
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use signal_hook::flag;
use std::fs;
use std::sync::atomic::{AtomicBool, Ordering::SeqCst};
use std::sync::{Arc, LazyLock};

static STOPPED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

const EXIT_CODE: u8 = 128 + SIGINT as u8;

/// Makes the first signal set a flag and the second end the program, except SIGHUP, which both a
/// terminal and its shell send.
pub fn listen() {
    for signal in [SIGINT, SIGTERM] {
        let exits = flag::register_conditional_shutdown(signal, EXIT_CODE.into(), STOPPED.clone());
        let stops = flag::register(signal, STOPPED.clone());
        exits.and(stops).expect("the signal can be handled");
    }
    if !ignores_hang_up() {
        flag::register(SIGHUP, STOPPED.clone()).expect("the signal can be handled");
    }
}

fn ignores_hang_up() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok());
    ignored.unwrap_or(0) >> (SIGHUP - 1) & 1 != 0
}

pub fn is_stopped() -> bool {
    STOPPED.load(SeqCst)
}

pub fn check(results: &str) -> Result<(), Exit> {
    if is_stopped() {
        return Err(Exit::new(EXIT_CODE, format!("interrupted; {results}")));
    }
    Ok(())
}
