//! The points of a band that have been traced.

use super::square::is_wider;
use crate::MAX_WIDTH;
use crate::lanes::*;
use crate::quality::Quality;
use crate::trace::{Layers, Sample};

/// Points in a row: the last column of corners lies up to a square beyond the picture.
const ROW: usize = (MAX_WIDTH + Quality::MAX_SQUARE).next_power_of_two();
/// Rows of points in a band.
const ROWS: usize = Quality::MAX_SQUARE + 1;
/// Words that hold a bit for each point of a row.
const WORDS: usize = ROW.div_ceil(64);

/// The samples of a band's points, and which of them are traced.
pub(crate) struct Points([Border; ROWS]);

/// A row of points. Bands share those between them: the lower corners of one's last squares are the upper corners of
/// the other's first.
#[derive(Clone, Copy)]
pub(crate) struct Border {
    samples: [Sample; ROW],
    layers: [Layers; ROW],
    keys: [u32; ROW],
    traced: [u64; WORDS],
}

impl Border {
    /// A row without points.
    pub const NONE: Self = Self {
        samples: [Sample(0); ROW],
        layers: [Layers::NONE; ROW],
        keys: [0; ROW],
        traced: [0; WORDS],
    };

    /// Takes the first `width` points over from another row.
    pub fn copy(&mut self, other: &Self, width: usize, with_layers: bool, with_keys: bool) {
        self.traced = other.traced;
        for (to, from) in self.samples.iter_mut().zip(&other.samples).take(width) {
            *to = *from;
        }
        if with_layers {
            for (to, from) in self.layers.iter_mut().zip(&other.layers).take(width) {
                *to = *from;
            }
        }
        if with_keys {
            self.keys[..width].copy_from_slice(&other.keys[..width]);
        }
    }
}

impl Border {
    /// Whether the point at x is traced, or going to be.
    #[inline(always)]
    pub fn is_traced(&self, x: usize) -> bool {
        let word = self.traced.get(x / 64).copied().unwrap_or_default();
        word >> (x % 64) & 1 != 0
    }

    /// Whether the point at x has to be traced, which is noted: not where that has been done, nor where it lies between
    /// samples that are not farther apart than a limit, whose mean it gets.
    #[inline(always)]
    pub fn claim<S: Simd>(&mut self, simd: S, x: usize, limit: u64, a: Sample, b: Sample) -> bool {
        let places = (self.traced.get_mut(x / 64), self.samples.get_mut(x));
        let (Some(word), Some(sample)) = places else {
            return false;
        };
        let bit = 1 << (x % 64);
        if *word & bit != 0 {
            return false;
        }
        let is_far = is_wider(simd, &[a, b], limit);
        if is_far {
            *word |= bit;
        } else {
            *sample = a.mean(b);
        }
        is_far
    }

    /// Keeps what was traced at x.
    #[inline(always)]
    pub fn put(&mut self, x: usize, sample: Sample) {
        if let Some(place) = self.samples.get_mut(x) {
            *place = sample;
        }
    }

    /// Keeps the layers at x.
    #[inline(always)]
    pub fn put_layers(&mut self, x: usize, layers: Layers) {
        if let Some(place) = self.layers.get_mut(x) {
            *place = layers;
        }
    }

    /// Keeps the key at x.
    #[inline(always)]
    pub fn put_key(&mut self, x: usize, key: u32) {
        self.keys[x] = key;
    }
}

impl Points {
    pub const fn new() -> Self {
        Self([Border::NONE; ROWS])
    }

    /// Forgets the first `rows` rows.
    #[inline(always)]
    pub fn clear(&mut self, rows: usize) {
        for row in self.0.iter_mut().take(rows) {
            row.traced.fill(0);
        }
    }

    /// All rows.
    pub fn rows(&self) -> &[Border] {
        &self.0
    }

    /// Row `y`.
    #[inline(always)]
    pub fn row(&mut self, y: usize) -> Option<&mut Border> {
        self.0.get_mut(y)
    }

    /// The sample at (x, y); some sample where there is none.
    #[inline(always)]
    pub fn sample(&self, x: usize, y: usize) -> Sample {
        self.0[y.min(ROWS - 1)].samples[x % ROW]
    }

    /// The layers at (x, y); some layers where there are none.
    #[inline(always)]
    pub fn layers(&self, x: usize, y: usize) -> Layers {
        self.0[y.min(ROWS - 1)].layers[x % ROW]
    }

    /// The key at (x, y).
    #[inline(always)]
    pub fn key(&self, x: usize, y: usize) -> u32 {
        self.0[y].keys[x]
    }
}
