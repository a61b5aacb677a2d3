use super::captions;
use super::path::move_camera;
use super::scenes::{ALL, LENGTH};
use crate::grid::{BAR, BEATS_PER_BAR};
use crate::sound::pulse;
use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::Scene;

/// Seconds of the final fade-out.
const FADE_OUT: f32 = 2.0;

/// The increase of lights on the loudest kick, in environments that respond to it: visible, but not dazzling.
const FLASH: f32 = 0.3;
/// The camera's approach to its target on the loudest kick: felt rather than seen.
const PUSH: f32 = 0.02;

const BEATS: f32 = BEATS_PER_BAR as f32;

/// Sets the show's scene at `time` seconds, 0 to [`LENGTH`].
pub fn at(time: f32, scene: &mut Scene) {
    transition(without_transition(time, scene), scene);
}

/// Sets a scene like [`at`], without a transition's coarse squares. Returns the transition's halvings.
pub fn without_transition(time: f32, scene: &mut Scene) -> f32 {
    let (shown, bar) = playing(&ALL, |scene| scene.bars(), time / BAR);
    shown.environment.apply((bar + shown.environment_since as f32) * BEATS, scene);
    let kick = shown.environment.kick_response * pulse(time).kick;
    for light in scene.lights.iter_mut() {
        light.colour *= 1.0 + FLASH * kick;
    }
    for bar in scene.copper_bars.iter_mut() {
        bar.brightness *= kick;
    }
    captions::apply(shown.captions, bar * BEATS, scene);
    let (shot, bar_of_shot) = playing(shown.shots, |shot| shot.bars.into(), bar);
    let time_of_shot = bar_of_shot / f32::from(shot.bars);
    move_camera(shot.keyframes, time_of_shot, PUSH * kick, scene);
    scene.camera.min_aspect = shown.min_aspect;
    scene.exposure = 1.0 - smooth_step((time - LENGTH) / FADE_OUT + 1.0);
    // Halve squares on eighths, and double them on sixteenths.
    let bars_left = shown.bars() as f32 - bar;
    BEATS * f32::min(2.0 * bar, 4.0 * bars_left)
}

/// Coarsens a scene's beginning and end, from squares of 32 pixels. `halvings` counts from the beginning, or to the end.
fn transition(halvings: f32, scene: &mut Scene) {
    // No squares of a single pixel.
    let side = (32 >> (halvings as u32).min(6) & !1) as f32;
    let method = &mut scene.method;
    method.coarse = method.coarse.max(side);
    method.squares = method.squares.max(side / 128.0);
}

/// Returns the scene or shot at a bar counted from the start of the first, and the bars since its own start. The last one has no end.
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
