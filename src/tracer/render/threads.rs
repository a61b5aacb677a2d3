use crate::picture::Band;
use crate::refine::Worker;

/// The work on a band, with a thread's working memory.
pub type Job<'a> = &'a (dyn Fn(&mut Worker, &mut Band<'_>) + Sync);

/// Threads that draw the bands of a frame, each with its own [`Worker`].
///
/// A [`Worker`] draws on the caller's thread, [`ScopedThreads`](crate::ScopedThreads) starts
/// threads for every frame, and a closure can use a pool.
pub trait Threads {
    /// Runs the job once on each band, with any worker, in any order and concurrently, and returns
    /// when all are done. Called up to three times per frame: for squares, antialiasing and
    /// captions. The bands that probably take longest come first.
    ///
    /// A band that is left out keeps its pixels.
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>);
}

impl Threads for Worker {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        for band in bands {
            job(self, band);
        }
    }
}

impl<F: FnMut(&mut [Band<'_>], Job<'_>)> Threads for F {
    fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
        self(bands, job);
    }
}
