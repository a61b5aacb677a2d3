//! The memory that the library needs from its caller can be made on the stack of any thread.

use eightfold::show;
use eightfold_tracer::{Frame, Level, Memory, Quality, Renderer, Worker};
use std::{iter, thread};

/// The default stack size of threads in bytes: the smallest of the usual systems.
const STACK: usize = 2 << 20;

/// Runs a function on a thread with that stack.
fn on_small_stack<T: Send + 'static>(job: fn() -> T) -> T {
    let thread = thread::Builder::new().stack_size(STACK).spawn(job);
    let thread = thread.expect("the system has a thread to spare");
    thread.join().expect("it does not panic")
}

#[test]
fn memory_is_made_on_two_megabytes_of_stack() {
    on_small_stack(|| Box::new(Memory::new()));
    on_small_stack(|| Box::new(Worker::new()));
    on_small_stack(|| iter::repeat_with(Memory::new).take(2).collect::<Vec<_>>());
    on_small_stack(|| iter::repeat_with(Worker::new).take(2).collect::<Vec<_>>());
}

#[test]
fn a_frame_is_drawn_on_two_megabytes_of_stack() {
    let pixels = on_small_stack(|| {
        let mut pixels = vec![0; 64 * 48];
        let frame = Frame::new(64, 48, &mut pixels);
        Renderer::new(Level::baseline())
            .render(
                &show::model_scene(2.0),
                &Quality::DEFAULT,
                frame,
                &mut Worker::new(),
            )
            .expect("all is valid");
        pixels
    });
    assert!(pixels.iter().any(|&pixel| pixel != pixels[0]));
}

#[test]
fn memory_is_as_small_as_its_docs_say() {
    for (bytes, source) in [
        (
            Memory::BYTES,
            include_str!("../src/tracer/render/memory.rs"),
        ),
        (
            Worker::BYTES,
            include_str!("../src/tracer/refine/worker.rs"),
        ),
    ] {
        let (_, said) = source
            .split_once("at most ")
            .expect("the docs have a bound");
        let (said, _) = said.split_once(" bytes").expect("it is in bytes");
        let bound: usize = said.replace(',', "").parse().expect("a number");
        // And not much smaller, so that the docs are of use.
        assert!((bound * 9 / 10..=bound).contains(&bytes), "{bytes}, {said}");
    }
}

/// Others link to these docs, so that one figure can't become three.
#[test]
fn nobody_else_says_how_large_it_is() {
    for text in [
        include_str!("../src/tracer/lib.rs"),
        include_str!("../src/tracer/render/mod.rs"),
        include_str!("../README.md"),
        include_str!("../ARCHITECTURE.md"),
        include_str!("../CHANGELOG.md"),
    ] {
        for line in text.lines().filter(|line| line.contains("`Memory")) {
            assert!(!line.contains(" kB"), "{line}");
        }
    }
}

#[test]
fn sixteen_threads_take_less_than_8_mib_for_a_picture_of_any_size() {
    const { assert!(Memory::BYTES + 16 * Worker::BYTES < 8 << 20) };
}
