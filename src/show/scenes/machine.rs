//! An orrery: planets on brass arms, moved by a clockwork on the beat, around a flashing sun.

use crate::show::environment::{Environment, FAR, SHOW, point};
use crate::show::material;
use crate::show::path::keyframe;
use crate::show::props::{Prop, add_block, add_rod, add_sphere, around, cylinder, ticks};
use crate::show::scene::{Shot, ShowScene, shot};
use eightfold_tracer::scene::{Light, Material, Scene, Shape, Spot};
use glam::{Mat3, Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.34, 0.18, 0.14),
    sky: vec3(-0.32, -0.16, -0.08),
    ambient: vec3(0.10, 0.11, 0.15),
    haze: 0.03,
    film: SHOW,
    floor: &material::WATER,
    floor_half: FAR,
    swell: 0.0,
    lights: &[
        // The orrery's sun.
        Light { drawn_radius: 0.5, glow: 0.6, ..point([0.0, HEIGHT, 0.0], [0.87, 0.66, 0.35]) },
        Light {
            diameter: 0.8,
            spot: Some(Spot {
                aim: vec3(0.5, -0.9, 0.6),
                inner_angle: 0.317_560_4,
                outer_angle: 0.795_398_83,
            }),
            ..point([-5.0, 10.0, -6.0], [0.45, 0.50, 0.70])
        },
    ],
    kick_response: 1.0,
    props: PROPS,
    procedural: Some(add),
};

#[rustfmt::skip]
static PROPS: &[Prop] = &[
    cylinder(&material::STEEL, [0.0, 0.15, 0.0], [3.0, 0.3, 3.0]),
    cylinder(&material::BRASS, [0.0, 1.2, 0.0], [0.3, 2.0, 0.3]),
];

#[rustfmt::skip]
static SHOTS: &[Shot] = &[
    shot(3, &[
        keyframe([0.0, 1.3, 0.0], -1.4, 5.5, 1.6).rolled(0.05),
        keyframe([0.0, 1.5, 0.0], -0.9, 6.5, 1.8),
        keyframe([0.0, 1.7, 0.0], -0.32, 8.4, 2.0),
        keyframe([0.0, 1.7, 0.0], 0.2, 10.4, 3.0),
    ]),
    shot(3, &[
        keyframe([0.0, 2.0, 0.0], 4.0, 6.0, 0.4).rolled(-0.05),
        keyframe([0.0, 1.9, 0.0], 3.7, 7.0, 1.6),
        keyframe([0.0, 1.8, 0.0], 3.3, 8.8, 3.4),
        keyframe([0.0, 1.7, 0.0], 3.0, 9.2, 4.4),
    ]),
];

/// The height of the sun and the planets above the floor, in scene units.
const HEIGHT: f32 = 2.7;

const ROD: f32 = 0.06;

struct Planet {
    material: &'static Material,
    orbit: f32,
    radius: f32,
    /// Turns per beat.
    speed: f32,
}

#[rustfmt::skip]
static PLANETS: [Planet; 6] = [
    Planet { material: &material::SILVER, orbit: 0.95, radius: 0.13, speed: 0.25 },
    Planet { material: &material::GOLD, orbit: 1.35, radius: 0.24, speed: 0.1875 },
    Planet { material: &material::BLUE, orbit: 1.85, radius: 0.32, speed: 0.125 },
    Planet { material: &material::SCARLET, orbit: 2.4, radius: 0.25, speed: 0.09375 },
    Planet { material: &material::STRIPED, orbit: 3.1, radius: 0.55, speed: 0.0625 },
    Planet { material: &material::GOLD, orbit: 4.0, radius: 0.42, speed: 0.03125 },
];

const TILTED: Mat3 =
    Mat3::from_cols(vec3(0.96, 0.28, 0.0), vec3(-0.28, 0.96, 0.0), vec3(0.0, 0.0, 1.0));

fn add(beat: f32, scene: &mut Scene) {
    let ticks = ticks(beat);
    for (number, planet) in (0..).zip(&PLANETS) {
        planet.add(number as f32, ticks, scene);
    }
    let ringed = scene.spheres[PLANETS.len() - 1].centre;
    let ring = vec3(0.8, 0.02, 0.8);
    add_block(Shape::Cylinder, ringed, ring, TILTED, &material::SILVER, scene);
    // Two meshing wheels advance by a tooth per tick.
    add_wheel(Vec3::Y * 0.5, 1.5, 16, ticks / 16.0, scene);
    add_wheel(vec3(2.25, 0.5, 0.0), 0.65, 8, 0.0625 - ticks / 8.0, scene);
}

impl Planet {
    /// Adds a planet with its arm; `number` planets are closer to the sun.
    fn add(&self, number: f32, ticks: f32, scene: &mut Scene) {
        // The planets start at intervals of about the golden angle, 0.38 turns.
        let out = around(self.speed * ticks + 0.38 * number);
        let place = out * self.orbit;
        // Longer arms are lower than shorter ones, to avoid their stems.
        let low = 1.65 - 0.15 * number;
        let [hub, elbow, top] = [Vec3::Y * low, place + Vec3::Y * low, place + Vec3::Y * HEIGHT];
        let side = Vec3::Y.cross(out);
        // The stem is slightly thinner, so that its end is hidden in the arm's.
        for (ends, radius) in [([hub, elbow], ROD), ([elbow, top], 0.98 * ROD)] {
            add_rod(ends, side, radius, &material::BRASS, scene);
        }
        add_sphere(top, self.radius, self.material, scene);
    }
}

fn add_wheel(centre: Vec3, radius: f32, teeth: u8, turns: f32, scene: &mut Scene) {
    let mut add = |shape, centre, half, axes| {
        add_block(shape, centre, half, axes, &material::BRASS, scene);
    };
    add(Shape::Cylinder, centre, vec3(radius, 0.1, radius), Mat3::IDENTITY);
    for tooth in 0..teeth {
        let out = around(f32::from(tooth) / f32::from(teeth) + turns);
        let half = vec3(0.11, 0.085, 0.12);
        add(Shape::Box, centre + out * (radius + 0.08), half, axes(out));
    }
}

fn axes(z: Vec3) -> Mat3 {
    Mat3::from_cols(Vec3::Y.cross(z), Vec3::Y, z)
}
