//! Traces points: a point's colour and key from the tree of rays that starts there.
//!
//! Rays travel in packets, a ray per lane, whichever points they belong to. A packet's secondary rays go to a stack of
//! fixed capacity, and the next packet is taken from its top as soon as it fills the lanes, so there is no recursion and
//! few lanes idle. Colours are summed in fixed point: integer sums do not depend on the order in which rays come back,
//! so a point has the same bits whatever points it is traced with.

mod air;
mod batch;
mod block;
mod candidates;
mod contribution;
mod intersect;
mod key;
mod layers;
mod light;
mod point;
mod sample;
mod shade;
mod stack;
mod surface;
#[cfg(test)]
mod tests;
mod texture;

pub(crate) use batch::{BATCH, Batch};
pub(crate) use layers::Layers;
pub(crate) use sample::{STEP, Sample};
pub(crate) use texture::pattern_at_pixels;

use crate::lanes::*;
use crate::prepare::{GroupSet, Prepared, VisibleGroups};
use crate::quality::Quality;
use fearless_simd::Level;

/// How much work was done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Points traced.
    pub points: u64,
    /// Primary and secondary rays.
    pub rays: u64,
    /// Rays towards a light.
    pub shadow_rays: u64,
    /// Lanes of the packets that the primary and secondary rays travelled in, idle ones included.
    pub lanes: u64,
}

impl Counts {
    /// Nothing done.
    pub const NONE: Self = Self {
        points: 0,
        rays: 0,
        shadow_rays: 0,
        lanes: 0,
    };
}

impl core::ops::Add for Counts {
    type Output = Self;

    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl core::ops::AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.points += other.points;
        self.rays += other.rays;
        self.shadow_rays += other.shadow_rays;
        self.lanes += other.lanes;
    }
}

/// Traces a batch's points with all their rays by an instruction set; the primary rays and their reflections meet none
/// but the groups `seen`.
pub(crate) fn trace(
    level: Level,
    scene: &Prepared,
    quality: &Quality,
    seen: VisibleGroups,
    batch: &mut Batch,
) {
    match level {
        #[cfg(target_arch = "x86_64")]
        Level::Avx512(simd) => trace_by(simd, scene, quality, seen, batch),
        #[cfg(target_arch = "x86_64")]
        Level::Avx2(simd) => trace_by(simd, scene, quality, seen, batch),
        _ => trace_by(baseline(), scene, quality, seen, batch),
    }
    // This takes a thousandth of the time, so one instruction set is enough.
    batch.finish(baseline());
}

#[inline(always)]
fn trace_by<S: Isa>(
    simd: S,
    scene: &Prepared,
    quality: &Quality,
    seen: VisibleGroups,
    batch: &mut Batch,
) {
    simd.vectorize(
        #[inline(always)]
        || {
            trace_packets(simd, scene, quality, seen, batch);
        },
    );
}

#[inline(always)]
fn trace_packets<S: Isa>(
    simd: S,
    scene: &Prepared,
    quality: &Quality,
    seen: VisibleGroups,
    batch: &mut Batch,
) {
    let mut next = 0;
    loop {
        let is_primary = batch.stack.len() < lanes::<S>() && next < batch.len();
        let (rays, count) = if is_primary {
            let rays = batch.primary_rays(simd, scene, next);
            (rays, (batch.len() - next).min(lanes::<S>()))
        } else {
            batch.stack.pop(simd)
        };
        if count == 0 {
            break;
        }
        let active = first(simd, count);
        let (groups, from) = if is_primary {
            (seen.directly, scene.tree.start(seen.directly))
        } else if (rays.mirrored(simd) | !active).all_true() {
            (seen.mirrored, scene.tree.start(seen.mirrored))
        } else {
            (GroupSet::MAX, scene.tree.start(GroupSet::MAX))
        };
        batch.counts.rays += count as u64;
        batch.counts.lanes += lanes::<S>() as u64;
        let candidates = &mut batch.candidates;
        let mut hit = intersect::nearest(simd, scene, &rays, groups, from, candidates);
        if !candidates.is_empty() {
            block::resolve_blocks(simd, scene, &rays, candidates, &mut hit);
        }
        if is_primary {
            batch.keep_objects::<S>(next, hit.object);
        }
        let contribution = shade::shade(simd, scene, quality, &rays, &hit, active, batch);
        let first = is_primary.then_some(next);
        batch.add(simd, &rays, first, &contribution, scene.has_patterns());
        next += lanes::<S>() * usize::from(is_primary);
    }
    batch.counts.points += batch.len() as u64;
}
