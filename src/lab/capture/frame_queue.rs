//! Draws frames in parallel, and hands them over in order.

use super::film::{Canvas, Film};
use crate::interrupt::{self, Stopped};
use anyhow::{Error, Result, bail};
use std::collections::BTreeMap;
use std::sync::{Condvar, Mutex, MutexGuard};
use std::thread;

/// Draws frames of a film on several threads, one frame per thread.
pub struct FrameQueue<'a> {
    pub film: &'a Film,
    pub threads: usize,
}

/// The number of unfinished frames per thread: one is being drawn, one may wait for its turn.
const AHEAD: usize = 2;

/// The state that the threads share.
struct State<T, H> {
    /// The index of the next frame to draw.
    next: usize,
    /// Results, by index, that wait for their turn.
    drawn: BTreeMap<usize, T>,
    /// The number of results handed over.
    handed: usize,
    hand_over: H,
    error: Option<Error>,
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
        hand_over: impl FnMut(T) -> Result<()> + Send,
    ) -> Result<()> {
        let state = Mutex::new(State {
            next: 0,
            drawn: BTreeMap::new(),
            handed: 0,
            hand_over,
            error: None,
        });
        let moved = Condvar::new();
        thread::scope(|scope| {
            for _ in 0..self.threads.min(frames.len()) {
                scope.spawn(|| {
                    let mut canvas = Canvas::new();
                    while let Some(index) = self.claim(frames.len(), &state, &moved) {
                        let frame = frames[index];
                        let picture = self.film.draw(frame, &mut canvas);
                        let made = check_stopped().and_then(|()| make(frame, picture));
                        lock(&state).put(index, made);
                        moved.notify_all();
                    }
                });
            }
        });
        let state = state.into_inner().expect("no thread panics");
        state.error.map_or(Ok(()), Err)
    }

    /// The index of the next frame to draw, below `count`, once few enough are unfinished; `None` at the end.
    fn claim<T, H>(
        &self,
        count: usize,
        state: &Mutex<State<T, H>>,
        moved: &Condvar,
    ) -> Option<usize> {
        let is_far_ahead = |state: &mut State<T, H>| {
            let ahead = state.next - state.handed;
            state.error.is_none() && ahead >= AHEAD * self.threads
        };
        let waited = moved.wait_while(lock(state), is_far_ahead);
        let mut state = waited.expect("no thread panics");
        if state.error.is_some() || state.next == count {
            return None;
        }
        state.next += 1;
        Some(state.next - 1)
    }
}

/// An error once the command has to end.
fn check_stopped() -> Result<()> {
    if interrupt::is_stopped() {
        bail!(Stopped("no more frames are drawn".to_owned()));
    }
    Ok(())
}

impl<T, H: FnMut(T) -> Result<()>> State<T, H> {
    /// Takes a result, and hands over all results whose turn has come.
    fn put(&mut self, index: usize, made: Result<T>) {
        if self.error.is_some() {
            return;
        }
        let handed = made.and_then(|made| {
            self.drawn.insert(index, made);
            while let Some(made) = self.drawn.remove(&self.handed) {
                (self.hand_over)(made)?;
                self.handed += 1;
            }
            Ok(())
        });
        self.error = handed.err();
    }
}

fn lock<T>(state: &Mutex<T>) -> MutexGuard<'_, T> {
    state.lock().expect("no thread panics")
}
