use eightfold::sound::{RATE, Synthesizer};
use std::ops::Range;

/// Bytes per stereo sample.
const FRAME: u32 = 8;

pub fn record(range: Range<u32>) -> Vec<[f32; 2]> {
    let mut synthesizer = Box::<Synthesizer>::default();
    let mut samples = vec![[0.0; 2]; range.len()];
    synthesizer.seek(range.start);
    synthesizer.play(&mut samples);
    samples
}

/// 48 kHz, 32-bit floating point.
pub fn wav(samples: &[[f32; 2]]) -> Vec<u8> {
    let size = samples.len() as u32 * FRAME;
    // Format 3 is floating point.
    let (format, channels) = (3, 2);
    let header = [
        u32::from_le_bytes(*b"RIFF"),
        36 + size,
        u32::from_le_bytes(*b"WAVE"),
        u32::from_le_bytes(*b"fmt "),
        16,
        format | channels << 16,
        RATE,
        RATE * FRAME,
        FRAME | (8 * FRAME / channels) << 16,
        u32::from_le_bytes(*b"data"),
        size,
    ];
    let header = header.into_iter().flat_map(u32::to_le_bytes);
    let samples = samples.iter().flatten();
    header.chain(samples.flat_map(|sample| sample.to_le_bytes())).collect()
}
