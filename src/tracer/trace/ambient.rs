//! Ambient light at points, see [`crate::scene::Ambience`].

use super::Tracer;
use super::point::ShadingPoint;
use super::rays::Rays;
use crate::lanes::*;
use crate::prepare::{Bounds, CAPACITY, Neighbour, Object, Tap};
use crate::scene::{self, Block};
use crate::shapes::block::along;
use crate::shapes::solid_distance;
use glam::Vec3A;

/// Paths below this have a depth of at most 1.
const DEEP_PATH: u32 = 4;

/// Returns the ambient light that surfaces reflect; `unoccluded` without
/// [`crate::scene::Ambience`].
#[inline(always)]
pub(super) fn light<S: Isa>(
    tracer: Tracer<'_, S>,
    rays: &Rays<S>,
    point: &ShadingPoint<S>,
    unoccluded: Vec3x<S>,
) -> Vec3x<S> {
    if !tracer.world.ambience.is_on {
        return unoccluded;
    }
    Vec3x::select(point.shaded, unoccluded * arriving(tracer, rays, point), unoccluded)
}

#[inline(always)]
fn arriving<S: Isa>(tracer: Tracer<'_, S>, rays: &Rays<S>, point: &ShadingPoint<S>) -> Vec3x<S> {
    let (simd, world) = (tracer.isa, tracer.world);
    let ambience = &world.ambience;
    let (zero, one) = (splat(simd, 0.0), splat(simd, 1.0));
    let up = point.n.y * 0.5 + 0.5;
    let height = at_least::<S>(point.p.y - ambience.floor, zero);
    let below = (one - up) * height / (height + ambience.contact);
    let sky = Vec3x::splat(simd, ambience.sky).scaled(up);
    let unoccluded = sky.add_scaled(Vec3x::splat(simd, ambience.ground), below);
    let near = point.shaded
        & !point.inside
        & rays.paths().simd_lt(U::<S>::splat(simd, DEEP_PATH))
        & rays.weight.simd_gt(splat(simd, scene::Ambience::FAINT));
    if !near.any_true() {
        return unoccluded;
    }
    let (p, n) = (&point.p, &point.n);
    let around = Surroundings {
        p: [p.x, p.y, p.z].map(
            #[inline(always)]
            |c| extent(simd, c, near),
        ),
        n: [n.x, n.y, n.z].map(
            #[inline(always)]
            |c| extent(simd, c, near),
        ),
    };
    let (share, bounced) = around.gather(tracer, point, near);
    Vec3x::select(near, unoccluded.scaled(share) + bounced, unoccluded)
}

struct Cover<S: Isa> {
    share: F<S>,
    /// The direction from the solid, along its axes.
    from: Vec3x<S>,
}

/// The extents of a packet's points and normals along each axis.
struct Surroundings {
    p: [[f32; 2]; 3],
    n: [[f32; 2]; 3],
}

impl Surroundings {
    /// Returns the uncovered share and the light that solids reflect.
    #[inline(always)]
    fn gather<S: Isa>(
        &self,
        tracer: Tracer<'_, S>,
        point: &ShadingPoint<S>,
        near: M<S>,
    ) -> (F<S>, Vec3x<S>) {
        let (simd, world) = (tracer.isa, tracer.world);
        let ambience = &world.ambience;
        let mut unoccluded = splat(simd, 1.0);
        let mut bounced = Vec3x::splat(simd, Vec3A::ZERO);
        for first in (0..ambience.count).step_by(lanes::<S>()) {
            let mut rest = self.meets(simd, &ambience.bounds, first).to_bitmask();
            while rest != 0 {
                let i = first + rest.trailing_zeros() as usize;
                rest &= rest - 1;
                let neighbour = &ambience.neighbours[i % CAPACITY];
                let cover = match world.object(neighbour.object).0 {
                    Object::Block(block) => by_block(simd, block, neighbour, point, near),
                    _ => by_sphere(simd, neighbour, point, near),
                };
                let Some(cover) = cover else {
                    continue;
                };
                let share = at_most::<S>(cover.share * neighbour.opacity, splat(simd, 1.0));
                if ambience.bounces {
                    let light = reflected(simd, neighbour, &cover, world.light_count);
                    bounced = bounced.add_scaled(light, share * unoccluded);
                }
                unoccluded = unoccluded - unoccluded * share;
            }
        }
        (unoccluded, bounced)
    }

