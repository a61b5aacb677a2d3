//! Sums up, point by point, what the rays of a batch bring back.

use super::contribution::Contribution;
use super::queue::{BATCH, Queue, packet};
use super::rays::Rays;
use super::sample::{STEP_BITS, Sum};
use super::{Layers, Sample, sample};
use crate::lanes::*;
use crate::prepare::Film;
use fearless_simd::{f32x4, i32x4};
use glam::Vec3A;

/// The element of a [`Sum`] that holds the key.
const KEY: usize = 3;

/// The results of traced points, which have the numbers that they have in the [`Queue`](super::queue::Queue).
///
/// The sums grow while rays are traced. Samples are made of them at the end, see [`Accumulator::finish`].
pub(crate) struct Accumulator {
    sums: [Sum; BATCH],
    /// The terms that a packet of secondary rays adds to the sums.
    terms: [Sum; MAX_LANES],
    samples: [u64; BATCH],
    /// The part of the colour that a pattern darkens, blue, green and red in output steps, and the share that the pattern leaves.
    patterned: [[f32; 4]; BATCH],
    /// The objects that the primary rays hit.
    objects: [u32; BATCH],
}

impl Accumulator {
    /// All zeros.
    pub const fn new() -> Self {
        Self {
            sums: [[0; 4]; BATCH],
            terms: [[0; 4]; MAX_LANES],
            samples: [0; BATCH],
            patterned: [[0.0; 4]; BATCH],
            objects: [0; BATCH],
        }
    }

    /// The sample of traced point number `i`.
    #[inline(always)]
    pub fn sample(&self, i: usize) -> Sample {
        let i = i % BATCH;
        Sample(self.samples[i]).showing(self.objects[i])
    }

    /// The key of traced point number `i`.
    #[inline(always)]
    pub fn key(&self, i: usize) -> u32 {
        self.sums[i % BATCH][KEY] as u32
    }

    /// The layers of traced point number `i`, if it shows an object with a pattern.
    #[inline(always)]
    pub fn layers(&self, i: usize) -> Layers {
        let i = i % BATCH;
        let [blue, green, red, share] = self.patterned[i];
        let untextured = Vec3A::new(blue, green, red);
        Layers {
            rest: steps(&self.sums[i]) - untextured * share,
            untextured,
        }
    }

    /// Turns the sums of the points into samples.
    #[inline(always)]
    pub(super) fn finish(&mut self, film: &Film, queue: &Queue) {
        let simd = baseline();
        let (sums, _) = self.sums.as_chunks();
        let (samples, _) = self.samples.as_chunks_mut();
        let sums = sums.iter().zip(samples).enumerate();
        for (i, (sums, samples)) in sums.take(queue.len().div_ceil(4)) {
            *samples = if film.is_plain {
                sample::from_sums(simd, sums)
            } else {
                sample::from_sums(simd, &exposed(simd, film, sums, queue.pixels(simd, 4 * i)))
            };
        }
    }

    /// Keeps the objects that a packet of primary rays hit. Its first point is number `first`.
    #[inline(always)]
    pub(super) fn keep_objects<S: Isa>(&mut self, first: usize, objects: U<S>) {
        objects.store_slice(&mut self.objects[packet::<S>(first)]);
    }

    /// Adds the contribution of a packet's hits to the sums of their points. A packet of primary rays, whose first point is number
    /// `first`, starts these sums.
    #[inline(always)]
    pub(super) fn add<S: Isa>(
        &mut self,
        simd: S,
        rays: &Rays<S>,
        first: Option<usize>,
        contribution: &Contribution<S>,
        has_patterns: bool,
    ) {
        let points = first.map(packet::<S>);
        let sums = match points.clone() {
            Some(points) => &mut self.sums[points],
            None => &mut self.terms[..lanes::<S>()],
        };
        contribution.store(simd, sums.as_flattened_mut());
        match points {
            Some(points) if has_patterns => {
                contribution.store_layers(self.patterned[points].as_flattened_mut());
            }
            Some(_) => {}
            None => self.add_terms(simd, rays),
        }
    }

    /// Adds the terms of a packet of secondary rays. Lanes beyond the last ray add nothing, whichever point was in them before.
    #[inline(always)]
    fn add_terms<S: Isa>(&mut self, simd: S, rays: &Rays<S>) {
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

/// A sum's blue, green and red in output steps.
fn steps(sum: &Sum) -> Vec3A {
    let [blue, green, red, _] = sum.map(|sum| sum as f32);
    Vec3A::new(blue, green, red) * (1.0 / (1 << STEP_BITS) as f32)
}

/// The sums of four points after the film, without their keys. The points are at the given x and y.
fn exposed(simd: Baseline, film: &Film, sums: &[Sum; 4], at: [f32x4<Baseline>; 2]) -> [Sum; 4] {
    let mut four = sums.map(|sum| {
        let light: f32x4<Baseline> = i32x4::simd_from(simd, sum).to_float();
        light * (1.0 / (1 << STEP_BITS) as f32)
    });
    film.expose(simd, &mut four, at);
    four.map(|colour| {
        let sum = colour * (1 << STEP_BITS) as f32 + 0.5;
        sum.to_int::<i32x4<Baseline>>().into()
    })
}
