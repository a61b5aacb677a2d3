//! Flicker: errors that come and go from one frame to the next.
//!
//! An error that stays where it is, or moves with what is shown, goes unseen more easily than one that jumps.

/// Side of the blocks that errors are taken over, in pixels: the adaptive squares' usual side.
const BLOCK: usize = 8;

/// How far a block's error has to move from one frame to the next to be counted, of 255.
const JUMP: f32 = 8.0;

/// Counts the blocks whose error jumps while frames go by.
#[derive(Clone, Debug, Default)]
pub struct Flicker {
    /// The errors of the last frame's blocks.
    last: Vec<f32>,
    /// Frames seen.
    pub frames: usize,
    /// Blocks whose error has moved by more than 8 of 255, over all pairs of frames.
    pub jumps: usize,
}

impl Flicker {
    /// Looks at the next frame, `width` pixels wide, beside the exhaustive one.
    pub fn next(&mut self, width: usize, exhaustive: &[u32], pixels: &[u32]) {
        let errors = block_errors(width, exhaustive, pixels);
        let pairs = self.last.iter().zip(&errors);
        self.jumps += pairs.filter(|(a, b)| (*a - *b).abs() > JUMP).count();
        self.last = errors;
        self.frames += 1;
    }

    /// Blocks that jump from a frame to the next, on average; `None` before the second frame.
    pub fn per_frame(&self) -> Option<f64> {
        (self.frames > 1).then(|| self.jumps as f64 / (self.frames - 1) as f64)
    }
}

/// The error of each block of 8x8 pixels, row after row: the mean over its pixels of the largest channel's difference, of
/// 255.
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

/// Without a branch or a table, since this runs for each pixel of hundreds of frames.
fn largest_difference(a: u32, b: u32) -> u32 {
    let channel = |shift: u32| (a >> shift & 0xff).abs_diff(b >> shift & 0xff);
    channel(16).max(channel(8)).max(channel(0))
}
