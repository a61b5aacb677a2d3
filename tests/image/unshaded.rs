//! Shadows that lie between the corners of squares: nothing says that they are seen, so this says how often they are not.
//!
//! Measured: 2.7 % of the pixels of small spheres' shadows by the finest quality, 7.7 % by the default one, 9.2 % by the
//! rules of 2008; the largest patches are of 78, 108 and 125 pixels.

use crate::drawn::draw;
use crate::isa;
use crate::wrong::largest_patch;
use eightfold::Quality;
use eightfold::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use glam::{Vec3A, vec3a};

const WIDTH: usize = 320;
const HEIGHT: usize = 240;

/// Scenes by chance.
const SCENES: u64 = 60;

/// Numbers by chance, from 0 to 1 (Steele, Lea and Flood's SplitMix).
struct Chance(u64);

impl Chance {
    fn between(&mut self, low: f32, high: f32) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        let share = (z >> 40) as f32 / (1 << 24) as f32;
        low + (high - low) * share
    }
}

/// Red spheres in the air over a grey floor with one lamp; most of their shadows are some pixels wide.
fn scene(chance: &mut Chance) -> Scene {
    let sphere = |chance: &mut Chance| Sphere {
        centre: vec3a(
            chance.between(-5.0, 5.0),
            chance.between(0.5, 3.0),
            chance.between(-5.0, 5.0),
        ),
        radius: 10.0_f32.powf(chance.between(-2.0, -0.3)),
        material: Material {
            colour: Vec3A::X,
            ..Material::BLACK
        },
    };
    let spheres: Vec<Sphere> = (0..32).map(|_| sphere(chance)).collect();
    Scene {
        camera: Camera {
            eye: vec3a(chance.between(-6.0, 6.0), chance.between(2.0, 8.0), 11.0),
            look_at: Vec3A::ZERO,
            up: Vec3A::Y,
            field_of_view: chance.between(0.6, 1.0),
        },
        ambient: Vec3A::splat(0.2),
        spheres: List::of(&spheres),
        planes: List::of(&[Plane {
            centre: Vec3A::ZERO,
            half_x: 20.0,
            half_z: 20.0,
            material: Material {
                colour: Vec3A::splat(0.8),
                kd: 0.9,
                ..Material::BLACK
            },
        }]),
        lights: List::of(&[Light {
            position: vec3a(
                chance.between(-6.0, 6.0),
                chance.between(5.0, 9.0),
                chance.between(-6.0, 6.0),
            ),
            colour: Vec3A::ONE,
            ..Light::DARK
        }]),
        ..Scene::default()
    }
}

/// The floor without the lamp: 0.2 of 0.8, in steps of 255.
const SHADED: u32 = 0x29_2929;

#[test]
fn few_pixels_of_shadows_are_missed_and_their_patches_are_small() {
    // Of the shadows' pixels, and pixels of a patch.
    let limits = [
        (Quality::LADDER[0], 0.03, 80),
        (Quality::DEFAULT, 0.08, 110),
        (Quality::THESIS, 0.1, 130),
    ];
    for (quality, most, largest) in limits {
        let mut chance = Chance(2008);
        let (mut shaded, mut missed, mut patch) = (0, 0, 0);
        for _ in 0..SCENES {
            let scene = scene(&mut chance);
            let draw = |quality| draw(isa::best(), 2, &scene, &quality, WIDTH, HEIGHT).pixels;
            let exhaustive = draw(Quality::EXHAUSTIVE);
            let drawn = draw(quality);
            // A channel of what is lit is more than 8 of 255 above.
            let pairs = exhaustive.iter().zip(&drawn);
            let lit: Vec<bool> = pairs
                .map(|(&a, &b)| a == SHADED && b & 0xff > (SHADED & 0xff) + 8)
                .collect();
            shaded += exhaustive.iter().filter(|&&a| a == SHADED).count();
            missed += lit.iter().filter(|&&lit| lit).count();
            patch = patch.max(largest_patch(lit, WIDTH));
        }
        let share = missed as f64 / shaded as f64;
        println!("{share:.4} of {shaded} pixels, a patch of {patch} by {quality:?}");
        assert!(share <= most, "{share} of {shaded} by {quality:?}");
        assert!(patch <= largest, "a patch of {patch} by {quality:?}");
    }
}
