//! One frame: bands in parallel.

use crate::observe::Observer;
use crate::prepare::Prepared;
use crate::quality::Quality;
use crate::refine::antialias::Seams;
use crate::refine::{self, Band, MAX_BANDS, Worker};
use crate::scene::Scene;
use crate::text;
use crate::trace::Counts;
use crate::{MAX_HEIGHT, MAX_WIDTH};
use fearless_simd::Level;

/// What the threads share while they render a frame, of fixed size and owned by the caller: at most 480,000 bytes, see
/// [`Memory::BYTES`]. So `Box::new(Memory::new())` works on the stack of a thread, which it passes over on its way; it may live in
/// a `static` as well, which takes no room in a program's file.
pub struct Memory {
    prepared: Prepared,
    seams: Seams,
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
            }
        }
    }
}

impl Memory {
    /// Prepares a frame of so many pixels.
    fn begin(
        &mut self,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        height: usize,
        count: usize,
    ) {
        let is_valid = (1..=MAX_WIDTH).contains(&width)
            && (1..=MAX_HEIGHT).contains(&height)
            && count == width * height
            && quality.is_valid();
        assert!(is_valid, "size or quality out of range");
        self.prepared.set(scene, width, height);
    }
}

impl Memory {
    /// Has the next frames take their samples `x` pixels to the right of the pixels' centres and `y` below them, within
    /// -0.5 to 0.5. The mean of frames that cover a pixel evenly is a supersampled one.
    pub fn set_offset(&mut self, x: f32, y: f32) {
        self.prepared.offset = glam::vec2(x, y);
    }

    /// Gives the edges of a frame their samples, if the quality has more than one for them, and then its captions.
    #[allow(clippy::too_many_arguments, reason = "as for the frame itself")]
    fn smooth(
        &mut self,
        level: Level,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        workers: &mut [Worker],
        pixels: &mut [u32],
        run: &mut dyn Run,
    ) -> Counts {
        if !quality.is_antialiased() {
            return Counts::NONE;
        }
        self.seams.set(quality, width, pixels);
        // The scene again, for a picture with a pixel for each sample.
        let (n, height, offset) = (
            quality.antialias,
            self.prepared.height,
            self.prepared.offset,
        );
        self.prepared.offset = offset * n as f32;
        self.prepared.set(scene, n * width, n * height);
        self.prepared.offset = offset;
        let (finer, seams) = (&self.prepared, &self.seams);
        let job = |worker: &mut Worker, band: &mut Band<'_>| {
            seams.smooth(level, finer, quality, worker, band);
            text::draw(&scene.captions, height, band);
        };
        frame(Band::rows(quality), width, workers, pixels, &job, run)
    }
}

impl Default for Memory {
    fn default() -> Self {
        Self::new()
    }
}

/// A job on a band, to be run by a worker.
pub type Job<'a> = &'a (dyn Fn(&mut Worker, &mut Band<'_>) + Sync);

/// What has a job done on bands: the caller's function, behind a pointer, so that what draws is compiled once, in this library.
trait Run {
    fn run(&mut self, workers: &mut [Worker], bands: &mut [Band<'_>], job: Job<'_>);
}

impl<F: FnMut(&mut [Worker], &mut [Band<'_>], Job<'_>)> Run for F {
    fn run(&mut self, workers: &mut [Worker], bands: &mut [Band<'_>], job: Job<'_>) {
        self(workers, bands, job);
    }
}

/// Renders one frame of `width` by `height` pixels: `0x00RRGGBB`, row after row.
///
/// The picture depends on the scene, the quality, the size and the instruction set alone. `run` has to apply the job
/// to every band, each by any of the workers, in any order, and return when all are done; it is called once, and once more
/// where the quality is antialiased.
///
/// # Panics
/// If a side is 0 or beyond [`MAX_WIDTH`] or [`MAX_HEIGHT`], if `pixels` has another length than `width * height`, or
/// if `quality` is out of its range.
#[allow(clippy::too_many_arguments, reason = "what to draw, where, by whom")]
pub fn render(
    level: Level,
    scene: &Scene,
    quality: &Quality,
    width: usize,
    height: usize,
    memory: &mut Memory,
    workers: &mut [Worker],
    pixels: &mut [u32],
    mut run: impl FnMut(&mut [Worker], &mut [Band<'_>], Job<'_>),
) -> Counts {
    plain(
        level, scene, quality, width, height, memory, workers, pixels, &mut run,
    )
}

/// Like [`render`], and the observer hears how the frame comes about: the same frame, the same counts, more time. Of the
/// samples that edges get in the end it does not hear.
///
/// # Panics
/// As [`render`].
#[allow(clippy::too_many_arguments, reason = "what to draw, where, by whom")]
pub fn render_observed<O: Observer>(
    level: Level,
    scene: &Scene,
    quality: &Quality,
    width: usize,
    height: usize,
    memory: &mut Memory,
    workers: &mut [Worker],
    pixels: &mut [u32],
    observer: O,
    mut run: impl FnMut(&mut [Worker], &mut [Band<'_>], Job<'_>),
) -> Counts {
    observed(
        level, scene, quality, width, height, memory, workers, pixels, observer, &mut run,
    )
}

/// A frame that nobody observes.
#[allow(clippy::too_many_arguments, reason = "what to draw, where, by whom")]
fn plain(
    level: Level,
    scene: &Scene,
    quality: &Quality,
    width: usize,
    height: usize,
    memory: &mut Memory,
    workers: &mut [Worker],
    pixels: &mut [u32],
    run: &mut dyn Run,
) -> Counts {
    observed(
        level,
        scene,
        quality,
        width,
        height,
        memory,
        workers,
        pixels,
        (),
        run,
    )
}

/// A frame, with an observer.
#[allow(clippy::too_many_arguments, reason = "what to draw, where, by whom")]
fn observed<O: Observer>(
    level: Level,
    scene: &Scene,
    quality: &Quality,
    width: usize,
    height: usize,
    memory: &mut Memory,
    workers: &mut [Worker],
    pixels: &mut [u32],
    observer: O,
    run: &mut dyn Run,
) -> Counts {
    memory.begin(scene, quality, width, height, pixels.len());
    let prepared = &memory.prepared;
    let job = |worker: &mut Worker, band: &mut Band<'_>| {
        refine::render(level, prepared, quality, observer, worker, band);
        if !quality.is_antialiased() {
            text::draw(&scene.captions, height, band);
        }
    };
    let rows = Band::rows(quality);
    let counts = frame(rows, width, workers, pixels, &job, run);
    counts + memory.smooth(level, scene, quality, width, workers, pixels, run)
}

/// The bands of a frame, of so many rows, each drawn by the job.
fn frame(
    rows: usize,
    width: usize,
    workers: &mut [Worker],
    pixels: &mut [u32],
    job: Job<'_>,
    run: &mut dyn Run,
) -> Counts {
    let mut bands = [const { Band::none() }; MAX_BANDS];
    let mut count = 0;
    for (band, pixels) in bands.iter_mut().zip(pixels.chunks_mut(rows * width)) {
        *band = Band {
            top: count * rows,
            width,
            pixels,
        };
        count += 1;
    }
    run.run(workers, &mut bands[..count], job);
    let mut counts = Counts::NONE;
    for worker in workers {
        counts += worker.take_counts();
    }
    counts
}
