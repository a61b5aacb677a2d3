//! The qualities that have a name.

use eightfold::Quality;

/// The named qualities. First comes the ladder, from the finest rung to the fastest, so that a rung's number is its index here;
/// then the two qualities that the ladder is compared with.
pub static NAMED: [(&str, Quality); 9] = [
    (Quality::NAMES[0], Quality::LADDER[0]),
    (Quality::NAMES[1], Quality::LADDER[1]),
    (Quality::NAMES[2], Quality::LADDER[2]),
    (Quality::NAMES[3], Quality::LADDER[3]),
    (Quality::NAMES[4], Quality::LADDER[4]),
    (Quality::NAMES[5], Quality::LADDER[5]),
    (Quality::NAMES[6], Quality::LADDER[6]),
    ("thesis", Quality::THESIS),
    ("exhaustive", Quality::EXHAUSTIVE),
];

/// The index in [`NAMED`] of the quality for stills and for `--uncapped`, unless another is named.
pub const DEFAULT: usize = 3;

/// The index in [`NAMED`] of the quality that traces every pixel.
pub const EXHAUSTIVE: usize = 8;

/// The index in [`NAMED`] of a quality by its name.
pub fn find(name: &str) -> Option<usize> {
    NAMED.iter().position(|&(known, _)| known == name)
}
