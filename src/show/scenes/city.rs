//! Five letters as towers over water, a city that rises behind them, and the sun.

use crate::show::environment::{Environment, Now, point};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{Size, add_block, add_letter, add_sphere, fraction};
use eightfold_tracer::scene::{Light, Material, Scene, Shape};
use glam::{Mat3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

const SUN: [f32; 3] = [0.0, 44.0, -264.0];

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.625, 0.25, 0.0625),
    sky: vec3(-0.625, -0.0625, 0.375),
    ambient: vec3(0.046875, 0.0625, 0.09375),
    haze: 0.03125,
    haze_fall: 0.125,
    scatter: 0.046875,
    vignette: 0.25,
    floor: Some(&WATER),
    lights: &[
        // Above the water: an image of a cut sun has no bounds, so all of it is traced.
        Light { drawn_radius: 43.5, glow: 12.0, ..point(SUN, [5.0, 3.0, 1.25]) },
        point([-60.0, 60.0, 30.0], [1.5, 1.625, 1.75]),
    ],
    field_of_view: 0.875,
    add,
    ..Environment::EMPTY
};

/// No shot is in front of the slit left of the G's bar: the slit's image has no bounds, and
/// flickered.
static SHOTS: &[Shot] = &[
    shot(
        3,
        &[
            view([-34.0, 2.0, 12.0], SUN),
            view([-10.0, 2.0, 4.0], SUN),
            view([-7.0, 1.25, -2.0], SUN),
        ],
    ),
    shot(3, &[view([-21.0, 1.25, -2.0], SUN), view([-15.0, 1.25, -13.0], SUN)]),
    shot(
        2,
        &[view([-9.0, 1.5, -7.0], SUN), view([-7.5, 1.5, 2.0], SUN), view([-6.5, 13.5, 11.0], SUN)],
    ),
];

static TOWER: Material = Material::matt(vec3(0.03125, 0.03125, 0.03515625), 0.0);
/// Calm: the guard has no bounds of images in waves. Without diffuse light, which costs shadows.
static WATER: Material =
    Material { kr: 0.09375, fresnel: 0.6875, ..Material::matt(vec3(0.0625, 0.75, 0.75), 0.0) };
static RED: Material =
    Material { ks: 0.5, exponent: 32.0, ..Material::matt(vec3(2.5, 0.0625, 0.015625), 0.875) };

const LETTER: Size = Size { step: 2.25, half_width: 0.875, half_depth: 1.75 };
const BALL: f32 = 0.5;

fn add(now: Now, scene: &mut Scene) {
    for (number, &letter) in (0..).zip(b"EIGHT") {
        let foot = vec3(-19.0, LETTER.half_width, -30.0) + vec3(8.5, 0.0, -2.0) * number as f32;
        add_letter(letter, foot, Mat3::IDENTITY, &LETTER, &TOWER, scene);
    }
    // The city is low before the sun.
    for number in 0..28 {
        let number = number as f32;
        let away = 90.0 + 4.0 * number;
        let aside = 240.0 * fraction(number * 0.618) - 120.0;
        let rise = 0.00390625 * (now.beat + 20.0) * fraction(number * 0.453125);
        let height = 3.0 + rise * aside.abs();
        let centre = vec3(aside, height, -away);
        add_block(Shape::Box, centre, vec3(6.0, height, 3.0), Mat3::IDENTITY, &TOWER, scene);
    }
    // Faster and faster; the last cut moves it near the camera.
    let away = if now.beat < 24.0 { 25.0 } else { 9.0 };
    let way = vec3(15.875 + 0.125 * away, 0.0, -away);
    let drift = now.beat / 32.0;
    let ball = vec3(-20.0, BALL, -9.0) + way * (drift * drift);
    add_sphere(ball, BALL, &RED, scene);
}
