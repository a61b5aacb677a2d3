//! Threads that share the work of a frame.
//!
//! They start once. A run costs a few atomic operations, and nobody waits for a thread that the
//! system has not woken up yet: the caller works too, closes the run when the last item is taken,
//! and waits only for those that came in.

use core::{
    cell::UnsafeCell,
    ffi::c_void,
    hint::spin_loop,
    mem::{MaybeUninit, transmute},
    ptr::null_mut,
    sync::atomic::{
        AtomicBool, AtomicU32, AtomicUsize,
        Ordering::{AcqRel, Acquire, Relaxed, Release, SeqCst},
    },
};

pub use crate::backend::threads::processors;
use crate::backend::threads::{Thread, spawn, wait, wake};

/// Turns of a spinning wait before the thread goes to sleep: about 50 microseconds, several times
/// what the rest of a frame takes between two runs.
const SPINS: u32 = 1000;

/// Threads that work for whoever has the pool; they end when it is dropped.
pub struct Pool {
    shared: Box<Shared>,
    /// The others; as many as `count` says.
    threads: [MaybeUninit<Thread>; Pool::MOST - 1],
    count: usize,
}

/// Work for one thread of a run, which it has a number in.
type Work<'a> = &'a (dyn Fn(usize) + Sync);

struct Shared {
    /// Counts the runs; threads without work sleep on it.
    run: AtomicU32,
    /// Threads that sleep on `run`, or are about to.
    sleeping: AtomicU32,
    /// Threads inside of the current run, and [`OPEN`] while more may come in.
    inside: AtomicU32,
    /// The work of the current run; not to be looked at from outside of it.
    work: UnsafeCell<MaybeUninit<Work<'static>>>,
    /// The number that the next thread to start takes.
    next: AtomicUsize,
    over: AtomicBool,
}

/// See [`Shared::inside`].
const OPEN: u32 = 1 << 31;

// SAFETY: all is atomic but `work`, which the pool's owner writes while no run is open and no thread
// is inside, and which threads read only while they are inside.
unsafe impl Sync for Shared {}

impl Pool {
    /// The most threads of a pool, with the caller's.
    pub const MOST: usize = 256;

    /// Starts threads so that there are `count` with the caller's, at most [`Pool::MOST`]. There may be fewer
    /// if the system has no more.
    #[must_use]
    pub fn new(count: usize) -> Pool {
        let shared = Box::new(Shared {
            run: AtomicU32::new(0),
            sleeping: AtomicU32::new(0),
            inside: AtomicU32::new(0),
            work: UnsafeCell::new(MaybeUninit::uninit()),
            next: AtomicUsize::new(1),
            over: AtomicBool::new(false),
        });
        let mut threads = [const { MaybeUninit::uninit() }; Pool::MOST - 1];
        let mut started = 0;
        let pointer = (&raw const *shared).cast_mut().cast();
        for thread in threads.iter_mut().take(count.saturating_sub(1)) {
            // SAFETY: `shared` has a place of its own that lasts until every thread has been joined.
            let Some(new) = (unsafe { spawn(thread_main, pointer) }) else {
                break;
            };
            thread.write(new);
            started += 1;
        }
        Pool {
            shared,
            threads,
            count: started,
        }
    }

    /// Threads, with the caller's.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.count + 1
    }

    /// Does a job on every item, each with one of the workers, and returns when all are done.
    ///
    /// A worker belongs to one thread during the run, so no more threads take part than there are
    /// workers; without any, nothing is done. Items are taken in order by whoever is free.
    ///
    /// # Panics
    /// If the job panics on the caller's thread. A panic on another thread aborts the process.
    pub fn run<W: Send, T: Send>(
        &mut self,
        workers: &mut [W],
        items: &mut [T],
        job: &(dyn Fn(&mut W, &mut T) + Sync),
    ) {
        let next = AtomicUsize::new(0);
        let workers = Each::new(workers);
        let items = Each::new(items);
        self.work(&|thread| {
            // SAFETY: no two threads of a run have the same number.
            let Some(worker) = (unsafe { workers.get(thread) }) else {
                return;
            };
            // SAFETY: the counter gives each number once.
            while let Some(item) = unsafe { items.get(next.fetch_add(1, Relaxed)) } {
                job(worker, item);
            }
        });
    }

    /// Has the work done by the caller's thread, with number 0, and by as many others as come in time.
    fn work(&mut self, work: Work<'_>) {
        let shared = &*self.shared;
        if self.count == 0 {
            return work(0);
        }
        // SAFETY: no run is open and no thread inside, as `&mut self` and the end of `Run` see to.
        // Threads look at `work` only while inside, and `Run` does not end before they have left.
        unsafe { (*shared.work.get()).write(transmute::<Work<'_>, Work<'static>>(work)) };
        let _run = Run::open(shared);
        work(0);
    }
}

