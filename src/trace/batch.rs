//! Points that are traced together: the queue of their positions, and the sums of what their rays bring back.

use super::candidates::Candidates;
use super::contribution::Contribution;
use super::sample::{STEP_BITS, Sum};
use super::stack::{Rays, Stack};
use super::surface::SurfaceRows;
use super::{Counts, Layers, Sample, sample};
use crate::lanes::*;
use crate::prepare::Prepared;
use fearless_simd::i32x4;
use glam::Vec3A;

/// The most points that are traced together: their sums take 16 kB, which stay in the nearest cache.
pub(crate) const BATCH: usize = 1024;

/// Where the key is.
const KEY: usize = 3;

/// Points to trace and what came of them.
pub(crate) struct Batch {
    /// Where the points are: `y << 16 | x`.
    positions: [u32; BATCH],
    len: usize,
    sums: [Sum; BATCH],
    /// What a packet of secondary rays adds to the sums.
    terms: [Sum; MAX_LANES],
    samples: [u64; BATCH],
    /// The part of the colour that a pattern darkens, blue, green and red in output steps, and the share that the pattern leaves.
    patterned: [[f32; 4]; BATCH],
    /// The objects that the primary rays hit.
    objects: [u32; BATCH],
    pixels: [u32; BATCH],
    pub stack: Stack,
    /// What the packet at work may meet beyond spheres and planes, or on its way to a lamp.
    pub candidates: Candidates,
    /// The surfaces of the packet at work.
    pub(super) surfaces: SurfaceRows,
    /// The work since they were last reset.
    pub counts: Counts,
}

impl Batch {
    /// Room for points, empty.
    pub const fn new() -> Self {
        Self {
            positions: [0; BATCH],
            len: 0,
            sums: [[0; 4]; BATCH],
            terms: [[0; 4]; MAX_LANES],
            samples: [0; BATCH],
            patterned: [[0.0; 4]; BATCH],
            objects: [0; BATCH],
            pixels: [0; BATCH],
            stack: Stack::new(),
            candidates: Candidates::NONE,
            surfaces: SurfaceRows::NONE,
            counts: Counts::NONE,
        }
    }

    /// Begins a part of a picture: forgets the surfaces of other frames.
    pub fn begin(&mut self) {
        self.surfaces.clear();
    }

    /// Points in it.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Adds the point at pixel (x, y); the batch must not be full.
    #[inline(always)]
    pub fn push(&mut self, x: usize, y: usize) {
        self.positions[self.len % BATCH] = (y << 16 | x) as u32;
        self.len += 1;
    }

    /// The traced points as pixels.
    #[inline(always)]
    pub fn pixels<S: Simd>(&mut self, simd: S) -> &[u32] {
        let (samples, _) = self.samples.as_chunks();
        let (pixels, _) = self.pixels.as_chunks_mut();
        for (pixels, samples) in pixels.iter_mut().zip(samples) {
            *pixels = sample::pixels(simd, samples);
        }
        &self.pixels
    }

    /// Removes all points.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// The position of point number `i` in the picture, x and y.
    #[inline(always)]
    pub fn position(&self, i: usize) -> (usize, usize) {
        let position = self.positions[i % BATCH] as usize;
        (position & 0xffff, position >> 16)
    }

    /// The sample and the key of traced point number `i`.
    #[inline(always)]
    pub fn sample(&self, i: usize) -> (Sample, u32) {
        let i = i % BATCH;
        let sample = Sample(self.samples[i]).showing(self.objects[i]);
        (sample, self.sums[i][KEY] as u32)
    }

    /// The layers of traced point number `i`, if it shows an object with a pattern.
    #[inline(always)]
    pub fn layers(&self, i: usize) -> Layers {
        let i = i % BATCH;
        let [blue, green, red, share] = self.patterned[i];
        let untextured = Vec3A::new(blue, green, red);
        let [blue, green, red, _] = self.sums[i].map(|sum| sum as f32);
        let sum = Vec3A::new(blue, green, red) * (1.0 / (1 << STEP_BITS) as f32);
        Layers {
            rest: sum - untextured * share,
            untextured,
        }
    }

