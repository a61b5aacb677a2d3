use eightfold_window::enlarge::{MAX_SMALL, Small};
use eightfold_window::pool::Pool;

/// Sides that 2 and 3 divide, or not; single pixels, rows and columns; the widest and the largest.
const SIZES: [[usize; 2]; 9] =
    [[1, 1], [2, 3], [1, 40], [41, 1], [12, 12], [13, 11], [64, 50], [3839, 7], [3840, 2160]];

fn mix(pixel: u32, neighbour: u32) -> u32 {
    let mean = |a: u8, b: u8| (u16::from(a) + u16::from(b)).div_ceil(2) as u8;
    let channels = pixel.to_le_bytes().into_iter().zip(neighbour.to_le_bytes());
    let mut mixed = channels.map(|(a, b)| mean(a, mean(a, b)));
    u32::from_le_bytes([(); 4].map(|()| mixed.next().expect("four channels")))
}

/// Returns the nearest small coordinate, and its neighbour on the side of the larger one.
fn sides(at: usize, factor: usize, count: usize) -> [usize; 2] {
    let nearest = at / factor;
    let neighbour = match at % factor {
        0 => nearest.saturating_sub(1),
        side if side == factor - 1 => usize::min(nearest + 1, count - 1),
        _ => nearest,
    };
    [nearest, neighbour]
}

#[test]
fn enlarged_pixels_are_mixed_or_repeated() {
    let pixels = (0..MAX_SMALL as u32).map(|i| i.wrapping_mul(0x9e37_79b1) >> 8);
    let pixels: Vec<u32> = pixels.collect();
    for factor in [2, 3] {
        for [columns, rows] in SIZES {
            let [width, height] = [columns, rows].map(|side| side.div_ceil(factor));
            for (threads, is_smooth) in [(1, true), (4, true), (4, false)] {
                let mut canvas = vec![u32::MAX; columns * rows];
                let small =
                    Small { pixels: &pixels, width, height, factor: factor as u32, is_smooth };
                small.enlarge(&mut Pool::new(threads), &mut canvas, columns);
                // A hundredth of the largest picture, in all rows and columns, is enough.
                let step = if canvas.len() > 1_000_000 { 97 } else { 1 };
                for (i, &pixel) in canvas.iter().enumerate().step_by(step) {
                    let [x, near_x] = sides(i % columns, factor, width);
                    let [y, near_y] = sides(i / columns, factor, height);
                    let row = |x: usize| mix(pixels[y * width + x], pixels[near_y * width + x]);
                    let expected = match is_smooth {
                        true => mix(row(x), row(near_x)),
                        false => pixels[y * width + x],
                    };
                    assert_eq!(pixel, expected, "{i} of {columns}x{rows} by {factor}");
                }
            }
        }
    }
}
