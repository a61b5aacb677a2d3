//! Credits and greetings over a glass ball at dusk.

use crate::scene::Light;
use crate::show::act::{Act, Shot, shot};
use crate::show::captions::Line;
use crate::show::material;
use crate::show::path::key;
use crate::show::props::{Motion::Circling, Prop, sphere};
use crate::show::set::{FAR, Set, point, sun};
use glam::vec3a;

/// The scene as a record.
pub(in crate::show) const ACT: Act = Act {
    set: &SET,
    set_since: 0,
    shots: SHOTS,
    captions: CAPTIONS,
};

static SET: Set = Set {
    background: vec3a(0.55, 0.30, 0.22),
    sky: vec3a(-0.52, -0.24, -0.06),
    ambient: vec3a(0.12, 0.11, 0.16),
    haze: 0.03,
    floor: &material::DUSK,
    floor_half: FAR,
    lights: &[
        Light {
            size: 0.3,
            ..sun([4.0, 2.2, 6.0], [0.85, 0.50, 0.28])
        },
        point([-6.0, 8.0, -8.0], [0.30, 0.36, 0.55]),
    ],
    flash: 0.0,
    props: PROPS,
    special: None,
};

#[rustfmt::skip]
static PROPS: &[Prop] = &[
    // A large glass sphere, and small spheres that circle it.
    sphere(&material::GLASS, [0.0, 1.3, 0.0], 2.6),
    sphere(&material::SCARLET, [0.0, 0.4, 0.0], 0.8).copies(8).alternating(&material::GOLD).moving(Circling { radius: 3.2 }),
];

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(6, key([0.0, 1.9, 0.0],   -0.3, 9.0, 0.2), key([0.0, 2.6, 0.0],   0.3, 15.0, 1.6)),
];

#[rustfmt::skip]
static CAPTIONS: &[Line] = &[
    Line { first: 2.0, beats: 7.0, middle: 0.18, size: 0.090, text: "EIGHTFOLD" },
    Line { first: 9.0, beats: 7.0, middle: 0.14, size: 0.040, text: "GREETINGS TO" },
    Line { first: 10.0, beats: 6.0, middle: 0.24, size: 0.065, text: "HEAVEN SEVEN" },
    Line { first: 11.0, beats: 5.0, middle: 0.35, size: 0.065, text: "REALSTORM" },
    Line { first: 16.0, beats: 7.0, middle: 0.16, size: 0.045, text: "AND THE 2008 THESIS" },
    Line { first: 16.0, beats: 7.0, middle: 0.24, size: 0.045, text: "ON ADAPTIVE RAY TRACING" },
];
