//! Memory that the threads share while they render a frame, and the steps of one.

use super::Frame;
use super::schedule::Schedule;
use super::threads::Threads;
use crate::observe::Observer;
use crate::prepare::Prepared;
use crate::quality::Quality;
use crate::refine::antialias::Seams;
use crate::refine::probe::{Probing, probe};
use crate::refine::{self, Band, MAX_BANDS, Rough, Worker};
use crate::scene::Scene;
use crate::text;
use crate::trace::{Counts, WideKernel};
use fearless_simd::Level;

/// The memory that the threads share while they render a frame, of fixed size: at most 850,000 bytes, see [`Memory::BYTES`].
///
/// So `Box::new(Memory::new())` works on the stack of a thread, which it passes over on its way; it may live in a `static` as
/// well, which takes no room in a program's file.
pub struct Memory {
    prepared: Prepared,
    seams: Seams,
    rough: [Rough; MAX_BANDS],
    /// Of drawing bands, and of smoothing their edges.
    drawing: Schedule,
    smoothing: Schedule,
    pub(super) probing: Probing,
    wide: Option<WideKernel>,
}

impl Memory {
    /// How large it is, in bytes: the same for pictures of any size.
    pub const BYTES: usize = size_of::<Self>();

    /// Empty memory.
    #[must_use]
    pub const fn new() -> Self {
        // Put together by the compiler: unoptimised code would make each part on the stack first.
        const {
            Self {
                prepared: Prepared::new(),
                seams: Seams::new(),
                rough: [[[0; _]; _]; _],
                drawing: Schedule::new(),
                smoothing: Schedule::new(),
                probing: Probing::NONE,
                wide: None,
            }
        }
    }

    /// Has the next frames drawn with a kernel for wide packets, if there is one.
    pub(super) fn widen(&mut self, kernel: Option<WideKernel>) {
        self.wide = kernel;
    }

    pub(super) fn set_offset(&mut self, x: f32, y: f32) {
        self.prepared.offset = glam::vec2(x, y);
    }

    /// Renders a frame that nobody observes. Compiled in this library, once.
    pub(super) fn render(
        &mut self,
        level: Level,
        scene: &Scene,
        quality: &Quality,
        frame: Frame<'_>,
        threads: &mut dyn Threads,
    ) -> Counts {
        self.render_observed(level, scene, quality, frame, threads, ())
    }

    /// Renders a frame with an observer.
    pub(super) fn render_observed<O: Observer>(
        &mut self,
        level: Level,
        scene: &Scene,
        quality: &Quality,
        frame: Frame<'_>,
        threads: &mut dyn Threads,
        observer: O,
    ) -> Counts {
        let is_valid = frame.validate().is_ok() && quality.is_drawable();
        assert!(is_valid, "size or quality out of range");
        let (width, height) = (frame.width, frame.height);
        let quality = &scene.film.tightened(&scene.method.coarsened(quality));
        let pixels = &mut frame.pixels[..width * height];
        self.prepared.set(scene, width, height);
        let prepared = &self.prepared;
        let has_edges = quality.antialias && prepared.finished_columns() > 0;
        let (probing, wide) = (self.probing, self.wide);
        let job = |worker: &mut Worker, band: &mut Band<'_>| {
            worker.widen(wide);
            refine::render(level, prepared, quality, observer, worker, band);
            band.counts = worker.take_counts();
            if !has_edges {
                probe(level, prepared, quality, probing, worker, band);
            }
        };
        let rows = Band::rows(quality);
        let counts = self
            .drawing
            .run(rows, width, pixels, &job, threads, &mut self.rough);
        let counts = if has_edges {
            counts + self.smooth(level, quality, width, pixels, threads, observer)
        } else {
            counts
        };
        if !scene.captions.is_empty() {
            let numbers = [counts.points as usize, pixels.len()];
            let job = |_: &mut Worker, band: &mut Band<'_>| {
                text::draw(&scene.captions, 0.5, &numbers, height, band);
            };
            Schedule::new().run(rows, width, pixels, &job, threads, &mut self.rough);
        }
        counts
    }

    /// Smooths the edges of a frame that is drawn, one of whose columns is finished at least.
    fn smooth<O: Observer>(
        &mut self,
        level: Level,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
        threads: &mut dyn Threads,
        observer: O,
    ) -> Counts {
        let finished = self.prepared.finished_columns();
        self.seams
            .set(Band::rows(quality), width, finished, pixels, &self.rough);
        let (prepared, seams, probing) = (&self.prepared, &self.seams, self.probing);
        let wide = self.wide;
        let job = |worker: &mut Worker, band: &mut Band<'_>| {
            worker.widen(wide);
            seams.smooth(level, prepared, quality, observer, worker, band);
            band.counts = worker.take_counts();
            probe(level, prepared, quality, probing, worker, band);
        };
        let rows = Band::rows(quality);
        self.smoothing
            .run(rows, width, pixels, &job, threads, &mut self.rough)
    }
}

impl Default for Memory {
    fn default() -> Self {
        Self::new()
    }
}
