//! How exact pictures of scenes far from the origin are, where numbers of 32 bits are coarse: the figures of [`eightfold_tracer::limits`].

use crate::drawn::draw_by_all;
use crate::error::Difference;
use eightfold::show;
use eightfold_oracle::frame::Frame;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use glam::{Vec3, vec3};

/// The scene moved.
fn moved(mut scene: Scene, by: Vec3) -> Scene {
    scene.camera.eye += by;
    scene.camera.look_at += by;
    for sphere in scene.spheres.iter_mut() {
        sphere.centre += by;
    }
    for plane in scene.planes.iter_mut() {
        plane.centre += by;
    }
    for light in scene.lights.iter_mut() {
        light.position += by;
    }
    assert!(scene.blocks.is_empty(), "they are not moved");
    scene
}

#[test]
fn the_further_from_the_origin_the_coarser_a_picture_is_as_stated() {
    // The distance in scene units, and the least PSNR in dB against the oracle, which draws the same numbers.
    for (distance, least) in [
        (0.0, 80.0),
        (1e2, 55.0),
        (1e3, 50.0),
        (1e4, 41.0),
        (1e5, 31.0),
    ] {
        let by = distance / 3.0 * vec3(2.0, 1.0, -2.0);
        for time in [0.0, 2.5] {
            let scene = moved(show::model_scene(time), by);
            let expected = Frame::new(&scene, &Quality::EXHAUSTIVE, 320, 240).picture();
            for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 320, 240) {
                let psnr = Difference::between(&expected, &drawn.pixels).psnr;
                let what = format!("{distance} away at {time} s by {}", isa.name);
                assert!(psnr >= least, "{what}: {psnr} dB");
            }
        }
    }
}
