//! Writes WAV files.

use eightfold::sound::{RATE, Synthesizer};
use std::ops::Range;

/// The bytes of a sample of both channels.
const FRAME: u32 = 8;

/// Synthesizes a range of the song, given in samples.
pub fn record(range: Range<u32>) -> Vec<[f32; 2]> {
    let mut synthesizer = Box::<Synthesizer>::default();
    let mut samples = vec![[0.0; 2]; range.len()];
    synthesizer.seek(range.start);
    synthesizer.play(&mut samples);
    samples
}

/// Encodes stereo samples as a WAV file: 48 kHz, 32-bit floating point.
pub fn wav(samples: &[[f32; 2]]) -> Vec<u8> {
    const FLOATING_POINT: u16 = 3;
    const CHANNELS: u16 = 2;
    const FORMAT: u32 = 18;
    const HEADER: u32 = 58;
    let count = samples.len() as u32;
    let mut bytes = Vec::with_capacity((HEADER + count * FRAME) as usize);
    bytes.extend(b"RIFF");
    bytes.extend((HEADER - 8 + count * FRAME).to_le_bytes());
    bytes.extend(b"WAVEfmt ");
    bytes.extend(FORMAT.to_le_bytes());
    bytes.extend(FLOATING_POINT.to_le_bytes());
    bytes.extend(CHANNELS.to_le_bytes());
    bytes.extend(RATE.to_le_bytes());
    bytes.extend((RATE * FRAME).to_le_bytes());
    bytes.extend((FRAME as u16).to_le_bytes());
    bytes.extend((8 * FRAME as u16 / CHANNELS).to_le_bytes());
    // The size of the format's extension.
    bytes.extend(0_u16.to_le_bytes());
    bytes.extend(b"fact");
    bytes.extend(4_u32.to_le_bytes());
    bytes.extend(count.to_le_bytes());
    bytes.extend(b"data");
    bytes.extend((count * FRAME).to_le_bytes());
    for channel in samples.iter().flatten() {
        bytes.extend(channel.to_le_bytes());
    }
    bytes
}
