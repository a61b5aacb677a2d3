//! The kaleidoscope: balls and brass pipes on marble around the only light, folded into eight.

use super::planet::GIANT;
use crate::show::environment::{Environment, Now, point, softbox};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{add_block, add_sphere, around};
use crate::sound::Track;
use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::{Ambience, Light, Material, Pattern, Scene, Shape};
use glam::{Mat3, Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.02, 0.03, 0.08),
    ambient: vec3(0.02, 0.025, 0.05),
    ambience: Ambience { occlusion: 1.0, reach: 2.0, ground: vec3(0.11, 0.08, 0.055), bounce: 1.0 },
    vignette: 0.1,
    floor: Some(&MARBLE),
    lights: &[Light {
        drawn_radius: 1.5,
        diameter: 1.6,
        core: 1.5,
        glow: 0.12,
        ..point([0.0, 8.0, 0.0], [1.9, 1.4, 0.9])
    }],
    softboxes: &[softbox([0.3, 1.0, 0.0], [2.5, 2.5, 2.5], [2.2, 2.2, 2.2])],
    field_of_view: 0.9,
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
        view([0.0, 20.7, 0.0], [0.0; 3]).tilted(0.0, -1.0),
        view([0.0, 19.0, 0.0], [0.0; 3]).tilted(0.0, -1.0),
    ],
)];

static MARBLE: Material = Material {
    pattern: Pattern {
        waves: vec3(0.16, 0.0, 0.0),
        depth: 1.0,
        edge: 0.9,
        grain: 0.16,
        swirl: 0.3,
        tint: vec3(0.14, 0.05, 0.16),
        ..Pattern::NONE
    },
    ..Material::matt(vec3(0.02, 0.05, 0.3), 0.9)
};
static PEARL: Material =
    Material { ks: 0.3, exponent: 40.0, ..Material::matt(vec3(0.8, 0.7, 0.6), 1.0) };
// Matt: reflections of the other balls would move and pop.
static RED: Material =
    Material { ks: 0.25, exponent: 14.0, ..Material::matt(vec3(0.615, 0.02, 0.01), 0.95) };
static BRASS: Material = Material {
    ks: 1.0,
    exponent: 12.0,
    metallic: 1.0,
    anisotropy: 0.9,
    ..Material::matt(vec3(0.724, 0.34, 0.06), 0.35)
};

// A thick film, whose colours repeat in rings.
static OPAL: Material =
    Material { kr: 0.8, film_thickness: 700.0, ..Material::matt(vec3(0.01, 0.05, 0.1), 1.0) };

fn add(now: Now, scene: &mut Scene) {
    let kick = now.cue(Track::Kick);
    // A sixteenth of a turn per kick: balls and pipes stop next to a mirror, or on it.
    let turns = (kick.count as f32 + smooth_step(kick.since * 2.0)) * 0.0625;
    // The marble of the floor moves along.
    scene.planes[0].centre = around(turns) * 9.0;
    // A gold ring around the lamp.
    let half = vec3(3.3, 0.1, 3.3);
    add_block(Shape::Cylinder, Vec3::ZERO, half, Mat3::IDENTITY, &BRASS, scene);
    for number in 0..8 {
        let part = number as f32 / 8.0;
        // Pipes that end outside the picture are rays.
        let half = vec3(0.7, 8.0, 0.7);
        for i in [0.0, 0.0625] {
            let at = around(part - turns + i) * (8.2 + 80.0 * i);
            add_block(Shape::Cylinder, at + Vec3::Y * 8.0, half, Mat3::IDENTITY, &BRASS, scene);
        }
        let at = around(part + turns) * 5.2;
        add_sphere(at + Vec3::Y * 1.4, 1.4, [&RED, &PEARL][number % 2], scene);
        let at = around(part - turns + 0.0625) * 8.2 + Vec3::Y * 1.8;
        add_sphere(at, 1.8, [&GIANT, &OPAL][number % 2], scene);
    }
}
