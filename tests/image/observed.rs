//! What an observer hears of a frame.
//!
//! Of the feature `lab`, as observers are.

use crate::cpu;
use crate::overlay::{Trail, draw_error, heat};
use crate::studio::Studio;
use eightfold::{Quality, show};

/// Sides that no square divides.
const SIZE: (usize, usize) = (331, 217);

fn qualities() -> impl Iterator<Item = Quality> {
    // Nothing divides 17 but its halves, which differ.
    let odd = Quality {
        square: 17,
        ..Quality::THESIS
    };
    let mixed = Quality {
        square: 17,
        ..Quality::DEFAULT
    };
    let named = [Quality::EXHAUSTIVE, Quality::THESIS, odd, mixed];
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
            let trail = Trail::new(width, height);
            let counts = studio.draw_observed(isa.level, &scene, &quality, &trail, &mut heard);
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
    let trail = Trail::new(width, height);
    let level = cpu::best().level;
    let counts = studio.draw_observed(level, &scene, &Quality::EXHAUSTIVE, &trail, &mut pixels);
    let rays: u64 = trail.rays().map(u64::from).sum();
    assert_eq!(rays, counts.rays + counts.shadow_rays);
    assert_eq!(
        trail.rays().filter(|&rays| rays > 0).count(),
        width * height
    );

    for quality in Quality::LADDER {
        let trail = Trail::new(width, height);
        let counts = studio.draw_observed(level, &scene, quality, &trail, &mut pixels);
        let points = trail.rays().filter(|&rays| rays > 0).count() as u64;
        let beyond = ((width + height) / quality.square + 1) as u64;
        assert!(points <= counts.points && counts.points <= points + beyond + width as u64);
        assert!(trail.rays().map(u64::from).sum::<u64>() <= counts.rays + counts.shadow_rays);
    }
}

#[test]
fn squares_cover_each_pixel_once() {
    let (width, height) = SIZE;
    let scene = show::scene(1.0);
    let mut studio = Studio::new(2);
    for quality in qualities().filter(|quality| quality.square > 1) {
        let trail = Trail::new(width, height);
        let mut pixels = vec![0; width * height];
        studio.draw_observed(cpu::best().level, &scene, &quality, &trail, &mut pixels);
        let mut covered = vec![0; width * height];
        for square in trail.squares() {
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
