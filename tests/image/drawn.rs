//! Draws pictures with the library. The instruction sets, qualities, sides and numbers of threads of all properties are here.
//!
//! | property | instruction sets |
//! | --- | --- |
//! | of a few scenes' bits | all of the machine: [`draw_by_all`] |
//! | of many random scenes | one for each scene, in turns: [`isa_of`] |
//! | of errors in dB, of what a number means | the best: [`draw_best`] |

use crate::cpu::{self, Isa};
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_oracle::squares::Splits;
use eightfold_tracer::observe::{Fill, Observer, Split};
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Counts, Quality};
use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Mutex;

/// The sides of squares.
pub const SIDES: [usize; 5] = [2, 4, 8, 16, 32];

/// The rules of 2008, and those of the intro.
pub const RULES: [Quality; 2] = [Quality::THESIS, Quality::DEFAULT];

/// The ways in which pictures are refined: not at all, antialiased or not, by the rules of 2008, and as the intro plays.
pub const REFINEMENTS: [Quality; 4] = [
    Quality::EXHAUSTIVE,
    Quality::DEFAULT.reference(),
    Quality::THESIS,
    Quality::DEFAULT,
];

/// All named qualities with squares.
pub fn named() -> impl Iterator<Item = Quality> {
    Quality::LADDER.iter().copied().chain([Quality::THESIS])
}

/// The quality with squares of another side.
pub const fn of_side(square: usize, quality: Quality) -> Quality {
    Quality { square, ..quality }
}

/// The quality without antialiasing, which mixes pixels that refining leaves as they were traced.
pub const fn jagged(quality: Quality) -> Quality {
    Quality {
        antialias: false,
        ..quality
    }
}

/// The quality without the guard and without antialiasing.
pub const fn bare(quality: Quality) -> Quality {
    Quality {
        guarded: false,
        ..jagged(quality)
    }
}

/// The instruction set for a random scene with a seed.
pub fn isa_of(seed: u64) -> Isa {
    let all: Vec<Isa> = cpu::instruction_sets().collect();
    all[seed as usize % all.len()]
}

/// A picture and the work that it took.
pub struct Drawn {
    pub pixels: Vec<u32>,
    pub counts: Counts,
}

/// The value of pixels before they are drawn. Drawn pixels have a highest byte of 0.
const UNDRAWN: u32 = 0xdead_beef;

thread_local! {
    /// The renderers of a test by their numbers of threads: making one takes longer than a small picture.
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

/// The show's scene at a time in seconds.
pub fn of_the_show(time: f32) -> Scene {
    let mut scene = Scene::default();
    show::at(time, &mut scene);
    scene
}

/// Records the work of all points of a frame, and the squares that were split.
#[derive(Default)]
pub struct Record(pub Mutex<(Counts, Splits)>);

impl Observer for &Record {
    fn point(self, _: usize, _: usize, work: Counts) {
        self.0.lock().unwrap().0 += work;
    }

    fn square(self, _: usize, _: usize, _: usize, _: usize, _: Fill) {}

    fn split(self, x: usize, y: usize, side: usize, _: Split) {
        self.0.lock().unwrap().1.insert([x, y, side]);
    }
}
