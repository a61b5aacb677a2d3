//! The chimes: a ball strikes a tune on a ring of eight brass pipes.

use crate::show::environment::{Environment, Now, point, softbox};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{add_block, add_sphere, around};
use crate::sound::{THEME, Track};
use eightfold_tracer::scene::{Ambience, Light, Material, Scene, Shape, Spot};
use glam::{Mat3, Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.02, 0.06, 0.065),
    sky: vec3(-0.018, -0.045, -0.04),
    ambient: vec3(0.16, 0.17, 0.19),
    ambience: Ambience { occlusion: 1.0, reach: 1.2, ground: vec3(0.12, 0.13, 0.12), bounce: 0.9 },
    haze: 0.02,
    vignette: 0.25,
    floor: Some(&PAPER),
    lights: &[
        Light { diameter: 14.0, ..point([-30.0, 55.0, 30.0], [0.55, 0.48, 0.38]) },
        Light { glow: 0.8, spot: Some(Spot::new(Vec3::Y, 0.9)), ..point([0.0; 3], [0.0; 3]) },
    ],
    softboxes: &[
        softbox([-4.0, 3.0, 8.0], [0.25, 1.5, 0.25], [6.0, 5.5, 5.0]),
        softbox([8.0, 2.0, 2.0], [0.4, 1.0, 0.4], [2.0, 2.2, 2.4]),
    ],
    add,
    ..Environment::EMPTY
};

static SHOTS: &[Shot] = &[
    shot(
        5,
        &[
            view([-1.4, 3.7, 8.05], [-0.834, 2.77, 2.568]),
            view([0.0, 4.2, 10.4], [0.3, 2.4, 0.8]),
            view([3.0, 4.6, 10.2], [0.0, 2.4, 0.0]),
            view([6.8, 5.0, 7.8], [0.0, 2.3, 0.0]),
            view([9.4, 5.4, 4.0], [0.0, 2.1, 0.0]),
        ],
    ),
    shot(
        1,
        &[
            view([0.0, 15.0, 2.0], [0.0, 2.0, -1.0]).tilted(0.0, -1.0),
            view([-0.8, 12.5, 1.6], [-0.8, 2.8, 0.0]).tilted(0.0, -1.0),
            view([-2.406, 7.1, 1.226], [-2.406, 3.62, 1.226]).tilted(0.0, -1.0),
        ],
    ),
];

static PAPER: Material = Material::matt(vec3(0.07, 0.16, 0.16), 0.8);
static BRASS: Material = Material {
    ks: 1.0,
    exponent: 10.0,
    metallic: 1.0,
    kr: 0.35,
    film_thickness: 330.0,
    anisotropy: 0.85,
    ..Material::matt(vec3(0.69, 0.355, 0.084), 0.46)
};
static BORE: Material = Material::matt(vec3(0.12, 0.05, 0.012), 0.8);
static BALL: Material = Material {
    ks: 0.5,
    exponent: 50.0,
    kr: 0.02,
    fresnel: 0.25,
    ..Material::matt(vec3(0.64, 0.035, 0.009), 0.85)
};
/// The light of a struck pipe's bore.
const GLOW: Vec3 = vec3(16.0, 11.0, 5.0);

const RADIUS: f32 = 0.52;
const BALL_RADIUS: f32 = 0.62;
/// The height of a hop above the line between two pipes.
const HOP: f32 = 1.1;
/// The depth to which a struck pipe sinks.
const SINK: f32 = 0.25;

/// Returns the middle of the upper end, at rest, of the pipe that sounds a note of the theme. Lower notes have longer pipes.
fn top(note: usize) -> Vec3 {
    let pitch = f32::from(THEME[note % 8]);
    around(note as f32 * 0.125 + 0.95) * 2.7 + Vec3::Y * (18.11 - 0.21 * pitch)
}

fn add(now: Now, scene: &mut Scene) {
    let chime = now.cue(Track::Chime);
    let struck = usize::from(chime.digit) - 1;
    // After the last landing the ball leaves, and the pipe glows on.
    let is_last = chime.count == 24;
    let u = chime.since;
    let glow = if is_last { 1.0 } else { 1.0 / (1.0 + 2.0 * u) };
    for note in 0..8 {
        let mut end = top(note);
        // Struck bores glow on.
        let age = u + ((struck + 8 - note) % 8) as f32;
        let mut bore = BORE;
        bore.colour += GLOW * (glow / (1.0 + age * age));
        if note == struck {
            end.y -= SINK * 4.0 * u * (1.0 - u) * glow;
            scene.lights[1].position = end + Vec3::Y * 0.05;
            scene.lights[1].colour = vec3(2.4, 1.4, 0.5) * glow;
        }
        let half = vec3(RADIUS, 0.5 * end.y, RADIUS);
        add_block(Shape::Cylinder, end - Vec3::Y * half.y, half, Mat3::IDENTITY, &BRASS, scene);
        let half = vec3(0.4, 0.004, 0.4);
        add_block(Shape::Cylinder, end, half, Mat3::IDENTITY, &bore, scene);
    }
    let from = top(struck);
    let to = if is_last { from.with_y(1.0) * 3.0 } else { top(struck + 1) };
    let up = BALL_RADIUS + 4.0 * HOP * u * (1.0 - u);
    add_sphere(from.lerp(to, u) + Vec3::Y * up, BALL_RADIUS, &BALL, scene);
}
