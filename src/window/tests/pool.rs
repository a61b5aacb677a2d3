//! Threads that share work: everything is done, once, and nobody is waited for in vain.

use eightfold_window::pool::{Pool, processors};
use std::{
    fs,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::atomic::{AtomicUsize, Ordering::Relaxed},
    thread::{current, sleep},
    time::{Duration, Instant},
};

/// Runs a job that counts, over items and workers, and checks that it was done once on each item.
fn count(pool: &mut Pool, workers: usize, items: usize) {
    let mut workers = vec![0_usize; workers];
    let mut items = vec![0_usize; items];
    pool.run(&mut workers, &mut items, &|worker, item| {
        *worker += 1;
        *item += 1;
    });
    assert!(items.iter().all(|&times| times == 1), "{items:?}");
    assert_eq!(workers.iter().sum::<usize>(), items.len());
}

#[test]
fn every_item_is_done_once() {
    for threads in [1, 2, 3, 8, 33] {
        let mut pool = Pool::new(threads);
        assert_eq!(pool.threads(), threads);
        for items in [0, 1, 2, 7, 100, 5000] {
            for workers in [1, 2, threads, threads + 5] {
                count(&mut pool, workers, items);
            }
        }
    }
}

#[test]
fn without_workers_nothing_is_done() {
    let mut items = [0; 3];
    let mut workers: [(); 0] = [];
    Pool::new(2).run(&mut workers, &mut items, &|(), item| *item += 1);
    assert_eq!(items, [0; 3]);
}

#[test]
fn many_short_runs_are_all_done() {
    let mut pool = Pool::new(3);
    let mut sums = [0_u64; 3];
    let mut items: Vec<u64> = (0..5).collect();
    for _ in 0..100_000 {
        pool.run(&mut sums, &mut items, &|sum, item| *sum += *item);
    }
    assert_eq!(sums.iter().sum::<u64>(), 100_000 * 10);
}

#[test]
fn runs_after_a_pause_are_done_too() {
    let mut pool = Pool::new(4);
    for _ in 0..50 {
        // Long enough for every thread to fall asleep.
        sleep(Duration::from_millis(3));
        count(&mut pool, 4, 64);
    }
}

#[test]
fn all_threads_take_part_in_long_work() {
    let mut pool = Pool::new(4);
    let mut workers = [0_usize; 4];
    pool.run(&mut workers, &mut [(); 40], &|worker, ()| {
        *worker += 1;
        sleep(Duration::from_millis(5));
    });
    assert!(workers.iter().all(|&items| items > 0), "{workers:?}");
}

#[test]
fn a_panic_of_the_caller_waits_for_the_others() {
    let mut pool = Pool::new(3);
    let caller = current().id();
    for _ in 0..20 {
        let (begun, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let panics = AssertUnwindSafe(|| {
            pool.run(&mut [(), (), ()], &mut [(); 50], &|(), ()| {
                assert!(current().id() != caller, "on purpose");
                begun.fetch_add(1, Relaxed);
                sleep(Duration::from_millis(1));
                done.fetch_add(1, Relaxed);
            });
        });
        assert!(catch_unwind(panics).is_err());
        assert_eq!(
            begun.into_inner(),
            done.into_inner(),
            "nobody is left behind"
        );
        count(&mut pool, 3, 10);
    }
}

#[test]
fn threads_end_with_the_pool() {
    let threads = || fs::read_dir("/proc/self/task").expect("Linux").count();
    for _ in 0..100 {
        let mut pool = Pool::new(5);
        count(&mut pool, 5, 10);
        drop(pool);
    }
    // Other tests have threads too, but not hundreds.
    assert!(threads() < 200, "{} threads", threads());
}

#[test]
fn a_pool_that_was_never_used_ends() {
    let start = Instant::now();
    drop(Pool::new(16));
    assert!(start.elapsed() < Duration::from_secs(5));
}

#[test]
fn there_is_a_processor() {
    let std = std::thread::available_parallelism().map_or(1, usize::from);
    assert!(processors() >= std, "without the limits of a container");
}
