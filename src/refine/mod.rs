//! Which points of a band of the picture are traced, and what becomes of the rest.

/// Evaluates an expression by an instruction set, with all that it has.
macro_rules! by_isa {
    ($isa:expr, $simd:ident => $expression:expr) => {{
        #[cfg(target_arch = "x86_64")]
        match $isa {
            fearless_simd::Level::Avx512($simd) => {
                fearless_simd::Simd::vectorize($simd, #[inline(always)] || $expression)
            }
            fearless_simd::Level::Avx2($simd) => {
                fearless_simd::Simd::vectorize($simd, #[inline(always)] || $expression)
            }
            isa => match isa.as_sse2() {
                Some($simd) => fearless_simd::Simd::vectorize($simd, #[inline(always)] || $expression),
                None => unreachable!("every x86-64 has SSE2"),
            },
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            fearless_simd::dispatch!($isa, $simd => $expression)
        }
    }};
}

pub(crate) mod antialias;
mod band;
mod bits;
mod fill;
mod guard;
mod marks;
mod patterned;
mod points;
mod pyramid;
mod tile;
mod verdict;
mod worker;

pub use band::Band;
pub(crate) use band::{MAX_BANDS, render};
pub use worker::Worker;

/// Width of a tile in pixels.
const TILE_WIDTH: usize = 512;
/// Height of the tallest tile.
const TILE_HEIGHT: usize = 32;
