//! The overlay of the method marks exactly the traced points and the filled squares. A golden
//! picture has coarse squares.

use crate::cpu;
use crate::drawn::{Drawn, draw, of_side};
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_harness::Size;
use eightfold_harness::frame_trace::FrameTrace;
use eightfold_tracer::observe::Fill;
use eightfold_tracer::presentation::{Method, Moment};
use eightfold_tracer::{Preset, Quality};

const SIZE: (usize, usize) = (331, 217);

const WHITE: u32 = 0x00ff_ffff;

const MARKS: Method = Method { picture: 0.0, ..Method::PLAIN };

fn scene(method: Method) -> Moment {
    let mut moment = Moment::from(show::model_scene(1.0));
    moment.presentation.method = method;
    moment
}

fn drawn(method: Method, quality: Quality) -> Drawn {
    let draw = |threads| draw(cpu::best(), threads, &scene(method), &quality, SIZE.0, SIZE.1);
    let [two, three] = [2, 3].map(draw);
    assert!(two.pixels == three.pixels, "{method:?}");
    two
}

fn trace(quality: &Quality) -> FrameTrace {
    let (level, size) = (cpu::best().level, Size::new(SIZE.0, SIZE.1));
    ThreadedRenderer::new(2).trace(level, &scene(MARKS), quality, size).1
}

#[test]
fn marks_lie_where_points_are_traced() {
    let method = Method { points: 1.0, ..MARKS };
    for quality in Preset::LADDER.iter().map(|preset| preset.quality()) {
        let pixels = drawn(method, *quality).pixels;
        let mut count = 0;
        for (i, (&pixel, rays)) in pixels.iter().zip(trace(quality).rays()).enumerate() {
            // The lower band does not mark points on its first row that the upper band traced.
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
fn lines_are_the_upper_and_left_sides_of_squares() {
    let method = Method { squares: 1.0, ..MARKS };
    let sides = [2, 32].map(|side| of_side(side, Quality::THESIS));
    for quality in Preset::LADDER.iter().map(|preset| preset.quality()).chain(&sides) {
        let mut expected = vec![0; SIZE.0 * SIZE.1];
        let mut covered = expected.clone();
        for square in trace(quality).squares() {
            assert!(square.side <= quality.square, "{square:?} by {quality:?}");
            for y in square.y..square.y + square.h {
                for x in square.x..square.x + square.w {
                    covered[y * SIZE.0 + x] += 1;
                    if square.fill != Fill::Points && (x == square.x || y == square.y) {
                        expected[y * SIZE.0 + x] = WHITE;
                    }
                }
            }
        }
        assert!(covered.iter().all(|&times| times == 1), "{quality:?}");
        assert!(drawn(method, *quality).pixels == expected, "{quality:?}");
    }
}

#[test]
fn overlay_keeps_or_dims_the_picture_between_marks() {
    let dimmed = Method { picture: 0.5, ..Method::PLAIN };
    let coarse = Method { coarse: 1.9, ..Method::PLAIN };
    // Pictures with an overlay are not antialiased.
    let plain = drawn(Method::PLAIN, Quality::DEFAULT.jagged());
    for (method, factor) in [(dimmed, 2), (coarse, 1)] {
        let drawn = drawn(method, Quality::DEFAULT);
        assert_eq!(plain.counts.points, drawn.counts.points);
        let bytes = |drawn: &Drawn| drawn.pixels.iter().flat_map(|it| it.to_be_bytes()).collect();
        let [plain, drawn]: [Vec<u8>; 2] = [&plain, &drawn].map(bytes);
        for (plain, drawn) in plain.into_iter().zip(drawn) {
            assert!(plain.abs_diff(factor * drawn) <= factor, "{method:?}: {plain}, {drawn}");
        }
    }
}

#[test]
fn front_parts_finished_from_marked_picture() {
    let overlay = Method { points: 1.0, squares: 0.5, picture: 0.2, ..Method::PLAIN };
    let width = SIZE.0;
    let [finished, marked] = [Method::PLAIN, overlay].map(|method| drawn(method, Quality::DEFAULT));
    for front in [0, 1, 64, 65, 200, width - 1, width] {
        let swept = Method { front: ((front as f32 + 0.5) / width as f32).min(1.0), ..overlay };
        for (i, &pixel) in drawn(swept, Quality::DEFAULT).pixels.iter().enumerate() {
            let x = i % width;
            let expected = match x {
                // Antialiasing mixes this pixel with the first one ahead.
                _ if x + 1 == front => continue,
                _ if x < front => finished.pixels[i],
                _ if front > 0 && x < front + 3 => WHITE,
                _ => marked.pixels[i],
            };
            assert_eq!(pixel, expected, "pixel {i}, front {front}");
        }
    }
}
