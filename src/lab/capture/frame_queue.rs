//! Draws frames in parallel, and hands them over in order.

use super::film::{Canvas, Film};
use crate::interrupt::{self, Stopped};
use anyhow::Result;
use std::sync::mpsc::sync_channel;
use std::thread;

/// Draws frames of a film on several threads, one frame per thread.
pub struct FrameQueue<'a> {
    pub film: &'a Film,
    pub threads: usize,
}

impl FrameQueue<'_> {
    /// Draws the frames of the given numbers. `make` turns each picture into a result, on the thread that drew it; `hand_over`
    /// gets the results in the order of the list.
    ///
    /// # Errors
    /// The first error of `make` or `hand_over`, or [`Stopped`], after which no more frames are drawn.
    pub fn draw<T: Send>(
        &self,
        frames: &[usize],
        make: impl Fn(usize, &[u32]) -> Result<T> + Sync,
        mut hand_over: impl FnMut(T) -> Result<()>,
    ) -> Result<()> {
        let threads = self.threads.min(frames.len());
        let make = &make;
        thread::scope(|scope| {
            // The threads take the frames in turns, and their results are asked for in turns. While one of a thread waits, the
            // next one is drawn.
            let mut results = Vec::new();
            for first in 0..threads {
                let (sender, receiver) = sync_channel(1);
                results.push(receiver);
                scope.spawn(move || {
                    let mut canvas = Canvas::new();
                    for &frame in frames.iter().skip(first).step_by(threads) {
                        let picture = self.film.draw(frame, &mut canvas);
                        let made = check_stopped().and_then(|()| make(frame, picture));
                        // Nobody asks for more after an error.
                        if sender.send(made).is_err() {
                            return;
                        }
                    }
                });
            }
            let mut turns = (0..frames.len()).map(|i| &results[i % threads]);
            turns.try_for_each(|result| hand_over(result.recv().expect("no thread panics")?))
        })
    }
}

/// An error once the command has to end.
fn check_stopped() -> Result<()> {
    if interrupt::is_stopped() {
        return Err(Stopped("no more frames are drawn".to_owned()).into());
    }
    Ok(())
}
