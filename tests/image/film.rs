use crate::drawn::{REFINEMENTS, draw_best};
use eightfold::show;
use eightfold_tracer::Quality;
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::Scene;

#[test]
fn film_tolerance_scales_quality_tolerances() {
    let mut scene = show::model_scene(1.0);
    let quality = Quality::DEFAULT;
    let halved = Quality {
        tolerance_agreeing: 0.5 * quality.tolerance_agreeing,
        tolerance_differing: 0.5 * quality.tolerance_differing,
        tolerance_side: 0.5 * quality.tolerance_side,
        key_weight: 0.25 * quality.key_weight,
        ..quality
    };
    let [whole, by_quality] =
        [quality, halved].map(|quality| draw_best(&scene, &quality, 160, 120));
    scene.film.tolerance = 0.5;
    let by_film = draw_best(&scene, &quality, 160, 120);
    assert!(by_film.pixels == by_quality.pixels);
    assert!(by_film.counts.points > whole.counts.points);
}

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
