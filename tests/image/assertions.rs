//! Frames never panic while glam asserts its conditions, which `tests/scenes` enables for all tests.

use crate::cpu::best;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold_scenes::{Random, any, cases};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Camera, MAX_LENGTH, Scene};
use glam::{Vec3, vec3};
use std::panic::catch_unwind;

fn draw(renderer: &mut ThreadedRenderer, scene: &Scene) {
    for quality in [Quality::THESIS, Quality::DEFAULT] {
        renderer.draw(best().level, scene, &quality, 48, &mut [0; 48 * 32]);
    }
}

/// Puts the eye and lights at, above, or in the middle of objects: directions and normals have no length.
fn degenerate(random: &mut Random) -> [Scene; 4] {
    let mut scene = any(random);
    let places = scene.spheres.iter().map(|sphere| sphere.centre);
    let places = places.chain(scene.blocks.iter().map(|block| block.centre));
    let places: Vec<Vec3> = places.chain([Vec3::ZERO]).collect();
    let place = places[random.below(places.len())];
    scene.camera.up = vec3(0.3, 1.0, 0.2);
    [place, place + 3.0 * Vec3::Y, place + Vec3::splat(1e-22), Vec3::splat(MAX_LENGTH)].map(|eye| {
        let mut scene = scene.clone();
        scene.camera.eye = eye;
        scene.camera.look_at = random.one_of([place, eye + Vec3::Z, eye + Vec3::NEG_Y]);
        let lights = scene.lights.iter_mut();
        lights.for_each(|light| light.position = random.one_of([eye, place, place + Vec3::Y]));
        if scene.validate().is_err() {
            scene.camera = Camera::default();
        }
        scene
    })
}

#[test]
fn glam_asserts_its_conditions() {
    assert!(catch_unwind(|| Vec3::ZERO.normalize()).is_err());
}

#[test]
fn valid_scenes_meet_all_conditions_of_glam() {
    let mut renderer = ThreadedRenderer::new(1);
    for mut random in cases(100) {
        let valid = any(&mut random);
        for scene in degenerate(&mut random).iter().chain([&valid]) {
            println!("case {}", random.seed);
            assert_eq!(scene.validate(), Ok(()));
            draw(&mut renderer, scene);
        }
    }
}
