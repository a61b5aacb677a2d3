//! Traced points, filled squares and the picture of the still life.

use super::still_life::{self, PEARL_BALL};
use crate::show::captions::Cue;
use crate::show::environment::{Environment, Now};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use eightfold_tracer::presentation::{Method, Presentation};

pub(in crate::show) const SCENE: ShowScene = ShowScene {
    environment_since: still_life::SCENE.bars(),
    captions: CAPTIONS,
    ..ShowScene::new(&ENVIRONMENT, SHOTS)
};

static ENVIRONMENT: Environment = Environment { present, ..still_life::ENVIRONMENT };

static SHOTS: &[Shot] = &[shot(
    8,
    &[
        view([2.5, 1.25, 6.25], PEARL_BALL),
        view([0.5, 1.0, 6.6], [0.9, 0.7, 0.7]),
        view([-1.6, 1.4, 7.2], [0.5, 0.9, 0.2]),
        view([-3.4, 1.7, 7.2], [0.2, 1.0, 0.0]),
        view([-1.0, 1.6, 7.8], [0.4, 0.9, 0.2]),
        view([1.8, 1.2, 6.8], [0.8, 0.7, 0.6]),
        view([2.5, 1.25, 6.0], [1.1, 0.6, 1.1]),
        view([2.0, 1.25, 6.25], PEARL_BALL),
        view([2.0, 1.25, 6.25], PEARL_BALL),
    ],
)];

#[rustfmt::skip]
static CAPTIONS: &[Cue] = &[
    Cue { first: 2.0, beats: 8.0, middle: 0.92, size: 0.024, text: "TRACE A POINT EVERY 8 PIXELS" },
    Cue { first: 11.0, beats: 6.0, middle: 0.92, size: 0.024, text: "FILL WHERE CORNERS AGREE" },
    Cue { first: 18.0, beats: 6.0, middle: 0.92, size: 0.024, text: "DIVIDE WHERE THEY DIFFER" },
    Cue { first: 24.0, beats: 7.5, middle: 0.92, size: 0.024, text: "TRACED ####### OF $$$$$$$ PIXELS" },
];

/// The overlay at the start of each bar: points, squares, picture, coarse, front.
static OVERLAYS: [[f32; 5]; 9] = [
    [1.0, 0.0, 0.2, 0.0, 1.0],
    [1.0, 0.0, 0.2, 0.0, 0.0],
    [0.7, 0.0, 0.2, 0.0, 0.0],
    [0.0, 0.2, 0.9, 15.9, 0.0],
    [0.0, 0.3, 0.9, 10.0, 0.0],
    [0.0, 0.3, 0.9, 2.0, 0.0],
    [0.8, 0.3, 0.3, 0.0, 0.0],
    [0.8, 0.3, 0.3, 0.0, 0.8],
    [0.0, 0.0, 1.0, 0.0, 1.0],
];

fn present(now: Now, presentation: &mut Presentation) {
    let bar = now.beat * 0.25 - SCENE.environment_since as f32;
    let from = (bar as usize).min(OVERLAYS.len() - 2);
    let u = bar - from as f32;
    let at = |i: usize| OVERLAYS[from][i] + (OVERLAYS[from + 1][i] - OVERLAYS[from][i]) * u;
    let [points, squares, picture, coarse, front] = core::array::from_fn(at);
    presentation.method = Method { points, squares, picture, coarse, front };
}
