//! Traces points: a point's colour and key from the tree of rays that starts there.
//!
//! Rays travel eight at a time, whichever points they belong to. A packet's secondary rays go to a stack of fixed
//! capacity, and the next packet is taken from its top as soon as it fills the lanes, so there is no recursion and few
//! lanes idle. Colours are summed in fixed point: integer sums do not depend on the order in which rays come back, so
//! a point has the same bits whatever points it is traced with.

mod intersect;
mod key;
mod shade;
mod stack;

use crate::lanes::*;
use crate::prepare::Prepared;
use crate::quality::Quality;
use stack::{Rays, Stack};

/// Points traced in one go: 16 kB of sums, which stay in the nearest cache.
pub(crate) const BATCH: usize = 1024;

/// Parts of full brightness that a sum counts in.
///
/// A multiple of 255, so that a colour half-way between two of the 255 steps of the output stays just there; fine enough
/// that the rounding of a tree's nodes stays below 1/100 of a step, and coarse enough that 127 nodes of
/// [`shade::BRIGHTEST`] do not overflow 32 bits.
const FIXED_POINT: f32 = (255 << 14) as f32;

/// Points to trace, and what came of them.
pub(crate) struct Batch {
    x: [f32; BATCH],
    y: [f32; BATCH],
    len: usize,
    sums: [[u32; 4]; BATCH],
    stack: Stack,
    /// What was done since it was last reset.
    pub counts: Counts,
}

/// How much work was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Points traced.
    pub points: u64,
    /// Primary and secondary rays.
    pub rays: u64,
    /// Rays towards a light.
    pub shadow_rays: u64,
    /// Packets that the primary and secondary rays travelled in.
    pub packets: u64,
}

impl core::ops::AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.points += other.points;
        self.rays += other.rays;
        self.shadow_rays += other.shadow_rays;
        self.packets += other.packets;
    }
}

impl Batch {
    /// Room for points, empty.
    pub const fn new() -> Self {
        Self {
            x: [0.0; BATCH],
            y: [0.0; BATCH],
            len: 0,
            sums: [[0; 4]; BATCH],
            stack: Stack::new(),
            counts: Counts {
                points: 0,
                rays: 0,
                shadow_rays: 0,
                packets: 0,
            },
        }
    }

    /// Adds the point at pixel (x, y); the batch must not be full.
    #[inline(always)]
    pub fn push(&mut self, x: usize, y: usize) {
        self.x[self.len] = x as f32;
        self.y[self.len] = y as f32;
        self.len += 1;
    }

    /// Whether there is no room for another point.
    #[inline(always)]
    pub fn is_full(&self) -> bool {
        self.len == BATCH
    }

    /// Traces all points, hands each one's place and [`Sample`] to `put` in the order they were pushed, and empties
    /// the batch.
    #[inline(always)]
    pub fn trace<S: Simd>(
        &mut self,
        simd: S,
        scene: &Prepared,
        quality: &Quality,
        mut put: impl FnMut(usize, usize, Sample),
    ) {
        self.trace_rays(simd, scene, quality);
        for i in 0..self.len {
            put(
                self.x[i] as usize,
                self.y[i] as usize,
                Sample::from_sum(self.sums[i]),
            );
        }
        self.counts.points += self.len as u64;
        self.len = 0;
    }

    #[inline(always)]
    fn trace_rays<S: Simd>(&mut self, simd: S, scene: &Prepared, quality: &Quality) {
        let mut next = 0;
        loop {
            let primary = self.stack.len() < LANES && next < self.len;
            let (rays, count) = if primary {
                let count = (self.len - next).min(LANES);
                let rays = self.primary(simd, scene, next);
                (rays, count)
            } else {
                let (rays, count) = self.stack.pop(simd);
                if count == 0 {
                    break;
                }
                (rays, count)
            };
            let active = first(simd, count);
            self.counts.rays += count as u64;
            self.counts.packets += 1;
            let hit = if primary {
                intersect::nearest(simd, scene, &rays, |ball| Vec3x::splat(simd, ball.from_eye))
            } else {
                intersect::nearest(simd, scene, &rays, |ball| {
                    rays.o - Vec3x::splat(simd, ball.centre)
                })
            };
            let node = shade::shade(
                simd,
                scene,
                quality,
                &rays,
                &hit,
                active,
                &mut self.stack,
                &mut self.counts,
            );
            let packed = node.pack(simd);
            if primary {
                for (sum, term) in self.sums[next..].iter_mut().zip(packed).take(count) {
                    *sum = term;
                }
                next += count;
            } else {
                let slots = rays.slots().to_array();
                for (&slot, term) in slots.iter().zip(packed).take(count) {
                    let sum = &mut self.sums[slot as usize % BATCH];
                    for (s, t) in sum.iter_mut().zip(term) {
                        *s = s.wrapping_add(t);
                    }
                }
            }
        }
    }

    /// The primary rays of the points from number `next` on.
    #[inline(always)]
    fn primary<S: Simd>(&self, simd: S, scene: &Prepared, next: usize) -> Rays<S> {
        // Lanes beyond the last point hold points of earlier batches, or 0: their rays go nowhere that is looked at.
        let start = next.min(BATCH - LANES);
        let x = F::from_slice(simd, &self.x[start..start + LANES]);
        let y = F::from_slice(simd, &self.y[start..start + LANES]);
        let raster = &scene.raster;
        let d = Vec3x::splat(simd, raster.corner)
            .add_scaled(Vec3x::splat(simd, raster.dx), x)
            .add_scaled(Vec3x::splat(simd, raster.dy), y);
        Rays {
            o: Vec3x::splat(simd, scene.eye),
            d: d.normalize(),
            weight: F::splat(simd, 1.0),
            place: Rays::places(simd, next),
        }
    }
}

/// A traced point: its colour, 0 to 255 per channel and not rounded, and its key.
#[derive(Clone, Copy, Default)]
#[repr(align(16))]
pub(crate) struct Sample {
    pub colour: [f32; 3],
    pub key: u32,
}

impl Sample {
    /// No sample.
    pub const NONE: Self = Self {
        colour: [0.0; 3],
        key: 0,
    };

    /// The colour as a pixel, `0x00RRGGBB`, rounded.
    #[inline(always)]
    pub fn pixel(&self) -> u32 {
        let [r, g, b] = self.colour.map(|c| (c + 0.5) as i32 as u32);
        r << 16 | g << 8 | b
    }

    /// The colour at share `v` of the way from one sample to another.
    #[inline(always)]
    pub fn between(a: &Self, b: &Self, v: f32) -> [f32; 3] {
        core::array::from_fn(|k| a.colour[k] + (b.colour[k] - a.colour[k]) * v)
    }

    #[inline(always)]
    fn from_sum(sum: [u32; 4]) -> Self {
        let channel = |s: u32| (s as i32 as f32 * (255.0 / FIXED_POINT)).clamp(0.0, 255.0);
        Self {
            colour: [channel(sum[0]), channel(sum[1]), channel(sum[2])],
            key: sum[3],
        }
    }
}
