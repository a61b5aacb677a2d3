//! Pyramid of a tile's points: a grid of them for each level.

use crate::lanes::MAX_LANES;
use crate::picture::{TILE_HEIGHT, TILE_WIDTH};
use crate::quality::Quality;
use crate::trace::{Layers, Sample};

/// Levels of the pyramid. Level 0 has single pixels, and level `n` squares of `1 << n` pixels a side.
pub(crate) const LEVELS: usize = Quality::MAX_SQUARE.ilog2() as usize + 1;

/// The grids of all levels but that of single pixels, which are drawn as they are traced.
///
/// A grid is row-major, with a point more along each side than there are squares, so that the corners of the square (x, y)
/// are the points (x, y), (x + 1, y), (x, y + 1) and (x + 1, y + 1).
pub(crate) struct Pyramid {
    /// [`Sample`]s as words, as the vector code loads them.
    samples: [u64; POINTS],
    /// The keys of what was hit and lit there.
    pub keys: [u32; POINTS],
    /// Of points that show a pattern, the light on it and apart from it.
    pub layers: [Layers; POINTS],
}

/// A row of a grid; the vector code may read some points beyond its end.
#[derive(Clone, Copy)]
pub(crate) struct GridRow<'a> {
    pub samples: &'a [u64],
    pub keys: &'a [u32],
}

/// Points of a row.
const fn columns(level: usize) -> usize {
    (TILE_WIDTH >> level) + 1
}

/// Where each level's grid starts in the arrays, the finest first.
const STARTS: [usize; LEVELS + 1] = {
    let mut starts = [0; LEVELS + 1];
    let mut level = 1;
    while level < LEVELS {
        starts[level + 1] = starts[level] + columns(level) * ((TILE_HEIGHT >> level) + 1);
        level += 1;
    }
    starts
};

/// All points, and what may be read beyond the last one.
const POINTS: usize = STARTS[LEVELS] + 2 * MAX_LANES;

/// Words of [`Pyramid::scratch`]: two for each pixel of an eighth of a tile.
pub(crate) const SCRATCH: usize = 2 * TILE_WIDTH * TILE_HEIGHT / 8;

impl Pyramid {
    pub const fn new() -> Self {
        Self {
            samples: [0; POINTS],
            keys: [0; POINTS],
            layers: [[0.0; 8]; POINTS],
        }
    }

    /// Where a level has its point (x, y).
    pub fn index(level: usize, x: usize, y: usize) -> usize {
        STARTS[level] + y * columns(level) + x
    }

    /// How many indices a row of a level's points takes.
    pub fn stride(level: usize) -> usize {
        columns(level)
    }

    pub fn sample(&self, index: usize) -> Sample {
        Sample(self.samples[index])
    }

    pub fn put(&mut self, index: usize, sample: Sample, key: u32) {
        self.samples[index] = sample.0;
        self.keys[index] = key;
    }

    /// Memory for other purposes, between tiles.
    pub fn scratch(&mut self) -> &mut [u64; SCRATCH] {
        self.samples.first_chunk_mut().expect("as many points")
    }

    /// A row of a level's grid.
    pub fn row(&self, level: usize, y: usize) -> GridRow<'_> {
        let start = Self::index(level, 0, y);
        let range = start..start + columns(level) + 2 * MAX_LANES - 1;
        GridRow {
            samples: &self.samples[range.clone()],
            keys: &self.keys[range],
        }
    }

    /// Where a level has the corners of its square (x, y): upper left, upper right, lower left, lower right.
    pub fn corner_indices(level: usize, x: usize, y: usize) -> [usize; 4] {
        let (upper, lower) = (Self::index(level, x, y), Self::index(level, x, y + 1));
        [upper, upper + 1, lower, lower + 1]
    }

    /// The samples at the corners of a level's square (x, y), in the same order.
    pub fn corners(&self, level: usize, x: usize, y: usize) -> [Sample; 4] {
        let (start, stride) = (Self::index(level, x, y), Self::stride(level));
        // One slice, whose end alone is checked.
        let samples = &self.samples[start..start + stride + 2];
        [0, 1, stride, stride + 1].map(|i| Sample(samples[i]))
    }
}
