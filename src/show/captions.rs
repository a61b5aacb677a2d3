use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::presentation::{Caption, Presentation};

pub(super) struct Cue {
    pub text: &'static str,
    /// The scene's beat, from 0, at which the text begins to fade in.
    pub first: f32,
    pub beats: f32,
    /// See [`Caption::middle`].
    pub middle: f32,
    /// See [`Caption::size`].
    pub size: f32,
}

pub(super) fn apply(lines: &[Cue], beat: f32, presentation: &mut Presentation) {
    presentation.captions.clear();
    for line in lines {
        let since = beat - line.first;
        let brightness = smooth_step(since.min(line.beats - since));
        if brightness > 0.0 {
            presentation.captions.push(Caption {
                letters: line.text.bytes().collect(),
                middle: line.middle,
                size: line.size,
                brightness,
            });
        }
    }
}
