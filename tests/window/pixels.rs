use eightfold_stage::{on_displays, run, screenshot, tool};
use eightfold_window::render_target::{InnerSize, Next, RenderTarget};
use eightfold_window::window::Window;
use std::{env, thread::sleep, time::Duration};

type Size = (usize, usize);

/// Neighbouring pixels differ.
fn colour(x: usize, y: usize, round: usize) -> u32 {
    let mixed = (x * 73 + y * 179 + round * 31) as u32;
    mixed.wrapping_mul(0x9e37_79b1) >> 8
}

#[test]
fn window_shows_the_pixels_drawn_at_any_size() {
    on_displays(&[&[], &["-extension", "MIT-SHM"]], check_all_sizes);
}

fn check_all_sizes() {
    let display = env::var("DISPLAY").expect("there is a display");
    let mut window =
        Window::open(c"Eightfold", InnerSize::Exactly(301, 203)).expect("there is a display");
    let sizes = [(301, 203), (1280, 1024), (1, 1), (17, 1), (640, 480)];
    for (round, size) in sizes.into_iter().enumerate() {
        let mut xdotool = tool("xdotool");
        let words = "search --sync --name Eightfold windowmove 0 0 windowsize";
        let sides = [size.0, size.1].map(|side| side.to_string());
        run(xdotool.env("DISPLAY", &display).args(words.split(' ')).args(sides));
        for _ in 0..500 {
            if window.size() == size {
                break;
            }
            draw(&mut window, size, round);
            sleep(Duration::from_millis(10));
        }
        for drawn in [size, (size.0.div_ceil(2), size.1.div_ceil(2))] {
            // Two frames: the window has two buffers.
            draw(&mut window, drawn, round);
            draw(&mut window, drawn, round + 1);
            sleep(Duration::from_millis(100));
            compare(&display, size, drawn, round + 1);
        }
    }
}

fn draw(window: &mut Window, (width, height): Size, round: usize) {
    let canvas = window.canvas(width, height);
    for (y, row) in canvas.chunks_exact_mut(width).enumerate() {
        for (x, pixel) in row.iter_mut().enumerate() {
            *pixel = colour(x, y, round);
        }
    }
    assert_eq!(window.show(), Next::GoOn);
}

fn compare(display: &str, (width, height): Size, drawn: Size, round: usize) {
    let pixels = screenshot(display, [0, 0, width as i32, height as i32]);
    for (i, pixel) in pixels.into_iter().enumerate() {
        let (x, y) = (i % width, i / width);
        let expected = colour(x * drawn.0 / width, y * drawn.1 / height, round);
        assert_eq!(pixel, expected, "pixel {x},{y} of {width}x{height}, drawn as {drawn:?}");
    }
}
