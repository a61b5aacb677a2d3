//! Text that is written over a finished picture.

use eightfold_tracer::Frame;
use eightfold_tracer::scene::{Caption, List};

const SIZE: (usize, usize) = (640, 360);

/// A line over a black picture.
fn written(letters: &[u8], numbers: [usize; 3]) -> Vec<u32> {
    let caption = Caption {
        letters: List::of(letters),
        middle: 0.1,
        size: 0.05,
        brightness: 1.0,
    };
    let mut pixels = vec![0; SIZE.0 * SIZE.1];
    let mut frame = Frame::new(SIZE.0, SIZE.1, &mut pixels);
    frame.write(&[caption], numbers);
    pixels
}

#[test]
fn signs_stand_for_the_digits_of_three_numbers() {
    let plain = written(b" A  60 B 12345 C47", [0; 3]);
    let numbers = written(b" A ### B $$$$$ C%%", [60, 12_345, 1_047]);
    assert!(plain == numbers);
    assert!(plain.contains(&0xff_ff_ff));
    assert!(plain != written(b" A ### B $$$$$ C%%", [61, 12_345, 47]));
}

#[test]
fn lines_begin_at_the_left() {
    let pixels = written(b" I", [0; 3]);
    let lit = |x: usize| {
        pixels
            .iter()
            .skip(x)
            .step_by(SIZE.0)
            .any(|&pixel| pixel != 0)
    };
    assert!(!(0..7).any(lit) && (7..24).any(lit) && !(24..SIZE.0).any(lit));
}
