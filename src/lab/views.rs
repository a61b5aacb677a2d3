//! Errors as a viewer sees them, at some views of a scene: FLIP, pixels that pop, and how far frames are from many samples a pixel.

use crate::arguments::Size;
use crate::error::{Difference, worst_channel};
use crate::flip::{Flip, Flips};
use crate::interrupt;
use crate::picture::Mean;
use crate::scenes::SceneName;
use crate::threaded_renderer::ThreadedRenderer;
use crate::timing::{evenly_spaced, frame_time};
use crate::way::Way;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use eightfold_window::cpu::Isa;

/// Frames that follow a view's own, in which pixels may pop.
const FOLLOWING: usize = 10;
/// Samples of a pixel along each axis, where there are many.
const GRID: usize = 8;
/// A pixel pops if it changes by more than this from a frame to the next, in a channel and steps of 1/255 ...
const POP: u32 = 16;
/// ... while its reference changes by no more than this.
const STILL: u32 = 4;
/// Ways whose frames are held at the same time.
const GROUP: usize = 4;

/// The times of different views from a first time on, spread evenly, each with those of the frames that follow it.
///
/// The last time has no view of its own, as the model scene then is where it began. If it is the first one there is one view.
/// Frames are left out from an end on, where something else is shown.
pub fn views(from: f32, to: f32, count: usize, end: Option<f32>) -> Vec<Vec<f32>> {
    let count = if from < to { count } else { 1 };
    let views = (0..count).map(|view| {
        let first = evenly_spaced(from, to, view, count + 1);
        let following = (1..=FOLLOWING).map(|frame| frame_time(first, frame));
        let following = following.take_while(|&time| end.is_none_or(|end| time < end));
        [first].into_iter().chain(following).collect()
    });
    views.collect()
}

/// The number of pixels that change from a frame to the next while they stay in the frames that these are held to.
pub fn pops(references: [&[u32]; 2], frames: [&[u32]; 2]) -> usize {
    let change = |[before, after]: [&[u32]; 2], i: usize| worst_channel(before[i], after[i]);
    let pixels = 0..frames[0].len();
    pixels
        .filter(|&i| change(frames, i) > POP && change(references, i) <= STILL)
        .count()
}

/// The errors that are seen of a quality, at all views together.
#[derive(Clone, Default)]
pub struct Seen {
    /// Against its reference.
    pub flips: Flips,
    /// Pixels that popped, in so many pairs of frames.
    pops: usize,
    pairs: usize,
    /// Against 64 samples a pixel.
    differences_to_64: Vec<Difference>,
    pub flips_to_64: Flips,
}

impl Seen {
    /// The mean number of pixels that pop from a frame to the next.
    pub fn pops(&self) -> Option<f64> {
        (self.pairs > 0).then(|| self.pops as f64 / self.pairs as f64)
    }

    /// The PSNR against 64 samples a pixel, in dB.
    pub fn psnr_to_64_db(&self) -> Option<f64> {
        let differences = &self.differences_to_64;
        (!differences.is_empty()).then(|| Difference::pooled_psnr(differences))
    }
}

/// Looks at frames.
pub struct Viewer<'a> {
    renderer: &'a mut ThreadedRenderer,
    isa: Isa,
    size: Size,
    /// The reference's frames of a view.
    references: Vec<Vec<u32>>,
    /// The view's own frame with 64 samples a pixel, if it is asked for.
    samples: Option<Vec<u32>>,
    /// The last two frames of each way of a group.
    frames: Vec<[Vec<u32>; 2]>,
}

impl<'a> Viewer<'a> {
    /// A viewer of frames of a size, who compares them with 64 samples a pixel or not.
    pub fn new(
        renderer: &'a mut ThreadedRenderer,
        isa: Isa,
        size: Size,
        has_samples: bool,
    ) -> Self {
        let picture = || vec![0; size.area()];
        Self {
            renderer,
            isa,
            size,
            references: (0..=FOLLOWING).map(|_| picture()).collect(),
            samples: has_samples.then(picture),
            frames: (0..GROUP).map(|_| [picture(), picture()]).collect(),
        }
    }

    /// Looks at a view of a scene in all ways, the first of which is the reference. After Ctrl-C, the rest is left out.
    pub fn look(&mut self, view: &[f32], scene: SceneName, ways: &[Way], seen: &mut [Seen]) {
        if interrupt::is_stopped() {
            return;
        }
        let (level, width) = (self.isa.level, self.size.width);
        let reference = &ways[0];
        for (&time, pixels) in view.iter().zip(&mut self.references) {
            let scene = reference.scene(scene, time);
            self.renderer
                .draw(level, &scene, &reference.quality, width, pixels);
        }
        self.sample(&reference.scene(scene, view[0]));
        for (ways, seen) in ways.chunks(GROUP).zip(seen.chunks_mut(GROUP)) {
            if interrupt::is_stopped() {
                return;
            }
            for (frame, &time) in view.iter().enumerate() {
                for (way, frames) in ways.iter().zip(&mut self.frames) {
                    let (scene, pixels) = (way.scene(scene, time), &mut frames[frame % 2]);
                    self.renderer
                        .draw(level, &scene, &way.quality, width, pixels);
                }
                self.compare(seen, frame);
            }
        }
    }

    /// Draws a scene with 64 samples a pixel, if that is asked for.
    fn sample(&mut self, scene: &Scene) {
        let Some(samples) = &mut self.samples else {
            return;
        };
        let mut mean = Mean::default();
        for i in 0..GRID * GRID {
            let place = |i: usize| (i as f32 + 0.5) / GRID as f32 - 0.5;
            self.renderer.set_offset(place(i % GRID), place(i / GRID));
            let (level, width) = (self.isa.level, self.size.width);
            self.renderer
                .draw(level, scene, &Quality::EXHAUSTIVE, width, samples);
            mean.add(samples);
        }
        self.renderer.set_offset(0.0, 0.0);
        mean.write(samples);
    }

    /// Compares the last frames of a group, on all threads.
    fn compare(&mut self, seen: &mut [Seen], frame: usize) {
        let (width, references, samples) = (self.size.width, &self.references, &self.samples);
        let pool = &mut self.renderer.threads.pool;
        let mut each: Vec<_> = seen.iter_mut().zip(&self.frames).collect();
        let mut workers = vec![(); pool.threads()];
        pool.run(&mut workers, &mut each, &|(), (seen, frames)| {
            let (before, now) = (&frames[(frame + 1) % 2], &frames[frame % 2]);
            if frame > 0 {
                seen.pairs += 1;
                let references = [&references[frame - 1][..], &references[frame]];
                seen.pops += pops(references, [before, now]);
                return;
            }
            seen.flips.add(&Flip::between(width, &references[0], now));
            if let Some(samples) = samples {
                seen.differences_to_64
                    .push(Difference::between(samples, now));
                seen.flips_to_64.add(&Flip::between(width, samples, now));
            }
        });
    }
}
