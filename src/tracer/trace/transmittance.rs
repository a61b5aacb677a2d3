//! How much of a lamp's light passes what is in its way: spotlights' cones, penumbrae and coloured shadows. Coordinates are the
//! scene's.

use super::candidates::Candidates;
use super::shadow::ShadowRays;
use crate::lanes::*;
use crate::prepare::{Lamp, Object, SpotCone, World};
use crate::scene::Sphere;
use crate::shapes::{block, sphere};
use glam::Vec3A;

/// The share of a lamp's light, as a colour, that its cone and the solids in the way let pass; 0 in lanes that are not needed.
#[inline(always)]
pub(super) fn transmittance<S: Isa>(
    simd: S,
    world: World<'_>,
    lamp: &Lamp,
    rays: &ShadowRays<S>,
    solids: &Candidates,
) -> Vec3x<S> {
    let zero = splat(simd, 0.0);
    let &SpotCone {
        aim,
        cos_outer,
        cos_inner,
    } = &lamp.cone;
    let inward = (-rays.d.dot(Vec3x::splat(simd, aim)) - cos_outer) / (cos_inner - cos_outer);
    let is_asked = rays.distance.simd_gt(zero);
    let in_cone = is_asked.select(soft_edge(simd, inward), zero);
    let mut passing = Vec3x {
        x: in_cone,
        y: in_cone,
        z: in_cone,
    };
    for &candidate in solids.iter() {
        let (object, material) = world.object(candidate.object);
        let covered = match object {
            Object::Block(block) => {
                let t = block::distance(simd, block, &rays.o, &rays.d);
                t.simd_lt(rays.distance).select(splat(simd, 1.0), zero)
            }
            Object::Sphere(sphere) => sphere_covers(simd, lamp, sphere, rays),
            Object::Plane(_) | Object::Light(_) | Object::Background => continue,
        };
        // The share given by the blocker's tint passes. NaN counts as no tint: it would spoil lanes that are not blocked.
        let mut absorbed = Vec3A::ONE;
        if lamp.diameter > 0.0 {
            absorbed -= Vec3A::from(material.tint).max(Vec3A::ZERO).min(Vec3A::ONE);
        }
        let covered = candidate.lanes(simd).select(covered, zero);
        passing = passing - (passing * Vec3x::splat(simd, absorbed)).scaled(covered);
        if passing.max_element().simd_le(zero).all_true() {
            break;
        }
    }
    passing
}

/// The share of a lamp that a sphere covers, 0 to 1 (after Parker, Shirley and Smits: Single Sample Soft Shadows, 1998).
///
/// The rays from the point to the lamp form a cone. At the distance `a`, where it passes the sphere, it is `b = a diameter /
/// distance` wide. As the sphere's edge crosses the cone from one side to the other, the covered share goes from 0 to 1.
#[inline(always)]
fn sphere_covers<S: Isa>(simd: S, lamp: &Lamp, sphere: &Sphere, rays: &ShadowRays<S>) -> F<S> {
    let (a, depth) = sphere::deepest(simd, sphere, rays.o, rays.d, rays.distance);
    let b = at_most::<S>(
        a * lamp.diameter / rays.distance,
        splat(simd, lamp.max_penumbra),
    );
    soft_edge(
        simd,
        depth / at_least::<S>(b, splat(simd, f32::MIN_POSITIVE)) + 0.5,
    )
}

/// A smooth step that is 0 up to 0, and 1 from 1 on.
#[inline(always)]
fn soft_edge<S: Isa>(simd: S, v: F<S>) -> F<S> {
    smooth_step::<S>(clamp::<S>(v, splat(simd, 0.0), splat(simd, 1.0)))
}
