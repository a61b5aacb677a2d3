//! A field of small spheres: the model scene's floor and lights, with as many spheres on it as one likes.
//!
//! Shows how the time of a frame grows with the number of objects.

use super::model::{ORBIT_SPEED, model};
use super::path::orbit;
use super::random::Random;
use crate::scene::{MAX_SPHERES, Material, Scene, Sphere};
use glam::{Vec3A, vec3a};

/// The side of a full field, in scene units; the floor's is 24.
const SIDE: f32 = 16.0;
/// The most room for one sphere: a few spheres stay in the middle of the picture.
const CELL: f32 = 4.0;
/// The smallest radius and what chance adds to it: 320 spheres of the largest still fit the field side by side.
const RADIUS: (f32, f32) = (0.2, 0.2);
/// Chance begins here; another number is another field.
const SEED: u32 = 2008;

/// `count` spheres, or as many as a scene holds, at `time` seconds. None touch; six of ten are plastic, two mirrors and
/// two glass, by chance. The same count gives the same spheres.
#[must_use]
pub fn field(count: usize, time: f32) -> Scene {
    let count = count.min(MAX_SPHERES);
    // Each sphere has a cell of a square grid for itself.
    let cells = (1..).find(|n| n * n >= count).unwrap_or(1);
    let cell = (SIDE / cells as f32).min(CELL);
    let mut random = Random(SEED);
    let mut scene = Scene::default();
    model(time, &mut scene);
    scene.spheres.clear();
    for i in 0..count {
        let radius = RADIUS.0 + RADIUS.1 * random.share();
        let mut place = |cell_number: usize| {
            let room = cell - 2.0 * radius;
            let start = (cell_number as f32 - 0.5 * cells as f32) * cell;
            start + radius + room * random.share()
        };
        let centre = vec3a(place(i % cells), radius, place(i / cells));
        scene.spheres.push(Sphere {
            centre,
            radius,
            material: material(&mut random),
        });
    }
    scene.camera = orbit(vec3a(0.0, 0.4, 0.0), ORBIT_SPEED * time, 11.0, 4.5);
    scene
}

/// One of the model scene's kinds, in a colour of its own.
fn material(random: &mut Random) -> Material {
    let kind = random.share();
    let mut channel = || 0.12 + 0.8 * random.share();
    let colour = vec3a(channel(), channel(), channel());
    if kind < 0.6 {
        Material {
            colour,
            kd: 0.7,
            ks: 0.5,
            exponent: 40.0,
            kr: 0.2,
            kt: 0.0,
            index: 1.0,
            ..Material::BLACK
        }
    } else if kind < 0.8 {
        Material {
            colour: Vec3A::splat(0.6) + 0.4 * colour,
            kd: 0.2,
            ks: 0.8,
            exponent: 80.0,
            kr: 0.7,
            kt: 0.0,
            index: 1.0,
            ..Material::BLACK
        }
    } else {
        Material {
            colour: Vec3A::splat(0.95),
            kd: 0.05,
            ks: 0.8,
            exponent: 100.0,
            kr: 0.1,
            kt: 0.85,
            index: 1.5,
            ..Material::BLACK
        }
    }
}
