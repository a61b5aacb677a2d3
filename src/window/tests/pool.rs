use eightfold_window::pool::Pool;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::thread::{current, sleep};
use std::time::Duration;

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
fn run_does_each_item_once() {
    for threads in [1, 2, 3, 8, 33] {
        let mut pool = Pool::new(threads);
        assert_eq!(pool.threads(), threads);
        for items in [0, 1, 2, 7, 100, 5000] {
            for workers in [1, 2, threads, threads + 5] {
                count(&mut pool, workers, items);
            }
        }
        pool.run(&mut [], &mut [()], &|(), ()| unreachable!());
    }
}

#[test]
fn short_runs_complete_after_pauses() {
    let mut pool = Pool::new(4);
    for run in 0..50 {
        // Long enough for every thread to fall asleep.
        sleep(Duration::from_millis(3));
        for _ in 0..2000 {
            count(&mut pool, 4, 5 + run % 7);
        }
    }
}

#[test]
fn long_work_uses_all_threads() {
    let mut pool = Pool::new(4);
    let mut workers = [0_usize; 4];
    pool.run(&mut workers, &mut [(); 40], &|worker, ()| {
        *worker += 1;
        sleep(Duration::from_millis(5));
    });
    assert!(workers.iter().all(|&items| items > 0), "{workers:?}");
}

#[test]
fn callers_panic_waits_for_threads() {
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
        assert_eq!(begun.into_inner(), done.into_inner(), "jobs end before the panic");
        count(&mut pool, 3, 10);
    }
}

#[test]
fn threads_end_with_pool() {
    let threads = || fs::read_dir("/proc/self/task").expect("Linux").count();
    for runs in 0..100 {
        let mut pool = Pool::new(5);
        for _ in 0..runs % 2 {
            count(&mut pool, 5, 10);
        }
    }
    // Other tests have threads, too, but not hundreds.
    assert!(threads() < 200, "{} threads", threads());
}
