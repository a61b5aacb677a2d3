//! A room of four mirror walls, in which a light moves: endless halls.

use crate::show::environment::{Environment, FAR, SHOW, point};
use crate::show::material;
use crate::show::path::keyframe;
use crate::show::props::{Motion::Bouncing, Prop, around, cuboid, cylinder, sphere, ticks};
use crate::show::scene::{Shot, ShowScene, shot};
use eightfold_tracer::scene::{Film, Light, Material, Pattern, Scene};
use glam::{Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.30, 0.20, 0.34),
    sky: vec3(-0.27, -0.16, -0.16),
    ambient: vec3(0.20, 0.18, 0.26),
    haze: 0.06,
    film: Film {
        // Reflections of reflections are dark, and full of edges.
        tolerance: 0.5,
        ..SHOW
    },
    floor: &FLOOR,
    floor_half: FAR,
    swell: 0.0,
    lights: &[
        Light { drawn_radius: 0.2, glow: 0.3, ..point([0.0, 1.6, 0.0], [1.10, 0.80, 0.45]) },
        point([2.0, 7.0, -1.0], [0.34, 0.36, 0.52]),
    ],
    kick_response: 0.0,
    props: PROPS,
    procedural: Some(add),
};

/// Half the side of the room, in scene units.
const HALF: f32 = 5.0;

/// Large tiles, without reflections, which would appear in many mirrors.
static FLOOR: Material = Material {
    colour: vec3(0.62, 0.58, 0.62),
    pattern: Pattern { waves: vec3(0.2, 0.0, 0.2), depth: 0.4, edge: 40.0, ..Pattern::NONE },
    ..material::SANDSTONE
};

static WALL: Material = Material::mirror(0.56);

#[rustfmt::skip]
static PROPS: &[Prop] = &[
    sphere(&material::RED, [0.0, 1.2, 0.0], 1.6),
    sphere(&material::GOLD, [-1.7, 0.6, 0.9], 0.9).moving(Bouncing { phase: 0.0 }),
    sphere(&material::BLUE, [1.6, 0.6, 1.0], 0.9).moving(Bouncing { phase: 2.0 }),
    cuboid(&WALL, [-HALF, 2.5, 0.0], [0.2, 5.0, 10.4]).repeat([2, 1], [2.0 * HALF, 0.0]),
    cuboid(&WALL, [0.0, 2.5, -HALF], [10.4, 5.0, 0.2]).repeat([1, 2], [0.0, 2.0 * HALF]),
    cylinder(&material::BRASS, [-3.4, 2.0, -3.4], [0.5, 4.0, 0.5]).repeat([2, 2], [6.8, 6.8]),
];

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(6, &[
        keyframe([0.0, 1.5, 0.0], -0.6, 4.6, -0.4),
        keyframe([0.0, 1.5, 0.0], -0.2, 4.6, 0.2).rolled(0.03),
        keyframe([0.0, 1.5, 0.0], 0.3, 4.5, 0.6).rolled(0.03),
        keyframe([0.0, 1.5, 0.0], 0.8, 4.4, 1.2),
    ]),
];

fn add(beat: f32, scene: &mut Scene) {
    scene.lights[0].position = around(0.06 * ticks(beat)) * 1.7 + Vec3::Y * 1.9;
}
