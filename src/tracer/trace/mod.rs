//! Traces points: a point's colour and key from the tree of rays that starts there.
//!
//! A [`Batch`] is a queue of points, an accumulator of what their rays bring back, and the stack of secondary rays. Rays travel in
//! packets, a ray per lane, whichever points they belong to. A packet's secondary rays go to the stack, which has a fixed
//! capacity, and the next packet is taken from its top as soon as it fills the lanes, so there is no recursion and few lanes idle.
//! Colours are summed in fixed point: integer sums do not depend on the order in which rays come back, so a point has the same
//! bits whatever points it is traced with.
//!
//! The way of a packet:
//!
//! | step | module |
//! | --- | --- |
//! | primary rays of queued points, or secondary rays from the stack | `queue`, `stack` |
//! | the nearest hits: planes and spheres, then boxes and cylinders among the candidates | `intersect` |
//! | points, normals, grooves, patterns and waves there | `surface`, `point`, `texture`, `waves` |
//! | visibility: which lamps' light arrives, and how much of it | `visibility`, `shadow`, `transmittance` |
//! | light: what the surfaces reflect of it | `light` |
//! | what the hits add to their points, and which secondary rays leave them | `shade` |
//! | the sums of the points | `accumulator` |

mod accumulator;
mod air;
mod batch;
mod candidates;
mod contribution;
mod intersect;
mod key;
mod layers;
mod light;
mod packets;
mod point;
mod queue;
mod rays;
mod sample;
mod shade;
mod shadow;
mod stack;
mod surface;
#[cfg(test)]
mod tests;
mod texture;
mod transmittance;
mod visibility;
mod waves;

pub(crate) use batch::Batch;
pub(crate) use layers::Layers;
pub(crate) use queue::{BATCH, PARTS};
pub(crate) use sample::{STEP, Sample};
pub(crate) use texture::SeenPattern;

use crate::lanes::*;
use crate::prepare::{VisibleGroups, World};
use crate::quality::Quality;
use fearless_simd::Level;

/// How points are traced.
#[derive(Clone, Copy)]
pub(crate) struct Tracer<'a, I> {
    /// The instruction set: a level of those that the processor has, or the one that a kernel is compiled for.
    pub isa: I,
    pub world: World<'a>,
    pub quality: &'a Quality,
}

/// Traces a batch's points with all their rays; the primary rays and their reflections meet none but the groups `seen`.
pub(crate) type Kernel = fn(&Tracer<'_, Level>, VisibleGroups, &mut Batch);

/// The kernel for AVX-512 where the level has that, and for AVX2 and less. Only a program that refers to it has it in its file.
pub(crate) fn trace_wide(tracer: &Tracer<'_, Level>, seen: VisibleGroups, batch: &mut Batch) {
    match avx512(tracer.isa) {
        Some(isa) => trace_by(isa, tracer, seen, batch),
        None => trace_narrow(tracer, seen, batch),
    }
}

/// The kernel for AVX2 and less.
pub(crate) fn trace_narrow(tracer: &Tracer<'_, Level>, seen: VisibleGroups, batch: &mut Batch) {
    match avx2(tracer.isa) {
        Some(isa) => trace_by(isa, tracer, seen, batch),
        None => trace_by(baseline(), tracer, seen, batch),
    }
}

#[inline(always)]
fn trace_by<S: Isa>(
    isa: S,
    &Tracer { world, quality, .. }: &Tracer<'_, Level>,
    seen: VisibleGroups,
    batch: &mut Batch,
) {
    let tracer = Tracer {
        isa,
        world,
        quality,
    };
    isa.vectorize(
        #[inline(always)]
        || packets::trace_packets(tracer, seen, batch),
    );
    batch.finish(&world.film);
}
