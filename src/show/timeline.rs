//! The show at a time: which scene is played, and which of its shots.

use super::captions;
use super::path::film;
use super::scenes::{ACTS, LENGTH};
use crate::grid::{BAR, BEATS_PER_BAR};
use crate::sound::pulse;
use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::Scene;

/// Seconds in which the show fades out at its end.
const FADE_OUT: f32 = 2.0;

/// The share by which lights get brighter on the loudest kick where a set follows the drum: visible, but not dazzling.
const FLASH: f32 = 0.3;
/// The share by which the camera is closer then: felt rather than seen.
const PUSH: f32 = 0.02;

/// Beats per bar, for times in beats.
const BEATS: f32 = BEATS_PER_BAR as f32;

/// Sets a scene to that of the show at `time` seconds, 0 to [`LENGTH`].
pub fn at(time: f32, scene: &mut Scene) {
    transition(whole(time, scene), scene);
}

/// Sets a scene like [`at`], but without the coarse squares of the transition between two scenes. Returns how often these are halved
/// there.
pub fn whole(time: f32, scene: &mut Scene) -> f32 {
    // Set up the act that is played.
    let (act, bar) = playing(&ACTS, |act| act.bars(), time / BAR);
    act.set.apply((bar + act.set_since as f32) * BEATS, scene);
    // Flash lights and copper bars with the kick.
    let kick = act.set.hit * pulse(time).kick;
    for light in scene.lights.iter_mut() {
        light.colour *= 1.0 + FLASH * kick;
    }
    for bar in scene.copper_bars.iter_mut() {
        bar.brightness *= kick;
    }
    // Set captions and camera.
    captions::apply(act.captions, bar * BEATS, scene);
    let (shot, bar_of_shot) = playing(act.shots, |shot| shot.bars.into(), bar);
    let time_of_shot = bar_of_shot / f32::from(shot.bars);
    film(shot.keys, time_of_shot, PUSH * kick, scene);
    // Fade out at the end of the show.
    scene.exposure = 1.0 - smooth_step((time - LENGTH) / FADE_OUT + 1.0);
    // Squares are halved on eighths, and doubled on sixteenths.
    let bars_left = act.bars() as f32 - bar;
    BEATS * f32::min(2.0 * bar, 4.0 * bars_left)
}

/// Has a scene begin and end with squares of 32 pixels. `halvings` is how often they have been halved since the scene began, or
/// will be doubled before it ends.
fn transition(halvings: f32, scene: &mut Scene) {
    // No squares of a single pixel.
    let side = (32 >> (halvings as u32).min(6) & !1) as f32;
    let method = &mut scene.method;
    method.coarse = method.coarse.max(side);
    method.squares = method.squares.max(side / 128.0);
}

/// Which of several scenes or shots, that are played one after another, is played at a bar counted from the start of the first;
/// and the bars since its own start. `bars` tells their lengths. The last one has no end.
fn playing<T>(all: &[T], bars: impl Fn(&T) -> u32, mut bar: f32) -> (&T, f32) {
    let mut playing = &all[0];
    for next in &all[1..] {
        let left = bar - bars(playing) as f32;
        if left < 0.0 {
            break;
        }
        (playing, bar) = (next, left);
    }
    (playing, bar)
}
