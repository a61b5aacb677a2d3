//! Observers hear of all points and squares of a frame.

use crate::cpu;
use crate::drawn::{REFINEMENTS, jagged, of_side};
use crate::overlay::{FrameTrace, draw_error, heat};
use crate::sameness::work;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_tracer::observe::{Fill, Observer};
use eightfold_tracer::{Counts, Quality};
use std::sync::Mutex;

/// Draws the model scene for an observer.
fn observed(quality: Quality, width: usize, height: usize, observer: impl Observer) -> Counts {
    let (level, scene) = (cpu::best().level, show::model_scene(1.0));
    let mut pixels = vec![0; width * height];
    let mut renderer = ThreadedRenderer::new(2);
    renderer.draw_observed(level, &scene, &quality, width, &mut pixels, observer)
}

/// Counts points and rays.
#[derive(Default)]
struct Counter(Mutex<Counts>);

impl Observer for &Counter {
    fn point(self, _: usize, _: usize, work: Counts) {
        *self.0.lock().unwrap() += work;
    }

    fn square(self, _: usize, _: usize, _: usize, _: usize, _: Fill) {}
}

#[test]
fn reported_points_cast_all_rays() {
    // The points that antialias edges are not reported.
    for quality in Quality::LADDER.map(jagged).iter().chain(&REFINEMENTS[..1]) {
        let counter = Counter::default();
        let counts = observed(*quality, 331, 217, &counter);
        assert_eq!(work(counter.0.into_inner().unwrap()), work(counts));
    }
}

#[test]
fn squares_cover_each_pixel_once() {
    let (width, height) = (331, 217);
    let sides = [2, 32].map(|side| of_side(side, Quality::THESIS));
    for quality in Quality::LADDER.iter().chain(&sides) {
        let trace = FrameTrace::new(width, height);
        observed(*quality, width, height, &trace);
        let mut covered = vec![0; width * height];
        for square in trace.squares() {
            assert!(square.side <= quality.square, "{square:?} by {quality:?}");
            for y in square.y..square.y + square.h {
                for x in square.x..square.x + square.w {
                    covered[y * width + x] += 1;
                }
            }
        }
        assert!(covered.iter().all(|&times| times == 1), "{quality:?}");
    }
}

#[test]
fn error_is_drawn_from_black_to_white() {
    let exhaustive = [0x0010_2030, 0x0010_2030, 0x0010_2030];
    let mut pixels = [0x0010_2030, 0x0010_2130, 0x00ff_2030];
    draw_error(&mut pixels, &exhaustive, 32);
    assert_eq!(pixels, [0.0, 1.0 / 32.0, 1.0].map(heat));
}
