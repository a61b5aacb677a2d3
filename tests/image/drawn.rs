//! Draws pictures with the library, through the lab's renderer.

use crate::cpu::{self, Isa};
use crate::threaded_renderer::ThreadedRenderer;
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Counts, Quality};
use std::cell::RefCell;
use std::collections::HashMap;

/// A picture and the work that it took.
pub struct Drawn {
    pub pixels: Vec<u32>,
    pub counts: Counts,
}

/// The value of pixels before they are drawn. Drawn pixels have a highest byte of 0.
const UNDRAWN: u32 = 0xdead_beef;

/// The quality without antialiasing, which mixes pixels that refining leaves as they were traced.
pub const fn jagged(quality: Quality) -> Quality {
    Quality {
        antialias: false,
        ..quality
    }
}

/// All named qualities with squares.
pub fn named() -> impl Iterator<Item = Quality> {
    Quality::LADDER.iter().copied().chain([Quality::THESIS])
}

/// All named qualities with squares, and the default quality with squares whose sides are not powers of two.
pub fn with_any_squares() -> impl Iterator<Item = Quality> {
    let of_side = |square| Quality {
        square,
        ..Quality::DEFAULT
    };
    named().chain([3, 5, 12, 17].map(of_side))
}

thread_local! {
    /// Those of a test, by their numbers of threads: to make one takes longer than a small picture.
    static RENDERERS: RefCell<HashMap<usize, ThreadedRenderer>> = RefCell::default();
}

/// Draws a picture by one instruction set, on a number of threads.
pub fn draw(
    isa: Isa,
    threads: usize,
    scene: &Scene,
    quality: &Quality,
    width: usize,
    height: usize,
) -> Drawn {
    let mut pixels = vec![UNDRAWN; width * height];
    let counts = RENDERERS.with_borrow_mut(|renderers| {
        let renderer = renderers.entry(threads);
        let renderer = renderer.or_insert_with(|| ThreadedRenderer::new(threads));
        renderer.draw(isa.level, scene, quality, width, &mut pixels)
    });
    let undrawn = pixels.iter().position(|&pixel| pixel >> 24 != 0);
    assert_eq!(undrawn, None, "a pixel was left out, {width}x{height}");
    Drawn { pixels, counts }
}

/// Draws a picture by the best instruction set of the machine, on two threads.
pub fn draw_best(scene: &Scene, quality: &Quality, width: usize, height: usize) -> Drawn {
    draw(cpu::best(), 2, scene, quality, width, height)
}

/// Draws a picture by every instruction set of the machine, on two threads.
pub fn draw_by_all(
    scene: &Scene,
    quality: &Quality,
    width: usize,
    height: usize,
) -> Vec<(Isa, Drawn)> {
    cpu::instruction_sets()
        .map(|isa| (isa, draw(isa, 2, scene, quality, width, height)))
        .collect()
}
