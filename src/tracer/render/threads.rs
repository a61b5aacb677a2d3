//! Who draws the bands of a frame.

use crate::picture::Band;
use crate::refine::Worker;

/// The work on each band of a frame, in a thread's working memory.
pub type Job<'a> = &'a (dyn Fn(&mut Worker, &mut Band<'_>) + Sync);

/// Threads that draw the bands of a frame, each in a [`Worker`] of its own.
///
/// A worker is the simplest of them: the caller's thread alone. [`ScopedThreads`](crate::ScopedThreads), with the feature `std`, starts
/// one for each of its workers, for every frame; a pool would start them once.
pub trait Threads {
    /// Applies the job to each band once, each with any of the workers, in any order and side by side, and returns when all are
    /// done. It is called once for a frame, then once if the quality is antialiased, and once if the scene has captions or copper bars.
    /// Taken in the order given, as pools do, those that are expected to take longest come first.
    ///
    /// A band that is left out keeps the pixels that were there.
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>);
}

/// The caller's thread alone.
impl Threads for Worker {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        for band in bands {
            job(self, band);
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use crate::scene::Scene;
    use crate::{Frame, Level, Memory, Quality, Renderer};
    use std::prelude::v1::*;

    /// The caller's thread, which counts how often it is called.
    struct Counting(Box<Worker>, usize);

    impl Threads for Counting {
        fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
            self.1 += 1;
            self.0.run(bands, job);
        }
    }

    #[test]
    fn threads_are_called_once_and_for_edges_and_for_captions() {
        let memory = Box::<Memory>::default();
        let mut renderer = Renderer::with_memory(Level::baseline(), memory);
        let mut threads = Counting(Box::<Worker>::default(), 0);
        let mut calls = |captions: bool, antialias: bool| {
            let mut scene = Scene::default();
            if captions {
                scene.captions.push(Default::default());
            }
            let quality = Quality {
                antialias,
                ..Quality::DEFAULT
            };
            let pixels = &mut [0; 8 * 6];
            let frame = Frame::new(8, 6, pixels);
            threads.1 = 0;
            renderer
                .render(&scene, &quality, frame, &mut threads)
                .expect("a frame");
            threads.1
        };
        assert_eq!(calls(false, false), 1);
        assert_eq!(calls(false, true), 2);
        assert_eq!(calls(true, false), 2);
        assert_eq!(calls(true, true), 3);
    }
}
