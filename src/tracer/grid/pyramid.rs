//! The traced points of a tile: a grid per level.

use crate::lanes::MAX_LANES;
use crate::picture::{TILE_HEIGHT, TILE_WIDTH};
use crate::quality::Quality;
use crate::trace::{Layers, Sample};

pub(crate) const LEVELS: usize = Quality::MAX_SQUARE.ilog2() as usize + 1;

/// The grids of all levels except level 0, whose pixels are drawn immediately.
///
/// A grid is row-major. The square (x, y) has the corners (x, y), (x + 1, y), (x, y + 1) and (x +
/// 1, y + 1).
pub(crate) struct Pyramid {
    /// [`Sample`]s as words.
    samples: [u64; POINTS],
    pub keys: [u32; POINTS],
    /// Only set where the world has patterns.
    pub layers: [Layers; POINTS],
}

/// A row of a grid. Vector code may read beyond its end.
#[derive(Clone, Copy)]
pub(crate) struct GridRow<'a> {
    pub samples: &'a [u64],
    pub keys: &'a [u32],
}

const STARTS: [usize; LEVELS + 1] = {
    let mut starts = [0; LEVELS + 1];
    let mut level = 1;
    while level < LEVELS {
        starts[level + 1] = starts[level] + Pyramid::stride(level) * ((TILE_HEIGHT >> level) + 1);
        level += 1;
    }
    starts
};

const POINTS: usize = STARTS[LEVELS] + 2 * MAX_LANES;

/// Two words for each pixel of an eighth of a tile.
pub(crate) const CHANGES: usize = 2 * TILE_WIDTH * TILE_HEIGHT / 8;

zero! { Pyramid { samples, keys, layers } }

impl Pyramid {
    pub fn index(level: usize, x: usize, y: usize) -> usize {
        STARTS[level] + y * Self::stride(level) + x
    }

    pub const fn stride(level: usize) -> usize {
        (TILE_WIDTH >> level) + 1
    }

    pub fn sample(&self, index: usize) -> Sample {
        Sample(self.samples[index])
    }

    pub fn put(&mut self, index: usize, sample: Sample, key: u32) {
        self.samples[index] = sample.0;
        self.keys[index] = key;
    }

    /// Returns the pixels' changes by antialiasing, in the samples' memory: no tile is drawn
    /// meanwhile.
    pub fn changes(&mut self) -> &mut [u64; CHANGES] {
        self.samples.first_chunk_mut().expect("enough points")
    }

    pub fn row(&self, level: usize, y: usize) -> GridRow<'_> {
        let start = Self::index(level, 0, y);
        let range = start..start + Self::stride(level) + 2 * MAX_LANES - 1;
        GridRow { samples: &self.samples[range.clone()], keys: &self.keys[range] }
    }

    pub fn corner_indices(level: usize, x: usize, y: usize) -> [usize; 4] {
        let (upper, lower) = (Self::index(level, x, y), Self::index(level, x, y + 1));
        [upper, upper + 1, lower, lower + 1]
    }

    pub fn grid(&self, level: usize) -> &[u64] {
        &self.samples[STARTS[level]..STARTS[level + 1]]
    }
}
