use super::isa::{Isa, at_least};
use super::types::*;
use core::ops::{Add, Mul, Sub};
use glam::Vec3;

/// A vector per lane, as a structure of arrays.
#[derive(Clone, Copy)]
pub(crate) struct Vec3x<S: Simd> {
    pub x: F<S>,
    pub y: F<S>,
    pub z: F<S>,
}

impl<S: Simd> Vec3x<S> {
    #[inline(always)]
    pub fn splat(simd: S, v: impl Into<Vec3>) -> Self {
        let v = v.into();
        Self { x: splat(simd, v.x), y: splat(simd, v.y), z: splat(simd, v.z) }
    }

    #[inline(always)]
    pub fn equal(c: F<S>) -> Self {
        Self { x: c, y: c, z: c }
    }

    #[inline(always)]
    pub fn dot(self, b: Self) -> F<S> {
        self.x.mul_add(b.x, self.y.mul_add(b.y, self.z * b.z))
    }

    #[inline(always)]
    pub fn max_element(self) -> F<S>
    where
        S: Isa,
    {
        at_least::<S>(at_least::<S>(self.x, self.y), self.z)
    }

    #[inline(always)]
    pub fn at_least(self, b: Self) -> Self
    where
        S: Isa,
    {
        Self {
            x: at_least::<S>(self.x, b.x),
            y: at_least::<S>(self.y, b.y),
            z: at_least::<S>(self.z, b.z),
        }
    }

    /// Returns `self + b s`.
    #[inline(always)]
    pub fn add_scaled(self, b: Self, s: F<S>) -> Self {
        Self { x: b.x.mul_add(s, self.x), y: b.y.mul_add(s, self.y), z: b.z.mul_add(s, self.z) }
    }

    #[inline(always)]
    pub fn flipped(self, flip: U<S>) -> Self {
        Self {
            x: flipped::<S>(self.x, flip),
            y: flipped::<S>(self.y, flip),
            z: flipped::<S>(self.z, flip),
        }
    }

    /// Returns `self s - b`.
    #[inline(always)]
    pub fn scaled_minus(self, s: F<S>, b: Self) -> Self {
        Self { x: self.x.mul_sub(s, b.x), y: self.y.mul_sub(s, b.y), z: self.z.mul_sub(s, b.z) }
    }

    #[inline(always)]
    pub fn select(mask: M<S>, a: Self, b: Self) -> Self {
        Self { x: mask.select(a.x, b.x), y: mask.select(a.y, b.y), z: mask.select(a.z, b.z) }
    }

    #[inline(always)]
    pub fn scaled(self, s: F<S>) -> Self {
        Self { x: self.x * s, y: self.y * s, z: self.z * s }
    }
}

impl<S: Simd> Add for Vec3x<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self { x: self.x + b.x, y: self.y + b.y, z: self.z + b.z }
    }
}

impl<S: Simd> Sub for Vec3x<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Self { x: self.x - b.x, y: self.y - b.y, z: self.z - b.z }
    }
}

/// Componentwise: a colour filters a colour.
impl<S: Simd> Mul for Vec3x<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Self { x: self.x * b.x, y: self.y * b.y, z: self.z * b.z }
    }
}
