//! A moon covers the sun, and the name rises on the limb of a dark world.

use crate::show::environment::{Environment, Now, point};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{Size, add_letter, add_sphere, add_stars};
use eightfold_tracer::maths::{cos, sin, smooth_step};
use eightfold_tracer::scene::{Light, Material, Scene};
use glam::{Mat3, Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.0012, 0.0022, 0.0080),
    sky: vec3(0.0, 0.0008, 0.0060),
    ambient: vec3(0.004, 0.006, 0.016),
    vignette: 0.3,
    lights: &[
        // The sun.
        Light {
            drawn_radius: 7.4,
            core: 7.25,
            glow: 0.25,
            ..point([0.0, 0.0, -60.0], [22.0, 19.0, 16.0])
        },
        // Its halo.
        Light { core: 7.2, glow: 6.0, ..point([0.0, 0.0, -60.0], [0.05, 0.10, 0.28]) },
        // The diamond of the ring.
        Light { glow: 0.05, ..point([0.36, 0.36, 4.8], [0.0, 0.0, 0.0]) },
    ],
    add,
    ..Environment::EMPTY
};

static SHOTS: &[Shot] = &[shot(
    6,
    &[
        view([0.0, 0.0, 10.2], [0.0; 3]),
        view([0.0, 0.0, 9.4], [0.0; 3]),
        view([0.0, 0.0, 9.0], [0.0; 3]),
    ],
)];

// Not black: the world reflects some light to it.
static MOON: Material = Material::matt(Vec3::splat(0.25), 0.0);
static LIMB: Material = Material::matt(vec3(0.3, 0.25, 0.22), 0.03);
static PEARL: Material = Material::matt(vec3(0.9, 0.85, 0.78), 0.95);

const NAME: &[u8; 9] = b"EIGHTFOLD";
const LETTER: Size = Size { step: 0.16, half_width: 0.05, half_depth: 0.09 };
const ADVANCE: f32 = 0.56;

/// The radius of the dark world, and its centre, in scene units.
const WORLD: f32 = 12.0;
const CENTRE: Vec3 = vec3(0.0, -1.8 - WORLD, 3.5);
/// The direction from there to the horizon, where the name stands.
const HORIZON: Vec3 = vec3(0.0, 0.973_66, -0.228);

/// The beats between the starts of two letters, and of a rise.
const BEATS: f32 = 1.0;
const RISE: f32 = 2.0;

fn add(now: Now, scene: &mut Scene) {
    let beat = now.beat;
    // Totality is on beat 8, and the ring on beat 16.
    let moon = 2.3 * (1.0 - beat / 8.0).max(0.0) - 0.055 * smooth_step((beat - 14.0) * 0.5);
    add_sphere(vec3(moon, 0.6 * moon, 0.0), 1.0, &MOON, scene);
    let flash = if beat < 16.0 { 0.0 } else { 1.0 + 4.0 / (1.0 + 4.0 * (beat - 16.0)) };
    scene.lights[2].colour = vec3(1.1, 0.95, 0.75) * flash;
    add_stars(scene);
    add_sphere(CENTRE, WORLD, &LIMB, scene);
    for (number, &letter) in (0..).zip(NAME) {
        let number = number as f32;
        let risen = smooth_step((beat - 6.0 - BEATS * number) / RISE);
        if risen > 0.0 {
            let angle = (number - 4.0) * (ADVANCE / WORLD);
            let (sine, cosine) = (sin(angle), cos(angle));
            let right = Vec3::X * cosine - HORIZON * sine;
            let up = HORIZON * cosine + Vec3::X * sine;
            let axes = Mat3::from_cols(right, up, right.cross(up));
            let high = WORLD + 0.8 * (risen - 1.0);
            let foot = CENTRE + axes * vec3(-LETTER.step, high, 0.0);
            add_letter(letter, foot, axes, &LETTER, &PEARL, scene);
        }
    }
}
