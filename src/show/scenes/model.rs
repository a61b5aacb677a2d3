//! The model scene: four spheres, a plane and two lights, after the test scene of the 2008 thesis.

use crate::show::environment::{Environment, point};
use crate::show::material;
use crate::show::path::keyframe;
use crate::show::props::{Motion::Bouncing, Prop, sphere};
use crate::show::scene::{Shot, ShowScene, shot};
use eightfold_tracer::scene::{Film, Light};
use glam::{Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

/// The environment of this scene, of the method scene, and of measurements.
pub(in crate::show) static ENVIRONMENT: Environment = Environment {
    background: vec3(0.10, 0.12, 0.20),
    sky: Vec3::ZERO,
    ambient: vec3(0.12, 0.12, 0.14),
    haze: 0.0,
    film: Film::PLAIN,
    floor: &material::PAPER,
    floor_half: 12.0,
    swell: 0.0,
    lights: &[
        Light { drawn_radius: 0.15, ..point([-4.0, 6.0, -4.0], [0.90, 0.85, 0.80]) },
        Light { drawn_radius: 0.15, ..point([5.0, 5.0, -2.0], [0.35, 0.40, 0.50]) },
    ],
    kick_response: 0.0,
    props: PROPS,
    procedural: None,
};

#[rustfmt::skip]
static PROPS: &[Prop] = &[
    sphere(&material::RED, [-2.2, 1.0, 0.5], 2.0),
    sphere(&material::MIRROR, [0.0, 1.2, 1.8], 2.4),
    sphere(&material::BLUE, [2.2, 1.0, 0.3], 2.0),
    sphere(&material::GLASS, [0.6, 0.5, -1.6], 1.0).moving(Bouncing { phase: 0.0 }),
];

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(4, &[
        keyframe([0.0, 0.9, 0.0], -1.2, 8.0, 0.5),
        keyframe([0.0, 0.9, 0.0], -0.5, 7.2, 1.2).rolled(0.04),
        keyframe([0.0, 0.9, 0.0], 0.3, 7.2, 1.6).rolled(-0.04),
        keyframe([0.0, 0.9, 0.0], 0.9, 8.0, 1.3),
    ]),
    shot(2, &[
        keyframe([0.4, 0.8, -0.6], 0.5, 4.0, 0.3).rolled(-0.05),
        keyframe([0.4, 0.8, -0.5], 0.1, 4.0, 0.5),
        keyframe([0.1, 0.9, 0.1], -0.5, 6.2, 1.6).rolled(0.04),
        keyframe([0.0, 0.9, 0.2], -0.9, 8.2, 2.6),
    ]),
];