impl Drop for Pool {
    fn drop(&mut self) {
        self.shared.over.store(true, Relaxed);
        self.shared.wake();
        for thread in &self.threads[..self.count] {
            // SAFETY: it has been started; each thread is joined once.
            unsafe { thread.assume_init_read() }.join();
        }
    }
}

/// A run that threads may come into. It ends, also when the caller's work panics, once the threads
/// inside have left.
struct Run<'a>(&'a Shared);

impl<'a> Run<'a> {
    fn open(shared: &'a Shared) -> Run<'a> {
        shared.inside.store(OPEN, Release);
        shared.wake();
        Run(shared)
    }
}

impl Drop for Run<'_> {
    fn drop(&mut self) {
        let inside = &self.0.inside;
        let mut left = inside.fetch_and(!OPEN, AcqRel) & !OPEN;
        let mut spins = 0;
        while left != 0 {
            if spins < SPINS {
                spins += 1;
                spin_loop();
            } else {
                wait(inside, left);
            }
            left = inside.load(Acquire);
        }
    }
}

impl Shared {
    /// Has all threads look for work.
    fn wake(&self) {
        self.run.fetch_add(1, SeqCst);
        if self.sleeping.load(SeqCst) != 0 {
            wake(&self.run);
        }
    }

    /// Waits for a run after the one that was seen last.
    fn wait(&self, seen: u32) -> u32 {
        for _ in 0..SPINS {
            let run = self.run.load(Acquire);
            if run != seen {
                return run;
            }
            spin_loop();
        }
        self.sleeping.fetch_add(1, SeqCst);
        // It sleeps only if the number is still the same, so no run goes by unseen.
        while self.run.load(SeqCst) == seen {
            wait(&self.run, seen);
        }
        self.sleeping.fetch_sub(1, SeqCst);
        self.run.load(Acquire)
    }

    /// Comes into the run, if it is still open, does its work and leaves.
    fn take_part(&self, thread: usize) {
        let enter = |inside| (inside & OPEN != 0).then_some(inside + 1);
        if self.inside.fetch_update(Acquire, Relaxed, enter).is_err() {
            return;
        }
        // SAFETY: this thread is inside, so the work has been written and lasts.
        let work = unsafe { (*self.work.get()).assume_init() };
        work(thread);
        if self.inside.fetch_sub(1, Release) == 1 {
            wake(&self.inside);
        }
    }
}

extern "C" fn thread_main(shared: *mut c_void) -> *mut c_void {
    // SAFETY: `Pool::new` passes it, and `Pool::drop` waits for this thread before it frees it.
    let shared = unsafe { &*shared.cast::<Shared>() };
    let thread = shared.next.fetch_add(1, Relaxed);
    let mut seen = 0;
    while !shared.over.load(Relaxed) {
        seen = shared.wait(seen);
        shared.take_part(thread);
    }
    null_mut()
}

/// A slice whose elements go to different threads.
struct Each<T> {
    start: *mut T,
    length: usize,
}

// SAFETY: it hands out elements as a slice would, each to one thread.
unsafe impl<T: Send> Sync for Each<T> {}

impl<T> Each<T> {
    fn new(slice: &mut [T]) -> Each<T> {
        Each {
            start: slice.as_mut_ptr(),
            length: slice.len(),
        }
    }

    /// An element, if there is one of that number.
    ///
    /// # Safety
    /// No element may be asked for twice, and the slice has to be borrowed all the while.
    unsafe fn get<'a>(&self, index: usize) -> Option<&'a mut T> {
        // SAFETY: it is inside of the slice, and the caller vouches for the rest.
        (index < self.length).then(|| unsafe { &mut *self.start.add(index) })
    }
}
