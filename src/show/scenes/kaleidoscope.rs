//! The kaleidoscope: balls on marble around the only light, folded into eight.

use crate::show::environment::{Environment, Now, point};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{add_block, add_sphere, around};
use crate::sound::Track;
use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::{Ambience, Light, Material, Pattern, Scene, Shape};
use glam::{Mat3, Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.05, 0.03, 0.05),
    ambient: vec3(0.06, 0.066, 0.11),
    ambience: Ambience { occlusion: 1.0, reach: 1.5, ground: vec3(0.11, 0.08, 0.055), bounce: 1.0 },
    vignette: 0.1,
    floor: Some(&PAPER),
    lights: &[Light {
        drawn_radius: 1.5,
        diameter: 3.6,
        glow: 0.7,
        ..point([0.0, 15.0, 0.0], [1.7, 1.45, 1.15])
    }],
    field_of_view: 0.5,
    add,
    present: |now, presentation| {
        // Each boom doubles the sectors: 1, 2, 4, 8.
        presentation.sectors = (1 << now.cue(Track::Boom).count >> 1) as f32;
    },
    ..Environment::EMPTY
};

static SHOTS: &[Shot] = &[shot(
    6,
    &[
        view([0.0, 39.2, 0.0], [0.0; 3]).tilted(0.0, -1.0),
        view([0.0, 39.2, 0.0], [0.0; 3]).tilted(0.0, -1.0),
    ],
)];

static PAPER: Material = Material {
    pattern: Pattern {
        waves: vec3(0.16, 0.0, 0.0),
        depth: 1.0,
        edge: 0.9,
        grain: 0.16,
        swirl: 0.3,
        tint: vec3(0.14, 0.05, 0.16),
        ..Pattern::NONE
    },
    ..Material::matt(vec3(0.07, 0.12, 0.38), 0.9)
};
static RED: Material =
    Material { ks: 0.25, exponent: 14.0, ..Material::matt(vec3(0.615, 0.038, 0.014), 0.95) };
static PEARL: Material =
    Material { ks: 0.3, exponent: 40.0, ..Material::matt(vec3(1.0, 0.95, 0.86), 1.0) };
static BRASS: Material = Material {
    ks: 0.5,
    exponent: 14.0,
    metallic: 1.0,
    ..Material::matt(vec3(0.724, 0.394, 0.084), 0.8)
};

static BALLS: [&Material; 4] = [&RED, &BRASS, &RED, &PEARL];

fn add(now: Now, scene: &mut Scene) {
    let kick = now.cue(Track::Kick);
    // A sixteenth of a turn per kick: balls stand next to a mirror, or on it.
    let turns = (kick.count as f32 + smooth_step(kick.since * 2.0)) * 0.0625;
    // The marble of the floor moves along.
    scene.planes[0].centre = around(turns) * 9.0;
    let half = vec3(3.5, 0.9, 3.5);
    add_block(Shape::Cylinder, Vec3::Y * 0.9, half, Mat3::IDENTITY, &BRASS, scene);
    for number in 0..8 {
        let part = number as f32 / 8.0;
        let [near, far] = [0, 2].map(|i| BALLS[(number + i) % 4]);
        add_sphere(around(part + turns) * 7.4 + Vec3::Y * 2.3, 2.3, near, scene);
        add_sphere(around(part - turns + 0.0625) * 13.0 + Vec3::Y * 1.9, 1.9, far, scene);
    }
}
