//! The four balls of the 2008 thesis, on paper without a horizon.

use crate::show::environment::{Environment, Now, point};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::add_sphere;
use crate::sound::Track;
use eightfold_tracer::scene::{Ambience, Light, Material, Scene};
use glam::{Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

pub(super) static ENVIRONMENT: Environment = Environment {
    background: vec3(0.405, 0.333, 0.26),
    sky: vec3(-0.24, -0.2, -0.16),
    ambient: vec3(0.36, 0.37, 0.42),
    ambience: Ambience { occlusion: 1.0, reach: 1.0, ground: vec3(0.18, 0.15, 0.12), bounce: 0.9 },
    haze: 0.022,
    vignette: 0.2,
    floor: Some(&PAPER),
    lights: &[Light { diameter: 800.0, ..point([-600.0, 960.0, 540.0], [1.75, 1.6, 1.35]) }],
    field_of_view: 0.62,
    add,
    ..Environment::EMPTY
};

/// The white ball's centre.
pub(super) const PEARL_BALL: [f32; 3] = [1.3, 0.5, 1.7];

static SHOTS: &[Shot] = &[
    shot(
        4,
        &[
            view([-0.5, 2.25, 8.5], [0.0, 1.0, 0.0]),
            view([-1.5, 2.0, 7.5], [0.25, 0.75, 0.25]),
            view([-1.5, 1.75, 6.0], [0.5, 0.75, 0.5]),
        ],
    ),
    shot(
        2,
        &[
            view([4.25, 1.75, 6.0], [1.0, 0.75, 1.0]),
            view([3.25, 1.5, 6.25], PEARL_BALL),
            view([2.5, 1.25, 6.25], PEARL_BALL),
        ],
    ),
];

static PAPER: Material = Material::matt(vec3(0.30, 0.26, 0.22), 0.74);
static RED: Material =
    Material { ks: 0.3, exponent: 22.0, ..Material::matt(vec3(0.64, 0.035, 0.009), 0.85) };
static PEARL: Material = Material {
    ks: 0.5,
    exponent: 60.0,
    fresnel: 0.3,
    ..Material::matt(vec3(1.0, 0.946, 0.857), 0.95)
};
static INK: Material =
    Material { ks: 0.3, exponent: 30.0, colour: vec3(0.012, 0.032, 0.11), kd: 0.85, ..PEARL };
static GLASS: Material = Material {
    ks: 0.9,
    exponent: 120.0,
    fresnel: 1.0,
    kt: 0.85,
    index: 1.4,
    tint: vec3(0.62, 0.66, 0.68),
    ..Material::BLACK
};

/// Half the acceleration of the glass ball's fall in scene units per squared beat; its bounces
/// start on the kick drum.
const FALL: f32 = 0.6;
/// The longest bounce in beats, after which the ball rests.
const LONGEST: f32 = 2.0;

pub(super) fn add(now: Now, scene: &mut Scene) {
    add_sphere(Vec3::Y, 1.0, &RED, scene);
    add_sphere(Vec3::from_array(PEARL_BALL), 0.5, &PEARL, scene);
    add_sphere(vec3(2.25, 0.85, -1.1), 0.85, &INK, scene);
    let kick = now.cue(Track::Kick);
    let left = f32::min(kick.until, LONGEST - kick.since);
    let up = f32::max(FALL * kick.since * left, 0.0);
    add_sphere(vec3(-0.75, 0.46 + up, 1.3), 0.46, &GLASS, scene);
}
