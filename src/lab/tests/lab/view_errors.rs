use eightfold::show;
use eightfold_harness::Size;
use eightfold_harness::error::{Difference, pops};
use eightfold_harness::threaded_renderer::{ThreadedRenderer, drawn};
use eightfold_lab::measure::Shot;
use eightfold_lab::scenes::SceneName;
use eightfold_lab::technique::{Sampling, Technique};
use eightfold_lab::view_errors::{ViewErrors, add_errors};
use eightfold_tracer::{Counts, Quality};
use eightfold_window::cpu;

const SIZE: Size = Size::new(96, 72);

#[test]
fn view_is_consecutive_frames_of_its_scene() {
    let scene: SceneName = "show:chimes".parse().unwrap();
    for (count, last) in [(3, 11), (720, 1)] {
        let Shot { times, views, .. } = Shot::new(scene, 5, count);
        assert!(times[0] == 0.0 && (times[4] - (12.0 - 1.0 / 60.0)).abs() < 1e-5);
        assert_eq!(views.len(), count);
        assert!((views[1][0] - 12.0 / count as f32).abs() < 1e-5);
        assert_eq!((views[0].len(), views[count - 1].len()), (11, last));
        for pair in views[0].windows(2) {
            assert!((pair[1] - pair[0] - 1.0 / 60.0).abs() < 1e-6);
        }
    }
    let Shot { views, .. } = Shot::new(SceneName::Model, 1, 9);
    assert!((views[8][0] - show::MODEL_LENGTH * 8.0 / 9.0).abs() < 1e-5);
}

#[test]
fn pixel_pops_if_reference_stays() {
    let count = |references: [u32; 2], frames: [u32; 2]| {
        pops([&[0, references[0]], &[0, references[1]]], [&[0, frames[0]], &[0, frames[1]]])
    };
    let (dark, light) = (0x0040_4040, 0x0040_5140);
    assert_eq!(count([dark, dark], [dark, light]), 1);
    assert_eq!(count([dark, dark], [light, dark]), 1);
    assert_eq!(count([dark, dark], [light, light]), 0);
    assert_eq!(count([dark, dark], [dark, light - 0x100]), 0);
    // The reference may change by 4.
    assert_eq!(count([dark, dark + 4], [dark, light]), 1);
    assert_eq!(count([dark, dark + 5], [dark, light]), 0);
}

fn errors_of(qualities: [Quality; 2], times: [f32; 2]) -> [ViewErrors; 2] {
    let named = |it: Quality| Technique::new("", it, it.antialias, Sampling::Full);
    let techniques = qualities.map(named);
    let mut errors = [ViewErrors::default(), ViewErrors::default()];
    let scenes = times.map(|time| show::model_scene(time).into());
    add_errors(&techniques, cpu::best().level, SIZE, &scenes, &mut errors);
    errors
}

#[test]
fn only_moving_squares_pop() {
    let coarse = Quality { tolerance_agreeing: 64.0, ..Quality::THESIS };
    let [_, still] = errors_of([Quality::EXHAUSTIVE, coarse], [2.0; 2]);
    let [exact, moving] = errors_of([Quality::EXHAUSTIVE, coarse], [2.0, 2.1]);
    assert_eq!([still.pops, exact.pops], [[0.0], [0.0]]);
    assert!(moving.pops[0] > 0.1);
}

#[test]
fn antialiasing_approaches_64_samples() {
    // Between edges, the error of squares remains.
    for (quality, min_gain) in [(Quality::EXHAUSTIVE, 6.0), (Quality::DEFAULT, 3.0)] {
        let qualities = [false, true].map(|antialias| Quality { antialias, ..quality });
        let errors = errors_of(qualities, [2.0, 2.1]);
        assert_eq!(errors[0].flips, [0.0]);
        let psnr = errors.each_ref().map(|it| it.differences_to_64[0].psnr);
        assert!(psnr[0] > 25.0 && psnr[1] > psnr[0] + min_gain, "{psnr:?}");
        let flip = errors.map(|it| it.flips_to_64[0]);
        assert!(0.0 < flip[1] && flip[1] < flip[0], "{flip:?}");
    }
}

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
