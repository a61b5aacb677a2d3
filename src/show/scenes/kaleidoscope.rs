//! The kaleidoscope, folded into eight: rings of gems around the only light cast shadows of their
//! colours.

use crate::show::environment::{Environment, Now, point, softbox};
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
    background: vec3(0.3, 0.1, 0.5),
    ambient: vec3(0.03, 0.02, 0.10),
    ambience: Ambience { occlusion: 1.0, reach: 2.0, ground: vec3(0.2, 0.12, 0.12), bounce: 1.0 },
    vignette: 0.8,
    floor: Some(&FLOOR),
    lights: &[Light {
        drawn_radius: 0.8,
        diameter: 2.4,
        core: 0.8,
        glow: 0.3,
        ..point(LAMP, [3.7, 2.9, 2.4])
    }],
    // Gold filigree.
    softboxes: &[softbox([1.0, 0.35, 0.8], [0.8, 0.2, 0.25], [20.0, 13.0, 5.0])],
    field_of_view: 0.9,
    add,
    present: |now, presentation| {
        // Each boom doubles the sectors: 1, 2, 4, 8.
        presentation.sectors = (1 << now.cue(Track::Boom).count >> 1) as f32;
    },
    ..Environment::EMPTY
};

const LAMP: [f32; 3] = [0.0, 6.5, 0.0];

static SHOTS: &[Shot] = &[shot(
    6,
    // Straight down on the lamp, without a roll: gems rest on mirrors or halfway between, and are
    // cut by none.
    &[
        view([0.0, 20.7, 0.0], LAMP).tilted(0.0, -9.0),
        view([0.0, 18.0, 0.0], LAMP).tilted(0.0, -9.0),
        view([0.0, 19.0, 0.0], LAMP).tilted(0.0, -9.0),
        view([0.0, 17.5, 0.0], LAMP).tilted(0.0, -9.0),
        view([0.0, 19.0, 0.0], LAMP).tilted(0.0, -9.0),
    ],
)];

static FLOOR: Material = Material::matt(vec3(0.45, 0.36, 0.4), 0.9);

/// Pearl, ruby, amethyst and sapphire.
static COLOURS: [Vec3; 4] =
    [vec3(0.85, 0.75, 0.6), vec3(0.5, 0.0, 0.03), vec3(0.1, 0.01, 0.36), vec3(0.045, 0.03, 0.45)];

fn add(now: Now, scene: &mut Scene) {
    let kick = now.cue(Track::Kick);
    let kicked = 1.0 - smooth_step(kick.since);
    let mut turns = (kick.count as f32 + smooth_step(kick.since * 3.0)) * 0.0625;
    scene.lights[0].colour *= 1.0 + 0.3 * kicked;
    let mut distance = 3.0 + 0.22 * kicked;
    // Each of the first three booms adds a ring.
    for &colour in COLOURS.iter().take(now.cue(Track::Boom).count as usize + 1) {
        // Shadows have the colour, too. Films grow, so their colours change.
        // No highlights: pairs at a mirror look like eyes.
        let gem = Material {
            // Below 0.3: every pixel of a crowd of mirrors is traced.
            kr: 0.18,
            film_thickness: 330.0 + 9.0 * now.beat,
            tint: colour,
            ..Material::matt(colour, 0.65)
        };
        for number in 0..8 {
            let out = around(number as f32 * 0.125 + turns);
            // Above the floor: all of the shadow of a sphere that cuts it would be traced.
            add_sphere((out + Vec3::Y * 0.34) * distance, 0.22 * distance, &gem, scene);
        }
        // The next ring turns back; its gems stand between.
        turns = 0.0625 - turns;
        distance *= 1.46;
    }
}
