//! The qualities that have a name.

use eightfold_tracer::Quality;

/// The number of rungs of the ladder.
const RUNGS: usize = Quality::LADDER.len();

/// The named qualities. First comes the ladder, from the finest rung to the fastest, so that a rung's number is its index here;
/// then the two qualities that the ladder is compared with.
pub static NAMED: [(&str, Quality); RUNGS + 2] = {
    let mut named = [("exhaustive", Quality::EXHAUSTIVE); _];
    named[RUNGS] = ("thesis", Quality::THESIS);
    let mut rung = 0;
    while rung < RUNGS {
        named[rung] = (Quality::NAMES[rung], Quality::LADDER[rung]);
        rung += 1;
    }
    named
};

/// The index in [`NAMED`] of the quality for stills and for `--uncapped`, unless another is named.
pub const DEFAULT: usize = Quality::DEFAULT_RUNG;

/// The index in [`NAMED`] of the quality that traces every pixel.
pub const EXHAUSTIVE: usize = RUNGS + 1;

/// The index in [`NAMED`] of a quality by its name.
pub fn find(name: &str) -> Option<usize> {
    NAMED.iter().position(|&(known, _)| known == name)
}
