//! Points that are traced together.

use super::shade::Node;
use super::stack::{Rays, Stack};
use super::{Counts, SampleLanes};
use crate::lanes::*;
use crate::prepare::Prepared;

/// Points traced in one go: 16 kB of sums, which stay in the nearest cache.
pub(crate) const BATCH: usize = 1024;
/// Packets in a batch.
pub(crate) const PACKETS: usize = BATCH / LANES;

/// Parts of full brightness that a sum counts in.
///
/// A multiple of 255, so that a colour half-way between two of the 255 steps of the output stays just there; fine
/// enough that the rounding of a tree's nodes stays below 1/100 of a step, and coarse enough that 127 nodes of
/// [`super::shade::BRIGHTEST`] do not overflow 32 bits.
pub(crate) const FIXED_POINT: f32 = (255 << 14) as f32;

/// Points to trace, eight to a packet, and what came of them.
pub(crate) struct Batch {
    x: [[f32; LANES]; PACKETS],
    y: [[f32; LANES]; PACKETS],
    len: usize,
    /// Red, green, blue and key of each point, in fixed point.
    sums: [[[i32; LANES]; 4]; PACKETS],
    pub stack: Stack,
    /// What was done since it was last reset.
    pub counts: Counts,
}

impl Batch {
    /// Room for points, empty.
    pub const fn new() -> Self {
        Self {
            x: [[0.0; LANES]; PACKETS],
            y: [[0.0; LANES]; PACKETS],
            len: 0,
            sums: [[[0; LANES]; 4]; PACKETS],
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
        let (packet, lane) = (self.len / LANES % PACKETS, self.len % LANES);
        self.x[packet][lane] = x as f32;
        self.y[packet][lane] = y as f32;
        self.len += 1;
    }

    /// Adds the points of row `y` from `x` on, `count` of them; there must be room.
    #[inline(always)]
    pub fn push_run<S: Simd>(&mut self, simd: S, x: usize, y: usize, count: usize) {
        let mut done = 0;
        if self.len.is_multiple_of(LANES) {
            let lane = F::from_fn(
                simd,
                #[inline(always)]
                |i| i as f32,
            );
            while done + LANES <= count {
                let packet = self.len / LANES % PACKETS;
                (lane + (x + done) as f32).store_array(&mut self.x[packet]);
                self.y[packet] = [y as f32; LANES];
                self.len += LANES;
                done += LANES;
            }
        }
        for x in x + done..x + count {
            self.push(x, y);
        }
    }

    /// Takes all points out.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Where point number `i` is.
    #[inline(always)]
    pub fn place(&self, i: usize) -> (usize, usize) {
        let (packet, lane) = (i / LANES % PACKETS, i % LANES);
        (self.x[packet][lane] as usize, self.y[packet][lane] as usize)
    }

    /// The samples of eight points from number `start`, a multiple of eight.
    #[inline(always)]
    pub fn samples<S: Simd>(&self, simd: S, start: usize) -> SampleLanes<S> {
        let [r, g, b, key] = &self.sums[start / LANES % PACKETS];
        SampleLanes {
            colour: Vec3x {
                x: channel(simd, r),
                y: channel(simd, g),
                z: channel(simd, b),
            },
            key: I::load_array_ref(simd, key).bitcast(),
        }
    }

    /// The pixels of all points, in the order they were added.
    #[inline(always)]
    pub fn pixels<S: Simd>(&self, simd: S, pixels: &mut [[u32; LANES]; PACKETS]) {
        let packets = self.len.div_ceil(LANES).min(PACKETS);
        for (i, eight) in pixels[..packets].iter_mut().enumerate() {
            self.samples(simd, i * LANES).pixels().store_array(eight);
        }
    }

    /// The primary rays of the eight points from number `start`, a multiple of eight. Lanes beyond the last point hold
    /// points of earlier batches: their rays go nowhere that is looked at.
    #[inline(always)]
    pub(super) fn primary_rays<S: Simd>(&self, simd: S, scene: &Prepared, start: usize) -> Rays<S> {
        let packet = start / LANES % PACKETS;
        let x = F::load_array_ref(simd, &self.x[packet]);
        let y = F::load_array_ref(simd, &self.y[packet]);
        let raster = &scene.raster;
        let d = Vec3x::splat(simd, raster.corner)
            .add_scaled(Vec3x::splat(simd, raster.dx), x)
            .add_scaled(Vec3x::splat(simd, raster.dy), y);
        Rays {
            o: Vec3x::splat(simd, scene.eye),
            d: d.normalize(),
            weight: splat(simd, 1.0),
            place: Rays::places(simd, start),
        }
    }

    /// Starts the sums of the eight points from number `start`, a multiple of eight.
    #[inline(always)]
    pub(super) fn set<S: Simd>(&mut self, start: usize, node: &Node<S>) {
        let sums = &mut self.sums[start / LANES % PACKETS];
        for (sum, term) in sums.iter_mut().zip(node.fixed_point()) {
            term.store_array(sum);
        }
    }

    /// Adds to the sums of some points.
    #[inline(always)]
    pub(super) fn add<S: Simd>(&mut self, slots: &U<S>, count: usize, node: &Node<S>) {
        let slots = slots.to_array();
        let [r, g, b, key] = node.fixed_point().map(
            #[inline(always)]
            |term| term.to_array(),
        );
        for i in 0..count.min(LANES) {
            let slot = slots[i] as usize;
            let lane = slot % LANES;
            let sums = &mut self.sums[slot / LANES % PACKETS];
            sums[0][lane] = sums[0][lane].wrapping_add(r[i]);
            sums[1][lane] = sums[1][lane].wrapping_add(g[i]);
            sums[2][lane] = sums[2][lane].wrapping_add(b[i]);
            sums[3][lane] = sums[3][lane].wrapping_add(key[i]);
        }
    }
}

/// A sum as a number from 0 to 255.
#[inline(always)]
fn channel<S: Simd>(simd: S, sums: &[i32; LANES]) -> F<S> {
    let whole: F<S> = I::load_array_ref(simd, sums).to_float();
    (whole * (255.0 / FIXED_POINT))
        .max(splat(simd, 0.0))
        .min(splat(simd, 255.0))
}
