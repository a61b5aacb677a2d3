//! The waveform as a picture: left above right.

use eightfold::show::grid::{BARS, CUTS};

const BACKGROUND: u32 = 0x10_1218;
/// Where a bar begins, and where a scene does.
const LINES: [u32; 2] = [0x22_2630, 0x50_5870];
/// From the least to the largest sample of a column, and within the root of the mean square.
const PEAK: u32 = 0x3a_6ea5;
const MEAN: u32 = 0x9f_c8f0;

/// Draws samples, from the first column to the last, full scale half of each side's height.
pub fn draw(samples: &[[f32; 2]], width: usize, height: usize) -> Vec<u32> {
    let mut pixels = vec![BACKGROUND; width * height];
    for bar in 0..BARS as usize {
        let line = LINES[usize::from(CUTS.contains(&(bar as u32)))];
        let x = bar * width / BARS as usize;
        for row in pixels.chunks_exact_mut(width) {
            row[x] = line;
        }
    }
    let half = height / 2;
    for x in 0..width {
        let column = &samples[x * samples.len() / width..(x + 1) * samples.len() / width];
        for side in 0..2 {
            let levels = column.iter().map(|sample| sample[side]);
            let (least, most) = levels
                .clone()
                .fold((1.0, -1.0), |(least, most): (f32, f32), level| {
                    (least.min(level), most.max(level))
                });
            let root =
                (levels.map(|level| level * level).sum::<f32>() / column.len() as f32).sqrt();
            for y in 0..half {
                let level = 1.0 - 2.0 * (y as f32 + 0.5) / half as f32;
                if (least..=most).contains(&level) {
                    let colour = if level.abs() < root { MEAN } else { PEAK };
                    pixels[(side * half + y) * width + x] = colour;
                }
            }
        }
    }
    pixels
}
