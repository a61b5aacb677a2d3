//! The points of a band that have been traced.

use crate::MAX_WIDTH;
use crate::quality::Quality;
use crate::trace::Sample;

/// Points in a row: the last column of corners lies up to a square beyond the picture.
const ROW: usize = MAX_WIDTH + Quality::MAX_SQUARE;
/// Rows of points in a band.
const ROWS: usize = Quality::MAX_SQUARE + 1;
/// Words that hold a bit for each point of a row.
const WORDS: usize = ROW.div_ceil(64);

/// The samples of a band's points, and which of them are traced.
pub(crate) struct Points {
    samples: [[Sample; ROW]; ROWS],
    traced: [[u64; WORDS]; ROWS],
}

/// A row of points that two bands share: the lower corners of one's last squares are the upper corners of the other's
/// first.
pub(crate) struct Border {
    samples: [Sample; ROW],
    traced: [u64; WORDS],
}

impl Points {
    pub const fn new() -> Self {
        Self {
            samples: [[Sample::NONE; ROW]; ROWS],
            traced: [[0; WORDS]; ROWS],
        }
    }

    /// Forgets the first `rows` rows.
    pub fn clear(&mut self, rows: usize) {
        for row in &mut self.traced[..rows] {
            row.fill(0);
        }
    }

    /// Notes that the point at (x, y) is going to be traced; false where it was noted before.
    #[inline(always)]
    pub fn claim(&mut self, x: usize, y: usize) -> bool {
        let word = &mut self.traced[y][x / 64];
        let bit = 1 << (x % 64);
        let new = *word & bit == 0;
        *word |= bit;
        new
    }

    /// The sample at (x, y).
    #[inline(always)]
    pub fn at(&self, x: usize, y: usize) -> &Sample {
        &self.samples[y][x]
    }

    /// Keeps the sample at (x, y).
    #[inline(always)]
    pub fn put(&mut self, x: usize, y: usize, sample: Sample) {
        self.samples[y][x] = sample;
    }

    /// Takes row `y` over from a neighbour; `width` points of it matter.
    pub fn take(&mut self, y: usize, border: &Border, width: usize) {
        self.samples[y][..width].copy_from_slice(&border.samples[..width]);
        self.traced[y] = border.traced;
    }

    /// Leaves row `y` to a neighbour.
    pub fn leave(&self, y: usize, border: &mut Border, width: usize) {
        border.samples[..width].copy_from_slice(&self.samples[y][..width]);
        border.traced = self.traced[y];
    }
}

impl Border {
    pub const fn new() -> Self {
        Self {
            samples: [Sample::NONE; ROW],
            traced: [0; WORDS],
        }
    }

    /// Forgets the row.
    pub fn clear(&mut self) {
        self.traced.fill(0);
    }
}
