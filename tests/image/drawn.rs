//! Draws pictures on all instruction sets ([`draw_by_all`]), on one per scene, in turns
//! ([`isa_of`]), or on the best ([`draw_best`]).

use crate::cpu::{self, Isa};
use crate::threaded_renderer::{MomentRef, ThreadedRenderer};
use eightfold::show;
use eightfold_scene_file::SceneFile;
use eightfold_tracer::observe::{Observer, Split};
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{Counts, Preset, Quality, presentation::Moment};
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::fs;
use std::sync::Mutex;

pub const TILE: [usize; 2] = [512, 32];

pub const RULES: [Quality; 2] = [Quality::THESIS, Quality::DEFAULT];

pub const REFINEMENTS: [Quality; 4] =
    [Quality::EXHAUSTIVE, Quality::DEFAULT.reference(), Quality::THESIS, Quality::DEFAULT];

pub fn named() -> impl Iterator<Item = Quality> {
    Preset::ALL[1..].iter().map(|preset| *preset.quality())
}

pub const fn of_side(square: usize, quality: Quality) -> Quality {
    Quality { square, ..quality }
}

pub const fn bare(quality: Quality) -> Quality {
    Quality { guarded: false, ..quality.jagged() }
}

pub fn isa_of(seed: u64) -> Isa {
    let all: Vec<Isa> = cpu::instruction_sets().collect();
    all[seed as usize % all.len()]
}

pub struct Drawn {
    pub pixels: Vec<u32>,
    pub counts: Counts,
}

/// Drawn pixels have 0 in the highest byte.
const UNDRAWN: u32 = 0xdead_beef;

thread_local! {
    /// Renderers by thread count: to create one takes longer than to draw a small picture.
    static RENDERERS: RefCell<HashMap<usize, ThreadedRenderer>> = RefCell::default();
}

pub fn draw<'a>(
    isa: Isa,
    threads: usize,
    moment: impl Into<MomentRef<'a>>,
    quality: &Quality,
    width: usize,
    height: usize,
) -> Drawn {
    let mut pixels = vec![UNDRAWN; width * height];
    let counts = RENDERERS.with_borrow_mut(|renderers| {
        let renderer = renderers.entry(threads);
        let renderer = renderer.or_insert_with(|| ThreadedRenderer::new(threads));
        renderer.draw(isa.level, moment, quality, width, &mut pixels)
    });
    let undrawn = pixels.iter().position(|&pixel| pixel >> 24 != 0);
    assert_eq!(undrawn, None, "a pixel was left out, {width}x{height}");
    Drawn { pixels, counts }
}

pub fn draw_best<'a>(
    moment: impl Into<MomentRef<'a>>,
    quality: &Quality,
    width: usize,
    height: usize,
) -> Drawn {
    draw(cpu::best(), 2, moment, quality, width, height)
}

pub fn draw_by_all<'a>(
    moment: impl Into<MomentRef<'a>>,
    quality: &Quality,
    width: usize,
    height: usize,
) -> Vec<(Isa, Drawn)> {
    let moment = moment.into();
    cpu::instruction_sets().map(|isa| (isa, draw(isa, 2, moment, quality, width, height))).collect()
}

/// Returns a scene of the show without its presentation.
pub fn of_the_show(time: f32) -> Scene {
    show_at(time).scene
}

/// Returns a scene of `examples/scenes` at its start.
pub fn example(name: &str) -> Scene {
    let path = format!("{}/examples/scenes/{name}.ron", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(path).expect("a scene file");
    SceneFile::parse(name, &text).expect("a scene").at(0.0).scene
}

pub fn show_at(time: f32) -> Moment {
    let mut moment = Moment::default();
    show::at(time, &mut moment);
    moment
}

/// The work of points, and the squares that were split, by x, y and side.
#[derive(Default)]
pub struct Record {
    pub counts: Mutex<Counts>,
    pub split: Mutex<HashSet<[usize; 3]>>,
}

// The only observer of these tests: refinement is compiled for each.
impl Observer for &Record {
    fn point(self, _: usize, _: usize, work: Counts) {
        *self.counts.lock().unwrap() += work;
    }

    fn split(self, x: usize, y: usize, side: usize, _: Split) {
        self.split.lock().unwrap().insert([x, y, side]);
    }
}

/// Returns the number of pixels, and of the corners that squares of each size may have outside.
pub fn max_points(square: usize, width: usize, height: usize) -> usize {
    let corners = |side: usize, tile: usize| -> usize {
        let parts = (0..side).step_by(tile).map(|start| (side - start).min(tile));
        let ends = |part: usize| (0..=square.ilog2()).map(move |i| part.next_multiple_of(1 << i));
        parts.map(|part| part + ends(part).collect::<BTreeSet<_>>().len()).sum()
    };
    if square == 1 { width * height } else { corners(width, TILE[0]) * corners(height, TILE[1]) }
}
