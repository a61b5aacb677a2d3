//! Frames drawn side by side, handed over in their order.

use super::film::{Canvas, Film};
use anyhow::{Error, Result};
use std::collections::BTreeMap;
use std::sync::{Condvar, Mutex, MutexGuard};
use std::thread;

/// Threads that draw a frame each.
pub struct Crew<'a> {
    pub film: &'a Film,
    pub threads: usize,
}

/// Frames that may be under way for each thread: one to be drawn, one to wait for its turn.
const AHEAD: usize = 2;

/// How far the work is.
struct State<T, H> {
    /// The place in the list of the next frame to draw.
    next: usize,
    /// Frames drawn whose turn has not come.
    drawn: BTreeMap<usize, T>,
    /// Frames handed over.
    handed: usize,
    hand_over: H,
    error: Option<Error>,
}

impl Crew<'_> {
    /// Draws frames by number, makes something of each picture on the thread that drew it, and hands that over in the
    /// order of the list.
    ///
    /// # Errors
    /// The first of `make` and `hand_over`; then no more frames are drawn.
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
                    while let Some(place) = self.claim(frames.len(), &state, &moved) {
                        let frame = frames[place];
                        let made = make(frame, self.film.draw(frame, &mut canvas));
                        lock(&state).put(place, made);
                        moved.notify_all();
                    }
                });
            }
        });
        let state = state.into_inner().expect("no thread panics");
        state.error.map_or(Ok(()), Err)
    }

    /// The next frame's place in a list of `count`, once few enough are under way; none at the end.
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

impl<T, H: FnMut(T) -> Result<()>> State<T, H> {
    /// Takes what was made of a frame, and hands over all whose turn has come.
    fn put(&mut self, place: usize, made: Result<T>) {
        if self.error.is_some() {
            return;
        }
        let handed = made.and_then(|made| {
            self.drawn.insert(place, made);
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
