use crate::frame_trace::FrameTrace;
use crate::picture::Size;
use eightfold_tracer::observe::Observer;
use eightfold_tracer::presentation::{Moment, Presentation};
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{
    Band, BoxedMemory, Counts, Frame, Job, Level, Memory, Probing, Quality, Renderer, Threads,
    Worker,
};
use eightfold_window::cpu;
use eightfold_window::pool::Pool;
use std::borrow::BorrowMut;

pub struct ThreadedRenderer {
    memory: BoxedMemory,
    pool: Pool,
    workers: Vec<Worker>,
    offset: [f32; 2],
    probing: Probing,
}

impl ThreadedRenderer {
    /// `threads` includes the caller's.
    pub fn new(threads: usize) -> Self {
        let pool = Pool::new(threads);
        let started = pool.threads();
        assert!(started == threads, "number of started threads is {started}; must be {threads}");
        Self {
            memory: BoxedMemory::new(),
            pool,
            workers: Worker::several(threads),
            offset: [0.0; 2],
            probing: Probing::default(),
        }
    }

    pub fn draw<'a>(
        &mut self,
        level: Level,
        moment: impl Into<MomentRef<'a>>,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
    ) -> Counts {
        let MomentRef { scene, presentation } = moment.into();
        let (mut renderer, frame, mut threads) = self.parts(level, presentation, width, pixels);
        renderer.render_valid(scene, quality, frame, &mut threads)
    }

    pub fn draw_observed<'a>(
        &mut self,
        level: Level,
        moment: impl Into<MomentRef<'a>>,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
        observer: impl Observer,
    ) -> Counts {
        let MomentRef { scene, presentation } = moment.into();
        let (mut renderer, frame, mut threads) = self.parts(level, presentation, width, pixels);
        let counts = renderer.render_observed(scene, quality, frame, &mut threads, observer);
        counts.expect("a valid scene")
    }

    pub fn trace<'a>(
        &mut self,
        level: Level,
        moment: impl Into<MomentRef<'a>>,
        quality: &Quality,
        size: Size,
    ) -> (Vec<u32>, FrameTrace) {
        let mut pixels = vec![0; size.area()];
        let trace = FrameTrace::new(size.width, size.height);
        self.draw_observed(level, moment, quality, size.width, &mut pixels, &trace);
        (pixels, trace)
    }

    pub fn set_probes(&mut self, count: u16, seed: u32) {
        self.probing = Probing { count, seed };
    }

    /// In pixels.
    pub fn set_offset(&mut self, x: f32, y: f32) {
        self.offset = [x, y];
    }

    fn parts<'a>(
        &'a mut self,
        level: Level,
        presentation: &'a Presentation,
        width: usize,
        pixels: &'a mut [u32],
    ) -> (Renderer<&'a mut Memory>, Frame<'a>, impl Threads) {
        let ([x, y], Probing { count, seed }) = (self.offset, self.probing);
        let frame = whole(width, pixels).with_offset(x, y).with_probes(count, seed);
        let Self { memory, pool, workers, .. } = self;
        let threads = |bands: &mut [Band<'_>], job: Job<'_>| pool.run(workers, bands, job);
        let renderer = Renderer::with_memory(level, memory.borrow_mut());
        (renderer, frame.with_presentation(presentation), threads)
    }
}

/// A scene and its presentation, or a plain scene.
#[derive(Clone, Copy)]
pub struct MomentRef<'a> {
    scene: &'a Scene,
    presentation: &'a Presentation,
}

impl<'a> From<&'a Scene> for MomentRef<'a> {
    fn from(scene: &'a Scene) -> Self {
        Self { scene, presentation: &Presentation::PLAIN }
    }
}

impl<'a> From<&'a Moment> for MomentRef<'a> {
    fn from(Moment { scene, presentation }: &'a Moment) -> Self {
        Self { scene, presentation }
    }
}

pub fn drawn<'a>(
    threads: usize,
    moment: impl Into<MomentRef<'a>>,
    quality: &Quality,
    size: Size,
) -> Vec<u32> {
    let mut pixels = vec![0; size.area()];
    let level = cpu::best().level;
    ThreadedRenderer::new(threads).draw(level, moment, quality, size.width, &mut pixels);
    pixels
}

pub fn whole(width: usize, pixels: &mut [u32]) -> Frame<'_> {
    assert_eq!(pixels.len() % width, 0, "the last row is incomplete");
    Frame::new(width, pixels.len() / width, pixels)
}
