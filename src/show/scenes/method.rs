//! The method is explained on the model scene.

use super::model;
use crate::show::act::{Act, Shot, shot};
use crate::show::captions::Line;
use crate::show::path::key;

/// The scene as a record.
pub(in crate::show) const ACT: Act = Act {
    set: &model::SET,
    set_since: model::ACT.bars(),
    shots: SHOTS,
    captions: CAPTIONS,
};

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(8, &[
        key([0.0, 0.9, 0.0], -1.0, 7.0, 1.8).overlaid(0.0, 0.0, 0.0),
        key([0.0, 0.9, 0.0], -0.5, 7.0, 1.6).overlaid(1.0, 0.0, 0.0),
        key([0.0, 0.9, 0.0], 0.0, 7.0, 1.3).overlaid(0.3, 0.6, 0.15),
        key([0.0, 0.9, 0.0], 0.5, 7.0, 1.0).overlaid(0.2, 0.4, 0.6),
        key([0.0, 0.9, 0.0], 1.0, 7.0, 0.7).overlaid(0.0, 0.0, 1.0),
    ]),
];

#[rustfmt::skip]
static CAPTIONS: &[Line] = &[
    Line { first: 1.0, beats: 7.0, middle: 0.86, size: 0.045, text: "TRACE A POINT EVERY 8 PIXELS" },
    Line { first: 9.0, beats: 7.0, middle: 0.86, size: 0.045, text: "FILL WHERE CORNERS AGREE" },
    Line { first: 17.0, beats: 7.0, middle: 0.86, size: 0.045, text: "DIVIDE WHERE THEY DIFFER" },
];
