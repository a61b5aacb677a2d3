use super::queue::{BATCH, Queue, packet};
use super::rays::Rays;
use super::sample::{FIXED_POINT, STEP_BITS, Sum};
use super::{Sample, sample};
use crate::lanes::*;
use crate::prepare::{Film, World};
use fearless_simd::{f32x4, i32x4};
use glam::Vec3A;

const KEY: usize = 3;

/// The brightest untextured light whose pattern is interpolated: the sum of its channels, in steps
/// of 1/255. The filmic curve turns 1 step into at most 8.
const DARK: f32 = 1.0;

/// The light of a point on a patterned surface, `rest + reflectance * untextured`. These layers
/// vary slowly across the surface.
///
/// The first four numbers are `rest`: highlights, reflection, transmission and haze. The last four
/// are `untextured`: ambient and diffuse light. Each is blue, green, red and 0, in steps of 1/255.
pub(crate) type Layers = [f32; 8];

/// The results of the points in the `Queue`, with the same indices.
pub(crate) struct Accumulator {
    sums: [Sum; BATCH],
    terms: [Sum; MAX_LANES],
    samples: [u64; BATCH],
    /// The untextured blue, green and red in output steps, and the reflectance, negative where the
    /// pattern is fine.
    patterned: [[f32; 4]; BATCH],
    objects: [u32; BATCH],
}

zero! { Accumulator { sums, terms, samples, patterned, objects } }

impl Accumulator {
    pub fn sample(&self, i: usize) -> Sample {
        let i = i % BATCH;
        Sample(self.samples[i]).showing(self.objects[i])
    }

    pub fn key(&self, i: usize) -> u32 {
        self.sums[i % BATCH][KEY] as u32
    }

    /// Returns whether the point shows a pattern finer than squares, in enough light.
    pub fn is_fine(&self, i: usize) -> bool {
        let [blue, green, red, share] = self.patterned[i % BATCH];
        share.is_sign_negative() & (blue + green + red > DARK)
    }

    pub fn layers(&self, i: usize, film: &Film) -> Layers {
        let i = i % BATCH;
        let [blue, green, red, share] = self.patterned[i];
        let untextured = Vec3A::new(blue, green, red);
        let [a, b, c] = (steps(&self.sums[i], film.sum_unit) - untextured * share.abs()).to_array();
        [a, b, c, 0.0, blue, green, red, 0.0]
    }

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

    #[inline(always)]
    pub(super) fn keep_objects<S: Isa>(&mut self, first: usize, objects: U<S>) {
        objects.store_slice(&mut self.objects[packet::<S>(first)]);
    }

    #[inline(always)]
    pub(super) fn mark_unguarded<S: Isa>(&mut self, rays: &Rays<S>, unguarded: M<S>) {
        let slots = rays.slots();
        let mut rest = unguarded.to_bitmask();
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize % lanes::<S>();
            self.objects[slots.as_slice()[lane] as usize % BATCH] |= Sample::UNGUARDED_OBJECT;
            rest &= rest - 1;
        }
    }

    /// Adds a packet's contribution to its points. Primary rays belong to the points from `first`
    /// on.
    #[inline(always)]
    pub(super) fn add<S: Isa>(
        &mut self,
        simd: S,
        rays: &Rays<S>,
        first: Option<usize>,
        contribution: &Contribution<S>,
        world: World<'_>,
    ) {
        let points = first.map(packet::<S>);
        let sums = match points.clone() {
            Some(points) => &mut self.sums[points],
            None => &mut self.terms[..lanes::<S>()],
        };
        contribution.store(simd, world.film.sum_unit, sums.as_flattened_mut());
        match points {
            Some(points) if world.has_patterns => {
                contribution.store_layers(self.patterned[points].as_flattened_mut());
            }
            Some(_) => {}
            None => self.add_terms(simd, rays),
        }
    }

    /// Adds the terms of secondary rays. Lanes after the last ray have stale slots, but zero terms.
    #[inline(always)]
    fn add_terms<S: Isa>(&mut self, simd: S, rays: &Rays<S>) {
        let slots = rays.slots();
        let first = slots.as_slice()[0];
        let start = first as usize % BATCH;
        // Most packets have consecutive slots: a vector sum.
        let in_order = slots.simd_eq(lane_numbers(simd) + first).all_true();
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

fn steps(sum: &Sum, unit: f32) -> Vec3A {
    let [blue, green, red, _] = sum.map(|sum| sum as f32);
    Vec3A::new(blue, green, red) * (1.0 / (unit * (1 << STEP_BITS) as f32))
}

fn exposed(simd: Baseline, film: &Film, sums: &[Sum; 4], at: [f32x4<Baseline>; 2]) -> [Sum; 4] {
    let mut four = sums.map(|sum| {
        let light: f32x4<Baseline> = i32x4::simd_from(simd, sum).to_float();
        light * (1.0 / (film.sum_unit * (1 << STEP_BITS) as f32))
    });
    film.expose(&mut four, at);
    four.map(|colour| {
        let sum = colour * (1 << STEP_BITS) as f32 + 0.5;
        sum.to_int::<i32x4<Baseline>>().into()
    })
}

/// The upper limit of a ray's contribution times [`Film::sum_unit`]: twice full brightness. So the
/// sum over the 255 nodes of the deepest ray tree does not overflow.
const BRIGHTEST: f32 = 2.0;

pub(super) struct Contribution<S: Isa> {
    pub colour: Vec3x<S>,
    pub key: U<S>,
    /// Undefined for lights and the background.
    pub untextured: Vec3x<S>,
    pub reflectance: F<S>,
}

impl<S: Isa> Contribution<S> {
    #[inline(always)]
    /// `unit` is [`Film::sum_unit`].
    pub fn store(&self, simd: S, unit: f32, sums: &mut [i32]) {
        let [blue, green, red] = [self.colour.z, self.colour.y, self.colour.x].map(
            #[inline(always)]
            |channel| fixed(simd, channel, unit),
        );
        store_transposed([blue, green, red, self.key.bitcast()], sums);
    }

    #[inline(always)]
    pub fn store_layers(&self, layers: &mut [f32]) {
        let Vec3x { x, y, z } = self.untextured;
        store_transposed([z * 255.0, y * 255.0, x * 255.0, self.reflectance], layers);
    }
}

#[inline(always)]
fn fixed<S: Isa>(simd: S, c: F<S>, unit: f32) -> I<S> {
    // Add one half, since the conversion truncates.
    let sum = c.mul_add(splat(simd, FIXED_POINT * unit), splat(simd, 0.5));
    clamp::<S>(sum, splat(simd, 0.0), splat(simd, BRIGHTEST * FIXED_POINT)).to_int()
}

#[inline(always)]
fn store_transposed<S: Isa, V: SimdBase<S>>([a, b, c, d]: [V; 4], numbers: &mut [V::Element]) {
    let (ac0, ac1) = a.interleave(c);
    let (bd0, bd1) = b.interleave(d);
    let (first, second) = ac0.interleave(bd0);
    let (third, fourth) = ac1.interleave(bd1);
    for (row, numbers) in
        [first, second, third, fourth].iter().zip(numbers.chunks_mut(lanes::<S>()))
    {
        row.store_slice(numbers);
    }
}
