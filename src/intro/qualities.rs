//! The qualities that can be asked for by name.

use core::array;

use eightfold::Quality;

/// How many there are.
pub const COUNT: usize = Quality::LADDER.len() + 2;

/// The number of the quality that traces every pixel.
pub const EXHAUSTIVE: usize = COUNT - 1;

/// The qualities and their names: the ladder, from the finest rung to the fastest, so that a rung's number is that of its
/// quality; then the two that the ladder is compared with.
pub fn all() -> [(&'static str, Quality); COUNT] {
    let ladder = Quality::NAMES
        .split(' ')
        .zip(Quality::LADDER.iter().copied());
    let compared = [
        ("thesis", Quality::THESIS),
        ("exhaustive", Quality::EXHAUSTIVE),
    ];
    let mut named = ladder.chain(compared);
    array::from_fn(|_| named.next().expect("as many as are counted"))
}

/// The number of the quality with a name.
pub fn find(name: &str) -> Option<usize> {
    all().iter().position(|&(known, _)| known == name)
}
