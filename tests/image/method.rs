//! The overlay that explains the method marks exactly the points that are traced and the squares that are filled, and a coarse
//! picture has squares of one colour.

use crate::cpu;
use crate::drawn::{draw, draw_best, jagged};
use crate::error::worst_channel;
use crate::overlay::FrameTrace;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_tracer::Quality;
use eightfold_tracer::observe::Fill;
use eightfold_tracer::scene::{Method, Scene};

/// A size that is no multiple of any square's side.
const SIZE: (usize, usize) = (331, 217);

const WHITE: u32 = 0x00ff_ffff;

/// The overlay of the model scene alone, on black.
fn overlay(points: f32, squares: f32) -> Scene {
    let mut scene = show::model_scene(1.0);
    scene.method = Method {
        points,
        squares,
        picture: 0.0,
        coarse: 0.0,
        front: 0.0,
    };
    scene
}

/// Draws a picture on two threads, and records its points and squares.
fn draw_traced(scene: &Scene, quality: &Quality) -> (Vec<u32>, FrameTrace) {
    let (width, height) = SIZE;
    let trace = FrameTrace::new(width, height);
    let mut pixels = vec![0; width * height];
    ThreadedRenderer::new(2).draw_observed(
        cpu::best().level,
        scene,
        quality,
        width,
        &mut pixels,
        &trace,
    );
    (pixels, trace)
}

#[test]
fn marks_lie_exactly_where_points_are_traced() {
    for quality in Quality::LADDER {
        let (pixels, trace) = draw_traced(&overlay(1.0, 0.0), quality);
        let mut count = 0;
        for (i, (&pixel, rays)) in pixels.iter().zip(trace.rays()).enumerate() {
            // On the row that two bands share, points that only the upper band traced have no mark.
            if (i / SIZE.0).is_multiple_of(32) && pixel == 0 {
                continue;
            }
            let expected = if rays > 0 { WHITE } else { 0 };
            assert_eq!(pixel, expected, "pixel {i} by {quality:?}");
            count += usize::from(rays > 0);
        }
        assert!(count > 400, "{count} points");
    }
}

#[test]
fn lines_are_the_upper_and_left_sides_of_filled_squares() {
    let (width, height) = SIZE;
    let (pixels, trace) = draw_traced(&overlay(0.0, 1.0), &Quality::DEFAULT);
    let mut expected = vec![0; width * height];
    for square in trace.squares().filter(|square| square.fill != Fill::Points) {
        for y in square.y..square.y + square.h {
            for x in square.x..square.x + square.w {
                if x == square.x || y == square.y {
                    expected[y * width + x] = WHITE;
                }
            }
        }
    }
    assert!(pixels == expected);
}

#[test]
fn the_picture_is_dimmed_between_marks_by_the_same_bits_on_any_number_of_threads() {
    let (width, height) = SIZE;
    let plain = draw_best(
        &show::model_scene(1.0),
        &jagged(Quality::DEFAULT),
        width,
        height,
    );
    let mut scene = overlay(0.0, 0.0);
    scene.method.picture = 0.5;
    let dimmed = draw_best(&scene, &Quality::DEFAULT, width, height);
    assert_eq!(plain.counts, dimmed.counts);
    for (plain, dimmed) in plain.pixels.iter().zip(&dimmed.pixels) {
        for shift in [0, 8, 16] {
            let [plain, dimmed] = [plain, dimmed].map(|pixel| (pixel >> shift & 0xff) as i32);
            assert!((plain - 2 * dimmed).abs() <= 2, "{plain} to {dimmed}");
        }
    }
    scene.method = Method {
        points: 0.7,
        squares: 0.3,
        picture: 0.4,
        coarse: 0.0,
        front: 0.0,
    };
    let drawn = draw_best(&scene, &Quality::DEFAULT, width, height);
    for threads in [2, 3, 7] {
        let again = draw(
            cpu::best(),
            threads,
            &scene,
            &Quality::DEFAULT,
            width,
            height,
        );
        assert!(drawn.pixels == again.pixels, "{threads} threads");
    }
}

#[test]
fn a_coarse_picture_has_squares_of_one_colour_by_the_same_bits_on_any_number_of_threads() {
    let (width, height) = SIZE;
    for quality in [Quality::EXHAUSTIVE, Quality::THESIS, Quality::DEFAULT] {
        for side in [2, 4, 8, 16, 32] {
            let mut scene = show::model_scene(1.0);
            scene.method.coarse = side as f32;
            let by = |threads| draw(cpu::best(), threads, &scene, &quality, width, height);
            let drawn = by(1);
            for (i, &pixel) in drawn.pixels.iter().enumerate() {
                let (x, y) = (i % width / side * side, i / width / side * side);
                // A square that agreed when it was larger is filled with colours between its corners'.
                let is_larger = side < quality.square;
                let corner = drawn.pixels[y * width + x];
                assert!(
                    is_larger || pixel == corner,
                    "pixel {i} by squares of {side}"
                );
            }
            for threads in [2, 3] {
                assert!(by(threads).pixels == drawn.pixels, "{threads} threads");
            }
            // About a point for each square, and none within them.
            let points = drawn.counts.points as usize;
            assert!(
                points < (width + 64) * (height + 64) * 2 / (side * side),
                "{points} by {side}"
            );
        }
    }
}

#[test]
fn squares_of_a_single_pixel_leave_the_picture_as_it_is() {
    let (width, height) = SIZE;
    let mut scene = show::model_scene(1.0);
    // With an overlay nothing is antialiased.
    let quality = jagged(Quality::DEFAULT);
    let plain = draw_best(&scene, &quality, width, height);
    scene.method.coarse = 1.9;
    let drawn = draw_best(&scene, &quality, width, height);
    assert_eq!(plain.counts, drawn.counts);
    // An overlay that shows nothing rounds colours down.
    for (&plain, &drawn) in plain.pixels.iter().zip(&drawn.pixels) {
        assert!(
            worst_channel(plain, drawn) <= 1,
            "{plain:06x} to {drawn:06x}"
        );
    }
}

#[test]
fn behind_the_front_is_the_finished_picture_and_ahead_of_it_the_overlay() {
    let (width, height) = SIZE;
    let by = |method: Method, threads| {
        let scene = Scene {
            method,
            ..show::model_scene(1.0)
        };
        draw(
            cpu::best(),
            threads,
            &scene,
            &Quality::DEFAULT,
            width,
            height,
        )
    };
    let overlay = Method {
        points: 1.0,
        squares: 0.5,
        picture: 0.2,
        ..Method::PLAIN
    };
    let (finished, marked) = (by(Method::PLAIN, 2), by(overlay, 2));
    for front in [0, 1, 64, 65, 200, width - 1, width] {
        let swept = Method {
            // In the middle of a pixel, where no rounding decides.
            front: ((front as f32 + 0.5) / width as f32).min(1.0),
            ..overlay
        };
        let drawn = by(swept, 2);
        for (i, &pixel) in drawn.pixels.iter().enumerate() {
            let x = i % width;
            let expected = match x {
                // What is mixed with the first pixel ahead, or has none to be mixed with, differs.
                _ if x + 1 == front => continue,
                _ if x < front => finished.pixels[i],
                _ if front > 0 && x < front + 3 => WHITE,
                _ => marked.pixels[i],
            };
            assert_eq!(pixel, expected, "pixel {i}, front {front}");
        }
        assert!(by(swept, 3).pixels == drawn.pixels, "front {front}");
    }
}
