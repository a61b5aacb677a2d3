//! What a pattern is on, apart from the pattern.

use core::ops::{Add, Mul, Sub};
use glam::Vec3A;

/// A traced point of a surface with a pattern, in two layers: it shows `rest + left * full`, the pattern leaving that share
/// there. Both change slowly along a surface where the pattern does not.
///
/// Blue, green and red, in output steps.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Layers {
    /// What has nothing to do with the surface's colour: highlights, what is reflected or shines through, haze.
    pub rest: Vec3A,
    /// The light that the surface's own colour would send back without a pattern.
    pub full: Vec3A,
}

impl Layers {
    /// Black.
    pub const NONE: Self = Self {
        rest: Vec3A::ZERO,
        full: Vec3A::ZERO,
    };

    /// The greatest of all numbers.
    #[inline(always)]
    pub fn most(self) -> f32 {
        self.rest.max(self.full).max_element()
    }

    /// The greater of each two numbers.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self {
            rest: self.rest.max(other.rest),
            full: self.full.max(other.full),
        }
    }

    /// The smaller of each two numbers.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self {
            rest: self.rest.min(other.rest),
            full: self.full.min(other.full),
        }
    }
}

impl Add for Layers {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            rest: self.rest + other.rest,
            full: self.full + other.full,
        }
    }
}

impl Sub for Layers {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            rest: self.rest - other.rest,
            full: self.full - other.full,
        }
    }
}

impl Mul<f32> for Layers {
    type Output = Self;

    #[inline(always)]
    fn mul(self, share: f32) -> Self {
        Self {
            rest: self.rest * share,
            full: self.full * share,
        }
    }
}
