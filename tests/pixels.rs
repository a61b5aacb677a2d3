//! A window shows exactly the pixels that were drawn, at any size, and stretches pictures of another size; with shared memory and
//! without.

use eightfold_stage::{on_displays, run, tool};
use eightfold_window::{
    screen::{Next, Screen},
    window::Window,
};
use std::{env, process::Command, thread::sleep, time::Duration};

/// The colour of a pixel in a picture whose neighbouring pixels all differ.
fn colour(x: usize, y: usize, round: usize) -> u32 {
    let mixed = (x * 73 + y * 179 + round * 31) as u32;
    mixed.wrapping_mul(0x9e37_79b1) >> 8
}

#[test]
fn a_window_shows_the_pixels_drawn_at_any_size() {
    on_displays(&[&[], &["-extension", "MIT-SHM"]], check_all_sizes);
}

fn check_all_sizes() {
    let display = env::var("DISPLAY").expect("there is a display");
    let mut window = Window::open(c"Eightfold", 301, 203).expect("there is a display");
    let sizes = [
        (301, 203),
        (1280, 1024),
        (1, 1),
        (17, 1),
        (1, 9),
        (640, 480),
    ];
    for (round, size) in sizes.into_iter().enumerate() {
        resize(&display, size);
        for _ in 0..500 {
            if window.size() == size {
                break;
            }
            draw(&mut window, round, false);
            sleep(Duration::from_millis(10));
        }
        for stretched in [false, true] {
            // Twice, since frames alternate between two buffers.
            draw(&mut window, round, stretched);
            draw(&mut window, round + 1, stretched);
            // The server may need some time.
            sleep(Duration::from_millis(100));
            compare(&display, size, round + 1, stretched);
        }
    }
}

/// Draws a picture of the window's size, or of half of it.
fn draw(window: &mut Window, round: usize, half: bool) {
    let (width, height) = window.size();
    let (width, height) = if half {
        halves(width, height)
    } else {
        (width, height)
    };
    let canvas = window.canvas(width, height);
    for (y, row) in canvas.chunks_exact_mut(width).enumerate() {
        for (x, pixel) in row.iter_mut().enumerate() {
            *pixel = colour(x, y, round);
        }
    }
    assert_eq!(window.show(), Next::GoOn);
}

fn halves(width: usize, height: usize) -> (usize, usize) {
    (width.div_ceil(2), height.div_ceil(2))
}

/// Resizes the window.
fn resize(display: &str, (width, height): (usize, usize)) {
    let mut xdotool = tool("xdotool");
    let words =
        format!("search --sync --name Eightfold windowmove 0 0 windowsize {width} {height}");
    run(xdotool.env("DISPLAY", display).args(words.split(' ')));
}

/// Compares the window's pixels on the screen with those drawn.
fn compare(display: &str, (width, height): (usize, usize), round: usize, half: bool) {
    let mut import: Command = tool("import");
    let part = format!("{width}x{height}+0+0");
    let (output, _) = run(import.env("DISPLAY", display).args([
        "-window", "root", "-crop", &part, "+repage", "-depth", "8", "rgb:-",
    ]));
    assert_eq!(
        output.stdout.len(),
        width * height * 3,
        "a picture of {width}x{height}"
    );
    let (from_width, from_height) = if half {
        halves(width, height)
    } else {
        (width, height)
    };
    for (i, rgb) in output.stdout.chunks_exact(3).enumerate() {
        let (x, y) = (
            i % width * from_width / width,
            i / width * from_height / height,
        );
        let [_, red, green, blue] = colour(x, y, round).to_be_bytes();
        assert_eq!(
            rgb,
            [red, green, blue],
            "pixel {},{} of {width}x{height}, drawn as {from_width}x{from_height}",
            i % width,
            i / width
        );
    }
}
