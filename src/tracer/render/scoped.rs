use super::threads::{Job, Threads};
use crate::picture::Band;
use crate::refine::Worker;
use std::iter::from_fn;
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::vec::Vec;

/// The caller's thread, and threads that [`std::thread::scope`] starts up to three times per frame,
/// each with its own [`Worker`].
///
/// Starting a thread takes some hundredths of a millisecond. A pool that keeps its threads needs
/// unsafe code; pass a closure that uses one as [`Threads`].
#[derive(Debug)]
pub struct ScopedThreads {
    workers: Vec<Worker>,
}

impl ScopedThreads {
    /// Returns one thread per processor that is available to the program.
    #[must_use]
    pub fn new() -> Self {
        Self::of(thread::available_parallelism().map_or(1, usize::from))
    }

    /// Returns `count` threads, the caller's included; 0 counts as 1.
    #[must_use]
    pub fn of(count: usize) -> Self {
        Self { workers: Worker::several(count.max(1)) }
    }

    /// Returns the number of threads.
    #[must_use]
    pub fn count(&self) -> usize {
        self.workers.len()
    }
}

default!(ScopedThreads = Self::new());

impl Threads for ScopedThreads {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        let count = self.workers.len().min(bands.len());
        let bands = Mutex::new(bands.iter_mut());
        let next = || bands.lock().unwrap_or_else(PoisonError::into_inner).next();
        let draw = |worker: &mut Worker| from_fn(next).for_each(|band| job(worker, band));
        let Some((own, others)) = self.workers[..count].split_first_mut() else {
            return;
        };
        thread::scope(|scope| {
            for worker in others {
                scope.spawn(|| draw(worker));
            }
            draw(own);
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presentation::Presentation;
    use crate::scene::Scene;
    use crate::{Frame, Quality, Renderer};
    use std::vec;

    struct Counting(ScopedThreads, usize);

    impl Threads for Counting {
        fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
            self.1 += 1;
            self.0.run(bands, job);
        }
    }

    #[test]
    fn any_number_of_threads_draws_all_bands_per_phase() {
        let mut renderer = Renderer::detect();
        let scene = Scene { background: glam::Vec3::ONE, ..Scene::default() };
        for (asked, count) in [(0, 1), (1, 1), (3, 3), (100, 100)] {
            for (antialias, captions) in [(false, 0), (false, 1), (true, 0), (true, 1)] {
                let mut threads = Counting(ScopedThreads::of(asked), 0);
                assert_eq!(threads.0.count(), count);
                let mut presentation = Presentation::default();
                presentation.captions.extend((0..captions).map(|_| Default::default()));
                let quality = Quality { antialias, ..Quality::DEFAULT };
                let mut pixels = vec![0; 200 * 100];
                let frame = Frame::new(200, 100, &mut pixels);
                let frame = frame.with_presentation(&presentation);
                let drawn = renderer.render(&scene, &quality, frame, &mut threads);
                drawn.expect("a frame");
                assert!(pixels.iter().all(|&pixel| pixel == 0x00ff_ffff), "{asked}");
                assert_eq!(threads.1, 1 + usize::from(antialias) + captions);
            }
        }
    }
}
