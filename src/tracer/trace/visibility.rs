use super::candidates::{Candidates, Occluders};
use super::point::ShadingPoint;
use super::rays::departing;
use super::shadow::ShadowRays;
use crate::counts::Counts;
use crate::lanes::*;
use crate::prepare::{Object, PreparedLight, SpotCone, World};
use crate::shapes::{block, solid_distance, sphere};
use glam::Vec3A;

pub(super) struct ArrivingLight<S: Isa> {
    /// To the light, of length 1.
    pub l: Vec3x<S>,
    pub nl: F<S>,
    pub lit: M<S>,
    pub colour: Vec3x<S>,
}

impl<S: Isa> ShadingPoint<S> {
    /// Returns `None` if all points face away or are outside the light's cone.
    #[inline(always)]
    pub fn light_of(
        &self,
        simd: S,
        world: World<'_>,
        light: &PreparedLight,
        shows: M<S>,
        occluders: &mut Occluders,
        counts: &mut Counts,
    ) -> Option<ArrivingLight<S>> {
        let to_light = Vec3x::splat(simd, light.position) - self.p;
        let distance = to_light.dot(to_light).sqrt();
        let l = to_light.scaled(splat::<S>(simd, 1.0) / distance);
        let nl = self.n.dot(l);
        let mut facing = shows & nl.simd_gt(distance * self.horizon);
        if !light.is_point {
            let off = l + Vec3x::splat(simd, light.cone.aim);
            facing &= off.dot(off).simd_lt(splat(simd, light.cone.outer2));
        }
        if !facing.any_true() {
            return None;
        }
        counts.shadow_rays += u64::from(facing.to_bitmask().count_ones());
        let rays = ShadowRays { o: self.p, d: l, distance, departure: self.departure };
        let mut lit = facing & !occluders.find(simd, world, light, &rays);
        let mut colour = Vec3x::splat(simd, light.colour);
        if light.is_cone || !occluders.solids.is_empty() {
            let rays = ShadowRays { distance: lit.select(distance, splat(simd, 0.0)), ..rays };
            let passing = transmittance(simd, world, light, &rays, &occluders.solids);
            lit &= passing.max_element().simd_gt(splat(simd, 0.0));
            colour = colour * passing;
        }
        Some(ArrivingLight { l, nl, lit, colour })
    }
}

/// The cone and the listed occluders; 0 in lanes whose distance is 0.
#[inline(always)]
fn transmittance<S: Isa>(
    simd: S,
    world: World<'_>,
    light: &PreparedLight,
    rays: &ShadowRays<S>,
    solids: &Candidates,
) -> Vec3x<S> {
    let zero = splat(simd, 0.0);
    let SpotCone { aim, inner2, outer2 } = light.cone;
    let off = rays.d + Vec3x::splat(simd, aim);
    let inward = (splat(simd, outer2) - off.dot(off)) / (outer2 - inner2);
    let is_asked = rays.distance.simd_gt(zero);
    let in_cone = is_asked.select(soft_edge(simd, inward), zero);
    let mut passing = Vec3x { x: in_cone, y: in_cone, z: in_cone };
    for &candidate in solids.iter() {
        let (object, material) = world.object(candidate.object);
        let mut outward = M::<S>::splat(simd, false);
        let mut certain = outward;
        let passed = match object {
            Object::Block(block) => {
                let [leaving, inward] = departing(simd, rays.departure, candidate.object);
                outward = leaving;
                if light.is_soft_around(block) {
                    certain = inward;
                    let (o, d) = (&rays.o, &rays.d);
                    Some(solid_distance::approach(simd, block, o, d, rays.distance))
                } else {
                    let t = block::distance(simd, block, &rays.o, &rays.d, inward).0;
                    certain = t.simd_lt(rays.distance);
                    None
                }
            }
            Object::Sphere(sphere) => {
                let (o, d) = (rays.o, rays.d);
                Some(sphere::deepest(simd, sphere, o, d, rays.distance))
            }
            Object::Plane(_) | Object::Light(_) | Object::Background => continue,
        };
        let covered = match passed {
            Some((a, depth)) => penumbra(simd, light, rays, a, depth),
            None => zero,
        };
        let covered = outward.select(zero, certain.select(splat(simd, 1.0), covered));
        // A NaN tint counts as black: it must not spoil lanes that are not in shadow.
        let mut absorbed = Vec3A::ONE;
        if light.diameter > 0.0 {
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

/// Returns the share of a light that an occluder covers, 0 to 1, if rays pass at the depth `depth`
/// (after Parker, Shirley and Smits: Single Sample Soft Shadows, 1998).
///
/// The cone from the point to the light has the width `b = a diameter / distance` at the distance
/// `a` of the occluder. While the occluder's edge crosses it, the share rises from 0 to 1.
#[inline(always)]
fn penumbra<S: Isa>(
    simd: S,
    light: &PreparedLight,
    rays: &ShadowRays<S>,
    a: F<S>,
    depth: F<S>,
) -> F<S> {
    let b = at_most::<S>(a * light.diameter / rays.distance, splat(simd, light.max_penumbra));
    let b = at_least::<S>(b, splat(simd, f32::MIN_POSITIVE));
    soft_edge(simd, depth / b + 0.5)
}

#[inline(always)]
pub(super) fn soft_edge<S: Isa>(simd: S, v: F<S>) -> F<S> {
    smooth_step::<S>(clamp::<S>(v, splat(simd, 0.0), splat(simd, 1.0)))
}