    #[inline(always)]
    fn meets<S: Isa>(&self, simd: S, bounds: &Bounds, first: usize) -> M<S> {
        let ahead = load(simd, first, &bounds.ahead);
        let mut met = M::<S>::splat(simd, true);
        for axis in 0..3 {
            let [low, high] = self.n[axis].map(
                #[inline(always)]
                |n| splat(simd, n) * ahead,
            );
            let [low, high] = [low + self.p[axis][0], high + self.p[axis][1]];
            met &= load(simd, first, &bounds.low[axis]).simd_lt(high)
                & load(simd, first, &bounds.high[axis]).simd_gt(low);
        }
        met
    }
}

#[inline(always)]
fn reflected<S: Isa>(simd: S, neighbour: &Neighbour, cover: &Cover<S>, lights: usize) -> Vec3x<S> {
    let mut light = Vec3x::splat(simd, neighbour.ambient);
    for &[to_light, colour] in neighbour.lights.iter().take(lights) {
        let facing = cover.from.dot(Vec3x::splat(simd, to_light));
        let facing = at_least::<S>(facing, splat(simd, 0.0));
        light = light.add_scaled(Vec3x::splat(simd, colour), facing);
    }
    light
}

#[inline(always)]
fn by_sphere<S: Isa>(
    simd: S,
    neighbour: &Neighbour,
    point: &ShadingPoint<S>,
    near: M<S>,
) -> Option<Cover<S>> {
    let (zero, one) = (splat(simd, 0.0), splat(simd, 1.0));
    let to = Vec3x::splat(simd, neighbour.centre) - point.p;
    let distance2 = to.dot(to);
    let fade = at_least::<S>(one - distance2 * neighbour.per_reach2, zero);
    if !(near & fade.simd_gt(zero)).any_true() {
        return None;
    }
    let per_radius = neighbour.per_radius;
    let inverse: F<S> = one / distance2.sqrt();
    // In radii.
    let h2 = at_least::<S>(distance2 * (per_radius * per_radius), one);
    let height: F<S> = point.n.dot(to) * per_radius;
    let above = at_least::<S>(height, zero) * inverse * (1.0 / per_radius) / h2;
    // An approximation where the sphere crosses the horizon.
    let part = clamp::<S>((height + 1.0) * 0.5 / h2, zero, one);
    let share = height.abs().simd_lt(one).select(part * part.sqrt(), above);
    Some(Cover { share: share * fade * fade, from: to.scaled(-inverse) })
}

#[inline(always)]
fn by_block<S: Isa>(
    simd: S,
    block: &Block,
    neighbour: &Neighbour,
    point: &ShadingPoint<S>,
    near: M<S>,
) -> Option<Cover<S>> {
    let (zero, one) = (splat(simd, 0.0), splat(simd, 1.0));
    let p = along(simd, &block.axes, &(point.p - Vec3x::splat(simd, neighbour.centre)));
    let n = along(simd, &block.axes, &point.n);
    let [farthest, _] = neighbour.taps;
    let mut share = zero;
    let mut sum = splat(simd, farthest.height * 0.1);
    let mut from = n.scaled(zero);
    for (i, Tap { height, range, weight }) in neighbour.taps.into_iter().enumerate() {
        let tap = p.add_scaled(n, splat(simd, height));
        let out = solid_distance::outside(simd, block, &tap).out;
        let distance: F<S> = out.dot(out).sqrt();
        // The block reaches the second tap only if it is within the first tap's height.
        if i == 0 && !(near & distance.simd_lt(splat(simd, height))).any_true() {
            return None;
        }
        let closeness = at_least::<S>(one - distance * (1.0 / range), zero);
        let covered = closeness * closeness * weight;
        share += covered;
        sum += covered * distance;
        from = from.add_scaled(out, covered);
    }
    Some(Cover { share, from: from.scaled(one / sum) })
}

#[inline(always)]
fn extent<S: Isa>(simd: S, c: F<S>, mask: M<S>) -> [f32; 2] {
    let [min, max] = [splat(simd, f32::NEG_INFINITY), splat(simd, f32::INFINITY)];
    [mask.select(c, max).reduce_min(), mask.select(c, min).reduce_max()]
}

#[inline(always)]
fn load<S: Isa>(simd: S, first: usize, numbers: &[f32; CAPACITY]) -> F<S> {
    let first = first % CAPACITY / lanes::<S>() * lanes::<S>();
    F::<S>::from_slice(simd, &numbers[first..first + lanes::<S>()])
}
