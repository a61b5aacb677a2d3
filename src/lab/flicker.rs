//! Flicker: errors that appear or disappear from one frame to the next, which are more visible than errors that stay.

/// The side, in pixels, of the blocks over which errors are averaged: that of the default quality's squares.
const BLOCK: usize = 8;

/// The change of a block's error between two frames above which it counts, in steps of 1/255.
const JUMP: f32 = 8.0;

/// Counts the blocks whose error changes abruptly from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct Flicker {
    /// The errors of the blocks in the last frame.
    last: Vec<f32>,
    /// The number of frames so far.
    pub frames: usize,
    /// The number of blocks whose error changed by more than `JUMP`, summed over all pairs of successive frames.
    pub jumps: usize,
}

impl Flicker {
    /// Takes the next frame, `width` pixels wide, and the exhaustive one of the same moment.
    pub fn next(&mut self, width: usize, exhaustive: &[u32], pixels: &[u32]) {
        let errors = block_errors(width, exhaustive, pixels);
        let pairs = self.last.iter().zip(&errors);
        self.jumps += pairs.filter(|(a, b)| (*a - *b).abs() > JUMP).count();
        self.last = errors;
        self.frames += 1;
    }

    /// The mean number of such blocks per pair of frames; `None` before the second frame.
    pub fn per_frame(&self) -> Option<f64> {
        (self.frames > 1).then(|| self.jumps as f64 / (self.frames - 1) as f64)
    }
}

/// The error of each block, row by row: the mean, over its pixels, of the largest difference in a channel, in steps of 1/255.
fn block_errors(width: usize, exhaustive: &[u32], pixels: &[u32]) -> Vec<f32> {
    let columns = width.div_ceil(BLOCK);
    let mut errors = Vec::new();
    let rows = exhaustive.chunks(BLOCK * width);
    for (a, b) in rows.zip(pixels.chunks(BLOCK * width)) {
        let mut sums = vec![0_u32; columns];
        for (a, b) in a.chunks_exact(width).zip(b.chunks_exact(width)) {
            let blocks = a.chunks(BLOCK).zip(b.chunks(BLOCK));
            for (sum, (a, b)) in sums.iter_mut().zip(blocks) {
                let off = a.iter().zip(b).map(|(&a, &b)| largest_difference(a, b));
                *sum += off.sum::<u32>();
            }
        }
        let height = a.len() / width;
        errors.extend(sums.iter().enumerate().map(|(i, &sum)| {
            let across = BLOCK.min(width - i * BLOCK);
            sum as f32 / (across * height) as f32
        }));
    }
    errors
}

/// The largest difference between two pixels in any channel. It is written without branches, since it runs for each pixel of
/// hundreds of frames.
fn largest_difference(a: u32, b: u32) -> u32 {
    let channel = |shift: u32| (a >> shift & 0xff).abs_diff(b >> shift & 0xff);
    channel(16).max(channel(8)).max(channel(0))
}
