//! Traces a batch's points, packet by packet.

use super::batch::Batch;
use super::{Tracer, intersect, shade};
use crate::lanes::*;
use crate::prepare::{GroupSet, VisibleGroups};

/// Traces a batch's points with all their rays; the primary rays and their reflections meet none but the groups `seen`.
#[inline(always)]
pub(super) fn trace_packets<S: Isa>(tracer: Tracer<'_, S>, seen: VisibleGroups, batch: &mut Batch) {
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
        let has_patterns = world.has_patterns();
        let results = &mut batch.results;
        results.add(simd, &rays, first, &contribution, has_patterns);
        next += lanes::<S>() * usize::from(is_primary);
    }
    batch.counts.points += batch.points.len() as u64;
}
