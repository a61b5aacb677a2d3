//! The method is explained on the model scene.

use super::model;
use crate::show::act::{Act, Shot, shot};
use crate::show::captions::Line;
use crate::show::path::key;

/// The scene as a record.
pub(in crate::show) const ACT: Act = Act {
    set_since: model::ACT.bars(),
    captions: CAPTIONS,
    ..Act::new(&model::SET, SHOTS)
};

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(8, &[
        key([0.0, 0.9, 0.0], -1.0, 7.6, 1.8).overlaid(1.0, 0.0, 0.2, 0.0).swept(1.0),
        key([0.0, 0.9, 0.0], -0.7, 7.0, 1.8).overlaid(1.0, 0.0, 0.2, 0.0),
        key([0.0, 0.9, 0.0], -0.4, 6.6, 1.7).overlaid(0.7, 0.0, 0.2, 0.0),
        key([0.0, 0.9, 0.0], -0.1, 6.6, 1.5).overlaid(0.0, 0.2, 0.9, 15.9),
        key([0.0, 0.9, 0.0], 0.2, 6.6, 1.3).overlaid(0.0, 0.3, 0.9, 8.0),
        key([0.0, 0.9, 0.0], 0.5, 6.8, 1.1).overlaid(0.0, 0.3, 0.9, 2.0),
        key([0.0, 0.9, 0.0], 0.8, 7.0, 0.9).overlaid(0.8, 0.3, 0.3, 0.0),
        key([0.0, 0.9, 0.0], 1.0, 7.2, 0.8).overlaid(0.8, 0.3, 0.3, 0.0).swept(0.8),
        key([0.0, 0.9, 0.0], 1.2, 7.4, 0.7).overlaid(0.0, 0.0, 1.0, 0.0).swept(1.0),
    ]),
];

#[rustfmt::skip]
static CAPTIONS: &[Line] = &[
    Line { first: 2.0, beats: 8.0, middle: 0.88, size: 0.045, text: "TRACE A POINT EVERY 8 PIXELS" },
    Line { first: 11.0, beats: 6.0, middle: 0.88, size: 0.045, text: "FILL WHERE CORNERS AGREE" },
    Line { first: 18.0, beats: 6.0, middle: 0.88, size: 0.045, text: "DIVIDE WHERE THEY DIFFER" },
    Line { first: 24.0, beats: 7.5, middle: 0.88, size: 0.045, text: "TRACED ####### OF $$$$$$$ PIXELS" },
];
