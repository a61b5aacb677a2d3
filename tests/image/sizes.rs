//! Pictures of every size are right to the last row and column.

use crate::accuracy::assert_as_traced;
use crate::drawn::draw_by_all;
use crate::refinement::{assert_as_refined, bare};
use eightfold::show;
use eightfold_oracle::frame::Frame;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH, Quality};

fn hold(width: usize, height: usize) {
    let scene = show::model_scene(0.5);
    let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, width, height);
    for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, width, height) {
        assert_as_traced(&drawn, &frame, &format!("{width}x{height} by {}", isa.name));
    }
    let what = format!("{width}x{height}");
    assert_as_refined(&scene, &bare(Quality::THESIS), [width, height], &what);
}

#[test]
fn small_and_odd_sizes_are_right_to_the_last_row_and_column() {
    for (width, height) in [
        (1, 1),
        (2, 1),
        (1, 2),
        (7, 3),
        (8, 8),
        (9, 9),
        (15, 17),
        (16, 16),
        (1, 100),
        (1000, 1),
        (255, 33),
        (256, 32),
        (257, 31),
        (1023, 767),
    ] {
        hold(width, height);
    }
}

#[test]
fn the_widest_and_the_tallest_are_right_to_the_last_row_and_column() {
    hold(MAX_WIDTH, 1);
    hold(MAX_WIDTH, 20);
    hold(1, MAX_HEIGHT);
    hold(20, MAX_HEIGHT);
}

#[test]
fn squares_of_every_size_draw_the_widest_and_the_tallest() {
    let scene = show::model_scene(0.5);
    for square in [1, 2, 3, 4, 5, 8, 12, 16, 17, 32] {
        let quality = Quality {
            square,
            ..Quality::THESIS
        };
        for (width, height) in [(MAX_WIDTH, 40), (40, MAX_HEIGHT)] {
            for (_, drawn) in draw_by_all(&scene, &quality, width, height) {
                assert!(drawn.counts.points > 0);
            }
        }
    }
}

#[test]
#[ignore = "the largest picture"]
fn the_largest_is_right_to_the_last_row_and_column() {
    hold(MAX_WIDTH, MAX_HEIGHT);
}
