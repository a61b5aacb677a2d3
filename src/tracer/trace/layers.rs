//! The light of a patterned surface, separated from the pattern.

use core::ops::{Add, Mul, Sub};
use glam::Vec3A;

/// The light of a traced point in two layers: its colour is `rest + reflectance * untextured`, with the share that the pattern
/// leaves. Along a surface both layers change slowly, while the pattern may not.
///
/// Channels are blue, green and red, in steps of 1/255.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Layers {
    /// The part that does not depend on the surface's colour: highlights, reflection, transmission and haze.
    pub rest: Vec3A,
    /// The light that the surface would reflect diffusely without a pattern.
    pub untextured: Vec3A,
}

impl Layers {
    /// Black.
    pub const NONE: Self = Self {
        rest: Vec3A::ZERO,
        untextured: Vec3A::ZERO,
    };

    /// The largest channel of both layers.
    #[inline(always)]
    pub fn most(self) -> f32 {
        self.rest.max(self.untextured).max_element()
    }

    /// The maximum, channel by channel.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self {
            rest: self.rest.max(other.rest),
            untextured: self.untextured.max(other.untextured),
        }
    }

    /// The minimum, channel by channel.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self {
            rest: self.rest.min(other.rest),
            untextured: self.untextured.min(other.untextured),
        }
    }
}

impl Add for Layers {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            rest: self.rest + other.rest,
            untextured: self.untextured + other.untextured,
        }
    }
}

impl Sub for Layers {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            rest: self.rest - other.rest,
            untextured: self.untextured - other.untextured,
        }
    }
}

impl Mul<f32> for Layers {
    type Output = Self;

    #[inline(always)]
    fn mul(self, share: f32) -> Self {
        Self {
            rest: self.rest * share,
            untextured: self.untextured * share,
        }
    }
}
