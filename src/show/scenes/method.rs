//! Explains the method on the model scene.

use super::model;
use crate::show::captions::Cue;
use crate::show::path::keyframe;
use crate::show::scene::{Shot, ShowScene, shot};

pub(in crate::show) const SCENE: ShowScene = ShowScene {
    environment_since: model::SCENE.bars(),
    captions: CAPTIONS,
    ..ShowScene::new(&model::ENVIRONMENT, SHOTS)
};

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(8, &[
        keyframe([0.0, 0.9, 0.0], -1.0, 7.6, 1.8).overlaid(1.0, 0.0, 0.2, 0.0).swept(1.0),
        keyframe([0.0, 0.9, 0.0], -0.7, 7.0, 1.8).overlaid(1.0, 0.0, 0.2, 0.0),
        keyframe([0.0, 0.9, 0.0], -0.4, 6.6, 1.7).overlaid(0.7, 0.0, 0.2, 0.0),
        keyframe([0.0, 0.9, 0.0], -0.1, 6.6, 1.5).overlaid(0.0, 0.2, 0.9, 15.9),
        keyframe([0.0, 0.9, 0.0], 0.2, 6.5, 1.4).overlaid(0.0, 0.3, 0.9, 8.0),
        keyframe([0.0, 0.9, 0.0], 0.5, 6.8, 1.1).overlaid(0.0, 0.3, 0.9, 2.0),
        keyframe([0.0, 0.9, 0.0], 0.8, 7.0, 0.9).overlaid(0.8, 0.3, 0.3, 0.0),
        keyframe([0.0, 0.9, 0.0], 1.0, 7.2, 0.8).overlaid(0.8, 0.3, 0.3, 0.0).swept(0.8),
        keyframe([0.0, 0.9, 0.0], 1.2, 7.4, 0.7).overlaid(0.0, 0.0, 1.0, 0.0).swept(1.0),
    ]),
];

#[rustfmt::skip]
static CAPTIONS: &[Cue] = &[
    Cue { first: 2.0, beats: 8.0, middle: 0.88, size: 0.045, text: "TRACE A POINT EVERY 8 PIXELS" },
    Cue { first: 11.0, beats: 6.0, middle: 0.88, size: 0.045, text: "FILL WHERE CORNERS AGREE" },
    Cue { first: 18.0, beats: 6.0, middle: 0.88, size: 0.045, text: "DIVIDE WHERE THEY DIFFER" },
    Cue { first: 24.0, beats: 7.5, middle: 0.88, size: 0.045, text: "TRACED ####### OF $$$$$$$ PIXELS" },
];
