//! Arguments out of their range are refused, those at its ends are not.

use crate::drawn::draw;
use crate::isa;
use crate::studio::Studio;
use eightfold::scene::Scene;
use eightfold::{MAX_HEIGHT, MAX_WIDTH, Quality, show};
use std::panic::catch_unwind;

fn refused(quality: Quality, width: usize, height: usize) -> bool {
    catch_unwind(|| draw(isa::best(), 1, &show::scene(0.0), &quality, width, height)).is_err()
}

#[test]
fn sizes_out_of_range_are_refused() {
    for (width, height) in [
        (1, 0),
        (MAX_WIDTH + 1, 1),
        (1, MAX_HEIGHT + 1),
        (MAX_HEIGHT, MAX_WIDTH),
    ] {
        assert!(refused(Quality::THESIS, width, height), "{width}x{height}");
    }
}

#[test]
fn pixels_that_do_not_fill_the_picture_are_refused() {
    let half_a_row = catch_unwind(|| {
        let mut pixels = vec![0; 15];
        let level = isa::best().level;
        Studio::new(1).draw(level, &show::scene(0.0), &Quality::THESIS, 10, &mut pixels);
    });
    assert!(half_a_row.is_err());
}

#[test]
fn qualities_out_of_range_are_refused() {
    for square in [0, Quality::MAX_SQUARE + 1, usize::MAX] {
        let quality = Quality {
            square,
            ..Quality::THESIS
        };
        assert!(refused(quality, 64, 48), "squares of {square}");
    }
    for depth in [Quality::MAX_DEPTH + 1, u32::MAX] {
        let quality = Quality {
            depth,
            ..Quality::THESIS
        };
        assert!(refused(quality, 64, 48), "depth {depth}");
    }
}

#[test]
fn comparing_deeper_than_rays_go_compares_all() {
    let scene = show::scene(0.0);
    let compare = |depth| {
        let quality = Quality {
            key_depth: depth,
            state_depth: depth,
            ..Quality::THESIS
        };
        draw(isa::best(), 1, &scene, &quality, 200, 150).pixels
    };
    let all = compare(Quality::MAX_DEPTH);
    for depth in [8, 30, 31, 32, 40, u32::MAX] {
        assert!(compare(depth) == all, "depth {depth}");
    }
}

#[test]
fn an_empty_scene_is_its_background() {
    let scene = Scene {
        background: glam::vec3a(1.0, 0.5, 0.0),
        ..Scene::default()
    };
    for isa in isa::all() {
        for quality in [Quality::EXHAUSTIVE, Quality::THESIS] {
            let drawn = draw(isa, 2, &scene, &quality, 70, 50);
            assert!(drawn.pixels.iter().all(|&pixel| pixel == 0x00ff_8000));
            assert_eq!(drawn.counts.rays, drawn.counts.points);
        }
    }
}
