//! Traces points: computes each point's colour and key from its tree of rays.
//!
//! Packets have a ray per lane, of different points. Secondary rays go to a stack, which a packet
//! leaves as soon as it fills the lanes. Colours are integer sums: a point's bits depend neither on
//! the order of rays nor on other points.
//!
//! | step of a packet | module |
//! | --- | --- |
//! | primary rays of queued points, or secondary rays | `queue`, `stack` |
//! | nearest hits: planes and spheres, then candidate blocks | `intersect` |
//! | points, normals, grooves, patterns and waves there | `surface`, `point`, `texture`, `waves` |
//! | shadows, spotlights and penumbrae | `visibility`, `shadow` |
//! | reflected light | `light`, `ambient` |
//! | haze, glow and secondary rays | `shade`, `air` |
//! | sums of the points | `accumulator` |

mod accumulator;
mod air;
mod ambient;
mod batch;
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
pub(crate) use batch::{Batch, Tracer};
pub(crate) use queue::{BATCH, PARTS};
pub(crate) use sample::{STEP, Sample};
pub(crate) use texture::{PatternOnScreen, surface_points};

use crate::lanes::*;
use crate::prepare::{GroupSet, VisibleGroups};
use rays::Rays;

/// Traces a batch's points. Primary rays and their reflections in the first plane only meet the
/// groups `visible`.
#[inline(always)]
pub(crate) fn trace<S: Isa>(tracer: Tracer<'_, S>, visible: VisibleGroups, batch: &mut Batch) {
    let (simd, world) = (tracer.isa, tracer.world);
    let mut next = 0;
    loop {
        let is_primary = batch.stack.len() < lanes::<S>() && next < batch.points.len();
        let (rays, count) = if is_primary {
            let rays = Rays::primary(simd, world, &batch.points, next);
            (rays, (batch.points.len() - next).min(lanes::<S>()))
        } else {
            batch.stack.pop(simd)
        };
        if count == 0 {
            break;
        }
        let active = first_lanes(simd, count);
        let groups = if is_primary {
            visible.directly
        } else if (rays.mirrored(simd) | !active).all_true() {
            visible.mirrored
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
        batch.results.add(simd, &rays, first, &contribution, world);
        next += lanes::<S>() * usize::from(is_primary);
    }
    batch.counts.points += batch.points.len() as u64;
    batch.finish(&world.film);
}
