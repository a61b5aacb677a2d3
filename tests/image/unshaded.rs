//! Shadows that lie between the corners of squares: each is shown in a pixel, and few of all their pixels are lit.
//!
//! Measured: lit are 0.27 % of the pixels of small spheres' shadows by the finest quality, 0.33 % by the default one, and
//! 0.13 % by the rules of 2008; the largest patches are of 16, 16 and 9 pixels. Unguarded, these are 4 to 10 %, and patches
//! of 78 to 125 pixels.

use crate::cpu;
use crate::drawn::draw;
use crate::refinement::bare;
use crate::wrong::largest_patch;
use eightfold::Quality;
use eightfold::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use glam::{Vec3A, vec3a};
use std::collections::BTreeSet;

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
        (Quality::LADDER[0], 0.0035, 20),
        (Quality::DEFAULT, 0.004, 20),
        (Quality::THESIS, 0.002, 12),
    ];
    for (quality, most, largest) in limits {
        let mut chance = Chance(2008);
        let (mut shaded, mut missed, mut patch) = (0, 0, 0);
        for _ in 0..SCENES {
            let scene = scene(&mut chance);
            let draw = |quality| draw(cpu::best(), 2, &scene, &quality, WIDTH, HEIGHT).pixels;
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

/// The numbers of the spheres that shade the point of the floor that a pixel of the plain floor shows.
fn casters(scene: &Scene, pixel: usize) -> Vec<usize> {
    let raster = scene.camera.raster(WIDTH, HEIGHT);
    let (eye, lamp) = (
        scene.camera.eye.as_dvec3(),
        scene.lights[0].position.as_dvec3(),
    );
    let (x, y) = (pixel % WIDTH, pixel / WIDTH);
    let d = raster.corner.as_dvec3()
        + x as f64 * raster.dx.as_dvec3()
        + y as f64 * raster.dy.as_dvec3();
    let way = (eye - d * (eye.y / d.y) - lamp).normalize();
    let shades = |sphere: &Sphere| {
        let to = sphere.centre.as_dvec3() - lamp;
        let off = to - way * to.dot(way);
        off.length() < f64::from(sphere.radius)
    };
    let numbers = scene.spheres.iter().enumerate();
    numbers.filter(|(_, s)| shades(s)).map(|(i, _)| i).collect()
}

/// The spheres whose shadow some pixels show.
fn thrown(scene: &Scene, shaded: impl Iterator<Item = usize>) -> BTreeSet<usize> {
    shaded.flat_map(|pixel| casters(scene, pixel)).collect()
}

#[test]
fn every_shadow_that_a_pixel_can_show_is_shown_and_the_bare_rules_miss_some() {
    let mut shadows = 0;
    let mut bare_misses = 0;
    for seed in 0..SCENES {
        let scene = scene(&mut Chance(seed));
        let draw = |quality| draw(cpu::best(), 2, &scene, &quality, WIDTH, HEIGHT).pixels;
        let exhaustive = draw(Quality::EXHAUSTIVE);
        let is_shaded = |pixels: &[u32], i: usize| pixels[i] == SHADED && exhaustive[i] == SHADED;
        let of =
            |pixels: Vec<u32>| thrown(&scene, (0..pixels.len()).filter(|&i| is_shaded(&pixels, i)));
        let all = of(exhaustive.clone());
        shadows += all.len();
        for quality in Quality::LADDER.iter().copied().chain([Quality::THESIS]) {
            let missed: Vec<_> = all.difference(&of(draw(quality))).copied().collect();
            assert!(missed.is_empty(), "{missed:?} of {seed} by {quality:?}");
        }
        bare_misses += all.difference(&of(draw(bare(Quality::DEFAULT)))).count();
    }
    println!("{shadows} shadows, {bare_misses} of them missed by the bare rules");
    assert!(
        shadows > 1000 && bare_misses > 100,
        "{shadows}, {bare_misses}"
    );
}
