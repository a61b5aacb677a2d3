//! Draws the waveform: the left channel above the right.

use super::axes::Heights;
use eightfold::show::{BARS, CUTS};

const BACKGROUND: u32 = 0x10_1218;
/// The colours of the lines at the start of a bar, and of a scene.
const LINES: [u32; 2] = [0x22_2630, 0x50_5870];
/// The colour from the smallest to the largest sample of a column.
const PEAK: u32 = 0x3a_6ea5;
/// The colour within the root mean square of a column.
const RMS: u32 = 0x9f_c8f0;

/// Draws the waveform of samples. Each channel has half of the height, and full scale fills it.
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
        for channel in 0..2 {
            let levels = column.iter().map(|sample| sample[channel]);
            let (least, most) = levels
                .clone()
                .fold((1.0, -1.0), |(least, most): (f32, f32), level| {
                    (least.min(level), most.max(level))
                });
            let rms = (levels.map(|level| level * level).sum::<f32>() / column.len() as f32).sqrt();
            for y in 0..half {
                let level = 1.0 - 2.0 * (y as f32 + 0.5) / half as f32;
                if (least..=most).contains(&level) {
                    let colour = if level.abs() < rms { RMS } else { PEAK };
                    pixels[(channel * half + y) * width + x] = colour;
                }
            }
        }
    }
    pixels
}

/// The values of its heights: amplitudes of each channel, 1 for full scale.
pub fn heights() -> Heights {
    let amplitudes = [
        ("left  1", 0.0),
        ("0", 0.25),
        ("right  1", 0.5),
        ("0", 0.75),
        ("-1", 1.0),
    ];
    Heights {
        ticks: amplitudes
            .map(|(name, share)| (share, name.to_owned()))
            .to_vec(),
        unit: "",
    }
}
