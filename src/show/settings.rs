//! Where things are: the air, the floor and the lamps of each scene.

use super::Set;
use super::material::{self, Stuff};
use super::steps::{PERCENT, numbers, steps};
use crate::scene::{Scene, Spot};
use glam::Vec3A;

/// The air of each [`Set`] in percent, but for haze, which is a tenth of that, and half its floor's side, which is a hundred
/// times as large.
#[rustfmt::skip]
static AIR: [[i8; 11]; 6] = [
    //    background, level  what it gains straight up  ambient light  haze  floor
    steps([0.05, 0.07, 0.14, -0.04, -0.05, -0.08,  0.10, 0.10, 0.10,  0.15, FAR],  PERCENT),
    steps([0.10, 0.12, 0.20,  0.0,   0.0,   0.0,   0.12, 0.12, 0.14,  0.0,  0.12], PERCENT),
    steps([0.78, 0.50, 0.36, -0.62, -0.26,  0.10,  0.16, 0.15, 0.20,  0.22, FAR],  PERCENT),
    steps([0.06, 0.07, 0.11, -0.03, -0.03, -0.03,  0.10, 0.11, 0.15,  0.3,  FAR],  PERCENT),
    steps([0.10, 0.12, 0.20, -0.08, -0.09, -0.12,  0.12, 0.12, 0.15,  0.3,  FAR],  PERCENT),
    steps([0.55, 0.30, 0.22, -0.52, -0.24, -0.06,  0.12, 0.11, 0.16,  0.3,  FAR],  PERCENT),
];

/// So far that haze hides where it ends.
const FAR: f32 = 1.0;

/// What the floor of each [`Set`] is made of.
static FLOORS: [Stuff; 6] = [
    Stuff::Night,
    Stuff::Paper,
    Stuff::Sandstone,
    Stuff::Slate,
    Stuff::Night,
    Stuff::Dusk,
];

/// A lamp.
struct Lamp {
    set: Set,
    is_sun: bool,
    /// See [`LAMPS`].
    row: [i8; 13],
}

/// Lamps in percent, but for places, which are ten times as far away.
#[rustfmt::skip]
static LAMPS: [Lamp; 13] = [
    //                    place              colour            seen as  throws shadows as  cone: aim, dark, bright
    lamp(Set::Title,     [0.7, 0.8, -0.9,   1.25, 0.95, 0.62,  0.0,  0.0,  0.0, 0.0, 0.0,  0.0, 0.0]),
    lamp(Set::Title,     [-0.9, 0.4, -0.5,  0.30, 0.48, 0.95,  0.0,  0.0,  0.0, 0.0, 0.0,  0.0, 0.0]),
    lamp(Set::Model,     [-0.4, 0.6, -0.4,  0.90, 0.85, 0.80,  0.15, 0.0,  0.0, 0.0, 0.0,  0.0, 0.0]),
    lamp(Set::Model,     [0.5, 0.5, -0.2,   0.35, 0.40, 0.50,  0.15, 0.0,  0.0, 0.0, 0.0,  0.0, 0.0]),
    sun(Set::Colonnade,  [0.7, 0.42, -0.34, 1.00, 0.70, 0.40,  0.0,  0.2,  0.0, 0.0, 0.0,  0.0, 0.0]),
    sun(Set::Colonnade,  [-0.4, 0.5, -0.5,  0.16, 0.22, 0.38,  0.0,  0.0,  0.0, 0.0, 0.0,  0.0, 0.0]),
    lamp(Set::Colonnade, [0.0, 0.9, 0.6,    0.45, 0.50, 0.65,  0.0,  1.2,  0.0, -1.0, 0.0, 0.96, 0.98]),
    lamp(Set::Machine,   [-0.5, 0.9, -0.6,  1.20, 1.01, 0.79,  0.0,  0.8,  0.5, -0.9, 0.6, 0.70, 0.95]),
    lamp(Set::Machine,   [0.8, 0.7, 0.2,    0.35, 0.50, 0.95,  0.2,  0.0,  0.0, 0.0, 0.0,  0.0, 0.0]),
    lamp(Set::Swarm,     [-0.8, 1.2, -0.6,  1.00, 0.86, 0.70,  0.0,  1.25, 0.0, 0.0, 0.0,  0.0, 0.0]),
    lamp(Set::Swarm,     [1.0, 0.6, 0.4,    0.16, 0.26, 0.55,  0.0,  0.0,  0.0, 0.0, 0.0,  0.0, 0.0]),
    sun(Set::Finale,     [0.4, 0.22, 0.6,   0.85, 0.50, 0.28,  0.0,  0.3,  0.0, 0.0, 0.0,  0.0, 0.0]),
    lamp(Set::Finale,    [-0.6, 0.8, -0.8,  0.30, 0.36, 0.55,  0.0,  0.0,  0.0, 0.0, 0.0,  0.0, 0.0]),
];

const fn lamp(set: Set, row: [f32; 13]) -> Lamp {
    Lamp {
        set,
        is_sun: false,
        row: steps(row, PERCENT),
    }
}

const fn sun(set: Set, row: [f32; 13]) -> Lamp {
    Lamp {
        is_sun: true,
        ..lamp(set, row)
    }
}

/// Takes the air, the floor and the lamps of a set into a scene.
#[inline(never)]
pub(super) fn set(set: Set, scene: &mut Scene) {
    let row = numbers(&AIR[set as usize], PERCENT);
    scene.background = Vec3A::from_slice(&row);
    scene.sky = Vec3A::from_slice(&row[3..]);
    scene.ambient = Vec3A::from_slice(&row[6..]);
    scene.haze = row[9] * 0.1;
    scene.planes.clear();
    let floor = scene.planes.grow();
    floor.centre = Vec3A::ZERO;
    floor.half_x = row[10] * 100.0;
    floor.half_z = floor.half_x;
    material::set(&mut floor.material, FLOORS[set as usize]);
    scene.lights.clear();
    for lamp in &LAMPS {
        if lamp.set != set {
            continue;
        }
        let row = numbers(&lamp.row, PERCENT);
        let light = scene.lights.grow();
        light.position = Vec3A::from_slice(&row) * 10.0;
        light.colour = Vec3A::from_slice(&row[3..]);
        light.radius = row[6];
        light.size = row[7];
        light.parallel = lamp.is_sun;
        let (aim, dark, bright) = (Vec3A::from_slice(&row[8..]), row[11], row[12]);
        light.spot = (bright > 0.0).then(|| Spot {
            aim: aim.normalize(),
            dark,
            bright,
        });
    }
}
