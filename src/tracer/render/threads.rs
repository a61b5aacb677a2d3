use crate::picture::Band;
use crate::refine::Worker;

/// The work on each band of a frame, with a thread's working memory.
pub type Job<'a> = &'a (dyn Fn(&mut Worker, &mut Band<'_>) + Sync);

/// Threads that draw the bands of a frame, each with its own [`Worker`].
///
/// A single worker is an implementation that uses the caller's thread. [`ScopedThreads`](crate::ScopedThreads), with the feature
/// `std`, starts threads for every frame; a pool would start them once.
pub trait Threads {
    /// Runs the job once on each band, with any worker, in any order and concurrently, and returns when all are done. It is called
    /// once per frame, once more if the quality is antialiased, and once more if the scene has captions or copper bars. The bands
    /// that probably take longest come first.
    ///
    /// A band that is left out keeps its pixels.
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>);
}

/// Draws on the caller's thread.
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

    struct Counting(Box<Worker>, usize);

    impl Threads for Counting {
        fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
            self.1 += 1;
            self.0.run(bands, job);
        }
    }

    #[test]
    fn threads_run_once_per_phase() {
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
