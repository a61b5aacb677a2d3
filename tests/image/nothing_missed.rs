//! Every object that tracing every pixel shows is shown by every guarded quality.

use crate::cpu::{self, Isa};
use crate::drawn::{draw_best, jagged, with_any_squares};
use crate::generator::config;
use crate::generator::near::{contact, seeds, slivers};
use crate::generator::placed::{between_corners, extreme_blocks, of_the_show, placed};
use crate::refinement::bare;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use proptest::prelude::*;
use std::collections::HashSet;

fn qualities() -> impl Iterator<Item = Quality> {
    with_any_squares().map(jagged)
}

/// Asserts that every quality shows each colour of the exhaustive picture at one of its pixels. The background is exempt: gaps
/// between objects may be missed.
fn assert_nothing_is_missed(scene: &Scene, width: usize, height: usize) {
    let mut renderer = ThreadedRenderer::new(1);
    let mut draw = |isa: Isa, scene: &Scene, quality: &Quality| {
        let mut pixels = vec![0; width * height];
        renderer.draw(isa.level, scene, quality, width, &mut pixels);
        pixels
    };
    let empty = Scene {
        background: scene.background,
        ..Scene::default()
    };
    for isa in cpu::instruction_sets() {
        let nothing = draw(isa, &empty, &Quality::EXHAUSTIVE)[0];
        // One more pixel shows the background in all pictures.
        let mut exhaustive = draw(isa, scene, &Quality::EXHAUSTIVE);
        exhaustive.push(nothing);
        for quality in qualities() {
            let mut drawn = draw(isa, scene, &quality);
            drawn.push(nothing);
            let missed = missed(&exhaustive, &drawn);
            assert_eq!(missed, 0, "by {} with {quality:?}", isa.name);
        }
    }
}

/// The number of colours of the exhaustive picture that another picture has at none of their pixels.
fn missed(exhaustive: &[u32], drawn: &[u32]) -> usize {
    let pairs = exhaustive.iter().zip(drawn);
    let shown: HashSet<u32> = pairs.filter(|(a, b)| a == b).map(|(&a, _)| a).collect();
    let all: HashSet<u32> = exhaustive.iter().copied().collect();
    all.difference(&shown).count()
}

#[test]
fn spheres_between_corners_are_shown_and_the_bare_rules_miss_them() {
    let scene = between_corners();
    let draw = |quality| draw_best(&scene, &quality, 320, 240).pixels;
    let exhaustive = draw(Quality::EXHAUSTIVE);
    for quality in qualities() {
        assert_eq!(missed(&exhaustive, &draw(quality)), 0, "{quality:?}");
        // They lie between the corners of squares of 8.
        if quality.square == 8 {
            let bare = missed(&exhaustive, &draw(bare(quality)));
            assert!(bare > 200, "{bare} missed by the bare {quality:?}");
        }
    }
}

#[test]
fn what_rises_by_little_out_of_what_it_stands_in_is_shown() {
    for near in slivers() {
        assert_nothing_is_missed(&near.scene, near.width, near.height);
    }
}

#[test]
#[ignore = "many scenes by chance"]
fn whatever_touches_or_rises_by_any_height_is_shown() {
    for mut random in seeds(60) {
        let near = contact(&mut random);
        assert_nothing_is_missed(&near.scene, near.width, near.height);
    }
}

proptest! {
    #![proptest_config(config(200))]

    #[test]
    fn every_object_of_the_show_is_shown_at_any_time_and_size(
        time in 0.0..show::LENGTH,
        width in 1_usize..160,
        height in 1_usize..120,
    ) {
        assert_nothing_is_missed(&of_the_show(time), width, height);
    }

    #[test]
    fn every_object_that_a_pixel_can_show_is_shown(placed in placed()) {
        assert_nothing_is_missed(&placed.scene(), placed.width, placed.height);
    }

    #[test]
    #[ignore = "many scenes by chance"]
    fn boxes_and_cylinders_of_any_size_are_shown(placed in extreme_blocks()) {
        assert_nothing_is_missed(&placed.scene(), placed.width, placed.height);
    }
}
