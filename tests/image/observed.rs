//! What an observer hears of a frame.
//!
//! Of the feature `lab`, as observers are.

use crate::cpu;
use crate::overlay::{FrameTrace, draw_error, heat};
use crate::studio::Studio;
use eightfold::observe::{Fill, Observer};
use eightfold::{Band, Counts, Quality, Worker, render_observed, show};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Sides that no square divides.
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
    let odd = Quality {
        square: 12,
        ..Quality::THESIS
    };
    let named = [Quality::EXHAUSTIVE, Quality::THESIS, large, small, odd];
    named.into_iter().chain(*Quality::LADDER)
}

#[test]
fn a_frame_is_the_same_whoever_listens() {
    let (width, height) = SIZE;
    let scene = show::field(40, 2.0);
    let mut studio = Studio::new(2);
    for isa in cpu::instruction_sets() {
        let smooth = Quality {
            antialias: 2,
            ..Quality::DEFAULT
        };
        for quality in qualities().chain([smooth]) {
            // Counts too: no point depends on what was traced in a frame before.
            let (mut heard, mut unheard) = (vec![0; width * height], vec![1; width * height]);
            let trace = FrameTrace::new(width, height);
            let counts = studio.draw_observed(isa.level, &scene, &quality, &trace, &mut heard);
            assert_eq!(
                counts,
                studio.draw(isa.level, &scene, &quality, width, &mut unheard)
            );
            assert!(heard == unheard, "{quality:?} by {}", isa.name);
        }
    }
}

#[test]
fn the_points_heard_of_cast_all_the_rays() {
    // Whole squares: no point lies beyond the picture but in the last row and column of corners.
    let (width, height) = (328, 216);
    let scene = show::scene(2.5);
    let mut studio = Studio::new(2);
    let mut pixels = vec![0; width * height];
    let trace = FrameTrace::new(width, height);
    let level = cpu::best().level;
    let counts = studio.draw_observed(level, &scene, &Quality::EXHAUSTIVE, &trace, &mut pixels);
    let rays: u64 = trace.rays().map(u64::from).sum();
    assert_eq!(rays, counts.rays + counts.shadow_rays);
    assert_eq!(
        trace.rays().filter(|&rays| rays > 0).count(),
        width * height
    );

    for quality in Quality::LADDER {
        let heard = Heard::default();
        let counts = render_observed(
            level,
            &scene,
            quality,
            width,
            height,
            &mut studio.memory,
            &mut studio.workers,
            &mut pixels,
            &heard,
            |workers: &mut [Worker], bands: &mut [Band<'_>], job| {
                studio.pool.run(workers, bands, job);
            },
        );
        assert_eq!(heard.points.into_inner(), counts.points);
        assert_eq!(heard.rays.into_inner(), counts.rays + counts.shadow_rays);
    }
}

/// Counts points, and all their rays.
#[derive(Default)]
struct Heard {
    points: AtomicU64,
    rays: AtomicU64,
}

impl Observer for &Heard {
    fn point(self, _: usize, _: usize, work: Counts) {
        self.points.fetch_add(work.points, Relaxed);
        self.rays.fetch_add(work.rays + work.shadow_rays, Relaxed);
    }

    fn square(self, _: usize, _: usize, _: usize, _: usize, _: Fill) {}
}

#[test]
fn squares_cover_each_pixel_once() {
    let (width, height) = SIZE;
    let scene = show::scene(1.0);
    let mut studio = Studio::new(2);
    for quality in qualities().filter(|quality| quality.square > 1) {
        let trace = FrameTrace::new(width, height);
        let mut pixels = vec![0; width * height];
        studio.draw_observed(cpu::best().level, &scene, &quality, &trace, &mut pixels);
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
fn the_error_of_a_frame_is_dark_where_it_is_right_and_brightest_where_it_is_far_off() {
    let exhaustive = [0x0010_2030, 0x0010_2030, 0x0010_2030];
    let mut pixels = [0x0010_2030, 0x0010_2130, 0x00ff_2030];
    draw_error(&mut pixels, &exhaustive, 32);
    assert_eq!(pixels[0], heat(0.0));
    assert_eq!(pixels[1], heat(1.0 / 32.0));
    assert_eq!(pixels[2], heat(1.0));
}
