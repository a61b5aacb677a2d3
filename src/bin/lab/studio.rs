//! Where frames are drawn: the tracer's memory, and threads that share the work.

use eightfold::scene::Scene;
use eightfold::{Band, Counts, Job, Level, Memory, Quality, Worker, render};
use rayon::ThreadPool;
use std::sync::Mutex;

/// Memory for one frame at a time, and threads that start once.
pub struct Studio {
    /// One, behind a pointer.
    memory: Vec<Memory>,
    /// One for each thread.
    workers: Vec<Worker>,
    /// The threads besides the caller's; none where it works alone.
    pool: Option<ThreadPool>,
}

impl Studio {
    /// A studio of so many threads, at least 1, with the caller's.
    pub fn new(threads: usize) -> Self {
        let pool = (threads > 1).then(|| {
            rayon::ThreadPoolBuilder::new()
                .num_threads(threads - 1)
                .build()
                .expect("the system has threads to spare")
        });
        Self {
            memory: on_heap(1, Memory::new),
            workers: on_heap(threads, Worker::new),
            pool,
        }
    }

    /// Draws a frame `width` pixels wide that fills `pixels`, and says how much work it was.
    pub fn draw(
        &mut self,
        level: Level,
        scene: &Scene,
        quality: &Quality,
        width: usize,
        pixels: &mut [u32],
    ) -> Counts {
        let pool = self.pool.as_ref();
        render(
            level,
            scene,
            quality,
            width,
            pixels.len() / width,
            &mut self.memory[0],
            &mut self.workers,
            pixels,
            |workers, bands, job| share(pool, workers, bands, job),
        )
    }
}

/// Gives the bands to the workers, each the next one when it is free.
fn share(pool: Option<&ThreadPool>, workers: &mut [Worker], bands: &mut [Band<'_>], job: Job<'_>) {
    let bands = Mutex::new(bands.iter_mut());
    let work = |worker: &mut Worker| {
        let next = || bands.lock().expect("no job panics in here").next();
        while let Some(band) = next() {
            job(worker, band);
        }
    };
    match (pool, workers) {
        (Some(pool), [mine, others @ ..]) => pool.in_place_scope(|scope| {
            for worker in others {
                scope.spawn(|_| work(worker));
            }
            work(mine);
        }),
        (_, workers) => workers.iter_mut().take(1).for_each(work),
    }
}

/// So many new items on the heap. They are larger than a thread's usual stack, which they pass over on their way, so
/// a thread with a larger one makes them.
pub fn on_heap<T: Send + 'static>(count: usize, new: fn() -> T) -> Vec<T> {
    // Room for a few copies: unoptimised code makes one for each function the item passes through.
    let stack = 4 * size_of::<T>() + (1 << 20);
    std::thread::Builder::new()
        .stack_size(stack)
        .spawn(move || std::iter::repeat_with(new).take(count).collect())
        .expect("the system has a thread to spare")
        .join()
        .expect("nothing in there panics")
}
