//! The scenes of the show, a file for each, and the list of them in the order in which they are played.
//!
//! How long the show is, where its cuts are and what its scenes are called follows from the list and from their shots.

mod colonnade;
mod finale;
mod flake;
mod machine;
mod method;
mod mirrors;
pub(super) mod model;
mod swarm;
mod title;

use super::act::Act;
use crate::grid::BAR;
use crate::sound;

/// The scenes in the order in which they are played, with their names.
const SCENES: &[(&str, Act)] = &[
    ("title", title::ACT),
    ("model", model::ACT),
    ("method", method::ACT),
    ("colonnade", colonnade::ACT),
    ("machine", machine::ACT),
    ("flake", flake::ACT),
    ("mirrors", mirrors::ACT),
    ("swarm", swarm::ACT),
    ("finale", finale::ACT),
];

/// The names of the show's scenes, in the order in which they are played.
pub const NAMES: [&str; SCENES.len()] = {
    let mut names = [""; SCENES.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = SCENES[i].0;
        i += 1;
    }
    names
};

/// The scenes themselves. The intro does without their names.
pub(super) static ACTS: [Act; SCENES.len()] = {
    let mut acts = [title::ACT; SCENES.len()];
    let mut i = 0;
    while i < acts.len() {
        acts[i] = SCENES[i].1;
        i += 1;
    }
    acts
};

/// The bars at which these scenes begin, counted from 0. The last one ends with the show.
pub const CUTS: [u32; ACTS.len()] = {
    let mut cuts = [0; ACTS.len()];
    let mut i = 1;
    while i < cuts.len() {
        cuts[i] = cuts[i - 1] + ACTS[i - 1].bars();
        i += 1;
    }
    cuts
};

/// The length of the show in bars.
pub const BARS: u32 = CUTS[ACTS.len() - 1] + ACTS[ACTS.len() - 1].bars();

const _: () = assert!(
    BARS == sound::BARS,
    "the song has as many bars as the show's scenes"
);

/// The length of the show in seconds.
pub const LENGTH: f32 = BAR * BARS as f32;

/// The bar at which the scene of a name begins.
///
/// # Panics
///
/// If there is no such scene.
#[must_use]
pub fn cut(name: &str) -> u32 {
    let scene = NAMES.iter().position(|&of_scene| of_scene == name);
    CUTS[scene.expect("a scene of the show")]
}
