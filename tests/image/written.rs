//! Text over a finished picture, and copper bars.

use crate::drawn::draw_best;
use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Caption, CopperBar, List, Scene};
use eightfold_tracer::{Frame, Quality};

const SIZE: (usize, usize) = (640, 360);

fn written(letters: &[u8], numbers: [usize; 4]) -> Vec<u32> {
    let caption = Caption {
        letters: letters.iter().copied().collect(),
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
fn signs_stand_for_the_digits_of_four_numbers() {
    let plain = written(b" A  60 B 12345 C4.7/ .9", [0; 4]);
    let signs = b" A ### B $$$$$ C%.%/&.&";
    assert!(plain == written(signs, [60, 12_345, 1_047, 9]));
    assert!(plain.contains(&0xff_ff_ff));
    for other in [[61, 12_345, 47, 9], [60, 12_345, 47, 8]] {
        assert!(plain != written(signs, other));
    }
}

#[test]
fn copper_bar_covers_its_share_of_the_picture() {
    for brightness in [0.0, 0.5, 1.0] {
        let bar = CopperBar { middle: 0.25, height: 0.1, colour: vec3(1.0, 0.5, 0.0), brightness };
        let scene =
            Scene { background: Vec3::ONE, copper_bars: List::of(&[bar]), ..Scene::default() };
        let drawn = draw_best(&scene, &Quality::DEFAULT, SIZE.0, SIZE.1);
        for (y, row) in drawn.pixels.chunks(SIZE.0).enumerate() {
            assert!(row.iter().all(|pixel| *pixel == row[0]), "row {y}");
            // The bar is 36 rows high; row 90 is the first below its middle.
            let out = (y as f32 + 0.5 - 90.0) / 18.0;
            let covered = if out.abs() < 1.0 { brightness } else { 0.0 };
            let light = 1.0 - out * out;
            let [_, red, green, blue] = row[0].to_be_bytes();
            for (channel, colour) in [(red, 1.0), (green, 0.5), (blue, 0.0)] {
                let expected = 255.0 * (1.0 - covered + covered * light * colour);
                assert!((f32::from(channel) - expected).abs() < 2.0, "row {y}");
            }
        }
    }
}
