//! A vector per lane.

use super::{F, fma};
use crate::lanes::*;
use core::ops::{Add, Mul, Sub};
use glam::Vec3;

/// Eight vectors, structure of arrays.
#[derive(Clone, Copy)]
pub(crate) struct Vec3x<S: Simd> {
    pub x: F<S>,
    pub y: F<S>,
    pub z: F<S>,
}

impl<S: Simd> Vec3x<S> {
    /// The same vector in every lane.
    #[inline(always)]
    pub fn splat(simd: S, v: Vec3) -> Self {
        Self {
            x: F::splat(simd, v.x),
            y: F::splat(simd, v.y),
            z: F::splat(simd, v.z),
        }
    }

    /// The scalar product.
    #[inline(always)]
    pub fn dot(self, b: Self) -> F<S> {
        fma(self.x, b.x, fma(self.y, b.y, self.z * b.z))
    }

    /// `self + b s`.
    #[inline(always)]
    pub fn add_scaled(self, b: Self, s: F<S>) -> Self {
        Self {
            x: fma(b.x, s, self.x),
            y: fma(b.y, s, self.y),
            z: fma(b.z, s, self.z),
        }
    }

    /// The vector of length 1 in the same direction; the length must not be 0.
    #[inline(always)]
    pub fn normalize(self) -> Self {
        let simd = self.x.simd;
        self * (F::splat(simd, 1.0) / self.dot(self).sqrt())
    }
}

impl<S: Simd> Add for Vec3x<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self {
            x: self.x + b.x,
            y: self.y + b.y,
            z: self.z + b.z,
        }
    }
}

impl<S: Simd> Sub for Vec3x<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Self {
            x: self.x - b.x,
            y: self.y - b.y,
            z: self.z - b.z,
        }
    }
}

impl<S: Simd> Mul<F<S>> for Vec3x<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, s: F<S>) -> Self {
        Self {
            x: self.x * s,
            y: self.y * s,
            z: self.z * s,
        }
    }
}

impl<S: Simd> Mul for Vec3x<S> {
    type Output = Self;
    /// The product of each component: how a colour filters a colour.
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Self {
            x: self.x * b.x,
            y: self.y * b.y,
            z: self.z * b.z,
        }
    }
}
