use super::{cells, printed};
use eightfold::show;
use eightfold_harness::Size;
use eightfold_harness::error::Difference;
use eightfold_harness::threaded_renderer::{ThreadedRenderer, drawn};
use eightfold_lab::technique::{Sampling, Technique};
use eightfold_tracer::{Counts, Quality};
use eightfold_window::cpu;

const SIZE: Size = Size::new(96, 70);

fn picture(sampling: Sampling) -> (Vec<u32>, Counts) {
    let mut renderer = ThreadedRenderer::new(1);
    let mut pixels = vec![u32::MAX; SIZE.area()];
    let (scene, level) = (show::model_scene(2.0), cpu::best().level);
    let technique = Technique::new("", Quality::EXHAUSTIVE, false, sampling);
    let counts = technique.draw(&mut renderer, level, &scene, SIZE.width, &mut pixels);
    (pixels, counts)
}

#[test]
fn checkerboard_has_every_second_traced_pixel() {
    let (pixels, counts) = picture(Sampling::Checkerboard);
    let traced = drawn(1, &show::model_scene(2.0), &Quality::EXHAUSTIVE, SIZE);
    assert_eq!(counts.points as usize, SIZE.area() / 2);
    let psnr = |parity: usize| {
        let has_parity = |i: &usize| (i % SIZE.width + i / SIZE.width) % 2 == parity;
        let places = (0..SIZE.area()).filter(has_parity);
        let (a, b): (Vec<u32>, Vec<u32>) = places.map(|i| (pixels[i], traced[i])).unzip();
        Difference::between(&a, &b).psnr
    };
    let (own, others) = (psnr(0), psnr(1));
    assert!(own > 55.0, "{own}");
    assert!((24.0..45.0).contains(&others), "{others}");
}

#[test]
fn larger_frames_are_enlarged_better() {
    let whole = picture(Sampling::Full).0;
    let psnr = [0.4, 0.7, 1.0].map(|scale| {
        let (pixels, counts) = picture(Sampling::Enlarged(scale));
        let share = counts.points as f64 / SIZE.area() as f64;
        assert!((share - scale * scale).abs() < 0.01, "{share}");
        Difference::between(&whole, &pixels).psnr
    });
    assert!(psnr[0] > 20.0 && psnr[1] > psnr[0] + 1.0 && psnr[2].is_infinite());
}

#[test]
fn race_has_line_per_quality() {
    let text = printed("bench --size 48x36 --frames 2 --views 1 --quality default --rivals");
    let (_, races) = text.split_once("|\n\n").expect("two tables");
    let lines = cells(races);
    assert_eq!(lines[0][6], "ahead by");
    let names: Vec<&str> = lines[1..].iter().map(|line| line[1]).collect();
    assert_eq!(names, ["default", "unguarded"]);
}
