//! Constants for new memory, all bits zero, so that a `static` takes no space in an executable
//! file; and a short form of `Default`.

use glam::{Mat3, Vec2, Vec3, Vec3A, Vec4};

pub(crate) trait Zero {
    const ZERO: Self;
}

/// Implements [`Zero`] for a type by its value, or for a struct by its fields.
macro_rules! zero {
    ($($type:ty = $value:expr;)*) => {
        $(impl $crate::zero::Zero for $type { const ZERO: Self = $value; })*
    };
    ($($type:ident { $($field:ident),* })*) => {
        $(impl $crate::zero::Zero for $type {
            const ZERO: Self = Self { $($field: $crate::zero::Zero::ZERO),* };
        })*
    };
}

/// Implements [`Default`] for a type by its value.
macro_rules! default {
    ($(#[$doc:meta])* $type:ident = $value:expr) => {
        $(#[$doc])*
        impl Default for $type {
            fn default() -> Self {
                $value
            }
        }
    };
}

zero! {
    bool = false; u8 = 0; u16 = 0; u32 = 0; u64 = 0; i16 = 0; i32 = 0; usize = 0; f32 = 0.0;
    Mat3 = Mat3::ZERO; Vec2 = Vec2::ZERO; Vec3 = Vec3::ZERO; Vec3A = Vec3A::ZERO; Vec4 = Vec4::ZERO;
}

impl<T> Zero for Option<T> {
    const ZERO: Self = None;
}

impl<T: Zero, const N: usize> Zero for [T; N] {
    const ZERO: Self = [T::ZERO; N];
}
