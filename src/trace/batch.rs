//! Points that are traced together.

use super::shade::Node;
use super::stack::{Rays, Stack};
use super::{Counts, Sample, sample};
use crate::lanes::*;
use crate::prepare::Prepared;
use fearless_simd::i32x4;

/// Points traced in one go: 16 kB of sums, which stay in the nearest cache.
pub(crate) const BATCH: usize = 1024;
/// Packets in a batch.
pub(crate) const PACKETS: usize = BATCH / LANES;

/// Bits below the point of a sum of output steps.
///
/// Sums count in 1/16384 of a step, so that a colour half-way between two of the 255 steps of the output stays just
/// there, and the rounding of a tree's nodes stays below 1/100 of a step.
pub(super) const STEP_BITS: i32 = 14;

/// Full brightness as a sum.
pub(super) const FIXED_POINT: f32 = (255 << STEP_BITS) as f32;

/// Blue, green and red, in the order of a pixel's bytes, and the key of a point.
pub(super) type Sum = [i32; 4];
/// Where the key is.
const KEY: usize = 3;

/// Points to trace, a packet of lanes at a time, and what came of them.
pub(crate) struct Batch {
    /// Where the points are: `y << 16 | x`.
    places: [[u32; LANES]; PACKETS],
    len: usize,
    /// Blue, green, red and key of each point.
    sums: [Sum; BATCH],
    samples: [[Sample; LANES]; PACKETS],
    pub stack: Stack,
    /// What was done since it was last reset.
    pub counts: Counts,
}

impl Batch {
    /// Room for points, empty.
    pub const fn new() -> Self {
        Self {
            places: [[0; LANES]; PACKETS],
            len: 0,
            sums: [[0; 4]; BATCH],
            samples: [[Sample(0); LANES]; PACKETS],
            stack: Stack::new(),
            counts: Counts::NONE,
        }
    }

    /// Points in it.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is no room for another point.
    #[inline(always)]
    pub fn is_full(&self) -> bool {
        self.len == BATCH
    }

    /// Adds the point at pixel (x, y); the batch must not be full.
    #[inline(always)]
    pub fn push(&mut self, x: usize, y: usize) {
        self.places.as_flattened_mut()[self.len % BATCH] = (y << 16 | x) as u32;
        self.len += 1;
    }

    /// Takes all points out.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Adds the points of row `y` from `x` on, `count` of them; there must be room.
    #[inline(always)]
    pub fn push_run<S: Simd>(&mut self, simd: S, x: usize, y: usize, count: usize) {
        let mut done = 0;
        if self.len.is_multiple_of(LANES) {
            let lane = U::from_fn(
                simd,
                #[inline(always)]
                |i| i as u32,
            );
            while done + LANES <= count {
                let place = (y << 16 | (x + done)) as u32;
                (lane + place).store_array(&mut self.places[self.len / LANES % PACKETS]);
                self.len += LANES;
                done += LANES;
            }
        }
        for x in x + done..x + count {
            self.push(x, y);
        }
    }

    /// The points' places, x and y, with their samples and keys, which [`Batch::finish`] has left.
    #[inline(always)]
    pub fn results(&self) -> impl Iterator<Item = (usize, usize, Sample, u32)> {
        let places = self.places.as_flattened()[..self.len].iter();
        places.zip(self.samples.as_flattened()).zip(&self.sums).map(
            #[inline(always)]
            |((&place, &sample), sum)| {
                let (x, y) = (place & 0xffff, place >> 16);
                (x as usize, y as usize, sample, sum[KEY] as u32)
            },
        )
    }

    /// Makes samples of the sums.
    #[inline(always)]
    pub(super) fn finish<S: Simd>(&mut self, simd: S) {
        let packets = self
            .sums
            .as_chunks::<LANES>()
            .0
            .iter()
            .zip(&mut self.samples);
        for (sums, samples) in packets.take(self.len.div_ceil(LANES)) {
            sample::from_sums(simd, sums, samples);
        }
    }

    /// Puts the points' pixels into `pixels`, in the order that the points were added.
    #[inline(always)]
    pub fn pixels<S: Simd>(&self, simd: S, pixels: &mut [[u32; LANES]; PACKETS]) {
        let packets = self.sums.as_chunks::<LANES>().0.iter().zip(pixels);
        for (sums, pixels) in packets.take(self.len.div_ceil(LANES)) {
            *pixels = sample::pixels_from_sums(simd, sums);
        }
    }

    /// The primary rays of a packet of points from number `start`, a multiple of the lanes. Lanes beyond the last point
    /// hold points of earlier batches: their rays go nowhere that is looked at.
    #[inline(always)]
    pub(super) fn primary_rays<S: Simd>(&self, simd: S, scene: &Prepared, start: usize) -> Rays<S> {
        let places = U::load_array_ref(simd, &self.places[start / LANES % PACKETS]);
        let x: I<S> = (places & 0xffff).bitcast();
        let y: I<S> = (places >> 16).bitcast();
        let raster = &scene.raster;
        let d = Vec3x::splat(simd, raster.corner)
            .add_scaled(Vec3x::splat(simd, raster.dx), x.to_float())
            .add_scaled(Vec3x::splat(simd, raster.dy), y.to_float());
        Rays {
            o: Vec3x::splat(simd, scene.eye),
            d: d.normalize(),
            weight: splat(simd, 1.0),
            place: Rays::places(simd, start),
        }
    }

    /// Starts the sums of the packet of points from number `start`, a multiple of the lanes.
    #[inline(always)]
    pub(super) fn set<S: Simd>(&mut self, start: usize, node: &Node<S>) {
        let start = start % BATCH / LANES * LANES;
        let sums = self.sums[start..start + LANES].as_flattened_mut();
        for (sums, terms) in sums.chunks_exact_mut(LANES).zip(node.terms()) {
            terms.store_slice(sums);
        }
    }

    /// Adds to the sums of some points.
    #[inline(always)]
    pub(super) fn add<S: Simd>(&mut self, simd: S, slots: U<S>, count: usize, node: &Node<S>) {
        let slots = slots.to_array();
        let [a, b, c, d] = node.terms();
        let terms = [a.to_array(), b.to_array(), c.to_array(), d.to_array()];
        let terms = terms.as_flattened().as_chunks::<4>().0;
        for (&slot, term) in slots.iter().zip(terms).take(count) {
            let sum = &mut self.sums[slot as usize % BATCH];
            let new = i32x4::load_array_ref(simd, sum) + i32x4::load_array_ref(simd, term);
            new.store_array(sum);
        }
    }
}
