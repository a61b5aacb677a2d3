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
    /// Whether nothing can be seen in it that is not shown anyway.
    pub is_clear: bool,
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
        let [[a, b, c], [d, e, f], [g, h, i]] = [row(y), row(middle_y), row(below)];
        Grid([a, b, c, d, e, f, g, h, i])
    }

    /// Whether the keys at the corners agree.
    #[inline(always)]
    pub fn agrees(&self, points: &Points) -> bool {
        let [a, b, c, d] = self.places();
        let key = |(x, y)| points.key(x, y);
        key(a) == key(b) && key(a) == key(c) && key(a) == key(d)
    }
}

/// The samples around a square's parts: three rows of three.
pub(crate) struct Grid([Sample; 9]);

/// What the spreads of a square's parts are, four bits for each part, of which some are set where it is so.
pub(crate) struct Spreads {
    some: u64,
    over_agreeing: u64,
    over_differing: u64,
}

impl Grid {
    /// The corners of part number `i`.
    #[inline(always)]
    pub fn corners(&self, i: usize) -> Corners {
        let first = i / 2 * 3 + i % 2;
        [0, 1, 3, 4].map(|next| self.0[first + next])
    }

    /// The samples, row after row.
    #[inline(always)]
    pub fn samples(&self) -> &[Sample] {
        &self.0
    }

    /// Compares the parts' spreads to what a quality allows parts of this side.
    #[inline(always)]
    pub fn spreads<S: Simd>(&self, simd: S, quality: &Quality, side: u8) -> Spreads {
        let [a, b, c, d, e, f, g, h, i] = self.0;
        let (p, q) = (fours(simd, [a, b, d, e]), fours(simd, [b, c, e, f]));
        let (r, s) = (fours(simd, [d, e, g, h]), fours(simd, [e, f, h, i]));
        let spread = p.max(q).max(r.max(s)) - p.min(q).min(r.min(s));
        let over = |limit: u64| {
            let limit: i16x16<S> = u64x4::splat(simd, limit).bitcast();
            spread.simd_gt(limit).to_bitmask()
        };
        let over_agreeing = over(channels(limit(quality.spread_agreeing, side)));
        let over_differing = if quality.needs_keys() {
            over(channels(limit(quality.spread_differing, side)))
        } else {
            over_agreeing
        };
        Spreads {
            some: over(channels(0.0)),
            over_agreeing,
            over_differing,
        }
    }
}

impl Spreads {
    /// What becomes of the part number `i`, with these corners.
    #[inline(always)]
    pub fn verdict(&self, i: usize, agrees: bool, [a, b, c, d]: Corners) -> Verdict {
        let of_part = |bits: u64| bits >> (4 * i) & 0xf;
        let over = if agrees {
            self.over_agreeing
        } else {
            self.over_differing
        };
        let colour = a.pixel();
        if of_part(self.some) == 0 {
            Verdict::Flat(colour)
        } else if of_part(over) == 0 {
            Verdict::Bilinear
        } else if colour == b.pixel() && colour == c.pixel() && colour == d.pixel() {
            Verdict::Flat(colour)
        } else {
            Verdict::Split
        }
    }
}

/// The channels of four samples, which are below 2^15: SSE2 compares no unsigned words.
#[inline(always)]
fn fours<S: Simd>(simd: S, [a, b, c, d]: Corners) -> i16x16<S> {
    u64x4::simd_from(simd, [a.0, b.0, c.0, d.0]).bitcast()
}

/// A limit for each channel of a sample, none for what else its word holds.
#[inline(always)]
fn channels(limit: f32) -> u64 {
    (u64::from(limit as i16 as u16) * 0x0001_0001_0001) | (0x7fff << 48)
}

/// Four bits for each of the upper, left, right and lower side, of which some are set where its ends are more than
/// `limit` apart in a channel.
#[inline(always)]
pub(super) fn far_sides<S: Simd>(simd: S, [a, b, c, d]: Corners, limit: f32) -> u64 {
    let (starts, ends) = (fours(simd, [a, a, b, c]), fours(simd, [b, c, d, d]));
    let limit: i16x16<S> = u64x4::splat(simd, channels(limit)).bitcast();
    let apart = starts.max(ends) - starts.min(ends);
    apart.simd_gt(limit).to_bitmask()
}
