//! Squares of pixels: the verdict on one, and its parts.

use super::Points;
use crate::lanes::*;
use crate::trace::{STEP, Sample};
use fearless_simd::{i16x8, u64x2};

/// A rectangle of pixels inside a band, a square where the sizes divide; its corners are the points (x, y),
/// (x + w, y), (x, y + h) and (x + w, y + h), the latter three outside it.
#[derive(Clone, Copy, Default)]
pub(crate) struct Square {
    pub x: u16,
    pub y: u16,
    pub w: u8,
    pub h: u8,
    /// Whether nothing can be seen in it that is not shown anyway.
    pub is_clear: bool,
}

/// The samples at a square's corners: upper left, upper right, lower left, lower right.
pub(crate) type Corners = [Sample; 4];

impl Square {
    /// Where it begins, x and y, and its sides along them.
    #[inline(always)]
    pub fn place(&self) -> (usize, usize, usize, usize) {
        let (w, h) = (self.w as usize, self.h as usize);
        (self.x as usize, self.y as usize, w, h)
    }

    /// Whether splitting it leaves single pixels.
    #[inline(always)]
    pub fn is_last(&self) -> bool {
        self.w <= 2 && self.h <= 2
    }

    /// The part number `i` of four; it may be empty.
    #[inline(always)]
    pub fn part(&self, i: usize) -> Self {
        let (left, top) = (self.w / 2, self.h / 2);
        let mut part = Self {
            w: left,
            h: top,
            ..*self
        };
        if i % 2 == 1 {
            part.x += u16::from(left);
            part.w = self.w - left;
        }
        if i / 2 == 1 {
            part.y += u16::from(top);
            part.h = self.h - top;
        }
        part
    }

    /// The samples around the parts.
    #[inline(always)]
    pub fn grid(&self, points: &Points) -> Grid {
        let (x, y, w, h) = self.place();
        let row = |y| {
            [
                points.sample(x, y),
                points.sample(x + w / 2, y),
                points.sample(x + w, y),
            ]
        };
        let ([a, b, c], [d, e, f], [g, h, i]) = (row(y), row(y + h / 2), row(y + h));
        let none = Sample::default();
        Grid([a, b, c, d, e, f, g, h, i, none, none, none])
    }

    /// Whether the keys at the corners agree.
    #[inline(always)]
    pub fn agrees(&self, points: &Points) -> bool {
        let (x, y, w, h) = self.place();
        let key = points.key(x, y);
        [(x + w, y), (x, y + h), (x + w, y + h)]
            .iter()
            .all(|&(x, y)| points.key(x, y) == key)
    }
}

/// The samples around a square's parts: three rows of three, and some more, so that no index is out of range.
pub(crate) struct Grid([Sample; 12]);

impl Grid {
    /// The corners of part number `i`.
    #[inline(always)]
    pub fn corners(&self, i: usize) -> Corners {
        let Self(samples) = self;
        let first = (i + i / 2) % 8;
        [
            samples[first],
            samples[first + 1],
            samples[first + 3],
            samples[first + 4],
        ]
    }

    /// The samples, row after row.
    #[inline(always)]
    pub fn samples(&self) -> &[Sample] {
        &self.0[..9]
    }
}

/// How far samples may be apart, for a square of one pixel.
#[derive(Clone, Copy)]
pub(crate) struct Limit(i32);

impl Limit {
    /// For a spread as a [`Quality`] has it.
    #[inline(never)]
    pub fn new(spread: f32) -> Self {
        Self((spread * (8 * STEP) as f32) as i32)
    }

    /// Below what any samples are apart.
    pub const NONE: Self = Self(i32::MIN);

    /// For a square of some side, in output steps.
    #[inline(always)]
    pub fn steps(self, side: usize) -> f32 {
        self.0 as f32 / (side as i32 * STEP) as f32
    }

    /// For a square of some side, as [`is_wider`] takes it.
    #[inline(always)]
    pub fn of(self, side: usize) -> u64 {
        let limit = if !side.is_power_of_two() {
            self.0 / side as i32
        } else {
            self.0 >> side.trailing_zeros()
        };
        channels(limit.clamp(-1, 0x7fff) as u16)
    }
}

/// The limit that all samples are beyond, equal ones too.
pub(super) const ALWAYS_FAR: u64 = channels(0xffff);

/// A limit for each channel of a sample, none for what else its word holds.
const fn channels(limit: u16) -> u64 {
    (limit as u64 * 0x0001_0001_0001) | (0x7fff << 48)
}

/// Whether two of some samples are farther apart than a limit in a channel.
///
/// Channels are below 2^15: SSE2 compares no unsigned words.
/// (Out of line where bytes count for more than time.)
#[inline(always)]
pub(super) fn is_wider<S: Simd>(simd: S, samples: &[Sample], limit: u64) -> bool {
    let (mut least, mut most) = (i16x8::splat(simd, i16::MAX), i16x8::splat(simd, 0));
    for sample in samples {
        let channels: i16x8<S> = u64x2::splat(simd, sample.0).bitcast();
        least = least.min(channels);
        most = most.max(channels);
    }
    let limit: i16x8<S> = u64x2::splat(simd, limit).bitcast();
    (most - least).simd_gt(limit).any_true()
}
