use crate::drawn::{REFINEMENTS, draw_best};
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::Scene;

#[test]
fn dither_keeps_means_between_two_steps() {
    let (width, height) = (70, 46);
    for quality in REFINEMENTS {
        for sixteenths in 0..=16 {
            let mut scene = Scene {
                background: Vec3::splat((10.0 + sixteenths as f32 / 16.0) / 255.0),
                ..Scene::default()
            };
            scene.film.dither = 1.0;
            let drawn = draw_best(&scene, &quality, width, height);
            let at = |x: usize, y: usize| drawn.pixels[y * width + x] & 0xff;
            // In any 4x4 pixels, the number of brighter ones is the fraction in sixteenths.
            for (left, top) in [(0, 0), (13, 7), (33, 30), (66, 42)] {
                let sum: u32 = (0..16).map(|i| at(left + i % 4, top + i / 4)).sum();
                assert!(sum.abs_diff(160 + sixteenths) <= 1, "{sum}, {sixteenths}");
            }
            assert!((0..width).all(|x| at(x, 0) == at(x % 4, 0)));
        }
    }
}
