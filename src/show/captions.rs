//! When captions of the show appear.

use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::{Caption, Scene};

/// A caption and the time for which it is shown.
pub(super) struct Line {
    pub text: &'static str,
    /// The beat of its scene, counted from 0, at which it begins to fade in.
    pub first: f32,
    /// The beats until it has faded out.
    pub beats: f32,
    /// See [`Caption::middle`].
    pub middle: f32,
    /// See [`Caption::size`].
    pub size: f32,
}

/// Replaces a scene's captions by these, as they are `beat` beats after the scene of the show began.
pub(super) fn apply(lines: &[Line], beat: f32, scene: &mut Scene) {
    scene.captions.clear();
    for line in lines {
        let since = beat - line.first;
        // Each fades in and out within a beat.
        let brightness = smooth_step(since.min(line.beats - since));
        if brightness > 0.0 {
            scene.captions.push(Caption {
                letters: line.text.bytes().collect(),
                middle: line.middle,
                size: line.size,
                brightness,
            });
        }
    }
}
