//! The machine on which is measured.

use std::fs;
use std::thread::available_parallelism;

/// The processor's name, if the system tells it, and the number of processors.
pub fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let models = info.lines().filter_map(|line| line.split_once(':'));
    let model = models
        .filter(|(name, _)| name.trim() == "model name")
        .map(|(_, model)| model.trim())
        .next()
        .unwrap_or("unknown processor");
    let count = available_parallelism().map_or(1, usize::from);
    format!(
        "{model}, {count} processor{}",
        if count == 1 { "" } else { "s" }
    )
}
