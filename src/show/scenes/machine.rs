//! Pistons that strike on the beat, and a wheel, under a spotlight.

use crate::scene::{Light, Spot};
use crate::show::act::{Act, Shot, shot};
use crate::show::material;
use crate::show::path::key;
use crate::show::props::{
    Motion::{Striking, Turning},
    Prop, cuboid, cylinder, sphere,
};
use crate::show::set::{FAR, FLASH, Set, point};
use glam::vec3a;

/// The scene as a record.
pub(in crate::show) const ACT: Act = Act {
    set: &SET,
    set_since: 0,
    shots: SHOTS,
    captions: &[],
};

static SET: Set = Set {
    background: vec3a(0.06, 0.07, 0.11),
    sky: vec3a(-0.03, -0.03, -0.03),
    ambient: vec3a(0.10, 0.11, 0.15),
    haze: 0.03,
    floor: &material::SLATE,
    floor_half: FAR,
    lights: &[
        Light {
            size: 0.8,
            spot: Some(Spot {
                aim: vec3a(0.5, -0.9, 0.6),
                dark: 0.70,
                bright: 0.95,
            }),
            ..point([-5.0, 9.0, -6.0], [1.20, 1.01, 0.79])
        },
        Light {
            radius: 0.2,
            ..point([8.0, 7.0, 2.0], [0.35, 0.50, 0.95])
        },
    ],
    flash: FLASH,
    props: PROPS,
    special: None,
};

#[rustfmt::skip]
static PROPS: &[Prop] = &[
    // The wheel: axle, hub, spokes, rim.
    cuboid(&material::STEEL, [0.0, 2.2, 1.2], [0.4, 0.4, 5.2]).moving(Turning { radius: 0.0 }),
    sphere(&material::GOLD, [0.0, 2.2, 1.2], 1.2),
    cuboid(&material::STEEL, [0.0, 2.2, 1.2], [0.2, 1.7, 0.2]).copies(8).moving(Turning { radius: 1.0 }),
    cuboid(&material::SCARLET, [0.0, 2.2, 1.2], [1.2, 0.3, 0.6]).copies(8).alternating(&material::GOLD).moving(Turning { radius: 1.9 }),
    // The posts that carry the axle, each with a knob.
    cuboid(&material::STRIPED, [-3.4, 2.1, 1.2], [0.7, 4.2, 1.2]).repeat([2, 1], [6.8, 0.0]),
    sphere(&material::GOLD, [-3.4, 4.6, 1.2], 1.0).repeat([2, 1], [6.8, 0.0]),
    // The pistons: anvils, heads, rods.
    cuboid(&material::STEEL, [-2.2, 0.3, -1.6], [1.1, 0.6, 1.1]).repeat([4, 1], [1.5, 0.0]),
    cylinder(&material::SCARLET, [-2.2, 0.9, -1.6], [0.8, 0.6, 0.8]).repeat([4, 1], [1.5, 0.0]).alternating(&material::GOLD).moving(Striking),
    cylinder(&material::STEEL, [-2.2, 2.2, -1.6], [0.3, 2.0, 0.3]).repeat([4, 1], [1.5, 0.0]).moving(Striking),
];

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(3, key([-1.0, 1.6, 0.0],  -0.9, 7.0, 0.8), key([0.0, 1.7, 0.0],   0.0,  9.0, 2.0)),
    shot(3, key([-0.4, 1.2, -1.0],  0.8, 6.0, 1.0), key([0.0, 1.7, 0.0],   0.5,  9.0, 2.6)),
];
