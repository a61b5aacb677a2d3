/// The difference of two pictures, over all channels, in steps of 1/255.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    pub mean: f64,
    /// Pixels with a channel more than 8 off.
    pub over_8: usize,
    /// The mean square.
    pub square: f64,
    /// In dB, infinite for equal pictures.
    pub psnr: f64,
}

impl Difference {
    pub fn between(a: &[u32], b: &[u32]) -> Self {
        assert_eq!(a.len(), b.len(), "pictures of different sizes");
        let (mut sum, mut squares, mut over_8) = (0_u64, 0_u64, 0);
        for (&a, &b) in a.iter().zip(b) {
            for d in channels(a, b) {
                sum += u64::from(d);
                squares += u64::from(d * d);
            }
            over_8 += usize::from(worst_channel(a, b) > 8);
        }
        let count = (a.len() * 3) as f64;
        let square = squares as f64 / count;
        Self { mean: sum as f64 / count, over_8, square, psnr: decibels(square) }
    }

    pub fn pooled_psnr(differences: &[Self]) -> f64 {
        let sum: f64 = differences.iter().map(|each| each.square).sum();
        decibels(sum / differences.len() as f64)
    }
}

fn decibels(square: f64) -> f64 {
    10.0 * (255.0 * 255.0 / square).log10()
}

pub fn worst_channel(a: u32, b: u32) -> u32 {
    channels(a, b).into_iter().fold(0, u32::max)
}

fn channels(a: u32, b: u32) -> [u32; 3] {
    [16, 8, 0].map(|shift| (a >> shift & 0xff).abs_diff(b >> shift & 0xff))
}

/// A pixel pops if a channel changes by more than [`POP`] of 255 in a frame, and by at most
/// [`STILL`] in the reference.
const POP: u32 = 16;
const STILL: u32 = 4;

pub fn pops(references: [&[u32]; 2], frames: [&[u32]; 2]) -> usize {
    let change = |[before, after]: [&[u32]; 2], i: usize| worst_channel(before[i], after[i]);
    let pops = |&i: &usize| change(frames, i) > POP && change(references, i) <= STILL;
    (0..frames[0].len()).filter(pops).count()
}
