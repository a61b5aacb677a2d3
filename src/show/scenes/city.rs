//! Five letters as towers over water, and the sun between them.

use crate::show::environment::{Environment, Now, point};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{Size, add_letter, add_sphere};
use eightfold_tracer::scene::{Light, Material, Scene};
use glam::{Mat3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

const SUN: [f32; 3] = [-10.0, 26.0, -170.0];

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.42, 0.21, 0.09),
    sky: vec3(-0.30, -0.11, 0.09),
    ambient: vec3(0.035, 0.042, 0.065),
    haze: 0.05,
    haze_fall: 0.3,
    scatter: 0.1,
    vignette: 0.1,
    floor: Some(&WATER),
    lights: &[Light { drawn_radius: 25.0, glow: 11.0, ..point(SUN, [4.0, 3.3, 2.3]) }],
    field_of_view: 0.88,
    add,
    ..Environment::EMPTY
};

static SHOTS: &[Shot] = &[
    shot(
        5,
        &[
            view([-25.0, 2.2, 10.0], SUN),
            view([-15.0, 1.9, 5.0], SUN),
            view([-10.0, 1.6, -3.0], SUN),
            view([-8.9, 1.4, -8.5], SUN),
        ],
    ),
    shot(
        3,
        &[view([2.4, 2.0, 9.0], SUN), view([-6.0, 2.2, 11.0], SUN), view([-25.0, 2.6, 12.0], SUN)],
    ),
];

static TOWER: Material = Material::matt(vec3(0.06, 0.045, 0.05), 0.9);
/// Calm: the guard has no bounds of images in waves. Without diffuse light, which costs shadows.
static WATER: Material =
    Material { kr: 0.15, fresnel: 0.7, ..Material::matt(vec3(0.035, 0.048, 0.084), 0.0) };
static RED: Material =
    Material { ks: 0.4, exponent: 40.0, ..Material::matt(vec3(11.5, 0.57, 0.14), 0.85) };

const LETTER: Size = Size { step: 2.2, half_width: 0.9, half_depth: 1.8 };

fn add(now: Now, scene: &mut Scene) {
    for (number, &letter) in (0..).zip(b"EIGHT") {
        let foot = vec3(-15.3, LETTER.half_width, -20.0) + vec3(8.6, 0.0, -9.0) * number as f32;
        add_letter(letter, foot, Mat3::IDENTITY, &LETTER, &TOWER, scene);
    }
    // The ball drifts ahead of the camera.
    let drift = now.beat / 20.0;
    let ball = if drift < 1.0 {
        vec3(-19.0, 0.3, -2.0).lerp(vec3(-8.5, 0.3, -14.0), drift)
    } else {
        vec3(0.5, 0.3, -2.0).lerp(vec3(-18.0, 0.3, 0.0), 1.6 * (drift - 1.0))
    };
    add_sphere(ball, 0.36, &RED, scene);
}
