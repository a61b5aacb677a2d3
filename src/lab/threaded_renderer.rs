//! Where frames are drawn: the tracer's memory, and threads that share the work.

use crate::arguments::Size;
use eightfold_tracer::observe::Observer;
use eightfold_tracer::scene::Scene;
use eightfold_tracer::{
    Band, Counts, Frame, Job, Level, Probing, Quality, Renderer, Threads, Worker,
};
use eightfold_window::cpu;
use eightfold_window::pool::Pool;

/// Memory for one frame at a time, and threads that start once.
pub struct ThreadedRenderer {
    renderer: Renderer,
    pub threads: PoolThreads,
    /// Of the next frames.
    offset: [f32; 2],
    probing: Probing,
}

/// A pool of threads, each with its working memory.
pub struct PoolThreads {
    pub pool: Pool,
    workers: Vec<Worker>,
}

impl Threads for PoolThreads {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        self.pool.run(&mut self.workers, bands, job);
    }
}

impl ThreadedRenderer {
    /// A renderer of so many threads, at least 1, with the caller's.
    pub fn new(threads: usize) -> Self {
        let pool = Pool::new(threads);
        assert_eq!(
            pool.threads(),
            threads,
            "the system has no threads to spare"
        );
        Self {
            renderer: Renderer::new(Level::baseline()),
            threads: PoolThreads {
                pool,
                workers: Worker::several(threads),
            },
            offset: [0.0; 2],
            probing: Probing::default(),
        }
    }

    /// Draws a frame `width` pixels wide that fills `pixels`, and says how much work it was. It takes a scene that is not valid,
    /// too.
    pub fn draw(
        &mut self,
        level: Level,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
    ) -> Counts {
        let frame = self.whole(width, pixels);
        self.renderer.set_level(level);
        self.renderer
            .render_valid(scene, quality, frame, &mut self.threads)
    }

    /// Draws a frame of a valid scene like [`ThreadedRenderer::draw`], and tells an observer how.
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
        self.renderer.set_level(level);
        self.renderer
            .render_observed(scene, quality, frame, &mut self.threads, observer)
            .expect("a valid scene")
    }

    /// Has some pixels of the next frames probed.
    pub fn set_probes(&mut self, count: u16, seed: u32) {
        self.probing = Probing { count, seed };
    }

    /// Moves the samples of the next frames by so many pixels.
    pub fn set_offset(&mut self, x: f32, y: f32) {
        self.offset = [x, y];
    }

    /// A frame `width` pixels wide that fills `pixels`.
    fn whole<'a>(&self, width: usize, pixels: &'a mut [u32]) -> Frame<'a> {
        let ([x, y], Probing { count, seed }) = (self.offset, self.probing);
        whole(width, pixels)
            .with_offset(x, y)
            .with_probes(count, seed)
    }
}

/// Draws one frame by the best instruction set of this machine, on so many threads.
pub fn drawn(threads: usize, scene: &Scene, quality: &Quality, size: Size) -> Vec<u32> {
    let mut pixels = vec![0; size.area()];
    let level = cpu::best().level;
    ThreadedRenderer::new(threads).draw(level, scene, quality, size.width, &mut pixels);
    pixels
}

/// A frame `width` pixels wide that fills `pixels`.
pub fn whole(width: usize, pixels: &mut [u32]) -> Frame<'_> {
    assert_eq!(pixels.len() % width, 0, "the last row is not whole");
    Frame::new(width, pixels.len() / width, pixels)
}
