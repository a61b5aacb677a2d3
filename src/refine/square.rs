//! Squares of pixels: the verdict on one, and its parts.

use super::Points;
use crate::lanes::*;
use crate::quality::{Quality, limit};
use crate::trace::Sample;
use fearless_simd::{i16x16, u64x4};

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

    /// The samples around the parts: three rows of three.
    #[inline(always)]
    pub fn grid(&self, points: &Points) -> Grid {
        let (x, y) = (self.x as usize, self.y as usize);
        let (middle_x, middle_y) = self.middle();
        let (right, below) = (x + self.w as usize, y + self.h as usize);
        let row = |y| {
            [
                points.sample(x, y),
                points.sample(middle_x, y),
                points.sample(right, y),
            ]
        };
        Grid([row(y), row(middle_y), row(below)])
    }

    /// What a quality says of a square with these corners, whose spread is known.
    #[inline(always)]
    pub fn verdict(
        &self,
        quality: &Quality,
        points: &Points,
        [a, b, c, d]: Corners,
        spread: u16,
    ) -> Verdict {
        let colour = a.pixel();
        if spread == 0 {
            return Verdict::Flat(colour);
        }
        let side = self.w.max(self.h);
        if f32::from(spread) <= limit(self.allowed(quality, points), side) {
            return Verdict::Bilinear;
        }
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

/// The samples around a square's parts: three rows of three.
pub(crate) struct Grid([[Sample; 3]; 3]);

impl Grid {
    /// The corners of each part.
    #[inline(always)]
    pub fn corners(&self) -> [Corners; 4] {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.0;
        [[a, b, d, e], [b, c, e, f], [d, e, g, h], [e, f, h, i]]
    }

    /// For each part the largest difference between two corners in a channel, as a sample counts.
    #[inline(always)]
    pub fn spreads<S: Simd>(&self, simd: S) -> [u16; 4] {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.0;
        let (p, q) = (channels(simd, [a, b, d, e]), channels(simd, [b, c, e, f]));
        let (r, s) = (channels(simd, [d, e, g, h]), channels(simd, [e, f, h, i]));
        let most = p.max(q).max(r.max(s));
        let least = p.min(q).min(r.min(s));
        widest(most - least)
    }
}

/// The channels of four samples, which are below 2^15: SSE2 compares no unsigned words.
#[inline(always)]
fn channels<S: Simd>(simd: S, [a, b, c, d]: [Sample; 4]) -> i16x16<S> {
    u64x4::simd_from(simd, [a.0, b.0, c.0, d.0]).bitcast()
}

/// The largest channel of each of four samples.
#[inline(always)]
fn widest<S: Simd>(channels: i16x16<S>) -> [u16; 4] {
    let words: u64x4<S> = channels.bitcast();
    let (second, third): (i16x16<S>, i16x16<S>) =
        ((words >> 16).bitcast(), (words >> 32).bitcast());
    let widest: u64x4<S> = channels.max(second).max(third).bitcast();
    [
        widest[0] as u16,
        widest[1] as u16,
        widest[2] as u16,
        widest[3] as u16,
    ]
}

/// Whether the ends of the upper, left, right and lower side are at most `limit` apart in each channel.
#[inline(always)]
pub(super) fn close_sides<S: Simd>(simd: S, [a, b, c, d]: Corners, limit: f32) -> [bool; 4] {
    let starts = channels(simd, [a, a, b, c]);
    let ends = channels(simd, [b, c, d, d]);
    let [upper, left, right, lower] = widest(starts.max(ends) - starts.min(ends));
    let is_close = |apart: u16| f32::from(apart) <= limit;
    [
        is_close(upper),
        is_close(left),
        is_close(right),
        is_close(lower),
    ]
}
