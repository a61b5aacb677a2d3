//! A field of small spheres, with the model scene's floor and lights, to measure frame times by the
//! number of objects.

use super::model::{model, orbit};
use eightfold_tracer::scene::{MAX_SPHERES, Material, Scene, Sphere};
use glam::{Vec3, vec3};

/// The side of a full field, in scene units. The floor's side is 24.
const SIDE: f32 = 16.0;
/// The maximum side of a sphere's cell in scene units: few spheres stay near the centre.
const CELL: f32 = 4.0;
/// The minimum radius, and the maximum random addition, in scene units. Even 320 of the largest
/// spheres fit.
const RADIUS: (f32, f32) = (0.2, 0.2);
const SEED: u32 = 2008;

/// Returns a field of `count` spheres, at most [`MAX_SPHERES`], that do not touch: plastic with
/// probability 0.6, mirrors with 0.2, glass with 0.2. It depends only on `count`.
#[must_use]
pub fn field(count: usize, time: f32) -> Scene {
    let count = count.min(MAX_SPHERES);
    let cells = (1..).find(|n| n * n >= count).unwrap_or(1);
    let cell = (SIDE / cells as f32).min(CELL);
    let mut random = Random(SEED);
    let mut scene = Scene::default();
    model(time, &mut scene);
    scene.spheres.clear();
    for i in 0..count {
        let radius = RADIUS.0 + RADIUS.1 * random.fraction();
        let mut coordinate = |cell_number: usize| {
            let room = cell - 2.0 * radius;
            let start = (cell_number as f32 - 0.5 * cells as f32) * cell;
            start + radius + room * random.fraction()
        };
        let centre = vec3(coordinate(i % cells), radius, coordinate(i / cells));
        let material = material(&mut random);
        scene.spheres.push(Sphere::new(centre, radius, material));
    }
    scene.camera = orbit(time, 0.4, 11.0, 4.5);
    scene
}

fn material(random: &mut Random) -> Material {
    let kind = random.fraction();
    let mut channel = || 0.12 + 0.8 * random.fraction();
    let colour = vec3(channel(), channel(), channel());
    if kind < 0.6 {
        Material { colour, kd: 0.7, ks: 0.5, exponent: 40.0, kr: 0.2, ..Material::BLACK }
    } else if kind < 0.8 {
        Material {
            colour: Vec3::splat(0.6) + 0.4 * colour,
            kd: 0.2,
            ks: 0.8,
            exponent: 80.0,
            kr: 0.7,
            ..Material::BLACK
        }
    } else {
        Material {
            colour: Vec3::splat(0.95),
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

/// Pseudorandom numbers: SplitMix of Steele, Lea and Flood with the 32-bit mixer of Wellons and
/// Mulvey.
struct Random(u32);

impl Random {
    fn fraction(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9);
        let mut h = self.0;
        h = (h ^ (h >> 16)).wrapping_mul(0x7feb_352d);
        h = (h ^ (h >> 15)).wrapping_mul(0x846c_a68b);
        h ^= h >> 16;
        (h >> 8) as f32 / (1 << 24) as f32
    }
}
