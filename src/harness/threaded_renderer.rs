use crate::frame_trace::FrameTrace;
use crate::size::Size;
use eightfold_tracer::observe::Observer;
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{
    Band, BoxedMemory, Counts, Frame, Job, Level, Probing, Quality, Renderer, Worker,
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

    pub fn draw(
        &mut self,
        level: Level,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
    ) -> Counts {
        let frame = self.whole(width, pixels);
        let mut threads =
            |bands: &mut [Band<'_>], job: Job<'_>| self.pool.run(&mut self.workers, bands, job);
        Renderer::with_memory(level, self.memory.borrow_mut()).render_valid(
            scene,
            quality,
            frame,
            &mut threads,
        )
    }

    pub fn draw_observed(
        &mut self,
        level: Level,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
        observer: impl Observer,
    ) -> Counts {
        let frame = self.whole(width, pixels);
        let mut threads =
            |bands: &mut [Band<'_>], job: Job<'_>| self.pool.run(&mut self.workers, bands, job);
        Renderer::with_memory(level, self.memory.borrow_mut())
            .render_observed(scene, quality, frame, &mut threads, observer)
            .expect("a valid scene")
    }

    pub fn trace(
        &mut self,
        level: Level,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
    ) -> FrameTrace {
        let trace = FrameTrace::new(width, pixels.len() / width);
        self.draw_observed(level, scene, quality, width, pixels, &trace);
        trace
    }

    pub fn set_probes(&mut self, count: u16, seed: u32) {
        self.probing = Probing { count, seed };
    }

    /// In pixels.
    pub fn set_offset(&mut self, x: f32, y: f32) {
        self.offset = [x, y];
    }

    fn whole<'a>(&self, width: usize, pixels: &'a mut [u32]) -> Frame<'a> {
        let ([x, y], Probing { count, seed }) = (self.offset, self.probing);
        whole(width, pixels).with_offset(x, y).with_probes(count, seed)
    }
}

pub fn drawn(threads: usize, scene: &Scene, quality: &Quality, size: Size) -> Vec<u32> {
    let mut pixels = vec![0; size.area()];
    let level = cpu::best().level;
    ThreadedRenderer::new(threads).draw(level, scene, quality, size.width, &mut pixels);
    pixels
}

pub fn whole(width: usize, pixels: &mut [u32]) -> Frame<'_> {
    assert_eq!(pixels.len() % width, 0, "the last row is incomplete");
    Frame::new(width, pixels.len() / width, pixels)
}
