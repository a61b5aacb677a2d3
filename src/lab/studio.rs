//! Where frames are drawn: the tracer's memory, and threads that share the work.

use eightfold::scene::Scene;
use eightfold::{Band, Counts, Level, Memory, Quality, Worker, render};
use eightfold_window::pool::Pool;

/// Memory for one frame at a time, and threads that start once.
pub struct Studio {
    /// One, behind a pointer.
    pub memory: Vec<Memory>,
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
            memory: on_heap(1, Memory::new),
            workers: on_heap(threads, Worker::new),
            pool,
        }
    }

    /// Has frames take their samples beside the pixels' centres; see [`Memory::set_offset`].
    pub fn set_offset(&mut self, x: f32, y: f32) {
        self.memory[0].set_offset(x, y);
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
            &mut self.memory[0],
            &mut self.workers,
            pixels,
            |workers: &mut [Worker], bands: &mut [Band<'_>], job| {
                self.pool.run(workers, bands, job);
            },
        )
    }
}

/// So many new items on the heap. They are larger than a thread's usual stack, which they pass over on their way, so
/// a thread with a larger one makes them.
pub fn on_heap<T: Send + 'static>(count: usize, new: fn() -> T) -> Vec<T> {
    // Room for a few copies: unoptimised code makes one for each function the item passes through.
    let stack = 4 * size_of::<T>() + (1 << 20);
    std::thread::Builder::new()
        .stack_size(stack)
        .spawn(move || std::iter::repeat_with(new).take(count).collect())
        .expect("the system has a thread to spare")
        .join()
        .expect("nothing in there panics")
}
