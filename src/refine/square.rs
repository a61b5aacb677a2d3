//! Squares of pixels: the verdict on one, and its parts.

use super::Points;
use crate::trace::Sample;

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
pub(crate) type Corners<'a> = [&'a Sample; 4];

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
    /// The samples at the corners.
    #[inline(always)]
    pub fn corners<'a>(&self, points: &'a Points) -> Corners<'a> {
        let (x, y) = (self.x as usize, self.y as usize);
        let (right, below) = (x + self.w as usize, y + self.h as usize);
        [
            points.at(x, y),
            points.at(right, y),
            points.at(x, below),
            points.at(right, below),
        ]
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
}

/// Flat where the corners' rounded colours are equal, else interpolated where their keys are.
#[inline(always)]
pub(crate) fn verdict([a, b, c, d]: Corners<'_>) -> Verdict {
    let colour = a.pixel();
    if colour == b.pixel() && colour == c.pixel() && colour == d.pixel() {
        Verdict::Flat(colour)
    } else if a.key == b.key && a.key == c.key && a.key == d.key {
        Verdict::Bilinear
    } else {
        Verdict::Split
    }
}
