//! Draws frames of the show on all threads.

use eightfold::{Band, Memory, Quality, Worker, render, scene::Scene, show};
use eightfold_window::{
    clock::SECOND,
    cpu::Isa,
    fixed::Fixed,
    pool::{self, Pool},
};

use super::{
    SHOW_NANOSECONDS,
    options::{MAX_THREADS, Options},
};

/// The working memory for a frame.
struct Workspace {
    scene: Scene,
    memory: Memory,
    workers: [Worker; MAX_THREADS],
}

/// Too large for the stack. Pages of workers that no thread uses are never touched, so they take no physical memory.
static WORKSPACE: Fixed<Workspace> = Fixed::new(Workspace {
    scene: Scene::ZEROED,
    memory: Memory::new(),
    workers: [const { Worker::new() }; _],
});

/// Draws frames of the show. There can be one in a process.
pub struct Renderer {
    isa: Isa,
    pool: Pool,
    workspace: &'static mut Workspace,
}

impl Renderer {
    /// Starts the threads and takes the working memory.
    pub fn new(options: &Options) -> Renderer {
        let threads = options.threads.unwrap_or_else(pool::processors);
        Renderer {
            isa: options.isa,
            pool: Pool::new(threads.min(MAX_THREADS)),
            workspace: WORKSPACE.take(),
        }
    }

    /// The number of threads that draw, the caller's included.
    pub fn threads(&self) -> usize {
        self.pool.threads()
    }

    /// Draws the frame at a time, in nanoseconds, to `width * height` pixels. The show repeats.
    pub fn draw(
        &mut self,
        time: u64,
        quality: &Quality,
        (width, height): (usize, usize),
        pixels: &mut [u32],
    ) {
        let Workspace {
            scene,
            memory,
            workers,
        } = &mut *self.workspace;
        // An f64 represents every nanosecond of the show exactly, so the time is rounded only once.
        let seconds = ((time % SHOW_NANOSECONDS) as f64 / SECOND as f64) as f32;
        show::at(seconds, scene);
        let pool = &mut self.pool;
        render(
            self.isa.level,
            scene,
            quality,
            width,
            height,
            memory,
            &mut workers[..pool.threads()],
            pixels,
            |workers: &mut [Worker], bands: &mut [Band<'_>], job| pool.run(workers, bands, job),
        );
    }
}
