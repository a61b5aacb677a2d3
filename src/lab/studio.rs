//! Where frames are drawn: the tracer's memory, and threads that share the work.

use eightfold::scene::Scene;
use eightfold::{Band, Counts, Level, Memory, Quality, Worker, render};
use eightfold_window::pool::Pool;

/// Memory for one frame at a time, and threads that start once.
pub struct Studio {
    pub memory: Box<Memory>,
    /// One for each thread.
    pub workers: Vec<Worker>,
    pub pool: Pool,
}

impl Studio {
    /// A studio of so many threads, at least 1, with the caller's.
    pub fn new(threads: usize) -> Self {
        let pool = Pool::new(threads);
        assert_eq!(
            pool.threads(),
            threads,
            "the system has no threads to spare"
        );
        Self {
            memory: Box::new(Memory::new()),
            workers: std::iter::repeat_with(Worker::new).take(threads).collect(),
            pool,
        }
    }

    /// Has frames take their samples beside the pixels' centres; see [`Memory::set_offset`].
    pub fn set_offset(&mut self, x: f32, y: f32) {
        self.memory.set_offset(x, y);
    }

    /// Draws a frame `width` pixels wide that fills `pixels`, and says how much work it was.
    pub fn draw(
        &mut self,
        level: Level,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
    ) -> Counts {
        render(
            level,
            scene,
            quality,
            width,
            pixels.len() / width,
            &mut self.memory,
            &mut self.workers,
            pixels,
            |workers: &mut [Worker], bands: &mut [Band<'_>], job| {
                self.pool.run(workers, bands, job);
            },
        )
    }
}
