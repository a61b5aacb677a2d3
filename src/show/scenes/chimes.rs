//! The chimes: a ball strikes a tune on eight brass pipes around a lamp.

use crate::show::environment::{Environment, Now, point, softbox};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{add_block, add_sphere, around, fraction};
use crate::sound::{THEME, Track};
use eightfold_tracer::scene::{Light, Material, Scene, Shape, Spot};
use glam::{Mat3, Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.03, 0.09, 0.125),
    sky: vec3(-0.025, -0.08, -0.1),
    ambient: vec3(0.21, 0.16, 0.12),
    haze: 0.06,
    vignette: 0.3,
    lights: &[
        Light { diameter: 2.5, glow: 0.2, core: 0.5, ..point([0.0, 1.4, 0.0], [3.0, 1.7, 0.7]) },
        Light { glow: 0.2, spot: Some(Spot::new(Vec3::Y, 0.9)), ..point([0.0; 3], [0.0; 3]) },
    ],
    softboxes: &[softbox([-4.0, 0.0, 8.0], [1.0, 20.0, 1.25], [2.5, 2.0, 1.5])],
    field_of_view: 0.75,
    add,
    ..Environment::EMPTY
};

static SHOTS: &[Shot] = &[
    shot(
        5,
        &[
            view([-1.2, 3.6, 6.9], [-0.834, 2.76, 2.568]),
            view([1.5, 4.0, 9.5], [0.0, 2.25, 0.0]),
            view([4.0, 4.0, 9.5], [0.0, 2.25, 0.0]),
            view([6.5, 4.0, 7.75], [0.0, 2.25, 0.0]),
            view([8.75, 4.5, 5.25], [0.0, 2.1, 0.0]),
        ],
    ),
    shot(
        1,
        &[
            view([4.0, 8.1, 9.0], [0.0, 2.1, 0.0]),
            view([0.0, 8.8, 4.2], [-0.8, 3.2, 0.2]).tilted(0.0, -1.0),
            view([-2.406, 6.7, 1.226], [-2.406, 4.0, 1.226]).tilted(0.0, -1.0),
        ],
    ),
];

// A film of this thickness is gold, and white at grazing angles.
static BRASS: Material = Material {
    ks: 1.0,
    exponent: 8.0,
    metallic: 1.0,
    kr: 0.55,
    film_thickness: 158.0,
    anisotropy: 0.85,
    ..Material::matt(vec3(0.69, 0.355, 0.084), 0.4)
};
static FLOOR: Material = Material {
    ks: 1.0,
    exponent: 6.0,
    metallic: 1.0,
    ..Material::matt(vec3(0.3, 0.12, 0.045), 0.45)
};
static BORE: Material = Material::matt(vec3(1.0, 0.3, 0.06), 0.8);
static EMBER: Material = Material::matt(vec3(9.0, 2.6, 0.4), 1.0);
/// A film, no mirror: images of embers and bores in the ball are smaller than a square.
static BALL: Material = Material {
    ks: 0.5,
    exponent: 50.0,
    kr: 0.08,
    fresnel: 0.7,
    film_thickness: 100.0,
    ..Material::matt(vec3(0.95, 0.055, 0.012), 0.85)
};
/// The light of a struck pipe's bore.
const GLOW: Vec3 = vec3(24.0, 13.0, 4.0);

const RADIUS: f32 = 0.42;
const BALL_RADIUS: f32 = 0.62;
/// The height of a hop above the line between two pipes.
const HOP: f32 = 0.9;
/// The depth to which a struck pipe sinks.
const SINK: f32 = 0.25;

/// Returns the middle of the upper end, at rest, of the pipe of a note of the theme. Lower notes
/// have longer pipes.
fn top(note: usize) -> Vec3 {
    let pitch = f32::from(THEME[note % 8]);
    around(note as f32 * 0.125 + 0.95) * 2.7 + Vec3::Y * (22.1 - 0.2625 * pitch)
}

fn add(now: Now, scene: &mut Scene) {
    let chime = now.cue(Track::Chime);
    let struck = usize::from(chime.digit) - 1;
    // After the last landing the ball leaves, and the pipe glows on.
    let is_last = chime.count == 24;
    let u = chime.since;
    let glow = if is_last { 1.0 } else { 1.0 / (1.0 + 2.0 * u) };
    // The lamp goes out, so that the last mouth is the only disc.
    scene.lights[0].colour *= if is_last { 1.0 - u } else { 0.7 + 0.5 * glow };
    // A plane, with guarded shadows, takes 7 % more time.
    add_block(Shape::Box, Vec3::NEG_Y, vec3(99.0, 1.0, 99.0), Mat3::IDENTITY, &FLOOR, scene);
    for note in 0..8 {
        let mut end = top(note);
        // In beats: bores glow on.
        let age = u + ((struck + 8 - note) % 8) as f32;
        let mut bore = BORE;
        let fade = age * age;
        bore.colour += GLOW * (glow / (1.0 + 4.0 * fade * fade));
        if note == struck {
            end.y -= SINK * 4.0 * u * (1.0 - u) * glow;
            scene.lights[1].position = end + Vec3::Y * 0.006;
            scene.lights[1].colour = GLOW * (0.1 * glow);
        }
        let half = vec3(RADIUS, 0.5 * end.y, RADIUS);
        add_block(Shape::Cylinder, end - Vec3::Y * half.y, half, Mat3::IDENTITY, &BRASS, scene);
        let half = vec3(0.35, 0.004, 0.35);
        add_block(Shape::Cylinder, end, half, Mat3::IDENTITY, &bore, scene);
        // Embers rise for two beats.
        for number in 0..4 {
            let number = (4 * note + number) as f32;
            let drift = around(number * 0.618) * (0.3 + 0.2 * age);
            let up = Vec3::Y * age * (0.6 + fraction(number * 0.755));
            if age < 2.0 {
                add_sphere(end + drift + up, 0.06 - 0.02 * age, &EMBER, scene);
            }
        }
    }
    let from = top(struck);
    let to = if is_last { from.with_y(1.0) * 3.0 } else { top(struck + 1) };
    let up = BALL_RADIUS + 4.0 * HOP * u * (1.0 - u);
    add_sphere(from.lerp(to, u) + Vec3::Y * up, BALL_RADIUS, &BALL, scene);
}
