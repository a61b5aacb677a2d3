//! Vectors with a ray per lane. A lane's result never depends on its neighbours.
//!
//! A kernel is generic over the instruction set `S` and inlined into one function per set.
//! Functions and closures that kernels call need `#[inline(always)]`: otherwise they lose the
//! instruction set.

mod isa;
mod pow;
mod types;
mod vec3x;

/// Evaluates an expression with the instructions of a set.
macro_rules! by_isa {
    ($simd:ident: $expression:expr) => {
        fearless_simd::Simd::vectorize(
            $simd,
            #[inline(always)]
            || $expression,
        )
    };
}

pub(crate) use by_isa;
#[cfg(test)]
pub(crate) use isa::isas;
pub(crate) use isa::{Baseline, Isa, at_least, at_most, baseline, clamp};
pub(crate) use pow::{log2, pow};
pub use types::*;
pub(crate) use vec3x::Vec3x;
