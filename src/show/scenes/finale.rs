//! Credits and greetings at dusk: a glass ball before the sun, on water with waves, with eight arms of spheres around it.

use crate::show::captions::Cue;
use crate::show::environment::{Environment, FAR, SHOW, point};
use crate::show::material;
use crate::show::path::keyframe;
use crate::show::props::{Prop, add_sphere, around, sphere};
use crate::show::scene::{Shot, ShowScene, shot};
use eightfold_tracer::scene::{Light, Material, Scene};
use glam::{Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene =
    ShowScene { captions: CAPTIONS, ..ShowScene::new(&ENVIRONMENT, SHOTS) };

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.98, 0.50, 0.22),
    sky: vec3(-0.97, -0.44, 0.20),
    ambient: vec3(0.12, 0.11, 0.16),
    haze: 0.02,
    film: SHOW,
    floor: &material::WATER,
    floor_half: FAR,
    swell: 0.0125,
    lights: &[
        // The sun.
        Light { drawn_radius: 5.0, glow: 7.0, ..point([4.0, 5.2, 70.0], [1.00, 0.72, 0.42]) },
        Light { diameter: 1.0, ..point([-6.0, 8.0, -8.0], [0.75, 0.62, 0.72]) },
    ],
    kick_response: 0.0,
    props: PROPS,
    procedural: Some(add),
};

static PROPS: &[Prop] = &[sphere(&material::GLASS, [0.0, 1.6, 0.0], 2.3)];

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(6, &[
        keyframe([0.0, 1.9, 0.0], -0.08, 6.0, -0.4),
        keyframe([0.0, 2.2, 0.0], -0.16, 7.5, 0.0),
        keyframe([0.0, 2.4, 0.0], -0.24, 9.0, 0.9),
        keyframe([0.0, 2.6, 0.0], -0.31, 10.5, 1.7),
        keyframe([0.0, 2.6, 0.0], -0.36, 11.5, 2.4),
    ]),
];

#[rustfmt::skip]
static CAPTIONS: &[Cue] = &[
    Cue { first: 2.0, beats: 7.0, middle: 0.18, size: 0.090, text: "EIGHTFOLD" },
    Cue { first: 9.0, beats: 7.0, middle: 0.07, size: 0.040, text: "GREETINGS TO" },
    Cue { first: 10.0, beats: 6.0, middle: 0.14, size: 0.055, text: "HEAVEN SEVEN" },
    Cue { first: 11.0, beats: 5.0, middle: 0.22, size: 0.055, text: "REALSTORM" },
    Cue { first: 16.0, beats: 7.0, middle: 0.07, size: 0.040, text: "AND THE 2008 THESIS" },
    Cue { first: 16.0, beats: 7.0, middle: 0.14, size: 0.040, text: "ON ADAPTIVE RAY TRACING" },
];

const ARMS: u8 = 8;
const SPHERES: u8 = 12;

/// The colour of an arm's first sphere, and the change along the arm: from gold to violet.
const GOLD: Vec3 = vec3(0.95, 0.66, 0.25);
const TO_VIOLET: Vec3 = vec3(-0.60, -0.58, 0.30);

fn add(beat: f32, scene: &mut Scene) {
    for arm in 0..ARMS {
        // Nearer spheres are strips at the ball's rim.
        let mut out = 2.8;
        for number in 0..SPHERES {
            let number = f32::from(number);
            let turns = f32::from(arm) / f32::from(ARMS) + 0.0185 * number + 0.006 * beat;
            let radius = 0.05 * out;
            let material = Material {
                colour: GOLD + TO_VIOLET * (number / f32::from(SPHERES)),
                ..material::SCARLET
            };
            let centre = around(turns) * out + Vec3::Y * (1.05 * radius);
            add_sphere(centre, radius, &material, scene);
            out *= 1.12;
        }
    }
}
