use crate::lanes::*;
use core::ops::Range;
use fearless_simd::{f32x4, i32x4, u32x4};

/// The most points in a batch: their 16 kB of sums stay in the L1 cache.
pub(crate) const BATCH: usize = 1024;

/// Positions are in 16ths of a pixel: the widest picture fits in 16 bits.
pub(crate) const PARTS: usize = 16;

const PART: f32 = 1.0 / PARTS as f32;

pub(crate) struct Queue {
    /// `y << 16 | x`, in 1/[`PARTS`] of a pixel.
    positions: [u32; BATCH],
    len: usize,
}

zero! { Queue { positions, len } }

impl Queue {
    pub fn len(&self) -> usize {
        self.len
    }

    pub fn push_pixel(&mut self, x: usize, y: usize) {
        self.push(PARTS * x, PARTS * y);
    }

    pub fn push(&mut self, x: usize, y: usize) {
        self.push_at((y << 16 | x) as u32);
    }

    /// Adds the point at `y << 16 | x`, in 1/[`PARTS`] of a pixel. The queue must not be full.
    pub fn push_at(&mut self, position: u32) {
        self.positions[self.len % BATCH] = position;
        self.len += 1;
    }

    pub fn clear(&mut self) {
        self.len = 0;
    }

    pub fn pixel(&self, i: usize) -> (usize, usize) {
        let (x, y) = self.position(i);
        (x / PARTS, y / PARTS)
    }

    pub fn position(&self, i: usize) -> (usize, usize) {
        let position = self.positions[i % BATCH] as usize;
        (position & 0xffff, position >> 16)
    }

    #[inline(always)]
    pub(super) fn pixels<S: Isa>(&self, simd: S, start: usize) -> [f32x4<S>; 2] {
        let start = start % BATCH / 4 * 4;
        let positions = u32x4::from_slice(simd, &self.positions[start..start + 4]);
        [positions & 0xffff, positions >> 16]
            .map(|c| c.bitcast::<i32x4<S>>().to_float::<f32x4<S>>() * PART)
    }

    /// In pixels. Lanes after the last point have stale positions, which are ignored.
    #[inline(always)]
    pub(super) fn packet<S: Isa>(&self, simd: S, start: usize) -> [F<S>; 2] {
        let positions = U::<S>::from_slice(simd, &self.positions[packet::<S>(start)]);
        [positions & 0xffff, positions >> 16].map(|c| c.bitcast::<I<S>>().to_float::<F<S>>() * PART)
    }
}

#[inline(always)]
pub(super) fn packet<S: Isa>(first: usize) -> Range<usize> {
    let first = first % BATCH / lanes::<S>() * lanes::<S>();
    first..first + lanes::<S>()
}
