//! The show's scenes, see `docs/storyboard.md`.

mod bubbles;
mod chimes;
mod city;
mod eclipse;
mod finale;
mod kaleidoscope;
mod method;
mod planet;
mod still_life;

use super::scene::ShowScene;
use crate::sound;
use crate::tempo::BAR;

const SCENES: &[(&str, ShowScene)] = &[
    ("eclipse", eclipse::SCENE),
    ("still-life", still_life::SCENE),
    ("method", method::SCENE),
    ("city", city::SCENE),
    ("chimes", chimes::SCENE),
    ("bubbles", bubbles::SCENE),
    ("planet", planet::SCENE),
    ("kaleidoscope", kaleidoscope::SCENE),
    ("finale", finale::SCENE),
];

/// The scenes' names, in order.
pub const NAMES: [&str; SCENES.len()] = {
    let mut names = [""; SCENES.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = SCENES[i].0;
        i += 1;
    }
    names
};

/// The scenes without their names, for the intro.
pub(super) static ALL: [ShowScene; SCENES.len()] = {
    let mut all = [eclipse::SCENE; SCENES.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = SCENES[i].1;
        i += 1;
    }
    all
};

/// The bars at which the scenes begin, counted from 0.
pub const CUTS: [u32; ALL.len()] = {
    let mut cuts = [0; ALL.len()];
    let mut i = 1;
    while i < cuts.len() {
        cuts[i] = cuts[i - 1] + ALL[i - 1].bars();
        i += 1;
    }
    cuts
};

/// The show's length in bars.
pub const BARS: u32 = CUTS[ALL.len() - 1] + ALL[ALL.len() - 1].bars();

const _: () = assert!(BARS == sound::BARS, "the song has as many bars as the show's scenes");

/// The show's length in seconds.
pub const LENGTH: f32 = BAR * BARS as f32;

/// Returns the bar at which a named scene begins.
///
/// # Panics
///
/// If there is no such scene.
#[must_use]
pub fn cut(name: &str) -> u32 {
    let scene = NAMES.iter().position(|&of_scene| of_scene == name);
    CUTS[scene.expect("a scene of the show")]
}
