use super::captions;
use super::environment::Now;
use super::path::move_camera;
use super::scene::ShowScene;
use super::scenes::ALL;
use crate::tempo::{BAR, BEATS_PER_BAR};
use eightfold_tracer::presentation::{Method, Moment, Presentation};

const BEATS: f32 = BEATS_PER_BAR as f32;

/// Sets the show's scene and its presentation at `time` seconds, 0 to [`LENGTH`](super::LENGTH).
pub fn at(time: f32, moment: &mut Moment) {
    transition(without_transition(time, moment), &mut moment.presentation);
}

/// Sets a scene like [`at`], without a transition's coarse squares. Returns the transition's
/// halvings.
pub fn without_transition(time: f32, Moment { scene, presentation }: &mut Moment) -> f32 {
    let (show_scene, bar) = playing(&ALL, ShowScene::bars, time / BAR);
    let since = bar + show_scene.environment_since as f32;
    // Rounded, since the difference may be slightly less than a whole number.
    let first = (time / BAR - since + 0.5) as u32;
    let now = Now { first, beat: since * BEATS };
    show_scene.environment.apply(now, scene);
    (presentation.sectors, presentation.method) = (1.0, Method::PLAIN);
    (show_scene.environment.present)(now, presentation);
    captions::apply(show_scene.captions, bar * BEATS, presentation);
    let (shot, bar_of_shot) = playing(show_scene.shots, |shot| shot.bars.into(), bar);
    let time_of_shot = bar_of_shot / f32::from(shot.bars);
    move_camera(shot.views, time_of_shot, show_scene.environment.field_of_view, scene);
    // Halve squares on eighths, and double them on sixteenths.
    let bars_left = show_scene.bars() as f32 - bar;
    // The last scene ends by itself.
    let is_last = core::ptr::eq(show_scene, &ALL[ALL.len() - 1]);
    BEATS * if is_last { 2.0 * bar } else { f32::min(2.0 * bar, 4.0 * bars_left) }
}

/// Coarsens a scene's beginning and end, from squares of 32 pixels. `halvings` counts from the
/// beginning, or to the end.
fn transition(halvings: f32, presentation: &mut Presentation) {
    // No squares of a single pixel.
    let side = (32 >> (halvings as u32).min(6) & !1) as f32;
    let method = &mut presentation.method;
    method.coarse = method.coarse.max(side);
    method.squares = method.squares.max(side / 128.0);
}

/// Returns the scene or shot at a bar from the start of the first, and the bars since its own
/// start. The last has no end.
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