    /// Turns the sums into samples.
    #[inline(always)]
    pub(super) fn finish<S: Isa>(&mut self, simd: S) {
        let n = lanes::<S>();
        for start in (0..self.len.min(BATCH)).step_by(n) {
            let start = start % BATCH / n * n;
            let sums = &self.sums[start..start + n];
            sample::from_sums(simd, sums, &mut self.samples[start..start + n]);
        }
    }

    /// The primary rays of a packet of points from number `start`, a multiple of the number of lanes. Lanes beyond the last point
    /// have rays of an earlier batch, whose results nobody reads.
    #[inline(always)]
    pub(super) fn primary_rays<S: Isa>(&self, simd: S, scene: &Prepared, start: usize) -> Rays<S> {
        let start = start % BATCH / lanes::<S>() * lanes::<S>();
        let positions = U::<S>::from_slice(simd, &self.positions[start..start + lanes::<S>()]);
        let x: I<S> = (positions & 0xffff).bitcast();
        let y: I<S> = (positions >> 16).bitcast();
        Rays {
            o: Vec3x::splat(simd, scene.eye),
            d: primary_directions(simd, scene, x.to_float(), y.to_float()),
            weight: splat(simd, scene.weight),
            slot_path: Rays::slot_paths(simd, start),
        }
    }

    /// Keeps the objects that a packet of primary rays hit. Its first point is number `first`.
    #[inline(always)]
    pub(super) fn keep_objects<S: Isa>(&mut self, first: usize, objects: U<S>) {
        let first = first % BATCH / lanes::<S>() * lanes::<S>();
        objects.store_slice(&mut self.objects[first..first + lanes::<S>()]);
    }

    /// Adds the contribution of a packet's hits to the points' sums. A packet of primary rays, whose first point is number `first`,
    /// starts these sums.
    #[inline(always)]
    pub(super) fn add<S: Isa>(
        &mut self,
        simd: S,
        rays: &Rays<S>,
        first: Option<usize>,
        node: &Contribution<S>,
        has_patterns: bool,
    ) {
        let start = first.map(|first| first % BATCH / lanes::<S>() * lanes::<S>());
        let sums = match start {
            Some(first) => &mut self.sums[first..first + lanes::<S>()],
            None => &mut self.terms[..lanes::<S>()],
        };
        node.store(simd, sums.as_flattened_mut());
        if let Some(first) = start {
            if has_patterns {
                let layers = &mut self.patterned[first..first + lanes::<S>()];
                node.store_layers(layers.as_flattened_mut());
            }
            return;
        }
        // Lanes beyond the last ray add nothing to what was in them before.
        let slots = rays.slots();
        let first = slots.as_slice()[0];
        let start = first as usize % BATCH;
        // Most packets have their slots in order, and are added as vectors.
        let in_order = slots.simd_eq(numbers(simd) + first).all_true();
        if let (true, Some(sums)) = (in_order, self.sums.get_mut(start..start + lanes::<S>())) {
            let (sums, terms) = (sums.as_flattened_mut(), self.terms.as_flattened());
            for i in (0..4 * lanes::<S>()).step_by(lanes::<S>()) {
                let sums = &mut sums[i..i + lanes::<S>()];
                let terms = &terms[i..i + lanes::<S>()];
                let new = I::<S>::from_slice(simd, sums) + I::<S>::from_slice(simd, terms);
                new.store_slice(sums);
            }
            return;
        }
        for (&slot, term) in slots.as_slice().iter().zip(&self.terms) {
            let sum = &mut self.sums[slot as usize % BATCH];
            let new = i32x4::load_array_ref(simd, sum) + i32x4::load_array_ref(simd, term);
            new.store_array(sum);
        }
    }
}

/// The directions in which the eye sees points of the picture, of length 1.
#[inline(always)]
pub(super) fn primary_directions<S: Isa>(simd: S, scene: &Prepared, x: F<S>, y: F<S>) -> Vec3x<S> {
    let raster = &scene.raster;
    let d = Vec3x::splat(simd, raster.corner)
        .add_scaled(Vec3x::splat(simd, raster.dx), x)
        .add_scaled(Vec3x::splat(simd, raster.dy), y);
    d.scaled(splat(simd, 1.0) / d.dot(d).sqrt())
}
