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
//! | visibility: which lamps' light arrives, and how much of it | `visibility`, `shadow` |
//! | light: what the surfaces reflect of it | `light` |
//! | what the hits add to their points, and which secondary rays leave them | `shade` |
//! | the sums of the points | `accumulator` |

mod accumulator;
mod air;
mod candidates;
mod intersect;
mod key;
mod light;
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
mod visibility;
mod waves;

pub(crate) use accumulator::Layers;
pub(crate) use queue::{BATCH, PARTS};
pub(crate) use sample::{STEP, Sample};
pub(crate) use texture::SeenPattern;

use crate::counts::Counts;
use crate::lanes::*;
use crate::prepare::{Film, GroupSet, VisibleGroups, World};
use crate::quality::Quality;
use accumulator::Accumulator;
use candidates::{Blockers, Candidates};
use fearless_simd::Level;
use queue::Queue;
use stack::RayStack;
use surface::SurfaceRows;

/// Points to trace and what came of them. It is filled, traced, read and cleared again and again.
pub(crate) struct Batch {
    /// The points to trace.
    pub points: Queue,
    /// The results of the points.
    pub results: Accumulator,
    /// The work since this was last reset.
    pub counts: Counts,
    /// The secondary rays that wait to be traced.
    stack: RayStack,
    /// Boxes and cylinders that the packet at work may meet, by an exact test.
    blocks: Candidates,
    /// The solids that may be on the way of the packet at work to a lamp.
    blockers: Blockers,
    /// The surfaces of the packet at work.
    surfaces: SurfaceRows,
}

impl Batch {
    /// Room for points, empty.
    pub const fn new() -> Self {
        Self {
            points: Queue::new(),
            results: Accumulator::new(),
            counts: Counts::NONE,
            stack: RayStack::new(),
            blocks: candidates::NONE,
            blockers: Blockers::NONE,
            surfaces: SurfaceRows::NONE,
        }
    }

    /// Begins a part of a picture: forgets the surfaces of other frames.
    #[inline(never)]
    pub fn begin(&mut self) {
        self.surfaces.clear();
    }

    /// Turns the sums of the points into samples. This takes a thousandth of the time, so one instruction set is enough.
    #[inline(never)]
    fn finish(&mut self, film: &Film) {
        self.results.finish(film, &self.points);
    }
}

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
        Some(isa) => by_isa!(isa: trace_packets(tracer.by(isa), seen, batch)),
        None => trace_narrow(tracer, seen, batch),
    }
}

/// The kernel for AVX2 and less.
pub(crate) fn trace_narrow(tracer: &Tracer<'_, Level>, seen: VisibleGroups, batch: &mut Batch) {
    by_isa!(tracer.isa, isa => trace_packets(tracer.by(isa), seen, batch));
}

impl<'a> Tracer<'a, Level> {
    /// Returns the same for a kernel's instruction set.
    #[inline(always)]
    fn by<S: Isa>(&self, isa: S) -> Tracer<'a, S> {
        let &Self { world, quality, .. } = self;
        Tracer {
            isa,
            world,
            quality,
        }
    }
}

/// Traces a batch's points with all their rays; the primary rays and their reflections meet none but the groups `seen`.
#[inline(always)]
fn trace_packets<S: Isa>(tracer: Tracer<'_, S>, seen: VisibleGroups, batch: &mut Batch) {
    let Tracer {
        isa: simd, world, ..
    } = tracer;
    let mut next = 0;
    loop {
        let is_primary = batch.stack.len() < lanes::<S>() && next < batch.points.len();
        let (rays, count) = if is_primary {
            let rays = batch.points.primary_rays(simd, world, next);
            (rays, (batch.points.len() - next).min(lanes::<S>()))
        } else {
            batch.stack.pop(simd)
        };
        if count == 0 {
            break;
        }
        let active = first(simd, count);
        let groups = if is_primary {
            seen.directly
        } else if (rays.mirrored(simd) | !active).all_true() {
            seen.mirrored
        } else {
            GroupSet::MAX
        };
        batch.counts.rays += count as u64;
        batch.counts.lanes += lanes::<S>() as u64;
        let blocks = &mut batch.blocks;
        let mut hit = intersect::nearest(simd, world, &rays, groups, blocks);
        if !blocks.is_empty() {
            intersect::resolve_blocks(simd, world, &rays, blocks, &mut hit);
        }
        if is_primary {
            batch.results.keep_objects::<S>(next, hit.object);
        }
        let contribution = shade::shade(tracer, &rays, &hit, active, batch);
        let first = is_primary.then_some(next);
        let has_patterns = world.has_patterns;
        let results = &mut batch.results;
        results.add(simd, &rays, first, &contribution, has_patterns);
        next += lanes::<S>() * usize::from(is_primary);
    }
    batch.counts.points += batch.points.len() as u64;
    batch.finish(&world.film);
}
