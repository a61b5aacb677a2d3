use core::mem::ManuallyDrop;
use eightfold::show;
use eightfold_tracer::{
    Band, Counts, Frame, Job, Memory, Quality, Renderer, Worker, presentation::Moment,
};
use eightfold_window::clock::SECOND;
use eightfold_window::cpu::{self, Isa};
use eightfold_window::pool::{self, Pool};
use eightfold_window::static_cell::StaticCell;

use super::SHOW_NANOSECONDS;
use super::options::{MAX_THREADS, Options};

struct Workspace {
    moment: Moment,
    memory: Memory,
    workers: [Worker; MAX_THREADS],
}

/// Too large for the stack.
static WORKSPACE: StaticCell<Workspace> = StaticCell::new(Workspace {
    moment: Moment::ZEROED,
    memory: Memory::new(),
    workers: [const { Worker::new() }; _],
});

pub struct ShowRenderer {
    pub isa: Isa,
    renderer: Renderer<&'static mut Memory>,
    moment: &'static mut Moment,
    /// The process ends without its threads.
    threads: (ManuallyDrop<Pool>, &'static mut [Worker]),
}

impl ShowRenderer {
    #[inline(never)]
    pub fn new(options: &Options, isa: Isa) -> ShowRenderer {
        let Workspace { moment, memory, workers } = WORKSPACE.take();
        let threads = options.threads.unwrap_or_else(pool::processors);
        ShowRenderer {
            isa,
            renderer: renderer(isa, memory),
            moment,
            threads: (ManuallyDrop::new(Pool::new(threads.min(MAX_THREADS))), workers),
        }
    }

    /// Returns the number of threads, including the caller's.
    pub fn threads(&self) -> usize {
        self.threads.0.threads()
    }

    /// Draws the frame at a time in nanoseconds; the show repeats. `number` selects the pixels to
    /// probe.
    #[inline(never)]
    pub fn draw(
        &mut self,
        time: u64,
        number: u64,
        quality: &Quality,
        frame: &mut Frame<'_>,
    ) -> Counts {
        // Rounds once: an f64 represents every nanosecond of the show.
        let seconds = ((time % SHOW_NANOSECONDS) as f64 / SECOND as f64) as f32;
        show::at(seconds, self.moment);
        let frame = Frame::new(frame.width, frame.height, &mut *frame.pixels)
            .with_probes(Frame::PROBES, number as u32)
            .with_presentation(&self.moment.presentation);
        let threads = &mut self.threads;
        // One captured reference makes a smaller program than two.
        let mut threads =
            move |bands: &mut [Band<'_>], job: Job<'_>| threads.0.run(threads.1, bands, job);
        self.renderer.render_valid(&self.moment.scene, quality, frame, &mut threads)
    }

    pub fn pool(&mut self) -> &mut Pool {
        &mut self.threads.0
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
