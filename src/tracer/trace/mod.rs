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
mod casters;
mod contribution;
mod counts;
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
mod tracer;
mod transmittance;
mod visibility;
mod waves;

pub(crate) use batch::Batch;
pub use counts::{Counts, Probes};
pub(crate) use layers::Layers;
pub(crate) use queue::BATCH;
pub(crate) use sample::{STEP, Sample};
pub(crate) use texture::SeenPattern;

use crate::lanes::*;
use crate::prepare::{Prepared, VisibleGroups};
use crate::quality::Quality;
use fearless_simd::Level;
use tracer::Tracer;

/// Traces a batch's points with all their rays by an instruction set; the primary rays and their reflections meet none
/// but the groups `seen`.
pub(crate) fn trace(
    level: Level,
    scene: &Prepared,
    quality: &Quality,
    seen: VisibleGroups,
    batch: &mut Batch,
) {
    let is_traced = batch
        .wide
        .is_some_and(|wide| wide(level, scene, quality, seen, batch));
    if !is_traced {
        if let Some(simd) = avx2(level) {
            trace_by(simd, scene, quality, seen, batch);
        } else {
            trace_by(baseline(), scene, quality, seen, batch);
        }
    }
    // This takes a thousandth of the time, so one instruction set is enough.
    batch.results.finish(&scene.film, &batch.points);
}

/// A kernel for wider packets than AVX2 has; says whether the level has such. Only a program that refers to one has it in its file.
pub(crate) type WideKernel = fn(Level, &Prepared, &Quality, VisibleGroups, &mut Batch) -> bool;

/// Traces a batch's points by AVX-512, if the level has that.
pub(crate) fn trace_wide(
    level: Level,
    scene: &Prepared,
    quality: &Quality,
    seen: VisibleGroups,
    batch: &mut Batch,
) -> bool {
    let Some(simd) = avx512(level) else {
        return false;
    };
    trace_by(simd, scene, quality, seen, batch);
    true
}

#[inline(always)]
fn trace_by<S: Isa>(
    simd: S,
    scene: &Prepared,
    quality: &Quality,
    seen: VisibleGroups,
    batch: &mut Batch,
) {
    let tracer = Tracer {
        simd,
        scene,
        quality,
    };
    simd.vectorize(
        #[inline(always)]
        || packets::trace_packets(tracer, seen, batch),
    );
}
