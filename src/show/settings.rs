//! Where things are: the air, the floor and the lamps of each scene.

use super::Set;
use super::material::{self, Stuff};
use super::steps::{PERCENT, TENTHS, TWENTIETHS, at, number, rgb, steps, vector};
use crate::scene::{Light, Method, Scene, Spot};
use glam::Vec3A;

/// The air and the floor of a scene, in bytes.
struct Setting {
    /// What rays see that hit nothing, level, and what that gains straight up.
    background: [i8; 3],
    sky: [i8; 3],
    ambient: [i8; 3],
    /// Thousandths.
    haze: i8,
    floor: Stuff,
    /// Half the floor's side in scene units.
    extent: i8,
}

/// Without an end.
const FAR: i8 = 100;

/// A row for each [`Set`].
#[rustfmt::skip]
static SETTINGS: [Setting; 6] = [
    setting(rgb(0.05, 0.07, 0.14), rgb(-0.04, -0.05, -0.08), rgb(0.10, 0.10, 0.10), 15, Stuff::Night, FAR),
    setting(rgb(0.10, 0.12, 0.20), rgb(0.0, 0.0, 0.0),       rgb(0.12, 0.12, 0.14), 0,  Stuff::Paper, 12),
    setting(rgb(0.78, 0.50, 0.36), rgb(-0.62, -0.26, 0.10),  rgb(0.16, 0.15, 0.20), 22, Stuff::Sandstone, FAR),
    setting(rgb(0.06, 0.07, 0.11), rgb(-0.03, -0.03, -0.03), rgb(0.10, 0.11, 0.15), 30, Stuff::Slate, FAR),
    setting(rgb(0.10, 0.12, 0.20), rgb(-0.08, -0.09, -0.12), rgb(0.12, 0.12, 0.15), 30, Stuff::Night, FAR),
    setting(rgb(0.55, 0.30, 0.22), rgb(-0.52, -0.24, -0.06), rgb(0.12, 0.11, 0.16), 30, Stuff::Dusk, FAR),
];

const fn setting(
    background: [i8; 3],
    sky: [i8; 3],
    ambient: [i8; 3],
    haze: i8,
    floor: Stuff,
    extent: i8,
) -> Setting {
    Setting {
        background,
        sky,
        ambient,
        haze,
        floor,
        extent,
    }
}

/// A lamp in bytes.
struct Lamp {
    set: Set,
    position: [i8; 3],
    colour: [i8; 3],
    kind: Kind,
    /// Its radius where it is seen, its diameter else; 20ths.
    size: i8,
}

#[derive(PartialEq)]
enum Kind {
    /// A ball of light.
    Seen,
    /// Unseen.
    Lamp,
    /// So far away that its rays are parallel.
    Sun,
    /// A cone: where it points, in tenths, and the cosines of its edges in percent.
    Spot([i8; 3], i8, i8),
}

#[rustfmt::skip]
static LAMPS: [Lamp; 14] = [
    lamp(Set::Title,     at(7.0, 8.0, -9.0),  rgb(1.25, 0.95, 0.62), Kind::Lamp, 0.0),
    lamp(Set::Title,     at(-9.0, 4.0, -5.0), rgb(0.30, 0.48, 0.95), Kind::Lamp, 0.0),
    lamp(Set::Model,     at(-4.0, 6.0, -4.0), rgb(0.90, 0.85, 0.80), Kind::Seen, 0.15),
    lamp(Set::Model,     at(5.0, 5.0, -2.0),  rgb(0.35, 0.40, 0.50), Kind::Seen, 0.15),
    lamp(Set::Colonnade, at(7.0, 4.2, -3.4),  rgb(1.00, 0.70, 0.40), Kind::Sun,  0.2),
    lamp(Set::Colonnade, at(-4.0, 5.0, -5.0), rgb(0.16, 0.22, 0.38), Kind::Sun,  0.0),
    lamp(Set::Colonnade, at(0.0, 9.0, 6.0),   rgb(0.45, 0.50, 0.65), spot(at(0.0, -1.0, 0.0), 0.955, 0.985), 1.2),
    lamp(Set::Machine,   at(-5.0, 9.0, -6.0), rgb(1.25, 1.05, 0.82), spot(at(5.0, -9.0, 6.0), 0.70, 0.95), 0.8),
    lamp(Set::Machine,   at(7.0, 5.0, 2.0),   rgb(0.35, 0.50, 0.95), Kind::Seen, 0.2),
    lamp(Set::Machine,   at(0.0, 2.2, 7.0),   rgb(0.60, 0.16, 0.08), Kind::Lamp, 0.0),
    lamp(Set::Swarm,     at(-8.0, 12.0, -6.0), rgb(1.00, 0.86, 0.70), Kind::Lamp, 1.5),
    lamp(Set::Swarm,     at(10.0, 6.0, 4.0),  rgb(0.16, 0.26, 0.55), Kind::Lamp, 0.0),
    lamp(Set::Finale,    at(4.0, 2.2, 6.0),   rgb(0.85, 0.50, 0.28), Kind::Sun,  0.3),
    lamp(Set::Finale,    at(-6.0, 8.0, -8.0), rgb(0.30, 0.36, 0.55), Kind::Lamp, 0.0),
];

const fn lamp(set: Set, position: [i8; 3], colour: [i8; 3], kind: Kind, size: f32) -> Lamp {
    Lamp {
        set,
        position,
        colour,
        kind,
        size: steps(size, TWENTIETHS),
    }
}

const fn spot(aim: [i8; 3], dark: f32, bright: f32) -> Kind {
    Kind::Spot(aim, steps(dark, PERCENT), steps(bright, PERCENT))
}

/// Takes the air, the floor and the lamps of a set into a scene.
pub(super) fn set(set: Set, scene: &mut Scene) {
    let row = &SETTINGS[set as usize];
    scene.background = vector(row.background, PERCENT);
    scene.sky = vector(row.sky, PERCENT);
    scene.ambient = vector(row.ambient, PERCENT);
    scene.method = Method::default();
    scene.haze = f32::from(row.haze) * 0.001;
    scene.planes.clear();
    let floor = scene.planes.grow();
    floor.centre = Vec3A::ZERO;
    floor.half_x = f32::from(row.extent);
    floor.half_z = floor.half_x;
    material::set(&mut floor.material, row.floor);
    scene.lights.clear();
    for lamp in LAMPS.iter().filter(|lamp| lamp.set == set) {
        let size = number(lamp.size, TWENTIETHS);
        let is_seen = lamp.kind == Kind::Seen;
        *scene.lights.grow() = Light {
            position: vector(lamp.position, TENTHS),
            colour: vector(lamp.colour, PERCENT),
            radius: if is_seen { size } else { 0.0 },
            parallel: lamp.kind == Kind::Sun,
            size: if is_seen { 0.0 } else { size },
            spot: match lamp.kind {
                Kind::Spot(aim, dark, bright) => Some(Spot {
                    aim: vector(aim, TENTHS).normalize(),
                    dark: number(dark, PERCENT),
                    bright: number(bright, PERCENT),
                }),
                _ => None,
            },
        };
    }
}
