use core::mem::ManuallyDrop;
use eightfold::show;
use eightfold_tracer::{
    Band, Counts, Frame, Job, Memory, Quality, Renderer, Threads, Worker, scene::Scene,
};
use eightfold_window::{
    clock::SECOND,
    cpu::{self, Isa},
    pool::{self, Pool},
    static_cell::StaticCell,
};

use super::{
    SHOW_NANOSECONDS,
    options::{MAX_THREADS, Options},
};

struct Workspace {
    scene: Scene,
    memory: Memory,
    workers: [Worker; MAX_THREADS],
}

/// Too large for the stack.
static WORKSPACE: StaticCell<Workspace> = StaticCell::new(Workspace {
    scene: Scene::ZEROED,
    memory: Memory::new(),
    workers: [const { Worker::new() }; _],
});

/// A renderer of the show's frames. A process can have one.
pub struct ShowRenderer {
    pub isa: Isa,
    renderer: Renderer<&'static mut Memory>,
    scene: &'static mut Scene,
    threads: PoolThreads,
}

impl ShowRenderer {
    #[inline(never)]
    pub fn new(options: &Options, isa: Isa) -> ShowRenderer {
        let Workspace { scene, memory, workers } = WORKSPACE.take();
        let threads = options.threads.unwrap_or_else(pool::processors);
        ShowRenderer {
            isa,
            renderer: renderer(isa, memory),
            scene,
            threads: PoolThreads {
                pool: ManuallyDrop::new(Pool::new(threads.min(MAX_THREADS))),
                workers,
            },
        }
    }

    /// Returns the number of threads that draw, including the caller's.
    pub fn threads(&self) -> usize {
        self.threads.pool.threads()
    }

    /// Draws the frame at a time in nanoseconds, and returns the work done. The show repeats. `number` selects the pixels to probe.
    #[inline(never)]
    pub fn draw(
        &mut self,
        time: u64,
        number: u64,
        quality: &Quality,
        frame: &mut Frame<'_>,
    ) -> Counts {
        // An f64 represents every nanosecond of the show exactly, so the time is rounded only once.
        let seconds = ((time % SHOW_NANOSECONDS) as f64 / SECOND as f64) as f32;
        show::at(seconds, self.scene);
        let frame = Frame::new(frame.width, frame.height, &mut *frame.pixels)
            .with_probes(Frame::PROBES, number as u32);
        self.renderer.render_valid(self.scene, quality, frame, &mut self.threads)
    }

    /// Returns the threads, for other work between frames.
    pub fn pool(&mut self) -> &mut Pool {
        &mut self.threads.pool
    }
}

/// Returns a renderer that links only the kernels of [`cpu::shipped`].
fn renderer(isa: Isa, memory: &'static mut Memory) -> Renderer<&'static mut Memory> {
    #[cfg(target_arch = "x86_64")]
    if !cpu::HAS_BASELINE {
        let simd = isa.level.as_avx2().unwrap();
        return Renderer::avx2(simd, memory);
    }
    Renderer::narrow(isa.level, memory)
}

struct PoolThreads {
    /// The process ends without its threads.
    pool: ManuallyDrop<Pool>,
    workers: &'static mut [Worker],
}

impl Threads for PoolThreads {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        self.pool.run(self.workers, bands, job);
    }
}
