//! Observers are told of all points and squares of a frame, and do not change it.

use crate::cpu;
use crate::drawn::jagged;
use crate::overlay::{FrameTrace, draw_error, heat};
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_tracer::observe::{Fill, Observer};
use eightfold_tracer::{Counts, Quality};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// A size that is no multiple of any square's side.
const SIZE: (usize, usize) = (331, 217);

fn qualities() -> impl Iterator<Item = Quality> {
    let large = Quality {
        square: 32,
        ..Quality::THESIS
    };
    let small = Quality {
        square: 2,
        ..Quality::DEFAULT
    };
    let named = [Quality::EXHAUSTIVE, Quality::THESIS, large, small];
    named.into_iter().chain(*Quality::LADDER)
}

#[test]
fn an_observer_does_not_change_the_frame() {
    let (width, height) = SIZE;
    let scene = show::field(40, 2.0);
    let mut renderer = ThreadedRenderer::new(2);
    for isa in cpu::instruction_sets() {
        for quality in qualities() {
            // The counts have to be the same, too: no point depends on earlier frames.
            let (mut observed, mut plain) = (vec![0; width * height], vec![1; width * height]);
            let trace = FrameTrace::new(width, height);
            let counts =
                renderer.draw_observed(isa.level, &scene, &quality, width, &mut observed, &trace);
            assert_eq!(
                counts,
                renderer.draw(isa.level, &scene, &quality, width, &mut plain)
            );
            assert!(observed == plain, "{quality:?} by {}", isa.name);
        }
    }
}

#[test]
fn the_reported_points_cast_all_rays() {
    // The size is a multiple of the squares' side, so that no square reaches beyond the picture.
    let (width, height) = (328, 216);
    let scene = show::model_scene(2.5);
    let mut renderer = ThreadedRenderer::new(2);
    let mut pixels = vec![0; width * height];
    let trace = FrameTrace::new(width, height);
    let level = cpu::best().level;
    let counts = renderer.draw_observed(
        level,
        &scene,
        &Quality::EXHAUSTIVE,
        width,
        &mut pixels,
        &trace,
    );
    let rays: u64 = trace.rays().map(u64::from).sum();
    assert_eq!(rays, counts.rays + counts.shadow_rays);
    assert_eq!(
        trace.rays().filter(|&rays| rays > 0).count(),
        width * height
    );

    // Of the points that antialias edges an observer does not hear.
    for quality in Quality::LADDER.map(jagged) {
        let counter = Counter::default();
        let counts = renderer.draw_observed(level, &scene, &quality, width, &mut pixels, &counter);
        assert_eq!(counter.points.into_inner(), counts.points);
        assert_eq!(counter.rays.into_inner(), counts.rays + counts.shadow_rays);
    }
}

/// Counts the reported points and their rays.
#[derive(Default)]
struct Counter {
    points: AtomicU64,
    rays: AtomicU64,
}

impl Observer for &Counter {
    fn point(self, _: usize, _: usize, work: Counts) {
        self.points.fetch_add(work.points, Relaxed);
        self.rays.fetch_add(work.rays + work.shadow_rays, Relaxed);
    }

    fn square(self, _: usize, _: usize, _: usize, _: usize, _: Fill) {}
}

#[test]
fn squares_cover_each_pixel_once() {
    let (width, height) = SIZE;
    let scene = show::model_scene(1.0);
    let mut renderer = ThreadedRenderer::new(2);
    for quality in qualities().filter(|quality| quality.square > 1) {
        let trace = FrameTrace::new(width, height);
        let mut pixels = vec![0; width * height];
        renderer.draw_observed(
            cpu::best().level,
            &scene,
            &quality,
            width,
            &mut pixels,
            &trace,
        );
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
fn the_error_is_drawn_from_black_for_none_to_white_for_the_largest() {
    let exhaustive = [0x0010_2030, 0x0010_2030, 0x0010_2030];
    let mut pixels = [0x0010_2030, 0x0010_2130, 0x00ff_2030];
    draw_error(&mut pixels, &exhaustive, 32);
    assert_eq!(pixels[0], heat(0.0));
    assert_eq!(pixels[1], heat(1.0 / 32.0));
    assert_eq!(pixels[2], heat(1.0));
}
