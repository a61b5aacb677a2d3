//! Squares of pixels: the verdict on one, and its parts.

use super::Points;
use crate::lanes::*;
use crate::quality::{Quality, limit};
use crate::trace::Sample;
use fearless_simd::{u16x8, u16x16, u64x2, u64x4};

/// A rectangle of pixels inside a band, a square where the sizes divide; its corners are the points (x, y),
/// (x + w, y), (x, y + h) and (x + w, y + h), the latter three outside it.
#[derive(Clone, Copy, Default)]
pub(crate) struct Square {
    pub x: u16,
    pub y: u16,
    pub w: u8,
    pub h: u8,
}

/// The samples at a square's corners: upper left, upper right, lower left, lower right.
pub(crate) type Corners = [Sample; 4];

/// What becomes of a square.
pub(crate) enum Verdict {
    /// One colour.
    Flat(u32),
    /// Colours interpolated between the corners.
    Bilinear,
    /// Its parts are looked at.
    Split,
}

impl Square {
    /// The places of the corners.
    #[inline(always)]
    fn places(&self) -> [(usize, usize); 4] {
        let (x, y) = (self.x as usize, self.y as usize);
        let (right, below) = (x + self.w as usize, y + self.h as usize);
        [(x, y), (right, y), (x, below), (right, below)]
    }

    /// The samples at the corners.
    #[inline(always)]
    pub fn corners(&self, points: &Points) -> Corners {
        {
            let [a, b, c, d] = self.places();
            let at = |(x, y)| points.sample(x, y);
            [at(a), at(b), at(c), at(d)]
        }
    }

    /// Whether splitting it leaves single pixels.
    #[inline(always)]
    pub fn is_last(&self) -> bool {
        self.w <= 2 && self.h <= 2
    }

    /// Where the parts meet.
    #[inline(always)]
    pub fn middle(&self) -> (usize, usize) {
        (
            self.x as usize + self.w as usize / 2,
            self.y as usize + self.h as usize / 2,
        )
    }

    /// The up to four parts; a part may be empty.
    #[inline(always)]
    pub fn parts(&self) -> [Self; 4] {
        let (left, top) = (self.w / 2, self.h / 2);
        let (right, bottom) = (self.w - left, self.h - top);
        let (x, y) = (self.x + u16::from(left), self.y + u16::from(top));
        [
            Self {
                w: left,
                h: top,
                ..*self
            },
            Self {
                x,
                w: right,
                h: top,
                ..*self
            },
            Self {
                y,
                w: left,
                h: bottom,
                ..*self
            },
            Self {
                x,
                y,
                w: right,
                h: bottom,
            },
        ]
    }

    /// What the qualities say of a square with these corners.
    #[inline(always)]
    pub fn verdict<S: Simd>(
        &self,
        simd: S,
        quality: &Quality,
        points: &Points,
        corners: Corners,
    ) -> Verdict {
        let [a, b, c, d] = corners;
        if a == b && a == c && a == d {
            return Verdict::Flat(a.pixel());
        }
        let side = self.w.max(self.h);
        let limit = limit(self.allowed(quality, points), side);
        if f32::from(spread(simd, corners)) <= limit {
            return Verdict::Bilinear;
        }
        let colour = a.pixel();
        if colour == b.pixel() && colour == c.pixel() && colour == d.pixel() {
            return Verdict::Flat(colour);
        }
        Verdict::Split
    }

    /// How far the corners' colours may be apart, for a square of 8 pixels.
    #[inline(always)]
    fn allowed(&self, quality: &Quality, points: &Points) -> f32 {
        if quality.needs_keys() {
            let [a, b, c, d] = self.places();
            let key = |(x, y)| points.key(x, y);
            if key(a) != key(b) || key(a) != key(c) || key(a) != key(d) {
                return quality.spread_differing;
            }
        }
        quality.spread_agreeing
    }
}

/// The largest difference between two corners in a channel, as a sample counts.
#[inline(always)]
fn spread<S: Simd>(simd: S, [a, b, c, d]: Corners) -> u16 {
    let upper: u16x8<S> = u64x2::simd_from(simd, [a.0, b.0]).bitcast();
    let lower: u16x8<S> = u64x2::simd_from(simd, [c.0, d.0]).bitcast();
    let most = upper.max(lower);
    let least = upper.min(lower);
    let most = most.max(most.rotate_elements_left::<4>());
    let least = least.min(least.rotate_elements_left::<4>());
    (most - least).reduce_max()
}

/// Whether the ends of the upper, left, right and lower side are at most `limit` apart in each channel.
#[inline(always)]
pub(super) fn close_sides<S: Simd>(simd: S, [a, b, c, d]: Corners, limit: f32) -> [bool; 4] {
    let starts: u16x16<S> = u64x4::simd_from(simd, [a.0, a.0, b.0, c.0]).bitcast();
    let ends: u16x16<S> = u64x4::simd_from(simd, [b.0, c.0, d.0, d.0]).bitcast();
    let apart: u64x4<S> = (starts.max(ends) - starts.min(ends)).bitcast();
    let widest = |i: usize| {
        let channels = apart[i];
        let (b, g, r) = (
            channels as u16,
            (channels >> 16) as u16,
            (channels >> 32) as u16,
        );
        f32::from(b.max(g).max(r)) <= limit
    };
    [widest(0), widest(1), widest(2), widest(3)]
}
