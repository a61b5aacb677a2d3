//! Who draws the bands of a frame.

use crate::refine::{Band, Worker};

/// What has to be done to each band of a frame, in a thread's working memory.
pub type Job<'a> = &'a (dyn Fn(&mut Worker, &mut Band<'_>) + Sync);

/// Threads that draw the bands of a frame, each in a [`Worker`] of its own.
///
/// A worker is the simplest of them: the caller's thread alone. This one starts a thread for each of its workers, for every
/// frame; a pool would start them once:
///
/// ```
/// use eightfold::{Band, Job, Threads, Worker};
/// use std::{sync::Mutex, thread};
///
/// struct Scoped(Vec<Worker>);
///
/// impl Threads for Scoped {
///     fn run(&mut self, bands: &mut [Band<'_>], job: Job<'_>) {
///         let bands = Mutex::new(bands.iter_mut());
///         let next = || bands.lock().unwrap().next();
///         thread::scope(|scope| {
///             for worker in &mut self.0 {
///                 scope.spawn(move || while let Some(band) = next() { job(worker, band) });
///             }
///         });
///     }
/// }
/// ```
pub trait Threads {
    /// Applies the job to each band once, each with any of the workers, in any order and side by side, and returns when all are
    /// done. It is called once for a frame, and once more if the quality is antialiased. Taken in the order given, as pools do, those
    /// that are expected to take longest come first.
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
