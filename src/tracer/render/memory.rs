use super::schedule::Schedule;
use super::threads::Threads;
use crate::counts::Counts;
use crate::coverage::Coverage;
use crate::observe::Observer;
use crate::overlay::Overlay;
use crate::picture::{Band, Frame, Rough};
use crate::plan::FramePlan;
use crate::prepare::Prepared;
use crate::refine::antialias::Seams;
use crate::refine::probe::probe;
use crate::refine::{Context, Kernels, Worker, draw};
use crate::scene::Scene;
use crate::zero::Zero;

/// The memory that threads share while they render a frame, of [`Memory::BYTES`] bytes.
///
/// It is too large for a thread's stack. Without the feature `std`, pass a `static` to
/// [`Renderer::with_memory`](crate::Renderer::with_memory): it takes no space in the executable
/// file.
pub struct Memory {
    prepared: Prepared,
    coverage: Coverage,
    seams: Seams,
    rough: Rough,
    drawing: Schedule,
    smoothing: Schedule,
}

zero! { Memory { prepared, coverage, seams, rough, drawing, smoothing } }

impl Memory {
    /// The size in bytes, at most 1,000,000, for pictures of any size.
    pub const BYTES: usize = size_of::<Self>();

    /// Returns empty memory.
    #[must_use]
    pub const fn new() -> Self {
        // A constant: unoptimised code would build each part on the stack.
        const { Self::ZERO }
    }

    /// Not generic: compiled once, in this crate.
    pub(super) fn render(
        &mut self,
        kernels: Kernels,
        plan: &FramePlan,
        scene: &Scene,
        frame: Frame<'_>,
        threads: &mut dyn Threads,
    ) -> Counts {
        self.render_observed(kernels, plan, scene, frame, threads, ())
    }

    pub(super) fn render_observed<O: Observer>(
        &mut self,
        kernels: Kernels,
        plan: &FramePlan,
        scene: &Scene,
        mut frame: Frame<'_>,
        threads: &mut dyn Threads,
        observer: O,
    ) -> Counts {
        let [width, height] = plan.size;
        let world = self.prepared.prepare(scene, plan.size, plan.offset);
        self.coverage.set(world, plan.size, plan.offset);
        let context = &Context { plan, kernels, world, coverage: &self.coverage, observer };
        let captions = &frame.presentation.captions;
        let picture = &mut frame.band(&mut self.rough);
        let has_edges = plan.quality.antialias;
        let job = |worker: &mut Worker, band: &mut Band<'_>| {
            draw(context, worker, band);
            band.counts = worker.take_counts();
            if !has_edges {
                probe(context, worker, band);
            }
        };
        let mut counts = self.drawing.run(picture, &job, threads);
        // Smoothing reads the neighbouring bands.
        if has_edges {
            self.seams.set(plan, picture);
            let seams = &self.seams;
            let job = |worker: &mut Worker, band: &mut Band<'_>| {
                seams.smooth(context, worker, band);
                band.counts = worker.take_counts();
                probe(context, worker, band);
            };
            counts += self.smoothing.run(picture, &job, threads);
        }
        plan.fold.copy(picture);
        let overlay = Overlay {
            captions,
            numbers: &[counts.points as usize, width * height],
            middle: 0.5,
            height,
        };
        if !overlay.is_empty() {
            let job = |_: &mut Worker, band: &mut Band<'_>| overlay.draw(band);
            let mut schedule = Schedule::ZERO;
            schedule.run(picture, &job, threads);
        }
        counts
    }
}

default!(Memory = Self::new());

const _: () = assert!(Memory::BYTES <= 1_000_000 && Memory::BYTES + 16 * Worker::BYTES < 8 << 20);
