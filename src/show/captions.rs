//! The show's captions and when they appear.

use crate::maths::smooth_step;
use crate::scene::{Caption, List, Scene};

/// A caption and the time for which it is shown.
struct Line {
    text: &'static str,
    /// The beat of the show at which it begins to fade in.
    first: f32,
    /// The beats until it has faded out.
    beats: f32,
    /// See [`Caption::middle`].
    middle: f32,
    /// See [`Caption::size`].
    size: f32,
}

#[rustfmt::skip]
static LINES: [Line; 10] = [
    Line { first: 12.0, beats: 11.0, middle: 0.82, size: 0.040, text: "RAYS BY SQUARES OF EIGHT" },
    // The method scene.
    Line { first: 57.0, beats: 7.0, middle: 0.86, size: 0.045, text: "TRACE A POINT EVERY 8 PIXELS" },
    Line { first: 65.0, beats: 7.0, middle: 0.86, size: 0.045, text: "FILL WHERE CORNERS AGREE" },
    Line { first: 73.0, beats: 7.0, middle: 0.86, size: 0.045, text: "DIVIDE WHERE THEY DIFFER" },
    // The finale: credits and greetings.
    Line { first: 170.0, beats: 7.0, middle: 0.18, size: 0.090, text: "EIGHTFOLD" },
    Line { first: 177.0, beats: 7.0, middle: 0.14, size: 0.040, text: "GREETINGS TO" },
    Line { first: 178.0, beats: 6.0, middle: 0.24, size: 0.065, text: "HEAVEN SEVEN" },
    Line { first: 179.0, beats: 5.0, middle: 0.35, size: 0.065, text: "REALSTORM" },
    Line { first: 184.0, beats: 7.0, middle: 0.16, size: 0.045, text: "AND THE 2008 THESIS" },
    Line { first: 184.0, beats: 7.0, middle: 0.24, size: 0.045, text: "ON ADAPTIVE RAY TRACING" },
];

/// Replaces a scene's captions by those of the show at a time in beats.
pub(super) fn apply(beat: f32, scene: &mut Scene) {
    scene.captions.clear();
    for line in &LINES {
        let since = beat - line.first;
        // Each fades in and out within a beat.
        let brightness = smooth_step(since.min(line.beats - since));
        if brightness > 0.0 {
            scene.captions.push(Caption {
                letters: List::of(line.text.as_bytes()),
                middle: line.middle,
                size: line.size,
                brightness,
            });
        }
    }
}
