//! A low sun through two rows of marble columns.

use crate::show::environment::{Environment, FAR, SHOW, point, sun};
use crate::show::material;
use crate::show::path::keyframe;
use crate::show::props::{Motion::Bouncing, Prop, cuboid, cylinder, sphere};
use crate::show::scene::{Shot, ShowScene, shot};
use eightfold_tracer::scene::{Light, Spot};
use glam::vec3;

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.78, 0.50, 0.36),
    sky: vec3(-0.62, -0.26, 0.10),
    ambient: vec3(0.22, 0.20, 0.27),
    haze: 0.022,
    film: SHOW,
    floor: &material::SANDSTONE,
    floor_half: FAR,
    swell: 0.0,
    lights: &[
        Light { diameter: 0.2, glow: 0.3, ..sun([7.0, 2.0, -3.4], [1.00, 0.70, 0.40]) },
        sun([-4.0, 5.0, -5.0], [0.16, 0.22, 0.38]),
        Light {
            diameter: 1.2,
            spot: Some(Spot {
                aim: vec3(0.0, -1.0, 0.0),
                inner_angle: 0.200_334_6,
                outer_angle: 0.283_794_1,
            }),
            ..point([0.0, 9.0, 6.0], [0.45, 0.50, 0.65])
        },
    ],
    kick_response: 0.0,
    props: PROPS,
    procedural: None,
};

#[rustfmt::skip]
static PROPS: &[Prop] = &[
    cuboid(&material::MARBLE, [-2.6, 0.2, -6.0], [1.5, 0.4, 1.5]).repeat([2, 7], [5.2, 3.2]),
    cylinder(&material::MARBLE, [-2.6, 2.7, -6.0], [0.9, 4.6, 0.9]).repeat([2, 7], [5.2, 3.2]),
    cuboid(&material::MARBLE, [-2.6, 5.2, -6.0], [1.4, 0.4, 1.4]).repeat([2, 7], [5.2, 3.2]),
    cuboid(&material::MARBLE, [-2.6, 5.7, -2.6], [1.1, 0.6, 11.2]).repeat([2, 2], [5.2, 11.2]),
    sphere(&material::CRYSTAL, [0.0, 1.7, 6.0], 2.0).moving(Bouncing { phase: 0.0 }),
    sphere(&material::GOLD, [-0.9, 0.7, 1.4], 1.0).moving(Bouncing { phase: 1.0 }),
    sphere(&material::SCARLET, [0.9, 1.0, 3.2], 0.9).moving(Bouncing { phase: 2.0 }),
    sphere(&material::SILVER, [-0.2, 3.2, 9.0], 1.4).moving(Bouncing { phase: 3.0 }),
];

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(3, &[
        keyframe([0.0, 2.9, 2.6], -1.8, 15.0, -2.2),
        keyframe([0.0, 2.9, 2.6], -1.95, 14.0, -2.2).rolled(0.03),
        keyframe([0.0, 2.9, 2.6], -2.1, 12.5, -2.2),
    ]),
    shot(2, &[
        keyframe([0.0, 2.0, 3.4], 1.4, 16.0, 5.0),
        keyframe([0.0, 1.8, 3.4], 1.15, 15.0, 6.5).rolled(-0.04),
        keyframe([0.0, 1.6, 3.4], 0.9, 14.0, 8.5),
    ]),
    shot(3, &[
        keyframe([0.0, 1.5, 4.6], 0.2, 6.4, 0.0).rolled(-0.03),
        keyframe([0.0, 1.5, 5.3], 0.0, 6.1, 0.4),
        keyframe([0.0, 1.6, 6.0], -0.1, 5.8, 0.9).rolled(0.03),
    ]),
];
