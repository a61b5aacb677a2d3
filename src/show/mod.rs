//! What is played, as a function of time.

mod colonnade;
mod field;
mod finale;
pub mod grid;
mod letters;
mod machine;
mod material;
mod model;
mod path;
mod random;
mod swarm;
mod title;

pub use field::field;
pub use model::{LENGTH, scene};

use crate::scene::Scene;
use grid::{BAR, BARS, BEAT, CUTS};

/// The scene of the show at `time` seconds, 0 to [`grid::LENGTH`].
#[must_use]
pub fn at(time: f32) -> Scene {
    let bar = time / BAR;
    let number = CUTS.iter().rposition(|&cut| cut as f32 <= bar).unwrap_or(0);
    let start = CUTS[number] as f32;
    let end = CUTS.get(number + 1).map_or(BARS, |&cut| cut) as f32;
    let u = (bar - start) / (end - start);
    let beat = (bar - start) * (BAR / BEAT);
    match number {
        0 => title::scene(u),
        1 | 2 => scene(beat * BEAT),
        3 => colonnade::scene(u, beat),
        4 => machine::scene(u, beat),
        5 => swarm::scene(u, beat),
        _ => finale::scene(u, beat),
    }
}
