use eightfold_tracer::Quality;

const PRESETS: usize = Quality::LADDER.len();

/// The presets from the finest to the fastest, then two for comparison.
pub static NAMED: [(&str, Quality); PRESETS + 2] = {
    let mut named = [("exhaustive", Quality::EXHAUSTIVE); _];
    named[PRESETS] = ("thesis", Quality::THESIS);
    let mut preset = 0;
    while preset < PRESETS {
        named[preset] = (Quality::NAMES[preset], Quality::LADDER[preset]);
        preset += 1;
    }
    named
};

/// The index in [`NAMED`] of the quality for stills and for `--uncapped`, unless another is named.
pub const DEFAULT: usize = Quality::DEFAULT_PRESET;

pub const EXHAUSTIVE: usize = PRESETS + 1;

pub fn find(name: &[u8]) -> Option<usize> {
    NAMED.iter().position(|&(known, _)| known.as_bytes() == name)
}
