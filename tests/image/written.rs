use eightfold_tracer::Frame;
use eightfold_tracer::scene::Caption;

const SIZE: (usize, usize) = (640, 360);

fn written(letters: &[u8], numbers: [usize; 4]) -> Vec<u32> {
    let letters = letters.iter().copied().collect();
    let caption = Caption { letters, middle: 0.1, size: 0.05, brightness: 1.0 };
    let mut pixels = vec![0; SIZE.0 * SIZE.1];
    let mut frame = Frame::new(SIZE.0, SIZE.1, &mut pixels);
    frame.write(&[caption], numbers);
    pixels
}

#[test]
fn signs_stand_for_the_digits_of_four_numbers() {
    let plain = written(b" A  60 B 12345 C4.7/ .9", [0; 4]);
    let signs = b" A ### B $$$$$ C%.%/&.&";
    assert!(plain == written(signs, [60, 12_345, 1_047, 9]));
    assert!(plain.contains(&0xff_ff_ff));
    for other in [[61, 12_345, 47, 9], [60, 12_345, 47, 8]] {
        assert!(plain != written(signs, other));
    }
}
