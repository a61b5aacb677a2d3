//! A room of mirrors, in which a light walks about: four walls make endless halls of it.

use crate::show::act::{Act, Shot, shot};
use crate::show::material;
use crate::show::path::key;
use crate::show::props::{Motion::Bouncing, Prop, around, cuboid, cylinder, sphere, ticks};
use crate::show::set::{FAR, SHOW, Set, point};
use eightfold_tracer::scene::{Film, Light, Material, Pattern, Scene};
use glam::{Vec3, vec3};

/// The scene as a record.
pub(in crate::show) const ACT: Act = Act::new(&SET, SHOTS);

static SET: Set = Set {
    background: vec3(0.30, 0.20, 0.34),
    sky: vec3(-0.27, -0.16, -0.16),
    ambient: vec3(0.20, 0.18, 0.26),
    haze: 0.06,
    film: Film {
        // Mirrors of mirrors are dark, and full of edges.
        tolerance: 0.6,
        ..SHOW
    },
    floor: &FLOOR,
    floor_half: FAR,
    swell: 0.0,
    lights: &[
        // The light that walks, see `add`.
        Light {
            drawn_radius: 0.2,
            glow: 0.3,
            ..point([0.0, 1.6, 0.0], [1.10, 0.80, 0.45])
        },
        point([2.0, 7.0, -1.0], [0.34, 0.36, 0.52]),
    ],
    hit: 0.0,
    props: PROPS,
    special: Some(add),
};

/// Half the side of the room, in scene units.
const HALF: f32 = 5.0;

/// Large tiles without reflections, of which the mirrors show many.
static FLOOR: Material = Material {
    colour: vec3(0.62, 0.58, 0.62),
    pattern: Pattern {
        waves: vec3(0.2, 0.0, 0.2),
        depth: 0.4,
        edge: 40.0,
        ..Pattern::NONE
    },
    ..material::SANDSTONE
};

/// A mirror that shows nothing of its own.
static WALL: Material = Material {
    kr: 0.62,
    index: 1.0,
    ..Material::BLACK
};

#[rustfmt::skip]
static PROPS: &[Prop] = &[
    sphere(&material::RED, [0.0, 1.2, 0.0], 1.6),
    sphere(&material::GOLD, [-1.7, 0.6, 0.9], 0.9).moving(Bouncing { phase: 0.0 }),
    sphere(&material::BLUE, [1.6, 0.6, 1.0], 0.9).moving(Bouncing { phase: 2.0 }),
    // Two walls along z and two along x.
    cuboid(&WALL, [-HALF, 2.5, 0.0], [0.2, 5.0, 10.4]).repeat([2, 1], [2.0 * HALF, 0.0]),
    cuboid(&WALL, [0.0, 2.5, -HALF], [10.4, 5.0, 0.2]).repeat([1, 2], [0.0, 2.0 * HALF]),
    cylinder(&material::BRASS, [-3.4, 2.0, -3.4], [0.5, 4.0, 0.5]).repeat([2, 2], [6.8, 6.8]),
];

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(6, &[
        key([0.0, 1.5, 0.0], -0.6, 4.6, -0.4),
        key([0.0, 1.5, 0.0], -0.2, 4.6, 0.2).rolled(0.03),
        key([0.0, 1.5, 0.0], 0.3, 4.5, 0.6).rolled(0.03),
        key([0.0, 1.5, 0.0], 0.8, 4.4, 1.2),
    ]),
];

/// Has the light walk, `beat` beats after the act began: a step on each beat.
fn add(beat: f32, scene: &mut Scene) {
    scene.lights[0].position = around(0.06 * ticks(beat)) * 1.7 + Vec3::Y * 1.9;
}
