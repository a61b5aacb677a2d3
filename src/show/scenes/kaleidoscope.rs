//! The kaleidoscope: gems around the only light, whose shadows are beams of their colours, folded into eight.

use crate::show::environment::{Environment, Now, point};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{add_sphere, around};
use crate::sound::Track;
use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::{Ambience, Light, Material, Scene};
use glam::{Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    // Seen only in the films.
    background: vec3(0.9, 0.35, 1.1),
    ambient: vec3(0.05, 0.02, 0.10),
    ambience: Ambience { occlusion: 1.0, reach: 2.0, ground: vec3(0.2, 0.08, 0.055), bounce: 1.0 },
    vignette: 0.3,
    floor: Some(&FLOOR),
    lights: &[Light {
        drawn_radius: 0.8,
        diameter: 1.8,
        core: 0.8,
        glow: 0.2,
        ..point([0.0, 5.0, 0.0], [3.2, 2.3, 1.8])
    }],
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

static FLOOR: Material = Material::matt(vec3(0.56, 0.35, 0.14), 0.9);

/// Returns a gem whose shadow has its colour.
const fn gem(red: f32, green: f32, blue: f32) -> Material {
    let colour = vec3(red, green, blue);
    Material {
        ks: 0.6,
        exponent: 30.0,
        kr: 0.12,
        fresnel: 0.4,
        tint: colour,
        ..Material::matt(colour, 0.9)
    }
}
static GEMS: [Material; 3] = [gem(0.6, 0.0, 0.03), gem(0.13, 0.01, 0.42), gem(0.9, 0.32, 0.02)];

/// Distances from the middle, radii, heights and directions of turning.
static RINGS: [[f32; 4]; 3] = [[4.1, 1.45, 2.4, 1.0], [8.6, 1.3, 1.3, -1.0], [12.6, 2.0, 2.0, 1.0]];

fn add(now: Now, scene: &mut Scene) {
    let kick = now.cue(Track::Kick);
    // A sixteenth of a turn per kick: gems stand next to a mirror, or on it.
    let turns = (kick.count as f32 + smooth_step(kick.since * 2.0)) * 0.0625;
    // The lamp flares on each kick.
    scene.lights[0].colour *= 1.3 - 0.3 * smooth_step(kick.since);
    // Each of the first three booms adds a ring.
    let rings = RINGS.iter().take(now.cue(Track::Boom).count as usize);
    for (ring, &[distance, radius, height, direction]) in rings.enumerate() {
        for number in 0..8 {
            // Gems of the other rings stand between two of the first.
            let part = (number * 2 + ring.min(1)) as f32 * 0.0625;
            let at = around(part + turns * direction) * distance + Vec3::Y * height;
            let gem = if ring == 1 { 2 } else { number % 2 };
            add_sphere(at, radius, &GEMS[gem], scene);
        }
    }
    // Films grow, so their colours change.
    for gem in scene.spheres.iter_mut() {
        gem.material.film_thickness = 330.0 + 9.0 * now.beat;
    }
}
