use crate::drawn::draw_best;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Camera, List, Material, Plane, Scene, Sphere, Waves};
use glam::{Vec3, vec3};

/// Returns a red ball over a mirror, under a sky that is brighter above; the floor below the mirror is black.
fn sea(height: f32, water: Waves) -> Vec<u32> {
    let floor = |y: f32, material: Material| Plane::new(Vec3::Y * y, 1e3, 1e3, material);
    let red = Material::matt(Vec3::X, 0.0);
    let scene = Scene {
        camera: Camera::new(vec3(0.0, height, -10.0), Vec3::ZERO, 0.8),
        background: Vec3::splat(0.2),
        sky: Vec3::splat(0.6),
        ambient: Vec3::ONE,
        planes: List::of(&[floor(0.0, Material::mirror(1.0)), floor(-0.1, Material::BLACK)]),
        spheres: List::of(&[Sphere::new(vec3(0.0, 2.0, 4.0), 1.0, red)]),
        water,
        ..Scene::default()
    };
    draw_best(&scene, &Quality::EXHAUSTIVE, 160, 120).pixels
}

const ROUGH: Waves = Waves { slope: 0.1, length: 3.0, phase: 0.3 };

#[test]
fn no_wave_mirrors_the_floor_below_the_water() {
    for height in [9.0, 3.0, 1.0, 0.3, 0.1, 0.03] {
        for phase in [0.0, 0.2, 0.4, 0.6, 0.8] {
            let pixels = sea(height, Waves { phase, ..ROUGH });
            // The horizon is the darkest colour above the water.
            assert!(pixels.iter().all(|&pixel| pixel >> 16 >= 51), "{height}");
        }
    }
}
