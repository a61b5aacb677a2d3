//! A thread pool for the work of a frame. A run costs a few atomic operations: the caller works
//! too, closes the run when the last item is taken, and waits only for threads that have entered.

use core::cell::UnsafeCell;
use core::ffi::c_void;
use core::hint::spin_loop;
use core::mem::{MaybeUninit, transmute};
use core::ptr::null_mut;
use core::slice::from_raw_parts_mut;
use core::sync::atomic::{AtomicBool, AtomicU32, AtomicUsize, Ordering::*};

pub use crate::backend::threads::processors;
use crate::backend::threads::{Thread, spawn, wait, wake};

/// Iterations of a spinning wait before the thread sleeps: about 50 microseconds, several times the
/// gap between two runs of a frame.
const SPINS: u32 = 1000;

/// A pool whose threads end when it is dropped.
pub struct Pool {
    shared: Box<Shared>,
    /// The first `count` are initialised.
    threads: [MaybeUninit<Thread>; Pool::MAX_THREADS - 1],
    count: usize,
}

type Work<'a> = &'a (dyn Fn(usize) + Sync);

struct Shared {
    /// The number of runs; idle threads sleep on it.
    run: AtomicU32,
    sleeping: AtomicU32,
    /// The number of threads in the current run, and [`OPEN`] while more may enter.
    inside: AtomicU32,
    /// The current run's work; only valid for threads inside.
    work: UnsafeCell<MaybeUninit<Work<'static>>>,
    next: AtomicUsize,
    over: AtomicBool,
}

const OPEN: u32 = 1 << 31;

// SAFETY: all is atomic except `work`. The pool's owner writes it while no run is open and no
// thread is inside; threads read it only inside.
unsafe impl Sync for Shared {}

impl Pool {
    /// The maximum number of threads, including the caller's.
    pub const MAX_THREADS: usize = 256;

    /// Starts a pool of `count` threads including the caller's, at most [`Pool::MAX_THREADS`]. It
    /// has fewer if the system refuses.
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
        let mut threads = [const { MaybeUninit::uninit() }; Pool::MAX_THREADS - 1];
        let mut started = 0;
        let pointer = (&raw const *shared).cast_mut().cast();
        for thread in threads.iter_mut().take(count.saturating_sub(1)) {
            // SAFETY: `shared` has a fixed address until all threads have been joined.
            let Some(new) = (unsafe { spawn(thread_main, pointer) }) else {
                break;
            };
            thread.write(new);
            started += 1;
        }
        Pool { shared, threads, count: started }
    }

    #[must_use]
    pub fn threads(&self) -> usize {
        self.count + 1
    }

    /// Runs a job on every item, in order, each with one of the workers. Each worker belongs to one
    /// thread during the run, so `workers` limits the number of threads.
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
            // SAFETY: the threads of a run have different numbers.
            let Some(worker) = (unsafe { workers.get(thread) }) else {
                return;
            };
            // SAFETY: the counter gives each number once.
            while let Some(item) = unsafe { items.get(next.fetch_add(1, Relaxed)) } {
                job(worker, item);
            }
        });
    }

    pub fn rows(
        &mut self,
        pixels: &mut [u32],
        width: usize,
        job: &(dyn Fn(usize, &mut [u32]) + Sync),
    ) {
        let next = AtomicUsize::new(0);
        let pixels = Each::new(pixels);
        self.work(&|_| {
            loop {
                let row = next.fetch_add(1, Relaxed);
                // SAFETY: the counter gives each number once.
                let Some(pixels) = (unsafe { pixels.chunk(row, width) }) else {
                    return;
                };
                job(row, pixels);
            }
        });
    }

    /// Runs the work on the caller's thread, with number 0, and on all threads that enter in time.
    /// It has two callers and is too large to inline.
    #[inline(never)]
    fn work(&mut self, work: Work<'_>) {
        let shared = &*self.shared;
        if self.count == 0 {
            return work(0);
        }
        // SAFETY: no run is open and no thread inside, by `&mut self` and the end of `Run`. Threads
        // read `work` only inside, and `Run` ends after they have left.
        unsafe { (*shared.work.get()).write(transmute::<Work<'_>, Work<'static>>(work)) };
        shared.inside.store(OPEN, Release);
        shared.wake();
        let _run = Run(shared);
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

/// A run that threads may enter. It ends after all of them have left, even if the caller's work
/// panics.
struct Run<'a>(&'a Shared);

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
    fn wake(&self) {
        self.run.fetch_add(1, SeqCst);
        if self.sleeping.load(SeqCst) != 0 {
            wake(&self.run);
        }
    }

    fn wait(&self, last_run: u32) -> u32 {
        for _ in 0..SPINS {
            let run = self.run.load(Acquire);
            if run != last_run {
                return run;
            }
            spin_loop();
        }
        self.sleeping.fetch_add(1, SeqCst);
        // The wait returns if the number has changed, so no run is missed.
        while self.run.load(SeqCst) == last_run {
            wait(&self.run, last_run);
        }
        self.sleeping.fetch_sub(1, SeqCst);
        self.run.load(Acquire)
    }

    fn take_part(&self, thread: usize) {
        let enter = |inside| (inside & OPEN != 0).then_some(inside + 1);
        if self.inside.fetch_update(Acquire, Relaxed, enter).is_err() {
            return;
        }
        // SAFETY: this thread is inside, so the work is valid.
        let work = unsafe { (*self.work.get()).assume_init() };
        work(thread);
        if self.inside.fetch_sub(1, Release) == 1 {
            wake(&self.inside);
        }
    }
}

extern "C" fn thread_main(shared: *mut c_void) -> *mut c_void {
    // SAFETY: `Pool::new` passes it, and `Pool::drop` joins this thread before freeing it.
    let shared = unsafe { &*shared.cast::<Shared>() };
    let thread = shared.next.fetch_add(1, Relaxed);
    let mut last_run = 0;
    while !shared.over.load(Relaxed) {
        last_run = shared.wait(last_run);
        shared.take_part(thread);
    }
    null_mut()
}

struct Each<T> {
    start: *mut T,
    length: usize,
}

// SAFETY: each element goes to one thread.
unsafe impl<T: Send> Sync for Each<T> {}

impl<T> Each<T> {
    fn new(slice: &mut [T]) -> Each<T> {
        Each { start: slice.as_mut_ptr(), length: slice.len() }
    }

    /// Returns an element, if `index` is in the slice.
    ///
    /// # Safety
    /// Each element may be requested once, and the slice has to stay borrowed.
    unsafe fn get<'a>(&self, index: usize) -> Option<&'a mut T> {
        // SAFETY: the index is in the slice; the rest is required of the caller.
        (index < self.length).then(|| unsafe { &mut *self.start.add(index) })
    }

    /// Returns the chunk of `size` elements at an index, if all are in the slice.
    ///
    /// # Safety
    /// Each chunk of one size may be requested once, and the slice has to stay borrowed.
    unsafe fn chunk<'a>(&self, index: usize, size: usize) -> Option<&'a mut [T]> {
        let start = index * size;
        let is_there = start + size <= self.length;
        // SAFETY: the chunk is in the slice; the rest is required of the caller.
        is_there.then(|| unsafe { from_raw_parts_mut(self.start.add(start), size) })
    }
}
