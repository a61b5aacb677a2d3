//! The qualities that can be asked for by name.

use eightfold::Quality;

/// The qualities and their names: the ladder, from the finest rung to the fastest, so that a rung's number is that of its
/// quality; then the two that the ladder is compared with.
pub static NAMED: [(&str, Quality); 9] = [
    ("finest", Quality::LADDER[0]),
    ("finer", Quality::LADDER[1]),
    ("fine", Quality::LADDER[2]),
    ("default", Quality::DEFAULT),
    ("fast", Quality::LADDER[4]),
    ("faster", Quality::LADDER[5]),
    ("fastest", Quality::LADDER[6]),
    ("thesis", Quality::THESIS),
    ("exhaustive", Quality::EXHAUSTIVE),
];

/// The number in [`NAMED`] of what is played without a pause if nothing is said.
pub const DEFAULT: usize = 3;

/// The number in [`NAMED`] of the quality that traces every pixel.
pub const EXHAUSTIVE: usize = 8;

/// The number of the quality with a name.
pub fn find(name: &str) -> Option<usize> {
    NAMED.iter().position(|&(known, _)| known == name)
}
