//! Frames of the show, drawn by all threads.

use eightfold::{Band, Memory, Quality, Worker, render, scene::Scene, show};
use eightfold_window::{
    clock::SECOND,
    cpu::Isa,
    fixed::Fixed,
    pool::{self, Pool},
};

use super::{
    SHOW_LENGTH,
    options::{MAX_THREADS, Options},
};

/// What a frame is made in.
struct Workspace {
    scene: Scene,
    memory: Memory,
    workers: [Worker; MAX_THREADS],
}

/// Far too large for a stack; what no thread or frame size needs is never touched, so it takes no memory.
static WORKSPACE: Fixed<Workspace> = Fixed::new(Workspace {
    scene: Scene::ZEROED,
    memory: Memory::new(),
    workers: [const { Worker::new() }; _],
});

/// Draws frames of the show. There is one in a process.
pub struct Renderer {
    isa: Isa,
    pool: Pool,
    workspace: &'static mut Workspace,
}

impl Renderer {
    /// Starts the threads.
    pub fn new(options: &Options) -> Renderer {
        let threads = options.threads.unwrap_or_else(pool::processors);
        Renderer {
            isa: options.isa,
            pool: Pool::new(threads.min(MAX_THREADS)),
            workspace: WORKSPACE.take(),
        }
    }

    /// Threads that draw, with the caller's.
    pub fn threads(&self) -> usize {
        self.pool.threads()
    }

    /// Draws the frame of a time, in nanoseconds, to `width * height` pixels. After its end the show begins again.
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
        // Through f64, which holds every nanosecond of the show, so that the time is rounded only once.
        let seconds = ((time % SHOW_LENGTH) as f64 / SECOND as f64) as f32;
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
