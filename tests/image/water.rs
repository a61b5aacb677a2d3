//! Waves on the first plane.

use crate::drawn::draw_best;
use crate::error::Difference;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Camera, List, Material, Plane, Scene, Sphere, Waves};
use glam::{Vec3, vec3};

const WIDTH: usize = 160;
const HEIGHT: usize = 120;

/// A mirror seen from a height, under a sky that is brighter above; deep below it a black floor.
fn sea(height: f32, waves: Waves) -> Scene {
    let mirror = Material::mirror(1.0);
    let floor = |y: f32, material: Material| Plane::new(Vec3::Y * y, 1e3, 1e3, material);
    Scene {
        camera: Camera {
            eye: vec3(0.0, height, -10.0),
            look_at: Vec3::ZERO,
            ..Camera::default()
        },
        background: Vec3::splat(0.2),
        sky: Vec3::splat(0.6),
        planes: List::of(&[floor(0.0, mirror), floor(-0.1, Material::BLACK)]),
        water: waves,
        ..Scene::default()
    }
}

const ROUGH: Waves = Waves {
    slope: 0.1,
    length: 3.0,
    phase: 0.3,
};

fn picture(scene: &Scene) -> Vec<u32> {
    let quality = Quality::EXHAUSTIVE;
    draw_best(scene, &quality, WIDTH, HEIGHT).pixels
}

/// How many pixels differ.
fn differing(a: &[u32], b: &[u32]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a != b).count()
}

#[test]
fn water_without_slope_is_a_flat_mirror() {
    let calm = Waves {
        slope: 0.0,
        ..ROUGH
    };
    let flat = picture(&sea(3.0, Waves::CALM));
    assert_eq!(flat, picture(&sea(3.0, calm)));
    let rough = picture(&sea(3.0, ROUGH));
    assert!(4 * differing(&flat, &rough) > rough.len());
}

#[test]
fn no_wave_mirrors_what_is_below_the_water() {
    for height in [9.0, 3.0, 1.0, 0.3, 0.1, 0.03] {
        for phase in [0.0, 0.2, 0.4, 0.6, 0.8] {
            let pixels = picture(&sea(height, Waves { phase, ..ROUGH }));
            // Nothing above is darker than the horizon.
            assert!(pixels.iter().all(|&pixel| pixel & 0xff >= 51), "{height}");
        }
    }
}

#[test]
fn what_is_mirrored_moves_with_the_waves_and_comes_back() {
    let mut scene = sea(4.0, ROUGH);
    scene.ambient = Vec3::ONE;
    scene.spheres.push(Sphere::new(
        vec3(0.0, 2.0, 4.0),
        1.0,
        Material {
            colour: Vec3::X,
            ..Material::BLACK
        },
    ));
    let mut at = |phase: f32| {
        scene.water.phase = phase;
        picture(&scene)
    };
    let first = at(0.0);
    assert!(5 * differing(&first, &at(0.1)) > first.len());
    // 3^6 lengths: each wave goes on by 4/3 times as many as the one before, of which there are six.
    let psnr = Difference::between(&first, &at(729.0)).psnr;
    assert!(psnr > 45.0, "{psnr} dB");
}

#[test]
fn waves_that_are_too_fine_to_be_drawn_are_calm() {
    // At the nearest point of the water a pixel sees more than a tenth of the length.
    let fine = Waves {
        length: 0.3,
        ..ROUGH
    };
    let flat = picture(&sea(9.0, Waves::CALM));
    assert_eq!(flat, picture(&sea(9.0, fine)));
}
