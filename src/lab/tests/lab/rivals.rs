//! Frames of fewer pixels are those that people would draw.

use super::{cells, printed};
use eightfold::show;
use eightfold_lab::arguments::Size;
use eightfold_lab::error::Difference;
use eightfold_lab::rivals::{Way, draw};
use eightfold_lab::threaded_renderer::{ThreadedRenderer, drawn};
use eightfold_tracer::{Counts, Quality};
use eightfold_window::cpu;

const SIZE: Size = Size::new(96, 70);

/// Draws the model scene. Returns the picture and its work.
fn picture(way: Way) -> (Vec<u32>, Counts) {
    let mut renderer = ThreadedRenderer::new(1);
    let mut pixels = vec![u32::MAX; SIZE.area()];
    let (scene, quality) = (show::model_scene(2.0), Quality::EXHAUSTIVE);
    let level = cpu::best().level;
    let counts = draw(
        way,
        &mut renderer,
        level,
        &scene,
        &quality,
        SIZE.width,
        &mut pixels,
    );
    (pixels, counts)
}

#[test]
fn checkerboard_has_every_second_traced_pixel() {
    let (pixels, counts) = picture(Way::Checkerboard);
    let traced = drawn(1, &show::model_scene(2.0), &Quality::EXHAUSTIVE, SIZE);
    assert_eq!(counts.points as usize, SIZE.area() / 2);
    let (mut own, mut others) = (Vec::new(), Vec::new());
    for (i, pair) in pixels.into_iter().zip(traced).enumerate() {
        let is_traced = (i % SIZE.width + i / SIZE.width).is_multiple_of(2);
        if is_traced { &mut own } else { &mut others }.push(pair);
    }
    let psnr = |pairs: Vec<(u32, u32)>| {
        let (a, b): (Vec<u32>, Vec<u32>) = pairs.into_iter().unzip();
        Difference::between(&a, &b).psnr
    };
    // Rays through the same places are rounded otherwise.
    let (own, others) = (psnr(own), psnr(others));
    assert!(
        own > 55.0 && (24.0..45.0).contains(&others),
        "{own}, {others}"
    );
}

#[test]
fn enlarged_frames_are_better_the_larger_they_were() {
    let whole = picture(Way::Drawn).0;
    let psnr = [0.4, 0.7, 1.0].map(|scale| {
        let (pixels, counts) = picture(Way::Enlarged(scale));
        let share = counts.points as f64 / SIZE.area() as f64;
        assert!((share - scale * scale).abs() < 0.01, "{share}");
        Difference::between(&whole, &pixels).psnr
    });
    assert!(psnr[0] > 20.0 && psnr[1] > psnr[0] + 1.0 && psnr[2].is_infinite());
}

#[test]
fn race_has_a_line_for_each_quality() {
    let text = printed("bench --size 48x36 --frames 2 --views 1 --quality default --rivals");
    let (_, races) = text.split_once("|\n\n").expect("two tables");
    let lines = cells(races);
    assert_eq!(lines[0][6], "ahead by");
    let names: Vec<&str> = lines[1..].iter().map(|line| line[1]).collect();
    assert_eq!(names, ["default", "unguarded"]);
}
